// SPDX-License-Identifier: MIT
#include <irg/geometry/triangulate_ear_clipping.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/geometry/triangulate_monotone.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/lattice_polygons.hpp"

namespace {

using P = irg::point<double, 2>;
using ring = test::lattice_ring;
using triangles = std::vector<std::array<std::uint32_t, 3>>;

ring corners_of(const std::array<std::uint32_t, 3>& t, const ring& r) { return {r[t[0]], r[t[1]], r[t[2]]}; }

// The signed areas of the triangles add up to the ring's, whatever the ring.
void check_any(const ring& r) {
  const triangles t = irg::triangulate_ear_clipping(r);
  REQUIRE(t.size() == r.size() - 2);
  std::int64_t sum = 0;
  for (const auto& one : t) sum += test::twice_area(corners_of(one, r));
  REQUIRE(sum == test::twice_area(r));
}
// And a simple one's triangles all run its way and have area.
void check_simple(const ring& r) {
  check_any(r);
  for (const auto& one : irg::triangulate_ear_clipping(r))
    REQUIRE((test::twice_area(corners_of(one, r)) > 0) == (test::twice_area(r) > 0));
}

TEST_CASE("triangulate_ear_clipping: at compile time as at run time, degenerate rings") {
  constexpr auto l_shape = [](bool clockwise) {
    ring r{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    if (clockwise) std::reverse(r.begin(), r.end());
    std::uint64_t h = 14695981039346656037u;
    for (const auto& t : irg::triangulate_ear_clipping(r))
      for (const auto i : t) h = (h ^ i) * 1099511628211u;
    return h;
  };
  constexpr std::uint64_t one_way = l_shape(false), other_way = l_shape(true);
  CHECK(l_shape(false) == one_way);
  CHECK(l_shape(true) == other_way);
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  constexpr auto first = [](double hair) {  // the widest square there is; vertex 3 lies off its diagonal by a hair
    return irg::triangulate_ear_clipping(std::array{P{-most, -most}, P{most, -most}, P{most, most}, P{-hair, hair}})[0];
  };
  CHECK_BOTH(first(least) == std::array<std::uint32_t, 3>{0, 1, 2});   // convex: the diagonal 0 2
  CHECK_BOTH(first(-least) == std::array<std::uint32_t, 3>{3, 0, 1});  // reflex: the diagonal 1 3
  CHECK_BOTH(irg::triangulate_ear_clipping(ring{}).empty());
  CHECK_BOTH(irg::triangulate_ear_clipping(ring{{1, 1}, {2, 2}}).empty());
  CHECK_BOTH(irg::triangulate_ear_clipping(ring{{1, 1}, {2, 2}, {3, 3}, {1, 1}}).size() == 2);
  const double nan_ = std::numeric_limits<double>::quiet_NaN();
  CHECK(irg::triangulate_ear_clipping(std::array{P{0, 0}, P{nan_, 0}, P{0, 1}, P{1, 1}}).empty());
}

TEST_CASE("triangulate_ear_clipping: random simple rings, and rings of any kind") {
  test::random random(81);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 100'000 : 3000;
  for (int i = 0; i < rounds; ++i) {
    const int n = static_cast<int>(random.integer(4, i % 20 == 0 ? 40 : 12));
    const ring r = test::random_simple(random, n, static_cast<int>(n / 4 + random.integer(3, 16)));
    if (!r.empty()) check_simple(r);
    ring any;
    for (auto k = random.integer(3, 12); k > 0; --k) {
      const int x = static_cast<int>(random.integer(0, 4));
      any.push_back({x, static_cast<int>(random.integer(0, 4))});
    }
    check_any(any);
  }
}

TEST_CASE("triangulate_ear_clipping: ears of one ulp, memory used again, a budget") {
  irg::ear_clipping_memory<double> memory;
  std::vector<P> saw{{0, 0}, {33, 0}, {33, 4}};
  for (int i = 32; i > 0; --i) saw.push_back({static_cast<double>(i), i % 2 == 0 ? 4.0 : std::nextafter(4.0, 5.0)});
  saw.push_back({0, 4});
  for (int again = 0; again < 2; ++again) {
    int count = 0, wrong = 0;
    const auto emit = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      ++count;
      wrong += irg::orient2d(saw[i], saw[j], saw[k]) != 1;
    };
    REQUIRE(irg::triangulate_ear_clipping(saw, emit, memory));
    CHECK(count == static_cast<int>(saw.size()) - 2);
    CHECK(wrong == 0);
    const auto none = [](std::uint32_t, std::uint32_t, std::uint32_t) { FAIL("a ring without area"); };
    CHECK(!irg::triangulate_ear_clipping(std::array{P{0, 0}, P{1, 1}, P{2, 2}, P{3, 3}}, none, memory));
    CHECK(!irg::triangulate_ear_clipping(std::array{P{0, 0}, P{1, 1}}, none, memory));
  }
  ring comb{{0, 0}, {400, 0}};
  for (int i = 200; i-- > 0;) {
    comb.push_back({2 * i + 1, 100});
    comb.push_back({2 * i, 1});
  }
  check_simple(comb);
  const auto hasty = irg::triangulate_ear_clipping(comb, {.tests_per_vertex = 1});
  CHECK(hasty.size() == comb.size() - 2);
}

}  // namespace
