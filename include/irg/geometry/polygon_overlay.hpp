// SPDX-License-Identifier: MIT
// Intersection, union and differences of arbitrary polygons: concave, with holes, of several parts, touching and
// overlapping each other, or crossing themselves. Boundaries are cut where they meet; each piece is kept when the
// result lies on one side of it alone; pieces are joined to rings. Weiler and Atherton's own walk along entering and
// leaving points stands in textbook/clip_weiler_atherton.hpp.
//
// Crossings are rounded to the numbers' grid, and pieces that cross after that are cut again, until none do. From then
// on every decision is exact, whatever coincides.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/core/coordinates.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/geometry/vocabulary.hpp>
#if IRG_BODIES
#include <algorithm>
#include <limits>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/math/exact_sum.hpp>
#endif

namespace irg {

/// How polygon_boolean ended: `not_finite` when a coordinate is NaN or infinite, `unresolved` when rounding has
/// made new crossings again and again (never seen).
enum class [[nodiscard]] polygon_clip_status {
  ok,
  not_finite,
  unresolved,
  done [[deprecated("irg: done is now ok")]] = ok
};

/// What polygon_boolean did: of `pairs`, those beyond `compared` were skipped.
/// shape   pieces are the edges at first, then what they are cut into; edges that run along each other from end to end
///         are one piece, or none where one takes the other back
struct polygon_overlay_counts {
  std::uint64_t rounds = 0;  // of cuts, the last of which finds none to make
  std::uint64_t pairs = 0;  // of pieces, summed over the rounds
  std::uint64_t compared = 0;  // of these, pairs whose boxes have a point in common
  std::uint64_t crossings = 0;  // of these, pairs that cross between their ends
  bool operator==(const polygon_overlay_counts&) const = default;
};

/// The rings of a polygon: outer ones counter-clockwise, holes clockwise (y up).
template <Floating T>
struct clipped_rings {
  polygon_clip_status status = polygon_clip_status::ok;
  std::vector<std::vector<point<T, 2>>> rings{};
  polygon_overlay_counts counts{};

