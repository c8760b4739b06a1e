// SPDX-License-Identifier: MIT
#include <irg/hidden/bsp_scene.hpp>

#include <cmath>
#include <cstdlib>
#include <vector>

#include <irg/raster/screen_pieces.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>

#include "method_scenes.hpp"
#include "spatial/space_scenes.hpp"
#include "support/check_both.hpp"

namespace {

using P = test::space_point;
using matrix = irg::mat<double, 4, 4>;

struct view_of_space {
  matrix to_clip;
  irg::screen_mapping<double> mapping;
};

constexpr std::vector<irg::screen_face> faces_of(const test::space_scene& s, const view_of_space& v) {
  std::vector<irg::screen_face> faces;
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
    const irg::hpoint<double, 3> corner[3] = {v.to_clip * s.vertices[s.triangles[i].v[0]],
                                              v.to_clip * s.vertices[s.triangles[i].v[1]],
                                              v.to_clip * s.vertices[s.triangles[i].v[2]]};
    for (const irg::screen_piece& p : clip_to_screen(corner, v.mapping, i)) faces.push_back(p.face);
  }
  return faces;
}

// How far snapping the corners of a face by half a unit may move its depth at a pixel.
double moved_depth(const irg::screen_face& f) {
  const auto& [a, b, c] = f.v;
  const double ux = b.position.x - a.position.x, uy = b.position.y - a.position.y,
               uz = static_cast<double>(b.depth) - static_cast<double>(a.depth);
  const double vx = c.position.x - a.position.x, vy = c.position.y - a.position.y,
               vz = static_cast<double>(c.depth) - static_cast<double>(a.depth);
  const double area = std::fabs(ux * vy - uy * vx);
  return (std::fabs(uy * vz - uz * vy) + std::fabs(uz * vx - ux * vz)) / area +
         0x1p-22 * static_cast<double>(f.depth_high);
}
// Whether snapping may have decided that a face covers a pixel.
bool is_at_border(const irg::screen_face& f, int x, int y) {
  for (int i = 0; i < 3; ++i) {
    const irg::subpixel &a = f.v[i].position, &b = f.v[(i + 1) % 3].position;
    const irg::subpixel p{x * 256 + 128, y * 256 + 128};
    const double area = static_cast<double>(irg::twice_signed_area(a, b, p));
    if (std::fabs(area) <= std::abs(b.x - a.x) + std::abs(b.y - a.y) + 1) return true;
  }
  return false;
}
double depth_in(const irg::screen_face& f, int x, int y) {
  const auto& [a, b, c] = f.v;
  const irg::subpixel p{x * 256 + 128, y * 256 + 128};
  const auto area = [](const irg::subpixel& r, const irg::subpixel& s, const irg::subpixel& t) {
    return static_cast<double>(irg::twice_signed_area(r, s, t));
  };
  return (area(b.position, c.position, p) * static_cast<double>(a.depth) +
          area(c.position, a.position, p) * static_cast<double>(b.depth) +
          area(a.position, b.position, p) * static_cast<double>(c.depth)) /
         area(a.position, b.position, c.position);
}

struct difference {
  int shown = 0, near_depths = 0, at_borders = 0, wrong = 0;
};
void compare(const std::vector<irg::screen_face>& faces, const test::id_image& ids, difference& d) {
  const test::id_image exact = test::exact_ids(faces, ids.width(), ids.height());
  for (int y = 0; y < ids.height(); ++y)
    for (int x = 0; x < ids.width(); ++x) {
      d.shown += exact(x, y) != irg::no_index;
      if (ids(x, y) == exact(x, y)) continue;
      const irg::screen_face *a = nullptr, *b = nullptr;
      for (const irg::screen_face& f : faces) {
        if (f.number == ids(x, y) && covers(f, x, y)) a = &f;
        if (f.number == exact(x, y) && covers(f, x, y)) b = &f;
      }
      if (a != nullptr && b != nullptr &&
          std::fabs(depth_in(*a, x, y) - depth_in(*b, x, y)) <= moved_depth(*a) + moved_depth(*b))
        ++d.near_depths;
      else if ((a != nullptr && is_at_border(*a, x, y)) || (b != nullptr && is_at_border(*b, x, y)))
        ++d.at_borders;
      else
        ++d.wrong;
    }
}

