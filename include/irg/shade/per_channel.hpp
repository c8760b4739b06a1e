// SPDX-License-Identifier: MIT
// Formulas for one channel, applied to an intensity: one number, or a colour channel by channel.
#pragma once

#include <irg/colour/pixel.hpp>

namespace irg::inline IRG_ABI {

/// f(a, b, ...) of numbers, or of each channel of colours.
template <class F, Scalar T, class... More>
[[nodiscard]] IRG_INLINE constexpr T per_channel(F f, const T& a, const More&... more) noexcept {
  return f(a, more...);
}
template <class F, class T, class... More>
[[nodiscard]] IRG_INLINE constexpr rgb<T> per_channel(F f, const rgb<T>& a, const More&... more) noexcept {
  return {f(a.r, more.r...), f(a.g, more.g...), f(a.b, more.b...)};
}

/// The largest channel of an intensity, or `largest` when that is larger; a NaN is passed over.
template <Scalar T>
[[nodiscard]] IRG_INLINE constexpr T largest_channel(const T& largest, const T& i) noexcept {
  return largest < i ? i : largest;
}
template <Scalar T>
[[nodiscard]] IRG_INLINE constexpr T largest_channel(const T& largest, const rgb<T>& i) noexcept {
  return largest_channel(largest_channel(largest_channel(largest, i.r), i.g), i.b);
}

}  // namespace irg::inline IRG_ABI
