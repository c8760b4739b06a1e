// SPDX-License-Identifier: MIT
#include <irg/render/render.hpp>

#include <bit>
#include <cstring>
#include <cstdlib>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/raster/window.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rendered.hpp"
#include "support/scenes.hpp"

namespace {

using point = irg::point<double, 3>;
constexpr irg::rgba8 background = irg::picture_colours{}.background;

constexpr irg::mesh<double> triangle_at(double z, double size = 1) {
  irg::mesh<double> m;
  m.positions = {{-size, -size, z}, {size, -size, z}, {0, size, z}};
  irg::add_face(m, std::vector<int>{0, 1, 2});
  return m;
}

constexpr irg::scene<double> scene_of(const std::vector<irg::mesh<double>>& shapes) {
  irg::scene<double> s;
  for (const auto& shape : shapes) {
    const double share = 1.0 / static_cast<double>(s.objects.size() + 1);
    s.objects.push_back({shape, irg::identity_matrix<double, 4>(), {{share, 1, 1}, {share, 1, 1}, {0.2, 0.2, 0.2}, 8}});
  }
  s.view.eye = {0, 0, 4};
  s.lights.push_back({{1, 2, 5, 1}, {1, 1, 1}});
  s.ambient = {0.1, 0.1, 0.1};
  return s;
}

constexpr irg::picture_style styles[] = {irg::picture_style::wire, irg::picture_style::flat,
                                         irg::picture_style::gouraud, irg::picture_style::phong};

// ---- one source, three lives

struct small_picture {
  irg::rgba8 colour[32][32];
  std::uint32_t depth[32][32]{};
  irg::render_counts stats;
};

constexpr irg::scene<double> crossing_triangles() {
  irg::scene<double> s = scene_of({triangle_at(0)});
  s.objects[0].shape.positions[2].z = -3;
  s.objects.push_back({triangle_at(-1, 2)});
  return s;
}

constexpr small_picture copied(const test::rendered& r) {
  small_picture p{};
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      p.colour[y][x] = r.picture.colour(x, y);
      p.depth[y][x] = std::bit_cast<std::uint32_t>(r.picture.depth(x, y));
    }
  p.stats = r.stats;
  return p;
}

static_assert(irg::render_options{} == irg::render_options{} &&
              irg::render_options{} != irg::render_options{irg::picture_style::flat});
static_assert(std::equality_comparable<irg::draw_options<irg::rgba8>> && std::equality_comparable<irg::screen_vertex> &&
              std::equality_comparable<irg::screen_mapping<float>>);

TEST_CASE("render: two lit, depth-tested triangles in a constant expression, with the bytes of run time") {
  static constexpr small_picture at_compile_time = copied(test::render_constant(crossing_triangles(), 32, 32));
  static_assert(at_compile_time.stats.triangles == 2 && at_compile_time.stats.skipped == irg::skip_counts{});
  static_assert(at_compile_time.stats.pixels.tested >
                at_compile_time.stats.drawn);  // some of one is hidden by the other
  static_assert(at_compile_time.stats.drawn > 300 && at_compile_time.colour[0][0] == background);
  static_assert(at_compile_time.colour[16][16] != background &&
                at_compile_time.colour[16][16] != at_compile_time.colour[20][16]);
  const small_picture at_run_time = copied(test::render(crossing_triangles(), 32, 32));
  CHECK(std::memcmp(at_compile_time.colour, at_run_time.colour, sizeof at_run_time.colour) == 0);
  CHECK(std::memcmp(at_compile_time.depth, at_run_time.depth, sizeof at_run_time.depth) == 0);
  CHECK(at_compile_time.stats == at_run_time.stats);
}

// ---- what is in the picture

TEST_CASE("render: an empty scene, an empty mesh and a scene behind the eye give the background") {
  irg::scene<double> empty;
  for (const auto style : styles)
    for (const auto hidden : {irg::hidden_surface_method::zbuffer, irg::hidden_surface_method::none})
      for (const auto& s : {empty, scene_of({irg::mesh<double>{}}), scene_of({triangle_at(9)})}) {
        const test::rendered r = test::render(s, 21, 40, {style, hidden});
        CHECK(r.stats.drawn == 0);
        CHECK(r.stats.pixels == irg::draw_counts{});
        for (int y = 0; y < 40; ++y)
          for (int x = 0; x < 21; ++x) {
            REQUIRE(r.picture.colour(x, y) == background);
            REQUIRE(r.picture.depth(x, y) == (hidden == irg::hidden_surface_method::none ? -1.0f : 0.0f));
          }
      }
}