  /// Whether the rings are what was asked for.
  IRG_INLINE constexpr explicit operator bool() const noexcept { return status == polygon_clip_status::ok; }
  bool operator==(const clipped_rings&) const = default;
};

namespace detail {

// A piece of boundary from p to q, p before q: how often each polygon's rings run along it, less those that run back.
template <class T>
struct boundary_piece {
  point<T, 2> p, q;
  int times[2];
};

inline namespace IRG_ABI {

template <class T>
constexpr void add_piece(std::vector<boundary_piece<T>>& pieces, const point<T, 2>& p, const point<T, 2>& q,
                         const int (&times)[2]) {
  if (same_place(p, q)) return;
  if (comes_before(p, q))
    pieces.push_back({p, q, {times[0], times[1]}});
  else
    pieces.push_back({q, p, {-times[0], -times[1]}});
}

template <class T, PlaneRing R>
constexpr bool add_ring(std::vector<boundary_piece<T>>& pieces, const R& ring, int polygon) {
  const int times[2] = {polygon == 0 ? 1 : 0, polygon == 1 ? 1 : 0};
  const auto at = [&](std::size_t i) {
    const auto v = ring_vertex(ring, i);
    return point<T, 2>{static_cast<T>(coordinate(v, 0)), static_cast<T>(coordinate(v, 1))};
  };
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    if (!is_finite(at(i))) return false;
    if (is_finite(at(i + 1))) add_piece(pieces, at(i), at(i + 1), times);
  }
  return true;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

// What the pieces of two polygons' boundaries, which it uses up, come to.
template <Floating T>
IRG_API clipped_rings<T> combine_pieces(std::vector<boundary_piece<T>>& pieces, boolean_operation operation,
                                        fill_rule rule);

}  // namespace IRG_COMPILED_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The polygon that belongs to both a and b (intersection), to either (union), to a but not b (difference), or to one
/// of them alone (symmetric_difference). A polygon is a ring or a list of rings, of any direction and in any order;
/// vertices may repeat, rings may touch, overlap and cross themselves and each other: `rule` says what is inside.
/// shape   floats, doubles, or integers of up to 32 bits, whose crossings are doubles
/// gives   rings that do not cross, outer ones counter-clockwise, holes clockwise; pieces that touch in a point are
///         rings of their own. Vertices on straight edges are left out; no ring is without area. No rings when nothing
///         is left; status not_finite when a coordinate is NaN or infinite. What was done and skipped is counted
/// exact   crossings are rounded to within 0.501 ulp, edges bend by as much; for the polygons so bent every decision is
///         exact. So areas add up, a + b = union + intersection, to within an ulp of the coordinates times the length
///         of the boundaries; where no crossing has to be rounded nothing is lost at all
/// cost    n pieces of boundary: n log n, n for each that overlaps in x; some 0.2 us a crossing
/// source  Weiler and Atherton 1977; Weiler 1980; Hobby 1999
template <PlanePolygon A, PlanePolygon B>
  requires OverlayScalar<scalar_of<polygon_point<A>>> &&
           std::same_as<scalar_of<polygon_point<A>>, scalar_of<polygon_point<B>>>
[[nodiscard]] constexpr auto polygon_boolean(const A& a, const B& b,
                                             boolean_operation operation = boolean_operation::intersection,
                                             fill_rule rule = fill_rule::even_odd) {
  using S = scalar_of<polygon_point<A>>;
  using T = std::conditional_t<Floating<S>, S, double>;
  std::vector<detail::boundary_piece<T>> pieces;
  bool finite = true;
  const auto add = [&](const auto& polygon, int number) {
    for (std::size_t i = 0; i < detail::ring_count(polygon); ++i)
      finite = finite && detail::add_ring(pieces, detail::ring_of(polygon, i), number);
  };
  add(a, 0), add(b, 1);
  if (!finite) return clipped_rings<T>{polygon_clip_status::not_finite, {}, {}};
  return detail::combine_pieces(pieces, operation, rule);
}

IRG_RENAMED(polygon_overlay, polygon_boolean)

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Pieces from the same place to the same place become one; those that are walked as often back as forth go.
template <class T>
constexpr void merge_pieces(std::vector<boundary_piece<T>>& pieces) {
  std::sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
    return same_place(a.p, b.p) ? comes_before(a.q, b.q) : comes_before(a.p, b.p);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pieces.size();) {
    boundary_piece<T> sum = pieces[i];
    for (++i; i < pieces.size() && same_place(pieces[i].p, sum.p) && same_place(pieces[i].q, sum.q); ++i)
      for (int k = 0; k < 2; ++k) sum.times[k] += pieces[i].times[k];
    if (sum.times[0] != 0 || sum.times[1] != 0) pieces[kept++] = sum;
  }
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(kept), pieces.end());
}

// Whether v lies on the piece, but not at its ends.
template <class T>
constexpr bool is_inside_piece(const boundary_piece<T>& s, const point<T, 2>& v, int turn) noexcept {
  return turn == 0 && comes_before(s.p, v) && comes_before(v, s.q);
}

// Whether v is beside the piece and no further from its line than the tolerance, nearly.
template <class T>
constexpr bool is_next_to_piece(const boundary_piece<T>& s, const point<T, 2>& v, T tolerance) noexcept {
  const T dx = s.q.x - s.p.x, dy = s.q.y - s.p.y, width = dx, height = dy < 0 ? -dy : dy;
  const int axis = width < height ? 1 : 0;  // the longer one
  const T along = v[axis] - s.p[axis], length = axis == 0 ? dx : dy;
  if (!(length < 0 ? along < 0 && length < along : 0 < along && along < length)) return false;
  const T off = v[1 - axis] - (s.p[1 - axis] + product(along / length, axis == 0 ? dy : dx));
  return -tolerance <= off && off <= tolerance;
}

