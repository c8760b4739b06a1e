// SPDX-License-Identifier: MIT
#include <irg/trace/path_tracer.hpp>

#include <array>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <irg/mesh/shapes.hpp>

#include "trace/worlds.hpp"

namespace {

using world = irg::ray_world<double>;
using R = irg::ray<double, 3>;
constexpr double pi = irg::pi<double>;

// A floor of diffuse share 0.5 under a square panel of 2 by 2 at height 1: the light that a point under its middle
// reflects is 0.5 L F, with F four times the form factor of a corner: (2/pi) (a/A atan(a/A)), a = 1, A = sqrt(2).
const double expected = 0.5 * 3 * 4 / pi * (1 / std::sqrt(2.0)) * std::atan(1 / std::sqrt(2.0));

irg::traced_body<double> shining(const test::kept_body& b, double light) {
  irg::traced_body<double> out = b.body({});
  out.emitted = {light, light, light};
  return out;
}

TEST_CASE("path_tracer: a floor under a panel, whose light is known; the error falls as the square root of the paths") {
  const test::kept_body floor(test::rectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), {}),
      panel(test::rectangle({-1, 1, 1}, {2, 0, 0}, {0, -2, 0}), {});
  const world w({floor.body({{}, {0.5, 0.5, 0.5}, {}, 1}), shining(panel, 3)}, {});
  const irg::path_tracer<double> trace(w);
  const R down{{0, 0, 0.5}, {0, 0, -1}};
  double error[3]{};
  const int paths[3] = {16, 256, 4096};
  for (int k = 0; k < 3; ++k) {
    const int trials = k < 2 ? 400 : 60;
    for (int i = 0; i < trials; ++i) {
      const double off = trace(down, {paths[k], 1, 7}, static_cast<std::uint64_t>(i)).r - expected;
      error[k] += off * off / trials;
    }
    error[k] = std::sqrt(error[k]);
  }
  CHECK(error[2] < 0.01 * expected);
  CHECK(error[0] / error[1] == doctest::Approx(4).epsilon(0.2));
  CHECK(error[1] / error[2] == doctest::Approx(4).epsilon(0.3));
  CHECK(trace(R{{0, 0, 0.5}, {0, 0, 1}}, {4, 1}, 0).r == 3);          // the panel itself
  CHECK(trace(R{{0, 0, 2}, {0, 0, -1}}, {4, 0}, 0).r == 0);           // its back
  CHECK(trace(down, {64, 3, 5}, 9) == trace(down, {64, 3, 5}, 9));
}

TEST_CASE("path_tracer: the same light at every scale, and past triangles with corners that are no numbers") {
  const auto light_at = [](double s, double corner) {
    irg::mesh<double> shape = test::rectangle({-1, 1, 1}, {2, 0, 0}, {0, -2, 0});
    shape.positions.push_back({corner, 1, 1});
    irg::add_face(shape, std::array{0, 1, 4});
    const test::kept_body floor(test::rectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), {}, s), panel(shape, {}, s);
    const world w({floor.body({{}, {0.5, 0.5, 0.5}, {}, 1}), shining(panel, 3)}, {});
    return irg::path_tracer<double>(w)(R{{0, 0, 0.5 * s}, {0, 0, -s}}, {64, 1}, 3).r;
  };
  const double light = light_at(1, -1);  // a triangle without area
  CHECK(light == doctest::Approx(expected).epsilon(0.2));
  for (const double s : {0x1p-300, 0x1p-900, 0x1p300, 0x1p900}) CHECK(light_at(s, -1) == light);
  CHECK(light_at(1, std::nan("")) == light);
  CHECK(light_at(1, HUGE_VAL) == light);
}

TEST_CASE("path_tracer: many small triangles beside a large one, in floats: none is lost in the sum of areas") {
  constexpr std::uint32_t n = 128;
  std::vector<irg::point<float, 3>> corners;
  std::vector<irg::triangle_indices> panel;
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i)
    corners.push_back({static_cast<float>(i % (n + 1)) / 64 - 1, static_cast<float>(i / (n + 1)) / 64 - 1, 1});
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const std::uint32_t a = i / n * (n + 1) + i % n, b = a + n + 1;
    panel.push_back({{a, b, a + 1}});
    panel.push_back({{a + 1, b, b + 1}});
  }
  const std::vector<irg::point<float, 3>> large{{0, 0, -5}, {96, 0, -5}, {0, 96, -5}},
      floor{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
  const std::vector<irg::triangle_indices> one{{{0, 1, 2}}};
  const irg::rgb<float> light{3, 3, 3};
  const irg::ray_world<float> w({{large, {}, one, {}, {}, light},
                                 {corners, {}, panel, {}, {}, light},
                                 {floor, {}, one, {{}, {0.5f, 0.5f, 0.5f}, {}, 1}}},
                                {});
  CHECK(irg::path_tracer<float>(w)(irg::ray<float, 3>{{0, 0, 0.5f}, {0, 0, -1}}, {5000, 1}, 0).r > 0);
}

TEST_CASE("path_tracer: light between walls: the series of a closed room") {
  // Within a ball of diffuse share k that shines with 1 everywhere, n reflections make 1 + k + ... + k^n.
  irg::mesh<double> ball = irg::shape_sphere<double>({.slices = 24, .stacks = 16});
  for (std::size_t f = 0; f < ball.face_count(); ++f)
    std::swap(ball.corners[ball.face_starts[f]], ball.corners[ball.face_starts[f] + 2]);
  const test::kept_body room(ball, {});
  irg::traced_body<double> body = shining(room, 1);
  body.surface.diffuse = {0.5, 0.25, 0};
  const world w({body}, {});
  const irg::path_tracer<double> trace(w);
  const auto light = trace(R{{0.1, 0.2, 0.1}, {0.3, 0.2, 0.9}}, {20000, 3, 3}, 1);
  CHECK(light.r == doctest::Approx(1.875).epsilon(0.02));
  CHECK(light.g == doctest::Approx(1 + 0.25 + 0.0625 + 0.015625).epsilon(0.02));
  CHECK(light.b == 1);
}

TEST_CASE("path_tracer: nothing shines, nothing is there") {
  const world empty({}, {}, {0.5, 0.5, 0.5});
  CHECK(irg::path_tracer<double>(empty)(R{{0, 0, 0}, {0, 0, 1}}, {}, 0).r == 0.5);
  CHECK(irg::path_tracer<double>(empty)(R{{0, 0, 0}, {0, 0, 0}}, {}, 0).r == 0.5);
  const test::kept_body floor(test::rectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), {});
  const world dark({floor.body({{}, {0.5, 0.5, 0.5}, {}, 1})}, {}, {1, 1, 1});
  CHECK(irg::path_tracer<double>(dark)(R{{0, 0, 1}, {0, 0, -1}}, {16, 4}, 0).r == 0.5);  // the sky, reflected once
}

}  // namespace
