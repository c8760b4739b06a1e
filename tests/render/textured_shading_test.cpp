// SPDX-License-Identifier: MIT
#include <irg/render/textured_shading.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::rgba8;
using irg::texture_filter;
using irg::texture_wrap;
using irg::textured_vertex;
using batch = irg::triangle_batch<double>;
using point = irg::point<double, 3>;

static_assert(irg::AttributeShading<irg::textured_shading, batch>);

// Takes the plain path: the order is nearer_is_greater, under another name.
struct plainly {
  static constexpr float farthest = 0.0f;
  template <class T>
  static constexpr auto nearer(const T& a, const T& b) noexcept {
    return b < a;
  }
};

constexpr irg::image<rgba8> chequers() {
  irg::image<rgba8> t(2, 2, rgba8{255, 255, 255, 255});
  t(1, 0) = t(0, 1) = {0, 0, 0, 255};
  return t;
}

// A square of the whole picture, its texture coordinates from 0 to 1 across it.
constexpr rgba8 square_at(int x, int y, irg::texture_sampler sampler, irg::rgb<float> light) {
  const std::vector<point> positions{{-1, 1, -2}, {1, 1, -2}, {-1, -1, -2}, {1, -1, -2}};
  const std::vector<irg::triangle_indices> triangles{{{0, 2, 1}}, {{1, 2, 3}}};
  const std::vector<textured_vertex> vertices{
      irg::make_textured_vertex(0, 0, light), irg::make_textured_vertex(1, 0, light),
      irg::make_textured_vertex(0, 1, light), irg::make_textured_vertex(1, 1, light)};
  const auto mapping = irg::map_to_screen<double>({4, 4});
  const auto projected = irg::project_vertices<double>(
      positions, irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, 0, 8), mapping);
  const auto picture = chequers();
  const irg::textured_vertices objects[1] = {{vertices}};
  const irg::texture_image textures[1] = {{picture.view(), sampler}};
  irg::image<rgba8> colour(4, 4);
  irg::image<float> depth(4, 4, 0.0f);
  const batch one[1] = {{&projected, triangles, 0}};
  irg::shade_batches(irg::render_target{colour, depth}, {one, mapping}, irg::textured_shading{objects, textures});
  return colour(x, y);
}

TEST_CASE("textured_shading: a square by hand") {
  constexpr irg::texture_sampler nearest{texture_filter::nearest, texture_wrap::repeat, texture_wrap::repeat},
      bilinear{texture_filter::bilinear, texture_wrap::clamp, texture_wrap::clamp};
  CHECK_BOTH(square_at(0, 0, nearest, {1, 1, 1}) == rgba8{255, 255, 255, 255});
  CHECK_BOTH(square_at(1, 1, nearest, {1, 1, 1}) == rgba8{255, 255, 255, 255});
  CHECK_BOTH(square_at(2, 1, nearest, {1, 1, 1}) == rgba8{0, 0, 0, 255});
  CHECK_BOTH(square_at(1, 2, nearest, {1, 1, 1}) == rgba8{0, 0, 0, 255});
  CHECK_BOTH(square_at(3, 3, nearest, {1, 0.5f, 0}) == rgba8{255, 188, 0, 255});
  CHECK_BOTH(square_at(0, 0, bilinear, {1, 1, 1}) == rgba8{255, 255, 255, 255});
  // The pixel (1, 0) has u = 3/8, a quarter of the way from white to black.
  CHECK_BOTH(square_at(1, 0, bilinear, {1, 1, 1}) == irg::encode({0.75f, 0.75f, 0.75f}));
  CHECK_BOTH(square_at(1, 1, bilinear, {1, 1, 1}) == irg::encode({0.625f, 0.625f, 0.625f}));
}

TEST_CASE("textured_shading: no texture, no texels, numbers out of range") {
  const auto picture = chequers();
  const irg::texture_image textures[2] = {{picture.view(), {texture_filter::nearest}}, {}};
  const irg::textured_shading without{{}, {}}, with{{}, textures};
  CHECK(without.pixel({0, 0, 1, 0.5f, 0.25f, 0}) == irg::encode({1, 0.5f, 0.25f}));
  CHECK(with.pixel({0.1f, 0.1f, 1, 0.5f, 0.25f, 0}) == irg::encode({1, 0.5f, 0.25f}));
  for (const float n : {-1.0f, 0.99f, std::numeric_limits<float>::quiet_NaN()})
    CHECK(with.pixel({0.1f, 0.1f, 1, 1, 1, n}) == rgba8{255, 255, 255, 255});
  for (const float n : {1.0f, 7.0f, std::numeric_limits<float>::infinity()})
    CHECK(with.pixel({0.1f, 0.1f, 1, 1, 1, n}) == rgba8{0, 0, 0, 255});
}

