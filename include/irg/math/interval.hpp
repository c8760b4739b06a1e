// SPDX-License-Identifier: MIT
// Intervals: numbers with their uncertainty. Every operation gives an interval that contains f(x, y) for all x and y of
// its arguments for which f has a value, rounded outwards without touching the processor's rounding mode.
#pragma once

#include <concepts>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/unrounded.hpp>

namespace irg {

template <Floating T>
class interval;

namespace detail::inline IRG_ABI {

template <Floating T>
constexpr interval<T> interval_sum(const interval<T>& a, const interval<T>& b) noexcept;
template <Floating T>
constexpr interval<T> interval_product(const interval<T>& a, const interval<T>& b) noexcept;
template <Floating T>
constexpr interval<T> interval_quotient(const interval<T>& a, const interval<T>& b) noexcept;

}  // namespace detail::inline IRG_ABI

/// The real numbers from lower() to upper().
/// shape   an end may be infinite: then there is no bound on that side. The empty interval contains nothing
/// exact   ends are the nearest outward numbers; where a product or a quotient is below 2^-900, or a quotient or its
///         dividend above 2^1020, they may be one step further out (float: never)
template <Floating T>
class interval {
public:
  /// The number 0.
  IRG_INLINE constexpr interval() noexcept {}
  /// The number x.
  /// gives   what lies beyond the largest number for an infinity, the whole line for NaN
  IRG_INLINE constexpr interval(T x) noexcept : interval(x, x) {}
  /// The integer i, between two neighbouring numbers where it is none itself.
  template <std::integral J>
    requires(!std::same_as<J, bool>)
  IRG_INLINE constexpr interval(J i) noexcept;
  /// The numbers from `lower` to `upper`.
  /// gives   the empty interval when upper < lower, the whole line when one is NaN
  IRG_INLINE constexpr interval(T lower, T upper) noexcept;
  /// All numbers.
  IRG_INLINE static constexpr interval whole() noexcept {
    interval all;
    all.lower_ = -infinity<T>;
    all.upper_ = infinity<T>;
    return all;
  }
  /// No number.
  IRG_INLINE static constexpr interval empty() noexcept {
    interval none;
    none.lower_ = infinity<T>;
    none.upper_ = -infinity<T>;
    return none;
  }

  [[nodiscard]] IRG_INLINE constexpr T lower() const noexcept { return lower_; }
  [[nodiscard]] IRG_INLINE constexpr T upper() const noexcept { return upper_; }
  [[nodiscard]] IRG_INLINE constexpr bool is_empty() const noexcept { return upper_ < lower_; }

  IRG_INLINE constexpr interval operator-() const noexcept { return is_empty() ? *this : interval(-upper_, -lower_); }
  IRG_INLINE friend constexpr interval operator+(const interval& a, const interval& b) noexcept {
    return detail::interval_sum(a, b);
  }
  IRG_INLINE friend constexpr interval operator-(const interval& a, const interval& b) noexcept {
    return detail::interval_sum(a, -b);
  }
  IRG_INLINE friend constexpr interval operator*(const interval& a, const interval& b) noexcept {
    return detail::interval_product(a, b);
  }
  /// gives   the whole line when b has 0 inside, a half-line when 0 is an end of b and the sign of a is certain, the
  ///         empty interval for the divisor 0 alone
  IRG_INLINE friend constexpr interval operator/(const interval& a, const interval& b) noexcept {
    return detail::interval_quotient(a, b);
  }

