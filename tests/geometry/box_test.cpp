// SPDX-License-Identifier: MIT
#include <irg/geometry/box.hpp>

#include <array>
#include <limits>
#include <sstream>
#include <vector>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/endless_number.hpp"
#include "support/random.hpp"

using namespace irg;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
using P2 = point<double, 2>;
using P3 = point<double, 3>;
using box2 = box<double, 2>;

/// A number without numeric_limits.
struct fraction {
  int n = 0, d = 1;
  constexpr fraction() = default;
  constexpr explicit fraction(int n_, int d_ = 1) : n(n_), d(d_) {}
  constexpr bool operator==(const fraction& o) const { return n * o.d == o.n * d; }
  constexpr bool operator<(const fraction& o) const { return n * o.d < o.n * d; }
  constexpr fraction operator-() const { return fraction{-n, d}; }
  constexpr fraction operator+(const fraction& o) const { return fraction{n * o.d + o.n * d, d * o.d}; }
  constexpr fraction operator-(const fraction& o) const { return *this + -o; }
  constexpr fraction operator*(const fraction& o) const { return fraction{n * o.n, d * o.d}; }
  constexpr fraction operator/(const fraction& o) const { return fraction{n * o.d, d * o.n}; }
};

/// The course's body.
constexpr std::array<P3, 4> body{P3{2, 0, 0}, P3{6, 2, 0}, P3{2, 8, 3}, P3{4, 1, -1}};

}  // namespace

TEST_CASE("box: type facts") {
  static_assert(std::is_trivially_copyable_v<box<float, 3>>);
  static_assert(std::is_same_v<decltype(bounding_box(body)), box<double, 3>>);
  static_assert(noexcept(bounding_box(body)));
}

TEST_CASE("box: extents, centre and size, golden") {
  constexpr auto b = bounding_box(body);
  CHECK_BOTH(b == box<double, 3>{{2, 0, -1}, {6, 8, 3}});
  CHECK_BOTH(extent(b) == vec<double, 3>{4, 8, 4});
  CHECK_BOTH(centre(b) == P3{4, 4, 1});
  CHECK_BOTH(bounding_sphere_of(b).radius * bounding_sphere_of(b).radius - 24 < 1e-14);
  CHECK_BOTH(corner(b, 0) == b.low);
  CHECK_BOTH(corner(b, 7) == b.high);
  CHECK_BOTH(corner(b, 5) == P3{6, 0, 3});
}

TEST_CASE("box: written by its two corners") {
  std::ostringstream out;
  out << irg::box<int, 2>{{0, -1}, {2, 3}};
  CHECK(out.str() == "((0, -1), (2, 3))");
}

TEST_CASE("box: minimax, golden") {
  using enum box_boundary;
  constexpr box2 a{{0, 0}, {2, 2}};
  CHECK_BOTH(!overlap(a, box2{{3, 0}, {4, 1}}));
  CHECK_BOTH(overlap(a, box2{{1, 1}, {3, 3}}));
  CHECK_BOTH(overlap(a, box2{{2, 0}, {3, 1}}));
  CHECK_BOTH(!overlap(a, box2{{2, 0}, {3, 1}}, open));
  CHECK_BOTH(overlap(a, box2{{1, 1}, {3, 3}}, open));
  CHECK_BOTH(!overlap(box2{{0, 0}, {4, 1}}, box2{{0, 2}, {4, 3}}));
}

TEST_CASE("box: what two boxes share") {
  constexpr box2 a{{0, 0}, {2, 2}};
  CHECK_BOTH(intersect(a, box2{{1, -1}, {3, 1}}) == box2{{1, 0}, {2, 1}});
  CHECK_BOTH(intersect(a, a) == a);
  CHECK_BOTH(intersect(a, box2{{2, 0}, {3, 1}}) == box2{{2, 0}, {2, 1}});  // they touch
  CHECK_BOTH(intersect(a, box2{{3, 0}, {4, 1}}).empty());
  CHECK_BOTH(intersect(a, box2{}).empty());
  CHECK_BOTH(intersect(a, box2{{nan_, 0}, {1, 1}}).empty());
  CHECK_BOTH(intersect(box2{{-inf, -inf}, {inf, inf}}, a) == a);
  CHECK_BOTH(intersect(box<fraction, 2>{}, box<fraction, 2>{}).empty());
}

TEST_CASE("box: minimax of flat boxes") {
  using enum box_boundary;
  constexpr box2 a{{0, 0}, {2, 2}};
  CHECK_BOTH(overlap(a, box2{{1, -1}, {1, 5}}, open));
  CHECK_BOTH(!overlap(a, box2{{2, -1}, {2, 5}}, open));
  CHECK_BOTH(overlap(a, box2{{2, 2}, {2, 2}}));
  CHECK_BOTH(!overlap(a, box2{{2, 2}, {2, 2}}, open));
  CHECK_BOTH(overlap(box2{{-inf, -inf}, {inf, inf}}, a, open));
}

