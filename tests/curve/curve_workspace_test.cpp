// SPDX-License-Identifier: MIT
// Whatever works in memory of the caller's gives the same bits in a workspace, which allocates nothing when it is used
// again.
#include <array>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/curve/bezier_accurate.hpp>
#include <irg/curve/bezier_crossings.hpp>
#include <irg/curve/bezier_edge_form.hpp>
#include <irg/curve/bezier_forward.hpp>
#include <irg/curve/bezier_prepared.hpp>
#include <irg/curve/bezier_queries.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/curve/bspline_knots.hpp>
#include <irg/curve/bspline_surface.hpp>
#include <irg/curve/flatten.hpp>

#include "mesh/short_memory.hpp"
#include "support/check_both.hpp"

namespace {

using P = irg::point<double, 2>;
using V = irg::vec<double, 2>;
using N = irg::vec<double, 1>;
using P3 = irg::point<double, 3>;
using V3 = irg::vec<double, 3>;
using H3 = irg::hpoint<double, 3>;

// All numbers that a row of calls gives, in memory of its own.
struct numbers_given {
  std::array<double, 256> value{};
  std::size_t count = 0;
  constexpr void add(double x) { value[count++] = x; }
  template <irg::Coordinates Q>
  constexpr void add(const Q& p) {
    for (int i = 0; i < irg::size_of<Q>; ++i) add(irg::coordinate(p, i));
  }
  template <class Q>
  constexpr void add(const irg::curve_sample<Q>& s) {
    add(s.point), add(s.derivative);
  }
  template <class Q>
  constexpr void add(const irg::surface_sample<Q>& s) {
    add(s.point), add(s.du), add(s.dv), add(s.duv);
  }
  template <class Q, std::size_t Extent>
  constexpr void add(std::span<Q, Extent> all) {
    for (const auto& q : all) add(q);
  }
  constexpr void add(const irg::root_interval<double>& r) { add(r.from), add(r.to); }
  constexpr void add(const irg::surface_piece<P3>& piece) { add(piece.u_to), add(piece.v_to), add(piece.net.points); }
  constexpr bool operator==(const numbers_given&) const = default;
};

constexpr std::array<P, 4> hill{P{0, 0}, P{1, 2}, P{2, 2.5}, P{3, 0}};
constexpr std::array<P, 3> bowl_points{P{0, 2}, P{1.5, -2}, P{3, 2}};
constexpr std::span<const P> curve(hill), bowl(bowl_points);
constexpr std::array<double, 4> weights{1, 2, 1, 0.5};
constexpr std::array<double, 7> list{0, 0, 0, 1, 2, 2, 2};
constexpr std::array<double, 8> finer{0, 0, 0, 0.5, 1, 2, 2, 2};
constexpr std::array<double, 10> raised{0, 0, 0, 0, 1, 1, 2, 2, 2, 2};
using run_time_knots = irg::bspline_knots<double, irg::degree_at_run_time>;
constexpr run_time_knots knots(list, 2), refined(finer, 2), elevated(raised, 3);

// What a call works in: scratch as it is, a workspace that is kept, or one for the call alone.
struct in_scratch {
  template <class S>
  constexpr S& operator()(S& scratch) const {
    return scratch;
  }
  template <class Call, class Sink, class... S>
  constexpr auto call(const Call& of, Sink& sink, S&... scratch) const {
    return of(scratch..., sink);
  }
};
template <class Q>
struct in_workspace {
  irg::curve_workspace<Q>& memory;
  template <class S>
  constexpr irg::curve_workspace<Q>& operator()(S&) const {
    return memory;
  }
  template <class Call, class Sink, class... S>
  constexpr auto call(const Call& of, Sink& sink, S&...) const {
    return of(sink, memory);
  }
};
template <class Q>
struct in_none {
  template <class S>
  constexpr irg::curve_workspace<Q> operator()(S&) const {
    return {};
  }
  template <class Call, class Sink, class... S>
  constexpr auto call(const Call& of, Sink& sink, S&...) const {
    return of(sink);
  }
};

template <class In>
constexpr numbers_given bezier_curves(const In& in) {
  numbers_given all;
  const auto sink = [&](const auto& x) { all.add(x); };
  std::array<P, 21> points{};
  std::array<N, 32> numbers{};
  std::array<irg::exact_sum<double>, 4> sums{};
  std::array<double, 4> shares{};
  std::array<double, irg::prepared_bezier<P>::numbers_for(4)> space{};
  std::array<irg::curve_meeting<double>, 4> room{};
  all.add(irg::bezier_point(curve, 0.3, in(points)));
  all.add(irg::bezier_sample(curve, 0.3, in(points)));
  all.add(irg::bezier_point_accurate(curve, 0.3, in(sums)));
  all.add(irg::bezier_point_of_edges(curve, 0.3, in(shares)));
  all.add(irg::bezier_point(*irg::prepare_bezier(curve, std::span<double>(space), in(sums)), 0.3));
  all.add(irg::bezier_box(curve, in(numbers)).high);
  if constexpr (std::is_same_v<In, in_scratch>)
    all.add(irg::bezier_nearest(curve, P{2, 9}, numbers, points).point);
  else
    all.add(irg::bezier_nearest(curve, P{2, 9}, in(points)).point);
  all.add(static_cast<double>(irg::bezier_intersections(curve, bowl, {0.01}, room, in(points)).value));
  for (const auto& m : room) all.add(m.first_from), all.add(m.second_to);
  in.call([&](auto&... a) { irg::bezier_forward(curve, 5, a...); }, sink, points);
  in.call([&](auto&... a) { all.add(irg::bezier_line_intersections(curve, P{0, 1}, P{1, 1}, a...)); }, sink, numbers);
  in.call([&](auto&... a) { all.add(static_cast<double>(irg::flatten(curve, 0.1, a...).pieces)); }, sink, points);
  return all;
}

template <class In>
constexpr numbers_given bspline_curves(const In& in) {
  numbers_given all;
  const auto sink = [&](const auto&... x) { (all.add(x), ...); };
  std::array<P, 6> result{};
  std::array<V, 3> derivatives{};
  std::array<double, 6> numbers{};
  std::array<P, 3> points{};
  std::array<V, 6> vectors{};
  all.add(*irg::bspline_point(knots, curve, 0.7, in(numbers)));
  all.add(*irg::nurbs_point(knots, curve, weights, 0.7, in(numbers)));
  all.add(*irg::bspline_point_de_boor(knots, curve, 0.7, in(points)));
  all.add(irg::bspline_derivatives(knots, curve, 0.7, derivatives, in(vectors)));
  all.add(std::span(derivatives));
  all.add(*irg::bspline_sample(knots, curve, 0.7, in(vectors)));
  all.add(irg::bspline_refine(knots, curve, refined, result, in(numbers)));
  all.add(std::span(result));
  irg::bspline_elevate(knots, curve, elevated, result, in(numbers));
  all.add(std::span(result));
  in.call([&](auto&&... a) { irg::bspline_bezier_pieces(knots, curve, a...); }, sink, numbers, points);
  return all;
}

constexpr std::array<P3, 9> roof{P3{0, 0, 0}, {0, 1, 4}, {0, 2, 0}, {1, 0, 0}, {1, 1, 4},
                                 {1, 2, 0},   {2, 0, 2}, {2, 1, 6}, {2, 2, 2}};
constexpr std::array<H3, 9> heavy{H3{0, 0, 0, 1}, {0, 1, 4, 2}, {0, 2, 0, 1}, {1, 0, 0, 1}, {1, 1, 4, 3},
                                  {1, 2, 0, 1},   {2, 0, 2, 1}, {2, 1, 6, 1}, {2, 2, 2, 2}};
constexpr std::array<double, 6> one_stretch{0, 0, 0, 1, 1, 1};
constexpr std::array<double, 5> two_stretches{0, 0, 1, 2, 2};
constexpr run_time_knots along_u(one_stretch, 2), along_v(two_stretches, 1);
constexpr irg::bspline_surface<P3> surface{along_u, along_v, {roof, 3}};
constexpr irg::bspline_surface<H3> rational{along_u, along_v, {heavy, 3}};

template <class In>
constexpr numbers_given surfaces(const In& in) {
  numbers_given all;
  const auto sink = [&](const auto& piece) { all.add(piece); };
  std::array<V3, 9> derivatives{};
  std::array<P3, 9> points{};
  std::array<V3, 18> vectors{};
  std::array<double, 13> numbers{};
  all.add(irg::patch_sample(surface.net, 0.3, 0.6, in(points)));
  all.add(*irg::bspline_surface_point(surface, 0.3, 0.6, in(numbers)));
  all.add(irg::bspline_surface_derivatives(surface, {0.3, 0.6}, 2, derivatives, in(vectors)));
  all.add(std::span(derivatives));
  all.add(*irg::bspline_surface_sample(surface, 0.3, 0.6, in(vectors)));
  in.call([&](auto&... a) { irg::bspline_surface_patches(surface, a...); }, sink, numbers, points);
  return all;
}

template <class In>
constexpr numbers_given rational_surfaces(const In& in) {
  numbers_given all;
  std::array<H3, 16> points{};
  std::array<double, 5> numbers{};
  all.add(*irg::nurbs_surface_point(rational, 0.3, 0.6, in(numbers)));
  all.add(*irg::nurbs_surface_sample(rational, 0.3, 0.6, in(points)));
  return all;
}

template <class In>
constexpr numbers_given roots(const In& in) {
  constexpr std::array<N, 3> coefficients{N{-1}, N{2}, N{-1.5}};
  numbers_given all;
  const auto sink = [&](const auto& r) { all.add(r); };
  std::array<N, 9> numbers{};
  in.call([&](auto&... a) { irg::bernstein_roots<double>(coefficients, 0.0, a...); }, sink, numbers);
  return all;
}

template <class W>
concept works_in = requires(W& memory) { irg::bezier_point(curve, 0.3, memory); };

// Once in a workspace of its own, once in one that is kept, and again in that without memory.
template <class Q, class Calls>
void check_in_workspaces(const Calls& calls) {
  const numbers_given expected = calls(in_scratch{});
  REQUIRE(expected.count > 3);
  CHECK(calls(in_none<Q>{}) == expected);
  irg::curve_workspace<Q> workspace;
  CHECK(calls(in_workspace<Q>{workspace}) == expected);
  test::allocations_left = 0;
  const numbers_given again = calls(in_workspace<Q>{workspace});
  test::allocations_left = -1;
  CHECK(again == expected);
}

}  // namespace

