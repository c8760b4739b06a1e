// SPDX-License-Identifier: MIT
#include <irg/math/vec.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <type_traits>

#include <irg/math/homogeneous.hpp>
#include <irg/math/mat.hpp>
#ifdef IRG_HAVE_EIGEN
#include <Eigen/Geometry>
#endif

#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/own_types.hpp"
#include "support/random.hpp"

namespace {

// A number none of whose operations is a constant expression, as those of GMP and Boost are not.
struct run_time_number {
  double value = 0;
  run_time_number() = default;
  explicit run_time_number(int i) : value(i) {}
  static run_time_number of(double x) {
    run_time_number n;
    n.value = x;
    return n;
  }
  friend run_time_number operator+(const run_time_number& a, const run_time_number& b) { return of(a.value + b.value); }
  friend run_time_number operator-(const run_time_number& a, const run_time_number& b) { return of(a.value - b.value); }
  friend run_time_number operator*(const run_time_number& a, const run_time_number& b) { return of(a.value * b.value); }
  friend run_time_number operator/(const run_time_number& a, const run_time_number& b) { return of(a.value / b.value); }
  run_time_number operator-() const { return of(-value); }
  friend bool operator<(const run_time_number& a, const run_time_number& b) { return a.value < b.value; }
  friend bool operator==(const run_time_number& a, const run_time_number& b) { return a.value == b.value; }
};
static_assert(irg::Scalar<run_time_number>);

using vec3 = irg::vec<double, 3>;
using point3 = irg::point<double, 3>;

// 1. Types. Plain aggregates: no more than their numbers, copied as bytes.
static_assert(std::is_aggregate_v<vec3> && std::is_trivially_copyable_v<vec3> && sizeof(vec3) == 3 * sizeof(double));
static_assert(std::is_aggregate_v<point3> && std::is_aggregate_v<irg::hpoint<float, 3>>);
static_assert(sizeof(irg::vec<float, 2>) == 8 && sizeof(irg::hpoint<float, 2>) == 12 &&
              sizeof(irg::vec<float, 7>) == 28);

static_assert(irg::Vector<vec3> && !irg::Point<vec3> && !irg::HomogeneousPoint<irg::vec<float, 4>>);
static_assert(irg::Point<point3> && !irg::Vector<point3> && !irg::HomogeneousPoint<point3>);
static_assert(irg::HomogeneousPoint<irg::hpoint<float, 2>> && !irg::Vector<irg::hpoint<float, 3>>);
static_assert(!irg::Point<irg::hpoint<float, 3>> && irg::Vector<irg::vec<float, 7>> && irg::Vector<irg::vec<int, 1>>);
static_assert(irg::size_of<irg::hpoint<float, 3>> == 4 && irg::size_of<irg::vec<double, 7>> == 7);

template <class A, class B>
concept can_add = requires(const A& a, const B& b) { a + b; };
template <class A, class B>
concept can_subtract = requires(const A& a, const B& b) { a - b; };
template <class A, class B>
concept can_scale = requires(const A& a, const B& b) { a* b; };
template <class A, class B>
concept can_dot = requires(const A& a, const B& b) { irg::dot(a, b); };
template <class A, class B>
concept can_cross = requires(const A& a, const B& b) { irg::cross(a, b); };

static_assert(can_add<vec3, vec3> && can_add<point3, vec3> && !can_add<point3, point3> && !can_add<vec3, point3>);
static_assert(can_subtract<point3, point3> && can_subtract<point3, vec3> && !can_subtract<vec3, point3>);
static_assert(std::is_same_v<decltype(point3{} - point3{}), vec3> &&
              std::is_same_v<decltype(point3{} + vec3{}), point3>);
static_assert(can_scale<vec3, double> && can_scale<double, vec3> && can_scale<vec3, int>);
static_assert(!can_scale<vec3, vec3> && !can_scale<point3, double> && !can_add<irg::hpoint<double, 3>, vec3>);
static_assert(!can_add<vec3, irg::vec<float, 3>> && !can_add<vec3, irg::vec<double, 2>>);
static_assert(can_dot<vec3, vec3> && can_dot<vec3, std::array<double, 3>> && !can_dot<vec3, irg::vec<double, 2>>);
static_assert(!can_dot<vec3, irg::vec<float, 3>> && !can_dot<vec3, point3> && !can_dot<point3, point3>);
static_assert(can_cross<vec3, std::array<double, 3>> && !can_cross<vec3, irg::vec<double, 2>>);
static_assert(irg::cross(irg::vec<double, 2>{1, 2}, std::array{3.0, 4.0}) == -2.0);
static_assert(!can_cross<irg::vec<double, 4>, irg::vec<double, 4>> && !can_cross<point3, vec3>);
static_assert(std::is_same_v<decltype(irg::cross(std::array<float, 3>{}, irg::vec<float, 3>{})), std::array<float, 3>>);

constexpr vec3 a{1, 2, 3}, b{4, 5, 6};

constexpr vec3 accumulated() {
  vec3 v = a;
  v += b;
  v -= vec3{1, 1, 1};
  v *= 2;
  v[1] = -1;
  return v;
}

// Archetypes have what Vector asks and nothing more; dot and cross must not ask for more either.
static_assert(std::same_as<irg::assignable<irg::point<double, 2>>, irg::point<double, 2>>);
static_assert(std::same_as<irg::assignable<archetype::point<int, 2>>, irg::point<int, 2>>);
static_assert(std::same_as<irg::assignable<archetype::vector<int, 3>>, irg::vec<int, 3>>);
static_assert(std::same_as<irg::assignable<archetype::homogeneous_point<int, 3>>, irg::hpoint<int, 2>>);
static_assert(std::same_as<irg::assignable<archetype::any_kind<int, 3>>, std::array<int, 3>>);
static_assert([] {
  const auto p = archetype::point<int, 3>::of(1, 2, 3);
  const irg::point<int, 3> kept = irg::as_assignable(p);
  const auto again = irg::from_assignable<archetype::point<int, 3>>(kept);
  const auto zero = irg::zero_coordinates<archetype::point<int, 3>>();
  return kept == irg::point<int, 3>{1, 2, 3} && again.nth(0) == 1 && again.nth(2) == 3 && zero.nth(1) == 0;
}());

constexpr bool archetypes_are_enough() {
  using number = archetype::scalar;
  using vector = archetype::vector<number, 3>;
  const vector u = vector::of(number(1), number(2), number(3)), v = vector::of(number(4), number(5), number(6));
  const vector w = irg::cross(u, v);
  return irg::dot(u, v) == number(32) && w.nth(0) == number(-3) && w.nth(1) == number(6) && w.nth(2) == number(-3);
}

// A double of any sign and any exponent in [-range, range].
double any_double(test::random& random, int range) {
  double x = 1 + random.unit();
  for (auto e = random.integer(-range, range); e != 0; e += e < 0 ? 1 : -1) x = e < 0 ? x / 2 : x * 2;
  return (random.next() & 1) != 0 ? -x : x;
}
vec3 any_vec(test::random& random, int range) {
  const double x = any_double(random, range), y = any_double(random, range);
  return {x, y, any_double(random, range)};
}

// Each operation rounded on its own: volatile leaves the compiler no choice.
double rounded_product(double x, double y) {
  volatile double vx = x, vy = y;
  volatile double p = vx * vy;
  return p;
}
double rounded_sum(double x, double y) {
  volatile double vx = x, vy = y;
  volatile double s = vx + vy;
  return s;
}

}  // namespace

