// SPDX-License-Identifier: MIT
#include <irg/render/mip_textured_shading.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/render/draw_transparent.hpp>
#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::rgba8;
using irg::textured_vertex;
using batch = irg::triangle_batch<double>;
using point = irg::point<double, 3>;
using shading = irg::mip_textured_shading<double>;
using real = long double;

// Takes the plain path: the order is nearer_is_greater, under another name.
struct plainly {
  static constexpr float farthest = 0.0f;
  template <class T>
  static constexpr auto nearer(const T& a, const T& b) noexcept {
    return b < a;
  }
};

constexpr int width = 64, height = 48;
constexpr irg::mat<double, 4, 4> view() { return irg::perspective(irg::pi<double> / 2, 4.0 / 3, 0.5, 1000.0); }

// Black and white squares of 16 texels.
constexpr irg::image<rgba8> chequers() {
  irg::image<rgba8> t(32, 32, {255, 255, 255, 255});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      if ((x / 16 + y / 16) % 2 != 0) t(x, y) = {0, 0, 0, 255};
  return t;
}

// Triangles with texture coordinates, projected.
struct surface {
  std::vector<point> positions;
  std::vector<textured_vertex> vertices;
  std::vector<irg::triangle_indices> triangles;
  irg::screen_mapping<double> mapping = irg::map_to_screen<double>({width, height});
  irg::projected_vertices<double> projected{};
  constexpr batch project() {
    projected = irg::project_vertices<double>(positions, view(), mapping);
    return {&projected, triangles};
  }
};

// A floor one unit below the eye, from beside it to far away: u to the right, v into the distance, one texture a unit.
constexpr surface make_floor() {
  surface s;
  for (const auto& [x, z] : {std::pair{-400.0, 4.0}, {400.0, 4.0}, {400.0, -900.0}, {-400.0, -900.0}}) {
    s.positions.push_back({x, -1, z});
    s.vertices.push_back(irg::make_textured_vertex(static_cast<float>(x), static_cast<float>(z)));
  }
  s.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  return s;
}

// What a triangle's u (or v) is at a place of the picture, in pixels: where the ray through it meets the plane.
real at_place(const surface& s, const irg::triangle_indices& t, int which, real x, real y) {
  const real direction[3] = {(x - width / 2) / (width / 2) * 4 / 3, (height / 2 - y) / (height / 2), -1};
  real p[3][3], n[3];
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) p[i][k] = static_cast<real>(s.positions[t.v[i]][k]);
  const auto cross = [](const real* a, const real* b, real* out) {
    for (int k = 0; k < 3; ++k) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  };
  const auto dot = [](const real* a, const real* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  real e1[3], e2[3], to[3];
  for (int k = 0; k < 3; ++k) e1[k] = p[1][k] - p[0][k], e2[k] = p[2][k] - p[0][k];
  cross(e1, e2, n);
  const real along = dot(n, p[0]) / dot(n, direction);
  for (int k = 0; k < 3; ++k) to[k] = along * direction[k] - p[0][k];
  // to = s e1 + t e2
  const real a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2), d = dot(to, e1), e = dot(to, e2), det = a * c - b * b;
  const auto value = [&](int i) { return static_cast<real>(s.vertices[t.v[i]][static_cast<std::size_t>(which)]); };
  return value(0) + (d * c - e * b) / det * (value(1) - value(0)) + (e * a - d * b) / det * (value(2) - value(0));
}

// The level by what u and v are a thousandth of a pixel aside.
real level_at(const surface& s, const irg::triangle_indices& t, int x, int y, int size) {
  constexpr real h = 1e-3L;
  const real cx = static_cast<real>(x) + 0.5L, cy = static_cast<real>(y) + 0.5L;
  real longest = 0;
  for (int down = 0; down < 2; ++down) {
    const real dx = down ? 0 : h, dy = down ? h : 0;
    real square = 0;
    for (int k = 0; k < 2; ++k) {
      const real d = (at_place(s, t, k, cx + dx, cy + dy) - at_place(s, t, k, cx - dx, cy - dy)) / (2 * h) * size;
      square += d * d;
    }
    longest = std::max(longest, square);
  }
  return std::max(std::log2(longest) / 2, 0.0L);
}

