// SPDX-License-Identifier: MIT
#include <irg/view/window_to_viewport.hpp>
#include <irg/view/textbook/window_to_viewport.hpp>

#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::fitted_viewport;
using irg::from_pixels;
using irg::point;
using irg::to_pixels;
using irg::view_window;
using irg::viewport;
using irg::window_fit;
using irg::window_status;
using irg::window_to_viewport;
using test::rational;

namespace {

using R = rational;
using P = point<R, 2>;
using D = point<double, 2>;
constexpr viewport<R> whole{0, 0, 800, 600};

template <class T>
constexpr point<T, 2> mapped(const view_window<T>& w, const viewport<T>& v, const point<T, 2>& p,
                             window_fit fit = window_fit::stretch) {
  return to_pixels(window_to_viewport(w, v, fit).value, p);
}

}  // namespace

TEST_CASE("window_to_viewport: Hank's values, and his own formula") {
  constexpr view_window<R> w{-4, 4, -3, 3};
  constexpr irg::textbook::edged_window<R> s{-4, -3, 8, 6};
  const auto both = [&](const P& p, const P& expected, const viewport<R>& v = whole) {
    CHECK(mapped(w, v, p) == expected);
    CHECK(irg::textbook::to_pixels(s, v, p) == expected);
  };
  both({-4, 3}, {0, 0});
  both({4, -3}, {800, 600});
  both({0, 0}, {400, 300});
  both({1, 2}, {500, 100});
  both({-4, -3}, {0, 600});
  both({1, 2}, {225, 100}, {100, 50, 200, 300});
  constexpr view_window<R> beside{0, 2, 1, 5};
  CHECK_BOTH(mapped(beside, whole, P{0, 5}) == P{0, 0});
  CHECK_BOTH(mapped(beside, whole, P{2, 1}) == P{800, 600});
  CHECK_BOTH(irg::textbook::to_pixels(irg::textbook::edged_window<R>{0, -5, 2, 4}, whole, P{2, 1}) == P{800, 600});
}

TEST_CASE("window_to_viewport: the aspect ratio kept, by hand") {
  constexpr view_window<R> square{-1, 1, -1, 1};
  CHECK_BOTH(mapped(square, whole, P{-1, 1}, window_fit::whole) == P{100, 0});
  CHECK_BOTH(mapped(square, whole, P{1, -1}, window_fit::whole) == P{700, 600});
  CHECK_BOTH(mapped(square, whole, P{-1, 1}, window_fit::fill) == P{0, -100});
  CHECK_BOTH(mapped(square, whole, P{1, -1}, window_fit::fill) == P{800, 700});
  CHECK_BOTH(mapped(square, {10, 20, 30, 60}, P{-1, 1}, window_fit::whole) == P{10, 35});
  CHECK_BOTH(mapped(square, {10, 20, 30, 60}, P{-1, 1}, window_fit::fill) == P{-5, 20});
  CHECK_BOTH(mapped({1, -1, -1, 1}, whole, P{-1, 1}, window_fit::whole) == P{700, 0});  // mirrored
  CHECK_BOTH(fitted_viewport(whole, 1, window_fit::whole) == viewport<R>{100, 0, 600, 600});
  CHECK_BOTH(fitted_viewport(whole, 1, window_fit::fill) == viewport<R>{0, -100, 800, 800});
  CHECK_BOTH(fitted_viewport(whole, 2, window_fit::whole) == viewport<R>{0, 100, 800, 400});
  CHECK_BOTH(fitted_viewport(whole, 2, window_fit::fill) == viewport<R>{-200, 0, 1200, 600});
  CHECK_BOTH(fitted_viewport(whole, 1, window_fit::stretch) == whole);
  CHECK_BOTH(fitted_viewport(whole, 0, window_fit::whole) == whole);
  CHECK_BOTH(fitted_viewport(whole, -1, window_fit::fill) == whole);
  constexpr double least = std::numeric_limits<double>::denorm_min();
  CHECK_BOTH(fitted_viewport(viewport<double>{0, 0, 1, 1}, least, window_fit::whole).width == least);
}

