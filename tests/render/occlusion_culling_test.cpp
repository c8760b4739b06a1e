// SPDX-License-Identifier: MIT
// Objects that occlusion culling leaves out show no pixel when they are drawn, and the picture is the same without them.
#include <irg/render/occlusion_culling.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/render/visibility_buffer.hpp>
#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rendered.hpp"

namespace {

using irg::face_culling;
using irg::triangle_indices;

bool release_tier() { return std::getenv("IRG_RELEASE_TIER") != nullptr; }

// -------------------------------------------------------------------------------------- objects, and drawing them

template <class T>
struct body {
  std::vector<irg::point<T, 3>> positions{};
  std::vector<triangle_indices> triangles{};

  irg::occludable_object<T> object() const {
    irg::box<T, 3> b;
    for (const auto& p : positions) b = irg::bounding_box(b, p);
    return {b, positions, triangles};
  }
};

template <class T>
struct body_scene {
  int width = 0, height = 0;
  face_culling culling = face_culling::back;
  irg::mat<T, 4, 4> to_clip{};
  std::vector<body<T>> bodies{};

  std::vector<irg::occludable_object<T>> objects() const {
    std::vector<irg::occludable_object<T>> all;
    for (const body<T>& b : bodies) all.push_back(b.object());
    return all;
  }
};

// The object that each pixel shows, and its depth; with these objects alone.
struct object_picture {
  irg::image<std::uint32_t> object;
  irg::image<float> depth;
  bool operator==(const object_picture&) const = default;
};

template <class Order, class T>
object_picture draw_objects(const body_scene<T>& s, std::span<const std::uint32_t> which,
                            const irg::skip_options& skip) {
  object_picture p{irg::image<std::uint32_t>(s.width, s.height, 0), irg::image<float>(s.width, s.height, 0)};
  if (s.width == 0 || s.height == 0) return p;
  const auto mapping = irg::map_to_screen<T>({s.width, s.height});
  std::vector<irg::projected_vertices<T>> vertices;
  std::vector<irg::triangle_batch<T>> batches;
  std::vector<std::uint32_t> object_of;
  vertices.reserve(which.size());
  for (const std::uint32_t i : which) {
    const body<T>& b = s.bodies[i];
    vertices.push_back(irg::project_vertices<T>(b.positions, s.to_clip, mapping));
    batches.push_back({&vertices.back(), b.triangles, static_cast<std::uint32_t>(object_of.size())});
    object_of.insert(object_of.end(), b.triangles.size(), i);
  }
  irg::draw_visibility<Order, T>({p.object, p.depth}, {batches, mapping},
                                 {s.culling, skip, irg::clearing::before_drawing});
  for (int y = 0; y < s.height; ++y)
    for (int x = 0; x < s.width; ++x)
      if (p.object(x, y) != irg::no_index) p.object(x, y) = object_of[p.object(x, y)];
  return p;
}

template <class T>
std::vector<std::uint32_t> all_of(const body_scene<T>& s) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < s.bodies.size(); ++i) all.push_back(i);
  return all;
}

// -------------------------------------------------------------------------------------- random scenes

// Things of which some hide others: walls, floors that reach behind the eye, bodies, and what is meant to do harm.
template <class T>
struct scene_maker {
  test::random r;
  irg::vec<double, 2> view{0.7, 0.5};  // half of what is seen at distance 1

