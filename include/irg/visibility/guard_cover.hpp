// SPDX-License-Identifier: MIT
// Guards on the corners of a plan who see all of it, and the proof: parts that make up the plan, each with a guard who
// sees the whole part. Chosen greedily, with a number that no choice of corners can go below.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/math/vec.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/compare.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/visibility/detail/sight_arrangement.hpp>
#include <irg/visibility/detail/source_view.hpp>
#endif

namespace irg {

/// Whether guards could be chosen: not where rings cross or run along each other or themselves, or something is NaN or
/// infinite.
enum class [[nodiscard]] guard_status { ok, rings_cross, not_finite, done [[deprecated("irg: done is now ok")]] = ok };

/// A part of a plan, counter-clockwise, and a guard who sees all of it: a corner's number.
/// shape   a part with holes is listed once for its outer ring, and once for each hole, clockwise
template <Floating T>
struct guarded_part {
  std::vector<point<T, 2>> ring{};
  std::size_t guard = 0;
  bool operator==(const guarded_part&) const = default;
};

/// Guards of a plan, as numbers of its corners; the least number that could do; the parts of the plan.
template <Floating T>
struct guard_cover {
  guard_status status = guard_status::ok;
  std::vector<std::size_t> guards{};
  std::size_t at_least = 0;
  std::vector<guarded_part<T>> parts{};
  bool operator==(const guard_cover&) const = default;

