// SPDX-License-Identifier: MIT
#include <irg/core/raster_concept.hpp>

#include <array>
#include <vector>

#include <irg/raster/fill_span.hpp>
#include <irg/raster/draw_line.hpp>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/opencv_raster.hpp"

namespace {

// Fits without a word: width, height and operator().
struct checkers {
  int width() const { return 8; }
  int height() const { return 8; }
  constexpr bool operator()(int x, int y) const { return ((x + y) & 1) != 0; }
};
struct own_image {
  std::array<int, 12> pixels{};
  constexpr int width() const { return 4; }
  constexpr unsigned char height() const { return 3; }
  constexpr int& operator()(int x, int y) { return pixels[static_cast<std::size_t>(y * 4 + x)]; }
  constexpr int operator()(int x, int y) const { return pixels[static_cast<std::size_t>(y * 4 + x)]; }
};
struct own_rows : own_image {
  constexpr int* row(int y) { return pixels.data() + 4 * y; }
};

struct picture {  // an interface: algorithms see the reference, never the object
  virtual int width() const = 0;
  virtual int height() const = 0;
  virtual int operator()(int x, int y) const = 0;
  virtual ~picture() = default;
};
struct no_height {
  int width() const;
  int operator()(int, int) const;
};
struct no_pixels {
  int width() const;
  int height() const;
};
struct void_pixels : no_pixels {
  void operator()(int, int) const;
};
struct one_index : no_pixels {
  int operator()(int) const;
};
struct returned_by_value : no_pixels {  // assigning to it would change nothing
  archetype::pixel operator()(int, int) const;
};
struct strange_rows : own_image {
  float* row(int y);
};

static_assert(irg::ReadableRaster<checkers> && !irg::WritableRaster<checkers>);
static_assert(irg::ReadableRaster<picture>);
static_assert(irg::WritableRaster<own_image> && !irg::RowRaster<own_image>);
static_assert(irg::ReadableRaster<const own_image> && !irg::WritableRaster<const own_image>);
static_assert(irg::RowRaster<own_rows> && !irg::RowRaster<const own_rows> && irg::ReadableRaster<const own_rows>);
static_assert(irg::ReadableRaster<returned_by_value> && !irg::WritableRaster<returned_by_value>);
static_assert(irg::WritableRaster<strange_rows> && !irg::RowRaster<strange_rows>);
static_assert(!irg::ReadableRaster<no_height> && !irg::ReadableRaster<no_pixels> && !irg::ReadableRaster<void_pixels>);
static_assert(!irg::ReadableRaster<one_index> && !irg::ReadableRaster<int> && !irg::ReadableRaster<void>);
static_assert(!irg::ReadableRaster<std::vector<int>> && !irg::ReadableRaster<int[3][4]>);
static_assert(std::same_as<irg::pixel_of<own_image>, int> && std::same_as<irg::pixel_of<const own_image>, int>);

static_assert(irg::ReadableRaster<archetype::readable_raster> && !irg::WritableRaster<archetype::readable_raster>);
static_assert(irg::WritableRaster<archetype::writable_raster<archetype::pixel>>);
static_assert(!irg::RowRaster<archetype::writable_raster<archetype::pixel>>);
static_assert(irg::RowRaster<archetype::row_raster<archetype::pixel>>);

static_assert(irg::DepthRaster<archetype::depth_raster> && irg::DepthRaster<own_image>);
static_assert(!irg::DepthRaster<const own_image> && !irg::DepthRaster<archetype::writable_raster<archetype::pixel>>);
static_assert(!irg::DepthRaster<archetype::writable_raster<bool>> && !irg::DepthRaster<checkers>);

template <class R>
constexpr unsigned drawn_into() {
  R r;
  irg::clear(r, archetype::pixel{1});
  irg::fill_span(r, {2, -5, 4}, archetype::pixel{3});
  irg::draw_line(r, {7, 0}, {7, 5}, archetype::pixel{5});
  unsigned sum = 0;
  for (int y = 0; y < irg::height_of(r); ++y)
    for (int x = 0; x < irg::width_of(r); ++x) sum += irg::get_pixel(r, x, y).tint;
  return sum;
}

}  // namespace

TEST_CASE("raster: columns and rows keep their places") {
  constexpr auto at = [](int x, int y) {
    own_image r;
    irg::set_pixel(r, x, y, 9);
    return r;
  };
  CHECK_BOTH(irg::width_of(own_image{}) == 4);
  CHECK_BOTH(irg::height_of(own_image{}) == 3);
  CHECK_BOTH(at(3, 1).pixels[7] == 9);
  CHECK_BOTH(irg::get_pixel(at(3, 1), 3, 1) == 9);
  CHECK_BOTH(irg::get_pixel(at(3, 1), 1, 2) == 0);
}

TEST_CASE("raster: a virtual raster computes its pixels when they are read") {
  CHECK_BOTH(irg::get_pixel(checkers{}, 3, 4));
  CHECK_BOTH(!irg::get_pixel(checkers{}, 3, 5));
  CHECK(irg::get_pixel(archetype::readable_raster{}, 7, 4).tint == 47);
}

TEST_CASE("raster: drawing asks for no more than the concept, with rows and without") {
  // 48 pixels of 1; four of them 3; then a column of six 5.
  CHECK_BOTH(drawn_into<archetype::writable_raster<archetype::pixel>>() == 48 + 4 * 2 + 6 * 4);
  CHECK_BOTH(drawn_into<archetype::row_raster<archetype::pixel>>() == 48 + 4 * 2 + 6 * 4);
}

TEST_CASE("raster: cv::Mat_") {
#ifdef IRG_HAVE_OPENCV
  static_assert(irg::RowRaster<cv::Mat_<cv::Vec3b>> && irg::DepthRaster<cv::Mat_<float>>);
  static_assert(!irg::DepthRaster<cv::Mat_<cv::Vec3b>> && !irg::WritableRaster<const cv::Mat_<float>>);
  static_assert(!irg::ReadableRaster<cv::Mat>);  // its pixels are known at run time only: raster/view_opencv.hpp
  cv::Mat_<cv::Vec3b> m(2, 3, cv::Vec3b(0, 0, 0));
  irg::draw_line(m, {0, 0}, {2, 0}, cv::Vec3b(1, 2, 3));
  irg::fill_span(m, {1, 1, 9}, cv::Vec3b(7, 8, 9));
  CHECK(irg::width_of(m) == 3);
  CHECK(m(0, 2) == cv::Vec3b(1, 2, 3));
  CHECK(m(1, 0) == cv::Vec3b(0, 0, 0));
  CHECK(m(1, 2) == cv::Vec3b(7, 8, 9));
#else
  MESSAGE("skipped: OpenCV was not found");
#endif
}
