// SPDX-License-Identifier: MIT
// The depth of a plane at points of the picture, as textbooks compute it: from the plane's equation at each point, or
// by one addition from each pixel to the next. The picture plane is z = 0; in parallel projection a point keeps its x
// and y, in perspective the eye is at (0, 0, d) and x' = x d/(d - z). With d > 0 the z axis points at the viewer, with
// d < 0 away from him: z then grows with the distance.
#pragma once

#include <cstdint>
#include <optional>

#include <irg/geometry/plane.hpp>

namespace irg {

/// Where on the picture plane the pixels take their samples: pixel (column, row) at (x + column * per_column,
/// y + row * per_row). Left as it is, pixels are unit squares sampled at their centres; {0, 0} samples whole numbers,
/// {0.5, height - 0.5, 1, -1} turns the picture's y up.
template <Real T>
struct picture_grid {
  T x = T(1) / T(2), y = T(1) / T(2), per_column = T(1), per_row = T(1);

  [[nodiscard]] IRG_INLINE constexpr T x_of(int column) const noexcept {
    return x + product(static_cast<T>(column), per_column);
  }
  [[nodiscard]] IRG_INLINE constexpr T y_of(int row) const noexcept {
    return y + product(static_cast<T>(row), per_row);
  }
  bool operator==(const picture_grid&) const = default;
};

/// A quantity that is linear on the picture: its value at pixel (0, 0), and how much it grows from each column to the
/// next and from each row to the next.
template <Real T>
struct depth_steps {
  T origin{}, per_column{}, per_row{};
  bool operator==(const depth_steps&) const = default;
};

inline namespace IRG_ABI {

/// The z at which a plane is met above (x, y): (-D - A x - B y) / C.
/// gives   nothing when C is 0: the plane is seen edge on
/// exact   for rationals; in floats, where no term leaves the range or is subnormal, off by at most
///         5u (|D| + |A x| + |B y|) / |C|
/// source  Hidden-surface slides, the z-buffer algorithm
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr std::optional<plane_scalar<P>> plane_depth(const P& p, const plane_scalar<P>& x,
                                                                   const plane_scalar<P>& y) noexcept {
  using T = plane_scalar<P>;
  const T c = plane_coefficient(p, 2);
  if (!(c < T(0) || T(0) < c)) return std::nullopt;
  const T sum = product(plane_coefficient(p, 0), x) + product(plane_coefficient(p, 1), y) + plane_coefficient(p, 3);
  return (T(0) - sum) / c;
}

/// The z at which the ray from the eye (0, 0, d) through (x', y', 0) meets a plane:
/// d (A x' + B y' + D) / (A x' + B y' - C d).
/// gives   nothing when the ray is parallel to the plane or meets it at the eye or behind it, and when d is 0
/// exact   for rationals; in floats, where no term leaves the range or is subnormal, numerator and denominator are each
///         off by at most 4u times the sum of the absolute values of their terms
/// source  Hidden-surface slides; not linear in x'
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr std::optional<plane_scalar<P>> plane_depth_perspective(const P& p, const plane_scalar<P>& d,
                                                                               const plane_scalar<P>& x,
                                                                               const plane_scalar<P>& y) noexcept {
  using T = plane_scalar<P>;
  const T sum = product(plane_coefficient(p, 0), x) + product(plane_coefficient(p, 1), y);
  const T below = sum - product(plane_coefficient(p, 2), d);
  if (!(below < T(0) || T(0) < below)) return std::nullopt;
  const T z = product(d, sum + plane_coefficient(p, 3)) / below;
  const bool in_front = T(0) < d ? z < d : d < T(0) && d < z;
  return in_front ? std::optional<T>(z) : std::nullopt;
}

/// The depth of a plane as steps over the picture: -A/C from column to column, -B/C from row to row.
/// gives   nothing when C is 0
/// source  Hidden-surface slides: A/C is computed once for the whole polygon
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr std::optional<depth_steps<plane_scalar<P>>> plane_depth_steps(
    const P& p, const picture_grid<plane_scalar<P>>& grid = {}) noexcept {
  using T = plane_scalar<P>;
  const std::optional<T> origin = plane_depth(p, grid.x, grid.y);
  if (!origin) return std::nullopt;
  const T c = plane_coefficient(p, 2);
  return depth_steps<T>{*origin, product((T(0) - plane_coefficient(p, 0)) / c, grid.per_column),
                        product((T(0) - plane_coefficient(p, 1)) / c, grid.per_row)};
}

/// 1/(d - z) of a plane as steps over the picture: (C d - A x' - B y') / (d (C d + D)). Unlike z it is linear in x'; it
/// orders as z does, and z is d - 1/value.
/// gives   nothing when the plane holds the eye: it is seen edge on; and when d is 0
/// source  Hidden-surface slides, the perspective depth, rearranged
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr std::optional<depth_steps<plane_scalar<P>>> inverse_depth_steps(
    const P& p, const plane_scalar<P>& d, const picture_grid<plane_scalar<P>>& grid = {}) noexcept {
  using T = plane_scalar<P>;
  const T a = plane_coefficient(p, 0), b = plane_coefficient(p, 1), cd = product(plane_coefficient(p, 2), d);
  const T scale = product(d, cd + plane_coefficient(p, 3));
  if (!(scale < T(0) || T(0) < scale)) return std::nullopt;
  return depth_steps<T>{(cd - product(a, grid.x) - product(b, grid.y)) / scale,
                        product((T(0) - a) / scale, grid.per_column), product((T(0) - b) / scale, grid.per_row)};
}

}  // namespace IRG_ABI

/// Depths by repeated addition, from pixel to pixel and from row to row; the first pixel asked for is computed.
/// exact   in floats off by at most (n + 12) u M, n being the columns passed in this row and three times the rows
///         passed since the first one, M the greatest (|D| + |A x| + |B y|) / |C| among the pixels passed (for
///         1/(d - z), the sum of the absolute values of its terms)
template <Real T>
class depth_walk {
public:
  IRG_INLINE constexpr explicit depth_walk(const depth_steps<T>& steps) noexcept : steps_(steps) {}

