// SPDX-License-Identifier: MIT
#include <irg/hidden/back_faces.hpp>
#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/bsp_scene.hpp>
#include <irg/hidden/horizon_curves.hpp>
#include <irg/hidden/horizon_lines.hpp>
#include <irg/hidden/horizon_surface.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/textbook/back_faces.hpp>
#include <irg/hidden/textbook/zbuffer.hpp>
#include <irg/hidden/warnock.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/screen_pieces.hpp>
#include <irg/view/projection.hpp>

#include <array>

#include "hashes.hpp"

namespace {

// Polygons in parallel projection and in perspective, in floats and doubles.
template <class T>
constexpr std::uint64_t textbook_buffers(int rounds) {
  using P = irg::point<T, 3>;
  test::random r(31);
  determinism::hasher h;
  const int size = rounds < 10 ? 7 : 60;
  irg::image<int> ids(size, size);
  irg::image<T> depth(size, size);
  const irg::textbook::zbuffer buffers{irg::nearer_is_greater{}, ids, depth};
  for (int i = 0; i < rounds; ++i) {
    const auto any = [&](double low, double high) { return static_cast<T>(low + irg::product(high - low, r.unit())); };
    const auto corner = [&] {
      const T x = any(-5, size + 5), y = any(-5, size + 5);
      return P{x, y, any(-40, 15)};
    };
    if (i % 4 == 0) buffers.clear(-1, T(-1000));
    const P a = corner(), b = corner(), c = corner();
    if (i % 4 < 2)
      irg::textbook::zbuffer_polygon(buffers, std::array{a, b, c}, i);
    else
      irg::textbook::zbuffer_polygon_perspective(buffers, std::array{a, b, c}, T(20), i);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        h.add(ids(x, y));
        h.add(depth(x, y));
      }
  }
  return h.value();
}
constexpr std::uint64_t hidden_zbuffer_float(int rounds) { return textbook_buffers<float>(rounds); }
constexpr std::uint64_t hidden_zbuffer_double(int rounds) { return textbook_buffers<double>(rounds); }
HASHED(hidden_zbuffer_float, 8, 400);
HASHED(hidden_zbuffer_double, 8, 400);

// Which side of triangles an eye sees, near it and infinitely far away.
constexpr std::uint64_t hidden_back_faces(int rounds) {
  test::random r(32);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto number = [&] { return i % 2 ? static_cast<double>(r.integer(-3, 3)) : r.unit() - 0.5; };
    irg::mesh<double> m;
    for (int k = 0; k < 3; ++k) m.positions.push_back({number(), number(), number()});
    irg::add_face(m, std::array{0, 1, 2});
    const irg::point<double, 3> eye{number(), number(), number()};
    h.add(static_cast<int>(irg::facing_of(m, 0, irg::hpoint<double, 3>{eye.x, eye.y, eye.z, i % 3 ? 1.0 : 0.0})));
    h.add(irg::textbook::mixed_product(m.positions[0], m.positions[1], m.positions[2], eye.z));
    const irg::vec<double, 3> n = irg::textbook::face_normal(m.positions[0], m.positions[1], m.positions[2]);
    h.add(static_cast<int>(irg::facing_by_angle(n, m.positions[0], eye)));
    const irg::point<double, 2> flat[] = {{m.positions[0].x, m.positions[0].y},
                                          {m.positions[1].x, m.positions[1].y},
                                          {m.positions[2].x, m.positions[2].y}};
    h.add(static_cast<int>(irg::facing_by_order(flat)));
    h.add(irg::textbook::is_back_by_edges(flat) ? 1 : 0);
  }
  return h.value();
}
HASHED(hidden_back_faces, 20, 20000);

// Faces through each other: what three methods show, and what they counted.
constexpr std::uint64_t hidden_methods(int rounds) {
  test::random r(33);
  determinism::hasher h;
  const int size = rounds < 10 ? 6 : 40;
  for (int i = 0; i < rounds; ++i) {
    std::vector<irg::screen_face> faces;
    for (std::uint32_t k = 0; k < (rounds < 10 ? 3u : 24u); ++k) {
      const auto corner = [&] {
        const auto x = static_cast<std::int32_t>(r.integer(-size * 64, size * 320));
        const auto y = static_cast<std::int32_t>(r.integer(-size * 64, size * 320));
        return irg::screen_vertex{{x, y}, static_cast<float>(r.integer(1, 1 << 20)) * 0x1p-20f};
      };
      const irg::screen_vertex a = corner(), b = corner(), c = corner();
      faces.push_back(irg::make_screen_face(a, b, c, k));
    }
    const irg::cell_window all{0, 0, size, size};
    const auto add = [&](const auto& method) {
      irg::image<std::uint32_t> ids(size, size, irg::no_index);
      irg::draw_counts counts;
      method(faces, all, ids, counts);
      h.add(static_cast<int>(counts.tested));
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) h.add(static_cast<int>(ids(x, y)));
    };
    add(irg::warnock<>{});
    add(irg::painter_newell<>{});
    add(irg::bsp_painter<>{});
  }
  return h.value();
}
HASHED(hidden_methods, 1, 60);

