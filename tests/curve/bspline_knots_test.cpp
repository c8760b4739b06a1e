// SPDX-License-Identifier: MIT
#include <irg/curve/bspline_knots.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/curve/bezier.hpp>
#include <irg/curve/rational.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/spline_oracle.hpp"

namespace {

using P = irg::point<double, 2>;
using H = irg::hpoint<double, 2>;
constexpr double inf = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<double, 8> clamped{0, 0, 0, 1, 2, 3, 3, 3};
constexpr std::array<P, 5> hill{P{0, 0}, P{1, 2}, P{3, 2}, P{4, 0}, P{6, 1}};
constexpr auto knots = irg::bspline_knots<double, 2>(clamped);

constexpr std::array<P, 7> refined_hill() {
  std::array<double, 10> merged{};
  std::array<double, 3> scratch{};
  std::array<P, 7> result{};
  static_cast<void>(irg::insert_knots(knots, std::array<double, 2>{0.5, 1}, merged));
  irg::bspline_refine(knots, hill, irg::bspline_knots<double, 2>(merged), result, scratch);
  return result;
}

constexpr std::array<P, 8> elevated_hill() {
  std::array<double, 18> all{};
  const std::size_t count = irg::elevated_knots(knots, all);
  const auto elevated = *irg::make_bspline_knots<3>(std::span<const double>(all).first(count));
  std::array<double, 6> scratch{};
  std::array<P, 8> result{};
  if (elevated.size() != 8) return result;
  irg::bspline_elevate(knots, hill, elevated, result, scratch);
  return result;
}

struct piece {
  double from = 0, to = 0;
  std::array<P, 3> controls{};
  constexpr bool operator==(const piece&) const = default;
};

constexpr std::array<piece, 3> pieces_of_hill() {
  std::array<piece, 3> result{};
  std::array<double, 3> scratch{};
  std::array<P, 3> controls{};
  std::size_t count = 0;
  irg::bspline_bezier_pieces(knots, hill, scratch, controls, [&](double from, double to, std::span<const P> c) {
    result[count++] = {from, to, {c[0], c[1], c[2]}};
  });
  return result;
}

irg::knots_status inserted(const std::vector<double>& list) {
  std::vector<double> merged(clamped.size() + list.size());
  return irg::insert_knots(knots, list, merged);
}

}  // namespace

TEST_CASE("bspline_refine, bspline_bezier_pieces and bspline_elevate: values by hand") {
  CHECK_BOTH(refined_hill() == std::array<P, 7>{P{0, 0}, P{0.5, 1}, P{1.5, 2}, P{2, 2}, P{3, 2}, P{4, 0}, P{6, 1}});
  CHECK_BOTH(pieces_of_hill() == std::array<piece, 3>{piece{0, 1, {P{0, 0}, P{1, 2}, P{2, 2}}},
                                                      piece{1, 2, {P{2, 2}, P{3, 2}, P{3.5, 1}}},
                                                      piece{2, 3, {P{3.5, 1}, P{4, 0}, P{6, 1}}}});
  constexpr auto raised = elevated_hill();
  CHECK_BOTH(raised[0] == P{0, 0});
  CHECK_BOTH(raised[7] == P{6, 1});
  CHECK(std::abs(raised[1].x - 2. / 3) < 1e-15);
  CHECK(std::abs(raised[1].y - 4. / 3) < 1e-15);
}

