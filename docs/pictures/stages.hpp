// SPDX-License-Identifier: MIT
// One body on its way through the stages of the pipeline, a picture for each. Included by pictures.cpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/hidden/back_faces.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/screen_mapping.hpp>
#include <irg/render/textbook/pipeline.hpp>
#include <irg/shade/shading.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/camera_frame.hpp>
#include <irg/view/frustum.hpp>
#include <irg/view/projection.hpp>
#include <irg/view/window_to_viewport.hpp>

#include "viewing.hpp"

namespace stages {

using namespace viewing;
using body = irg::mesh<double>;
using matrix = irg::mat<double, 4, 4>;
constexpr int width = 320, height = 240, pixel = 5;
constexpr double near_distance = 1.78, far_distance = 4.6;

// ---- the stages, one function of irg each

inline body object() {
  return irg::shape_torus<double>({.minor_radius = 0.45, .major_segments = 14, .minor_segments = 8});
}

inline matrix placement() {
  return irg::translation(irg::vec<double, 3>{0.3, 0.5, 0}) * irg::rotation_x(0.12) * irg::rotation_z(-0.3) *
         irg::rotation_y(2.6);
}
inline body in_world() { return irg::transformed(object(), placement()); }

inline irg::camera_frame<double> camera() {
  return irg::look_at_frame(point3{0.6, 1.15, 3.15}, point3{-0.3, 0.42, 0}, irg::vec<double, 3>{0, 1, 0});
}
inline body in_camera() { return irg::transformed(in_world(), irg::view_matrix(camera())); }

inline std::vector<std::uint32_t> fronts() {  // in camera space the eye is the origin
  return irg::front_faces(in_camera(), irg::hpoint<double, 3>{0, 0, 0, 1});
}

inline matrix projection() { return irg::perspective(irg::radians(36.0), 4.0 / 3, near_distance, far_distance); }

// What clipping leaves of a face, with the positions in camera space as attributes.
using corner = irg::clip_vertex<double, 3>;
inline auto clipped(const body& m, std::uint32_t f) {
  corner polygon[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const point3& p = m.positions[m.corner(f, k).position];
    polygon[k] = {projection() * p, {p.x, p.y, p.z}};
  }
  return irg::clip_homogeneous(polygon);
}

// ---- seen from aside

struct observer {
  matrix view;
  double scale;
  point2 centre;
  point2 operator()(const point3& p) const {
    const point3 q = transform_point(view, p);
    return {centre.x + scale * q.x / (6 - q.z / 3), centre.y - scale * q.y / (6 - q.z / 3)};
  }
};

inline observer aside(const point3& from, const point3& at, double scale, const point2& centre) {
  return {irg::view_matrix(irg::look_at_frame(at + irg::normalized(from - at), at, irg::vec<double, 3>{0, 1, 0})),
          scale, centre};
}

template <class Place>
void ring(picture& p, const std::vector<point3>& points, const Place& place, irg::rgba8 colour, double thickness = 1) {
  for (std::size_t i = 0; i < points.size(); ++i)
    stroke(p, place(points[i]), place(points[(i + 1) % points.size()]), colour, thickness);
}

inline std::vector<point3> face(const body& m, std::uint32_t f) {
  std::vector<point3> points;
  for (std::size_t k = 0; k < m.face_size(f); ++k) points.push_back(m.positions[m.corner(f, k).position]);
  return points;
}

template <class Place>
void wire(picture& p, const body& m, const Place& place, irg::rgba8 colour) {
  for (std::uint32_t f = 0; f < m.face_count(); ++f) ring(p, face(m, f), place, colour);
}

template <class Place>
void axes(picture& p, const matrix& frame, const Place& place, double length) {
  const point3 origin = transform_point(frame, point3{});
  for (int i = 0; i < 3; ++i) {
    point3 tip{};
    tip[i] = length;
    stroke(p, place(origin), place(transform_point(frame, tip)), green, 1.8);
    tip[i] += 0.15;
    const irg::cell at = cell_of(place(transform_point(frame, tip)));
    letter(p, "xyz" [i], { at.x - 5, at.y - 7 }, 2, green);
  }
}

// The space that the camera sees.
template <class Place>
void frustum(picture& p, const matrix& to_clip, const Place& place) {
  const auto corners = irg::frustum_corners(irg::frustum_of(to_clip));
  if (!corners) return;
  const auto at = [&](int k) { return place(irg::to_cartesian(corners->at[k])); };
  for (int k = 0; k < 8; ++k)
    for (const int bit : {1, 2, 4})
      if ((k & bit) == 0) stroke(p, at(k), at(k | bit), blue, 1.2);
}

inline picture in_its_own_system() {
  picture p(width, height, paper);
  const observer place = aside({1, 0.8, 1.6}, {0, 0, 0}, 430, {160, 150});
  wire(p, object(), place, ink);
  axes(p, irg::identity_matrix<double, 4>(), place, 1.8);
  return p;
}

inline const point3& lamp() {
  static constexpr point3 at{-1.2, 2.2, 1.2};
  return at;
}

inline picture in_the_world() {
  picture p(width, height, paper);
  const observer place = aside({4.2, 2.6, 1.6}, {0, 0.7, 0.9}, 250, {150, 125});
  axes(p, irg::identity_matrix<double, 4>(), place, 1.5);
  wire(p, in_world(), place, ink);
  frustum(p, projection() * irg::view_matrix(camera()), place);
  dot(p, cell_of(place(camera().position)), 4, red);
  dot(p, cell_of(place(lamp())), 6, {236, 190, 92, 255});
  return p;
}

inline observer beside_camera() { return aside({3.6, 1.6, -0.6}, {0, 0, -2.4}, 270, {165, 122}); }

inline picture in_the_camera() {
  picture p(width, height, paper);
  const observer place = beside_camera();
  wire(p, in_camera(), place, ink);
  frustum(p, projection(), place);
  axes(p, irg::identity_matrix<double, 4>(), place, 0.9);
  dot(p, cell_of(place({0, 0, 0})), 4, red);
  return p;
}

inline picture without_back_faces() {
  picture p(width, height, paper);
  const observer place = beside_camera();
  const body m = in_camera();
  wire(p, m, place, pale);
  for (const std::uint32_t f : fronts()) ring(p, face(m, f), place, ink);
  dot(p, cell_of(place({0, 0, 0})), 4, red);
  return p;
}

inline picture clipped_away() {
  picture p(width, height, paper);
  const observer place = beside_camera();
  const body m = in_camera();
  for (const std::uint32_t f : fronts()) ring(p, face(m, f), place, pale);
  frustum(p, projection(), place);
  for (const std::uint32_t f : fronts()) {
    std::vector<point3> points;
    for (const corner& c : clipped(m, f)) points.push_back({c.attributes[0], c.attributes[1], c.attributes[2]});
    ring(p, points, place, ink);
  }
  dot(p, cell_of(place({0, 0, 0})), 4, red);
  return p;
}

// The edges of what is left, from normalised coordinates to wherever a mapping puts them.
template <class Draw>
void projected_edges(const Draw& draw) {
  const body m = in_camera();
  for (const std::uint32_t f : fronts()) {
    const auto left = clipped(m, f);
    for (int k = 0; k < left.count; ++k) {
      const point3 a = irg::to_cartesian(left.vertices[k].position);
      const point3 b = irg::to_cartesian(left.vertices[(k + 1) % left.count].position);
      draw(point2{a.x, a.y}, point2{b.x, b.y});
    }
  }
}

inline picture in_the_picture_plane() {
  picture p(width, height, paper);
  const auto place = [](const point2& q) { return point2{160 + 132 * q.x, 120 - 99 * q.y}; };
  const point2 window[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (std::size_t i = 0; i < 4; ++i) stroke(p, place(window[i]), place(window[(i + 1) % 4]), blue, 1.2);
  projected_edges([&](const point2& a, const point2& b) { stroke(p, place(a), place(b), ink, 1); });
  stroke(p, place({0, 0}), place({0.45, 0}), green, 1.8);
  stroke(p, place({0, 0}), place({0, 0.55}), green, 1.8);
  letter(p, 'x', {cell_of(place({0.49, 0})).x, 113}, 2, green);
  letter(p, 'y', {155, cell_of(place({0, 0.72})).y}, 2, green);
  return p;
}

inline picture in_the_viewport() {
  picture small(width / pixel, height / pixel, {255, 255, 255, 255});
  const auto to_view = irg::window_to_viewport(irg::centred_window(2.0, 2.0),
                                               irg::viewport<double>{0, 0, width / pixel, height / pixel});
  const auto cell = [&](const point2& q) {
    const point2 at = irg::to_pixels(to_view.value, q);
    return irg::cell{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))};
  };
  projected_edges([&](const point2& a, const point2& b) { irg::draw_line(small, cell(a), cell(b), ink); });
  return enlarged(small, pixel);
}

