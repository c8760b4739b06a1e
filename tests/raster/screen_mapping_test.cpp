// SPDX-License-Identifier: MIT
#include <irg/raster/screen_mapping.hpp>

#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"

namespace {

using irg::classify;
using irg::clip_planes;
using irg::map_to_screen;
using irg::subpixel;
using irg::to_screen;
using H = irg::hpoint<double, 3>;

constexpr auto vga = map_to_screen<double>({640, 480});

constexpr subpixel place(const H& p) { return to_screen(p, vga).position; }

TEST_CASE("screen_mapping: corners and centre of the picture, y down") {
  CHECK_BOTH(place({0, 0, 0.5, 1}) == subpixel{320 * 256, 240 * 256});
  CHECK_BOTH(place({-1, 1, 0.5, 1}) == subpixel{0, 0});
  CHECK_BOTH(place({3, -3, 0.5, 3}) == subpixel{640 * 256, 480 * 256});
  CHECK_BOTH(place({1, 1, 0.5, 2}) == subpixel{480 * 256, 120 * 256});
  CHECK_BOTH(to_screen(H{1, 1, 0.5, 2}, vga).depth == 0.25f);
  CHECK_BOTH(to_screen(H{1, 1, 0.5, 2}, vga).inverse_w == 0.5f);
  constexpr auto one = map_to_screen<double>({1, 1});
  CHECK_BOTH(to_screen(H{0, 0, 0, 1}, one).position == subpixel{128, 128});
}

TEST_CASE("screen_mapping: snapped to the nearest 1/256 pixel, ties up, whichever side of the picture") {
  constexpr auto wide = map_to_screen<double>({512, 512});  // x = -1 to 1 is 512 pixels: 2^-17 is half a step
  const auto x_of = [&](double x) { return to_screen(H{x, 0, 0, 1}, wide).position.x; };
  CHECK(x_of(-1 + 0x1p-17) == 1);
  CHECK(x_of(-1 + 0x1p-18) == 0);
  CHECK(x_of(-1 - 0x1p-17) == 0);
  CHECK(x_of(-1 - 0x1.8p-17) == -1);
}

TEST_CASE("screen_mapping: the planes that a position is beyond") {
  constexpr auto outside = [](const H& p) { return clip_code(p, vga).outside_planes(); };
  constexpr auto cut = [](const H& p) { return clip_code(p, vga).cut_planes(); };
  CHECK_BOTH(outside({0, 0, 1, 2}) == clip_planes::none);
  CHECK_BOTH(outside({2, 2, 2, 2}) == clip_planes::none);  // points on a plane are inside
  CHECK_BOTH(outside({5, 0, 1, 2}) == clip_planes::right);
  CHECK_BOTH(outside({-5, 3, 1, 2}) == (clip_planes::left | clip_planes::top));
  CHECK_BOTH(outside({0, 0, 3, 2}) == clip_planes::z_near);
  CHECK_BOTH(outside({0, 0, -1, 2}) == clip_planes::z_far);
  // The guard band: 2^15 pixels from the centre are 102.4 half widths and 136.5 half heights.
  CHECK_BOTH(cut({5, -9, 1, 2}) == clip_planes::none);
  CHECK_BOTH(cut({204, 0, 1, 2}) == clip_planes::none);
  CHECK_BOTH(cut({205, 0, 1, 2}) == clip_planes::right);
  CHECK_BOTH(cut({0, -273, 1, 2}) == clip_planes::none);
  CHECK_BOTH(cut({0, -274, 1, 2}) == clip_planes::bottom);
  CHECK_BOTH(cut({0, 0, 3, 2}) == clip_planes::z_near);
  // The eye, behind it, no position at all: always cut.
  for (const H& p : {H{0, 0, 0, 0}, H{0, 0, 0, -1}, H{1, 2, 3, 0}, H{1, 1, -1, -2}}) CHECK(cut(p) != clip_planes::none);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double odd : {nan, inf, -inf})
    for (int i = 0; i < 4; ++i) {
      H p{0.1, 0.2, 0.3, 1};
      p[i] = odd;
      if (i == 3 && odd == inf) continue;  // infinitely far away: in the middle of the picture
      CHECK(cut(p) != clip_planes::none);
      CHECK(outside(p) != clip_planes::none);
    }
}

