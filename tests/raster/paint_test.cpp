// SPDX-License-Identifier: MIT
#include <irg/raster/paint.hpp>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("paint: a value, a function, a coverage") {
  CHECK_BOTH([] {
    irg::image<int> ids(2, 1, 5);
    irg::paint_pixel(ids, 0, 0, 9);
    irg::paint_pixel(ids, 1, 0, [](int there) { return there + 1; });
    return ids(0, 0) == 9 && ids(1, 0) == 6;
  }());
  CHECK_BOTH([] {
    irg::image<irg::rgba8> picture(3, 1, {0, 0, 0, 255});
    irg::paint_pixel(picture, 0, 0, {255, 0, 0, 255}, 128);
    irg::paint_pixel(picture, 1, 0, {255, 0, 0, 255}, 0);
    irg::paint_pixel(picture, 2, 0, [](irg::rgba8 p, std::uint8_t c) { return irg::rgba8{c, c, c, p.a}; }, 7);
    return picture(0, 0) == irg::rgba8{128, 0, 0, 255} && picture(1, 0) == irg::rgba8{0, 0, 0, 255} &&
           picture(2, 0) == irg::rgba8{7, 7, 7, 255};
  }());
}

TEST_CASE("paint: what is no paint") {
  static_assert(irg::PaintFor<int, irg::image<float>>);
  static_assert(!irg::PaintFor<irg::rgba8, irg::image<float>>);
  static_assert(!irg::CoveragePaintFor<int, irg::image<int>>);
}

}  // namespace
