// SPDX-License-Identifier: MIT
// The filter of sign_of: which numbers it takes, and which values tell their sign.
#pragma once

#include <type_traits>

#include <irg/math/exact/filtered_number.hpp>

namespace irg::detail::inline IRG_ABI {

// -1 or 1, as x is beyond -bound or bound, without a branch that signs mispredict; else what is given instead.
IRG_INLINE constexpr int sign_beyond(double bound, double x, int otherwise) noexcept {
  return magnitude(x) > bound ? 1 - 2 * static_cast<int>(bits_of(x) >> 63) : otherwise;
}

// 2 where rounding leaves the sign open, in numbers that suit the filter.
IRG_INLINE constexpr int filtered_sign(const filtered_number& x) noexcept {
  return sign_beyond(polynomial_filter_bound * x.size, x.value, x.size == 0 ? 0 : 2);
}

// What is asked of the numbers before a polynomial is computed in them, and of its value after.
template <Floating T, int Degree>
class filter_range {
public:
  IRG_INLINE constexpr void include(T x) noexcept { suits_ = suits_ && suits_filter<Degree>(x); }
  [[nodiscard]] IRG_INLINE constexpr bool suits() const noexcept { return suits_; }
  [[nodiscard]] IRG_INLINE static constexpr int sign_of(const filtered_number& x) noexcept { return filtered_sign(x); }

private:
  bool suits_ = true;
};
// Of doubles only whether they are below 2^R, so that nothing overflows: a sum tells, asked once, without a branch for
// each. A number or result that is subnormal, or a zero in its place, changes the value by at most 2^-1021 times 2^10
// terms of the other factors, at most 2^(R (Degree - 1)) each; of less than 2^14 of them a value beyond `least` is not
// in doubt.
template <int Degree>
class filter_range<double, Degree> {
  static constexpr double limit = power_of_two(filter_reach<Degree>);
  static constexpr double least = power_of_two(filter_reach<Degree> * (Degree - 1) - 990);

public:
  IRG_INLINE constexpr void include(double x) noexcept {
    const double size = magnitude(x);
    // Constant evaluation refuses sums that overflow or are NaN.
    sum_ = std::is_constant_evaluated() && !(size < limit) ? limit : sum_ + size;
  }
  [[nodiscard]] IRG_INLINE constexpr bool suits() const noexcept { return sum_ < limit; }
  [[nodiscard]] IRG_INLINE static constexpr int sign_of(const filtered_number& x) noexcept {
    return sign_beyond(polynomial_filter_bound * x.size + least, x.value, 2);
  }

private:
  double sum_ = 0;  // of the magnitudes
};

}  // namespace irg::detail::inline IRG_ABI
