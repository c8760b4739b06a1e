// SPDX-License-Identifier: MIT
// Input that hidden-surface methods have been known to fail on, each through all of them. The release tier has a million
// equal faces and a hundred thousand through one line.
#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/painter_once.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/warnock.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/render/render.hpp>

#include <algorithm>
#include <cstdlib>

#include "method_scenes.hpp"
#include "support/check_both.hpp"

namespace {

template <class See>
void for_each_method(const See& see) {
  see(irg::warnock<>{});
  see(irg::painter_newell<>{});
  see(irg::bsp_painter<>{});
  see(irg::ray_casting<>{});
  see(irg::painter_once<>{});
}

void check_all(const test::face_list& faces, int width, int height) {
  const test::id_image exact = test::exact_ids(faces, width, height);
  for_each_method(
      [&](const auto& method) { CHECK(test::differing(test::ids_of(method, faces, width, height), exact) == 0); });
}

constexpr irg::screen_vertex at(int x, int y, float depth) { return {{x, y}, depth}; }

}  // namespace

TEST_CASE("hostile faces: all of the same extent in depth") {
  test::random r(31);
  test::face_list faces;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const auto place = [&] { return static_cast<int>(r.integer(-2000, 12000)); };
    const int x = place(), y = place();
    const auto near = [&](int reach) { return static_cast<int>(r.integer(-reach, reach)); };
    const int bx = near(5000), by = near(5000), cx = near(5000), cy = near(5000);
    const auto between = static_cast<float>(r.integer(1 << 18, 3 << 18)) * 0x1p-20f;
    faces.push_back(irg::make_screen_face(at(x, y, 0.25f), at(x + bx, y + by, 0.75f), at(x + cx, y + cy, between), i));
  }
  check_all(faces, 40, 40);
}

TEST_CASE("hostile faces: a thousand in one plane, a thousand through one point, many edge on") {
  const auto depth = [](int x, int y) { return static_cast<float>((1 << 20) + 3 * x - 5 * y) * 0x1p-21f; };
  test::random r(32);
  const auto place = [&] { return static_cast<int>(r.integer(-1000, 7000)); };
  test::face_list plane, star, edge_on;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const int ax = place(), ay = place(), bx = place(), by = place(), cx = place(), cy = place();
    plane.push_back(irg::make_screen_face(at(ax, ay, depth(ax, ay)), at(bx, by, depth(bx, by)),
                                          at(cx, cy, depth(cx, cy)), 999 - i));
    star.push_back(irg::make_screen_face(at(3000, 2900, 0.5f), at(bx, by, static_cast<float>(ax + 1001) * 0x1p-13f),
                                         at(cx, cy, static_cast<float>(ay + 1001) * 0x1p-13f), i));
    // A face seen edge on before every other one covers nothing.
    edge_on.push_back(i % 2 == 0 ? star.back() : irg::make_screen_face(at(ax, ay, 1), at(bx, by, 1), at(ax, ay, 1), i));
  }
  check_all(plane, 24, 24);
  check_all(star, 24, 24);
  check_all(edge_on, 24, 24);
}

TEST_CASE("hostile faces: none, one that covers all, detail below a pixel, pictures of odd sizes") {
  check_all({}, 5, 7);
  check_all({irg::make_screen_face(at(-9000, -9000, 0.5f), at(30000, -9000, 0.5f), at(-9000, 30000, 0.5f), 3)}, 9, 5);
  test::face_scene_maker make(33, 30);
  const test::face_list tiny = make(test::face_scene::tiny, 600), any = make(test::face_scene::any, 80);
  for (const auto& [width, height] : {std::pair{30, 30}, {1, 29}, {31, 1}, {1, 1}, {7, 23}, {17, 16}}) {
    check_all(tiny, width, height);
    check_all(any, width, height);
  }
}

TEST_CASE("hostile faces: the order of input is nothing to any method") {
  for (int kind = 0; kind < test::face_scenes; ++kind) {
    test::face_scene_maker make(34, 24);
    test::face_list faces = make(static_cast<test::face_scene>(kind), 60);
    for_each_method([&](const auto& method) {
      const test::id_image first = test::ids_of(method, faces, 24, 24);
      test::random r(35);
      for (std::size_t i = faces.size(); i > 1; --i)
        std::swap(faces[i - 1], faces[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(i) - 1))]);
      CHECK(test::differing(test::ids_of(method, faces, 24, 24), first) == 0);
    });
  }
}

