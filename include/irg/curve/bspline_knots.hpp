// SPDX-License-Identifier: MIT
// The same B-spline curve over other knots: knots inserted, pieces as Bezier curves, the degree raised by one. A
// control point of the new curve is a mean of old ones, whose shares come from the recursion of the basis functions
// with a knot of the new list at each level in place of t; no share is negative, so that no new point leaves the box
// of the old ones. Rational curves take part as curves of hpoint.
#pragma once

#include <cstddef>
#include <span>

#include <irg/core/contract.hpp>
#include <irg/curve/bspline.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Merges the knots with others: `merged` gets the knots of a curve that bspline_refine controls with more points.
/// needs   merged as long as both together
/// gives   what check_knots says of the result; also not_finite, decreasing, and outside for inserted knots that
///         are not in [first(), last()]. `merged` is then of no use
/// exact   knots are copied
template <Floating T, int Degree>
constexpr knots_status insert_knots(const bspline_knots<T, Degree>& knots,
                                    std::type_identity_t<std::span<const T>> inserted,
                                    std::type_identity_t<std::span<T>> merged) noexcept {
  const auto old = knots.list();
  IRG_EXPECTS(merged.size() >= old.size() + inserted.size());
  for (std::size_t i = 0; i < inserted.size(); ++i) {
    if (!is_finite(inserted[i])) return knots_status::not_finite;
    if (i > 0 && inserted[i] < inserted[i - 1]) return knots_status::decreasing;
    if (!(knots.first() <= inserted[i] && inserted[i] <= knots.last())) return knots_status::outside;
  }
  std::size_t from_old = 0, from_new = 0;
  for (std::size_t i = 0; i < old.size() + inserted.size(); ++i) {
    const bool take_new = from_new < inserted.size() && (from_old == old.size() || inserted[from_new] < old[from_old]);
    merged[i] = take_new ? inserted[from_new++] : old[from_old++];
  }
  return check_knots(std::span<const T>(merged.first(old.size() + inserted.size())), knots.degree());
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// How many rows of knots.order() numbers bspline_elevate works in.
inline constexpr std::size_t elevate_rows = 2;

// Whether `fine` has every knot of `coarse` at least as often, and others only between first() and last().
template <Floating T, int Degree, int OtherDegree>
constexpr bool is_refined(const bspline_knots<T, Degree>& coarse, const bspline_knots<T, OtherDegree>& fine) noexcept {
  std::size_t at = 0;
  const auto old = coarse.list();
  for (const T& v : fine.list()) {
    if (at < old.size() && v == old[at])
      ++at;
    else if (!(coarse.first() <= v && v <= coarse.last()))
      return false;
  }
  return at == old.size() && coarse.degree() == fine.degree();
}

// The shares of the old points in one new point, whose knots are place(0), place(1), ... : the index of the first.
// Knots before the first and behind the last old one count as equal to these; no curve depends on them.
template <class V, Floating T, int Degree, class Place>
constexpr std::ptrdiff_t fill_refined_shares(V& value, const bspline_knots<T, Degree>& knots,
                                             const Place& place) noexcept {
  const auto old = knots.list();
  const std::size_t low = stretch_between(old, 0, old.size() - 1, place(0)), pad = knots.order();
  const auto padded = [&](std::size_t i) {  // counted from `pad` before the first knot
    return i < pad ? old[0] : old[i - pad < old.size() ? i - pad : old.size() - 1];
  };
  fill_bspline_values(value, padded, low + pad, place);
  return static_cast<std::ptrdiff_t>(low + 1) - static_cast<std::ptrdiff_t>(knots.order());
}

// The mean of the control points from `first` on; shares of points that do not exist are left out.
template <class V, ControlPolygon R>
constexpr ring_point<R> blend_existing(const V& value, std::ptrdiff_t first, const R& points) noexcept {
  const auto count = static_cast<std::ptrdiff_t>(ring_size(points));
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::ptrdiff_t at = first + static_cast<std::ptrdiff_t>(i);
    if (at < 0 || at >= count) value[i] = 0;
  }
  const auto skipped = first < 0 ? static_cast<std::size_t>(-first) : 0;
  return blend_points(value.subspan(skipped), static_cast<std::size_t>(first < 0 ? 0 : first), points);
}

