// SPDX-License-Identifier: MIT
// Draws the pictures of the documentation into the folder named on the command line. `scripts/pictures` calls it; a test
// checks that the committed pictures are what it draws.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include <irg/colour/srgb.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/io/image_file.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/mesh/crease_normals.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/face_order.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/render/render.hpp>
#include <irg/view/affine.hpp>

#include "booleans.hpp"
#include "bsp.hpp"
#include "cameras.hpp"
#include "curves.hpp"
#include "deep.hpp"
#include "depths.hpp"
#include "enlarged.hpp"
#include "convex_bodies.hpp"
#include "escape.hpp"
#include "faces.hpp"
#include "fills.hpp"
#include "fills_aa.hpp"
#include "hidden_methods.hpp"
#include "grid_surfaces.hpp"
#include "horizon.hpp"
#include "lights.hpp"
#include "line_drawings.hpp"
#include "line_kernels.hpp"
#include "line_teaching.hpp"
#include "line_variants.hpp"
#include "occlusion.hpp"
#include "occlusion_culling.hpp"
#include "plane_sight.hpp"
#include "portals.hpp"
#include "projections.hpp"
#include "plots.hpp"
#include "rays.hpp"
#include "rectangles.hpp"
#include "saving.hpp"
#include "shaders.hpp"
#include "sight.hpp"
#include "solids.hpp"
#include "space_sight.hpp"
#include "splines.hpp"
#include "stages.hpp"
#include "studio.hpp"
#include "surfaces.hpp"
#include "textbook_fill.hpp"
#include "texts.hpp"
#include "trees.hpp"
#include "viewing.hpp"
#include "lines_aa.hpp"
#include "meshes.hpp"

namespace {

using namespace enlarging;
using namespace saving;
using vec3 = irg::vec<double, 3>;

constexpr irg::rgba8 blue{92, 142, 196, 255}, red{204, 96, 72, 255}, dark_blue{48, 90, 140, 255},
    dark_red{150, 60, 40, 255};

void shared_edge() {
  picture small(14, 9, paper);
  const irg::subpixel a{300, 200}, b{3400, 420}, c{2300, 2150}, d{500, 1700};
  const auto fill = [&](irg::subpixel p, irg::subpixel q, irg::subpixel r, irg::rgba8 colour) {
    irg::covered_spans(irg::cover_triangle(p, q, r), irg::window_of(small),
                       [&](irg::span_of_cells s) { irg::fill_span(small, s, colour); });
  };
  fill(a, b, d, blue);
  fill(b, c, d, red);
  constexpr int size = 40;
  picture big = enlarged(small, size);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 14; ++x) dot(big, {x * size + size / 2, y * size + size / 2}, 2, ink);
  const auto place = [](irg::subpixel p) { return irg::cell{p.x * size / 256, p.y * size / 256}; };
  for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, d}, std::pair{d, a}, std::pair{b, c}, std::pair{c, d}})
    irg::draw_line(big, place(p), place(q), ink);
  save("shared_edge", big);
}

void lines() {
  constexpr int size = 10;
  picture small(64, 40, paper);
  const irg::cell_window window{8, 5, 56, 35};
  for (int y = window.y_first; y < window.y_last; ++y)
    irg::fill_span(small, {y, window.x_first, window.x_last}, {255, 255, 255, 255});
  for (int i = 0; i < 16; ++i) {
    const double angle = irg::two_pi<double> * i / 16;
    const irg::cell end{32 + static_cast<int>(std::floor(60 * irg::cos(angle))),
                        20 + static_cast<int>(std::floor(60 * irg::sin(angle)))};
    irg::draw_line(small, {32, 20}, end, pale);
    irg::draw_line(irg::within(small, window), {32, 20}, end, i % 2 ? blue : red);
  }
  save("lines", enlarged(small, size));
}

struct encode_light {
  irg::rgba8 operator()(const irg::rgb<float>& light) const { return irg::encode(light); }
};

