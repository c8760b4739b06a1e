// SPDX-License-Identifier: MIT
#include <irg/raster/draw_triangle.hpp>

#include <cmath>
#include <cstring>
#include <utility>

#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

using irg::screen_vertex;

struct to_bytes {
  constexpr irg::rgba8 operator()(const irg::rgb<float>& c) const {
    const auto byte = [](float v) { return static_cast<std::uint8_t>(irg::clamped(v, 0.0f, 1.0f) * 255.0f + 0.5f); };
    return {byte(c.r), byte(c.g), byte(c.b), 255};
  }
};
using colours = irg::vertex_colour_shader<irg::rgba8, to_bytes>;

struct canvas {
  irg::image<irg::rgba8> colour;
  irg::image<float> depth;
  constexpr canvas(int width, int height, float farthest = 0.0f)
      : colour(width, height), depth(width, height, farthest) {}
  constexpr bool operator==(const canvas&) const = default;
};

template <class Order = irg::nearer_is_greater, class Shader>
constexpr irg::draw_counts draw(canvas& c, const screen_vertex (&v)[3], const Shader& shader) {
  return irg::shade_triangle<Order>(c.colour, c.depth, {v[0], v[1], v[2]}, shader);
}

// The same triangle by the plain kernel: scalars and 64-bit coverage.
template <class Order = irg::nearer_is_greater, class Shader>
irg::draw_counts draw_plain(canvas& c, const screen_vertex (&v)[3], const Shader& shader) {
  const auto t = irg::cover_and_set_up(v[0], v[1], v[2]);
  const auto w = irg::window_of(c.colour);
  if (t.coverage.double_area == 0 || irg::intersect(t.coverage.bounds, w).empty()) return {};
  return irg::detail::triangle_rows<Order, irg::depth_policy<>, float, std::int64_t>(
      c.colour, c.depth, t, irg::shade_over<Shader>{shader}, w);
}

screen_vertex random_vertex(test::random& r, int pixels) {
  return {{static_cast<std::int32_t>(r.integer(-pixels * 64, pixels * 256)),
           static_cast<std::int32_t>(r.integer(-pixels * 64, pixels * 256))},
          static_cast<float>(r.unit()),
          static_cast<float>(std::ldexp(1.0 + r.unit(), static_cast<int>(r.integer(-8, 8))))};
}

constexpr canvas two_triangles() {
  canvas c(16, 16);
  const colours s{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}};
  draw(c, {{{100, 100}, 0.5f, 1.0f}, {{3900, 900}, 0.2f, 0.3f}, {{300, 3900}, 0.9f, 0.8f}}, s);
  draw(c, {{{3950, 100}, 0.7f, 1.0f}, {{100, 100}, 0.3f, 0.3f}, {{2000, 3900}, 0.4f, 0.8f}}, s);
  return c;
}

TEST_CASE("shade_triangle: constant evaluation gives the bytes of lanes") {
  static constexpr auto at_compile_time = [] {
    const canvas c = two_triangles();
    struct bytes {
      std::uint32_t depth[16][16]{};
      irg::rgba8 colour[16][16]{};
    } b;
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        b.depth[y][x] = std::bit_cast<std::uint32_t>(c.depth(x, y));
        b.colour[y][x] = c.colour(x, y);
      }
    return b;
  }();
  const canvas c = two_triangles();
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      CHECK(at_compile_time.depth[y][x] == std::bit_cast<std::uint32_t>(c.depth(x, y)));
      CHECK(at_compile_time.colour[y][x] == c.colour(x, y));
    }
}