// Of 2^24 + 4 textures the last has a number that no float is; the next float is one too many.
TEST_CASE("textured_shading: the last of more textures than floats count") {
  constexpr auto last_of = [](std::size_t count) { return irg::detail::texture_index(1e30f, count); };
  CHECK_BOTH(last_of(3) == 2);
  CHECK_BOTH(last_of((1 << 24) + 4) == (1 << 24) + 3);
}

TEST_CASE("textured_shading: a register of pixels has the bits of single ones") {
  constexpr int N = irg::native_lanes<float>;
  test::random r(51);
  std::vector<irg::image<rgba8>> pictures;
  for (const auto& [w, h] : {std::pair{7, 5}, {1, 1}, {64, 3}, {0, 0}}) {
    pictures.emplace_back(w, h);
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) pictures.back()(x, y) = std::bit_cast<rgba8>(static_cast<std::uint32_t>(r.next()));
  }
  for (int i = 0; i < 20000; ++i) {
    std::vector<irg::texture_image> textures;
    for (const auto& p : pictures) {
      const int w = p.width(), h = p.height();
      irg::image_view<const rgba8> view = p.view();
      if (i % 3 == 1 && h > 0) view = {p.row(h - 1), w, h, -p.bytes_per_row()};  // bottom up
      if (i % 3 == 2 && h > 2) view = {p.row(0) + 1, w - 1, h / 2, 2 * p.bytes_per_row() - i % 4};  // a part; odd bytes
      textures.push_back({view,
                          {static_cast<texture_filter>(r.integer(0, 3) != 0),
                           static_cast<texture_wrap>(r.integer(0, 3)), static_cast<texture_wrap>(r.integer(0, 2))}});
    }
    const irg::textured_shading shading{{}, std::span(textures).first(static_cast<std::size_t>(r.integer(0, 4)))};
    std::array<irg::pack<float, N>, 6> at;
    const auto same = static_cast<float>(r.integer(0, 3));
    for (int k = 0; k < N; ++k) {
      for (std::size_t j = 0; j < 2; ++j) {
        at[j].v[k] = static_cast<float>((r.unit() - 0.5) * 6);
        if (r.integer(0, 40) == 0) at[j].v[k] = std::bit_cast<float>(static_cast<std::uint32_t>(r.next()));
      }
      for (std::size_t j = 2; j < 5; ++j) at[j].v[k] = static_cast<float>(r.unit() * 1.5 - 0.1);
      at[5].v[k] = i % 4 != 0 ? same : static_cast<float>(r.integer(-1, 4));
    }
    const auto words = shading.pixels(at);
    for (int k = 0; k < N; ++k)
      REQUIRE(std::bit_cast<rgba8>(words[k]) ==
              shading.pixel({at[0][k], at[1][k], at[2][k], at[3][k], at[4][k], at[5][k]}));
  }
}

// ---- perspective: corners whose w are as 1 to 100000

// Records the attributes themselves.
struct recorder {
  static constexpr int attribute_count = 6;
  irg::textured_shading shading;
  const float* attributes(const batch& b, std::uint32_t v, irg::facing side) const {
    return shading.attributes(b, v, side);
  }
  textured_vertex pixel(const textured_vertex& at) const { return at; }
};

TEST_CASE("textured_shading: u and v within 4e-7 of the exact ones where the w of the corners differ by up to 1e5") {
  test::random r(52);
  const int size = 96;
  long long pixels = 0;
  long double worst = 0;
  for (int i = 0; i < 120; ++i) {
    // Three points of the picture, each at a distance of its own: 1 to 1e5 by powers of ten.
    const auto mapping = irg::map_to_screen<double>({size, size});
    std::vector<point> positions;
    std::vector<textured_vertex> vertices;
    for (int k = 0; k < 3; ++k) {
      const double away = k == 0 ? 1 : k == 1 ? 1e5 : std::pow(10.0, static_cast<double>(r.integer(0, 5)));
      const double x = static_cast<double>(r.integer(-64, 64)) / 64, y = static_cast<double>(r.integer(-64, 64)) / 64;
      positions.push_back({x * away, y * away, -away});
      vertices.push_back(irg::make_textured_vertex(static_cast<float>(r.unit()), static_cast<float>(r.unit())));
    }
    const irg::triangle_indices triangle[1] = {{{0, 1, 2}}};
    const auto projected =
        irg::project_vertices<double>(positions, irg::perspective(irg::pi<double> / 2, 1.0, 0.5, 1e6), mapping);
    const irg::textured_vertices objects[1] = {{vertices}};
    const batch one[1] = {{&projected, triangle, 0}};
    irg::image<textured_vertex> seen(size, size);
    irg::image<float> depth(size, size, 0.0f);
    irg::draw_options<textured_vertex> settings;
    settings.culling = irg::face_culling::none;
    irg::shade_batches(irg::render_target{seen, depth}, {one, mapping}, recorder{{objects, {}}}, settings);
    // The exact weights, from the snapped positions and 1/w, in long double.
    long double px[3], py[3], q[3];
    for (std::size_t k = 0; k < 3; ++k) {
      px[k] = projected.screen[k].position.x / 256.0L;
      py[k] = projected.screen[k].position.y / 256.0L;
      q[k] = static_cast<long double>(projected.screen[k].inverse_w);
    }
    const long double area = (px[1] - px[0]) * (py[2] - py[0]) - (py[1] - py[0]) * (px[2] - px[0]);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        if (depth(x, y) == 0.0f) continue;
        const long double cx = x + 0.5L, cy = y + 0.5L;
        long double b[3], sum = 0, u = 0, v = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t m = (k + 1) % 3, n = (k + 2) % 3;
          b[k] = ((px[n] - px[m]) * (cy - py[m]) - (py[n] - py[m]) * (cx - px[m])) / area * q[k];
          sum += b[k];
          u += b[k] * static_cast<long double>(vertices[k][0]);
          v += b[k] * static_cast<long double>(vertices[k][1]);
        }
        worst = std::max({worst, std::abs(static_cast<long double>(seen(x, y)[0]) - u / sum),
                          std::abs(static_cast<long double>(seen(x, y)[1]) - v / sum)});
        ++pixels;
      }
  }
  MESSAGE(pixels, " pixels, u and v off by at most ", static_cast<double>(worst));
  CHECK(pixels > 50000);
  CHECK(worst < 4e-7L);
}