TEST_CASE("vec: operators by hand") {
  CHECK_BOTH(a + b == vec3{5, 7, 9});
  CHECK_BOTH(b - a == vec3{3, 3, 3});
  CHECK_BOTH(-a == vec3{-1, -2, -3});
  CHECK_BOTH(a * 2 == vec3{2, 4, 6});
  CHECK_BOTH(0.5 * b == vec3{2, 2.5, 3});
  CHECK_BOTH(b / 2 == vec3{2, 2.5, 3});
  CHECK_BOTH(accumulated() == vec3{8, -1, 16});
  CHECK_BOTH(vec3{} == vec3{0, 0, 0});
  CHECK_BOTH(a != b);
  CHECK_BOTH(irg::vec<int, 5>{{1, 2, 3, 4, 5}} + irg::vec<int, 5>{{5, 4, 3, 2, 1}} ==
             irg::vec<int, 5>{{6, 6, 6, 6, 6}});
}

TEST_CASE("vec: written as (1, 2, 3) into any stream of numbers and text") {
  std::ostringstream out;
  out << vec3{1, -2, 0.5} << irg::point<int, 2>{3, 4} << irg::hpoint<float, 3>{1, 2, 3, 1}
      << irg::vec<signed char, 1>{{65}};
  CHECK(out.str() == "(1, -2, 0.5)(3, 4)(1, 2, 3, 1)(65)");
  static_assert(!irg::TextStream<std::ostringstream, run_time_number> && !irg::TextStream<int>);
}

