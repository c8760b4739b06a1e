// SPDX-License-Identifier: MIT
#include <irg/raster/triangle_setup.hpp>

#include <cmath>
#include <cstdint>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

using irg::screen_vertex;

// A triangle of 8 x 8 pixels whose depth is x / 8 at the centres' x, and y / 8 beside it.
constexpr irg::covered_triangle corner =
    irg::cover_and_set_up({{0, 0}, 0.0f, 1.0f}, {{2048, 0}, 1.0f, 1.0f}, {{0, 2048}, 0.0f, 1.0f});

TEST_CASE("triangle_setup: depths and weights by hand") {
  CHECK_BOTH(corner.coverage.double_area == 2048 * 2048);
  CHECK_BOTH(irg::depth_at(corner.setup, 0, 0) == 0.0625f);
  CHECK_BOTH(irg::depth_at(corner.setup, 3, 2) == 0.4375f);
  CHECK_BOTH(irg::weights_at(corner.setup, 3, 2).weight1 == 0.4375f);
  CHECK_BOTH(irg::weights_at(corner.setup, 3, 2).weight2 == 0.3125f);
  CHECK_BOTH(irg::weights_at(corner.setup, 3, 2).depth == 0.4375f);
}

TEST_CASE("triangle_setup: a triangle without area is covered nowhere") {
  CHECK_BOTH(irg::cover_and_set_up({{0, 0}}, {{256, 256}}, {{512, 512}}).coverage.double_area == 0);
}

TEST_CASE("triangle_setup: turning a triangle round exchanges two weights and changes no bit") {
  test::random random(3);
  const auto vertex = [&] {
    return screen_vertex{
        {static_cast<std::int32_t>(random.integer(0, 20000)), static_cast<std::int32_t>(random.integer(0, 20000))},
        static_cast<float>(random.integer(1, 1000)) / 1000,
        static_cast<float>(random.integer(1, 1000)) / 10};
  };
  for (int i = 0; i < 2000; ++i) {
    const screen_vertex v[3] = {vertex(), vertex(), vertex()};
    const auto t = irg::cover_and_set_up(v[0], v[1], v[2]), turned = irg::cover_and_set_up(v[0], v[2], v[1]);
    if (t.coverage.double_area == 0) continue;
    const int x = static_cast<int>(random.integer(0, 79)), y = static_cast<int>(random.integer(0, 79));
    if (!irg::covers(t.coverage, x, y)) continue;
    const auto at = irg::weights_at(t.setup, x, y), back = irg::weights_at(turned.setup, x, y);
    CHECK(at.weight1 == back.weight2);
    CHECK(at.weight2 == back.weight1);
    CHECK(at.depth == back.depth);
    // The plane through the three corners, met at the pixel's centre.
    const auto corner_of = [&](int k, int c) {
      const double position = c == 0 ? v[k].position.x : v[k].position.y;
      return static_cast<long double>(c == 2 ? static_cast<double>(v[k].depth) : position);
    };
    const auto side = [&](int k, int c) { return corner_of(k, c) - corner_of(0, c); };
    const long double cx = x * 256 + 128 - corner_of(0, 0), cy = y * 256 + 128 - corner_of(0, 1);
    const long double area = side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0);
    const long double depth = corner_of(0, 2) + ((side(1, 2) * side(2, 1) - side(2, 2) * side(1, 1)) * cx +
                                                 (side(2, 2) * side(1, 0) - side(1, 2) * side(2, 0)) * cy) /
                                                    area;
    CHECK(std::fabs(static_cast<double>(depth - static_cast<long double>(at.depth))) <=
          0x1p-22 * static_cast<double>(at.depth));
  }
}

// The worst of depths, in ulp, and of weights, of pixels within triangles of all sizes up to the reach.
struct worst_errors {
  double depth = 0, weight = 0;
  int pixels = 0;
};