void depth() {
  picture p(420, 220, paper);
  irg::image<float> z(420, 220, irg::nearer_is_greater::farthest);
  const auto triangle = [&](float left, float right, int top, irg::rgb<float> near, irg::rgb<float> far) {
    const auto mix = [&](float t) {
      return irg::rgb<float>{far.r + t * (near.r - far.r), far.g + t * (near.g - far.g), far.b + t * (near.b - far.b)};
    };
    const irg::screen_vertex a{{20 * 256, top * 256}, left}, b{{400 * 256, top * 256}, right},
        c{{210 * 256, 210 * 256}, (left + right) / 2};
    irg::shade_triangle(
        p, z, {a, b, c},
        irg::vertex_colour_shader<irg::rgba8, encode_light>{mix(a.depth), mix(b.depth), mix(c.depth), {}});
  };
  triangle(0.9f, 0.1f, 20, {0.1f, 0.3f, 0.7f}, {0.5f, 0.65f, 0.85f});
  triangle(0.1f, 0.9f, 50, {0.7f, 0.12f, 0.06f}, {0.9f, 0.6f, 0.5f});
  save("depth", p);
}

irg::scene<double> scene_of(irg::mesh<double> shape, vec3 from, int width, int height, double zoom = 1.0) {
  irg::scene<double> s;
  s.objects.resize(1);
  s.objects[0].shape = std::move(shape);
  s.objects[0].surface = {{0.10, 0.20, 0.30}, {0.25, 0.50, 0.75}, {0.40, 0.40, 0.40}, 50.0};
  s.lights = {{{-0.4, 1.0, 0.7, 0.0}, {1.0, 1.0, 1.0}}};
  s.ambient = {0.5, 0.5, 0.5};
  const auto ball = irg::bounding_sphere_of(s.objects[0].shape);
  s.view = irg::camera_around(ball.centre, ball.radius / zoom, from, irg::radians(40.0),
                              static_cast<double>(width) / height);
  s.view = irg::with_depth_range(s.view, ball.centre, ball.radius);
  return s;
}

picture render(const irg::scene<double>& s, int width, int height, irg::render_options options = {}) {
  picture p(width, height);
  irg::image<float> z(width, height);
  irg::render(s, {p, z}, options);
  return p;
}

// One body from four sides, prepared once.
void prepared() {
  constexpr int width = 200, height = 150, views = 4;
  const auto world = scene_of(irg::shape_teapot<double>({.subdivisions = 6}), {0.2, 0.7, 1.6}, width, height, 1.1);
  irg::prepared_scene<double> ready = irg::prepare_scene(world);
  picture all(views * width, height), one(width, height);
  irg::image<float> z(width, height);
  for (int i = 0; i < views; ++i) {
    ready.view.eye = irg::transform_point(irg::rotation_y(irg::radians(70.0 * i)), world.view.eye);
    irg::render(ready, {one, z});
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) all(i * width + x, y) = one(x, y);
  }
  save("prepared_scene", all);
}

