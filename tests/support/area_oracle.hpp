// SPDX-License-Identifier: MIT
// What the tests of anti-aliased fills compare with: areas by clipping polygons to pixels (Sutherland and Hodgman), in
// extended precision; nothing of it is shared with the library.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/raster/subpixel.hpp>

#include "support/random.hpp"

namespace test {

/// A point within 16 pixels of (0, 0) or up to `reach` away, as often between 2^k and 2^(k + 1) pixels for each k.
inline irg::subpixel place_within(random& r, double reach) {
  const auto coordinate = [&] {
    const double size = std::exp2(r.unit() * std::log2(reach * irg::one_pixel));
    const auto far = static_cast<std::int32_t>(r.integer(0, 1) == 0 ? -size : size);
    return r.integer(0, 2) == 0 ? static_cast<std::int32_t>(r.integer(-4096, 4096)) : far;
  };
  const std::int32_t x = coordinate();
  return {x, coordinate()};
}
/// The ends of an edge that passes by (0, 0), nearly level, up to `reach` long on either side.
inline std::pair<irg::subpixel, irg::subpixel> nearly_level(random& r, double reach) {
  const auto away = [&] { return static_cast<std::int32_t>(std::exp2(r.unit() * std::log2(reach * irg::one_pixel))); };
  const auto height = [&] { return static_cast<std::int32_t>(r.integer(-2000, 2000)); };
  const irg::subpixel a{-away(), height()};
  return {a, {away(), r.integer(0, 1) == 0 ? height() : a.y + height() / 16}};
}

struct real_point {
  long double x, y;
};

/// The area of a ring, positive when it runs clockwise on the screen, in pixels.
inline long double signed_area(const std::vector<real_point>& p) {
  long double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const real_point &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

/// The part of a ring where sign * (coordinate - at) >= 0; its signed area is right for every ring.
inline std::vector<real_point> clipped(const std::vector<real_point>& p, bool in_x, long double at, int sign) {
  std::vector<real_point> out;
  out.reserve(p.size() + 4);
  const auto side = [&](const real_point& v) { return sign * ((in_x ? v.x : v.y) - at); };
  for (std::size_t i = 0; i < p.size(); ++i) {
    const real_point &a = p[i], &b = p[(i + 1) % p.size()];
    const long double da = side(a), db = side(b);
    if (da >= 0) out.push_back(a);
    if ((da < 0) != (db < 0)) {
      const long double t = da / (da - db);
      real_point c{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
      (in_x ? c.x : c.y) = at;
      out.push_back(c);
    }
  }
  return out;
}

inline std::vector<real_point> in_pixels(const std::vector<irg::subpixel>& outline, long double x, long double y) {
  std::vector<real_point> p;
  p.reserve(outline.size());
  for (const irg::subpixel& v : outline) p.push_back({v.x / 256.0L - x, v.y / 256.0L - y});
  return p;
}

inline long double area_of(const std::vector<irg::subpixel>& outline) {
  const long double a = signed_area(in_pixels(outline, 0, 0));
  return a < 0 ? -a : a;
}

/// The area of a ring within pixel (x, y), counted as often as the ring runs round it; clockwise rounds are positive.
inline long double signed_area_within_pixel(const std::vector<irg::subpixel>& outline, int x, int y) {
  std::vector<real_point> p = in_pixels(outline, x, y);
  p = clipped(p, true, 0, 1);
  p = clipped(p, true, 1, -1);
  p = clipped(p, false, 0, 1);
  p = clipped(p, false, 1, -1);
  return signed_area(p);
}

/// The area of a convex ring within pixel (x, y).
inline long double area_within_pixel(const std::vector<irg::subpixel>& outline, int x, int y) {
  const long double a = signed_area_within_pixel(outline, x, y);
  return a < 0 ? -a : a;
}

/// The area within pixel (x, y) where the winding number of the rings is inside, by brute force: between all heights at
/// which anything can happen (vertices, crossings of any two edges, edges meeting the pixel's sides) the length inside
/// is linear in y, so its value half-way is exact for the slab.
template <class Inside>
long double enclosed_within_pixel(const std::vector<std::vector<irg::subpixel>>& rings, int x, int y, Inside inside) {
  struct edge {
    real_point a, b;
  };
  std::vector<edge> edges;
  std::vector<long double> heights = {0, 1};
  for (const auto& outline : rings) {
    if (outline.size() < 3) continue;
    const std::vector<real_point> p = in_pixels(outline, x, y);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const real_point &a = p[i], &b = p[(i + 1) % p.size()];
      if (a.y == b.y || std::max(a.y, b.y) <= 0 || std::min(a.y, b.y) >= 1) continue;
      edges.push_back({a, b});
      heights.push_back(a.y);
      heights.push_back(b.y);
      for (const long double at : {0.0L, 1.0L})
        if (a.x != b.x) heights.push_back(a.y + (at - a.x) * (b.y - a.y) / (b.x - a.x));
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const real_point &p = edges[i].a, &q = edges[k].a;
      const real_point u{edges[i].b.x - p.x, edges[i].b.y - p.y}, v{edges[k].b.x - q.x, edges[k].b.y - q.y};
      const long double d = u.x * v.y - u.y * v.x;
      if (d != 0) heights.push_back(p.y + u.y * ((q.x - p.x) * v.y - (q.y - p.y) * v.x) / d);
    }
  std::sort(heights.begin(), heights.end());
  long double area = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const long double top = heights[i], bottom = heights[i + 1];
    if (!(top >= 0 && bottom <= 1 && top < bottom)) continue;
    const long double middle = (top + bottom) / 2;
    std::vector<std::pair<long double, int>> crossings;
    for (const edge& e : edges) {
      const bool down = e.a.y < e.b.y;
      const real_point &a = down ? e.a : e.b, &b = down ? e.b : e.a;
      if (a.y < middle && middle < b.y)
        crossings.emplace_back(a.x + (b.x - a.x) * (middle - a.y) / (b.y - a.y), down ? 1 : -1);
    }
    std::sort(crossings.begin(), crossings.end());
    int winding = 0;
    long double length = 0;
    for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
      winding += crossings[k].second;
      const long double from = std::clamp(crossings[k].first, 0.0L, 1.0L);
      const long double to = std::clamp(crossings[k + 1].first, 0.0L, 1.0L);
      if (inside(winding)) length += to - from;
    }
    area += length * (bottom - top);
  }
  return area;
}

/// The convex hull of points, without the points on its edges (Andrew's chain).
inline std::vector<irg::subpixel> convex_hull(std::vector<irg::subpixel> p) {
  const auto less = [](const irg::subpixel& a, const irg::subpixel& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  const auto turn = [](const irg::subpixel& a, const irg::subpixel& b, const irg::subpixel& c) {
    return static_cast<long long>(b.x - a.x) * (c.y - a.y) - static_cast<long long>(b.y - a.y) * (c.x - a.x);
  };
  std::sort(p.begin(), p.end(), less);
  p.erase(std::unique(p.begin(), p.end()), p.end());
  if (p.size() < 3) return p;
  std::vector<irg::subpixel> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const irg::subpixel& v : p) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), v) <= 0) hull.pop_back();
      hull.push_back(v);
    }
    hull.pop_back();
    std::reverse(p.begin(), p.end());
  }
  return hull;
}

}  // namespace test
