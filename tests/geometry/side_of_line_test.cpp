// SPDX-License-Identifier: MIT
#include <irg/geometry/side_of_line.hpp>

#include <irg/geometry/plane.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/flush_mode.hpp"
#include "support/sign_trials.hpp"

using irg::side;
using irg::side_of_line;

namespace {

using P = irg::point<double, 2>;
using H = irg::hpoint<double, 2>;
using V = irg::vec<double, 3>;
struct own_line {
  float a, b, c;
};
constexpr double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST_CASE("side_of_line: on it and beside it") {
  CHECK_BOTH(side_of_line(V{1, 1, -2}, P{1, 1}) == side::on);
  CHECK_BOTH(side_of_line(V{1, 1, -2}, P{1, 1.0000000000000002}) == side::above);
  CHECK_BOTH(side_of_line(V{1, 1, -2}, P{1, 0.9999999999999999}) == side::below);
  CHECK_BOTH(side_of_line(own_line{1, 1, -2}, irg::point<float, 2>{1, 1}) == side::on);
  CHECK_BOTH(side_of_line(std::array<int, 3>{3, -1, 4}, irg::point<int, 2>{2, 10}) == side::on);
  CHECK_BOTH(side_of_line(std::array<int, 3>{2147483647, 2147483647, 2147483647},
                          irg::point<int, 2>{2147483647, -2147483647 - 1}) == side::on);
  CHECK_BOTH(side_of_line(V{huge, -huge, tiny}, P{huge, huge}) == side::above);
  CHECK_BOTH(side_of_line(V{tiny, tiny, 0}, P{tiny, -2 * tiny}) == side::below);
  volatile double one = 1;
  CHECK(side_of_line(V{1, 1, -2}, P{one, 1}) == side::on);
}

TEST_CASE("side_of_line: each member of a line of one's own has its part") {
  using Q = irg::point<float, 2>;
  CHECK_BOTH(side_of_line(own_line{0, 1, -2}, Q{5, 3}) == side::above);
  CHECK_BOTH(side_of_line(own_line{0, 1, -2}, Q{5, 2}) == side::on);
  CHECK_BOTH(side_of_line(own_line{0, 1, -2}, Q{5, 1}) == side::below);
  CHECK_BOTH(side_of_line(own_line{1, 0, -2}, Q{1, 5}) == side::below);
}

TEST_CASE("side_of_line: homogeneous points and directions") {
  CHECK_BOTH(side_of_line(V{1, 1, -2}, H{2, 2, 2}) == side::on);
  CHECK_BOTH(side_of_line(V{1, 1, -2}, H{3, 3, 2}) == side::above);
  CHECK_BOTH(side_of_line(V{1, 1, -2}, H{-3, -3, -2}) == side::above);  // the same point
  CHECK_BOTH(side_of_line(V{1, 1, -2}, H{1, -1, 0}) == side::on);    // along the line
  CHECK_BOTH(side_of_line(V{1, 1, -2}, H{1, 0, 0}) == side::above);
}

TEST_CASE("side_of_line: no line, no numbers") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK_BOTH(side_of_line(V{0, 0, 3}, P{5, 6}) == side::above);
  CHECK_BOTH(side_of_line(V{0, 0, 0}, P{5, 6}) == side::on);
  CHECK_BOTH(side_of_line(V{1, 0, 3}, P{nan, 6}) == side::on);
  CHECK_BOTH(side_of_line(V{1, 0, 3}, P{infinity, 6}) == side::on);
}

#ifdef IRG_HAVE_MPFR
namespace {

// Lines and planes, points and homogeneous points, of coefficients and coordinates in every kind; half of the lines and
// planes pass through the first point, as nearly as T allows.
template <class T>
void check_random(int trials) {
  test::random r(sizeof(T));
  test::sign_counts lines, planes;
  for (int i = 0; i < trials; ++i) {
    const int kind = test::hard_kind(r);
    std::array<T, 4> l{}, q{};
    for (T& c : l) c = test::hard_number<T>(r, kind);
    for (T& c : q) c = test::hard_number<T>(r, kind);
    const auto exact = [](T x) { return test::exact_of(x); };
    const auto sum = [&](int n, bool weighted) {  // of n products and the last coefficient, times the weight
      test::exact all = exact(l[static_cast<std::size_t>(n)]);
      if (weighted) all = all * exact(q[static_cast<std::size_t>(n)]);
      for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j) all = all + exact(l[j]) * exact(q[j]);
      return all.sign() * (weighted && q[static_cast<std::size_t>(n)] < 0 ? -1 : 1);
    };
    const irg::vec<T, 3> line{l[0], l[1], l[2]};
    const irg::plane<T> plane{l[0], l[1], l[2], l[3]};
    CHECK(sign_of(side_of_line(line, irg::point<T, 2>{q[0], q[1]})) == sum(2, false));
    CHECK(sign_of(side_of_line(line, irg::hpoint<T, 2>{q[0], q[1], q[2]})) == sum(2, true));
    CHECK(static_cast<int>(side_of(plane, irg::point<T, 3>{q[0], q[1], q[2]})) == sum(3, false));
    CHECK(static_cast<int>(side_of(plane, irg::hpoint<T, 3>{q[0], q[1], q[2], q[3]})) == sum(3, true));
    CHECK(sign_of(test::while_flushing([&] { return side_of_line(line, irg::point<T, 2>{q[0], q[1]}); })) ==
          sum(2, false));
    lines.add(sum(2, true)), planes.add(sum(3, true));
  }
  lines.check(), planes.check();
}

}  // namespace

TEST_CASE(
    "side_of_line and side_of a plane: against rationals, on hard numbers, also with subnormal ones taken for zero") {
  check_random<double>(test::many_trials(10000));
  check_random<float>(test::many_trials(5000));
  check_random<std::int64_t>(test::many_trials(5000));
}

TEST_CASE("side_of_line: next to a line that roundings hide") {
  test::random r(5);
  int rounded_zero = 0, rounded_wrong = 0;
  for (int i = 0; i < test::trials(5000); ++i) {
    // c is the rounded value of -(a*x + b*y), or next to it: the sign is that of the error.
    const double a = r.unit(), b = r.unit(), x = r.unit() + 1000, y = r.unit() + 1000;
    const double c = static_cast<double>(r.integer(-1, 1)) * 0x1p-43 - (irg::product(a, x) + irg::product(b, y));
    const int due = (test::exact(a) * test::exact(x) + test::exact(b) * test::exact(y) + test::exact(c)).sign();
    CHECK(sign_of(side_of_line(V{a, b, c}, P{x, y})) == due);
    const double rounded = (irg::product(a, x) + irg::product(b, y)) + c;
    rounded_zero += rounded == 0 && due != 0;
    rounded_wrong += (rounded > 0 && due < 0) || (rounded < 0 && due > 0);
  }
  CHECK(rounded_zero > 1000);
  CHECK(rounded_wrong > 0);
}
#endif
