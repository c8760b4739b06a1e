// SPDX-License-Identifier: MIT
#include "render/oracle.hpp"

#include <algorithm>
#include <cmath>

namespace bench {

exact_triangle exact_cover(const irg::subpixel (&p)[3], int width, int height) {
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

std::array<double, 4> exact_clip(const scene& s, std::uint32_t vertex) {
  std::array<double, 4> h{};
  const irg::point<float, 3>& p = s.positions[vertex];
  for (int r = 0; r < 4; ++r) {
    double sum = static_cast<double>(s.to_clip(r, 3));
    for (int c = 0; c < 3; ++c) sum += static_cast<double>(s.to_clip(r, c)) * static_cast<double>(p[c]);
    h[static_cast<std::size_t>(r)] = sum;
  }
  return h;
}

// Where a triangle stands to the picture.
enum class standing { outside, inside, cut };

static standing standing_of(const std::array<std::array<double, 4>, 3>& h) {
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

exact_picture find_exact_picture(const scene& s, const std::vector<irg::subpixel>& snapped) {
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

verdict judge(const scene& s, const std::vector<irg::subpixel>& snapped, const exact_picture& exact,
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

verdict judge_depth(const scene& s, const exact_picture& exact, const float* depth) {
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
