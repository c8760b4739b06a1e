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
#include <irg/raster/subpixel.hpp>
#if IRG_BODIES
#include <irg/raster/vertex_lanes.hpp>
#endif

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
constexpr void project_vertices(std::span<const point<T, 3>> positions, const mat<T, 4, 4>& to_clip,
                                const screen_mapping<T>& mapping, projected_vertices<T>& out, const E& executor = {});

/// The same of positions of other types, such as glm::vec3, which `out` keeps as points of T.
/// shape   anything with size() and [] that holds points; irg's own points of T stay where they are
/// exact   positions to the nearest T first
template <Floating T, SpaceRing A = std::span<const point<T, 3>>, Executor E = sequential>
  requires Floating<ring_scalar<A>>
constexpr void project_vertices(const A& positions, const mat<T, 4, 4>& to_clip, const screen_mapping<T>& mapping,
                                projected_vertices<T>& out, const E& executor = {}) {
  if constexpr (std::convertible_to<const A&, std::span<const point<T, 3>>>) {
    project_vertices(std::span<const point<T, 3>>(positions), to_clip, mapping, out, executor);
  } else {
    out.converted.clear();
    for (std::size_t k = 0; k < ring_size(positions); ++k) {
      const auto p = ring_vertex(positions, k);
      out.converted.push_back(generate_coordinates<point<T, 3>>([&](int i) { return converted<T>(coordinate(p, i)); }));
    }
    project_vertices(std::span<const point<T, 3>>(out.converted), to_clip, mapping, out, executor);
  }
}
template <Floating T, SpaceRing A = std::span<const point<T, 3>>, Executor E = sequential>
  requires Floating<ring_scalar<A>>
[[deprecated("irg: project_vertices(positions, to_clip, mapping, out, executor)")]] constexpr void project_vertices(
    projected_vertices<T>& out, const A& positions, const mat<T, 4, 4>& to_clip, const screen_mapping<T>& mapping,
    const E& executor = {}) {
  project_vertices(positions, to_clip, mapping, out, executor);
}

/// All positions, projected.
template <Floating T, SpaceRing A = std::span<const point<T, 3>>, Executor E = sequential>
  requires Floating<ring_scalar<A>>
[[nodiscard]] constexpr projected_vertices<T> project_vertices(const A& positions, const mat<T, 4, 4>& to_clip,
                                                               const screen_mapping<T>& mapping,
                                                               const E& executor = {}) {
  projected_vertices<T> v;
  project_vertices(positions, to_clip, mapping, v, executor);
  return v;
}

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void project_positions(std::span<const point<T, 3>> positions, const mat<T, 4, 4>& to_clip,
                               const screen_mapping<T>& mapping, projected_vertices<T>& out,
                               const executor_ref& executor);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <Floating T, Executor E>
