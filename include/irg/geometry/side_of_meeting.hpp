// SPDX-License-Identifier: MIT
// On which side of a plane the point lies in which three others meet, decided exactly and without computing the point.
#pragma once

#include <array>
#include <optional>
#include <type_traits>

#include <irg/core/vocabulary.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A plane through three points, in front where they are seen counter-clockwise.
template <Number T>
struct plane_points {
  point<T, 3> a{}, b{}, c{};
  bool operator==(const plane_points&) const = default;
};

inline namespace IRG_ABI {

/// The plane's points as polynomials of sign_of take them.
template <class N, class T, class F>
[[nodiscard]] IRG_INLINE constexpr auto in_numbers(const plane_points<T>& p, const F& number) noexcept {
  using input = std::remove_cvref_t<decltype(number(p.a.x))>;
  return plane_points<input>{in_numbers<N>(p.a, number), in_numbers<N>(p.b, number), in_numbers<N>(p.c, number)};
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// On which side of `of` the point lies in which three planes meet: above in front of it, below behind.
/// needs   finite coordinates
/// gives   nothing when the three do not meet in one point, `on` when the points of `of` lie on a line
/// exact   for every finite float and double, of any magnitudes
/// cost    some 0.3 us; where the point is nearly on the plane, a polynomial of degree 9 in exact numbers
template <Floating T>
[[nodiscard]] IRG_API std::optional<side> side_of_meeting(const plane_points<T>& first, const plane_points<T>& second,
                                                          const plane_points<T>& third,
                                                          const plane_points<T>& of) noexcept;

}  // namespace IRG_COMPILED_ABI

}  // namespace irg

#if IRG_BODIES
namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API std::optional<side> side_of_meeting(const plane_points<T>& first, const plane_points<T>& second,
                                                          const plane_points<T>& third,
                                                          const plane_points<T>& of) noexcept {
  // In shares of the corners of the first plane, which sum up to 1, every other plane is a linear equation whose
  // coefficients are the corners' distances from it; so the point is the cross product of two of these.
  const auto [apart, beside] = sign_of<9>(
      [](const auto& corners, const auto& p, const auto& q, const auto& r) {
        const auto distances = [&](const auto& plane) {
          const auto n = cross(plane.b - plane.a, plane.c - plane.a);
          return vec{dot(n, corners.a - plane.a), dot(n, corners.b - plane.a), dot(n, corners.c - plane.a)};
        };
        const auto shares = cross(distances(p), distances(q));
        return std::array{shares.x + shares.y + shares.z, dot(distances(r), shares)};
      },
      first, second, third, of);
  return apart == 0 ? std::nullopt : std::optional(static_cast<side>(apart * beside));
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
