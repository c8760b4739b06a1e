// SPDX-License-Identifier: MIT
#include <irg/colour/over.hpp>

#include <cmath>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::rgba8;
constexpr irg::over_in_light light;
constexpr irg::over_as_encoded encoded;

TEST_CASE("over: nothing, everything, half of it") {
  constexpr rgba8 wall{10, 100, 200, 255};
  CHECK_BOTH(light(wall, {1, 2, 3, 0}) == wall);
  CHECK_BOTH(light(wall, {1, 2, 3, 255}) == rgba8{1, 2, 3, 255});
  CHECK_BOTH(encoded(wall, {1, 2, 3, 0}) == wall);
  CHECK_BOTH(encoded(wall, {1, 2, 3, 255}) == rgba8{1, 2, 3, 255});
  // 51 of 255 are a fifth; a fifth of the light is code 124.
  CHECK_BOTH(light({0, 0, 0, 255}, {255, 255, 255, 51}) == rgba8{124, 124, 124, 255});
  CHECK_BOTH(encoded({0, 0, 0, 255}, {255, 255, 255, 51}) == rgba8{51, 51, 51, 255});
  // Over what is transparent itself: over nothing it is alone; opacities add as what they leave multiplies.
  CHECK_BOTH(light({9, 9, 9, 0}, {40, 50, 60, 51}) == rgba8{40, 50, 60, 51});
  CHECK_BOTH(light({0, 0, 0, 102}, {0, 0, 0, 51}).a == 133);  // 1 - 3/5 * 4/5 = 0.52
}

TEST_CASE("over: against double precision") {
  test::random r(31);
  const auto to_light = [](std::uint8_t code) {
    const double c = code / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const auto to_code = [](double l) {
    return 255 * (l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055);
  };
  for (int i = 0; i < 100000; ++i) {
    const auto byte = [&] { return static_cast<std::uint8_t>(r.next() >> 56); };
    const rgba8 b{byte(), byte(), byte(), i % 2 == 0 ? std::uint8_t{255} : byte()}, a{byte(), byte(), byte(), byte()};
    const rgba8 o = light(b, a);
    const double t = a.a / 255.0, rest = b.a / 255.0 * (1 - t), opacity = t + rest;
    REQUIRE(std::abs(o.a - 255 * opacity) <= 0.5 + 1e-9);
    if (opacity == 0) continue;
    const auto near = [&](std::uint8_t out, std::uint8_t below, std::uint8_t above) {
      return std::abs(out - to_code((to_light(above) * t + to_light(below) * rest) / opacity)) < 0.5001;
    };
    REQUIRE((near(o.r, b.r, a.r) && near(o.g, b.g, a.g) && near(o.b, b.b, a.b)));
  }
}

}  // namespace
