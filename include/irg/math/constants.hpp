// SPDX-License-Identifier: MIT
// Constants, rounded to nearest for every type.
#pragma once

#include <irg/core/scalar.hpp>

namespace irg {

template <Real T>
inline constexpr T pi = static_cast<T>(3.14159265358979323846264338327950288L);
template <Real T>
inline constexpr T two_pi = static_cast<T>(6.28318530717958647692528676655900577L);
template <Real T>
inline constexpr T half_pi = static_cast<T>(1.57079632679489661923132169163975144L);
template <Real T>
inline constexpr T e = static_cast<T>(2.71828182845904523536028747135266250L);
template <Real T>
inline constexpr T sqrt_3 = static_cast<T>(1.73205080756887729352744634150587237L);
template <Real T>
inline constexpr T golden_ratio = static_cast<T>(1.61803398874989484820458683436563812L);

}  // namespace irg
