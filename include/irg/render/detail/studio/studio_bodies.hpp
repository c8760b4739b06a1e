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

// The faces that have a surface, corners and positions as they are.
template <class T>
constexpr mesh<T> faces_of_surface(const mesh<T>& m, std::span<const std::uint32_t> surface_of_face,
                                   std::uint32_t surface, std::size_t surfaces) {
  mesh<T> out;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const bool without = surfaces <= surface_of_face[f];
    if (without ? surface != surfaces : surface_of_face[f] != surface) continue;
    for (std::size_t k = 0; k < m.face_size(f); ++k) out.corners.push_back(m.corner(f, k));
    out.face_starts.push_back(static_cast<std::uint32_t>(out.corners.size()));
  }
  if (out.face_count() == 0) return out;
  out.positions = m.positions;
  out.normals = m.normals;
  return out;
}

template <class T>
constexpr void place_body(placed_body<T>& p, const stored_body<T>& b, const mat<T, 4, 4>& placement) {
  if (p.source == b && p.placement == placement) return;
  p = {};
  p.source = b;
  p.placement = placement;
  p.shape = b.shape;
  p.can_be_seen = place_shape(p.shape, placement);
  if (!p.can_be_seen) return;
  mesh<T> smooth = p.shape;
  assign_vertex_normals(smooth, normal_weight::average);
  const auto surfaces = static_cast<std::uint32_t>(b.surfaces.size());
  for (std::uint32_t s = 0; s <= surfaces; ++s) {
    object<T> o{faces_of_surface<T>(smooth, b.surface_of_face, s, surfaces)};
    if (o.shape.face_count() == 0) continue;
    p.parts.push_back(prepare_object(o));
    p.surface_of_part.push_back(s);
  }
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
