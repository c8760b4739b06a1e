// SPDX-License-Identifier: MIT
// The curves of a surface over the unit square as points in the picture, unrounded, near ones first: for visible_curves
// (horizon_lines.hpp), which parts of them are seen. At right angles as draw_horizon_surface draws them, or as an eye
// sees them before an upright picture plane, in which upright lines stay upright.
#pragma once

#include <limits>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/hidden/horizon_view.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/sqrt.hpp>

namespace irg {

/// Points of curves, y up, and the height of the surface at each: for colours. NaN parts curves, and stands where the
/// surface has no height.
struct horizon_curve_points {
  std::vector<point<double, 2>> points{};
  std::vector<double> heights{};
  bool operator==(const horizon_curve_points&) const = default;
};

namespace detail::inline IRG_ABI {

template <class Height, class View, class Place>
constexpr horizon_curve_points curve_points(const Height& height, const View& t, const point<double, 2>& eye,
                                            const Place& place) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  horizon_curve_points curves;
  const auto put = [&](const point<double, 2>& at, double y) {
    const bool is_seen = is_finite(at, y);
    curves.points.push_back(is_seen ? at : point<double, 2>{nothing, nothing});
    curves.heights.push_back(y);
  };
  const auto begin = [&] {
    if (!curves.points.empty()) put({nothing, nothing}, nothing);
  };
  visit_horizon_samples(t, eye, begin, [&](double x, double z) {
    const double y = height(x, z);
    put(place(x, y, z), y);
  });
  return curves;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The curves of y = height(x, z), turned and tilted as the view says.
/// shape   x' width and y' height as in draw_horizon_surface, neither moved nor rounded to pixels
/// gives   NaN where a height or its place is not finite
/// exact   each operation rounded once
/// cost    a call of height for each sample; memory for all of them
template <class Height>
[[nodiscard]] constexpr horizon_curve_points horizon_curves_of(const Height& height, const horizon_view& view) {
  const detail::turned_view t = detail::turn_view(view);
  return detail::curve_points(height, t, detail::eye_at_infinity,
                              [&](double x, double y, double z) { return detail::turned_place(t, x, y, z); });
}

/// The curves of y = height(x, z) as an eye at `eye` sees them that looks level towards the square's middle.
/// shape   to the right of the middle width times the distance to the side over the distance ahead, up from the eye's
///         height height times that upwards; the view's yaw and pitch do not matter, and each curve has a sample for
///         each pixel of its width
/// gives   no points for an eye over the square (x and z both between 0 and 1), or not finite; NaN for what is not
///         before the eye
/// exact   each operation rounded once
/// cost    a call of height for each sample; memory for all of them
/// source  irg's own: near to far as the perimeter method's covering order, about the eye
template <class Height>
[[nodiscard]] constexpr horizon_curve_points horizon_curves_from(const Height& height, const horizon_view& view,
                                                                 const point<double, 3>& eye) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const auto over = [](double v) { return v > 0 && v < 1; };
  if (!is_finite(eye)) return {};
  if (over(eye.x) && over(eye.z)) return {};
  const double scale = magnitude(eye.x) < 0x1p500 && magnitude(eye.z) < 0x1p500 ? 1 : 0x1p-550;  // for the squares
  const double ahead_x = (0.5 - eye.x) * scale, ahead_z = (0.5 - eye.z) * scale;
  const double size = sqrt(product(ahead_x, ahead_x) + product(ahead_z, ahead_z));
  const double x_ahead = ahead_x / size, z_ahead = ahead_z / size;
  const detail::turned_view t{detail::limited_view(view), 1, 1, 1, 0, 0};
  return detail::curve_points(height, t, {eye.x, eye.z}, [&](double x, double y, double z) {
    const double dx = x - eye.x, dz = z - eye.z;
    const double depth = product(dx, x_ahead) + product(dz, z_ahead);
    if (!(depth > 0)) return point<double, 2>{nothing, nothing};
    const double aside = product(dx, z_ahead) - product(dz, x_ahead);
    return point<double, 2>{product(t.view.width, aside / depth), product(t.view.height, (y - eye.y) / depth)};
  });
}

}  // namespace IRG_ABI
}  // namespace irg
