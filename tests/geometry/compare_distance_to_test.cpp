// SPDX-License-Identifier: MIT
#include <irg/geometry/compare_distance_to.hpp>

#include <array>
#include <limits>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/flush_mode.hpp"
#include "support/sign_trials.hpp"

using irg::compare_distance_to_line;
using irg::compare_distance_to_plane;

namespace {

using P2 = irg::point<double, 2>;
using P3 = irg::point<double, 3>;
using I2 = irg::point<std::int64_t, 2>;
using L = irg::plane<double>;
constexpr double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST_CASE("compare_distance_to: a line") {
  CHECK_BOTH(compare_distance_to_line(P2{0, 0}, P2{1, 1}, P2{3, 1}, P2{0, 3}) == -1);
  CHECK_BOTH(compare_distance_to_line(P2{0, 0}, P2{1, 1}, P2{0, 3}, P2{3, 1}) == 1);
  CHECK_BOTH(compare_distance_to_line(P2{0, 0}, P2{1, 1}, P2{3, 1}, P2{7, 9}) == 0);
  CHECK_BOTH(compare_distance_to_line(P2{0, 0}, P2{1, 1}, P2{3, 1}, P2{9, 7}) == 0);
  CHECK_BOTH(compare_distance_to_line(P2{0, 0}, P2{1, 1}, P2{5, 5}, P2{9, 7}) == -1);
  CHECK_BOTH(compare_distance_to_line(P2{0, 0}, P2{1, 1}, P2{5, 5}, P2{9, 9}) == 0);
  CHECK_BOTH(compare_distance_to_line(P2{0, 0}, P2{1, 0}, P2{5, 1 + 0x1p-52}, P2{9, -1}) == 1);
  CHECK_BOTH(compare_distance_to_line(P2{2, 2}, P2{2, 2}, P2{2, 4}, P2{5, 2}) == -1);  // from the point
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max(), least = -most - 1;
  CHECK_BOTH(compare_distance_to_line(I2{least, least}, I2{most, most}, I2{least, most}, I2{most, least}) == 0);
  CHECK_BOTH(compare_distance_to_line(I2{least, least}, I2{most, most}, I2{least, most}, I2{most - 1, least}) == 1);
  volatile double nine = 9;
  CHECK(compare_distance_to_line(P2{0, 0}, P2{1, 1}, P2{3, 1}, P2{nine, 7}) == 0);
}

TEST_CASE("compare_distance_to: a plane") {
  CHECK_BOTH(compare_distance_to_plane(L{0, 0, 2, -2}, P3{5, 5, 2}, P3{7, 7, 0}) == 0);
  CHECK_BOTH(compare_distance_to_plane(L{0, 0, 2, -2}, P3{5, 5, 2}, P3{7, 7, -tiny}) == -1);
  CHECK_BOTH(compare_distance_to_plane(L{0, 0, 2, -2}, P3{5, 5, 1}, P3{7, 7, -tiny}) == -1);
  CHECK_BOTH(compare_distance_to_plane(L{0, 0, 2, -2}, P3{5, 5, 3}, P3{7, 7, 2}) == 1);
  CHECK_BOTH(compare_distance_to_plane(L{0, 0, 2, -2}, P3{5, 5, 1}, P3{7, 7, 1}) == 0);
  CHECK_BOTH(compare_distance_to_plane(L{huge, huge, huge, 0}, P3{tiny, 0, 0}, P3{0, 0, tiny}) == 0);
  CHECK_BOTH(compare_distance_to_plane(L{0, 0, 0, 5}, P3{1, 0, 0}, P3{0, 0, 2}) == 0);
}

#ifdef IRG_HAVE_MPFR
namespace {

test::exact magnitude(const test::exact& x) { return x.sign() < 0 ? -x : x; }

template <class T>
void check_random(int trials) {
  test::random r(sizeof(T));
  test::sign_counts lines, planes;
  for (int i = 0; i < trials; ++i) {
    const int kind = test::hard_kind(r);
    std::array<T, 10> n{};
    std::array<test::exact, 10> x;
    for (std::size_t k = 0; k < n.size(); ++k) n[k] = test::hard_number<T>(r, kind);
    if (r.integer(0, 1) != 0) n[6] = n[4], n[9] = n[7];  // equally far, perhaps
    for (std::size_t k = 0; k < n.size(); ++k) x[k] = test::exact_of(n[k]);
    const auto area = [&](std::size_t k) { return (x[2] - x[0]) * (x[k + 1] - x[1]) - (x[3] - x[1]) * (x[k] - x[0]); };
    const auto value = [&](std::size_t k) { return x[0] * x[k] + x[1] * x[k + 1] + x[2] * x[k + 2] + x[3]; };
    const int line = (magnitude(area(4)) - magnitude(area(6))).sign();
    const int plane = (magnitude(value(4)) - magnitude(value(7))).sign();
    if (n[0] != n[2] || n[1] != n[3]) {
      using Q = irg::point<T, 2>;
      CHECK(compare_distance_to_line(Q{n[0], n[1]}, Q{n[2], n[3]}, Q{n[4], n[5]}, Q{n[6], n[7]}) == line);
      const auto again = [&] {
        return compare_distance_to_line(Q{n[0], n[1]}, Q{n[2], n[3]}, Q{n[4], n[5]}, Q{n[6], n[7]});
      };
      if (sizeof(T) == 8) CHECK(test::while_flushing(again) == line);
      lines.add(line);
    }
    using Q = irg::point<T, 3>;
    CHECK(compare_distance_to_plane(irg::plane<T>{n[0], n[1], n[2], n[3]}, Q{n[4], n[5], n[6]}, Q{n[7], n[8], n[9]}) ==
          plane);
    planes.add(plane);
  }
  lines.check(), planes.check();
}

}  // namespace

TEST_CASE("compare_distance_to: against rationals, on hard numbers, also with subnormal ones taken for zero") {
  check_random<double>(test::many_trials(10000));
  check_random<float>(test::many_trials(5000));
  check_random<std::int64_t>(test::many_trials(5000));
}
#endif