// Where the stretch behind that of knot `low` begins; knots.size() behind the last one.
template <Floating T, int Degree>
constexpr std::size_t next_stretch(const bspline_knots<T, Degree>& knots, std::size_t low) noexcept {
  std::size_t next = low + 1;
  while (next < knots.size() && !(knots[next] < knots[next + 1])) ++next;
  return next;
}

// The shares of control points in point i of the Bezier curve over the stretch of knot `low`: the index of the first.
// The last point is the next stretch's first one, unless the curve may be torn between.
template <class V, Floating T, int Degree>
constexpr std::size_t fill_piece_shares(V& value, const bspline_knots<T, Degree>& knots, std::size_t low,
                                        std::size_t i) noexcept {
  const std::size_t degree = knots.order() - 1, next = next_stretch(knots, low);
  const T from = knots[low], to = knots[low + 1];
  const bool joins = i == degree && next < knots.size() && next - low <= degree;
  const std::size_t at = joins ? next : low;
  fill_bspline_values(
      value, [&](std::size_t k) { return knots[k]; }, at, [&](std::size_t k) { return k + i <= degree ? from : to; });
  return at - degree;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The control points of the same curve over more knots.
/// needs   as many points as knots.size(); room for refined.size() ones; scratch for knots.order() numbers
/// gives   false, and nothing written, where `refined` is of another degree, lacks a knot or has one that is not in
///         [first(), last()]
/// exact   each new point is a mean of old ones, shares as bspline_basis; one that keeps its knots is kept bit for bit
/// cost    degree^2 / 2 steps for each new point
/// source  Boehm 1980; Cohen, Lyche and Riesenfeld 1980 (the Oslo algorithm)
template <Floating T, int Degree, int OtherDegree, ControlPolygon R>
constexpr bool bspline_refine(const bspline_knots<T, Degree>& knots, const R& points,
                              const bspline_knots<T, OtherDegree>& refined, std::span<ring_point<R>> result,
                              std::type_identity_t<std::span<T>> scratch) noexcept {
  IRG_EXPECTS(ring_size(points) == knots.size() && result.size() >= refined.size() && scratch.size() >= knots.order());
  if (!detail::is_refined(knots, refined)) return false;
  const auto value = scratch.first(knots.order());
  for (std::size_t j = 0; j < refined.size(); ++j) {
    const auto first = detail::fill_refined_shares(value, knots, [&](std::size_t k) { return refined[j + k]; });
    result[j] = detail::blend_existing(value, first, points);
  }
  return true;
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, int Degree, int OtherDegree, ControlPolygon R, WorkspaceFor<R> W = workspace_for<R>>
constexpr bool bspline_refine(const bspline_knots<T, Degree>& knots, const R& points,
                              const bspline_knots<T, OtherDegree>& refined, std::span<ring_point<R>> result,
                              W&& memory = W{}) {
  return bspline_refine(knots, points, refined, result, detail::room_for(memory.numbers, knots.order()));
}

/// Hands each polynomial piece of the curve to sink(from, to, control points): a Bezier curve over [from, to].
/// needs   as many points as knots.size(); scratch for knots.order() numbers, piece for as many points
/// exact   pieces begin and end at bspline_point's points bit for bit, and so join, but at knots of full multiplicity,
///         where the curve may be torn; other control points are means of those that count, shares as bspline_basis
/// cost    degree^3 / 2 steps for each piece
/// source  Piegl and Tiller 1997, 5.3; Ramshaw 1987 (blossoms)
template <Floating T, int Degree, ControlPolygon R, class Sink>
constexpr void bspline_bezier_pieces(const bspline_knots<T, Degree>& knots, const R& points,
                                     std::type_identity_t<std::span<T>> scratch, std::span<ring_point<R>> piece,
                                     Sink&& sink) {
  const std::size_t order = knots.order(), degree = order - 1;
  IRG_EXPECTS(ring_size(points) == knots.size() && scratch.size() >= order && piece.size() >= order);
  const auto value = scratch.first(order);
  const auto controls = piece.first(order);
  for (std::size_t low = detail::bspline_stretch(knots, knots.first()); low < knots.size();
       low = detail::next_stretch(knots, low)) {
    for (std::size_t i = 0; i <= degree; ++i) {
      const std::size_t first = detail::fill_piece_shares(value, knots, low, i);
      controls[i] = detail::blend_points(value, first, points);
    }
    sink(knots[low], knots[low + 1], std::span<const ring_point<R>>(controls));
  }
}

/// The same, computed in a workspace, where the control points stand; allocates where that has too little memory.
template <Floating T, int Degree, ControlPolygon R, class Sink, WorkspaceFor<R> W = workspace_for<R>>
constexpr void bspline_bezier_pieces(const bspline_knots<T, Degree>& knots, const R& points, Sink&& sink,
                                     W&& memory = W{}) {
  bspline_bezier_pieces(knots, points, detail::room_for(memory.numbers, knots.order()),
                        detail::room_for(memory.points, knots.order()), sink);
}

/// Writes the knots of the same curve with one degree more: each knot in [first(), last()] once more, the ends as often
/// as a curve needs that begins and ends in its control points. The result says how many there are.
/// needs   elevated twice as long as the knots, and 2 more
/// exact   knots are copied
template <Floating T, int Degree>
constexpr std::size_t elevated_knots(const bspline_knots<T, Degree>& knots,
                                     std::type_identity_t<std::span<T>> elevated) noexcept {
  IRG_EXPECTS(elevated.size() >= 2 * knots.list().size() + 2);
  std::size_t count = 0;
  const auto add = [&](T u, std::size_t times) {
    for (; times > 0; --times) elevated[count++] = u;
  };
  add(knots.first(), knots.order() + 1);
  for (const T& u : knots.list())
    if (knots.first() < u && u < knots.last()) add(u, elevated[count - 1] == u ? 1 : 2);
  add(knots.last(), knots.order() + 1);
  return count;
}

/// The control points of the same curve with one degree more.
/// needs   as many points as knots.size(); knots that elevated_knots gave; room for elevated.size() points; scratch for
///         2 * knots.order() numbers
/// exact   each new point is the mean of degree + 1 points of refined curves; the curve's ends bit for bit
/// cost    degree^3 / 2 steps for each new point
/// source  Prautzsch 1984; Ramshaw 1987 (blossoms)
template <Floating T, int Degree, int OtherDegree, ControlPolygon R>
constexpr void bspline_elevate(const bspline_knots<T, Degree>& knots, const R& points,
                               const bspline_knots<T, OtherDegree>& elevated, std::span<ring_point<R>> result,
                               std::type_identity_t<std::span<T>> scratch) noexcept {
  const std::size_t order = knots.order();
  const std::size_t needed = detail::elevate_rows * order;
  IRG_EXPECTS(ring_size(points) == knots.size() && elevated.order() == order + 1 && scratch.size() >= needed);
  IRG_EXPECTS(elevated.first() == knots.first() && elevated.last() == knots.last() && result.size() >= elevated.size());
  const auto value = scratch.first(order), sum = scratch.subspan(order, order);
  for (std::size_t j = 0; j < elevated.size(); ++j) {
    for (T& s : sum) s = 0;
    std::ptrdiff_t first = 0;
    for (std::size_t left_out = 1; left_out <= order;) {  // of the knots between the first and the last of this point
      std::size_t alike = 1;
      while (left_out + alike <= order && elevated[j + left_out + alike] == elevated[j + left_out]) ++alike;
      first = detail::fill_refined_shares(value, knots,
                                          [&](std::size_t k) { return elevated[j + k + (k >= left_out ? 1 : 0)]; });
      const T part = static_cast<T>(static_cast<int>(alike)) / static_cast<T>(static_cast<int>(order));
      for (std::size_t i = 0; i < order; ++i) sum[i] = sum[i] + product(part, value[i]);
      left_out += alike;
    }
    if (elevated[j + 1] != elevated[j + order]) detail::make_sum_one(sum);  // at an end they are bspline_basis's own
    result[j] = detail::blend_existing(sum, first, points);
  }
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, int Degree, int OtherDegree, ControlPolygon R, WorkspaceFor<R> W = workspace_for<R>>
constexpr void bspline_elevate(const bspline_knots<T, Degree>& knots, const R& points,
                               const bspline_knots<T, OtherDegree>& elevated, std::span<ring_point<R>> result,
                               W&& memory = W{}) {
  const auto scratch = detail::room_for(memory.numbers, detail::elevate_rows * knots.order());
  bspline_elevate(knots, points, elevated, result, scratch);
}

}  // namespace IRG_ABI
}  // namespace irg