// A pixel shader that keeps the level at each pixel.
struct level_maker {
  const shading& of;
  int size;
  struct shader {
    irg::mip_textured_shader of;
    int size;
    float operator()(const irg::pixel_weights<float>& at) const { return of.level(at, {size, size}); }
  };
  shader operator()(const batch& b, std::uint32_t triangle, irg::facing side) const {
    return {of(b, triangle, side), size};
  }
};

TEST_CASE("mip_textured_shading: levels against differences of long doubles, through the eye and beside it") {
  test::random r(1);
  float worst = 0;
  int pixels = 0, above = 0;
  for (int i = 0; i < 300; ++i) {
    surface s;
    if (i == 0) {
      s = make_floor();
    } else {
      const double depth = r.integer(0, 1) ? 3 : 40,
                   middle = r.integer(0, 2) ? -1.6 * depth : 0;  // some behind the eye
      for (int k = 0; k < 3; ++k) {
        const double x = (r.unit() - 0.5) * depth, y = (r.unit() - 0.5) * depth;
        s.positions.push_back({x, y, middle + (r.unit() - 0.5) * depth});
        const auto u = static_cast<float>(r.integer(-40, 40)) / 4;
        s.vertices.push_back(irg::make_textured_vertex(u, static_cast<float>(r.integer(-40, 40)) / 4));
      }
      s.triangles = {{{0, 1, 2}}};
    }
    const batch one[1] = {s.project()};
    const irg::textured_vertices objects[1] = {{s.vertices}};
    const shading of{objects, {}, s.mapping};
    irg::image<float> levels(width, height, -1.0f), depth(width, height, 0.0f);
    const irg::draw_options<float> settings{irg::face_culling::none};
    irg::shade_batches(irg::render_target{levels, depth}, {one, s.mapping}, level_maker{of, 32}, settings);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        if (levels(x, y) < 0) continue;
        // Which of the two triangles it is does not matter: they lie in one plane, with one texture.
        const real expected = level_at(s, s.triangles[0], x, y, 32);
        // Vertices are snapped, so that the triangle is seen a little tilted; slivers and edges are left out.
        if (!(expected < 12)) continue;
        ++pixels;
        above += expected > 0;
        worst = std::max(worst, static_cast<float>(std::fabs(static_cast<real>(levels(x, y)) - expected)));
      }
  }
  MESSAGE(pixels, " pixels, ", above, " above level 0: within ", worst, " of a level");
  CHECK(pixels > 20000);
  CHECK(above > 10000);
  CHECK(worst <= 0.02f);
}

