// SPDX-License-Identifier: MIT
// Axonometry: parallel projection at right angles to a picture plane that is parallel to no axis, or to one at most, so
// that x, y and z all show. It is given by the direction towards the viewer, which follows from two angles or from how
// much the three axes are shortened; the picture itself is an orthographic one.
//
//            y |                isometric   1 : 1 : 1         x and z at 30 and 30 degrees to the level
//              |                dimetric    1 : 1 : 1/2       x at 7.18, z at 41.41 degrees
//          z _/ \_ x            trimetric   0.9 : 1 : 0.5     x at 5.18, z at 17.81 degrees
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/length.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/view/look_at.hpp>

namespace irg {

/// How many of the three axes are shortened alike.
enum class axonometry_kind {
  isometric,  // all three
  dimetric,  // two
  trimetric,  // none
  impossible  // no direction shows the axes in these proportions
};

/// The unit vector towards the viewer from whom the axes have the proportions asked for.
template <Floating T>
struct axonometry {
  vec<T, 3> to_viewer{T(0), T(0), T(1)};
  axonometry_kind kind = axonometry_kind::impossible;
  bool operator==(const axonometry&) const = default;
};

inline namespace IRG_ABI {

/// The direction towards the viewer after `turn` about the y axis, from z towards x, and `tilt` above the level.
/// units   radians
/// gives   a unit vector; for angles that are NaN or infinite, NaN
template <Floating T>
[[nodiscard]] constexpr vec<T, 3> axonometric_direction(T turn, std::type_identity_t<T> tilt) noexcept {
  const T level = cos(tilt);
  return {product(sin(turn), level), sin(tilt), product(cos(turn), level)};
}

/// The axonometry that draws lengths along x, y and z in given proportions, seen from x, y, z >= 0.
/// gives   impossible, with the direction 0, 0, 1, unless the numbers are finite and none is negative, and the square
///         of none is larger than the sum of the squares of the other two
/// exact   which are impossible; coordinates within 1 ulp, for all finite floats and doubles
/// source  irg's own: a direction (a, b, c) of length 1 shortens x by sqrt(1 - a^2), so that the squares of the three
///         factors add up to 2
template <Floating T>
[[nodiscard]] constexpr axonometry<T> axonometry_by_ratios(T x, std::type_identity_t<T> y,
                                                           std::type_identity_t<T> z) noexcept {
  const auto usable = [](T r) { return T(0) <= r && r <= (std::numeric_limits<T>::max)(); };
  if (!usable(x) || !usable(y) || !usable(z)) return {};
  const auto squares = quotients_of<2>(
      [](const auto& p, const auto& q, const auto& r) {
        const auto pp = p * p, qq = q * q, rr = r * r;
        return std::array{pp + qq + rr, qq + rr - pp, pp + rr - qq, pp + qq - rr};
      },
      x, y, z);
  if (!squares) return {};
  const auto& [a, b, c] = *squares;
  if (a < T(0) || b < T(0) || c < T(0)) return {};
  // Of an axis that is hardly seen the square would be rounded to 0, or among subnormal numbers.
  constexpr bool single = std::is_same_v<T, float>;
  constexpr T up = single ? T(0x1p120f) : T(0x1p1000), tiny = 64 * (std::numeric_limits<T>::min)();
  vec<T, 3> d{sqrt(a), sqrt(b), sqrt(c)};
  if (a < tiny || b < tiny || c < tiny) {
    const auto scaled = quotients_of<4>(
        [](const auto& p, const auto& q, const auto& r, const auto& f) {
          const auto pp = p * p, qq = q * q, rr = r * r, ff = f * f;
          return std::array{pp + qq + rr, (qq + rr - pp) * ff, (pp + rr - qq) * ff, (pp + qq - rr) * ff};
        },
        x, y, z, up);
    for (int i = 0; i < 3; ++i)
      if (squares->at(static_cast<std::size_t>(i)) < tiny) d[i] = sqrt(scaled->at(static_cast<std::size_t>(i))) / up;
  }
  const int alike = (x == y ? 1 : 0) + (y == z ? 1 : 0) + (x == z ? 1 : 0);
  return {d, alike == 3   ? axonometry_kind::isometric
             : alike == 1 ? axonometry_kind::dimetric
                          : axonometry_kind::trimetric};
}

/// The axonometries of technical drawing: isometric and dimetric as in ISO 5456-3; the trimetric one, for which there
/// is no standard, in the proportions of handbooks, 0.9 : 1 : 0.5.
template <Floating T>
[[nodiscard]] constexpr axonometry<T> isometric() noexcept {
  return axonometry_by_ratios(T(1), T(1), T(1));
}
template <Floating T>
[[nodiscard]] constexpr axonometry<T> dimetric() noexcept {
  return axonometry_by_ratios(T(1), T(1), T(0.5));
}
template <Floating T>
[[nodiscard]] constexpr axonometry<T> trimetric() noexcept {
  return axonometry_by_ratios(T(0.9), T(1), T(0.5));
}

/// How long a unit along x, y and z is drawn from a direction: 0 to 1 each, squares adding up to 2. Drawings at full
/// scale divide by the largest.
/// gives   zeros for a direction that is zero, NaN or infinite
/// exact   within 4u
template <Floating T>
[[nodiscard]] constexpr vec<T, 3> foreshortening(const vec<T, 3>& to_viewer) noexcept {
  const auto d = try_normalized(to_viewer);
  if (!d) return {};
  const auto beside = [](T a, T b) { return length(vec<T, 2>{a, b}); };
  return {beside(d->y, d->z), beside(d->x, d->z), beside(d->x, d->y)};
}

/// The rotation from the world to right-handed camera space for a parallel projection from a direction; the y axis is
/// drawn upright. Its columns are the pictures of the axes.
/// gives   a rotation always: seen along y as look_at has it, and without a turn for a direction that is no direction
/// exact   as look_at
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> axonometric_view(const vec<T, 3>& to_viewer) noexcept {
  const point<T, 3> origin{};
  auto m = look_at(to_point(normalized(to_viewer)), origin, vec<T, 3>{T(0), T(1), T(0)});
  for (int r = 0; r < 3; ++r) m(r, 3) = T(0);
  return m;
}

/// A direction that is meant for a world with y up, in a world with another axis up: (right, up, front) becomes
/// right * x + up * y + front * z. Front is the part of the world's z at right angles to `up`, or of -y where z is the
/// axis nearest to it, so that in a world with z up x still runs to the right.
/// gives   the direction itself for an `up` that is zero, NaN or infinite
template <Floating T>
[[nodiscard]] constexpr vec<T, 3> with_axis_up(const vec<T, 3>& direction, const vec<T, 3>& up) noexcept {
  const auto y = try_normalized(up);
  if (!y) return direction;
  const bool z_up = magnitude(y->x) < magnitude(y->z) && magnitude(y->y) < magnitude(y->z);
  const vec<T, 3> front = z_up ? vec<T, 3>{T(0), T(-1), T(0)} : vec<T, 3>{T(0), T(0), T(1)};
  const vec<T, 3> x = normalized(cross(*y, front)), z = cross(x, *y);
  return x * direction.x + *y * direction.y + z * direction.z;
}

}  // namespace IRG_ABI
}  // namespace irg