TEST_CASE("insert_knots: what cannot be inserted; bspline_refine: knots that are no refinement") {
  using enum irg::knots_status;
  CHECK(inserted({}) == irg::knots_status::ok);
  CHECK(inserted({0.5, 1, 1, 2.5}) == irg::knots_status::ok);
  CHECK(inserted({1, 1, 1}) == too_many_equal);
  CHECK(inserted({0}) == too_many_equal);
  CHECK(inserted({2, 1}) == decreasing);
  CHECK(inserted({-0.5}) == outside);
  CHECK(inserted({3.5}) == outside);
  CHECK(inserted({inf}) == not_finite);
  CHECK(inserted({not_a_number}) == not_finite);
  std::array<double, 4> scratch{};
  std::array<P, 8> result{};
  const std::array<double, 8> other{0, 0, 0, 1, 2.5, 3, 3, 3};
  CHECK(!irg::bspline_refine(knots, hill, irg::bspline_knots<double, 2>(other), result, scratch));
  const std::array<double, 10> cubic{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
  CHECK(!irg::bspline_refine(knots, hill, irg::bspline_knots<double, 3>(cubic), result, scratch));
  CHECK(irg::bspline_refine(knots, hill, knots, result, scratch));
  CHECK(std::equal(hill.begin(), hill.end(), result.begin()));
}

TEST_CASE("rational curves: the circle in pieces, refined and elevated, is a circle") {
  const auto list = irg::circle_knots<double>();
  const auto circle = irg::circle_points(P{0, 0}, 1);
  const irg::bspline_knots<double, 2> u(list);
  std::array<double, 6> scratch{};
  std::array<H, 3> controls{};
  int pieces = 0;
  const auto off = [](const H& h) { return std::abs(h[0] * h[0] + h[1] * h[1] - h[2] * h[2]) / (h[2] * h[2]); };
  irg::bspline_bezier_pieces(u, circle, scratch, controls, [&](double, double, std::span<const H> c) {
    ++pieces;
    std::array<H, 3> work{};
    for (int k = 0; k <= 16; ++k) CHECK(off(irg::bezier_point(c, k / 16.0, work)) < 1e-15);
  });
  CHECK(pieces == 4);
  std::vector<double> raised(26);
  raised.resize(irg::elevated_knots(u, raised));
  const auto elevated = *irg::make_bspline_knots(std::span<const double>(raised), 3);
  std::vector<H> points(elevated.size());
  irg::bspline_elevate(u, circle, elevated, std::span<H>(points), scratch);
  std::array<double, 4> value{};
  for (int k = 0; k <= 64; ++k) CHECK(off(*irg::bspline_point(elevated, points, k / 16.0, value)) < 2e-15);
}

namespace {

struct random_spline {
  std::size_t degree = 0;
  std::vector<double> u;
  std::vector<P> points;
};

/// Knots of all multiplicities, clamped or not, evenly spaced, crowded or of all sizes; points of one size or many.
random_spline make_spline(test::random& r) {
  random_spline s;
  s.degree = static_cast<std::size_t>(r.integer(0, 6));
  const auto kind = r.integer(0, 3);
  double at = kind == 3 ? 1 : static_cast<double>(r.integer(-3, 3));
  while (s.u.size() < 2 * s.degree + 2 + static_cast<std::size_t>(r.integer(0, 6))) {
    const auto times = r.integer(0, 1) == 0 ? r.integer(1, static_cast<std::int64_t>(s.degree) + 1) : 1;
    for (std::int64_t k = 0; k < times; ++k) s.u.push_back(at);
    at += kind == 0   ? 1
          : kind == 1 ? r.unit()
          : kind == 2 ? std::ldexp(r.unit(), static_cast<int>(r.integer(-300, 300)))
                      : 0x1p-52;
  }
  const bool mixed = r.integer(0, 2) == 0;
  for (std::size_t i = 0; i + s.degree + 1 < s.u.size(); ++i) {
    const double x = 2 * r.unit() - 1, y = 2 * r.unit() - 1;
    s.points.push_back({x, mixed ? std::ldexp(y, static_cast<int>(r.integer(-1000, 1000))) : y});
  }
  return s;
}

double largest_size(const std::vector<P>& points) {
  double largest = 0;
  for (const P& p : points) largest = std::fmax(largest, std::abs(p.y));
  return largest;
}

}  // namespace

TEST_CASE("knots inserted and degrees raised: new control points stay in the box of the old ones, whatever the knots") {
  test::random r(5);
  long curves = 0, points = 0, wrong = 0;
  for (int round = 0; round < (std::getenv("IRG_RELEASE_TIER") ? 200'000 : 3000); ++round) {
    const random_spline s = make_spline(r);
    const auto u = irg::make_bspline_knots(std::span<const double>(s.u), static_cast<int>(s.degree));
    if (!u) continue;
    ++curves;
    std::vector<double> more, scratch(2 * s.degree + 2);
    for (auto k = r.integer(0, 5); k > 0; --k)
      more.push_back(std::clamp(u->first() + (u->last() - u->first()) * r.unit(), u->first(), u->last()));
    if (r.integer(0, 1) == 0) more.push_back(u->first());
    std::sort(more.begin(), more.end());
    const double bound = largest_size(s.points) * (1 + 0x1p-48);
    const auto count = [&](const std::vector<P>& result) {
      for (const P& p : result) wrong += !(std::abs(p.y) <= bound && std::abs(p.x) <= 1 + 0x1p-48);
      points += static_cast<long>(result.size());
    };
    std::vector<double> merged(s.u.size() + more.size());
    if (irg::insert_knots(*u, more, merged) == irg::knots_status::ok) {
      const auto refined = *irg::make_bspline_knots(std::span<const double>(merged), u->degree());
      std::vector<P> result(refined.size());
      CHECK(irg::bspline_refine(*u, s.points, refined, std::span<P>(result), scratch));
      count(result);
    }
    std::vector<double> raised(2 * s.u.size() + 2);
    raised.resize(irg::elevated_knots(*u, raised));
    const auto elevated = irg::make_bspline_knots(std::span<const double>(raised), u->degree() + 1);
    REQUIRE(elevated);
    std::vector<P> result(elevated->size());
    irg::bspline_elevate(*u, s.points, *elevated, std::span<P>(result), scratch);
    count(result);
    wrong += !(*irg::bspline_point(*elevated, result, u->last(), scratch) ==
               *irg::bspline_point(*u, s.points, u->last(), scratch));
    double end = u->first();
    P joint{};
    std::vector<P> controls(s.degree + 1);
    irg::bspline_bezier_pieces(*u, s.points, scratch, std::span<P>(controls),
                               [&](double from, double to, std::span<const P> c) {
                                 wrong += from != end || !(from < to);
                                 count(std::vector<P>(c.begin(), c.end()));
                                 const auto equal = std::count(s.u.begin(), s.u.end(), from);
                                 const bool is_torn = equal > static_cast<std::ptrdiff_t>(s.degree);
                                 if (from > u->first() && !is_torn) wrong += !(c[0] == joint);
                                 std::vector<double> value(s.degree + 1);
                                 wrong += !(c[0] == *irg::bspline_point(*u, s.points, from, value));
                                 joint = c.back();
                                 end = to;
                               });
    wrong += end != u->last();
  }
  MESSAGE(curves, " curves, ", points, " points");
  CHECK(curves > 300);
  CHECK(wrong == 0);
}

TEST_CASE("degrees raised: an end between control points is the same point, bit for bit") {
  constexpr std::array<double, 10> numbers{2, 2, 2, 3, 3, 4, 5, 5, 6, 6};
  constexpr std::array<P, 5> points{P{0, -0x1.9d6a20155923cp-2},
                                    {0, 0x1.fb7624ae686p-9},
                                    {0, 0x1.0f08965d5880cp-2},
                                    {0, 0x1.ec1461019f242p-1},
                                    {0, 0x1.3324f14c838a8p-1}};
  const auto u = *irg::make_bspline_knots(std::span<const double>(numbers), 4);
  std::vector<double> raised(22), scratch(10);
  raised.resize(irg::elevated_knots(u, raised));
  const auto elevated = *irg::make_bspline_knots(std::span<const double>(raised), 5);
  std::vector<P> result(elevated.size());
  irg::bspline_elevate(u, points, elevated, std::span<P>(result), scratch);
  CHECK(*irg::bspline_point(elevated, result, u.last(), scratch) == *irg::bspline_point(u, points, u.last(), scratch));
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("knots inserted, pieces and degrees raised: the same curve, in rationals") {
  test::random r(6);
  double worst_refined = 0, worst_piece = 0, worst_elevated = 0;
  int curves = 0;
  for (int round = 0; round < (std::getenv("IRG_RELEASE_TIER") ? 10'000 : 120); ++round) {
    const random_spline s = make_spline(r);
    const auto u = irg::make_bspline_knots(std::span<const double>(s.u), static_cast<int>(s.degree));
    if (!u) continue;
    ++curves;
    const double size = largest_size(s.points);
    std::vector<double> scratch(2 * s.degree + 2), more;
    for (auto k = r.integer(1, 4); k > 0; --k)
      more.push_back(std::clamp(u->first() + (u->last() - u->first()) * r.unit(), u->first(), u->last()));
    std::sort(more.begin(), more.end());
    std::vector<double> merged(s.u.size() + more.size()), raised(2 * s.u.size() + 2);
    std::vector<P> refined_points, elevated_points;
    if (irg::insert_knots(*u, more, merged) == irg::knots_status::ok) {
      const auto refined = *irg::make_bspline_knots(std::span<const double>(merged), u->degree());
      refined_points.resize(refined.size());
      irg::bspline_refine(*u, s.points, refined, std::span<P>(refined_points), scratch);
    }
    raised.resize(irg::elevated_knots(*u, raised));
    const auto elevated = *irg::make_bspline_knots(std::span<const double>(raised), u->degree() + 1);
    elevated_points.resize(elevated.size());
    irg::bspline_elevate(*u, s.points, elevated, std::span<P>(elevated_points), scratch);
    const auto y_of = [](const std::vector<P>& points) {
      return [&](std::size_t i) { return test::big_rational(points[i].y); };
    };
    const auto off = [&](const test::big_rational& got, const test::big_rational& want) {
      return static_cast<double>(abs(got - want)) / size;
    };
    for (int k = 0; k < 6; ++k) {
      double t = k == 0 ? u->first() : k == 1 ? u->last() : u->first() + (u->last() - u->first()) * r.unit();
      t = std::clamp(t, u->first(), u->last());
      const auto want = test::spline_value(s.u, s.degree, t, 0, y_of(s.points));
      if (!refined_points.empty())
        worst_refined =
            std::fmax(worst_refined, off(test::spline_value(merged, s.degree, t, 0, y_of(refined_points)), want));
      worst_elevated =
          std::fmax(worst_elevated, off(test::spline_value(raised, s.degree + 1, t, 0, y_of(elevated_points)), want));
    }
    std::vector<P> controls(s.degree + 1);
    irg::bspline_bezier_pieces(
        *u, s.points, scratch, std::span<P>(controls), [&](double from, double to, std::span<const P> c) {
          const double t = std::clamp(from + (to - from) * r.unit(), from, std::nextafter(to, from));
          std::vector<double> ends(2 * (s.degree + 1), from);  // the piece as a B-spline of one stretch
          std::fill(ends.begin() + static_cast<std::ptrdiff_t>(s.degree) + 1, ends.end(), to);
          const std::vector<P> piece(c.begin(), c.end());
          worst_piece = std::fmax(worst_piece, off(test::spline_value(ends, s.degree, t, 0, y_of(piece)),
                                                   test::spline_value(s.u, s.degree, t, 0, y_of(s.points))));
        });
  }
  MESSAGE(curves, " curves: refined ", worst_refined * 0x1p53, " u, pieces ", worst_piece * 0x1p53, " u, elevated ",
          worst_elevated * 0x1p53, " u of the largest control point");
  CHECK(curves > 50);
  CHECK(worst_refined <= 16 * 0x1p-53);
  CHECK(worst_piece <= 16 * 0x1p-53);
  CHECK(worst_elevated <= 16 * 0x1p-53);
}
#endif