TEST_CASE("mip_textured_shading: a floor to the horizon: its mean far away, its chequers near") {
  surface s = make_floor();
  const batch one[1] = {s.project()};
  const auto texels = chequers();
  const auto levels = irg::make_mip_pyramid(texels);
  const irg::textured_vertices objects[1] = {{s.vertices}};
  const irg::texture_pyramid pyramids[1] = {{&levels}};
  const irg::texture_image textures[1] = {{texels.view()}};
  irg::image<rgba8> with(width, height), without(width, height);
  irg::image<float> depth(width, height, 0.0f);
  const shading mips{objects, pyramids, s.mapping};
  irg::shade_batches(irg::render_target{with, depth}, {one, s.mapping}, mips);
  const irg::textured_shading full{objects, textures};
  const irg::draw_options<rgba8> again{.clear = irg::clearing::before_drawing};
  irg::shade_batches(irg::render_target{without, depth}, {one, s.mapping}, full, again);
  const auto spread = [&](const irg::image<rgba8>& p, int y) {
    int low = 255, high = 0;
    for (int x = 0; x < width; ++x) low = std::min<int>(low, p(x, y).r), high = std::max<int>(high, p(x, y).r);
    return high - low;
  };
  CHECK(spread(with, height / 2 + 1) <= 2);
  CHECK(std::abs(with(9, height / 2 + 1).r - irg::encode({0.5f, 0.5f, 0.5f}).r) <= 2);
  CHECK(spread(without, height / 2 + 1) > 50);
  CHECK(spread(with, height - 1) > 150);
  CHECK(with(3, 3) == rgba8{});

  // The plain way, threads, and drawn as transparent: the same bytes.
  irg::image<rgba8> other(width, height);
  depth = irg::image<float>(width, height, 0.0f);
  irg::shade_batches<plainly, double>(irg::render_target{other, depth}, {one, s.mapping}, mips);
  CHECK(other == with);
  depth = irg::image<float>(width, height, 0.0f);
  other = irg::image<rgba8>(width, height);
  irg::shade_batches(irg::render_target{other, depth}, {one, s.mapping}, mips, {}, irg::parallel{3});
  CHECK(other == with);
  depth = irg::image<float>(width, height, 0.0f);
  other = irg::image<rgba8>(width, height);
  irg::draw_transparent(irg::render_target{other, depth}, {one, s.mapping}, mips);
  CHECK(other == with);
}

TEST_CASE("mip_textured_shading: small triangles of several textures, in lanes as one by one") {
  test::random r(2);
  const auto squares = chequers();
  irg::image<rgba8> dots(7, 5);
  for (int i = 0; i < 35; ++i) dots(i % 7, i / 7) = std::bit_cast<rgba8>(static_cast<std::uint32_t>(r.next()));
  const auto levels = irg::make_mip_pyramid(squares), others = irg::make_mip_pyramid(dots);
  for (int i = 0; i < 40; ++i) {
    surface s = make_floor();
    s.positions.clear(), s.vertices.clear(), s.triangles.clear();
    const int across = i < 20 ? 24 : 3;  // squares of two triangles each, on a floor
    for (int k = 0; k < (across + 1) * (across + 1); ++k)
      s.positions.push_back({-4.0 + 8.0 * (k % (across + 1)) / across, -1, -0.2 - 6.0 * (k / (across + 1)) / across});
    for (int k = 0; k < static_cast<int>(s.positions.size()); ++k) {
      const auto place = [&] { return static_cast<float>((r.unit() - 0.5) * (i % 3 == 0 ? 40 : 2)); };
      const float u = place(), v = place();
      const int texture = i % 2 == 0 ? 0 : k / 7 % 3;  // mixed on the way, too
      s.vertices.push_back(irg::make_textured_vertex(u, v, {1, static_cast<float>(r.unit()), 0.5f}, texture));
    }
    for (int y = 0; y < across; ++y)
      for (int x = 0; x < across; ++x) {
        const auto a = static_cast<std::uint32_t>(y * (across + 1) + x), row = static_cast<std::uint32_t>(across + 1);
        s.triangles.push_back({{a, a + 1, a + row}});
        s.triangles.push_back({{a + 1, a + row + 1, a + row}});
      }
    const batch one[1] = {s.project()};
    const irg::textured_vertices objects[1] = {{s.vertices}};
    const auto wrap = static_cast<irg::texture_wrap>(i % 4);
    const irg::texture_pyramid pyramids[3] = {
        {&levels, {irg::texture_filter::bilinear, wrap, irg::texture_wrap::repeat}},
        {&others, {static_cast<irg::texture_filter>(i % 5 != 0), irg::texture_wrap::clamp, wrap}},
        {}};
    const irg::texture_image textures[2] = {{squares.view(), pyramids[0].sampler}, {dots.view(), pyramids[1].sampler}};
    const auto compare = [&](const auto& shading_of) {
      irg::image<rgba8> many(width, height), each(width, height);
      irg::image<float> depth(width, height, 0.0f);
      const irg::draw_options<rgba8> settings{irg::face_culling::none};
      irg::shade_batches(irg::render_target{many, depth}, {one, s.mapping}, shading_of, settings);
      depth = irg::image<float>(width, height, 0.0f);
      irg::draw_transparent(irg::render_target{each, depth}, {one, s.mapping}, shading_of);
      CHECK(many == each);
      CHECK(many != irg::image<rgba8>(width, height));
    };
    compare(shading{objects, pyramids, s.mapping});
    compare(irg::textured_shading{objects, textures});
  }
}

