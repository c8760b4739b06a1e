// SPDX-License-Identifier: MIT
// The common line of two parametric planes by holding one parameter. intersect_planes (geometry/intersect_planes.hpp)
// is the one to use.
#pragma once

#include <irg/geometry/intersect_planes.hpp>

namespace irg::textbook {

/// Two points of the line that two parametric planes have in common, and the parameter of the second plane that was
/// held at 0 and at 1 to find them.
/// shape   points and parameter have a meaning only where the planes cross
template <Scalar T>
struct planes_meeting {
  flat_relation relation = flat_relation::none;
  point<T, 3> at_zero{}, at_one{};
  enum class parameter { s3, s4 } held = parameter::s4;
  bool operator==(const planes_meeting&) const = default;
};

/// Which parameter of the second plane is held first: the program's order or the text's.
enum class held_parameter { s4_then_s3, s3_then_s4 };

inline namespace IRG_ABI {

/// Hank's construction of the common line of two parametric planes: one parameter of the second plane is held at
/// 0 and at 1, which gives two lines of that plane; where they cross the first plane are two points of the common line.
/// When those lines are parallel to the first plane, the other parameter is held.
/// exact   the relation; each coordinate within 0.501 ulp, for the directions as
///         they are
/// source  Hank n.d., 1.3.6: the program holds s4 first, the text s3
template <Real T>
[[nodiscard]] constexpr planes_meeting<T> intersect_planes(const parametric_plane<T>& first,
                                                           const parametric_plane<T>& second,
                                                           held_parameter order = held_parameter::s4_then_s3) noexcept {
  using result = planes_meeting<T>;
  const auto n1 = detail::directions_normal(first), n2 = detail::directions_normal(second);
  if (!n1 || !n2 || detail::is_zero(*n1) || detail::is_zero(*n2)) return {};
  for (int attempt = 0; attempt < 2; ++attempt) {
    const bool hold_s4 = (order == held_parameter::s4_then_s3) == (attempt == 0);
    const vec<T, 3>&along = hold_s4 ? second.first : second.second, &held = hold_s4 ? second.second : second.first;
    const auto v = values_of<4>(
        [](const auto& a, const auto& b, const auto& zero, const auto& base, const auto& u, const auto& step) {
          const auto n = cross(a, b), to_zero = zero - base;
          return std::tuple{detail::cross_plane(n, zero, u, dot(n, to_zero)),
                            detail::cross_plane(n, zero + step, u, dot(n, to_zero + step))};
        },
        first.first, first.second, second.origin, first.origin, along, held);
    if (!v) return {};
    const auto& [divisor, height, at_zero] = std::get<0>(*v);
    if (!detail::is_zero(divisor))
      return {flat_relation::crossing, rounded_coordinates<point<T, 3>>(at_zero / divisor),
              rounded_coordinates<point<T, 3>>(std::get<2>(std::get<1>(*v)) / divisor),
              hold_s4 ? result::parameter::s4 : result::parameter::s3};
    if (attempt == 1)
      return {detail::is_zero(height) ? flat_relation::coincident : flat_relation::parallel, {}, {}, {}};
  }
  return {};
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