TEST_CASE("shade_triangle: lanes give the bytes of the plain kernel, for every width, order and shader") {
  test::random random(5);
  for (int i = 0; i < 3000; ++i) {
    const int width = static_cast<int>(random.integer(1, 70)), height = static_cast<int>(random.integer(1, 20));
    canvas lanes(width, height), plain(width, height);
    for (int k = 0; k < 3; ++k) {
      const screen_vertex v[3] = {random_vertex(random, 64), random_vertex(random, 64), random_vertex(random, 64)};
      const colours s{{static_cast<float>(random.unit()), 0.5f, 0.1f},
                      {0.3f, static_cast<float>(random.unit()), 1.0f},
                      {0, 0, 1},
                      {}};
      if (i % 3 == 0)
        REQUIRE(draw(lanes, v, s) == draw_plain(plain, v, s));
      else if (i % 3 == 1)
        REQUIRE(draw<irg::nearer_is_less>(lanes, v, s) == draw_plain<irg::nearer_is_less>(plain, v, s));
      else
        REQUIRE(draw<irg::drawing_order>(lanes, v, irg::solid_shader<irg::rgba8>{{1, 2, 3, 4}}) ==
                draw_plain<irg::drawing_order>(plain, v, irg::solid_shader<irg::rgba8>{{1, 2, 3, 4}}));
    }
    REQUIRE(lanes == plain);
  }
}

TEST_CASE("shade_triangle: coverage is cover_triangle's, in every pixel") {
  test::random random(6);
  for (int i = 0; i < 2000; ++i) {
    canvas c(40, 20);
    const screen_vertex v[3] = {random_vertex(random, 40), random_vertex(random, 40), random_vertex(random, 40)};
    draw<irg::drawing_order>(c, v, irg::solid_shader<irg::rgba8>{{9, 9, 9, 9}});
    const auto t = irg::cover_triangle(v[0].position, v[1].position, v[2].position);
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 40; ++x) REQUIRE((c.colour(x, y).a == 9) == irg::covers(t, x, y));
  }
}

TEST_CASE("shade_triangle: depth and weights against long double, on triangles and slivers") {
  test::random random(8);
  long double worst_depth = 0, worst_weight = 0;
  for (int i = 0; i < 4000; ++i) {
    screen_vertex v[3] = {random_vertex(random, 60), random_vertex(random, 60), random_vertex(random, 60)};
    if (i % 2) {
      v[2].position = {(v[0].position.x + v[1].position.x) / 2 + static_cast<int>(random.integer(-2, 2)),
                       (v[0].position.y + v[1].position.y) / 2 + static_cast<int>(random.integer(-2, 2))};
    }
    const auto t = irg::cover_triangle(v[0].position, v[1].position, v[2].position);
    if (t.double_area == 0) continue;
    struct recorder {
      float w1, w2;
    };
    irg::image<recorder> weights(60, 60);
    irg::image<float> depth(60, 60, -1.0f);
    const auto record = [](const irg::pixel_weights<float>& f) { return recorder{f.weight1, f.weight2}; };
    irg::shade_triangle(weights, depth, {v[0], v[1], v[2]}, record);
    const long double area =
        static_cast<long double>(irg::twice_signed_area(v[0].position, v[1].position, v[2].position));
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x) {
        if (!irg::covers(t, x, y)) continue;
        const irg::subpixel p{x * 256 + 128, y * 256 + 128};
        const long double b1 = static_cast<long double>(irg::twice_signed_area(v[2].position, v[0].position, p)) / area;
        const long double b2 = static_cast<long double>(irg::twice_signed_area(v[0].position, v[1].position, p)) / area;
        const auto wide = [](float f) { return static_cast<long double>(f); };
        const long double z0 = wide(v[0].depth), q1 = wide(v[1].inverse_w), q2 = wide(v[2].inverse_w);
        const long double z = z0 + b1 * (wide(v[1].depth) - z0) + b2 * (wide(v[2].depth) - z0);
        const long double q = wide(v[0].inverse_w) * (1 - b1 - b2) + q1 * b1 + q2 * b2;
        worst_depth = std::fmax(worst_depth, std::fabs(z / wide(depth(x, y)) - 1) * 0x1p24L);
        worst_weight = std::fmax(worst_weight, std::fabs(b1 * q1 / q - wide(weights(x, y).w1)));
        worst_weight = std::fmax(worst_weight, std::fabs(b2 * q2 / q - wide(weights(x, y).w2)));
        const float low = std::fmin(v[0].depth, std::fmin(v[1].depth, v[2].depth));
        const float high = std::fmax(v[0].depth, std::fmax(v[1].depth, v[2].depth));
        REQUIRE(depth(x, y) >= low);
        REQUIRE(depth(x, y) <= high);
      }
  }
  MESSAGE("largest error of depth ", static_cast<double>(worst_depth), " half ulp, of perspective weights ",
          static_cast<double>(worst_weight));
  CHECK(worst_depth <= 8);  // relative, in units of 2^-24: 4 ulp
  CHECK(worst_weight <= 4e-7L);  // although inverse_w spreads over 2^16
}