TEST_CASE("curve_workspace: the bits of scratch, and nothing allocated when it is used again") {
  check_in_workspaces<P>([](const auto& in) { return bezier_curves(in); });
  check_in_workspaces<P>([](const auto& in) { return bspline_curves(in); });
  check_in_workspaces<P3>([](const auto& in) { return surfaces(in); });
  check_in_workspaces<H3>([](const auto& in) { return rational_surfaces(in); });
  check_in_workspaces<N>([](const auto& in) { return roots(in); });
}

TEST_CASE("curve_workspace: in constant evaluation, and beside forms that need none") {
  static_assert(bspline_curves(in_none<P>{}) == bspline_curves(in_scratch{}));
  static_assert(surfaces(in_none<P3>{}) == surfaces(in_scratch{}));
  static_assert(rational_surfaces(in_none<H3>{}) == rational_surfaces(in_scratch{}));
  static_assert(roots(in_none<N>{}) == roots(in_scratch{}));
  CHECK_BOTH(irg::bezier_point(curve, 0.3) == irg::bezier_point(hill, 0.3));
  CHECK_BOTH(irg::bspline_point(knots, curve, 0.7) ==
             irg::bspline_point(irg::bspline_knots<double, 2>(list), hill, 0.7));
  CHECK_BOTH(irg::flatten(curve, 0.5, [](const P&) {}).within_tolerance);
  irg::curve_workspace<P> plane;
  constexpr irg::bspline_knots<double, 2> fixed(list);
  static_assert(noexcept(irg::bezier_point(hill, 0.3)) && noexcept(irg::bspline_point(fixed, hill, 0.7)));
  CHECK(irg::bezier_point(hill, 0.3, plane) == irg::bezier_point(hill, 0.3));
  CHECK(irg::bspline_point(fixed, hill, 0.7, plane) == irg::bspline_point(fixed, hill, 0.7));
  static_assert(works_in<irg::curve_workspace<P>> && works_in<std::array<P, 4>>);
  static_assert(!works_in<irg::curve_workspace<P3>> && !works_in<const irg::curve_workspace<P>>);
}
