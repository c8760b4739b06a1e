// SPDX-License-Identifier: MIT
// Signs and quotients of polynomials in doubles, exactly: a formula is written once, over numbers of any type with + -
// and *, and computed in doubles with a bound of the error, in twice the precision, and in exact numbers where neither
// tells. For decisions that no predicate of its own makes.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <irg/geometry/detail/exact_sign.hpp>
#include <irg/geometry/detail/nearest_quotient.hpp>

namespace irg {

namespace detail {
inline namespace IRG_ABI {

// Less than 60 roundings lie on the way from a coordinate to the value of a formula of degree 6 that sums up to 2^10
// terms; doubles that suit twofold neither over- nor underflow in it.
inline constexpr double polynomial_filter_bound = 0x1p-46;

template <int Degree, std::size_t Size, class Formula>
IRG_NOINLINE constexpr int unfiltered_sign(const Formula& formula, const std::array<double, Size>& in) noexcept {
  const auto one = [&](const auto& x) { return std::array{formula(x)}; };
  const auto value = evaluate<Degree>(one, in);
  return value ? known_sign((*value)[0]) : 0;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// -1, 0 or 1, as formula(in) is negative, zero or positive.
/// shape   formula(x) takes a std::array of numbers of a type that it is not told and gives one number of a type with
///         + - and *; every number enters it through a difference of two
/// needs   a polynomial of at most this degree, 6 at most, with at most 2^10 terms
/// gives   0 when a number is NaN or infinite
/// exact   for all finite doubles
/// cost    twice the formula in doubles where the value is not nearly 0; beyond, some microseconds
/// source  Shewchuk 1997 (the stages)
template <int Degree, std::size_t Size, class Formula>
constexpr int sign_of(const Formula& formula, const std::array<double, Size>& in) noexcept {
  static_assert(Degree >= 1 && Degree <= 6);
  std::array<detail::filtered_input, Size> x{};
  bool suits = true;
  for (std::size_t i = 0; i < Size; ++i) {
    x[i].value = in[i];
    suits = suits && detail::suits_twofold(in[i]);
  }
  if (suits) {
    const detail::filtered f = formula(x);
    const double bound = detail::polynomial_filter_bound * f.size;
    if (f.value > bound) return 1;
    if (-f.value > bound) return -1;
    if (f.size == 0) return 0;
  }
  return detail::unfiltered_sign<Degree>(formula, in);
}

/// The double nearest to a/b, ties to even, for {b, a} = formula(in).
/// shape   formula as sign_of takes it, but for two numbers: the divisor comes first
/// needs   polynomials of at most this degree, 5 at most; finite numbers
/// gives   nothing when the divisor is zero
/// exact   correctly rounded
template <int Degree, std::size_t Size, class Formula>
constexpr std::optional<double> quotient_of(const Formula& formula, const std::array<double, Size>& in) noexcept {
  static_assert(Degree >= 1 && Degree <= 5);
  const auto nearest = detail::nearest_quotients<Degree>(formula, in);
  return nearest ? std::optional<double>((*nearest)[0]) : std::nullopt;
}

}  // namespace IRG_ABI
}  // namespace irg
