// SPDX-License-Identifier: MIT
// Values of polynomials right to 60 bits with the exact sign, for all finite floats and doubles: a polynomial is
// computed in twice the precision, and in big floats where that does not suffice. Quotients of such values are what
// intersections and nearest points are made of.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include <irg/math/detail/unrounded.hpp>
#include <irg/math/exact/big_float.hpp>
#include <irg/math/exact/in_numbers.hpp>
#include <irg/math/exact/scaled_double_double.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// What values_of knows the value of a polynomial in numbers of type T as.
template <Scalar T>
using known_value = std::conditional_t<Floating<T>, scaled_double_double, T>;

inline namespace IRG_ABI {

/// The values polynomial(arguments...): scaled double-doubles for floats, doubles and integers; other scalars compute
/// in their arithmetic.
/// shape   the polynomial takes its arguments with numbers of any type that has + - and * in the place of T: numbers
///         for numbers, vec, point and hpoint for vectors and points, arrays for larger arrays, and the same template
///         for what overloads in_numbers, as planes do; it gives a number, or an array, vec or tuple of numbers
/// needs   a polynomial of at most this degree, 6 at most
/// gives   nothing when a number is NaN or infinite
/// exact   in floats, doubles and integers each value within 2^-60 of its size, zeros and signs exactly
/// cost    some 10 ns for each product; where numbers nearly cancel or are beyond 2^+-80 (integers: 2^53), some
///         microseconds
template <int Degree, class Polynomial, class... A>
[[nodiscard]] constexpr auto known_values_of(const Polynomial& polynomial, const A&... arguments) noexcept;

/// The same, but integers, too, compute in their arithmetic.
template <int Degree, class Polynomial, class... A>
[[nodiscard]] IRG_INLINE constexpr auto values_of(const Polynomial& polynomial, const A&... arguments) noexcept {
  using T = detail::argument_scalar<A...>;
  if constexpr (std::is_integral_v<T>)
    return std::optional(polynomial(in_numbers<T>(arguments, [](const T& x) { return x; })...));
  else
    return known_values_of<Degree>(polynomial, arguments...);
}

}  // namespace IRG_ABI

namespace detail {

/// A double-double at most about `bound` away from the number it stands for, which tells whether its sign and value are
/// sure.
/// shape   the value is the sum rounded; bound is 0 when nothing was rounded on the way
/// needs   numbers made from doubles that are 0 or 2^-80 <= |x| < 2^80, and polynomials of degree 6 at most: all parts
///         are then multiples of 2^-800 below 2^500, so that nothing over- or underflows
struct bounded_double_double : unrounded {
  double bound = 0;

  constexpr bounded_double_double() = default;
  IRG_INLINE constexpr explicit bounded_double_double(double x) noexcept : unrounded{x, 0} {}
  IRG_INLINE constexpr bounded_double_double(const unrounded& x, double b) noexcept : unrounded(x), bound(b) {}

  bool operator==(const bounded_double_double&) const = default;
  IRG_INLINE friend constexpr bounded_double_double operator-(const bounded_double_double& a) noexcept {
    return {negated(a), a.bound};
  }
  IRG_INLINE friend constexpr bounded_double_double operator+(const bounded_double_double& a,
                                                              const bounded_double_double& b) noexcept {
    const unrounded sum = accurate_sum(a, b);
    return {sum, a.bound + b.bound + (is_exact(a, b) ? 0.0 : magnitude(sum.value) * 0x1p-104)};
  }
  IRG_INLINE friend constexpr bounded_double_double operator-(const bounded_double_double& a,
                                                              const bounded_double_double& b) noexcept {
    return a + -b;
  }
  IRG_INLINE friend constexpr bounded_double_double operator*(const bounded_double_double& a,
                                                              const bounded_double_double& b) noexcept {
    const unrounded whole = multiply(a, b);
    const double carried =
        product(magnitude(a.value), b.bound) + product(magnitude(b.value), a.bound) + product(a.bound, b.bound);
    return {whole, carried + (is_exact(a, b) ? 0.0 : magnitude(whole.value) * 0x1p-103)};
  }

