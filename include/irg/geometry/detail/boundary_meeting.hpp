// SPDX-License-Identifier: MIT
// Where boundaries of regions meet lines and planes through given points: about, with a bound of the error; on which
// side of another boundary, exactly; and correctly rounded.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>

#include <irg/geometry/detail/half_space.hpp>
#include <irg/math/exact/filtered_number.hpp>
#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>

namespace irg::detail::inline IRG_ABI {

// A boundary and two points: from the first point on, where their line meets it: the divisor, and the way times it.
struct line_meeting {
  template <class H, class P>
  constexpr auto operator()(const H& h, const P& from, const P& to) const noexcept {
    const auto at_from = half_space_value(h, from);
    return std::tuple{at_from - half_space_value(h, to), (to - from) * at_from};
  }
  template <class H, class P>
  static constexpr const P& first(const H&, const P& from, const P&) noexcept {
    return from;  // NOLINT(bugprone-return-const-ref-from-parameter)
  }
};
// Two planes and three points: the same for the point that they and the plane through the points share.
struct plane_meeting {
  template <class H, class P>
  constexpr auto operator()(const H& g, const H& h, const P& from, const P& second, const P& third) const noexcept {
    const auto n = cross(second - from, third - from);
    using N = std::remove_cvref_t<decltype(n.x)>;
    const auto normal = [](const H& of) { return vec<N, 3>{of.numbers[0], of.numbers[1], of.numbers[2]}; };
    const auto a = normal(g), b = normal(h);
    return std::tuple{dot(n, cross(a, b)),
                      cross(n, b) * half_space_value(g, from) + cross(a, n) * half_space_value(h, from)};
  }
  template <class H, class P>
  static constexpr const P& first(const H&, const H&, const P& from, const P&, const P&) noexcept {
    return from;  // NOLINT(bugprone-return-const-ref-from-parameter)
  }
};

// Where these meet, about.
template <class Meeting, class Corner, class... In>
constexpr void place_about(Corner& c, const Meeting& meeting, const In&... in) noexcept {
  c.error = std::numeric_limits<double>::infinity();
  const auto found = filtered_value_of<5>(meeting, in...);
  if (!found) return;
  const auto& [divisor, way] = *found;
  constexpr double relative = 0x1p-48;  // of at most 16 roundings
  const double size = magnitude(divisor.value), off = product(relative, divisor.size);
  if (!(off + off < size)) return;
  double error = 0;
  for (int i = 0; i < static_cast<int>(c.about.size()); ++i) {
    const double from = widened(coordinate(meeting.first(in...), i)), part = way[i].value / divisor.value;
    c.about[static_cast<std::size_t>(i)] = from + part;
    const double way_off = (product(relative, way[i].size) + product(magnitude(part), off)) / size;
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
    suits = suits && suits_filter<5>(widened(boundary.numbers[i]));
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
// The same exactly: the sign of the boundary's value where these meet.
template <int Degree, class H, class Meeting, class... In>
constexpr int exact_side(const Meeting& meeting, const H& boundary, const In&... in) noexcept {
  const auto [turn, side] = sign_of<Degree>(
      [&](const auto& h, const auto&... x) {
        const auto [divisor, way] = meeting(x...);
        return std::array{divisor, divisor * half_space_value(h, meeting.first(x...)) + half_space_growth(h, way)};
      },
      boundary, in...);
  return turn * side;
}
// The same place, rounded.
template <int Degree, Point P, class Meeting, class... In>
constexpr std::optional<P> rounded_place(const Meeting& meeting, const In&... in) noexcept {
  const auto found = quotients_of<Degree>(
      [&](const auto&... x) {
        const auto [divisor, way] = meeting(x...);
        const auto at = way + to_vec(meeting.first(x...)) * divisor;
        if constexpr (size_of<P> == 2)
          return std::array{divisor, at.x, at.y};
        else
          return std::array{divisor, at.x, at.y, at.z};
      },
      in...);
  if (!found) return std::nullopt;
  return generate_coordinates<P>([&](int i) { return (*found)[static_cast<std::size_t>(i)]; });
}

}  // namespace irg::detail::inline IRG_ABI
