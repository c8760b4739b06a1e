// SPDX-License-Identifier: MIT
// The steps of sphere.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/exact/values_of.hpp>

namespace irg::detail::inline IRG_ABI {

// The smallest sphere through a and up to three points at u, v, w from it: its centre is at `offset / (2 divisor)` from
// a.
template <class N, int D>
struct sphere_centre {
  N divisor{};
  vec<N, D> offset{};
};

template <class N, int D>
constexpr sphere_centre<N, D> centre_of_sphere(const vec<N, D>& u) noexcept {
  return {dot(u, u), u * dot(u, u)};
}
template <class N>
constexpr sphere_centre<N, 2> centre_of_sphere(const vec<N, 2>& u, const vec<N, 2>& v) noexcept {
  const N uu = dot(u, u), vv = dot(v, v);
  return {cross(u, v), {uu * v.y - vv * u.y, vv * u.x - uu * v.x}};
}
template <class N>
constexpr sphere_centre<N, 3> centre_of_sphere(const vec<N, 3>& u, const vec<N, 3>& v) noexcept {
  const auto n = cross(u, v);
  return {dot(n, n), cross(v, n) * dot(u, u) + cross(n, u) * dot(v, v)};
}
template <class N>
constexpr sphere_centre<N, 3> centre_of_sphere(const vec<N, 3>& u, const vec<N, 3>& v, const vec<N, 3>& w) noexcept {
  const auto vw = cross(v, w);
  return {dot(u, vw), vw * dot(u, u) + cross(w, u) * dot(v, v) + cross(u, v) * dot(w, w)};
}

template <Point P, class... More>
constexpr auto sphere_of(const P& a, const More&... more) noexcept {
  using T = scalar_of<P>;
  using ball = bounding_sphere<T, size_of<P>>;
  const auto values = values_of<5>(
      [](const auto& from, const auto&... to) {
        const auto c = centre_of_sphere((to - from)...);
        const auto twice = c.divisor + c.divisor;
        return std::tuple{twice, c.offset, to_vec(from) * twice + c.offset};
      },
      a, more...);
  if (!values || is_zero(std::get<0>(*values))) return std::optional<ball>();
  const auto& [divisor, offset, at] = *values;
  known_number squared = offset[0] * offset[0];
  for (int i = 1; i < size_of<P>; ++i) squared = squared + offset[i] * offset[i];
  const T radius = magnitude(rounded_to<T>(sqrt(squared) / divisor));
  return std::optional(ball{rounded_coordinates<point<T, size_of<P>>>(at / divisor), radius});
}

// Whether p lies within this distance of centre, which is the sum of the radii.
template <Floating T, int N, class... R>
constexpr bool lies_within(const point<T, N>& centre, const point<T, N>& p, box_boundary boundary,
                           const R&... radius) noexcept {
  if (!(is_finite(centre) && is_finite(p) && (is_finite(radius) && ...))) return false;
  const int gap = sign_of<2>(
      [](const auto& from, const auto& to, const auto&... r) {
        const auto d = to - from;
        const auto reach = (r + ...);
        return dot(d, d) - reach * reach;
      },
      centre, p, radius...);
  return gap < 0 || (gap == 0 && boundary == box_boundary::closed);
}

}  // namespace irg::detail::inline IRG_ABI
