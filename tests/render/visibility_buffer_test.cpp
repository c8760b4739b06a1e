// SPDX-License-Identifier: MIT
// Numbers of visible triangles and their weights, against the pixel shaders of shade_batches.
#include <irg/render/visibility_buffer.hpp>

#include <irg/core/threads.hpp>

#include "support/check_both.hpp"
#include "support/ulp.hpp"
#include "support/visible_scenes.hpp"

namespace {

using irg::face_culling;
using irg::skip_options;
using test::scene_kind;
using test::triangle_scene;

// What a pixel shader is given.
struct mark {
  std::uint32_t number = irg::no_index;
  float second = 0, third = 0, depth = 0;
  constexpr bool operator==(const mark&) const = default;
};

// A scene cut into two batches, projected.
template <class T>
struct batches_of {
  std::vector<irg::point<T, 3>> positions;
  irg::screen_mapping<T> mapping;
  irg::projected_vertices<T> vertices;
  std::array<irg::triangle_batch<T>, 2> batches;

  explicit constexpr batches_of(const triangle_scene& s)
      : positions(test::positions_in<T>(s)), mapping(irg::map_to_screen<T>({s.width, s.height})),
        vertices(irg::project_vertices<T>(positions, test::matrix_in<T>(s), mapping)) {
    const std::span<const irg::triangle_indices> all(s.triangles);
    const std::size_t half = all.size() / 2;
    batches = {{{&vertices, all.first(half), 0, 0}, {&vertices, all.subspan(half), static_cast<std::uint32_t>(half)}}};
  }
};

struct buffer {
  irg::image<std::uint32_t> ids;
  irg::image<float> depth;
  irg::render_counts stats;
};

template <class Order, class T, class E = irg::sequential>
constexpr buffer draw(const batches_of<T>& b, int width, int height, face_culling culling,
                      const skip_options& skip = {}, const E& executor = {}) {
  buffer r{irg::image<std::uint32_t>(width, height, 9999u), irg::image<float>(width, height, 0.5f), {}};
  r.stats = irg::draw_visibility<Order, T>({r.ids, r.depth}, {b.batches, b.mapping},
                                           {culling, skip, irg::clearing::before_drawing}, executor);
  return r;
}

template <class Order, class T>
void like_the_shaders(std::uint64_t seed, int scenes) {
  test::random r(seed);
  long long seen = 0, clipped = 0;
  for (int i = 0; i < scenes; ++i) {
    const int width = static_cast<int>(r.integer(1, 150)), height = static_cast<int>(r.integer(1, 90));
    const auto kind = static_cast<scene_kind>(i % (test::scene_kinds + 1));
    triangle_scene s = test::scene_maker(r, kind, width, height)(40);
    if (Order::nearer(0.0f, 1.0f)) s.to_clip = test::square_view<Order>(0.125, 64);
    const batches_of<T> b(s);
    const face_culling culling = i % 2 == 0 ? face_culling::none : face_culling::back;
    irg::image<mark> marks(width, height, mark{});
    irg::image<float> depth(width, height, 0.0f);
    const auto shader = [](const irg::triangle_batch<T>& batch, std::uint32_t k, irg::facing) {
      return [number = batch.first_number + k](const irg::pixel_weights<float>& at) {
        return mark{number, at.weight1, at.weight2, at.depth};
      };
    };
    irg::shade_batches<Order, T>(irg::render_target{marks, depth}, {b.batches, b.mapping}, shader,
                                 {culling, {}, irg::clearing::before_drawing, mark{}});
    const buffer v = draw<Order>(b, width, height, culling);
    CAPTURE(i);
    REQUIRE(v.depth == depth);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const mark& m = marks(x, y);
        REQUIRE(v.ids(x, y) == m.number);
        const auto at = irg::barycentrics_at<Order, T>(b.batches, b.mapping, m.number, x, y);
        REQUIRE(at.has_value() == (m.number != irg::no_index));
        if (!at) continue;
        REQUIRE(mark{m.number, at->weight1, at->weight2, at->depth} == m);
        ++seen;
        const auto& t = s.triangles[m.number];
        clipped += (b.vertices.codes[t.v[0]] | b.vertices.codes[t.v[1]] | b.vertices.codes[t.v[2]]).cut != 0;
      }
    const buffer all = draw<Order>(b, width, height, culling, irg::skip_nothing);
    REQUIRE((all.ids == v.ids && all.depth == v.depth));
    const buffer shared = draw<Order>(b, width, height, culling, {}, irg::parallel{3});
    REQUIRE((shared.ids == v.ids && shared.depth == v.depth && shared.stats == v.stats));
    if constexpr (std::same_as<Order, irg::nearer_is_greater>) {
      const buffer plain = draw<test::plain_order>(b, width, height, culling);
      REQUIRE((plain.ids == v.ids && plain.depth == v.depth));
    }
  }
  CHECK(seen > scenes * 1000);
  CHECK(clipped > scenes * 100);
}

