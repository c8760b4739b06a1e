// SPDX-License-Identifier: MIT
// Points of B-splines, lengths of curves, places at lengths, and places of curves nearest to points: run time against
// error. Curves of all shapes, of sharp turns, and far from the origin.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <irg/curve/arc_length.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/curve/bezier_queries.hpp>
#include <irg/curve/bspline.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/math/length.hpp>
#include <irg/math/vec.hpp>

#include "accuracy/vector_sets.hpp"

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using point2 = irg::point<double, 2>;
using point3 = irg::point<double, 3>;
using cubic = std::array<point2, 4>;
std::size_t count(std::size_t n) { return bench::smoke() ? 8 : n; }

// ---- points of a B-spline of 12 control points

struct spline {
  int degree;
  std::vector<double> knots;
  std::vector<point3> points;
};

spline some_spline(int degree, double away) {
  bench::random_numbers r(41);
  spline s{degree, {}, {}};
  const std::size_t p = static_cast<std::size_t>(degree);
  s.knots.assign(p + 1, 0);
  for (std::size_t i = 0; i + p + 1 < 12; ++i) s.knots.push_back(s.knots.back() + r.between(0.1, 1));
  s.knots.insert(s.knots.end(), p + 1, s.knots.back() + r.between(0.1, 1));
  for (int i = 0; i < 12; ++i) {
    const double x = r.between(-1, 1), y = r.between(-1, 1), z = r.between(-1, 1);
    s.points.push_back({away + x, away + y, away + z});
  }
  return s;
}

// Cox's and de Boor's recursion for basis function i.
real basis(const spline& s, std::size_t i, std::size_t degree, double t) {
  const auto u = [&](std::size_t k) { return real(s.knots[k]); };
  if (degree == 0) return real(s.knots[i] <= t && t < s.knots[i + 1] ? 1 : 0);
  const auto part = [&](std::size_t k, std::size_t from, std::size_t to, bool rises) {
    if (!(s.knots[from] < s.knots[to])) return real(0);
    return (rises ? real(t) - u(from) : u(to) - real(t)) / (u(to) - u(from)) * basis(s, k, degree - 1, t);
  };
  return part(i, i, i + degree, true) + part(i + 1, i + 1, i + degree + 1, false);
}

void spline_points() {
  bench::study study("point of a B-spline", "point of a curve", bench::error_unit::relative_u);
  for (const auto& [name, degree, away] :
       {std::tuple{"degree 3", 3, 0.0}, {"degree 5", 5, 0.0}, {"10^6 away", 3, 1e6}}) {
    const spline& s = bench::keep(some_spline(degree, away));
    bench::random_numbers r(42);
    auto& places = bench::keep(std::vector<irg::vec<double, 2>>());
    while (places.size() < count(512)) places.push_back({r.between(0, s.knots.back()), 0});
    const auto exact = [&s](const irg::vec<double, 2>& t, bench::exact_results& out) {
      std::array<real, 3> sum;
      for (std::size_t i = 0; i < s.points.size(); ++i) {
        const real weight = basis(s, i, static_cast<std::size_t>(s.degree), t.x);
        for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] + weight * real(s.points[i][static_cast<int>(k)]);
      }
      for (const real& x : sum) out.push_back(x.result());
    };
    const auto knots = *irg::make_bspline_knots(std::span<const double>(s.knots), degree);
    const bench::distribution d{name, places.size(), 3, bench::exact_for(places, exact)};
    study.panel(d,
                {bench::for_each_vector<3>("irg", places,
                                           [&s, knots](const auto& t) {
                                             std::array<double, 8> room;
                                             return *irg::bspline_point(knots, s.points, t.x, std::span<double>(room));
                                           }),
                 bench::for_each_vector<3>("irg: bspline_point_de_boor", places,
                                           [&s, knots](const auto& t) {
                                             std::array<point3, 8> room;
                                             return *irg::bspline_point_de_boor(knots, s.points, t.x,
                                                                                std::span<point3>(room));
                                           })},
                bench::text_of_items(places));
  }
}

// ---- lengths of cubics

// Any cubics; or such that turn back on themselves within 2^-bits or so of their size.
std::vector<cubic> cubics(std::size_t n, int bits) {
  bench::random_numbers r(43);
  std::vector<cubic> all(count(n));
  for (cubic& c : all) {
    for (point2& p : c) {
      const double x = r.between(-1, 1), y = r.between(-1, 1);
      p = {x, y};
    }
    if (bits > 0) {
      const double bend = std::ldexp(r.between(0.5, 1), -bits);
      c = {point2{-1, 0}, {r.between(1.5, 3), bend}, {r.between(-3, -1.5), bend}, {1, 0}};
    }
  }
  return all;
}

