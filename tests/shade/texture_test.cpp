// SPDX-License-Identifier: MIT
#include <irg/shade/texture.hpp>

#include <cmath>
#include <limits>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

// A raster without memory.
struct endless_ones {
  int width = 0;
};
template <>
struct irg::raster_traits<endless_ones> {
  using pixel = float;
  static constexpr int width(const endless_ones& r) { return r.width; }
  static constexpr int height(const endless_ones&) { return 1; }
  static constexpr float get(const endless_ones&, int, int) { return 1.0f; }
};

namespace {

using irg::texture_filter;
using irg::texture_sampler;
using irg::texture_wrap;

constexpr texture_wrap wraps[] = {texture_wrap::repeat, texture_wrap::mirrored, texture_wrap::clamp,
                                  texture_wrap::border};
constexpr float inf = std::numeric_limits<float>::infinity(), no_number = std::numeric_limits<float>::quiet_NaN();

constexpr texture_sampler nearest(texture_wrap wrap) { return {texture_filter::nearest, wrap, wrap}; }
constexpr texture_sampler bilinear(texture_wrap wrap) { return {texture_filter::bilinear, wrap, wrap}; }

// 4 x 2 texels: 10 x + y + 1.
constexpr irg::image<float> numbers() {
  irg::image<float> t(4, 2, 0.0f);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x) t(x, y) = static_cast<float>(10 * x + y + 1);
  return t;
}

constexpr float at(float u, float v, texture_sampler s, float border = -5.0f) {
  return irg::sample_texture(numbers(), u, v, s, border);
}

// ---- an oracle that knows nothing of floors and folds: texels by counting, in long double

// The texel that stands at place i of the endless texture, -1 for the border.
int texel_at(long long i, int count, texture_wrap wrap) {
  if (0 <= i && i < count) return static_cast<int>(i);
  if (wrap == texture_wrap::border) return -1;
  if (wrap == texture_wrap::clamp) return i < 0 ? 0 : count - 1;
  const bool turned = wrap == texture_wrap::mirrored;
  int k = 0, step = 1;  // walks there
  const long long to = i < 0 ? -1 - i : i;
  for (long long n = 0; n < to; ++n) {
    k += step;
    if (k < 0 || k >= count) {
      if (turned)
        step = -step, k += step;
      else
        k = 0;
    }
  }
  if (i >= 0) return k;
  return turned ? k : count - 1 - k;
}

struct oracle {
  const irg::image<float>& t;
  float border;
  long double texel(long long x, long long y, const texture_sampler& s) const {
    const int i = texel_at(x, t.width(), s.wrap_u), k = texel_at(y, t.height(), s.wrap_v);
    return static_cast<long double>(i < 0 || k < 0 ? border : t(i, k));
  }
  long double operator()(float u, float v, const texture_sampler& s) const {
    const long double x = static_cast<long double>(u) * t.width(), y = static_cast<long double>(v) * t.height();
    if (s.filter == texture_filter::nearest)
      return texel(static_cast<long long>(std::floor(x)), static_cast<long long>(std::floor(y)), s);
    const long double fx = std::floor(x - 0.5L), fy = std::floor(y - 0.5L), s0 = x - 0.5L - fx, t0 = y - 0.5L - fy;
    const auto i = static_cast<long long>(fx), k = static_cast<long long>(fy);
    return (1 - t0) * ((1 - s0) * texel(i, k, s) + s0 * texel(i + 1, k, s)) +
           t0 * ((1 - s0) * texel(i, k + 1, s) + s0 * texel(i + 1, k + 1, s));
  }
};

