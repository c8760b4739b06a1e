// SPDX-License-Identifier: MIT
// double_double: numbers of 106 bits, each the unevaluated sum of two doubles. They are Scalars: vectors, matrices and
// determinants compute with them as with doubles. double_word<float> is the same with floats, 48 bits.
//
// Relative errors are proved in Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of
// double-word arithmetic", ACM TOMS 44 (2017), with the corrections of Muller and Rideau (2022), barring over- and
// underflow; u = 2^-53 (float: 2^-24). With and without a fused multiply-add the bits are the same.
#pragma once

#include <concepts>
#include <type_traits>

#include <irg/math/detail/unrounded.hpp>
#include <irg/math/sqrt.hpp>

namespace irg {

template <Floating T>
class double_word;

namespace detail::inline IRG_ABI {

/// The number of the two parts, the value being the sum rounded; where that is not finite, it stands alone.
template <Floating T>
IRG_INLINE constexpr double_word<T> finite_words(const exact_sum<T>& x) noexcept {
  return {x.value, is_finite(x.value) ? x.error : T(0)};
}

// Between these sizes a product of words has an error that is a number; a dividend or radicand beyond is scaled first.
template <Floating T>
inline constexpr T least_of_exact_words = std::is_same_v<T, double> ? T(0x1p-914) : T(0x1p-77f);
template <Floating T>
inline constexpr T most_of_exact_words = std::is_same_v<T, double> ? T(0x1p1000) : T(0x1p120f);

template <Floating T>
constexpr double_word<T> scaled_quotient(const double_word<T>& x, const double_word<T>& y) noexcept;

}  // namespace detail::inline IRG_ABI

/// A number in two words: high is the number rounded to T, low the rest, at most half a unit in high's last place.
/// shape   low is 0 where high is infinite or NaN
/// exact   bounds of relative errors stand at each operation; they hold where no product of two high words is below
///         2^-914 (float: 2^-77), below that the absolute error is some 2^-1074 (2^-149)
template <Floating T>
class double_word {
public:
  T high{}, low{};

  IRG_INLINE constexpr double_word() noexcept {}
  /// The number x.
  IRG_INLINE constexpr double_word(T x) noexcept : high(x) {}
  /// The integer i: exactly from up to 64 bits into doubles, up to 32 bits into floats.
  template <std::integral J>
    requires(!std::same_as<J, bool>)
  IRG_INLINE constexpr double_word(J i) noexcept {
    constexpr J half =
        static_cast<J>(sizeof(J) == 8 ? J{1} << (sizeof(J) == 8 ? 32 : 0) : J{1} << (sizeof(J) == 4 ? 16 : 0));
    if constexpr (sizeof(J) <= 2) {
      high = static_cast<T>(i);
    } else {
      const J upper = static_cast<J>(i / half);
      const auto [value, error] =
          two_sum(product(static_cast<T>(upper), static_cast<T>(half)), static_cast<T>(i - upper * half));
      high = value;
      low = error;
    }
  }
  /// The number of the two words.
  /// needs   |low| at most half a unit in the last place of high, as two_sum and two_product give them
  IRG_INLINE constexpr double_word(T high_word, T low_word) noexcept : high(high_word), low(low_word) {}

  /// The nearest T.
  IRG_INLINE constexpr explicit operator T() const noexcept { return high; }

  IRG_INLINE constexpr double_word operator-() const noexcept { return {-high, -low}; }

  /// exact   relative error below 3u^2 + 13u^3
  /// cost    20 operations
  /// source  Li et al. 2002 (AccurateDWPlusDW)
  IRG_INLINE friend constexpr double_word operator+(const double_word& x, const double_word& y) noexcept {
    const auto heads = two_sum(x.high, y.high);
    if (!is_finite(heads.value)) return heads.value;
    return detail::finite_words(detail::accurate_sum(heads, x.parts(), y.parts()));
  }
  /// exact   relative error at most 2u^2
  /// cost    10 operations
  /// source  Joldes, Muller and Popescu 2017 (DWPlusFP)
  IRG_INLINE friend constexpr double_word operator+(const double_word& x, T y) noexcept {
    const auto [heads, heads_error] = two_sum(x.high, y);
    if (!is_finite(heads)) return heads;
    return detail::finite_words(fast_two_sum(heads, x.low + heads_error));
  }
  IRG_INLINE friend constexpr double_word operator+(T x, const double_word& y) noexcept { return y + x; }
  IRG_INLINE friend constexpr double_word operator-(const double_word& x, const double_word& y) noexcept {
    return x + (-y);
  }
  IRG_INLINE friend constexpr double_word operator-(const double_word& x, T y) noexcept { return x + (-y); }
  IRG_INLINE friend constexpr double_word operator-(T x, const double_word& y) noexcept { return (-y) + x; }