TEST_CASE(
    "window_to_viewport: in rationals, there and back; one scale; as much seen as the name says; as by viewport") {
  test::random r(11);
  for (int i = 0; i < 1500; ++i) {
    const auto n = [&] { return R{r.integer(-20, 20), r.integer(1, 3)}; };
    const auto size = [&] { return R{r.integer(1, 60), r.integer(1, 3)}; };
    const view_window<R> w{n(), n(), n(), n()};
    const viewport<R> v{n(), n(), size(), size()};
    for (const auto fit : {window_fit::stretch, window_fit::whole, window_fit::fill}) {
      const auto m = window_to_viewport(w, v, fit);
      if (w.left == w.right || w.bottom == w.top) {
        CHECK(m.status == window_status::bad_window);
        continue;
      }
      REQUIRE(m.status == window_status::ok);
      const P p{n(), n()};
      CHECK(from_pixels(m.value, to_pixels(m.value, p)) == p);
      const P first = to_pixels(m.value, P{w.left, w.top}), last = to_pixels(m.value, P{w.right, w.bottom});
      CHECK((first.x < last.x && first.y < last.y));
      CHECK((first.x + last.x == v.x + v.x + v.width && first.y + last.y == v.y + v.y + v.height));  // centred
      const R width = last.x - first.x, height = last.y - first.y;
      if (fit == window_fit::stretch) CHECK((width == v.width && height == v.height));
      if (fit == window_fit::whole)
        CHECK((!(v.width < width) && !(v.height < height) && (width == v.width || height == v.height)));
      if (fit == window_fit::fill)
        CHECK((!(width < v.width) && !(height < v.height) && (width == v.width || height == v.height)));
      const auto positive = [](R x) { return x < R(0) ? -x : x; };
      if (fit != window_fit::stretch) CHECK(positive(m.value.scale.x) == positive(m.value.scale.y));
      const R aspect = positive((w.right - w.left) / (w.top - w.bottom));
      const viewport<R> fitted = fitted_viewport(v, aspect, fit);
      CHECK((fitted.x == first.x && fitted.y == first.y && fitted.width == width && fitted.height == height));
    }
  }
}

TEST_CASE("window_to_viewport: refusals and extremes, in every life") {
  constexpr double inf = std::numeric_limits<double>::infinity(),
                   not_a_number = std::numeric_limits<double>::quiet_NaN();
  using enum window_status;
  constexpr view_window<double> w{-4, 4, -3, 3};
  const auto status = [](const view_window<double>& window, const viewport<double>& v) {
    for (const auto fit : {window_fit::whole, window_fit::fill})
      CHECK((window_to_viewport(window, v, fit).status == window_to_viewport(window, v).status));
    return window_to_viewport(window, v).status;
  };
  for (const double bad : {inf, -inf, not_a_number}) {
    CHECK(status({bad, 4, -3, 3}, {0, 0, 8, 6}) == bad_window);
    CHECK(status({-4, 4, -3, bad}, {0, 0, 8, 6}) == bad_window);
    CHECK(status(w, {bad, 0, 8, 6}) == bad_viewport);
    CHECK(status(w, {0, 0, bad, 6}) == bad_viewport);
    CHECK(status(w, {0, 0, 8, bad}) == bad_viewport);
  }
  static_assert(window_to_viewport(view_window<double>{1, 1, -3, 3}, {0, 0, 8, 6}).status == bad_window);
  static_assert(window_to_viewport(w, {0, 0, 0, 6}).status == bad_viewport);
  static_assert(window_to_viewport(w, {0, 0, 8, -6}).status == bad_viewport);
  static_assert(window_to_viewport(w, {0, 0, not_a_number, 6}).value == irg::window_mapping<double>{});
  static_assert(window_to_viewport(view_window<double>{0, 1e-320, -3, 3}, {0, 0, 8, 6}).status == not_representable);
  CHECK(status({-8e307, 8e307, -3, 3}, {0, 0, 1e-5, 6}) == not_representable);
  // A subnormal scale would be off by 4u.
  CHECK(status({-8e307, 8e307, -3, 3}, {0, 0, 1, 6}) == not_representable);
  CHECK(status({-8e307, 8e307, -3, 3}, {0, 0, 4, 6}) == ok);
  CHECK(status(w, {0, 0, 1, 1}) == ok);
  // The filling picture would reach beyond the numbers; the whole one vanishes in one direction only.
  constexpr view_window<double> needle{0, 1e-200, 0, 1e200};
  static_assert(window_to_viewport(needle, {0, 0, 1, 1}, window_fit::fill).status == not_representable);
  static_assert(window_to_viewport(needle, {0, 0, 1, 1}, window_fit::whole).status == ok);
  static_assert(window_to_viewport(needle, {0, 0, 1, 1}).status == ok);
  CHECK(status(w, {0, 0, 65535, 1}) == ok);
  CHECK(mapped(w, {0, 0, 65535, 1}, D{4, -3}) == D{65535, 1});
  // Far away, where the window's size is a rounding error of its place: still from border to border.
  CHECK(mapped(view_window<double>{1e15, 1e15 + 1, 1e15, 1e15 + 2}, {0, 0, 800, 600}, D{1e15 + 0.5, 1e15 + 1}) ==
        D{400, 300});
  constexpr auto any = mapped(view_window<float>{0.1f, 0.7f, -0.3f, 0.9f}, {3, 5, 77, 33}, point<float, 2>{0.4f, 0.2f},
                              window_fit::whole);
  volatile float left = 0.1f;
  CHECK(mapped(view_window<float>{left, 0.7f, -0.3f, 0.9f}, {3, 5, 77, 33}, point<float, 2>{0.4f, 0.2f},
               window_fit::whole) == any);
}
