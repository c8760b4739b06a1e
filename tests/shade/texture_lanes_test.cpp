// SPDX-License-Identifier: MIT
#include <irg/shade/texture_lanes.hpp>

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::rgb;
using irg::rgba8;
constexpr int count = irg::native_lanes<float>;
using floats = irg::pack<float, count>;

// Coordinates as they come, and those that need care.
float any_coordinate(test::random& r) {
  constexpr float limit = std::numeric_limits<float>::infinity();
  constexpr float special[] = {0,        -0.0f,   1,      0.5f,  -1,     0x1p24f,
                               -0x1p24f, 0x1p30f, 1e-40f, limit, -limit, std::numeric_limits<float>::quiet_NaN()};
  if (r.integer(0, 9) == 0) return special[r.integer(0, 11)];
  return static_cast<float>((r.unit() - 0.5) * (r.integer(0, 3) == 0 ? 1000 : 4));
}

irg::texture_sampler any_sampler(test::random& r) {
  return {static_cast<irg::texture_filter>(r.integer(0, 1)), static_cast<irg::texture_wrap>(r.integer(0, 3)),
          static_cast<irg::texture_wrap>(r.integer(0, 3))};
}

template <class Make>
floats any_lanes(const Make& make) {
  return irg::lanes<floats>::generate([&](int) { return make(); });
}

bool same(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }
bool same(const rgb<floats>& many, int i, const rgb<float>& one) {
  return same(many.r[i], one.r) && same(many.g[i], one.g) && same(many.b[i], one.b);
}

TEST_CASE("mip_level in lanes: mip_level's own bits") {
  test::random r(71);
  int differ = 0;
  for (int k = 0; k < 20000; ++k) {
    const int width = static_cast<int>(r.integer(1, 4000)), height = static_cast<int>(r.integer(1, 4000));
    const auto change = [&] {
      const float x = any_coordinate(r);
      return r.integer(0, 1) == 0 ? x : x / 1000;
    };
    irg::texture_derivatives_of<floats> d{any_lanes(change), any_lanes(change), any_lanes(change), any_lanes(change)};
    if (k % 4 == 0) {  // all about a power of two
      const float near =
          static_cast<float>(1 << r.integer(0, 12)) * (1 + static_cast<float>(r.integer(-4, 4)) * 0x1p-23f);
      const floats none = irg::lanes<floats>::broadcast(0);
      d = {irg::lanes<floats>::broadcast(near / static_cast<float>(width)), none, none, none};
    }
    const floats level = irg::mip_level<count>(d, {width, height});
    for (int i = 0; i < count; ++i)
      differ +=
          !same(level[i], irg::mip_level({d.u_right[i], d.v_right[i], d.u_down[i], d.v_down[i]}, {width, height}));
  }
  CHECK(differ == 0);
}

TEST_CASE("sample_texture and sample_mip_pyramid in lanes: the bits of one by one") {
  test::random r(72);
  int differ = 0;
  for (int k = 0; k < 4000; ++k) {
    const int width = static_cast<int>(r.integer(k % 16 == 0 ? 0 : 1, 21)), height = static_cast<int>(r.integer(1, 9));
    irg::image<rgba8> texels(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) texels(x, y) = std::bit_cast<rgba8>(static_cast<std::uint32_t>(r.next()));
    const auto pyramid = irg::make_mip_pyramid(texels);
    const irg::image_view<const rgba8> upright = texels.view();
    const irg::image_view<const rgba8> view =
        height > 0 && width > 0 && k % 3 == 0
            ? irg::image_view<const rgba8>{upright.row(height - 1), width, height, -upright.stride()}
            : upright;
    const irg::texture_sampler sampler = any_sampler(r);
    const floats u = any_lanes([&] { return any_coordinate(r); }), v = any_lanes([&] { return any_coordinate(r); }),
                 level = any_lanes([&] { return r.integer(0, 3) == 0 ? 1.0f : any_coordinate(r); });
    const rgb<floats> plain = irg::sample_texture<count>(view, u, v, sampler),
                      mixed = irg::sample_mip_pyramid<count>(pyramid, {u, v, level}, sampler);
    for (int i = 0; i < count; ++i) {
      differ += !same(plain, i, irg::sample_texture(view, u[i], v[i], sampler));
      differ += !same(mixed, i, irg::sample_mip_pyramid(pyramid, {u[i], v[i], level[i]}, sampler));
    }
  }
  CHECK(differ == 0);
}

}  // namespace