TEST_CASE("vec: points and vectors") {
  CHECK_BOTH(point3{5, 5, 5} - point3{1, 2, 3} == vec3{4, 3, 2});
  CHECK_BOTH(point3{1, 2, 3} + vec3{4, 3, 2} == point3{5, 5, 5});
  CHECK_BOTH(point3{5, 5, 5} - vec3{4, 3, 2} == point3{1, 2, 3});
  CHECK_BOTH(irg::to_point(irg::to_vec(point3{1, 2, 3})) == point3{1, 2, 3});
  CHECK_BOTH(irg::to_homogeneous(point3{1, 2, 3}) == irg::hpoint<double, 3>{1, 2, 3, 1});
  CHECK_BOTH(irg::to_homogeneous(irg::point<int, 2>{7, 8}) == irg::hpoint<int, 2>{7, 8, 1});
  CHECK_BOTH(irg::to_cartesian(irg::hpoint<double, 3>{2, 4, 6, 2}) == point3{1, 2, 3});
  CHECK_BOTH(irg::to_cartesian(irg::hpoint<double, 2>{2, 4, -2}) == irg::point<double, 2>{-1, -2});
}

TEST_CASE("vec: points of any dimension") {
  using point4 = irg::point<double, 4>;
  static_assert(irg::Point<point4> && !irg::Vector<point4> && irg::HomogeneousPoint<irg::hpoint<int, 1>>);
  static_assert(irg::size_of<irg::hpoint<double, 4>> == 5 && irg::size_of<irg::point<int, 1>> == 1);
  CHECK_BOTH(point4{{4, 3, 2, 1}} - point4{{1, 1, 1, 1}} == irg::vec<double, 4>{3, 2, 1, 0});
  CHECK_BOTH(irg::to_homogeneous(point4{{4, 3, 2, 1}}) == irg::hpoint<double, 4>{{4, 3, 2, 1, 1}});
  CHECK_BOTH(irg::to_cartesian(irg::hpoint<double, 4>{{4, 3, 2, 1, 2}}) == point4{{2, 1.5, 1, 0.5}});
  CHECK_BOTH(irg::to_cartesian(irg::hpoint<double, 1>{{6, 3}})[0] == 2);
  CHECK_BOTH(*irg::try_to_cartesian(irg::identity_matrix<double, 5>() * point4{{4, 3, 2, 1}}) == point4{{4, 3, 2, 1}});
  CHECK_BOTH(irg::homogeneous_kind_of(irg::hpoint<double, 4>{{0, 1, 0, 0, 0}}) == irg::homogeneous_kind::direction);
}

