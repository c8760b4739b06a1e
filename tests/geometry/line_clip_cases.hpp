// SPDX-License-Identifier: MIT
// Segments and windows that are hard to clip, and the exact result by rationals.
#pragma once

#include <irg/geometry/box.hpp>
#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/geometry/vocabulary.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace line_cases {

template <class T>
using P = irg::point<T, 2>;

template <class T>
struct line_case {
  P<T> a, b;
  irg::box<T, 2> window;
};

inline int release_or(int ci) { return std::getenv("IRG_RELEASE_TIER") ? 100 * ci : ci; }

/// Ordinary ones, lattices, ends and lines within an ulp or two of corners, all exponents, huge and subnormal numbers.
template <class T>
line_case<T> draw_case(test::random& r) {
  using limits = std::numeric_limits<T>;
  const auto any_exponent = [&] {
    const int e = static_cast<int>(r.integer(limits::min_exponent - limits::digits, limits::max_exponent));
    return static_cast<T>(std::ldexp(static_cast<T>(r.unit() - 0.5), e));
  };
  const auto near = [&](T x) {
    for (auto k = r.integer(-2, 2); k != 0; k += k < 0 ? 1 : -1)
      x = std::nextafter(x, k < 0 ? -limits::max() : limits::max());
    return x;
  };
  line_case<T> c{};
  const auto set = [&](auto number) {
    for (T* v : {&c.a.x, &c.a.y, &c.b.x, &c.b.y, &c.window.low.x, &c.window.low.y, &c.window.high.x, &c.window.high.y})
      *v = number();
    for (int i = 0; i < 2; ++i)
      if (c.window.high[i] < c.window.low[i]) std::swap(c.window.high[i], c.window.low[i]);
  };
  const auto kind = r.integer(0, 9);
  if (kind <= 2) set([&] { return static_cast<T>(r.unit() * 4 - 2); });
  if (kind == 3) set([&] { return static_cast<T>(r.integer(-6, 6)); });
  if (kind == 4) set(any_exponent);
  if (kind == 5) set([&] { return static_cast<T>(r.integer(-9, 9)) * limits::denorm_min(); });
  if (kind == 6)
    set([&] { return r.integer(0, 2) == 0 ? limits::max() * static_cast<T>(r.integer(-1, 1)) : any_exponent(); });
  if (kind >= 7) {  // through a corner, nearly
    set([&] { return static_cast<T>(r.unit() * 4 - 2); });
    if (kind == 8) set([&] { return static_cast<T>(std::ldexp(static_cast<double>(r.integer(-64, 64)), -3)); });
    const P<T> corner = irg::corner(c.window, static_cast<unsigned>(r.integer(0, 3)));
    const T reach = static_cast<T>(std::ldexp(1.0, static_cast<int>(r.integer(-3, 3))));
    const P<T> way{static_cast<T>(r.unit() - 0.5) * reach, static_cast<T>(r.unit() - 0.5)};
    c.a = {near(corner.x - way.x), near(corner.y - way.y)};
    c.b = {near(corner.x + way.x), near(corner.y + way.y)};
  }
  if (r.integer(0, 30) == 0) c.b = c.a;
  if (r.integer(0, 20) == 0) c.b.x = c.a.x;
  if (r.integer(0, 20) == 0) c.b.y = c.a.y;
  if (r.integer(0, 30) == 0) c.window.high.x = c.window.low.x;
  return c;
}

#ifdef IRG_HAVE_MPFR

using mpq = test::big_rational;

/// Whether no other T is nearer to the exact value.
template <class T>
bool is_nearest(T x, const mpq& exact) {
  const mpq off = abs(mpq(static_cast<double>(x)) - exact);
  for (const T to : {std::numeric_limits<T>::max(), -std::numeric_limits<T>::max()})
    if (abs(mpq(static_cast<double>(std::nextafter(x, to))) - exact) < off) return false;
  return true;
}

