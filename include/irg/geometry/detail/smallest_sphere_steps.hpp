// SPDX-License-Identifier: MIT
// The steps of smallest_sphere.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/core/ring.hpp>
#include <irg/geometry/sphere.hpp>
#include <irg/math/vec.hpp>

namespace irg {
namespace detail {

// The points that a ball rests on, by their numbers.
template <std::size_t D>
struct ball_support {
  std::array<std::size_t, D + 1> at{};
  std::size_t count = 0;
};

inline namespace IRG_ABI {

// Whether p is outside of the smallest sphere through the points `on`.
template <Point P, std::same_as<P>... More>
constexpr bool is_outside(const P& p, const P& on, const More&... more) noexcept {
  const auto [gap, turn] = sign_of<6>(
      [](const auto& x, const auto& from, const auto&... to) {
        const auto c = centre_of_sphere((to - from)...);
        const auto way = x - from;
        return std::array{dot(way, way) * c.divisor - dot(way, c.offset), c.divisor};
      },
      p, on, more...);
  return gap * turn > 0;  // the divisor of a ball on D + 1 points may be negative
}

// The smallest ball around D + 2 points at most.
template <Point P>
class smallest_ball {
public:
  static constexpr std::size_t D = static_cast<std::size_t>(size_of<P>);
  using T = scalar_of<P>;
  using ball = bounding_sphere<T, size_of<P>>;
  using support = ball_support<D>;

  constexpr explicit smallest_ball(const P& p) noexcept { points_[size_++] = p; }

  // Takes p, which is outside of the ball, in; those points that the new ball does not rest on are forgotten.
  constexpr void grow(const P& p) noexcept {
    points_[size_++] = p;
    const support s = around(size_, {});
    std::array<P, D + 2> kept{};
    for (std::size_t k = 0; k < s.count; ++k) kept[k] = points_[s.at[k]];
    points_ = kept;
    size_ = s.count;
  }
  constexpr bool is_outside(const P& p) const noexcept {
    support all;
    for (; all.count < size_; ++all.count) all.at[all.count] = all.count;
    return is_outside_of(all, p);
  }
  constexpr ball rounded() const noexcept {
    if (size_ == 2) return *sphere_through(points_[0], points_[1]);
    if (size_ == 3) return *sphere_through(points_[0], points_[1], points_[2]);
    if constexpr (D == 3)
      if (size_ == 4) return *sphere_through(points_[0], points_[1], points_[2], points_[3]);
    return {generate_coordinates<point<T, size_of<P>>>([&](int i) { return coordinate(points_[0], i); }), T(0)};
  }

private:
  // The points that the smallest ball around the first `count` points rests on when it passes through `forced`.
  constexpr support around(std::size_t count, const support& forced) const noexcept {
    support s = forced;
    if (forced.count == D + 1) return s;
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_outside_of(s, points_[i])) continue;
      support more = forced;
      more.at[more.count++] = i;
      s = around(i, more);
    }
    return s;
  }
  constexpr bool is_outside_of(const support& s, const P& p) const noexcept {
    std::array<P, 4> on{};
    for (std::size_t k = 0; k < s.count; ++k) on[k] = points_[s.at[k]];
    if (s.count == 0) return true;
    if (s.count == 1) return !are_equal(on[0], p);
    if (s.count == 2) return detail::is_outside(p, on[0], on[1]);
    if constexpr (D == 3)
      if (s.count == 4) return detail::is_outside(p, on[0], on[1], on[2], on[3]);
    return detail::is_outside(p, on[0], on[1], on[2]);
  }

  std::array<P, D + 2> points_{};
  std::size_t size_ = 0;
};

// How far p is from the rounded ball's centre, squared, and whether it is outside (1) or inside (-1) by far more than
// what rounding can do to the ball and to this; 0 when that is not sure.
struct guessed_side {
  double squared = 0;
  int side = 0;
};
template <Floating T, int N, Point P>
constexpr guessed_side guess_side(const bounding_sphere<T, N>& ball, const P& p) noexcept {
  const double radius = widened(ball.radius);
  double squared = 0, reach = radius;
  for (int i = 0; i < N; ++i) {
    const double c = widened(ball.centre[i]), x = widened(coordinate(p, i));
    reach = greater(reach, greater(magnitude(c), magnitude(x)));
    if (!(reach < 0x1p400)) return {};
    squared = squared + product(x - c, x - c);
  }
  const double slack = reach * (sizeof(T) == 4 ? 0x1p-18 : 0x1p-44), inner = radius - slack, outer = radius + slack;
  if (!(slack > 0x1p-400)) return {squared, 0};
  if (squared > product(outer, outer)) return {squared, 1};
  return {squared, inner > 0 && squared < product(inner, inner) ? -1 : 0};
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
