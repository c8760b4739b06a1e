// SPDX-License-Identifier: MIT
// Path tracing: the light along a ray as the mean of random paths, for diffuse surfaces lit by each other and by
// surfaces that emit light.
//
// The estimator of one path: what the first surface emits; then at each surface of albedo k, up to `bounces` of them,
// the light of one place y sampled evenly on all emitters (next-event estimation),
//     throughput * k * L(y) * cos * cos' * area / (pi r^2)    where nothing is between,
// and a next direction sampled with the density cos / pi, along which throughput becomes throughput * k. What a next
// surface emits is not counted there: the place sampled before it stood for it. Its mean is the light that is reflected
// at most `bounces` times; the error of n paths falls as 1 / sqrt(n).
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <irg/trace/ray_world.hpp>
#if IRG_BODIES
#include <algorithm>
#include <cstddef>
#include <limits>

#include <irg/math/constants.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/trace/trace_ray.hpp>
#endif

namespace irg {

/// How paths are taken: how many for each ray, how often they are reflected, and which random numbers.
struct path_options {
  int paths = 64, bounces = 5;
  std::uint64_t seed = 1;
  bool operator==(const path_options&) const = default;
};

namespace detail {

// The triangles that shine.
template <class T>
struct path_emitters {
  std::vector<std::pair<T, std::uint32_t>> places{};  // the area up to and with each triangle
  T area = T(0), scale = T(0);  // areas are times scale^2
};

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API path_emitters<T> find_emitters(const ray_world<T>& world);
template <Floating T>
IRG_API rgb<T> mean_of_paths(const ray_world<T>& world, const path_emitters<T>& emitters, const ray<T, 3>& r,
                             const path_options& options, std::uint64_t stream) noexcept;

}  // namespace IRG_COMPILED_ABI
}  // namespace detail

/// A world made ready for paths: its emitters.
/// needs   a world that outlives it
template <Floating T>
class path_tracer {
public:
  IRG_APART constexpr explicit path_tracer(const ray_world<T>& world)
      : world_(world), emitters_(detail::find_emitters(world)) {}

  /// The light along a ray: the mean of its paths.
  /// shape   `stream` tells the random numbers of this ray from those of others: the number of its pixel
  /// gives   the background where a path leaves the world
  /// exact   the same bits for every compiler and executor, given seed and stream
  /// cost    2 (bounces + 1) rays for a path
  /// source  Kajiya 1986
  IRG_APART constexpr rgb<T> operator()(const ray<T, 3>& r, const path_options& options,
                                        std::uint64_t stream) const noexcept {
    return detail::mean_of_paths(world_, emitters_, r, options, stream);
  }

private:
  const ray_world<T>& world_;
  detail::path_emitters<T> emitters_;
};

}  // namespace irg

