// SPDX-License-Identifier: MIT
// Polynomials of coordinates with exact signs and with values right to 60 bits, for all finite floats and doubles: a
// formula is computed in twice the precision, and in exact numbers where that does not suffice. Other scalars compute
// it in their own arithmetic. Quotients of such values are what intersections and nearest points are made of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/dyadic.hpp>
#include <irg/geometry/detail/twofold.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

IRG_INLINE constexpr bool suits_twofold(double x) noexcept { return is_zero_or_within<-80, 80>(x); }

// Whether x is a number one can compute with: not NaN, not infinite.
template <Scalar T>
IRG_INLINE constexpr bool is_proper(const T& x) noexcept {
  if constexpr (Floating<T>)
    return is_finite(x);
  else
    return true;
}

template <class N, class T, std::size_t Size>
constexpr std::array<N, Size> numbers_of(const std::array<T, Size>& in) noexcept {
  std::array<N, Size> out{};
  for (std::size_t i = 0; i < Size; ++i) out[i] = N(exactly_widened(in[i]));
  return out;
}

template <std::size_t Size>
constexpr std::array<known_number, Size> known_of(const std::array<twofold, Size>& in) noexcept {
  std::array<known_number, Size> out{};
  for (std::size_t i = 0; i < Size; ++i) out[i] = {in[i].high, in[i].low, 0};
  return out;
}

template <int Degree, class T, std::size_t Size, class Formula>
IRG_NOINLINE constexpr auto evaluate_exactly(const Formula& formula, const std::array<T, Size>& in) noexcept {
  const auto values = formula(numbers_of<dyadic<words_for_degree(Degree)>>(in));
  std::array<known_number, std::tuple_size_v<decltype(values)>> out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = values[i].rounded();
  return out;
}

/// The values formula(x) of polynomials of at most this degree at x = in: known numbers for float and double, T for
/// other scalars.
/// shape   formula takes an array of numbers of any type with + - and *, and returns an array of them
/// gives   nothing when a number is NaN or infinite
template <int Degree, class T, std::size_t Size, class Formula>
constexpr auto evaluate(const Formula& formula, const std::array<T, Size>& in) noexcept {
  if constexpr (Floating<T>) {
    static_assert(Degree <= 6);
    using known_values = decltype(known_of(formula(numbers_of<twofold>(in))));
    bool suits = true, finite = true;
    for (const T& x : in) {
      suits = suits && suits_twofold(exactly_widened(x));
      finite = finite && is_finite(x);
    }
    if (suits) {
      const auto values = formula(numbers_of<twofold>(in));
      bool sure = true;
      for (const twofold& v : values) sure = sure && v.is_sure();
      if (sure) return std::optional<known_values>(known_of(values));
    }
    if (!finite) return std::optional<known_values>();
    return std::optional<known_values>(evaluate_exactly<Degree>(formula, in));
  } else {
    return std::optional(formula(in));
  }
}

IRG_INLINE constexpr int known_sign(const known_number& x) noexcept { return x.high < 0 ? -1 : x.high > 0 ? 1 : 0; }
template <Scalar T>
IRG_INLINE constexpr int known_sign(const T& x) noexcept {
  return x < T(0) ? -1 : T(0) < x ? 1 : 0;
}

// Whether products and quotients with another such number stay far within the range as they are.
IRG_INLINE constexpr bool is_middling(const known_number& x) noexcept {
  const double size = magnitude(x.high);
  return x.exponent == 0 && size > 0x1p-200 && size < 0x1p200;
}

// Known numbers of any exponent come here with 1 <= |high| < 2, so that their products and quotients stay in range.
constexpr known_number normalized_number(const known_number& x) noexcept {
  if (x.high == 0) return x;
  const int exponent = decompose(x.high).exponent;
  const double scale = power_of_two(-exponent);
  return {x.high * scale, x.low * scale, x.exponent + exponent};
}

IRG_INLINE constexpr known_number tamed_number(const known_number& x) noexcept {
  return is_middling(x) ? x : normalized_number(x);
}

constexpr known_number operator*(const known_number& a, const known_number& b) noexcept {
  const known_number x = tamed_number(a), y = tamed_number(b);
  const twofold p = twofold(x.high, x.low, 0) * twofold(y.high, y.low, 0);
  return {p.high, p.low, x.exponent + y.exponent};
}
constexpr known_number operator-(const known_number& a) noexcept { return {-a.high, -a.low, a.exponent}; }

/// a - b, to some 100 bits unless they cancel.
constexpr known_number operator-(const known_number& a, const known_number& b) noexcept {
  const known_number x = normalized_number(a), y = normalized_number(b);
  if (y.high == 0) return x;
  if (x.high == 0) return -y;
  const int apart = x.exponent - y.exponent;
  if (apart > 200) return x;
  if (apart < -200) return -y;
  const double scale = power_of_two(-apart);
  const twofold d = twofold(x.high, x.low, 0) - twofold(y.high * scale, y.low * scale, 0);
  return {d.high, d.low, x.exponent};
}

/// a/b to some 100 bits.
/// needs   b is not zero
constexpr known_number operator/(const known_number& a, const known_number& b) noexcept {
  const known_number x = tamed_number(a), y = tamed_number(b);
  const double q = x.high / y.high;
  const auto back = fast_two_product(q, y.high);
  const double rest = ((x.high - back.value) - back.error) + (x.low - product(q, y.low));
  const auto whole = fast_two_sum(q, rest / y.high);
  return {whole.value, whole.error, x.exponent - y.exponent};
}

/// The square root to some 100 bits.
/// needs   x is not negative
constexpr known_number root_of(const known_number& a) noexcept {
  known_number x = tamed_number(a);
  if (x.high <= 0) return {};
  const int odd = x.exponent & 1;
  if (odd != 0) x = {x.high * 2, x.low * 2, x.exponent - 1};
  const double r = sqrt(x.high);
  const auto back = fast_two_product(r, r);
  const auto whole = fast_two_sum(r, (((x.high - back.value) - back.error) + x.low) / (r + r));
  return {whole.value, whole.error, x.exponent / 2};
}

/// The number as T; infinity beyond the range.
/// exact   within 0.501 ulp, where the result is subnormal, too
template <Floating T>
constexpr T rounded_to(const known_number& x) noexcept {
  if (x.exponent == 0 && magnitude(x.high) > 0x1p-1000) return converted<T>(x.high);
  const known_number y = normalized_number(x);
  if (y.high == 0) return T(0);
  double value = y.exponent < 0 ? 0.0 : y.high < 0 ? -infinity<double> : infinity<double>;
  if (y.exponent >= -1022 && y.exponent <= 1023) value = y.high * power_of_two(y.exponent);
  if (y.exponent < -1022 && y.exponent > -1080) {
    value = y.high * 0x1p-1000 * power_of_two(y.exponent + 1000);
    // `high` has been rounded before: where it is halfway between two numbers, `low` tells which one is nearer.
    const double rest = y.high - value * 0x1p1000 * power_of_two(-y.exponent - 1000);
    if (magnitude(rest) == power_of_two(-1075 - y.exponent) && y.low != 0 && (rest > 0) == (y.low > 0))
      value = value + (rest > 0 ? 0x1p-1074 : -0x1p-1074);
  }
  return converted<T>(value);
}
template <Scalar T>
  requires(!Floating<T>)
IRG_INLINE constexpr T rounded_to(const T& x) noexcept {
  return x;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
