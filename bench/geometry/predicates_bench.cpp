// SPDX-License-Identifier: MIT
// orient2d, one by one and in batches, orient3d, in_circle and in_sphere: time per call and wrong signs, on easy points and on degenerate ones.
#include <numeric>

#include <irg/geometry/in_circle.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient2d_batch.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/math/vec.hpp>

#include "geometry/decisions.hpp"
#include "geometry/gmp_signs.hpp"
#include "geometry/peer_cgal.hpp"
#include "geometry/predicate_sets.hpp"
#include "support/measure.hpp"

namespace {

using namespace bench;
int broken = 0;

// One implementation; it is timed with its signs written one by one.
struct judged {
  contender racer;
  std::string note;
  bool exact = true, judge = true, same_work = true;
};

template <class Call, class F>
judged deciding(const std::string& name, std::vector<Call> calls, F sign, std::vector<std::int8_t>& signs) {
  return {{name,
           [calls = std::move(calls), sign, &signs] {
             for (std::size_t i = 0; i < calls.size(); ++i) signs[i] = static_cast<std::int8_t>(sign(calls[i]));
             asm volatile("" : : "r"(signs.data()) : "memory");
           }},
          ""};
}

// In the coordinates' own arithmetic.
template <int N, class T, int D>
int naive_sign(const arguments<T, N, D>& p) {
  const T value = textbook_determinant<T, T, N, D>(p);
  return (value > 0) - (value < 0);
}

void print_and_report(const std::string& kernel, const std::string& name, const std::vector<judged>& all,
                      const std::vector<std::int64_t>& wrong, std::int64_t calls, std::int64_t zeros) {
  const auto ns = [&](const judged& c) { return c.racer.median() * 1e9 / static_cast<double>(calls); };
  std::printf("%s / %s: %lld calls, %lld of them 0\n", kernel.c_str(), name.c_str(), static_cast<long long>(calls),
              static_cast<long long>(zeros));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string count = wrong[i] < 0 ? "" : std::to_string(wrong[i]);
    const double limit = ns(all.back()) / ns(all[i]);
    std::printf("  %-34s %9.2f ns   %s%s\n", all[i].racer.name.c_str(), ns(all[i]), count.c_str(),
                count.empty() ? "" : " wrong");
    report({kernel, name, all[i].racer.name, all[i].same_work ? "yes" : "no", ns(all[i]), calls, "call", number(limit),
            "", "", "", count, all[i].note});
    if (all[i].exact && wrong[i] > 0) ++broken;
  }
}

// Judges all, races them and reports.
template <class T, int N, int D>
void hold(const std::string& kernel, const point_set<T, N, D>& s, std::vector<judged>& all,
          const std::vector<std::int8_t>& signs) {
  std::vector<std::int8_t> truth;
#ifdef IRG_HAVE_MPFR
  for (const auto& call : s.calls) truth.push_back(static_cast<std::int8_t>(true_sign<T, N, D>(call)));
#endif
  std::vector<std::int64_t> wrong;
  std::vector<contender> racers;
  for (const judged& c : all) {
    c.racer.run();
    wrong.push_back(c.judge && !truth.empty() ? 0 : -1);
    for (std::size_t i = 0; i < truth.size() && c.judge; ++i) wrong.back() += signs[i] != truth[i];
    racers.push_back(c.racer);
  }
  race(racers, 9, 3e-3, warming::one_run);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].racer = racers[i];
  print_and_report(kernel, s.name, all, wrong, static_cast<std::int64_t>(s.calls.size()),
                   std::count(truth.begin(), truth.end(), std::int8_t{0}));
}

template <class T, int N, int D>
void hold(const std::string& kernel, const point_set<T, N, D>& s) {
  std::vector<std::int8_t> signs(s.calls.size());
  std::vector<judged> all;
  const auto points = own_points(s);
  all.push_back(deciding("irg", points, [](const auto& p) { return irg_sign<N, D>(p); }, signs));
  if constexpr (std::is_same_v<T, double>) {
#ifdef IRG_HAVE_CGAL
    all.push_back(deciding("CGAL EPICK", cgal::points_of(s), [](const auto& p) { return cgal::sign<N, D>(p); }, signs));
#endif
    all.push_back(deciding("naive double", s.calls, [](const auto& p) { return naive_sign<N, T, D>(p); }, signs));
    all.back().exact = all.back().same_work = false;
  }
  all.push_back(deciding(
      "limit:read the coordinates", s.calls,
      [](const auto& p) {
        std::uint64_t sum = 0;
        for (const auto& point : p)
          for (const T c : point) sum += std::bit_cast<std::uint64_t>(c);
        return static_cast<int>(sum & 1);
      },
      signs));
  all.back().exact = all.back().judge = false;

  hold(kernel, s, all, signs);
}

