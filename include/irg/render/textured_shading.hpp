// SPDX-License-Identifier: MIT
// Textured surfaces: texture coordinates and light given at the vertices, linear in between and corrected for
// perspective; a pixel is the light times what the texture holds there.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include <irg/colour/srgb_lanes.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/attribute_shading.hpp>
#include <irg/shade/texture.hpp>

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
IRG_INLINE constexpr textured_vertex make_textured_vertex(float u, float v, const rgb<float>& light = {1, 1, 1},
                                                          int texture = 0) noexcept {
  return {u, v, light.r, light.g, light.b, static_cast<float>(texture)};
}

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

// Which of the textures a number means.
// needs   count > 0
IRG_INLINE constexpr std::size_t texture_index(float number, std::size_t count) noexcept {
  return static_cast<std::size_t>(clamp(number, 0.0f, static_cast<float>(count - 1)));
}

}  // namespace IRG_ABI
}  // namespace detail

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
  std::span<const textured_vertices> objects;
  std::span<const texture_image> textures;

  template <class Batch>
  IRG_INLINE constexpr const float* attributes(const Batch& batch, std::uint32_t vertex, facing side) const noexcept {
    const textured_vertices& v = objects[batch.object];
    return (side == facing::back && !v.back.empty() ? v.back : v.front)[vertex].data();
  }

  template <class Vertex = textured_vertex>
  IRG_INLINE constexpr rgba8 pixel(const Vertex& at) const noexcept {
    const auto [u, v, r, g, b, number] = at;
    if (textures.empty()) return encode({r, g, b});
    const texture_image& t = textures[detail::texture_index(number, textures.size())];
    const rgb<float> texel = sample_texture(t.texels, u, v, t.sampler);
    return encode({product(texel.r, r), product(texel.g, g), product(texel.b, b)});
  }

  template <int N>
  IRG_INLINE pack<std::uint32_t, N> pixels(const std::array<pack<float, N>, 6>& at) const noexcept {
    const float number = at[5][0];
    if (textures.empty()) return encode_lanes(at[2], at[3], at[4]);
    const texture_image& t = textures[detail::texture_index(number, textures.size())];
    const bool of_one = mask_bits(at[5] == lanes<pack<float, N>>::broadcast(number)) == (1u << N) - 1;
    if (of_one && bilinear_in_lanes(t)) return bilinear(t, at);
    pack<std::uint32_t, N> words;
    for (int i = 0; i < N; ++i)
      set_lane(words, i,
               std::bit_cast<std::uint32_t>(pixel({at[0][i], at[1][i], at[2][i], at[3][i], at[4][i], at[5][i]})));
    return words;
  }

private:
  // Texels in reach of a gather's 32-bit indices, and none in a border.
  IRG_INLINE static bool bilinear_in_lanes(const texture_image& t) noexcept {
    constexpr std::ptrdiff_t most = 0x7fffffff, size = sizeof(rgba8);
    const texture_sampler& s = t.sampler;
    const std::ptrdiff_t stride = t.texels.stride(), width = t.texels.width(), height = t.texels.height();
    return s.filter == texture_filter::bilinear && s.wrap_u != texture_wrap::border &&
           s.wrap_v != texture_wrap::border && width > 0 && height > 0 && stride % size == 0 &&
           ((stride < 0 ? -stride : stride) / size + 1) <= most / height;
  }

  // The light of N texels, one of them at each index.
  template <int N>
  IRG_INLINE static rgb<pack<float, N>> light_at(const rgba8* texels, const pack<std::int32_t, N>& index) noexcept {
    const auto word = gather<std::int32_t>(texels, index);
    const auto light = [&](int shift) { return gather<float>(detail::srgb_light, (word >> shift) & 255); };
    return {light(byte_shift<4>(0)), light(byte_shift<4>(1)), light(byte_shift<4>(2))};
  }

  template <int N>
  IRG_INLINE static pack<std::uint32_t, N> bilinear(const texture_image& t,
                                                    const std::array<pack<float, N>, 6>& at) noexcept {
    using floats = pack<float, N>;
    const auto x = detail::neighbouring_texels(at[0], t.texels.width(), t.sampler.wrap_u),
               y = detail::neighbouring_texels(at[1], t.texels.height(), t.sampler.wrap_v);
    const rgba8* const base = t.texels.row(0);
    const auto stride = lanes<pack<std::int32_t, N>>::broadcast(
        static_cast<std::int32_t>(t.texels.stride() / std::ptrdiff_t{sizeof(rgba8)}));
    const auto upper_row = y.first * stride, lower_row = y.second * stride;
    const rgb<floats> four[4] = {light_at(base, upper_row + x.first), light_at(base, upper_row + x.second),
                                 light_at(base, lower_row + x.first), light_at(base, lower_row + x.second)};
    const auto value = [&](const floats& a, const floats& b, const floats& c, const floats& d, const floats& light) {
      const floats upper = a + (b - a) * x.fraction, lower = c + (d - c) * x.fraction;
      return (upper + (lower - upper) * y.fraction) * light;
    };
    return encode_lanes(value(four[0].r, four[1].r, four[2].r, four[3].r, at[2]),
                        value(four[0].g, four[1].g, four[2].g, four[3].g, at[3]),
                        value(four[0].b, four[1].b, four[2].b, four[3].b, at[4]));
  }
};

}  // namespace irg
