// SPDX-License-Identifier: MIT
#include <irg/render/weight_derivatives.hpp>

#include <cmath>
#include <vector>

#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using point = irg::point<double, 3>;

// The derivatives of a triangle, seen 90 degrees wide on 64 x 48 pixels.
template <class T = double>
constexpr irg::weight_derivatives derivatives_of(const point& a, const point& b, const point& c, double scale = 1) {
  std::vector<irg::point<T, 3>> positions;
  for (const point& p : {a, b, c}) positions.push_back({static_cast<T>(p.x), static_cast<T>(p.y), static_cast<T>(p.z)});
  irg::mat<T, 4, 4> view = irg::perspective(irg::pi<T> / T(2), T(4) / T(3), T(0.5), T(1000));
  view = view * static_cast<T>(scale);
  const std::vector<irg::triangle_indices> triangles{{{0, 1, 2}}};
  const auto mapping = irg::map_to_screen<T>({64, 48});
  const auto projected = irg::project_vertices<T>(positions, view, mapping);
  return irg::make_weight_derivatives(irg::triangle_batch<T>{&projected, triangles}, 0, mapping);
}

constexpr bool near(float a, float b, float tolerance = 1e-7f) { return a - b <= tolerance && b - a <= tolerance; }

// The weights of the second and third vertex at a place of the picture, by areas on the screen: for triangles in front
// of the eye.
struct weights {
  long double b[2];
};
weights weights_at(const point (&p)[3], long double x, long double y) {
  long double sx[3], sy[3], w[3], g[3];
  for (int i = 0; i < 3; ++i) {
    w[i] = -static_cast<long double>(p[i].z);
    sx[i] = 32 + 24 * static_cast<long double>(p[i].x) / w[i];
    sy[i] = 24 - 24 * static_cast<long double>(p[i].y) / w[i];
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    g[i] = ((sx[j] - x) * (sy[k] - y) - (sx[k] - x) * (sy[j] - y)) / w[i];
  }
  const long double sum = g[0] + g[1] + g[2];
  return {{g[1] / sum, g[2] / sum}};
}

}  // namespace

TEST_CASE("weight_derivatives: a triangle that faces the eye, by hand") {
  // Ten pixels to the right and 20 down is one length of its sides, at distance 2 anywhere.
  constexpr auto change = derivatives_of({0, 0, -2}, {20.0 / 24, 0, -2}, {0, -40.0 / 24, -2})({0.25f, 0.5f, 0.5f});
  CHECK_BOTH((near(change.weight1_right, 0.1f) && near(change.weight2_down, 0.05f)));
  CHECK_BOTH((near(change.weight2_right, 0, 1e-9f) && near(change.weight1_down, 0, 1e-9f)));
  CHECK_BOTH((near(change.right(1, 3, 7), 0.2f) && near(change.down(1, 3, 7), 0.3f)));
  // Turned round, the other way; in floats; at the ends of the range of w.
  constexpr auto back = derivatives_of({0, 0, -2}, {0, -40.0 / 24, -2}, {20.0 / 24, 0, -2})({0.25f, 0.5f, 0.5f});
  CHECK_BOTH((near(back.weight2_right, 0.1f) && near(back.weight1_down, 0.05f)));
  constexpr auto in_floats =
      derivatives_of<float>({0, 0, -2}, {20.0 / 24, 0, -2}, {0, -40.0 / 24, -2})({0.25f, 0.5f, 0.5f});
  CHECK_BOTH((near(in_floats.weight1_right, 0.1f) && near(in_floats.weight2_down, 0.05f)));
  for (const double scale : {0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000}) {
    const auto c = derivatives_of({0, 0, -2}, {20.0 / 24, 0, -2}, {0, -40.0 / 24, -2}, scale)({0.25f, 0.5f, 0.5f});
    CHECK((near(c.weight1_right, 0.1f) && near(c.weight2_down, 0.05f)));
  }
}

TEST_CASE("weight_derivatives: seen from the edge, without size, in the eye: 0") {
  constexpr irg::pixel_weights<float> at{0.25f, 0.5f, 0.5f};
  constexpr auto edge = derivatives_of({0, 0, -2}, {0, 0, -3}, {0, 0, -4})(at);
  CHECK_BOTH((edge.right(0, 1, 2) == 0 && edge.down(0, 1, 2) == 0));
  constexpr auto point_of_it = derivatives_of({1, 1, -2}, {1, 1, -2}, {1, 1, -2})(at);
  CHECK_BOTH((point_of_it.right(0, 1, 2) == 0 && point_of_it.down(0, 1, 2) == 0));
  constexpr auto eye = derivatives_of({0, 0, 0}, {0, 0, 0}, {0, 0, 0})(at);
  CHECK_BOTH((eye.right(0, 1, 2) == 0 && eye.down(0, 1, 2) == 0));
}

TEST_CASE("weight_derivatives: against differences of weights by areas on the screen") {
  test::random r(3);
  double worst = 0;
  int places = 0;
  for (int i = 0; i < 3000; ++i) {
    point p[3];
    for (point& q : p) {
      const double away = 1 + r.unit() * 30, x = (r.unit() - 0.5) * 3, y = (r.unit() - 0.5) * 2;
      q = {x * away, y * away, -away};
    }
    const double px = 20 + 24 * r.unit(), py = 12 + 24 * r.unit();
    const long double x = static_cast<long double>(px), y = static_cast<long double>(py), h = 1e-4L;
    const weights here = weights_at(p, x, y);
    if (!(here.b[0] > 0 && here.b[1] > 0 && here.b[0] + here.b[1] < 1)) continue;
    ++places;
    const auto change =
        derivatives_of(p[0], p[1], p[2])({static_cast<float>(here.b[0]), static_cast<float>(here.b[1]), 0.5f});
    const weights left = weights_at(p, x - h, y), right = weights_at(p, x + h, y), up = weights_at(p, x, y - h),
                  down = weights_at(p, x, y + h);
    const float got[] = {change.weight1_right, change.weight2_right, change.weight1_down, change.weight2_down};
    for (int k = 0; k < 4; ++k) {
      const weights &a = k < 2 ? left : up, &b = k < 2 ? right : down;
      const long double expected = (b.b[k % 2] - a.b[k % 2]) / (2 * h);
      const long double size = 1e-3L + (expected < 0 ? -expected : expected);
      worst = std::fmax(worst, static_cast<double>(std::fabs(static_cast<long double>(got[k]) - expected) / size));
    }
  }
  MESSAGE(places, " places, off by ", worst, " of the derivative, or of 0.001 a pixel");
  CHECK(places > 300);
  CHECK(worst <= 1e-3);
}
