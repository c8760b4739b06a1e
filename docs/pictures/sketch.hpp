// SPDX-License-Identifier: MIT
// What drawings of numbers and geometry share: smooth strokes, discs, arrows and areas, and an oblique view of space.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <irg/colour/mix.hpp>
#include <irg/math/length.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/math/vec.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/image.hpp>
#include <irg/view/oblique.hpp>

#include "enlarged.hpp"

namespace sketching {

using namespace enlarging;
using point2 = irg::point<double, 2>;
using vec2 = irg::vec<double, 2>;
using point3 = irg::point<double, 3>;
using vec3 = irg::vec<double, 3>;
using ring = std::vector<point2>;
inline constexpr irg::rgba8 white{255, 255, 255, 255}, red{204, 76, 58, 255}, green{66, 140, 84, 255},
    blue{62, 112, 176, 255}, grey{150, 150, 148, 255}, yellow{250, 214, 90, 255}, light_blue{206, 222, 240, 255},
    light_red{240, 210, 200, 255};

// The colour over what is there; its opacity counts.
inline auto glaze(irg::rgba8 colour) {
  return [colour](const irg::rgba8& there, std::uint8_t coverage) {
    const irg::rgba8 opaque{colour.r, colour.g, colour.b, 255};
    return irg::mix(there, opaque, static_cast<std::uint8_t>((coverage * colour.a + 127) / 255));
  };
}

inline irg::rgba8 with_opacity(irg::rgba8 colour, int opacity) {
  colour.a = static_cast<std::uint8_t>(opacity);
  return colour;
}

inline void area(picture& p, const ring& outline, irg::rgba8 colour) {
  irg::fill_polygon_aa(p, outline, irg::fill_rule::non_zero, glaze(colour));
}

// A ring around a point; it turns the way that the quadrangles of strokes turn.
inline ring circle(const point2& centre, double radius) {
  ring r;
  for (int i = 0; i < 24; ++i) {
    const double angle = -irg::two_pi<double> * i / 24;
    r.push_back({centre.x + radius * irg::cos(angle), centre.y + radius * irg::sin(angle)});
  }
  return r;
}

inline void disc(picture& p, const point2& centre, double radius, irg::rgba8 colour) {
  area(p, circle(centre, radius), colour);
}

// A dot with a border, seen on any ground.
inline void mark(picture& p, const point2& centre, double radius, irg::rgba8 colour) {
  disc(p, centre, radius + 1.5, white);
  disc(p, centre, radius, colour);
}

// The line through all points with round ends and corners, painted in one.
inline void stroke(picture& p, const ring& points, double width, irg::rgba8 colour) {
  std::vector<ring> parts;
  for (const point2& q : points) parts.push_back(circle(q, width / 2));
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const point2 a = points[i], b = points[i + 1];
    const auto along = irg::try_normalized(b - a);
    if (!along) continue;
    const vec2 aside{-along->y * width / 2, along->x * width / 2};
    parts.push_back({a + aside, b + aside, b - aside, a - aside});
  }
  irg::fill_polygon_aa(p, parts, irg::fill_rule::non_zero, glaze(colour));
}

inline void outline(picture& p, ring corners, double width, irg::rgba8 colour) {
  corners.push_back(corners.front());
  stroke(p, corners, width, colour);
}

inline void dashes(picture& p, const point2& a, const point2& b, double width, irg::rgba8 colour) {
  const double length = irg::length(b - a), step = 4 * width;
  for (double from = 0; from < length; from += step) {
    const double to = std::min(from + step / 2, length);
    stroke(p, {a + (b - a) * (from / length), a + (b - a) * (to / length)}, width, colour);
  }
}

inline void arrow(picture& p, const point2& a, const point2& b, double width, irg::rgba8 colour) {
  const auto along = irg::try_normalized(b - a);
  if (!along) return;
  const vec2 back = *along * (4.5 * width), aside{-along->y * 2 * width, along->x * 2 * width};
  stroke(p, {a, b - back * 0.8}, width, colour);
  area(p, {b, b - back + aside, b - back - aside}, colour);
}

// The letters of axes, as strokes.
inline void letter(picture& p, char name, const point2& at, double half, irg::rgba8 colour) {
  const auto q = [&](double x, double y) { return point2{at.x + x * half, at.y + y * half}; };
  constexpr double width = 2.0;
  if (name == 'z') {
    stroke(p, {q(-0.8, -1), q(0.8, -1), q(-0.8, 1), q(0.8, 1)}, width, colour);
  } else {
    stroke(p, {q(-0.8, -1), name == 'x' ? q(0.8, 1) : q(0, 0.3)}, width, colour);
    stroke(p, {q(0.8, -1), name == 'x' ? q(-0.8, 1) : q(-0.6, 1.8)}, width, colour);
  }
}

// Space with x to the right, y up and z toward the viewer as an oblique projection shows it.
class oblique_view {
public:
  oblique_view(const point2& where_origin_is, double size_of_one, double degrees = 40, double factor = 0.55)
      : how_{irg::radians(degrees), factor},
        matrix_(irg::oblique(how_, irg::view_window<double>{-1, 1, -1, 1}, -100, 100)), origin_(where_origin_is),
        unit_(size_of_one) {}
  point2 at(const point3& p) const {
    const auto q = matrix_ * p;
    return {origin_.x + unit_ * q.x, origin_.y - unit_ * q.y};
  }
  // The point of the plane z = 0 that is seen at a place of the picture.
  point3 under(const point2& p) const { return {(p.x - origin_.x) / unit_, (origin_.y - p.y) / unit_, 0}; }
  vec3 to_viewer() const { return irg::direction_to_viewer(how_); }

private:
  irg::oblique_depth<double> how_;
  irg::mat<double, 4, 4> matrix_;
  point2 origin_;
  double unit_;
};

// The picture at half its size, four pixels mixed into one.
inline picture halved(const picture& big) {
  picture p(big.width() / 2, big.height() / 2);
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x) {
      const auto mean = [&](auto channel) {
        int sum = 2;
        for (int k = 0; k < 4; ++k) sum += big(2 * x + k % 2, 2 * y + k / 2).*channel;
        return static_cast<std::uint8_t>(sum / 4);
      };
      p(x, y) = {mean(&irg::rgba8::r), mean(&irg::rgba8::g), mean(&irg::rgba8::b), 255};
    }
  return p;
}

}  // namespace sketching
