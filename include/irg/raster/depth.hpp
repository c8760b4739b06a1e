// SPDX-License-Identifier: MIT
// Which of two depths is nearer to the viewer: named in a type, never left to a sign convention.
#pragma once

#include <irg/core/scalar.hpp>

namespace irg {

/// Reversed depth: 1 on the near plane, 0 far away. Floats are dense near 0, so this order loses least (Upchurch and
/// Desbrun 2012); it is irg's default.
struct [[gnu::visibility("default")]] nearer_is_greater {
  static constexpr float farthest = 0.0f;
  template <class T>
  IRG_INLINE static constexpr auto nearer(const T& a, const T& b) noexcept {
    return b < a;
  }
};

/// Ordinary depth: 0 on the near plane, 1 far away.
struct [[gnu::visibility("default")]] nearer_is_less {
  static constexpr float farthest = 1.0f;
  template <class T>
  IRG_INLINE static constexpr auto nearer(const T& a, const T& b) noexcept {
    return a < b;
  }
};

/// No hiding: what is drawn later covers what was drawn before, whatever its depth; the depth is only recorded.
struct [[gnu::visibility("default")]] drawing_order {
  static constexpr float farthest = -1.0f;  // below every depth: tells touched pixels from untouched ones
  template <class T>
  IRG_INLINE static constexpr auto nearer(const T& a, const T&) noexcept {
    return a == a;
  }
};

/// A way to order depths, and the value a depth buffer is cleared to. Models: nearer_is_greater, nearer_is_less,
/// drawing_order.
template <class T>
concept DepthOrder = requires(float a, float b) {
  { T::nearer(a, b) } -> std::convertible_to<bool>;
  { T::farthest } -> std::convertible_to<float>;
};

}  // namespace irg
