// SPDX-License-Identifier: MIT
#include <irg/raster/projected_vertices.hpp>

#include <cmath>
#include <cstring>
#include <doctest/doctest.h>
#include <limits>
#include <vector>

#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/scenes.hpp"

namespace {

using point = irg::point<double, 3>;
using irg::clip_planes;
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr auto eye_at_origin = irg::perspective(irg::pi<double> / 2, 1.0, 1.0, infinity);

constexpr irg::projected_vertices<double> projected(const point& p, int width = 64, int height = 32,
                                                    const irg::mat<double, 4, 4>& m = eye_at_origin) {
  const point positions[1] = {p};
  return irg::project_vertices<double>(positions, m, irg::map_to_screen<double>({width, height}));
}
constexpr irg::screen_vertex on_screen(const point& p, int width = 64, int height = 32) {
  return projected(p, width, height).screen[0];
}
constexpr clip_planes cut(const point& p) { return projected(p).codes[0].cut_planes(); }
constexpr clip_planes outside(const point& p) { return projected(p).codes[0].outside_planes(); }

TEST_CASE("project_vertices: by hand") {
  // 90 degrees, at distance 2: the borders of the square view are at x, y = -2 and 2; the picture is stretched.
  CHECK_BOTH(on_screen({0, 0, -2}).position == irg::subpixel{32 * 256, 16 * 256});
  CHECK_BOTH(on_screen({1, 0, -2}).position == irg::subpixel{48 * 256, 16 * 256});
  CHECK_BOTH(on_screen({0, 1, -2}).position ==
             irg::subpixel{32 * 256, 8 * 256});  // up in the world is up in the picture
  CHECK_BOTH(on_screen({0, 0, -2}).depth == 0.5f);
  CHECK_BOTH(on_screen({0, 0, -2}).inverse_w == 0.5f);
  CHECK_BOTH(on_screen({0, 0, -8}).depth == 0.125f);
  constexpr auto clip = [] {
    const point positions[1] = {{3, 4, -5}};
    return irg::clip_position(
        irg::project_vertices<double>(positions, eye_at_origin, irg::map_to_screen<double>({64, 32})), 0);
  };
  CHECK_BOTH(clip() == eye_at_origin * point{3, 4, -5});
  CHECK_BOTH(clip().w == 5);
}

TEST_CASE("project_vertices: beyond which planes") {
  // tan(45 degrees) is rounded, so the borders are tried from a little within.
  CHECK_BOTH(outside({0, 0, -2}) == clip_planes::none);
  CHECK_BOTH(outside({1.999, 1.999, -2}) == clip_planes::none);
  CHECK_BOTH(outside({2.001, 0, -2}) == clip_planes::right);
  CHECK_BOTH(outside({-2.001, 0, -2}) == clip_planes::left);
  CHECK_BOTH(outside({0, 2.001, -2}) == clip_planes::top);
  CHECK_BOTH(outside({0, -2.001, -2}) == clip_planes::bottom);
  CHECK_BOTH(outside({0, 0, -0.999}) == clip_planes::z_near);
  CHECK_BOTH(irg::overlap(outside({0, 0, 3}), clip_planes::z_near));
  // The sides are cut only where the rasterizer's numbers would end: 2^15 pixels from the middle.
  CHECK_BOTH(cut({2.001, 0, -2}) == clip_planes::none);
  CHECK_BOTH(cut({2 * 1023, 0, -2}) == clip_planes::none);
  CHECK_BOTH(cut({2 * 1025, 0, -2}) == clip_planes::right);
  CHECK_BOTH(cut({0, -2 * 2049, -2}) == clip_planes::bottom);
  CHECK_BOTH(cut({0, 0, -0.5}) == clip_planes::z_near);
}

TEST_CASE("project_vertices: w = 0 and the eye itself are cut") {
  CHECK_BOTH(cut({0, 0, 0}) != clip_planes::none);
  CHECK_BOTH(cut({1, 2, 0}) != clip_planes::none);
  CHECK_BOTH(cut({0, 0, -5e-324}) != clip_planes::none);
  CHECK_BOTH(cut({0, 0, 5e-324}) != clip_planes::none);
}

TEST_CASE("project_vertices: what is not finite is cut and outside") {
  const double odd[] = {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity,
                        std::numeric_limits<double>::max()};
  for (int axis = 0; axis < 3; ++axis)
    for (const double value : odd)
      for (const auto& m : {eye_at_origin, irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, -5, 5),
                            irg::perspective(1.0, 1.0, 0.5, 9.0)}) {
        point p{0.5, 0.25, -2};
        p[axis] = value;
        const auto v = projected(p, 64, 32, m);
        CHECK(v.codes[0].cut != 0);
        CHECK(v.codes[0].outside != 0);
      }
}

