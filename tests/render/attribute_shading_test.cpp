// SPDX-License-Identifier: MIT
#include <irg/render/attribute_shading.hpp>

#include <bit>
#include <vector>

#include <irg/colour/srgb_lanes.hpp>
#include <irg/core/threads.hpp>
#include <irg/render/draw_triangles.hpp>

#include "support/check_both.hpp"
#include "support/ulp.hpp"
#include "support/visible_scenes.hpp"

namespace {

using irg::facing;
using irg::rgba8;
using test::scene_kind;
using test::triangle_scene;
using batch = irg::triangle_batch<double>;
using values = std::array<float, 3>;

// nearer_is_greater by another name: irg does not know it and takes the plain path.
struct plainly {
  static constexpr float farthest = 0.0f;
  template <class T>
  static constexpr auto nearer(const T& a, const T& b) noexcept {
    return b < a;
  }
};

// ---- shadings: what is interpolated, as it is; as an encoded colour; the same in lanes

using vertex_values = std::vector<values>;  // of the fronts of a batch, then of the backs

struct recorded {
  static constexpr int attribute_count = 3;
  std::span<const vertex_values> of_batch;
  std::span<const std::size_t> backs_from;

  constexpr const float* attributes(const batch& b, std::uint32_t v, facing side) const {
    return of_batch[b.object][(side == facing::front ? 0 : backs_from[b.object]) + v].data();
  }
  constexpr values pixel(const values& v) const { return v; }
};
struct coloured : recorded {
  constexpr rgba8 pixel(const values& v) const { return irg::encode({v[0], v[1], v[2]}); }
};
struct coloured_in_lanes : coloured {
  template <int N>
  irg::pack<std::uint32_t, N> pixels(const std::array<irg::pack<float, N>, 3>& v) const {
    return irg::encode_lanes(v[0], v[1], v[2]);
  }
};
static_assert(irg::AttributeShading<recorded, batch> && irg::AttributeShading<coloured_in_lanes, batch>);
struct no_pixel {
  static constexpr int attribute_count = 1;
  const float* attributes(const batch&, std::uint32_t, facing) const { return nullptr; }
};
static_assert(!irg::AttributeShading<no_pixel, batch>);
static_assert(!irg::AttributeShading<irg::solid_shader<rgba8>, batch>);

TEST_CASE("interpolate_attributes: weights of the second and third vertex, constants as they are") {
  constexpr float a[] = {1, 0.1f}, b[] = {3, 0.1f}, c[] = {1, 0.1f};
  CHECK_BOTH(irg::interpolate_attributes<2>(irg::pixel_weights<float>{0.25f, 0.5f, 0}, a, b, c) ==
             std::array<float, 2>{1.5f, 0.1f});
  CHECK_BOTH(irg::interpolate_attributes<2>(irg::pixel_weights<float>{0.3f, 0.7f, 0}, a, b, c)[1] == 0.1f);
  CHECK_BOTH(irg::interpolate_attributes<2>(irg::pixel_weights<float>{0, 0, 0}, a, b, c)[0] == 1);
}

// ---- the fast way against the plain one

struct batches_of {
  std::vector<irg::projected_vertices<double>> vertices;
  std::vector<batch> batches;
  std::vector<vertex_values> shown;
  std::vector<std::size_t> backs_from;
};

// A scene's triangles in one to four batches, each over vertices of its own.
batches_of cut(const triangle_scene& s, const irg::screen_mapping<double>& mapping, test::random& r) {
  batches_of out;
  const std::span<const irg::triangle_indices> all(s.triangles);
  const auto parts = static_cast<std::size_t>(r.integer(1, 4));
  std::size_t first = 0;
  out.vertices.resize(parts);
  for (std::size_t i = 0; i < parts; ++i) {
    const std::size_t last = i + 1 == parts
                                 ? all.size()
                                 : static_cast<std::size_t>(r.integer(static_cast<std::int64_t>(first),
                                                                      static_cast<std::int64_t>(all.size())));
    irg::project_vertices<double>(s.positions, s.to_clip, mapping, out.vertices[i]);
    out.batches.push_back({&out.vertices[i], all.subspan(first, last - first), static_cast<std::uint32_t>(first),
                           static_cast<std::uint32_t>(i)});
    first = last;
    vertex_values& v = out.shown.emplace_back();
    for (std::size_t k = 0; k < 2 * s.positions.size(); ++k) {
      const auto any = [&] { return static_cast<float>(r.unit() * 1.5 - 0.25); };
      const float x = any(), y = any();
      v.push_back({x, y, any()});
    }
    out.backs_from.push_back(s.positions.size());
  }
  return out;
}

template <class P>
struct drawn {
  irg::image<P> colour;
  irg::image<float> depth;
  irg::render_counts stats;
  bool operator==(const drawn& o) const { return colour == o.colour && depth == o.depth; }
};

template <class Order, class P, class Shading, class E = irg::sequential>
drawn<P> draw(const triangle_scene& s, const batches_of& b, const Shading& shading,
              const irg::draw_options<P>& settings, std::uint64_t seed, const E& executor = {}) {
  drawn<P> d{irg::image<P>(s.width, s.height), irg::image<float>(s.width, s.height), {}};
  test::random r(seed);
  for (int y = 0; y < s.height; ++y)  // what was there before
    for (int x = 0; x < s.width; ++x) {
      d.depth(x, y) = r.integer(0, 2) == 0 ? static_cast<float>(r.integer(0, 255)) / 1024 : 0.0f;
      if constexpr (std::same_as<P, rgba8>)
        d.colour(x, y) = std::bit_cast<rgba8>(static_cast<std::uint32_t>(r.next()));
      else
        d.colour(x, y) = {static_cast<float>(r.unit()), -1, -2};
    }
  d.stats = irg::shade_batches<Order, double>(irg::render_target{d.colour, d.depth},
                                              {b.batches, irg::map_to_screen<double>({s.width, s.height})}, shading,
                                              settings, executor);
  return d;
}

long long fast_equals_plain(const triangle_scene& s, test::random& r, irg::clearing clear, irg::face_culling culling) {
  const batches_of b = cut(s, irg::map_to_screen<double>({s.width, s.height}), r);
  const recorded numbers{b.shown, b.backs_from};
  const std::uint64_t seed = r.next();
  using fast = irg::nearer_is_greater;
  const irg::draw_options<values> as_numbers{culling, {}, clear, {5, 6, 7}};
  const irg::draw_options<rgba8> as_colours{culling, {}, clear, {5, 6, 7, 8}};
  const auto expected = draw<plainly>(s, b, numbers, as_numbers, seed);
  const auto one = draw<fast>(s, b, numbers, as_numbers, seed);
  REQUIRE(one.depth == expected.depth);
  REQUIRE(one.colour == expected.colour);
  const auto colours = draw<plainly>(s, b, coloured{numbers}, as_colours, seed);
  REQUIRE(draw<fast>(s, b, coloured{numbers}, as_colours, seed) == colours);
  REQUIRE(draw<fast>(s, b, coloured_in_lanes{{numbers}}, as_colours, seed) == colours);
  REQUIRE(draw<fast>(s, b, coloured_in_lanes{{numbers}}, as_colours, seed, irg::parallel{3}) == colours);
  auto plain_skips = as_colours;
  plain_skips.skip = irg::skip_nothing;
  REQUIRE(draw<fast>(s, b, coloured_in_lanes{{numbers}}, plain_skips, seed) == colours);
  return one.stats.pixels.shaded;
}

triangle_scene mixed_scene(test::random& r, int i, int width, int height, int triangles) {
  triangle_scene s{{}, {}, test::square_view(0.125), width, height};
  for (int k = 0; k < 2; ++k) {
    const triangle_scene more =
        test::scene_maker(r, static_cast<scene_kind>((i + 3 * k) % test::scene_kinds), width, height)(triangles / 2);
    const auto first = static_cast<std::uint32_t>(s.positions.size());
    s.positions.insert(s.positions.end(), more.positions.begin(), more.positions.end());
    for (const auto& t : more.triangles) s.triangles.push_back({{t.v[0] + first, t.v[1] + first, t.v[2] + first}});
  }
  return s;
}

TEST_CASE("attribute shading: the fast way has the bits of the plain one, on scenes of every kind and size") {
  test::random r(61);
  const int scenes = test::is_release_tier() ? 3000 : 160;
  long long shaded = 0;
  for (int i = 0; i < scenes; ++i) {
    CAPTURE(i);
    const triangle_scene s = mixed_scene(r, i, static_cast<int>(r.integer(1, 200)), static_cast<int>(r.integer(1, 90)),
                                         static_cast<int>(r.integer(2, 60)));
    shaded += fast_equals_plain(s, r, i / 2 % 2 == 0 ? irg::clearing::none : irg::clearing::before_drawing,
                                i % 2 == 0 ? irg::face_culling::none : irg::face_culling::back);
  }
  CHECK(shaded > scenes * 500);
}

TEST_CASE("attribute shading: pictures of every size from 1 to 70") {
  test::random r(62);
  for (int width = 1; width <= 70; ++width) {
    CAPTURE(width);
    const int height = 1 + (width * 37) % 70;  // each height once
    const auto clear = width % 2 == 0 ? irg::clearing::none : irg::clearing::before_drawing;
    fast_equals_plain(mixed_scene(r, width, width, height, 16), r, clear, irg::face_culling::none);
    fast_equals_plain(mixed_scene(r, width, width, 1 + width % 9, 16), r, clear, irg::face_culling::none);
  }
}

// Sides longer than 128 pixels leave 32-bit set-up, areas above 4 million pixels 32-bit coverage.
TEST_CASE("attribute shading: triangles far larger than the picture") {
  test::random r(63);
  const int scenes = test::is_release_tier() ? 400 : 24;
  for (int i = 0; i < scenes; ++i) {
    CAPTURE(i);
    const int width = static_cast<int>(r.integer(60, 210)), height = static_cast<int>(r.integer(60, 140));
    triangle_scene s{{}, {}, test::square_view(0.125), width, height};
    int large = 0;
    for (std::uint32_t t = 0; t < 16; ++t) {
      const std::int64_t reach = 1024 * (t % 2 == 0 ? 12000 : 400);  // both within the guard band
      irg::subpixel at[3];
      for (irg::subpixel& p : at) {
        const std::int64_t x = r.integer(-reach, reach), y = r.integer(-reach, reach);
        s.positions.push_back(test::seen_at(x, y, r.integer(1024, 1 << 14), width, height));
        p = {static_cast<std::int32_t>(x / 4), static_cast<std::int32_t>(y / 4)};
      }
      s.triangles.push_back({{3 * t, 3 * t + 1, 3 * t + 2}});
      large += std::abs(irg::twice_signed_area(at[0], at[1], at[2])) / 131072 > 4'000'000;
    }
    CHECK(large > 3);
    fast_equals_plain(s, r, i % 2 == 0 ? irg::clearing::none : irg::clearing::before_drawing, irg::face_culling::none);
  }
}

}  // namespace
