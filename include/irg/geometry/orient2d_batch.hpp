// SPDX-License-Identifier: MIT
// orient2d for many points at once: the same signs, several times as fast.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <irg/core/contract.hpp>
#include <irg/geometry/detail/orient2d_batch_kernel.hpp>

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
constexpr std::size_t orient2d_batch(const P& a, const P& b, const point_columns& c,
                                     std::span<std::int8_t> signs) noexcept {
  IRG_EXPECTS(c.x.size() == signs.size() && c.y.size() == signs.size());
  const double ax = coordinate(a, 0), ay = coordinate(a, 1), bx = coordinate(b, 0), by = coordinate(b, 1);
  const detail::line_batch_filter filter(ax, ay, bx, by, c.x.data(), c.y.data());
  return detail::write_signs(filter, signs.size(), signs.data(), [&](std::size_t i) {
    return orient2d(std::array{ax, ay}, std::array{bx, by}, std::array{c.x[i], c.y[i]});
  });
}

/// signs[i] = orient2d(a[i], b[i], c[i]).
/// needs   finite coordinates; all columns and signs of one size
/// gives   how many triples are so nearly collinear that the filter left them to orient2d
/// exact   as orient2d; the same bytes and the same count in constant evaluation and with any lanes
constexpr std::size_t orient2d_batch(const point_columns& a, const point_columns& b, const point_columns& c,
                                     std::span<std::int8_t> signs) noexcept {
  IRG_EXPECTS(a.x.size() == signs.size() && a.y.size() == signs.size());
  IRG_EXPECTS(b.x.size() == signs.size() && b.y.size() == signs.size());
  IRG_EXPECTS(c.x.size() == signs.size() && c.y.size() == signs.size());
  const detail::triple_batch_filter filter{a.x.data(), a.y.data(), b.x.data(), b.y.data(), c.x.data(), c.y.data()};
  return detail::write_signs(filter, signs.size(), signs.data(), [&](std::size_t i) {
    return orient2d(std::array{a.x[i], a.y[i]}, std::array{b.x[i], b.y[i]}, std::array{c.x[i], c.y[i]});
  });
}

}  // namespace IRG_ABI
}  // namespace irg
