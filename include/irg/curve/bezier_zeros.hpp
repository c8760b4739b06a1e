// SPDX-License-Identifier: MIT
// All zeros in [0, 1] of a polynomial given by its Bernstein coefficients: stretches are halved until the coefficients
// tell that there is no zero, or that the polynomial runs through zero once, or until rounding hides which. No zero is
// lost to rounding: what cannot be told is handed over as a stretch.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

/// A stretch [from, to] of a parameter with zeros, and the signs just before and behind it; sign 0 where it reaches the
/// end. Different signs: an odd number of zeros, counted with multiplicity. Equal ones or an end: perhaps touching,
/// perhaps near, perhaps zero all along.
template <Floating T>
struct root_interval {
  T from = 0, to = 0;
  int before = 0, behind = 0;
  [[nodiscard]] IRG_APART constexpr T middle() const noexcept { return from + (to - from) / 2; }
  [[nodiscard]] IRG_APART constexpr bool is_crossing() const noexcept { return before * behind < 0; }
  bool operator==(const root_interval&) const = default;
};

namespace detail::inline IRG_ABI {

// Coefficients of one stretch, and how far rounding may have moved each value.
template <Floating T>
struct bernstein_stretch {
  std::span<vec<T, 1>> c;
  T off = 0;

  // The sign of the polynomial all over the stretch, 0 where the coefficients do not tell.
  constexpr int sign() const noexcept {
    bool above = true, below = true;
    for (const auto& v : c) {
      above = above && v[0] > off;
      below = below && v[0] < -off;
    }
    return above ? 1 : below ? -1 : 0;
  }
  constexpr bool is_hidden() const noexcept {
    for (const auto& v : c)
      if (!(v[0] <= off && v[0] >= -off)) return false;
    return true;
  }
  // Whether the values run from one sign to the other and never back.
  constexpr bool runs_through() const noexcept {
    const T begin = c[0][0], end = c[c.size() - 1][0];
    if (!((begin > off && end < -off) || (begin < -off && end > off))) return false;
    for (std::size_t i = 1; i < c.size(); ++i)
      if (begin < 0 ? c[i][0] < c[i - 1][0] : c[i][0] > c[i - 1][0]) return false;
    return true;
  }
};

// Two neighbours of [low, high] found by halving: `holds` is true at the first and false at the second.
// needs   holds at low, not at high
template <Floating T, class Holds>
constexpr root_interval<T> edge_by_halving(T low, T high, const Holds& holds) noexcept {
  while (true) {
    const T middle = low + (high - low) / 2;
    if (!(low < middle && middle < high)) return {low, high, 1, 0};
    (holds(middle) ? low : high) = middle;
  }
}

// How many rows of as many numbers as there are coefficients bernstein_roots works in.
inline constexpr std::size_t root_rows = 3;

// Joins stretches that touch, and hands them over with the signs around them.
template <Floating T, class Sink>
struct zero_collector {
  Sink& sink;
  root_interval<T> open{};
  bool is_open = false;
  int last_sign = 0;

  constexpr void add(T from, T to) {
    if (!is_open) open = {from, to, last_sign, 0};
    is_open = true;
    open.to = to;
  }
  constexpr void close(int sign) {
    if (is_open) {
      open.behind = sign;
      sink(open);
    }
    is_open = false;
    last_sign = sign;
  }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Hands sink(root_interval) stretches of [0, 1], in order and apart from each other, that hold every zero of the
/// polynomial with these Bernstein coefficients.
/// shape   each coefficient is a vec<T, 1>
/// needs   one coefficient or more; scratch three times as many; 0 <= uncertainty: how far each coefficient may be off
/// gives   one stretch where the polynomial is within rounding of zero. Numbers that are not finite: one stretch,
///         [0, 1]. No stretches: no zeros
/// exact   no zero is missed, of this polynomial nor of any whose coefficients are off by the uncertainty; a stretch
///         about a simple zero is as wide as 16 * degree * u * (largest coefficient) over the slope makes it, one about
///         a double zero not much wider than the root of this
/// cost    some digits / 2 halvings for each zero, each with two bezier_split; then halvings of bezier_point
/// source  Lane and Riesenfeld 1981
template <Floating T, class Sink>
constexpr void bernstein_roots(std::span<const vec<T, 1>> coefficients, std::type_identity_t<T> uncertainty,
                               std::type_identity_t<std::span<vec<T, 1>>> scratch, Sink&& sink) {
  constexpr int depth = std::numeric_limits<T>::digits / 2 + 2;
  const std::size_t n = coefficients.size();
  IRG_EXPECTS(n > 0 && scratch.size() >= detail::root_rows * n && !(uncertainty < 0));
  T largest = 0;
  bool is_sound = is_finite(uncertainty);
  for (const auto& c : coefficients) {
    is_sound = is_sound && is_finite(c[0]);
    largest = maximum(largest, magnitude(c[0]));
  }
  if (!is_sound) {
    sink(root_interval<T>{0, 1, 0, 0});
    return;
  }
  // Two splits, each of 3 * degree * u: bezier_point's bound.
  const T steps = static_cast<T>(static_cast<int>(8 * n));
  const T off = uncertainty + product(steps, product(largest, std::numeric_limits<T>::epsilon() / 2) +
                                                 std::numeric_limits<T>::denorm_min());
  const auto left = scratch.first(n), work = scratch.subspan(n, n), piece = scratch.subspan(2 * n, n);
  detail::zero_collector<T, std::remove_reference_t<Sink>> zeros{sink};
  int level = 0, k = 0;  // the stretch from k to k + 1, of 2^level
  while (true) {
    bezier_split(coefficients, curve_fraction<T>(k + 1, 1 << level), left, work);
    bezier_split(left, curve_fraction<T>(k, k + 1), work, piece);
    const detail::bernstein_stretch<T> here{piece, off};
    const T all = static_cast<T>(1 << level), from = static_cast<T>(k) / all, to = static_cast<T>(k + 1) / all;
    if (const int sign = here.sign(); sign != 0) {
      zeros.close(sign);
    } else if (here.is_hidden() || level == depth) {
      zeros.add(from, to);
    } else if (here.runs_through()) {
      const int start = piece[0][0] > 0 ? 1 : -1;
      const auto has = [&](int which, T t) {
        const T value = bezier_point(coefficients, curve_parameter<T>(t), work)[0];
        return which > 0 ? value > off : value < -off;
      };
      zeros.close(start);
      const T low = detail::edge_by_halving(from, to, [&](T t) { return has(start, t); }).from;
      zeros.add(low, detail::edge_by_halving(low, to, [&](T t) { return !has(-start, t); }).to);
      zeros.close(-start);
    } else {
      ++level, k *= 2;
      continue;
    }
    for (; k % 2 == 1; --level) k /= 2;
    if (level == 0) break;
    ++k;
  }
  zeros.close(0);
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, class Sink, WorkspaceFor<vec<T, 1>> W = curve_workspace<vec<T, 1>>>
constexpr void bernstein_roots(std::span<const vec<T, 1>> coefficients, std::type_identity_t<T> uncertainty,
                               Sink&& sink, W&& memory = W{}) {
  const auto scratch = detail::room_for(memory.coefficients, coefficients, detail::root_rows);
  bernstein_roots(coefficients, uncertainty, scratch, sink);
}

IRG_RENAMED(bernstein_zeros, bernstein_roots)

}  // namespace IRG_ABI
}  // namespace irg