constexpr int width = 96, height = 72;
constexpr irg::cell_window picture{0, 0, width, height};

view_of_space seen(const P& eye, const P& target, bool parallel) {
  const irg::vec<double, 3> up{0.1, 0.2, 1};
  const double aspect = double{width} / height;
  const matrix project =
      parallel ? irg::orthographic(irg::view_window<double>{-8, 8, -8.0 / aspect, 8.0 / aspect}, -100.0, 100.0)
               : irg::perspective(0.9, aspect, 0.05, 1e9);
  return {project * irg::look_at(eye, target, up), irg::map_to_screen<double>({width, height})};
}

TEST_CASE("bsp_scene_painter: the exact picture, but where snapping can have moved depths or borders") {
  test::random r(1605);
  difference d;
  int cut = 0;
  const int scenes = std::getenv("IRG_RELEASE_TIER") != nullptr ? 2000 : 60;
  for (int scene = 0; scene < scenes; ++scene) {
    test::space_scene s;
    if (scene % 5 == 0) s = test::three_rods();
    if (scene % 5 == 1) s = test::ball(8);
    if (scene % 5 == 2) s = test::whole_numbers(r, 24, false);
    const double reach = scene % 2 == 0 ? 2 : 8;
    for (int i = 0; i < 60 && scene % 5 != 2; ++i) {
      double c[12];
      for (double& x : c) x = r.unit() - 0.5;
      const auto v = [&](int k) {
        return P{c[0] * 8 + c[k] * reach, c[1] * 8 + c[k + 1] * reach, c[2] * 8 + c[k + 2] * reach};
      };
      s.add(v(3), v(6), v(9));
    }
    const irg::bsp_tree_3d<double> tree(s.vertices, s.triangles);
    cut += static_cast<int>(tree.splits());
    const auto at = [&](double size) {
      const double x = r.unit() - 0.5, y = r.unit() - 0.5, z = r.unit() - 0.5;
      return P{x * size, y * size, z * size};
    };
    const P eye = scene % 4 == 0 ? at(4) : at(24), target = at(2);  // often within the scene
    const bool parallel = scene % 3 == 2;
    const view_of_space v = seen(eye, target, parallel);
    const auto faces = faces_of(s, v);
    test::id_image ids(width, height, irg::no_index);
    irg::draw_counts counts;
    if (parallel)
      irg::bsp_scene_painter<double>(tree, eye - target, v.to_clip, v.mapping)(faces, picture, ids, counts);
    else
      irg::bsp_scene_painter<double>(tree, eye, v.to_clip, v.mapping)(faces, picture, ids, counts);
    CHECK(counts.tested > 0);
    compare(faces, ids, d);
  }
  MESSAGE(d.shown << " pixels, " << d.near_depths << " of other faces as near as snapping moves, " << d.at_borders
                  << " at borders");
  CHECK(d.wrong == 0);
  CHECK(cut > 1000);
  CHECK((d.near_depths + d.at_borders) * 1000 < d.shown);
}

TEST_CASE("bsp_scene_painter: one tree for all eyes, in windows, with an eye in a plane") {
  test::space_scene s = test::ball(12);
  const test::space_scene rods = test::three_rods();
  for (const auto& [v] : rods.triangles) s.add(rods.vertices[v[0]], rods.vertices[v[1]], rods.vertices[v[2]]);
  const irg::bsp_tree_3d<double> tree(s.vertices, s.triangles);
  difference d;
  for (const P& eye : {P{6, 0, 0}, P{0, 0, 7}, P{0, 9, 1}, P{0, 0, 0}, P{0.3, 0.2, 0.1}}) {
    const view_of_space v = seen(eye, {0.5, -0.25, 0.125}, false);
    const auto faces = faces_of(s, v);
    const irg::bsp_scene_painter<double> method(tree, eye, v.to_clip, v.mapping);
    test::id_image whole(width, height, irg::no_index), parts(width, height, irg::no_index);
    irg::draw_counts counts;
    method(faces, picture, whole, counts);
    for (int y = 0; y < height; y += 17)
      for (int x = 0; x < width; x += 31)
        method(faces, irg::cell_window{x, y, std::min(x + 31, width), std::min(y + 17, height)}, parts, counts);
    CHECK(test::differing(whole, parts) == 0);
    compare(faces, whole, d);
  }
  CHECK(d.wrong == 0);
  CHECK((d.near_depths + d.at_borders) * 500 < d.shown);
}