TEST_CASE("map_to_screen: whatever is not cut can be snapped, in pictures up to 65535 pixels long") {
  test::random r(4);
  for (const int width : {1, 2, 33, 1920, 32768, 65535})
    for (const int height : {1, 7, 1080, 32768, 65535}) {
      const auto mapping = irg::map_to_screen<double>({width, height});
      CHECK(mapping.guard.guard_x >= 1);
      CHECK(mapping.guard.guard_y >= 1);
      for (int i = 0; i < 200; ++i) {
        const double far = std::ldexp(1.0, static_cast<int>(r.integer(0, 17)));
        const point p{far * (2 * r.unit() - 1), far * (2 * r.unit() - 1), -1 - r.unit()};
        const auto v = projected(p, width, height);
        if (v.codes[0].cut != 0) continue;
        const irg::subpixel s = v.screen[0].position;
        REQUIRE(std::abs(s.x) <= 65536 * 256);
        REQUIRE(std::abs(s.y) <= 65536 * 256);
        if (v.codes[0].outside != 0)
          REQUIRE((s.x <= 0 || s.y <= 0 || s.x >= width * 256 || s.y >= height * 256 || p.z > -1));
      }
    }
}

TEST_CASE("project_vertices: the nearest 1/256 pixel, against long double") {
  test::random r(5);
  const auto m = irg::view_projection(irg::camera<double>{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}}, 1.5);
  for (int i = 0; i < 5000; ++i) {
    const point p{r.unit() * 2 - 1, r.unit() * 2 - 1, r.unit() * 2 - 1};
    const auto v = projected(p, 640, 480, m);
    REQUIRE(v.codes[0].cut == 0);
    const auto c = m * p;
    const long double x = (static_cast<long double>(c.x) / static_cast<long double>(c.w) + 1) * 320 * 256;
    const long double y = (1 - static_cast<long double>(c.y) / static_cast<long double>(c.w)) * 240 * 256;
    REQUIRE(std::fabs(x - v.screen[0].position.x) <= 0.5000001L);
    REQUIRE(std::fabs(y - v.screen[0].position.y) <= 0.5000001L);
    REQUIRE(std::fabs(static_cast<double>(v.screen[0].depth) - c.z / c.w) <= 0x1p-24 * c.z / c.w * 1.000001);
  }
}

// Positions as they come, and those that need care: far away, tiny, not finite.
template <class T>
int differences(int positions) {
  test::random r(17);
  constexpr T special[] = {T(0),
                           -T(0),
                           std::numeric_limits<T>::infinity(),
                           std::numeric_limits<T>::quiet_NaN(),
                           (std::numeric_limits<T>::max)(),
                           (std::numeric_limits<T>::min)(),
                           std::numeric_limits<T>::denorm_min(),
                           -(std::numeric_limits<T>::max)()};
  std::vector<irg::point<T, 3>> p;
  for (int i = 0; i < positions; ++i) {
    const T size = i % 3 == 0 ? T(1) : i % 3 == 1 ? T(40) : (std::numeric_limits<T>::min)() * T(3);
    const auto number = [&] {
      return r.integer(0, 30) == 0 ? special[r.integer(0, 7)] : static_cast<T>(r.unit() * 2 - 1) * size;
    };
    const T x = number(), y = number(), z = number();
    p.push_back({x, y, z});
  }
  int wrong = 0;
  for (const auto& to_clip : {irg::perspective(T(1.2), T(1.5), T(0.01), T(30)), irg::identity_matrix<T, 4>(),
                              irg::perspective(T(1.2), T(1.5), (std::numeric_limits<T>::min)(), T(30)),
                              irg::mat<T, 4, 4>{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, T(0x1p127f)}},
                              // z and w independent of each other: behind the eye on either side of the depth planes
                              irg::mat<T, 4, 4>{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}}}) {
    const auto mapping = irg::map_to_screen<T>({640, 480});
    const auto v = irg::project_vertices<T>(p, to_clip, mapping);
    irg::clip_code_pair any;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const irg::hpoint<T, 3> clip = to_clip * p[i];
      const irg::clip_code_pair codes = irg::clip_code(clip, mapping);
      const irg::screen_vertex one = codes.cut == 0 ? irg::to_screen(clip, mapping) : irg::screen_vertex{};
      wrong += !(v.codes[i] == codes) || std::memcmp(&v.screen[i], &one, sizeof one) != 0;
      any = any | codes;
    }
    wrong += !(v.any == any);
  }
  return wrong;
}

TEST_CASE("project_vertices: bit for bit what to_screen and classify give one by one") {
  CHECK(differences<float>(30'001) == 0);
  CHECK(differences<double>(30'001) == 0);
}

TEST_CASE("project_vertices: no positions") {
  CHECK(irg::project_vertices<double>({}, eye_at_origin, irg::map_to_screen<double>({8, 8})).screen.empty());
}

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // the old order goes on compiling
TEST_CASE("project_vertices: the output behind the inputs, and the old order") {
  const std::vector<irg::point<double, 3>> positions{{0, 0, -1}, {0.5, 0.25, -2}};
  const auto mapping = irg::map_to_screen<double>({64, 32});
  irg::projected_vertices<double> now, before;
  irg::project_vertices<double>(positions, eye_at_origin, mapping, now);
  irg::project_vertices<double>(before, positions, eye_at_origin, irg::map_to_screen<double>(64, 32));
  REQUIRE(now.screen.size() == 2);
  CHECK(now.screen[1].position == before.screen[1].position);
  CHECK(now.screen[1].position == irg::project_vertices<double>(positions, eye_at_origin, mapping).screen[1].position);
}

}  // namespace