  /// Whether the number is sure to have this sign and to be off by less than 2^-60 of its size. The factor 2^-61
  /// leaves room for the rounding of `bound` itself.
  IRG_INLINE constexpr bool is_sure() const noexcept { return bound <= magnitude(value) * 0x1p-61; }

private:
  // Whether the sum and the product are exact, being those of two doubles.
  IRG_INLINE static constexpr bool is_exact(const unrounded& a, const unrounded& b) noexcept {
    return a.error == 0 && b.error == 0;
  }
};

inline namespace IRG_ABI {

IRG_INLINE constexpr bool suits_double_double(double x) noexcept { return is_zero_or_within<-80, 80>(x); }

// each(x) for every number of what a polynomial gave, in the same arrangement.
template <class N, class F>
IRG_INLINE constexpr auto for_numbers(const N& x, const F& each) noexcept {
  return each(x);
}
template <class N, int D, class F>
IRG_INLINE constexpr auto for_numbers(const vec<N, D>& v, const F& each) noexcept {
  return generate_coordinates<vec<decltype(each(v[0])), D>>([&](int i) IRG_INLINE_LAMBDA { return each(v[i]); });
}
template <class N, std::size_t D, class F>
IRG_INLINE constexpr auto for_numbers(const std::array<N, D>& v, const F& each) noexcept {
  return [&]<std::size_t... J>(std::index_sequence<J...>) IRG_INLINE_LAMBDA {
    return std::array<decltype(each(v[0])), D>{each(v[J])...};
  }(std::make_index_sequence<D>{});
}
template <class... N, class F>
IRG_INLINE constexpr auto for_numbers(const std::tuple<N...>& t, const F& each) noexcept {
  return std::apply([&](const N&... x) IRG_INLINE_LAMBDA { return std::tuple{for_numbers(x, each)...}; }, t);
}

template <int Degree, class Polynomial, class... A>
IRG_NOINLINE constexpr auto exact_values_of(const Polynomial& polynomial, const A&... arguments) noexcept {
  using number = big_float<Degree>;
  const auto exact = [](const auto& x) { return exactly<number>(x); };
  return for_numbers(polynomial(in_numbers<number>(arguments, exact)...), [](const number& x) { return x.rounded(); });
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

template <int Degree, class Polynomial, class... A>
[[nodiscard]] constexpr auto known_values_of(const Polynomial& polynomial, const A&... arguments) noexcept {
  using T = detail::argument_scalar<A...>;
  if constexpr (Floating<T> || std::is_integral_v<T>) {
    static_assert(Degree >= 1 && Degree <= 6);
    bool suits = true, finite = true;
    const auto twice = [&](const T& x) IRG_INLINE_LAMBDA {
      double wide = 0;
      if constexpr (Floating<T>) {
        wide = exactly_widened(x);
        suits = suits && detail::suits_double_double(wide);
        finite = finite && is_finite(x);
      } else {
        wide = static_cast<double>(x);
        suits = suits && -0x1p53 < wide && wide < 0x1p53;
      }
      return detail::bounded_double_double(wide);
    };
    const auto stages = [&](const auto&... x) IRG_INLINE_LAMBDA {
      const auto known = [](const detail::bounded_double_double& v) { return scaled_double_double(v, 0); };
      using known_values = decltype(detail::for_numbers(polynomial(x...), known));
      if (suits) {
        const auto values = polynomial(x...);
        bool sure = true;
        const auto is_sure = [&](const detail::bounded_double_double& v) { return sure = sure && v.is_sure(), 0; };
        static_cast<void>(detail::for_numbers(values, is_sure));
        if (sure) return std::optional<known_values>(detail::for_numbers(values, known));
      }
      if (!finite) return std::optional<known_values>();
      return std::optional<known_values>(detail::exact_values_of<Degree>(polynomial, arguments...));
    };
    return stages(in_numbers<detail::bounded_double_double>(arguments, twice)...);
  } else {
    return std::optional(polynomial(in_numbers<T>(arguments, [](const T& x) { return x; })...));
  }
}

}  // namespace IRG_ABI
}  // namespace irg