TEST_CASE("bsp_scene_painter: the same pictures of scenes that are hundreds of decades smaller or larger") {
  const test::space_scene rods = test::three_rods();
  const P target{0.5, -0.25, 0.125};
  for (const bool parallel : {false, true})
    for (const bool mirrored : {false, true})
      for (const double size : {1.0, 0x1p-900, 0x1p-400, 0x1p400, 0x1p900}) {
        const auto scaled = [size](const P& p) { return P{p.x * size, p.y * size, p.z * size}; };
        const P eye = scaled({6, 1, 3});
        test::space_scene s = rods;
        for (P& p : s.vertices) p = scaled(p);
        matrix project = parallel
                             ? irg::orthographic(irg::view_window<double>{-8 * size, 8 * size, -6 * size, 6 * size},
                                                 -100 * size, 100 * size)
                             : irg::perspective(0.9, double{width} / height, 0.05 * size, 1e3 * size);
        if (mirrored)
          for (double& entry : project.m[0]) entry = -entry;
        const view_of_space v{project * irg::look_at(eye, scaled(target), irg::vec<double, 3>{0.1, 0.2, 1}),
                              irg::map_to_screen<double>({width, height})};
        const auto faces = faces_of(s, v);
        const irg::bsp_tree_3d<double> tree(s.vertices, s.triangles);
        test::id_image ids(width, height, irg::no_index);
        irg::draw_counts counts;
        if (parallel)
          irg::bsp_scene_painter<double>(tree, eye - scaled(target), v.to_clip, v.mapping)(faces, picture, ids, counts);
        else
          irg::bsp_scene_painter<double>(tree, eye, v.to_clip, v.mapping)(faces, picture, ids, counts);
        difference d;
        compare(faces, ids, d);
        CHECK(d.shown > 100);
        CHECK(d.wrong == 0);
        CHECK((d.near_depths + d.at_borders) * 100 < d.shown);
      }
}

TEST_CASE("bsp_scene_painter: in constant evaluation") {
  constexpr auto drawn = [] {
    // A floor that a wall cuts, seen from above by a matrix that keeps x and y.
    const P v[] = {{-1, -1, 0.25}, {1, -1, 0.25}, {-1, 1, 0.75}, {-1, -1, 0.5}, {1, -1, 0.5}, {-1, 1, 0.5}};
    const irg::triangle_indices t[] = {{{0, 1, 2}}, {{3, 4, 5}}};
    const irg::bsp_tree_3d<double> tree(v, t, {.candidates = 1});
    const view_of_space view{irg::identity_matrix<double, 4>(), irg::map_to_screen<double>({8, 8})};
    std::vector<irg::screen_face> faces;
    for (std::uint32_t i = 0; i < 2; ++i) {
      const irg::hpoint<double, 3> c[3] = {view.to_clip * v[3 * i], view.to_clip * v[3 * i + 1],
                                           view.to_clip * v[3 * i + 2]};
      for (const irg::screen_piece& p : clip_to_screen(c, view.mapping, i)) faces.push_back(p.face);
    }
    test::id_image ids(8, 8, irg::no_index);
    irg::draw_counts counts;
    irg::bsp_scene_painter<double>(tree, irg::vec<double, 3>{0, 0, 1}, view.to_clip, view.mapping)(
        faces, irg::cell_window{0, 0, 8, 8}, ids, counts);
    return ids(0, 7) * 100 + ids(0, 1) * 10 + static_cast<std::uint32_t>(counts.tested);
  };
  CHECK_BOTH(drawn() == 103);
}

}  // namespace
