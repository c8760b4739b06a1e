// SPDX-License-Identifier: MIT
// Three ways to spread the reflection model over a picture, as callables that a renderer calls per face, per vertex or
// per pixel. They differ in where the model is evaluated and in what is interpolated between:
//
//   flat_shader      once per face, at its centre                    nothing: the face has one colour
//   gouraud_shader   once per vertex, with the vertex normal         colours, linearly over the triangle
//   phong_shader     at every pixel                                  positions and normals
//
// Positions and normals, eye and lights are in one coordinate system, before any projection.
#pragma once

#include <cstddef>

#include <irg/core/ring.hpp>
#include <irg/shade/phong_model.hpp>

namespace irg {

inline namespace IRG_ABI {

/// The mean of the vertices of a polygon; the centroid of a triangle.
/// needs   a ring that is not empty
/// exact   the sum in the order of the vertices, then one division; each rounded once
template <PolygonRing R>
[[nodiscard]] constexpr typename ring_traits<R>::point vertex_mean(const R& ring) noexcept {
  using point_type = typename ring_traits<R>::point;
  using T = scalar_of<point_type>;
  const std::size_t n = ring_size(ring);
  return generate_coordinates<point_type>([&](int axis) {
    T sum = coordinate(ring_vertex(ring, 0), axis);
    for (std::size_t i = 1; i < n; ++i) sum = sum + coordinate(ring_vertex(ring, i), axis);
    return sum / static_cast<T>(n);
  });
}

}  // namespace IRG_ABI

/// Constant shading: one intensity for a whole face, from its centre and its normal.
/// needs   lights that outlive the shader
/// source  Bouknight 1970
template <Floating T, class L = rgb<T>>
struct flat_shader {
  material<T, L> surface;
  lighting<T, L> light;
  point<T, 3> eye;

  /// The intensity of a face.
  /// needs   an outward normal, of any length; where it is 0, the ambient term comes out
  template <PolygonRing R>
  IRG_INLINE constexpr L operator()(const R& face, const vec<T, 3>& normal) const noexcept {
    return (*this)(vertex_mean(face), normal);
  }
  /// The intensity of a face whose centre is known.
  IRG_INLINE constexpr L operator()(const point<T, 3>& centre, const vec<T, 3>& normal) const noexcept {
    return phong_model(surface, light, eye, {centre, normalized(normal)});
  }
};

/// Gouraud shading: the intensity at a vertex; the rasterizer interpolates intensities.
/// needs   lights that outlive the shader
/// source  Gouraud 1971
template <Floating T, class L = rgb<T>>
struct gouraud_shader {
  material<T, L> surface;
  lighting<T, L> light;
  point<T, 3> eye;

  /// The intensity at a vertex.
  /// needs   the vertex's outward normal, of any length; where it is 0, the ambient term comes out
  IRG_INLINE constexpr L operator()(const point<T, 3>& vertex, const vec<T, 3>& normal) const noexcept {
    return phong_model(surface, light, eye, {vertex, normalized(normal)});
  }
};

/// Phong shading: the intensity at a pixel; the rasterizer interpolates positions and normals.
/// needs   lights that outlive the shader
/// source  Phong 1975
template <Floating T, class L = rgb<T>>
struct phong_shader {
  material<T, L> surface;
  lighting<T, L> light;
  point<T, 3> eye;

  /// The intensity at a point inside a face.
  /// needs   the interpolated normal, of any length: interpolation shortens normals, here they are renormalised
  IRG_INLINE constexpr L operator()(const point<T, 3>& p, const vec<T, 3>& interpolated_normal) const noexcept {
    return phong_model(surface, light, eye, {p, normalized(interpolated_normal)});
  }
};

}  // namespace irg
