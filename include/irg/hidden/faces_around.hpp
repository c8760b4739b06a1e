// SPDX-License-Identifier: MIT
// faces_around: the faces of a mesh as they are seen from a point in all directions, in the six sides of a cube around
// it, ready for whatever finds out what hides what: visible_polygons for polygons, a hidden-surface method for ids.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/function_ref.hpp>
#include <irg/math/vec.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/raster/screen_face.hpp>
#if IRG_BODIES
#include <irg/math/mat.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/raster/projected_vertices.hpp>
#include <irg/raster/screen_mapping.hpp>
#include <irg/raster/screen_pieces.hpp>
#endif

namespace irg {

/// The cube around a point: how many pixels a side has, and how far off, along the axes, what is seen begins.
template <Floating T>
struct cube_options {
  int size = 1024;
  T near_distance = T(1) / T(1024);
  bool operator==(const cube_options&) const = default;
};

namespace detail::inline IRG_ABI {

// Right, up and forward of a side, as axes and their signs: towards x, -x, y, -y, z, -z.
struct cube_side {
  int right, right_sign, up, forward, forward_sign;
};
inline constexpr cube_side cube_sides[6] = {{1, -1, 2, 0, 1},  {1, 1, 2, 0, -1}, {0, 1, 2, 1, 1},
                                            {0, -1, 2, 1, -1}, {0, -1, 1, 2, 1}, {0, 1, 1, 2, -1}};

}  // namespace detail::inline IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void send_sides(const point<T, 3>& eye, const mesh<T>& m,
                        const function_ref<void(std::size_t, const std::vector<screen_face>&)>& sink,
                        const cube_options<T>& options);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// Calls sink(side, faces) for the six sides of a cube around a point: the faces of a mesh that its window, of size x
/// size pixels, may show, as a std::vector<screen_face>, with the numbers of the mesh's faces.
/// shape   sides 0 to 5, towards x, -x, y, -y, z, -z, not mirrored: z is up in the first four, y in the last two
/// needs   a mesh in which validate() finds no defect, 1 <= size <= 4096, 0 < near_distance; coordinates whose
///         differences from the eye are finite
/// gives   faces whose back is seen, too. What is nearer than near_distance along the axis of a side is cut off
/// exact   corners are rounded to a 256th of a pixel and depths to floats. For these, visible_polygons and the methods
///         of this chapter tell exactly what hides what; what shows less of itself may be lost, or found
/// cost    each vertex and triangle six times; allocates
template <Floating T, class Sink>
  requires std::invocable<Sink&, std::size_t, const std::vector<screen_face>&>
constexpr void faces_around(const point<T, 3>& eye, const mesh<T>& m, Sink&& sink,
                            const cube_options<T>& options = {}) {
  detail::send_sides(eye, m, as_function<void(std::size_t, const std::vector<screen_face>&)>(sink), options);
}
template <Floating T, class Sink>
  requires std::invocable<Sink&, std::size_t, const std::vector<screen_face>&>
[[deprecated("irg: faces_around(eye, mesh, sink, options)")]] constexpr void faces_around(
    const point<T, 3>& eye, const mesh<T>& m, const cube_options<T>& options, Sink&& sink) {
  faces_around(eye, m, sink, options);
}

/// The direction in which a place of a side, in pixels, is seen; its largest coordinate is 1 or -1.
/// needs   side < 6, 1 <= size
/// exact   within an ulp of 1 in each coordinate
[[nodiscard]] constexpr vec<double, 3> direction_of(int size, std::size_t side,
                                                    const point<double, 2>& place) noexcept {
  const detail::cube_side& s = detail::cube_sides[side];
  vec<double, 3> out{};
  out[s.right] = s.right_sign * (2 * place.x / size - 1);
  out[s.up] = 1 - 2 * place.y / size;
  out[s.forward] = s.forward_sign;
  return out;
}

/// The side of the cube that a direction meets, and where, in pixels; of several the first.
/// needs   a finite direction, not 0
[[nodiscard]] constexpr std::pair<std::size_t, point<double, 2>> place_of(int size,
                                                                          const vec<double, 3>& direction) noexcept {
  std::size_t best = 0;
  for (std::size_t i = 1; i < 6; ++i) {
    const detail::cube_side &s = detail::cube_sides[i], &b = detail::cube_sides[best];
    if (s.forward_sign * direction[s.forward] > b.forward_sign * direction[b.forward]) best = i;
  }
  const detail::cube_side& s = detail::cube_sides[best];
  const double distant = s.forward_sign * direction[s.forward], half = size / 2.0;
  return {best,
          {half + half * (s.right_sign * direction[s.right] / distant), half - half * (direction[s.up] / distant)}};
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail {
inline namespace IRG_ABI {

// The faces of triangles, with the numbers of the faces they were cut from, as the window of a side shows them.
template <Floating T>
constexpr std::vector<screen_face> faces_of_side(const mesh<T>& around, std::span<const std::uint32_t> numbers,
                                                 const cube_side& side, const cube_options<T>& options) {
  mat<T, 4, 4> to_clip{};
  to_clip(0, side.right) = static_cast<T>(side.right_sign);
  to_clip(1, side.up) = T(1);
  to_clip(2, 3) = options.near_distance;
  to_clip(3, side.forward) = static_cast<T>(side.forward_sign);
  const screen_mapping<T> mapping = map_to_screen<T>({options.size, options.size});
  const auto vertices = project_vertices<T>(std::span<const point<T, 3>>(around.positions), to_clip, mapping);
  std::vector<screen_face> out;
  for (std::size_t t = 0; t < around.face_count(); ++t) {
    hpoint<T, 3> corner[3];
    std::uint32_t v[3]{};
    std::uint8_t cut = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = around.corner(t, k).position;
      corner[k] = clip_position(vertices, v[k]);
      cut |= vertices.codes[v[k]].cut;
    }
    if (cut == 0) {
      out.push_back(make_screen_face(vertices.screen[v[0]], vertices.screen[v[1]], vertices.screen[v[2]], numbers[t]));
      continue;
    }
    const screen_pieces pieces = clip_to_screen(corner, mapping, numbers[t]);
    for (const screen_piece& p : pieces) out.push_back(p.face);
  }
  return out;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API void send_sides(const point<T, 3>& eye, const mesh<T>& m,
                        const function_ref<void(std::size_t, const std::vector<screen_face>&)>& sink,
                        const cube_options<T>& options) {
  IRG_EXPECTS(1 <= options.size && options.size <= 4096 && T(0) < options.near_distance);
  mesh<T> triangles = triangulated(m);
  for (point<T, 3>& p : triangles.positions) p = {p.x - eye.x, p.y - eye.y, p.z - eye.z};
  std::vector<std::uint32_t> numbers;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    numbers.resize(numbers.size() + m.face_size(f) - 2, static_cast<std::uint32_t>(f));
  for (std::size_t i = 0; i < 6; ++i) sink(i, faces_of_side<T>(triangles, numbers, cube_sides[i], options));
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
