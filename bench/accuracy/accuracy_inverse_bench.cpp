// SPDX-License-Identifier: MIT
// Inverses of 4x4 matrices and systems of four equations of growing condition: run time against error. A result that is
// refused counts as failed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <irg/math/inverse.hpp>
#include <irg/math/exact_matrix.hpp>
#include <irg/math/solve.hpp>
#include <irg/math/solve_exact.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"

#ifdef IRG_HAVE_OPENCV_IMGPROC
#include <opencv2/core.hpp>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using mat4 = irg::mat<double, 4, 4>;
using vec4 = irg::vec<double, 4>;
constexpr vec4 right{0.3, -0.7, 0.2, 0.9};

struct set {
  std::string name;
  std::vector<mat4> matrices;
};

mat4 turned(bench::random_numbers& r) {
  mat4 a = irg::identity_matrix<double, 4>();
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double t = r.between(-1, 1), c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
      mat4 turn = irg::identity_matrix<double, 4>();
      turn(i, i) = turn(j, j) = c;
      turn(i, j) = -s;
      turn(j, i) = s;
      a = a * turn;
    }
  return a;
}

// U S V, the logarithms of the singular values between 0 and -power.
mat4 of_condition(bench::random_numbers& r, int power) {
  mat4 s{};
  for (int i = 0; i < 4; ++i)
    s(i, i) = std::pow(10.0, -power * (i == 0 ? 0.0 : i == 3 ? 1.0 : std::floor(2 * r.unit()) * r.unit()));
  const mat4 first = turned(r);
  return first * s * turned(r);
}

// A motion, then a perspective projection whose planes are at 1 and at `far` times that.
mat4 camera(bench::random_numbers& r, double away, double far) {
  const mat4 whole = turned(r);
  mat4 motion = irg::identity_matrix<double, 4>(), projection{};
  const double c = whole(0, 0), s = std::sqrt(1 - c * c);
  motion(0, 0) = motion(2, 2) = c, motion(0, 2) = s, motion(2, 0) = -s;
  for (int y = 0; y < 3; ++y) motion(y, 3) = away * r.between(-1, 1);
  projection(0, 0) = 1.5, projection(1, 1) = 2, projection(2, 2) = -(far + 1) / (far - 1);
  projection(2, 3) = -2 * far / (far - 1), projection(3, 2) = -1;
  return projection * motion;
}

std::vector<set> sets() {
  std::vector<set> all;
  const auto add = [&](const std::string& name, auto next) {
    bench::random_numbers r(8);
    set s{name, {}};
    for (int i = 0; i < (bench::smoke() ? 4 : 256); ++i) s.matrices.push_back(next(r));
    all.push_back(s);
  };
  for (const int power : {0, 4, 8, 12, 16})
    add("condition 10^" + std::to_string(power), [power](bench::random_numbers& r) { return of_condition(r, power); });
  add("Hilbert's segments", [](bench::random_numbers& r) {
    mat4 a{};
    const int first = r.integer(1, 64);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) a(i, j) = 1.0 / (first + i + j);
    return a;
  });
  add("permutations", [](bench::random_numbers& r) {
    int order[] = {0, 1, 2, 3};
    for (int k = 3; k > 0; --k) std::swap(order[k], order[r.integer(0, k)]);
    mat4 a{};
    for (int k = 0; k < 4; ++k) a(k, order[k]) = 1;
    return a;
  });
  add("whole numbers to 100", [](bench::random_numbers& r) {
    mat4 a;
    for (int i = 0; i < 16; ++i) a(i / 4, i % 4) = r.integer(-100, 100);
    return a;
  });
  add("cameras", [](bench::random_numbers& r) { return camera(r, 10, 1e3); });
  add("cameras 10^6 away that see 10^9 far", [](bench::random_numbers& r) { return camera(r, 1e6, 1e9); });
  return all;
}