// A tree in space: its numbers, and what is seen through it.
constexpr std::uint64_t hidden_bsp_scene(int rounds) {
  test::random r(34);
  determinism::hasher h;
  const int size = rounds < 10 ? 4 : 40;
  for (int i = 0; i < rounds; ++i) {
    std::vector<irg::point<double, 3>> vertices;
    std::vector<irg::triangle_indices> triangles;
    for (std::uint32_t k = 0; k < (rounds < 10 ? 3u : 40u); ++k) {
      for (int n = 0; n < 3; ++n) {
        const auto number = [&] {
          return i % 2 ? static_cast<double>(r.integer(-3, 3)) : irg::product(4.0, r.unit()) - 2.0;
        };
        const double x = number(), y = number(), z = number();
        vertices.push_back({x, y, z});
      }
      triangles.push_back({{3 * k, 3 * k + 1, 3 * k + 2}});
    }
    const irg::bsp_tree_3d<double> tree(vertices, triangles);
    const auto& d = tree.data();
    for (const irg::bsp_node_3d& n : d.nodes)
      for (const std::uint32_t v : {n.plane.source, n.plane.axis, n.first, n.last, n.front, n.back})
        h.add(static_cast<int>(v));
    for (const irg::bsp_limit_3d& l : d.limits) h.add(static_cast<int>(l.node) * l.side);
    for (const irg::bsp_piece_3d& p : d.pieces)
      for (const irg::point<double, 3>& q : tree.rounded(p)) h.add(q[0]), h.add(q[1]), h.add(q[2]);
    const auto to_clip = irg::orthographic(irg::view_window<double>{-2, 2, -2, 2}, -10.0, 10.0);
    const auto mapping = irg::map_to_screen<double>({size, size});
    std::vector<irg::screen_face> faces;
    for (std::uint32_t k = 0; k < triangles.size(); ++k) {
      const irg::hpoint<double, 3> c[3] = {to_clip * vertices[3 * k], to_clip * vertices[3 * k + 1],
                                           to_clip * vertices[3 * k + 2]};
      for (const irg::screen_piece& p : clip_to_screen(c, mapping, k)) faces.push_back(p.face);
    }
    irg::image<std::uint32_t> ids(size, size, irg::no_index);
    irg::draw_counts counts;
    irg::bsp_scene_painter<double>(tree, irg::vec<double, 3>{0, 0, 1}, to_clip, mapping)(
        faces, irg::cell_window{0, 0, size, size}, ids, counts);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) h.add(static_cast<int>(ids(x, y)));
  }
  return h.value();
}
HASHED(hidden_bsp_scene, 2, 30);

// The lines of a surface at many angles.
constexpr std::uint64_t hidden_horizon(int rounds) {
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const irg::horizon_view view{rounds < 10 ? 9.0 : 90.0, 30, i * 0.17 - static_cast<int>(i * 0.17 / 1.5) * 1.5,
                                 i * 0.05 - 1.2, rounds < 10 ? 3 : 12};
    irg::floating_horizon horizon(irg::horizon_width(view));
    const auto height = [](double x, double z) { return irg::sin(irg::product(9.0, x)) * z; };
    draw_horizon_surface(horizon, height, view, [&](const irg::cell& a, const irg::cell& b, irg::horizon_side) {
      for (const int v : {a.x, a.y, b.x, b.y}) h.add(v);
    });
  }
  return h.value();
}
HASHED(hidden_horizon, 2, 60);

// Curves of a surface in vectors: their places, and what is seen.
constexpr std::uint64_t hidden_horizon_lines(int rounds) {
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    irg::horizon_view view{rounds < 10 ? 9.0 : 90.0, 30, (i % 12) * 0.125, (i % 16) * 0.125 - 1, rounds < 10 ? 3 : 12,
                           rounds < 10 ? 5 : 45};
    const auto height = [&](double x, double z) { return irg::product(irg::cos(4 * x + i), irg::sin(4 * z)); };
    const auto add = [&](const irg::horizon_curve_points& c) {
      irg::visible_curves(c.points, [&](const irg::edge_part& p) {
        h.add(static_cast<std::uint64_t>(p.edge));
        h.add(p.from);
        h.add(p.to);
      });
    };
    add(irg::horizon_curves_of(height, view));
    add(irg::horizon_curves_from(height, view, {-0.3 - i * 0x1p-6, 1.2, 0.5}));
  }
  return h.value();
}
HASHED(hidden_horizon_lines, 1, 40);

}  // namespace