TEST_CASE("texture: by hand") {
  using enum texture_wrap;
  CHECK_BOTH(at(0, 0, nearest(repeat)) == 1);
  CHECK_BOTH(at(0.25f, 0.5f, nearest(repeat)) == 12);
  CHECK_BOTH(at(0.99f, 0.99f, nearest(repeat)) == 32);
  CHECK_BOTH(at(1, 1, nearest(repeat)) == 1);
  CHECK_BOTH(at(-0.01f, 0, nearest(repeat)) == 31);
  CHECK_BOTH(at(1.01f, 0, nearest(mirrored)) == 31);
  CHECK_BOTH(at(-0.01f, 0, nearest(mirrored)) == 1);
  CHECK_BOTH(at(-3.9f, 0, nearest(mirrored)) == 1);
  CHECK_BOTH(at(-2.9f, 0, nearest(mirrored)) == 31);
  CHECK_BOTH(at(7, -3, nearest(clamp)) == 31);
  CHECK_BOTH(at(1, 0, nearest(border)) == -5);
  CHECK_BOTH(at(0.99f, 0, nearest(border)) == 31);
  CHECK_BOTH(at(-1e-30f, 0, nearest(border)) == -5);
  // Centres, half-way between them, the middle.
  CHECK_BOTH(at(0.375f, 0.25f, bilinear(repeat)) == 11);
  CHECK_BOTH(at(0.5f, 0.25f, bilinear(repeat)) == 16);
  CHECK_BOTH(at(0.5f, 0.5f, bilinear(repeat)) == 16.5f);
  CHECK_BOTH(at(0, 0.25f, bilinear(repeat)) == 16);
  CHECK_BOTH(at(0, 0.25f, bilinear(mirrored)) == 1);
  CHECK_BOTH(at(0, 0.25f, bilinear(clamp)) == 1);
  CHECK_BOTH(at(0, 0.25f, bilinear(border)) == -2);
  CHECK_BOTH(at(1, 0.75f, bilinear(border)) == 13.5f);
  CHECK_BOTH(at(0, 0, bilinear(border)) == -3.5f);
}

TEST_CASE("texture: coordinates that are no numbers, or are larger than a float's fractions") {
  using enum texture_wrap;
  CHECK_BOTH(at(inf, -inf, nearest(repeat)) == 1);
  CHECK_BOTH(at(no_number, no_number, bilinear(mirrored)) == 1);
  CHECK_BOTH(at(no_number, inf, nearest(clamp)) == 2);
  CHECK_BOTH(at(inf, no_number, bilinear(clamp)) == 31);
  CHECK_BOTH(at(no_number, 0.25f, bilinear(border)) == -5);
  CHECK_BOTH(at(0.25f, -inf, nearest(border)) == -5);
  CHECK_BOTH(at(0x1p23f, 0x1p30f, nearest(repeat)) == 1);
  CHECK_BOTH(at(0x1p23f, 0, nearest(mirrored)) == 1);
  CHECK_BOTH(at(0x1p23f + 1, 0, nearest(mirrored)) == 31);  // an odd one
  for (const texture_wrap wrap : wraps)
    for (const float u : {inf, -inf, no_number, 0x1p24f, -0x1p24f, 0x1.fffffep127f, 1e-45f, -1e-45f, -0.0f})
      for (const texture_sampler s : {nearest(wrap), bilinear(wrap)}) {
        const float value = at(u, 0.5f, s);
        CHECK((value == -5 || (value >= 1 && value <= 32) || (s == bilinear(texture_wrap::border) && value >= -5)));
      }
  constexpr irg::image<float> none;
  CHECK_BOTH(irg::sample_texture(irg::image<float>(), 0.5f, 0.5f, {}, 7.0f) == 7);
  CHECK(irg::sample_texture(none, 0.5f, 0.5f) == 0);
}

TEST_CASE("texture: none of 2^29 texels is beyond the last one") {
  for (const int width : {(1 << 24) - 1, 1 << 24, (1 << 24) + 3, (1 << 29) - 1, 1 << 29})
    for (const auto wrap : {texture_wrap::repeat, texture_wrap::mirrored, texture_wrap::clamp})
      for (const auto filter : {texture_filter::nearest, texture_filter::bilinear})
        for (const float u : {0.0f, 1.0f, -1e-9f, 1e-9f, 1 - 0x1p-24f, -0x1p-25f, 3.5f, -3.3e6f})
          CHECK(irg::sample_texture(endless_ones{width}, u, 0.5f, texture_sampler{filter, wrap, wrap}, -5.0f) == 1);
}

TEST_CASE("texture: light, not codes, is averaged") {
  constexpr auto black_and_white = [] {
    irg::image<irg::rgba8> t(2, 1, irg::rgba8{0, 0, 0, 9});
    t(1, 0) = {255, 255, 255, 0};
    return t;
  };
  CHECK_BOTH(irg::sample_texture(black_and_white(), 0.5f, 0.5f) == irg::rgb<float>{0.5f, 0.5f, 0.5f});
  CHECK_BOTH(irg::encode(irg::sample_texture(black_and_white(), 0.5f, 0.5f)) == irg::rgba8{188, 188, 188, 255});
  CHECK_BOTH(irg::sample_texture(irg::image<std::uint8_t>(3, 3, std::uint8_t{255}), 0.1f, 0.7f) ==
             irg::rgb<float>{1, 1, 1});
  CHECK_BOTH(irg::sample_texture(irg::image<irg::rgb<float>>(3, 3, {2, 0.1f, 0.7f}), 0.1f, 0.7f) ==
             irg::rgb<float>{2, 0.1f, 0.7f});
  static_assert(irg::TextureRaster<irg::image<irg::bgr8>> && !irg::TextureRaster<irg::image<double>> &&
                !irg::TextureRaster<irg::image<int>>);
}