// A square of the whole picture of size x size pixels, the chequers once across it.
constexpr rgba8 square_at(int x, int y, int size, irg::texture_sampler sampler, int texture, int count) {
  const std::vector<point> positions{{-1, 1, -2}, {1, 1, -2}, {-1, -1, -2}, {1, -1, -2}};
  const std::vector<irg::triangle_indices> triangles{{{0, 2, 1}}, {{1, 2, 3}}};
  std::vector<textured_vertex> vertices;
  for (int i = 0; i < 4; ++i)
    vertices.push_back(
        irg::make_textured_vertex(static_cast<float>(i % 2), static_cast<float>(i / 2), {1, 1, 0.5f}, texture));
  irg::image<rgba8> texels(8, 8, {255, 255, 255, 255});
  for (int i = 0; i < 64; ++i)
    if ((i / 32 + i % 8 / 4) % 2 != 0) texels(i % 8, i / 8) = {0, 0, 0, 255};
  const auto levels = irg::make_mip_pyramid(texels);
  const irg::mip_pyramid<irg::rgb<float>> none;
  const auto mapping = irg::map_to_screen<double>({size, size});
  const auto projected = irg::project_vertices<double>(
      positions, irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, 0, 8), mapping);
  const irg::textured_vertices objects[1] = {{vertices}};
  const irg::texture_pyramid textures[3] = {{&levels, sampler}, {&none}, {}};
  irg::image<rgba8> colour(size, size);
  irg::image<float> depth(size, size, 0.0f);
  const batch one[1] = {{&projected, triangles, 0}};
  irg::shade_batches(irg::render_target{colour, depth}, {one, mapping},
                     shading{objects, std::span(textures).first(static_cast<std::size_t>(count)), mapping});
  return colour(x, y);
}

TEST_CASE("mip_textured_shading: by hand, in constant evaluation and at run time") {
  constexpr irg::texture_sampler nearest{irg::texture_filter::nearest};
  const rgba8 white{255, 255, 188, 255}, black{0, 0, 0, 255};
  // As many pixels as level 1 has texels; as level 2; one pixel for two squares of each kind.
  CHECK_BOTH(square_at(0, 0, 4, nearest, 0, 1) == rgba8{255, 255, 188, 255});
  CHECK_BOTH(square_at(3, 1, 4, nearest, 0, 1) == rgba8{0, 0, 0, 255});
  CHECK_BOTH(square_at(0, 0, 2, nearest, 0, 1) == rgba8{255, 255, 188, 255});
  CHECK_BOTH(square_at(0, 0, 1, nearest, 0, 1) == irg::encode({0.5f, 0.5f, 0.25f}));
  CHECK(square_at(20, 3, 40, nearest, 0, 1) == black);  // larger than the texture
  CHECK(square_at(3, 3, 40, nearest, 0, 1) == white);
  // No textures: the light alone. Without levels, or without a pyramid: black. Numbers too large: the last.
  CHECK(square_at(0, 0, 2, nearest, 0, 0) == irg::encode({1, 1, 0.5f}));
  CHECK(square_at(0, 0, 2, nearest, 1, 3) == black);
  CHECK(square_at(0, 0, 2, nearest, 7, 3) == black);
  CHECK(square_at(0, 0, 2, nearest, -7, 3) == white);
}

}  // namespace