TEST_CASE("screen_mapping: codes of several vertices") {
  constexpr irg::clip_code_pair a{1, 2}, b{3, 6};
  CHECK_BOTH((a | b) == irg::clip_code_pair{3, 6});
  CHECK_BOTH((a & b) == irg::clip_code_pair{1, 2});
  CHECK_BOTH(irg::clip_code_pair{}.outside_planes() == clip_planes::none);
}

TEST_CASE("screen_mapping: within half a step and rounding of the true place, in pictures of every size") {
  test::random r(3);
  for (int i = 0; i < 20000; ++i) {
    const int width = static_cast<int>(r.integer(1, 65536)), height = static_cast<int>(r.integer(1, 65536));
    const auto m = map_to_screen<double>({width, height});
    const double w = std::ldexp(1 + r.unit(), static_cast<int>(r.integer(-30, 30)));
    const H p{(2 * r.unit() - 1) * w, (2 * r.unit() - 1) * w, r.unit() * w, w};
    REQUIRE(clip_code(p, m).cut == 0);
    const auto v = to_screen(p, m);
    const long double x = (static_cast<long double>(p.x) / static_cast<long double>(w) + 1) * width * 128;
    const long double y = (1 - static_cast<long double>(p.y) / static_cast<long double>(w)) * height * 128;
    CHECK(std::fabs(x - v.position.x) <= 0.5000001L);
    CHECK(std::fabs(y - v.position.y) <= 0.5000001L);
    CHECK(v.depth == doctest::Approx(p.z / w).epsilon(1e-7));
    CHECK(v.inverse_w == doctest::Approx(1 / w).epsilon(1e-7));
  }
}

template <class T>
constexpr irg::clip_code_pair code(T x, T y, T z, T w, int width = 512, int height = 512) {
  return irg::clip_code(irg::hpoint<T, 3>{x, y, z, w}, irg::map_to_screen<T>({width, height}));
}

TEST_CASE("classify: the picture's planes, and the guard band 2^15 pixels about its centre") {
  CHECK_BOTH(code<double>(0, 0, 0.5, 1) == irg::clip_code_pair{});
  CHECK_BOTH(code<double>(1, 1, 1, 1) == irg::clip_code_pair{});  // on planes is inside
  CHECK_BOTH(code<double>(2, 0, 0.5, 1).outside_planes() != clip_planes{});
  CHECK_BOTH(code<double>(2, 0, 0.5, 1).cut == 0);
  CHECK_BOTH(code<double>(128, -128, 0.5, 1).cut == 0);  // 256 * 128 = 2^15
  CHECK_BOTH(code<double>(128.001, 0, 0.5, 1).cut != 0);
  CHECK_BOTH(code<double>(0, -128.001, 0.5, 1).cut != 0);
  CHECK_BOTH(code<double>(0, 0, 1.01, 1).cut != 0);  // beyond a depth plane is cut always
  CHECK_BOTH(code<double>(0, 0, -0.01, 1).cut != 0);
  CHECK_BOTH(code<double>(0, 0, 0.5, -1).cut != 0);  // behind the eye
  CHECK_BOTH(code<double>(0, 0, -2, -1).cut_planes() == code<double>(0, 0, -2, -1).outside_planes());  // not z_near
  CHECK_BOTH(code<double>(0, 0, 0, 0) == irg::clip_code_pair{0, static_cast<std::uint8_t>(clip_planes::z_near)});
  CHECK_BOTH(code<double>(1, 0, 0, 0).cut != 0);
  CHECK_BOTH(code<double>(1, 0.1, 0.5, 1, 65536, 65536).cut == 0);  // no room beside the widest picture
  CHECK_BOTH(code<double>(1.001, 0.1, 0.5, 1, 65536, 65536).cut != 0);
  constexpr double inf = std::numeric_limits<double>::infinity();
  CHECK(code<double>(inf, 0, 0.5, 1).cut != 0);
  for (int k = 0; k < 4; ++k) {
    double p[4] = {0, 0, 0.5, 1};
    p[k] = std::numeric_limits<double>::quiet_NaN();
    CHECK(code(p[0], p[1], p[2], p[3]).cut != 0);
    CHECK(code(p[0], p[1], p[2], p[3]).outside != 0);
  }
}

