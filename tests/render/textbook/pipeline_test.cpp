// SPDX-License-Identifier: MIT
// The pipeline on one screen against shade_triangles and against render: the same pixels, depths and weights.
#include <irg/render/textbook/pipeline.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rendered.hpp"

namespace {

using P = irg::point<double, 3>;
using matrix = irg::mat<double, 4, 4>;

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr irg::rgba8 nothing{9, 9, 9, 9};
constexpr matrix eye_at_origin = irg::perspective(irg::pi<double> / 2, 1.0, 0.125, inf);

constexpr irg::rgba8 colour_of(std::size_t n) {
  return {static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(n >> 8), static_cast<std::uint8_t>(n >> 16), 255};
}
constexpr auto by_number = [](std::size_t n, const irg::pixel_weights<float>&) { return colour_of(n); };

struct canvas {
  irg::image<irg::rgba8> picture;
  irg::image<float> depth;
  constexpr canvas(int width, int height) : picture(width, height, nothing), depth(width, height, 0.0f) {}
};

template <class Shade = decltype(by_number)>
constexpr canvas book(const std::vector<P>& corners, const matrix& to_clip, int width, int height,
                      const Shade& shade = by_number) {
  canvas c(width, height);
  irg::textbook::shade_triangles(corners, to_clip, c.picture, c.depth, shade);
  return c;
}

template <class Shade = decltype(by_number)>
constexpr canvas own(const std::vector<P>& corners, const matrix& to_clip, int width, int height,
                     const Shade& shade = by_number) {
  canvas c(width, height);
  const auto mapping = irg::map_to_screen<double>({width, height});
  const auto vertices = irg::project_vertices<double>(corners, to_clip, mapping);
  std::vector<irg::triangle_indices> triangles;
  for (std::uint32_t k = 0; k + 2 < corners.size(); k += 3) triangles.push_back({{k, k + 1, k + 2}});
  irg::shade_triangles(irg::render_target{c.picture, c.depth}, {vertices, triangles, mapping},
                       [&](std::uint32_t n, irg::facing) {
                         return [&shade, n](const irg::pixel_weights<float>& at) { return shade(n, at); };
                       });
  return c;
}

void add_triangles(std::vector<P>& corners, const irg::mesh<double>& m, const matrix& placement) {
  for (const irg::mesh_corner& c : irg::triangulated(m).corners)
    corners.push_back(irg::transform_point(placement, m.positions[c.position]));
}

matrix anywhere_ahead(test::random& r) {
  const auto any = [&](double low, double high) { return low + (high - low) * r.unit(); };
  const double turn = any(-3, 3), tilt = any(-3, 3), size = any(0.5, 1.5), away = any(3, 6);
  const double x = any(-0.9, 0.9), y = any(-0.9, 0.9);
  return irg::translation(irg::vec<double, 3>{x * away, y * away, -away}) * irg::rotation_x(tilt) *
         irg::rotation_y(turn) * irg::scaling(irg::vec<double, 3>{size, size, size});
}

float ulps_apart(float a, float b) { return std::fabs(a - b) / std::ldexp(1.0f, std::ilogb(std::fmax(a, b)) - 23); }

TEST_CASE("textbook::shade_triangles: a convex body has the pixels of shade_triangles, each one, and its depths") {
  test::random r(61);
  long long covered = 0;
  for (int n = 0; n < 300; ++n) {
    std::vector<P> corners;
    const matrix placement = anywhere_ahead(r);
    const int kind = n % 3;
    add_triangles(corners,
                  kind == 0   ? irg::shape_cube<double>()
                  : kind == 1 ? irg::shape_icosahedron<double>()
                              : irg::shape_sphere<double>(),
                  placement);
    const int width = static_cast<int>(r.integer(1, 120)), height = static_cast<int>(r.integer(1, 120));
    const canvas a = book(corners, eye_at_origin, width, height), b = own(corners, eye_at_origin, width, height);
    REQUIRE(a.picture == b.picture);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        if (a.picture(x, y) == nothing) continue;
        REQUIRE(ulps_apart(a.depth(x, y), b.depth(x, y)) <= 8);
        ++covered;
      }
  }
  CHECK(covered > 40000);
}