// Where the pieces a and b cross, rounded and kept within both.
template <class T>
constexpr point<T, 2> rounded_crossing(const boundary_piece<T>& a, const boundary_piece<T>& b) noexcept {
  point<T, 2> at = intersect_lines(a.p, a.q, b.p, b.q).at;
  for (int i = 0; i < 2; ++i)
    for (const auto* s : {&a, &b}) at[i] = clamped(at[i], minimum(s->p[i], s->q[i]), maximum(s->p[i], s->q[i]));
  return at;
}

// Notes where a and b have to be cut, so that they have no more than ends in common. With a tolerance, they bend to
// ends that they pass that near by. Gives whether they cross between their ends.
template <class T>
constexpr bool cut_pair(const boundary_piece<T>& a, const boundary_piece<T>& b, T tolerance,
                        std::vector<point<T, 2>>& on_a, std::vector<point<T, 2>>& on_b) {
  if (tolerance > 0) {
    const std::size_t before = on_a.size() + on_b.size();
    for (const auto* v : {&b.p, &b.q})
      if (is_next_to_piece(a, *v, tolerance)) on_a.push_back(*v);
    for (const auto* v : {&a.p, &a.q})
      if (is_next_to_piece(b, *v, tolerance)) on_b.push_back(*v);
    if (on_a.size() + on_b.size() > before) return false;
  }
  const int bp = orient2d(a.p, a.q, b.p), bq = orient2d(a.p, a.q, b.q);
  if (bp * bq > 0) return false;
  const int ap = orient2d(b.p, b.q, a.p), aq = orient2d(b.p, b.q, a.q);
  if (ap * aq > 0) return false;
  if (bp * bq < 0 && ap * aq < 0) {
    const point<T, 2> at = rounded_crossing(a, b);
    if (!same_place(at, a.p) && !same_place(at, a.q)) on_a.push_back(at);
    if (!same_place(at, b.p) && !same_place(at, b.q)) on_b.push_back(at);
    return true;
  }
  if (is_inside_piece(a, b.p, bp)) on_a.push_back(b.p);
  if (is_inside_piece(a, b.q, bq)) on_a.push_back(b.q);
  if (is_inside_piece(b, a.p, ap)) on_b.push_back(a.p);
  if (is_inside_piece(b, a.q, aq)) on_b.push_back(a.q);
  return false;
}

// One round of cuts among pieces sorted by p; false when none was needed.
template <class T>
constexpr bool cut_pieces(std::vector<boundary_piece<T>>& pieces, T tolerance, polygon_overlay_counts& counts) {
  std::vector<std::vector<point<T, 2>>> cuts(pieces.size(), std::vector<point<T, 2>>{});
  bool any = false;
  std::uint64_t compared = 0, crossings = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = i + 1; k < pieces.size() && !(pieces[i].q.x < pieces[k].p.x); ++k) {
      const auto &a = pieces[i], &b = pieces[k];
      if (minimum(a.p.y, a.q.y) > maximum(b.p.y, b.q.y) || minimum(b.p.y, b.q.y) > maximum(a.p.y, a.q.y)) continue;
      ++compared;
      crossings += cut_pair(a, b, tolerance, cuts[i], cuts[k]) ? 1u : 0u;
    }
  ++counts.rounds;
  if (!pieces.empty()) counts.pairs += std::uint64_t{pieces.size()} * (pieces.size() - 1) / 2;
  counts.compared += compared;
  counts.crossings += crossings;
  std::vector<boundary_piece<T>> result;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const boundary_piece<T>& s = pieces[i];
    if (cuts[i].empty()) {
      result.push_back(s);
      continue;
    }
    any = true;
    std::sort(cuts[i].begin(), cuts[i].end(), [](const auto& a, const auto& b) { return comes_before(a, b); });
    // Along a piece that is nearly vertical, rounded cuts need not be in the order of x: then that of y counts.
    if (s.q.x - s.p.x < (s.q.y < s.p.y ? s.p.y - s.q.y : s.q.y - s.p.y))
      std::sort(cuts[i].begin(), cuts[i].end(), [&](const auto& a, const auto& b) {
        return a.y == b.y ? comes_before(a, b) : (a.y < b.y) == (s.p.y < s.q.y);
      });
    point<T, 2> from = s.p;
    for (const auto& at : cuts[i]) {
      add_piece(result, from, at, s.times);
      from = at;
    }
    add_piece(result, from, s.q, s.times);
  }
  pieces.swap(result);
  merge_pieces(pieces);
  return any;
}

