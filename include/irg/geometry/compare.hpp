// SPDX-License-Identifier: MIT
// Which of two points comes first: by coordinates, along a line, by distance from a point. Decided exactly.
#pragma once

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/exact_sign.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The coordinates of all points, one after the other.
template <class P, std::same_as<P>... Q>
IRG_INLINE constexpr auto all_coordinates(const P& first, const Q&... more) noexcept {
  constexpr std::size_t dimension = size_of<P>;
  std::array<scalar_of<P>, dimension * (1 + sizeof...(Q))> all{};
  std::size_t next = 0;
  const auto append = [&](const P& p) {
    for (int i = 0; i < static_cast<int>(dimension); ++i) all[next++] = coordinate(p, i);
  };
  append(first), (append(more), ...);
  return all;
}

// The sum of term(0) to term(N - 1), which may be of any type.
template <std::size_t N, class Term>
IRG_INLINE constexpr auto sum_of_terms(const Term& term) noexcept {
  auto sum = term(std::size_t{0});
  for (std::size_t i = 1; i < N; ++i) sum = sum + term(i);
  return sum;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// -1 when p comes before q by its first coordinate, or by the first that differs; 1 when it comes after q; 0 when they
/// are equal.
/// needs   no NaN
/// exact   comparisons alone; -0 and 0 are equal
template <Point P>
constexpr int compare_lexicographic(const P& p, const P& q) noexcept {
  for (int i = 0; i < size_of<P>; ++i)
    if (const int order = detail::compare_scalars(coordinate(p, i), coordinate(q, i)); order != 0) return order;
  return 0;
}

/// -1 when p comes before q for one who goes from a to b, 1 when it comes after q, 0 when they are level: the points
/// count where they fall on the line through a and b, which they need not lie on.
/// needs   finite coordinates
/// gives   0 when a and b are equal
/// exact   the sign of (b - a) . (p - q), for every finite float, double and integer
/// cost    about 5 ns, where roundings do not tell some 200 ns
template <Point P>
constexpr int order_along_line(const P& a, const P& b, const P& p, const P& q) noexcept {
  constexpr std::size_t n = size_of<P>;
  const auto formula = [](const auto& x) {
    return detail::sum_of_terms<n>([&](std::size_t i) { return (x[n + i] - x[i]) * (x[2 * n + i] - x[3 * n + i]); });
  };
  return detail::sign_of_degree_2(formula, detail::all_coordinates(a, b, p, q));
}

/// -1 when a is nearer to p than b is, 1 when b is nearer, 0 when they are equally far.
/// needs   finite coordinates
/// exact   the sign of |a - p|^2 - |b - p|^2, for every finite float, double and integer
/// cost    about 5 ns, where roundings do not tell some 300 ns
template <Point P>
constexpr int compare_distance(const P& p, const P& a, const P& b) noexcept {
  constexpr std::size_t n = size_of<P>;
  const auto formula = [](const auto& x) {
    const auto squared = [&](std::size_t from) {
      return detail::sum_of_terms<n>([&](std::size_t i) {
        const auto d = x[from + i] - x[i];
        return d * d;
      });
    };
    return squared(n) - squared(2 * n);
  };
  return detail::sign_of_degree_2(formula, detail::all_coordinates(p, a, b));
}

}  // namespace IRG_ABI
}  // namespace irg
