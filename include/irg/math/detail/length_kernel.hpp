// SPDX-License-Identifier: MIT
// Lengths and directions of floats, whose squares are exact in double and stay far inside its range. Run time looks at
// their sum alone; constant evaluation, where a NaN must not come out of a sum, at the coordinates first. And lengths
// of doubles of moderate size.
#pragma once

#include <concepts>
#include <cstdint>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/lanes.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::detail {

// Half the exponent of the square and 1.5 * 2^28: what is added to it stands in units of 2^-24 or 2^-25 of its root.
inline constexpr std::uint64_t exponent_of_grid = std::uint64_t{0x7ff} << 52;
inline constexpr std::uint64_t offset_of_grid = (std::uint64_t{539} << 52) + (std::uint64_t{1} << 51);

inline namespace IRG_ABI {

/// The length of the vector of these coordinates.
template <std::same_as<float>... Ts>
IRG_INLINE constexpr float float_length(Ts... coordinates) noexcept {
  const auto has_infinity = [&]() IRG_INLINE_LAMBDA { return ((magnitude(coordinates) == infinity<float>) | ...); };
  if (std::is_constant_evaluated() && ((is_nan(coordinates) || ...) || has_infinity()))
    return has_infinity() ? infinity<float> : not_a_number<float>;
  double sum = 0;
  ((sum = sum + widened(coordinates) * widened(coordinates)), ...);
  const double root = sqrt(sum);
  const float length = std::is_constant_evaluated() ? narrowed<float>(root) : converted<float>(root);
  return is_nan(sum) && has_infinity() ? infinity<float> : length;
}

/// Puts a vector's direction into `unit`, zero where there is none, and says whether there is one.
template <Vector V>
IRG_INLINE constexpr bool put_float_direction(const V& v, V& unit) noexcept {
  double c[static_cast<std::size_t>(size_of<V>)]{}, square = 0;
  bool is_known = true;
  for (int i = 0; i < size_of<V>; ++i) {
    c[i] = widened(coordinate(v, i));
    if (std::is_constant_evaluated()) is_known = is_known && is_finite(c[i]);
  }
  if (is_known)
    for (const double x : c) square = square + x * x;
  const bool has_direction = (square > 0) & (square < infinity<double>);
  const double factor = 1 / sqrt(has_direction ? square : 1.0);
  unit = generate_coordinates<V>(
      [&](int i) IRG_INLINE_LAMBDA { return converted<float>(has_direction ? product(c[i], factor) : 0.0); });
  return has_direction;
}

/// Whether the sum of squares that neither overflowed nor vanished may be this; not NaN.
IRG_INLINE constexpr bool is_moderate_square(double sum) noexcept {
  constexpr std::uint64_t least = bits_of(0x1p-800), most = bits_of(0x1p1000);
  return bits_of(sum) - least <= most - least;
}

/// What rounds x to multiples of 2^-24 or 2^-25 of the root's power of two: (x + grid) - grid.
IRG_INLINE constexpr double grid_below_root(double square) noexcept {
  return from_bits(((bits_of(square) >> 1) & exponent_of_grid) + offset_of_grid);
}
template <int N>
IRG_INLINE pack<double, N> grid_below_root(const pack<double, N>& square) noexcept {
  return bits_as<double>(((bits_as<std::uint64_t>(square) >> 1) & exponent_of_grid) + offset_of_grid);
}

/// The sum of the squares less that of the root, which is off by some last places.
/// needs   sizes, and the grid of their squares' sum
/// exact   within 2^-72 of the sum for up to 16 numbers
// A square is h*h + (x - h)*(x + h) for x rounded to h, a multiple of the grid. The first kind of terms are added and
// subtracted without rounding, the second kind is so small that its rounding does not count.
template <class F, std::same_as<F>... Others>
IRG_INLINE constexpr F rest_of_squares_one_by_one(const F& root, const F& grid, const F& first,
                                                  const Others&... others) noexcept {
  const auto high = [&](const F& x) IRG_INLINE_LAMBDA { return (x + grid) - grid; };
  F h = high(first), squares = product(h, h), beside = product(first - h, first + h);
  const auto add = [&](const F& x) IRG_INLINE_LAMBDA {
    h = high(x);
    squares = squares + product(h, h);
    beside = beside + product(x - h, x + h);
  };
  (add(others), ...);
  h = high(root);
  return (squares - product(h, h)) + (beside - product(root - h, root + h));
}

/// The same for three numbers, summed in pairs, which lanes can take at once.
template <class F>
IRG_INLINE constexpr F rest_of_squares_one_by_one(const F& root, const F& grid, const F& x, const F& y,
                                                  const F& z) noexcept {
  const F hx = (x + grid) - grid, hy = (y + grid) - grid, hz = (z + grid) - grid, hr = (root + grid) - grid;
  const F squares = (product(hx, hx) + product(hy, hy)) + (product(hz, hz) - product(hr, hr));
  return squares + ((product(x - hx, x + hx) + product(y - hy, y + hy)) +
                    (product(z - hz, z + hz) - product(root - hr, root + hr)));
}

/// The same in doubles: of three, pairs in lanes where there are such.
template <std::same_as<double>... Numbers>
IRG_INLINE constexpr double rest_of_squares(double root, double grid, Numbers... numbers) noexcept {
  return rest_of_squares_one_by_one(root, grid, numbers...);
}
IRG_INLINE constexpr double rest_of_squares(double root, double grid, double x, double y, double z) noexcept {
  if (!has_lanes || std::is_constant_evaluated()) return rest_of_squares_one_by_one(root, grid, x, y, z);
  using F = pack<double, 2>;
  const F xy = pack_of(x, y), zr = pack_of(z, root), g = lanes<F>::broadcast(grid);
  const F hxy = (xy + g) - g, hzr = (zr + g) - g;
  const F squares = hxy * hxy, beside = (xy - hxy) * (xy + hxy), more = hzr * hzr, besides = (zr - hzr) * (zr + hzr);
  const F sums = (shuffled<0, 2>(squares, beside) + shuffled<1, 3>(squares, beside)) +
                 (shuffled<0, 2>(more, besides) - shuffled<1, 3>(more, besides));
  return sums[0] + sums[1];
}

/// The square root of the sum of the squares of sizes.
/// needs   the sum of their squares; is_moderate_square, or all of them multiples of 2^-474
template <class... Sizes>
IRG_INLINE constexpr unrounded length_of_moderate(double square, Sizes... sizes) noexcept {
  const double root = sqrt(square);
  return {root, product(rest_of_squares(root, grid_below_root(square), sizes...), 0.5 / root)};
}

/// Whether squares of these numbers may be taken: constant evaluation refuses what overflows. Numbers that it refuses
/// have no moderate square, at run time either.
template <std::same_as<double>... Numbers>
IRG_INLINE constexpr bool can_take_squares(Numbers... numbers) noexcept {
  return !std::is_constant_evaluated() || ((magnitude(numbers) <= 0x1p500) && ...);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