template <class T>
T speed_of(const cubic& c, T t) {
  const T s = 1 - t;
  T side[3][2];
  for (std::size_t k = 0; k < 3; ++k) {
    side[k][0] = 3 * (static_cast<T>(c[k + 1].x) - static_cast<T>(c[k].x));
    side[k][1] = 3 * (static_cast<T>(c[k + 1].y) - static_cast<T>(c[k].y));
  }
  const T x = s * s * side[0][0] + 2 * s * t * side[1][0] + t * t * side[2][0];
  const T y = s * s * side[0][1] + 2 * s * t * side[1][1] + t * t * side[2][1];
  return std::sqrt(x * x + y * y);
}

// In 64 bits: Gauss's and Legendre's rule of five places, halved until two halves agree.
long double gauss5(const cubic& c, long double a, long double b) {
  constexpr long double place[] = {0.538469310105683091036314420700209L, 0.906179845938663992797626878299393L};
  constexpr long double weight[] = {0.478628670499366468041291514835638L, 0.236926885056189087514264040719917L};
  const long double m = (a + b) / 2, h = (b - a) / 2;
  long double sum = 0.568888888888888888888888888888889L * speed_of(c, m);
  for (int i = 0; i < 2; ++i) sum += weight[i] * (speed_of(c, m - h * place[i]) + speed_of(c, m + h * place[i]));
  return h * sum;
}
long double true_length(const cubic& c, long double a, long double b, int depth = 0) {
  const long double m = (a + b) / 2, whole = gauss5(c, a, b), halves = gauss5(c, a, m) + gauss5(c, m, b);
  if (depth == 20 || (depth > 2 && std::fabs(halves - whole) <= 2e-18L * halves)) return halves;
  return true_length(c, a, m, depth + 1) + true_length(c, m, b, depth + 1);
}
bench::exact_result split(long double x) {
  const auto value = static_cast<double>(x);
  return {value, static_cast<double>(x - value)};
}

auto speed(const cubic& c) {
  return [&c](double t) { return irg::length(irg::bezier_sample(c, t).derivative); };
}

void lengths() {
  bench::study s("length of a curve", "cubic", bench::error_unit::relative_u);
  for (const auto& [name, bits] : {std::tuple{"any cubic", 0}, {"turns of 2^-4", 4}, {"turns of 2^-10", 10}}) {
    const auto& items = bench::keep(cubics(128, bits));
    const auto exact = [](const cubic& c, bench::exact_results& out) { out.push_back(split(true_length(c, 0, 1))); };
    const bench::distribution d{name, items.size(), 1, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_item("irg", items, [](const cubic& c) { return irg::arc_length(speed(c), 0., 1, 0); }),
             bench::for_each_item("irg: tolerance 10^-6", items,
                                  [](const cubic& c) { return irg::arc_length(speed(c), 0., 1, 1e-6); }),
             bench::for_each_item("100 chords", items,
                                  [](const cubic& c) {
                                    double sum = 0;
                                    point2 last = c[0];
                                    for (int k = 1; k <= 100; ++k) {
                                      const point2 next = irg::bezier_point(c, k / 100.);
                                      sum += irg::length(next - last);
                                      last = next;
                                    }
                                    return sum;
                                  })},
            bench::text_of_items(items));
  }
}

// The length up to the place at half of it, which is what is wanted: errors of places would be those of lengths over
// the speed.
void places_at_lengths() {
  bench::study s("place at half the length", "cubic with its table", bench::error_unit::relative_u);
  for (const auto& [name, bits] : {std::tuple{"any cubic", 0}, {"turns of 2^-4", 4}, {"turns of 2^-10", 10}}) {
    const auto& items = bench::keep(cubics(128, bits));
    const auto exact = [](const cubic& c, bench::exact_results& out) {
      const long double half = true_length(c, 0, 1) / 2;
      long double low = 0, high = 1, run = 0;
      while (high - low > 1e-18L) {
        const long double middle = (low + high) / 2, there = run + true_length(c, low, middle);
        if (there < half)
          low = middle, run = there;
        else
          high = middle;
      }
      out.push_back(split(low));
    };
    const bench::distribution d{name, items.size(), 1, bench::exact_for(items, exact)};
    const auto by_table = [&]<std::size_t N>(const char* who, std::array<double, N>) {
      return bench::for_each_item(who, items, [](const cubic& c) {
        std::array<double, N> room;
        const auto table = irg::arc_lengths<double>(speed(c), 0, 1, std::span<double>(room));
        return irg::parameter_at_length(speed(c), table, table.length() / 2);
      });
    };
    s.panel(d,
            {by_table("irg", std::array<double, 17>()), by_table("irg: table of 5", std::array<double, 5>()),
             bench::for_each_item("between 100 chords", items,
                                  [](const cubic& c) {
                                    std::array<double, 101> run{};
                                    for (int k = 1; k <= 100; ++k)
                                      run[static_cast<std::size_t>(k)] =
                                          run[static_cast<std::size_t>(k - 1)] +
                                          irg::length(irg::bezier_point(c, k / 100.) -
                                                      irg::bezier_point(c, (k - 1) / 100.));
                                    const double half = run[100] / 2;
                                    const auto at = std::upper_bound(run.begin(), run.end(), half) - run.begin();
                                    const auto k = static_cast<std::size_t>(at);
                                    return (static_cast<double>(k) - (run[k] - half) / (run[k] - run[k - 1])) / 100;
                                  })},
            bench::text_of_items(items));
  }
}

