// SPDX-License-Identifier: MIT
// Inverses of 4x4 matrices and systems of four equations: time against error, over condition numbers. A result that is
// refused, NaN or has no correct digit counts as wrong where the truth is a number.
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <irg/math/inverse.hpp>
#include <irg/math/inverse_exact.hpp>
#include <irg/math/solve_exact.hpp>

#ifdef IRG_HAVE_EIGEN
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12's own header for AVX-512, which Eigen calls
#endif
#include <Eigen/Dense>
#endif
#ifdef IRG_HAVE_GLM
#include <glm/glm.hpp>
#endif

#include "../tests/support/random.hpp"
#include "support/measure.hpp"

namespace bench {
namespace {

using mat4 = irg::mat<double, 4, 4>;
using vec4 = irg::vec<double, 4>;

mat4 turned(test::random& r) {
  mat4 a = irg::identity<double, 4>();
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double angle = 6.28 * r.unit(), c = std::cos(angle), s = std::sin(angle);
      mat4 turn = irg::identity<double, 4>();
      turn(i, i) = turn(j, j) = c;
      turn(i, j) = -s;
      turn(j, i) = s;
      a = a * turn;
    }
  return a;
}

/// U S V with one small, one large or stepped singular values.
mat4 of_condition(test::random& r, double k, int way) {
  mat4 s{};
  for (int i = 0; i < 4; ++i) s(i, i) = way == 0 ? std::pow(k, -i / 3.0) : (way == 1 ? i < 3 : i < 1) ? 1 : 1 / k;
  const mat4 first = turned(r);
  return first * s * turned(r);
}

/// A rigid motion followed by a perspective projection.
mat4 camera(test::random& r) {
  const mat4 whole = turned(r);
  mat4 motion = irg::identity<double, 4>(), projection{};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) motion(y, x) = x < 3 ? whole(y, x) : 20 * r.unit() - 10;
  projection(0, 0) = 1.5, projection(1, 1) = 2, projection(2, 2) = -1.0002, projection(2, 3) = -0.20002;
  projection(3, 2) = -1;
  return projection * motion;
}

using numbers = std::vector<double>;

struct entrant {
  std::string name;
  std::function<numbers(const mat4&)> results;         // of one matrix; empty when refused
  std::function<double(const std::vector<mat4>&)> run;  // all of them
};

template <class F, class Get>
entrant enter(const char* name, F invert, Get get) {
  return {name, [=](const mat4& a) { return get(invert(a)); },
          [=](const std::vector<mat4>& all) {
            for (const mat4& a : all) {
              auto x = invert(a);
              asm volatile("" : : "r"(&x) : "memory");
            }
            return 0.0;
          }};
}

numbers of_mat(const std::optional<mat4>& x) {
  numbers n;
  for (int i = 0; x && i < 16; ++i) n.push_back((*x)(i / 4, i % 4));
  return n;
}
numbers of_vec(const std::optional<vec4>& x) { return x ? numbers{x->x, x->y, x->z, x->w} : numbers{}; }

constexpr vec4 right{0.3, -0.7, 0.2, 0.9};

std::vector<entrant> inverters() {
  std::vector<entrant> all;
  all.push_back(enter("irg:fast", [](const mat4& a) { return irg::inverse_fast(a); }, of_mat));
  all.push_back(enter("irg", [](const mat4& a) { return irg::inverse(a); }, of_mat));
  all.push_back(enter("irg:accurate", [](const mat4& a) { return irg::inverse_accurate(a); }, of_mat));
  all.push_back(enter("irg:exact", [](const mat4& a) { return irg::inverse_exact(a); }, of_mat));
#ifdef IRG_HAVE_GLM
  const auto of_glm = [](const glm::dmat4& x) {
    numbers n;
    for (int i = 0; i < 16; ++i) n.push_back(x[i % 4][i / 4]);
    return n;
  };
  const auto to_glm = [](const mat4& a) {
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i) m[i % 4][i / 4] = a(i / 4, i % 4);
    return m;
  };
  all.push_back(enter("GLM", [=](const mat4& a) { return glm::inverse(to_glm(a)); }, of_glm));
#endif
#ifdef IRG_HAVE_EIGEN
  using M = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  const auto of_eigen = [](const M& x) { return numbers(x.data(), x.data() + 16); };
  const auto to_eigen = [](const mat4& a) { return Eigen::Map<const M>(&a.m[0][0]); };
  all.push_back(enter("Eigen inverse", [=](const mat4& a) { return M(to_eigen(a).inverse()); }, of_eigen));
  all.push_back(
      enter("Eigen PartialPivLU", [=](const mat4& a) { return M(to_eigen(a).partialPivLu().inverse()); }, of_eigen));
  all.push_back(
      enter("Eigen FullPivLU", [=](const mat4& a) { return M(to_eigen(a).fullPivLu().inverse()); }, of_eigen));
#endif
  return all;
}

