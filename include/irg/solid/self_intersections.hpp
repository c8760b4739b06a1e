// SPDX-License-Identifier: MIT
// Which faces of a surface pass through each other, exactly: what list_faults does not look at.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/mesh/to_mesh.hpp>
#include <irg/solid/detail/body_triangles.hpp>
#include <irg/solid/detail/box_pairs.hpp>
#include <irg/solid/detail/triangle_contacts.hpp>

namespace irg {

/// Two faces that meet where they should not.
struct face_pair {
  std::uint32_t first = 0, second = 0;
  constexpr auto operator<=>(const face_pair&) const = default;
};

namespace detail {
inline namespace IRG_ABI {

// Whether two triangles have more in common than corners and whole sides that both have.
template <std::same_as<triangle_indices> Triangle>
constexpr bool pass_through(const std::vector<point<double, 3>>& positions, const Triangle& s,
                            const Triangle& t) noexcept {
  const auto a = see_triangle(positions, s, 0), b = see_triangle(positions, t, 1);
  if (a.turn == 0 || b.turn == 0) return false;
  const contact_finder found(a, b);
  for (int i = 0; i < found.count; ++i)
    if (found.contacts[i].at[0] > 2 || found.contacts[i].at[1] > 2) return true;
  return found.count == 3;  // the same triangle
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// All pairs of faces that have a point in common which is not a corner of both: faces that cross, touch each other's
/// inside or sides, lie on each other.
/// shape   first < second, in order, each pair once; equal positions are one corner
/// needs   a mesh in which validate() finds no defect, with finite positions
/// gives   nothing for faces without area, whose sides are their neighbours'; pieces of one face are not compared
/// exact   always, for the triangles that triangulate() makes of the faces
/// cost    O(n log n) and the pairs of triangles whose boxes meet: some dozen for each triangle where bodies are
///         smooth, all pairs of those around one corner
template <Floating T>
[[nodiscard]] constexpr std::vector<face_pair> self_intersections(const mesh<T>& m) {
  detail::body_triangles b;
  detail::append_body(b, m);
  std::vector<face_pair> found;
  if (b.fault != detail::surface_fault::none) return found;
  detail::merge_bodies(b);
  std::vector<detail::space_box> boxes;
  std::vector<std::uint32_t> all;
  for (std::uint32_t t = 0; t < b.triangles.size(); ++t) {
    detail::space_box box = detail::no_box();
    for (const std::uint32_t v : b.triangles[t].v) box.add(b.positions[v]);
    boxes.push_back(box);
    all.push_back(t);
  }
  const auto use = [&](std::uint32_t s, std::uint32_t t) {
    if (s < t && b.face[s] != b.face[t] && detail::pass_through(b.positions, b.triangles[s], b.triangles[t]))
      found.push_back({b.face[s] < b.face[t] ? b.face[s] : b.face[t], b.face[s] < b.face[t] ? b.face[t] : b.face[s]});
  };
  detail::box_pair_search<decltype(use)>(boxes, use).search(all, all);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace IRG_ABI
}  // namespace irg
