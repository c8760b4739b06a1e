// SPDX-License-Identifier: MIT
// Many points against one body: its triangles stand in a tree of boxes as they are seen from above, so that a point
// asks the few that its ray upward may meet.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <irg/solid/point_in_solid.hpp>

namespace irg {

/// What points have asked of a body so far.
struct solid_locator_counts {
  std::uint64_t points = 0, boxes = 0, triangles = 0;  // asked; triangles / points of all are not skipped
};

/// A body made ready for point_in_solid and winding_number of many points.
template <Floating T>
class solid_locator {
public:
  /// needs   as point_in_solid
  /// cost    sorts the triangles by place, O(n log n); allocates some 130 bytes a triangle of doubles
  template <detail::mesh_in_space M>
    requires std::same_as<scalar_of<mesh_point<M>>, T>
  constexpr explicit solid_locator(const M& body) {
    detail::each_solid_triangle(triangulate(to_mesh<T>(body)), [&](const auto& a, const auto& b, const auto& c) {
      triangles_.push_back({{a, b, c}});
    });
    build();
  }

  /// winding_number of the body; counts what it asks in `counts`, where that is given.
  /// gives, exact   as winding_number
  /// cost    some log n boxes and the triangles above and beside p; nothing allocated
  constexpr std::optional<int> winding_number(const point<T, 3>& p, solid_locator_counts* counts = nullptr) const {
    const detail::upward_crossings count = cross(p, counts);
    if (count.on_surface) return std::nullopt;
    return count.winding;
  }

  /// point_in_solid of the body.
  /// gives, exact   as point_in_solid
  /// cost    as winding_number
  constexpr location operator()(const point<T, 3>& p, fill_rule rule = fill_rule::non_zero,
                                solid_locator_counts* counts = nullptr) const {
    return detail::location_by_winding(cross(p, counts), rule);
  }

private:
  using triangle = std::array<point<T, 3>, 3>;
  static constexpr std::uint32_t leaf_size = 8;

  // A box seen from above, and its top.
  struct flat_box {
    T low[2], high[2], top;

    // Without branches: few points are beside a box for the reason for which the last one was.
    [[nodiscard]] IRG_INLINE constexpr bool may_be_below(const point<T, 3>& p) const noexcept {
      return ((low[0] <= p.x) & (p.x <= high[0]) & (low[1] <= p.y) & (p.y <= high[1]) & (p.z <= top)) != 0;
    }
  };

  // Nodes stand in the order of a walk that takes each before its parts; `next` is the node after all of them.
  struct node {
    flat_box box;
    std::uint32_t next, first, count;  // triangles, where it has no parts
  };

  [[nodiscard]] static constexpr T centre(const triangle& t, int axis) noexcept {
    const T a = t[0][axis] * T(0.25), b = t[1][axis] * T(0.25), c = t[2][axis] * T(0.25);
    return lesser(lesser(a, b), c) + greater(greater(a, b), c);
  }

  [[nodiscard]] constexpr flat_box box_of(std::uint32_t first, std::uint32_t last) const {
    const point<T, 3>& p = triangles_[first][0];
    flat_box n{{p.x, p.y}, {p.x, p.y}, p.z};
    for (std::uint32_t i = first; i < last; ++i)
      for (const point<T, 3>& q : triangles_[i]) {
        n.low[0] = lesser(n.low[0], q.x), n.high[0] = greater(n.high[0], q.x);
        n.low[1] = lesser(n.low[1], q.y), n.high[1] = greater(n.high[1], q.y);
        n.top = greater(n.top, q.z);
      }
    return n;
  }

  // Halves runs of triangles along the longer side of the box round them, until they are short.
  constexpr void build() {
    struct run {
      std::uint32_t first, last;
    };
    const auto count = static_cast<std::uint32_t>(triangles_.size());
    std::vector<run> open;
    if (count > 0) open.push_back({0, count});
    std::vector<std::uint32_t> ends;  // of each node, the last triangle
    while (!open.empty()) {
      const run r = open.back();
      open.pop_back();
      node n{box_of(r.first, r.last), 0, r.first, r.last - r.first};
      const flat_box& around = n.box;
      if (r.last - r.first > leaf_size) {
        const int axis =
            around.high[0] * T(0.5) - around.low[0] * T(0.5) < around.high[1] * T(0.5) - around.low[1] * T(0.5) ? 1 : 0;
        const std::uint32_t middle = r.first + (r.last - r.first) / 2;
        const auto at = [&](std::uint32_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(r.first), at(middle), at(r.last),
                         [axis](const triangle& a, const triangle& b) { return centre(a, axis) < centre(b, axis); });
        open.push_back({middle, r.last});
        open.push_back({r.first, middle});
        n.count = 0;
      }
      nodes_.push_back(n);
      ends.push_back(r.last);
    }
    // A node's walk ends where the first node begins that stands behind its triangles.
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      while (!waiting.empty() && ends[waiting.back()] <= nodes_[i].first) {
        nodes_[waiting.back()].next = i;
        waiting.pop_back();
      }
      waiting.push_back(i);
    }
    for (const std::uint32_t i : waiting) nodes_[i].next = static_cast<std::uint32_t>(nodes_.size());
    for (std::uint32_t t = 0; t < count; ++t) boxes_.push_back(box_of(t, t + 1));
  }

  constexpr detail::upward_crossings cross(const point<T, 3>& p, solid_locator_counts* counts) const {
    detail::upward_crossings out;
    solid_locator_counts asked{1, 0, 0};
    if (is_finite(p))
      for (std::uint32_t i = 0; i < nodes_.size() && !out.on_surface;) {
        const node& n = nodes_[i];
        ++asked.boxes;
        if (!n.box.may_be_below(p)) {
          i = n.next;
          continue;
        }
        std::uint32_t asks = 0;  // a bit for each triangle whose box is over p
        for (std::uint32_t k = 0; k < n.count; ++k) asks |= (boxes_[n.first + k].may_be_below(p) ? 1u : 0u) << k;
        asked.triangles += static_cast<std::uint64_t>(std::popcount(asks));
        for (; asks != 0; asks &= asks - 1) {
          const triangle& t = triangles_[n.first + static_cast<std::uint32_t>(std::countr_zero(asks))];
          detail::count_upward_crossing(t[0], t[1], t[2], p, out);
        }
        ++i;
      }
    if (counts) {
      counts->points += asked.points;
      counts->boxes += asked.boxes;
      counts->triangles += asked.triangles;
    }
    return out;
  }

  std::vector<triangle> triangles_;
  std::vector<flat_box> boxes_;  // of the triangles
  std::vector<node> nodes_;
};

template <detail::mesh_in_space M>
solid_locator(const M&) -> solid_locator<scalar_of<mesh_point<M>>>;

}  // namespace irg
