// SPDX-License-Identifier: MIT
// What an occlusion mask calls occluded changes no pixel when it is drawn; the mask's depths against those of drawing.
#include <irg/render/occlusion_mask.hpp>

#include <cmath>

#include <irg/core/threads.hpp>
#include <irg/render/draw_depth.hpp>

#include "support/check_both.hpp"
#include "support/ulp.hpp"
#include "support/visible_scenes.hpp"

namespace {

using irg::face_culling;
using irg::occlusion;
using test::scene_kind;
using test::triangle_scene;

// A scene, projected, and its depths as they are drawn.
template <class Order, class T>
struct drawn_scene {
  std::vector<irg::point<T, 3>> positions;
  irg::mat<T, 4, 4> to_clip;
  irg::screen_mapping<T> mapping;
  irg::projected_vertices<T> vertices;
  irg::image<float> depth;

  drawn_scene(const triangle_scene& s, face_culling culling)
      : positions(test::positions_in<T>(s)), to_clip(test::matrix_in<T>(s)),
        mapping(irg::map_to_screen<T>({s.width, s.height})),
        vertices(irg::project_vertices<T>(positions, to_clip, mapping)), depth(s.width, s.height, 0.5f) {
    irg::draw_depth<Order, T>(depth, {vertices, s.triangles, mapping}, {culling, {}, irg::clearing::before_drawing});
  }