TEST_CASE(
    "textbook::shade_triangles: bodies through each other, and triangles in disorder: but for close depths the same") {
  test::random r(62);
  long long covered = 0, otherwise = 0;
  for (int n = 0; n < 100; ++n) {
    std::vector<P> corners;
    for (int k = 0; k < 5; ++k) {
      const matrix placement = anywhere_ahead(r);
      if (k % 2 == 0)
        add_triangles(corners, irg::shape_torus<double>({.major_segments = 16, .minor_segments = 8}), placement);
      else
        add_triangles(corners, irg::shape_icosahedron<double>(), placement);
    }
    constexpr int size = 96;
    const canvas a = book(corners, eye_at_origin, size, size), b = own(corners, eye_at_origin, size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        REQUIRE((a.picture(x, y) == nothing) == (b.picture(x, y) == nothing));
        if (a.picture(x, y) == nothing) continue;
        REQUIRE(ulps_apart(a.depth(x, y), b.depth(x, y)) <= 8);
        otherwise += a.picture(x, y) != b.picture(x, y);
        ++covered;
      }
  }
  MESSAGE(covered, " pixels, ", otherwise, " of another triangle as near");
  CHECK(covered > 100000);
  CHECK(otherwise * 10000 <= covered);
}

TEST_CASE(
    "textbook::shade_triangles: centres on edges and corners belong to the triangles that shade_triangles gives them") {
  test::random r(63);
  constexpr int size = 16;
  for (int n = 0; n < 3000; ++n) {
    std::vector<P> corners;
    for (int k = 0; k < 12; ++k) {  // whole and half pixels, in clip space
      const double x = static_cast<double>(r.integer(-4, 36)) / 16 - 1,
                   y = static_cast<double>(r.integer(-4, 36)) / 16 - 1;
      corners.push_back({x, y, static_cast<double>(r.integer(1, 9)) / 16});
    }
    const canvas a = book(corners, irg::identity_matrix<double, 4>(), size, size);
    const canvas b = own(corners, irg::identity_matrix<double, 4>(), size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        REQUIRE((a.picture(x, y) == nothing) == (b.picture(x, y) == nothing));
        if (a.picture(x, y) != b.picture(x, y)) REQUIRE(ulps_apart(a.depth(x, y), b.depth(x, y)) <= 8);
      }
  }
}

TEST_CASE("textbook::shade_triangles: the picture of render") {
  irg::scene<double> world;
  world.ambient = {1, 1, 1};
  world.view.eye = {2.2, 2.4, 4};
  world.view.near_distance = 0.5;
  const irg::mesh<double> shapes[] = {irg::triangulated(irg::shape_teapot<double>()), irg::shape_icosahedron<double>(),
                                      irg::triangulated(irg::shape_sphere<double>())};
  std::vector<P> corners;
  std::vector<irg::rgba8> colours;
  for (std::size_t k = 0; k < 3; ++k) {
    irg::object<double> o;
    o.shape = shapes[k];
    const double part = 0.25 * static_cast<double>(k + 1);
    o.placement = irg::translation(irg::vec<double, 3>{1.6 * part - 0.8, part - 0.5, 0.4 - part});
    o.surface = {{part, 1 - part, 0.5}, {}, {}, 1};
    add_triangles(corners, o.shape, o.placement);
    colours.resize(corners.size() / 3, irg::encode({float(part), float(1 - part), 0.5f}));
    world.objects.push_back(o);
  }
  constexpr int width = 320, height = 240;
  canvas a(width, height);
  irg::clear(a.picture, irg::picture_colours{}.background);
  irg::textbook::shade_triangles(corners, irg::view_projection(world.view, double{width} / height), a.picture, a.depth,
                                 [&](std::size_t n, const auto&) { return colours[n]; });
  const auto by_render = test::render(world, width, height, {.style = irg::picture_style::flat});
  int covered = 0, otherwise = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      covered += a.depth(x, y) > 0;
      otherwise += a.picture(x, y) != by_render.picture.colour(x, y);
      if (a.depth(x, y) > 0) CHECK(ulps_apart(a.depth(x, y), by_render.picture.depth(x, y)) <= 8);
    }
  MESSAGE(covered, " pixels, ", otherwise, " of another colour");
  CHECK(covered > 10000);
  CHECK(otherwise == 0);
}

