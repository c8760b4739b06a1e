// SPDX-License-Identifier: MIT
// Sampling textures at a register of places at once: what sample_texture, mip_level and sample_mip_pyramid give one by
// one, bit for bit. Places are found in lanes; at each of them the channels of a texel are the lanes.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/colour/srgb_lanes.hpp>
#include <irg/core/interleaved_lanes.hpp>
#include <irg/core/lanes.hpp>
#include <irg/shade/mip_pyramid.hpp>

namespace irg::inline IRG_ABI {

/// The values of a texture at N places.
/// exact   sample_texture's own
template <int N>
rgb<pack<float, N>> sample_texture(const image_view<const rgba8>& texture, const pack<float, N>& u,
                                   const pack<float, N>& v, const texture_sampler& sampler = {}) noexcept;

/// The levels of N pixels.
/// exact   mip_level's own
template <int N>
[[nodiscard]] IRG_INLINE pack<float, N> mip_level(const texture_derivatives_of<pack<float, N>>& d,
                                                  const extent2& texture) noexcept;
template <int N>
[[nodiscard, deprecated("irg: mip_level(derivatives, {width, height})")]] IRG_INLINE pack<float, N> mip_level(
    const texture_derivatives_of<pack<float, N>>& d, int width, int height) noexcept {
  return mip_level<N>(d, {width, height});
}

/// The values of a texture's levels at N places.
/// exact   sample_mip_pyramid's own
template <int N>
rgb<pack<float, N>> sample_mip_pyramid(const mip_pyramid<rgb<float>>& pyramid,
                                       const mip_place_of<pack<float, N>>& place, const texture_sampler& sampler = {});

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// Whether places have four texels to be mixed, none of them in a border.
template <class R>
IRG_INLINE bool mixes_texels(const R& texture, const texture_sampler& s) noexcept {
  return s.filter == texture_filter::bilinear && s.wrap_u != texture_wrap::border && s.wrap_v != texture_wrap::border &&
         width_of(texture) > 0 && height_of(texture) > 0;
}

// Red, green, blue and anything.
IRG_INLINE pack<float, 4> channel_lanes(const rgb<float>& c) noexcept { return pack_of(c.r, c.g, c.b, 0.0f); }

// Calls each(i, channels) with what the texture holds at place i, for all i whose bit is set.
template <int N, class Each>
IRG_INLINE void sample_each(const image<rgb<float>>& texture, const pack<float, N>& u, const pack<float, N>& v,
                            const texture_sampler& sampler, unsigned places, const Each& each) {
  using integers = pack<std::int32_t, N>;
  using channels = lanes<pack<float, 4>>;
  static_assert(sizeof(rgb<float>) == 3 * sizeof(float));
  const auto broadcast = [](int n) { return lanes<integers>::broadcast(n); };
  if (!mixes_texels(texture, sampler) || texture.width() > 0x2aaaaaaa / texture.height()) {
    for (; places != 0; places &= places - 1) {
      const int i = std::countr_zero(places);
      each(i, channel_lanes(sample_texture(texture, u[i], v[i], sampler)));
    }
    return;
  }
  const auto x = neighbouring_texels(u, texture.width(), sampler.wrap_u),
             y = neighbouring_texels(v, texture.height(), sampler.wrap_v);
  alignas(64) std::int32_t upper[static_cast<unsigned>(N)], lower[static_cast<unsigned>(N)];
  alignas(64) float right[static_cast<unsigned>(N)], down[static_cast<unsigned>(N)];
  const auto offset = [&](const integers& row) { return (row * broadcast(texture.width()) + x.first) * broadcast(3); };
  lanes<integers>::store(upper, offset(y.first));
  lanes<integers>::store(lower, offset(y.second));
  lanes<pack<float, N>>::store(right, x.fraction);
  lanes<pack<float, N>>::store(down, y.fraction);
  const integers step = x.second - x.first;
  const unsigned neighbours = mask_bits(step == broadcast(1));
  const float* const all = &texture.data()->r;
  for (; places != 0; places &= places - 1) {
    const int i = std::countr_zero(places);
    const auto mix = [&](const auto& across) {
      const auto above = across(all + upper[i]), below = across(all + lower[i]);
      each(i, above + (below - above) * down[i]);
    };
    if ((neighbours >> i & 1) != 0)
      mix([&](const float* six) {  // two texels
        const auto a = channels::load_bytes(six), b = shuffled<1, 2, 3, 3>(channels::load_bytes(six + 2));
        return a + (b - a) * right[i];
      });
    else
      mix([&](const float* first) {
        const float* const second = first + 3 * std::ptrdiff_t{step[i]};
        const auto a = pack_of(first[0], first[1], first[2], 0.0f), b = pack_of(second[0], second[1], second[2], 0.0f);
        return a + (b - a) * right[i];
      });
  }
}

// Channels of N places, gathered into colours.
template <int N>
struct sampled_channels {
  alignas(64) float at[static_cast<unsigned>(N)][4];
  IRG_INLINE void put(int i, const pack<float, 4>& channels) noexcept { lanes<pack<float, 4>>::store(at[i], channels); }
  IRG_INLINE rgb<pack<float, N>> colours() const noexcept {
    const quadruple_lanes<N> q = load_quadruples<N>([&](int i) { return at[i]; });
    return {q.x, q.y, q.z};
  }
};

// log2 of numbers from 1 to 2^64, each rounded to the nearest float: in doubles, within 2^-39 of it; where that leaves
// two floats to choose from, by log2 itself.
template <int N>
IRG_INLINE pack<float, N> log2_lanes(const pack<float, N>& x) noexcept {
  constexpr std::int32_t root_of_half = 0x3f3504f3;  // so that what is left is from there to its double
  const auto bits = bits_as<std::int32_t>(x);
  const auto exponent = (bits - root_of_half) >> 23;
  const auto mantissa = bits_as<float>(bits - (exponent << 23));
  const auto of_half = [](const pack<std::int32_t, N / 2>& e, const pack<float, N / 2>& m) {
    using D = pack<double, N / 2>;
    const D one = lanes<D>::broadcast(1), d = converted<double>(m), s = (d - one) / (d + one), square = s * s;
    // The series of the inverse hyperbolic tangent, times 2 / ln 2.
    const auto term = [](int n) { return lanes<D>::broadcast(2.8853900817779268147 / n); };
    const D fourth = square * square, first = (term(1) + term(3) * square) + (term(5) + term(7) * square) * fourth,
            last = (term(9) + term(11) * square) + term(13) * fourth;
    return converted<double>(e) + s * (first + last * (fourth * fourth));
  };
  const auto low = of_half(low_half(exponent), low_half(mantissa)),
             high = of_half(high_half(exponent), high_half(mantissa));
  const auto rounded = [&](double away) {
    const auto half = [&](const auto& d) { return converted<float>(d + d * away); };
    return join_halves<float, N>(half(low), half(high));
  };
  pack<float, N> result = rounded(-0x1p-38);
  for (unsigned unsure = ~mask_bits(result == rounded(0x1p-38)) & ((1u << N) - 1); unsure != 0; unsure &= unsure - 1)
    set_lane(result, std::countr_zero(unsure), log2(x[std::countr_zero(unsure)]));
  return result;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <int N>
rgb<pack<float, N>> sample_texture(const image_view<const rgba8>& texture, const pack<float, N>& u,
                                   const pack<float, N>& v, const texture_sampler& sampler) noexcept {
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
  const auto across = [&](const integers& row) {
    return detail::between_texels(light_at(row, x.first), light_at(row, x.second), x.fraction);
  };
  return detail::between_texels(across(y.first), across(y.second), y.fraction);
}

template <int N>
[[nodiscard]] IRG_INLINE pack<float, N> mip_level(const texture_derivatives_of<pack<float, N>>& d,
                                                  const extent2& texture) noexcept {
  return detail::log2_lanes(detail::squared_side(d, texture.width, texture.height)) * 0.5f;
}

template <int N>
rgb<pack<float, N>> sample_mip_pyramid(const mip_pyramid<rgb<float>>& pyramid,
                                       const mip_place_of<pack<float, N>>& place, const texture_sampler& sampler) {
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

}  // namespace irg::inline IRG_ABI