TEST_CASE("hostile faces: equal ones, whichever corner comes first and whichever way round") {
  const std::uint32_t n = std::getenv("IRG_RELEASE_TIER") != nullptr ? 1000000 : 20000;
  const irg::screen_vertex v[3] = {at(100, 200, 0.5f), at(7000, 900, 0.25f), at(1500, 8000, 0.75f)};
  test::face_list faces;
  for (std::uint32_t i = 0; i < n; ++i)
    faces.push_back(irg::make_screen_face(v[i % 3], v[(i + 1 + i / 3 % 2) % 3], v[(i + 2 - i / 3 % 2) % 3], n - i));
  const test::id_image exact = test::exact_ids({faces.back()}, 32, 32);
  for_each_method([&](const auto& method) { CHECK(test::differing(test::ids_of(method, faces, 32, 32), exact) == 0); });
}

TEST_CASE("hostile faces: many layers over each other, each of them twice") {
  test::face_list faces;
  for (std::uint32_t i = 0; i < 12000; ++i) {
    const float depth = 0.25f + static_cast<float>(i / 2 * 7 % 6000) * 0x1p-20f;
    faces.push_back(irg::make_screen_face(at(0, 0, depth), at(2048, 0, depth), at(0, 2048, depth), i));
  }
  const auto sees = [&]<class Order>(Order) {
    const std::uint32_t seen = irg::picture_face_at<Order>(faces, 1, 1).value();
    const auto see = [&](const auto& method) {
      return test::ids_of(method, faces, 2, 2) == test::id_image(2, 2, seen);
    };
    return see(irg::ray_casting<Order>{}) && see(irg::painter_once<Order>{}) && see(irg::warnock<Order>{}) &&
           see(irg::bsp_painter<Order>{});
  };
  CHECK(sees(irg::nearer_is_greater{}));
  CHECK(sees(irg::drawing_order{}));
}

TEST_CASE("hostile faces: many through one line") {
  const bool release = std::getenv("IRG_RELEASE_TIER") != nullptr;
  const int size = 24, all = size * 256;
  const auto pencil = [&](std::uint32_t n) {
    // The line is the middle of each face: through a and b, which are half way from a corner to the others.
    const irg::screen_vertex a = at(all / 4, all / 3, 0.5f), b = at(3 * all / 4, 2 * all / 3, 0.625f);
    test::random r(36);
    test::face_list faces;
    for (std::uint32_t i = 0; i < n; ++i) {
      const int x = static_cast<int>(r.integer(-all, 2 * all)), y = static_cast<int>(r.integer(-all, 2 * all));
      const irg::screen_vertex c = at(x, y, static_cast<float>(r.integer(1 << 18, 3 << 18)) * 0x1p-20f);
      const auto beyond = [&](const irg::screen_vertex& m) {
        return at(2 * m.position.x - x, 2 * m.position.y - y, 2 * m.depth - c.depth);
      };
      faces.push_back(irg::make_screen_face(c, beyond(a), beyond(b), i));
    }
    return faces;
  };
  check_all(pencil(600), size, size);
  const test::face_list many = pencil(release ? 100000 : 4000);
  const test::id_image by_definition = test::ids_of(irg::ray_casting<>{}, many, size, size);
  for_each_method(
      [&](const auto& method) { CHECK(test::differing(test::ids_of(method, many, size, size), by_definition) == 0); });
}

TEST_CASE("hostile faces: the eye in the plane of a face, inside a body, before nothing at all") {
  const auto drawn_from = [](const irg::scene<double>& world, const auto& method) {
    irg::render_options options;
    options.style = irg::picture_style::flat;
    options.culling = irg::face_culling::none;
    irg::image<irg::rgba8> picture(40, 30);
    irg::image<float> depth(40, 30);
    const auto stats = irg::render_with(method, world, {picture, depth}, options);
    // The z-buffer's picture.
    irg::image<irg::rgba8> want(40, 30);
    irg::image<float> want_depth(40, 30);
    CHECK(irg::render(world, {want, want_depth}, options).drawn == stats.drawn);
    CHECK(picture == want);
    CHECK(depth == want_depth);
    return stats.drawn;
  };
  irg::scene<double> empty, cube, sheet;
  cube.objects.push_back({irg::shape_cube<double>(), irg::scaling(20.0)});
  sheet.objects.push_back({irg::shape_grid<double>({.columns = 2, .rows = 2})});
  for_each_method([&](const auto& method) {
    empty.view.eye = {0, 0, 5};
    CHECK(drawn_from(empty, method) == 0);
    cube.view.eye = {8, 10, 12};
    cube.view.target = {20, 9, 11};
    CHECK(drawn_from(cube, method) == 40 * 30);  // from within the cube its sides are everywhere
    cube.view.eye = {60, 25, 0};  // in the plane of a side
    cube.view.target = {10, 10, 10};
    CHECK(drawn_from(cube, method) > 0);
    // In the plane of the whole object: it is a line.
    sheet.view.target = {0, 0, 0};
    sheet.view.eye = {0, 4, 1};
    CHECK(drawn_from(sheet, method) > 0);
    sheet.view.eye = {4, 0, 0.3};
    CHECK(drawn_from(sheet, method) == 0);
  });
}
