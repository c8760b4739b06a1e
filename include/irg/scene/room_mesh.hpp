// SPDX-License-Identifier: MIT
// room_mesh: a cell of a plan as one sees it from within: floor, ceiling, and walls with openings where portals are.
//
// Walls are cut where portals end and where their sills and lintels are, on both sides of an opening alike, so that
// neighbouring faces share whole edges and a picture shows no cracks between them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/geometry/compare.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/visibility/view_through_portals.hpp>

namespace irg::inline IRG_ABI {

/// The inside of a cell of a plan: its floor, its ceiling, and its walls, open where its portals are.
/// shape   z is up; faces counter-clockwise as seen from within, floor first, then the ceiling; straight corners where
///         portals end, so that neighbours share whole edges
/// needs   a plan without defects, its graph, and one of its cells
/// exact   coordinates are those of the plan
/// cost    the corners times the portals of the cell; allocates the result
template <Floating T>
[[nodiscard]] constexpr mesh<T> room_mesh(const cell_plan<T>& plan, const portal_graph<T>& graph, std::uint32_t cell);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

template <class T>
class room_builder {
public:
  constexpr room_builder(const cell_plan<T>& plan, const portal_graph<T>& graph, std::uint32_t cell)
      : plan_(plan), room_(plan.cells[cell]), doors_(graph.doors(cell)) {
    for (std::size_t i = 0; i < room_.corners.size(); ++i)
      add_side(room_.corners[i], room_.corners[i + 1 < room_.corners.size() ? i + 1 : 0]);
  }

  constexpr mesh<T> build() {
    for (std::size_t i = 0; i < posts_.size(); ++i) add_heights(i);
    std::vector<std::uint32_t> face;
    face.reserve(posts_.size());
    for (const post& p : posts_) face.push_back(p.first);
    add_face(out_, face);
    face.clear();
    for (std::size_t i = posts_.size(); i-- > 0;) face.push_back(posts_[i].first + posts_[i].count - 1);
    add_face(out_, face);
    for (std::size_t i = 0; i < posts_.size(); ++i) {
      const T low = posts_[i].low, high = posts_[i].high;
      if (!(low < high)) add_panel(i, room_.floor, room_.ceiling);
      if (low < high && room_.floor < low) add_panel(i, room_.floor, low);
      if (low < high && high < room_.ceiling) add_panel(i, high, room_.ceiling);
    }
    return std::move(out_);
  }

private:
  // A point of the boundary, the opening from it to the next (none where low == high), and its vertices upwards.
  struct post {
    point<T, 2> at{};
    T low{}, high{};
    std::uint32_t first = 0, count = 0;
  };

  constexpr std::size_t next(std::size_t i) const noexcept { return i + 1 < posts_.size() ? i + 1 : 0; }
  constexpr std::size_t before(std::size_t i) const noexcept { return i > 0 ? i - 1 : posts_.size() - 1; }

  constexpr bool lies_on(const point<T, 2>& a, const point<T, 2>& b, const point<T, 2>& p) const noexcept {
    return orient2d(a, b, p) == 0 && is_between_ends(a, b, p);
  }

  // The posts of a side but its last, in order.
  constexpr void add_side(const point<T, 2>& a, const point<T, 2>& b) {
    if (a == b) return;
    const std::size_t start = posts_.size();
    posts_.push_back({a});
    for (const doorway<T>& d : doors_)
      for (const point<T, 2>& p : {d.right, d.left}) {
        if (p == a || p == b || !lies_on(a, b, p)) continue;
        std::size_t i = posts_.size();
        while (i > start && is_between_ends(a, posts_[i - 1].at, p) && !(posts_[i - 1].at == p)) --i;
        if (i > start && posts_[i - 1].at == p) continue;
        posts_.insert(posts_.begin() + static_cast<std::ptrdiff_t>(i), post{p});
      }
    for (std::size_t i = start; i < posts_.size(); ++i)
      for (const doorway<T>& d : doors_) {
        const point<T, 2>& last = i + 1 < posts_.size() ? posts_[i + 1].at : b;
        if (!lies_on(d.right, d.left, posts_[i].at) || !lies_on(d.right, d.left, last)) continue;
        const auto opening = opening_of(plan_, d);
        posts_[i].low = opening[0].z;
        posts_[i].high = opening[2].z;
      }
  }

  // The vertices over a point: floor and ceiling, and where the openings beside it begin and end.
  constexpr void add_heights(std::size_t i) {
    const post &here = posts_[i], &other = posts_[before(i)];
    std::array<T, 6> z{room_.floor, here.low, here.high, other.low, other.high, room_.ceiling};
    for (std::size_t k = 1; k < z.size(); ++k)
      for (std::size_t j = k; j > 0 && z[j] < z[j - 1]; --j) std::swap(z[j], z[j - 1]);
    posts_[i].first = static_cast<std::uint32_t>(out_.positions.size());
    for (std::size_t k = 0; k < z.size(); ++k) {
      const bool opens = (here.low < here.high && (z[k] == here.low || z[k] == here.high)) ||
                         (other.low < other.high && (z[k] == other.low || z[k] == other.high));
      const bool ends = z[k] == room_.floor || z[k] == room_.ceiling;
      const bool is_new = out_.positions.size() == posts_[i].first || !(out_.positions.back().z == z[k]);
      if ((opens || ends) && is_new && !(z[k] < room_.floor) && !(room_.ceiling < z[k]))
        out_.positions.push_back({here.at.x, here.at.y, z[k]});
    }
    posts_[i].count = static_cast<std::uint32_t>(out_.positions.size()) - posts_[i].first;
  }

  // A wall from one post to the next, from one height to another, as seen from within.
  constexpr void add_panel(std::size_t i, const T& low, const T& high) {
    const post &p = posts_[i], &q = posts_[next(i)];
    const auto is_in = [&](std::uint32_t v) { return !(out_.positions[v].z < low) && !(high < out_.positions[v].z); };
    std::vector<std::uint32_t> face;
    for (std::uint32_t v = p.first; v < p.first + p.count; ++v)
      if (is_in(v)) face.push_back(v);
    for (std::uint32_t v = q.first + q.count; v-- > q.first;)
      if (is_in(v)) face.push_back(v);
    add_face(out_, face);
  }

  const cell_plan<T>& plan_;
  const plan_cell<T>& room_;
  std::span<const doorway<T>> doors_;
  std::vector<post> posts_;
  mesh<T> out_;
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr mesh<T> room_mesh(const cell_plan<T>& plan, const portal_graph<T>& graph, std::uint32_t cell) {
  return detail::room_builder<T>(plan, graph, cell).build();
}

}  // namespace irg::inline IRG_ABI
