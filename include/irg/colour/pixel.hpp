// SPDX-License-Identifier: MIT
// Pixel types: plain aggregates with the channels in memory order.
#pragma once

#include <cstdint>

#include <irg/core/scalar.hpp>

namespace irg {

/// Red, green, blue and opacity, 8 bits each, sRGB-encoded; byte 0 is red. The pixel of pictures and of `render`.
struct [[gnu::visibility("default")]] rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const rgba8&) const = default;
};

/// Blue, green, red and opacity: the order of many windowing systems and of OpenCV.
struct bgra8 {
  std::uint8_t b = 0, g = 0, r = 0, a = 255;
  bool operator==(const bgra8&) const = default;
};

/// Red, green and blue, 8 bits each.
struct rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const rgb8&) const = default;
};

/// Blue, green and red, 8 bits each: OpenCV's usual order.
struct bgr8 {
  std::uint8_t b = 0, g = 0, r = 0;
  bool operator==(const bgr8&) const = default;
};

/// Red, green and blue as numbers: light, not encoding; 0 is dark, 1 is the display's white, larger values are legal.
template <class T>
struct rgb {
  T r{}, g{}, b{};
  bool operator==(const rgb&) const
    requires std::equality_comparable<T>
  = default;
};

inline namespace IRG_ABI {

template <class T>
[[nodiscard]] IRG_INLINE constexpr rgb<T> operator+(const rgb<T>& a, const rgb<T>& b) noexcept {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}

/// Writes red, green, blue and, where there is any, opacity: "(255, 0, 0, 255)".
template <class S, class P>
  requires(std::same_as<P, rgba8> || std::same_as<P, bgra8> || std::same_as<P, rgb8> || std::same_as<P, bgr8>) &&
          TextStream<S>
constexpr S& operator<<(S& stream, const P& p) {
  constexpr bool has_opacity = std::same_as<P, rgba8> || std::same_as<P, bgra8>;
  return print_list(stream, has_opacity ? 4 : 3, [&](int i) {
    if constexpr (has_opacity)
      if (i == 3) return p.a;
    return i == 0 ? p.r : i == 1 ? p.g : p.b;
  });
}
template <class S, class T>
  requires TextStream<S, T>
constexpr S& operator<<(S& stream, const rgb<T>& c) {
  return print_list(stream, 3, [&](int i) { return i == 0 ? c.r : i == 1 ? c.g : c.b; });
}

}  // namespace IRG_ABI
}  // namespace irg