TEST_CASE("render: an object without faces before others clears the picture all the same") {
  const auto alone = test::render(scene_of({triangle_at(0)}), 40, 80);
  auto s = scene_of({irg::mesh<double>{}, triangle_at(0)});
  s.objects[1].surface = scene_of({triangle_at(0)}).objects[0].surface;
  CHECK(test::render(s, 40, 80).picture == alone.picture);
}

TEST_CASE("render: 1 x 1, 65535 x 1, 1 x 65535 and pictures without pixels") {
  const auto s = scene_of({triangle_at(0)});
  for (const auto style : styles) {
    CHECK(test::render(s, 1, 1, {style}).stats.drawn == (style == irg::picture_style::wire ? 1 : 1));
    CHECK(test::render(s, 1, 65535, {style}).stats.drawn > 0);
    CHECK(test::render(s, 65535, 1, {style}).stats.triangles == 1);
    CHECK(test::render(s, 0, 7, {style}).stats == irg::render_counts{});
    CHECK(test::render(s, 7, 0, {style}).stats == irg::render_counts{});
  }
  CHECK(test::render(s, 65535, 1).stats.drawn > 0);
}

TEST_CASE("render: equal depths go to the first object, in drawing order to the last") {
  const auto both = scene_of({triangle_at(0), triangle_at(0)});
  auto first = both, second = both;
  first.objects.pop_back();
  second.objects.erase(second.objects.begin());
  for (const auto style : {irg::picture_style::flat, irg::picture_style::gouraud, irg::picture_style::phong}) {
    const auto r = test::render(both, 48, 32, {style});
    CHECK(r.picture == test::render(first, 48, 32, {style}).picture);
    CHECK(r.stats.pixels.ties == r.stats.drawn);
    CHECK(r.stats.triangles == 2);
    const irg::render_options none{style, irg::hidden_surface_method::none};
    const auto last = test::render(both, 48, 32, none);
    CHECK(last.picture == test::render(second, 48, 32, none).picture);
    CHECK(last.picture.colour != r.picture.colour);
    CHECK(last.stats.pixels.tested == 2 * last.stats.drawn);
    CHECK(last.stats.pixels.shaded == last.stats.drawn);  // only what stays visible
  }
}

TEST_CASE("render: what is nearer hides what is farther, in any order of the objects") {
  const auto front_first = scene_of({triangle_at(1, 0.5), triangle_at(0, 1)});
  auto back_first = front_first;
  std::swap(back_first.objects[0], back_first.objects[1]);
  for (const auto style : {irg::picture_style::flat, irg::picture_style::gouraud, irg::picture_style::phong}) {
    const auto a = test::render(front_first, 48, 48, {style}), b = test::render(back_first, 48, 48, {style});
    CHECK(a.picture == b.picture);
    CHECK(a.stats.drawn == b.stats.drawn);
    CHECK(a.stats.pixels.shaded == b.stats.pixels.shaded);
    const irg::render_options none{style, irg::hidden_surface_method::none};
    CHECK(test::render(front_first, 48, 48, none).picture.colour != a.picture.colour);
    CHECK(test::render(back_first, 48, 48, none).picture.colour == a.picture.colour);
  }
}

TEST_CASE("render: a back that is shown is lit as a front of the other direction would be") {
  for (const auto style : {irg::picture_style::flat, irg::picture_style::gouraud, irg::picture_style::phong}) {
    auto s = scene_of({triangle_at(0)});
    s.lights = {{{0.3, 0.4, 1, 0}, {1, 1, 1}}};  // from the viewer's side
    const auto front = test::render(s, 32, 32, {style});
    auto turned = s;
    turned.objects[0].shape.corners = {{0}, {2}, {1}};
    CHECK(test::render(turned, 32, 32, {style}).stats.drawn == 0);
    CHECK(test::render(turned, 32, 32, {style}).stats.skipped.backface == 1);
    const auto back = test::render(turned, 32, 32, {style, {}, irg::face_culling::none});
    CHECK(back.stats.drawn == front.stats.drawn);
    int darker = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {  // the corners' order differs, so the last bits may
        const irg::rgba8 p = front.picture.colour(x, y), q = back.picture.colour(x, y);
        REQUIRE(std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) <= 3);
        darker += q.r < 100;
      }
    CHECK(darker == 0);
  }
}

