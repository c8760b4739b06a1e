// SPDX-License-Identifier: MIT
// Three rods that lie on each other in turn and a triangle through them, by each of the classical methods.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/painter.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/textbook/depth_sort.hpp>
#include <irg/hidden/warnock.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/line_aa.hpp>

#include "../../tests/hidden/one_scene.hpp"
#include "enlarged.hpp"

namespace hidden_pictures {

using namespace enlarging;
using ids = irg::image<std::uint32_t>;
inline constexpr int width = 300, height = 240;
inline constexpr irg::rgba8 of_face[] = {{204, 96, 72, 255},  {204, 96, 72, 255},  {236, 190, 96, 255},
                                         {236, 190, 96, 255}, {96, 160, 120, 255}, {96, 160, 120, 255},
                                         {120, 150, 212, 255}};

// Faces 0 to 5 are the rods, two each, 6 the triangle.
inline std::vector<irg::screen_face> rods(double scale = 1) {
  std::vector<irg::screen_face> faces;
  const auto corner = [&](double x, double y, double depth) {
    const auto snapped = [&](double v) { return static_cast<std::int32_t>(std::lround(v * scale * 256)); };
    return irg::screen_vertex{{snapped(x), snapped(y)}, static_cast<float>(depth)};
  };
  for (std::uint32_t i = 0; i < 3; ++i) {
    const double turn = 2.0943951 * i, c = std::cos(turn), s = std::sin(turn);
    const auto at = [&](double along, double across, double depth) {
      return corner(150 + c * along - s * (across + 38), 128 + s * along + c * (across + 38), depth);
    };
    const auto a = at(-98, -16, 0.35), b = at(98, -16, 0.65), d = at(98, 16, 0.65), e = at(-98, 16, 0.35);
    faces.push_back(irg::make_screen_face(a, b, d, 2 * i));
    faces.push_back(irg::make_screen_face(a, d, e, 2 * i + 1));
  }
  faces.push_back(irg::make_screen_face(corner(20, 30, 0.2), corner(285, 60, 0.8), corner(120, 228, 0.5), 6));
  return faces;
}

template <class Method>
ids found_by(const Method& method, const std::vector<irg::screen_face>& faces, int w = width, int h = height) {
  ids found(w, h, irg::no_index);
  irg::draw_counts counts;
  method(faces, irg::cell_window{0, 0, w, h}, found, counts);
  return found;
}
inline irg::rgba8 colour_of(std::uint32_t id) { return id == irg::no_index ? paper : of_face[id]; }
inline void put(picture& p, const ids& found, int left) {
  for (int y = 0; y < found.height(); ++y)
    for (int x = 0; x < found.width(); ++x) p(left + x, y) = colour_of(found(x, y));
}
inline irg::rgba8 darker(irg::rgba8 c, int of_100) {
  const auto part = [&](std::uint8_t v) { return static_cast<std::uint8_t>(v * of_100 / 100); };
  return {part(c.r), part(c.g), part(c.b), 255};
}

// Few large pixels and their centres, where the rays go; the faces' edges over them.
inline picture rays() {
  constexpr int pixel = 12;
  picture p(width, height, paper);
  const auto found = found_by(irg::ray_casting<>{}, rods(1.0 / pixel), width / pixel, height / pixel);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool centre = x % pixel / 2 == pixel / 4 && y % pixel / 2 == pixel / 4;
      p(x, y) = centre ? ink : colour_of(found(x / pixel, y / pixel));
    }
  for (const auto& f : rods())
    for (int i = 0; i < 3; ++i) {
      const auto at = [&](int k) {
        return irg::point<double, 2>{f.v[k].position.x / 256.0, f.v[k].position.y / 256.0};
      };
      irg::draw_line_aa(p, at(i), at((i + 1) % 3), ink);
    }
  return p;
}

// The picture, and the windows that it took, those that ended.
inline picture windows() {
  picture p(2 * width, height, paper);
  put(p, found_by(irg::warnock<>{}, rods()), 0);
  ids found(width, height, irg::no_index);
  const auto frame = [&](const irg::cell_window& w, irg::warnock_case how) {
    if (how == irg::warnock_case::divided) return;
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x)
        p(width + x, y) = darker(colour_of(found(x, y)), x == w.x_first || y == w.y_first ? 72 : 100);
  };
  irg::draw_warnock(found, rods(), irg::cell_window{0, 0, width, height}, frame);
  return p;
}

