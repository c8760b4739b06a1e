// SPDX-License-Identifier: MIT
// Stages of sign_of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <irg/math/detail/filter_kernel.hpp>
#include <irg/math/exact/filtered_number.hpp>
#include <irg/math/exact/values_of.hpp>
#include <irg/math/int128.hpp>

namespace irg::detail::inline IRG_ABI {

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

// The signs of values that are zero or nearly so, computed in numbers of which none is too large.
template <int Degree, class Signs, class Values, class Polynomial, class... A>
IRG_NOINLINE constexpr Signs sign_near_zero(const Values& values, const Polynomial& polynomial,
                                            const A&... arguments) noexcept {
  const Signs all = for_numbers(values, [](const filtered_number& v) { return filtered_sign(v); });
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
