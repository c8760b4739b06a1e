// SPDX-License-Identifier: MIT
// The numbers that algorithms compute with.
#pragma once

#include <concepts>
#include <limits>
#include <type_traits>

#include <irg/core/config.hpp>

namespace irg {

namespace detail {
// What an operation gives is a number, if of another type, and no expression that is computed later, when its operands
// may be gone; and the number's own type.
template <class X>
concept no_expression = std::default_initializable<std::remove_cvref_t<X>>;
template <class X, class T>
concept gives_number = std::same_as<std::remove_cvref_t<X>, T>;
}  // namespace detail

/// What polynomials are computed in: sums, differences and products. Models: every Scalar, and the exact numbers and
/// numbers with a bound of their error that sign_of and values_of (math/exact) hand to a polynomial.
template <class T>
concept Number = !std::same_as<T, bool> && std::same_as<T, std::remove_cvref_t<T>> &&
                 (std::is_arithmetic_v<T> || requires(T& to, const T a, const T b) {
                   T();
                   T(a);
                   to = b;
                   static_cast<bool>(a == b);
                   { a + b } -> detail::no_expression;
                   { a - b } -> detail::no_expression;
                   { a* b } -> detail::no_expression;
                   { -a } -> detail::no_expression;
                 });

/// A number that is ordered, with the four operations, made from small integers. Models: every built-in arithmetic type
/// but bool, rationals, double-double, interval and fixed-point types, Boost.Multiprecision's with et_off. Not those
/// whose operators give expressions, as GMP's mpq_class.
template <class T>
concept Scalar = Number<T> && (std::is_arithmetic_v<T> || requires(const T a, const T b) {
                   static_cast<T>(1);
                   { a + b } -> detail::gives_number<T>;
                   { a - b } -> detail::gives_number<T>;
                   { a* b } -> detail::gives_number<T>;
                   { a / b } -> detail::gives_number<T>;
                   { -a } -> detail::gives_number<T>;
                   { a < b } -> std::convertible_to<bool>;
                 });

/// A number whose division is no truncation. Models: float, double, rationals and the like; not the integers, of any
/// size and library.
template <class T>
concept Real = Scalar<T> && !std::integral<T> && !std::numeric_limits<T>::is_integer;

/// float or double: the numbers that irg's own elementary functions are written for.
template <class T>
concept Floating = std::same_as<T, float> || std::same_as<T, double>;

/// Numbers of different types, or integers, as a function's arguments: it takes them as the standard library's do, as
/// doubles.
template <class... T>
concept MixedArguments = (std::is_arithmetic_v<T> && ...) && !(std::same_as<T, float> && ...) &&
                         !(std::same_as<T, double> && ...) && (!std::same_as<T, long double> && ...);

/// What takes numbers of type T, and text, by <<, as std::ostream does. No stream's header is included for it.
template <class S, class T = double>
concept TextStream = requires(S& stream, const T& number) {
  stream << 1.0 << "x";
  stream << number;
};

inline namespace IRG_ABI {

/// Writes at(0) to at(count - 1) as "(1, 2, 3)", bytes as numbers. So go points, colours and matrices into a stream.
template <class S, class At>
constexpr S& print_list(S& stream, int count, const At& at) {
  for (int i = 0; i < count; ++i) {
    stream << (i == 0 ? "(" : ", ");
    if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(at(i))>>)
      stream << +at(i);
    else
      stream << at(i);
  }
  stream << ")";
  return stream;
}

/// The smaller of two numbers; b when they are unordered (a is NaN).
template <class T>
[[nodiscard]] IRG_INLINE constexpr T minimum(T a, T b) noexcept(noexcept(a < b)) {
  return a < b ? a : b;
}

/// The larger of two numbers; b when they are unordered (a is NaN).
template <class T>
[[nodiscard]] IRG_INLINE constexpr T maximum(T a, T b) noexcept(noexcept(b < a)) {
  return b < a ? a : b;
}

/// x, limited to [low, high]; low when x is NaN.
template <class T>
[[nodiscard]] IRG_INLINE constexpr T clamped(T x, T low, T high) noexcept(noexcept(x < low)) {
  return low < x ? (x < high ? x : high) : low;
}

}  // namespace IRG_ABI
}  // namespace irg
