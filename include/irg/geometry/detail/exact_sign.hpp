// SPDX-License-Identifier: MIT
// The sign of a polynomial of degree 2 in coordinates, exact for every type: the polynomial is written once and
// computed in doubles with a bound of the error, in 128 bits where integers fit, and in exact numbers where these do
// not tell.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/dyadic.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/int128.hpp>

namespace irg::detail {

inline namespace IRG_ABI {

// -1, 0 or 1, as a is less than b, equal or greater. Floats are compared by their bits: a processor that takes
// subnormal numbers for zero would find some of them equal.
template <class T>
IRG_INLINE constexpr int compare_scalars(const T& a, const T& b) noexcept {
  if constexpr (Floating<T>) {
    using bits = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
    const auto place = [](const T& x) {  // -0 and 0 have the same
      const auto v = std::bit_cast<bits>(x);
      return v < 0 ? (std::numeric_limits<bits>::min)() - v : v;
    };
    return compare_scalars(place(a), place(b));
  } else {
    return a < b ? -1 : b < a ? 1 : 0;
  }
}

// A rounded number; `size` is what it would be if all terms were positive, which is what its error is measured by.
struct filtered {
  double value, size;

  IRG_INLINE friend constexpr filtered operator+(const filtered& a, const filtered& b) noexcept {
    return {a.value + b.value, a.size + b.size};
  }
  IRG_INLINE friend constexpr filtered operator-(const filtered& a, const filtered& b) noexcept {
    return {a.value - b.value, a.size + b.size};
  }
  IRG_INLINE friend constexpr filtered operator*(const filtered& a, const filtered& b) noexcept {
    return {product(a.value, b.value), product(a.size, b.size)};
  }
};

// A coordinate as it came: not off by anything, so that a difference is off by its own rounding only.
struct filtered_input {
  double value;

  IRG_INLINE constexpr operator filtered() const noexcept { return {value, magnitude(value)}; }
  IRG_INLINE friend constexpr filtered operator-(const filtered_input& a, const filtered_input& b) noexcept {
    const double difference = a.value - b.value;
    return {difference, magnitude(difference)};
  }
  IRG_INLINE friend constexpr filtered operator*(const filtered_input& a, const filtered_input& b) noexcept {
    return filtered(a) * filtered(b);
  }
};

// With at most 10 roundings on the way from a coordinate to the value, it is off by less than 12u times its size.
inline constexpr double filter_bound = 0x1.8p-50;

// Nothing of degree 2 over- or underflows then, with subnormal numbers or with zeros in their place. A float must not
// be subnormal: what makes a double of it may take it for zero.
IRG_INLINE constexpr bool suits_filter(double x) noexcept { return is_zero_or_within<-400, 400>(x); }
IRG_INLINE constexpr bool suits_filter(float x) noexcept {
  const std::uint32_t size = std::bit_cast<std::uint32_t>(x) << 1, least_normal = std::uint32_t{1} << 24;
  return size - 1 >= least_normal - 1;
}

template <class T>
inline constexpr bool fits_in_double = Floating<T> || (std::is_integral_v<T> && sizeof(T) <= 4);

template <class Number, class T>
IRG_INLINE constexpr Number exact_number(const T& x) noexcept {
  if constexpr (std::is_same_v<Number, T>) {
    return x;
  } else if constexpr (Floating<T>) {
    return Number(exactly_widened(x));
  } else if constexpr (fits_in_double<T>) {
    return Number(static_cast<double>(x));
  } else {
    const T high = x >> 32;
    return Number(static_cast<double>(high) * 0x1p32) + Number(static_cast<double>(x - (high << 32)));
  }
}

// formula(numbers) gives one number; at most 10 roundings lie on the way from any of them to it.
template <class T, std::size_t Size, class Formula>
IRG_NOINLINE constexpr int exact_sign_of_degree_2(const Formula& formula, const std::array<T, Size>& in) noexcept {
  using number = dyadic<words_for_degree(2)>;
  std::array<number, Size> x{};
  for (std::size_t i = 0; i < Size; ++i) x[i] = exact_number<number>(in[i]);
  return formula(x).sign();
}

template <class T, std::size_t Size, class Formula>
IRG_INLINE constexpr int sign_of_degree_2(const Formula& formula, const std::array<T, Size>& in) noexcept {
  if constexpr (Floating<T>) {
    std::array<filtered_input, Size> x{};
    bool suits = true;
    for (std::size_t i = 0; i < Size; ++i) {
      x[i].value = widened(in[i]);
      suits = suits && suits_filter(in[i]);
    }
    if (suits) {
      const filtered f = formula(x);
      const double bound = filter_bound * f.size;
      if (f.value > bound) return 1;
      if (-f.value > bound) return -1;
      if (f.size == 0) return 0;
    }
    for (const T& number : in)
      if (!is_finite(number)) return 0;
    return exact_sign_of_degree_2(formula, in);
  } else if constexpr (std::is_integral_v<T>) {
    std::array<int128, Size> x{};
    bool fits = true;
    for (std::size_t i = 0; i < Size; ++i) {
      x[i] = in[i];
      if constexpr (sizeof(T) > 4) fits = fits && (x[i] >> 57 == 0 || x[i] >> 57 == -1);
    }
    if (fits) {  // products of sums and differences stay below 2^119
      const int128 value = formula(x);
      return value < 0 ? -1 : value > 0 ? 1 : 0;
    }
    return exact_sign_of_degree_2(formula, in);
  } else {
    return compare_scalars(T(formula(in)), T(0));
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail
