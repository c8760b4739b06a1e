// SPDX-License-Identifier: MIT
#include <irg/curve/bezier_crossings.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 2>;
using M = irg::curve_meeting<double>;
using enum irg::bezier_intersection_status;

using meetings_result = irg::checked<std::size_t, irg::bezier_intersection_status>;

constexpr std::array<P, 3> arch{P{0, 0}, P{1, 2}, P{2, 0}}, bowl{P{0, 1}, P{1, -1}, P{2, 1}};

struct outcome {
  std::array<M, 8> room{};
  meetings_result result{};
};
constexpr outcome of_arch_and_bowl(double tolerance) {
  outcome all;
  std::array<P, 18> scratch{};
  all.result = irg::bezier_intersections(arch, bowl, {tolerance}, std::span<M>(all.room), scratch);
  return all;
}

meetings_result meetings(const std::vector<P>& a, const std::vector<P>& b,
                         const irg::bezier_intersection_options<double>& how, std::vector<M>& room) {
  std::vector<P> scratch(3 * (a.size() + b.size()));
  return irg::bezier_intersections(a, b, how, std::span<M>(room), std::span<P>(scratch));
}

}  // namespace

TEST_CASE("bezier_intersections: two parabolas meet twice") {
  constexpr auto coarse = of_arch_and_bowl(0.01);
  CHECK_BOTH(coarse.result == meetings_result{2, ok});
  const auto fine = of_arch_and_bowl(1e-8);
  REQUIRE(fine.result == meetings_result{2, ok});
  // 4 t (1 - t) = 1 - 4 t (1 - t): t (1 - t) = 1/8
  const double low = (1 - std::sqrt(0.5)) / 2;
  for (std::size_t k = 0; k < 2; ++k) {
    const M& m = fine.room[k];
    const double t = m.first_middle() < 0.5 ? low : 1 - low;
    CHECK(std::abs(m.first_middle() - t) < 1e-8);
    CHECK(std::abs(m.second_middle() - t) < 1e-8);
    CHECK((m.first_from <= t && t <= m.first_to));
  }
}

TEST_CASE("bezier_intersections: apart, touching, coincident, points, huge, not finite, no room") {
  std::vector<M> room(16);
  const std::vector<P> a{{0, 0}, {1, 2}, {2, 0}}, above{{0, 1.5}, {2, 1.5}}, tangent{{0, 1}, {2, 1}}, one{{1, 1}};
  CHECK(meetings(a, above, {}, room) == meetings_result{0, ok});
  const auto touching = meetings(a, tangent, {1e-6}, room);
  CHECK(touching == meetings_result{1, ok});
  CHECK(std::abs(room[0].first_middle() - 0.5) < 1e-3);
  const auto same = meetings(a, a, {1e-9}, room);
  CHECK(same.value >= 1);
  CHECK(same.status != ok);
  for (int k = 0; k <= 64; ++k)
    CHECK(std::any_of(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(same.value), [&](const M& m) {
      return m.first_from <= k / 64.0 && k / 64.0 <= m.first_to && m.second_from <= k / 64.0 && k / 64.0 <= m.second_to;
    }));
  CHECK(meetings(a, one, {1e-8}, room) == meetings_result{1, ok});
  const std::vector<P> brief{{1e-7 / 2, -1e-7}, {1e-7 / 2, 3e-7}};  // beside a curve ten million times as long
  CHECK(meetings(a, brief, {1e-8}, room) == meetings_result{1, ok});
  CHECK(std::abs(room[0].first_middle() - 2.5e-8) < 1e-8);
  CHECK(meetings(one, one, {1e-9}, room).value == 1);
  CHECK(meetings(one, {{1, 2}}, {}, room).value == 0);
  const std::vector<P> up{{-1e308, -1e308}, {1e308, 1e308}}, down{{-1e308, 1e308}, {1e308, -1e308}};
  CHECK(meetings(up, down, {1e300}, room) == meetings_result{1, ok});
  const double inf = std::numeric_limits<double>::infinity(), no_number = std::numeric_limits<double>::quiet_NaN();
  CHECK(meetings(a, {{0, no_number}, {1, 1}}, {0, 1000}, room).status != ok);
  CHECK(meetings(a, {{0, inf}, {1, 1}}, {0, 1000}, room).status != ok);
  constexpr auto of_infinity = [] {
    const std::array<P, 3> endless{P{std::numeric_limits<double>::infinity(), 0}, P{1, 1}, P{2, 0}};
    const std::array<P, 2> line{P{0, 0}, P{1, 1}};
    std::array<P, 15> scratch{};
    std::array<irg::curve_meeting<double>, 2> found{};
    return irg::bezier_intersections(endless, line, {0, 50}, found, scratch).status;
  };
  CHECK_BOTH(of_infinity() != irg::bezier_intersection_status::ok);
  std::vector<M> little(1);
  CHECK(meetings({arch.begin(), arch.end()}, {bowl.begin(), bowl.end()}, {1e-6}, little) ==
        meetings_result{1, too_many});
  CHECK((little[0].first_from < 0.15 && little[0].first_to > 0.85));
  CHECK(meetings(a, a, {0, 1}, room) == meetings_result{1, wide});
  CHECK(room[0] == M{0, 1, 0, 1});
}

TEST_CASE("bezier_intersections: no common point is missed, and each meeting is as narrow as asked") {
  test::random r(91);
  long meant = 0, missed = 0, loose = 0, within = 0;
  for (int round = 0; round < (std::getenv("IRG_RELEASE_TIER") ? 20'000 : 120); ++round) {
    const double size = std::ldexp(1, static_cast<int>(r.integer(-900, 900)));
    const auto make = [&] {
      std::vector<P> c;
      for (auto k = r.integer(0, 5); k >= 0; --k) {
        const double x = size * (2 * r.unit() - 1), y = size * (2 * r.unit() - 1);
        c.push_back({x, y});
      }
      return c;
    };
    const auto a = make();
    auto b = make();
    // The second curve is moved so that it has a point of the first one at known parameters, up to rounding.
    const double s = r.unit(), t = r.unit();
    std::vector<P> work(8);
    const P on_a = irg::bezier_point(a, s, std::span<P>(work)), on_b = irg::bezier_point(b, t, std::span<P>(work));
    for (P& p : b) p = {p.x + (on_a.x - on_b.x), p.y + (on_a.y - on_b.y)};
    std::vector<M> room(64);
    const double tolerance = size * 0x1p-20;
    const auto result = meetings(a, b, {tolerance}, room);
    ++meant;
    missed += std::none_of(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(result.value), [&](const M& m) {
      return m.first_from <= s && s <= m.first_to && m.second_from <= t && t <= m.second_to;
    });
    if (result.status != ok) continue;
    ++within;
    for (std::size_t k = 0; k < result.value; ++k) {
      const P p = irg::bezier_point(a, room[k].first_middle(), std::span<P>(work));
      const P q = irg::bezier_point(b, room[k].second_middle(), std::span<P>(work));
      // Pieces that touch were joined: a hundred of them at most where curves cross at a slant.
      loose += !(std::abs(p.x - q.x) <= 1000 * tolerance && std::abs(p.y - q.y) <= 1000 * tolerance);
    }
  }
  MESSAGE(meant, " meetings, ", within, " searches within the tolerance");
  CHECK(missed == 0);
  CHECK(within > meant / 2);
  CHECK(loose <= within / 20);
}
