// SPDX-License-Identifier: MIT
// Sampling a raster as a texture: the light at a place between its texels. Encoded texels are decoded first: light may
// be averaged, the codes of a picture may not.
//
// (u, v) = (0, 0) is the top left corner of the raster's first texel and (1, 1) the bottom right corner of its last
// one: u to the right, v down, as rasters run. Texel (i, j) has its centre at ((i + 1/2) / width, (j + 1/2) / height).
#pragma once

#include <concepts>
#include <cstdint>

#include <irg/colour/encode_pixel.hpp>
#include <irg/colour/srgb.hpp>
#include <irg/core/lanes.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/shade/per_channel.hpp>

namespace irg {

/// The texel that holds the place, or the weighted mean of the four whose centres surround it.
enum class texture_filter { nearest, bilinear };

/// What lies outside of 0 to 1: the texture again, the texture turned round each second time, its outermost texels, or
/// a value of the caller's.
enum class texture_wrap { repeat, mirrored, clamp, border };

/// How a texture is sampled.
struct texture_sampler {
  texture_filter filter = texture_filter::bilinear;
  texture_wrap wrap_u = texture_wrap::repeat, wrap_v = texture_wrap::repeat;
  bool operator==(const texture_sampler&) const = default;
};

inline namespace IRG_ABI {

/// What a texel stands for: the light of an encoded pixel (its opacity left aside); numbers stand for themselves.
template <EncodablePixel P>
[[nodiscard]] IRG_INLINE constexpr rgb<float> texel_value(const P& texel) noexcept {
  return decode(to_rgba8(texel));
}
[[nodiscard]] IRG_INLINE constexpr rgb<float> texel_value(const rgb<float>& texel) noexcept { return texel; }
template <std::same_as<float> P>
[[nodiscard]] IRG_INLINE constexpr float texel_value(P texel) noexcept {
  return texel;
}

}  // namespace IRG_ABI

/// A raster whose pixels are texels: encoded pixels, rgb<float> or float.
template <class R>
concept TextureRaster = ReadableRaster<R> && requires(const pixel_of<R>& texel) { texel_value(texel); };

/// What sampling a raster gives: rgb<float> or float.
template <TextureRaster R>
using texel_value_of = decltype(texel_value(std::declval<const pixel_of<R>&>()));

namespace detail::inline IRG_ABI {

// The greatest integer that is not greater.
// needs   |x| < 2^31
IRG_INLINE constexpr std::int32_t texture_floor(float x) noexcept {
  const auto whole = static_cast<std::int32_t>(x);
  return x < static_cast<float>(whole) ? whole - 1 : whole;
}
template <int N>
IRG_INLINE pack<std::int32_t, N> texture_floor(const pack<float, N>& x) noexcept {
  const auto whole = converted<std::int32_t>(x);
  return whole + (x < to_float(whole));  // a mask is -1 where it holds
}

// x, or `low` where it is less or NaN, or `high` where it is more.
template <class F, class S>
IRG_INLINE constexpr F limited_coordinate(const F& x, S low, S high) noexcept {
  const F least = lanes<F>::broadcast(low), most = lanes<F>::broadcast(high), not_below = select(least < x, x, least);
  return select(not_below < most, not_below, most);
}

// A coordinate brought to 0 to 1; for a border, to -1 to 2. From 2^23 on all floats are integers.
template <class F>
IRG_INLINE constexpr F wrapped_coordinate(const F& u, texture_wrap wrap) noexcept {
  using f = lanes<F>;
  if (wrap == texture_wrap::clamp) return limited_coordinate(u, 0.0f, 1.0f);
  if (wrap == texture_wrap::border) return limited_coordinate(u, -1.0f, 2.0f);
  const F usable = select(both(f::broadcast(-0x1p24f) < u, u < f::broadcast(0x1p24f)), u, f::broadcast(0.0f));
  if (wrap == texture_wrap::repeat) return usable - to_float(texture_floor(usable));
  const F twice = f::broadcast(2.0f);
  const F along = usable - product(twice, to_float(texture_floor(product(usable, f::broadcast(0.5f)))));
  return select(f::broadcast(1.0f) < along, twice - along, along);
}

// Two texels next to each other in a row or column, and how far on the way from one to the other; indices outside of
// 0 to count - 1 lie in the border.
template <class F>
struct texel_pair {
  typename lanes<F>::template rebind<std::int32_t> first, second;
  F fraction;
};

// The texel that holds a coordinate.
template <class F>
IRG_INLINE constexpr auto nearest_texel(const F& u, int count, texture_wrap wrap) noexcept {
  using J = typename lanes<F>::template rebind<std::int32_t>;
  const F along = wrapped_coordinate(u, wrap);
  const J i = texture_floor(product(along, lanes<F>::broadcast(static_cast<float>(count))));
  const J limited = limited_coordinate(i, 0, count - 1);  // the product may have been rounded up to `count`
  if (wrap != texture_wrap::border) return limited;
  return select(both(along >= lanes<F>::broadcast(0.0f), along < lanes<F>::broadcast(1.0f)), limited,
                lanes<J>::broadcast(-1));
}

// The texels on both sides of a coordinate.
template <class F>
IRG_INLINE constexpr texel_pair<F> neighbouring_texels(const F& u, int count, texture_wrap wrap) noexcept {
  using J = typename lanes<F>::template rebind<std::int32_t>;
  using i = lanes<J>;
  const F x =
      product(wrapped_coordinate(u, wrap), lanes<F>::broadcast(static_cast<float>(count))) - lanes<F>::broadcast(0.5f);
  const J first = texture_floor(x), second = first + i::broadcast(1);
  const F fraction = x - to_float(first);
  if (wrap == texture_wrap::border) return {first, second, fraction};
  if (wrap == texture_wrap::repeat)
    return {select(both(first >= i::broadcast(0), first < i::broadcast(count)), first, i::broadcast(count - 1)),
            select(second < i::broadcast(count), second, i::broadcast(0)), fraction};
  return {limited_coordinate(first, 0, count - 1), limited_coordinate(second, 0, count - 1), fraction};
}

// From a to b, as far as t says: exactly a at 0, and exactly a everywhere when b equals it.
template <class V, class F>
IRG_INLINE constexpr V between_texels(const V& a, const V& b, const F& t) noexcept {
  return per_channel([&](const F& from, const F& to) { return from + product(to - from, t); }, a, b);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The value of a texture at (u, v).
/// shape   values are light, rgb<float>, for encoded texels and rgb<float>; float for float
/// units   u and v from 0 to 1 across the texture; v runs down: for coordinates whose v runs up, as in OBJ files, give
///         1 - v
/// needs   width, height <= 2^29, which texel indices of 32 bits take as floats
/// gives   `border` for a texture without texels; u and v that are NaN or infinite, and those from 2^24 on, where
///         neighbouring floats are more than a texture apart: as 0 for repeat and mirrored; NaN as 0 for clamp, outside
///         for border. A border begins at the outermost texels' edges for nearest, and is mixed in from their centres
///         on for bilinear
/// exact   bilinear: the place within 2^-24 of the texture's width and 2^-24 of the coordinate where it is wrapped, the
///         value within 3 roundings of each channel; a texel's own value at its centre; equal texels give their value
/// cost    1 or 4 texels
/// source  Williams 1983 for textures filtered in two directions
template <TextureRaster R>
[[nodiscard]] constexpr texel_value_of<R> sample_texture(const R& texture, float u, float v,
                                                         const texture_sampler& sampler = {},
                                                         const texel_value_of<R>& border = {}) {
  const int width = width_of(texture), height = height_of(texture);
  if (width <= 0 || height <= 0) return border;
  const auto value = [&](int x, int y) -> texel_value_of<R> {
    if (x < 0 || y < 0 || x >= width || y >= height) return border;
    return texel_value(get_pixel(texture, x, y));
  };
  if (sampler.filter == texture_filter::nearest)
    return value(detail::nearest_texel(u, width, sampler.wrap_u), detail::nearest_texel(v, height, sampler.wrap_v));
  const auto x = detail::neighbouring_texels(u, width, sampler.wrap_u),
             y = detail::neighbouring_texels(v, height, sampler.wrap_v);
  const auto across = [&](int row) {
    return detail::between_texels(value(x.first, row), value(x.second, row), x.fraction);
  };
  return detail::between_texels(across(y.first), across(y.second), y.fraction);
}

}  // namespace IRG_ABI
}  // namespace irg