  /// Whether the guards see all of the plan.
  IRG_INLINE constexpr explicit operator bool() const noexcept { return status == guard_status::ok; }
};

inline namespace IRG_COMPILED_ABI {

/// Corners of the plan from which together all of it is seen, and the parts that prove it.
/// shape   rings of any direction and in any order; a ring inside another one is a hole, one inside a hole a room
///         again. They may touch in points. Corners are numbered on from ring to ring
/// needs   fewer than 2^15 corners
/// gives   guards by increasing number, none of whom could be left out; `at_least`: so many parts have no guard in
///         common, whichever corners are chosen. No guards where no ring has an area
/// exact   every decision, for all finite floats and doubles; the corners of parts are the plan's own, bit for bit, or
///         correctly rounded crossings of lines through two of them
/// cost    m sight lines past two corners cut the plan into up to m^2 parts, each of which asks every corner: made for
///         plans of some dozens of corners
/// source  Ghosh 1987 (greedy over the parts that corners see)
template <Floating T>
[[nodiscard]] IRG_API guard_cover<T> cover_by_guards(std::span<const std::vector<point<T, 2>>> rings);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// From a plan to its guards: the plan is cut along the sight lines at which what a corner sees begins or ends; each
// part is asked from which corners it is seen; corners are chosen until each part has one.

template <Floating T>
class guard_set_cover {
public:
  constexpr guard_cover<T> run(std::span<const std::vector<point<T, 2>>> rings) {
    guard_cover<T> out;
    out.status = read(rings);
    if (out.status != guard_status::ok || corners_.empty()) return out;
    for (corner& c : corners_) note_bends(c, corners_);
    if (cross_in_corners()) {
      out.status = guard_status::rings_cross;
      return out;
    }
    cut();
    find_parts();
    choose(out);
    return out;
  }

private:
  // A way in and a way out, the inside on the left of both.
  struct bend {
    point<T, 2> before, at, after;
  };
  struct corner : bend {
    std::size_t number;
    std::vector<bend> here{};  // all at this place, itself and walls that pass among them
    std::size_t most = 0;      // of them that lie on the left of one direction; where so many do is the inside
  };
  struct part {
    std::uint32_t edge;  // a half-edge along it
    std::vector<std::uint32_t> seers{};  // corners, in order
  };

  std::vector<corner> corners_{};
  std::vector<segment<T, 2>> walls_{};
  sight_arrangement<T> parts_of_plan_{};
  std::vector<part> parts_{};
  box<T, 2> extent_{};

  constexpr guard_status read(std::span<const std::vector<point<T, 2>>> rings) {
    for (const auto& r : rings)
      if (!is_finite(r)) return guard_status::not_finite;
    std::vector<std::vector<corner>> list;
    std::size_t number = 0;
    for (const auto& r : rings) {
      if (!add_ring(r, number, list)) return guard_status::rings_cross;
      number += r.size();
    }
    for (std::size_t i = 0; i < list.size(); ++i) add_corners(list, i);
    for (std::size_t i = 0; i < walls_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (disturb(walls_[i], walls_[k])) return guard_status::rings_cross;
    return guard_status::ok;
  }

  // Whether two walls cross, or run along each other.
  static constexpr bool disturb(const segment<T, 2>& s, const segment<T, 2>& t) noexcept {
    const int sa = orient2d(t.a, t.b, s.a), sb = orient2d(t.a, t.b, s.b);
    if (sa * sb > 0) return false;
    if (sa == 0 && sb == 0) return intersect_segments(s, t).relation == segment_relation::overlap;
    return sa * sb < 0 && orient2d(s.a, s.b, t.a) * orient2d(s.a, s.b, t.b) < 0;
  }

  // Adds a ring without repeated corners, counter-clockwise; false when it has corners on a line only.
  static constexpr bool add_ring(const std::vector<point<T, 2>>& given, std::size_t number,
                                 std::vector<std::vector<corner>>& list) {
    std::vector<corner> ring;
    for (std::size_t i = 0; i < given.size(); ++i)
      if (ring.empty() || !(ring.back().at == given[i])) ring.push_back({{given[i], given[i], given[i]}, number + i});
    while (ring.size() > 1 && ring.back().at == ring[0].at) ring.pop_back();
    const std::size_t n = ring.size();
    if (n < 3) return n < 2;  // a point is no part of a plan
    const orientation way = orientation_of(given);
    for (std::size_t i = 0; i < n; ++i) {
      ring[i].before = ring[(i + n - 1) % n].at;
      ring[i].after = ring[(i + 1) % n].at;
      if (way == orientation::clockwise) std::swap(ring[i].before, ring[i].after);
    }
    list.push_back(std::move(ring));
    return way != orientation::degenerate;
  }

  // The corners and walls of a ring, the inside of the plan on their left.
  constexpr void add_corners(const std::vector<std::vector<corner>>& list, std::size_t index) {
    std::size_t depth = 0;
    for (std::size_t k = 0; k < list.size(); ++k) depth += k != index && lies_in(list[index], list[k]) ? 1u : 0u;
    for (corner c : list[index]) {
      if (depth % 2 != 0) std::swap(c.before, c.after);
      walls_.push_back({c.before, c.at});
      corners_.push_back(c);
      extent_ = bounding_box(extent_, c.at);
    }
  }

  // Whether a ring lies in another one: told by a corner or, where all corners touch it, by the way to the next one.
  static constexpr bool lies_in(const std::vector<corner>& ring, const std::vector<corner>& other) {
    std::vector<point<T, 2>> outline;
    outline.reserve(other.size());
    for (const corner& c : other) outline.push_back(c.at);
    for (const corner& c : ring)
      if (const location where = point_in_polygon(outline, c.at, fill_rule::even_odd); where != location::boundary)
        return where == location::inside;
    corner first = ring[0];
    note_bends(first, other);
    return leads_inside(first, [&](const bend& b) { return is_on_left(b, ring[0].after); });
  }

  // Only past such a corner a sight line goes on within the plan.
  static constexpr bool is_reflex(const bend& c) noexcept { return orient2d(c.before, c.at, c.after) < 0; }

  constexpr void cut() {
    for (const auto& w : walls_) parts_of_plan_.cuts.push_back({w, false, true});
    source_view<T> view;
    view.obstacles = walls_;
    for (const corner& g : corners_) {
      view.source.assign(1, g.at);
      for (const corner& v : corners_)
        if (!(g.at == v.at) && is_reflex(v) && matters_beyond(view, g.at, v.at))
          parts_of_plan_.cuts.push_back({{g.at, v.at}, true, false});
    }
    build_arrangement(parts_of_plan_, extent_);
  }

  // Notes the ways of some rings through the place of a corner.
  static constexpr void note_bends(corner& c, const std::vector<corner>& rings) {
    for (const corner& o : rings) {
      if (o.at == c.at) c.here.push_back(o);
      if (!(o.before == c.at) && !(o.at == c.at) && orient2d(o.before, o.at, c.at) == 0 &&
          is_between_ends(o.before, o.at, c.at))
        c.here.push_back({o.before, c.at, o.at});
    }
    c.most = 1;  // a way has the inside on its left
    for (const bend& b : c.here) c.most += is_on_left(b, c.here[0].after) ? 1u : 0u;
  }

  // Whether the direction from a bend to p lies to the left of the way in and out.
  static constexpr bool is_on_left(const bend& c, const point<T, 2>& p) noexcept {
    const bool left_of_in = orient2d(c.before, c.at, p) > 0, left_of_out = orient2d(c.at, c.after, p) > 0;
    return is_reflex(c) ? left_of_in || left_of_out : left_of_in && left_of_out;
  }
  // Whether two ways through one corner lead over each other. Walls that meet elsewhere than in corners do not cross,
  // and none run along each other.
  constexpr bool cross_in_corners() const noexcept {
    for (const corner& c : corners_)
      for (const bend& b : c.here)
        if (is_on_left(c, b.before) != is_on_left(c, b.after)) return true;
    return false;
  }

  // Whether a direction leaves the corner into the plan; on_left(bend) says whether it lies to the left of one.
  template <class OnLeft>
  static constexpr bool leads_inside(const corner& at, const OnLeft& on_left) {
    std::size_t count = 0;
    for (const bend& b : at.here) count += on_left(b) ? 1u : 0u;
    return count == at.most;
  }

  // A place in the plan is seen from some corner, one out of it from none.
  constexpr void find_parts() {
    const auto& edges = parts_of_plan_.edges;
    std::vector<std::uint8_t> known(edges.size(), std::uint8_t{0});
    source_view<T> view;
    view.obstacles = walls_;
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      if (known[e] != 0) continue;
      std::uint32_t best = e, k = e;  // where the origin is given, sides cost least
      do {
        known[k] = 1;
        if (parts_of_plan_.vertices[edges[k].origin].is_given) best = k;
        k = edges[k].next;
      } while (k != e);
      const auto side = [&](const point<T, 2>& u, const point<T, 2>& v) {
        return side_beside(parts_of_plan_, best, u, v);
      };
      const auto on_left = [&](const bend& b) {
        const bool left_of_in = side(b.before, b.at) > 0, left_of_out = side(b.at, b.after) > 0;
        return is_reflex(b) ? left_of_in || left_of_out : left_of_in && left_of_out;
      };
      part found{e};
      for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        if (!leads_inside(corners_[i], on_left)) continue;
        view.source.assign(1, corners_[i].at);
        if (share_seen(view, side) == seen_share::all) found.seers.push_back(i);
      }
      if (!found.seers.empty()) parts_.push_back(std::move(found));
    }
  }

  constexpr void choose(guard_cover<T>& out) const {
    std::vector<std::uint8_t> is_guard(corners_.size(), std::uint8_t{0});
    const auto guards_of = [&](const part& p) {
      std::size_t count = 0;
      for (const std::uint32_t i : p.seers) count += is_guard[i];
      return count;
    };
    for (;;) {
      std::vector<std::size_t> gain(corners_.size(), std::size_t{0});
      for (const part& p : parts_)
        if (guards_of(p) == 0)
          for (const std::uint32_t i : p.seers) ++gain[i];
      std::size_t best = 0;
      for (std::size_t i = 1; i < gain.size(); ++i)
        if (gain[best] < gain[i]) best = i;
      if (gain[best] == 0) break;
      is_guard[best] = 1;
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (is_guard[i] == 0) continue;
      is_guard[i] = 0;
      for (const part& p : parts_)
        if (guards_of(p) == 0) is_guard[i] = 1;
    }
    for (std::size_t i = 0; i < corners_.size(); ++i)
      if (is_guard[i] != 0) out.guards.push_back(corners_[i].number);
    out.at_least = least_number();
    for (const part& p : parts_) {
      std::size_t first = 0;
      while (is_guard[p.seers[first]] == 0) ++first;
      out.parts.push_back({ring_of_part(p), corners_[p.seers[first]].number});
    }
  }

  // Parts that no corner sees two of need a guard each. Those that few corners see are taken first.
  constexpr std::size_t least_number() const {
    std::vector<std::uint8_t> taken(corners_.size(), std::uint8_t{0});
    std::size_t count = 0;
    for (std::size_t size = 1; size <= corners_.size(); ++size)
      for (const part& p : parts_) {
        if (p.seers.size() != size) continue;
        bool is_apart = true;
        for (const std::uint32_t i : p.seers) is_apart = is_apart && taken[i] == 0;
        if (!is_apart) continue;
        ++count;
        for (const std::uint32_t i : p.seers) taken[i] = 1;
      }
    return count;
  }

  constexpr std::vector<point<T, 2>> ring_of_part(const part& p) const {
    const auto& edges = parts_of_plan_.edges;
    std::vector<point<T, 2>> ring;
    std::uint32_t e = p.edge;
    do {
      ring.push_back(parts_of_plan_.vertices[edges[e].origin].at);
      e = edges[e].next;
    } while (e != p.edge);
    return ring;
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API guard_cover<T> cover_by_guards(std::span<const std::vector<point<T, 2>>> rings) {
  return detail::guard_set_cover<T>().run(rings);
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
