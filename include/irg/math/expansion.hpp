// SPDX-License-Identifier: MIT
// Expansions: numbers as unevaluated sums of doubles that do not overlap, of which sums, differences and products are
// exact. Polynomials of coordinates written with them have exact signs; the capacity is part of the type and grows with
// each operation, so nothing is allocated.
//
// Exact for polynomials of degree K whose arguments are 0 or have a size from 2^(53 - 1074/K) to 2^(1000/K): 2^-484 to
// 2^500 for products of two, 2^-215 to 2^250 for products of four. Beyond that range exact_accumulator takes over.
#pragma once

#include <cstddef>

#include <irg/math/error_free.hpp>

namespace irg {

/// The sum of parts[0] to parts[size - 1].
/// shape   no part is zero; their sizes increase and their significands do not overlap: the last one tells the sign,
///         and the sum is zero when there is none
template <Floating T, int Capacity>
struct expansion {
  T parts[static_cast<std::size_t>(Capacity)]{};
  int size = 0;
};

namespace detail::inline IRG_ABI {

template <Floating T, int N>
IRG_INLINE constexpr void append(expansion<T, N>& e, T part) noexcept {
  if (part != 0) e.parts[e.size++] = part;
}

/// The parts of e and of `sign` times f, by size, the smaller first.
template <Floating T, int N, int M>
constexpr expansion<T, N + M> merged(const expansion<T, N>& e, const expansion<T, M>& f, T sign) noexcept {
  expansion<T, N + M> both;
  for (int i = 0, k = 0; i < e.size || k < f.size;) {
    const bool from_e = k == f.size || (i < e.size && magnitude(e.parts[i]) < magnitude(f.parts[k]));
    both.parts[both.size++] = from_e ? e.parts[i++] : sign * f.parts[k++];
  }
  return both;
}

template <Floating T, int N, int M>
constexpr expansion<T, N + M> sum_of_expansions(const expansion<T, N>& e, const expansion<T, M>& f, T sign) noexcept {
  const expansion<T, N + M> both = merged(e, f, sign);
  expansion<T, N + M> sum;
  if (both.size == 0) return sum;
  T head = both.parts[0];
  for (int i = 1; i < both.size; ++i) {
    const auto [value, error] = i == 1 ? fast_two_sum(both.parts[1], head) : two_sum(head, both.parts[i]);
    append(sum, error);
    head = value;
  }
  append(sum, head);
  return sum;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The number x.
template <Floating T>
[[nodiscard]] constexpr expansion<T, 1> expansion_of(T x) noexcept {
  expansion<T, 1> e;
  detail::append(e, x);
  return e;
}

/// a + b, exactly.
template <Floating T>
[[nodiscard]] constexpr expansion<T, 2> exact_sum_of(T a, T b) noexcept {
  const auto [value, error] = two_sum(a, b);
  expansion<T, 2> e;
  detail::append(e, error);
  detail::append(e, value);
  return e;
}

/// a - b, exactly.
template <Floating T>
[[nodiscard]] constexpr expansion<T, 2> exact_difference_of(T a, T b) noexcept {
  return exact_sum_of(a, -b);
}

/// a*b, exactly.
template <Floating T>
[[nodiscard]] constexpr expansion<T, 2> exact_product_of(T a, T b) noexcept {
  const auto [value, error] = two_product(a, b);
  expansion<T, 2> e;
  detail::append(e, error);
  detail::append(e, value);
  return e;
}

/// e + f, exactly.
/// source  Shewchuk 1997 (Fast-Expansion-Sum with zero elimination)
template <Floating T, int N, int M>
[[nodiscard]] constexpr expansion<T, N + M> operator+(const expansion<T, N>& e, const expansion<T, M>& f) noexcept {
  return detail::sum_of_expansions(e, f, T(1));
}

/// e + b, exactly.
/// source  Shewchuk 1997, as the sum of two expansions: Grow-Expansion leaves parts that the next sum could not take
template <Floating T, int N>
[[nodiscard]] constexpr expansion<T, N + 1> operator+(const expansion<T, N>& e, T b) noexcept {
  return e + expansion_of(b);
}

/// e - f, exactly.
template <Floating T, int N, int M>
[[nodiscard]] constexpr expansion<T, N + M> operator-(const expansion<T, N>& e, const expansion<T, M>& f) noexcept {
  return detail::sum_of_expansions(e, f, T(-1));
}

/// e*b, exactly.
/// source  Shewchuk 1997 (Scale-Expansion with zero elimination)
template <Floating T, int N>
[[nodiscard]] constexpr expansion<T, 2 * N> operator*(const expansion<T, N>& e, T b) noexcept {
  expansion<T, 2 * N> result;
  T head = 0;
  for (int i = 0; i < e.size; ++i) {
    const auto [value, error] = two_product(e.parts[i], b);
    const auto [low, low_error] = two_sum(head, error);
    detail::append(result, low_error);
    const auto [high, high_error] = fast_two_sum(value, low);
    detail::append(result, high_error);
    head = high;
  }
  detail::append(result, head);
  return result;
}

/// e*f, exactly.
/// cost    a scaling and a sum for each part of f
template <Floating T, int N, int M>
[[nodiscard]] constexpr expansion<T, 2 * N * M> operator*(const expansion<T, N>& e, const expansion<T, M>& f) noexcept {
  expansion<T, 2 * N * M> result;
  for (int k = 0; k < f.size; ++k) {
    const auto sum = result + e * f.parts[k];
    result.size = sum.size;
    for (int i = 0; i < sum.size; ++i) result.parts[i] = sum.parts[i];
  }
  return result;
}

/// -e.
template <Floating T, int N>
[[nodiscard]] constexpr expansion<T, N> operator-(expansion<T, N> e) noexcept {
  for (int i = 0; i < e.size; ++i) e.parts[i] = -e.parts[i];
  return e;
}

/// -1, 0 or 1, as the number is negative, zero or positive.
template <Floating T, int N>
[[nodiscard]] constexpr int sign(const expansion<T, N>& e) noexcept {
  return e.size == 0 ? 0 : e.parts[e.size - 1] < 0 ? -1 : 1;
}

/// The number, nearly.
/// exact   within 1 ulp
template <Floating T, int N>
[[nodiscard]] constexpr T estimate(const expansion<T, N>& e) noexcept {
  T sum = 0;
  for (int i = 0; i < e.size; ++i) sum = sum + e.parts[i];
  return sum;
}

/// The same number in as few parts as they can be made; the last part is within 1 ulp of it.
/// source  Shewchuk 1997 (Compress)
template <Floating T, int N>
[[nodiscard]] constexpr expansion<T, N> compress(const expansion<T, N>& e) noexcept {
  if (e.size == 0) return e;
  expansion<T, N> downwards = e, result;
  int bottom = e.size - 1;
  T head = e.parts[bottom];
  for (int i = e.size - 2; i >= 0; --i) {
    const auto [value, error] = fast_two_sum(head, e.parts[i]);
    head = error != 0 ? error : value;
    if (error != 0) downwards.parts[bottom--] = value;
  }
  downwards.parts[bottom] = head;
  for (int i = bottom + 1; i < e.size; ++i) {
    const auto [value, error] = fast_two_sum(downwards.parts[i], head);
    detail::append(result, error);
    head = value;
  }
  detail::append(result, head);
  return result;
}

}  // namespace IRG_ABI
}  // namespace irg