// By centroids, wrong pixels dark; as Newell, Newell and Sancha have it.
inline picture painters() {
  picture p(2 * width, height, paper);
  const ids naive = found_by(irg::painter_by_centroid_rounded<>{}, rods()),
            right = found_by(irg::painter_newell<>{}, rods());
  put(p, naive, 0), put(p, right, width);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (naive(x, y) != right(x, y)) p(x, y) = darker(p(x, y), 45);
  return p;
}

// The three rods as polygons, z towards the viewer, in the order of depth sort: after a third of the parts, two thirds,
// all of them; each with its outline.
inline picture sorted_parts() {
  using ring = std::vector<irg::point<double, 3>>;
  std::vector<ring> rods;
  for (int i = 0; i < 3; ++i) {
    const double turn = 2.0943951 * i, c = std::cos(turn), s = std::sin(turn);
    const auto at = [&](double along, double across, double z) {
      return irg::point<double, 3>{150 + c * along - s * (across + 38), 128 + s * along + c * (across + 38), z};
    };
    rods.push_back({at(-98, -16, 35), at(98, -16, 65), at(98, 16, 65), at(-98, 16, 35)});
  }
  const auto order = irg::textbook::depth_sort(rods);
  picture p(3 * width, height, paper);
  for (std::size_t shown = 1; shown <= 3; ++shown)
    for (std::size_t i = 0; i < order.size() * shown / 3; ++i) {
      std::vector<irg::point<double, 2>> flat;
      for (const auto& q : order[i].corners) flat.push_back({q.x + static_cast<double>(shown - 1) * width, q.y});
      irg::fill_polygon_aa(p, flat, irg::fill_rule::even_odd, of_face[2 * order[i].number]);
      for (std::size_t k = 0; k < flat.size(); ++k) irg::draw_line_aa(p, flat[k], flat[(k + 1) % flat.size()], ink);
    }
  return p;
}

// The picture, each part of a face in a shade of its own.
inline picture parts() {
  picture p(2 * width, height, paper);
  put(p, found_by(irg::bsp_painter<>{}, rods()), 0);
  const auto tree = irg::build_bsp(rods(), irg::cell_window{0, 0, width, height});
  int number = 0;
  walk_bsp(tree, irg::bsp_order::back_to_front, [&](const irg::bsp_of_faces::node& n) {
    const int shade = 60 + 40 * (number++ * 5 % 8) / 7;
    for (int y = n.box.y_first; y < n.box.y_last; ++y)
      for (int x = n.box.x_first; x < n.box.x_last; ++x)
        if (covers(n.part, x, y)) p(width + x, y) = darker(of_face[n.part.face->number], shade);
  });
  return p;
}

// The scene of the page "one scene, every method" at half its size: as all exact methods have it, and by centroids, wrong
// pixels dark.
inline picture one_scene_by_two() {
  const one_scene::bodies s = one_scene::make();
  const auto faces = one_scene::faces_of(s);
  const int w = one_scene::width, h = one_scene::height;
  const ids exact = found_by(irg::painter_newell<>{}, faces, w, h),
            naive = found_by(irg::painter_by_centroid_rounded<>{}, faces, w, h);
  constexpr irg::rgba8 of_body[] = {
      {120, 150, 212, 255}, {204, 96, 72, 255}, {96, 160, 120, 255}, {250, 214, 90, 255}, {236, 190, 96, 255}};
  const auto shaded = [&](std::uint32_t id) {
    if (id == irg::no_index) return paper;
    const auto& [v] = s.triangles[id];
    const auto n = irg::cross(s.corners[v[1]] - s.corners[v[0]], s.corners[v[2]] - s.corners[v[0]]);
    const double up = (0.3 * n[0] + 0.8 * n[1] + 0.5 * n[2]) / std::sqrt(dot(n, n));
    return darker(of_body[s.body[id]], static_cast<int>(70 + 30 * std::fmax(up, -0.5)));
  };
  picture p(w, h / 2, paper);
  for (int y = 0; y < h; y += 2)
    for (int x = 0; x < w; x += 2) {
      p(x / 2, y / 2) = shaded(exact(x, y));
      p(x / 2 + w / 2, y / 2) = naive(x, y) == exact(x, y) ? shaded(naive(x, y)) : ink;
    }
  return p;
}

}  // namespace hidden_pictures
