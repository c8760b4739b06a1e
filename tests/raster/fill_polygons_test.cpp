// SPDX-License-Identifier: MIT
#include <irg/raster/fill_polygons.hpp>

#include <array>
#include <limits>
#include <vector>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/fill_oracle.hpp"

namespace {

using irg::cell_window;
using irg::fill_rule;
using irg::subpixel;
using test::ring;

// One polygon after another, the definition of the batch.
template <class R, class P, class Paints>
bool one_by_one(R& raster, const P& polygons, fill_rule rule, const Paints& paints, const cell_window& w) {
  bool all = true;
  for (std::size_t i = 0; i < polygons.size(); ++i)
    all = irg::fill_polygon(irg::within(raster, w), polygons[i], rule, paints[i]) && all;
  return all;
}

std::vector<ring> random_polygons(test::random& random, int count, int width, int height, int size) {
  std::vector<ring> all;
  for (int i = 0; i < count; ++i) {
    ring r = test::random_convex(random, test::random_int(random, 3, 9), 128 * size);
    if (i % 4 == 0) r = {r[0], r[2], r[1], {r[0].x + 999, r[0].y + 2999}, r[1]};  // of any shape
    const int x = test::random_int(random, 0, width) * 256, y = test::random_int(random, 0, height) * 256;
    for (subpixel& v : r) v = {v.x + x, v.y + y};
    all.push_back(r);
  }
  return all;
}

TEST_CASE("fill_polygons: the pixels of one polygon after another, small and large, with one paint for each") {
  test::random random(1);
  irg::fill_workspace workspace;
  struct batch {
    int count, width, height, size;
  };
  // The last two are painted in bands.
  for (const batch b :
       {batch{300, 60, 50, 12}, batch{2000, 700, 500, 10}, batch{60, 1200, 900, 600}, batch{60, 3000, 600, 1200}}) {
    const std::vector<ring> polygons = random_polygons(random, b.count, b.width, b.height, b.size);
    std::vector<std::uint32_t> paints;
    for (int i = 0; i < b.count; ++i) paints.push_back(static_cast<std::uint32_t>(i + 1));
    for (const cell_window w : {cell_window{0, 0, b.width, b.height}, cell_window{7, 5, b.width - 3, b.height - 9}})
      for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero}) {
        irg::image<std::uint32_t> batched(b.width, b.height, 0u), expected = batched;
        CHECK(irg::fill_polygons(irg::within(batched, w), polygons, rule, paints, workspace));
        CHECK(one_by_one(expected, polygons, rule, paints, w));
        CHECK(batched == expected);
      }
  }
  CHECK(workspace.bands.rows > 0);
}

TEST_CASE("fill_polygons: a pixel is blended in the order of the polygons, in bands too") {
  test::random random(2);
  const std::vector<ring> polygons = random_polygons(random, 80, 1200, 900, 500);
  irg::image<std::uint32_t> batched(1200, 900, 1u), expected = batched;
  // Not commutative: a wrong order shows.
  std::vector<std::uint32_t> factors;
  struct affine {
    std::uint32_t factor;
    std::uint32_t operator()(std::uint32_t there) const { return there * factor + 1; }
  };
  std::vector<affine> blends;
  for (int i = 0; i < 80; ++i) blends.push_back({static_cast<std::uint32_t>(2 * i + 3)});
  irg::fill_workspace workspace;
  CHECK(irg::fill_polygons(irg::within(batched, {0, 0, 1200, 900}), polygons, fill_rule::even_odd, blends, workspace));
  CHECK(workspace.bands.rows > 0);
  CHECK(one_by_one(expected, polygons, fill_rule::even_odd, blends, {0, 0, 1200, 900}));
  CHECK(batched == expected);
}