  /// Whether the two are the same interval; possibly_equal and certainly_equal compare the numbers.
  constexpr bool operator==(const interval&) const noexcept = default;
  /// Whether every number of a is less than every number of b: certainly less. Neither a < b nor b < a nor a == b holds
  /// where that is open. The empty interval is less than nothing.
  IRG_INLINE friend constexpr bool operator<(const interval& a, const interval& b) noexcept {
    return !a.is_empty() && !b.is_empty() && a.upper_ < b.lower_;
  }
  IRG_INLINE friend constexpr bool operator>(const interval& a, const interval& b) noexcept { return b < a; }

private:
  T lower_{}, upper_{};
};

inline namespace IRG_ABI {

/// Whether some number of a is less than some number of b.
template <Floating T>
[[nodiscard]] constexpr bool possibly_less(const interval<T>& a, const interval<T>& b) noexcept {
  return !a.is_empty() && !b.is_empty() && a.lower() < b.upper();
}

/// Whether a and b have a number in common.
template <Floating T>
[[nodiscard]] constexpr bool possibly_equal(const interval<T>& a, const interval<T>& b) noexcept {
  return !a.is_empty() && !b.is_empty() && !(a < b) && !(b < a);
}

/// Whether a and b are the same single number.
template <Floating T>
[[nodiscard]] constexpr bool certainly_equal(const interval<T>& a, const interval<T>& b) noexcept {
  return a == b && a.lower() == a.upper();
}

/// -1, 0 or 1, as all numbers of a are negative, zero or positive.
/// gives   nothing where they differ, or there are none
template <Floating T>
[[nodiscard]] constexpr std::optional<int> certain_sign(const interval<T>& a) noexcept {
  if (a > interval<T>()) return 1;
  if (a < interval<T>()) return -1;
  return certainly_equal(a, interval<T>()) ? std::optional<int>(0) : std::nullopt;
}

/// Whether x is one of the numbers.
template <Floating T>
[[nodiscard]] constexpr bool contains(const interval<T>& a, std::type_identity_t<T> x) noexcept {
  return a.lower() <= x && x <= a.upper() && is_finite(x);
}

/// Whether every number of b is in a.
template <Floating T>
[[nodiscard]] constexpr bool contains(const interval<T>& a, const interval<T>& b) noexcept {
  return b.is_empty() || (a.lower() <= b.lower() && b.upper() <= a.upper());
}

/// upper() - lower(), rounded up.
/// gives   0 for the empty interval
template <Floating T>
[[nodiscard]] constexpr T width(const interval<T>& a) noexcept;

/// A number in the middle of a.
/// needs   a is not empty
/// gives   0 for the whole line, the largest number for half a line
template <Floating T>
[[nodiscard]] constexpr T middle(const interval<T>& a) noexcept;

/// The numbers that are in both.
template <Floating T>
[[nodiscard]] constexpr interval<T> intersect(const interval<T>& a, const interval<T>& b) noexcept {
  return {maximum(a.lower(), b.lower()), minimum(a.upper(), b.upper())};
}

/// The smallest interval that contains both.
template <Floating T>
[[nodiscard]] constexpr interval<T> hull(const interval<T>& a, const interval<T>& b) noexcept {
  if (a.is_empty()) return b;
  return b.is_empty() ? a : interval<T>(minimum(a.lower(), b.lower()), maximum(a.upper(), b.upper()));
}

/// The squares; narrower than a*a, and never negative.
template <Floating T>
[[nodiscard]] constexpr interval<T> square(const interval<T>& a) noexcept;

/// The square roots of the numbers that have one.
/// gives   the empty interval when all are negative
template <Floating T>
[[nodiscard]] constexpr interval<T> sqrt(const interval<T>& a) noexcept;

/// The magnitudes.
template <Floating T>
[[nodiscard]] constexpr interval<T> abs(const interval<T>& a) noexcept {
  if (a.is_empty() || a.lower() >= 0) return a;
  return a.upper() <= 0 ? -a : interval<T>(T(0), maximum(-a.lower(), a.upper()));
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Sums, products, quotients and roots rounded downwards, without touching the rounding mode: the rounded result and the
// sign of its exact error. Rounding upwards is rounding the negative downwards.

template <Floating T>
inline constexpr T largest_number = (std::numeric_limits<T>::max)();

/// The largest number below x.
/// needs   x is not -infinity
template <Floating T>
IRG_INLINE constexpr T next_down(T x) noexcept {
  using bits_type = std::conditional_t<std::is_same_v<T, double>, std::uint64_t, std::uint32_t>;
  if (x == 0) return -std::numeric_limits<T>::denorm_min();
  const auto bits = std::bit_cast<bits_type>(x);
  return std::bit_cast<T>(static_cast<bits_type>(x < 0 ? bits + 1 : bits - 1));
}

/// The rounded result, or its neighbour below where that is too large.
template <Floating T>
IRG_INLINE constexpr T lowered(T rounded, bool is_too_large) noexcept {
  if (rounded == infinity<T>) return largest_number<T>;
  return is_too_large && rounded != -infinity<T> ? next_down(rounded) : rounded;
}

/// Below the range in which errors are known: one step down, but not from positive numbers to negative ones.
template <Floating T>
IRG_INLINE constexpr T lowered_blindly(T rounded, bool is_positive) noexcept {
  return rounded == 0 && is_positive ? T(0) : lowered(rounded, true);
}

/// a + b, rounded downwards.
/// needs   a and b below infinity
template <Floating T>
constexpr T sum_down(T a, T b) noexcept {
  if (a == -infinity<T> || b == -infinity<T>) return -infinity<T>;
  if (is_refused_sum(a, b)) return a < 0 ? -infinity<T> : largest_number<T>;
  const auto [value, error] = two_sum(a, b);
  return lowered(value, error < 0);
}

/// a*b, rounded downwards; 0 times infinity is 0, as it is for the end points of intervals.
template <Floating T>
constexpr T product_down(T a, T b) noexcept {
  if (a == 0 || b == 0) return T(0);
  const bool is_positive = (a < 0) == (b < 0);
  if (!is_finite(a) || !is_finite(b)) return is_positive ? infinity<T> : -infinity<T>;
  if constexpr (std::is_same_v<T, float>) {
    const double exact = widened(a) * widened(b);
    const T value = narrowed<T>(exact);
    return lowered(value, widened(value) > exact);
  } else {
    const auto [value, error] = two_product(a, b);
    return magnitude(value) < 0x1p-960 ? lowered_blindly(value, is_positive) : lowered(value, error < 0);
  }
}

/// a/b, rounded downwards; infinity over infinity is 0.
/// needs   b > 0
template <Floating T>
constexpr T quotient_down(T a, T b) noexcept {
  if (a == 0 || !is_finite(b)) return T(0);
  const bool is_positive = a > 0;
  if (!is_finite(a)) return is_positive ? infinity<T> : -infinity<T>;
  if constexpr (std::is_same_v<T, float>) {
    const T value = narrowed<T>(widened(a) / widened(b));
    const double back = widened(value) * widened(b);
    return lowered(value, back > widened(a));
  } else {
    if (is_refused_quotient(a, b)) return is_positive ? largest_number<T> : -infinity<T>;
    const T value = a / b;
    if (!(magnitude(a) < 0x1p1020 && magnitude(value) > 0x1p-960 && magnitude(value) < 0x1p1020))
      return lowered_blindly(value, is_positive);
    // A dividend near the smallest number and the smaller factor are scaled, so that the error is a number.
    const T up = magnitude(a) > 0x1p-900 ? T(1) : T(0x1p200);
    const bool is_large = magnitude(value) > 1;
    const auto [back, error] = two_product(is_large ? value : value * up, is_large ? b * up : b);
    const T rest = (a * up - back) - error;  // exact, as the remainder of every division
    return lowered(value, rest < 0);
  }
}

/// The square root, rounded downwards or upwards.
/// needs   x >= 0
template <Floating T>
constexpr T sqrt_directed(T x, bool upwards) noexcept {
  if (x == 0 || !is_finite(x)) return x;
  const T root = sqrt(x);
  double rest = 0;
  if constexpr (std::is_same_v<T, float>) {
    rest = widened(x) - widened(root) * widened(root);
  } else {
    const bool is_small = x < 0x1p-900;
    const auto [back, error] = two_product(is_small ? root * 0x1p100 : root, is_small ? root * 0x1p100 : root);
    rest = ((is_small ? x * 0x1p200 : x) - back) - error;
  }
  if (upwards) return rest > 0 ? -next_down(-root) : root;
  return lowered(root, rest < 0);
}

template <Floating T>
constexpr interval<T> interval_sum(const interval<T>& a, const interval<T>& b) noexcept {
  if (a.is_empty() || b.is_empty()) return interval<T>::empty();
  return {sum_down(a.lower(), b.lower()), -sum_down(-a.upper(), -b.upper())};
}

template <Floating T>
constexpr interval<T> interval_product(const interval<T>& a, const interval<T>& b) noexcept {
  if (a.is_empty() || b.is_empty()) return interval<T>::empty();
  const auto lowest = [](const interval<T>& x, const interval<T>& y) {
    return minimum(minimum(product_down(x.lower(), y.lower()), product_down(x.lower(), y.upper())),
                   minimum(product_down(x.upper(), y.lower()), product_down(x.upper(), y.upper())));
  };
  return {lowest(a, b), -lowest(-a, b)};
}

template <Floating T>
constexpr interval<T> interval_quotient(const interval<T>& a, const interval<T>& b) noexcept {
  if (a.is_empty() || b.is_empty() || (b.lower() == 0 && b.upper() == 0)) return interval<T>::empty();
  if (a.lower() == 0 && a.upper() == 0) return T(0);
  if (b.lower() < 0 && b.upper() > 0) return interval<T>::whole();
  if (b.upper() <= 0) return interval_quotient(-a, -b);
  const auto lowest = [&](const interval<T>& x) {  // the divisors lie between 0 and b.upper()
    if (x.lower() >= 0) return quotient_down(x.lower(), b.upper());
    return b.lower() == 0 ? -infinity<T> : quotient_down(x.lower(), b.lower());
  };
  return {lowest(a), -lowest(-a)};
}

}  // namespace detail::inline IRG_ABI

template <Floating T>
template <std::integral J>
  requires(!std::same_as<J, bool>)
IRG_INLINE constexpr interval<T>::interval(J i) noexcept : interval(static_cast<T>(i)) {
  if constexpr (std::numeric_limits<J>::digits > std::numeric_limits<T>::digits) {
    constexpr J limit = J{1} << std::numeric_limits<T>::digits;
    if (i <= limit && (std::unsigned_integral<J> || i >= J(0) - limit)) return;
    lower_ = detail::next_down(lower_);
    upper_ = -detail::next_down(-upper_);
  }
}

template <Floating T>
IRG_INLINE constexpr interval<T>::interval(T lower, T upper) noexcept : lower_(lower), upper_(upper) {
  if (lower != lower || upper != upper)
    *this = whole();
  else if (upper < lower)
    *this = empty();
  else if (lower == infinity<T>)
    lower_ = detail::largest_number<T>;
  else if (upper == -infinity<T>)
    upper_ = -detail::largest_number<T>;
}

inline namespace IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr T width(const interval<T>& a) noexcept {
  return a.is_empty() ? T(0) : -detail::sum_down(a.lower(), -a.upper());
}

template <Floating T>
[[nodiscard]] constexpr T middle(const interval<T>& a) noexcept {
  const bool left = is_finite(a.lower()), right = is_finite(a.upper());
  if (!left || !right) return left ? detail::largest_number<T> : right ? -detail::largest_number<T> : T(0);
  const T sum = T(0.5) * a.lower() + T(0.5) * a.upper();
  return clamped(sum, a.lower(), a.upper());
}

template <Floating T>
[[nodiscard]] constexpr interval<T> square(const interval<T>& a) noexcept {
  if (a.is_empty()) return a;
  const T outer = maximum(-a.lower(), a.upper()), inner = minimum(-a.lower(), a.upper());
  return {inner >= 0 ? T(0) : detail::product_down(inner, inner), -detail::product_down(-outer, outer)};
}

template <Floating T>
[[nodiscard]] constexpr interval<T> sqrt(const interval<T>& a) noexcept {
  if (a.is_empty() || a.upper() < 0) return interval<T>::empty();
  return {a.lower() <= 0 ? T(0) : detail::sqrt_directed(a.lower(), false), detail::sqrt_directed(a.upper(), true)};
}

}  // namespace IRG_ABI
}  // namespace irg