// How often the polygons go round the place just to the left of piece k, by the pieces above its middle: those that are
// `open`, of the ones before it, and those behind it that begin before it ends.
template <class T>
constexpr void winding_beside(const std::vector<boundary_piece<T>>& pieces, std::size_t k,
                              const std::vector<boundary_piece<T>>& open, int (&winding)[2]) noexcept {
  const boundary_piece<T>& s = pieces[k];
  const auto wide = [](T v) { return widened(v); };
  // Whether x, twice the middle's, is beyond: exact.
  const auto is_left_of_middle = [&](T x) {
    exact_accumulator<1> sum;
    sum.add(wide(s.p.x)), sum.add(wide(s.q.x)), sum.subtract(wide(x)), sum.subtract(wide(x));
    return sum.sign() > 0;
  };
  winding[0] = winding[1] = 0;
  const auto count = [&](const boundary_piece<T>& f) {
    if (!is_left_of_middle(f.p.x) || is_left_of_middle(f.q.x)) return;
    // f goes from the left of the middle to its right; is the middle below?
    const int at_p = orient2d(f.p, f.q, s.p), at_q = orient2d(f.p, f.q, s.q);
    int side = at_p + at_q;
    if (at_p * at_q < 0) {  // s ends on either side of f's line: the middle decides
      exact_accumulator<2> sum;
      for (const auto* v : {&s.p, &s.q}) {
        sum.add(wide(f.p.x), wide(f.q.y)), sum.subtract(wide(f.p.y), wide(f.q.x));
        sum.add(wide(f.q.x), wide(v->y)), sum.subtract(wide(f.q.y), wide(v->x));
        sum.add(wide(v->x), wide(f.p.y)), sum.subtract(wide(v->y), wide(f.p.x));
      }
      side = sum.sign();
    }
    if (side < 0)
      for (int polygon = 0; polygon < 2; ++polygon) winding[polygon] -= f.times[polygon];
  };
  for (const boundary_piece<T>& f : open) count(f);
  for (std::size_t i = k + 1; i < pieces.size() && !(s.q.x < pieces[i].p.x); ++i) count(pieces[i]);
}

constexpr bool is_within_result(const int (&winding)[2], boolean_operation operation, fill_rule rule) noexcept {
  const auto inside = [&](int w) { return rule == fill_rule::even_odd ? w % 2 != 0 : w != 0; };
  const bool a = inside(winding[0]), b = inside(winding[1]);
  switch (operation) {
    case boolean_operation::intersection: return a && b;
    case boolean_operation::union_: return a || b;
    case boolean_operation::difference: return a && !b;
    default: return a != b;
  }
}

// Whether the direction from v to x comes before that to y, going clockwise from that to `back`.
template <class T>
constexpr bool turns_first(const point<T, 2>& v, const point<T, 2>& back, const point<T, 2>& x,
                           const point<T, 2>& y) noexcept {
  const auto sector =
      [&](const point<T, 2>& to) {  // 0: on the right of the way to `back`, 1: straight on, 2: on its left
        const int turn = orient2d(v, back, to);
        return turn < 0 ? 0 : turn == 0 ? 1 : 2;
      };
  const int sx = sector(x), sy = sector(y);
  return sx != sy ? sx < sy : orient2d(v, x, y) < 0;
}

