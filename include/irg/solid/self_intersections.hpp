// SPDX-License-Identifier: MIT
// Which faces of a surface pass through each other, exactly: what list_faults does not look at.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <irg/core/scalar.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <irg/math/sqrt.hpp>
#include <irg/math/vec.hpp>
#include <irg/mesh/to_mesh.hpp>
#include <irg/solid/detail/body_triangles.hpp>
#include <irg/solid/detail/box_pairs.hpp>
#include <irg/solid/detail/triangle_contacts.hpp>
#endif

namespace irg {

/// Two faces that meet where they should not.
struct face_pair {
  std::uint32_t first = 0, second = 0;
  constexpr auto operator<=>(const face_pair&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// All pairs of faces that have a point in common which is not a corner of both: faces that cross, touch each other's
/// inside or sides, lie on each other.
/// shape   first < second, in order, each pair once; equal positions are one corner
/// needs   a mesh in which validate() finds no defect, with finite positions
/// gives   nothing for faces without area, whose sides are their neighbours'; pieces of one face are not compared
/// exact   always, for the triangles that triangulated() makes of the faces
/// cost    O(n log n) and the pairs of triangles that are close to each other, some dozen for each triangle; no more
///         for fans, cones, bipyramids and poles, where thousands meet round one corner or side, as measured to 10^5;
///         bundles that no plane tells apart cost the pairs of triangles whose boxes meet
template <Floating T>
[[nodiscard]] IRG_API std::vector<face_pair> self_intersections(const mesh<T>& m);

}  // namespace IRG_COMPILED_ABI

#if IRG_BODIES
namespace detail {

// A triangle in one of the spaces that pairs are searched in: each of its points lies within `margin` along each axis
// of a point of the triangle p.
struct IRG_APART searched_triangle {
  point<double, 3> p[3];
  double margin;
  std::uint32_t number;
};

inline namespace IRG_ABI {

// Whether two triangles with area have more in common than corners and whole sides that both have.
constexpr bool pass_through(const seen_triangle& a, const seen_triangle& b) noexcept {
  const contact_finder found(a, b);
  for (int i = 0; i < found.count; ++i)
    if (found.contacts[i].at[0] > 2 || found.contacts[i].at[1] > 2) return true;
  return found.count == 3;  // the same triangle
}

// False only where a plane tells the triangle from the region: its own plane, or one along an axis and a side of it.
// With u = 2^-53 and all coordinates from the region's centre at most `size`: sides are known within 2u size, so their
// products' differences with the corners within 32u size^2, the triangle's distance from the centre times its area
// within 400u size^3; what is asked for is 128u and 2048u.
constexpr bool reaches(const searched_triangle& s, const space_box& region) noexcept {
  double half[3]{}, from[3][3]{}, side[3][3]{}, size = 0;
  for (int i = 0; i < 3; ++i) {
    const double centre = region.low[i] * 0.5 + region.high[i] * 0.5;
    half[i] = maximum(region.high[i] - centre, centre - region.low[i]) + s.margin;
    size = maximum(size, half[i]);
    for (int k = 0; k < 3; ++k) {
      from[k][i] = s.p[k][i] - centre;
      side[k][i] = s.p[(k + 1) % 3][i] - s.p[k][i];
      size = maximum(size, magnitude(from[k][i]));
    }
  }
  if (!(size > 0x1p-300 && size < 0x1p300)) return true;  // so that nothing overflows, and no product is lost
  double distance = 0, reach = 0x1p-42 * size * size * size;
  for (int i = 0, j = 1, k = 2; i < 3; j = k, k = i++) {
    const double normal = side[0][j] * side[1][k] - side[0][k] * side[1][j];
    distance += normal * from[0][i];
    reach += magnitude(normal) * half[i];
  }
  if (magnitude(distance) > reach) return false;
  const double error = 0x1p-46 * size * size;
  for (int i = 1, j = 2, along = 0; along < 3; i = j, j = along++)
    for (int k = 0; k < 3; ++k) {
      const double *a = from[k], *c = from[(k + 2) % 3], *e = side[k];
      const double at = e[j] * a[i] - e[i] * a[j], third = e[i] * (c[j] - a[j]) - e[j] * (c[i] - a[i]);
      const double width = magnitude(e[i]) * half[j] + magnitude(e[j]) * half[i] + error;
      if (at - width > maximum(third, 0.0) || at + width < minimum(third, 0.0)) return false;
    }
  return true;
}

// Calls use(p) for the corners of what a region leaves of a triangle, but for roundings: each point of the triangle in
// the region is within 2^-46 of the coordinates' largest of a point between the corners. For a side is cut within 4u of
// the cutting plane and of itself, six times, and the planes stand 512u outside the region.
template <class Use>
constexpr void each_corner_within(const searched_triangle& s, const space_box& region, const Use& use) {
  double size = 0;
  for (int i = 0; i < 3; ++i) {
    for (const point<double, 3>& p : s.p) size = maximum(size, magnitude(p[i]));
    size = maximum(size, maximum(magnitude(region.low[i]), magnitude(region.high[i])));
  }
  const double wider = s.margin + 0x1p-44 * size;
  point<double, 3> corners[2][32] = {{s.p[0], s.p[1], s.p[2]}, {}};
  int count = 3, now = 0;
  for (int plane = 0; plane < 6; ++plane, now = 1 - now) {
    const int axis = plane / 2;
    const auto outside = [&](const point<double, 3>& p) {
      return plane % 2 == 0 ? (region.low[axis] - wider) - p[axis] : p[axis] - (region.high[axis] + wider);
    };
    int kept = 0;
    for (int k = 0; k < count; ++k) {
      const point<double, 3>&p = corners[now][k], &q = corners[now][k + 1 == count ? 0 : k + 1];
      const double a = outside(p), b = outside(q);
      if (a <= 0) corners[1 - now][kept++] = p;
      if (a < 0 ? b > 0 : a > 0 && b < 0) corners[1 - now][kept++] = p + (q - p) * (a / (a - b));
    }
    count = kept;
  }
  for (int k = 0; k < count; ++k) use(corners[now][k]);
}

// Calls use(s, t) for the pairs of triangles that may have a point in common that is no corner of both; for some more
// than once, and for pairs of one face or not, as it happens. Three searches in one another: of all triangles by their
// boxes in space; of those round one corner by the arcs that they take of the sphere of directions there; of those
// along one side by their directions from it. Triangles of which all pairs have a corner in common are left to the
// next of these searches: two arcs apart are two triangles with nothing but the corner in common.
template <class Use>
class triangle_pair_search {
public:
  using lot = box_lot;
  std::size_t looks = 0;  // triangles that were asked where they are, and pairs that were asked whether they meet

  /// needs   scale: a power of two that brings all positions to 1 at most
  constexpr triangle_pair_search(const body_triangles& b, double scale, const Use& use)
      : b_(b), scale_(scale), use_(use) {}

  constexpr void search(const lot& triangles) {
    constexpr space_box everywhere{{-most, -most, -most}, {most, most, most}};
    lot all;
    for (const std::uint32_t t : triangles) {
      all.push_back(static_cast<std::uint32_t>(items_.size()));
      see(t);
    }
    halve(all, everywhere, 0);
    cuts_ = must_cut_;
    if (cuts_) halve(all, everywhere, 0);
    search_round_corners();
  }

private:
  static constexpr std::size_t few = 20;  // triangles whose pairs are looked at one by one
  static constexpr int deepest = 100;
  static constexpr double most = (std::numeric_limits<double>::max)();

  constexpr triangle_pair_search(const triangle_pair_search& outer, std::uint32_t corner)
      : b_(outer.b_), scale_(outer.scale_), use_(outer.use_), count_(outer.count_ + 1) {
    around_[0] = outer.count_ == 0 ? corner : outer.around_[0];
    around_[1] = corner;
  }

  constexpr void search_round_corners() {
    struct incidence {
      std::uint32_t corner, triangle;
      constexpr auto operator<=>(const incidence&) const = default;
    };
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    if (corners_.empty()) return;
    std::vector<incidence> incident;
    for (const searched_triangle& s : items_)
      for (const std::uint32_t v : b_.triangles[s.number].v)
        if (std::binary_search(corners_.begin(), corners_.end(), v)) incident.push_back({v, s.number});
    items_ = {};
    boxes_ = {};
    std::sort(incident.begin(), incident.end());
    for (std::size_t i = 0; i < incident.size();) {
      triangle_pair_search inner(*this, incident[i].corner);
      lot triangles;
      for (; i < incident.size() && incident[i].corner == inner.around_[count_]; ++i)
        triangles.push_back(incident[i].triangle);
      inner.search(triangles);
      looks += inner.looks;
    }
  }

  // The triangle in the space of this search.
  constexpr void see(std::uint32_t t) {
    const std::uint32_t(&v)[3] = b_.triangles[t].v;
    searched_triangle s{{}, 0, t};
    if (count_ == 0)
      for (int k = 0; k < 3; ++k) s.p[k] = at(v[k]);
    else if (!(count_ == 1 ? see_arc(s) : see_direction(s)))
      s.margin = 4;  // anywhere
    space_box box = no_box();
    for (const point<double, 3>& p : s.p) box.add(p);
    for (int i = 0; i < 3; ++i) {
      box.low[i] -= s.margin;
      box.high[i] += s.margin;
    }
    items_.push_back(s);
    boxes_.push_back(box);
  }

  // An arc lies in the triangle of its ends a, b and (a + b) / (1 + dot(a, b)), where the tangents in these meet. The
  // ends are known within 8u, and the sum below within 32u; so that is 2048u and less where it is not small.
  constexpr bool see_arc(searched_triangle& s) const noexcept {
    vec<double, 3> end[3]{};
    int n = 0;
    for (const std::uint32_t v : b_.triangles[s.number].v)
      if (v != around_[0] && !direction_to(v, end[n++])) return false;
    const double sum = 1 + dot(end[0], end[1]);
    if (!(sum > 0.125)) return false;
    end[2] = (end[0] + end[1]) / sum;
    for (int k = 0; k < 3; ++k) s.p[k] = point<double, 3>{} + end[k];
    s.margin = 0x1p-41;
    return true;
  }

  // The direction from the side at right angles to it, known within 64u by its length.
  constexpr bool see_direction(searched_triangle& s) const noexcept {
    vec<double, 3> along{}, off{};
    for (const std::uint32_t v : b_.triangles[s.number].v)
      if (v != around_[0] && !direction_to(v, v == around_[1] ? along : off)) return false;
    off = off - along * dot(along, off);
    const double l = sqrt(dot(off, off));
    if (!(l > 0x1p-40)) return false;
    for (point<double, 3>& p : s.p) p = point<double, 3>{} + off / l;
    s.margin = 0x1p-46 / l;
    return true;
  }

  constexpr bool direction_to(std::uint32_t v, vec<double, 3>& to) const noexcept {
    to = at(v) - at(around_[0]);
    const double largest = maximum(maximum(magnitude(to.x), magnitude(to.y)), magnitude(to.z));
    if (!(largest > 0x1p-960)) return false;  // what the scale took away may count
    to = to / largest;
    to = to / sqrt(dot(to, to));
    return true;
  }

  constexpr point<double, 3> at(std::uint32_t v) const noexcept {
    const point<double, 3>& p = b_.positions[v];
    return {p.x * scale_, p.y * scale_, p.z * scale_};
  }

  constexpr lot within(const lot& l, const space_box& region) {
    return those_of(l, looks, [&](std::uint32_t i) { return boxes_[i].meets(region); });
  }
  constexpr lot reaching(const lot& l, const space_box& region) {
    return those_of(l, looks, [&](std::uint32_t i) { return boxes_[i].meets(region) && reaches(items_[i], region); });
  }

  // Whether all are of one face, or have a corner in common beside those that this search is round.
  constexpr bool is_done(const lot& l) {
    const std::uint32_t first = items_[l[0]].number;
    std::uint32_t shared[3]{};
    int n = 0;
    bool are_one_face = true;
    if (count_ < 2)
      for (const std::uint32_t v : b_.triangles[first].v)
        if (count_ == 0 || v != around_[0]) shared[n++] = v;
    for (const std::uint32_t i : l) {
      const std::uint32_t t = items_[i].number;
      ++looks;
      are_one_face = are_one_face && b_.face[t] == b_.face[first];
      const std::uint32_t(&v)[3] = b_.triangles[t].v;
      int left = 0;
      for (int k = 0; k < n; ++k)
        if (const std::uint32_t w = shared[k]; w == v[0] || w == v[1] || w == v[2]) shared[left++] = w;
      n = left;
      if (n == 0 && !are_one_face) return false;
    }
    if (!are_one_face) corners_.push_back(shared[0]);
    return true;
  }

  constexpr void use_pair(std::uint32_t i, std::uint32_t k, const space_box& cell) const {
    if (boxes_[i].meets(boxes_[k]) && (cuts_ || begins_in(boxes_[i], boxes_[k], cell)))
      use_(items_[i].number, items_[k].number);
  }
  constexpr void use_pairs(const lot& l, const space_box& cell) {
    looks += l.size() * l.size() / 2;
    for (std::size_t i = 1; i < l.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) use_pair(l[i], l[k], cell);
  }

  // Halves by boxes, for as long as these tell triangles apart.
  constexpr void halve(const lot& l, const space_box& cell, int depth) {  // cell: where a pair's common box begins
    space_box region = cell;
    if (must_cut_ != cuts_ || !narrow_region(region, boxes_, l)) return;
    const lot kept = within(l, region);
    if (kept.size() <= few) {
      return use_pairs(kept, cell);
    }
    if (is_done(kept)) return;
    int axes[3]{};
    order_axes(region, axes);
    for (const int axis : axes)
      if (depth < deepest && halve_along(axis, kept, region, {cell, depth})) return;
    must_cut_ = true;
    if (!cuts_) return;
    const std::size_t n = kept.size();
    end_ = looks + 4 * n * minimum(n, 128 * static_cast<std::size_t>(std::bit_width(n)));  // some looks cost as a pair
    cut(reaching(kept, region), region, axes[0], 0);
  }

  struct call {
    space_box cell;
    int depth;
  };

  // False where boxes are not told apart: where nearly all are in both halves.
  constexpr bool halve_along(int axis, const lot& l, const space_box& region, const call& of) {
    space_box regions[2], cells[2];
    const double middle = region.low[axis] * 0.5 + region.high[axis] * 0.5;
    if (!halve_box(region, axis, middle, regions) || !halve_box(of.cell, axis, middle, cells)) return false;
    const lot halves[] = {within(l, regions[0]), within(l, regions[1])};
    if ((halves[0].size() + halves[1].size()) * 2 >= l.size() * 3) return false;
    for (int i = 0; i < 2; ++i) halve(halves[i], cells[i], of.depth + 1);
    return true;
  }

  struct split {
    lot halves[2]{};
    space_box regions[2]{};
    constexpr double pairs() const noexcept {
      const auto a = static_cast<double>(halves[0].size()), b = static_cast<double>(halves[1].size());
      return a * a + b * b;
    }
  };

  // How a region is halved: along one of the axes, or by a plane of one of the triangles.
  static constexpr int level = 3, across = 4, ways = 5;

  // Halves a region and keeps for each half those that reach it themselves: where boxes meet all over, long before the
  // triangles do. Two with a point in common are together in a half that has it. The lot reaches the region; way: what
  // is tried first.
  constexpr void cut(lot l, space_box region, int way, int depth) {
    const space_box whole = region;
    if (!narrow_region(region, boxes_, l)) return;
    if (!(region == whole)) l = reaching(l, region);
    if (l.size() <= few) return use_pairs(l, region);
    if (is_done(l)) return;
    if (looks > end_ || depth == deepest) return ask_tree(l);
    // The best of those that leave much fewer pairs, or where there is none the longest axis: what is in both halves
    // of all may not be so in smaller regions.
    split best;
    double least = most;
    const double all = static_cast<double>(l.size()) * static_cast<double>(l.size());
    int order[ways] = {0, 1, 2, level, across};
    order_axes(region, order);
    const int longest = order[0], first = way;
    for (int i = -1; i < ways && least > 0.6 * all; ++i) {
      const int now = i < 0 ? first : order[i];
      if (i >= 0 && now == first) continue;
      split s;
      if (now < level ? !split_axis(s, l, region, now) : !split_along(s, l, region, now == level)) continue;
      const double pairs = s.pairs();
      if (pairs <= 0.8 * all ? pairs >= least : now != longest || least < most) continue;
      least = pairs <= 0.8 * all ? pairs : maximum(pairs, 0.8 * all);
      best = std::move(s);
      way = now;
    }
    if (least == most) return ask_tree(l);
    l = {};
    for (int i = 0; i < 2; ++i) cut(std::move(best.halves[i]), best.regions[i], way, depth + 1);
  }

  // False where there is nothing between the sides of the region.
  constexpr bool split_axis(split& s, const lot& l, const space_box& region, int axis) {
    // Not the middle, where what is alike on both sides has its corners.
    const double middle = region.low[axis] * 0.53125 + region.high[axis] * 0.46875;
    if (!halve_box(region, axis, middle, s.regions)) return false;
    for (int i = 0; i < 2; ++i) s.halves[i] = reaching(l, s.regions[i]);
    return true;
  }

  // By a plane that runs as one triangle does, or along its longest side and across it: what lies side by side.
  constexpr bool split_along(split& s, const lot& l, const space_box& region, bool is_level) {
    const point<double, 3>(&p)[3] = items_[l[l.size() / 2]].p;
    vec<double, 3> longest{}, normal{};
    for (int k = 0; k < 3; ++k)
      if (const auto side = p[(k + 1) % 3] - p[k]; dot(side, side) > dot(longest, longest)) longest = side;
    normal = cross(p[1] - p[0], p[2] - p[0]);
    for (vec<double, 3>* v : {&longest, &normal}) {
      const double largest = maximum(maximum(magnitude(v->x), magnitude(v->y)), magnitude(v->z));
      if (!(largest > 0x1p-300)) return false;
      *v = *v / largest;
    }
    if (!is_level) normal = cross(normal, longest);
    struct interval {
      double low, high;
    };
    std::vector<interval> places;
    std::vector<double> middles;
    for (const std::uint32_t i : l) {
      interval at{most, -most};
      each_corner_within(items_[i], region, [&](const point<double, 3>& q) {
        const vec<double, 3> to = q - p[0];
        const double place = dot(normal, to);
        at.low = minimum(at.low, place);
        at.high = maximum(at.high, place);
      });
      middles.push_back(at.low * 0.5 + at.high * 0.5);
      // The normal's coordinates are 2 at most, and there are three of them; all others are 4 at most.
      const double error = 6 * items_[i].margin + 0x1p-40;
      places.push_back({at.low - error, at.high + error});
    }
    const auto middle = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
    std::nth_element(middles.begin(), middle, middles.end());
    std::size_t next = 0;
    for (space_box& r : s.regions) r = region;
    s.halves[0] = those_of(l, looks, [&](std::uint32_t) { return places[next++].low <= *middle; });
    next = 0;
    s.halves[1] = those_of(l, looks, [&](std::uint32_t) { return places[next++].high >= *middle; });
    return true;
  }

  // What nothing tells apart.
  constexpr void ask_tree(const lot& l) {
    pair_by_tree(boxes_, l, l, looks, [&](std::uint32_t i, std::uint32_t k) {
      if (k < i) use_pair(i, k, boxes_[i]);
    });
  }

  const body_triangles& b_;
  double scale_;
  const Use& use_;
  int count_ = 0;
  std::uint32_t around_[2]{};  // the corners that all triangles of this search have
  std::vector<searched_triangle> items_{};
  std::vector<space_box> boxes_{};
  lot corners_{};  // that all pairs which were left have in common
  // Where boxes alone tell all apart each pair is used in the cell where its common box begins. A pair's points are
  // elsewhere, perhaps; so where a lot is to be cut the search starts again, using a pair in each cell that has both.
  bool must_cut_ = false, cuts_ = false;
  std::size_t end_ = 0;  // the looks after which no more is cut
};

// The pairs of triangles, by their faces, in any order, some more than once. Adds to looks those of the search.
constexpr std::vector<face_pair> meeting_faces(const body_triangles& b, std::size_t& looks) {
  std::vector<seen_triangle> seen;
  std::vector<std::uint32_t> with_area;
  for (std::uint32_t t = 0; t < b.triangles.size(); ++t) {
    seen.push_back(see_triangle(b.positions, b.triangles[t], t));
    if (seen[t].turn != 0) with_area.push_back(t);
  }
  double most = 0, scale = 1;
  for (const point<double, 3>& p : b.positions)
    most = maximum(maximum(most, magnitude(p.x)), maximum(magnitude(p.y), magnitude(p.z)));
  while (most * scale > 1) scale *= 0.5;
  while (most * scale < 0.5 && scale < 0x1p1000) scale *= 2;
  std::vector<face_pair> found;
  const auto use = [&](std::uint32_t s, std::uint32_t t) {
    if (b.face[s] != b.face[t] && pass_through(seen[minimum(s, t)], seen[maximum(s, t)]))
      found.push_back({minimum(b.face[s], b.face[t]), maximum(b.face[s], b.face[t])});
  };
  triangle_pair_search<decltype(use)> search(b, scale, use);
  search.search(with_area);
  looks += search.looks;
  return found;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API std::vector<face_pair> self_intersections(const mesh<T>& m) {
  detail::body_triangles b;
  detail::append_body(b, m);
  if (b.fault != detail::surface_fault::none) return {};
  detail::merge_bodies(b);
  std::size_t looks = 0;
  std::vector<face_pair> found = detail::meeting_faces(b, looks);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace IRG_COMPILED_ABI
#endif
}  // namespace irg