TEST_CASE("draw_visibility: numbers, depths and weights are those of the pixel shaders, bit for bit") {
  const int scenes = test::is_release_tier() ? 3000 : 108;
  test::with_each_order(
      311, [scenes]<class Order, class T>(std::uint64_t seed) { like_the_shaders<Order, T>(seed, scenes); });
}

TEST_CASE("draw_visibility: onto a buffer that is kept, later drawing wins only where it is nearer") {
  test::random r(314);
  const triangle_scene s = test::scene_maker(r, scene_kind::any, 100, 80)(40);
  const batches_of<double> b(s);
  const buffer whole = draw<irg::nearer_is_greater>(b, 100, 80, face_culling::none);
  buffer parts{irg::image<std::uint32_t>(100, 80, irg::no_index), irg::image<float>(100, 80, 0.0f), {}};
  // Numbers count from the first batch that is drawn.
  irg::triangle_batch<double> second[1] = {b.batches[1]};
  second[0].first_number = 0;
  const std::span<const irg::triangle_batch<double>> first(b.batches.data(), 1);
  const irg::draw_depth_options keep{face_culling::none, {}, irg::clearing::none};
  irg::draw_visibility({parts.ids, parts.depth}, irg::projected_triangles{first, b.mapping}, keep);
  irg::draw_visibility({parts.ids, parts.depth},
                       irg::projected_triangles{std::span<const irg::triangle_batch<double>>(second), b.mapping}, keep);
  CHECK(parts.depth == whole.depth);
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 100; ++x) {
      const std::uint32_t expected = whole.ids(x, y);
      REQUIRE(parts.ids(x, y) == (expected == irg::no_index || expected < 20 ? expected : expected - 20));
    }
}

TEST_CASE("barycentrics_at: nothing for numbers and pixels that are not the triangle's") {
  const triangle_scene s{{{-1, -1, -2}, {1, -1, -2}, {-1, 1, -2}}, {{{0, 1, 2}}}, test::square_view(0.125), 16, 16};
  const auto mapping = irg::map_to_screen<double>({16, 16});
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  const irg::triangle_batch<double> batch{&vertices, s.triangles, 5};
  CHECK(irg::barycentrics_at(batch, mapping, 5, 4, 11).has_value());
  CHECK(!irg::barycentrics_at(batch, mapping, 5, 15, 0).has_value());
  CHECK(!irg::barycentrics_at(batch, mapping, 4, 4, 11).has_value());
  CHECK(!irg::barycentrics_at(batch, mapping, 6, 4, 11).has_value());
  CHECK(!irg::barycentrics_at(batch, mapping, irg::no_index, 4, 11).has_value());
  CHECK(!irg::barycentrics_at<irg::nearer_is_greater, double>({}, mapping, 0, 4, 11).has_value());
  const auto at = *irg::barycentrics_at(batch, mapping, 5, 4, 11);
  CHECK(at.weight1 == 0.0625f);
  CHECK(at.weight2 == 0.0625f);
  CHECK(at.depth == 0.0625f);
}

TEST_CASE("draw_visibility: constant evaluation gives the numbers of run time") {
  static constexpr auto at_compile_time = [] {
    const triangle_scene s = test::two_to_be_clipped();
    const batches_of<double> b(s);
    const buffer v = draw<irg::nearer_is_greater>(b, 8, 8, face_culling::none);
    std::array<std::uint32_t, 64> ids{};
    for (int i = 0; i < 64; ++i) ids[static_cast<std::size_t>(i)] = v.ids(i % 8, i / 8);
    return ids;
  }();
  const triangle_scene s = test::two_to_be_clipped();
  const batches_of<double> b(s);
  const buffer v = draw<irg::nearer_is_greater>(b, 8, 8, face_culling::none);
  bool both[2] = {};
  for (int i = 0; i < 64; ++i) {
    const std::uint32_t id = v.ids(i % 8, i / 8);
    REQUIRE(at_compile_time[static_cast<std::size_t>(i)] == id);
    if (id < 2) both[id] = true;
  }
  CHECK(both[0]);
  CHECK(both[1]);
}

}  // namespace
