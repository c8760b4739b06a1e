// SPDX-License-Identifier: MIT
// Hashes of clipping: lines and polygons against windows and convex polygons, and operations on polygons.
#include <array>
#include <vector>

#include <irg/geometry/clip_line_cohen_sutherland.hpp>
#include <irg/geometry/clip_line_cyrus_beck.hpp>
#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/geometry/clip_line_nicholl_lee_nicholl.hpp>
#include <irg/geometry/clip_sutherland_hodgman.hpp>
#include <irg/geometry/polygon_overlay.hpp>

#include "hashes.hpp"

namespace {

using determinism::hasher;

template <class T>
constexpr std::uint64_t clipping(int rounds) {
  using P = irg::point<T, 2>;
  hasher h;
  test::random r(77);
  const auto draw = [&] { return static_cast<T>(r.unit() * 4 - 2); };
  const auto place = [&] {
    const T x = draw(), y = draw();
    return P{x, y};
  };
  const auto add = [&](const P& p) { h.add(p.x), h.add(p.y); };
  const std::vector<P> hexagon{{T(2), T(0.1)}, {T(1), T(1.7)},   {T(-1), T(1.8)},
                               {T(-2), T(0)},  {T(-1), T(-1.7)}, {T(1), T(-1.9)}};
  for (int i = 0; i < rounds; ++i) {
    const auto window = irg::bounding_box(irg::bounding_box(irg::box<T, 2>{}, place()), place());
    const P a = place(), b = place(), c = place(), d = place();
    for (const auto& kept : {clip_line_liang_barsky(a, b, window), clip_line_cohen_sutherland(b, a, window),
                             clip_line_nicholl_lee_nicholl(a, c, window), irg::clip_line_cyrus_beck(a, b, hexagon)}) {
      h.add(static_cast<int>(kept.has_value()));
      if (kept) add(kept->first), add(kept->second), h.add(kept->t_first), h.add(kept->t_second);
    }
    const std::vector<P> polygon{a, b, c, d};
    for (const P& p : clip_sutherland_hodgman(polygon, window)) add(p);
    for (const P& p : clip_sutherland_hodgman(polygon, hexagon)) add(p);
    for (const auto& ring : polygon_boolean(polygon, hexagon).rings)
      for (const P& p : ring) add(p);
  }
  return h.value();
}

constexpr std::uint64_t geometry_clipping_float(int rounds) { return clipping<float>(rounds); }
constexpr std::uint64_t geometry_clipping_double(int rounds) { return clipping<double>(rounds); }
HASHED(geometry_clipping_float, 1, 3000);
HASHED(geometry_clipping_double, 1, 3000);

}  // namespace
