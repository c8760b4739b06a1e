// SPDX-License-Identifier: MIT
#include <irg/raster/pixel_weights.hpp>

#include "support/check_both.hpp"

namespace {

struct encode {
  constexpr int operator()(const irg::rgb<float>& c) const { return static_cast<int>(c.r + 10 * c.g + 100 * c.b); }
};

static_assert(irg::PixelShader<irg::solid_shader<int>, int>);
static_assert(!irg::PixelShader<int, int>);
static_assert(irg::LaneShader<irg::vertex_colour_shader<int, encode>, int>);
static_assert(!irg::LaneShader<irg::solid_shader<int>, int>);

constexpr irg::pixel_weights<float> first{0, 0, 0}, second{1, 0, 0}, third{0, 1, 0}, middle{0.25f, 0.5f, 0};

TEST_CASE("pixel weights: a vertex has its own value, exactly; in between it is linear") {
  CHECK_BOTH(first.interpolate(3, 5, 9) == 3.0f);
  CHECK_BOTH(second.interpolate(3, 5, 9) == 5.0f);
  CHECK_BOTH(third.interpolate(3, 5, 9) == 9.0f);
  CHECK_BOTH(middle.interpolate(3, 5, 9) == 6.5f);
}

TEST_CASE("shaders: solid, vertex colours, intensities") {
  CHECK_BOTH(irg::solid_shader<int>{7}(middle) == 7);
  CHECK_BOTH(irg::vertex_colour_shader<int, encode>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}(second) == 10);
  CHECK_BOTH(irg::vertex_colour_shader<int, encode>{{4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {}}(middle) == 211);
  CHECK_BOTH(irg::intensity_shader<std::uint8_t>{-5, 300, 90}(first) == 0);     // limited to the range
  CHECK_BOTH(irg::intensity_shader<std::uint8_t>{-5, 300, 90}(second) == 255);
  CHECK_BOTH(irg::intensity_shader<std::uint8_t>{10.5f, 50, 90}(first) == 11);  // rounded to nearest
}

TEST_CASE("pixel weights: packs compute what scalars compute") {
  using floats = irg::pack<float, 4>;
  const float w1[4] = {0.1f, 0.7f, 0.0f, 0.33f}, w2[4] = {0.3f, 0.2f, 1.0f, 0.33f};
  const irg::pixel_weights<floats> at{irg::lanes<floats>::load(w1), irg::lanes<floats>::load(w2),
                                      irg::lanes<floats>::broadcast(0)};
  for (int i = 0; i < 4; ++i)
    CHECK(at.interpolate(0.1f, 0.9f, 0.4f)[i] ==
          irg::pixel_weights<float>{w1[i], w2[i], 0}.interpolate(0.1f, 0.9f, 0.4f));
}

}  // namespace
