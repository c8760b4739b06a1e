// SPDX-License-Identifier: MIT
// Predicates that never find points in special position: each point stands as if it had been moved by an infinitely
// small amount of its own, always the same, so that all answers together are those of one set of points in general
// position. Where the points as they are decide, they do.
//
// The moved coordinates. Points have an order: lexicographic, or that of numbers given with them. Coordinate j of the
// i-th point of that order is raised by e(i, j) > 0, and so is, for circles and spheres, the sum of its squares, as
// coordinate j = D of the point lifted to the paraboloid. Within
//     e(0, last), ..., e(0, 1), e(0, 0), e(1, last), ..., e(1, 0), e(2, last), ...
// each is smaller than every product of earlier ones. A predicate is the sign of a determinant whose rows are the
// (lifted) points, with a last column of ones. As a polynomial in the e its coefficients are minors: to multiply by
// e(i, j) is to strike out row i and column j. The sizes of products of different e are ordered as the binary numbers
// whose bit k is set where the k-th e of the sequence is a factor, so the first coefficient in the order of these
// numbers that is not zero is the sign. There always is one: all columns but the ones can be struck out.
//
// Why the answers agree with each other. The order of any two e is the order of their points, then of their
// coordinates; it does not depend on which other points are asked about, nor on how many. Hence every set of points has
// one set of e for all calls, in the plane or lifted, and the answers are those of the moved points. Circles are planes
// through moved points at moved heights: what a construction gets from them is the weighted Delaunay triangulation of
// the moved points with infinitely small weights. Its triangles are those of a Delaunay triangulation of the points as
// they are, and flat ones on the hull where points lie on a line.
//
// The lexicographic order needs no numbers and makes the answer depend on the points alone. It cannot tell equal points
// apart; numbers can.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include <irg/geometry/compare.hpp>
#include <irg/geometry/in_circle.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/math/exact/nearest_float.hpp>
#include <irg/math/exact/big_float.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A point with a number of its own. Points with different numbers are never equal.
template <Point P>
struct numbered_point {
  P point;
  std::int64_t number;
  IRG_APART constexpr bool operator==(const numbered_point& o) const {
    return same_place(point, o.point) && number == o.number;
  }
};
template <Point P>
numbered_point(const P&, std::int64_t) -> numbered_point<P>;

namespace detail::inline IRG_ABI {

// The determinant of N points in D dimensions, in the order of their perturbation: N = D + 1 for the simplex, D + 2
// lifted.
template <class P, std::size_t N>
class perturbed_determinant {
public:
  IRG_INLINE constexpr explicit perturbed_determinant(const std::array<const P*, N>& points) noexcept
      : point_(points) {}

  /// The sign of the first coefficient that is not zero, without the first one, the determinant of the points as they
  /// are.
  constexpr int sign() const noexcept { return first_sign(all_rows, all_columns, 1, (columns + 1) * columns - 1); }

private:
  static constexpr int dimension = size_of<P>, columns = static_cast<int>(N) - 1;
  static constexpr unsigned all_rows = (1u << N) - 1, all_columns = (1u << columns) - 1;
  using T = scalar_of<P>;

  static constexpr bool has(unsigned set, int i) noexcept { return (set >> i & 1) != 0; }
  static constexpr unsigned before(unsigned set, int i) noexcept { return set & ((1u << i) - 1); }

  // Over all ways to strike out, in order, further ones of the first k + 1 of the sequence.
  constexpr int first_sign(unsigned rows, unsigned cols, int factor, int k) const noexcept {
    if (k < 0) return rows == all_rows ? 0 : factor * minor_sign(rows, cols);
    if (const int sign = first_sign(rows, cols, factor, k - 1); sign != 0) return sign;
    const int row = k / columns, column = columns - 1 - k % columns;
    if (!has(rows, row) || !has(cols, column)) return 0;
    const int place = std::popcount(before(rows, row)) + std::popcount(before(cols, column));
    return first_sign(rows & ~(1u << row), cols & ~(1u << column), place % 2 == 0 ? factor : -factor, k - 1);
  }

