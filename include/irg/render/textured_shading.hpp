// SPDX-License-Identifier: MIT
// Textured surfaces: texture coordinates and light given at the vertices, linear in between and corrected for
// perspective; a pixel is the light times what the texture holds there.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <irg/colour/srgb_lanes.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/attribute_shading.hpp>
#include <irg/shade/texture_lanes.hpp>

namespace irg {

/// A picture as a texture, and how it is sampled; a border is black.
struct texture_image {
  image_view<const rgba8> texels;
  texture_sampler sampler{};
};

/// What a vertex of a textured surface has: u, v, the light that meets it (red, green, blue), and the number of its
/// texture, the same at the three vertices of a triangle.
using textured_vertex = std::array<float, 6>;

inline namespace IRG_ABI {

/// A vertex with texture coordinates and light.
[[nodiscard]] IRG_INLINE constexpr textured_vertex make_textured_vertex(float u, float v,
                                                                        const rgb<float>& light = {1, 1, 1},
                                                                        int texture = 0) noexcept {
  return {u, v, light.r, light.g, light.b, static_cast<float>(texture)};
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Which of the textures a number means.
// needs   count > 0
IRG_INLINE constexpr std::size_t texture_index(float number, std::size_t count) noexcept {
  const float last = static_cast<float>(count - 1);  // rounded up, maybe, beyond 2^24
  return minimum(static_cast<std::size_t>(clamped(number, 0.0f, last)), count - 1);
}

}  // namespace detail::inline IRG_ABI

/// The vertices of one object, lit from outside and, where backs are shown, from inside; without `back` alike.
struct textured_vertices {
  std::span<const textured_vertex> front, back{};
};

/// Textured surfaces as an AttributeShading.
/// shape   objects[batch.object] belongs to a batch, its vertices to the batch's; textures are numbered from 0
/// needs   all that it names to outlive it
/// gives   the light alone where there is no texture; the first texture for a number that is NaN or negative, the last
///         one for a number too large; a texture without texels is black
/// exact   the value of sample_texture, times the light, each channel rounded once, then encode(); the same in lanes
struct textured_shading {
  static constexpr int attribute_count = 6;
  static constexpr bool is_dear = true;
  std::span<const textured_vertices> objects;
  std::span<const texture_image> textures;

  template <class Batch>
  [[nodiscard]] IRG_INLINE constexpr const float* attributes(const Batch& batch, std::uint32_t vertex,
                                                             facing side) const noexcept {
    const textured_vertices& v = objects[batch.object];
    return (side == facing::back && !v.back.empty() ? v.back : v.front)[vertex].data();
  }

  template <class Vertex = textured_vertex>
  [[nodiscard]] IRG_INLINE constexpr rgba8 pixel(const Vertex& at) const noexcept {
    const auto [u, v, r, g, b, number] = at;
    if (textures.empty()) return encode({r, g, b});
    const texture_image& t = textures[detail::texture_index(number, textures.size())];
    const rgb<float> texel = sample_texture(t.texels, u, v, t.sampler);
    return encode({product(texel.r, r), product(texel.g, g), product(texel.b, b)});
  }

  template <int N>
  IRG_APART pack<std::uint32_t, N> pixels(const std::array<pack<float, N>, 6>& at) const noexcept {
    const float number = at[5][0];
    if (textures.empty()) return encode_lanes(at[2], at[3], at[4]);
    if (!all_lanes(at[5] == lanes<pack<float, N>>::broadcast(number))) return detail::pixels_one_by_one<N>(*this, at);
    const texture_image& t = textures[detail::texture_index(number, textures.size())];
    const rgb<pack<float, N>> texel = sample_texture(t.texels, at[0], at[1], t.sampler);
    return encode_lanes(texel.r * at[2], texel.g * at[3], texel.b * at[4]);
  }
};

}  // namespace irg