// Depths and inverse w of 2^-exponent to 2^exponent; a depth may also lose what underflow takes, as it is stated.
worst_errors sweep(int count, int depth_exponent, int w_exponent) {
  test::random r(29);
  worst_errors worst;
  for (int i = 0; i < count; ++i) {
    screen_vertex v[3];
    const int reach = static_cast<int>(r.integer(6, 29));
    for (screen_vertex& c : v) {
      const auto coordinate = [&] {
        const std::int64_t most = std::int64_t{1} << r.integer(4, reach);
        return static_cast<std::int32_t>(r.integer(-most, most));
      };
      const auto size = [&](int e) {
        return static_cast<float>(std::ldexp(1 + r.unit(), static_cast<int>(r.integer(-e, e))));
      };
      c.position.x = coordinate();
      c.position.y = coordinate();
      c.depth = size(depth_exponent);
      c.inverse_w = size(w_exponent);
    }
    const irg::covered_triangle t = irg::cover_and_set_up(v[0], v[1], v[2]);
    if (t.coverage.double_area == 0) continue;
    for (int k = 0; k < 8; ++k) {
      double s = r.unit(), u = r.unit();
      if (s + u > 1) s = 1 - s, u = 1 - u;
      if (k < 3) s *= std::ldexp(1.0, -static_cast<int>(r.integer(0, 20)));
      const auto at = [&](auto axis) {
        const double a = axis(v[0]), b = axis(v[1]), c = axis(v[2]);
        return static_cast<int>(std::floor((a + s * (b - a) + u * (c - a)) / 256));
      };
      const int x = at([](const screen_vertex& c) { return static_cast<double>(c.position.x); }),
                y = at([](const screen_vertex& c) { return static_cast<double>(c.position.y); });
      if (!irg::covers(t.coverage, x, y)) continue;
      const irg::subpixel p{x * 256 + 128, y * 256 + 128};
      long double b[3], depth = 0, q = 0;
      for (int e = 0; e < 3; ++e) {
        b[e] = static_cast<long double>(irg::twice_signed_area(v[(e + 1) % 3].position, v[(e + 2) % 3].position, p)) /
               static_cast<long double>(irg::twice_signed_area(v[0].position, v[1].position, v[2].position));
        depth += b[e] * static_cast<long double>(v[e].depth);
        q += b[e] * static_cast<long double>(v[e].inverse_w);
      }
      const irg::pixel_weights<float> w = irg::weights_at(t.setup, x, y);
      const long double off = std::fabs(static_cast<long double>(w.depth) - depth) - 0x1p-72L;
      worst.depth = std::fmax(worst.depth, static_cast<double>(off / depth * 0x1p23L));
      const long double w1 = b[1] * static_cast<long double>(v[1].inverse_w) / q,
                        w2 = b[2] * static_cast<long double>(v[2].inverse_w) / q;
      worst.weight = std::fmax(worst.weight, static_cast<double>(std::fabs(static_cast<long double>(w.weight1) - w1)));
      worst.weight = std::fmax(worst.weight, static_cast<double>(std::fabs(static_cast<long double>(w.weight2) - w2)));
      ++worst.pixels;
    }
  }
  return worst;
}

TEST_CASE("triangle_setup: depths and weights over the whole reach, sizes of all magnitudes") {
  for (const int e : {8, 40, 90, 118}) {
    const worst_errors deep = sweep(test::trials(3000), e, 8), wide = sweep(test::trials(3000), 8, e);
    CHECK(deep.pixels > 10000);
    for (const worst_errors& worst : {deep, wide}) {
      CHECK(worst.depth <= 4);
      CHECK(worst.weight <= 4e-7);
    }
  }
}

TEST_CASE("fits_32_bits: 32 bits are taken just as long as every pixel of the widened window stays within 2^30") {
  using irg::cell_window;
  constexpr auto fits = [](std::int64_t at_origin, int right, int down, const cell_window& w, int margin) {
    irg::triangle_coverage t{};
    t.edge[1] = {at_origin, right, down, 0};
    return irg::fits_32_bits(t, w, margin);
  };
  constexpr std::int64_t limit = std::int64_t{1} << 30;
  constexpr cell_window w{10, 20, 30, 50};
  constexpr int last_x = 30 + 8, last_y = 50, first_x = 10 - 8, first_y = 20;
  // The greatest and the least F are at corners of [2, 38] x [20, 50].
  for (const int right : {0, 3, -3, 1000})
    for (const int down : {0, 7, -7, 5000}) {
      const std::int64_t greatest =
          std::int64_t{right} * (right > 0 ? last_x : first_x) + std::int64_t{down} * (down > 0 ? last_y : first_y);
      const std::int64_t least =
          std::int64_t{right} * (right > 0 ? first_x : last_x) + std::int64_t{down} * (down > 0 ? first_y : last_y);
      CHECK(fits(limit - greatest, right, down, w, 8));
      CHECK(!fits(limit - greatest + 1, right, down, w, 8));
      CHECK(fits(-limit - least, right, down, w, 8));
      CHECK(!fits(-limit - least - 1, right, down, w, 8));
    }
  CHECK_BOTH(fits(limit, 0, 0, w, 8));
  CHECK_BOTH(!fits(limit + 1, 0, 0, w, 8));
}

