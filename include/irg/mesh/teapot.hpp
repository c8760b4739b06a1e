// SPDX-License-Identifier: MIT
// The Utah teapot: 32 bicubic Bezier patches, and their triangle mesh.
//
// Martin Newell's control points (1975) are usually printed as a list of 306 points and 32 rows of indices. Nearly all
// of that is repetition. Body, lid and bottom are turned: each control row is a ring about the axis whose quarter has
// the corners (r, 0), (r, c), (c, r), (0, r). Handle and spout are tubes that mirror each other in the plane of the
// drawing: each control row is a half ring (x0, y0, 0), (x0, y0, w), (x1, y1, w), (x1, y1, 0). The rows below are all
// there is.
#pragma once

#include <array>
#include <cstddef>

#include <irg/curve/bezier_surface.hpp>
#include <irg/mesh/detail/rings.hpp>
#include <irg/mesh/detail/teapot_steps.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// Whether the teapot stands open below, as Newell made it, or has the bottom that Crow added.
enum class teapot_bottom { without, with };

struct teapot_options {
  int subdivisions = 10;  // cells along each side of a patch; taken as 1 if less, as 1024 if more
  teapot_bottom bottom = teapot_bottom::with;
};

inline namespace IRG_ABI {

/// The 32 patches of the teapot, in the usual order: rim 0-3, body 4-11, handle 12-15, spout 16-19, lid 20-27, bottom
/// 28-31. Without the last four it is Newell's own.
/// shape   y up (the original's z), spout towards +x; du x dv points outward; from -3 to 3.525 in x, 0 to 3.15 in y
///         and -2 to 2 in z by control points
/// exact   each coordinate is the published decimal, rounded once
/// source  Newell 1975, with Blinn's flattened height; bottom: Crow 1987. The point at the top of the knob is taken
///         four times, as is usual; Newell's own list has neighbours of it that are 0.002 away
template <Real T>
[[nodiscard]] constexpr std::array<bezier_patch<point<T, 3>>, 32> teapot_patches() noexcept {
  std::array<bezier_patch<point<T, 3>>, 32> patches{};
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    for (std::size_t k = 0; k < 3; ++k)
      patches[4 * k + quarter] = detail::teapot_patch<T>(detail::teapot_body, 3 * k, quarter);
    for (std::size_t k = 0; k < 2; ++k)
      patches[20 + 4 * k + quarter] = detail::teapot_patch<T>(detail::teapot_lid, 3 * k, quarter);
    patches[28 + quarter] = detail::teapot_patch<T>(detail::teapot_body, 9, quarter);
  }
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t k = 0; k < 2; ++k) {
      patches[12 + 2 * k + side] = detail::teapot_patch<T>(detail::teapot_handle, 3 * k, side);
      patches[16 + 2 * k + side] = detail::teapot_patch<T>(detail::teapot_spout, 3 * k, side);
    }
  return patches;
}

/// The teapot as triangles with the patches' own normals.
/// shape   four surfaces with open borders (body, lid, handle, spout), which pass through each other as in the
///         original; y up, spout towards +x; 64*n*n - 8*n triangles for n subdivisions with bottom, 56*n*n - 4*n
///         without; counter-clockwise from outside; vertices on shared patch borders and at the poles are one
/// exact   positions as patch_sample: the mesh is its own mirror image in z bit for bit; normals as surface_normal, on
///         a shared border from the patch that begins there
/// cost    a patch sample per vertex
/// source  Newell 1975; see teapot_patches
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_teapot(const teapot_options& options = {}) {
  using detail::ring_end;
  const int n = detail::clamped(options.subdivisions, 1, 1024);
  mesh<T> m;
  if (options.bottom == teapot_bottom::with)
    detail::add_teapot_part(m, n, detail::teapot_body, 4, 4, ring_end::open, ring_end::pole);
  else
    detail::add_teapot_part(m, n, detail::teapot_body, 4, 3, ring_end::open, ring_end::open);
  detail::add_teapot_part(m, n, detail::teapot_handle, 2, 2, ring_end::open, ring_end::open);
  detail::add_teapot_part(m, n, detail::teapot_spout, 2, 2, ring_end::open, ring_end::open);
  detail::add_teapot_part(m, n, detail::teapot_lid, 4, 2, ring_end::pole, ring_end::open);
  return m;
}

}  // namespace IRG_ABI
}  // namespace irg