  // The determinant of these rows and columns, and the ones.
  constexpr int minor_sign(unsigned rows, unsigned cols) const noexcept {
    if (cols == 0) return 1;
    if (!has(cols, dimension)) {
      if (std::popcount(cols) == 1) {
        const int j = std::countr_zero(cols);
        const int first = std::countr_zero(rows), second = std::countr_zero(rows & (rows - 1));
        return compare_numbers(coordinate(point(first), j), coordinate(point(second), j));
      }
      if constexpr (dimension >= 2)
        if (std::popcount(cols) == 2) return shadow_orientation(rows, cols);
      if constexpr (dimension == 3) return -orient3d(nth(rows, 0), nth(rows, 1), nth(rows, 2), nth(rows, 3));
    }
    return exact_determinant_sign(rows, cols);
  }

  constexpr const P& nth(unsigned rows, int n) const noexcept {
    while (n-- > 0) rows &= rows - 1;
    return point(std::countr_zero(rows));
  }

  // orient2d of three points seen along an axis.
  constexpr int shadow_orientation(unsigned rows, unsigned cols) const noexcept {
    const int x = std::countr_zero(cols), y = std::countr_zero(cols & (cols - 1));
    const auto shadow = [&](int n) {
      return irg::point<T, 2>{coordinate(nth(rows, n), x), coordinate(nth(rows, n), y)};
    };
    return orient2d(shadow(0), shadow(1), shadow(2));
  }

  IRG_NOINLINE constexpr int exact_determinant_sign(unsigned rows, unsigned cols) const noexcept {
    if constexpr (Floating<T> || std::is_integral_v<T>)
      return determinant<big_float<dimension + 1>>(rows, cols).sign();
    else
      return compare_numbers(determinant<T>(rows, cols), T(0));
  }

  template <class Value>
  static constexpr Value as_number(const T& x) noexcept {
    if constexpr (std::is_same_v<Value, T>)
      return x;
    else
      return exactly<Value>(x);
  }

  // Coordinate j, or the sum of squares.
  template <class Value>
  constexpr Value entry(int row, int column) const noexcept {
    const auto number = [&](int j) { return as_number<Value>(coordinate(point(row), j)); };
    if (column < dimension) return number(column);
    Value sum = number(0) * number(0);
    for (int j = 1; j < dimension; ++j) sum = sum + number(j) * number(j);
    return sum;
  }

  // By the first column.
  template <class Value>
  constexpr Value determinant(unsigned rows, unsigned cols) const noexcept {
    const int column = std::countr_zero(cols);
    const unsigned rest = cols & (cols - 1);
    Value sum = as_number<Value>(T(0));
    bool minus = false;
    for (unsigned left = rows; left != 0; left &= left - 1, minus = !minus) {
      const int row = std::countr_zero(left);
      const Value x = entry<Value>(row, column);
      const Value term = rest == 0 ? x : x * determinant<Value>(rows & ~(1u << row), rest);
      sum = minus ? sum - term : sum + term;
    }
    return sum;
  }

  constexpr const P& point(int row) const noexcept { return *point_[static_cast<std::size_t>(row)]; }

  std::array<const P*, N> point_;
};

template <class P>
IRG_INLINE constexpr const P& point_of(const P& p) noexcept {
  return p;  // NOLINT(bugprone-return-const-ref-from-parameter)
}
template <class P>
IRG_INLINE constexpr const P& point_of(const numbered_point<P>& p) noexcept {
  return p.point;
}
template <class P>
using bare_point = std::remove_cvref_t<decltype(point_of(std::declval<const P&>()))>;
template <Point P>
IRG_INLINE constexpr int compare_for_perturbation(const P& p, const P& q) noexcept {
  return compare_lexicographic(p, q);
}
template <class P>
IRG_INLINE constexpr int compare_for_perturbation(const numbered_point<P>& p, const numbered_point<P>& q) noexcept {
  return compare_numbers(p.number, q.number);
}

// The perturbed determinant's sign for points in the order they come: that in their own order, times the sign of the
// permutation. 0 when their order does not tell two of them apart.
template <class... Q>
IRG_NOINLINE constexpr int perturbed_sign(const Q&... q) noexcept {
  using item = std::common_type_t<Q...>;
  using P = bare_point<item>;
  std::array<const item*, sizeof...(Q)> items{&q...};
  int factor = 1;
  for (std::size_t i = 1; i < items.size(); ++i)
    for (std::size_t k = i; k > 0; --k) {
      const int order = compare_for_perturbation(*items[k - 1], *items[k]);
      if (order == 0) return 0;
      if (order < 0) break;
      std::swap(items[k - 1], items[k]);
      factor = -factor;
    }
  std::array<const P*, sizeof...(Q)> points{};
  for (std::size_t i = 0; i < items.size(); ++i) points[i] = &point_of(*items[i]);
  return factor * perturbed_determinant<P, sizeof...(Q)>(points).sign();
}

}  // namespace detail::inline IRG_ABI

