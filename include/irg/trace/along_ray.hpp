// SPDX-License-Identifier: MIT
// What stands along a ray: all crossings in their order, whether one point sees another, how far it is free.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <irg/geometry/orient3d.hpp>
#include <irg/spatial/triangle_bvh.hpp>
#if IRG_BODIES
#include <algorithm>
#include <concepts>
#include <limits>

#include <irg/math/exact/sign_of.hpp>
#endif

namespace irg {

/// A part of a ray that nothing crosses, and how many steps of a given length it has room for.
struct free_run {
  double from = 0, to = 0;
  std::int64_t steps = 0;
  bool operator==(const free_run&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// All triangles that a ray crosses, in the order in which it does.
/// gives   of those whose times are one double the lower number first
/// exact   which are crossed, as intersect_triangle; the order is that of the rounded times
/// cost    as all_hits, and sorting; allocates the result
template <Floating T, Floating U>
[[nodiscard]] IRG_API std::vector<triangle_hit> sorted_hits(const triangle_bvh<T>& triangles, const ray<U, 3>& r);

/// How many steps, of so many of the ray's direction, can be taken from its beginning before something is crossed.
/// gives   at most 2^53; 0 where a step is not positive or infinite
/// exact   of the rounded time of the first crossing: steps of the double 0.1, which is more than a tenth, are taken 9
///         times until 1
/// cost    as closest_hit
template <Floating T, Floating U>
[[nodiscard]] IRG_API std::int64_t visible_steps(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                                                 double step) noexcept;

/// The longest part of a ray that nothing crosses, and how many steps of the given length it has room for: the greatest
/// number of segments in a row that see each other.
/// needs   a ray that ends
/// gives   of equally long ones the first; nothing of an empty ray
/// exact   of the rounded times of the crossings
/// cost    as sorted_hits
/// source  irg's own: the task is that of Fabris 2012
template <Floating T, Floating U>
[[nodiscard]] IRG_API free_run longest_free_run(const triangle_bvh<T>& triangles, const ray<U, 3>& r, double step);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// Whether p sees q past triangles, of which corners(i) gives the corners: none of them crosses the way from p to q.
/// gives   true for equal points. What p or q stands on does not hide: triangles whose planes hold one of them, to the
///         last bit, are passed over; false where a coordinate is NaN or infinite
/// exact   for the direction q - p as it is rounded, or half of it where it is beyond the largest number; what holds p
///         or q by orient3d
/// cost    as any_hit
template <Floating T, class Corners>
[[nodiscard]] constexpr bool has_line_of_sight(const triangle_bvh<T>& triangles, const Corners& corners,
                                               const point<T, 3>& p, const point<T, 3>& q) {
  if (p == q) return true;
  ray<T, 3> way = ray_between(p, q);
  if (way.empty()) {
    const auto half = [&](int i) { return q[i] * T(0.5) - p[i] * T(0.5); };
    way = {p, {half(0), half(1), half(2)}, T(0), T(2)};
    if (way.empty()) return false;
  }
  return !any_hit(triangles, way, [&](std::uint32_t number) {
    const std::array<point<T, 3>, 3> corner = corners(number);
    const auto holds = [&](const point<T, 3>& x) { return orient3d(corner[0], corner[1], corner[2], x) == 0; };
    return !holds(p) && !holds(q);
  });
}

IRG_RENAMED(is_visible, has_line_of_sight)

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg {
namespace detail::inline IRG_ABI {

// The most steps from one time that do not end after another, at most 2^53. A template, so that including it makes
// nothing of the exact engine.
constexpr std::int64_t whole_steps(std::same_as<double> auto from, double to, double step) noexcept {
  constexpr double most = 0x1p53;
  if (!(from < to) || !(0 < step) || !(step <= (std::numeric_limits<double>::max)())) return 0;
  const double about = (to - from) / step;
  if (!(about < most + 8)) return std::int64_t{1} << 53;
  const auto have_room = [&](double n) {
    return irg::sign_of<2>([](const auto& x) { return (x[1] - x[0]) - x[2] * x[3]; }, std::array{from, to, n, step}) >=
           0;
  };
  double n = about < most ? static_cast<double>(static_cast<std::int64_t>(about)) : most;
  while (n > 0 && !have_room(n)) n -= 1;
  while (n < most && have_room(n + 1)) n += 1;
  return static_cast<std::int64_t>(n);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T, Floating U>
[[nodiscard]] IRG_API std::vector<triangle_hit> sorted_hits(const triangle_bvh<T>& triangles, const ray<U, 3>& r) {
  std::vector<triangle_hit> hits;
  all_hits(triangles, r, [&](const triangle_hit& h) { hits.push_back(h); });
  std::sort(hits.begin(), hits.end(), [](const triangle_hit& a, const triangle_hit& b) {
    return a.at.t != b.at.t ? a.at.t < b.at.t : a.triangle < b.triangle;
  });
  return hits;
}

template <Floating T, Floating U>
[[nodiscard]] IRG_API std::int64_t visible_steps(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                                                 double step) noexcept {
  if (r.empty()) return 0;
  const double low = r.low < U(0) ? 0.0 : static_cast<double>(r.low);
  const auto hit = closest_hit(triangles, r);
  return detail::whole_steps(low, hit ? hit->at.t : static_cast<double>(r.high), step);
}

template <Floating T, Floating U>
[[nodiscard]] IRG_API free_run longest_free_run(const triangle_bvh<T>& triangles, const ray<U, 3>& r, double step) {
  if (r.empty()) return {};
  double from = r.low < U(0) ? 0.0 : static_cast<double>(r.low);
  free_run best{from, from, 0};
  const auto try_run = [&](double to) {
    if (best.to - best.from < to - from) best = {from, to, detail::whole_steps(from, to, step)};
    from = to;
  };
  for (const triangle_hit& h : sorted_hits(triangles, r)) try_run(h.at.t);
  try_run(static_cast<double>(r.high));
  return best;
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg
#endif
