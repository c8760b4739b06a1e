// SPDX-License-Identifier: MIT
// Transformations by name and numbers, as one adds them to a list, takes them out and exchanges them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include <irg/core/is_finite.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/plane_projection.hpp>

namespace irg {

/// What a transformation does.
enum class studio_map {
  translate,  // x y z
  scale,  // x y z, factors
  rotate_x,  // degrees, about the x axis, counter-clockwise as seen from its tip
  rotate_y,
  rotate_z,
  rotate,  // x y z of an axis through the origin, degrees
  shear,  // xy xz yx yz zx zy: x grows by xy times y and xz times z, and so on
  mirror,  // a b c d of a plane
  parallel,  // a b c d of a plane, x y z of a direction: onto the plane along the direction
  central,  // a b c d of a plane, x y z of an eye: onto the plane from the eye
  matrix  // 16 numbers by rows, for columns
};

/// How a transformation is written: its name and how many numbers it takes.
struct studio_map_form {
  std::string_view name;
  std::size_t numbers = 0;
};

/// The forms, in the order of studio_map.
inline constexpr std::array<studio_map_form, 11> studio_maps{{{"translate", 3},
                                                              {"scale", 3},
                                                              {"rotate-x", 1},
                                                              {"rotate-y", 1},
                                                              {"rotate-z", 1},
                                                              {"rotate", 4},
                                                              {"shear", 6},
                                                              {"mirror", 4},
                                                              {"parallel", 7},
                                                              {"central", 7},
                                                              {"matrix", 16}}};

/// A transformation by its name and as many numbers as it takes; the others are 0.
template <Floating T>
struct studio_transformation {
  studio_map kind = studio_map::translate;
  std::array<T, 16> numbers{};
  constexpr bool operator==(const studio_transformation&) const = default;
};

inline namespace IRG_ABI {

/// The matrix of a transformation, for columns.
/// units   degrees
/// gives   nothing where there is none: a number is NaN or infinite, a plane has no normal, a direction runs along its
///         plane, an eye lies in it, an entry would overflow. An axis without length turns nothing
/// exact   as the functions of `view` that it comes from
template <Floating T>
[[nodiscard]] constexpr std::optional<mat<T, 4, 4>> matrix_of(const studio_transformation<T>& t) noexcept;

/// The matrix of a list: the first transformation comes first.
/// gives   those without a matrix change nothing
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> matrix_of(std::span<const studio_transformation<T>> list) noexcept;

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

// The mirror image is as far beyond the plane as what it is of: twice the way to the foot of the perpendicular.
template <class T>
constexpr checked<mat<T, 4, 4>, plane_projection_status> mirror_checked(const plane<T>& p) noexcept {
  auto foot = parallel_projection_onto_checked(p, vec<T, 3>{p.a, p.b, p.c});
  const auto unit = identity_matrix<T, 4>();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) foot.value(r, c) = T(2) * foot.value(r, c) - unit(r, c);
  return foot;
}

template <class T>
constexpr mat<T, 4, 4> studio_matrix(const studio_transformation<T>& t) noexcept {
  const auto& n = t.numbers;
  const vec<T, 3> first{n[0], n[1], n[2]}, last{n[4], n[5], n[6]};
  const plane<T> onto{n[0], n[1], n[2], n[3]};
  const auto or_none = [](const auto& m) {
    return m.ok() ? m.value : generate_mat<T, 4, 4>([](int, int) { return std::numeric_limits<T>::quiet_NaN(); });
  };
  switch (t.kind) {
    case studio_map::translate: return translation(first);
    case studio_map::scale: return irg::scaling(first);  // detail has a scaling of its own
    case studio_map::rotate_x: return rotation_x(radians(n[0]));
    case studio_map::rotate_y: return rotation_y(radians(n[0]));
    case studio_map::rotate_z: return rotation_z(radians(n[0]));
    case studio_map::rotate: return rotation(first, radians(n[3]));
    case studio_map::shear: return {{{1, n[0], n[1], 0}, {n[2], 1, n[3], 0}, {n[4], n[5], 1, 0}, {0, 0, 0, 1}}};
    case studio_map::mirror: return or_none(mirror_checked(onto));
    case studio_map::parallel: return or_none(parallel_projection_onto_checked(onto, last));
    case studio_map::central: return or_none(central_projection_onto_checked(onto, to_point(last)));
    case studio_map::matrix: break;
  }
  return generate_mat<T, 4, 4>([&](int r, int c) { return n[static_cast<std::size_t>(4 * r + c)]; });
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr std::optional<mat<T, 4, 4>> matrix_of(const studio_transformation<T>& t) noexcept {
  for (const T& n : t.numbers)
    if (!is_finite(n)) return std::nullopt;
  const mat<T, 4, 4> m = detail::studio_matrix(t);
  for (const auto& row : m.m)
    for (const T& entry : row)
      if (!is_finite(entry)) return std::nullopt;
  return m;
}

template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> matrix_of(std::span<const studio_transformation<T>> list) noexcept {
  auto m = identity_matrix<T, 4>();
  for (const auto& t : list)
    if (const auto next = matrix_of(t)) m = *next * m;
  return m;
}

}  // namespace IRG_ABI
}  // namespace irg
