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
#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <irg/mesh/detail/rings.hpp>
#endif

namespace irg {

/// Whether the teapot stands open below, as Newell made it, or has the bottom that Crow added.
enum class teapot_bottom { without, with };

struct teapot_options {
  int subdivisions = 10;  // cells along each side of a patch; taken as 1 if less, as 1024 if more
  teapot_bottom bottom = teapot_bottom::with;
  bool operator==(const teapot_options&) const = default;
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
[[nodiscard]] constexpr std::array<bezier_patch<point<T, 3>>, 32> teapot_patches() noexcept;

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// The teapot as triangles with the patches' own normals.
/// shape   four surfaces with open borders (body, lid, handle, spout), which pass through each other as in the
///         original; y up, spout towards +x; 64*n*n - 8*n triangles for n subdivisions with bottom, 56*n*n - 4*n
///         without; counter-clockwise from outside; vertices on shared patch borders and at the poles are one
/// exact   positions as patch_sample: the mesh is its own mirror image in z bit for bit; normals as surface_normal, on
///         a shared border from the patch that begins there
/// cost    a patch sample per vertex
/// source  Newell 1975; see teapot_patches
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_teapot(const teapot_options& options = {});

}  // namespace IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

// Lengths in hundred-thousandths, in which every published decimal is an integer.
struct turned_row {
  int radius, corner, height;
};
struct tube_row {
  int x0, y0, x1, y1, half_width;
};

inline constexpr int teapot_unit = 100000;

// From the rim's inner edge over the body down to the middle of the bottom; every third row is shared by two patches.
inline constexpr std::array<turned_row, 13> teapot_body{{
    // rim
    {140000, 78400, 240000},
    {133750, 74900, 253125},
    {143750, 80500, 253125},
    {150000, 84000, 240000},
    // upper body
    {175000, 98000, 187500},
    {200000, 112000, 135000},
    {200000, 112000, 90000},
    // lower body
    {200000, 112000, 45000},
    {150000, 84000, 22500},
    {150000, 84000, 15000},
    // bottom
    {150000, 84000, 7500},
    {142500, 79800, 0},
    {0, 0, 0},
}};
// From the top of the knob to the lid's edge.
inline constexpr std::array<turned_row, 7> teapot_lid{{
    // knob
    {0, 0, 315000},
    {80000, 45000, 315000},
    {0, 0, 285000},
    {20000, 11200, 270000},
    // lid
    {40000, 22400, 255000},
    {130000, 72800, 255000},
    {130000, 72800, 240000},
}};
// From the rim round to the body; the first point of a row is on the inside of the bow.
inline constexpr std::array<tube_row, 7> teapot_handle{{
    {-160000, 202500, -150000, 225000, 30000},
    {-230000, 202500, -250000, 225000, 30000},
    {-270000, 202500, -300000, 225000, 30000},
    {-270000, 180000, -300000, 180000, 30000},
    {-270000, 157500, -300000, 135000, 30000},
    {-250000, 112500, -265000, 93750, 30000},
    {-200000, 90000, -190000, 60000, 30000},
}};
// From the body to the mouth and a little back inside; the first point of a row is on the upper side.
inline constexpr std::array<tube_row, 7> teapot_spout{{
    {170000, 142500, 170000, 60000, 66000},
    {260000, 142500, 310000, 82500, 66000},
    {230000, 210000, 240000, 202500, 25000},
    {270000, 240000, 330000, 240000, 25000},
    {280000, 247500, 352500, 249375, 25000},
    {290000, 247500, 345000, 251250, 15000},
    {280000, 240000, 320000, 240000, 15000},
}};

template <class T>
constexpr point<T, 3> teapot_point(int x, int y, int z) noexcept {
  const auto length = [](int n) { return static_cast<T>(n) / static_cast<T>(teapot_unit); };
  return {length(x), length(y), length(z)};
}

/// Control point i of a row's quarter ring, for quarter 0 to 3 about the y axis from x towards z.
template <class T>
constexpr point<T, 3> control_point_of(const turned_row& row, std::size_t quarter, std::size_t i) noexcept {
  const int x = i < 2 ? row.radius : i == 2 ? row.corner : 0;
  const int z = i > 1 ? row.radius : i == 1 ? row.corner : 0;
  if (quarter == 0) return teapot_point<T>(x, row.height, z);
  if (quarter == 1) return teapot_point<T>(-z, row.height, x);
  if (quarter == 2) return teapot_point<T>(-x, row.height, -z);
  return teapot_point<T>(z, row.height, -x);
}

/// Control point i of a row's half ring: side 0 has z >= 0, side 1 leads back with z <= 0.
template <class T>
constexpr point<T, 3> control_point_of(const tube_row& row, std::size_t side, std::size_t i) noexcept {
  const int z = i == 0 || i == 3 ? 0 : side == 0 ? row.half_width : -row.half_width;
  return (i < 2) == (side == 0) ? teapot_point<T>(row.x0, row.y0, z) : teapot_point<T>(row.x1, row.y1, z);
}

/// The patch whose control rows are rows[first] to rows[first + 3]: u leads round the ring, v from row to row.
template <class T, class Rows>
constexpr bezier_patch<point<T, 3>> teapot_patch(const Rows& rows, std::size_t first, std::size_t part) noexcept {
  bezier_patch<point<T, 3>> patch;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) patch.points[i][j] = control_point_of<T>(rows[first + j], part, i);
  return patch;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

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

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

/// Appends a body given by control rows and made of `parts` patches around and `chain` patches along.
template <class T, class Rows>
constexpr void add_teapot_part(mesh<T>& m, int n, const Rows& rows, int parts, int chain, ring_end first,
                               ring_end last) {
  add_rings(m, parts * n, chain * n, first, last, [&](int i, int j) {
    const int link = j == chain * n ? chain - 1 : j / n;
    const auto patch = teapot_patch<T>(rows, static_cast<std::size_t>(3 * link), static_cast<std::size_t>(i / n));
    const auto u = curve_fraction<T>(i % n, n), v = curve_fraction<T>(j - link * n, n);
    const auto sample = patch_sample(patch, u, v);
    return surface_vertex<T>{sample.point, surface_normal(sample, u, v).value_or(vec<T, 3>{})};
  });
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_teapot(const teapot_options& options) {
  using detail::ring_end;
  const int n = clamped(options.subdivisions, 1, 1024);
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

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
