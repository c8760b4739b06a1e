// SPDX-License-Identifier: MIT
// Triangles that name vertices which are not there are left out, by everything that draws triangles: what remains is as
// if they had not been given.
#include <irg/render/draw_transparent.hpp>
#include <irg/render/occlusion_mask.hpp>
#include <irg/render/visibility_buffer.hpp>
#include <irg/render/wireframe.hpp>

#include <algorithm>
#include <vector>

#include <irg/core/threads.hpp>

#include "support/check_both.hpp"
#include "support/visible_scenes.hpp"

namespace {

using irg::face_culling;
using irg::triangle_indices;
using batch = irg::triangle_batch<double>;
using ids = irg::image<std::uint32_t>;
using depths = irg::image<float>;
constexpr int width = 90, height = 70;  // two tiles by two

// The triangles of a scene, and the same with others among them that name vertices beyond the last.
struct given {
  test::triangle_scene scene;
  irg::screen_mapping<double> mapping;
  irg::projected_vertices<double> vertices;
  std::vector<triangle_indices> mixed;
  std::vector<std::uint32_t> place;  // of each triangle of the scene among the mixed ones

  constexpr given(const test::triangle_scene& s, int bad_for_each)
      : scene(s), mapping(irg::map_to_screen<double>({s.width, s.height})) {
    vertices = irg::project_vertices<double>(scene.positions, scene.to_clip, mapping);
    const auto n = static_cast<std::uint32_t>(scene.positions.size());
    const std::uint32_t beyond[] = {n, n + 1, 0x7fffffff, 0x80000000, 0x80000001, 0xffffffff};
    std::uint32_t k = 0;
    for (const triangle_indices& t : scene.triangles) {
      for (int i = 0; i < bad_for_each; ++i, ++k) {
        triangle_indices bad = t;
        for (std::uint32_t corner = 0; corner < 3; ++corner)
          if ((k % 7 + 1) >> corner & 1) bad.v[corner] = beyond[(k / 7 + corner) % 6];
        mixed.push_back(bad);
      }
      place.push_back(static_cast<std::uint32_t>(mixed.size()));
      mixed.push_back(t);
    }
  }
  given(const given&) = delete;
  constexpr batch good() const { return {&vertices, scene.triangles}; }
  constexpr batch with_bad() const { return {&vertices, mixed}; }
};

given random_scene(std::uint64_t seed) {
  test::random r(seed);
  const auto kind = seed % 2 ? test::scene_kind::any : test::scene_kind::through_the_eye;
  test::scene_maker make(r, kind, width, height);
  return {make(40), 5};
}

// Numbers of the scene's triangles as numbers of the mixed ones.
template <class Executor>
void check_visible(const given& g, const irg::draw_depth_options& settings, const Executor& executor) {
  ids expected(g.scene.width, g.scene.height, 0), seen = expected;
  depths expected_depth(g.scene.width, g.scene.height, 0.0f), depth = expected_depth, alone = expected_depth;
  const batch good[] = {g.good()}, mixed[] = {g.with_bad()};
  const auto a =
      irg::draw_visibility({expected, expected_depth}, irg::projected_triangles{good, g.mapping}, settings, executor);
  const auto b = irg::draw_visibility({seen, depth}, irg::projected_triangles{mixed, g.mapping}, settings, executor);
  for (int y = 0; y < g.scene.height; ++y)
    for (int x = 0; x < g.scene.width; ++x) {
      std::uint32_t& e = expected(x, y);
      if (e != irg::no_index) e = g.place[e];
    }
  CHECK(seen == expected);
  CHECK(depth == expected_depth);
  CHECK(b.pixels.tested == a.pixels.tested);
  CHECK(b.skipped == a.skipped);
  CHECK(b.triangles == static_cast<std::int64_t>(g.mixed.size()));
  irg::draw_depth(alone, irg::projected_triangles{mixed, g.mapping}, settings, executor);
  CHECK(alone == expected_depth);
}

constexpr test::triangle_scene small_scene() {
  return {{{-1, -1, -2}, {1, -1, -2}, {0, 1, -3}}, {{{0, 1, 2}}}, test::square_view(0.125), 7, 6};
}

}  // namespace

TEST_CASE("indices: triangles without vertices are left out of visibility buffers and depths") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const given g = random_scene(seed);
    for (const face_culling culling : {face_culling::back, face_culling::none})
      for (const irg::skip_options& skip : {irg::skip_options{}, irg::skip_nothing}) {
        check_visible(g, {culling, skip, irg::clearing::before_drawing}, irg::sequential{});
        check_visible(g, {culling, skip, irg::clearing::before_drawing}, irg::parallel{3});
      }
    for (std::uint32_t i = 0; i < g.mixed.size(); ++i)
      if (std::find(g.place.begin(), g.place.end(), i) == g.place.end())
        CHECK_FALSE(irg::barycentrics_at(g.with_bad(), g.mapping, i, 45, 35).has_value());
  }
}