TEST_CASE("shade_triangle: weights stay accurate when inverse_w differs by 1e5") {
  irg::image<float> weight(64, 64), depth(64, 64, -1.0f);
  const screen_vertex v[3] = {{{0, 0}, 0.5f, 1.0f}, {{64 * 256, 0}, 0.5f, 1e-5f}, {{0, 64 * 256}, 0.5f, 1.0f}};
  irg::shade_triangle(weight, depth, {v[0], v[1], v[2]}, [](const irg::pixel_weights<float>& f) { return f.weight1; });
  for (int x = 0; x < 63; ++x) {
    const long double b1 = (x + 0.5L) / 64, q = (1 - b1) + b1 * static_cast<long double>(1e-5f);
    CHECK(std::fabs(static_cast<long double>(weight(x, 0)) - b1 * static_cast<long double>(1e-5f) / q) < 1e-9L);
  }
}

TEST_CASE("shade_triangle: of equal depths the first drawn stays, and is counted") {
  constexpr auto ties = [] {
    canvas c(4, 4);
    const screen_vertex v[3] = {{{0, 0}, 0.5f}, {{1024, 0}, 0.5f}, {{0, 1024}, 0.5f}};
    draw(c, v, irg::solid_shader<irg::rgba8>{{1, 1, 1, 1}});
    const irg::draw_counts n = draw(c, v, irg::solid_shader<irg::rgba8>{{2, 2, 2, 2}});
    return n == irg::draw_counts{6, 0, 6} && c.colour(0, 0).r == 1;
  };
  CHECK_BOTH(ties());
}

TEST_CASE("shade_triangle: opaque triangles without ties give one picture in every order") {
  test::random random(14);
  screen_vertex v[12][3];
  for (auto& t : v)
    for (auto& p : t) p = random_vertex(random, 48);
  canvas first(48, 48);
  for (int round = 0; round < 100; ++round) {
    int order[12] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    if (round > 0)
      for (int i = 11; i > 0; --i) std::swap(order[i], order[random.integer(0, i)]);
    canvas c(48, 48);
    std::int64_t ties = 0;
    for (const int i : order) {
      const auto shade = static_cast<std::uint8_t>(20 * i + 10);
      ties += draw(c, v[i], irg::solid_shader<irg::rgba8>{{shade, 0, 0, 255}}).ties;
    }
    REQUIRE(ties == 0);
    if (round == 0)
      first = c;
    else
      REQUIRE(c == first);
  }
}

TEST_CASE("shade_triangle: the winding and a rotation of the vertices do not change coverage") {
  constexpr auto same = [] {
    const screen_vertex a{{100, 50}, 0.1f}, b{{3000, 700}, 0.9f}, c{{900, 3500}, 0.4f};
    canvas p(12, 14), q(12, 14), r(12, 14);
    const irg::solid_shader<irg::rgba8> s{{7, 7, 7, 7}};
    const auto n = draw(p, {a, b, c}, s), m = draw(q, {a, c, b}, s), k = draw(r, {b, c, a}, s);
    return n == m && n == k && p == q && p.colour == r.colour && n.tested > 50;
  };
  CHECK_BOTH(same());
}

TEST_CASE("shade_triangle: vertices far outside take the 64-bit path, with the same coverage") {
  canvas c(33, 9);
  const int far = irg::snap_limit * 256;
  const screen_vertex v[3] = {{{-far, -far}, 0.25f}, {{far, -far + 7}, 0.5f}, {{3, far}, 0.75f}};
  const auto n = draw(c, v, irg::solid_shader<irg::rgba8>{{5, 5, 5, 5}});
  const auto t = irg::cover_triangle(v[0].position, v[1].position, v[2].position);
  std::int64_t expected = 0;
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 33; ++x) expected += irg::covers(t, x, y);
  CHECK(n.tested == expected);
  CHECK(expected == 33 * 9);
}

