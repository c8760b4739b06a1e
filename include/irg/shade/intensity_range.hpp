// SPDX-License-Identifier: MIT
// Several lights may add up to more than a display can show. The textbook names two ways out: cut off what is over the
// range, or scale the whole picture down, in proportion or by a curve.
#pragma once

#include <concepts>
#include <limits>
#include <span>

#include <irg/core/contraction.hpp>
#include <irg/core/scalar.hpp>
#include <irg/shade/per_channel.hpp>

namespace irg {

/// What becomes of intensities over the range: each channel cut off at the maximum, or all intensities scaled by the
/// factor that takes the largest of them to the maximum. Scaling keeps hues and contrasts, but its factor depends on
/// the whole picture and so flickers in an animation.
enum class intensity_range { clamp, rescale };

/// What becomes of each share of the largest intensity: a function from 0 to 1 into 0 to 1.
template <class C, class T>
concept IntensityCurve = Real<T> && requires(const C& curve, const T& share) {
  { curve(share) } -> std::convertible_to<T>;
};

inline namespace IRG_ABI {

/// An intensity within 0 to maximum, each channel by itself.
/// gives   0 for NaN
template <class L, Scalar T>
[[nodiscard]] IRG_INLINE constexpr L clamp_intensity(const L& intensity, const T& maximum) noexcept {
  return per_channel([&](const T& i) { return clamped(i, T(0), maximum); }, intensity);
}

/// Brings all intensities within 0 to maximum. rescale leaves them as they are when none is over it.
/// needs   for rescale: finite intensities, none negative
/// exact   rescale: intensity * maximum / largest, rounded twice, but never over the maximum
/// cost    one pass to clamp, two to rescale
template <class L, Scalar T>
constexpr void fit_intensities(std::span<L> intensities, const T& maximum,
                               intensity_range range = intensity_range::clamp) noexcept {
  if (range == intensity_range::clamp) {
    for (L& i : intensities) i = clamp_intensity(i, maximum);
    return;
  }
  T largest = maximum;
  for (const L& i : intensities) largest = largest_channel(largest, i);
  if (!(maximum < largest)) return;
  const auto scaled = [&](const T& channel) -> T {
    if constexpr (Floating<T>)
      if (T(1) < maximum && (std::numeric_limits<T>::max)() / maximum <= largest)  // the product may overflow
        return product(channel / largest, maximum);
    return product(channel, maximum) / largest;
  };
  for (L& i : intensities)
    i = per_channel(
        [&](const T& channel) {
          const T within = scaled(channel);  // but for its roundings
          return maximum < within ? maximum : within;
        },
        i);
}

/// Brings all intensities within 0 to maximum by a curve: each channel becomes maximum * curve(channel / largest), with
/// the largest channel of all, or the maximum when none is over it. The curve t scales as rescale does; one above it,
/// as sqrt, keeps what is dark beside bright lamps from going black. Each channel goes by itself, so hues change.
/// gives   the curve is asked for nothing but 0 to 1; what it gives beyond is cut off, 0 for NaN
/// needs   finite intensities, none negative, and maximum >= 0
/// exact   the quotient and the product are rounded once each, the curve is the caller's; never over the maximum
/// cost    two passes, one call of the curve a channel
template <class L, Real T, IntensityCurve<T> Curve>
constexpr void fit_intensities(std::span<L> intensities, const T& maximum, const Curve& curve) {
  T largest = maximum;
  for (const L& i : intensities) largest = largest_channel(largest, i);
  if (!(T(0) < largest)) return;  // all are 0
  for (L& i : intensities)
    i = per_channel(
        [&](const T& channel) -> T {
          const T share = clamped(T(channel / largest), T(0), T(1));
          return product(clamped(static_cast<T>(curve(share)), T(0), T(1)), maximum);
        },
        i);
}

}  // namespace IRG_ABI
}  // namespace irg
