// SPDX-License-Identifier: MIT
// camera_frame<T>: a camera as its position and three axes, and the matrices that follow from it, M = R * T: first the
// position goes to the origin, then the axes to the coordinate axes. The frame's own axes say right, up and forward,
// whatever the handedness of the camera space; that is chosen with the matrix.
#pragma once

#include <limits>

#include <irg/core/vocabulary.hpp>
#include <irg/math/coordinate_system.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/view/look_at.hpp>

namespace irg {

/// Where a camera stands and how it is turned.
/// shape   axes of length 1, at right angles to each other, right x up = -forward in the right-handed world;
///         orthonormalized repairs what is not so
template <Floating T>
struct camera_frame {
  point<T, 3> position{};
  vec<T, 3> right{T(1), T(0), T(0)}, up{T(0), T(1), T(0)}, forward{T(0), T(0), T(-1)};
  bool operator==(const camera_frame&) const = default;
};

/// What orthonormalized made of a frame.
enum class [[nodiscard]] camera_frame_status {
  ok,
  up_replaced,  // up was zero, NaN, infinite or parallel to forward: right, or else an axis of the world stands in
  forward_replaced,  // forward was zero, NaN or infinite: the direction behind right and up, or else -z, stands in
  ordinary [[deprecated("irg: ordinary is now ok")]] = ok
};

inline namespace IRG_ABI {

/// Frame from what look_at takes: the camera at `eye` that looks at `target`. view_matrix of it equals look_at.
/// gives   look_at's fallbacks; the default frame where look_at gives the identity
/// exact   axes as look_at's: of length 1 and at right angles within 8u
template <Floating T>
constexpr camera_frame<T> look_at_frame(const point<T, 3>& eye, const point<T, 3>& target,
                                        const vec<T, 3>& up) noexcept {
  const auto v = look_at_checked(eye, target, up);
  if (v.status == look_at_status::not_finite) return {};
  const auto row = [&](int r) { return vec<T, 3>{v.value(r, 0), v.value(r, 1), v.value(r, 2)}; };
  return {eye, row(0), row(1), -row(2)};
}

/// R: turns the frame's axes into the coordinate axes. Its rows are right, up, and -forward or, left-handed, forward.
template <class T>
[[nodiscard]] constexpr mat<T, 4, 4> view_rotation(const camera_frame<T>& f,
                                                   handedness sense = handedness::right) noexcept {
  const vec<T, 3>&x = f.right, &y = f.up, z = sense == handedness::right ? -f.forward : f.forward;
  return {{{x.x, x.y, x.z, 0}, {y.x, y.y, y.z, 0}, {z.x, z.y, z.z, 0}, {0, 0, 0, 1}}};
}

/// T: moves the frame's position into the origin.
template <class T>
[[nodiscard]] constexpr mat<T, 4, 4> view_translation(const camera_frame<T>& f) noexcept {
  auto m = identity_matrix<T, 4>();
  for (int i = 0; i < 3; ++i) m(i, 3) = T(0) - f.position[i];
  return m;
}

/// M = R * T: from world space into the frame's camera space.
/// needs   a position of at most a quarter of the largest number
/// exact   equal to look_at for the same camera; for a general frame the product's own roundings only
/// source  Hank n.d., 4.1.4
template <class T>
[[nodiscard]] constexpr mat<T, 4, 4> view_matrix(const camera_frame<T>& f,
                                                 handedness sense = handedness::right) noexcept {
  return view_rotation(f, sense) * view_translation(f);
}

/// From the frame's camera space into world space: the inverse of view_matrix.
/// exact   the entries are the frame's own numbers
template <class T>
[[nodiscard]] constexpr mat<T, 4, 4> camera_to_world(const camera_frame<T>& f,
                                                     handedness sense = handedness::right) noexcept {
  const vec<T, 3>&x = f.right, &y = f.up, z = sense == handedness::right ? -f.forward : f.forward;
  const point<T, 3>& p = f.position;
  return {{{x.x, y.x, z.x, p.x}, {x.y, y.y, z.y, p.y}, {x.z, y.z, z.z, p.z}, {0, 0, 0, 1}}};
}

/// The frame of a view matrix: the inverse of view_matrix.
/// needs   a rigid map, of the handedness given; its last row is not read
/// exact   the axes are the matrix's own numbers; the position is rounded as three products and two sums are
template <Floating T>
[[nodiscard]] constexpr camera_frame<T> frame_of_view(const mat<T, 4, 4>& m,
                                                      handedness sense = handedness::right) noexcept {
  const auto row = [&](int r) { return vec<T, 3>{m(r, 0), m(r, 1), m(r, 2)}; };
  camera_frame<T> f{{}, row(0), row(1), sense == handedness::right ? -row(2) : row(2)};
  const auto column = [&](int c) { return vec<T, 3>{m(0, c), m(1, c), m(2, c)}; };
  f.position = generate_coordinates<point<T, 3>>([&](int c) { return T(0) - dot(column(c), column(3)); });
  return f;
}

/// Right-handed camera coordinates from left-handed ones, and the other way: z turns round.
template <class T>
[[nodiscard]] IRG_INLINE constexpr point<T, 3> change_handedness(const point<T, 3>& p) noexcept {
  return {p.x, p.y, -p.z};
}
template <class T>
[[nodiscard]] IRG_INLINE constexpr vec<T, 3> change_handedness(const vec<T, 3>& v) noexcept {
  return {v.x, v.y, -v.z};
}

/// The view matrix of the same camera into a camera space of the other handedness: its third row turns round. The sense
/// of rotation changes with it: what was counter-clockwise about an axis is clockwise.
/// exact   no number is rounded; twice is the matrix itself
template <class T>
[[nodiscard]] constexpr mat<T, 4, 4> change_handedness(const mat<T, 4, 4>& view) noexcept {
  mat<T, 4, 4> m = view;
  for (T& entry : m.m[2]) entry = T(0) - entry;
  return m;
}

/// The frame with axes of length 1 and at right angles again, and what had to be given up for that. Forward keeps its
/// direction, up its part at right angles to it; right follows from these two, so that a mirrored frame is righted.
/// gives   for broken axes what camera_frame_status says; an orthonormal frame always. The position is not touched
/// exact   of length 1 and at right angles within 8u (u = 2^-53, float 2^-24)
template <Floating T>
[[nodiscard]] constexpr checked<camera_frame<T>, camera_frame_status> orthonormalized_checked(
    const camera_frame<T>& f) noexcept {
  constexpr T parallel = 4 * std::numeric_limits<T>::epsilon();
  const vec<T, 3> right = normalized(f.right), up = normalized(f.up);
  checked<camera_frame<T>, camera_frame_status> r{f, camera_frame_status::ok};
  vec<T, 3> z = -normalized(f.forward);
  if (z == vec<T, 3>{}) {
    r.status = camera_frame_status::forward_replaced;
    const vec<T, 3> behind = cross(right, up);
    z = detail::within(behind, parallel) ? vec<T, 3>{T(0), T(0), T(1)} : normalized(behind);
  }
  vec<T, 3> side = cross(up, z);
  if (detail::within(side, parallel)) {
    if (r.status == camera_frame_status::ok) r.status = camera_frame_status::up_replaced;
    const vec<T, 3> above = cross(z, right);
    side = cross(detail::within(above, parallel) ? detail::axis_least_aligned(z) : above, z);
  }
  // As in look_at: `side` may be tilted by rounding, but what follows from y and z is not.
  const vec<T, 3> y = normalized(cross(z, side));
  r.value.right = cross(y, z);
  r.value.up = y;
  r.value.forward = -z;
  return r;
}

/// The frame with axes of length 1 and at right angles again; see orthonormalized_checked.
template <Floating T>
[[nodiscard]] constexpr camera_frame<T> orthonormalized(const camera_frame<T>& f) noexcept {
  return orthonormalized_checked(f).value;
}

}  // namespace IRG_ABI
}  // namespace irg
