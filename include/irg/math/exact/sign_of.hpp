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
#include <irg/math/detail/sign_of_steps.hpp>

namespace irg::inline IRG_ABI {

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
    detail::filter_range<T, Degree> range;
    const auto input = [&](const T& x) IRG_INLINE_LAMBDA {
      range.include(x);
      return filtered_input{widened(x)};
    };
    const auto stages = [&](const auto&... x) IRG_INLINE_LAMBDA {
      using filter = detail::filter_range<T, Degree>;
      const auto sign = [](const filtered_number& v) IRG_INLINE_LAMBDA { return filter::sign_of(v); };
      using signs = decltype(detail::for_numbers(polynomial(x...), sign));
      if (!range.suits()) return detail::unfiltered_sign<Degree, signs>(polynomial, arguments...);
      const auto values = polynomial(x...);
      const signs all = detail::for_numbers(values, sign);
      if (detail::are_sure(all)) return all;
      return detail::sign_near_zero<Degree, signs>(values, polynomial, arguments...);
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

}  // namespace irg::inline IRG_ABI
