// SPDX-License-Identifier: MIT
#include <irg/raster/image.hpp>

#include <array>
#include <cstdint>
#include <cstring>

#include <irg/colour/pixel.hpp>

#include "support/check_both.hpp"

namespace {

using view = irg::image_view<int>;

static_assert(irg::RowRaster<irg::image<int>> && irg::RowRaster<view> && irg::RowRaster<const view>);
static_assert(irg::ReadableRaster<const irg::image<int>> && !irg::WritableRaster<const irg::image<int>>);
static_assert(irg::ReadableRaster<irg::image_view<const int>> && !irg::WritableRaster<irg::image_view<const int>>);
static_assert(!irg::RowRaster<irg::image_view<const int>>);
static_assert(irg::DepthRaster<irg::image<float>> && !irg::DepthRaster<irg::image<irg::rgba8>>);
static_assert(std::same_as<irg::pixel_of<irg::image_view<const int>>, int>);
static_assert(std::is_trivially_copyable_v<view>);  // passed by value, as a span is

// Rows of a 3x2 picture in memory, with a gap after each row: 1 2 3 . / 4 5 6 .
constexpr std::array<int, 8> padded = {1, 2, 3, -1, 4, 5, 6, -1};

constexpr int number_of(const auto& raster) {  // its pixels as decimal digits, row after row
  int n = 0;
  for (int y = 0; y < irg::height_of(raster); ++y)
    for (int x = 0; x < irg::width_of(raster); ++x) n = 10 * n + static_cast<int>(irg::get_pixel(raster, x, y));
  return n;
}

constexpr irg::image_view<const int> top_down(padded.data(), 3, 2, 4 * sizeof(int));
constexpr irg::image_view<const int> bottom_up(padded.data() + 4, 3, 2, -4 * static_cast<int>(sizeof(int)));

constexpr int written() {
  irg::image<int> i(3, 2, 7);
  i(1, 0) = 8;
  irg::set_pixel(i, 2, 1, 9);
  i.view()(0, 1) = 1;
  i.row(0)[0] = 2;
  return number_of(i);
}

constexpr bool writes_through_const_view() {
  irg::image<int> i(2, 1, 0);
  const view v = i.view();
  irg::set_pixel(v, 1, 0, 5);
  return i(1, 0) == 5 && i(0, 0) == 0;
}

}  // namespace

TEST_CASE("image: owns, fills and compares") {
  CHECK_BOTH(number_of(irg::image<int>(3, 2, 7)) == 777777);
  CHECK_BOTH(written() == 287179);
  CHECK_BOTH(irg::image<int>(2, 2, 1) == irg::image<int>(2, 2, 1));
  CHECK_BOTH(irg::image<int>(2, 2, 1) != irg::image<int>(2, 2, 2));
  CHECK_BOTH(irg::image<int>(1, 4, 1) != irg::image<int>(4, 1, 1));  // the same pixels, another shape
  CHECK_BOTH(irg::image<irg::rgba8>(1, 1)(0, 0) == irg::rgba8{0, 0, 0, 255});
}

TEST_CASE("image: without pixels") {
  CHECK_BOTH(irg::image<int>().width() == 0);
  CHECK_BOTH(irg::image<int>(0, 5, 1).height() == 5);
  CHECK_BOTH(number_of(irg::image<int>(5, 0, 1)) == 0);
  CHECK_BOTH(view().height() == 0);
  CHECK_BOTH(number_of(irg::image<int>(0, 0).view()) == 0);
}

TEST_CASE("image_view: strides of either sign") {
  CHECK_BOTH(number_of(top_down) == 123456);
  CHECK_BOTH(number_of(bottom_up) == 456123);
  CHECK_BOTH(bottom_up.row(1) == padded.data());
  CHECK_BOTH(writes_through_const_view());
}

constexpr bool view_writes_through() {
  irg::image<int> picture(3, 2, 7);
  auto all = irg::view_of(picture);
  all(2, 1) = 5;
  auto again = irg::view_of(all);
  again(0, 0) = 4;
  return number_of(picture) == 477775 && all.stride() == picture.bytes_per_row();
}

TEST_CASE("view_of: the rows of a raster, whatever its type and sense; none of an empty one") {
  CHECK_BOTH(view_writes_through());
  int pixels[] = {1, 2, 3, -1, 4, 5, 6, -1};
  const view down(pixels, 3, 2, 4 * sizeof(int)), up(pixels + 4, 3, 2, -4 * static_cast<int>(sizeof(int)));
  CHECK(number_of(irg::view_of(down)) == 123456);
  CHECK(number_of(irg::view_of(up)) == 456123);
  irg::image<int> flat(5, 0);
  CHECK(irg::view_of(flat).width() == 5);
  CHECK(irg::view_of(flat).height() == 0);
}

TEST_CASE("image_view: rows padded to a multiple that is no multiple of the pixel") {
  // Three-byte pixels in rows of eight bytes, as bitmaps with 4-byte alignment have them.
  std::uint8_t bytes[16];
  for (std::uint8_t i = 0; i < 16; ++i) bytes[i] = i;
  const irg::image_view<irg::rgb8> down(reinterpret_cast<irg::rgb8*>(bytes), 2, 2, 8);
  CHECK(down(0, 0) == irg::rgb8{0, 1, 2});
  CHECK(down(1, 0) == irg::rgb8{3, 4, 5});
  CHECK(down(1, 1) == irg::rgb8{11, 12, 13});
  const irg::image_view<irg::rgb8> up(reinterpret_cast<irg::rgb8*>(bytes + 8), 2, 2, -8);
  CHECK(up(1, 0) == irg::rgb8{11, 12, 13});
  CHECK(up(1, 1) == irg::rgb8{3, 4, 5});
  up(0, 1) = {90, 91, 92};
  CHECK(bytes[0] == 90);
  CHECK(bytes[2] == 92);
  CHECK(bytes[3] == 3);
  const irg::image_view<const irg::rgb8> reading(reinterpret_cast<const irg::rgb8*>(bytes), 2, 2, 8);
  CHECK(reading(0, 0) == irg::rgb8{90, 91, 92});
}

TEST_CASE("image: made of a size, and a view where one is asked for") {
  constexpr auto across = [](irg::image_view<const int> v) { return v.width(); };
  constexpr auto down = [](irg::image_view<int> v) { return v.height(); };
  constexpr auto sides = [=] {
    irg::image<int> i(irg::extent2{3, 2}, 5);
    const irg::image<int> fixed = i;
    return i(2, 1) == 5 && across(i) == 3 && across(fixed) == 3 && down(i) == 2;
  };
  CHECK_BOTH(sides());
  static_assert(!std::is_convertible_v<const irg::image<int>&, irg::image_view<int>>);
  static_assert(!std::is_convertible_v<irg::image<int>, irg::image_view<int>>);  // it would not live long enough
  static_assert(!std::is_convertible_v<irg::image<float>&, irg::image_view<int>>);
  static_assert(irg::extent2{3, 2} != irg::extent2{2, 3});
}