TEST_CASE("to_screen: 1/w stays a positive float, however far away") {
  constexpr auto m = irg::map_to_screen<double>({64, 64});
  CHECK_BOTH(irg::to_screen(H{0, 0, 0, 0x1p125}, m).inverse_w == 0x1p-125f);
  for (const double w : {0x1p127, 0x1p200, 0x1p1000, std::numeric_limits<double>::infinity()})
    CHECK(irg::to_screen(H{0, 0, 0, w}, m).inverse_w == 0x1p-126f);
  CHECK(irg::to_screen(irg::hpoint<float, 3>{0, 0, 0, 0x1p127f}, irg::map_to_screen<float>({64, 64})).inverse_w ==
        0x1p-126f);
}

TEST_CASE("clip_code_pair: or, and, member by member") {
  constexpr irg::clip_code_pair a{5, 4}, b{6, 1};
  CHECK_BOTH((a | b) == irg::clip_code_pair{7, 5});
  CHECK_BOTH((a & b) == irg::clip_code_pair{4, 0});
  CHECK_BOTH(a.outside_planes() == static_cast<clip_planes>(5));
  CHECK_BOTH(a.cut_planes() == static_cast<clip_planes>(4));
}

TEST_CASE("to_screen: within half a 256th of a pixel of the exact place, everywhere in the guard band") {
  test::random r(81);
  const int rounds = test::is_release_tier() ? 2'000'000 : 20000;
  for (int i = 0; i < rounds; ++i) {
    const int width = static_cast<int>(r.integer(1, i % 2 == 0 ? 64 : 65536)),
              height = static_cast<int>(r.integer(1, i % 3 == 0 ? 64 : 65536));
    const auto m = irg::map_to_screen<double>({width, height});
    const double w = std::ldexp(r.unit() + 0.5, static_cast<int>(r.integer(-30, 30)));
    const double reach_x = 32768.0 / m.half_width, reach_y = 32768.0 / m.half_height;
    const H p{(2 * r.unit() - 1) * reach_x * w * 0.999, (2 * r.unit() - 1) * reach_y * w * 0.999, r.unit() * w, w};
    REQUIRE(irg::clip_code(p, m).cut == 0);
    const irg::screen_vertex v = irg::to_screen(p, m);
    const long double x = (static_cast<long double>(p.x) / static_cast<long double>(w) + 1) * width / 2,
                      y = (1 - static_cast<long double>(p.y) / static_cast<long double>(w)) * height / 2;
    REQUIRE(std::abs(static_cast<long double>(v.position.x) - x * 256) < 0.5001L);
    REQUIRE(std::abs(static_cast<long double>(v.position.y) - y * 256) < 0.5001L);
    REQUIRE(std::abs(static_cast<double>(v.depth) - p.z / w) <= 0x1p-24);
    // Outside codes agree with where it lands.
    const bool beside = x < -0.01L || x > width + 0.01L || y < -0.01L || y > height + 0.01L;
    const bool within = x > 0.01L && x < width - 0.01L && y > 0.01L && y < height - 0.01L;
    if (beside) REQUIRE(irg::clip_code(p, m).outside != 0);
    if (within) REQUIRE(irg::clip_code(p, m).outside == 0);
  }
}

}  // namespace