// ---- filled

// Draws the faces with constant shading into a picture and its depth buffer, the last one first.
template <class Order>
void fill(picture& colour, irg::image<float>& depth) {
  const auto mapping = irg::map_to_screen<double>({colour.width(), colour.height()});
  const point3 from = transform_point(irg::view_matrix(camera()), lamp());
  const irg::light<double, double> lights[] = {{irg::to_homogeneous(from), 200.0}};
  const irg::flat_shader<double, double> shade{{0.3, 0.9, 0, 1}, {100.0, lights}, {}};
  const body m = in_camera();
  const std::vector<std::uint32_t> left_over = fronts();
  for (auto it = left_over.rbegin(); it != left_over.rend(); ++it) {
    const std::uint32_t f = *it;
    const double intensity = shade(face(m, f), irg::face_normal(m, f).value_or(irg::vec<double, 3>{}));
    const auto v = static_cast<std::uint8_t>(irg::clamped(intensity, 0.0, 255.0));
    const irg::solid_shader<irg::rgba8> paint{{v, v, v, 255}};
    const auto left = clipped(m, f);
    for (int k = 1; k + 1 < left.count; ++k)
      irg::shade_triangle<Order>(
          colour, depth,
          {irg::to_screen(left.vertices[0].position, mapping), irg::to_screen(left.vertices[k].position, mapping),
           irg::to_screen(left.vertices[k + 1].position, mapping)},
          paint);
  }
}