TEST_CASE("texture: every code is its own at the texel's centre, in every wrap") {
  irg::image<irg::rgba8> t(16, 16);
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    t(i % 16, i / 16) = {code, static_cast<std::uint8_t>(255 - i), static_cast<std::uint8_t>(i * 7), 255};
  }
  for (const texture_wrap wrap : wraps)
    for (const texture_sampler s : {nearest(wrap), bilinear(wrap)})
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
          REQUIRE(irg::encode(irg::sample_texture(t, (static_cast<float>(x) + 0.5f) / 16,
                                                  (static_cast<float>(y) + 0.5f) / 16, s)) == t(x, y));
}

TEST_CASE("texture: against long double") {
  test::random r(11);
  long long nearest_seen = 0, at_edges = 0;
  for (int i = 0; i < 4000; ++i) {
    irg::image<float> t(static_cast<int>(r.integer(1, 9)), static_cast<int>(r.integer(1, 9)));
    for (int y = 0; y < t.height(); ++y)
      for (int x = 0; x < t.width(); ++x) t(x, y) = static_cast<float>(r.integer(0, 1 << 20)) * 0x1p-20f;
    const oracle expected{t, 0.625f};
    for (int k = 0; k < 16; ++k) {
      const auto coordinate = [&] {
        const double range = k % 4 == 0 ? 20.0 : 2.0;
        if (k % 5 == 0) return static_cast<float>(r.integer(-64, 64)) / 16;
        return static_cast<float>((r.unit() - 0.5) * range);
      };
      const float u = coordinate(), v = coordinate();
      const texture_sampler s{k % 2 == 0 ? texture_filter::nearest : texture_filter::bilinear, wraps[r.integer(0, 3)],
                              wraps[r.integer(0, 3)]};
      const auto value = static_cast<long double>(irg::sample_texture(t, u, v, s, 0.625f));
      if (s.filter == texture_filter::bilinear) {
        // A border's step between two texels is one texel wide: places are off by the roundings of u and of u * width.
        REQUIRE(std::abs(value - expected(u, v, s)) < 2e-6L);
        continue;
      }
      ++nearest_seen;
      if (value == expected(u, v, s)) continue;
      ++at_edges;
      const auto to_edge = [](float c, int count) {
        const long double place = static_cast<long double>(c) * count;
        return std::abs(place - std::round(place));
      };
      REQUIRE(std::min(to_edge(u, t.width()), to_edge(v, t.height())) < 1e-6L);
    }
  }
  CHECK(nearest_seen > 30000);
  CHECK(at_edges < nearest_seen / 100);  // turned round, an edge belongs to the texel on its other side
}

TEST_CASE("texture: places in lanes are those of single numbers") {
  constexpr int N = irg::native_lanes<float>;
  using floats = irg::pack<float, N>;
  test::random r(12);
  for (int i = 0; i < 20000; ++i) {
    float u[static_cast<unsigned>(N)];
    for (float& c : u) {
      c = i % 3 == 0 ? std::bit_cast<float>(static_cast<std::uint32_t>(r.next()))
                     : static_cast<float>((r.unit() - 0.5) * 8);
      if (r.integer(0, 30) == 0) c = no_number;
    }
    const int count = static_cast<int>(r.integer(1, i % 2 == 0 ? 12 : 4000));
    const floats packed = irg::lanes<floats>::load(u);
    for (const texture_wrap wrap : wraps) {
      const auto n = irg::detail::nearest_texel(packed, count, wrap);
      const auto two = irg::detail::neighbouring_texels(packed, count, wrap);
      for (int k = 0; k < N; ++k) {
        const auto one = irg::detail::neighbouring_texels(u[k], count, wrap);
        REQUIRE(n[k] == irg::detail::nearest_texel(u[k], count, wrap));
        REQUIRE(two.first[k] == one.first);
        REQUIRE(two.second[k] == one.second);
        REQUIRE(two.fraction[k] == one.fraction);
        REQUIRE((one.fraction >= 0 && one.fraction <= 1));
        if (wrap != texture_wrap::border) {
          REQUIRE((one.first >= 0 && one.first < count && one.second >= 0 && one.second < count));
        }
      }
    }
  }
}
}  // namespace
