// SPDX-License-Identifier: MIT
#include <irg/curve/keyframes.hpp>

#include <cmath>
#include <limits>
#include <vector>

#include <irg/math/length.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using namespace irg;

namespace {

using key_place = point<double, 2>;
using key = keyframe<key_place>;
constexpr std::array<key, 4> keys{key{0, {0, 0}}, key{1, {2, 1}}, key{3, {4, 4}}, key{4, {1, 1}}};
constexpr key_place key_at(double time) { return place_at(std::span<const key>(keys), time); }

}  // namespace

TEST_CASE("keyframes: each place at its time, the ends outside") {
  for (const key& k : keys) CHECK(key_at(k.time) == k.place);
  CHECK_BOTH(key_at(-5) == key_place{0, 0});
  CHECK_BOTH(key_at(9) == key_place{1, 1});
  CHECK(key_at(std::nan("")) == key_place{0, 0});
  CHECK(key_at(std::numeric_limits<double>::infinity()) == key_place{1, 1});
  const std::array<key, 1> alone{key{2, {7, 8}}};
  CHECK(place_at(std::span<const key>(alone), 3) == key_place{7, 8});
}

TEST_CASE("keyframes: uneven times: quadratics are followed exactly, velocity has no jumps") {
  test::random r(73);
  for (int trial = 0; trial < 100; ++trial) {
    // A motion that is a quadratic in time: Bessel's tangents are its velocities, so inner stretches are the motion.
    const double a = r.unit(), b = r.unit() - 0.5, c = 2 * r.unit() - 1;
    const auto motion = [&](double t) { return key_place{a + t * (b + t * c), c - t * (a - t * b)}; };
    std::vector<key> frames;
    double time = 0;
    for (int k = 0; k < 7; ++k, time += 0.1 + r.unit()) frames.push_back({time, motion(time)});
    const std::span<const key> all(frames);
    for (int k = 0; k <= 20; ++k) {
      const double t = frames[1].time + (frames[5].time - frames[1].time) * k / 20;
      CHECK(length(place_at(all, t) - motion(t)) <= 1e-13);
    }
    for (std::size_t k = 0; k < frames.size(); ++k) frames[k].place = {r.unit(), r.unit()};
    for (std::size_t k = 1; k + 1 < frames.size(); ++k) {
      const double h = 1e-6, t = frames[k].time;
      const auto in = (place_at(all, t) - place_at(all, t - h)) / h,
                 out = (place_at(all, t + h) - place_at(all, t)) / h;
      CHECK(length(in - out) <= 1e-3);
    }
  }
}

TEST_CASE("keyframes: what cannot be followed") {
  const auto followed = [](std::vector<key> frames) { return can_be_followed(std::span<const key>(frames)); };
  CHECK(followed({{0, {1, 1}}, {1, {1, 1}}}));
  CHECK(!followed({}));
  CHECK(!followed({{0, {1, 1}}, {0, {1, 1}}}));
  CHECK(!followed({{1, {1, 1}}, {0, {1, 1}}}));
  CHECK(!followed({{std::nan(""), {1, 1}}}));
  CHECK(!followed({{0, {1, 1}}, {std::numeric_limits<double>::infinity(), {1, 1}}}));
  constexpr double most = std::numeric_limits<double>::max();
  CHECK(followed({{-most / 2, {1, 1}}, {most / 2, {1, 1}}}));
  CHECK(!followed({{-most, {1, 1}}, {most, {1, 1}}}));  // the time between is not finite
  constexpr auto two = [](double from, double to) {
    const std::array<key, 2> frames{key{from, {1, 1}}, key{to, {1, 1}}};
    return can_be_followed(std::span<const key>(frames));
  };
  constexpr double inf = std::numeric_limits<double>::infinity();
  CHECK_BOTH(!two(-most, most));
  CHECK_BOTH(two(-most / 2, most / 2));
  CHECK_BOTH(!two(-most / 2, most / 2 * (1 + 0x1p-50)));
  CHECK_BOTH(!two(-most / 2 * (1 + 0x1p-50), most / 2));
  CHECK_BOTH(!two(-most * 0.125, most));
  CHECK_BOTH(!two(-most, most * 0.125));
  CHECK_BOTH(!two(-inf, inf));
  CHECK_BOTH(!two(inf, inf));
  CHECK_BOTH(!two(std::numeric_limits<double>::quiet_NaN(), 1));
}

TEST_CASE("keyframes: times and places of any size") {
  // Both scaled by powers of two: the places, scaled likewise.
  for (const double time : {1.0, 0x1p-1070, 0x1p-900, 0x1p900})
    for (const double size : {1.0, 0x1p-900, 0x1p1000}) {
      std::vector<key> frames;
      for (const key& k : keys) frames.push_back({k.time * time, {k.place.x * size, k.place.y * size}});
      for (int k = 1; k < 16; ++k) {
        const key_place usual = key_at(0.25 * k), p = place_at(std::span<const key>(frames), 0.25 * k * time);
        CHECK(p == key_place{usual.x * size, usual.y * size});
      }
    }
  // Beside stretches of quite another length.
  const std::vector<key> uneven{{0, {0, 0}}, {0x1p-1000, {0, 1}}, {0x1p1000, {1, 1}}};
  const key_place in_the_first = place_at(std::span<const key>(uneven), 0x1p-1001);
  CHECK(in_the_first.x == 0);
  CHECK((in_the_first.y > 0 && in_the_first.y < 1));
  CHECK(place_at(std::span<const key>(uneven), 0x1p999).x == 0.375);
  // Short ways in short times lead far in long ones.
  const std::vector<key> steady{{0, {0, 0}}, {0x1p-700, {0x1p-700, 0}}, {0x1p700, {0x1p700, 0}}};
  CHECK(std::abs(place_at(std::span<const key>(steady), 0x1p699).x - 0x1p699) <= 0x1p650);
  const std::vector<key> brief{{0, {0, 0}}, {0x1p-1074, {0x1p-40, 0}}, {0x1p-40, {0x1p994, 0}}};
  CHECK(std::abs(place_at(std::span<const key>(brief), 0x1p-41).x - 0x1p993) <= 0x1p950);
}
