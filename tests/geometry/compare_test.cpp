// SPDX-License-Identifier: MIT
#include <irg/geometry/compare.hpp>

#include <array>
#include <limits>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/flush_mode.hpp"
#include "support/random.hpp"
#include "support/sign_trials.hpp"

using irg::compare_distance;
using irg::compare_lexicographic;
using irg::order_along_line;

namespace {

using P2 = irg::point<double, 2>;
using P3 = irg::point<double, 3>;
using I2 = irg::point<std::int64_t, 2>;
constexpr double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max(), least = -most - 1;

}  // namespace

TEST_CASE("compare: lexicographic") {
  CHECK_BOTH(compare_lexicographic(P2{1, 5}, P2{2, 0}) == -1);
  CHECK_BOTH(compare_lexicographic(P2{1, 5}, P2{1, 0}) == 1);
  CHECK_BOTH(compare_lexicographic(P3{0.0, -0.0, 1}, P3{-0.0, 0.0, 1}) == 0);
  CHECK_BOTH(compare_lexicographic(std::array<int, 1>{3}, std::array<int, 1>{4}) == -1);
  CHECK_BOTH(compare_lexicographic(P2{tiny, 0}, P2{0, huge}) == 1);
}

TEST_CASE("compare: along a line") {
  CHECK_BOTH(order_along_line(P2{0, 0}, P2{2, 1}, P2{1, 1}, P2{2, 1}) == -1);
  CHECK_BOTH(order_along_line(P2{2, 1}, P2{0, 0}, P2{1, 1}, P2{2, 1}) == 1);
  CHECK_BOTH(order_along_line(P2{0, 0}, P2{2, 1}, P2{3, 0}, P2{2, 2}) == 0);   // level
  CHECK_BOTH(order_along_line(P2{4, 4}, P2{4, 4}, P2{3, 0}, P2{2, 2}) == 0);   // no direction
  CHECK_BOTH(order_along_line(P3{0, 0, 0}, P3{1, 1, 1}, P3{0, 0, 0}, P3{0, 0, tiny}) == -1);
  CHECK_BOTH(order_along_line(P2{-huge, 0}, P2{huge, 0}, P2{huge, 3}, P2{-huge, 2}) == 1);
  CHECK_BOTH(order_along_line(P2{0, 0}, P2{tiny, 0}, P2{-tiny, 3}, P2{0, 2}) == -1);
  CHECK_BOTH(order_along_line(I2{least, least}, I2{most, most}, I2{least, most}, I2{most, least}) == 0);
  CHECK_BOTH(order_along_line(I2{least, least}, I2{most, most}, I2{least, most}, I2{most, least + 1}) == -1);
  CHECK_BOTH(order_along_line(std::array<float, 2>{0, 0}, std::array<float, 2>{1, 1}, std::array<float, 2>{1e-40f, 0},
                              std::array<float, 2>{0, 0}) == 1);
}