TEST_CASE("vec: the course's exercise 1") {
  constexpr vec3 ga{2, 3, -4}, gb{-1, 4, -1}, gc{2, 2, 4};
  constexpr vec3 v1 = ga + gb, v2 = irg::cross(v1, gc);
  CHECK_BOTH(v1 == vec3{1, 7, -5});
  CHECK_BOTH(irg::dot(v1, gb) == 32);
  CHECK_BOTH(v2 == vec3{38, -14, -12});
  CHECK_BOTH(-v2 == vec3{-38, 14, 12});
  CHECK_BOTH(irg::dot(v2, v2) == 1784);
  CHECK_BOTH(irg::dot(v1, v1) == 75);
}

TEST_CASE("vec: dot and cross of the coordinate axes") {
  constexpr irg::vec<int, 3> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK_BOTH(irg::cross(x, y) == z);
  CHECK_BOTH(irg::cross(y, z) == x);
  CHECK_BOTH(irg::cross(z, x) == y);
  CHECK_BOTH(irg::cross(y, x) == -z);
  CHECK_BOTH(irg::dot(x, y) == 0);
  CHECK_BOTH(irg::dot(irg::vec<int, 1>{{3}}, irg::vec<int, 1>{{5}}) == 15);
  CHECK_BOTH(archetypes_are_enough());
}

TEST_CASE("vec: sums run from the first coordinate to the last, each product and sum rounded once") {
  constexpr irg::vec<double, 4> huge{0x1p53, 1, 1, -0x1p53}, ones{1, 1, 1, 1};
  CHECK_BOTH(irg::dot(huge, ones) == 0.0);  // from the other end: 2
  constexpr irg::vec<double, 4> reversed{-0x1p53, 1, 1, 0x1p53};
  CHECK_BOTH(irg::dot(reversed, ones) == 2.0);
  test::random random(1);
  int wrong_dot = 0, wrong_cross = 0, wrong_scale = 0;
  for (int i = 0; i < 100'000; ++i) {
    const vec3 u = any_vec(random, 3), v = any_vec(random, 3);
    double sum = rounded_product(u.x, v.x);
    sum = rounded_sum(sum, rounded_product(u.y, v.y));
    sum = rounded_sum(sum, rounded_product(u.z, v.z));
    wrong_dot += irg::dot(u, v) != sum;
    const vec3 w = irg::cross(u, v);
    wrong_cross += w.x != rounded_sum(rounded_product(u.y, v.z), -rounded_product(u.z, v.y)) ||
                   w.y != rounded_sum(rounded_product(u.z, v.x), -rounded_product(u.x, v.z)) ||
                   w.z != rounded_sum(rounded_product(u.x, v.y), -rounded_product(u.y, v.x));
    wrong_scale += (u * v.x + v).x != rounded_sum(rounded_product(u.x, v.x), v.x);
  }
  CHECK(wrong_dot == 0);
  CHECK(wrong_cross == 0);
  CHECK(wrong_scale == 0);
}

TEST_CASE("vec: algebra that rounding cannot spoil") {
  test::random random(2);
  int wrong = 0;
  for (int i = 0; i < 100'000; ++i) {
    const vec3 u = any_vec(random, 500), v = any_vec(random, 500);
    const vec3 zero{0, 0, 0};
    wrong += irg::cross(u, u) != zero;                      // huge and tiny alike, as long as no product overflows
    wrong += irg::cross(u, v) != -irg::cross(v, u) + zero;  // + zero: -0 is 0
    wrong += irg::dot(u, v) != irg::dot(v, u);
    wrong += irg::cross(u * 0.5, v) != irg::cross(u, v) * 0.5 && irg::cross(u, v) * 0.5 * 2 == irg::cross(u, v);
  }
  CHECK(wrong == 0);
}