  /// exact   relative error at most 5u^2
  /// cost    a two_product and 8 operations
  /// source  Dekker 1971 (DWTimesDW1)
  IRG_INLINE friend constexpr double_word operator*(const double_word& x, const double_word& y) noexcept {
    const auto heads = two_product(x.high, y.high);
    if (!is_finite(heads.value)) return heads.value;
    return detail::finite_words(detail::multiply(heads, x.parts(), y.parts()));
  }
  /// exact   relative error at most 3u^2
  /// source  Joldes, Muller and Popescu 2017 (DWTimesFP2)
  IRG_INLINE friend constexpr double_word operator*(const double_word& x, T y) noexcept {
    const auto [heads, error] = two_product(x.high, y);
    if (!is_finite(heads)) return heads;
    return detail::finite_words(fast_two_sum(heads, error + product(x.low, y)));
  }
  IRG_INLINE friend constexpr double_word operator*(T x, const double_word& y) noexcept { return y * x; }

  /// exact   relative error at most 15u^2 + 56u^3 (measured: below 6u^2)
  /// cost    two divisions, a two_product and 15 operations
  /// source  Joldes, Muller and Popescu 2017 (DWDivDW2)
  IRG_INLINE friend constexpr double_word operator/(const double_word& x, const double_word& y) noexcept {
    const T quotient = x.high / y.high;
    if (!is_finite(quotient) || quotient == 0 || !is_finite(y.high)) return quotient;
    const T size = magnitude(x.high);
    if (size < detail::least_of_exact_words<T> || size > detail::most_of_exact_words<T>)
      return detail::scaled_quotient(x, y);
    const double_word back = y * quotient;
    const T rest = (x.high - back.high) + (x.low - back.low);
    return detail::finite_words(fast_two_sum(quotient, rest / y.high));
  }

  IRG_INLINE constexpr double_word& operator+=(const double_word& y) noexcept { return *this = *this + y; }
  IRG_INLINE constexpr double_word& operator-=(const double_word& y) noexcept { return *this = *this - y; }
  IRG_INLINE constexpr double_word& operator*=(const double_word& y) noexcept { return *this = *this * y; }
  IRG_INLINE constexpr double_word& operator/=(const double_word& y) noexcept { return *this = *this / y; }

  /// The order of the numbers; false for all but != when one is NaN.
  IRG_INLINE friend constexpr bool operator==(const double_word& x, const double_word& y) noexcept {
    return x.high == y.high && x.low == y.low;
  }
  IRG_INLINE friend constexpr bool operator<(const double_word& x, const double_word& y) noexcept {
    return x.high < y.high || (x.high == y.high && x.low < y.low);
  }
  IRG_INLINE friend constexpr bool operator>(const double_word& x, const double_word& y) noexcept { return y < x; }
  IRG_INLINE friend constexpr bool operator<=(const double_word& x, const double_word& y) noexcept {
    return x.high < y.high || (x.high == y.high && x.low <= y.low);
  }
  IRG_INLINE friend constexpr bool operator>=(const double_word& x, const double_word& y) noexcept { return y <= x; }

private:
  [[nodiscard]] IRG_INLINE constexpr exact_sum<T> parts() const noexcept { return {high, low}; }
};

using double_double = double_word<double>;

namespace detail::inline IRG_ABI {

/// x/y for an x near an end of the range: x, or both of them, go to the middle by 2^537 or 2^-537 (float: 2^72).
template <Floating T>
constexpr double_word<T> scaled_quotient(const double_word<T>& x, const double_word<T>& y) noexcept {
  constexpr bool is_double = std::is_same_v<T, double>;
  constexpr T up = is_double ? T(0x1p537) : T(0x1p72f), down = is_double ? T(0x1p-537) : T(0x1p-72f);
  const bool is_small = magnitude(x.high) < 1;
  const T there = is_small ? up : down, back = is_small ? down : up;
  const double_word<T> dividend{x.high * there, x.low * there};
  if ((magnitude(y.high) < 1) == is_small) return dividend / double_word<T>{y.high * there, y.low * there};
  const double_word<T> quotient = dividend / y;
  return finite_words(fast_two_sum(quotient.high * back, quotient.low * back));
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The square root.
/// gives   -0 for -0, infinity for infinity, NaN for NaN and everything below zero
/// exact   relative error at most 25/8 u^2
/// source  Lefevre et al. 2023 (SQRTDWtoDW)
template <Floating T>
[[nodiscard]] constexpr double_word<T> sqrt(const double_word<T>& x) noexcept {
  const T root = sqrt(x.high);
  if (!(root > 0) || !is_finite(root)) return root;
  if (x.high < detail::least_of_exact_words<T>) {
    constexpr bool is_double = std::is_same_v<T, double>;
    constexpr T up = is_double ? T(0x1p600) : T(0x1p80f), back = is_double ? T(0x1p-300) : T(0x1p-40f);
    const double_word<T> scaled = sqrt(double_word<T>{x.high * up, x.low * up});
    return {scaled.high * back, scaled.low * back};
  }
  const auto [square, error] = two_product(root, root);
  return detail::finite_words(fast_two_sum(root, (((x.high - square) - error) + x.low) / (2 * root)));
}

/// |x|.
template <Floating T>
[[nodiscard]] constexpr double_word<T> abs(const double_word<T>& x) noexcept {
  return x.high < 0 ? -x : x;
}

}  // namespace IRG_ABI
}  // namespace irg