// The directed pieces, joined to rings with the inside on their left.
template <class T>
constexpr std::vector<std::vector<point<T, 2>>> rings_of(std::vector<std::pair<point<T, 2>, point<T, 2>>>& ways) {
  std::sort(ways.begin(), ways.end(), [](const auto& a, const auto& b) { return comes_before(a.first, b.first); });
  std::vector<std::uint8_t> used(ways.size(), std::uint8_t{0});
  std::vector<std::vector<point<T, 2>>> rings;
  const auto next_of = [&](std::size_t i) {
    const point<T, 2>&from = ways[i].first, &at = ways[i].second;
    std::size_t best = ways.size();
    const auto first = std::lower_bound(ways.begin(), ways.end(), at,
                                        [](const auto& way, const auto& v) { return comes_before(way.first, v); });
    for (auto k = static_cast<std::size_t>(first - ways.begin()); k < ways.size() && same_place(ways[k].first, at); ++k)
      if (used[k] == 0 && (best == ways.size() || turns_first(at, from, ways[k].second, ways[best].second))) best = k;
    return best;
  };
  for (std::size_t start = 0; start < ways.size(); ++start) {
    if (used[start] != 0) continue;
    std::vector<point<T, 2>> ring;
    for (std::size_t i = start; i != ways.size() && used[i] == 0; i = next_of(i)) {
      used[i] = 1;
      // What goes straight on needs no vertex.
      const auto straight = [&](const auto& a, const auto& b, const auto& c) { return orient2d(a, b, c) == 0; };
      while (ring.size() >= 2 && straight(ring[ring.size() - 2], ring.back(), ways[i].first)) ring.pop_back();
      ring.push_back(ways[i].first);
    }
    while (ring.size() >= 3 && orient2d(ring[ring.size() - 2], ring.back(), ring[0]) == 0) ring.pop_back();
    while (ring.size() >= 3 && orient2d(ring.back(), ring[0], ring[1]) == 0) ring.erase(ring.begin());
    if (ring.size() >= 3) rings.push_back(ring);
  }
  return rings;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API clipped_rings<T> combine_pieces(std::vector<boundary_piece<T>>& pieces, boolean_operation operation,
                                        fill_rule rule) {
  merge_pieces(pieces);
  // As a rule one round of cuts and one that finds none. Where edges lie within an ulp of each other over a long way,
  // bent edges cross anew; from the fourth round on they bend to what is an ulp of the largest coordinate away.
  T largest(0);
  for (const auto& s : pieces)
    for (int i = 0; i < 2; ++i) largest = maximum(largest, maximum(magnitude(s.p[i]), magnitude(s.q[i])));
  const T ulp = product(largest, std::numeric_limits<T>::epsilon());
  const bool may_bend = largest < (std::numeric_limits<T>::max)() / 4;
  const std::size_t most = 1000 + pieces.size() * pieces.size();
  polygon_overlay_counts counts;
  const auto tolerance = [&](int round) {
    return round < 3 || !may_bend ? T(0) : product(ulp, static_cast<T>(round / 3));
  };
  for (int round = 0; cut_pieces(pieces, tolerance(round), counts); ++round)
    if (round == 60 || pieces.size() > most) return {polygon_clip_status::unresolved, {}, counts};
  std::vector<std::pair<point<T, 2>, point<T, 2>>> ways;
  std::vector<boundary_piece<T>> open;  // of the pieces so far, those that reach to where the next one begins
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    int left[2]{};
    std::size_t kept = 0;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (!(open[i].q.x < pieces[k].p.x)) open[kept++] = open[i];
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(kept), open.end());
    winding_beside(pieces, k, open, left);
    open.push_back(pieces[k]);
    const int right[2] = {left[0] - pieces[k].times[0], left[1] - pieces[k].times[1]};
    const bool on_left = is_within_result(left, operation, rule), on_right = is_within_result(right, operation, rule);
    if (on_left && !on_right) ways.push_back({pieces[k].p, pieces[k].q});
    if (on_right && !on_left) ways.push_back({pieces[k].q, pieces[k].p});
  }
  return {polygon_clip_status::ok, rings_of(ways), counts};
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
