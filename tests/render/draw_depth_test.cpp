// SPDX-License-Identifier: MIT
// Depths without colours are the depths that shade_batches leaves, or nearer ones of faces too close to tell.
#include <irg/render/draw_depth.hpp>

#include <irg/core/threads.hpp>

#include "support/check_both.hpp"
#include "support/ulp.hpp"
#include "support/visible_scenes.hpp"

namespace {

using irg::face_culling;
using irg::skip_options;
using test::scene_kind;
using test::triangle_scene;

template <irg::DepthOrder Order = irg::nearer_is_greater, irg::Floating T = double, class E = irg::sequential>
constexpr std::pair<irg::image<float>, irg::render_counts> depths(const triangle_scene& s, face_culling culling,
                                                                  const skip_options& skip = {},
                                                                  const E& executor = {}) {
  irg::image<float> depth(s.width, s.height, 0.5f);
  const auto mapping = irg::map_to_screen<T>({s.width, s.height});
  const auto positions = test::positions_in<T>(s);
  const auto vertices = irg::project_vertices<T>(positions, test::matrix_in<T>(s), mapping);
  const auto stats = irg::draw_depth<Order, T>(depth, {vertices, s.triangles, mapping},
                                               {culling, skip, irg::clearing::before_drawing}, executor);
  return {depth, stats};
}

// Whether all depths are the same, or nearer by 8 ulp at most; `nearer` counts these.
template <class Order>
bool same_or_close(const irg::image<float>& a, const irg::image<float>& b, long long& nearer) {
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const float d = a(x, y), e = b(x, y), size = d < e ? e : d;
      if (d == e) continue;
      if (!Order::nearer(d, e) || (d < e ? e - d : d - e) > 8 * size * 0x1p-23f) return false;
      ++nearer;
    }
  return true;
}

template <class Order, class T>
void equal_on_random_scenes(std::uint64_t seed, int scenes) {
  test::random r(seed);
  long long drawn = 0, nearer = 0;
  for (int i = 0; i < scenes; ++i) {
    const int width = static_cast<int>(r.integer(1, 200)), height = static_cast<int>(r.integer(1, 100));
    test::scene_maker make(r, static_cast<scene_kind>(i % (test::scene_kinds + 1)), width, height);
    triangle_scene s = make(60);
    if (Order::nearer(0.0f, 1.0f)) s.to_clip = test::square_view<Order>(0.125, 64);
    const face_culling culling = i % 2 == 0 ? face_culling::none : face_culling::back;
    const test::id_picture expected = test::visible_ids<Order, T>(s, culling);
    const auto [depth, stats] = depths<Order, T>(s, culling);
    CAPTURE(i);
    REQUIRE(same_or_close<Order>(depth, expected.depth, nearer));
    REQUIRE(stats.skipped == expected.stats.skipped);
    REQUIRE(stats.pixels.tested == expected.stats.pixels.tested);
    REQUIRE(stats.pixels.shaded == 0);
    REQUIRE(depths<Order, T>(s, culling, irg::skip_nothing).first == depth);
    const auto shared = depths<Order, T>(s, culling, {}, irg::parallel{3});
    REQUIRE(shared.first == depth);
    REQUIRE(shared.second == stats);
    if constexpr (std::same_as<Order, irg::nearer_is_greater>)
      REQUIRE(depths<test::plain_order, T>(s, culling).first == depth);
    drawn += expected.stats.pixels.shaded;
  }
  CHECK(drawn > scenes * 1000);
  CHECK(nearer * 1000 < drawn);
}

TEST_CASE("draw_depth: the depths of shade_batches, the nearer one where faces are close, whatever is skipped") {
  const int scenes = test::is_release_tier() ? 5000 : 180;
  test::with_each_order(
      301, [scenes]<class Order, class T>(std::uint64_t seed) { equal_on_random_scenes<Order, T>(seed, scenes); });
}

TEST_CASE("draw_depth: onto depths that are there already") {
  test::random r(304);
  test::scene_maker one(r, scene_kind::crossing, 100, 80);
  triangle_scene s = one(20);
  const auto whole = depths(s, face_culling::none).first;
  const auto mapping = irg::map_to_screen<double>({100, 80});
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  irg::image<float> depth(100, 80, 0.0f);
  const std::span<const irg::triangle_indices> all(s.triangles);
  const irg::draw_depth_options keep{face_culling::none, {}, irg::clearing::none};
  irg::draw_depth(depth, irg::projected_triangles{vertices, all.subspan(10), mapping}, keep);
  irg::draw_depth(depth, irg::projected_triangles{vertices, all.first(10), mapping}, keep);
  CHECK(depth == whole);
}

TEST_CASE("draw_depth: nothing to draw, and rows wider than the picture") {
  const auto mapping = irg::map_to_screen<double>({70, 20});
  const irg::projected_vertices<double> none;
  std::vector<float> memory(80 * 20, 7.0f);
  irg::image_view<float> depth(memory.data(), 70, 20, 80 * 4);
  const auto stats = irg::draw_depth(depth, irg::projected_triangles{none, {}, mapping});
  CHECK(stats == irg::render_counts{});
  CHECK(depth(69, 19) == 7);
  irg::draw_depth(depth, irg::projected_triangles{none, {}, mapping}, {.clear = irg::clearing::before_drawing});
  for (int i = 0; i < 80 * 20; ++i) REQUIRE(memory[static_cast<std::size_t>(i)] == (i % 80 < 70 ? 0.0f : 7.0f));

  test::random r(305);
  const triangle_scene s = test::scene_maker(r, scene_kind::huge, 70, 20)(9);
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  irg::draw_depth(depth, irg::projected_triangles{vertices, s.triangles, mapping}, {.culling = face_culling::none});
  const auto expected = depths(s, face_culling::none).first;
  for (int i = 0; i < 80 * 20; ++i)
    REQUIRE(memory[static_cast<std::size_t>(i)] == (i % 80 < 70 ? expected(i % 80, i / 80) : 7.0f));
}

TEST_CASE("draw_depth: constant evaluation gives the bytes of run time, clipping included") {
  static constexpr auto at_compile_time = [] {
    const auto d = depths(test::two_to_be_clipped(), face_culling::none).first;
    std::array<std::uint32_t, 64> bits{};
    for (int i = 0; i < 64; ++i) bits[static_cast<std::size_t>(i)] = std::bit_cast<std::uint32_t>(d(i % 8, i / 8));
    return bits;
  }();
  const auto d = depths(test::two_to_be_clipped(), face_culling::none).first;
  int drawn = 0;
  for (int i = 0; i < 64; ++i) {
    REQUIRE(at_compile_time[static_cast<std::size_t>(i)] == std::bit_cast<std::uint32_t>(d(i % 8, i / 8)));
    drawn += d(i % 8, i / 8) != 0;
  }
  CHECK(drawn > 20);
}

}  // namespace
