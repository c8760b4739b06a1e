// SPDX-License-Identifier: MIT
// frustum<T>: the part of space that a picture shows, as six planes with inward normals, its corners, and whether
// boxes, balls and points are outside, inside or across its boundary. The answers err on one side only: what is called
// outside may be left out, what is called inside need not be clipped, whatever the rounding.
#pragma once

#include <limits>
#include <optional>

#include <irg/core/vocabulary.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/view/projection.hpp>

namespace irg {

/// The planes of a frustum, in the order of clip_planes. Unlike there, near is near with either depth_range.
enum class frustum_plane { z_near, z_far, left, right, bottom, top };

/// Six planes; what is on or above all of them is inside.
/// shape   a plane without a normal keeps nothing out: 0, 0, 0, 1 stands for the far plane at infinity, and 0, 0, 0, 0
///         for a plane that is unknown, so that nothing is surely outside or inside of it
template <Scalar T>
struct frustum {
  plane<T> planes[6]{};
  // The absolute values that each coefficient was added up from, on the same scale: rounding moves the value of a plane
  // by a small multiple of u times weights * (|x|, |y|, |z|, 1).
  plane<T> weights[6]{};
  bool operator==(const frustum&) const = default;
  IRG_INLINE constexpr const plane<T>& operator[](frustum_plane which) const noexcept {
    return planes[static_cast<int>(which)];
  }
  /// Sets a plane; its coefficients are taken to be rounded once at most.
  IRG_INLINE constexpr void set(frustum_plane which, const plane<T>& p) noexcept {
    const auto size = [](const T& x) IRG_INLINE_LAMBDA { return x < T(0) ? T(-x) : x; };
    planes[static_cast<int>(which)] = p;
    weights[static_cast<int>(which)] = {size(p.a), size(p.b), size(p.c), size(p.d)};
  }
};

/// The corners of a part of space with six sides: bit 0 of the index chooses left (0) or right (1), bit 1 bottom or
/// top, bit 2 the near or the far end.
template <class P>
struct volume_corners {
  P at[8]{};
  bool operator==(const volume_corners&) const = default;
};

/// The corners of a frustum; w is 1, or 0 for corners at infinity, which are directions.
template <Scalar T>
using frustum_corner_points = volume_corners<hpoint<T, 3>>;

inline namespace IRG_ABI {

/// The frustum of a matrix to clip space: from camera space with a projection, from the world with view and projection.
/// shape   in order: near, far, left, right, bottom, top; near is w - z >= 0 and far z >= 0 with reversed depth, the
///         other way round with the standard one; left is w + x >= 0, and so on. In floats normals have length 1, so
///         that a plane's value is the distance from it
/// gives   for an infinite far plane 0, 0, 0, 1; for coefficients that are NaN or infinite, or become so with the
///         normal's length, 0, 0, 0, 0
/// exact   in rationals, where normals keep their length; in floats each coefficient within 3u of the sum of the
///         absolute values it is made of
/// source  Gribb and Hartmann 2001
template <Real T>
[[nodiscard]] constexpr frustum<T> frustum_of(const mat<T, 4, 4>& to_clip,
                                              depth_range depth = depth_range::reversed) noexcept;

/// The corners of a frustum, each one where three of its planes meet.
/// gives   nothing unless every corner is in front of the other three planes: for planes that enclose no volume. With
///         the far plane at infinity the far corners are the directions of the edges
/// exact   in rationals; in floats within about 100u times the condition of the three planes
template <Real T>
[[nodiscard]] constexpr std::optional<frustum_corner_points<T>> frustum_corners(const frustum<T>& f) noexcept;

/// Where a box lies with regard to a frustum.
/// gives   outside when all of it is below one plane, and for an empty box; inside when all of it is above every plane.
///         A box beside an edge or corner of the frustum may be below no single plane: then it is called crossing
///         though it has no point in common. Crossing also for NaN planes and infinite boxes
/// exact   in rationals. In floats the margin of 16u covers the rounding of the planes, of this test and of the clip
///         coordinates: for every position of a box called outside, m * p has the clip code of the same plane, unless
///         products in m * p are subnormal
/// cost    per plane two scalar products
/// source  Assarsson and Moller 2000: the corner nearest to the plane and the one farthest from it
template <Real T>
[[nodiscard]] constexpr containment classify(const frustum<T>& f, const box<T, 3>& b) noexcept;

/// Where a ball lies with regard to a frustum.
/// needs   normals of length 1, as frustum_of and with_unit_normals have them
/// gives   as for a box; outside for a negative radius, crossing for NaN
/// exact   as for a box
/// cost    per plane one scalar product
template <Floating T>
[[nodiscard]] constexpr containment classify(const frustum<T>& f, const bounding_sphere<T, 3>& ball) noexcept;

/// Where a position lies with regard to a frustum; on its boundary, in floats beside it by rounding: crossing.
/// gives   in rationals inside for the boundary too; crossing for NaN
/// exact   as for a box
template <Real T>
[[nodiscard]] constexpr containment classify(const frustum<T>& f, const point<T, 3>& p) noexcept {
  const box<T, 3> b{p, p};
  return b.empty() ? containment::crossing : classify(f, b);
}

/// The frustum with normals of length 1.
/// exact   each coefficient within 2u
template <Floating T>
[[nodiscard]] constexpr frustum<T> with_unit_normals(frustum<T> f) noexcept;

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// The plane with its normal at length 1, and its weights on the same scale.
template <class T>
constexpr void normalise_frustum_plane(plane<T>& p, plane<T>& weight) noexcept {
  const T length_of_normal = length(normal_of(p));
  const auto over = [&](T x) { return quotient(x, length_of_normal); };
  if (T(0) < length_of_normal && is_finite(length_of_normal) && is_finite(p.d) && is_finite(over(p.d))) {
    p = {over(p.a), over(p.b), over(p.c), over(p.d)};
    weight = {over(weight.a), over(weight.b), over(weight.c), over(weight.d)};
  } else {
    const bool at_infinity = length_of_normal == T(0) && T(0) < p.d;
    p = {T(0), T(0), T(0), at_infinity ? T(1) : T(0)};
    weight = p;
  }
}

// What rounding may have moved the value of a plane by, for positions whose coordinates are at most `size`.
template <class T>
constexpr T frustum_margin(const plane<T>& weight, const point<T, 3>& size) noexcept {
  if constexpr (Floating<T>) {
    constexpr T u16 = T(8) * std::numeric_limits<T>::epsilon();
    const T sum = product(weight.a, size.x) + product(weight.b, size.y) + product(weight.c, size.z) + weight.d;
    return product(u16, sum) + (std::numeric_limits<T>::min)();
  } else {
    return T(0);
  }
}

// The position that three planes have in common, homogeneous; all zero when there is none or more than one.
template <class T>
constexpr hpoint<T, 3> common_position(const plane<T>& p, const plane<T>& q, const plane<T>& r) noexcept {
  const auto det = [&](int i, int j, int k) {
    const mat<T, 3, 3> m{{{plane_coefficient(p, i), plane_coefficient(p, j), plane_coefficient(p, k)},
                          {plane_coefficient(q, i), plane_coefficient(q, j), plane_coefficient(q, k)},
                          {plane_coefficient(r, i), plane_coefficient(r, j), plane_coefficient(r, k)}}};
    return determinant(m);
  };
  return {det(1, 2, 3), T(0) - det(0, 2, 3), det(0, 1, 3), T(0) - det(0, 1, 2)};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <Real T>
[[nodiscard]] constexpr frustum<T> frustum_of(const mat<T, 4, 4>& to_clip, depth_range depth) noexcept {
  const auto size = [](const T& x) { return x < T(0) ? T(-x) : x; };
  frustum<T> f{};
  const auto set = [&](frustum_plane which, int row, bool with_w, bool minus) {
    const auto entry = [&](int c) {
      const T other = minus ? T(-to_clip(row, c)) : to_clip(row, c);
      return with_w ? T(to_clip(3, c) + other) : other;
    };
    const auto weight = [&](int c) {
      return with_w ? T(size(to_clip(3, c)) + size(to_clip(row, c))) : size(to_clip(row, c));
    };
    plane<T>& p = f.planes[static_cast<int>(which)];
    p = {entry(0), entry(1), entry(2), entry(3)};
    plane<T>& w = f.weights[static_cast<int>(which)];
    w = {weight(0), weight(1), weight(2), weight(3)};
    if constexpr (Floating<T>) detail::normalise_frustum_plane(p, w);
  };
  const bool reversed = depth == depth_range::reversed;
  set(frustum_plane::z_near, 2, reversed, reversed);
  set(frustum_plane::z_far, 2, !reversed, !reversed);
  set(frustum_plane::left, 0, true, false);
  set(frustum_plane::right, 0, true, true);
  set(frustum_plane::bottom, 1, true, false);
  set(frustum_plane::top, 1, true, true);
  return f;
}

template <Real T>
[[nodiscard]] constexpr std::optional<frustum_corner_points<T>> frustum_corners(const frustum<T>& f) noexcept {
  using enum frustum_plane;
  frustum_corner_points<T> corners{};
  for (int k = 0; k < 8; ++k) {
    const auto pick = [&](int bit, frustum_plane low, frustum_plane high) -> const plane<T>& {
      return f[(k >> bit & 1) != 0 ? high : low];
    };
    hpoint<T, 3> p = detail::common_position(pick(0, left, right), pick(1, bottom, top), pick(2, z_near, z_far));
    const auto value = [&](const plane<T>& o) {
      return product(o.a, p.x) + product(o.b, p.y) + product(o.c, p.z) + product(o.d, p.w);
    };
    const T opposite[3] = {value(pick(0, right, left)), value(pick(1, top, bottom)), value(pick(2, z_far, z_near))};
    const T sign = opposite[0] < T(0) ? T(-1) : T(1);
    for (const T& v : opposite)
      if (!(T(0) < product(sign, v))) return std::nullopt;
    p = {product(sign, p.x), product(sign, p.y), product(sign, p.z), product(sign, p.w)};
    if (p.w < T(0)) return std::nullopt;
    if (T(0) < p.w) p = {p.x / p.w, p.y / p.w, p.z / p.w, T(1)};
    corners.at[k] = p;
  }
  return corners;
}

template <Real T>
[[nodiscard]] constexpr containment classify(const frustum<T>& f, const box<T, 3>& b) noexcept {
  if (b.empty()) return containment::outside;
  const auto size = [](const T& x) { return x < T(0) ? T(-x) : x; };
  const auto reach = generate_coordinates<point<T, 3>>([&](int i) { return maximum(size(b.low[i]), size(b.high[i])); });
  bool inside = true;
  for (int k = 0; k < 6; ++k) {
    const plane<T>& p = f.planes[k];
    const auto value = [&](bool highest) {
      const auto along = [&](const T& normal, int i) {
        return product(normal, (normal < T(0)) == highest ? b.low[i] : b.high[i]);
      };
      return along(p.a, 0) + along(p.b, 1) + along(p.c, 2) + p.d;
    };
    const T margin = detail::frustum_margin(f.weights[k], reach), lowest = value(false);
    if (value(true) < T(0) - margin) return containment::outside;
    inside = inside && (margin < lowest || margin == lowest);
  }
  return inside ? containment::inside : containment::crossing;
}

template <Floating T>
[[nodiscard]] constexpr containment classify(const frustum<T>& f, const bounding_sphere<T, 3>& ball) noexcept {
  if (ball.radius < T(0)) return containment::outside;
  const auto reach = generate_coordinates<point<T, 3>>([&](int i) { return magnitude(ball.centre[i]); });
  bool inside = true;
  for (int k = 0; k < 6; ++k) {
    const plane<T>& p = f.planes[k];
    const bool has_normal = p.a != T(0) || p.b != T(0) || p.c != T(0);
    const T radius = has_normal ? ball.radius : T(0);
    const T value = product(p.a, ball.centre.x) + product(p.b, ball.centre.y) + product(p.c, ball.centre.z) + p.d;
    const T margin = detail::frustum_margin(f.weights[k], reach);
    if (value < T(0) - (radius + margin)) return containment::outside;
    inside = inside && radius + margin <= value;
  }
  return inside ? containment::inside : containment::crossing;
}

/// The old name of classify for what a frustum holds.
template <Floating T, class Body>
[[nodiscard, deprecated("irg: now classify")]] constexpr containment side_of(const frustum<T>& f,
                                                                             const Body& body) noexcept {
  return classify(f, body);
}

template <Floating T>
[[nodiscard]] constexpr frustum<T> with_unit_normals(frustum<T> f) noexcept {
  for (int k = 0; k < 6; ++k) detail::normalise_frustum_plane(f.planes[k], f.weights[k]);
  return f;
}

}  // namespace IRG_ABI
}  // namespace irg
