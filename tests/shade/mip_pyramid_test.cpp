// SPDX-License-Identifier: MIT
#include <irg/shade/mip_pyramid.hpp>

#include <array>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), no_number = std::numeric_limits<float>::quiet_NaN();

constexpr irg::image<float> ramp(int width, int height) {
  irg::image<float> t(width, height, 0.0f);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) t(x, y) = static_cast<float>(4 * x + 16 * y);
  return t;
}

TEST_CASE("mip_pyramid: sizes and means by hand") {
  constexpr auto facts = [](int level) {
    const auto p = irg::make_mip_pyramid(ramp(8, 2));
    const auto& l = p.levels[static_cast<std::size_t>(level)];
    return std::array<float, 4>{static_cast<float>(p.levels.size()), static_cast<float>(l.width()),
                                static_cast<float>(l.height()), l(l.width() - 1, l.height() - 1)};
  };
  CHECK_BOTH(facts(0) == std::array<float, 4>{4, 8, 2, 44});
  CHECK_BOTH(facts(1) == std::array<float, 4>{4, 4, 1, 34});
  CHECK_BOTH(facts(2) == std::array<float, 4>{4, 2, 1, 30});
  CHECK_BOTH(facts(3) == std::array<float, 4>{4, 1, 1, 22});
  CHECK_BOTH(irg::make_mip_pyramid(irg::image<float>()).levels.empty());
  // Three texels by shares of 2/3 and 1/3 become one: all alike. Five become two.
  constexpr auto five = [](int i) { return irg::make_mip_pyramid(ramp(5, 1)).levels[1](i, 0); };
  CHECK(std::abs(five(0) - (0 + 4 + 8 * 0.5f) / 2.5f) < 1e-6f);
  CHECK(std::abs(five(1) - (16 + 12 + 8 * 0.5f) / 2.5f) < 2e-6f);
}

TEST_CASE("mip_pyramid: light is averaged") {
  constexpr auto last = [] {
    irg::image<irg::rgba8> t(2, 2, irg::rgba8{0, 0, 0, 255});
    t(0, 0) = t(1, 1) = {255, 255, 255, 255};
    return irg::make_mip_pyramid(t).levels[1](0, 0);
  };
  CHECK_BOTH(last() == irg::rgb<float>{0.5f, 0.5f, 0.5f});
}

TEST_CASE("mip_pyramid: every level of every size has the mean of the texture, and equal texels stay equal") {
  test::random r(21);
  for (int width = 1; width <= 17; ++width)
    for (int height = 1; height <= 17; ++height) {
      irg::image<float> t(width, height);
      double mean = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) mean += static_cast<double>(t(x, y) = static_cast<float>(r.unit()));
      mean /= width * height;
      const auto p = irg::make_mip_pyramid(t);
      int w = width, h = height;
      for (const auto& level : p.levels) {
        REQUIRE(level.width() == w);
        REQUIRE(level.height() == h);
        double sum = 0;
        for (int y = 0; y < h; ++y)
          for (int x = 0; x < w; ++x) sum += static_cast<double>(level(x, y));
        REQUIRE(std::abs(sum / (w * h) - mean) < 1e-6);
        w = irg::maximum(w / 2, 1), h = irg::maximum(h / 2, 1);
      }
      REQUIRE(p.levels.back().width() * p.levels.back().height() == 1);
    }
}

TEST_CASE("mip_level: from how coordinates change") {
  constexpr auto level = [](float a, float b, float c, float d) { return irg::mip_level({a, b, c, d}, {256, 128}); };
  CHECK_BOTH(level(1.0f / 256, 0, 0, 1.0f / 128) == 0);
  CHECK_BOTH(level(4.0f / 256, 0, 0, 1.0f / 128) == 2);
  CHECK_BOTH(level(0, 0, 0, -8.0f / 128) == 3);
  CHECK_BOTH(level(0, 0, 0, 0) == 0);
  CHECK(std::abs(level(3.0f / 256, 4.0f / 128, 0, 0) - std::log2(5.0f)) < 1e-6f);
  CHECK_BOTH(level(inf, 0, 0, 0) == 32);
  CHECK_BOTH(level(0, no_number, 0, 0) == 0);
  CHECK_BOTH(level(0, no_number, 1, 0) == 0);
}

TEST_CASE("sample_mip_pyramid: whole levels, between them, beyond them") {
  const auto p = irg::make_mip_pyramid(ramp(8, 8));
  test::random r(22);
  for (int i = 0; i < 500; ++i) {
    const auto u = static_cast<float>(r.unit() * 3 - 1), v = static_cast<float>(r.unit() * 3 - 1);
    float of[4];
    for (std::size_t k = 0; k < 4; ++k) {
      of[k] = irg::sample_texture(p.levels[k], u, v);
      REQUIRE(irg::sample_mip_pyramid(p, {u, v, static_cast<float>(k)}) == of[k]);
    }
    REQUIRE(irg::sample_mip_pyramid(p, {u, v, 1.25f}) == of[1] + irg::product(of[2] - of[1], 0.25f));
    REQUIRE(irg::sample_mip_pyramid(p, {u, v, -3}) == of[0]);
    REQUIRE(irg::sample_mip_pyramid(p, {u, v, no_number}) == of[0]);
    REQUIRE(irg::sample_mip_pyramid(p, {u, v, inf}) == of[3]);
  }
  CHECK_BOTH(irg::sample_mip_pyramid(irg::mip_pyramid<float>{}, {0, 0, 0}, {}, 3.0f) == 3);
}

}  // namespace