TEST_CASE("edge_lanes: the edges, rests and scales of set_up_triangle, lane by lane, ends of the range included") {
  constexpr int count = irg::native_lanes<std::int32_t>;
  using integers = irg::pack<std::int32_t, count>;
  test::random random(64);
  for (int i = 0; i < test::trials(3000); ++i) {
    integers x[3], y[3], column, row;
    const std::int32_t sides = (1 << random.integer(1, 15)) - 1;
    for (int l = 0; l < count; ++l) {
      const auto at = [&](std::int32_t from) {
        return from + static_cast<std::int32_t>(random.integer(0, 3) == 0 ? sides * random.integer(0, 1)
                                                                          : random.integer(0, sides));
      };
      const auto left = static_cast<std::int32_t>(random.integer(-100000, 100000)),
                 top = static_cast<std::int32_t>(random.integer(-100000, 100000));
      for (int k = 0; k < 3; ++k) {
        irg::set_lane(x[k], l, at(left));
        irg::set_lane(y[k], l, at(top));
      }
      irg::set_lane(column, l, irg::first_centre(at(left) - 127));
      irg::set_lane(row, l, irg::first_centre(at(top) - 127));
    }
    const irg::triangle_boxes<count> boxes(x, y);
    const irg::edge_lanes<count> edges(x, y, boxes.double_area);
    for (int l = 0; l < count; ++l) {
      REQUIRE(boxes.narrow[l] == -1);
      const irg::screen_vertex v[3] = {{{x[0][l], y[0][l]}}, {{x[1][l], y[1][l]}}, {{x[2][l], y[2][l]}}};
      const irg::covered_triangle t = irg::cover_and_set_up(v[0], v[1], v[2]);
      REQUIRE(boxes.double_area[l] == irg::twice_signed_area(v[0].position, v[1].position, v[2].position));
      if (t.coverage.double_area == 0) continue;
      REQUIRE((edges.flip[l] != 0) == t.coverage.flipped);
      REQUIRE(edges.scale[l] == t.setup.scale);
      for (int k = 0; k < 3; ++k) {
        const auto [f, rest] = edges(k, column, row);
        REQUIRE(edges.dx[k][l] == t.setup.edge[k].down);
        REQUIRE(edges.dy[k][l] == -t.setup.edge[k].right);
        REQUIRE(f[l] == t.setup.edge[k](column[l], row[l]));
        REQUIRE(rest[l] == t.setup.rest[k]);
      }
    }
  }
}

TEST_CASE("triangle_boxes: sides of 2^15 and more are not narrow") {
  constexpr int count = irg::native_lanes<std::int32_t>;
  using J = irg::lanes<irg::pack<std::int32_t, count>>;
  const auto none = J::broadcast(0);
  for (const int size : {0, 1, (1 << 15) - 1, 1 << 15, 1 << 20}) {
    const auto far_side = J::broadcast(size);
    const irg::triangle_boxes<count> wide({none, far_side, none}, {none, none, none}),
        high({none, none, none}, {none, none, far_side});
    CHECK((wide.narrow[0] != 0) == (size < 1 << 15));
    CHECK((high.narrow[0] != 0) == (size < 1 << 15));
    CHECK(wide.right[0] - wide.left[0] == size);
    CHECK(high.bottom[0] - high.top[0] == size);
  }
}

TEST_CASE("is_top_left: left and top edges of triangles that are on their right") {
  CHECK_BOTH(irg::is_top_left(0, -1));
  CHECK_BOTH(irg::is_top_left(5, -1));
  CHECK_BOTH(irg::is_top_left(1, 0));
  CHECK_BOTH(!irg::is_top_left(0, 0));
  CHECK_BOTH(!irg::is_top_left(-1, 0));
  CHECK_BOTH(!irg::is_top_left(0, 1));
  CHECK_BOTH(!irg::is_top_left(7, 1));
}

}  // namespace