// The determinant of rows and columns `rows`, `columns` on (masks of the four).
real minor_of(const mat4& a, int row, unsigned columns) {
  real sum = 0;
  int sign = 1;
  for (unsigned c = 0; c < 4; ++c) {
    if ((columns >> c & 1u) == 0) continue;
    const real entry = a(row, static_cast<int>(c)),
               rest = row == 3 ? real(1) : minor_of(a, row + 1, columns & ~(1u << c));
    sum = sign > 0 ? sum + entry * rest : sum - entry * rest;
    sign = -sign;
  }
  return sum;
}

std::array<real, 16> true_inverse(const mat4& a) {
  const real determinant = minor_of(a, 0, 15);
  std::array<real, 16> x;
  for (int c = 0; c < 4; ++c) {
    mat4 first{};  // row c in front, then the others
    for (int i = 1, row = 0; i < 4; ++i, ++row) {
      row += row == c ? 1 : 0;
      for (int j = 0; j < 4; ++j) first(i, j) = a(row, j);
    }
    for (int r = 0; r < 4; ++r) {
      const real cofactor = minor_of(first, 1, 15u & ~(1u << r)) / determinant;
      x[static_cast<std::size_t>(r * 4 + c)] = (r + c) % 2 == 0 ? cofactor : -cofactor;
    }
  }
  return x;
}

struct numbers_of {
  std::array<double, 16> n;
  double operator[](int i) const { return n[static_cast<std::size_t>(i)]; }
};
[[maybe_unused]] numbers_of flat(const numbers_of& x) { return x; }
numbers_of flat(const std::optional<mat4>& x) {
  numbers_of all;
  for (std::size_t i = 0; i < 16; ++i)
    all.n[i] = x ? (*x)(static_cast<int>(i / 4), static_cast<int>(i % 4)) : std::numeric_limits<double>::quiet_NaN();
  return all;
}
vec4 or_nan(const std::optional<vec4>& x) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return x ? *x : vec4{nan, nan, nan, nan};
}
vec4 or_nan(const irg::system_solution<double, 4>& s) { return or_nan(s ? std::optional(s.x) : std::nullopt); }

#ifdef IRG_HAVE_EIGEN
using eigen4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
auto eigen_of(const mat4& a) { return Eigen::Map<const eigen4>(&a.m[0][0]); }
numbers_of flat(const eigen4& x) {
  numbers_of all;
  Eigen::Map<eigen4>(all.n.data()) = x;
  return all;
}
#endif

void inverse(const std::vector<set>& all) {
  bench::study s("inverse of 4x4", "matrix", bench::error_unit::relative_u);
  for (const set& one : all) {
    const auto& m = one.matrices;
    const auto exact = [](const mat4& a, bench::exact_results& out) {
      for (const real& x : true_inverse(a)) out.push_back(x.result());
    };
    const bench::distribution d{one.name, m.size(), 16, bench::exact_for(m, exact)};
    const auto entry = [&](const char* name, auto f) {
      return bench::for_each_vector<16>(name, m, [f](const mat4& a) { return flat(f(a)); });
    };
    std::vector<bench::implementation> who{
        entry("irg", [](const mat4& a) { return irg::inverse(a); }),
        entry("irg: inverse_fast", [](const mat4& a) { return std::optional(irg::inverse_fast(a)); }),
        entry("irg: inverse_accurate", [](const mat4& a) { return irg::inverse_accurate(a); }),
        entry("irg: inverse_exact", [](const mat4& a) { return irg::inverse_exact(a); })};
#ifdef IRG_HAVE_GLM
    who.push_back(bench::for_each_vector<16>("GLM", m, [](const mat4& a) {
      glm::dmat4 g;
      for (int i = 0; i < 16; ++i) g[i % 4][i / 4] = a(i / 4, i % 4);
      g = glm::inverse(g);
      numbers_of x;
      for (int i = 0; i < 16; ++i) x.n[static_cast<std::size_t>(i)] = g[i % 4][i / 4];
      return x;
    }));
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
    who.push_back(entry("OpenCV invert (LU)", [](const mat4& a) {
      bool regular = true;
      const auto x = cv::Matx44d(&a.m[0][0]).inv(cv::DECOMP_LU, &regular);
      numbers_of found;
      std::copy(x.val, x.val + 16, found.n.begin());
      return found;
    }));
#endif
#ifdef IRG_HAVE_EIGEN
    who.push_back(entry("Eigen inverse", [](const mat4& a) { return eigen4(eigen_of(a).inverse()); }));
    who.push_back(
        entry("Eigen PartialPivLU", [](const mat4& a) { return eigen4(eigen_of(a).partialPivLu().inverse()); }));
    who.push_back(entry("Eigen FullPivLU", [](const mat4& a) { return eigen4(eigen_of(a).fullPivLu().inverse()); }));
#endif
    s.panel(d, who, bench::text_of_items(m));
  }
}