TEST_CASE("textbook::shade_triangles: weights are corrected for perspective, as those of shade_triangles") {
  const std::vector<P> corners{{-3, -2, -2}, {9, -2, -12}, {-3, 8, -9}};

  canvas c(50, 50);
  const auto coded = [](std::size_t, const irg::pixel_weights<float>& at) {
    const auto part = [](float w) { return static_cast<std::uint32_t>(std::lround(w * 65535)); };
    const std::uint32_t s = part(at.weight1), t = part(at.weight2);
    return irg::rgba8{static_cast<std::uint8_t>(s >> 8), static_cast<std::uint8_t>(s),
                      static_cast<std::uint8_t>(t >> 8), static_cast<std::uint8_t>(t)};
  };
  const canvas a = book(corners, eye_at_origin, 50, 50, coded), b = own(corners, eye_at_origin, 50, 50, coded);
  int covered = 0;
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 50; ++x) {
      REQUIRE((a.depth(x, y) > 0) == (b.depth(x, y) > 0));
      if (!(a.depth(x, y) > 0)) continue;
      const irg::rgba8 p = a.picture(x, y), q = b.picture(x, y);
      REQUIRE(std::abs((p.r << 8 | p.g) - (q.r << 8 | q.g)) <= 1);
      REQUIRE(std::abs((p.b << 8 | p.a) - (q.b << 8 | q.a)) <= 1);
      // By the ray: the point of the triangle's plane behind the pixel's centre, as a sum of its corners.
      const double s = (p.r << 8 | p.g) / 65535.0, t = (p.b << 8 | p.a) / 65535.0;
      const P at{(1 - s - t) * corners[0].x + s * corners[1].x + t * corners[2].x,
                 (1 - s - t) * corners[0].y + s * corners[1].y + t * corners[2].y,
                 (1 - s - t) * corners[0].z + s * corners[1].z + t * corners[2].z};
      REQUIRE(std::fabs(at.x / -at.z - ((x + 0.5) / 25 - 1)) < 2e-3);
      REQUIRE(std::fabs(at.y / -at.z - (1 - (y + 0.5) / 25)) < 2e-3);
      ++covered;
    }
  CHECK(covered > 300);
}

constexpr int pixels_of(const std::vector<P>& corners, int width = 8, int height = 8) {
  const canvas c = book(corners, eye_at_origin, width, height);
  int count = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) count += c.picture(x, y) == nothing ? 0 : 1;
  return count;
}

TEST_CASE("textbook::shade_triangles: backs, corners behind the eye or nowhere, no area, no pixels") {
  CHECK_BOTH(pixels_of({P{-2, -2, -1}, P{2, -2, -1}, P{2, 2, -1}, P{-2, -2, -1}, P{2, 2, -1}, P{-2, 2, -1}}) == 64);
  CHECK_BOTH(pixels_of({P{-2, -2, -1}, P{2, 2, -1}, P{2, -2, -1}}) == 0);  // its back
  CHECK_BOTH(pixels_of({P{-2, -2, -1}, P{2, -2, -1}, P{2, 2, 1}}) == 0);   // behind the eye
  CHECK_BOTH(pixels_of({P{-2, -2, -1}, P{2, -2, -1}, P{2, 2, 0}}) == 0);   // beside it
  CHECK_BOTH(pixels_of({P{-2, -2, -1}, P{0, 0, -1}, P{2, 2, -1}}) == 0);
  CHECK_BOTH(pixels_of({P{-2, -2, -1}, P{2, -2, -1}, P{3e6, 2, -1}}) == 0);  // beyond what can be rounded
  CHECK_BOTH(pixels_of({P{20, 20, -1}, P{21, 20, -1}, P{20, 21, -1}}) == 0);
  CHECK_BOTH(pixels_of({P{-2, -2, -1}, P{2, -2, -1}}) == 0);
  CHECK_BOTH(pixels_of({}) == 0);
  for (const double bad : {nan, inf, -inf, 1e308, -1e308})
    for (std::size_t i = 0; i < 9; ++i) {
      double c[] = {-2, -2, -1, 2, -2, -1, 2, 2, -1};
      c[i] = bad;
      pixels_of({P{c[0], c[1], c[2]}, P{c[3], c[4], c[5]}, P{c[6], c[7], c[8]}});
    }
  CHECK(pixels_of({P{nan, -2, -1}, P{2, -2, -1}, P{2, 2, -1}}) == 0);
  CHECK(pixels_of({P{-2, -2, nan}, P{2, -2, -1}, P{2, 2, -1}}) == 0);
  CHECK(pixels_of({P{-2, -2, -1}, P{2, -2, -1}, P{2, 2, -1}}, 0, 0) == 0);
}

TEST_CASE("textbook::shade_triangles: what is nearer hides, in either order; of equal depths the first stays") {
  constexpr auto seen = [](const std::vector<P>& corners) {
    return book(corners, eye_at_origin, 4, 4).picture(2, 2).r;
  };
  constexpr auto at = [](double z) { return std::array{P{3 * z, 3 * z, z}, P{-3 * z, 3 * z, z}, P{0, -3 * z, z}}; };
  constexpr auto both = [](const auto& a, const auto& b) {
    std::vector<P> all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    return all;
  };
  CHECK_BOTH(seen(both(at(-2), at(-3))) == 0);
  CHECK_BOTH(seen(both(at(-3), at(-2))) == 1);
  CHECK_BOTH(seen(both(at(-2), at(-2))) == 0);
}

}  // namespace
