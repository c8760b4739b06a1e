// SPDX-License-Identifier: MIT
// The length of a curve and the parameter at a length, for motion at constant speed. A curve enters by its speed: a
// callable that gives the length of its derivative at t.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/contraction.hpp>
#include <irg/core/instructions.hpp>
#include <irg/core/scalar.hpp>

namespace irg {

/// A stretch of a curve's parameter and the lengths from its beginning to equally spaced places, as arc_lengths fills
/// them in: lengths[0] is 0, the last one the length of all.
template <Floating T>
struct arc_length_table {
  T first = 0, last = 1;
  std::span<const T> lengths{};
  [[nodiscard]] IRG_APART constexpr T length() const noexcept { return lengths[lengths.size() - 1]; }
};

namespace detail::inline IRG_ABI {

/// Gauss and Legendre's rule of seven places: exact for polynomials up to degree 13.
template <Floating T, class F>
constexpr T gauss_legendre(const F& f, T a, T b) {
  constexpr T place[] = {T(0.40584515137739716691), T(0.74153118559939443986), T(0.94910791234275852453)};
  constexpr T weight[] = {T(0.38183005050511894495), T(0.27970539148927666790), T(0.12948496616886969327)};
  const T centre = a + (b - a) / 2, half = (b - a) / 2;
  T sum = product(T(0.41795918367346938776), f(centre));
  for (int i = 0; i < 3; ++i) {
    const T off = product(half, place[i]);
    sum = sum + product(weight[i], f(centre - off) + f(centre + off));
  }
  return product(half, sum);
}

template <Floating T, class F>
constexpr T adaptive_length(const F& speed, T a, T b, T whole, T tolerance, int depth) {
  const T middle = a + (b - a) / 2;
  const T left = gauss_legendre(speed, a, middle), right = gauss_legendre(speed, middle, b);
  const T off = (left + right) - whole;
  if (depth == 0 || !(off > tolerance || -off > tolerance)) return left + right;
  return adaptive_length(speed, a, middle, left, tolerance / 2, depth - 1) +
         adaptive_length(speed, middle, b, right, tolerance / 2, depth - 1);
}

// What is looked for between two places: where the length is `wanted`, within `noise`.
template <Floating T>
struct wanted_length {
  T begin, end, wanted, noise;
};

// The place where length_to(place) is what is wanted, from t on: Newton's steps, each within the stretch that is known
// to hold the place, and halves where a step would leave it. length_to is asked for t first, then for each place that a
// step leads to.
template <Floating T, class Speed, class Length>
constexpr T place_of_length(const Speed& speed, const Length& length_to, const wanted_length<T>& search, T t) {
  T a = search.begin, b = search.end;
  for (int step = 0; step < 60; ++step) {
    const T excess = length_to(t) - search.wanted;
    if (magnitude(excess) <= search.noise) break;
    (excess > T(0) ? b : a) = t;
    const T pace = speed(t);
    T next = pace > T(0) ? t - excess / pace : t;
    if (!(pace > T(0) && next >= a && next <= b)) next = a + (b - a) / 2;
    if (next == t) break;
    t = next;
  }
  return t;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The length of a curve from parameter a to b.
/// needs   speed(t) >= 0, the length of the derivative; a <= b, tolerance >= 0
/// gives   NaN where a speed is
/// exact   within `tolerance` where the speed is smooth; at a cusp within some 10^-6 of the length of the piece around
///         it. Tolerance 0 asks for what rounding lets have
/// cost    21 speeds for a smooth curve, twice as many with each halving; no stretch is halved more than 16 times
/// source  irg's own: Gauss's and Legendre's quadrature, halved until two halves agree with the whole
template <Floating T, class Speed>
[[nodiscard]] constexpr T arc_length(const Speed& speed, T a, std::type_identity_t<T> b,
                                     std::type_identity_t<T> tolerance) {
  const T whole = detail::gauss_legendre(speed, a, b);
  const T least = product(whole, sizeof(T) == 4 ? T(0x1p-20f) : T(0x1p-48));  // rounding noise is no reason to halve
  return detail::adaptive_length(speed, a, b, whole, maximum(tolerance, least), 16);
}

/// Fills `lengths` with the lengths from `first` to equally spaced parameters up to `last`: what parameter_at_length
/// starts from.
/// needs   two lengths or more, first < last
/// exact   each piece as arc_length with tolerance 0, added in order
template <Floating T, class Speed>
constexpr arc_length_table<T> arc_lengths(const Speed& speed, std::type_identity_t<T> first,
                                          std::type_identity_t<T> last, std::span<T> lengths) {
  IRG_EXPECTS(lengths.size() > 1 && first < last);
  const auto pieces = static_cast<T>(static_cast<int>(lengths.size()) - 1);
  lengths[0] = T(0);
  T from = first;
  for (std::size_t k = 1; k < lengths.size(); ++k) {
    const T share = static_cast<T>(static_cast<int>(k)) / pieces;
    const T to = k + 1 == lengths.size() ? last : first + product(last - first, share);
    lengths[k] = lengths[k - 1] + arc_length(speed, from, to, T(0));
    from = to;
  }
  return {first, last, lengths};
}

/// The parameter at which a curve has run the length s from table.first on.
/// needs   a table of this speed
/// gives   table.first for s <= 0 and NaN, table.last for s beyond the length: a path stands still at its ends
/// exact   the length up to the result is s within some 30 u of the whole where the speed is smooth, however few pieces
///         the table has; near a place without speed (a cusp) as arc_length
/// cost    a binary search, some three to six Newton steps of 7 speeds, and an adaptive length of 21 speeds or more
///         that confirms the last of them; where it does not, some steps more of 21
template <Floating T, class Speed>
[[nodiscard]] constexpr T parameter_at_length(const Speed& speed, const arc_length_table<T>& table,
                                              std::type_identity_t<T> s) {
  if (!(s > T(0))) return table.first;
  if (!(s < table.length())) return table.last;
  std::size_t low = 0, high = table.lengths.size() - 1;  // lengths[low] <= s < lengths[high]
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (s < table.lengths[middle] ? high : low) = middle;
  }
  const auto pieces = static_cast<T>(static_cast<int>(table.lengths.size()) - 1);
  const auto place = [&](std::size_t k) {
    return table.first + product(table.last - table.first, static_cast<T>(static_cast<int>(k)) / pieces);
  };
  const T begin = place(low), end = high + 1 == table.lengths.size() ? table.last : place(high);
  const T noise = product(table.length(), std::numeric_limits<T>::epsilon());
  const detail::wanted_length<T> search{begin, end, s - table.lengths[low], noise};
  const T guess = begin + product(end - begin, search.wanted / (table.lengths[high] - table.lengths[low]));
  const T close =
      detail::place_of_length(speed, [&](T t) { return detail::gauss_legendre(speed, begin, t); }, search, guess);
  // One rule of seven places may be far off over a long piece: what counts is the adaptive length, from place to place.
  T at = begin, run = T(0);
  const auto length_to = [&](T t) {
    run = at < t ? run + arc_length(speed, at, t, noise) : run - arc_length(speed, t, at, noise);
    at = t;
    return run;
  };
  return detail::place_of_length(speed, length_to, search, close);
}

}  // namespace IRG_ABI
}  // namespace irg
