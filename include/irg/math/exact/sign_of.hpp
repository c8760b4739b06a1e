// SPDX-License-Identifier: MIT
// Signs of polynomials, exactly: a polynomial is written once, as in the book, and computed in doubles with a bound of
// the error, in twice the precision where that does not tell, and in big floats where neither does. For decisions
// that no predicate of its own makes.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include <irg/math/exact/filtered_number.hpp>
#include <irg/math/exact/values_of.hpp>
#include <irg/math/int128.hpp>

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
[[nodiscard]] IRG_INLINE constexpr auto sign_of(const Polynomial& polynomial, const A&... arguments) noexcept;

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The filter of sign_of: which numbers it takes, and which values tell their sign.

// -1 or 1, as x is beyond -bound or bound, without a branch that signs mispredict; else what is given instead.
IRG_INLINE constexpr int sign_beyond(double bound, double x, int otherwise) noexcept {
  return magnitude(x) > bound ? 1 - 2 * static_cast<int>(bits_of(x) >> 63) : otherwise;
}

// 2 where rounding leaves the sign open, in numbers that suit the filter.
IRG_INLINE constexpr int sign_by_filter(const filtered_number& x) noexcept {
  return sign_beyond(polynomial_filter_bound * x.size, x.value, x.size == 0 ? 0 : 2);
}

// What is asked of the numbers before a polynomial is computed in them, and of its value after.
template <Floating T, int Degree>
class filter_range {
public:
  IRG_INLINE constexpr void include(T x) noexcept { suits_ = suits_ && suits_filter<Degree>(x); }
  [[nodiscard]] IRG_INLINE constexpr bool suits() const noexcept { return suits_; }
  [[nodiscard]] IRG_INLINE static constexpr int sign_of(const filtered_number& x) noexcept { return sign_by_filter(x); }

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

// The stages after the filter.

IRG_INLINE constexpr bool are_sure(int sign) noexcept { return sign != 2; }
template <std::size_t Size>
IRG_INLINE constexpr bool are_sure(const std::array<int, Size>& signs) noexcept {
  for (const int s : signs)
    if (s == 2) return false;
  return true;
}

template <int Degree, class Signs, class Polynomial, class... A>
IRG_NOINLINE constexpr Signs exact_sign(const Polynomial& polynomial, const A&... arguments) noexcept {
  using number = big_float<Degree>;
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

// The signs of values that are zero or nearly so, computed in numbers of which none is too large.
template <int Degree, class Signs, class Values, class Polynomial, class... A>
IRG_NOINLINE constexpr Signs sign_near_zero(const Values& values, const Polynomial& polynomial,
                                            const A&... arguments) noexcept {
  const Signs all = for_numbers(values, [](const filtered_number& v) { return sign_by_filter(v); });
  if (are_sure(all)) {
    bool suits = true;
    const auto check = [&](const auto& x) {
      suits = suits & is_zero_or_from<-filter_reach<Degree>>(widened(x));
      return filtered_input{};
    };
    (static_cast<void>(in_numbers<filtered_number>(arguments, check)), ...);
    if (suits) return all;
  }
  return unfiltered_sign<Degree, Signs>(polynomial, arguments...);
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

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <int Degree, class Polynomial, class... A>
  requires(sizeof...(A) > 0)
[[nodiscard]] IRG_INLINE constexpr auto sign_of(const Polynomial& polynomial, const A&... arguments) noexcept {
  static_assert(Degree >= 1 && Degree <= 9);
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