TEST_CASE("compare: distances") {
  CHECK_BOTH(compare_distance(P2{0, 0}, P2{3, 4}, P2{5, 0}) == 0);
  CHECK_BOTH(compare_distance(P2{0, 0}, P2{3, 4}, P2{5, tiny}) == -1);
  CHECK_BOTH(compare_distance(P3{0, 0, 0}, P3{3, 4, tiny}, P3{5, 0, 0}) == 1);
  CHECK_BOTH(compare_distance(P2{huge, huge}, P2{-huge, huge}, P2{huge, -huge}) == 0);
  CHECK_BOTH(compare_distance(P2{tiny, tiny}, P2{0, tiny}, P2{tiny, 3 * tiny}) == -1);
  CHECK_BOTH(compare_distance(I2{least, least}, I2{most, least}, I2{least, most}) == 0);
  CHECK_BOTH(compare_distance(I2{least, least}, I2{most, least}, I2{least, most - 1}) == 1);
  CHECK_BOTH(compare_distance(irg::point<int, 2>{-2147483647 - 1, 0}, {2147483647, 0}, {0, 0}) == 1);
  volatile double five = 5;
  CHECK(compare_distance(P2{0, 0}, P2{3, 4}, P2{five, 0}) == 0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK_BOTH(compare_distance(P2{0, 0}, P2{infinity, 0}, P2{1, 0}) == 0);  // a broken precondition, and no harm
  constexpr float infinite = std::numeric_limits<float>::infinity();
  using F2 = irg::point<float, 2>;
  CHECK_BOTH(compare_distance(F2{0, 0}, F2{infinite, 0}, F2{1, 0}) == 0);
}

TEST_CASE("compare: ahead of an eye, level with it, behind") {
  constexpr P3 eye{1, 1, 3}, target{0, 0, 0};
  CHECK_BOTH(order_along_line(eye, target, target, eye) == 1);
  CHECK_BOTH(order_along_line(eye, target, eye, eye) == 0);
  CHECK_BOTH(order_along_line(eye, target, P3{4, -2, 3}, eye) == 0);
  CHECK_BOTH(order_along_line(eye, target, P3{4, -2, 3.0000000000000004}, eye) == -1);
  CHECK_BOTH(order_along_line(eye, target, P3{4, -2.0000000000000004, 3}, eye) == 1);
  CHECK_BOTH(order_along_line(eye, target, P3{2, 2, 6}, eye) == -1);
  CHECK_BOTH(order_along_line(eye, eye, target, eye) == 0);
  CHECK_BOTH(order_along_line(P3{0, 0, huge}, P3{0, 0, -huge}, P3{huge, huge, tiny}, P3{0, 0, huge}) == 1);
  CHECK_BOTH(order_along_line(P3{0, 0, tiny}, P3{0, 0, 0}, P3{huge, huge, tiny}, P3{0, 0, tiny}) == 0);
  CHECK_BOTH(order_along_line(P3{0, 0, tiny}, P3{0, 0, 0}, P3{huge, huge, 2 * tiny}, P3{0, 0, tiny}) == -1);
  CHECK_BOTH(order_along_line(std::array<float, 2>{0, 1}, std::array<float, 2>{0, 0}, std::array<float, 2>{5, 1},
                              std::array<float, 2>{0, 1}) == 0);
  volatile double three = 3;
  CHECK(order_along_line(eye, target, P3{4, -2, three}, eye) == 0);
}

TEST_CASE("compare: ahead of an eye, by integers in 128 bits, on lattices moved away from the origin") {
  __extension__ typedef __int128 wide;
  test::random r(1);
  int level = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t reach = r.integer(0, 1) ? 3 : std::int64_t{1} << 50;
    P3 p[3];
    wide v[3][3];
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) {
        const std::int64_t c = r.integer(-reach, reach) + (reach == 3 ? std::int64_t{1} << 52 : 0);
        p[k][j] = static_cast<double>(c);
        v[k][j] = c;
      }
    wide dot = 0;
    for (int j = 0; j < 3; ++j) dot += (v[2][j] - v[0][j]) * (v[1][j] - v[0][j]);
    level += dot == 0;
    CHECK(order_along_line(p[0], p[1], p[2], p[0]) == (dot > 0 ? 1 : dot < 0 ? -1 : 0));
  }
  CHECK(level > 100);
}

#ifdef IRG_HAVE_MPFR
namespace {

template <class T, int N>
void check_random(int trials) {
  test::random r(N + static_cast<int>(sizeof(T)));
  test::sign_counts orders, distances;
  for (int i = 0; i < trials; ++i) {
    const int kind = test::hard_kind(r);
    irg::point<T, N> p[4];
    for (auto& q : p)
      for (int j = 0; j < N; ++j) q[j] = test::hard_number<T>(r, kind);
    test::exact along, nearer;
    for (int j = 0; j < N; ++j) {
      test::exact x[4];
      for (int k = 0; k < 4; ++k) x[k] = test::exact_of(p[k][j]);
      along = along + (x[1] - x[0]) * x[2] - (x[1] - x[0]) * x[3];
      nearer = nearer + (x[1] - x[2]) * (x[1] + x[2] - x[0] - x[0]);
    }
    CHECK(order_along_line(p[0], p[1], p[2], p[3]) == along.sign());
    CHECK(compare_distance(p[0], p[1], p[2]) == nearer.sign());
    CHECK(test::while_flushing([&] { return order_along_line(p[0], p[1], p[2], p[3]); }) == along.sign());
    CHECK(test::while_flushing([&] { return compare_distance(p[0], p[1], p[2]); }) == nearer.sign());
    orders.add(along.sign()), distances.add(nearer.sign());
  }
  orders.check(), distances.check();
}

}  // namespace

TEST_CASE("compare: against rationals, on hard numbers, and with subnormal ones taken for zero by the processor") {
  check_random<double, 2>(test::many_trials(10000));
  check_random<double, 3>(test::many_trials(10000));
  check_random<float, 2>(test::many_trials(5000));
  check_random<std::int64_t, 2>(test::many_trials(5000));
  check_random<std::int64_t, 3>(test::many_trials(5000));
}
#endif

TEST_CASE("compare: between the ends of a segment") {
  CHECK_BOTH(irg::is_between_ends(P2{0, 0}, P2{2, 1}, P2{1, 0.5}));
  CHECK_BOTH(irg::is_between_ends(P2{2, 1}, P2{0, 0}, P2{2, 1}));
  CHECK_BOTH(!irg::is_between_ends(P2{2, 1}, P2{0, 0}, P2{-2, -1}));
  CHECK_BOTH(irg::is_between_ends(P3{1, 1, -huge}, P3{1, 1, huge}, P3{1, 1, tiny}));
  CHECK_BOTH(!irg::is_between_ends(P3{1, 1, 0}, P3{1, 1, 0}, P3{1, 1, tiny}));
  CHECK_BOTH(irg::is_between_ends(I2{least, 0}, I2{most, 0}, I2{0, 0}));
}