  double real(double low, double high) { return low + (high - low) * r.unit(); }
  static irg::point<T, 3> at(double x, double y, double z) {
    return {static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)};
  }

  // Columns times rows of quadrilaterals over four corners, counter-clockwise.
  body<T> sheet(const irg::point<T, 3> (&c)[4], std::uint32_t n) {
    body<T> b;
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t i = 0; i <= n; ++i) {
        const T s = static_cast<T>(i) / static_cast<T>(n), t = static_cast<T>(j) / static_cast<T>(n);
        const auto low = c[0] + (c[1] - c[0]) * s, high = c[3] + (c[2] - c[3]) * s;
        b.positions.push_back(low + (high - low) * t);
      }
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = j * (n + 1) + i;
        b.triangles.push_back({{a, a + 1, a + n + 2}});
        b.triangles.push_back({{a, a + n + 2, a + n + 1}});
      }
    if (r.integer(0, 7) == 0)  // turned away
      for (triangle_indices& t : b.triangles) t = {{t.v[0], t.v[2], t.v[1]}};
    return b;
  }
  body<T> wall(double distance, double share) {
    const double x = real(-1, 1) * view.x * distance, y = real(-1, 1) * view.y * distance;
    const double w = real(0.2, share) * view.x * distance, h = real(0.2, share) * view.y * distance;
    const double tilt = r.integer(0, 2) == 0 ? real(-0.3, 0.3) * distance : 0, z = -distance;
    return sheet({at(x - w, y - h, z - tilt), at(x + w, y - h, z), at(x + w, y + h, z + tilt), at(x - w, y + h, z)},
                 static_cast<std::uint32_t>(r.integer(1, 3)));
  }
  body<T> floor() {
    const double y = real(-3, -0.2), side = real(2, 40);
    return sheet({at(-side, y, real(-1.5, 5)), at(side, y, 3), at(side, y, -real(5, 300)), at(-side, y, -50)},
                 static_cast<std::uint32_t>(r.integer(1, 3)));
  }
  // Triangles without any order in a cube.
  body<T> crumbs(double distance, double size) {
    body<T> b;
    const double x = real(-1.1, 1.1) * view.x * distance, y = real(-1.1, 1.1) * view.y * distance;
    const auto n = static_cast<std::uint32_t>(r.integer(1, 12));
    for (std::uint32_t i = 0; i < 3 * n; ++i) {
      const double dx = real(-1, 1) * size, dy = real(-1, 1) * size, dz = real(-1, 1) * size;
      b.positions.push_back(at(x + dx, y + dy, dz - distance));
    }
    for (std::uint32_t i = 0; i < n; ++i) b.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}});
    return b;
  }

  body_scene<T> operator()(int objects) {
    body_scene<T> s{static_cast<int>(r.integer(1, 160)), static_cast<int>(r.integer(1, 120))};
    if (r.integer(0, 2) == 0) s.culling = face_culling::none;
    const double far_distance = r.integer(0, 1) == 0 ? 60 : std::numeric_limits<double>::infinity();
    s.to_clip = irg::perspective(static_cast<T>(2 * std::atan(view.y)), static_cast<T>(view.x / view.y), T(1),
                                 static_cast<T>(far_distance));
    double distance = 4;
    for (int i = 0; i < objects; ++i) {
      const auto kind = r.integer(0, 15);
      if (kind <= 2) s.bodies.push_back(wall(distance = real(2, 20), 1.6));
      if (kind == 3) s.bodies.push_back(wall(distance, 0.5));  // in the plane of the last one
      if (kind == 4) s.bodies.push_back(floor());
      if (kind >= 5 && kind <= 9) {
        distance = real(3, 50);
        s.bodies.push_back(crumbs(distance, distance * real(0.005, 0.2)));
      }
      if (kind == 10) s.bodies.push_back(crumbs(distance, distance * 0x1p-20));
      if (kind == 11) {  // about the near plane or the eye
        const double away = real(0.5, 1.5);
        s.bodies.push_back(crumbs(away, real(0.01, 2)));
      }
      if (kind == 12) s.bodies.push_back(crumbs(real(40, 80), 5));  // about the far plane
      if (kind == 13) s.bodies.push_back({});
      if (kind == 14) s.bodies.push_back(r.integer(0, 3) == 0 ? wall(0.001, 1e7) : wall(3, 100));  // beyond the guard
      if (kind == 15) {  // hostile
        body<T> b = crumbs(distance, 1);
        using limits = std::numeric_limits<T>;
        const T odd[5] = {limits::quiet_NaN(), limits::infinity(), -limits::infinity(), limits::max(),
                          limits::lowest()};
        b.positions[static_cast<std::size_t>(r.integer(0, 2))][static_cast<int>(r.integer(0, 2))] =
            odd[r.integer(0, 4)];
        if (r.integer(0, 1) == 0) b.triangles.back().v[1] = 1000;  // no such vertex
        s.bodies.push_back(b);
      }
    }
    return s;
  }
};

struct tally {
  int scenes = 0, objects = 0, hidden = 0, beyond = 0, unseen = 0;
};

