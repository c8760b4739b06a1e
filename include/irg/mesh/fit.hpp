// SPDX-License-Identifier: MIT
// Fits a body into the cube [-1, 1]^3: its box is moved to the origin and scaled until the longest edge has length 2.
// Several bodies are fitted one by one, then scaled and placed.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/geometry/box.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// What the extents of a body allow.
enum class [[nodiscard]] fit_status {
  ok,          // the longest edge becomes 2
  empty,           // no positions: nothing to do
  all_sizes_zero,  // all positions coincide, or are so close that the scale would overflow: moved, not scaled
  not_finite,      // a coordinate is NaN or infinite: left alone
  fitted [[deprecated("irg: fitted is now ok")]] = ok
};

/// The map p -> (p - centre) * scale, and how it came about.
template <Floating T>
struct fit {
  point<T, 3> centre;
  T scale = 1;
  fit_status status = fit_status::empty;
  bool operator==(const fit&) const = default;
};

/// Where a fitted body goes: p -> p * scale + position.
template <Floating T>
struct placement {
  T scale = 1;
  point<T, 3> position;
  bool operator==(const placement&) const = default;
};

inline namespace IRG_ABI {

/// The map that fits a box into [-1, 1]^3.
/// gives   a map that does nothing for a box that is empty or not finite; a scale of 1 when all sizes are zero
/// exact   the centre rounded once, the scale twice: within 2u (once more each for boxes wider than half the range; the
///         scale within 9u where the longest edge is within 1024 times the smallest normal number)
/// source  Mihajlovic 2016, 7.2: centre (max + min)/2, scale 2/max(size)
template <Floating T>
[[nodiscard]] constexpr fit<T> fit_of(const box<T, 3>& extents) noexcept {
  if (extents.empty()) return {};
  T half_size = 0;
  for (int i = 0; i < 3; ++i) {
    if (!is_finite(extents.low[i]) || !is_finite(extents.high[i])) return {{}, 1, fit_status::not_finite};
    half_size = maximum(half_size, extents.high[i] / 2 - extents.low[i] / 2);
  }
  const bool has_scale = half_size > 1 / (std::numeric_limits<T>::max)();
  return {centre(extents), has_scale ? 1 / half_size : T(1), has_scale ? fit_status::ok : fit_status::all_sizes_zero};
}

/// The map that fits a mesh's positions, used by faces or not, into [-1, 1]^3.
/// gives   not_finite when any coordinate is NaN or infinite
/// exact   as fit_of a box
/// cost    two passes over the positions
template <Mesh M>
  requires(size_of<typename mesh_traits<M>::point> == 3 && Floating<scalar_of<typename mesh_traits<M>::point>>)
[[nodiscard]] constexpr auto fit_of(const M& m) noexcept -> fit<scalar_of<typename mesh_traits<M>::point>> {
  for (std::size_t v = 0; v < mesh_traits<M>::vertex_count(m); ++v)
    for (int i = 0; i < 3; ++i)
      if (!is_finite(coordinate(mesh_traits<M>::position(m, v), i))) return {{}, 1, fit_status::not_finite};
  return fit_of(bounding_box(m));
}

/// Where a fit takes a point.
/// exact   difference and product rounded once each: points of the fitted box come within 4u of [-1, 1], u = 2^-53 or
///         2^-24 (two bits worse where the box is wider than half the largest number, or its longest edge is within
///         1024 times the smallest normal one: subnormal numbers have fewer digits). The rounded centre adds u times
///         its largest coordinate over half the longest edge: 1 at most, where the box is from a number to the next
template <Floating T>
[[nodiscard]] constexpr point<T, 3> fitted(const point<T, 3>& p, const fit<T>& f) noexcept {
  return to_point((p - f.centre) * f.scale);
}

/// Where a placement takes a point.
/// exact   product and sum rounded once each
template <Floating T>
[[nodiscard]] constexpr point<T, 3> placed(const point<T, 3>& p, const placement<T>& where) noexcept {
  return where.position + to_vec(p) * where.scale;
}

/// Fits a mesh into [-1, 1]^3. Its normals stay right: it is moved and scaled alike on all axes.
/// gives   the status; the mesh is unchanged when it is empty or not finite
/// exact   as fitted
template <Floating T>
constexpr fit_status fit_mesh(mesh<T>& m) noexcept {
  const fit<T> f = fit_of(m);
  if (f.status == fit_status::ok || f.status == fit_status::all_sizes_zero)
    for (point<T, 3>& p : m.positions) p = fitted(p, f);
  return f.status;
}

/// Fits each mesh by itself into [-1, 1]^3, then scales and places it.
/// needs   as many placements as meshes
/// gives   one status per mesh; a mesh that is empty or not finite is left as it is
/// exact   as fitted, then placed
/// source  Mihajlovic 2016, 7.2
template <Floating T>
constexpr std::vector<fit_status> fit_each(std::span<mesh<T>> meshes, std::span<const placement<T>> placements) {
  IRG_EXPECTS(meshes.size() == placements.size());
  std::vector<fit_status> statuses(meshes.size(), fit_status::empty);
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    statuses[k] = fit_mesh(meshes[k]);
    if (statuses[k] == fit_status::ok || statuses[k] == fit_status::all_sizes_zero)
      for (point<T, 3>& p : meshes[k].positions) p = placed(p, placements[k]);
  }
  return statuses;
}

}  // namespace IRG_ABI
}  // namespace irg