TEST_CASE("render: a two-sided polygon is two with opposite normals") {
  for (const auto style : {irg::picture_style::flat, irg::picture_style::gouraud, irg::picture_style::phong})
    for (const double side : {1.0, -1.0}) {
      auto sheet = scene_of({triangle_at(0)});
      sheet.lights = {{{0.3, 0.4, side, 0}, {1, 1, 1}}};
      sheet.view.eye = {0.2, 0.1, 4 * side};
      auto two_faces = sheet;
      two_faces.objects.push_back(sheet.objects[0]);
      two_faces.objects[1].shape.corners = {{0}, {2}, {1}};
      const auto one = test::render(sheet, 32, 32, {style, {}, irg::face_culling::none});
      const auto two = test::render(two_faces, 32, 32, {style});
      CHECK(one.stats.drawn > 20);
      CHECK(two.stats.drawn == one.stats.drawn);
      CHECK(two.stats.skipped.backface == 1);
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
          const irg::rgba8 p = one.picture.colour(x, y), q = two.picture.colour(x, y);
          REQUIRE(std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) <= 3);
          CHECK((one.picture.depth(x, y) == 0) == (two.picture.depth(x, y) == 0));
        }
    }
}

TEST_CASE("render: flat faces have one colour, of the course's reflection model at their centre") {
  const auto s = scene_of({triangle_at(0)});
  const auto r = test::render(s, 33, 33, {irg::picture_style::flat});
  const irg::rgb<double> light = irg::phong_model(s.objects[0].surface, irg::lighting<double>{s.ambient, s.lights},
                                                  s.view.eye, {point{0, -1.0 / 3, 0}, irg::vec<double, 3>{0, 0, 1}});
  const irg::rgba8 expected =
      irg::encode({static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b)});
  int seen = 0;
  for (int y = 0; y < 33; ++y)
    for (int x = 0; x < 33; ++x)
      if (r.picture.colour(x, y) != background) {
        REQUIRE(r.picture.colour(x, y) == expected);
        ++seen;
      }
  CHECK(seen == r.stats.drawn);
  CHECK(seen > 100);
}

TEST_CASE("render: Phong pixels are the reflection model at the pixel's own point, clipped triangles included") {
  // A floor under the eye that reaches behind it; every pixel's ray meets it in a known point.
  irg::mesh<double> floor;
  floor.positions = {{-40, -1, 40}, {40, -1, 40}, {0, -1, -80}};
  irg::add_face(floor, std::vector<int>{0, 1, 2});
  auto s = scene_of({floor});
  s.view = {{0, 0, 4}, {0, -0.5, 0}, {0, 1, 0}, irg::projection_kind::perspective, irg::pi<double> / 2, 0.001};
  s.lights[0].position = {1, 2, 3, 1};
  const auto r = test::render(s, 40, 40, {irg::picture_style::phong});
  const auto view = irg::look_at(s.view.eye, s.view.target, s.view.up);
  int compared = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const irg::vec<double, 3> in_camera{(x + 0.5 - 20) / 20, (20 - y - 0.5) / 20, -1};
      irg::vec<double, 3> ray{};  // the view matrix turned back
      for (int i = 0; i < 3; ++i)
        ray[i] = view(0, i) * in_camera.x + view(1, i) * in_camera.y + view(2, i) * in_camera.z;
      if (ray.y >= -0.1) continue;
      const point p = s.view.eye + ray * (-1 / ray.y);
      const auto light = irg::phong_model(s.objects[0].surface, irg::lighting<double>{s.ambient, s.lights}, s.view.eye,
                                          {p, irg::vec<double, 3>{0, 1, 0}});
      const irg::rgba8 q = r.picture.colour(x, y);
      const irg::rgba8 e =
          irg::encode({static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b)});
      REQUIRE(std::abs(q.r - e.r) + std::abs(q.g - e.g) + std::abs(q.b - e.b) <= 6);
      ++compared;
    }
  CHECK(compared > 500);
}

