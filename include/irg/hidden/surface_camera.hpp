// SPDX-License-Identifier: MIT
// How an eye sees a grid surface: turned to its middle, upright lines upright, the picture plane half-way.
#pragma once

#include <optional>

#include <irg/core/is_finite.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A box with sides along the axes.
struct surface_box {
  point<double, 3> low{}, high{};
  bool operator==(const surface_box&) const = default;
};

/// An eye and the plane that it sees a surface in.
struct surface_camera {
  point<double, 3> eye{};
  vec<double, 3> right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};
  double distance = 1;  // of the picture plane

  /// Where a point is seen, right and up in the picture plane.
  /// gives   nothing for a point that is not before the eye, or is seen 2^500 or more aside
  IRG_APART constexpr std::optional<point<double, 2>> operator()(const point<double, 3>& p) const noexcept {
    const vec<double, 3> d = p - eye;
    const double depth = dot(d, forward);
    if (!(depth > 0)) return std::nullopt;
    const point<double, 2> at{product(dot(d, right) / depth, distance), product(dot(d, up) / depth, distance)};
    if (!(magnitude(at.x) < 0x1p500 && magnitude(at.y) < 0x1p500)) return std::nullopt;
    return at;
  }
  bool operator==(const surface_camera&) const = default;
};

inline namespace IRG_ABI {

/// The box of a surface's points.
/// gives   heights that are not finite are left out; 0 to 0 in a coordinate that has no numbers
/// exact   the extremes
template <class Surface>
[[nodiscard]] constexpr surface_box box_of_surface(const Surface& s) noexcept {
  const auto extremes = [](const auto& numbers, double& low, double& high) {
    bool any = false;
    for (const double v : numbers) {
      if (!is_finite(v)) continue;
      low = any ? minimum(low, v) : v;
      high = any ? maximum(high, v) : v;
      any = true;
    }
  };
  surface_box b;
  extremes(s.x, b.low.x, b.high.x);
  extremes(s.heights, b.low.y, b.high.y);
  extremes(s.z, b.low.z, b.high.z);
  return b;
}

/// The camera of an eye that looks at the middle of a box. The picture plane stands half-way.
/// gives   straight down, or from above where the eye is in the middle itself, x to the right
/// exact   each operation rounded once; directions are scaled before they are squared
/// source  Special-cases chapter, 3 (view set-up)
template <class Box>
[[nodiscard]] constexpr surface_camera camera_on(const Box& box, const point<double, 3>& eye) noexcept {
  const auto unit = [](const vec<double, 3>& v) {
    const double size = maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
    if (!(size > 0)) return vec<double, 3>{0, 0, 0};
    const vec<double, 3> s = v / size;
    return s / sqrt(dot(s, s));
  };
  const vec<double, 3> to{(box.low.x / 2 + box.high.x / 2) - eye.x, (box.low.y / 2 + box.high.y / 2) - eye.y,
                          (box.low.z / 2 + box.high.z / 2) - eye.z};
  surface_camera c;
  c.eye = eye;
  c.forward = unit(to);
  const vec<double, 3>& f = c.forward;
  c.distance = dot(to, f) / 2;
  if (!(c.distance > 0)) c.distance = 1, c.forward = {0, -1, 0};
  c.right = unit({f.z, 0, -f.x});
  if (!(magnitude(c.right.x) + magnitude(c.right.z) > 0)) c.right = {1, 0, 0};
  const vec<double, 3>& r = c.right;
  c.up = {product(f.y, r.z), product(f.z, r.x) - product(f.x, r.z), -product(f.y, r.x)};
  return c;
}

}  // namespace IRG_ABI
}  // namespace irg
