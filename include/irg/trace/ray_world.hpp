// SPDX-License-Identifier: MIT
// ray_world: bodies and lights made ready for rays that are reflected, refracted and stopped by them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <irg/math/length.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/math/float_bits.hpp>
#include <irg/shade/light.hpp>
#include <irg/shade/material.hpp>
#include <irg/spatial/triangle_bvh.hpp>

namespace irg {

/// What a surface does with light beside Phong's model: the shares that it mirrors and lets through, and how much
/// slower light is behind it (1: what is transparent does not bend rays).
template <Floating T>
struct optics {
  rgb<T> mirrored{}, transmitted{};
  T index = T(1);
  bool operator==(const optics&) const = default;
};

/// A body for rays: triangles over shared vertices, counter-clockwise seen from outside.
/// shape   normals and positions are parallel; a normal that is 0 counts as its triangle's
/// needs   positions and normals that live as long as the world
template <Floating T>
struct traced_body {
  std::span<const point<T, 3>> positions{};
  std::span<const vec<T, 3>> normals{};
  std::span<const triangle_indices> triangles{};
  material<T> surface{};
  optics<T> optic{};
  rgb<T> emitted{};  // what its fronts shine with, for paths
};

/// A point of a surface as a ray meets it.
/// shape   normal, of length 1, is the surface's, and face its triangle's, both on the side that the ray comes from
template <Floating T>
struct surface_point {
  point<T, 3> at{};
  vec<T, 3> normal{}, face{};
  facing side = facing::front;
  std::uint32_t body = 0;
  T reach{};  // the largest coordinate near by, which `at` is rounded by
  bool operator==(const surface_point&) const = default;
};

namespace detail::inline IRG_ABI {

// A power of two that brings the largest coordinate of two vectors near 1, so that products of them neither overflow
// nor vanish at any scale; 0 where there is none.
template <class T>
IRG_INLINE constexpr T scale_of(const vec<T, 3>& a, const vec<T, 3>& b) noexcept {
  constexpr T least = (std::numeric_limits<T>::min)(), most = (std::numeric_limits<T>::max)();
  T largest = T(0);
  for (int axis = 0; axis < 3; ++axis) largest = maximum(largest, maximum(magnitude(a[axis]), magnitude(b[axis])));
  if (!(T(0) < largest && largest <= most)) return T(0);
  return converted<T>(normalizing_power_of_two(widened(maximum(largest, least))));
}

}  // namespace detail::inline IRG_ABI

/// Bodies, the light on them, and what rays see that meet none.
/// needs   lights that outlive the world
template <Floating T>
class ray_world {
public:
  constexpr ray_world() = default;

  /// gives   a world in which triangles with a corner that is NaN or infinite are not there
  /// exact   as build_bvh
  /// cost    as build_bvh
  template <Executor E = sequential>
  IRG_APART constexpr ray_world(std::vector<traced_body<T>> bodies, const lighting<T>& light,
                                const rgb<T>& background = {}, const E& executor = {})
      : light_(light), background_(background), bodies_(std::move(bodies)) {
    std::size_t count = 0;
    for (const traced_body<T>& b : bodies_) {
      first_.push_back(static_cast<std::uint32_t>(count));
      count += b.triangles.size();
      const rgb<T>& c = b.optic.transmitted;
      transparent_ = transparent_ || T(0) < c.r || T(0) < c.g || T(0) < c.b;
    }
    tree_ = triangle_bvh<T>(
        count, [this](std::size_t i) { return corners(static_cast<std::uint32_t>(i)); }, bvh_options{}, executor);
  }

  [[nodiscard]] IRG_INLINE constexpr const lighting<T>& light() const noexcept { return light_; }
  [[nodiscard]] IRG_INLINE constexpr const rgb<T>& background() const noexcept { return background_; }
  [[nodiscard]] IRG_INLINE constexpr const triangle_bvh<T>& triangles() const noexcept { return tree_; }
  [[nodiscard]] IRG_INLINE constexpr const traced_body<T>& body(std::uint32_t i) const noexcept { return bodies_[i]; }
  [[nodiscard]] IRG_INLINE constexpr std::uint32_t body_count() const noexcept {
    return static_cast<std::uint32_t>(bodies_.size());
  }
  /// Whether any body lets light through.
  [[nodiscard]] IRG_INLINE constexpr bool is_transparent() const noexcept { return transparent_; }

  /// The number of the first triangle of a body: triangles count through all of them.
  [[nodiscard]] IRG_INLINE constexpr std::uint32_t first_triangle(std::uint32_t body) const noexcept {
    return first_[body];
  }

  /// The body of a triangle.
  [[nodiscard]] IRG_APART constexpr std::uint32_t body_of(std::uint32_t triangle) const noexcept {
    const auto after = std::upper_bound(first_.begin(), first_.end(), triangle);
    return static_cast<std::uint32_t>(after - first_.begin()) - 1;
  }

  [[nodiscard]] IRG_APART constexpr std::array<point<T, 3>, 3> corners(std::uint32_t triangle) const noexcept {
    const std::uint32_t b = body_of(triangle);
    const auto [i, j, k] = bodies_[b].triangles[triangle - first_[b]].v;
    const auto& p = bodies_[b].positions;
    return {p[i], p[j], p[k]};
  }

  /// The point of a triangle with the weights of its second and third corner, seen from the side that is given.
  [[nodiscard]] IRG_APART constexpr surface_point<T> point_of(std::uint32_t triangle, T weight1, T weight2,
                                                              facing side) const noexcept {
    surface_point<T> s;
    s.body = body_of(triangle);
    s.side = side;
    const traced_body<T>& body = bodies_[s.body];
    const auto [i, j, k] = body.triangles[triangle - first_[s.body]].v;
    const point<T, 3>&a = body.positions[i], &b = body.positions[j], &c = body.positions[k];
    const vec<T, 3> ab = b - a, ac = c - a;
    s.at = a + (ab * weight1 + ac * weight2);
    for (int axis = 0; axis < 3; ++axis)
      s.reach = maximum(s.reach, maximum(magnitude(a[axis]), maximum(magnitude(b[axis]), magnitude(c[axis]))));
    const bool front = side == facing::front;
    const T scale = detail::scale_of(ab, ac);
    const vec<T, 3> face = normalized(cross(ab * scale, ac * scale));
    s.face = front ? face : -face;
    s.normal = s.face;
    if (body.normals.empty()) return s;
    const vec<T, 3>&n0 = body.normals[i], &n1 = body.normals[j], &n2 = body.normals[k];
    const vec<T, 3> first = front ? n0 : -n0, second = front ? n1 : -n1, third = front ? n2 : -n2;
    const vec<T, 3> mean = first + ((second - first) * weight1 + (third - first) * weight2);
    if (!(mean == vec<T, 3>{})) s.normal = normalized(mean);
    return s;
  }

  /// What a ray meets first.
  [[nodiscard]] IRG_APART constexpr std::optional<surface_point<T>> meet(const ray<T, 3>& r) const noexcept {
    const auto hit = closest_hit(tree_, r);
    if (!hit) return std::nullopt;
    return point_of(hit->triangle, static_cast<T>(hit->at.weight_b), static_cast<T>(hit->at.weight_c), hit->at.side);
  }

private:
  lighting<T> light_{};
  rgb<T> background_{};
  std::vector<traced_body<T>> bodies_;
  std::vector<std::uint32_t> first_;
  triangle_bvh<T> tree_;
  bool transparent_ = false;
};

}  // namespace irg