TEST_CASE("render: placement moves, turns and mirrors an object; fronts stay fronts") {
  auto s = scene_of({irg::shape_cube<double>()});
  for (auto& p : s.objects[0].shape.positions) p = p + irg::vec<double, 3>{-0.5, -0.5, -0.5};
  const auto plain = test::render(s, 64, 64);
  s.objects[0].placement = irg::scaling(irg::vec<double, 3>{-1, 1, 1});
  const auto mirrored = test::render(s, 64, 64);
  CHECK(mirrored.stats.drawn == plain.stats.drawn);
  CHECK(mirrored.stats.skipped.backface == plain.stats.skipped.backface);
  s.objects[0].placement = irg::translation(irg::vec<double, 3>{100, 0, 0});
  CHECK(test::render(s, 64, 64).stats.drawn == 0);
  CHECK(test::render(s, 64, 64).stats.skipped.frustum > 0);
}

TEST_CASE("render: the eye inside a body sees its inside when nothing is culled, and nothing when backs are") {
  auto s = scene_of({irg::shape_cube<double>()});
  s.view = {{0.5, 0.4, 0.6}, {0.1, 0.9, 0.2}, {0, 1, 0}, irg::projection_kind::perspective, 1.5};
  for (const auto style : {irg::picture_style::flat, irg::picture_style::gouraud, irg::picture_style::phong}) {
    CHECK(test::render(s, 50, 50, {style, {}, irg::face_culling::none}).stats.drawn == 2500);
    CHECK(test::render(s, 50, 50, {style}).stats.drawn == 0);
  }
}

TEST_CASE("render: a world scaled by a power of two gives the same colours, from 2^-400 to 2^400") {
  auto s = scene_of({irg::shape_cube<double>()});
  s.lights[0].position.w = 0;
  s.view.eye = {2, 1.5, 3};
  for (const auto style : styles) {
    const auto expected = test::render(s, 40, 30, {style});
    for (const int power : {-400, -150, -130, -20, 20, 130, 150, 400}) {
      auto t = s;
      const double scale = std::ldexp(1.0, power);
      for (auto& p : t.objects[0].shape.positions) p = {p.x * scale, p.y * scale, p.z * scale};
      t.view.eye = {2 * scale, 1.5 * scale, 3 * scale};
      t.view.near_distance *= scale;
      const auto r = test::render(t, 40, 30, {style});
      REQUIRE(r.picture == expected.picture);
      REQUIRE(r.stats == expected.stats);
    }
  }
}

// ---- skipping and executors

template <class T>
void skipping_changes_nothing(std::uint64_t seed, int scenes) {
  test::random r(seed);
  long long skipped = 0, drawn = 0;
  for (int i = 0; i < scenes; ++i) {
    const auto kind = static_cast<test::positions>(i % 3);
    const irg::scene<T> s = test::random_scene<T>(r, static_cast<int>(r.integer(0, 24)), kind);
    const int width = static_cast<int>(r.integer(1, 60)), height = static_cast<int>(r.integer(1, 100));
    irg::render_options options{styles[i / 3 % 4], {}, i / 12 % 2 ? irg::face_culling::back : irg::face_culling::none};
    if (i / 24 % 4 == 0) options.hidden = irg::hidden_surface_method::none;
    CAPTURE(i);
    const test::rendered on = test::render(s, width, height, options);
    options.skip = irg::skip_nothing;
    const test::rendered off = test::render(s, width, height, options);
    REQUIRE(on.picture == off.picture);
    REQUIRE(on.stats.pixels.shaded == off.stats.pixels.shaded);
    REQUIRE(on.stats.drawn == off.stats.drawn);
    REQUIRE(on.stats.triangles == off.stats.triangles);
    REQUIRE(off.stats.skipped.frustum + off.stats.skipped.tiny + off.stats.skipped.occluded == 0);
    if (options.culling == irg::face_culling::none) REQUIRE(off.stats.skipped.backface == 0);
    const auto& c = on.stats.skipped;
    REQUIRE(c.frustum + c.backface + c.tiny + c.occluded <= on.stats.triangles);
    skipped += c.frustum + c.tiny, drawn += on.stats.drawn;

    options.skip = {};
    const auto same = [&](const test::rendered& other) {
      REQUIRE(other.picture == on.picture);
      REQUIRE(other.stats == on.stats);
    };
    same(test::render(s, width, height, options, test::backwards{}));
    if (i % 8 == 0)
      for (int threads = 1; threads <= 16; threads += 1 + threads / 3)
        same(test::render(s, width, height, options, irg::parallel{threads}));
  }
  MESSAGE(scenes, " scenes, ", drawn, " pixels drawn, ", skipped, " triangles skipped");
  CHECK(skipped > scenes);
  CHECK(drawn > 100 * scenes);
}

