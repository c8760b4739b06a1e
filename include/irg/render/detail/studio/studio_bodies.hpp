// SPDX-License-Identifier: MIT
// The bodies of the studio made ready for pictures, and kept as long as they stay the same.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/mesh/normals.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/scene/studio.hpp>

namespace irg {
namespace detail {

// A body in the world: its faces by surface, and where all its points are.
template <class T>
struct placed_body {
  stored_body<T> source;
  mat<T, 4, 4> placement;
  bool can_be_seen = false;
  mesh<T> shape;
  std::vector<prepared_object<T>> parts;
  std::vector<std::uint32_t> surface_of_part;  // the number of surfaces for faces without one
};

inline namespace IRG_ABI {

template <class T>
constexpr bool is_affine(const mat<T, 4, 4>& m) noexcept {
  return m(3, 0) == T(0) && m(3, 1) == T(0) && m(3, 2) == T(0) && m(3, 3) == T(1);
}

// The shape where the placement puts it; false when a point goes to infinity or behind the eye of a projection.
template <class T>
constexpr bool place_shape(mesh<T>& shape, const mat<T, 4, 4>& placement) {
  bool good = true;
  if (is_affine(placement)) {
    shape = transform_mesh(std::move(shape), placement);
  } else {
    for (point<T, 3>& p : shape.positions) {
      const hpoint<T, 3> q = placement * p;
      good = good && T(0) < q.w;
      p = {q.x / q.w, q.y / q.w, q.z / q.w};
    }
  }
  for (const point<T, 3>& p : shape.positions) good = good && is_finite(p);
  return good;
}

// The faces of a body put together by their surfaces, those without one last: of surface s from first[s] on.
struct faces_by_surface {
  std::vector<std::uint32_t> first, face;

  constexpr faces_by_surface(std::span<const std::uint32_t> surface_of_face, std::uint32_t surfaces)
      : first(surfaces + std::size_t{2}, 0u), face(surface_of_face.size(), 0u) {
    for (const std::uint32_t s : surface_of_face) ++first[lesser(s, surfaces) + std::size_t{1}];
    for (std::size_t s = 0; s <= surfaces; ++s) first[s + 1] += first[s];
    std::vector<std::uint32_t> next = first;
    for (std::uint32_t f = 0; f < face.size(); ++f) face[next[lesser(surface_of_face[f], surfaces)]++] = f;
  }
  constexpr std::span<const std::uint32_t> of(std::uint32_t surface) const noexcept {
    return {face.data() + first[surface], first[surface + 1] - first[surface]};
  }
};

// Some faces of a mesh that has a normal for each position, and the positions that they name. `number` has none for
// each position, before and after.
template <class T>
constexpr mesh<T> part_of_mesh(const mesh<T>& m, std::span<const std::uint32_t> faces,
                               std::vector<std::uint32_t>& number) {
  mesh<T> out;
  for (const std::uint32_t f : faces) {
    for (std::size_t k = 0; k < m.face_size(f); ++k) {
      const std::uint32_t p = m.corner(f, k).position;
      if (number[p] == mesh_corner::none) {
        number[p] = static_cast<std::uint32_t>(out.positions.size());
        out.positions.push_back(m.positions[p]);
        out.normals.push_back(m.normals[p]);
      }
      out.corners.push_back({number[p], number[p], mesh_corner::none});
    }
    out.face_starts.push_back(static_cast<std::uint32_t>(out.corners.size()));
  }
  for (const std::uint32_t f : faces)
    for (std::size_t k = 0; k < m.face_size(f); ++k) number[m.corner(f, k).position] = mesh_corner::none;
  return out;
}

template <class T>
constexpr void place_body(placed_body<T>& p, const stored_body<T>& b, const mat<T, 4, 4>& placement) {
  if (p.source == b && p.placement == placement) return;
  placed_body<T> made{b, placement, false, b.shape, {}, {}};  // `p` stays as it is if memory gives out
  made.can_be_seen = place_shape(made.shape, placement);
  const auto surfaces = static_cast<std::uint32_t>(b.surfaces.size());
  if (made.can_be_seen) {
    mesh<T> smooth = made.shape;
    assign_vertex_normals(smooth, normal_weight::average);
    const faces_by_surface faces(b.surface_of_face, surfaces);
    std::vector<std::uint32_t> number(smooth.positions.size(), mesh_corner::none);
    for (std::uint32_t s = 0; s <= surfaces; ++s) {
      if (faces.of(s).empty()) continue;
      made.parts.push_back(prepare_object(object<T>{part_of_mesh(smooth, faces.of(s), number)}));
      made.surface_of_part.push_back(s);
    }
  }
  p = std::move(made);
}

// What light does on a surface of a body, its colour in it.
template <class T>
constexpr material<T> studio_material(const stored_body<T>& b, std::uint32_t surface, studio_shading shading) noexcept {
  const stored_surface<T> s = surface < b.surfaces.size() ? b.surfaces[surface] : stored_surface<T>{};
  const rgb<float> light = decode(s.colour);
  const rgb<T> colour{static_cast<T>(light.r), static_cast<T>(light.g), static_cast<T>(light.b)};
  if (shading == studio_shading::none) return {colour, {}, {}, T(1)};
  const auto coloured = [&](const rgb<T>& share) {
    return rgb<T>{share.r * colour.r, share.g * colour.g, share.b * colour.b};
  };
  return {coloured(s.reflection.ambient), coloured(s.reflection.diffuse), s.reflection.specular,
          s.reflection.shininess};
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