  // Whether triangles, drawn into a copy, change a pixel.
  bool changed_by(std::span<const irg::point<T, 3>> corners, std::span<const irg::triangle_indices> triangles) const {
    irg::image<float> copy = depth;
    const auto v = irg::project_vertices<T>(corners, to_clip, mapping);
    irg::draw_depth<Order, T>(copy, {v, triangles, mapping}, {face_culling::none, {}, irg::clearing::none});
    return !(copy == depth);
  }
};

constexpr irg::triangle_indices box_triangles[12] = {{{0, 1, 3}}, {{0, 3, 2}}, {{4, 5, 7}}, {{4, 7, 6}},
                                                     {{0, 1, 5}}, {{0, 5, 4}}, {{2, 3, 7}}, {{2, 7, 6}},
                                                     {{0, 2, 6}}, {{0, 6, 4}}, {{1, 3, 7}}, {{1, 7, 5}}};

template <class T>
std::array<irg::point<T, 3>, 8> corners_of(const irg::box<T, 3>& b) {
  std::array<irg::point<T, 3>, 8> c;
  for (std::size_t i = 0; i < 8; ++i)
    c[i] = {(i & 1) != 0 ? b.high.x : b.low.x, (i & 2) != 0 ? b.high.y : b.low.y, (i & 4) != 0 ? b.high.z : b.low.z};
  return c;
}

template <class T>
irg::box<T, 3> random_box(test::random& r, int width, int height) {
  const auto middle = test::seen_at(r.integer(-100, width * 1024 + 100), r.integer(-100, height * 1024 + 100),
                                    r.integer(900, r.integer(0, 2) == 0 ? 1 << 17 : 1 << 14), width, height);
  const double size = -middle.z / static_cast<double>(std::int64_t{1} << r.integer(1, 9));
  const auto extent = [&] { return r.integer(0, 9) == 0 ? 0.0 : size * static_cast<double>(r.integer(1, 16)) / 16; };
  const double ex = extent(), ey = extent(), ez = extent();
  return {{static_cast<T>(middle.x - ex), static_cast<T>(middle.y - ey), static_cast<T>(middle.z - ez)},
          {static_cast<T>(middle.x + ex), static_cast<T>(middle.y + ey), static_cast<T>(middle.z + ez)}};
}

struct tally {
  long long visible = 0, occluded = 0, outside = 0, needless = 0;
};

// Boxes over scenes of every kind: nothing that the mask hides is seen.
template <class Order, class T>
void never_hides(std::uint64_t seed, int scenes, int boxes) {
  test::random r(seed);
  tally sum;
  for (int i = 0; i < scenes; ++i) {
    const int width = static_cast<int>(r.integer(20, 200)), height = static_cast<int>(r.integer(20, 150));
    const auto kind = static_cast<scene_kind>(i % (test::scene_kinds + 1));
    const bool sheets = kind == scene_kind::sheets || i % 3 == 0;
    triangle_scene s = test::scene_maker(r, sheets ? scene_kind::sheets : kind, width, height)(sheets ? 400 : 60);
    if (Order::nearer(0.0f, 1.0f)) s.to_clip = test::square_view<Order>(0.125, 64);
    const drawn_scene<Order, T> d(s, face_culling::none);
    irg::occlusion_mask<Order> mask(width, height);
    mask.template draw<T>(d.vertices, s.triangles, d.mapping, face_culling::none);
    CAPTURE(i);
    for (int k = 0; k < boxes; ++k) {
      const irg::box<T, 3> b = random_box<T>(r, width, height);
      const auto corners = corners_of(b);
      const occlusion answer = mask.test(b, d.to_clip);
      const bool seen = d.changed_by(corners, box_triangles);
      if (answer != occlusion::visible) REQUIRE(!seen);
      sum.visible += answer == occlusion::visible;
      sum.occluded += answer == occlusion::occluded;
      sum.outside += answer == occlusion::outside;
      sum.needless += answer == occlusion::visible && !seen;
      // Its triangles by themselves, and something small within the box.
      const auto v = irg::project_vertices<T>(corners, d.to_clip, d.mapping);
      const occlusion of_triangles = mask.template test<T>(v, box_triangles, d.mapping, face_culling::none);
      if (of_triangles != occlusion::visible) REQUIRE(!seen);
      if (answer == occlusion::occluded) REQUIRE(of_triangles != occlusion::visible);
      if (answer == occlusion::visible) continue;
      std::array<irg::point<T, 3>, 3> within;
      for (auto& p : within) {
        const auto share = [&](T low, T high) {
          const T at = low + (high - low) * static_cast<T>(r.integer(0, 8)) / T(8);
          return irg::minimum(irg::maximum(at, low), high);
        };
        const T x = share(b.low.x, b.high.x), y = share(b.low.y, b.high.y), z = share(b.low.z, b.high.z);
        p = {x, y, z};
      }
      constexpr irg::triangle_indices one[1] = {{{0, 1, 2}}};
      REQUIRE(!d.changed_by(within, one));
    }
  }
  MESSAGE(sum.visible, " visible (", sum.needless, " of them without a pixel), ", sum.occluded, " occluded, ",
          sum.outside, " outside");
  CHECK(sum.visible > scenes * boxes / 5);
  CHECK(sum.occluded > scenes * boxes / 5);
  CHECK(sum.outside > 0);
  CHECK(sum.needless < sum.visible / 3);
}

TEST_CASE("occlusion_mask: what it hides changes no pixel when drawn") {
  const int scenes = test::is_release_tier() ? 2000 : 90;
  never_hides<irg::nearer_is_greater, double>(401, scenes, 50);
  never_hides<irg::nearer_is_greater, float>(402, scenes, 50);
  never_hides<irg::nearer_is_less, float>(403, scenes, 50);
}

// The farthest of the depths in a window.
template <class Order>
float farthest_in(const irg::image<float>& depth, const irg::cell_window& w) {
  float far = depth(w.x_first, w.y_first);
  for (int y = w.y_first; y < w.y_last; ++y)
    for (int x = w.x_first; x < w.x_last; ++x)
      if (Order::nearer(far, depth(x, y))) far = depth(x, y);
  return far;
}

// The mask's depths are those of drawing, and the farthest ones are those of their pixels.
template <class Order, class T>
void depths_of_drawing(std::uint64_t seed, int scenes) {
  test::random r(seed);
  long long covered = 0, tiles = 0;
  for (int i = 0; i < scenes; ++i) {
    const int width = static_cast<int>(r.integer(1, 300)), height = static_cast<int>(r.integer(1, 150));
    const auto kind = static_cast<scene_kind>(i % (test::scene_kinds + 1));
    triangle_scene s = test::scene_maker(r, kind, width, height)(static_cast<int>(r.integer(1, 200)));
    if (Order::nearer(0.0f, 1.0f)) s.to_clip = test::square_view<Order>(0.125, 64);
    const face_culling culling = i % 2 == 0 ? face_culling::none : face_culling::back;
    const drawn_scene<Order, T> d(s, culling);
    irg::occlusion_mask<Order> mask(width, height), shared(width, height);
    const irg::triangle_batch<T> batch[1] = {{&d.vertices, s.triangles, 0}};
    const std::span<const irg::triangle_batch<T>> batches(batch);
    const auto counts = mask.template draw<T>(batches, d.mapping, culling);
    REQUIRE(shared.template draw<T>(batches, d.mapping, culling, irg::parallel{3}) == counts);
    CAPTURE(i);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        REQUIRE(mask.depth(x, y) == d.depth(x, y));
        REQUIRE(shared.depth(x, y) == d.depth(x, y));
        REQUIRE(shared.block_depth(x, y) == mask.block_depth(x, y));
        covered += d.depth(x, y) != Order::farthest;
      }
    const irg::cell_window picture{0, 0, width, height};
    for (int y = 0; y < height; y += 8)
      for (int x = 0; x < width; x += 8)
        REQUIRE(mask.block_depth(x, y) == farthest_in<Order>(d.depth, intersect(picture, {x, y, x + 8, y + 8})));
    // What is as far as the farthest pixel of a tile is hidden without a look at its blocks; what is nearer is not.
    for (int y = 0; y < height; y += 64)
      for (int x = 0; x < width; x += 64) {
        const irg::cell_window tile = intersect(picture, {x, y, x + 64, y + 64});
        const float far = farthest_in<Order>(d.depth, tile);
        irg::occlusion_counts looked;
        REQUIRE(mask.test(tile, far, &looked) == occlusion::occluded);
        REQUIRE(looked == irg::occlusion_counts{0, 1, 0, 1, 0, 0});
        REQUIRE(mask.test(tile, std::nextafter(far, Order::nearer(0.0f, 1.0f) ? -1.0f : 2.0f)) == occlusion::visible);
        tiles += far != Order::farthest;
      }
  }
  MESSAGE(covered, " covered pixels, ", tiles, " tiles without a gap");
  CHECK(covered > scenes * 1000);
  CHECK(tiles > scenes / 4);
}