template <class Order>
std::pair<picture, irg::image<float>> filled() {
  picture colour(width / pixel, height / pixel, paper);
  irg::image<float> depth(width / pixel, height / pixel, irg::nearer_is_greater::farthest);
  fill<Order>(colour, depth);
  return {colour, depth};
}

inline picture shaded() { return enlarged(filled<irg::drawing_order>().first, pixel); }
inline picture with_depth() { return enlarged(filled<irg::nearer_is_greater>().first, pixel); }
inline picture depths() {
  const irg::image<float> depth = filled<irg::nearer_is_greater>().second;
  picture grey(depth.width(), depth.height());
  for (int y = 0; y < depth.height(); ++y)
    for (int x = 0; x < depth.width(); ++x) {
      const auto v = static_cast<std::uint8_t>(irg::clamped(depth(x, y), 0.0f, 1.0f) * 255);
      grey(x, y) = {v, v, v, 255};
    }
  return enlarged(grey, pixel);
}

// The same body by the pipeline on one screen, each corner of a triangle in a colour of its own, and its depths.
inline picture on_one_screen() {
  picture p(width, height, paper), all(2 * width + 12, height, {255, 255, 255, 255});
  irg::image<float> depth(width, height, 0.0f);
  std::vector<point3> corners;
  const body m = in_camera();
  for (const irg::mesh_corner& c : m.corners) corners.push_back(m.positions[c.position]);
  irg::textbook::shade_triangles(corners, projection(), p, depth, [](std::size_t, const auto& at) {
    const auto channel = [&](float a, float b, float c) {
      return static_cast<std::uint8_t>(60 + 190 * at.interpolate(a, b, c));
    };
    return irg::rgba8{channel(1, 0, 0), channel(0, 1, 0), channel(0, 0, 1), 255};
  });
  paste(all, p, 0, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto grey = static_cast<std::uint8_t>(255 * irg::minimum(depth(x, y), 1.0f));
      p(x, y) = {grey, grey, grey, 255};
    }
  paste(all, p, width + 12, 0);
  return all;
}

// All of them, each with the name of its file.
inline std::vector<std::pair<const char*, picture>> all() {
  return {{"stage_object", in_its_own_system()}, {"stage_world", in_the_world()},
          {"stage_camera", in_the_camera()},     {"stage_back_faces", without_back_faces()},
          {"stage_clipping", clipped_away()},    {"stage_projection", in_the_picture_plane()},
          {"stage_viewport", in_the_viewport()}, {"stage_shading", shaded()},
          {"stage_zbuffer", with_depth()},       {"stage_depths", depths()},
          {"pipeline_textbook", on_one_screen()}};
}

}  // namespace stages