constexpr void project_vertices(std::span<const point<T, 3>> positions, const mat<T, 4, 4>& to_clip,
                                const screen_mapping<T>& mapping, projected_vertices<T>& out, const E& executor) {
  detail::project_positions(positions, to_clip, mapping, out, as_executor(executor));
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg {
namespace detail::inline IRG_ABI {

// A range of vertices from the world to the screen, a register of them at a time. Bit for bit what to_screen and
// classify give one by one.

// snap() of a number that can be snapped, in every lane; whatever it gives for others is not used.
template <class T, int N>
IRG_INLINE pack<std::int32_t, N> snap_lanes(const pack<T, N>& pixels) noexcept {
  using F = lanes<pack<T, N>>;
  const auto scaled = pixels * F::broadcast(T(one_pixel));
  // Out of range the conversion is undefined in the language, though not on any machine: keep it in.
  const auto limit = F::broadcast(static_cast<T>(snap_limit) * T(one_pixel) / 2);
  const auto sane = minimum(maximum(scaled, F::broadcast(0) - limit), limit);
  const auto toward_zero = converted<std::int32_t>(sane);
  const auto rest = sane - converted<T>(toward_zero);
  return toward_zero - converted<std::int32_t>(rest >= F::broadcast(T(0.5))) +
         converted<std::int32_t>(rest < F::broadcast(T(-0.5)));
}

// Vertices on their way: where they come from, and where they go to.
template <class T>
struct vertex_range {
  screen_vertex* screen;
  clip_code_pair* codes;
  const point<T, 3>* positions;
  const mat<T, 4, 4>& to_clip;
  const screen_mapping<T>& mapping;

  constexpr clip_code_pair project_one(std::size_t i) const {
    const hpoint<T, 3> clip = to_clip * positions[i];
    codes[i] = clip_code(clip, mapping);
    screen[i] = codes[i].cut == 0 ? to_screen(clip, mapping) : screen_vertex{};
    return codes[i];
  }
};

// N vertices from number `first` on. The matrix' entries stand broadcast in m, row by row.
template <int N, class T>
IRG_INLINE clip_code_pair project_lanes(const vertex_range<T>& v, std::size_t first,
                                        const pack<T, N> (&m)[16]) noexcept {
  using F = lanes<pack<T, N>>;
  using pack_i = typename F::mask;
  using J = lanes<pack_i>;
  const screen_mapping<T>& mapping = v.mapping;
  static_assert(sizeof *v.positions == 3 * sizeof(T));
  const auto at = load_triples<N>(&v.positions[first].x);
  const auto row = [&](int r) { return ((m[r] * at.x + m[r + 1] * at.y) + m[r + 2] * at.z) + m[r + 3]; };
  const pack<T, N> cx = row(0), cy = row(4), cz = row(8), cw = row(12), zero = F::broadcast(0);

  const auto beyond = [&](const pack<T, N>& distance, clip_planes plane) {
    const auto bit = J::broadcast(static_cast<int>(plane));
    return bit - both(bit, distance >= zero);  // the bit where the distance is negative or NaN
  };
  const auto sides = [&](const pack<T, N>& across, const pack<T, N>& up) {
    return (beyond(across + cx, clip_planes::left) | beyond(across - cx, clip_planes::right)) |
           (beyond(up + cy, clip_planes::bottom) | beyond(up - cy, clip_planes::top));
  };
  const pack_i depth = beyond(cw - cz, clip_planes::z_near) | beyond(cz, clip_planes::z_far);
  const pack_i outside =
      depth | sides(F::broadcast(mapping.picture.guard_x) * cw, F::broadcast(mapping.picture.guard_y) * cw);
  const pack_i cut = depth | sides(F::broadcast(mapping.guard.guard_x) * cw, F::broadcast(mapping.guard.guard_y) * cw);
  const auto kept = cut == J::broadcast(0);

  // Where 1/w would overflow, one by one.
  clip_code_pair any;
  if (mask_bits(both(cw < F::broadcast((std::numeric_limits<T>::min)()), kept)) != 0) [[unlikely]] {
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) any = any | v.project_one(first + i);
    return any;
  }
  const pack<T, N> inverse = F::broadcast(1) / cw;
  const pack<T, N> sx = (cx * inverse) * F::broadcast(mapping.half_width) + F::broadcast(mapping.centre_x);
  const pack<T, N> sy = F::broadcast(mapping.centre_y) - (cy * inverse) * F::broadcast(mapping.half_height);
  const auto shown = converted<std::int32_t>(kept);
  const pack<T, N> limited = maximum(F::broadcast(T(0x1p-126)), minimum(inverse, F::broadcast(T(0x1p126))));
  const pack<T, N> z_screen = select(kept, cz * inverse, zero), w_screen = select(kept, limited, F::broadcast(1));
  store_vertices<N>(v.screen + first, {both(snap_lanes(sx), shown), both(snap_lanes(sy), shown),
                                       converted<float>(z_screen), converted<float>(w_screen)});
  static_assert(sizeof(clip_code_pair) == 2);
  const pack_i pairs = (outside << byte_shift<2>(0)) | (cut << byte_shift<2>(1));
  lanes<pack<std::uint16_t, N>>::store_bytes(v.codes + first, converted<std::uint16_t>(converted<std::int32_t>(pairs)));
  if (!all_lanes(pairs == J::broadcast(0)))
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) any = any | v.codes[first + i];
  return any;
}

// The vertices [first, last), and the planes that some of them are beyond.
template <class T>
constexpr clip_code_pair project_range(const vertex_range<T>& v, std::size_t first, std::size_t last) noexcept {
  clip_code_pair any;
  constexpr int count = native_lanes<T>;
  if (!std::is_constant_evaluated()) {
    pack<T, count> m[16];
    for (int k = 0; k < 16; ++k) m[k] = lanes<pack<T, count>>::broadcast(v.to_clip(k / 4, k % 4));
    for (; last - first >= static_cast<std::size_t>(count); first += static_cast<std::size_t>(count))
      any = any | project_lanes<count>(v, first, m);
  }
  for (; first < last; ++first) any = any | v.project_one(first);
  return any;
}

}  // namespace detail::inline IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void project_positions(std::span<const point<T, 3>> positions, const mat<T, 4, 4>& to_clip,
                               const screen_mapping<T>& mapping, projected_vertices<T>& out,
                               const executor_ref& executor) {
  constexpr std::size_t portion = 8192;
  const std::size_t n = positions.size();
  out.positions = positions;
  out.to_clip = to_clip;
  out.screen.resize(n, screen_vertex{});
  out.codes.resize(n, clip_code_pair{});
  std::vector<clip_code_pair> any((n + portion - 1) / portion, clip_code_pair{});
  executor(any.size(), [&](std::size_t i) {
    const std::size_t first = i * portion, last = minimum(first + portion, n);
    any[i] = project_range<T>({out.screen.data(), out.codes.data(), positions.data(), to_clip, mapping}, first, last);
  });
  out.any = {};
  for (const clip_code_pair& a : any) out.any = out.any | a;
}

}  // namespace detail::inline IRG_COMPILED_ABI
}  // namespace irg
#endif