TEST_CASE("render: skipping and the executor change no byte and no count, on doubles") {
  skipping_changes_nothing<double>(11, std::getenv("IRG_RELEASE_TIER") ? 100000 : 1200);
}

TEST_CASE("render: skipping and the executor change no byte and no count, on floats") {
  skipping_changes_nothing<float>(12, std::getenv("IRG_RELEASE_TIER") ? 100000 : 1200);
}

TEST_CASE("render: observers hear of every stage of every object, and change nothing") {
  const auto s = scene_of({triangle_at(0), triangle_at(-1)});
  for (const auto style : styles) {
    std::vector<irg::render_stage> heard;
    const auto observed =
        test::render(s, 20, 20, {style}, {}, [&](irg::render_stage stage) { heard.push_back(stage); });
    using enum irg::render_stage;
    const std::vector<irg::render_stage> once =
        style == irg::picture_style::wire ? std::vector{project, draw} : std::vector{prepare, shade, project, draw};
    // Each object is made ready; all are drawn at once, but for wires.
    std::vector<irg::render_stage> twice = once;
    if (style != irg::picture_style::wire) twice.pop_back();
    twice.insert(twice.end(), once.begin(), once.end());
    CHECK(heard == twice);
    CHECK(observed.picture == test::render(s, 20, 20, {style}).picture);
  }
}

TEST_CASE("render: draws into views, upside down too") {
  const auto s = scene_of({triangle_at(0)});
  const auto expected = test::render(s, 24, 17);
  std::vector<irg::rgba8> memory(30 * 17, irg::rgba8{7, 7, 7, 7});
  irg::image_view<irg::rgba8> bottom_up(memory.data() + 16 * 30, 24, 17,
                                        -30 * static_cast<std::ptrdiff_t>(sizeof(irg::rgba8)));
  irg::image<float> depth(24, 17);
  CHECK(test::render_into(bottom_up, depth, s) == expected.stats);
  for (int y = 0; y < 17; ++y)
    for (int x = 0; x < 30; ++x)
      REQUIRE(memory[static_cast<std::size_t>((16 - y) * 30 + x)] ==
              (x < 24 ? expected.picture.colour(x, y) : irg::rgba8{7, 7, 7, 7}));
}

TEST_CASE("render: of a picture within a window nothing else is touched") {
  const auto s = scene_of({triangle_at(0)});
  const irg::cell_window window{30, 20, 70, 50};
  for (const auto style : {irg::picture_style::gouraud, irg::picture_style::wire}) {
    irg::image<irg::rgba8> picture(80, 70, {7, 7, 7, 7});
    irg::image<float> depth(80, 70);
    const auto part = irg::within(picture, window);
    irg::render(s, irg::render_target{part, depth}, {.style = style});
    const auto whole = test::render(s, 80, 70, {.style = style});
    for (int y = 0; y < 70; ++y)
      for (int x = 0; x < 80; ++x) {
        const bool is_in = x >= 30 && x < 70 && y >= 20 && y < 50;
        REQUIRE(picture(x, y) == (is_in ? whole.picture.colour(x, y) : irg::rgba8{7, 7, 7, 7}));
      }
  }
}

template <class Colour, class Depth>
concept renders_into = requires(const irg::scene<double>& s, Colour& colour, Depth& depth) {
  irg::render(s, {colour, depth}, {.style = irg::picture_style::flat});
};
using pixels = irg::image<irg::rgba8>;
using depths = irg::image<float>;
static_assert(renders_into<pixels, depths> && renders_into<pixels, irg::image_view<float>>);
static_assert(renders_into<irg::image_view<irg::rgba8>, depths>);
static_assert(renders_into<const irg::image_view<irg::rgba8>, irg::image_view<float>>);
static_assert(!renders_into<depths, pixels> && !renders_into<const pixels, depths>);
static_assert(!renders_into<irg::image<irg::rgb8>, depths>);

}  // namespace