TEST_CASE("shade_triangle: nothing outside the window is written") {
  canvas c(40, 10), before = c;
  const irg::cell_window w{5, 2, 29, 7};
  const screen_vertex v[3] = {{{-9000, -9000}, 0.5f}, {{90000, -9000}, 0.5f}, {{-9000, 90000}, 0.5f}};
  irg::shade_triangle(c.colour, c.depth, irg::cover_and_set_up(v[0], v[1], v[2]),
                      irg::solid_shader<irg::rgba8>{{5, 5, 5, 5}}, w);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 40; ++x) {
      const bool in = x >= 5 && x < 29 && y >= 2 && y < 7;
      CHECK((c.colour(x, y) == irg::rgba8{5, 5, 5, 5}) == in);
      CHECK((c.depth(x, y) == before.depth(x, y)) == !in);
    }
}

TEST_CASE("intensity_shader: the course's Gouraud triangle") {
  // (0,0) I=10, (4,0) I=50, (0,4) I=90: I(1,1)=40, I(2,0)=30, I(0,3)=70, I(2,2)=70; a sample point is a pixel centre.
  const auto drawn = [](int x, int y) {
    irg::image<float> intensity(6, 6, -1.0f);
    const auto at = [](int px, int py) { return screen_vertex{{px * 256 + 128, py * 256 + 128}}; };
    irg::shade_triangle(intensity, {at(0, 0), at(4, 0), at(0, 4)}, irg::intensity_shader<float>{10, 50, 90});
    return intensity(x, y);
  };
  CHECK_BOTH(drawn(1, 1) == 40.0f);
  CHECK_BOTH(drawn(2, 0) == 30.0f);
  CHECK_BOTH(drawn(0, 3) == 70.0f);
  CHECK_BOTH(drawn(0, 0) == 10.0f);
  CHECK_BOTH(drawn(2, 2) == -1.0f);  // on the right edge: not covered; the formula there:
  CHECK_BOTH(irg::pixel_weights<float>{0.5f, 0.5f, 0.0f}.interpolate(10, 50, 90) == 70.0f);
}

// What is drawn over a stored depth of 0.5 when the triangle's is `depth`, and which depth is kept: 9 for the colour of
// the triangle, then the depth.
template <irg::depth_test Test, irg::depth_write Write>
constexpr std::pair<int, float> over_a_half(float depth) {
  canvas c(12, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 12; ++x) c.depth(x, y) = 0.5f;
  irg::shade_triangle<irg::nearer_is_greater, irg::depth_policy<Test, Write>>(
      c.colour, c.depth, {{{0, 0}, depth}, {{9000, 0}, depth}, {{0, 9000}, depth}},
      irg::solid_shader<irg::rgba8>{{9, 9, 9, 9}});
  return {c.colour(10, 2).a == 9 ? 9 : 0, c.depth(10, 2)};
}

TEST_CASE("shade_triangle: the depth test and depth write of a policy") {
  using enum irg::depth_test;
  using enum irg::depth_write;
  using result = std::pair<int, float>;
  CHECK_BOTH(over_a_half<nearer, on>(0.75f) == result{9, 0.75f});
  CHECK_BOTH(over_a_half<nearer, off>(0.75f) == result{9, 0.5f});
  CHECK_BOTH(over_a_half<nearer, on>(0.5f) == result{0, 0.5f});
  CHECK_BOTH(over_a_half<nearer_or_equal, on>(0.5f) == result{9, 0.5f});
  CHECK_BOTH(over_a_half<equal, on>(0.5f) == result{9, 0.5f});
  CHECK_BOTH(over_a_half<equal, on>(0.75f) == result{0, 0.5f});
  CHECK_BOTH(over_a_half<always, on>(0.25f) == result{9, 0.25f});
  CHECK_BOTH(over_a_half<always, off>(0.25f) == result{9, 0.5f});
  CHECK_BOTH(over_a_half<never, on>(0.75f) == result{0, 0.5f});
}

// ---- depth formats