template <class Order, class T>
void never_leaves_out_what_is_seen(std::uint64_t seed, int scenes) {
  scene_maker<T> make{test::random(seed)};
  tally sum;
  for (int i = 0; i < scenes; ++i) {
    CAPTURE(i);
    const body_scene<T> s = make(static_cast<int>(make.r.integer(2, 40)));
    const auto objects = s.objects();
    const object_picture all = draw_objects<Order>(s, all_of(s), irg::skip_nothing);
    std::vector<std::uint8_t> seen(s.bodies.size(), 0);
    for (int y = 0; y < s.height; ++y)
      for (int x = 0; x < s.width; ++x)
        if (all.object(x, y) != irg::no_index) seen[all.object(x, y)] = 1;

    irg::occlusion_culling<T, Order> culling(s.to_clip, {s.width, s.height});
    std::vector<std::uint32_t> kept;
    if (i % 2 == 0) {  // those chosen hide
      kept = culling.visible_objects(objects, s.culling);
    } else {  // all hide
      for (const auto& o : objects) culling.add_occluder(o.positions, o.triangles, s.culling);
      for (std::uint32_t k = 0; k < objects.size(); ++k)
        if (!culling.hides(objects[k].bounds)) kept.push_back(k);
    }
    std::vector<std::uint8_t> left_out(s.bodies.size(), 1);
    for (const std::uint32_t k : kept) left_out[k] = 0;
    for (std::size_t k = 0; k < left_out.size(); ++k) {
      CAPTURE(k);
      if (left_out[k] != 0) REQUIRE(seen[k] == 0);
      sum.hidden += culling.hides(objects[k].bounds);
      sum.beyond += left_out[k] != 0 && !culling.hides(objects[k].bounds);
      sum.unseen += seen[k] == 0;
    }
    REQUIRE(draw_objects<Order>(s, kept, {}) == all);
    ++sum.scenes;
    sum.objects += static_cast<int>(objects.size());
  }
  MESSAGE(sum.scenes, " scenes of ", sum.objects, " objects: ", sum.unseen, " show no pixel, of which ", sum.hidden,
          " were found hidden and ", sum.beyond, " beyond the frustum");
  CHECK(test::enough(sum.hidden * 5 > sum.objects / 4));
}

TEST_CASE("occlusion culling: what it leaves out shows no pixel") {
  const int n = release_tier() ? 20000 : 400;
  never_leaves_out_what_is_seen<irg::nearer_is_greater, float>(1, n);
  never_leaves_out_what_is_seen<irg::nearer_is_greater, double>(2, n);
  never_leaves_out_what_is_seen<irg::nearer_is_less, float>(3, n / 4);
}

// -------------------------------------------------------------------------------------- the mask by itself

TEST_CASE("occlusion culling: the mask of blocks against the depths that drawing leaves") {
  test::random r(5);
  long long whole = 0, drawn_blocks = 0;
  for (int i = 0; i < (release_tier() ? 20000 : 500); ++i) {
    const int width = static_cast<int>(r.integer(1, 100)), height = static_cast<int>(r.integer(1, 70));
    irg::detail::block_mask m;
    irg::detail::clear_block_mask(m, width, height, 1, 0);
    irg::image<float> depth(width, height, 0);
    irg::image<std::uint32_t> unused(width, height, 0);
    const int count = static_cast<int>(r.integer(1, 6)), reach = r.integer(0, 3) == 0 ? 30000 : 150;
    for (int k = 0; k < count; ++k) {
      irg::screen_vertex v[3];
      for (auto& p : v) {
        p.position = {static_cast<std::int32_t>(r.integer(-reach, reach) * 256 + r.integer(0, 255)),
                      static_cast<std::int32_t>(r.integer(-reach, reach) * 256 + r.integer(0, 255))};
        p.depth = static_cast<float>(r.integer(0, 1) == 0 ? 0.25 + r.unit() * 0.01 : r.unit());
      }
      irg::detail::draw_block_mask(m, v[0], v[1], v[2]);
      irg::shade_triangle(unused, depth, {v[0], v[1], v[2]}, [](const auto&) { return std::uint32_t{0}; });
    }
    for (int by = 0; by < m.down; ++by)
      for (int bx = 0; bx < m.across; ++bx) {
        const std::size_t b = m.at(bx, by);
        float farthest = 1;
        for (int y = 8 * by; y < irg::minimum(8 * by + 8, height); ++y)
          for (int x = 8 * bx; x < irg::minimum(8 * bx + 8, width); ++x) {
            farthest = irg::minimum(depth(x, y), farthest);
            if ((m.layer[b] >> (y % 8 * 8 + x % 8) & 1) != 0) REQUIRE(depth(x, y) >= m.layer_key[b]);
          }
        REQUIRE(farthest >= m.farthest_key[b]);
        drawn_blocks += farthest > 0;
        whole += m.farthest_key[b] > 0;
        if (count == 1 && farthest > 0) REQUIRE(m.farthest_key[b] > 0);
      }
  }
  MESSAGE(whole, " blocks with a farthest depth, of ", drawn_blocks, " that are covered");
  CHECK(whole * 10 > drawn_blocks * 9);
}

