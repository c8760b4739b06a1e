// SPDX-License-Identifier: MIT
// What the picture of a scene has to be: coverage from the snapped vertices in 64-bit integers, the visible triangle
// and the colour from the unrounded transform in doubles. Written independently of irg's rasterizer, pixel by pixel.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/scenes.hpp"

namespace bench {

/// The exact picture.
struct exact_picture {
  static constexpr std::int32_t background = -1;
  std::vector<std::int32_t> visible;  // the triangle seen in each pixel; of equal depths the one with the lower number
  std::vector<double> depth, next_depth;  // of the nearest and of the one behind it, both 0 where there is none
  std::int64_t covered = 0;  // pixels of all triangles together, of whichever side
  std::int64_t tested = 0;  // of those that are not culled
  std::int64_t drawn = 0;  // pixels that are not background
  std::int64_t not_judged = 0;  // triangles that would have to be clipped, and are not here

  /// Whether floats may take the next triangle for the nearest: the depths are within 8 units in the last place.
  bool is_close(std::size_t pixel) const {
    const float d = static_cast<float>(depth[pixel]);
    const double ulp = static_cast<double>(std::nextafter(d, 2.0f)) - static_cast<double>(d);
    return visible[pixel] != background && depth[pixel] - next_depth[pixel] <= 8 * ulp;
  }
};

/// A triangle as the oracle walks over it: three edge functions, positive inside.
struct exact_triangle {
  std::int64_t at_first[3], right[3], down[3];  // at the window's first centre; per pixel
  std::int64_t least[3];  // 0 for an edge whose points belong to the triangle, else 1
  irg::cell_window window;
  double area = 0;  // twice the area in 1/256 pixel squared; negative for those that face the eye
  bool any = false;
};

/// needs   coordinates within 2^15 pixels of the picture
inline exact_triangle exact_cover(const irg::subpixel (&p)[3], int width, int height) {
  exact_triangle t{};
  const auto cross = [](const irg::subpixel& a, const irg::subpixel& b, std::int64_t x, std::int64_t y) {
    return (std::int64_t{b.x} - a.x) * (y - a.y) - (std::int64_t{b.y} - a.y) * (x - a.x);
  };
  const std::int64_t area = cross(p[0], p[1], p[2].x, p[2].y);
  t.area = static_cast<double>(area);
  if (area == 0) return t;
  const auto pixel_of = [](std::int64_t v) { return static_cast<int>(v >> 8); };
  t.window = irg::intersect(
      {pixel_of(std::min({p[0].x, p[1].x, p[2].x})), pixel_of(std::min({p[0].y, p[1].y, p[2].y})),
       pixel_of(std::max({p[0].x, p[1].x, p[2].x})) + 1, pixel_of(std::max({p[0].y, p[1].y, p[2].y})) + 1},
      {0, 0, width, height});
  t.any = !t.window.empty();
  const std::int64_t x = std::int64_t{256} * t.window.x_first + 128, y = std::int64_t{256} * t.window.y_first + 128;
  const std::int64_t side = area > 0 ? 1 : -1;
  for (std::size_t k = 0; k < 3; ++k) {  // the edge opposite to corner k
    const irg::subpixel &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
    const std::int64_t dx = side * (std::int64_t{b.x} - a.x), dy = side * (std::int64_t{b.y} - a.y);
    t.at_first[k] = side * cross(a, b, x, y);
    t.right[k] = -256 * dy;
    t.down[k] = 256 * dx;
    t.least[k] = dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;  // left edges run up, top edges to the right
  }
  return t;
}

/// Calls emit(x, y, weights) for each covered pixel; the weights add up to 1, rounded once each.
template <class Emit>
void each_covered(const exact_triangle& t, Emit emit) {
  if (!t.any) return;
  const double area = std::abs(t.area);
  for (int y = t.window.y_first; y < t.window.y_last; ++y) {
    std::int64_t e[3];
    for (std::size_t k = 0; k < 3; ++k) e[k] = t.at_first[k] + t.down[k] * (y - t.window.y_first);
    for (int x = t.window.x_first; x < t.window.x_last; ++x) {
      if (e[0] >= t.least[0] && e[1] >= t.least[1] && e[2] >= t.least[2])
        emit(x, y,
             std::array<double, 3>{static_cast<double>(e[0]) / area, static_cast<double>(e[1]) / area,
                                   static_cast<double>(e[2]) / area});
      for (std::size_t k = 0; k < 3; ++k) e[k] += t.right[k];
    }
  }
}

/// The vertex in clip space, from the floats of the scene, in doubles.
inline std::array<double, 4> exact_clip(const scene& s, std::uint32_t vertex) {
  std::array<double, 4> h{};
  const irg::point<float, 3>& p = s.positions[vertex];
  for (int r = 0; r < 4; ++r) {
    double sum = static_cast<double>(s.to_clip(r, 3));
    for (int c = 0; c < 3; ++c) sum += static_cast<double>(s.to_clip(r, c)) * static_cast<double>(p[c]);
    h[static_cast<std::size_t>(r)] = sum;
  }
  return h;
}

/// Where a triangle stands to the picture.
enum class standing { outside, inside, cut };

inline standing standing_of(const std::array<std::array<double, 4>, 3>& h) {
  // Beyond one border with all corners; before the near plane or far beyond a border with some.
  const auto all = [&](auto test) { return test(h[0]) && test(h[1]) && test(h[2]); };
  for (std::size_t i = 0; i < 2; ++i)
    if (all([i](const auto& v) { return v[i] > v[3]; }) || all([i](const auto& v) { return -v[i] > v[3]; }))
      return standing::outside;
  if (all([](const auto& v) { return v[2] > v[3]; }) || all([](const auto& v) { return v[2] < 0; }))
    return standing::outside;
  const auto reachable = [](const auto& v) {
    return v[2] <= v[3] && v[2] >= 0 && std::abs(v[0]) < 16 * v[3] && std::abs(v[1]) < 16 * v[3];
  };
  return all(reachable) ? standing::inside : standing::cut;
}

/// Finds the exact picture. `snapped` are the vertices' places on the screen.
inline exact_picture find_exact_picture(const scene& s, const std::vector<irg::subpixel>& snapped) {
  exact_picture found;
  found.visible.assign(s.pixel_count(), exact_picture::background);
  found.depth.assign(s.pixel_count(), 0.0);
  found.next_depth.assign(s.pixel_count(), 0.0);
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const auto& v = s.triangles[i].v;
    const std::array h{exact_clip(s, v[0]), exact_clip(s, v[1]), exact_clip(s, v[2])};
    const standing where = standing_of(h);
    if (where != standing::inside) {
      found.not_judged += where == standing::cut;
      continue;
    }
    const exact_triangle t = exact_cover({snapped[v[0]], snapped[v[1]], snapped[v[2]]}, s.width, s.height);
    const bool culled = t.area > 0 && s.culling == irg::face_culling::back;
    const double z[3] = {h[0][2] / h[0][3], h[1][2] / h[1][3], h[2][2] / h[2][3]};
    each_covered(t, [&](int x, int y, const std::array<double, 3>& weight) {
      ++found.covered;
      if (culled) return;
      ++found.tested;
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(s.width) + static_cast<std::size_t>(x);
      const double depth = weight[0] * z[0] + weight[1] * z[1] + weight[2] * z[2];
      if (found.visible[pixel] == exact_picture::background || depth > found.depth[pixel]) {
        found.drawn += found.visible[pixel] == exact_picture::background;
        found.next_depth[pixel] = found.depth[pixel];
        found.depth[pixel] = depth;
        found.visible[pixel] = static_cast<std::int32_t>(i);
      } else {
        found.next_depth[pixel] = std::max(found.next_depth[pixel], depth);
      }
    });
  }
  return found;
}

