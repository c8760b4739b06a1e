// SPDX-License-Identifier: MIT
// filtered_number: a double with what its error is measured by, the filter of exact decisions. filtered_input is one as
// it came, of which a difference is rounded once.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <irg/math/exact/in_numbers.hpp>
#include <irg/math/float_bits.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A rounded number; `size` is what it would be if all terms were positive, which is what its error is measured by.
struct filtered_number {
  double value = 0, size = 0;

  bool operator==(const filtered_number&) const = default;
  IRG_INLINE friend constexpr filtered_number operator-(const filtered_number& a) noexcept {
    return {-a.value, a.size};
  }
  IRG_INLINE friend constexpr filtered_number operator+(const filtered_number& a, const filtered_number& b) noexcept {
    return {a.value + b.value, a.size + b.size};
  }
  IRG_INLINE friend constexpr filtered_number operator-(const filtered_number& a, const filtered_number& b) noexcept {
    return {a.value - b.value, a.size + b.size};
  }
  IRG_INLINE friend constexpr filtered_number operator*(const filtered_number& a, const filtered_number& b) noexcept {
    return {product(a.value, b.value), product(a.size, b.size)};
  }
};

/// A number as it came: not off by anything, so that a sum or difference of two is off by its own rounding only.
struct filtered_input {
  double value = 0;

  bool operator==(const filtered_input&) const = default;
  IRG_INLINE constexpr operator filtered_number() const noexcept { return {value, magnitude(value)}; }
  IRG_INLINE friend constexpr filtered_input operator-(const filtered_input& a) noexcept { return {-a.value}; }
  IRG_INLINE friend constexpr filtered_number operator+(const filtered_input& a, const filtered_input& b) noexcept {
    return filtered_input{a.value + b.value};
  }
  IRG_INLINE friend constexpr filtered_number operator-(const filtered_input& a, const filtered_input& b) noexcept {
    return filtered_input{a.value - b.value};
  }
  IRG_INLINE friend constexpr filtered_number operator*(const filtered_input& a, const filtered_input& b) noexcept {
    return filtered_input{product(a.value, b.value)};
  }
};

inline namespace IRG_ABI {

template <int N>
[[nodiscard]] IRG_INLINE constexpr vec<filtered_number, N> operator-(const point<filtered_input, N>& a,
                                                                     const point<filtered_input, N>& b) noexcept {
  return generate_coordinates<vec<filtered_number, N>>([&](int i) IRG_INLINE_LAMBDA { return a[i] - b[i]; });
}
template <int N>
[[nodiscard]] IRG_INLINE constexpr vec<filtered_number, N> to_vec(const point<filtered_input, N>& p) noexcept {
  return generate_coordinates<vec<filtered_number, N>>([&](int i) IRG_INLINE_LAMBDA { return filtered_number(p[i]); });
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Less than 60 roundings lie on the way from an argument to the value of a polynomial of degree 9 of up to 2^10 terms.
inline constexpr double polynomial_filter_bound = 0x1p-46;

// Polynomials of this degree in numbers below 2^filter_reach do not overflow.
template <int Degree>
inline constexpr int filter_reach = Degree <= 2 ? 400 : 900 / Degree - 50;

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Whether polynomials of this degree in such numbers neither over- nor underflow, so that a filter may compute them.
/// gives   true for 0. False for floats that are subnormal: what makes a double of one may take it for zero
template <int Degree>
[[nodiscard]] IRG_INLINE constexpr bool suits_filter(double x) noexcept {
  return is_zero_or_within<-detail::filter_reach<Degree>, detail::filter_reach<Degree>>(x);
}
template <int Degree>
[[nodiscard]] IRG_INLINE constexpr bool suits_filter(float x) noexcept {
  constexpr std::uint32_t least_normal = std::uint32_t{1} << 24, infinite = std::uint32_t{255} << 24;
  const std::uint32_t size = std::bit_cast<std::uint32_t>(x) << 1;
  if constexpr (Degree <= 2)
    return (size - 1 >= least_normal - 1) & (size < infinite);
  else
    return size - 1 >= least_normal - 1 && suits_filter<Degree>(widened(x));
}

/// polynomial(arguments...) in rounded numbers: off by at most 2^-46 of its size.
/// shape   as sign_of takes it
/// gives   nothing for numbers so large or small that something could over- or underflow, NaN and infinity among them
template <int Degree, class Polynomial, class... A>
  requires Floating<detail::argument_scalar<A...>>
[[nodiscard]] IRG_INLINE constexpr auto filtered_value_of(const Polynomial& polynomial,
                                                          const A&... arguments) noexcept {
  using T = detail::argument_scalar<A...>;
  bool suits = true;
  const auto input = [&](const T& x) IRG_INLINE_LAMBDA {
    suits = suits && suits_filter<Degree>(x);
    return filtered_input{widened(x)};
  };
  const auto value = [&](const auto&... x) IRG_INLINE_LAMBDA {
    using R = decltype(polynomial(x...));
    return suits ? std::optional<R>(polynomial(x...)) : std::optional<R>();
  };
  return value(in_numbers<filtered_number>(arguments, input)...);
}

}  // namespace IRG_ABI
}  // namespace irg