// ---- the place of a cubic nearest to a point: its distance

struct cubic_and_point {
  cubic c;
  point2 p;
};

long double squared_distance(const cubic_and_point& i, long double t) {
  long double x[4], y[4];
  for (std::size_t k = 0; k < 4; ++k) {
    x[k] = static_cast<long double>(i.c[k].x) - static_cast<long double>(i.p.x);
    y[k] = static_cast<long double>(i.c[k].y) - static_cast<long double>(i.p.y);
  }
  for (std::size_t n = 3; n > 0; --n)
    for (std::size_t k = 0; k < n; ++k) x[k] += (x[k + 1] - x[k]) * t, y[k] += (y[k + 1] - y[k]) * t;
  return x[0] * x[0] + y[0] * y[0];
}

// The least of 2000 places, and from there by thirds in 64 bits: near a least value half the digits of t do.
void true_distance(const cubic_and_point& i, bench::exact_results& out) {
  constexpr int steps = 2000;
  int best = 0;
  for (int k = 1; k <= steps; ++k)
    if (squared_distance(i, k / static_cast<long double>(steps)) <
        squared_distance(i, best / static_cast<long double>(steps)))
      best = k;
  long double low = std::max(best - 1, 0) / static_cast<long double>(steps);
  long double high = std::min(best + 1, steps) / static_cast<long double>(steps);
  for (int k = 0; k < 100; ++k) {
    const long double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (squared_distance(i, a) < squared_distance(i, b))
      high = b;
    else
      low = a;
  }
  out.push_back(split(std::sqrt(squared_distance(i, (low + high) / 2))));
}

void nearest_places() {
  bench::study s("nearest place of a curve", "cubic and point", bench::error_unit::ulp);
  for (const auto& [name, away] : {std::tuple{"beside it", 0.0}, {"2^20 away", 0x1p20}, {"2^40 away", 0x1p40}}) {
    bench::random_numbers r(44);
    auto& items = bench::keep(std::vector<cubic_and_point>());
    while (items.size() < count(256)) {  // coordinates that bear to be moved
      const auto any = [&r, away = away] { return away + r.integer(-256, 256) / 256.; };
      cubic_and_point i{};
      for (point2& p : i.c) p.x = any(), p.y = any();
      i.p.x = any(), i.p.y = any();
      if (squared_distance(i, 0) > 0 && squared_distance(i, 1) > 0) items.push_back(i);
    }
    const bench::distribution d{name, items.size(), 1, bench::exact_for(items, true_distance)};
    s.panel(d,
            {bench::for_each_item("irg", items,
                                  [](const cubic_and_point& i) {
                                    std::array<irg::vec<double, 1>, 32> scratch;
                                    std::array<point2, 4> work;
                                    return irg::bezier_nearest(i.c, i.p, std::span<irg::vec<double, 1>>(scratch),
                                                               std::span<point2>(work))
                                        .distance;
                                  }),
             bench::for_each_item("the nearest of 1000 points", items,
                                  [](const cubic_and_point& i) {
                                    double least = irg::length(i.c[0] - i.p);
                                    for (int k = 1; k <= 1000; ++k)
                                      least = std::min(least, irg::length(irg::bezier_point(i.c, k / 1000.) - i.p));
                                    return least;
                                  })},
            bench::text_of_items(items));
  }
}

}  // namespace

int main(int argc, char** argv) {
  spline_points();
  lengths();
  places_at_lengths();
  nearest_places();
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_curves: skipped, MPFR was not found"); }
#endif
