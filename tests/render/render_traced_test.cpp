// SPDX-License-Identifier: MIT
#include <irg/render/render_traced.hpp>

#include <atomic>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>
#include <irg/core/threads.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/trace/ray_tracing.hpp>

namespace {

constexpr int width = 60, height = 40;

irg::scene<double> world() {
  irg::scene<double> s;
  s.objects.push_back({irg::shape_sphere<double>({.slices = 12, .stacks = 8})});
  s.objects.push_back({irg::shape_cube<double>()});
  s.objects[0].surface = {{0.4, 0.5, 0.6}, {0.4, 0.5, 0.6}, {0.3, 0.3, 0.3}, 30};
  s.objects[1].placement(0, 3) = 0.75;
  s.view.eye = {2, 3, 5};
  s.lights = {{{-3, 5, 4, 1}, {0.8, 0.8, 0.8}}, {{1, 1, 0, 0}, {0.2, 0.2, 0.2}}};
  s.ambient = {0.2, 0.2, 0.2};
  return s;
}

using picture = irg::image<irg::rgba8>;

picture traced(const irg::scene<double>& s, const std::vector<irg::optics<double>>& optics,
               irg::traced_options<double> options, int threads = 1) {
  picture p(width, height);
  options.optics = optics;
  irg::render_traced(s, p, options, irg::parallel{threads});
  return p;
}

irg::traced_options<double> plain(int samples = 1) {
  irg::traced_options<double> o;
  o.limits.shadows = irg::shadow_rays::off;
  o.samples = samples;
  return o;
}

TEST_CASE("render_traced: the bytes of render() where rays add nothing, in every projection and from within") {
  irg::scene<double> s = world();
  for (int i = 0; i < 5; ++i) {
    if (i == 1) s.view.projection = irg::projection_kind::orthographic;
    if (i == 2) s.view.projection = irg::projection_kind::oblique;
    if (i == 3) s.view = {{0, 0, 0.5}, {1, 0.3, 0}};  // within the ball, its triangles clipped
    if (i == 4) s.view = {{1.25, 0.5, 0.5}, {1.5, 0.5, 0}};
    s.view = irg::with_depth_range(s.view, {0.5, 0.25, 0.25}, 2);
    irg::render_options options;
    options.style = irg::picture_style::phong;
    options.culling = i == 3 ? irg::face_culling::none : irg::face_culling::back;
    irg::traced_options<double> rays = plain();
    rays.culling = options.culling;
    picture expected(width, height);
    irg::image<float> depth(width, height);
    irg::render(s, {expected, depth}, options);
    CHECK((traced(s, {}, rays) == expected));
    picture by_tree(width, height);
    irg::render_with(irg::ray_tracing<>{}, s, {by_tree, depth}, options);
    CHECK((by_tree == expected));
  }
}

TEST_CASE("render_traced: where normals are 0, those of the triangles") {
  irg::scene<double> s;
  s.objects.push_back({irg::shape_cube<double>()});
  irg::mesh<double>& shape = s.objects[0].shape;
  s.view.eye = {2, 3, 5};
  s.lights = {{{1, 2, 3, 0}, {1, 1, 1}}};
  shape.normals = {{0, 0, 0}};
  for (auto& c : shape.corners) c.normal = 0;
  const picture by_triangles = traced(s, {}, plain());
  picture dark(width, height);
  irg::image<float> depth(width, height);
  irg::render(s, {dark, depth}, {.style = irg::picture_style::phong});
  CHECK_FALSE((by_triangles == dark));
  shape.normals.clear();
  for (std::size_t f = 0; f < shape.face_count(); ++f) {
    shape.normals.push_back(irg::face_normal(shape, f).value());
    for (std::size_t k = 0; k < shape.face_size(f); ++k)
      shape.corners[shape.face_starts[f] + k].normal = static_cast<std::uint32_t>(f);
  }
  CHECK((traced(s, {}, plain()) == by_triangles));
}

TEST_CASE("render_traced: threads, samples, shadows, mirrors and glass") {
  const irg::scene<double> s = world();
  std::vector<irg::optics<double>> optics(1);
  optics[0] = {{0.2, 0.2, 0.2}, {0.5, 0.6, 0.7}, 1.5};
  const picture none = traced(s, {}, plain()), shadows = traced(s, {}, {}), glass = traced(s, optics, {});
  CHECK(!(none == shadows));
  CHECK(!(shadows == glass));
  CHECK((glass == traced(s, optics, {}, 3)));
  irg::traced_options<double> four;
  four.samples = 4;
  CHECK((traced(s, optics, four) == traced(s, optics, four, 2)));
  // The mean of samples in a picture that is dark left of its middle column and bright right of it.
  irg::scene<double> half;
  irg::mesh<double> sheet;
  sheet.positions = {{0, -9, 0}, {9, -9, 0}, {9, 9, 0}, {0, 9, 0}};
  irg::add_face(sheet, std::array{0, 1, 2, 3});
  half.objects.push_back({sheet});
  half.objects[0].surface = {{1, 1, 1}, {}, {}, 1};
  half.ambient = {1, 1, 1};
  half.view.projection = irg::projection_kind::orthographic;
  half.view = irg::with_depth_range(half.view, {0, 0, 0}, 20);
  picture p(3, 1);
  irg::traced_options<double> on_black = plain(2);
  on_black.colours.background = {0, 0, 0, 255};
  irg::render_traced(half, p, on_black);
  CHECK(p(0, 0) == irg::rgba8{0, 0, 0, 255});
  CHECK(p(1, 0) == irg::encode(irg::rgb<float>{0.5f, 0.5f, 0.5f}));
  CHECK(p(2, 0) == irg::rgba8{255, 255, 255, 255});
}

TEST_CASE("render_traced: no pixels, no objects, reports") {
  picture nothing(0, 0);
  CHECK(irg::render_traced(world(), nothing).drawn == 0);
  picture empty(2, 2);
  irg::render_traced(irg::scene<double>{}, empty);
  CHECK(empty(1, 1) == irg::picture_colours().background);
  picture p(width, height);
  std::atomic<std::size_t> done = 0;
  const irg::parallel threads{2};
  const auto report = [&](std::size_t, std::size_t) { ++done; };
  irg::render_traced(world(), p, {}, irg::reporting{threads, report});
  CHECK(done > 0);
  CHECK((p == traced(world(), {}, {})));
}

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // the old order goes on compiling
TEST_CASE("render_traced: optics among the options, and the old order") {
  const std::vector<irg::optics<double>> optics(1, {{0.5, 0.5, 0.5}, {}, 1});
  picture now(width, height), before(width, height);
  irg::render_traced(world(), now, {.optics = optics});
  irg::render_traced<double>(world(), optics, before);
  CHECK((now == before));
  irg::render_traced<double>(world(), {}, before);
  CHECK_FALSE((now == before));
}

}  // namespace