// -------------------------------------------------------------------------------------- by hand

// A wall of two triangles at distance 4 over the whole of a picture of 64 x 64, which is 4 wide there.
template <class T>
constexpr irg::mat<T, 4, 4> square_view() {
  return irg::perspective(T(0.9272952180016122), T(1), T(1), T(100));
}
constexpr irg::point<double, 3> wall_corners[4] = {{-3, -3, -4}, {3, -3, -4}, {3, 3, -4}, {-3, 3, -4}};
constexpr triangle_indices wall_triangles[2] = {{{0, 1, 2}}, {{0, 2, 3}}};
constexpr triangle_indices wall_turned_away[2] = {{{0, 2, 1}}, {{0, 3, 2}}};

constexpr irg::box<double, 3> cube(double x, double y, double z, double half) {
  return {{x - half, y - half, z - half}, {x + half, y + half, z + half}};
}
constexpr bool hidden_by_wall(const irg::box<double, 3>& b,
                              std::span<const triangle_indices> triangles = wall_triangles,
                              face_culling culling = face_culling::back) {
  irg::occlusion_culling<double> c(square_view<double>(), {64, 64});
  c.add_occluder(wall_corners, triangles, culling);
  return c.hides(b);
}

TEST_CASE("occlusion culling: boxes by hand") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK_BOTH(hidden_by_wall(cube(0, 0, -6, 1)));
  CHECK_BOTH(!hidden_by_wall(cube(0, 0, -3, 0.5)));  // before it
  CHECK_BOTH(!hidden_by_wall(cube(0, 0, -4, 0.5)));  // through it
  CHECK_BOTH(hidden_by_wall({{-1, -1, -5}, {1, 1, -4.001}}));
  CHECK_BOTH(!hidden_by_wall({{-1, -1, -5}, {1, 1, -4}}));  // touches it: as near
  CHECK_BOTH(!hidden_by_wall({{-1, -1, -4}, {1, 1, -4}}));  // in it
  CHECK_BOTH(!hidden_by_wall(cube(0, 0, -6, 7)));  // about the eye
  CHECK_BOTH(!hidden_by_wall(cube(0, 0, -100, 1)));  // through the far plane
  CHECK_BOTH(!hidden_by_wall({}));
  CHECK_BOTH(!hidden_by_wall({{nan, 0, -6}, {1, 1, -5}}));
  CHECK_BOTH(!hidden_by_wall({{-1, -1, -6}, {1, 1, nan}}));
  CHECK_BOTH(!hidden_by_wall({{-1, -1, -infinity}, {1, 1, -5}}));
  CHECK_BOTH(!hidden_by_wall(cube(0, 0, -6, 1), wall_turned_away));
  CHECK(hidden_by_wall(cube(0, 0, -6, 1), wall_turned_away, face_culling::none));
  // Half of a wall hides what is behind that half; the edge runs through blocks.
  const std::span<const triangle_indices> half(wall_triangles, 1);
  CHECK(hidden_by_wall(cube(1.3, -1.3, -6, 0.5), half));
  CHECK(!hidden_by_wall(cube(0, 0, -6, 0.5), half));
  CHECK(!hidden_by_wall(cube(-1.3, 1.3, -6, 0.5), half));
}