TEST_CASE("fill_polygons: a refused polygon is left out, the others are painted, in bands too") {
  using points = std::vector<irg::point<float, 2>>;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const int size : {20, 1500}) {
    const float s = static_cast<float>(size);
    std::vector<points> polygons{{{0, 0}, {s, 0}, {0, s}}, {{0, 0}, {s, nan}, {0, s}}, {{s, s}, {s, 0}, {0, s}}};
    for (int i = 0; i < 6; ++i) polygons.push_back({{0, 0}, {s, 0}, {0, s}});
    const std::vector<int> paints{1, 2, 3, 4, 5, 6, 7, 8, 9};
    irg::image<int> batched(size, size, 0), expected(size, size, 0);
    irg::fill_workspace workspace;
    const cell_window w = irg::window_of(batched);
    CHECK(!irg::fill_polygons(irg::within(batched, w), polygons, fill_rule::non_zero, paints, workspace));
    CHECK((workspace.bands.rows > 0) == (size > 1000));
    CHECK(!one_by_one(expected, polygons, fill_rule::non_zero, paints, w));
    CHECK(batched == expected);
    CHECK(batched(0, 0) == 9);
    CHECK(batched(size - 1, size - 1) == 3);
  }
}

TEST_CASE("fill_polygons: far, empty and flat polygons in a batch") {
  using points = std::vector<irg::point<double, 2>>;
  const double far = 2147483648.0;
  const std::vector<points> polygons{{},
                                     {{1, 1}},
                                     {{0, 0}, {9, 9}},
                                     {{5, 5}, {5, 5}, {5, 5}},
                                     {{-far, -far}, {far, -far}, {far, far}, {-far, far}},
                                     {{-far, far}, {far, -far}, {far, far}},
                                     {{0, 2000}, {900, 2000}, {0, 3000}},
                                     {{0, 0}, {1200, 0}, {0, 1200}}};
  const std::vector<int> paints{1, 2, 3, 4, 5, 6, 7, 8};
  irg::image<int> batched(1200, 1200, 0), expected = batched;
  CHECK(irg::fill_polygons(batched, polygons, fill_rule::even_odd, paints));
  CHECK(one_by_one(expected, polygons, fill_rule::even_odd, paints, irg::window_of(expected)));
  CHECK(batched == expected);
  CHECK(batched(1199, 1199) == 6);
  CHECK(batched(0, 0) == 8);
  irg::image<int> none(0, 0);
  CHECK(irg::fill_polygons(none, polygons, fill_rule::even_odd, paints));
  CHECK(irg::fill_polygons(batched, std::vector<points>{}, fill_rule::even_odd, 1));
}

TEST_CASE("fill_polygons: bands of a raster as tall as int allows") {
  using square = std::array<irg::point<double, 2>, 4>;
  constexpr int most = std::numeric_limits<int>::max();
  const std::array<square, 1> low{square{{{0, 2147483000.0}, {1, 2147483000.0}, {1, 2147483648.0}, {0, 2147483648.0}}}};
  irg::detail::polygon_bands bands;
  bands.rows = 524288;
  int calls = 0;
  CHECK(irg::detail::for_each_in_band(low, 1, {0, 0, 1, most}, bands, [&](std::size_t, const cell_window& band) {
    CHECK(band == cell_window{0, 4095 * 524288, 1, most});
    ++calls;
  }));
  CHECK(calls == 1);
}

constexpr int sum_of_filled() {
  using quad = std::array<subpixel, 4>;
  using frame = std::array<quad, 2>;
  constexpr quad large{{{0, 0}, {2048, 0}, {2048, 2048}, {0, 2048}}},
      small{{{512, 512}, {1536, 512}, {1536, 1536}, {512, 1536}}};
  irg::image<int> image(9, 9, 0);
  irg::fill_polygons(image, std::array<frame, 2>{frame{large, small}, frame{small, small}}, fill_rule::even_odd, 1);
  irg::fill_polygons(irg::within(image, {0, 0, 4, 4}), std::array<quad, 2>{large, small}, fill_rule::non_zero,
                     std::array<int, 2>{10, 100});
  irg::fill_polygons(image, std::array<quad, 1>{large}, fill_rule::non_zero, [](int there) { return there + 1000; });
  int n = 0;
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) n += image(x, y);
  return n;
}

TEST_CASE("fill_polygons: polygons with holes, one paint, a function; in constant evaluation as at run time") {
  CHECK_BOTH(sum_of_filled() == (64 - 16 - 12) + 10 * 12 + 100 * 4 + 64000);
}

}  // namespace