TEST_CASE("textured_shading: the fast way equals the plain one, several textures and objects, both sides") {
  test::random r(53);
  std::vector<irg::image<rgba8>> pictures;
  for (int k = 0; k < 3; ++k) {
    pictures.emplace_back(4 + 3 * k, 8);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < pictures.back().width(); ++x)
        pictures.back()(x, y) = std::bit_cast<rgba8>(static_cast<std::uint32_t>(r.next()));
  }
  for (int i = 0; i < 60; ++i) {
    const int width = static_cast<int>(r.integer(1, 150)), height = static_cast<int>(r.integer(1, 100));
    const auto mapping = irg::map_to_screen<double>({width, height});
    std::vector<point> positions[2];
    std::vector<textured_vertex> front[2], back;
    std::vector<irg::triangle_indices> triangles[2];
    for (int o = 0; o < 2; ++o)
      for (std::uint32_t t = 0; t < 20; ++t) {
        const auto texture = static_cast<int>(r.integer(0, 2));
        for (int k = 0; k < 3; ++k) {
          const double away = r.unit() * 8 - 1, size = i % 2 == 0 ? 1 : 8;
          positions[o].push_back({(r.unit() - 0.5) * 2 * size, (r.unit() - 0.5) * 2 * size, -away});
          const auto any = [&] { return static_cast<float>(r.unit() * 4 - 1); };
          const float u = any(), v = any(), red = any(), green = any();
          front[o].push_back(irg::make_textured_vertex(u, v, {red, green, any()}, texture));
          if (o == 0) back.push_back(irg::make_textured_vertex(v, u, {green, red, any()}, texture));
        }
        triangles[o].push_back({{3 * t, 3 * t + 1, 3 * t + 2}});
      }
    const irg::textured_vertices objects[2] = {{front[0], back}, {front[1]}};
    std::vector<irg::texture_image> textures;
    for (const auto& p : pictures)
      textures.push_back({p.view(),
                          {static_cast<texture_filter>(r.integer(0, 3) != 0),
                           static_cast<texture_wrap>(r.integer(0, 3)), static_cast<texture_wrap>(r.integer(0, 3))}});
    const auto to_clip = irg::perspective(irg::pi<double> / 2, 1.0, 0.25, 100.0);
    const irg::projected_vertices<double> projected[2] = {
        irg::project_vertices<double>(positions[0], to_clip, mapping),
        irg::project_vertices<double>(positions[1], to_clip, mapping)};
    const batch two[2] = {{&projected[0], triangles[0], 0, 0}, {&projected[1], triangles[1], 20, 1}};
    const irg::textured_shading shading{objects, textures};
    const irg::draw_options<rgba8> settings{irg::face_culling::none, {}, irg::clearing::before_drawing, {9, 8, 7, 6}};
    const auto draw = [&]<class Order, class E>(Order, const E& executor) {
      irg::image<rgba8> colour(width, height);
      irg::image<float> depth(width, height, 0.5f);
      irg::shade_batches<Order, double>(irg::render_target{colour, depth}, {two, mapping}, shading, settings, executor);
      return colour;
    };
    const auto expected = draw(plainly{}, irg::sequential{});
    REQUIRE(draw(irg::nearer_is_greater{}, irg::sequential{}) == expected);
    REQUIRE(draw(irg::nearer_is_greater{}, irg::parallel{3}) == expected);
  }
}

}  // namespace