// What a format keeps of a depth, told by the definition: the number that counts, and the word in the buffer.
struct by_hand {
  double level;
  std::uint32_t word;
};
template <class F>
by_hand kept_by_hand(float z, std::uint32_t before) {
  const double far = irg::nearer_is_less::nearer(F::order::farthest, 0.5f) ? 0 : 1;
  const double least_or_z = !(z >= 0.0f) ? 0 : static_cast<double>(z);
  if constexpr (std::same_as<F, irg::depth_inverse_w>) return {least_or_z, 0};
  const double in_range = std::isnan(z) ? far : std::fmin(least_or_z, 1);
  if constexpr (std::same_as<typename F::stored, float>) {
    return {in_range, 0};
  } else {
    const double level = std::floor(in_range * double{F::largest} + 0.5);
    if constexpr (std::same_as<F, irg::depth24_stencil8>)
      return {level, static_cast<std::uint32_t>(level) * 256 + before % 256};
    return {level, static_cast<std::uint32_t>(level)};
  }
}

// Random triangles into a buffer of the format, by shade_triangle and pixel by pixel; the difference in pixels.
template <class F, irg::depth_test Test, irg::depth_write Write>
int drawn_otherwise(std::uint64_t seed, int width) {
  constexpr int height = 9;
  using stored = typename F::stored;
  test::random r(seed);
  int wrong = 0;
  irg::image<int> ids(width, height, -1), due_ids(width, height, -1);
  irg::image<stored> depth(width, height, F::farthest), due(width, height, F::farthest);
  irg::image<double> levels(width, height, kept_by_hand<F>(F::order::farthest, 0).level);
  if constexpr (std::same_as<F, irg::depth24_stencil8>)
    for (int x = 0; x < width; ++x) depth(x, x % height) += 77, due(x, x % height) += 77;
  for (int i = 0; i < 12; ++i) {
    screen_vertex v[3] = {random_vertex(r, width), random_vertex(r, width), random_vertex(r, width)};
    const bool level = r.integer(0, 2) == 0, twice = i > 0 && r.integer(0, 2) == 0;
    for (auto& c : v) c.depth = level ? v[0].depth : 1.4f * c.depth - 0.2f;
    const irg::solid_shader<int> paint{i};
    for (int times = 0; times < (twice ? 2 : 1); ++times) {
      irg::shade_triangle<F, irg::depth_policy<Test, Write>>(ids, depth, {v[0], v[1], v[2]}, paint);
      screen_vertex u[3] = {v[0], v[1], v[2]};
      if (std::same_as<F, irg::depth_inverse_w>)
        for (auto& c : u) c.depth = c.inverse_w;
      const auto t = irg::cover_and_set_up(u[0], u[1], u[2]);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          if (!covers(t.coverage, x, y)) continue;
          const float z = depth_at(t.setup, x, y);
          const double mine = kept_by_hand<F>(z, 0).level, there = levels(x, y);
          const bool nearer = F::order::nearer(mine, there);
          const bool pass = Test == irg::depth_test::nearer            ? nearer
                            : Test == irg::depth_test::nearer_or_equal ? nearer || mine == there
                            : Test == irg::depth_test::equal           ? mine == there
                                                                       : Test == irg::depth_test::always;
          if (!pass) continue;
          due_ids(x, y) = i;
          if (Write == irg::depth_write::off) continue;
          levels(x, y) = mine;
          if constexpr (std::same_as<stored, float>)
            due(x, y) = static_cast<float>(mine);
          else
            due(x, y) = static_cast<stored>(kept_by_hand<F>(z, due(x, y)).word);
        }
    }
  }
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) wrong += ids(x, y) != due_ids(x, y) || depth(x, y) != due(x, y);
  return wrong;
}

template <class F>
int drawn_otherwise(std::uint64_t seed) {
  using enum irg::depth_test;
  using enum irg::depth_write;
  int wrong = 0;
  for (const int width : {3, 40}) {  // one by one, and in lanes
    wrong += drawn_otherwise<F, nearer, on>(seed, width) + drawn_otherwise<F, nearer, off>(seed, width) +
             drawn_otherwise<F, nearer_or_equal, on>(seed, width) + drawn_otherwise<F, equal, on>(seed, width) +
             drawn_otherwise<F, always, on>(seed, width) + drawn_otherwise<F, never, on>(seed, width);
  }
  return wrong;
}