// Without pivoting: as it is first taught.
vec4 eliminated(const mat4& m) {
  mat4 a = m;
  vec4 b = right;
  for (int k = 0; k < 4; ++k)
    for (int i = k + 1; i < 4; ++i) {
      const double factor = a(i, k) / a(k, k);
      for (int j = k; j < 4; ++j) a(i, j) -= factor * a(k, j);
      b[i] -= factor * b[k];
    }
  for (int k = 3; k >= 0; --k) {
    for (int j = k + 1; j < 4; ++j) b[k] -= a(k, j) * b[j];
    b[k] /= a(k, k);
  }
  return b;
}

void solve(const std::vector<set>& all) {
  bench::study s("solution of 4 equations", "system", bench::error_unit::relative_u);
  for (const set& one : all) {
    const auto& m = one.matrices;
    const auto exact = [](const mat4& a, bench::exact_results& out) {
      const auto x = true_inverse(a);
      for (std::size_t r = 0; r < 16; r += 4)
        out.push_back((x[r] * right.x + x[r + 1] * right.y + x[r + 2] * right.z + x[r + 3] * right.w).result());
    };
    const bench::distribution d{one.name, m.size(), 4, bench::exact_for(m, exact)};
    std::vector<bench::implementation> who{
        bench::for_each_vector<4>("irg: lu_solve", m,
                                  [](const mat4& a) {
                                    const auto f = irg::lu_factor(a);
                                    return or_nan(f ? std::optional(irg::lu_solve(*f, right)) : std::nullopt);
                                  }),
        bench::for_each_vector<4>("irg: solve_gauss", m,
                                  [](const mat4& a) { return or_nan(irg::solve_gauss(a, right)); }),
        bench::for_each_vector<4>("irg: lu_solve_refined", m,
                                  [](const mat4& a) { return or_nan(irg::lu_solve_refined(a, right)); }),
        bench::for_each_vector<4>("irg: solve_exact", m,
                                  [](const mat4& a) { return or_nan(irg::solve_exact(a, right)); }),
        bench::for_each_vector<4>("Gauss without pivoting", m, eliminated)};
#ifdef IRG_HAVE_OPENCV_IMGPROC
    who.push_back(bench::for_each_vector<4>("OpenCV solve (LU)", m, [](const mat4& a) {
      const auto x = cv::Matx44d(&a.m[0][0]).solve(cv::Vec4d(right.x, right.y, right.z, right.w), cv::DECOMP_LU);
      return vec4{x(0), x(1), x(2), x(3)};
    }));
#endif
#ifdef IRG_HAVE_EIGEN
    const Eigen::Vector4d b(right.x, right.y, right.z, right.w);
    who.push_back(bench::for_each_vector<4>(
        "Eigen PartialPivLU", m, [b](const mat4& a) { return Eigen::Vector4d(eigen_of(a).partialPivLu().solve(b)); }));
    who.push_back(bench::for_each_vector<4>(
        "Eigen FullPivLU", m, [b](const mat4& a) { return Eigen::Vector4d(eigen_of(a).fullPivLu().solve(b)); }));
#endif
    s.panel(d, who, bench::text_of_items(m));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto& all = bench::keep(sets());
  inverse(all);
  solve(all);
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_inverse: skipped, MPFR was not found"); }
#endif