TEST_CASE("vec: agreement with integers, which do not round") {
  test::random random(3);
  int wrong = 0;
  for (int i = 0; i < 100'000; ++i) {
    irg::vec<std::int64_t, 3> u, v;
    for (int k = 0; k < 3; ++k) {
      u[k] = random.integer(-(1 << 25), 1 << 25);
      v[k] = random.integer(-(1 << 25), 1 << 25);
    }
    const auto real = [](const irg::vec<std::int64_t, 3>& w) {
      return vec3{static_cast<double>(w.x), static_cast<double>(w.y), static_cast<double>(w.z)};
    };
    wrong += irg::cross(real(u), real(v)) != real(irg::cross(u, v));
    wrong += irg::dot(real(u), real(v)) != static_cast<double>(irg::dot(u, v));
  }
  CHECK(wrong == 0);
}

TEST_CASE("vec: hostile numbers stay what IEEE makes of them") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(irg::dot(vec3{infinity, 0, 0}, vec3{1, 1, 1}) == infinity);
  CHECK_BOTH(vec3{not_a_number, 0, 0} != vec3{not_a_number, 0, 0});
  CHECK_BOTH(vec3{0.0, 0, 0} == vec3{-0.0, 0, 0});
  volatile double large = 1e200;  // products overflow from 2^512 on: outside of the stated domain, and NaN
  const vec3 u{large, large, large};
  CHECK(irg::cross(u, u) != irg::cross(u, u));
  constexpr vec3 tiny{5e-324, 5e-324, 1};
  CHECK_BOTH(irg::cross(tiny, tiny) == vec3{0, 0, 0});
}

TEST_CASE("vec: GLM vectors serve as they are") {
#ifdef IRG_HAVE_GLM
  CHECK_BOTH(irg::dot(glm::dvec3(1, 2, 3), vec3{4, 5, 6}) == 32.0);
  CHECK_BOTH(irg::dot(glm::vec2(1, 2), glm::vec2(4, 5)) == 14.0f);
  CHECK_BOTH(irg::dot(glm::vec4(1, 2, 3, 4), glm::vec4(1, 1, 1, 1)) == 10.0f);
  CHECK_BOTH(irg::cross(glm::vec3(1, 7, -5), glm::vec3(2, 2, 4)) == glm::vec3(38, -14, -12));
  CHECK_BOTH(irg::cross(glm::dvec3(1, 7, -5), vec3{2, 2, 4}).y == -14.0);
#else
  MESSAGE("skipped: GLM was not found");
#endif
}

TEST_CASE("vec: Eigen vectors serve as they are") {
#ifdef IRG_HAVE_EIGEN
  const Eigen::Vector3d u(1, 7, -5), v(2, 2, 4);
  CHECK(irg::cross(u, v) == Eigen::Vector3d(38, -14, -12));
  CHECK(irg::cross(u, v) == u.cross(v));
  CHECK(irg::dot(Eigen::Vector2f(1, 2), Eigen::Vector2f(4, 5)) == 14.0f);
  CHECK(irg::dot(Eigen::Vector4d(1, 2, 3, 4), irg::vec<double, 4>{1, 1, 1, 1}) == 10.0);
#else
  MESSAGE("skipped: Eigen was not found");
#endif
}