TEST_CASE("shade_triangle: every depth format, with every depth test and write") {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test::trials(30)); ++seed) {
    REQUIRE(drawn_otherwise<irg::depth_float_reversed>(seed) == 0);
    REQUIRE(drawn_otherwise<irg::depth_float>(seed) == 0);
    REQUIRE(drawn_otherwise<irg::depth_inverse_w>(seed) == 0);
    REQUIRE(drawn_otherwise<irg::depth_unorm16>(seed) == 0);
    REQUIRE(drawn_otherwise<irg::depth_unorm24>(seed) == 0);
    REQUIRE(drawn_otherwise<irg::depth24_stencil8>(seed) == 0);
    REQUIRE(drawn_otherwise<irg::depth_fixed<16, irg::nearer_is_greater>>(seed) == 0);
    REQUIRE(drawn_otherwise<irg::depth_fixed<7>>(seed) == 0);
  }
}

// The word that a level triangle leaves at pixel (10, 2) of a buffer filled with another.
template <class F>
constexpr typename F::stored word_left(float depth, typename F::stored before) {
  irg::image<int> ids(12, 4);
  irg::image<typename F::stored> words(12, 4, before);
  irg::shade_triangle<F>(ids, words, {{{0, 0}, depth, 4.0f}, {{9000, 0}, depth, 4.0f}, {{0, 9000}, depth, 4.0f}},
                         irg::solid_shader<int>{1});
  return words(10, 2);
}

TEST_CASE("shade_triangle: depth formats by hand") {
  CHECK_BOTH(word_left<irg::depth_unorm16>(0.5f, 65535) == 32768);
  CHECK_BOTH(word_left<irg::depth_unorm16>(0.5f, 32768) == 32768);
  CHECK_BOTH(word_left<irg::depth_unorm16>(-3.0f, 1) == 0);
  CHECK_BOTH(word_left<irg::depth_unorm24>(0.5f, 0xffffffu) == 0x800000u);
  CHECK_BOTH(word_left<irg::depth24_stencil8>(0.5f, 0xffffff5au) == 0x8000005au);
  CHECK_BOTH(word_left<irg::depth24_stencil8>(0.5f, 0x8000015au) == 0x8000005au);
  CHECK_BOTH(word_left<irg::depth24_stencil8>(0.5f, 0x7fffffffu) == 0x7fffffffu);
  CHECK_BOTH(word_left<irg::depth_inverse_w>(0.5f, 3.0f) == 4.0f);
  CHECK_BOTH(word_left<irg::depth_inverse_w>(0.5f, 5.0f) == 5.0f);
  CHECK_BOTH(word_left<irg::depth_float_reversed>(7.0f, 0.5f) == 1.0f);
  CHECK_BOTH(word_left<irg::depth_float>(-7.0f, 0.5f) == 0.0f);
}

TEST_CASE("paint_triangle: the painter is given every visible pixel once, and the weights that the shader sees") {
  const screen_vertex v[3] = {{{100, 200}, 0.25f}, {{8000, 900}, 0.5f}, {{2000, 7000}, 0.75f}};
  canvas by_shader(40, 32), by_painter(40, 32);
  const irg::solid_shader<irg::rgba8> white{{255, 255, 255, 255}};
  const irg::draw_counts due = draw(by_shader, v, white);
  int painted = 0;
  const auto paint = [&](irg::rgba8* row, unsigned bits, const auto&) {
    for (; bits != 0; bits &= bits - 1) row[std::countr_zero(bits)] = white.pixel, ++painted;
  };
  const auto counts = irg::paint_triangle<irg::nearer_is_greater, irg::depth_policy<>>(
      by_painter.colour, by_painter.depth, irg::cover_and_set_up(v[0], v[1], v[2]), paint, {0, 0, 40, 32});
  CHECK(counts.shaded == due.shaded);
  CHECK(painted == static_cast<int>(due.shaded));
  CHECK(by_painter == by_shader);
}

}  // namespace