// Three triangles through each other, each a little in front of the others somewhere: ids, and colours.
void methods() {
  constexpr int width = 300, height = 220;
  irg::mesh<double> m;
  for (int i = 0; i < 3; ++i) {
    const auto turn = irg::rotation_z(irg::radians(120.0 * i)) * irg::rotation_x(irg::radians(28.0));
    for (const auto& p : {irg::point<double, 3>{-1.5, -0.55, 0}, {1.5, -0.55, 0}, {0.3, 1.1, 0}})
      m.positions.push_back(irg::transform_point(turn, p));
    irg::add_face(m, std::vector<int>{3 * i, 3 * i + 1, 3 * i + 2});
  }
  irg::scene<double> s;
  s.objects.push_back({m});
  s.objects[0].surface = {{0.10, 0.20, 0.30}, {0.25, 0.50, 0.75}, {}, 1.0};
  s.lights = {{{-0.4, 1.0, 0.7, 0.0}, {1.0, 1.0, 1.0}}};
  s.ambient = {0.5, 0.5, 0.5};
  s.view.eye = {0, -0.1, 4.6};
  picture all(2 * width, height), one(width, height);
  irg::image<float> z(width, height);
  irg::image<std::uint32_t> kept(width, height, irg::no_index);
  std::vector<irg::screen_face> all_faces;
  const auto nearest = [&](const auto& faces, const irg::cell_window& w, irg::image<std::uint32_t>& ids,
                           irg::draw_counts&) {
    for (std::size_t i = 0; i < faces.size(); ++i) all_faces.push_back(faces[i]);
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x)
        ids(x, y) = kept(x, y) =
            irg::picture_face_at(std::span(all_faces).last(faces.size()), x, y).value_or(irg::no_index);
  };
  irg::render_with(nearest, s, {one, z}, {.style = irg::picture_style::flat, .culling = irg::face_culling::none});
  constexpr irg::rgba8 of_face[3] = {{200, 80, 60, 255}, {70, 150, 90, 255}, {60, 100, 180, 255}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      all(x, y) = kept(x, y) == irg::no_index ? irg::picture_colours{}.background : of_face[kept(x, y)];
      all(width + x, y) = one(x, y);
    }
  save("hidden_surface_methods", all);
  save("ray_casting", hidden_pictures::rays());
  save("floating_horizon", horizon_pictures::surfaces());
  save("horizon_laid_over", horizon_pictures::laid_over());
  save("horizon_lines", plot_pictures::horizon_lines());
  save("plot_surface", plot_pictures::surfaces());
  save("bsp_tree_2d", bsp_pictures::orders());
  save("bsp_tree_3d", bsp_pictures::order_in_space());
  save("grid_surface", grid_pictures::views());
  save("warnock", hidden_pictures::windows());
  save("painter", hidden_pictures::painters());
  save("depth_sort", hidden_pictures::sorted_parts());
  save("one_scene", hidden_pictures::one_scene_by_two());
  save("bsp_faces", hidden_pictures::parts());
}

void teapots() {
  const vec3 from{0.6, 0.6, 1.6};
  save("teapot", render(scene_of(irg::shape_teapot<double>({.subdivisions = 16}), from, 800, 520, 1.18), 800, 520,
                        {.style = irg::picture_style::phong, .culling = irg::face_culling::none}));
  const auto small = scene_of(irg::shape_teapot<double>({.subdivisions = 6}), from, 400, 260, 1.18);
  save("teapot-wire", render(small, 400, 260, {.style = irg::picture_style::wire}));
  save("teapot-flat", render(small, 400, 260, {.style = irg::picture_style::flat, .culling = irg::face_culling::none}));
  save("teapot-gouraud",
       render(small, 400, 260, {.style = irg::picture_style::gouraud, .culling = irg::face_culling::none}));
  auto cut = small;
  cut.view.near_distance = irg::length(cut.view.target - cut.view.eye) * 0.93;
  save("clip", render(cut, 400, 260, {.style = irg::picture_style::flat, .culling = irg::face_culling::none}));
}

void shading() {
  picture p(900, 300, paper);
  const auto s = scene_of(irg::shape_sphere<double>({.slices = 18, .stacks = 12}), {0.3, 0.4, 1.0}, 300, 300, 0.95);
  int left = 0;
  for (const auto style : {irg::picture_style::flat, irg::picture_style::gouraud, irg::picture_style::phong}) {
    paste(p, render(s, 300, 300, {.style = style}), left, 0);
    left += 300;
  }
  save("shading", p);
}

void materials() {
  picture p(800, 400, paper);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 4; ++column) {
      auto s = scene_of(irg::shape_sphere<double>({.slices = 64, .stacks = 48}), {0.3, 0.4, 1.0}, 200, 200, 0.95);
      const double ks = row ? 0.8 : 0.3;
      s.objects[0].surface = {
          {0.16, 0.06, 0.04}, {0.55, 0.18, 0.12}, {ks, ks, ks}, static_cast<double>(4 << (2 * column))};
      paste(p, render(s, 200, 200, {.style = irg::picture_style::phong}), 200 * column, 200 * row);
    }
  save("materials", p);
}

