// SPDX-License-Identifier: MIT
#include <irg/geometry/line_forms.hpp>

#include <limits>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::homogeneous_line;
using irg::implicit_line_of;
using irg::line;
using irg::parametric_line;
using irg::parametric_line_of;
using test::rational;

namespace {

using Q = irg::point<rational, 2>;
constexpr double none = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
constexpr double huge = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST_CASE("line_forms: the course's values, from form to form") {
  constexpr parametric_line<double, 2> l{{1, 1}, {3, 2}};
  CHECK_BOTH(implicit_line_of(l) == line<double>{-2, 3, -1});
  CHECK_BOTH(implicit_line_of(parametric_line<int, 2>{{1, 1}, {3, 2}}) == line<int>{-2, 3, -1});
  CHECK_BOTH(implicit_line_of(homogeneous_line<double, 2>{{2, 2, 2}, {4, 3, 1}}) == line<double>{-4, 6, -2});
  CHECK_BOTH(parametric_line_of(line<rational>{-2, 3, -1}) ==
             parametric_line<rational, 2>{{0, rational(1, 3)}, {3, 2}});
  CHECK_BOTH(parametric_line_of(line<double>{4, 0, 0}) == parametric_line<double, 2>{{0, 0}, {0, -4}});
  CHECK_BOTH(parametric_line_of(line<double>{0, 0.5, -1})->origin == irg::point<double, 2>{0, 2});
}

TEST_CASE("line_forms: what is no line, the ends of the range") {
  CHECK_BOTH(!implicit_line_of(parametric_line<double, 2>{{1, 1}, {0, 0}}));
  CHECK_BOTH(!implicit_line_of(parametric_line<double, 2>{{1, none}, {0, 1}}));
  CHECK_BOTH(!implicit_line_of(parametric_line<double, 2>{{1, 1}, {inf, 1}}));
  CHECK_BOTH(!implicit_line_of(homogeneous_line<double, 2>{{1, 1, 1}, {2, 2, 2}}));
  CHECK_BOTH(!parametric_line_of(line<double>{0, 0, 1}));  // the line at infinity
  CHECK_BOTH(!parametric_line_of(line<double>{1, 2, none}));
  CHECK_BOTH(!parametric_line_of(line<double>{inf, 2, 3}));
  // Beyond the range all coefficients are multiplied by one power of two.
  constexpr auto level = implicit_line_of(parametric_line<double, 2>{{0, 0}, {least, 0}});
  CHECK_BOTH((level && level->a == 0 && level->b > 0 && level->c == 0));
  constexpr auto far = implicit_line_of(parametric_line<double, 2>{{huge, -huge}, {1, 1}});  // -x + y + 2 huge
  CHECK_BOTH((far && far->a == -far->b && far->c == huge * (2 * far->b)));
  CHECK_BOTH(parametric_line_of(line<double>{huge, 1, huge})->origin == irg::point<double, 2>{-1, 0});
  static_assert(noexcept(parametric_line_of(line<float>{})) && noexcept(implicit_line_of(parametric_line<float, 2>{})));
}

TEST_CASE("line_forms: there and back, in rationals") {
  test::random r(1);
  const auto any = [&] { return rational(r.integer(-20, 20), r.integer(1, 7)); };
  for (int i = 0; i < 1000; ++i) {
    const line<rational> l{any(), any(), any()};
    const auto p = parametric_line_of(l);
    CHECK(p.has_value() == !(l.a == rational(0) && l.b == rational(0)));
    if (!p) continue;
    const Q left = p->origin + irg::vec<rational, 2>{-p->direction.y, p->direction.x};
    CHECK(irg::line_value(l, point_at(*p, any())) == rational(0));
    CHECK(rational(0) < irg::line_value(l, left));
    const auto back = implicit_line_of(*p);
    REQUIRE(back);
    CHECK((back->a == l.a && back->b == l.b && back->c == l.c));
  }
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("implicit_line_of, parametric_line_of: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  using line = irg::line<T>;
  sweep(
      named<T>("implicit_line_of"), 0.501,
      [&](test::random& r, sizes which) {
        const auto c = numbers<T, 4>(r, which);
        const auto e = rationals(c);
        return off_from_line<T>(implicit_line_of(irg::parametric_line<T, 2>{{c[0], c[1]}, {c[2], c[3]}}),
                                minors({e[0], e[1], E(1)}, {e[2], e[3], E(0)}));
      },
      3000);
  sweep(
      named<T>("parametric_line_of"), 0.5,
      [&](test::random& r, sizes which) {
        const auto c = numbers<T, 3>(r, which);
        const auto e = rationals(c);
        const auto got = parametric_line_of(line{c[0], c[1], c[2]});
        if (!got) return c[0] == 0 && c[1] == 0 ? 0.0 : wrong;
        const bool on_y = std::fabs(c[0]) < std::fabs(c[1]);
        return quotient_error(got->origin[on_y ? 1 : 0], -e[2], e[on_y ? 1 : 0]);
      },
      3000);
}

#endif
