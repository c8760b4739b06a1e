// SPDX-License-Identifier: MIT
// Pictures of the view chapter: maps of a plane figure, axes in proportion, cameras as frames and what they see,
// central and oblique projection. Included by pictures.cpp.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <irg/view/affine.hpp>
#include <irg/view/axonometry.hpp>
#include <irg/view/camera_frame.hpp>
#include <irg/view/central_projection.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>

#include "board.hpp"
#include "sketch.hpp"

namespace camera_pictures {

using namespace sketching;
using mat4 = irg::mat<double, 4, 4>;
using shape = std::vector<point3>;  // a ring in space

// Space seen along parallel rays.
struct space {
  mat4 view;
  point2 origin;
  double unit;
  point2 at(const point3& p) const {
    const point3 q = transform_point(view, p);
    return {origin.x + unit * q.x, origin.y - unit * q.y};
  }
  ring at(const shape& s) const {
    ring r;
    for (const point3& q : s) r.push_back(at(q));
    return r;
  }
};
inline space seen_from(const vec3& to_viewer, const point2& origin, double unit) {
  return {irg::axonometric_view(to_viewer), origin, unit};
}

// An arrow with the letter of its axis beyond its tip.
inline void axis(picture& p, char name, const point2& from, const point2& to, irg::rgba8 colour) {
  arrow(p, from, to, 2, colour);
  const auto along = irg::try_normalized(to - from);
  if (along) letter(p, name, to + *along * 12.0, 4.5, colour);
}
inline void axes(picture& p, const space& s, double length, const mat4& frame = irg::identity_matrix<double, 4>()) {
  const irg::rgba8 colours[] = {red, green, blue};
  for (int i = 0; i < 3; ++i) {
    point3 tip{};
    tip[i] = length;
    axis(p, "xyz"[i], s.at(transform_point(frame, point3{})), s.at(transform_point(frame, tip)), colours[i]);
  }
}

// A house on the plane z = 0, with its front at greater z; no mirror image looks like it.
inline std::vector<shape> house() {
  const auto wall = [](double z) {
    return shape{{-0.5, 0, z}, {0.5, 0, z}, {0.5, 0.6, z}, {0, 1.05, z}, {-0.5, 0.6, z}};
  };
  std::vector<shape> parts{
      wall(-0.5), wall(0.5), {{-0.3, 0, 0.5}, {-0.05, 0, 0.5}, {-0.05, 0.4, 0.5}, {-0.3, 0.4, 0.5}}};
  for (std::size_t i = 0; i < 5; ++i) parts.push_back({parts[0][i], parts[1][i]});
  return parts;
}

// ---- affine maps

inline picture maps() {
  constexpr int panel = 300, height = 260;
  picture p(3 * panel, height, paper);
  const ring front{{0, 0}, {0.8, 0}, {0.8, 0.5}, {0.4, 0.9}, {0, 0.5}};
  const auto mapped = [](const mat4& m, const ring& r) {
    ring out;
    for (const point2& q : r) {
      const point3 t = transform_point(m, point3{q.x, q.y, 0});
      out.push_back({t.x, t.y});
    }
    return out;
  };
  const mat4 turn = irg::rotation_z(irg::radians(50.0)), move = irg::translation(vec3{1.7, 0.2, 0});
  const std::array<std::array<mat4, 2>, 2> orders{{{turn, move * turn}, {move, turn * move}}};
  for (int i = 0; i < 2; ++i) {
    const board b{p, 64.0 + panel * i, height - 40.0, 80};
    axis(p, 'x', b.at({-0.6, 0}), b.at({2.6, 0}), grey);
    axis(p, 'y', b.at({0, -0.3}), b.at({0, 2.4}), grey);
    const auto& [first, both] = orders[static_cast<std::size_t>(i)];
    b.outline(front, 1.6, ink);
    b.outline(mapped(first, front), 1.6, blue);
    b.fill(mapped(both, front), with_opacity(red, 60));
    b.outline(mapped(both, front), 2.2, red);
  }
  // A circle stretched upwards: its normals by the normal matrix, and by the matrix of its points.
  const mat4 stretch = irg::scaling(vec3{1, 1.9, 1});
  const board b{p, 2.0 * panel + panel / 2.0, height / 2.0, 50};
  ring circle_points;
  for (int i = 0; i < 48; ++i) {
    const double a = irg::two_pi<double> * i / 48;
    circle_points.push_back({irg::cos(a), irg::sin(a)});
  }
  b.fill(mapped(stretch, circle_points), {232, 230, 224, 255});
  b.outline(mapped(stretch, circle_points), 1.8, ink);
  for (int i = 0; i < 8; ++i) {
    const double a = irg::two_pi<double> * (i + 0.5) / 8;
    const vec3 n{irg::cos(a), irg::sin(a), 0};
    const point3 q = transform_point(stretch, point3{n.x, n.y, 0});
    const auto show = [&](const vec3& direction, irg::rgba8 colour) {
      const vec3 d = irg::normalized(direction) * 0.7;
      arrow(p, b.at({q.x, q.y}), b.at({q.x + d.x, q.y + d.y}), 2, colour);
    };
    show(irg::transform_vector(stretch, n), red);
    show(irg::transform_normal(stretch, n), green);
  }
  return p;
}

// ---- axonometry

// The unit cube in isometric, dimetric and trimetric projection: axes at their drawn lengths, angles against the level.
inline picture proportions() {
  constexpr int panel = 280, height = 310;
  picture p(3 * panel, height, paper);
  const std::array<vec3, 3> directions{irg::isometric<double>().to_viewer, irg::dimetric<double>().to_viewer,
                                       irg::trimetric<double>().to_viewer};
  for (int i = 0; i < 3; ++i) {
    const space s = seen_from(directions[static_cast<std::size_t>(i)], {panel * i + (i ? 112.0 : 140.0), 196}, 108);
    const irg::rgba8 faces[] = {{236, 205, 196, 255}, {206, 224, 206, 255}, {206, 220, 238, 255}};
    for (int a = 0; a < 3; ++a) {  // the faces that are seen: those at 1
      shape face;
      for (int k = 0; k < 4; ++k) {
        point3 q{};
        q[a] = 1;
        q[(a + 1) % 3] = k == 1 || k == 2 ? 1 : 0;
        q[(a + 2) % 3] = k > 1 ? 1 : 0;
        face.push_back(q);
      }
      area(p, s.at(face), faces[a]);
      outline(p, s.at(face), 1.4, ink);
    }
    const point2 o = s.at(point3{});
    dashes(p, {o.x - 96, o.y}, {o.x + (i ? 138 : 96), o.y}, 1.2, grey);
    const irg::rgba8 colours[] = {red, green, blue};
    for (int a = 0; a < 3; ++a) {  // within the cube an axis is an edge that is not seen
      point3 unit{}, tip{};
      unit[a] = 1;
      tip[a] = 1.35;
      dashes(p, o, s.at(unit), 1.8, colours[a]);
      axis(p, "xyz"[a], s.at(unit), s.at(tip), colours[a]);
    }
    disc(p, o, 3, ink);
  }
  return p;
}

// ---- cameras

struct eye_view {
  point3 eye, target;
  vec3 up;
  irg::rgba8 colour;
};

// A camera as a small pyramid with its axes: right red, up green, forward blue.
inline void camera(picture& p, const space& s, const irg::camera_frame<double>& f, double size, irg::rgba8 colour) {
  const point3 middle = f.position + f.forward * size;
  shape screen;
  for (int k = 0; k < 4; ++k)
    screen.push_back(middle + f.right * (k == 1 || k == 2 ? 0.5 : -0.5) * size + f.up * (k > 1 ? 0.4 : -0.4) * size);
  area(p, s.at(screen), with_opacity(colour, 70));
  outline(p, s.at(screen), 1.2, colour);
  for (const point3& q : screen) stroke(p, {s.at(f.position), s.at(q)}, 1.2, colour);
  mark(p, s.at(f.position), 3.5, colour);
}
inline void frame_arrows(picture& p, const space& s, const irg::camera_frame<double>& f, double length) {
  const std::array<vec3, 3> arms{f.right, f.up, f.forward};
  const irg::rgba8 colours[] = {red, green, blue};
  for (std::size_t i = 0; i < 3; ++i) arrow(p, s.at(f.position), s.at(f.position + arms[i] * length), 2.4, colours[i]);
}
inline void draw_house(picture& p, const space& s, const mat4& m, irg::rgba8 colour, double width = 1.5) {
  for (const shape& part : house()) {
    shape q;
    for (const point3& c : part) q.push_back(transform_point(m, c));
    outline(p, s.at(q), width, colour);
  }
}

// A camera in the world; the same in its own coordinates, right-handed and left-handed.
inline picture frames() {
  constexpr int panel = 300, height = 240;
  picture p(3 * panel, height, paper);
  const auto f = irg::look_at_frame(point3{2.3, 1.7, 1.6}, point3{0, 0.5, 0}, vec3{0, 1, 0});
  const space world = seen_from({-0.5, 0.45, 1}, {66, 172}, 58);
  draw_house(p, world, irg::identity_matrix<double, 4>(), ink);
  axes(p, world, 1.25);
  camera(p, world, f, 0.7, grey);
  frame_arrows(p, world, f, 0.9);
  for (int i = 0; i < 2; ++i) {
    const space s = seen_from({-0.75, 0.5, 1}, {panel * (i + 1) + 196.0, 166}, 62);
    const auto hand = i ? irg::handedness::left : irg::handedness::right;
    const mat4 m = irg::view_matrix(f, hand);
    // Where a camera's coordinates are in the drawing, which is right-handed.
    const auto placed = [&](const point3& q) { return i ? irg::change_handedness(q) : q; };
    for (const shape& part : house()) {
      shape seen;
      for (const point3& c : part) seen.push_back(placed(transform_point(m, c)));
      outline(p, s.at(seen), 1.5, ink);
    }
    const irg::camera_frame<double> own{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    camera(p, s, own, 0.7, grey);
    const irg::rgba8 colours[] = {red, green, blue};
    for (int k = 0; k < 3; ++k) {
      point3 tip{};
      tip[k] = k == 2 && i == 0 ? 1.0 : 1.3;
      axis(p, "xyz"[k], s.at(point3{}), s.at(placed(tip)), colours[k]);
    }
  }
  return p;
}

// Three cameras that look at one house, the third straight down with `up` along its view; and what each sees.
inline picture views() {
  constexpr int height = 330, square = 150;
  picture p(660, height, paper);
  const point3 target{0, 0.45, 0};
  const eye_view all[] = {{{-1.4, 1.1, 2.2}, target, {0, 1, 0}, red},
                          {{2.5, 0.9, 1.2}, target, {0.5, 1, 0}, blue},
                          {{0, 3.1, 0}, target, {0, 1, 0}, green}};
  const space s = seen_from({0.25, 0.75, 1}, {160, 222}, 55);
  shape floor{{-1.1, 0, -1.1}, {1.1, 0, -1.1}, {1.1, 0, 1.1}, {-1.1, 0, 1.1}};
  area(p, s.at(floor), {236, 234, 228, 255});
  draw_house(p, s, irg::identity_matrix<double, 4>(), ink);
  for (int i = 0; i < 3; ++i) {
    const auto& [eye, at, up, colour] = all[i];
    dashes(p, s.at(eye), s.at(at), 1.2, colour);
    camera(p, s, irg::look_at_frame(eye, at, up), 0.55, colour);
    arrow(p, s.at(eye), s.at(eye + irg::normalized(up) * 0.7), 1.8, grey);
    const int left = 340 + (i % 2) * (square + 8), top = 8 + (i / 2) * (square + 8);
    picture screen(square, square, white);
    const mat4 m = irg::perspective(irg::radians(36.0), 1.0, 0.1, 100) * irg::look_at(eye, at, up);
    const auto place = [&](const point3& q) {
      const point3 c = irg::to_cartesian(m * q);
      return point2{square / 2.0 * (1 + c.x), square / 2.0 * (1 - c.y)};
    };
    const auto seen = [&](const shape& part) {
      ring r;
      for (const point3& q : part) r.push_back(place(q));
      return r;
    };
    area(screen, seen(floor), {236, 234, 228, 255});
    for (const shape& part : house()) outline(screen, seen(part), 1.5, ink);
    outline(screen, {{1, 1}, {square - 1.0, 1}, {square - 1.0, square - 1.0}, {1, square - 1.0}}, 2, colour);
    paste(p, screen, left, top);
  }
  return p;
}

// ---- central and oblique projection

// Left the eye is the origin and z leads away from it; right the picture plane is z = 0 and the eye is at z = d.
inline picture rays() {
  constexpr int panel = 400, height = 260;
  picture p(2 * panel, height, paper);
  constexpr double d = 2;
  for (int i = 0; i < 2; ++i) {
    const auto origin = i ? irg::projection_origin::picture_plane : irg::projection_origin::eye;
    // Places are given with z to the viewer's eye for both: depth in front of the eye is d - z, the plane is at z = 0.
    const space s = seen_from({-1, 0.42, 0.62}, {panel * i + 196.0, 138}, 66);
    const auto own = [&](const point3& q) { return i ? q : point3{q.x, q.y, d - q.z}; };
    const auto drawn = [&](const point3& q) { return i ? q : point3{q.x, q.y, d - q.z}; };
    const point3 eye{0, 0, d};
    shape plane{{-0.9, -0.8, 0}, {0.9, -0.8, 0}, {0.9, 0.9, 0}, {-0.9, 0.9, 0}};
    const shape body{{-0.8, -0.7, -1.6}, {0.9, -0.7, -1.6}, {0.9, 0.4, -1.6}, {0.05, 1.1, -1.6}, {-0.8, 0.4, -1.6}};
    shape image;
    for (const point3& q : body) {
      const auto flat = irg::project_central(own(q), d, origin);
      image.push_back({flat->x, flat->y, 0});
    }
    area(p, s.at(body), with_opacity(blue, 60));
    outline(p, s.at(body), 2, blue);
    for (std::size_t k = 0; k < body.size(); ++k) stroke(p, {s.at(body[k]), s.at(image[k])}, 1, grey);
    area(p, s.at(plane), {250, 248, 242, 190});
    outline(p, s.at(plane), 1.2, grey);
    area(p, s.at(image), with_opacity(red, 70));
    outline(p, s.at(image), 2, red);
    for (const point3& q : image) stroke(p, {s.at(q), s.at(eye)}, 1, grey);
    for (int k = 0; k < 3; ++k) {
      point3 tip{};
      tip[k] = 0.9;
      axis(p, "xyz"[k], s.at(drawn({})), s.at(drawn(tip)), ink);
    }
    mark(p, s.at(eye), 5, ink);
  }
  return p;
}

// A cube with circles on its faces: factor 0, cabinet and cavalier at 45 degrees, cabinet at 30.
inline picture slants() {
  constexpr int panel = 190, height = 200;
  picture p(4 * panel, height, paper);
  const struct {
    double degrees, factor;
  } ways[] = {{45, 0},
              {45, irg::cabinet_factor<double>},
              {45, irg::cavalier_factor<double>},
              {30, irg::cabinet_factor<double>}};
  const irg::rgba8 faces[] = {{238, 226, 206, 255}, {206, 224, 206, 255}, {214, 226, 240, 255}};
  for (int i = 0; i < 4; ++i) {
    const auto& [degrees, factor] = ways[i];
    const oblique_view view({panel * i + 18.0 + 30 * (1 - factor), 178.0 - 24 * (1 - factor)}, 92, degrees, factor);
    for (int axis = 0; axis < 3; ++axis) {  // the right face, the upper one, the front; the back is at z = -1
      const auto place = [&](double u, double v) {
        point3 q{};
        q[axis] = axis == 2 ? 0 : 1;
        q[(axis + 1) % 3] = (axis + 1) % 3 == 2 ? -u : u;
        q[(axis + 2) % 3] = (axis + 2) % 3 == 2 ? -v : v;
        return view.at(q);
      };
      ring round;
      for (int k = 0; k < 48; ++k) {
        const double a = irg::two_pi<double> * k / 48;
        round.push_back(place(0.5 + 0.5 * irg::cos(a), 0.5 + 0.5 * irg::sin(a)));
      }
      if (factor == 0 && axis != 2) continue;
      const ring face{place(0, 0), place(1, 0), place(1, 1), place(0, 1)};
      area(p, face, faces[axis]);
      outline(p, face, 1.6, ink);
      outline(p, round, 1.6, axis == 2 ? red : blue);
    }
  }
  return p;
}

}  // namespace camera_pictures
