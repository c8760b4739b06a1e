// SPDX-License-Identifier: MIT
// view_window<T>: the rectangle of the picture plane that a picture shows.
#pragma once

#include <irg/core/scalar.hpp>

namespace irg {

/// A rectangle of the picture plane, y up. Exchanged sides mirror the picture.
template <Scalar T>
struct view_window {
  T left{}, right{}, bottom{}, top{};
  bool operator==(const view_window&) const = default;
};

inline namespace IRG_ABI {

/// The window of that size with the origin at its centre.
/// exact   each side is halved and rounded once
template <Real T>
[[nodiscard]] constexpr view_window<T> centred_window(const T& width, const std::type_identity_t<T>& height) noexcept {
  const T x = width / T(2), y = height / T(2);
  return {T(0) - x, x, T(0) - y, y};
}

}  // namespace IRG_ABI
}  // namespace irg
