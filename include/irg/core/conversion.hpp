// SPDX-License-Identifier: MIT
// Conversions between float and double that happen where they are written. g++ 12's straight-line vectorizer drops the
// rounding of a double to a float that is widened again, at plain -O2 and with the user's call inlined around irg's
// code: the double goes on unrounded. So no float enters or leaves a formula in doubles but through these.
#pragma once

#include <irg/core/contraction.hpp>

// Whether conversions are hidden from the optimiser. clang up to 19 never leaves one out, and can vectorise loops of
// those that it sees; what newer ones do has not been tried.
#if defined(__clang__) && __clang_major__ <= 19
#define IRG_HIDES_CONVERSIONS 0
#else
#define IRG_HIDES_CONVERSIONS 1
#endif

namespace irg::inline IRG_ABI {

/// x as a number of type To, rounded here if it is rounded at all.
/// needs   x within To's range where this is a constant expression
/// exact   correctly rounded
template <class To, class From>
[[nodiscard]] IRG_INLINE constexpr To converted(const From& x) noexcept(noexcept(static_cast<To>(x))) {
  constexpr bool hidden = IRG_HIDES_CONVERSIONS;
  if constexpr (hidden && std::is_same_v<From, float> && std::is_same_v<To, double>)
    return static_cast<double>(opaque(x));
  else if constexpr (hidden && std::is_same_v<From, double> && std::is_same_v<To, float>)
    return opaque(static_cast<float>(x));
  else
    return static_cast<To>(x);
}

/// x as a double. What rounded x to a float before, in irg or in the caller's code, has happened.
/// exact   the identity for float and double
template <class T>
[[nodiscard]] IRG_INLINE constexpr double widened(const T& x) noexcept(noexcept(static_cast<double>(x))) {
  return converted<double>(x);
}

}  // namespace irg::inline IRG_ABI
