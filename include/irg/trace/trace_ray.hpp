// SPDX-License-Identifier: MIT
// trace_ray: the light that comes along a ray. At each surface Phong's model, lamps being hidden by what stands
// between; to it come what a mirror reflects and what glass lets through, by rays of their own, up to a depth.
#pragma once

#include <limits>
#include <optional>

#include <irg/math/sqrt.hpp>
#include <irg/trace/ray_world.hpp>
#if IRG_BODIES
#include <cstddef>

#include <irg/shade/phong_model.hpp>
#endif

namespace irg {

/// Whether lamps throw shadows.
enum class shadow_rays { on, off };

/// How far rays are followed: so many times reflected or refracted, 0 to 32, and no further when less than this share
/// of what they bring would be seen. A pixel takes at most 2^(bounces + 1) rays.
template <Floating T>
struct trace_options {
  int bounces = 6;
  T least_share = T(1) / T(1024);
  shadow_rays shadows = shadow_rays::on;
  bool operator==(const trace_options&) const = default;
};

namespace detail::inline IRG_ABI {

template <class T>
IRG_INLINE constexpr rgb<T> filtered_light(const rgb<T>& a, const rgb<T>& b) noexcept {
  return {product(a.r, b.r), product(a.g, b.g), product(a.b, b.b)};
}

template <class T>
IRG_INLINE constexpr T greatest_channel(const rgb<T>& a) noexcept {
  return maximum(a.r, maximum(a.g, a.b));
}

// A point beside the surface, on the side of a normal of length 1: farther than what the point was rounded by.
template <class T>
IRG_INLINE constexpr point<T, 3> offset_origin(const surface_point<T>& s, const vec<T, 3>& face) noexcept {
  constexpr T roundings = 32;
  return s.at + face * (product(s.reach, std::numeric_limits<T>::epsilon()) * roundings);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The direction in which light of direction d, of length 1, goes on behind a surface, `ratio` times as slow as before
/// it. The normal is on the side that the light comes from.
/// gives   nothing where it is reflected whole
/// source  Whitted 1980
template <Floating T>
[[nodiscard]] constexpr std::optional<vec<T, 3>> refracted_direction(const vec<T, 3>& d, const vec<T, 3>& normal,
                                                                     T ratio) noexcept {
  const T c = -dot(d, normal), under = T(1) - product(product(ratio, ratio), T(1) - product(c, c));
  if (!(T(0) <= under)) return std::nullopt;
  return normalized(d * ratio + normal * (product(ratio, c) - sqrt(under)));
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// What of a lamp's light arrives at a point beside a surface: 1 in each channel where nothing is between, 0 behind
/// something opaque, and what transparent bodies let through, straight on.
/// shape   to_light as direction_to_light gives it; `share` is the part of it at which the lamp stands, infinity for
///         lamps that are infinitely far away
/// exact   what is between, as any_hit
template <Floating T>
[[nodiscard]] IRG_API rgb<T> light_through(const ray_world<T>& world, const point<T, 3>& from,
                                           const vec<T, 3>& to_light, T share) noexcept;

/// The light of a surface's own: Phong's model with the lamps that reach it, as an eye sees it.
/// gives   what phong_model gives, bit by bit, where shadows are off. A lamp behind the triangle does not reach it
template <Floating T>
[[nodiscard]] IRG_API rgb<T> light_of_surface(const ray_world<T>& world, const surface_point<T>& s,
                                              const point<T, 3>& eye, shadow_rays shadows = shadow_rays::on) noexcept;

/// The light that comes from a surface's point to an eye: its own, and what it mirrors and lets through.
/// shape   as trace_ray, for a point that is known
template <Floating T>
[[nodiscard]] IRG_API rgb<T> trace_from(const ray_world<T>& world, const surface_point<T>& s, const point<T, 3>& eye,
                                        const trace_options<T>& limits = {}) noexcept;

/// The light that comes along a ray to its origin.
/// gives   the background where it meets nothing; never NaN for finite worlds, unless light times what surfaces leave
///         of it overflows: a lamp of 10^200 on a surface that reflects 10^200 of it, in a mirror without blue. A ray
///         that begins within glass leaves it as one from outside would have entered. Behind the last bounce a surface
///         shows its own light alone
/// exact   which triangles are met, in every order of bodies; light is made of + - * / and square roots in one order:
///         the same bits everywhere
/// cost    at most 2^(bounces + 1) rays, and for each one to every lamp; nothing allocated
/// source  Whitted 1980
template <Floating T>
[[nodiscard]] IRG_API rgb<T> trace_ray(const ray_world<T>& world, const ray<T, 3>& r,
                                       const trace_options<T>& limits = {}) noexcept;

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg {
inline namespace IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API rgb<T> light_through(const ray_world<T>& world, const point<T, 3>& from,
                                           const vec<T, 3>& to_light, T share) noexcept {
  const ray<T, 3> r{from, to_light, T(0), share};
  rgb<T> through{T(1), T(1), T(1)};
  if (!world.is_transparent()) return any_hit(world.triangles(), r) ? rgb<T>{} : through;
  all_hits(world.triangles(), r, [&](const triangle_hit& hit) {
    through = detail::filtered_light(through, world.body(world.body_of(hit.triangle)).optic.transmitted);
  });
  return through;
}

template <Floating T>
[[nodiscard]] IRG_API rgb<T> light_of_surface(const ray_world<T>& world, const surface_point<T>& s,
                                              const point<T, 3>& eye, shadow_rays shadows) noexcept {
  const material<T>& surface = world.body(s.body).surface;
  if (shadows == shadow_rays::off) return phong_model(surface, world.light(), eye, {s.at, s.normal});
  const point<T, 3> from = detail::offset_origin(s, s.face);
  return phong_model(surface, world.light(), eye, {s.at, s.normal}, [&](std::size_t i, const rgb<T>& emitted) {
    const light<T>& source = world.light().lights[i];
    const vec<T, 3> to_light = direction_to_light(source, from);
    const T w = source.position.w, size = magnitude(w);
    if (!(T(0) < dot(to_light, s.face)) || !(T(0) < dot(to_light, s.normal))) return rgb<T>{};
    const T share = w == T(0) ? std::numeric_limits<T>::infinity() : T(1) / size;
    return detail::filtered_light(emitted, light_through(world, from, to_light, share));
  });
}

}  // namespace IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

template <class T>
struct pending_ray {
  ray<T, 3> r{};
  rgb<T> throughput{};
  int bounces = 0;
};

// The rays that a point sends on, into push(ray, throughput).
template <class T, class Push>
constexpr void send_on(const ray_world<T>& world, const surface_point<T>& s, const vec<T, 3>& direction,
                       const Push& push) noexcept {
  const optics<T>& optic = world.body(s.body).optic;
  const vec<T, 3> d = normalized(direction);
  rgb<T> mirrored = optic.mirrored;
  const bool passes = T(0) < greatest_channel(optic.transmitted);
  if (passes) {
    const T ratio = s.side == facing::front ? T(1) / optic.index : optic.index;
    const auto inside = refracted_direction(d, s.normal, ratio);
    if (!inside)
      mirrored = mirrored + optic.transmitted;
    else if (dot(*inside, s.face) < T(0))
      push(ray<T, 3>{offset_origin(s, -s.face), *inside}, optic.transmitted);
  }
  if (!(T(0) < greatest_channel(mirrored))) return;
  vec<T, 3> back = d - s.normal * (dot(d, s.normal) * T(2));
  if (!(T(0) < dot(back, s.face))) back = d - s.face * (dot(d, s.face) * T(2));
  push(ray<T, 3>{offset_origin(s, s.face), back}, mirrored);
}

// The light of all pending rays and of those that they send on.
template <class T, std::size_t Size>
constexpr rgb<T> light_of_pending(const ray_world<T>& world, pending_ray<T> (&pending)[Size], std::size_t count,
                                  const trace_options<T>& limits) noexcept {
  rgb<T> sum{};
  while (count > 0) {
    const pending_ray<T> next = pending[--count];
    const auto s = world.meet(next.r);
    if (!s) {
      sum = sum + filtered_light(next.throughput, world.background());
      continue;
    }
    sum = sum + filtered_light(next.throughput, light_of_surface(world, *s, next.r.origin, limits.shadows));
    if (next.bounces <= 0) continue;
    send_on(world, *s, next.r.direction, [&](const ray<T, 3>& r, const rgb<T>& throughput) {
      const rgb<T> whole = filtered_light(next.throughput, throughput);
      if (count < Size && limits.least_share <= greatest_channel(whole))
        pending[count++] = {r, whole, next.bounces - 1};
    });
  }
  return sum;
}

inline constexpr int most_bounces = 32;

}  // namespace detail::inline IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API rgb<T> trace_from(const ray_world<T>& world, const surface_point<T>& s, const point<T, 3>& eye,
                                        const trace_options<T>& limits) noexcept {
  rgb<T> sum = light_of_surface(world, s, eye, limits.shadows);
  const int bounces = limits.bounces < detail::most_bounces ? limits.bounces : detail::most_bounces;
  if (bounces <= 0) return sum;
  detail::pending_ray<T> pending[detail::most_bounces + 2]{};
  std::size_t count = 0;
  detail::send_on(world, s, s.at - eye, [&](const ray<T, 3>& r, const rgb<T>& throughput) {
    if (limits.least_share <= detail::greatest_channel(throughput)) pending[count++] = {r, throughput, bounces - 1};
  });
  return sum + detail::light_of_pending(world, pending, count, limits);
}

template <Floating T>
[[nodiscard]] IRG_API rgb<T> trace_ray(const ray_world<T>& world, const ray<T, 3>& r,
                                       const trace_options<T>& limits) noexcept {
  const auto s = world.meet(r);
  return s ? trace_from(world, *s, r.origin, limits) : world.background();
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg
#endif
