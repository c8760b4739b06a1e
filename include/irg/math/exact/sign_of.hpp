// SPDX-License-Identifier: MIT
// Signs of polynomials, exactly: a polynomial is written once, as in the book, and computed in doubles with a bound of
// the error, in twice the precision where that does not tell, and in exact numbers where neither does. For decisions
// that no predicate of its own makes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <irg/math/exact/filtered_number.hpp>
#include <irg/math/exact/values_of.hpp>
#include <irg/math/int128.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// 2 where rounding leaves it open.
IRG_INLINE constexpr int filtered_sign(const filtered_number& x) noexcept {
  const double bound = polynomial_filter_bound * x.size;
  const int sign = (x.value > bound ? 1 : 0) - (-x.value > bound ? 1 : 0);  // without a branch that signs mispredict
  return sign != 0 || x.size == 0 ? sign : 2;
}
IRG_INLINE constexpr bool are_sure(int sign) noexcept { return sign != 2; }
template <std::size_t Size>
IRG_INLINE constexpr bool are_sure(const std::array<int, Size>& signs) noexcept {
  for (const int s : signs)
    if (s == 2) return false;
  return true;
}

template <int Degree, class Signs, class Polynomial, class... A>
IRG_NOINLINE constexpr Signs exact_sign(const Polynomial& polynomial, const A&... arguments) noexcept {
  using number = exact_number<Degree>;
  bool finite = true;
  const auto exact = [&](const auto& x) {
    finite = finite && is_finite(x);
    return exactly<number>(x);
  };
  const auto signs = [&](const auto&... x) {
    return finite ? for_numbers(polynomial(x...), [](const number& v) { return v.sign(); }) : Signs{};
  };
  return signs(in_numbers<number>(arguments, exact)...);
}

template <int Degree, class Signs, class Polynomial, class... A>
IRG_NOINLINE constexpr Signs unfiltered_sign(const Polynomial& polynomial, const A&... arguments) noexcept {
  if constexpr (Degree <= 6) {
    const auto values = values_of<Degree>(polynomial, arguments...);
    return values ? for_numbers(*values, [](const auto& x) { return irg::sign_of(x); }) : Signs{};
  } else {
    return exact_sign<Degree, Signs>(polynomial, arguments...);
  }
}

// Integers whose sums and differences have polynomials of this degree, of up to 2^10 terms, below 2^127.
template <int Degree, class T>
IRG_INLINE constexpr bool suits_int128(const T& x) noexcept {
  constexpr int bits = 116 / Degree - 1;
  if constexpr (8 * sizeof(T) <= bits)
    return true;
  else
    return int128(x) >> bits == 0 || int128(x) >> bits == -1;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// -1, 0 or 1, as polynomial(arguments...) is negative, zero or positive; an array of signs when it gives an array.
/// shape   the polynomial as values_of takes it; it gives a number or a std::array of numbers
/// needs   a polynomial of at most this degree, 9 at most, with at most 2^10 terms
/// gives   0 when a number is NaN or infinite
/// exact   for all finite floats and doubles, and all integers; other scalars: as exact as their own + - *
/// cost    twice the polynomial in doubles where the value is not nearly 0; beyond, 100 ns to some microseconds
/// source  Shewchuk 1997 (the stages)
template <int Degree, class Polynomial, class... A>
  requires(sizeof...(A) > 0)
[[nodiscard]] IRG_INLINE constexpr auto sign_of(const Polynomial& polynomial, const A&... arguments) noexcept {
  static_assert(Degree >= 1 && Degree <= 9);
  using detail::in_numbers;
  using T = detail::argument_scalar<A...>;
  if constexpr (Floating<T>) {
    bool suits = true;
    const auto input = [&](const T& x) IRG_INLINE_LAMBDA {
      suits = suits && detail::suits_filter<Degree>(x);
      return filtered_input{widened(x)};
    };
    const auto stages = [&](const auto&... x) IRG_INLINE_LAMBDA {
      const auto sign = [](const filtered_number& v) IRG_INLINE_LAMBDA { return detail::filtered_sign(v); };
      using signs = decltype(detail::for_numbers(polynomial(x...), sign));
      if (suits) {
        const signs all = detail::for_numbers(polynomial(x...), sign);
        if (detail::are_sure(all)) return all;
      }
      return detail::unfiltered_sign<Degree, signs>(polynomial, arguments...);
    };
    return stages(in_numbers<filtered_number>(arguments, input)...);
  } else if constexpr (std::is_integral_v<T>) {
    bool suits = true;
    const auto wide = [&](const T& x) IRG_INLINE_LAMBDA {
      suits = suits && detail::suits_int128<Degree>(x);
      return int128(x);
    };
    const auto stages = [&](const auto&... x) IRG_INLINE_LAMBDA {
      const auto sign = [](const int128& v) { return v < 0 ? -1 : v > 0 ? 1 : 0; };
      using signs = decltype(detail::for_numbers(polynomial(x...), sign));
      return suits ? detail::for_numbers(polynomial(x...), sign)
                   : detail::exact_sign<Degree, signs>(polynomial, arguments...);
    };
    return stages(in_numbers<int128>(arguments, wide)...);
  } else {
    return detail::for_numbers(polynomial(in_numbers<T>(arguments, [](const T& x) { return x; })...),
                               [](const auto& x) { return irg::sign_of(x); });
  }
}

}  // namespace IRG_ABI
}  // namespace irg