TEST_CASE("occlusion_mask: depths as drawn and the farthest of them, on any number of threads") {
  const int scenes = test::is_release_tier() ? 1000 : 36;
  depths_of_drawing<irg::nearer_is_greater, double>(411, scenes);
  depths_of_drawing<irg::nearer_is_greater, float>(412, scenes);
  depths_of_drawing<irg::nearer_is_less, double>(413, scenes);
}

// A wall 4 in front of the eye that covers the picture's left half.
constexpr triangle_scene wall() {
  return {{{-8, -8, -4}, {0, -8, -4}, {0, 8, -4}, {-8, 8, -4}},
          {{{0, 1, 2}}, {{0, 2, 3}}},
          test::square_view(0.125),
          48,
          32};
}

struct answers {
  occlusion behind, before, beside, across_the_border, through_the_eye, behind_the_eye, above, empty, strange;
  irg::occlusion_counts counts;
  irg::occluder_counts drawn;
  constexpr bool operator==(const answers&) const = default;
};

constexpr answers ask_wall() {
  const triangle_scene s = wall();
  const auto mapping = irg::map_to_screen<double>({s.width, s.height});
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  irg::occlusion_mask<> mask(s.width, s.height);
  const auto drawn = mask.draw<double>(vertices, s.triangles, mapping);
  answers a{};
  a.drawn = drawn;
  const auto ask = [&](const irg::box<double, 3>& b) { return mask.test(b, s.to_clip, &a.counts); };
  a.behind = ask({{-2, -1, -6}, {-1, 1, -5}});
  a.before = ask({{-2, -1, -3}, {-1, 1, -2}});
  a.beside = ask({{1, -1, -6}, {2, 1, -5}});
  a.across_the_border = ask({{-2, -1, -6}, {1, 1, -5}});
  a.through_the_eye = ask({{-2, -1, -6}, {-1, 1, 1}});
  a.behind_the_eye = ask({{-2, -1, 1}, {-1, 1, 2}});
  a.above = ask({{-2, 30, -6}, {-1, 31, -5}});
  a.empty = ask({});
  a.strange = ask({{-2, -1, -6}, {std::numeric_limits<double>::quiet_NaN(), 1, -5}});
  return a;
}