/// The exact parameters of the visible part, or nothing.
struct exact_line {
  bool visible = false;
  mpq low = mpq(0), high = mpq(1);
};
template <int N, class T>
exact_line exact_clip(const irg::point<T, N>& a, const irg::point<T, N>& b, const irg::box<T, N>& window) {
  const auto q = [](T x) { return mpq(static_cast<double>(x)); };
  exact_line e;
  e.visible = true;
  for (int i = 0; i < N; ++i) {
    if (a[i] == b[i]) {
      e.visible = e.visible && window.low[i] <= a[i] && a[i] <= window.high[i];
      continue;
    }
    const mpq way = q(b[i]) - q(a[i]);
    mpq in = (q(window.low[i]) - q(a[i])) / way, out = (q(window.high[i]) - q(a[i])) / way;
    if (b[i] < a[i]) std::swap(in, out);
    if (e.low < in) e.low = in;
    if (out < e.high) e.high = out;
  }
  e.visible = e.visible && !(e.high < e.low);
  return e;
}

/// Whether the result is the exact one: its decision, its coordinates each nearest, its parameters within 3u.
template <int N, class T>
bool is_exact(const std::optional<irg::clipped_line<irg::point<T, N>>>& r, const irg::point<T, N>& a,
              const irg::point<T, N>& b, const irg::box<T, N>& window) {
  const auto e = exact_clip<N>(a, b, window);
  if (e.visible != r.has_value()) return false;
  if (!r) return true;
  for (int end = 0; end < 2; ++end) {
    const mpq& t = end == 0 ? e.low : e.high;
    const auto& p = end == 0 ? r->first : r->second;
    const T s = end == 0 ? r->t_first : r->t_second;
    const mpq u = mpq(static_cast<double>(std::numeric_limits<T>::epsilon() / 2));
    const mpq least = mpq(static_cast<double>(std::numeric_limits<T>::denorm_min()));
    if (mpq(3.001) * u * t + least < abs(mpq(static_cast<double>(s)) - t)) return false;
    for (int i = 0; i < N; ++i) {
      const mpq from(static_cast<double>(a[i])), to(static_cast<double>(b[i]));
      if (!is_nearest(p[i], from + t * (to - from))) return false;
      if (p[i] < window.low[i] || window.high[i] < p[i]) return false;
    }
  }
  return true;
}

#endif

/// What every clipper against a window makes of segments that are done by hand. clip(a, b, window) calls it.
template <class Clip>
constexpr bool does_by_hand(const Clip& clip) {
  using D = P<double>;
  constexpr irg::box<double, 2> window{{0, 0}, {4, 3}};
  const auto gives = [&](D a, D b, D first, D second) {
    const auto kept = clip(a, b, window);
    return kept && kept->first == first && kept->second == second;
  };
  return gives({1, 1}, {2, 2}, {1, 1}, {2, 2}) && gives({-1, -1}, {5, 5}, {0, 0}, {3, 3}) &&
         gives({-2, 1}, {4, 4}, {0, 2}, {2, 3}) && gives({-1, 1}, {1, -1}, {0, 0}, {0, 0}) &&
         !clip(D{-2, 1}, D{1, -2}, window) && !clip(D{1, 1}, D{2, 2}, irg::box<double, 2>{});
}

/// Ends that are NaN or infinite leave nothing.
template <class Clip>
void check_refusals(const Clip& clip) {
  using D = P<double>;
  constexpr irg::box<double, 2> window{{0, 0}, {4, 3}};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    CHECK(!clip(D{bad, 1}, D{1, 1}, window));
    CHECK(!clip(D{9, 1}, D{1, bad}, window));
  }
}

/// The bits of Liang and Barsky, on floating cases and on a lattice of integers.
template <class T, class Clip>
void check_as_liang_barsky(const Clip& clip, std::uint64_t seed, int count) {
  test::random r(seed);
  int visible = 0, wrong = 0;
  for (int k = 0; k < release_or(count); ++k) {
    line_case<T> c{};
    if constexpr (std::is_integral_v<T>) {
      const auto any = [&] { return static_cast<T>(r.integer(-9, 9)); };
      c.a = {any(), any()}, c.b = {any(), any()};
      const P<T> p{any(), any()}, q{any(), any()};
      c.window = irg::bounding_box(irg::bounding_box(irg::box<T, 2>{}, p), q);
    } else {
      c = draw_case<T>(r);
    }
    const auto kept = clip(c.a, c.b, c.window);
    visible += kept ? 1 : 0;
    wrong += kept == irg::clip_line_liang_barsky(c.a, c.b, c.window) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(visible > count / 4);
}

}  // namespace line_cases
