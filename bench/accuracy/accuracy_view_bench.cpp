// SPDX-License-Identifier: MIT
// From the world to the pixel: camera, central projection and viewport, made for each item and applied to a point. Run
// time against error of the place in the picture, with the world far from the origin and the camera near its target.
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <irg/math/mat.hpp>
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
struct shot {
  point3 eye, target;
  vec3 up;
  point3 p;
  double angle;
};
struct set {
  std::string name;
  std::vector<shot> shots;
};
constexpr double width = 1920, height = 1080, z_near = 0.125, z_far = 1000;

// The point is in the picture; `apart` are eye and target, and up is `tilt` from the direction of view.
shot make_shot(bench::random_numbers& r, double away, double apart, double tilt) {
  const auto unit = [&] { return vec3{r.between(-1, 1), r.between(-1, 1), r.between(0.2, 1)}; };
  const point3 eye{away + r.between(-1, 1), away + r.between(-1, 1), away + r.between(-1, 1)};
  const vec3 view = unit(), aside{-view.y, view.x, 0};
  const double depth = r.between(1, 100);
  return {eye, eye + view * apart, view + aside * tilt,
          eye + view * depth + vec3{r.between(-0.2, 0.2), r.between(-0.2, 0.2), r.between(-0.2, 0.2)} * depth,
          r.between(0.5, 1.5)};
}

std::vector<set> make_sets() {
  struct kind {
    const char* name;
    double away, apart, tilt;
  };
  std::vector<set> all;
  for (const kind& k : {kind{"about the origin", 0, 10, 1},
                        {"10^3 away", 1e3, 10, 1},
                        {"10^6 away", 1e6, 10, 1},
                        {"target 10^-6 before the eye", 0, 1e-6, 1},
                        {"up along the view to 10^-6", 0, 10, 1e-6}}) {
    bench::random_numbers r(29);
    set s{k.name, {}};
    for (int i = 0; i < (bench::smoke() ? 16 : 1024); ++i) s.shots.push_back(make_shot(r, k.away, k.apart, k.tilt));
    all.push_back(s);
  }
  return all;
}

using triple = std::array<real, 3>;
real dot(const triple& a, const triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
triple cross(const triple& a, const triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
triple normalized(const triple& a) {
  const real l = sqrt(dot(a, a));
  return {a[0] / l, a[1] / l, a[2] / l};
}

// Without matrices: distances from the eye along the axes of the camera.
void add_true_place(const shot& s, bench::exact_results& exact) {
  triple back, up, from_eye;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    back[k] = real(s.eye[i]) - real(s.target[i]);
    up[k] = real(s.up[i]);
    from_eye[k] = real(s.p[i]) - real(s.eye[i]);
  }
  const triple z = normalized(back), x = normalized(cross(up, z)), y = cross(z, x);
  const real scale = real(1) / real::of(mpfr_tan, real(s.angle) / real(2));
  const real w = -dot(z, from_eye);
  const real at_x = dot(x, from_eye) * scale / (real(width) / real(height)) / w, at_y = dot(y, from_eye) * scale / w;
  exact.push_back((real(width / 2) + real(width / 2) * at_x).result());
  exact.push_back((real(height / 2) - real(height / 2) * at_y).result());
}

irg::point<double, 3> by_irg(const shot& s) {
  const auto m = irg::perspective(s.angle, width / height, z_near, z_far) * irg::look_at(s.eye, s.target, s.up);
  return irg::to_pixels(irg::viewport<double>{0, 0, width, height}, m * s.p);
}

#ifdef IRG_HAVE_GLM
std::array<double, 2> by_glm(const shot& s) {
  const auto of = [](const auto& v) { return glm::dvec3(v.x, v.y, v.z); };
  const glm::dmat4 m =
      glm::perspective(s.angle, width / height, z_near, z_far) * glm::lookAt(of(s.eye), of(s.target), of(s.up));
  const glm::dvec4 clip = m * glm::dvec4(of(s.p), 1.0);
  return {width / 2 + width / 2 * (clip.x / clip.w), height / 2 - height / 2 * (clip.y / clip.w)};
}
#endif

}  // namespace

int main(int argc, char** argv) {
  const bench::study s("place in the picture", "camera and point", bench::error_unit::relative_u);
  for (const auto& one : bench::keep(make_sets())) {
    const auto& items = one.shots;
    const bench::distribution d{one.name, items.size(), 2, bench::exact_for(items, add_true_place)};
    std::vector<bench::implementation> who{bench::for_each_vector<2>("irg", items, by_irg)};
#ifdef IRG_HAVE_GLM
    who.push_back(bench::for_each_vector<2>("GLM lookAt and perspective", items, by_glm));
#endif
    s.panel(d, who, bench::text_of_items(items));
  }
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_view: skipped, MPFR was not found"); }
#endif
