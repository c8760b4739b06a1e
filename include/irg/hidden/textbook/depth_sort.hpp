// SPDX-License-Identifier: MIT
// Depth sort, the painter's algorithm of Newell, Newell and Sancha, as it is taught: a list of polygons, the
// farthest first, five tests by which the first of them, P, hides no other, Q, and what is done where all five fail:
// Q is drawn before P, or, if that was tried already, one of the two is split. The z axis points to the viewer, so
// the greater z is the nearer one, and polygons are projected by leaving z out. painter_newell
// (hidden/painter_newell.hpp) draws faces of a picture without making new points.
//
// The slides leave three things open that would end in a wrong picture or never. A polygon that was moved to the
// front leaves the list unsorted, so all others are asked, not only those up to the first whose depths are apart.
// The plane of P may leave Q whole: then P is split by that of Q, and where that does not cut, either, one of those
// that were moved by another's: of polygons that hide each other in turn some plane cuts another. And a part
// remembers on which side of the planes that cut it it lies, whatever its rounded points say.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/geometry/polygon_area.hpp>
#include <irg/hidden/textbook/newell_tests.hpp>

namespace irg {
namespace textbook {

/// A polygon, or a part of one, in the order of drawing.
template <Floating T>
struct depth_sorted_polygon {
  std::vector<point<T, 3>> corners{};
  std::uint32_t number = 0;  // of the polygon, counted from 0
};

}  // namespace textbook

namespace detail {

// A part of a polygon, and the planes that cut it before, by their polygons' numbers.
template <Floating T>
struct depth_sorted_part {
  struct known_side {
    std::uint32_t plane = 0;
    int side = 0;
  };
  textbook::depth_sorted_polygon<T> polygon{};
  std::vector<known_side> known{};
  T farthest{}, nearest{};
  std::uint32_t made = 0;  // as which of all polygons and parts
  std::vector<std::uint32_t> let_pass{};  // those of them that it does not hide but for roundings
  bool moved = false;
};

inline namespace IRG_ABI {

// What of a polygon lies on one side of a plane that cuts it; both sides get the same new points.
template <Floating T>
constexpr std::vector<point<T, 3>> ring_on_side(const std::vector<point<T, 3>>& ring, const visible_plane<T>& plane,
                                                int side) {
  std::vector<point<T, 3>> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const point<T, 3>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const int at_a = viewed_side(plane, a), at_b = viewed_side(plane, b);
    if (at_a == side || at_a == 0) kept.push_back(a);
    if (at_a * at_b < 0)
      kept.push_back(at_a < 0 ? intersect_plane_line(plane.p, plane.q, plane.r, a, b).at
                              : intersect_plane_line(plane.p, plane.q, plane.r, b, a).at);
  }
  return kept;
}

// The area that two convex polygons have in common on the screen: that of what of P is inside the prism over Q.
template <Floating T>
constexpr T area_in_common(std::vector<point<T, 3>> p, const std::vector<point<T, 3>>& q) {
  const int up = visible_plane_of(q).up;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const point<T, 3>&a = q[i], &b = q[i + 1 < q.size() ? i + 1 : 0];
    p = ring_on_side(p, {{a.x, a.y, 0}, {b.x, b.y, 0}, {a.x, a.y, 1}, 1}, -up);
  }
  const T area = polygon_area(without_depth(p));
  return area < 0 ? -area : area;
}

template <Floating T, class Observer>
class depth_sorter {
  using part = depth_sorted_part<T>;

public:
  constexpr explicit depth_sorter(Observer& observer) : observer_(observer) {}

  // Takes a polygon; its number is that of those taken before.
  template <SpaceRing R>
  constexpr void add(const R& ring) {
    const auto number = static_cast<std::uint32_t>(planes_.size());
    planes_.push_back({});
    if (ring_size(ring) == 0 || !is_finite(ring)) return;
    planes_.back() = visible_plane_of(ring);
    part p;
    p.polygon.number = number;
    for (std::size_t i = 0; i < ring_size(ring); ++i) p.polygon.corners.push_back(to_point(ring_vertex(ring, i)));
    measure(p);
    list_.push_back(std::move(p));
  }

  // The list ends with what is drawn first. Equally far ones are drawn in the order of their numbers.
  constexpr std::vector<textbook::depth_sorted_polygon<T>> sorted() {
    std::sort(list_.begin(), list_.end(), [](const part& a, const part& b) {
      return a.farthest != b.farthest ? a.farthest > b.farthest : a.polygon.number > b.polygon.number;
    });
    std::vector<textbook::depth_sorted_polygon<T>> order;
    while (!list_.empty()) {
      if (!may_be_drawn()) continue;
      observer_(newell_step::drawn, list_.back().polygon.number, list_.back().polygon.number);
      order.push_back(std::move(list_.back().polygon));
      list_.pop_back();
    }
    return order;
  }

private:
  constexpr void measure(part& p) {
    p.made = made_++;
    const auto all = bounding_box(p.polygon.corners);
    p.farthest = all.low.z;
    p.nearest = all.high.z;
  }
  constexpr void insert(part p) {
    measure(p);
    const auto place = std::lower_bound(list_.begin(), list_.end(), p.farthest,
                                        [](const part& other, const T& z) { return other.farthest > z; });
    list_.insert(place, std::move(p));
  }

