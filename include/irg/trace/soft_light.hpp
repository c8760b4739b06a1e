// SPDX-License-Identifier: MIT
// Lamps with an extent: rods and panels, and what share of them is seen from a point: soft shadows.
#pragma once

#include <span>

#include <irg/trace/ray_world.hpp>
#if IRG_BODIES
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/shade/phong_model.hpp>
#include <irg/spatial/bvh_hits.hpp>
#include <irg/trace/trace_ray.hpp>
#endif

namespace irg {

/// A panel that shines: the parallelogram of two sides from a corner; a rod, where the second side is 0.
template <Floating T>
struct area_light {
  point<T, 3> corner{};
  vec<T, 3> first{}, second{};
  rgb<T> intensity{};
  bool operator==(const area_light&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// The share of the rod from a to b that is seen from p past the triangles of a world, whatever they let through.
/// gives   1 where p, a and b stand on a line and nothing is decided; triangles in the plane of the three hide nothing
/// exact   in closed form: no samples are taken. Off by some roundings, times the size of coordinates over that of the
///         triangle p, a, b
/// cost    the triangles whose boxes meet the box of p, a and b; allocates the parts that they hide
/// source  irg's own: what triangles hide of the rod, part by part
template <Floating T>
[[nodiscard]] IRG_API T lit_share_of_rod(const ray_world<T>& world, const point<T, 3>& p, const point<T, 3>& a,
                                         const point<T, 3>& b);

/// The light of a surface's own under panels and rods, beside that of the world's lamps: the mean of `samples` by
/// `samples` places of each panel, one to each of as many equal parts; a rod by the share of it that is seen.
/// gives   as many as 64 by 64 samples; a panel shines to both sides
/// exact   each place as a lamp there: what is between is decided as any_hit. The same bits everywhere
/// cost    samples^2 rays for each panel, a box for each rod
template <Floating T>
[[nodiscard]] IRG_API rgb<T> soft_light_of_surface(const ray_world<T>& world, const surface_point<T>& s,
                                                   const point<T, 3>& eye, std::span<const area_light<T>> lights,
                                                   int samples);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg {
namespace detail::inline IRG_ABI {

// What a triangle hides of the rod ab from p: the parts of it, 0 to 1. In the plane of p, a and b, with q = p + s (a -
// p) + t (b - p), a triangle is a piece of a line, of which the part with s, t >= 0 and s + t <= 1 hides t / (s + t).
// Vectors from p are times `scale`.
template <class T>
constexpr std::pair<T, T> hidden_part(const point<T, 3>& p, const vec<T, 3>& a, const vec<T, 3>& b, T scale,
                                      const std::array<point<T, 3>, 3>& corner) noexcept {
  const vec<T, 3> n = cross(a, b);
  const T size = dot(n, n);
  vec<T, 3> from_p[3];
  T height[3];
  for (std::size_t i = 0; i < 3; ++i) {
    from_p[i] = (corner[i] - p) * scale;
    height[i] = dot(n, from_p[i]);
  }
  T s[2]{}, t[2]{};
  int found = 0;
  for (std::size_t i = 0; i < 3 && found < 2; ++i) {
    const std::size_t k = (i + 1) % 3;
    if ((height[i] < T(0)) == (height[k] < T(0))) continue;
    const vec<T, 3> q = from_p[i] + (from_p[k] - from_p[i]) * (height[i] / (height[i] - height[k]));
    s[found] = dot(cross(q, b), n) / size;
    t[found] = dot(cross(a, q), n) / size;
    ++found;
  }
  if (found < 2) return {T(0), T(0)};
  T from = T(0), to = T(1);
  const auto keep = [&](T at_first, T at_second) {  // the part where this is not negative
    if (at_first < T(0) && at_second < T(0)) to = -T(1);
    if ((at_first < T(0)) == (at_second < T(0))) return;
    const T zero = at_first / (at_first - at_second);
    if (at_first < T(0))
      from = maximum(from, zero);
    else
      to = minimum(to, zero);
  };
  keep(s[0], s[1]);
  keep(t[0], t[1]);
  keep(T(1) - s[0] - t[0], T(1) - s[1] - t[1]);
  if (!(from < to)) return {T(0), T(0)};
  const auto seen_at = [&](T u) {
    const T x = s[0] + (s[1] - s[0]) * u, y = t[0] + (t[1] - t[0]) * u;
    return T(0) < x + y ? clamped(y / (x + y), T(0), T(1)) : T(0);
  };
  const T first = seen_at(from), last = seen_at(to);
  return {minimum(first, last), maximum(first, last)};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API T lit_share_of_rod(const ray_world<T>& world, const point<T, 3>& p, const point<T, 3>& a,
                                         const point<T, 3>& b) {
  const T scale = detail::scale_of(a - p, b - p);
  const vec<T, 3> to_a = (a - p) * scale, to_b = (b - p) * scale, n = cross(to_a, to_b);
  if (!(T(0) < dot(n, n))) return T(1);
  std::vector<std::pair<T, T>> hidden;
  each_in_box(world.triangles().tree(), bounding_box(bounding_box(box<T, 3>{p, p}, a), b), [&](std::uint32_t i) {
    const std::pair<T, T> part = detail::hidden_part(p, to_a, to_b, scale, world.corners(i));
    if (part.first < part.second) hidden.push_back(part);
  });
  std::sort(hidden.begin(), hidden.end());
  T dark = T(0), until = T(0);
  for (const auto& [from, to] : hidden) {
    if (until < to) dark = dark + (to - maximum(from, until));
    until = maximum(until, to);
  }
  return clamped(T(1) - dark, T(0), T(1));
}

template <Floating T>
[[nodiscard]] IRG_API rgb<T> soft_light_of_surface(const ray_world<T>& world, const surface_point<T>& s,
                                                   const point<T, 3>& eye, std::span<const area_light<T>> lights,
                                                   int samples) {
  const int n = clamped(samples, 1, 64);
  const material<T>& surface = world.body(s.body).surface;
  const point<T, 3> from = detail::offset_origin(s, s.face);
  const vec<T, 3> to_viewer = normalized(eye - s.at);
  rgb<T> sum{};
  for (const area_light<T>& lamp : lights) {
    const bool is_rod = lamp.second == vec<T, 3>{};
    const int rows = is_rod ? 1 : n;
    const T share = T(1) / static_cast<T>(n * rows);
    const T seen = is_rod ? lit_share_of_rod(world, from, lamp.corner, lamp.corner + lamp.first) : T(1);
    rgb<T> light{};
    for (int k = 0; k < n * rows; ++k) {
      const T u = (static_cast<T>(k % n) + T(0.5)) / static_cast<T>(n);
      const T v = (static_cast<T>(k / n) + T(0.5)) / static_cast<T>(rows);
      const vec<T, 3> to_light = (lamp.corner + (lamp.first * u + lamp.second * v)) - from;
      if (!(T(0) < dot(to_light, s.face))) continue;
      const rgb<T> arriving =
          is_rod ? lamp.intensity : detail::filtered_light(lamp.intensity, light_through(world, from, to_light, T(1)));
      light = light + reflected_light(surface, arriving, normalized(to_light), s.normal, to_viewer);
    }
    const T weight = product(share, seen);
    sum = sum + rgb<T>{product(light.r, weight), product(light.g, weight), product(light.b, weight)};
  }
  return sum;
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg
#endif