#if IRG_BODIES
namespace irg {
namespace detail::inline IRG_ABI {

// Numbers from 0 to 1, made of integers alone (SplitMix64 of Steele, Lea and Flood).
class path_numbers {
public:
  constexpr explicit path_numbers(std::uint64_t seed) noexcept : state_(seed) {}
  template <class T>
  constexpr T next() noexcept {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<T>((z ^ (z >> 31)) >> 40) * T(0x1p-24);
  }

private:
  std::uint64_t state_;
};

// A direction about a normal of length 1, with density cos / pi.
template <class T>
constexpr vec<T, 3> sample_cosine_hemisphere(const vec<T, 3>& n, T u, T v) noexcept {
  const vec<T, 3> other = magnitude(n.x) < T(0.5) ? vec<T, 3>{T(1), T(0), T(0)} : vec<T, 3>{T(0), T(1), T(0)};
  const vec<T, 3> x = normalized(cross(other, n)), y = cross(n, x);
  const T radius = sqrt(u), angle = v * T(2) * pi<T>;
  return x * (radius * cos(angle)) + y * (radius * sin(angle)) + n * sqrt(T(1) - u);
}

// What arrives of a place sampled on the emitters, over pi and over the density of the sample.
template <class T>
constexpr rgb<T> sample_light(const ray_world<T>& world, const path_emitters<T>& emitters, const point<T, 3>& from,
                              const vec<T, 3>& normal, path_numbers& numbers) noexcept {
  if (emitters.places.empty()) return {};
  const T where = numbers.next<T>() * emitters.area;
  const auto found = std::upper_bound(emitters.places.begin(), emitters.places.end() - 1, where,
                                      [](T a, const auto& place) { return a < place.first; });
  const std::uint32_t triangle = found->second;
  const T root = sqrt(numbers.next<T>()), v = numbers.next<T>();
  const surface_point<T> y = world.point_of(triangle, root * (T(1) - v), root * v, facing::front);
  const vec<T, 3> way = offset_origin(y, y.face) - from;
  const T scale = scale_of(way, way), larger = scale / emitters.scale;  // than that of areas
  const vec<T, 3> near_one = way * scale;
  const T distance = dot(near_one, near_one), cosine = dot(near_one, normal), back = -dot(near_one, y.face);
  if (!(T(0) < cosine) || !(T(0) < back) || any_hit(world.triangles(), ray<T, 3>{from, way, T(0), T(1)})) return {};
  const T weight = product(product(product(cosine, back), emitters.area) / product(product(distance, distance), pi<T>),
                           product(larger, larger));
  const rgb<T>& light = world.body(y.body).emitted;
  return {product(light.r, weight), product(light.g, weight), product(light.b, weight)};
}

template <class T>
constexpr rgb<T> light_of_path(const ray_world<T>& world, const path_emitters<T>& emitters, ray<T, 3> r, int bounces,
                               path_numbers& numbers) noexcept {
  rgb<T> sum{}, throughput{T(1), T(1), T(1)};
  for (int depth = 0;; ++depth) {
    const auto s = world.meet(r);
    if (!s) return sum + filtered_light(throughput, world.background());
    const traced_body<T>& body = world.body(s->body);
    if (depth == 0 && s->side == facing::front) sum = sum + body.emitted;
    if (depth >= bounces) return sum;
    throughput = filtered_light(throughput, body.surface.diffuse);
    const point<T, 3> from = offset_origin(*s, s->face);
    sum = sum + filtered_light(throughput, sample_light(world, emitters, from, s->face, numbers));
    const T u = numbers.next<T>(), v = numbers.next<T>();
    r = {from, sample_cosine_hemisphere(s->face, u, v)};
  }
}

}  // namespace detail::inline IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API path_emitters<T> find_emitters(const ray_world<T>& world) {
  path_emitters<T> out;
  const auto each_emitter = [&world](const auto& use) {
    for (std::uint32_t b = 0; b < world.body_count(); ++b) {
      const traced_body<T>& body = world.body(b);
      if (!(T(0) < greatest_channel(body.emitted))) continue;
      for (std::size_t i = 0; i < body.triangles.size(); ++i) {
        const std::uint32_t t = world.first_triangle(b) + static_cast<std::uint32_t>(i);
        const auto c = world.corners(t);
        use(t, c[1] - c[0], c[2] - c[0]);
      }
    }
  };
  each_emitter([&out](std::uint32_t, const vec<T, 3>& u, const vec<T, 3>& v) {
    const T scale = scale_of(u, v);
    if (T(0) < scale) out.scale = T(0) < out.scale ? minimum(scale, out.scale) : scale;
  });
  T rest = T(0);  // what rounding took from the sum
  each_emitter([&out, &rest](std::uint32_t t, const vec<T, 3>& u, const vec<T, 3>& v) {
    const T area = length(cross(u * out.scale, v * out.scale)) / T(2);
    if (!(area <= (std::numeric_limits<T>::max)())) return;  // a corner is no number: the triangle is not there
    const exact_sum<T> sum = two_sum(out.area, area + rest);
    out.area = sum.value, rest = sum.error;
    out.places.push_back({out.area, t});
  });
  return out;
}

template <Floating T>
IRG_API rgb<T> mean_of_paths(const ray_world<T>& world, const path_emitters<T>& emitters, const ray<T, 3>& r,
                             const path_options& options, std::uint64_t stream) noexcept {
  rgb<T> sum{};
  const int paths = options.paths < 1 ? 1 : options.paths;
  path_numbers numbers(options.seed * 0xd1342543de82ef95u + stream * 0x2545f4914f6cdd1du);
  for (int i = 0; i < paths; ++i) sum = sum + light_of_path(world, emitters, r, options.bounces, numbers);
  const T share = T(1) / static_cast<T>(paths);
  return {product(sum.r, share), product(sum.g, share), product(sum.b, share)};
}

}  // namespace detail::inline IRG_COMPILED_ABI
}  // namespace irg
#endif