std::vector<entrant> solvers() {
  std::vector<entrant> all;
  const auto of_solution = [](const irg::system_solution<double, 4>& s) { return s ? of_vec(s.x) : numbers{}; };
  const auto lu = [](const mat4& a) {
    const auto f = irg::lu_factor(a);
    return f ? std::optional(irg::lu_solve(*f, right)) : std::nullopt;
  };
  all.push_back(enter("irg:lu_solve", lu, of_vec));
  all.push_back(enter("irg:solve_gauss", [](const mat4& a) { return irg::solve_gauss(a, right); }, of_solution));
  all.push_back(enter("irg:lu_solve_refined", [](const mat4& a) { return irg::lu_solve_refined(a, right); }, of_vec));
  all.push_back(enter("irg:solve_exact", [](const mat4& a) { return irg::solve_exact(a, right); }, of_solution));
#ifdef IRG_HAVE_EIGEN
  using M = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  using V = Eigen::Vector4d;
  const auto of_eigen = [](const V& x) { return numbers(x.data(), x.data() + 4); };
  const auto to_eigen = [](const mat4& a) { return Eigen::Map<const M>(&a.m[0][0]); };
  const V b(right.x, right.y, right.z, right.w);
  all.push_back(
      enter("Eigen PartialPivLU", [=](const mat4& a) { return V(to_eigen(a).partialPivLu().solve(b)); }, of_eigen));
  all.push_back(enter("Eigen FullPivLU", [=](const mat4& a) { return V(to_eigen(a).fullPivLu().solve(b)); }, of_eigen));
#endif
  return all;
}

/// Races everybody over the matrices; the last irg variant, correctly rounded, is the truth.
void hold(const char* kernel, const std::string& test_case, std::vector<entrant> all, std::size_t truth_at,
          const std::vector<mat4>& matrices) {
  std::vector<contender> racers;
  for (const entrant& e : all) racers.push_back({e.name, [&] { e.run(matrices); }});
  race(racers, 21, 2e-4, warming::one_run);
  std::printf("\n%s, %s\n  %-22s %9s %12s %12s %7s\n", kernel, test_case.c_str(), "", "ns", "max error", "mean error",
              "wrong");
  for (std::size_t i = 0; i < all.size(); ++i) {
    double worst = 0, sum = 0;
    int wrong = 0, count = 0;
    for (const mat4& a : matrices) {
      const numbers truth = all[truth_at].results(a), got = all[i].results(a);
      double largest = 0, error = 0;
      for (const double t : truth) largest = std::fmax(largest, std::fabs(t));
      for (std::size_t k = 0; k < truth.size() && k < got.size(); ++k)
        error = got[k] == got[k] ? std::fmax(error, std::fabs(got[k] - truth[k])) : HUGE_VAL;
      if (truth.empty() || got.empty() || !(error < largest)) {
        wrong += truth.empty() ? 0 : 1;
        continue;
      }
      worst = std::fmax(worst, error / largest * 0x1p53);
      sum += error / largest * 0x1p53;
      ++count;
    }
    const double ns = racers[i].median() * 1e9 / static_cast<double>(matrices.size());
    std::printf("  %-22s %9.1f %12.4g %12.4g %7d\n", all[i].name.c_str(), ns, worst, sum / std::fmax(count, 1), wrong);
    report({.kernel = kernel,
            .test_case = test_case,
            .implementation = all[i].name,
            .ns_per_item = ns,
            .items = static_cast<std::int64_t>(matrices.size()),
            .item = "operation",
            .max_error = number(worst),
            .mean_error = number(sum / std::fmax(count, 1)),
            .error_unit = "u x largest entry",
            .wrong = std::to_string(wrong)});
  }
}

}  // namespace
}  // namespace bench

int main() {
  using namespace bench;
  stay_on_this_processor();
  const auto hold_both = [](const std::string& test_case, const std::vector<mat4>& matrices) {
    hold("inverse 4x4", test_case, inverters(), 3, matrices);
    hold("solve 4x4", test_case, solvers(), 3, matrices);
  };
  const std::size_t count = smoke() ? 6 : 258;
  for (const int power : {0, 2, 4, 6, 8, 10, 12, 14, 16}) {
    test::random r(static_cast<std::uint64_t>(power) + 1);
    std::vector<mat4> matrices;
    for (std::size_t i = 0; i < count; ++i)
      matrices.push_back(of_condition(r, std::pow(10.0, power), static_cast<int>(i % 3)));
    hold_both("condition 1e" + std::to_string(power), matrices);
  }
  test::random r(99);
  std::vector<mat4> cameras, shuffles;
  for (std::size_t i = 0; i < count; ++i) {
    cameras.push_back(camera(r));
    int order[] = {0, 1, 2, 3};
    for (int k = 3; k > 0; --k) std::swap(order[k], order[r.integer(0, k)]);
    mat4 p{};
    for (int k = 0; k < 4; ++k) p(k, order[k]) = 1;
    shuffles.push_back(p);
  }
  hold_both("cameras", cameras);
  hold_both("permutations", shuffles);
}