// Every face with its own normal, so that its edges stay sharp.
irg::mesh<double> faceted(irg::mesh<double> m) {
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    for (std::size_t k = 0; k < m.face_size(f); ++k)
      m.corners[m.face_starts[f] + k].normal = static_cast<std::uint32_t>(f);
  }
  m.normals.clear();
  for (std::size_t f = 0; f < m.face_count(); ++f) m.normals.push_back(irg::face_normal(m, f).value_or(vec3{}));
  return m;
}

// A drum of 20 sides: every edge smooth, the sharp ones sharp, every edge sharp.
void creases() {
  constexpr int sides = 20;
  irg::mesh<double> drum;
  for (int i = 0; i < 2 * sides; ++i) {
    const double angle = (i / 2) * irg::two_pi<double> / sides;
    drum.positions.push_back({irg::cos(angle), i % 2 ? 0.8 : -0.8, irg::sin(angle)});
  }
  std::vector<int> lid, bottom;
  for (int i = 0; i < sides; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % sides);
    irg::add_face(drum, std::array{a, a + 1, b + 1, b});
    lid.insert(lid.begin(), a + 1);
    bottom.push_back(a);
  }
  irg::add_face(drum, lid);
  irg::add_face(drum, bottom);
  irg::scene<double> s = scene_of(drum, {0.3, 0.7, 1.2}, 840, 280);
  s.objects.clear();
  for (const double crease : {180.0, 60.0, 0.0}) {
    irg::object<double> o;
    o.shape = drum;
    irg::assign_crease_normals(o.shape, irg::radians(crease));
    o.placement = irg::translation(vec3{crease == 180 ? -2.6 : crease == 0 ? 2.6 : 0.0, 0, 0});
    o.surface = {{0.10, 0.20, 0.30}, {0.25, 0.50, 0.75}, {0.40, 0.40, 0.40}, 50.0};
    s.objects.push_back(std::move(o));
  }
  s.view = irg::camera_around(irg::point<double, 3>{0, 0, 0}, 1.4, vec3{0.0, 0.6, 1.0}, irg::radians(30.0), 3.0);
  s.view.near_distance = 0.1;
  save("crease_normals", render(s, 840, 280, {.style = irg::picture_style::phong}));
}

void shapes() {
  irg::scene<double> s = scene_of(irg::shape_sphere<double>({.slices = 48, .stacks = 32}), {0.5, 0.7, 1.6}, 800, 360);
  const auto add = [&](irg::mesh<double> shape, vec3 place, irg::rgb<double> colour) {
    irg::object<double> o;
    o.shape = std::move(shape);
    o.placement = irg::translation(place);
    o.surface = {{colour.r / 2, colour.g / 2, colour.b / 2}, colour, {0.3, 0.3, 0.3}, 40.0};
    s.objects.push_back(std::move(o));
  };
  s.objects.clear();
  add(faceted(irg::shape_cube<double>()), {-4.4, -0.5, -0.5}, {0.75, 0.42, 0.20});
  add(irg::shape_sphere<double>({.slices = 48, .stacks = 32}), {-1.6, 0, 0}, {0.25, 0.50, 0.75});
  add(irg::shape_torus<double>({.major_segments = 64, .minor_segments = 32}), {1.5, 0, 0}, {0.35, 0.60, 0.35});
  add(faceted(irg::shape_icosahedron<double>()), {4.3, 0, 0}, {0.65, 0.30, 0.55});
  s.view = irg::camera_around(irg::point<double, 3>{0, 0, 0}, 2.6, vec3{0.1, 0.5, 1.0}, irg::radians(30.0), 1.0);
  s.view.near_distance = 0.1;
  save("shapes", render(s, 800, 360, {.style = irg::picture_style::phong}));
}

void projections() {
  picture p(800, 300, paper);
  auto s = scene_of(irg::shape_cube<double>(), {1.0, 0.8, 1.6}, 400, 300);
  const auto ball = irg::bounding_sphere_of(s.objects[0].shape);
  s.view = irg::camera_around(ball.centre, ball.radius * 1.3, vec3{1.0, 0.8, 1.6}, irg::radians(70.0), 4.0 / 3.0);
  paste(p, render(s, 400, 300, {.style = irg::picture_style::flat}), 0, 0);
  s.view.projection = irg::projection_kind::orthographic;
  s.view = irg::with_depth_range(s.view, ball.centre, ball.radius);
  paste(p, render(s, 400, 300, {.style = irg::picture_style::flat}), 400, 0);
  save("projections", p);
}

