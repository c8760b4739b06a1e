// SPDX-License-Identifier: MIT
// Where points are seen in a picture, and Phong's light on them: run time against error. Cameras near and far from the
// origin, with the upward direction nearly along the view; dull and sharp highlights.
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/vec.hpp>
#include <irg/shade/phong_model.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>
#include <irg/view/viewport.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"
#ifdef IRG_HAVE_GLM
#include <glm/gtc/matrix_transform.hpp>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using point3 = irg::point<double, 3>;
using vec3 = irg::vec<double, 3>;
using real3 = std::array<real, 3>;
std::size_t count() { return bench::smoke() ? 16 : 512; }

real3 exactly(const vec3& v) { return {real(v.x), real(v.y), real(v.z)}; }
real3 difference(const point3& p, const point3& q) { return {real(p.x) - q.x, real(p.y) - q.y, real(p.z) - q.z}; }
real3 crossed(const real3& a, const real3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
real dotted(const real3& a, const real3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
real3 unit(const real3& a) {
  const real size = sqrt(dotted(a, a));
  return {a[0] / size, a[1] / size, a[2] / size};
}
vec3 any_direction(bench::random_numbers& r) {
  const double x = r.between(-1, 1), y = r.between(-1, 1), z = r.between(-1, 1);
  return irg::normalized(vec3{x, y, z});
}

// ---- the picture of a point

struct seen_point {
  point3 eye, target;
  vec3 up;
  point3 p;
};
constexpr double angle = 0.75, aspect = 1.5, z_near = 0.125, z_far = 64;
constexpr irg::viewport<double> picture{0, 0, 1200, 800};

// Points in front of the camera; up is 2^-bits from the view.
std::vector<seen_point> seen_points(double away, int bits) {
  bench::random_numbers r(51);
  std::vector<seen_point> all;
  while (all.size() < count()) {
    const vec3 forward = any_direction(r), side = any_direction(r), aside = any_direction(r);
    const point3 eye{away + r.between(-1, 1), away + r.between(-1, 1), away + r.between(-1, 1)};
    const vec3 up = bits == 0 ? side : forward + side * std::ldexp(1.0, -bits);
    if (irg::length(irg::cross(forward, side)) < 0.1) continue;
    const double depth = r.between(1, 10);
    all.push_back({eye, eye + forward * r.between(1, 4), up, eye + forward * depth + aside * (depth / 4)});
  }
  return all;
}

void views() {
  bench::study s("picture of a point", "camera and point", bench::error_unit::relative_u);
  const auto exact = [](const seen_point& i, bench::exact_results& out) {
    const real3 z = unit(difference(i.eye, i.target)), x = unit(crossed(exactly(i.up), z)), y = crossed(z, x);
    const real3 from_eye = difference(i.p, i.eye);
    const real depth = -dotted(z, from_eye), scale = real(1) / real::of(mpfr_tan, real(angle) / real(2));
    const real right = dotted(x, from_eye) * scale / real(aspect) / depth, top = dotted(y, from_eye) * scale / depth;
    out.push_back((real(picture.width / 2) * (real(1) + right)).result());
    out.push_back((real(picture.height / 2) * (real(1) - top)).result());
  };
  const auto of_panel = [&](const std::string& name, double away, int bits) {
    const auto& items = bench::keep(seen_points(away, bits));
    const bench::distribution d{name, items.size(), 2, bench::exact_for(items, exact)};
    std::vector<bench::implementation> who{bench::for_each_vector<2>("irg", items, [](const seen_point& i) {
      const auto m = irg::perspective(angle, aspect, z_near, z_far) * irg::look_at(i.eye, i.target, i.up);
      return irg::to_pixels(picture, m * irg::to_homogeneous(i.p));
    })};
    who.push_back(bench::for_each_vector<2>("irg: about the eye", items, [](const seen_point& i) {
      const point3 origin{0, 0, 0}, p = origin + (i.p - i.eye);
      const auto m =
          irg::perspective(angle, aspect, z_near, z_far) * irg::look_at(origin, origin + (i.target - i.eye), i.up);
      return irg::to_pixels(picture, m * irg::to_homogeneous(p));
    }));
#ifdef IRG_HAVE_GLM
    who.push_back(bench::for_each_vector<2>("GLM", items, [](const seen_point& i) {
      const auto of = [](const auto& v) { return glm::dvec3(v.x, v.y, v.z); };
      const glm::dmat4 m =
          glm::perspective(angle, aspect, z_near, z_far) * glm::lookAt(of(i.eye), of(i.target), of(i.up));
      const glm::dvec4 q = m * glm::dvec4(of(i.p), 1);
      return glm::dvec2(picture.width / 2 * (1 + q.x / q.w), picture.height / 2 * (1 - q.y / q.w));
    }));
#endif
    s.panel(d, who, bench::text_of_items(items));
  };
  of_panel("about the origin", 0, 0);
  of_panel("10^3 away", 1e3, 0);
  of_panel("10^6 away", 1e6, 0);
  of_panel("up 2^-20 from the view", 0, 20);
}

// ---- Phong's light

struct lit_point {
  irg::surface_place<double> place;
  point3 eye, lamp;
  std::array<double, 9> shares;  // ambient, diffuse and specular of red, green and blue
  double shininess;
};

std::vector<lit_point> lit_points(double shininess, bool is_grazing) {
  bench::random_numbers r(52);
  std::vector<lit_point> all;
  while (all.size() < count()) {
    const vec3 normal = any_direction(r), along = any_direction(r);
    const vec3 to_lamp =
        is_grazing ? irg::normalized(irg::cross(normal, along)) + normal * r.between(0.001, 0.01) : along;
    lit_point i{{{r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)}, normal}, {}, {}, {}, shininess};
    // Near the mirrored ray, so that there is a highlight.
    const vec3 mirrored = irg::reflected_direction(to_lamp, normal);
    if (!(irg::dot(to_lamp, normal) > 1e-4)) continue;
    i.lamp = i.place.p + to_lamp * r.between(1, 10);
    i.eye = i.place.p + (mirrored + any_direction(r) * 0.2) * r.between(1, 10);
    for (double& share : i.shares) share = r.unit();
    all.push_back(i);
  }
  return all;
}

void phong() {
  bench::study s("light on a point", "point with one lamp", bench::error_unit::relative_u);
  const auto exact = [](const lit_point& i, bench::exact_results& out) {
    const real3 n = exactly(i.place.normal), l = unit(difference(i.lamp, i.place.p)),
                v = unit(difference(i.eye, i.place.p));
    const real ln = dotted(l, n);
    real3 mirrored;
    for (std::size_t k = 0; k < 3; ++k) mirrored[k] = real(2) * ln * n[k] - l[k];
    const real rv = dotted(mirrored, v);
    const real highlight = real(0) < rv ? real::of(mpfr_pow, rv, real(i.shininess)) : real(0);
    for (std::size_t k = 0; k < 3; ++k)
      out.push_back(
          (real(0.25) * i.shares[k] + real(i.shares[3 + k]) * ln + real(i.shares[6 + k]) * highlight).result());
  };
  const auto of_panel = [&](const std::string& name, double shininess, bool is_grazing) {
    const auto& items = bench::keep(lit_points(shininess, is_grazing));
    const bench::distribution d{name, items.size(), 3, bench::exact_for(items, exact)};
    std::vector<bench::implementation> who{bench::for_each_vector<3>("irg", items, [](const lit_point& i) {
      const auto channels = [&i](std::size_t k) {
        return irg::rgb<double>{i.shares[k], i.shares[k + 1], i.shares[k + 2]};
      };
      const irg::material<double> surface{channels(0), channels(3), channels(6), i.shininess};
      const std::array lamps{irg::light<double>{{i.lamp.x, i.lamp.y, i.lamp.z, 1}, {1, 1, 1}}};
      const irg::lighting<double> light{{0.25, 0.25, 0.25}, lamps};
      const irg::rgb<double> sum = irg::phong_model(surface, light, i.eye, i.place);
      return std::array{sum.r, sum.g, sum.b};
    })};
#ifdef IRG_HAVE_GLM
    who.push_back(bench::for_each_vector<3>("GLM", items, [](const lit_point& i) {
      const auto of = [](const auto& v) { return glm::dvec3(v.x, v.y, v.z); };
      const glm::dvec3 n = of(i.place.normal), l = glm::normalize(of(i.lamp) - of(i.place.p));
      const glm::dvec3 v = glm::normalize(of(i.eye) - of(i.place.p)), mirrored = glm::reflect(-l, n);
      const double highlight = glm::pow(glm::max(glm::dot(mirrored, v), 0.), i.shininess), ln = glm::dot(l, n);
      const auto channels = [&i](std::size_t k) { return glm::dvec3(i.shares[k], i.shares[k + 1], i.shares[k + 2]); };
      const glm::dvec3 sum = channels(0) * 0.25 + channels(3) * glm::max(ln, 0.) + channels(6) * highlight;
      return std::array{sum.x, sum.y, sum.z};
    }));
#endif
    s.panel(d, who, bench::text_of_items(items));
  };
  of_panel("shininess 8", 8, false);
  of_panel("shininess 7.3", 7.3, false);
  of_panel("shininess 200", 200, false);
  of_panel("grazing light", 8, true);
}

}  // namespace

int main(int argc, char** argv) {
  views();
  phong();
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_views: skipped, MPFR was not found"); }
#endif
