// SPDX-License-Identifier: MIT
// orient2d, one by one and in batches, orient3d, in_circle and in_sphere: time per call and wrong signs, on easy points
// and on degenerate ones.
#include <functional>

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
// A contest of deciding the signs of the calls of one set.
template <class T, int N, int D>
class deciders {
public:
  deciders(const std::string& kernel, const point_set<T, N, D>& s)
      : what_{kernel, s.name, "call", static_cast<std::int64_t>(s.calls.size()), "", "limit:read the coordinates"},
        signs_(keep(std::vector<std::int8_t>(s.calls.size()))), truth_(keep_lazy([&s] {
          std::vector<std::int8_t> all;
#ifdef IRG_HAVE_MPFR
          for (const auto& call : s.calls) all.push_back(static_cast<std::int8_t>(true_sign<T, N, D>(call)));
#endif
          return all;
        })) {
  }

  std::vector<std::int8_t>& signs() const { return signs_; }

  /// Who writes signs(). Of exact ones none may be wrong; nobody judges a limit.
  void enter(const std::string& name, std::function<void()> run, bool exact = true) const {
    contender who{name, std::move(run)};
    who.same_work = exact;
    if (!name.starts_with("limit:"))
      who.judge = [&signs = signs_, &truth = truth_, exact] {
        errors e;
        if (truth->empty()) return e;
        e.wrong = 0;
        for (std::size_t i = 0; i < signs.size(); ++i) e.wrong += signs[i] != (*truth)[i];
        if (exact && e.wrong != 0) e.broken = "a sign is wrong";
        return e;
      };
    bench::enter(what_, std::move(who));
  }

  /// One by one: sign(call).
  template <class Call, class F>
  void enter_each(const std::string& name, std::vector<Call> calls, F sign, bool exact = true) const {
    const auto run = [calls = std::move(calls), sign, &signs = signs_] {
      for (std::size_t i = 0; i < calls.size(); ++i) signs[i] = static_cast<std::int8_t>(sign(calls[i]));
      asm volatile("" : : "r"(signs.data()) : "memory");
    };
    enter(name, run, exact);
  }

private:
  contest what_;
  std::vector<std::int8_t>& signs_;
  lazy<std::vector<std::int8_t>>& truth_;
};

// In the coordinates' own arithmetic.
template <int N, class T, int D>
int naive_sign(const arguments<T, N, D>& p) {
  const T value = textbook_determinant<T, T, N, D>(p);
  return (value > 0) - (value < 0);
}

