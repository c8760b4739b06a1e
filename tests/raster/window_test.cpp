// SPDX-License-Identifier: MIT
#include <irg/raster/window.hpp>

#include <irg/raster/draw_line.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("cell_window: intersection and emptiness") {
  CHECK_BOTH(irg::intersect({0, 0, 4, 4}, {2, -1, 9, 3}) == irg::cell_window{2, 0, 4, 3});
  CHECK_BOTH(irg::intersect({0, 0, 4, 4}, {4, 0, 9, 3}).empty());
  CHECK_BOTH(irg::cell_window{}.empty());
  CHECK_BOTH(irg::cell_window{} == irg::cell_window{0, 0, 0, 0});
  CHECK_BOTH(irg::cell_window{3, 0, 1, 9}.empty());
  CHECK_BOTH(irg::window_of(irg::image<int>(3, 2)) == irg::cell_window{0, 0, 3, 2});
}

TEST_CASE("within: the raster's pixels and size, the part of the window that the raster and earlier windows allow") {
  using within_view = const irg::raster_within<irg::image_view<int>>;
  static_assert(irg::EvenRowRaster<within_view> && irg::EvenRowRaster<irg::raster_within<irg::image_view<int>>>);
  static_assert(irg::ReadableRaster<irg::raster_within<const irg::image<int>>>);
  static_assert(!irg::WritableRaster<irg::raster_within<const irg::image<int>>>);
  irg::image<int> picture(9, 7, 0);
  const auto part = irg::within(picture, {2, 1, 99, 5});
  CHECK(irg::window_of(part) == irg::cell_window{2, 1, 9, 5});
  CHECK(irg::width_of(part) == 9);
  CHECK(irg::height_of(part) == 7);
  CHECK(irg::window_of(irg::within(part, {-5, 2, 4, 99})) == irg::cell_window{2, 2, 4, 5});
  CHECK(irg::window_of(irg::within(part, {0, 0, 2, 9})).empty());
  irg::set_pixel(part, 3, 2, 8);
  CHECK(picture(3, 2) == 8);
  CHECK(irg::get_pixel(part, 3, 2) == 8);
  CHECK(irg::raster_traits<decltype(part)>::row(part, 4) == picture.row(4));
  CHECK_BOTH([] {
    irg::image<int> image(6, 6, 0);
    irg::draw_line(irg::within(irg::within(image, {1, 0, 6, 6}), {0, 0, 4, 6}), {0, 0}, {5, 5}, 1);
    return image(0, 0) == 0 && image(1, 1) == 1 && image(3, 3) == 1 && image(4, 4) == 0;
  }());
}

}  // namespace
