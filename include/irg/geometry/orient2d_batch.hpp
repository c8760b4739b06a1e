// SPDX-License-Identifier: MIT
// orient2d for many points at once: the same signs, several times as fast.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/lanes.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact/filtered_number.hpp>

namespace irg {

/// Points as two arrays, one of their x and one of their y.
struct point_columns {
  std::span<const double> x, y;
};

inline namespace IRG_ABI {

/// signs[i] = orient2d(a, b, c[i]) for all points of c: 1 left of the line from a to b, -1 right of it, 0 on it.
/// needs   finite coordinates; c.x, c.y and signs of one size
/// gives   how many points lie so near to the line that the filter left them to orient2d
/// exact   as orient2d; the same bytes and the same count in constant evaluation and with any lanes
/// cost    about 8 operations for as many points as one instruction works on
template <Point P>
  requires(size_of<P> == 2 && std::same_as<scalar_of<P>, double>)
constexpr std::size_t orient2d_all(const P& a, const P& b, const point_columns& c,
                                   std::span<std::int8_t> signs) noexcept;

/// signs[i] = orient2d(a[i], b[i], c[i]).
/// needs   finite coordinates; all columns and signs of one size
/// gives   how many triples are so nearly collinear that the filter left them to orient2d
/// exact   as orient2d; the same bytes and the same count in constant evaluation and with any lanes
constexpr std::size_t orient2d_all(const point_columns& a, const point_columns& b, const point_columns& c,
                                   std::span<std::int8_t> signs) noexcept;

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_ABI {

// The inner loop of orient2d_all: a filter for many points at once, and orient2d for those that it leaves open.
//
// With l and r the two rounded products whose difference is the area, the error of l - r is at most (3 + 16u)u times
// |l| + |r| (Shewchuk 1997), u = 2^-53. That sum is the greater of |l + r| and |l - r|; where it is |l - r|, l and r
// differ in sign and that of l - r is right, so |l + r| serves as well. What subnormal numbers cost where the processor
// takes them for zero, less than 2^-1020 for a difference and for a product, is less than the floor of the bound.
// Nothing overflows, which constant evaluation would not allow: the line's direction is scaled to be below 1, and
// triples of great reach are left open.

// Twice an area, what it must exceed for its sign to be sure, and what must stay below 2^500 for that.
template <class F>
struct filtered_area {
  F area, bound, reach;
};
inline constexpr double batch_bound_floor = 0x1p-1000, batch_reach = 0x1p500;

template <class F>
IRG_INLINE constexpr filtered_area<F> filtered_cross(const F& ux, const F& uy, const F& vx, const F& vy, const F& floor,
                                                     const F& reach) noexcept {
  const F l = product(ux, vy), r = product(uy, vx);
  return {l - r, product(lanes<F>::broadcast(0x1p-51), magnitude(l + r)) + floor, reach};  // 4u
}

// Points c against one line from a to b. Where the line's coordinates are far from 1, its own differences could be off
// by too much: all points are left open.
struct line_batch_filter {
  static constexpr bool bounds_reach = false;
  double ax, ay, dx = 0, dy = 0;
  const double *x, *y;

  IRG_INLINE constexpr line_batch_filter(double x0, double y0, double x1, double y1, const double* xs,
                                         const double* ys) noexcept
      : ax(x0), ay(y0), x(xs), y(ys) {
    if (!suits_filter<2>(x0) || !suits_filter<2>(y0) || !suits_filter<2>(x1) || !suits_filter<2>(y1)) {
      ax = ay = 0;
      return;
    }
    dx = x1 - x0, dy = y1 - y0;
    const double size = maximum(magnitude(dx), magnitude(dy));
    if (size == 0) return;
    const double scale = power_of_two(-2 - decompose(size).exponent);
    dx *= scale, dy *= scale;
  }

  template <class F>
  IRG_INLINE constexpr filtered_area<F> at(std::size_t i) const noexcept {
    const auto all = [](double v) { return lanes<F>::broadcast(v); };
    return filtered_cross<F>(all(dx), all(dy), lanes<F>::load(x + i) - all(ax), lanes<F>::load(y + i) - all(ay),
                             all(batch_bound_floor), all(0));
  }
};

// One line for each point.
struct triple_batch_filter {
  static constexpr bool bounds_reach = true;
  const double *ax, *ay, *bx, *by, *cx, *cy;

  template <class F>
  IRG_INLINE constexpr filtered_area<F> at(std::size_t i) const noexcept {
    const auto load = [&](const double* p) { return lanes<F>::load(p + i); };
    if constexpr (std::is_same_v<F, double>)
      for (const double* p : {ax, ay, bx, by, cx, cy})  // from 2^1000 on there is no difference below 2^900 but 0
        if (magnitude(p[i]) >= 0x1p1000) return {0, 1, 0};
    const F x = load(cx), y = load(cy), ux = load(ax) - x, uy = load(ay) - y, vx = load(bx) - x, vy = load(by) - y;
    const F reach = (magnitude(ux) + magnitude(uy)) + (magnitude(vx) + magnitude(vy));
    if constexpr (std::is_same_v<F, double>)
      if (!(reach < batch_reach)) return {0, 1, 0};
    const F floor = lanes<F>::broadcast(batch_bound_floor);
    return filtered_cross<F>(ux, uy, vx, vy, product(floor, reach) + floor, reach);
  }
};

// Eight signs as bytes, 0 where the filter leaves them open: 1 and -1 are odd, so the lowest bits tell.
inline constexpr std::uint64_t lowest_bits = 0x0101010101010101u;

// The signs of points i to i + 7.
template <class Filter>
IRG_INLINE std::uint64_t eight_signs(const Filter& filter, std::size_t i) noexcept {
  constexpr int n = widest_lanes<double>;
  std::uint64_t all = 0;
  for (int k = 0; k < 8; k += n) {
    const auto f = filter.template at<pack<double, n>>(i + static_cast<std::size_t>(k));
    auto sure = magnitude(f.area) > f.bound;
    if constexpr (Filter::bounds_reach) sure = both(sure, f.reach < batch_reach);
    const auto sign = converted<std::int8_t>(((f.area < 0) | 1) & sure);
    lanes<pack<std::int8_t, n>>::store_bytes(reinterpret_cast<char*>(&all) + k, sign);
  }
  return all;
}

template <class Filter>
IRG_INLINE constexpr int sure_sign(const Filter& filter, std::size_t i) noexcept {
  const filtered_area<double> f = filter.template at<double>(i);
  return magnitude(f.area) > f.bound ? f.area < 0 ? -1 : 1 : 0;
}

// Writes n signs; decide(i) is asked for those that the filter leaves open. Gives how many these were.
template <class Filter, class Decide>
constexpr std::size_t write_signs(const Filter& filter, std::size_t n, std::int8_t* signs,
                                  const Decide& decide) noexcept {
  std::size_t i = 0, open = 0;
  if (!std::is_constant_evaluated())
    for (; i + 8 <= n; i += 8) {
      const std::uint64_t eight = eight_signs(filter, i);
      std::memcpy(signs + i, &eight, 8);
      if ((~eight & lowest_bits) == 0) [[likely]]
        continue;
      for (std::size_t k = i; k < i + 8; ++k)
        if (signs[k] == 0) {
          signs[k] = static_cast<std::int8_t>(decide(k));
          ++open;
        }
    }
  for (; i < n; ++i) {
    signs[i] = static_cast<std::int8_t>(sure_sign(filter, i));
    if (signs[i] == 0) {
      signs[i] = static_cast<std::int8_t>(decide(i));
      ++open;
    }
  }
  return open;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Point P>
  requires(size_of<P> == 2 && std::same_as<scalar_of<P>, double>)
constexpr std::size_t orient2d_all(const P& a, const P& b, const point_columns& c,
                                   std::span<std::int8_t> signs) noexcept {
  IRG_EXPECTS(c.x.size() == signs.size() && c.y.size() == signs.size());
  const double ax = coordinate(a, 0), ay = coordinate(a, 1), bx = coordinate(b, 0), by = coordinate(b, 1);
  const detail::line_batch_filter filter(ax, ay, bx, by, c.x.data(), c.y.data());
  return detail::write_signs(filter, signs.size(), signs.data(), [&](std::size_t i) {
    return orient2d(std::array{ax, ay}, std::array{bx, by}, std::array{c.x[i], c.y[i]});
  });
}

constexpr std::size_t orient2d_all(const point_columns& a, const point_columns& b, const point_columns& c,
                                   std::span<std::int8_t> signs) noexcept {
  IRG_EXPECTS(a.x.size() == signs.size() && a.y.size() == signs.size());
  IRG_EXPECTS(b.x.size() == signs.size() && b.y.size() == signs.size());
  IRG_EXPECTS(c.x.size() == signs.size() && c.y.size() == signs.size());
  const detail::triple_batch_filter filter{a.x.data(), a.y.data(), b.x.data(), b.y.data(), c.x.data(), c.y.data()};
  return detail::write_signs(filter, signs.size(), signs.data(), [&](std::size_t i) {
    return orient2d(std::array{a.x[i], a.y[i]}, std::array{b.x[i], b.y[i]}, std::array{c.x[i], c.y[i]});
  });
}

IRG_RENAMED(orient2d_batch, orient2d_all)

}  // namespace irg::inline IRG_ABI
