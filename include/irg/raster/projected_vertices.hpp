// SPDX-License-Identifier: MIT
// The vertex stage: every position once to clip space, and where it is safely inside, on to the screen.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/core/ring.hpp>
#include <irg/raster/screen_mapping.hpp>

#include <irg/raster/detail/vertex_kernel.hpp>

namespace irg {

/// Vertices on their way to the screen. Arrays parallel to the positions; kept from picture to picture, they spare the
/// next one the allocation.
template <Floating T>
struct projected_vertices {
  std::span<const point<T, 3>> positions;  // where they come from; must outlive this
  mat<T, 4, 4> to_clip{};
  std::vector<screen_vertex> screen;  // valid where `cut` is none
  std::vector<clip_code_pair> codes;  // the planes that each vertex is beyond
  clip_code_pair any;  // the planes that some vertex is beyond
  std::vector<point<T, 3>>
      converted{};  // what `positions` shows where they were of another type, in copies too: move it
};

inline namespace IRG_ABI {

/// Vertex i in clip space.
template <Floating T>
[[nodiscard]] constexpr hpoint<T, 3> clip_position(const projected_vertices<T>& v, std::size_t i) noexcept {
  return v.to_clip * v.positions[i];
}

/// Projects all positions into `out`: classified, and on the screen where they are inside the guard band.
/// needs   positions that outlive `out`
/// exact   as to_screen and classify; NaN is beyond every plane, what else is not finite beyond a depth plane
/// cost    linear, in lanes; allocates what `out` lacks
template <Floating T, Executor E = sequential>
constexpr void project_vertices(projected_vertices<T>& out, std::span<const point<T, 3>> positions,
                                const mat<T, 4, 4>& to_clip, const screen_mapping<T>& mapping, const E& executor = {}) {
  constexpr std::size_t portion = 8192;
  const std::size_t n = positions.size();
  out.positions = positions;
  out.to_clip = to_clip;
  out.screen.resize(n, screen_vertex{});
  out.codes.resize(n, clip_code_pair{});
  std::vector<clip_code_pair> any((n + portion - 1) / portion, clip_code_pair{});
  executor(any.size(), [&](std::size_t i) {
    const std::size_t first = i * portion, last = lesser(first + portion, n);
    any[i] = detail::project_range<T>({out.screen.data(), out.codes.data(), positions.data(), to_clip, mapping}, first,
                                      last);
  });
  out.any = {};
  for (const clip_code_pair& a : any) out.any = out.any | a;
}

/// The same of positions of other types, such as glm::vec3, which `out` keeps as points of T.
/// shape   anything with size() and [] that holds points; irg's own points of T stay where they are
/// exact   positions to the nearest T first
template <Floating T, SpaceRing A, Executor E = sequential>
  requires Floating<ring_scalar<A>>
constexpr void project_vertices(projected_vertices<T>& out, const A& positions, const mat<T, 4, 4>& to_clip,
                                const screen_mapping<T>& mapping, const E& executor = {}) {
  if constexpr (std::convertible_to<const A&, std::span<const point<T, 3>>>) {
    project_vertices(out, std::span<const point<T, 3>>(positions), to_clip, mapping, executor);
  } else {
    out.converted.clear();
    for (std::size_t k = 0; k < ring_size(positions); ++k) {
      const auto p = ring_vertex(positions, k);
      out.converted.push_back(generate_coordinates<point<T, 3>>([&](int i) { return converted<T>(coordinate(p, i)); }));
    }
    project_vertices(out, std::span<const point<T, 3>>(out.converted), to_clip, mapping, executor);
  }
}

/// All positions, projected.
template <Floating T, Executor E = sequential>
[[nodiscard]] constexpr projected_vertices<T> project_vertices(std::span<const point<T, 3>> positions,
                                                               const mat<T, 4, 4>& to_clip,
                                                               const screen_mapping<T>& mapping,
                                                               const E& executor = {}) {
  projected_vertices<T> v;
  project_vertices(v, positions, to_clip, mapping, executor);
  return v;
}
template <Floating T, SpaceRing A, Executor E = sequential>
  requires Floating<ring_scalar<A>>
[[nodiscard]] constexpr projected_vertices<T> project_vertices(const A& positions, const mat<T, 4, 4>& to_clip,
                                                               const screen_mapping<T>& mapping,
                                                               const E& executor = {}) {
  projected_vertices<T> v;
  project_vertices(v, positions, to_clip, mapping, executor);
  return v;
}

}  // namespace IRG_ABI
}  // namespace irg
