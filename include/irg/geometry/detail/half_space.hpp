// SPDX-License-Identifier: MIT
// The boundaries of convex regions, lines through two points and planes, as four numbers each: on which side a point
// lies, where a segment crosses, and which crossing comes first, all decided exactly.
#pragma once

#include <array>
#include <cstddef>

#include <irg/core/contract.hpp>
#include <irg/core/ring.hpp>
#include <irg/geometry/detail/formula.hpp>
#include <irg/geometry/detail/nearest_quotient.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/plane.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// Two points of a line with the inside on its left, or the coefficients of a plane with the inside above it.
template <class T, int D>
struct half_space {
  std::array<T, 4> numbers{};
};

template <int D, class N, class M>
constexpr auto half_space_value(const std::array<N, 4>& h,
                                const std::array<M, static_cast<std::size_t>(D)>& v) noexcept {
  if constexpr (D == 2)
    return (h[2] - h[0]) * (v[1] - h[1]) - (h[3] - h[1]) * (v[0] - h[0]);
  else
    return h[0] * v[0] + h[1] * v[1] + h[2] * v[2] + h[3];
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

// The sign of t_first - t_second, where the line from a to b crosses the boundaries. It crosses both: on each one side
// is the sign of the value at a, and not that at b.
template <class T, int D, Point P>
constexpr int compare_half_space_crossings(const P& a, const P& b, const half_space<T, D>& first,
                                           const half_space<T, D>& second, int sides) noexcept {
  const auto value = evaluate<4>(
      [](const auto& x) {
        using N = std::remove_cvref_t<decltype(x[0])>;
        constexpr std::size_t d = static_cast<std::size_t>(D);
        const auto from = part_of<d>(x, 8), to = part_of<d>(x, 8 + d);
        const auto p = part_of<4>(x, 0), q = part_of<4>(x, 4);
        return std::array<N, 1>{half_space_value<D>(q, from) * half_space_value<D>(p, to) -
                                half_space_value<D>(p, from) * half_space_value<D>(q, to)};
      },
      joined(joined(first.numbers, second.numbers), gathered<T>(a, b)));
  return value ? sides * known_sign((*value)[0]) : 0;
}

// Where the line from a to b meets the boundary, and its parameter: correctly rounded, and so between a and b where
// these lie on both sides, and at one place for b to a.
// needs   a line that is not parallel to the boundary
template <class T, Point P>
struct half_space_meeting {
  P at{};
  T t{};
};
template <class T, int D, Point P>
constexpr half_space_meeting<T, P> meet_half_space(const P& a, const P& b, const half_space<T, D>& h) noexcept {
  const auto found = nearest_quotients<3>(
      [](const auto& x) {
        constexpr std::size_t d = static_cast<std::size_t>(D);
        using N = std::remove_cvref_t<decltype(x[0])>;
        const auto from = part_of<d>(x, 4), to = part_of<d>(x, 4 + d);
        const N at_from = half_space_value<D>(part_of<4>(x, 0), from),
                at_to = half_space_value<D>(part_of<4>(x, 0), to);
        return joined(std::array<N, 2>{at_from - at_to, at_from},
                      difference_of(multiple_of(to, at_from), multiple_of(from, at_to)));
      },
      joined(h.numbers, gathered<T>(a, b)));
  IRG_EXPECTS(found.has_value());
  return {generate_coordinates<P>([&](int i) { return (*found)[1 + static_cast<std::size_t>(i)]; }), (*found)[0]};
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
constexpr half_space<scalar_of<ring_point<R>>, 2> half_space_at(const R& ring, std::size_t i, int turn) noexcept {
  const auto p = ring_vertex(ring, turn > 0 ? i : i + 1), q = ring_vertex(ring, turn > 0 ? i + 1 : i);
  return {{coordinate(p, 0), coordinate(p, 1), coordinate(q, 0), coordinate(q, 1)}};
}

}  // namespace IRG_ABI
}  // namespace irg::detail
