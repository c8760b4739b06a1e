// SPDX-License-Identifier: MIT
// Phong's reflection model at a point: run time against error, with the light at the side, grazing, and far away, and
// for large shininess, which makes much of a small error.
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <irg/math/length.hpp>
#include <irg/shade/phong_model.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using vec3 = irg::vec<double, 3>;
using point3 = irg::point<double, 3>;
struct item {
  point3 p, eye, light;
  vec3 normal;
  double shininess;
};
struct set {
  std::string name;
  std::vector<item> items;
};
constexpr double ambient = 0.125, diffuse = 0.5, specular = 0.375;

// A light at `height` over the surface's plane and a viewer near the reflected ray.
item make_item(bench::random_numbers& r, double height, double away, double shininess) {
  const vec3 n = irg::normalized(vec3{r.between(-1, 1), r.between(-1, 1), r.between(0.3, 1)});
  const vec3 u = irg::normalized(irg::cross(n, vec3{r.between(-1, 1), 1, r.between(-1, 1)})), v = irg::cross(n, u);
  const point3 p{r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)};
  const auto off = [&] { return vec3{r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)} * 0.1; };
  const double turn = r.between(0, 6.28), far = away * r.between(1, 3);
  const vec3 along = u * std::cos(turn) + v * std::sin(turn);
  return {p, p + (n * height - along + off() * height) * (2 * r.between(1, 3)), p + (n * height + along) * far, n,
          shininess};
}

std::vector<set> make_sets() {
  struct kind {
    const char* name;
    double height, away, shininess;
  };
  std::vector<set> all;
  for (const kind& k : {kind{"light from the side, n = 20", 1, 1, 20},
                        {"n = 1", 1, 1, 1},
                        {"n = 20.5", 1, 1, 20.5},
                        {"n = 1000", 1, 1, 1000},
                        {"grazing to 10^-6", 1e-6, 1, 20},
                        {"light 10^8 away", 1, 1e8, 20}}) {
    bench::random_numbers r(31);
    set s{k.name, {}};
    for (int i = 0; i < (bench::smoke() ? 16 : 1024); ++i)
      s.items.push_back(make_item(r, k.height, k.away, k.shininess));
    all.push_back(s);
  }
  return all;
}

struct triple {
  real x, y, z;
};
triple difference(const point3& a, const point3& b) {
  return {real(a.x) - real(b.x), real(a.y) - real(b.y), real(a.z) - real(b.z)};
}
real dot(const triple& a, const triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
triple scaled(const triple& a, const real& s) { return {a.x * s, a.y * s, a.z * s}; }
triple unit(const triple& a) { return scaled(a, real(1) / sqrt(dot(a, a))); }

// The normal counts as it is given; 2(L.N)N - L of one that is not quite of length 1, as the formula says.
void add_true_intensity(const item& i, bench::exact_results& exact) {
  const triple n{real(i.normal.x), real(i.normal.y), real(i.normal.z)};
  const triple l = unit(difference(i.light, i.p)), v = unit(difference(i.eye, i.p));
  const real ln = dot(l, n);
  real sum = real(ambient);
  if (real(0) < ln) {
    sum = sum + real(diffuse) * ln;
    const triple mirrored = scaled(n, ln + ln);
    const real rv = dot({mirrored.x - l.x, mirrored.y - l.y, mirrored.z - l.z}, v);
    if (real(0) < rv) sum = sum + real(specular) * real::of(mpfr_pow, rv, real(i.shininess));
  }
  exact.push_back(sum.result());
}

double by_irg(const item& i) {
  const irg::light<double, double> lamp{irg::to_homogeneous(i.light), 1};
  const irg::lighting<double, double> all{1, std::span(&lamp, 1)};
  const irg::material<double, double> surface{ambient, diffuse, specular, i.shininess};
  return irg::phong_model(surface, all, i.eye, {i.p, i.normal});
}

double in_doubles(const item& i) {
  const auto unit_of = [](const vec3& v) { return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); };
  const vec3 l = unit_of(i.light - i.p), v = unit_of(i.eye - i.p), &n = i.normal;
  const double ln = l.x * n.x + l.y * n.y + l.z * n.z;
  if (ln <= 0) return ambient;
  const vec3 r = n * (2 * ln) - l;
  const double rv = r.x * v.x + r.y * v.y + r.z * v.z;
  return ambient + diffuse * ln + (rv > 0 ? specular * std::pow(rv, i.shininess) : 0);
}

#ifdef IRG_HAVE_GLM
double by_glm(const item& i) {
  const auto of = [](const auto& v) { return glm::dvec3(v.x, v.y, v.z); };
  const glm::dvec3 p = of(i.p), l = glm::normalize(of(i.light) - p), v = glm::normalize(of(i.eye) - p),
                   n = of(i.normal);
  const double ln = glm::dot(l, n), rv = glm::dot(glm::reflect(-l, n), v);
  if (ln <= 0) return ambient;
  return ambient + diffuse * ln + specular * glm::pow(glm::max(rv, 0.0), i.shininess);
}
#endif

}  // namespace

int main(int argc, char** argv) {
  const bench::study s("Phong's reflection model", "point and light", bench::error_unit::ulp);
  for (const auto& one : bench::keep(make_sets())) {
    const auto& items = one.items;
    const bench::distribution d{one.name, items.size(), 1, bench::exact_for(items, add_true_intensity)};
    std::vector<bench::implementation> who{bench::for_each_item("irg", items, by_irg),
                                           bench::for_each_item("formula in double", items, in_doubles)};
#ifdef IRG_HAVE_GLM
    who.push_back(bench::for_each_item("GLM reflect and pow", items, by_glm));
#endif
    s.panel(d, who, bench::text_of_items(items));
  }
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_shade: skipped, MPFR was not found"); }
#endif
