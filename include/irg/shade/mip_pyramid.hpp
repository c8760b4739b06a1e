// SPDX-License-Identifier: MIT
// A texture at all sizes: each level half as wide and high as the one before, down to one texel. Where a texture is
// shown smaller than it is, the level whose texels are about as large as pixels shows it without flicker.
#pragma once

#include <utility>
#include <vector>

#include <irg/math/exponential.hpp>
#include <irg/raster/image.hpp>
#include <irg/shade/per_channel.hpp>
#include <irg/shade/texture.hpp>

namespace irg {

/// The levels of a texture, the full one first; none for a texture without texels.
/// shape   Value is rgb<float> or float
template <class Value>
struct mip_pyramid {
  std::vector<image<Value>> levels;
  bool operator==(const mip_pyramid&) const = default;
};

/// How texture coordinates change from a pixel to its right and to its lower neighbour; F is a float or a pack of them.
template <class F>
struct texture_derivatives_of {
  F u_right{}, v_right{}, u_down{}, v_down{};
  bool operator==(const texture_derivatives_of&) const
    requires std::equality_comparable<F>
  = default;
};
using texture_derivatives = texture_derivatives_of<float>;

/// Where a texture's levels are sampled.
template <class F>
struct mip_place_of {
  F u{}, v{}, level{};
  bool operator==(const mip_place_of&) const
    requires std::equality_comparable<F>
  = default;
};
using mip_place = mip_place_of<float>;

namespace detail::inline IRG_ABI {

// Texel i of the smaller of two sizes: the mean of what it covers of the larger one, by shares. `at(j)` gives texel j.
// Each of the larger size's texels is `fewer` units long, each of the smaller one's `more`.
template <class At>
constexpr auto box_mean(int i, int more, int fewer, const At& at) noexcept {
  using V = decltype(at(0));
  V sum{};
  for (int j = i * more / fewer; j * fewer < (i + 1) * more; ++j) {
    const int shared = minimum((j + 1) * fewer, (i + 1) * more) - maximum(j * fewer, i * more);
    const float share = static_cast<float>(shared) / static_cast<float>(more);
    sum = per_channel([&](float s, float t) { return s + product(t, share); }, sum, at(j));
  }
  return sum;
}

template <class V>
constexpr image<V> half_size(const image<V>& from) {
  const int w = from.width(), h = from.height(), half_w = maximum(w / 2, 1), half_h = maximum(h / 2, 1);
  image<V> narrow(half_w, h), result(half_w, half_h);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < half_w; ++x) narrow(x, y) = box_mean(x, w, half_w, [&](int j) { return from(j, y); });
  for (int y = 0; y < half_h; ++y)
    for (int x = 0; x < half_w; ++x) result(x, y) = box_mean(y, h, half_h, [&](int j) { return narrow(x, j); });
  return result;
}

// The square of the longer side of a pixel's image in a texture, from 1 to 2^64; 1 for NaN.
template <class F>
constexpr F squared_side(const texture_derivatives_of<F>& d, int width, int height) noexcept {
  using f = lanes<F>;
  const F w = f::broadcast(static_cast<float>(width)), h = f::broadcast(static_cast<float>(height));
  const auto square_of = [&](const F& u, const F& v) {
    const F x = product(limited_coordinate(u, -0x1p40f, 0x1p40f), w),
            y = product(limited_coordinate(v, -0x1p40f, 0x1p40f), h);
    return product(x, x) + product(y, y);
  };
  const F longer = maximum(square_of(d.u_right, d.v_right), square_of(d.u_down, d.v_down));
  const auto number =
      both(both(d.u_right == d.u_right, d.v_right == d.v_right), both(d.u_down == d.u_down, d.v_down == d.v_down));
  return select(number, limited_coordinate(longer, 1.0f, 0x1p64f), f::broadcast(1.0f));
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// All levels of a texture by box filtering: each texel is the mean of what it covers of the level before, so that all
/// levels have the mean of the texture. Odd sizes are halved downwards; texels that straddle a border count by shares.
/// needs   width, height <= 32768
/// exact   means of four are exact up to their sums' roundings; the shares of odd sizes are rounded once
/// cost    4/3 of the texture's texels; allocates them
/// source  Williams 1983
template <TextureRaster R>
[[nodiscard]] constexpr mip_pyramid<texel_value_of<R>> make_mip_pyramid(const R& texture) {
  mip_pyramid<texel_value_of<R>> pyramid;
  const int width = width_of(texture), height = height_of(texture);
  if (width <= 0 || height <= 0) return pyramid;
  image<texel_value_of<R>> level(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) level(x, y) = texel_value(get_pixel(texture, x, y));
  while (level.width() > 1 || level.height() > 1) {
    image<texel_value_of<R>> next = detail::half_size(level);
    pyramid.levels.push_back(std::move(level));
    level = std::move(next);
  }
  pyramid.levels.push_back(std::move(level));
  return pyramid;
}

/// The level whose texels are as large as pixels: the binary logarithm of the longer side of a pixel's image in a
/// texture of this size, in texels.
/// gives   0 where texels are larger than pixels, and for NaN; at most 32
/// exact   within 2 ulp of 1/2 log2 of the longer side's square
/// source  Williams 1983
[[nodiscard]] constexpr float mip_level(const texture_derivatives& d, const extent2& texture) noexcept {
  return 0.5f * log2(detail::squared_side(d, texture.width, texture.height));
}
[[nodiscard, deprecated("irg: mip_level(derivatives, {width, height})")]] constexpr float mip_level(
    const texture_derivatives& d, int width, int height) noexcept {
  return mip_level(d, {width, height});
}

/// The value at a place of a texture's levels: trilinear, between the two levels next to `level`, each sampled as the
/// sampler says.
/// gives   the first level for level <= 0 and NaN, the last one beyond it; `border` for a pyramid without levels
/// exact   at a whole level, what sample_texture gives on it; between, one rounding more of the sum and product
/// cost    two samples between levels, one at a whole one
template <class Value>
[[nodiscard]] constexpr Value sample_mip_pyramid(const mip_pyramid<Value>& pyramid, const mip_place& at,
                                                 const texture_sampler& sampler = {}, const Value& border = {}) {
  if (pyramid.levels.empty()) return border;
  const auto last = static_cast<float>(pyramid.levels.size() - 1);
  const float limited = clamped(at.level, 0.0f, last);
  const auto k = static_cast<std::size_t>(limited);
  const Value finer = sample_texture(pyramid.levels[k], at.u, at.v, sampler, border);
  const float fraction = limited - static_cast<float>(k);
  if (fraction == 0.0f) return finer;
  return detail::between_texels(finer, sample_texture(pyramid.levels[k + 1], at.u, at.v, sampler, border), fraction);
}

}  // namespace IRG_ABI
}  // namespace irg