TEST_CASE("occlusion culling: nothing to choose from, no picture, one pixel") {
  using culling_of = irg::occlusion_culling<float>;
  const auto view = square_view<float>();
  CHECK(culling_of(view, {64, 64}).choose_occluders({}).empty());
  CHECK(culling_of(view, {64, 64}).visible_objects({}).empty());
  const irg::object_extent<float> large{{{-9, -9, -5}, {9, 9, -4}}, 2}, detailed{{{-9, -9, -5}, {9, 9, -4}}, 5000};
  const irg::object_extent<float> two[2] = {detailed, large}, none[2] = {detailed, {{}, 0}};
  CHECK(culling_of(view, {64, 64}).choose_occluders({&large, 1}).empty());
  CHECK(culling_of(view, {64, 64}).choose_occluders(two) == std::vector<std::uint32_t>{1});
  CHECK(culling_of(view, {64, 64}).choose_occluders(none).empty());
  scene_maker<float> make{test::random(9)};
  for (const auto& [width, height] : {std::pair{0, 0}, {0, 5}, {5, 0}, {1, 1}, {1, 100}}) {
    body_scene<float> s = make(60);
    s.width = width;
    s.height = height;
    culling_of c(s.to_clip, {width, height});
    const auto objects = s.objects();
    for (const auto& o : objects) c.add_occluder(o.positions, o.triangles);
    std::vector<std::uint32_t> kept;
    for (std::uint32_t k = 0; k < objects.size(); ++k)
      if (!c.hides(objects[k].bounds)) kept.push_back(k);
    if (width == 0 || height == 0) CHECK(kept.size() == objects.size());
    s.culling = face_culling::back;
    CHECK(draw_objects<irg::nearer_is_greater>(s, kept, {}) ==
          draw_objects<irg::nearer_is_greater>(s, all_of(s), irg::skip_nothing));
  }
}

TEST_CASE("occlusion culling: forgotten occluders hide nothing, and the memory serves again") {
  irg::occlusion_culling<double> c(square_view<double>(), {64, 64});
  const irg::box<double, 3> behind = cube(0, 0, -6, 1);
  CHECK(!c.hides(behind));
  c.add_occluder(wall_corners, wall_triangles);
  CHECK(c.hides(behind));
  c.clear();
  CHECK(!c.hides(behind));
  c.add_occluder(wall_corners, std::span(wall_triangles).first(1));
  CHECK(!c.hides(behind));
}

// -------------------------------------------------------------------------------------- as render uses it

// A wall of one quadrilateral, and bodies behind and beside it.
template <class T>
irg::scene<T> walled_scene(int hidden, int seen) {
  irg::scene<T> s;
  s.view.eye = {0, 0, 10};
  s.view.target = {0, 0, 0};
  s.lights = {{{T(3), T(4), T(5), T(1)}, {T(1), T(1), T(1)}}};
  irg::mesh<T> wall;
  wall.positions = {{-4, -9, 2}, {9, -9, 2}, {9, 9, 2}, {-4, 9, 2}};
  for (std::uint32_t i = 0; i < 4; ++i) wall.corners.push_back({i, irg::no_index});
  wall.face_starts = {0, 4};
  const auto ball = irg::shape_sphere<T>({.slices = 10, .stacks = 6});
  const auto add = [&](T x, T y, T z) {
    s.objects.push_back(
        {ball, irg::translation(irg::vec<T, 3>{x, y, z}) * irg::scaling(irg::vec<T, 3>{T(0.2), T(0.2), T(0.2)})});
  };
  for (int i = 0; i < hidden / 2; ++i) add(static_cast<T>(i % 4), static_cast<T>(i % 3), T(-1));
  s.objects.push_back({wall});
  for (int i = hidden / 2; i < hidden; ++i) add(static_cast<T>(i % 4), -static_cast<T>(i % 3), T(-2));
  for (int i = 0; i < seen; ++i) add(static_cast<T>(i % 4), static_cast<T>(i % 3), T(4));
  return s;
}
constexpr std::int64_t ball_triangles = 2 * 10 * (6 - 1);

TEST_CASE("render: objects behind a wall are counted as occluded, and the bytes are the same") {
  const irg::scene<double> s = walled_scene<double>(20, 3);
  for (const irg::picture_style style :
       {irg::picture_style::flat, irg::picture_style::gouraud, irg::picture_style::phong}) {
    const irg::render_options on{.style = style};
    irg::render_options off = on, frustum_off = on, unordered = on;
    off.skip = irg::skip_nothing;
    frustum_off.skip.frustum = irg::skipping::off;
    unordered.hidden = irg::hidden_surface_method::none;
    const test::rendered with = test::render(s, 160, 120, on), without = test::render(s, 160, 120, off);
    CHECK(with.picture == without.picture);
    CHECK(test::render(s, 160, 120, frustum_off).picture == without.picture);
    CHECK(with.stats.triangles == 23 * ball_triangles + 2);
    CHECK(without.stats.triangles == with.stats.triangles);
    CHECK(with.stats.skipped.occluded >= 20 * ball_triangles);
    CHECK(with.stats.skipped.occluded < 21 * ball_triangles);
    CHECK(with.stats.pixels.shaded == without.stats.pixels.shaded);
    CHECK(with.stats.drawn == without.stats.drawn);
    // In drawing order nothing is hidden.
    CHECK(test::render(s, 160, 120, unordered).stats.skipped.occluded == 0);
    for (int threads = 1; threads <= 3; ++threads) {
      const test::rendered r = test::render(s, 160, 120, on, irg::parallel{threads});
      CHECK(r.picture == with.picture);
      CHECK(r.stats == with.stats);
    }
  }
}

