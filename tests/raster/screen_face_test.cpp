// SPDX-License-Identifier: MIT
#include <irg/raster/screen_face.hpp>

#include "support/check_both.hpp"

namespace {

constexpr irg::screen_face face = irg::make_screen_face({{0, 0}, 0.25f}, {{0, 2048}, 0.5f}, {{2048, 0}, 0.75f}, 7);

TEST_CASE("screen_face: the corners as given, and what they cover") {
  CHECK_BOTH(face.number == 7);
  CHECK_BOTH(face.v[1].depth == 0.5f);
  CHECK_BOTH(irg::covers(face.on_screen.coverage, 2, 3));
  CHECK_BOTH(!irg::covers(face.on_screen.coverage, 6, 6));
  CHECK_BOTH(face.on_screen.coverage.flipped);
  CHECK_BOTH(irg::depth_at(face.on_screen.setup, 0, 0) == 0.25f + 0.25f / 16 + 0.5f / 16);
}

TEST_CASE("screen_face: without area it covers nothing") {
  CHECK_BOTH(!irg::covers(irg::make_screen_face({{0, 0}}, {{256, 256}}, {{512, 512}}, 0).on_screen.coverage, 0, 0));
}

}  // namespace
