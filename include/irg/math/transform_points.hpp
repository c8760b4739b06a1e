// SPDX-License-Identifier: MIT
// Arrays of points through one matrix: the results of transform_point and of the operator *, bit for bit, in a fraction
// of their time.
#pragma once

#include <cstddef>
#include <span>

#include <irg/core/contract.hpp>
#include <irg/math/detail/coordinate_rows_kernel.hpp>
#include <irg/math/detail/transform_kernel.hpp>
#include <irg/math/mat.hpp>

namespace irg {

/// Points whose coordinates stand in arrays of their own: point i is (x[i], y[i], z[i]).
/// shape   three spans of one size
template <class T>
struct point_streams {
  std::span<T> x, y, z;
  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return x.size(); }
};

namespace detail::inline IRG_ABI {

// to[i] = one(from[i]) for positions (Coordinates = 4) or displacements (3).
template <int Coordinates, class T, class From, class To, class One>
constexpr void transform_rows(const mat<T, 4, 4>& a, From from, To to, const One& one) noexcept {
  IRG_EXPECTS(from.size() == to.size());
  if (from.empty()) return;
  const auto each = [&](std::size_t i) { to[i] = one(from[i]); };
  by_rows(
      from.size(), each, [&](auto* p, auto* q) { transform_triples<Coordinates>(a, p, q, from.size(), each); }, from[0],
      to[0]);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The images of positions under an affine matrix, whose last row is not read: out[i] = transform_point(a, points[i]).
/// shape   arrays of irg's points or of other types that are three floats or doubles in a row
/// needs   arrays of one size; `out` begins where `points` does or does not overlap them
/// exact   the bits of transform_point
/// cost    9 products and 9 sums a point in the widest registers; from about 10^5 points on, memory decides
template <class T, class A, class B>
  requires(Point<detail::element_of<const A>> && detail::Triple<detail::element_of<const A>> &&
           std::same_as<detail::element_of<const A>, detail::element_of<B>>)
constexpr void transform_points(const mat<T, 4, 4>& a, const A& points, B&& out) noexcept {
  detail::transform_rows<4>(a, std::span(points), std::span(out), [&](const auto& p) { return transform_point(a, p); });
}

/// The images of displacements under an affine matrix: out[i] = transform_vector(a, vectors[i]).
/// needs   as transform_points
/// exact   the bits of transform_vector
template <class T, class A, class B>
  requires(Vector<detail::element_of<const A>> && detail::Triple<detail::element_of<const A>> &&
           std::same_as<detail::element_of<const A>, detail::element_of<B>>)
constexpr void transform_vectors(const mat<T, 4, 4>& a, const A& vectors, B&& out) noexcept {
  detail::transform_rows<3>(a, std::span(vectors), std::span(out),
                            [&](const auto& v) { return transform_vector(a, v); });
}

/// The images of positions in streams under an affine matrix.
/// needs   six spans of one size; each of `out` begins where its like of `points` does or overlaps none of them
/// exact   the bits of transform_point
template <Floating T>
constexpr void transform_points(const mat<T, 4, 4>& a, std::type_identity_t<point_streams<const T>> points,
                                std::type_identity_t<point_streams<T>> out) noexcept {
  IRG_EXPECTS(points.y.size() == points.size() && points.z.size() == points.size());
  IRG_EXPECTS(out.x.size() == points.size() && out.y.size() == points.size() && out.z.size() == points.size());
  const T* const from[] = {points.x.data(), points.y.data(), points.z.data()};
  T* const to[] = {out.x.data(), out.y.data(), out.z.data()};
  detail::transform_streams(a, from, to, points.size(), [&](std::size_t i) {
    const point<T, 3> image = transform_point(a, point<T, 3>{from[0][i], from[1][i], from[2][i]});
    for (int k = 0; k < 3; ++k) to[k][i] = image[k];
  });
}

/// The images of positions under a matrix that may be projective: out[i] = a * points[i].
/// needs   spans of one size that do not overlap
/// exact   the bits of the operator *
template <Floating T>
constexpr void transform_points(const mat<T, 4, 4>& a, std::type_identity_t<std::span<const point<T, 3>>> points,
                                std::type_identity_t<std::span<hpoint<T, 3>>> out) noexcept {
  IRG_EXPECTS(points.size() == out.size());
  if (points.empty()) return;
  detail::project_points<3>(a, &points[0].x, &out[0].x, points.size(), [&](std::size_t i) { out[i] = a * points[i]; });
}

/// The images of homogeneous points: out[i] = a * points[i].
/// needs   spans of one size; `out` begins where `points` does or does not overlap them
/// exact   the bits of the operator *
template <Floating T>
constexpr void transform_points(const mat<T, 4, 4>& a, std::type_identity_t<std::span<const hpoint<T, 3>>> points,
                                std::type_identity_t<std::span<hpoint<T, 3>>> out) noexcept {
  IRG_EXPECTS(points.size() == out.size());
  if (points.empty()) return;
  detail::project_points<4>(a, &points[0].x, &out[0].x, points.size(), [&](std::size_t i) { out[i] = a * points[i]; });
}

}  // namespace IRG_ABI
}  // namespace irg
