// SPDX-License-Identifier: MIT
// Normals for smooth shading that leaves sharp edges sharp. Around a vertex the faces fall into groups, connected over
// edges that are not creases; the corners of a group share one normal.
#pragma once

#include <irg/math/angle_between.hpp>
#include <irg/math/trigonometry.hpp>  // radians()
#include <irg/mesh/mesh.hpp>
#include <irg/mesh/normals.hpp>
#if IRG_BODIES
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/mesh/detail/corner_groups.hpp>
#include <irg/mesh/edge_ends.hpp>
#endif

namespace irg::inline IRG_COMPILED_ABI {

/// Gives the corners of a mesh that have no normal one: the normal of the faces around the corner's position that are
/// connected to its own face over smooth edges, weighted and summed as vertex_normals does. An edge is smooth where
/// exactly two faces meet, run along it in opposite directions, and turn by no more than `crease`.
/// shape   normals are added behind those that are there, in the order of the corners that first need them
/// units   crease in radians: 0 keeps every edge that is not flat, pi smooths all
/// needs   a mesh that passes validate()
/// gives   as vertex_normals where a group has no direction; a face without a normal has sharp edges; a crease that is
///         NaN makes every edge sharp
/// exact   normals as vertex_normals; the angle that decides is that of rounded unit normals
/// cost    n log n in the corners around a position; allocates some 120 bytes a corner, nothing where all have normals
/// source  VRML 97, 4.6.3.5 (the crease angle)
template <Floating T>
IRG_API void assign_crease_normals(mesh<T>& m, T crease, normal_weight weight = normal_weight::angle);

}  // namespace irg::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void assign_crease_normals(mesh<T>& m, T crease, normal_weight weight) {
  if (std::ranges::all_of(m.corners, [](const mesh_corner& c) { return c.normal != no_index; })) return;
  const std::size_t count = m.corners.size();
  std::vector<vec<double, 3>> unit(count, vec<double, 3>{}), weighted(count, vec<double, 3>{});
  const double scale = weight == normal_weight::area ? detail::area_scale(m) : 1;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    detail::for_weighted_corners(m, f, weight, scale, [&](std::size_t k, const vec<double, 3>& n, double share) {
      unit[m.face_starts[f] + k] = n;
      weighted[m.face_starts[f] + k] =
          generate_coordinates<vec<double, 3>>([&](int i) { return product(n[i], share); });
    });

  detail::corner_groups groups(count);
  const auto ends = edge_ends(m);
  for (std::size_t i = 0, next = 0; i < ends.size(); i = next) {
    while (next < ends.size() && ends[next].from == ends[i].from && ends[next].to == ends[i].to) ++next;
    if (next - i != 2 || ends[i].leaves == ends[i + 1].leaves) continue;
    const std::uint32_t a = ends[i].corner, b = ends[i + 1].corner;
    const vec<double, 3> none{};
    if (unit[a] != none && unit[b] != none && angle_between(unit[a], unit[b]) <= widened(crease)) groups.join(a, b);
  }

  std::vector<vec<double, 3>> sum(count, vec<double, 3>{});
  for (std::uint32_t c = 0; c < count; ++c) sum[groups.of(c)] += weighted[c];
  std::vector<std::uint32_t> normal_of(count, no_index);
  std::vector<vec<T, 3>> added;  // the mesh is touched where there is memory for all of them
  for (std::uint32_t c = 0; c < count; ++c) {
    std::uint32_t& normal = normal_of[groups.of(c)];
    if (m.corners[c].normal != no_index || normal != no_index) continue;
    const vec<double, 3> n = normalized(sum[groups.of(c)]);
    normal = static_cast<std::uint32_t>(m.normals.size() + added.size());
    added.push_back(generate_coordinates<vec<T, 3>>([&](int i) { return converted<T>(n[i]); }));
  }
  m.normals.insert(m.normals.end(), added.begin(), added.end());
  for (std::uint32_t c = 0; c < count; ++c)
    if (m.corners[c].normal == no_index) m.corners[c].normal = normal_of[groups.of(c)];
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