TEST_CASE("render: an object in the plane of a wall is seen if it comes first") {
  for (const bool first : {true, false}) {
    irg::scene<double> s = walled_scene<double>(6, 0);
    irg::object<double> patch = s.objects[3];
    REQUIRE(patch.shape.face_count() == 1);
    patch.shape.positions = {{-1, -1, 2}, {2, -1, 2}, {2, 1, 2}, {-1, 1, 2}};
    patch.surface.diffuse = {1, 0, 0};
    s.objects.insert(first ? s.objects.begin() : s.objects.end(), patch);
    const test::rendered with = test::render(s, 160, 120),
                         without = test::render(s, 160, 120, {.skip = irg::skip_nothing});
    CHECK(with.picture == without.picture);
    CHECK(with.stats.skipped.occluded >= 6 * ball_triangles);
    const irg::rgba8 there = with.picture.colour(80, 60);
    CHECK((there.g == there.r) == !first);
  }
}

// Many objects without any order; each of them moved, turned and perhaps mirrored by its placement.
template <class T>
irg::scene<T> random_objects(test::random& r) {
  irg::scene<T> s = walled_scene<T>(0, 0);
  scene_maker<T> make{test::random(r.next())};
  s.view.eye = {0, 0, 0};
  s.view.target = {0, 0, -1};
  s.view.near_distance = T(1);
  s.objects.clear();
  for (const body<T>& b : make(static_cast<int>(r.integer(2, 40))).bodies) {
    irg::object<T> o;
    o.placement = irg::rotation_z(static_cast<T>(r.integer(0, 3)));
    if (r.integer(0, 3) == 0) o.placement = o.placement * irg::scaling(irg::vec<T, 3>{-1, 1, 1});
    o.shape.positions = b.positions;
    for (const triangle_indices& t : b.triangles) {
      if (t.v[1] == 1000) continue;
      for (const std::uint32_t v : t.v) o.shape.corners.push_back({v, irg::no_index});
      o.shape.face_starts.push_back(static_cast<std::uint32_t>(o.shape.corners.size()));
    }
    s.objects.push_back(o);
  }
  return s;
}

template <class T>
void renders_the_same(std::uint64_t seed, int scenes) {
  test::random r(seed);
  std::int64_t occluded = 0, triangles = 0;
  for (int i = 0; i < scenes; ++i) {
    CAPTURE(i);
    const irg::scene<T> s = random_objects<T>(r);
    const int width = static_cast<int>(r.integer(1, 140)), height = static_cast<int>(r.integer(1, 100));
    irg::render_options on{.style = static_cast<irg::picture_style>(r.integer(1, 3))};
    if (r.integer(0, 2) == 0) on.culling = face_culling::none;
    if (r.integer(0, 3) == 0) on.intensities = irg::intensity_range::rescale;
    irg::render_options off = on;
    off.skip = irg::skip_nothing;
    const test::rendered with = test::render(s, width, height, on, irg::parallel{i % 3 + 1}),
                         without = test::render(s, width, height, off);
    REQUIRE(with.picture == without.picture);
    REQUIRE(with.stats.triangles == without.stats.triangles);
    REQUIRE(with.stats.drawn == without.stats.drawn);
    REQUIRE(without.stats.skipped.occluded == 0);
    occluded += with.stats.skipped.occluded;
    triangles += with.stats.triangles;
  }
  MESSAGE(occluded, " of ", triangles, " triangles occluded");
  CHECK(occluded * 10 > triangles);
}

TEST_CASE("render: random scenes of many objects, the same bytes with skips and without") {
  const int n = release_tier() ? 5000 : 150;
  renders_the_same<double>(21, n);
  renders_the_same<float>(22, n);
}

}  // namespace
