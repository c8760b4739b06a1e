// SPDX-License-Identifier: MIT
// Points of curves and surfaces, fitted control points, and surfaces as triangles, bit for bit.
#include "hashes.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <irg/curve/bezier_forward.hpp>
#include <irg/curve/bezier_prepared.hpp>
#include <irg/curve/bspline_fit.hpp>
#include <irg/curve/bspline_surface.hpp>
#include <irg/curve/surface_trimming.hpp>

namespace {

template <class P>
constexpr void add_point(determinism::hasher& h, const P& p) {
  for (int i = 0; i < irg::size_of<P>; ++i) h.add(irg::coordinate(p, i));
}

template <class P>
constexpr std::vector<P> some_points(test::random& r, std::size_t count) {
  using T = irg::scalar_of<P>;
  std::vector<P> points(count, P{});
  for (P& p : points) {
    std::array<T, 4> c{};  // one after the other: arguments are evaluated in any order
    for (T& x : c) x = static_cast<T>(r.integer(-4000, 4000)) / T(3);
    p = irg::generate_coordinates<P>([&](int i) { return c[static_cast<std::size_t>(i)]; });
  }
  return points;
}

// Prepared curves one point at a time and in batches, forward differences.
template <class P>
constexpr std::uint64_t many_points(int rounds) {
  using T = irg::scalar_of<P>;
  determinism::hasher h;
  test::random r(19);
  for (int i = 0; i < rounds; ++i) {
    const auto points = some_points<P>(r, static_cast<std::size_t>(1 + i % 31));
    std::vector<T> space(irg::prepared_bezier<P>::numbers_for(points.size()), T(0)), t(70, T(0));
    std::vector<irg::exact_sum<T>> sums(points.size(), irg::exact_sum<T>{});
    std::vector<P> found(t.size(), P{}), room(points.size(), P{});
    const auto curve = irg::prepare_bezier(points, std::span<T>(space), sums);
    for (std::size_t k = 0; k < t.size(); ++k)
      t[k] = static_cast<T>(i % 2 == 0 ? r.unit() : static_cast<double>(k) / 69);
    if (!curve) continue;
    irg::bezier_points(*curve, t, std::span<P>(found));
    for (const P& p : found) add_point(h, p);
    for (std::size_t k = 0; k < 5; ++k) add_point(h, irg::bezier_point(*curve, t[k]));
    irg::bezier_forward(points, 20, std::span<P>(room), [&](const P& p) { add_point(h, p); });
  }
  return h.value();
}
constexpr std::uint64_t curve_many_points(int rounds) { return many_points<irg::point<double, 3>>(rounds); }
constexpr std::uint64_t curve_many_points_f(int rounds) { return many_points<irg::point<float, 2>>(rounds); }
HASHED(curve_many_points, 3, 300);
HASHED(curve_many_points_f, 3, 300);

// Rational surfaces: points, derivatives, poles.
constexpr std::uint64_t curve_nurbs(int rounds) {
  using H = irg::hpoint<double, 3>;
  determinism::hasher h;
  test::random r(20);
  const std::array<double, 10> u{0, 0, 0, 0, 1, 2.5, 3, 3, 3, 3};
  const irg::bspline_knots<double, 3> knots(u);
  for (int i = 0; i < rounds; ++i) {
    auto net = some_points<H>(r, 36);
    for (H& p : net) p.w = 0.5 + r.unit();
    const irg::bspline_surface<H, 3> surface{knots, knots, {net, 6}};
    for (int k = 0; k < (rounds < 4 ? 2 : 50); ++k) {
      const double x = k == 0 ? 3 : 3 * r.unit(), y = 3 * r.unit();
      add_point(h, *irg::nurbs_surface_point(surface, x, y));
      add_point(h, *irg::nurbs_point(knots, std::span<const H>(net).first(6), y));
      const auto s = *irg::nurbs_surface_sample(surface, x, y);
      add_point(h, s.du);
      add_point(h, s.dv);
      add_point(h, s.duv);
    }
  }
  return h.value();
}
HASHED(curve_nurbs, 1, 100);

// Control points by interpolation and least squares.
constexpr std::uint64_t curve_fits(int rounds) {
  using P = irg::point<double, 2>;
  determinism::hasher h;
  test::random r(21);
  for (int i = 0; i < rounds; ++i) {
    const std::size_t size = rounds < 4 ? 7 : 40, count = i % 2 == 0 ? size : size / 2 + 1;
    const auto points = some_points<P>(r, size);
    std::vector<double> places(size, 0.), list(count + 4, 0.);
    std::vector<P> control(count, P{});
    static_cast<void>(irg::parametrize(std::span<const P>(points), irg::fit_spacing::centripetal, places));
    irg::fit_knots(std::span<const double>(places), 3, count, list);
    const auto knots = irg::make_bspline_knots(std::span<const double>(list), 3);
    if (!knots) continue;
    const auto fit =
        irg::bspline_least_squares(*knots, places, std::span<const P>(points), irg::fit_ends::through, control);
    h.add(fit.value_or(0));
    for (const P& p : control) add_point(h, p);
  }
  return h.value();
}
HASHED(curve_fits, 2, 100);

// Triangles within a tolerance, whole patches and trimmed ones, rational ones too.
template <class P>
constexpr void add_triangles(determinism::hasher& h, const irg::control_net<P>& net, double tolerance) {
  const auto add = [&](const auto& a, const auto& b, const auto& c) {
    for (const auto* corner : {&a, &b, &c}) {
      h.add(corner->index);
      h.add(corner->u.t);
      h.add(corner->v.t);
      add_point(h, corner->point);
    }
  };
  h.add(irg::tessellate_within(net, tolerance, add).triangles);
  const std::array<irg::point<double, 2>, 3> part{{{0.1, 0.2}, {0.9, 0.3}, {0.4, 1.2}}};
  if (const auto done = irg::tessellate_trimmed(net, part, tolerance, add)) h.add(done->triangles);
}
constexpr std::uint64_t curve_triangles(int rounds) {
  determinism::hasher h;
  test::random r(22);
  for (int i = 0; i < rounds; ++i) {
    const auto points = some_points<irg::point<double, 3>>(r, rounds < 4 ? 4 : 12);
    if (rounds < 4) {
      add_triangles(h, irg::control_net<irg::point<double, 3>>{points, 2}, 3000);
      continue;
    }
    add_triangles(h, irg::control_net<irg::point<double, 3>>{points, 3}, 30);
    std::vector<irg::hpoint<double, 3>> weighted(12, irg::hpoint<double, 3>{});
    for (std::size_t k = 0; k < 12; ++k) weighted[k] = irg::to_homogeneous(points[k], 0.5 + r.unit());
    add_triangles(h, irg::control_net<irg::hpoint<double, 3>>{weighted, 3}, 100);
  }
  return h.value();
}
HASHED(curve_triangles, 1, 30);

}  // namespace
