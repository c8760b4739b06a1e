// SPDX-License-Identifier: MIT
// Textured surfaces without flicker: at each pixel the texture is sampled between the two levels of its pyramid whose
// texels are about as large there as the pixel, so that what is far away has its mean colour.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <irg/render/textured_shading.hpp>
#include <irg/render/weight_derivatives.hpp>
#include <irg/shade/mip_pyramid.hpp>

namespace irg {

/// A texture at all sizes, and how its levels are sampled; a border is black.
struct texture_pyramid {
  const mip_pyramid<rgb<float>>* levels = nullptr;
  texture_sampler sampler{};
};

/// The pixel shader of one textured triangle.
/// shape   a, b, c are its vertices
struct mip_textured_shader {
  std::span<const texture_pyramid> textures;
  const float *a, *b, *c;
  weight_derivatives derivatives;

  /// The level at a pixel for a texture of width x height texels: mip_level of how u and v change there.
  IRG_INLINE constexpr float level(const pixel_weights<float>& at, int width, int height) const noexcept {
    const weight_changes change = derivatives(at);
    return mip_level({change.right(a[0], b[0], c[0]), change.right(a[1], b[1], c[1]), change.down(a[0], b[0], c[0]),
                      change.down(a[1], b[1], c[1])},
                     width, height);
  }

  template <class Weights = pixel_weights<float>>
  IRG_INLINE constexpr rgba8 operator()(const Weights& at) const {
    const auto [u, v, r, g, b_, number] = interpolate_attributes<textured_shading::attribute_count>(at, a, b, c);
    if (textures.empty()) return encode({r, g, b_});
    const texture_pyramid& t = textures[detail::texture_index(number, textures.size())];
    if (t.levels == nullptr || t.levels->levels.empty()) return encode({0, 0, 0});
    const image<rgb<float>>& whole = t.levels->levels[0];
    const rgb<float> texel = sample_mip_pyramid(*t.levels, u, v, level(at, whole.width(), whole.height()), t.sampler);
    return encode({product(texel.r, r), product(texel.g, g), product(texel.b, b_)});
  }
};

/// Textured surfaces as a maker of pixel shaders for draw_batches and draw_transparent; as textured_shading, but with
/// the pyramids of the textures, and trilinear.
/// shape   objects[batch.object] belongs to a batch, its vertices to the batch's; textures are numbered from 0
/// needs   all that it names to outlive it; the mapping that the batches were projected with
/// gives   the light alone where there is no texture; the first texture for a number that is NaN or negative, the last
///         one for a number too large; a texture without levels is black
/// exact   the value of sample_mip_pyramid at mip_level, times the light, each channel rounded once, then encode()
/// cost    every triangle that is seen is set up alone, and pixels are shaded one by one: more than textured_shading
/// source  Williams 1983
template <Floating T>
struct mip_textured_shading {
  std::span<const textured_vertices> objects;
  std::span<const texture_pyramid> textures;
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
