// SPDX-License-Identifier: MIT
// The scenes that pipelines are measured on: triangles of one pixel, of a thousand and of half a picture, and scenes of
// which a stated share is in view. Built from models where there are some and from a seeded generator, so that
// everybody draws the same vertices.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/scene/camera.hpp>

#include "raster/canvas.hpp"
#include "support/measure.hpp"

namespace bench {

/// Triangles that belong together, one after the other: what a renderer may skip as a whole.
struct scene_object {
  std::uint32_t first_vertex = 0, vertices = 0, first_triangle = 0, triangles = 0;
  irg::box<float, 3> bounds;
};

/// What is drawn: coloured vertices, triangles (counter-clockwise seen from outside), and the matrix to clip space with
/// reversed depth.
struct scene {
  std::string name;
  int width = 0, height = 0;
  irg::face_culling culling = irg::face_culling::none;
  std::vector<irg::point<float, 3>> positions{};
  std::vector<irg::vec<float, 3>> normals{};
  std::vector<irg::rgb<float>> colours{};
  std::vector<irg::triangle_indices> triangles{};
  std::vector<scene_object> objects{};
  irg::mat<float, 4, 4> to_clip{};
  std::string meant{};  // the statistics that the scene is made to have

  std::size_t pixel_count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// A scene without anything in it, in the size that is measured.
inline scene empty_scene(std::string name, irg::face_culling culling) {
  return {.name = std::move(name), .width = smoke() ? 480 : 1920, .height = smoke() ? 270 : 1080, .culling = culling};
}

/// A scene that can be made: its name is known before it is.
struct scene_plan {
  std::string name;
  std::function<scene()> make;
};

inline constexpr double turn = 6.283185307179586;

inline float aspect_of(const scene& s) { return static_cast<float>(s.width) / static_cast<float>(s.height); }

/// An eye in the origin that looks along -z, from `nearest` to infinity.
struct eye_in_origin {
  float half_height;  // of what is seen at distance 1
  float nearest;
  int width, height;

  float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
  irg::mat<float, 4, 4> to_clip() const {
    irg::camera<float> c;
    c.eye = {0, 0, 0};
    c.target = {0, 0, -1};
    c.vertical_angle = 2 * std::atan(half_height);
    c.near_distance = nearest;
    return irg::view_projection(c, aspect());
  }
  /// What is seen at place (x, y) of the picture, in pixels, at this distance.
  irg::point<float, 3> at(double x, double y, double distance) const {
    const double reach = static_cast<double>(half_height) * distance;
    return {static_cast<float>((2 * x / width - 1) * reach * static_cast<double>(aspect())),
            static_cast<float>((1 - 2 * y / height) * reach), static_cast<float>(-distance)};
  }
};

/// In which order triangles are drawn.
enum class drawing { random_order, front_to_back };

/// How far the corners of a random triangle are from being even around its circle: 1 lets them lie anywhere.
struct triangle_shape {
  double radius, margin, spread;  // in pixels of a picture 1920 wide; the margin keeps centres off the border
};

/// Triangles in circles of one radius about random places, at random distances, tilted a little.
scene random_triangles(const std::string& name, int count, const triangle_shape& shape, drawing order,
                       const std::string& meant);

/// a0: a scanned body of 69,451 triangles. a: the same, each triangle cut into 16. a1: a sculpted body of 124,008.
scene_plan scene_a0();
scene_plan scene_a();
scene_plan scene_a1();

/// b: 20,000 triangles of 830 px, one over the other eight times. c: 200 triangles of a third of the picture.
scene_plan scene_b(drawing order);
scene_plan scene_c();

/// Twenty bodies in a ring about the eye, of which two, a tenth, are in view and whole.
scene_plan scene_frustum();

/// What keeps the rest of the visible-scenes from being seen.
enum class hidden_by { wall, picture_border };

/// A hundred bodies in ten columns of ten, `percent` of them visible: 100, 50, 10, 1 or 0. The others stand behind a
/// wall, which is drawn first, or outside of the picture.
scene_plan scene_visible(int percent, hidden_by what);

}  // namespace bench