TEST_CASE("indices: ... of pictures, opaque and transparent, in every order") {
  const auto colour_of = [](const given& g, const batch& b, std::uint32_t i) {
    const std::uint32_t at = b.triangles.size() == g.mixed.size() ? i : g.place[i];
    REQUIRE(std::find(g.place.begin(), g.place.end(), at) != g.place.end());
    return irg::solid_shader<irg::rgba8>{{static_cast<std::uint8_t>(at), 90, 200, 128}};
  };
  for (std::uint64_t seed = 10; seed < 16; ++seed) {
    const given g = random_scene(seed);
    irg::image<irg::rgba8> picture[2][3];
    for (int k = 0; k < 2; ++k) {
      const batch b[] = {k == 0 ? g.good() : g.with_bad()};
      const auto shader = [&](const batch& of, std::uint32_t i, irg::facing) { return colour_of(g, of, i); };
      for (auto& p : picture[k]) p = irg::image<irg::rgba8>(width, height, {9, 9, 9, 255});
      depths depth(width, height, 0.0f);
      irg::shade_batches(irg::render_target{picture[k][0], depth}, {b, g.mapping}, shader);
      depth = depths(width, height, 0.0f);
      irg::draw_transparent(irg::render_target{picture[k][1], depth}, {b, g.mapping}, shader);
      irg::draw_transparent<irg::drawing_order, irg::depth_test::always, double>(
          irg::render_target{picture[k][2], depth}, {b, g.mapping}, shader);
    }
    for (int way = 0; way < 3; ++way) CHECK(picture[1][way] == picture[0][way]);
  }
}

TEST_CASE("indices: ... of occlusion masks, as occluders and as what is asked for") {
  for (std::uint64_t seed = 20; seed < 30; ++seed) {
    const given g = random_scene(seed);
    irg::occlusion_mask<> expected(width, height), mask(width, height), parallel(width, height);
    expected.draw<double>(g.vertices, g.scene.triangles, g.mapping, face_culling::none);
    mask.draw<double>(g.vertices, g.mixed, g.mapping, face_culling::none);
    parallel.draw<double>(g.vertices, g.mixed, g.mapping, face_culling::none, irg::parallel{3});
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        REQUIRE(mask.depth(x, y) == expected.depth(x, y));
        REQUIRE(parallel.depth(x, y) == expected.depth(x, y));
      }
    CHECK(mask.test(g.vertices, g.mixed, g.mapping) == mask.test(g.vertices, g.scene.triangles, g.mapping));
    std::vector<triangle_indices> bad;
    for (std::uint32_t i = 0; i < g.mixed.size(); ++i)
      if (std::find(g.place.begin(), g.place.end(), i) == g.place.end()) bad.push_back(g.mixed[i]);
    CHECK(irg::occlusion_mask<>(width, height).test(g.vertices, bad, g.mapping) == irg::occlusion::outside);
  }
}

TEST_CASE("indices: no vertices at all") {
  given g({{}, {}, test::square_view(0.125), 70, 9}, 0);
  for (std::uint32_t i = 0; i < 40; ++i) g.mixed.push_back({{i % 3 ? i : 0xffffffff, 0, i / 2}});
  check_visible(g, {face_culling::none, {}, irg::clearing::before_drawing}, irg::sequential{});
  irg::image<irg::rgba8> picture(70, 9, {1, 2, 3, 4});
  depths depth(70, 9, 0.0f);
  const batch b[] = {g.with_bad()};
  irg::draw_transparent(
      irg::render_target{picture, depth}, {b, g.mapping},
      [](const batch&, std::uint32_t, irg::facing) { return irg::solid_shader<irg::rgba8>{{255, 0, 0, 255}}; });
  CHECK(picture == irg::image<irg::rgba8>(70, 9, {1, 2, 3, 4}));
  irg::occlusion_mask<> mask(70, 9);
  CHECK(mask.draw<double>(g.vertices, g.mixed, g.mapping).drawn == 0);
  CHECK(mask.test(g.vertices, g.mixed, g.mapping) == irg::occlusion::outside);
}

TEST_CASE("indices: in constant evaluation, where nothing may be read that is not there") {
  constexpr bool same = [] {
    const given g(small_scene(), 7);
    ids a(7, 6, 0), b = a;
    depths depth_a(7, 6, 0.0f), depth_b = depth_a;
    irg::draw_visibility(
        {a, depth_a},
        irg::projected_triangles{g.vertices, std::span<const triangle_indices>(g.scene.triangles), g.mapping});
    irg::draw_visibility({b, depth_b},
                         irg::projected_triangles{g.vertices, std::span<const triangle_indices>(g.mixed), g.mapping});
    bool all = depth_a == depth_b;
    for (int i = 0; i < 42; ++i)
      all = all && (b(i % 7, i / 7) == 7) == (a(i % 7, i / 7) == 0 && depth_a(i % 7, i / 7) > 0);
    return all;
  }();
  CHECK(same);
}

TEST_CASE("indices: edges to vertices that are not there are no lines") {
  irg::mesh<double> good;
  good.positions = {{-1, -1, -2}, {1, -1, -2}, {1, 1, -2}, {-1, 1, -2}};
  irg::mesh<double> bad = good;
  irg::add_face(good, std::vector{0, 1, 2});
  irg::add_face(bad, std::vector<std::uint32_t>{0, 1, 2});
  irg::add_face(bad, std::vector<std::uint32_t>{2, 0xffffffff, 4});
  irg::add_face(bad, std::vector<std::uint32_t>{0x80000000, 7, 5, 4});
  const auto mapping = irg::map_to_screen<double>({40, 30});
  const auto vertices = irg::project_vertices<double>(good.positions, test::square_view(0.125), mapping);
  for (const face_culling culling : {face_culling::back, face_culling::none}) {
    irg::image<int> expected(40, 30, 0), drawn = expected;
    irg::draw_wireframe(expected, irg::projected_mesh{vertices, good, mapping}, 1, culling);
    irg::draw_wireframe(drawn, irg::projected_mesh{vertices, bad, mapping}, 1, culling);
    CHECK(drawn == expected);
  }
}
