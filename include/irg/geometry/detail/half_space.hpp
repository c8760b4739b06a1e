// SPDX-License-Identifier: MIT
// The boundaries of convex regions, lines through two points and planes, as four numbers each: on which side a point
// lies, where a segment crosses, and which crossing comes first, all decided exactly.
#pragma once

#include <array>
#include <cstddef>

#include <irg/core/contract.hpp>
#include <irg/core/ring.hpp>
#include <irg/geometry/detail/compiled_numbers.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>

namespace irg::detail {

// Two points of a line with the inside on its left, or the coefficients of a plane with the inside above it.
template <class T, int D>
struct half_space {
  std::array<T, 4> numbers{};
};

// Where the line from a to b meets the boundary, and its parameter: correctly rounded, and so between a and b where
// these lie on both sides, and at one place for b to a.
// needs   a line that is not parallel to the boundary
template <class T, Point P>
struct half_space_meeting {
  P at;
  T t;
};

inline namespace IRG_COMPILED_ABI {

template <Floating T, int D>
IRG_API half_space_meeting<T, point<T, D>> meeting_with_half_space(const point<T, D>& a, const point<T, D>& b,
                                                                   const half_space<T, D>& h) noexcept;
// The sign of t_first - t_second, but for the sign of their denominators.
template <Floating T, int D>
IRG_API int order_of_crossings(const point<T, D>& a, const point<T, D>& b, const half_space<T, D>& first,
                               const half_space<T, D>& second) noexcept;

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail

namespace irg::detail::inline IRG_ABI {

using irg::in_numbers;  // of numbers and points, beside which stands that of half-spaces

template <class N, class T, int D, class F>
IRG_INLINE constexpr auto in_numbers(const half_space<T, D>& h, const F& number) noexcept {
  return half_space<std::remove_cvref_t<decltype(number(h.numbers[0]))>, D>{
      {number(h.numbers[0]), number(h.numbers[1]), number(h.numbers[2]), number(h.numbers[3])}};
}

// Positive inside.
template <class N, class P>
constexpr auto half_space_value(const half_space<N, 2>& h, const P& p) noexcept {
  const auto& [ax, ay, bx, by] = h.numbers;
  return (bx - ax) * (p.y - ay) - (by - ay) * (p.x - ax);
}
template <class N, class P>
constexpr auto half_space_value(const half_space<N, 3>& h, const P& p) noexcept {
  const auto& [x, y, z, d] = h.numbers;
  return x * p.x + y * p.y + z * p.z + d;
}
// By how much the value grows along a way.
template <class N, class V>
constexpr auto half_space_growth(const half_space<N, 2>& h, const V& way) noexcept {
  const auto& [ax, ay, bx, by] = h.numbers;
  return (bx - ax) * way.y - (by - ay) * way.x;
}
template <class N, class V>
constexpr auto half_space_growth(const half_space<N, 3>& h, const V& way) noexcept {
  const auto& [x, y, z, d] = h.numbers;
  return x * way.x + y * way.y + z * way.z;
}

// 1 inside, 0 on the boundary, -1 outside.
template <class T, int D, Point P>
constexpr int half_space_side(const half_space<T, D>& h, const P& p) noexcept {
  if constexpr (D == 2) {
    using V = point<T, 2>;
    return orient2d(V{h.numbers[0], h.numbers[1]}, V{h.numbers[2], h.numbers[3]},
                    V{coordinate(p, 0), coordinate(p, 1)});
  } else {
    const auto& [x, y, z, d] = h.numbers;
    return static_cast<int>(side_of(plane<T>{x, y, z, d}, p));
  }
}

template <class T, int D, Point P>
constexpr int find_order_of_crossings(const P& a, const P& b, const half_space<T, D>& first,
                                      const half_space<T, D>& second) noexcept {
  return sign_of<4>(
      [](const auto& g, const auto& h, const auto& from, const auto& to) {
        return half_space_value(h, from) * half_space_value(g, to) -
               half_space_value(g, from) * half_space_value(h, to);
      },
      first, second, a, b);
}

// The sign of t_first - t_second, where the line from a to b crosses the boundaries. It crosses both: on each one side
// is the sign of the value at a, and not that at b.
template <class T, int D, Point P>
constexpr int compare_half_space_crossings(const P& a, const P& b, const half_space<T, D>& first,
                                           const half_space<T, D>& second, int sides) noexcept {
  if constexpr (Floating<T>)
    return sides * order_of_crossings(as_point<T>(a), as_point<T>(b), first, second);
  else
    return sides * find_order_of_crossings(a, b, first, second);
}

template <class T, int D, Point P>
constexpr half_space_meeting<T, P> find_half_space_meeting(const P& a, const P& b, const half_space<T, D>& h) noexcept {
  const auto found = quotients_of<3>(
      [](const auto& boundary, const auto& from, const auto& to) {
        const auto at_from = half_space_value(boundary, from), at_to = half_space_value(boundary, to);
        const auto at = to_vec(to) * at_from - to_vec(from) * at_to;
        if constexpr (D == 2)
          return std::array{at_from - at_to, at_from, at.x, at.y};
        else
          return std::array{at_from - at_to, at_from, at.x, at.y, at.z};
      },
      h, a, b);
  IRG_EXPECTS(found.has_value());
  return {generate_coordinates<P>([&](int i) { return (*found)[1 + static_cast<std::size_t>(i)]; }), (*found)[0]};
}

template <class T, int D, Point P>
constexpr half_space_meeting<T, P> meet_half_space(const P& a, const P& b, const half_space<T, D>& h) noexcept {
  if constexpr (Floating<T>) {
    const auto m = meeting_with_half_space(as_point<T>(a), as_point<T>(b), h);
    return {own_point<P>(m.at), m.t};
  } else {
    return find_half_space_meeting(a, b, h);
  }
}

// The boundaries of a convex polygon, counter-clockwise or clockwise, one by one; none when it has no area.
template <PolygonRing R>
constexpr int turn_of_convex(const R& ring) noexcept {
  const std::size_t n = ring_size(ring);
  for (std::size_t i = 2; i < n; ++i)
    for (std::size_t k = 1; k < i; ++k)
      if (const int turn = orient2d(ring_vertex(ring, 0), ring_vertex(ring, k), ring_vertex(ring, i)); turn != 0)
        return turn;
  return 0;
}
template <PolygonRing R>
constexpr half_space<ring_scalar<R>, 2> half_space_at(const R& ring, std::size_t i, int turn) noexcept {
  const auto p = ring_vertex(ring, turn > 0 ? i : i + 1), q = ring_vertex(ring, turn > 0 ? i + 1 : i);
  return {{coordinate(p, 0), coordinate(p, 1), coordinate(q, 0), coordinate(q, 1)}};
}

}  // namespace irg::detail::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int D>
IRG_API half_space_meeting<T, point<T, D>> meeting_with_half_space(const point<T, D>& a, const point<T, D>& b,
                                                                   const half_space<T, D>& h) noexcept {
  return find_half_space_meeting(a, b, h);
}
template <Floating T, int D>
IRG_API int order_of_crossings(const point<T, D>& a, const point<T, D>& b, const half_space<T, D>& first,
                               const half_space<T, D>& second) noexcept {
  return find_order_of_crossings(a, b, first, second);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
