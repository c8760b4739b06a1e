// SPDX-License-Identifier: MIT
// parametric_line<T, N>: the points origin + t*direction, and the same through homogeneous points.
#pragma once

#include <limits>
#include <optional>

#include <irg/core/is_finite.hpp>
#include <irg/math/exact/values_of.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// The points origin + t*direction: t = 0 is the origin, t = 1 its end.
template <Scalar T, int N>
struct parametric_line {
  point<T, N> origin{};
  vec<T, N> direction{};
  bool operator==(const parametric_line&) const = default;
};

/// The points start + t*(end - start) in all homogeneous coordinates, the weight among them.
template <Scalar T, int N>
struct homogeneous_line {
  hpoint<T, N> start{}, end{};
  bool operator==(const homogeneous_line&) const = default;
};

/// The parts into which its two points divide a line.
enum class line_part { before_start, segment, after_end };

inline namespace IRG_ABI {

/// The line from a (t = 0) to b (t = 1).
/// gives   nothing when the points are equal, or a coordinate is NaN or infinite
/// exact   the direction b - a is rounded once; functions that take the two points themselves are not affected by that
/// source  Mihajlovic 2016, formula 2.7; Hank n.d., 1.3.1
template <Point P>
[[nodiscard]] constexpr std::optional<parametric_line<scalar_of<P>, size_of<P>>> parametric_line_through(
    const P& a, const P& b) noexcept {
  using T = scalar_of<P>;
  constexpr int N = size_of<P>;
  bool differ = false;
  for (int i = 0; i < N; ++i) differ = differ || !(coordinate(a, i) == coordinate(b, i));
  if (!differ || !is_finite(a, b)) return std::nullopt;
  return parametric_line<T, N>{
      generate_coordinates<point<T, N>>([&](int i) { return coordinate(a, i); }),
      generate_coordinates<vec<T, N>>([&](int i) { return coordinate(b, i) - coordinate(a, i); })};
}

/// The line's matrix of two columns, direction and origin: the point at t is the matrix times (t, 1).
/// source  Hank n.d., 1.3.1
template <class T, int N>
[[nodiscard]] constexpr mat<T, N, 2> columns_of(const parametric_line<T, N>& line) noexcept {
  mat<T, N, 2> m;
  for (int i = 0; i < N; ++i) m(i, 0) = line.direction[i];
  for (int i = 0; i < N; ++i) m(i, 1) = line.origin[i];
  return m;
}

/// The point at t.
/// exact   product and sum rounded once each
template <class T, int N>
[[nodiscard]] constexpr point<T, N> point_at(const parametric_line<T, N>& line, std::type_identity_t<T> t) noexcept {
  return line.origin + line.direction * t;
}

/// The homogeneous point at t. With unequal weights t is not proportional to the distance.
/// exact   difference, product and sum rounded once each
/// source  Mihajlovic 2016, formula 2.7
template <class T, int N>
[[nodiscard]] constexpr hpoint<T, N> point_at(const homogeneous_line<T, N>& line, std::type_identity_t<T> t) noexcept {
  return generate_coordinates<hpoint<T, N>>(
      [&](int i) { return product(line.end[i] - line.start[i], t) + line.start[i]; });
}

/// The point that divides the way from a to b as t says: a at t = 0, b at t = 1, on the line through both for other t.
/// gives   NaN for a coordinate that depends on NaN or infinity; infinity only beyond the range
/// exact   each coordinate within 0.501 ulp of a + t(b - a), so that t = 0 and t = 1 give a and b themselves
/// cost    some 100 ns; point_at is the plain formula
template <Point P>
  requires Real<scalar_of<P>>
[[nodiscard]] constexpr P point_between(const P& a, const P& b, scalar_of<P> t) noexcept {
  using T = scalar_of<P>;
  return generate_coordinates<P>([&](int i) -> T {
    const auto sum =
        values_of<2>([](const auto& from, const auto& to, const auto& s) { return from + s * (to - from); },
                     coordinate(a, i), coordinate(b, i), t);
    if (!sum) return std::numeric_limits<T>::quiet_NaN();
    return rounded_to<T>(*sum);
  });
}

/// Which part of its line the point at t belongs to; both ends count as the segment.
/// gives   after_end when t is NaN
template <Scalar T>
[[nodiscard]] constexpr line_part part_of_line(const T& t) noexcept {
  return t < T(0) ? line_part::before_start : !(T(1) < t) && t == t ? line_part::segment : line_part::after_end;
}

IRG_REFUSES_VECTORS(parametric_line_through);
IRG_REFUSES_VECTORS(point_between);

}  // namespace IRG_ABI
}  // namespace irg
