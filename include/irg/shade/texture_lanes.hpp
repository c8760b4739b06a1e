// SPDX-License-Identifier: MIT
// Sampling textures at a register of places at once: what sample_texture, mip_level and sample_mip_pyramid give one by
// one, bit for bit. Places are found in lanes; at each of them the channels of a texel are the lanes.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/colour/srgb_lanes.hpp>
#include <irg/core/interleaved_lanes.hpp>
#include <irg/core/lanes.hpp>
#include <irg/shade/detail/texture_lanes_steps.hpp>
#include <irg/shade/mip_pyramid.hpp>

namespace irg {

inline namespace IRG_ABI {

/// The values of a texture at N places.
/// exact   sample_texture's own
template <int N>
rgb<pack<float, N>> sample_texture(const image_view<const rgba8>& texture, const pack<float, N>& u,
                                   const pack<float, N>& v, const texture_sampler& sampler = {}) noexcept {
  using floats = pack<float, N>;
  using integers = pack<std::int32_t, N>;
  constexpr std::ptrdiff_t most = 0x7fffffff, size = sizeof(rgba8);
  const std::ptrdiff_t step = texture.stride() / size, height = texture.height();
  const bool in_reach =
      texture.stride() % size == 0 && ((step < 0 ? -step : step) + 1) <= most / (height > 0 ? height : 1);
  if (!in_reach || !detail::mixes_texels(texture, sampler)) {
    detail::sampled_channels<N> out;
    for (int i = 0; i < N; ++i) out.put(i, detail::channel_lanes(sample_texture(texture, u[i], v[i], sampler)));
    return out.colours();
  }
  const auto x = detail::neighbouring_texels(u, texture.width(), sampler.wrap_u),
             y = detail::neighbouring_texels(v, texture.height(), sampler.wrap_v);
  const auto light_at = [&](const integers& row, const integers& column) -> rgb<floats> {
    const auto stride = lanes<integers>::broadcast(static_cast<std::int32_t>(step));
    return decode_lanes(gather<std::int32_t>(texture.row(0), row * stride + column));
  };
  const auto between = [](const rgb<floats>& a, const rgb<floats>& b, const floats& t) -> rgb<floats> {
    return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
  };
  const auto across = [&](const integers& row) {
    return between(light_at(row, x.first), light_at(row, x.second), x.fraction);
  };
  return between(across(y.first), across(y.second), y.fraction);
}

/// The levels of N pixels.
/// exact   mip_level's own
template <int N>
[[nodiscard]] IRG_INLINE pack<float, N> mip_level(const texture_derivatives_of<pack<float, N>>& d, int width,
                                                  int height) noexcept {
  return detail::log2_lanes(detail::squared_side(d, width, height)) * 0.5f;
}

/// The values of a texture's levels at N places.
/// exact   sample_mip_pyramid's own
template <int N>
rgb<pack<float, N>> sample_mip_pyramid(const mip_pyramid<rgb<float>>& pyramid,
                                       const mip_place_of<pack<float, N>>& place, const texture_sampler& sampler = {}) {
  const auto& [u, v, level] = place;
  using F = lanes<pack<float, N>>;
  if (pyramid.levels.empty()) return {F::broadcast(0), F::broadcast(0), F::broadcast(0)};
  const auto limited = detail::limited_coordinate(level, 0.0f, static_cast<float>(pyramid.levels.size() - 1));
  const auto k = converted<std::int32_t>(limited);
  const auto fraction = limited - to_float(k);
  const unsigned whole = mask_bits(fraction == F::broadcast(0));
  detail::sampled_channels<N> out;
  for (unsigned left = (1u << N) - 1; left != 0;) {
    const std::int32_t finer = k[std::countr_zero(left)];
    const unsigned same = mask_bits(k == lanes<pack<std::int32_t, N>>::broadcast(finer)) & left;
    const image<rgb<float>>* const found = pyramid.levels.data() + finer;
    detail::sample_each(found[0], u, v, sampler, same,
                        [&](int i, const pack<float, 4>& channels) { out.put(i, channels); });
    if ((same & ~whole) != 0)
      detail::sample_each(found[1], u, v, sampler, same & ~whole, [&](int i, const pack<float, 4>& coarser) {
        const auto from = lanes<pack<float, 4>>::load(out.at[i]);
        out.put(i, from + (coarser - from) * fraction[i]);
      });
    left &= ~same;
  }
  return out.colours();
}

}  // namespace IRG_ABI
}  // namespace irg