/// A point of D coordinates, or one with a number.
template <class P, int D>
concept PerturbedPoint = Point<detail::bare_point<P>> && size_of<detail::bare_point<P>> == D;

inline namespace IRG_ABI {

/// orient2d that is never 0 for three different points: 1 when the way from a over b to c turns left, -1 when it turns
/// right, and one of the two, as if the points were moved a little, when they lie on a line.
/// shape   points, or points with numbers, which are equal only where their numbers are
/// needs   finite coordinates
/// gives   0 when two of the points are equal
/// exact   the sign of orient2d, or of the moved points; changes with every exchange of two points
/// cost    as orient2d, and some 20 ns more where that is 0
/// source  Edelsbrunner and Muecke 1990, with the lexicographic order for their indices
template <PerturbedPoint<2> P>
[[nodiscard]] constexpr int orient2d_sos(const P& a, const P& b, const P& c) noexcept {
  const int sign = orient2d(detail::point_of(a), detail::point_of(b), detail::point_of(c));
  return sign != 0 ? sign : detail::perturbed_sign(a, b, c);
}

/// orient3d that is never 0 for four different points: the side of the plane through a, b and c that d lies on, 1 for
/// that from which they are seen counter-clockwise, or would if all points were moved a little.
/// shape   points, or points with numbers, which are equal only where their numbers are
/// needs   finite coordinates
/// gives   0 when two of the points are equal
/// exact   the sign of orient3d, or of the moved points; changes with every exchange of two points
/// source  Edelsbrunner and Muecke 1990, with the lexicographic order for their indices
template <PerturbedPoint<3> P>
[[nodiscard]] constexpr int orient3d_sos(const P& a, const P& b, const P& c, const P& d) noexcept {
  const int sign = orient3d(detail::point_of(a), detail::point_of(b), detail::point_of(c), detail::point_of(d));
  return sign != 0 ? sign : -detail::perturbed_sign(a, b, c, d);
}

/// in_circle that is never 0 for four different points: 1 when d lies inside of the circle through a, b and c (which
/// turn left), -1 outside, or as if all points were moved a little and their heights above the plane, too.
/// shape   points, or points with numbers, which are equal only where their numbers are
/// needs   finite coordinates
/// gives   0 when two of the points are equal
/// exact   the sign of in_circle, or of the moved points; changes with every exchange of two points
/// cost    as in_circle, and some 50 ns more where that is 0, half a microsecond where the points lie on a line
/// source  Edelsbrunner and Muecke 1990; Devillers and Teillaud 2011 (moved heights, lexicographic order)
template <PerturbedPoint<2> P>
[[nodiscard]] constexpr int in_circle_sos(const P& a, const P& b, const P& c, const P& d) noexcept {
  const int sign = in_circle(detail::point_of(a), detail::point_of(b), detail::point_of(c), detail::point_of(d));
  return sign != 0 ? sign : detail::perturbed_sign(a, b, c, d);
}

/// in_sphere that is never 0 for five different points: 1 when e lies inside of the sphere through a, b, c and d (with
/// orient3d 1), -1 outside, or as if all points were moved a little and the sums of their squares, too.
/// shape   points, or points with numbers, which are equal only where their numbers are
/// needs   finite coordinates
/// gives   0 when two of the points are equal
/// exact   the sign of in_sphere, or of the moved points; changes with every exchange of two points
/// source  as in_circle_sos
template <PerturbedPoint<3> P>
[[nodiscard]] constexpr int in_sphere_sos(const P& a, const P& b, const P& c, const P& d, const P& e) noexcept {
  const int sign = in_sphere(detail::point_of(a), detail::point_of(b), detail::point_of(c), detail::point_of(d),
                             detail::point_of(e));
  return sign != 0 ? sign : -detail::perturbed_sign(a, b, c, d, e);
}

IRG_REFUSES_VECTORS(orient2d_sos);
IRG_REFUSES_VECTORS(orient3d_sos);
IRG_REFUSES_VECTORS(in_circle_sos);
IRG_REFUSES_VECTORS(in_sphere_sos);

}  // namespace IRG_ABI
}  // namespace irg
