// SPDX-License-Identifier: MIT
// mix: between two pixel values, as far as a coverage of 0 to 255 says.
#pragma once

#include <concepts>
#include <cstdint>

#include <irg/colour/pixel.hpp>
#include <irg/core/contraction.hpp>

namespace irg {
inline namespace IRG_ABI {

/// a * (255 - coverage) / 255 + b * coverage / 255.
/// exact   the integer nearest to the exact value (a tie cannot be: 255 is odd)
[[nodiscard]] IRG_INLINE constexpr std::uint8_t mix(std::uint8_t a, std::uint8_t b, std::uint8_t coverage) noexcept {
  // t / 255 rounded is (u + u / 256) / 256 with u = t + 128, for all t up to 255 * 255.
  const unsigned u = a * (255u - coverage) + b * unsigned{coverage} + 128u;
  return static_cast<std::uint8_t>((u + (u >> 8)) >> 8);
}

/// a + (b - a) * coverage / 255.
/// exact   a at coverage 0 and b at 255, whatever the other one is; between them four roundings
/// gives   infinity or NaN between them when a or b is not finite, or b - a overflows: no constant expression then
template <std::floating_point T>
[[nodiscard]] IRG_INLINE constexpr T mix(T a, T b, std::uint8_t coverage) noexcept {
  if (coverage == 0) return a;
  if (coverage == 255) return b;
  return a + product(b - a, static_cast<T>(coverage) / T(255));
}

/// Each channel mixed as encoded, opacity like the colours.
template <class P>
  requires std::same_as<P, rgba8> || std::same_as<P, bgra8>
[[nodiscard]] IRG_INLINE constexpr P mix(const P& a, const P& b, std::uint8_t coverage) noexcept {
  P out;
  out.r = mix(a.r, b.r, coverage);
  out.g = mix(a.g, b.g, coverage);
  out.b = mix(a.b, b.b, coverage);
  out.a = mix(a.a, b.a, coverage);
  return out;
}

/// Each channel mixed as encoded.
template <class P>
  requires std::same_as<P, rgb8> || std::same_as<P, bgr8>
[[nodiscard]] IRG_INLINE constexpr P mix(const P& a, const P& b, std::uint8_t coverage) noexcept {
  P out;
  out.r = mix(a.r, b.r, coverage);
  out.g = mix(a.g, b.g, coverage);
  out.b = mix(a.b, b.b, coverage);
  return out;
}

/// Each channel mixed.
template <std::floating_point T>
[[nodiscard]] IRG_INLINE constexpr rgb<T> mix(const rgb<T>& a, const rgb<T>& b, std::uint8_t coverage) noexcept {
  return {mix(a.r, b.r, coverage), mix(a.g, b.g, coverage), mix(a.b, b.b, coverage)};
}

}  // namespace IRG_ABI

namespace detail {

// What becomes an integer and nothing else, and what becomes nothing at all. Shaders and their libraries have a mix of
// shares from 0 to 1, too: it would take coverage 255 for a share of 255.
struct only_coverage {
  template <std::integral T>
  operator T() const noexcept;
};
struct no_coverage {};

}  // namespace detail

/// A pixel type that mix knows: irg's, and types with a mix in their own namespace whose coverage is an integer.
/// needs   of such a mix: a at coverage 0, b at 255
/// gives   false where the mix is one of shares from 0 to 1, or takes anything, as GLM's
template <class P>
concept Mixable = requires(const P& a, const P& b, std::uint8_t coverage, const detail::only_coverage& only) {
  { mix(a, b, coverage) } -> std::same_as<P>;
  { mix(a, b, only) } -> std::same_as<P>;
} && !requires(const P& a, const P& b, const detail::no_coverage& none) { mix(a, b, none); };

}  // namespace irg