/// How far a contender is from the exact picture.
struct verdict {
  std::int64_t wrong = 0;  // pixels whose coverage or visible triangle is not the exact one
  std::int64_t close = 0;  // pixels left out of that because two depths are too close to tell
  double max = 0, mean = 0;  // of colours or depths, where the triangle is the exact one
};

/// Judges a picture: ids are the triangles' numbers plus 1, 0 for the background. The colours' error is in 1/255.
inline verdict judge(const scene& s, const std::vector<irg::subpixel>& snapped, const exact_picture& exact,
                     const std::uint32_t* ids, const irg::rgba8* colours) {
  verdict v;
  std::int64_t compared = 0;
  double sum = 0;
  std::vector<bool> right(s.pixel_count());
  for (std::size_t i = 0; i < s.pixel_count(); ++i) {
    const bool same = ids[i] == static_cast<std::uint32_t>(exact.visible[i] + 1);
    const bool both_drawn = ids[i] != 0 && exact.visible[i] != exact_picture::background;
    if (exact.is_close(i) && both_drawn)
      ++v.close;
    else
      v.wrong += !same;
    right[i] = same && both_drawn;
  }
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const auto& c = s.triangles[i].v;
    const std::array h{exact_clip(s, c[0]), exact_clip(s, c[1]), exact_clip(s, c[2])};
    if (standing_of(h) != standing::inside) continue;
    each_covered(exact_cover({snapped[c[0]], snapped[c[1]], snapped[c[2]]}, s.width, s.height),
                 [&](int x, int y, const std::array<double, 3>& weight) {
                   const std::size_t pixel =
                       static_cast<std::size_t>(y) * static_cast<std::size_t>(s.width) + static_cast<std::size_t>(x);
                   if (!right[pixel] || exact.visible[pixel] != static_cast<std::int32_t>(i)) return;
                   double total = 0, light[3] = {};
                   for (std::size_t k = 0; k < 3; ++k) {
                     const double share = weight[k] / h[k][3];
                     const irg::rgb<float>& colour = s.colours[c[k]];
                     total += share;
                     light[0] += share * static_cast<double>(colour.r);
                     light[1] += share * static_cast<double>(colour.g);
                     light[2] += share * static_cast<double>(colour.b);
                   }
                   const irg::rgba8& got = colours[pixel];
                   const double channel[3] = {static_cast<double>(got.r), static_cast<double>(got.g),
                                              static_cast<double>(got.b)};
                   for (std::size_t k = 0; k < 3; ++k) {
                     const double error = std::abs(channel[k] - 255 * light[k] / total);
                     v.max = std::max(v.max, error);
                     sum += error;
                     ++compared;
                   }
                 });
  }
  v.mean = compared ? sum / static_cast<double>(compared) : 0;
  return v;
}

/// Judges depths, 0 for the background: wrong are those that stand where nothing does, or do not where something does,
/// or are off by more than 2^-12, as another triangle's is. The error of the others is in 2^-24.
inline verdict judge_depth(const scene& s, const exact_picture& exact, const float* depth) {
  verdict v;
  std::int64_t compared = 0;
  double sum = 0;
  for (std::size_t i = 0; i < s.pixel_count(); ++i) {
    const bool drawn = depth[i] != 0, meant = exact.visible[i] != exact_picture::background;
    const double error = std::abs(static_cast<double>(depth[i]) - exact.depth[i]) * 0x1p24;
    const bool same = drawn == meant && error <= 0x1p12;
    v.wrong += !same;
    if (!same || !drawn) continue;
    v.max = std::max(v.max, error);
    sum += error;
    ++compared;
  }
  v.mean = compared ? sum / static_cast<double>(compared) : 0;
  return v;
}

}  // namespace bench
