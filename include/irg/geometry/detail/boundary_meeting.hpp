// SPDX-License-Identifier: MIT
// Where boundaries of regions meet lines and planes through given points: about, with a bound of the error; on which
// side of another boundary, exactly; and correctly rounded.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <irg/geometry/detail/half_space.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// A boundary and two points: from the first point on, where their line meets it: the divisor, and the way times it.
template <int D>
struct line_meeting {
  static constexpr std::size_t first = 4, d = static_cast<std::size_t>(D);
  template <class M, std::size_t Size>
  constexpr auto operator()(const std::array<M, Size>& x) const noexcept {
    using N = decltype(x[0] * x[0]);
    const auto from = part_of<d>(x, first), to = part_of<d>(x, first + d);
    const N at_from = half_space_value<D>(part_of<4>(x, 0), from), at_to = half_space_value<D>(part_of<4>(x, 0), to);
    return joined(std::array<N, 1>{at_from - at_to}, multiple_of(difference_of(to, from), at_from));
  }
};
// Two planes and three points: the same for the point that they and the plane through the points share.
struct plane_meeting {
  static constexpr std::size_t first = 8;
  template <class M, std::size_t Size>
  constexpr auto operator()(const std::array<M, Size>& x) const noexcept {
    using N = decltype(x[0] * x[0]);
    const auto normal = [&](std::size_t i) { return std::array<N, 3>{x[i], x[i + 1], x[i + 2]}; };
    const auto from = part_of<3>(x, first);
    const auto a = normal(0), b = normal(4);
    const auto n = cross_of(difference_of(part_of<3>(x, 11), from), difference_of(part_of<3>(x, 14), from));
    const N a_from = half_space_value<3>(part_of<4>(x, 0), from), b_from = half_space_value<3>(part_of<4>(x, 4), from);
    return joined(std::array<N, 1>{dot_of(n, cross_of(a, b))},
                  sum_of(multiple_of(cross_of(n, b), a_from), multiple_of(cross_of(a, n), b_from)));
  }
};

// Where these numbers meet, about.
template <class Meeting, class Corner, Floating T, std::size_t Size>
constexpr void place_about(Corner& c, const Meeting& meeting, const std::array<T, Size>& in) noexcept {
  std::array<filtered_input, Size> x{};
  bool suits = true;
  for (std::size_t i = 0; i < Size; ++i) {
    suits = suits && suits_twofold(widened(in[i]));
    x[i].value = widened(in[i]);
  }
  c.error = infinity<double>;
  if (!suits) return;
  const auto way = meeting(x);
  constexpr double relative = 0x1p-48;  // of at most 16 roundings
  const double divisor = magnitude(way[0].value), off = product(relative, way[0].size);
  if (!(off + off < divisor)) return;
  double error = 0;
  for (std::size_t i = 0; i < c.about.size(); ++i) {
    const double from = x[Meeting::first + i].value, part = way[i + 1].value / way[0].value;
    c.about[i] = from + part;
    const double way_off = (product(relative, way[i + 1].size) + product(magnitude(part), off)) / divisor;
    error = greater(error, product(3.0, way_off) + product(0x1p-52, magnitude(from) + magnitude(part)));
  }
  c.error = error;
}
// On which side of a boundary a corner is for all that is known about its place; 0 where that does not tell.
template <class Corner, Floating T, int D>
constexpr int side_about(const Corner& c, const half_space<T, D>& boundary) noexcept {
  std::array<double, 4> h{};
  bool suits = c.error < infinity<double>;
  for (std::size_t i = 0; i < 4; ++i) {
    suits = suits && suits_twofold(widened(boundary.numbers[i]));
    h[i] = widened(boundary.numbers[i]);
  }
  if (!suits) return 0;
  double value = 0, size = 0, reach = 0;
  const auto add = [&](double factor, double x, double from) {
    value += product(factor, x - from);
    size += product(magnitude(factor), magnitude(x) + magnitude(from));
    reach += magnitude(factor);
  };
  if constexpr (D == 2) {
    add(h[2] - h[0], c.about[1], h[1]), add(h[1] - h[3], c.about[0], h[0]);
  } else {
    for (std::size_t i = 0; i < 3; ++i) add(h[i], c.about[i], 0);
    value += h[3], size += magnitude(h[3]);
  }
  const double bound = product(size, 0x1p-50) + product(reach, 1.5 * c.error);
  return value > bound ? 1 : -value > bound ? -1 : 0;
}
// The same exactly: the sign of the boundary's value where these numbers meet.
template <int Degree, int D, class Meeting, Floating T, std::size_t Size>
constexpr int exact_side(const Meeting& meeting, const std::array<T, Size>& in,
                         const half_space<T, D>& boundary) noexcept {
  const auto value = [&](const auto& x) {
    constexpr std::size_t d = static_cast<std::size_t>(D);
    const auto h = part_of<4>(x, Size);
    const auto way = meeting(x);
    const auto at_first = way[0] * half_space_value<D>(h, part_of<d>(x, Meeting::first));
    if constexpr (D == 2)
      return std::array{way[0], at_first + (h[2] - h[0]) * way[2] - (h[3] - h[1]) * way[1]};
    else
      return std::array{way[0], at_first + dot_of(part_of<3>(h, 0), part_of<3>(way, 1))};
  };
  const auto v = evaluate<Degree>(value, joined(in, boundary.numbers));
  return v ? known_sign((*v)[0]) * known_sign((*v)[1]) : 0;
}
// The same place, rounded.
template <int Degree, Point P, class Meeting, class T, std::size_t Size>
constexpr std::optional<P> rounded_place(const Meeting& meeting, const std::array<T, Size>& in) noexcept {
  const auto from_origin = [&](const auto& x) {
    constexpr std::size_t d = static_cast<std::size_t>(size_of<P>);
    const auto way = meeting(x);
    return joined(part_of<1>(way, 0), sum_of(part_of<d>(way, 1), multiple_of(part_of<d>(x, Meeting::first), way[0])));
  };
  const auto found = nearest_quotients<Degree>(from_origin, in);
  if (!found) return std::nullopt;
  return generate_coordinates<P>([&](int i) { return (*found)[static_cast<std::size_t>(i)]; });
}

}  // namespace IRG_ABI
}  // namespace irg::detail
