// SPDX-License-Identifier: MIT
// From a plan to its guards: the plan is cut along the sight lines at which what a corner sees begins or ends; each
// part is asked from which corners it is seen; corners are chosen until each part has one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/visibility/detail/finite_point.hpp>
#include <irg/visibility/detail/sight_arrangement.hpp>
#include <irg/visibility/detail/sight_envelope.hpp>
#include <irg/visibility/detail/source_view.hpp>
#include <irg/visibility/guard_result.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

template <Floating T>
class guard_chooser {
public:
  constexpr guard_cover<T> run(std::span<const std::vector<point<T, 2>>> rings) {
    guard_cover<T> out;
    out.status = read(rings);
    if (out.status != guard_status::done || corners_.empty()) return out;
    note_neighbours();
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
  // A corner with the way in and the way out, the inside on the left of both.
  struct corner {
    point<T, 2> before, at, after;
    std::size_t number;
    std::vector<std::uint32_t> here{};  // all corners at this place, itself among them
    std::vector<segment<T, 2>> touched{};  // walls that pass here, the inside on their left
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
      for (const auto& p : r)
        if (!is_finite_sight_point(p)) return guard_status::not_finite;
    std::size_t number = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (!add_ring(rings, i, number)) return guard_status::rings_cross;
      number += rings[i].size();
    }
    for (std::size_t i = 0; i < walls_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (disturb(walls_[i], walls_[k])) return guard_status::rings_cross;
    return guard_status::done;
  }

  // Whether two walls cross, or run along each other.
  static constexpr bool disturb(const segment<T, 2>& s, const segment<T, 2>& t) noexcept {
    const int sa = orient2d(t.a, t.b, s.a), sb = orient2d(t.a, t.b, s.b);
    if (sa * sb > 0) return false;
    if (sa == 0 && sb == 0) return intersect_segments(s, t).relation == segment_relation::overlap;
    return sa * sb < 0 && orient2d(s.a, s.b, t.a) * orient2d(s.a, s.b, t.b) < 0;
  }

  // Adds the corners of a ring without repeated ones; false when it has corners on a line only.
  constexpr bool add_ring(std::span<const std::vector<point<T, 2>>> rings, std::size_t index, std::size_t number) {
    std::vector<corner> ring;
    for (std::size_t i = 0; i < rings[index].size(); ++i) {
      const point<T, 2>& p = rings[index][i];
      if (ring.empty() || !(ring.back().at == p)) ring.push_back({p, p, p, number + i});
    }
    while (ring.size() > 1 && ring.back().at == ring[0].at) ring.pop_back();
    const std::size_t n = ring.size();
    if (n < 3) return n < 2;  // a point is no part of a plan
    const orientation way = orientation_of(rings[index]);
    if (way == orientation::degenerate) return false;
    const bool inside_left = (way == orientation::counter_clockwise) == (depth_of(rings, index) % 2 == 0);
    for (std::size_t i = 0; i < n; ++i) {
      ring[i].before = ring[inside_left ? (i + n - 1) % n : (i + 1) % n].at;
      ring[i].after = ring[inside_left ? (i + 1) % n : (i + n - 1) % n].at;
      walls_.push_back({ring[i].before, ring[i].at});
      corners_.push_back(ring[i]);
      extent_ = enclosing_box(extent_, ring[i].at);
    }
    return true;
  }

  // How many other rings a ring lies in: told by a corner or, where all corners touch, by nothing.
  static constexpr std::size_t depth_of(std::span<const std::vector<point<T, 2>>> rings, std::size_t index) {
    std::size_t depth = 0;
    for (std::size_t k = 0; k < rings.size(); ++k) {
      if (k == index) continue;
      for (const auto& p : rings[index]) {
        const location where = point_in_polygon(rings[k], p, fill_rule::even_odd);
        if (where == location::boundary) continue;
        depth += where == location::inside ? 1 : 0;
        break;
      }
    }
    return depth;
  }

  // Only past such a corner a sight line goes on within the plan.
  static constexpr bool is_reflex(const corner& c) noexcept { return orient2d(c.before, c.at, c.after) < 0; }

  constexpr void cut() {
    for (const auto& w : walls_) parts_of_plan_.cuts.push_back({w, false, true});
    source_view<T> view;
    view.obstacles = walls_;
    for (const corner& g : corners_) {
      view.source.assign(1, g.at);
      for (const corner& v : corners_)
        if (!(g.at == v.at) && is_reflex(v) && view.matters_beyond(g.at, v.at))
          parts_of_plan_.cuts.push_back({{g.at, v.at}, true, false});
    }
    parts_of_plan_.build(extent_);
  }

  constexpr void note_neighbours() {
    for (corner& c : corners_) {
      for (std::uint32_t i = 0; i < corners_.size(); ++i)
        if (corners_[i].at == c.at) c.here.push_back(i);
      for (const auto& w : walls_)
        if (!(w.a == c.at) && !(w.b == c.at) && orient2d(w.a, w.b, c.at) == 0 && lies_within(w.a, w.b, c.at))
          c.touched.push_back(w);
    }
  }

  // Whether the direction from the corner to p lies to the left of the way in and out.
  static constexpr bool is_on_left(const corner& c, const point<T, 2>& p) noexcept {
    const bool left_of_in = orient2d(c.before, c.at, p) > 0, left_of_out = orient2d(c.at, c.after, p) > 0;
    return is_reflex(c) ? left_of_in || left_of_out : left_of_in && left_of_out;
  }
  // Whether two ways through one corner lead over each other. Walls that meet elsewhere than in corners do not cross,
  // and none run along each other.
  constexpr bool cross_in_corners() const noexcept {
    for (const corner& c : corners_) {
      for (const std::uint32_t i : c.here)
        if (is_on_left(c, corners_[i].before) != is_on_left(c, corners_[i].after)) return true;
      for (const auto& w : c.touched)
        if (is_on_left(c, w.a) != is_on_left(c, w.b)) return true;
    }
    return false;
  }

  // Whether the way to a place leaves the corner into the plan.
  template <class Side>
  constexpr bool opens_to(const corner& at, const Side& side) const {
    for (const auto& w : at.touched)
      if (side(w.a, w.b) < 0) return false;
    for (const std::uint32_t i : at.here) {
      const corner& c = corners_[i];
      const bool left_of_in = side(c.before, c.at) > 0, left_of_out = side(c.at, c.after) > 0;
      if (is_reflex(c) ? !left_of_in && !left_of_out : !left_of_in || !left_of_out) return false;
    }
    return true;
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
        return parts_of_plan_.side_beside(best, u, v);
      };
      part found{e};
      for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        if (!opens_to(corners_[i], side)) continue;
        view.source.assign(1, corners_[i].at);
        if (view.share(side) == seen_share::all) found.seers.push_back(i);
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

}  // namespace IRG_ABI
}  // namespace irg::detail