void srgb() {
  picture p(640, 130, paper);
  for (int x = 0; x < 640; ++x) {
    const float light = (static_cast<float>(x) + 0.5f) / 640;
    const auto naive = static_cast<std::uint8_t>(light * 255 + 0.5f);
    for (int y = 0; y < 60; ++y) p(x, y) = irg::encode({light, light, light});
    for (int y = 70; y < 130; ++y) p(x, y) = {naive, naive, naive, 255};
  }
  save("srgb", p);
}

void bezier() {
  picture p(640, 320, paper);
  const std::array<irg::point<double, 2>, 4> control{{{40, 280}, {150, 30}, {470, 40}, {600, 270}}};
  const auto cell = [](irg::point<double, 2> q) {
    return irg::cell{static_cast<int>(std::floor(q.x)), static_cast<int>(std::floor(q.y))};
  };
  for (std::size_t i = 0; i < 3; ++i) irg::draw_line(p, cell(control[i]), cell(control[i + 1]), pale);
  // de Casteljau's construction at t = 0.4
  irg::point<double, 2> level[4] = {control[0], control[1], control[2], control[3]};
  for (int n = 3; n > 0; --n) {
    for (int i = 0; i < n; ++i) level[i] = level[i] + (level[i + 1] - level[i]) * 0.4;
    for (int i = 0; i + 1 < n; ++i) irg::draw_line(p, cell(level[i]), cell(level[i + 1]), n == 3 ? blue : red);
    for (int i = 0; i < n; ++i) dot(p, cell(level[i]), 3, n == 1 ? ink : n == 3 ? dark_blue : dark_red);
  }
  irg::cell last = cell(control[0]);
  for (int k = 1; k <= 100; ++k) {
    const irg::cell next = cell(irg::bezier_point(control, k / 100.0));
    irg::draw_line(p, last, next, ink);
    last = next;
  }
  for (const auto& c : control) dot(p, cell(c), 4, ink);
  save("bezier", p);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2) folder = argv[1];
  shared_edge();
  lines();
  depth();
  teapots();
  prepared();
  methods();
  shading();
  materials();
  shapes();
  creases();
  projections();
  srgb();
  bezier();
  save("bspline", splines::both());
  save("bspline_knots", splines::other_knots());
  save("bezier_queries", splines::queries());
  save("curve_joint", splines::joints());
  save("bezier_weights", curve_pictures::weights());
  save("curve_paths", curve_pictures::paths());
  save("flattened_curves", curve_pictures::flattened());
  save("fly_through", curve_pictures::flight());
  save("fitted_curves", curve_pictures::fitted());
  save("surfaces", surface_pictures::made_of_curves());
  save("tessellation", surface_pictures::tessellated());
  number_and_geometry_pages();
  save("draw_line", line_kernels::steps());
  save("draw_lines", line_kernels::tiles());
  save("draw_polyline", line_kernels::polylines());
  save("line_textbook", line_teaching::textbook());
  save("line_dda", line_teaching::dda());
  save("line_run_slice", line_teaching::run_slice());
  save("line_cells", line_teaching::cells());
  save("line_subpixel", line_variants::subpixel());
  save("line_styled", line_variants::styled());
  save("line_thick", line_variants::thick());
  save("circle_midpoint", line_variants::circles());
  save("ellipse_midpoint", line_variants::ellipses());
  save("fill_convex_textbook", textbook_fill::rules());
  save("seed_fill", textbook_fill::seeds());
  save("conformance", textbook_fill::tiling());
  save("point_location", textbook_fill::locations());
  save("edge_walk", fills::edge());
  save("fill_convex", fills::convex());
  save("fill_polygon", fills::rules());
  save("fill_polygons", fills::batch());
  save("line_wu", lines_aa::wu());
  save("line_aa", lines_aa::area());
  save("fill_convex_aa", fills_aa::convex());
  save("fill_polygon_aa", fills_aa::rules());
  save("fill_seam", fills_aa::seam());
  save("blend_span", fills_aa::run());
  save("draw_text", texts::font());
  save("stroke", texts::strokes());
  save("screen_face", face_pictures::order());
  save("escape_time", escape_pictures::both());
  save("distance_estimate", escape_pictures::distances());
  save("other_maps", escape_pictures::other_maps());
  save("julia_convergence", escape_pictures::convergence());
  save("deep_mandelbrot", deep_pictures::four_widths());
  save("field_of_view", sight_pictures::variants());
  save("visible_part", sight_pictures::parts());
  save("see", sight_pictures::corners());
  save("visibility_polygon", plane_sight::polygons());
  save("weak_visibility", plane_sight::shadows());
  save("street_view", plane_sight::street());
  save("guard_cover", plane_sight::galleries());
  save("sight_2d", sight_pictures::thirds());
  save("sight_answers", sight_pictures::answers());
  save("sight_in_space", space_sight::folded_out());
  save("viewshed", sight_pictures::hills());
  save("portals", portal_pictures::rooms());
  failures += sight_pictures::write_sweep(folder + "/sight_sweep.svg") ? 0 : 1;
  save("zbuffer_textbook", depths::forms());
  failures += depths::write_plot(folder + "/depth_format.svg") ? 0 : 1;
  save("view_transform_textbook", viewing::steps());
  save("polar_camera", viewing::orbit());
  save("affine", camera_pictures::maps());
  save("axonometry", camera_pictures::proportions());
  save("camera_frame", camera_pictures::frames());
  save("look_at", camera_pictures::views());
  save("central_projection", camera_pictures::rays());
  save("oblique", camera_pictures::slants());
  save("mesh", mesh_pictures::faces());
  save("normals", mesh_pictures::normals());
  save("fit", mesh_pictures::fitting());
  save("minimax", rectangle_pictures::minimax());
  save("convex_body", convex_body_pictures::bodies());
  save("boolean", boolean_pictures::operations());
  save("csg_spans", boolean_pictures::spans());
  save("half_edges", boolean_pictures::half_edges());
  save("point_in_solid", solid_pictures::locations());
  save("bvh", tree_pictures::levels());
  save("bvh_parts", tree_pictures::parts());
  save("along_ray", tree_pictures::runs());
  save("visible_points", tree_pictures::points_seen());
  save("light_placement", light_pictures::around());
  save("draw_depth", light_pictures::depths());
  save("shadow", ray_pictures::shadow());
  save("path_tracer", ray_pictures::rooms());
  save("soft_light", ray_pictures::soft_shadows());
  save("glass", ray_pictures::glass());
  save("triangle_bvh", tree_pictures::through());
  save("cross_triangle", tree_pictures::shares());
  save("cube_projections", projection_pictures::every_projection());
  save("plane_projection", projection_pictures::shadows());
  save("frustum", projection_pictures::boxes());
  save("window_to_viewport", projection_pictures::fits());
  for (const auto& [name, p] : stages::all()) save(name, p);
  save("attribute_shading", shaders::torus());
  save("texture", shaders::wraps());
  save("mip_pyramid", shaders::floors());
  save("textured_shading", shaders::textured_torus());
  save("mip_textured_shading", shaders::mip_floors());
  save("draw_transparent", shaders::panes());
  save("hidden_lines", line_drawings::hidden_lines());
  save("cube_edges", line_drawings::cube_edges());
  save("visible_polygons", line_drawings::visible_polygons());
  save("occlusion_mask", occlusion_pictures::mask());
  save("visibility_buffer", occlusion_pictures::ids());
  save("occlusion_culling", occlusion_culling_pictures::seen_from_above());
  save("studio", studio_pictures::both_views());
  save("studio_window", studio_pictures::window());
  return failures == 0 ? 0 : 1;
}
