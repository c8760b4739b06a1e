// SPDX-License-Identifier: MIT
// Textured surfaces without flicker: at each pixel the texture is sampled between the two levels of its pyramid whose
// texels are about as large there as the pixel, so that what is far away has its mean colour.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <span>

#include <irg/render/textured_shading.hpp>
#include <irg/render/weight_derivatives.hpp>
#include <irg/shade/texture_lanes.hpp>

namespace irg {

/// A texture at all sizes, and how its levels are sampled; a border is black.
struct texture_pyramid {
  const mip_pyramid<rgb<float>>* levels = nullptr;
  texture_sampler sampler{};
};

namespace detail {

// What the pixels of a picture's textures are made of: attributes as textured_shading's, and how u and v change.
struct mip_textured_pixels {
  std::span<const texture_pyramid> textures;
  template <class F>
  using values = std::array<F, 10>;

  constexpr mip_textured_pixels() = default;
  IRG_APART constexpr mip_textured_pixels(
      const std::convertible_to<std::span<const texture_pyramid>> auto& all) noexcept
      : textures(all) {}

  template <class F>
  IRG_INLINE static constexpr texture_derivatives_of<F> changes(const values<F>& at) noexcept {
    return {at[6], at[7], at[8], at[9]};
  }
  // The pyramid of a number; null where it has no levels.
  IRG_INLINE constexpr const texture_pyramid* pyramid(float number) const noexcept {
    const texture_pyramid& t = textures[texture_index(number, textures.size())];
    return t.levels == nullptr || t.levels->levels.empty() ? nullptr : &t;
  }
  IRG_INLINE constexpr rgba8 pixel(const std::same_as<values<float>> auto& at) const {
    if (textures.empty()) return encode({at[2], at[3], at[4]});
    const texture_pyramid* const t = pyramid(at[5]);
    if (t == nullptr) return encode({0, 0, 0});
    const image<rgb<float>>& whole = t->levels->levels[0];
    const rgb<float> texel = sample_mip_pyramid(
        *t->levels, {at[0], at[1], mip_level(changes(at), {whole.width(), whole.height()})}, t->sampler);
    return encode({product(texel.r, at[2]), product(texel.g, at[3]), product(texel.b, at[4])});
  }
  template <int N>
  IRG_APART pack<std::uint32_t, N> pixels(const values<pack<float, N>>& at) const {
    if (textures.empty()) return encode_lanes(at[2], at[3], at[4]);
    const texture_pyramid* const t = pyramid(at[5][0]);
    if (t == nullptr || !all_lanes(at[5] == lanes<pack<float, N>>::broadcast(at[5][0])))
      return pixels_one_by_one<N>(*this, at);
    const image<rgb<float>>& whole = t->levels->levels[0];
    const rgb<pack<float, N>> texel = sample_mip_pyramid<N>(
        *t->levels, {at[0], at[1], mip_level<N>(changes(at), {whole.width(), whole.height()})}, t->sampler);
    return encode_lanes(texel.r * at[2], texel.g * at[3], texel.b * at[4]);
  }
};

}  // namespace detail

/// The pixel shader of one textured triangle.
/// shape   a, b, c are its vertices
struct mip_textured_shader {
  const detail::mip_textured_pixels& shading;
  const float *a, *b, *c;
  weight_derivatives derivatives;

  /// What a pixel is made of.
  template <class F>
  [[nodiscard]] IRG_INLINE constexpr detail::mip_textured_pixels::values<F> values(
      const pixel_weights<F>& at) const noexcept {
    const auto v = interpolate_attributes<textured_shading::attribute_count>(at, a, b, c);
    const weight_changes<F> change = derivatives(at);
    return {v[0],
            v[1],
            v[2],
            v[3],
            v[4],
            v[5],
            change.right(a[0], b[0], c[0]),
            change.right(a[1], b[1], c[1]),
            change.down(a[0], b[0], c[0]),
            change.down(a[1], b[1], c[1])};
  }
  /// The level at a pixel for a texture of this size: mip_level of how u and v change there.
  [[nodiscard]] IRG_INLINE constexpr float level(const std::same_as<pixel_weights<float>> auto& at,
                                                 const extent2& texture) const noexcept {
    return mip_level(shading.changes(values(at)), texture);
  }
  [[nodiscard, deprecated("irg: level(weights, {width, height})")]] IRG_INLINE constexpr float level(
      const std::same_as<pixel_weights<float>> auto& at, int width, int height) const noexcept {
    return level(at, {width, height});
  }
  IRG_INLINE constexpr rgba8 operator()(const std::same_as<pixel_weights<float>> auto& at) const {
    return shading.pixel(values(at));
  }
};

/// Textured surfaces as a maker of pixel shaders for shade_batches and draw_transparent; as textured_shading, but with
/// the pyramids of the textures, and trilinear.
/// shape   objects[batch.object] belongs to a batch, its vertices to the batch's; textures are numbered from 0
/// needs   all that it names to outlive it; the mapping that the batches were projected with
/// gives   the light alone where there is no texture; the first texture for a number that is NaN or negative, the last
///         one for a number too large; a texture without levels is black
/// exact   the value of sample_mip_pyramid at mip_level, times the light, each channel rounded once, then encode()
/// cost    every triangle that is seen is set up alone
/// source  Williams 1983
template <Floating T>
struct mip_textured_shading {
  std::span<const textured_vertices> objects;
  detail::mip_textured_pixels textures;
  screen_mapping<T> mapping;

  IRG_INLINE constexpr mip_textured_shader operator()(const triangle_batch<T>& batch, std::uint32_t triangle,
                                                      facing side) const noexcept {
    const textured_shading plain{objects, {}};
    const auto [a, b, c] = batch.triangles[triangle].v;
    return {textures, plain.attributes(batch, a, side), plain.attributes(batch, b, side),
            plain.attributes(batch, c, side), make_weight_derivatives(batch, triangle, mapping)};
  }
};

}  // namespace irg