  constexpr bool reaches(const part& p, std::uint32_t plane, int side) const {
    for (const auto& k : p.known)
      if (k.plane == plane) return k.side == side;
    return detail::has_corner_on(p.polygon.corners, planes_[plane], side);
  }
  constexpr bool does_not_hide_part(const part& p, const part& q) const {
    const auto &a = p.polygon, &b = q.polygon;
    const auto by = [&](newell_step which) { return textbook::does_not_hide_by(which, a.corners, b.corners); };
    return a.number == b.number || std::find(p.let_pass.begin(), p.let_pass.end(), q.made) != p.let_pass.end() ||
           by(newell_step::x_apart) || by(newell_step::y_apart) ||
           (planes_[b.number].up != 0 && !reaches(p, b.number, 1)) ||
           (planes_[a.number].up != 0 && !reaches(q, a.number, -1)) || by(newell_step::projections_apart);
  }

  // Whether the last of the list hides none of the others; if not, the list is changed.
  constexpr bool may_be_drawn() {
    const part& p = list_.back();
    for (std::size_t i = list_.size() - 1; i-- > 0;) {
      part& q = list_[i];
      if (p.nearest <= q.farthest || does_not_hide_part(p, q)) continue;
      if (q.moved) return break_cycle(i), false;
      observer_(newell_step::moved, p.polygon.number, q.polygon.number);
      q.moved = true;
      std::rotate(list_.begin() + static_cast<std::ptrdiff_t>(i), list_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                  list_.end());
      return false;
    }
    return true;
  }

  // The last of the list, P, may hide part i, Q, which was moved: Q is split by the plane of P, or P by that of Q,
  // or any of those that were moved by another's. Where no plane cuts, only rounded points say that one of them
  // hides the next: of what might, the least is let pass.
  constexpr void break_cycle(std::size_t i) {
    const std::size_t last = list_.size() - 1;
    if (split(i, last) || split(last, i)) return;
    const auto in_turn = [&](std::size_t k) { return k == last || list_[k].moved; };
    for (std::size_t cut = 0; cut <= last; ++cut)
      for (std::size_t by = 0; by <= last; ++by)
        if (in_turn(cut) && in_turn(by) && split(cut, by)) return;
    std::size_t least_p = last, least_q = i;
    T least = area_in_common(list_[last].polygon.corners, list_[i].polygon.corners);
    for (std::size_t k = 0; k <= last; ++k)
      for (std::size_t j = 0; j <= last; ++j) {
        const part &p = list_[k], &q = list_[j];
        if (!in_turn(k) || !in_turn(j) || p.nearest <= q.farthest || does_not_hide_part(p, q)) continue;
        if (const T area = area_in_common(p.polygon.corners, q.polygon.corners); area < least)
          least = area, least_p = k, least_q = j;
      }
    list_[least_p].let_pass.push_back(list_[least_q].made);
    for (part& p : list_) p.moved = false;
  }

  constexpr bool split(std::size_t cut, std::size_t by) {
    const part whole = list_[cut];
    const std::uint32_t number = list_[by].polygon.number;
    if (number == whole.polygon.number || !reaches(whole, number, 1) || !reaches(whole, number, -1)) return false;
    observer_(newell_step::split_by_plane, number, whole.polygon.number);
    list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(cut));
    for (part& p : list_) p.moved = false;
    for (const int side : {1, -1}) {
      part half{
          {ring_on_side(whole.polygon.corners, planes_[number], side), whole.polygon.number}, whole.known, {}, {}};
      half.known.push_back({number, side});
      insert(std::move(half));
    }
    return true;
  }

  Observer& observer_;
  std::vector<visible_plane<T>> planes_{};
  std::vector<part> list_{};
  std::uint32_t made_ = 0;
};

}  // namespace IRG_ABI
}  // namespace detail

namespace textbook::inline IRG_ABI {

/// Polygons, and parts of those that had to be split, in an order in which the painter may draw them: none hides one
/// that is drawn after it.
/// shape   a container of rings, z towards the viewer; observer(step, number of P, number of Q)
/// needs   convex flat polygons
/// gives   each polygon once, or its parts; those with a number that is not finite are left out
/// exact   as the tests are. A new point is within 0.501 ulp of where an edge crosses the plane, so of parts the last
///         test is as exact as their points; where polygons lie within roundings of each other the order may be wrong
///         there
/// cost    n^2 tests where all overlap in depth, a sort where none do; polygons that hide each other in turn make
///         parts. Allocates
/// source  Hidden-surface slides, after Newell, Newell and Sancha 1972
template <RingSequence R, class Observer = no_newell_observer>
  requires(SpaceRing<ring_in<R>> && Floating<ring_scalar<ring_in<R>>>)
[[nodiscard]] constexpr std::vector<depth_sorted_polygon<ring_scalar<ring_in<R>>>> depth_sort(
    const R& polygons, Observer&& observer = {}) {
  detail::depth_sorter<ring_scalar<ring_in<R>>, std::remove_reference_t<Observer>> sorter(observer);
  for (std::size_t i = 0; i < std::size(polygons); ++i) sorter.add(polygons[i]);
  return sorter.sorted();
}

}  // namespace textbook::inline IRG_ABI
}  // namespace irg