namespace {

// The error of dot_fast in u times the sum of the products' sizes, against exact integers of 24 bits.
template <int N>
double dot_fast_error(const irg::vec<float, N>& v, const irg::vec<float, N>& w) {
  std::int64_t sum = 0, size = 0;
  for (int k = 0; k < N; ++k) {
    const std::int64_t term = static_cast<std::int64_t>(v[k]) * static_cast<std::int64_t>(w[k]);
    sum += term;
    size += std::abs(term);
  }
  const double error = std::abs(static_cast<double>(dot_fast(v, w)) - static_cast<double>(sum));
  return size == 0 ? 0 : error * 0x1p24 / static_cast<double>(size);
}

// The worst that small changes of one coordinate after another lead to.
template <int N>
double worst_of_dot_fast(test::random& r) {
  double worst = 0;
  for (int start = test::trials(40); start > 0; --start) {
    irg::vec<float, N> v{}, w{};
    for (int k = 0; k < N; ++k) {
      v[k] = static_cast<float>(r.integer(1 << (k < 2 ? 12 : 22), 1 << (k < 2 ? 13 : 24)));
      w[k] = static_cast<float>(r.integer(1 << 12, 1 << (k < 2 ? 13 : 24)));
    }
    double best = dot_fast_error(v, w);
    for (int step = 0; step < 3000; ++step) {
      irg::vec<float, N> x = v, y = w;
      float& changed = (r.integer(0, 1) == 0 ? x : y)[static_cast<int>(r.integer(0, N - 1))];
      changed = static_cast<float>(
          r.integer(0, 3) == 0
              ? r.integer(1, 1 << 24)
              : std::min<std::int64_t>(
                    std::max<std::int64_t>(static_cast<std::int64_t>(changed) + r.integer(-64, 64), 1), 1 << 24));
      const double there = dot_fast_error(x, y);
      if (there >= best) v = x, w = y, best = there;
    }
    worst = std::max(worst, best);
  }
  return worst;
}

}  // namespace

// The variants that may be fused: near the guarded ones, within their bound, against exact integers.
TEST_CASE("vec: dot_fast and cross_fast") {
  CHECK_BOTH(dot_fast(vec3{1, 2, 3}, vec3{4, -5, 6}) == 12);
  CHECK_BOTH(cross_fast(vec3{1, 0, 0}, vec3{0, 1, 0}) == vec3{0, 0, 1});
  test::random r(12);
  const auto coordinate = [&] { return static_cast<float>(r.integer(-(1 << 24), 1 << 24)); };
  int wrong = 0;
  for (int i = 0; i < 100000; ++i) {
    const irg::vec<float, 3> v{coordinate(), coordinate(), coordinate()}, w{coordinate(), coordinate(), coordinate()};
    const auto term = [&](int j, int k) { return static_cast<std::int64_t>(v[j]) * static_cast<std::int64_t>(w[k]); };
    wrong += dot_fast_error(v, w) > 3;
    const auto c = cross_fast(v, w);
    for (int k = 0; k < 3; ++k) {
      const std::int64_t p = term((k + 1) % 3, (k + 2) % 3), q = term((k + 2) % 3, (k + 1) % 3);
      const double off = std::abs(static_cast<double>(c[k]) - static_cast<double>(p - q));
      wrong += off > 2 * 0x1p-24 * static_cast<double>(std::abs(p) + std::abs(q));
    }
  }
  CHECK(wrong == 0);
  const double of_two = worst_of_dot_fast<2>(r), of_three = worst_of_dot_fast<3>(r), of_four = worst_of_dot_fast<4>(r);
  MESSAGE("dot_fast of 2, 3 and 4 coordinates: ", of_two, ", ", of_three, " and ", of_four, " u of the sizes");
  CHECK(of_two <= 2);
  CHECK(of_three <= 3);
  CHECK(of_four <= 4);
}

TEST_CASE("vec: of numbers that have no constant expressions") {
  using N = run_time_number;
  const irg::vec<N, 3> v{N(1), N(2), N(3)}, w{N(3), N(2), N(1)};
  CHECK((dot(v, w) == N(10) && v == v && !(v == w) && N(1) / N(2) < N(1)));
  CHECK((irg::point<N, 2>{N(1), N(2)} == irg::point<N, 2>{N(1), N(2)} && irg::hpoint<N, 3>{} == irg::hpoint<N, 3>{}));
  const auto identity = irg::identity_matrix<N, 3>();
  CHECK((identity == identity && identity * v == v && determinant(identity) == N(1)));
}
