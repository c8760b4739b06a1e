// SPDX-License-Identifier: MIT
#include <irg/hidden/horizon_curves.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/hidden/floating_horizon.hpp>
#include <irg/hidden/horizon_surface.hpp>

#include "hidden/horizon_lines_oracle.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::horizon_curve_points;
using irg::horizon_curves;
using irg::horizon_curves_from;
using irg::horizon_curves_of;
using irg::horizon_view;

namespace {

using P = irg::point<double, 2>;

// Heights between which there are planes' worth of nothing: any number for any place, the same each time.
struct rough {
  unsigned seed;
  double operator()(double x, double z) const {
    const double s = std::sin(seed + 12.9898 * std::round(x * 60) + 78.233 * std::round(z * 60)) * 43758.5453;
    return s - std::floor(s);
  }
};

std::vector<irg::edge_part> seen_of(const horizon_curve_points& c) {
  std::vector<irg::edge_part> out;
  irg::visible_curves(c.points, [&](const irg::edge_part& p) { out.push_back(p); });
  return out;
}

// A horizon that only notes its samples.
struct recorder {
  std::vector<irg::cell>& cells;
  void begin_curve() {}
  template <class Sink>
  void add(const irg::cell& c, const Sink&) {
    cells.push_back(c);
  }
};

// What is seen, as segments from the lower left end, sorted: apart from the order in which it is drawn.
std::vector<std::array<double, 6>> drawn(const horizon_curve_points& c) {
  std::vector<std::array<double, 6>> out;
  for (const irg::edge_part& p : seen_of(c)) {
    P a = c.points[p.edge], b = c.points[p.edge + 1];
    double from = p.from, to = p.to;
    if (b.x < a.x || (b.x == a.x && b.y < a.y)) {
      std::swap(a, b);
      from = 1 - p.to, to = 1 - p.from;
    }
    // From the other end a place is rounded otherwise.
    out.push_back({a.x, a.y, b.x, b.y, std::round(from * 0x1p40), std::round(to * 0x1p40)});
  }
  std::sort(out.begin(), out.end());
  return out;
}

horizon_view any_view(test::random& r, double yaw, double pitch) {
  horizon_view v{static_cast<double>(r.integer(5, 40)), static_cast<double>(r.integer(2, 30)), yaw, pitch};
  v.curves = static_cast<int>(r.integer(2, 6));
  return v;
}

#ifdef IRG_HAVE_MPFR
// Of one surface, whether the parts are those of the definition; adds up lengths.
bool is_true(const horizon_curve_points& c, double& hidden, double& length) {
  test::curve_oracle oracle;
  const auto expected = oracle.parts(c.points);
  const auto parts = seen_of(c);
  hidden += oracle.hidden_length, length += oracle.length;
  return std::equal(parts.begin(), parts.end(), expected.begin(), expected.end(),
                    [](const auto& a, const auto& b) { return a.edge == b.edge && a.from == b.from && a.to == b.to; });
}
#endif

}  // namespace

TEST_CASE("horizon_curves_of: the samples that the pixel form rounds") {
  horizon_view v{30, 20, irg::radians(29.0), irg::radians(40.0), 5};
  for (const auto families : {horizon_curves::constant_z, horizon_curves::constant_x, horizon_curves::both}) {
    v.families = families;
    std::vector<irg::cell> cells;
    recorder all{cells};
    irg::draw_horizon_surface(all, rough{3}, v, [](auto...) {});
    const horizon_curve_points c = horizon_curves_of(rough{3}, v);
    std::size_t next = 0;
    const int offset = static_cast<int>(std::ceil(30 * irg::sin(v.yaw)));
    for (const P& p : c.points) {
      if (!(p.x == p.x)) continue;
      REQUIRE(next < cells.size());
      CHECK(cells[next] ==
            irg::cell{static_cast<int>(std::floor(p.x + 0.5)) + offset, static_cast<int>(std::floor(p.y + 0.5))});
      ++next;
    }
    CHECK(next == cells.size());
  }
}