template <class T, int N, int D>
void enter_set(const std::string& kernel, const point_set<T, N, D>& made) {
  const auto& s = keep(point_set<T, N, D>(made));
  const deciders<T, N, D> all(kernel, s);
  all.enter_each("irg", own_points(s), [](const auto& p) { return irg_sign<N, D>(p); });
  if constexpr (std::is_same_v<T, double>) {
#ifdef IRG_HAVE_CGAL
    all.enter_each("CGAL EPICK", cgal::points_of(s), [](const auto& p) { return cgal::sign<N, D>(p); });
#endif
    all.enter_each("naive double", s.calls, [](const auto& p) { return naive_sign<N, T, D>(p); }, false);
  }
  all.enter_each("limit:read the coordinates", s.calls, [](const auto& p) {
    std::uint64_t sum = 0;
    for (const auto& point : p)
      for (const T c : point) sum += std::bit_cast<std::uint64_t>(c);
    return static_cast<int>(sum & 1);
  });
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

void enter_batch(point_set<double, 3, 2> made, bool one_line) {
  if (one_line)
    for (auto& call : made.calls) call[0] = made.calls[0][0], call[1] = made.calls[0][1];
  made.name += one_line ? " (one line)" : " (a line for each)";
  const auto& s = keep(std::move(made));
  const auto& columns = keep(in_columns(s));
  const deciders<double, 3, 2> all("orient2d_batch", s);
  auto& signs = all.signs();
  const irg::point<double, 2> a = as_point<double, 2>(s.calls[0][0]), b = as_point<double, 2>(s.calls[0][1]);
  all.enter("irg", [&columns, &signs, a, b, one_line] {
    if (one_line)
      irg::orient2d_all(a, b, columns.of(2), signs);
    else
      irg::orient2d_all(columns.of(0), columns.of(1), columns.of(2), signs);
    asm volatile("" : : "r"(signs.data()) : "memory");
  });
  const auto one_by_one = [&columns, &signs, one_line](const auto& sign) {
    return [&columns, &signs, one_line, sign] {
      for (std::size_t i = 0; i < signs.size(); ++i) {
        const auto at = [&](std::size_t k, std::size_t j) { return columns.c[k][j][one_line && k < 2 ? 0 : i]; };
        signs[i] = static_cast<std::int8_t>(sign(at(0, 0), at(0, 1), at(1, 0), at(1, 1), at(2, 0), at(2, 1)));
      }
      asm volatile("" : : "r"(signs.data()) : "memory");
    };
  };
  all.enter("irg:one by one", one_by_one([](double ax, double ay, double bx, double by, double cx, double cy) {
              using point = irg::point<double, 2>;
              return irg::orient2d(point{ax, ay}, point{bx, by}, point{cx, cy});
            }));
#ifdef IRG_HAVE_CGAL
  all.enter("CGAL EPICK", one_by_one([](double ax, double ay, double bx, double by, double cx, double cy) {
              using point = cgal::epick::Point_2;
              return cgal::sign<3, 2>(std::array<point, 3>{point(ax, ay), point(bx, by), point(cx, cy)});
            }));
#endif
  all.enter("naive double", one_by_one([](double ax, double ay, double bx, double by, double cx, double cy) {
              const double area = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
              return (area > 0) - (area < 0);
            }),
            false);
  all.enter("limit:read the coordinates",
            one_by_one([](double ax, double ay, double bx, double by, double cx, double cy) {
              return ((ax < bx) ^ (ay < by)) ^ ((cx < ax) ^ (cy < by));
            }));
}

template <int N, int D>
void enter_common(const std::string& kernel) {
  for (const auto& s : common_sets<N, D>()) enter_set(kernel, s);
  enter_set(kernel, set_of<std::int64_t, N, D>("int64", any_int64));
  enter_set(kernel, set_of<std::int64_t, N, D>("int64 lattice",
                                               [](random_numbers& r) { return std::int64_t{r.integer(0, 255)}; }));
}

}  // namespace

int main(int argc, char** argv) {
  enter_set("orient2d", ulp_grid<3, 2>("classroom 12 24", {{{0.5, 0.5}, {12, 12}, {24, 24}}}, 0, 256));
  enter_set("orient2d", ulp_grid<3, 2>("classroom 8.8 12.1",
                                       {{{0.5, 0.5}, {8.8000000000000007, 8.8000000000000007}, {12.1, 12.1}}}, 0, 256));
  enter_set("orient2d", ulp_grid<3, 2>("classroom 17.3 24",
                                       {{{0.50000000000002531, 0.5000000000000171},
                                         {17.300000000000001, 17.300000000000001},
                                         {24.00000000000005, 24.0000000000000517765}}},
                                       0, 256));
  enter_common<3, 2>("orient2d");
  for (const bool one_line : {true, false})
    for (const auto& s : common_sets<3, 2>()) enter_batch(s, one_line);
  enter_set("orient3d",
            ulp_grid<4, 3>("ulp grid", {{{0.5, 0.5, 0.5}, {12, 12, 12}, {24, 24, 24}, {12, 24, 18}}}, 0, 40));
  enter_common<4, 3>("orient3d");
  enter_set("in_circle", ulp_grid<4, 2>("ulp grid", {{{24, 0.5}, {24, 12}, {0.5, 12}, {0.5, 0.5}}}, 3, 256));
  enter_common<4, 2>("in_circle");
  enter_common<5, 3>("in_sphere");
  return run_benchmarks(argc, argv);
}
