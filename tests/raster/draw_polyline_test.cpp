// SPDX-License-Identifier: MIT
#include <irg/raster/draw_polyline.hpp>

#include <array>
#include <vector>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::polyline_shape;

struct count {
  constexpr int operator()(int there) const { return there + 1; }
};

template <class Vertices>
constexpr irg::image<int> counted(const Vertices& vertices, polyline_shape shape, irg::cell_window w = {0, 0, 99, 99}) {
  irg::image<int> image(12, 9, 0);
  irg::draw_polyline(irg::within(image, w), vertices, count{}, shape);
  return image;
}

constexpr int sum(const irg::image<int>& image) {
  int n = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) n += image(x, y);
  return n;
}

TEST_CASE("draw_polyline: a shared vertex is painted once, ends are drawn") {
  constexpr auto open = [] {
    const auto image = counted(std::array{cell{1, 1}, cell{9, 1}, cell{9, 7}, cell{4, 3}}, polyline_shape::open);
    return image(1, 1) == 1 && image(9, 1) == 1 && image(9, 7) == 1 && image(4, 3) == 1 && sum(image) == 8 + 6 + 5 + 1;
  };
  constexpr auto closed = [] {
    const auto image = counted(std::array{cell{1, 1}, cell{9, 1}, cell{9, 7}, cell{4, 3}}, polyline_shape::closed);
    return image(1, 1) == 1 && image(9, 1) == 1 && image(9, 7) == 1 && image(4, 3) == 1 && sum(image) == 8 + 6 + 5 + 3;
  };
  CHECK_BOTH(open());
  CHECK_BOTH(closed());
}

TEST_CASE("draw_polygon: the closed polyline") {
  irg::image<int> image(12, 9, 0);
  const std::array outline{cell{1, 1}, cell{9, 1}, cell{9, 7}, cell{4, 3}};
  irg::draw_polygon(image, outline, count{});
  CHECK(image == counted(outline, polyline_shape::closed));
}

TEST_CASE("draw_polyline: degenerate ones") {
  for (const polyline_shape shape : {polyline_shape::open, polyline_shape::closed}) {
    CHECK(sum(counted(std::vector<cell>{}, shape)) == 0);
    CHECK(sum(counted(std::vector<cell>{{3, 3}}, shape)) == 1);
    CHECK(sum(counted(std::vector<cell>{{3, 3}, {3, 3}, {3, 3}}, shape)) == 1);
    CHECK(sum(counted(std::vector<cell>{{30, 3}}, shape)) == 0);
    CHECK(sum(counted(std::vector<cell>{{3, 3}, {7, 3}}, shape, {5, 5, 1, 1})) == 0);
    CHECK(counted(std::vector<cell>{{1, 1}, {1, 1}, {8, 5}, {8, 5}, {2, 6}, {2, 6}}, shape) ==
          counted(std::vector<cell>{{1, 1}, {8, 5}, {2, 6}}, shape));  // repeated vertices change nothing
  }
  CHECK_BOTH(sum(counted(std::array{cell{3, 3}, cell{7, 3}}, polyline_shape::open)) == 5);
  CHECK_BOTH(sum(counted(std::array{cell{3, 3}, cell{7, 3}}, polyline_shape::closed)) == 8);  // there and back
}

TEST_CASE("draw_polyline: the cells are those of the segments, in any window") {
  test::random random(31);
  for (int round = 0; round < 2000; ++round) {
    std::vector<cell> vertices;
    const auto size = random.integer(2, 9);
    for (int i = 0; i < size; ++i) {
      const auto x = static_cast<int>(random.integer(-4, 15));
      vertices.push_back({x, static_cast<int>(random.integer(-4, 12))});
    }
    const irg::cell_window w{static_cast<int>(random.integer(0, 4)), 1, 11, static_cast<int>(random.integer(5, 12))};
    const auto shape = round % 2 ? polyline_shape::closed : polyline_shape::open;
    const auto ties = round % 4 < 2 ? irg::line_ties::start_side : irg::line_ties::symmetric;
    irg::image<int> image(12, 9, 0), expected(12, 9, 0);
    irg::draw_polyline(irg::within(image, w), vertices, 1, shape, ties);
    for (std::size_t i = 0; i + (shape == polyline_shape::open) < vertices.size(); ++i)
      irg::line_bresenham(vertices[i], vertices[(i + 1) % vertices.size()], intersect(w, irg::window_of(image)),
                          [&](cell c) { expected(c.x, c.y) = 1; }, {irg::line_ends::closed, ties});
    REQUIRE(image == expected);
  }
}

}  // namespace