  /// Goes to a pixel. From the start of the row before it gets there by adding: per_row once, and per_column times the
  /// number of columns between, the row's end being where the polygon's side has moved.
  IRG_INLINE constexpr void start(int column, int row) noexcept {
    const T columns = under_way_ ? steps_between(column_, column) : static_cast<T>(column);
    const T rows = under_way_ ? steps_between(row_, row) : static_cast<T>(row);
    first_ = (under_way_ ? first_ : steps_.origin) + product(rows, steps_.per_row);
    first_ = first_ + product(columns, steps_.per_column);
    value_ = first_;
    column_ = column;
    row_ = row;
    under_way_ = true;
  }
  [[nodiscard]] IRG_INLINE constexpr const T& value() const noexcept { return value_; }
  IRG_INLINE constexpr void next() noexcept { value_ = value_ + steps_.per_column; }

private:
  // to - from, which an int may be too small for.
  IRG_INLINE static constexpr T steps_between(int from, int to) noexcept {
    if constexpr (Floating<T>)
      return static_cast<T>(std::int64_t{to} - from);
    else
      return static_cast<T>(to) - static_cast<T>(from);
  }

  depth_steps<T> steps_;
  T first_{}, value_{};
  int column_ = 0, row_ = 0;
  bool under_way_ = false;
};

/// Depths from the plane's equation, anew at each pixel. Those of pixels that the plane has no depth at (see
/// plane_depth_perspective) are `otherwise`.
template <Real T>
class plane_walk {
public:
  /// Parallel projection.
  IRG_INLINE constexpr plane_walk(const plane<T>& p, const picture_grid<T>& grid, const T& otherwise) noexcept
      : plane_(p), grid_(grid), otherwise_(otherwise) {}
  /// Perspective from (0, 0, d).
  IRG_INLINE constexpr plane_walk(const plane<T>& p, const T& d, const picture_grid<T>& grid,
                                  const T& otherwise) noexcept
      : plane_(p), grid_(grid), otherwise_(otherwise), d_(d), perspective_(true) {}

  IRG_INLINE constexpr void start(int column, int row) noexcept {
    column_ = column;
    row_ = row;
  }
  [[nodiscard]] IRG_INLINE constexpr T value() const noexcept {
    const T x = grid_.x_of(column_), y = grid_.y_of(row_);
    return (perspective_ ? plane_depth_perspective(plane_, d_, x, y) : plane_depth(plane_, x, y)).value_or(otherwise_);
  }
  IRG_INLINE constexpr void next() noexcept { ++column_; }

private:
  plane<T> plane_;
  picture_grid<T> grid_;
  T otherwise_, d_{};
  int column_ = 0, row_ = 0;
  bool perspective_ = false;
};

}  // namespace irg
