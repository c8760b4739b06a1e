// SPDX-License-Identifier: MIT
// Shading by attributes: numbers given at the vertices (colours, texture coordinates, positions and normals), linear in
// between and corrected for perspective, and a function that makes a pixel of them. Because the function is the same
// for all triangles, pixels of different triangles are shaded together, a register of them at a time.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>

#include <irg/colour/pixel.hpp>
#include <irg/core/lanes.hpp>
#include <irg/raster/pixel_weights.hpp>
#include <irg/raster/triangle_batch.hpp>

namespace irg {

/// How pixels are made from the attributes of vertices.
///   attribute_count                       how many numbers a vertex has
///   attributes(batch, vertex, side)       pointer to them, for a triangle that shows this side; the numbers of all
///                                         vertices of a batch stand one after the other
///   pixel(array of attribute_count floats)                 the pixel
///   pixels(array of attribute_count packs), if it exists   the same for a register of pixels: their bits in 32 each
///   is_dear, if it exists and is true     pixels() costs more than finding out what is seen, and runs once for a
///                                         register, whatever triangles it shows
template <class S, class Batch>
concept AttributeShading = requires(const S& s, const Batch& batch) {
  requires S::attribute_count >= 1;
  { s.attributes(batch, std::uint32_t{}, facing::front) } -> std::same_as<const float*>;
  s.pixel(std::array<float, static_cast<std::size_t>(S::attribute_count)>{});
};

inline namespace IRG_ABI {

/// The attributes at a pixel of a triangle whose vertices have a, b and c.
template <int K, class F>
[[nodiscard]] IRG_INLINE constexpr std::array<F, static_cast<std::size_t>(K)> interpolate_attributes(
    const pixel_weights<F>& at, const float* a, const float* b, const float* c) noexcept {
  std::array<F, static_cast<std::size_t>(K)> v{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(K); ++i) v[i] = at.interpolate(a[i], b[i], c[i]);
  return v;
}

}  // namespace IRG_ABI

namespace detail {

template <class Shading>
inline constexpr bool is_dear = false;
template <class Shading>
  requires requires { Shading::is_dear; }
inline constexpr bool is_dear<Shading> = Shading::is_dear;

// The pixel shader of one triangle.
template <class Shading>
struct attribute_pixel_shader {
  const Shading& shading;
  const float *a, *b, *c;
  template <class F>
  IRG_INLINE constexpr auto values(const pixel_weights<F>& at) const noexcept {
    return interpolate_attributes<Shading::attribute_count>(at, a, b, c);
  }
  IRG_INLINE constexpr auto operator()(const pixel_weights<float>& at) const { return shading.pixel(values(at)); }
};

inline namespace IRG_ABI {

// N pixels as the shading makes them one by one.
template <int N, class Shading, std::size_t K>
pack<std::uint32_t, N> pixels_one_by_one(const Shading& shading, const std::array<pack<float, N>, K>& at) {
  return lanes<pack<std::uint32_t, N>>::generate([&](int i) {
    std::array<float, K> one;
    for (std::size_t j = 0; j < K; ++j) one[j] = at[j][i];
    return std::bit_cast<std::uint32_t>(shading.pixel(one));
  });
}

template <class T, class Shading>
IRG_INLINE constexpr attribute_pixel_shader<Shading> pixel_shader_of(const Shading& shading,
                                                                     const triangle_batch<T>& batch,
                                                                     std::uint32_t triangle, facing side) noexcept {
  const auto [a, b, c] = batch.triangles[triangle].v;
  return {shading, shading.attributes(batch, a, side), shading.attributes(batch, b, side),
          shading.attributes(batch, c, side)};
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