TEST_CASE("horizon_curves: both orders show the same, at 45 degrees and at every yaw") {
  test::random r(45);
  for (int i = 0; i < 120; ++i) {
    const double degrees = i < 40 ? 45 : 89 * r.unit() + 0.5;
    horizon_view v = any_view(r, irg::radians(degrees), irg::radians(180 * r.unit() - 90));
    v.samples = (v.curves - 1) * 3 + 1;
    irg::detail::turned_view t = irg::detail::turn_view(v);
    const rough height{static_cast<unsigned>(i)};
    const auto place = [&](double x, double y, double z) { return irg::detail::turned_place(t, x, y, z); };
    const auto sampled = [&](double sin_yaw) {  // which decides the order alone
      irg::detail::turned_view o = t;
      o.sin_yaw = sin_yaw;
      return irg::detail::curve_points(height, o, irg::detail::eye_at_infinity, place);
    };
    const auto z_first = sampled(0), x_first = sampled(2);
    CHECK(z_first.points.size() == x_first.points.size());
    REQUIRE(drawn(z_first) == drawn(x_first));
  }
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("visible curves of surfaces: against the definition, at right angles and as eyes see them") {
  const int trials = std::getenv("IRG_RELEASE_TIER") != nullptr ? 1500 : 60;
  test::random r(31);
  double hidden = 0, length = 0;
  for (int i = 0; i < trials; ++i) {
    const double degrees = i % 7 == 0 ? 0 : i % 7 == 1 ? 90 : i % 7 == 2 ? 45 : 90 * r.unit();
    horizon_view v = any_view(r, irg::radians(degrees), irg::radians(i % 5 == 0 ? 0 : 180 * r.unit() - 90));
    v.samples = static_cast<int>(r.integer(2, 14));
    v.families = std::array{horizon_curves::both, horizon_curves::both, horizon_curves::constant_z,
                            horizon_curves::constant_x}[static_cast<std::size_t>(i % 4)];
    const rough height{static_cast<unsigned>(i)};
    REQUIRE(is_true(horizon_curves_of(height, v), hidden, length));
    // Eyes beside the square in one coordinate or both, in line with curves too, above and below.
    const auto beside = [&] { return r.integer(0, 1) == 0 ? -3 * r.unit() : 1 + 3 * r.unit(); };
    const double along = i % 3 == 0 ? static_cast<double>(r.integer(0, 4)) / 4 : r.unit();
    irg::point<double, 3> eye{beside(), 4 * r.unit() - 1.5, beside()};
    if (i % 3 != 1) (i % 2 == 0 ? eye.x : eye.z) = along;
    REQUIRE(is_true(horizon_curves_from(height, v, eye), hidden, length));
  }
  CHECK(hidden > 0.1 * length);
}
#endif

TEST_CASE("horizon_curves: gaps, eyes that see nothing, in constant evaluation") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const horizon_view v{20, 10, irg::radians(30.0), irg::radians(40.0), 5};
  const auto holed = [&](double x, double z) { return x > 0.6 ? nan : z > 0.8 ? inf : x + z; };
  const horizon_curve_points c = horizon_curves_of(holed, v);
  CHECK(c.points.size() == c.heights.size());
  for (std::size_t k = 0; k < c.points.size(); ++k)
    CHECK((c.points[k].x == c.points[k].x) == (std::isfinite(c.heights[k])));
  for (const irg::edge_part& p : seen_of(c)) CHECK(std::isfinite(c.heights[p.edge] + c.heights[p.edge + 1]));
  const auto level = [](double, double) { return 0.0; };
  for (const irg::point<double, 3> eye :
       {irg::point<double, 3>{0.5, 2, 0.5}, {0.5, nan, -1}, {inf, 0, 0}, {-inf, 0, 1}, {0.1, 9, 0.9}})
    CHECK(horizon_curves_from(level, v, eye).points.empty());
  CHECK(!horizon_curves_from(level, v, {0.9, 1, -0.01}).points.empty());  // a part of which is behind the eye
  // From as far as doubles go what is seen is flat, but it is there.
  for (const double far_off : {-1e150, -1e200, -0x1.fffffffffffffp1023})
    for (const irg::point<double, 3>& eye :
         {irg::point<double, 3>{far_off, 0, 0.5}, {0.5, 0, far_off}, {far_off, 0, far_off}}) {
      const auto curves = horizon_curves_from(level, v, eye);
      CHECK(curves.points.size() == horizon_curves_from(level, v, {-2, 0, -2}).points.size());
      CHECK(std::abs(curves.points[0].x) <= 1e-100);
    }
  CHECK_BOTH(horizon_curves_of([](double x, double z) { return x * z; }, horizon_view{4, 3, 0, 0, 2}).points.size() ==
             17);
  CHECK_BOTH(horizon_curves_from([](double x, double z) { return x * z; }, horizon_view{2, 3, 0, 0, 2}, {-1, 2, -1})
                 .points.size() == 15);
  CHECK(horizon_curves_of(level, horizon_view{0, 0, nan, nan, -5}).points.size() > 0);
}