// Triples in columns, and all third points against the first line.
struct in_columns {
  explicit in_columns(const point_set<double, 3, 2>& s) {
    for (const auto& call : s.calls)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 2; ++j) c[k][j].push_back(call[k][j]);
  }
  irg::point_columns of(std::size_t k) const { return {c[k][0], c[k][1]}; }
  std::vector<double> c[3][2];
};

void hold_batch(point_set<double, 3, 2> s, bool one_line) {
  if (one_line)
    for (auto& call : s.calls) call[0] = s.calls[0][0], call[1] = s.calls[0][1];
  const in_columns columns(s);
  std::vector<std::int8_t> signs(s.calls.size());
  const std::size_t n = signs.size();
  const auto fence = [&] { asm volatile("" : : "r"(signs.data()) : "memory"); };
  const irg::point<double, 2> a = as_point<double, 2>(s.calls[0][0]), b = as_point<double, 2>(s.calls[0][1]);
  std::vector<judged> all;
  all.push_back({{"irg",
                  [&] {
                    if (one_line)
                      irg::orient2d_batch(a, b, columns.of(2), signs);
                    else
                      irg::orient2d_batch(columns.of(0), columns.of(1), columns.of(2), signs);
                    fence();
                  }},
                 ""});
  const auto one_by_one = [&](const auto& sign) {
    return [&, sign] {
      for (std::size_t i = 0; i < n; ++i) {
        const auto at = [&](std::size_t k, std::size_t j) { return columns.c[k][j][one_line && k < 2 ? 0 : i]; };
        signs[i] = static_cast<std::int8_t>(sign(at(0, 0), at(0, 1), at(1, 0), at(1, 1), at(2, 0), at(2, 1)));
      }
      fence();
    };
  };
  all.push_back({{"irg:one by one", one_by_one([](double ax, double ay, double bx, double by, double cx, double cy) {
                    using point = irg::point<double, 2>;
                    return irg::orient2d(point{ax, ay}, point{bx, by}, point{cx, cy});
                  })},
                 ""});
#ifdef IRG_HAVE_CGAL
  all.push_back({{"CGAL EPICK", one_by_one([](double ax, double ay, double bx, double by, double cx, double cy) {
                    using point = cgal::epick::Point_2;
                    return cgal::sign<3, 2>(std::array<point, 3>{point(ax, ay), point(bx, by), point(cx, cy)});
                  })},
                 ""});
#endif
  all.push_back({{"naive double", one_by_one([](double ax, double ay, double bx, double by, double cx, double cy) {
                    const double area = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
                    return (area > 0) - (area < 0);
                  })},
                 ""});
  all.back().exact = all.back().same_work = false;
  all.push_back(
      {{"limit:read the coordinates", one_by_one([](double ax, double ay, double bx, double by, double cx, double cy) {
          return ((ax < bx) ^ (ay < by)) ^ ((cx < ax) ^ (cy < by));
        })},
       ""});
  all.back().exact = all.back().judge = false;
  s.name += one_line ? " (one line)" : " (a line for each)";
  hold("orient2d_batch", s, all, signs);
}

template <int N, int D>
void hold_common(const std::string& kernel) {
  for (const auto& s : common_sets<N, D>()) hold(kernel, s);
  hold(kernel, set_of<std::int64_t, N, D>("int64", any_int64));
  hold(kernel,
       set_of<std::int64_t, N, D>("int64 lattice", [](random_numbers& r) { return std::int64_t{r.integer(0, 255)}; }));
}

}  // namespace

int main() {
  stay_on_this_processor();
  hold("orient2d", ulp_grid<3, 2>("classroom 12 24", {{{0.5, 0.5}, {12, 12}, {24, 24}}}, 0, 256));
  hold("orient2d", ulp_grid<3, 2>("classroom 8.8 12.1",
                                  {{{0.5, 0.5}, {8.8000000000000007, 8.8000000000000007}, {12.1, 12.1}}}, 0, 256));
  hold("orient2d", ulp_grid<3, 2>("classroom 17.3 24",
                                  {{{0.50000000000002531, 0.5000000000000171},
                                    {17.300000000000001, 17.300000000000001},
                                    {24.00000000000005, 24.0000000000000517765}}},
                                  0, 256));
  hold_common<3, 2>("orient2d");
  for (const bool one_line : {true, false})
    for (const auto& s : common_sets<3, 2>()) hold_batch(s, one_line);
  hold("orient3d", ulp_grid<4, 3>("ulp grid", {{{0.5, 0.5, 0.5}, {12, 12, 12}, {24, 24, 24}, {12, 24, 18}}}, 0, 40));
  hold_common<4, 3>("orient3d");
  hold("in_circle", ulp_grid<4, 2>("ulp grid", {{{24, 0.5}, {24, 12}, {0.5, 12}, {0.5, 0.5}}}, 3, 256));
  hold_common<4, 2>("in_circle");
  hold_common<5, 3>("in_sphere");
  if (broken > 0) std::printf("%d of the exact ones gave a wrong sign\n", broken);
  return broken == 0 ? 0 : 1;
}
