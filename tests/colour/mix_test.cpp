// SPDX-License-Identifier: MIT
#include <cmath>
#include <initializer_list>
#include <limits>

#include <irg/colour/mix.hpp>

#include "support/check_both.hpp"

namespace my {

struct mixed_by_coverage {
  unsigned level;
};
constexpr mixed_by_coverage mix(const mixed_by_coverage& a, const mixed_by_coverage& b, int coverage) {
  const auto c = static_cast<unsigned>(coverage);
  return {(a.level * (255 - c) + b.level * c) / 255};
}

// As in shaders, and as in GLM.
struct mixed_by_share {
  float level;
};
constexpr mixed_by_share mix(mixed_by_share a, mixed_by_share b, float share) {
  return {a.level + (b.level - a.level) * share};
}
struct mixed_by_anything {
  float level;
};
template <class U>
constexpr mixed_by_anything mix(mixed_by_anything a, mixed_by_anything b, U share) {
  static_assert(!std::integral<U>);
  return {a.level + (b.level - a.level) * share};
}

}  // namespace my

namespace {

TEST_CASE("mix: the nearest integer for all 2^24 arguments") {
  for (int a = 0; a < 256; ++a)
    for (int b = 0; b < 256; ++b)
      for (int c = 0; c < 256; ++c) {
        const int exact = a * (255 - c) + b * c;  // times 255
        const int got =
            irg::mix(static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b), static_cast<std::uint8_t>(c));
        REQUIRE(2 * (exact - 255 * got) < 255);
        REQUIRE(2 * (255 * got - exact) < 255);
      }
}

TEST_CASE("mix: channels, and the ends") {
  CHECK_BOTH(irg::mix(irg::rgba8{0, 10, 255, 255}, irg::rgba8{255, 20, 0, 0}, 51) == irg::rgba8{51, 12, 204, 204});
  CHECK_BOTH(irg::mix(irg::bgr8{1, 2, 3}, irg::bgr8{4, 5, 6}, 255) == irg::bgr8{4, 5, 6});
  CHECK_BOTH(irg::mix(1.0f, 3.0f, 0) == 1.0f);
  CHECK_BOTH(irg::mix(0.1, 3.7, 255) == 3.7);
  CHECK_BOTH(irg::mix(irg::rgb<double>{0, 0, 0}, irg::rgb<double>{255, 51, 0}, 5) == irg::rgb<double>{5, 1, 0});
}

TEST_CASE("mix: at both ends the other value does not matter") {
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double greatest = std::numeric_limits<double>::max();
  for (const double other : {0.0, infinity, -infinity, nan, greatest, -greatest}) {
    CHECK(irg::mix(greatest, other, 0) == greatest);
    CHECK(irg::mix(infinity, other, 0) == infinity);
    CHECK(irg::mix(other, greatest, 255) == greatest);
    CHECK(std::signbit(irg::mix(-0.0, other, 0)));
  }
  CHECK_BOTH(irg::mix(1.0f, std::numeric_limits<float>::infinity(), 0) == 1.0f);
  CHECK_BOTH(irg::mix(2.0, 2.0, 77) == 2.0);
}

TEST_CASE("mix: what it mixes") {
  static_assert(irg::Mixable<irg::rgb8> && irg::Mixable<std::uint8_t> && irg::Mixable<float>);
  static_assert(!irg::Mixable<int> && !irg::Mixable<char>);
  static_assert(irg::Mixable<my::mixed_by_coverage>);
  static_assert(!irg::Mixable<my::mixed_by_share> && !irg::Mixable<my::mixed_by_anything>);
  CHECK_BOTH(mix(my::mixed_by_coverage{0}, {510}, 128).level == 256);
  CHECK_BOTH(mix(my::mixed_by_share{0}, {2}, 0.5f).level == 1);
  CHECK_BOTH(mix(my::mixed_by_anything{0}, {2}, 0.5f).level == 1);
}

}  // namespace
