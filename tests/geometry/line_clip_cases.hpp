// SPDX-License-Identifier: MIT
// Segments and windows that are hard to clip, and the exact result by rationals.
#pragma once

#include <irg/geometry/box.hpp>
#include <irg/geometry/clipped_line.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#ifdef IRG_HAVE_MPFR
#include <gmp.h>
#endif

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

/// A rational number of any size.
class mpq {
public:
  mpq(double x = 0) { mpq_init(v), mpq_set_d(v, x); }
  mpq(const mpq& o) { mpq_init(v), mpq_set(v, o.v); }
  mpq& operator=(const mpq& o) { return mpq_set(v, o.v), *this; }
  ~mpq() { mpq_clear(v); }
  friend mpq operator+(const mpq& a, const mpq& b) { return mpq(a, b, mpq_add); }
  friend mpq operator-(const mpq& a, const mpq& b) { return mpq(a, b, mpq_sub); }
  friend mpq operator*(const mpq& a, const mpq& b) { return mpq(a, b, mpq_mul); }
  friend mpq operator/(const mpq& a, const mpq& b) { return mpq(a, b, mpq_div); }
  friend bool operator<(const mpq& a, const mpq& b) { return mpq_cmp(a.v, b.v) < 0; }
  friend bool operator==(const mpq& a, const mpq& b) { return mpq_equal(a.v, b.v) != 0; }
  double nearly() const { return mpq_get_d(v); }
  friend mpq abs(const mpq& a) { return a < mpq() ? mpq() - a : a; }

private:
  mpq(const mpq& a, const mpq& b, void (*f)(mpq_ptr, mpq_srcptr, mpq_srcptr)) { mpq_init(v), f(v, a.v, b.v); }
  mpq_t v;
};

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
  mpq low = mpq(0.0), high = mpq(1.0);
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

}  // namespace line_cases
