// SPDX-License-Identifier: MIT
// The angle between two vectors: run time against error, from 1e-300 to pi.
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <irg/math/angle_between.hpp>
#include <irg/math/length.hpp>
#include <irg/math/vec.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"

#ifdef IRG_HAVE_GLM
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/vector_angle.hpp>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using vec = irg::vec<double, 3>;
struct pair {
  vec a, b;
};
using pairs = std::vector<pair>;

bench::real exact_angle(const vec& a, const vec& b) {
  using bench::real;
  const auto minor = [&](int i, int j) { return real(a[i]) * real(b[j]) - real(a[j]) * real(b[i]); };
  const real x = minor(1, 2), y = minor(2, 0), z = minor(0, 1);
  const real along = real(a.x) * real(b.x) + real(a.y) * real(b.y) + real(a.z) * real(b.z);
  return real::of(mpfr_atan2, sqrt(x * x + y * y + z * z), along);
}

// Two vectors at an angle of about `angle`, or that much less than pi; one as long as 2^exponent, the other as 2^-exponent.
// Angles that general vectors of doubles cannot have are between vectors near an axis.
pairs at_angle(double angle, bool from_opposite, int exponent, std::size_t count) {
  bench::random_numbers r(17);
  pairs all;
  for (std::size_t i = 0; i < count; ++i) {
    vec a{r.between(0.5, 1), r.between(-1, 1), r.between(-1, 1)};
    if (angle < 1e-14) a = {a.x, 0, 0};
    const vec aside{-a.y, a.x, 0};
    const double s = from_opposite ? -1 : 1;
    const vec b{s * a.x + angle * aside.x, s * a.y + angle * aside.y, s * a.z};
    all.push_back({a * std::ldexp(1.0, exponent), b * std::ldexp(1.0, -exponent)});
  }
  return all;
}

double plain_length(const vec& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
double plain_dot(const vec& a, const vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
vec plain_cross(const vec& a, const vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double half_chord(const vec& a, const vec& b) { return std::asin(std::fmin(1.0, plain_length(a - b) / 2)); }

void measure(const bench::study& s, const std::string& name, pairs made) {
  const pairs& input = bench::keep(std::move(made));
  const bench::distribution d{name, input.size(), 1,
                              bench::exact_for(input, [](const pair& p, bench::exact_results& out) {
                                out.push_back(exact_angle(p.a, p.b).result());
                              })};
  const auto entry = [&](const char* who, auto f) {
    return bench::for_each_item(who, input, [f](const pair& p) { return f(p.a, p.b); });
  };
  using V = const vec&;
  std::vector<bench::implementation> all{
      entry("irg", [](V a, V b) { return irg::angle_between(a, b); }),
      entry("acos of the cosine",
            [](V a, V b) { return std::acos(plain_dot(a, b) / (plain_length(a) * plain_length(b))); }),
      entry("atan2 of the cross product",
            [](V a, V b) { return std::atan2(plain_length(plain_cross(a, b)), plain_dot(a, b)); }),
      entry("Kahan's half angle",
            [](V a, V b) {
              const vec u = a / plain_length(a), v = b / plain_length(b);
              return 2 * std::atan2(plain_length(u - v), plain_length(u + v));
            }),
      entry("pbrt form (asin of half the chord)", [](V a, V b) {
        const vec u = a / plain_length(a), v = b / plain_length(b);
        return plain_dot(u, v) < 0 ? 3.14159265358979323846 - 2 * half_chord(-u, v) : 2 * half_chord(u, v);
      })};
#ifdef IRG_HAVE_GLM
  all.push_back(entry("GLM angle", [](V a, V b) {
    return glm::angle(glm::normalize(glm::dvec3(a.x, a.y, a.z)), glm::normalize(glm::dvec3(b.x, b.y, b.z)));
  }));
#endif
  s.panel(d, all, bench::text_of_items(input));
}

}  // namespace

int main(int argc, char** argv) {
  bench::study s("angle", "angle", bench::error_unit::ulp);
  const std::size_t n = bench::smoke() ? 16 : 2048;
  measure(s, "any directions", at_angle(1, false, 0, n));
  for (const int e : {-6, -12, -100, -300})
    measure(s, "angles of 1e" + std::to_string(e), at_angle(std::pow(10, e), false, 0, n));
  for (const int e : {-6, -12})
    measure(s, "angles of pi - 1e" + std::to_string(e), at_angle(std::pow(10, e), true, 0, n));
  measure(s, "lengths 2^500 and 2^-500", at_angle(1e-3, false, 500, n));
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_angle: skipped, MPFR was not found"); }
#endif