TEST_CASE("occlusion_mask: a wall and boxes about it, in constant evaluation as at run time") {
  static constexpr answers a = ask_wall();
  CHECK(a.behind == occlusion::occluded);
  CHECK(a.before == occlusion::visible);
  CHECK(a.beside == occlusion::visible);
  CHECK(a.across_the_border == occlusion::visible);
  CHECK(a.through_the_eye == occlusion::visible);
  CHECK(a.behind_the_eye == occlusion::outside);
  CHECK(a.above == occlusion::outside);
  CHECK(a.empty == occlusion::outside);
  CHECK(a.strange == occlusion::visible);
  CHECK(a.counts.visible == 5);
  CHECK(a.counts.occluded == 1);
  CHECK(a.counts.outside == 3);
  CHECK(a.drawn.drawn == 2);
  CHECK(ask_wall() == a);
}

TEST_CASE("occlusion_mask: rectangles, clearing, and masks without pixels") {
  const triangle_scene s = wall();
  const auto mapping = irg::map_to_screen<double>({s.width, s.height});
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  irg::occlusion_mask<> mask(s.width, s.height);
  // Nothing is drawn: only what lies at the farthest depth is hidden.
  CHECK(mask.is_visible(irg::cell_window{0, 0, 9, 9}, 0.001f));
  CHECK(mask.test(irg::cell_window{0, 0, 9, 9}, 0.0f) == occlusion::occluded);
  mask.draw<double>(vertices, s.triangles, mapping);
  const float there = mask.depth(0, 0);
  CHECK(there == 0.03125f);
  CHECK(mask.depth(24, 0) == 0);
  CHECK(mask.test(irg::cell_window{0, 0, 24, 32}, there) == occlusion::occluded);
  CHECK(mask.test(irg::cell_window{0, 0, 24, 32}, 0.032f) == occlusion::visible);
  CHECK(mask.test(irg::cell_window{0, 0, 25, 32}, there) == occlusion::visible);
  CHECK(mask.test(irg::cell_window{-50, -50, 24, 3200}, there) == occlusion::occluded);
  CHECK(mask.test(irg::cell_window{-50, 0, 0, 32}, 1.0f) == occlusion::outside);
  CHECK(mask.test(irg::cell_window{5, 5, 5, 9}, 1.0f) == occlusion::outside);
  CHECK(mask.is_visible(irg::cell_window{0, 0, 9, 9}, std::numeric_limits<float>::quiet_NaN()));
  mask.clear();
  CHECK(mask.depth(0, 0) == 0);
  CHECK(mask.block_depth(0, 0) == 0);
  CHECK(mask.is_visible(irg::cell_window{0, 0, 9, 9}, there));

  irg::occlusion_mask<> none;
  CHECK(none.test(irg::cell_window{0, 0, 9, 9}, 1.0f) == occlusion::outside);
  CHECK(none.test(irg::box<double, 3>{{-1, -1, -2}, {1, 1, -1}}, s.to_clip) == occlusion::outside);
  none.draw<double>(vertices, s.triangles, mapping);  // nothing to draw into
}

TEST_CASE("occlusion_mask: drawing again, in parts and in any order, comes to the same") {
  test::random r(421);
  const triangle_scene s = test::scene_maker(r, scene_kind::any, 200, 150)(200);
  const auto mapping = irg::map_to_screen<double>({s.width, s.height});
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  irg::occlusion_mask<> whole(200, 150), parts(200, 150);
  whole.draw<double>(vertices, s.triangles, mapping, face_culling::none);
  const std::span<const irg::triangle_indices> all(s.triangles);
  parts.draw<double>(vertices, all.subspan(77), mapping, face_culling::none);
  parts.draw<double>(vertices, all.first(77), mapping, face_culling::none);
  parts.draw<double>(vertices, all.first(9), mapping, face_culling::none);
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 200; ++x) {
      REQUIRE(whole.depth(x, y) == parts.depth(x, y));
      REQUIRE(whole.block_depth(x, y) == parts.block_depth(x, y));
    }
}

}  // namespace