TEST_CASE("box: empty") {
  constexpr box2 none;
  CHECK_BOTH(none.empty());
  CHECK_BOTH(box<int, 3>{}.empty());
  CHECK_BOTH(box<fraction, 2>{}.empty());
  CHECK_BOTH(bounding_box(std::array<P2, 0>{}).empty());
  CHECK_BOTH(box2{{0, 0}, {nan_, 1}}.empty());
  CHECK_BOTH(box2{{0, 2}, {1, 1}}.empty());
  CHECK_BOTH(!overlap(none, box2{{-inf, -inf}, {inf, inf}}));
  CHECK_BOTH(!overlap(none, none));
  CHECK_BOTH(!contains(none, P2{0, 0}));
  CHECK_BOTH(extent(none) == vec<double, 2>{});
  CHECK_BOTH(bounding_box(none, box2{{1, 2}, {3, 4}}) == box2{{1, 2}, {3, 4}});
  CHECK_BOTH(bounding_box(box2{{1, 2}, {3, 4}}, box2{{9, 9}, {0, 0}}) == box2{{1, 2}, {3, 4}});
}

TEST_CASE("box: NaN coordinates are passed over") {
  CHECK_BOTH(bounding_box(std::array<P2, 3>{P2{nan_, 5}, P2{1, nan_}, P2{2, 3}}) == box2{{1, 3}, {2, 5}});
  CHECK_BOTH(bounding_box(std::array<P2, 2>{P2{nan_, 5}, P2{nan_, 6}}).empty());
  CHECK_BOTH(!contains(box2{{0, 0}, {1, 1}}, P2{nan_, 0.5}));
}

TEST_CASE("box: centre at the ends of the range") {
  CHECK_BOTH(centre(box2{{-largest, 0}, {largest, 0}}) == P2{0, 0});
  CHECK_BOTH(centre(box2{{largest, largest / 2}, {largest, largest}}) == P2{largest, largest * 0.75});
  CHECK_BOTH(centre(box2{{5e-324, 0}, {5e-324, 0}}) == P2{5e-324, 0});
}

TEST_CASE("box: centre in numbers that are never constants and have no end") {
  using E = test::endless;
  CHECK(centre(box<E, 2>{{E(1), E(2)}, {E(2), E(9)}}) == point<E, 2>{E(3) / E(2), E(11) / E(2)});
}

TEST_CASE("box: rationals and integers") {
  constexpr std::array<point<fraction, 2>, 2> points{point<fraction, 2>{fraction{1, 2}, fraction{-1, 3}},
                                                     point<fraction, 2>{fraction{5}, fraction{-2, 3}}};
  constexpr auto b = bounding_box(points);
  CHECK_BOTH(b.low == point<fraction, 2>{fraction{1, 2}, fraction{-2, 3}});
  CHECK_BOTH(centre(b) == point<fraction, 2>{fraction{11, 4}, fraction{-1, 2}});
  CHECK_BOTH(bounding_box(std::array<point<int, 2>, 2>{point<int, 2>{3, -4}, point<int, 2>{-1, 7}}) ==
             box<int, 2>{{-1, -4}, {3, 7}});
}

TEST_CASE("box: overlap against a search for a common lattice point") {
  test::random r(1);
  int both = 0;
  for (int k = 0; k < 20000; ++k) {
    const auto any = [&] { return static_cast<int>(r.integer(0, 5)); };
    const box<int, 2> a{{any(), any()}, {any(), any()}}, b{{any(), any()}, {any(), any()}};
    bool common = false;
    for (int y = 0; y <= 5; ++y)
      for (int x = 0; x <= 5; ++x)
        common = common || (a.low.x <= x && x <= a.high.x && a.low.y <= y && y <= a.high.y && b.low.x <= x &&
                            x <= b.high.x && b.low.y <= y && y <= b.high.y);
    CHECK(overlap(a, b) == common);
    CHECK(overlap(a, b) == overlap(b, a));
    if (overlap(a, b, box_boundary::open)) CHECK(common);
    both += common ? 1 : 0;
  }
  CHECK(both > 500);
}

TEST_CASE("box: the enclosing box of random points holds them, and each side touches one") {
  test::random r(2);
  for (int k = 0; k < 200; ++k) {
    std::vector<P3> points(static_cast<std::size_t>(r.integer(1, 40)), P3{});
    for (P3& p : points) p = {r.unit(), r.unit() * 1e9, -r.unit()};
    const auto b = bounding_box(points);
    const auto ball = bounding_sphere_of(b);
    unsigned touched = 0;
    for (const P3& p : points) {
      CHECK(contains(b, p));
      CHECK(length(p - ball.centre) <= ball.radius * (1 + 1e-15));
      for (int i = 0; i < 3; ++i) {
        if (p[i] == b.low[i]) touched |= 1u << i;
        if (p[i] == b.high[i]) touched |= 8u << i;
      }
    }
    CHECK(touched == 63u);
  }
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("box: size, centre and sphere, numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("box: size, centre and sphere"), 2,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 2>(r, which);
        irg::box<T, 3> b;
        for (const auto& q : p) b = bounding_box(b, q);
        const auto s = extent(b);
        const auto middle = centre(b);
        E squared = 0;
        for (int k = 0; k < 3; ++k) {
          const E low = of(b.low[k]), high = of(b.high[k]), half = (low + high).times_power_of_two(-1);
          if (s[k] != test::nearest<T>(high - low)) return wrong;
          if (error_in_ulp(middle[k], half) > 0.5) return wrong;
          const E up = high - of(middle[k]), down = of(middle[k]) - low;
          squared = squared + (up < down ? down * down : up * up);
        }
        return root_error(bounding_sphere_of(b).radius, squared, E(1));
      },
      3000);
}

#endif
