// SPDX-License-Identifier: MIT
// Pictures of the course's view transform, step by step, and of a camera that goes round its target.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/raster/draw_line.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/view/polar_camera.hpp>
#include <irg/view/textbook/project_perspective.hpp>
#include <irg/view/textbook/view_transform.hpp>

#include "enlarged.hpp"

namespace viewing {

using namespace enlarging;
using point2 = irg::point<double, 2>;
using point3 = irg::point<double, 3>;
constexpr irg::rgba8 blue{72, 122, 186, 255}, red{204, 96, 72, 255}, green{84, 140, 84, 255};

// The few letters that the pictures need, 5 x 7 dots, a row in five bits.
inline void letter(picture& p, char c, irg::cell at, int size, irg::rgba8 colour) {
  constexpr std::pair<char, std::array<std::uint8_t, 7>> glyphs[] = {
      {'x', {0, 0, 17, 10, 4, 10, 17}},    {'y', {0, 0, 17, 17, 15, 1, 14}},    {'z', {0, 0, 31, 2, 4, 8, 31}},
      {'T', {31, 4, 4, 4, 4, 4, 4}},       {'P', {30, 17, 17, 30, 16, 16, 16}}, {'O', {14, 17, 17, 17, 17, 17, 14}},
      {'G', {14, 17, 16, 23, 17, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},      {'2', {14, 17, 1, 2, 4, 8, 31}},
      {'3', {30, 1, 1, 14, 1, 1, 30}},     {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
  };
  for (const auto& [name, rows] : glyphs)
    if (name == c)
      for (int y = 0; y < 7 * size; ++y)
        for (int x = 0; x < 5 * size; ++x)
          if ((rows[static_cast<std::size_t>(y / size)] >> (4 - x / size)) & 1)
            irg::fill_span(p, {at.y + y, at.x + x, at.x + x + 1}, colour);
}
inline void text(picture& p, std::string_view word, irg::cell at, int size, irg::rgba8 colour) {
  for (const char c : word) {
    letter(p, c, at, size, colour);
    at.x += 6 * size;
  }
}

inline irg::cell cell_of(const point2& q) { return {static_cast<int>(q.x + 0.5), static_cast<int>(q.y + 0.5)}; }
inline void stroke(picture& p, const point2& a, const point2& b, irg::rgba8 colour, double width = 1.3) {
  irg::draw_line_aa(p, a, b, colour, irg::line_aa_options{.width = static_cast<int>(width * irg::one_pixel)});
}

// A house with a door: nothing about it is symmetrical enough to hide a mirror image.
struct edge {
  point3 a, b;
  bool is_door;
};
inline std::vector<edge> house() {
  const point3 v[] = {{-0.5, -0.4, 0},  {0.5, -0.4, 0},  {0.5, 0.4, 0},    {-0.5, 0.4, 0}, {-0.5, -0.4, 0.5},
                      {0.5, -0.4, 0.5}, {0.5, 0.4, 0.5}, {-0.5, 0.4, 0.5}, {-0.5, 0, 0.9}, {0.5, 0, 0.9}};
  const std::pair<int, int> e[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {6, 7}, {0, 4}, {1, 5}, {2, 6},
                                   {3, 7}, {4, 8}, {7, 8}, {5, 9}, {6, 9}, {8, 9}, {5, 6}, {4, 7}};
  std::vector<edge> edges;
  for (const auto& [a, b] : e) edges.push_back({v[a], v[b], false});
  const point3 door[] = {{0.5, 0.05, 0}, {0.5, 0.05, 0.35}, {0.5, 0.3, 0.35}, {0.5, 0.3, 0}, {0.5, 0.05, 0}};
  for (int i = 0; i < 4; ++i) edges.push_back({door[i], door[i + 1], true});
  return edges;
}

constexpr int side = 230;

// One step: the scene as the matrix leaves it, among the axes of the system that it is then measured in.
inline picture step(const irg::mat<double, 4, 4>& m, const point3& eye, const point3& target, std::string_view name) {
  picture p(side, side, paper);
  const auto flat = [](const point3& q) {  // x towards the reader, y to the right, z up
    return point2{44 * q.y - 22 * q.x, -44 * q.z + 17 * q.x};
  };
  const point3 origin{0, 0, 0}, tip[] = {{1.5, 0, 0}, {0, 1.2, 0}, {0, 0, 1.2}};
  const point3 o = irg::textbook::transform_row(eye, m), g = irg::textbook::transform_row(target, m);
  point2 low = flat(origin), high = low;
  const auto include = [&](const point3& q) {
    for (int i = 0; i < 2; ++i) {
      low[i] = irg::minimum(low[i], flat(q)[i]);
      high[i] = irg::maximum(high[i], flat(q)[i]);
    }
  };
  for (const point3& q : {o, g, tip[0], tip[1], tip[2]}) include(q);
  for (const edge& e : house()) include(irg::textbook::transform_row(e.a, m));
  const irg::vec<double, 2> shift{side / 2.0 - (low.x + high.x) / 2, side / 2.0 - (low.y + high.y) / 2};
  const auto place = [&](const point3& q) { return flat(q) + shift; };
  for (int i = 0; i < 3; ++i) {
    stroke(p, place(origin), place(tip[i]), green, 1.6);
    const irg::cell at = cell_of(place(tip[i]));
    letter(p, "xyz" [i], { at.x + (i == 1 ? 4 : -3), at.y + (i == 0 ? 3 : i == 1 ? -7 : -16) }, 2, green);
  }
  stroke(p, place(o), place(g), red);
  for (const edge& e : house())
    stroke(p, place(irg::textbook::transform_row(e.a, m)), place(irg::textbook::transform_row(e.b, m)),
           e.is_door ? blue : ink);
  dot(p, cell_of(place(o)), 4, red);
  dot(p, cell_of(place(g)), 3, red);
  letter(p, 'O', {cell_of(place(o)).x + 7, cell_of(place(o)).y - 16}, 2, red);
  letter(p, 'G', {cell_of(place(g)).x + 7, cell_of(place(g)).y - 4}, 2, red);
  text(p, name, {8, 8}, 2, ink);
  return p;
}

// What the eye sees: x to the right, y up.
template <class Project>
picture seen(const irg::mat<double, 4, 4>& t, std::string_view name, const Project& project) {
  picture p(side, side, paper);
  const auto place = [&](const point3& q) {
    const point2 s = project(irg::textbook::transform_row(q, t));
    return point2{side / 2.0 + 120 * s.x, side / 2.0 - 120 * s.y};
  };
  stroke(p, {side / 2.0, side / 2.0}, {side / 2.0 + 70, side / 2.0}, green, 1.6);
  stroke(p, {side / 2.0, side / 2.0}, {side / 2.0, side / 2.0 - 70}, green, 1.6);
  letter(p, 'x', {side / 2 + 74, side / 2 - 8}, 2, green);
  letter(p, 'y', {side / 2 - 5, side / 2 - 90}, 2, green);
  for (const edge& e : house()) stroke(p, place(e.a), place(e.b), e.is_door ? blue : ink);
  dot(p, {side / 2, side / 2}, 3, red);
  text(p, name, {8, 8}, 2, ink);
  return p;
}

inline picture steps() {
  const point3 eye{1.6, 2.3, 1.5}, target{0, 0, 0.3};
  const auto s = irg::textbook::view_transform_steps(eye, target);
  const irg::mat<double, 4, 4> parts[] = {irg::identity_matrix<double, 4>(), s.t1, s.t2, s.t3, s.t4, s.t5};
  const std::string_view names[] = {"", "T1", "T1T2", "T1T2T3", "T1T2T3T4", "T"};
  constexpr int gap = 10;
  picture big(4 * side + 3 * gap, 2 * side + gap, {255, 255, 255, 255});
  irg::mat<double, 4, 4> m = parts[0];
  for (int i = 0; i < 6; ++i) {
    m = m * parts[i];
    paste(big, step(m, eye, target, names[i]), (i % 4) * (side + gap), (i / 4) * (side + gap));
  }
  paste(big, seen(m, "TP", [&](const point3& q) { return *irg::textbook::project_perspective(q, s.h); }),
        2 * (side + gap), side + gap);
  paste(big, seen(m, "T", [](const point3& q) { return irg::textbook::project_parallel(q); }), 3 * (side + gap),
        side + gap);
  return big;
}

// Cameras about a target, at several elevations: their positions and axes, seen from aside.
inline picture orbit() {
  picture p(640, 440, paper);
  const auto view = irg::view_matrix(irg::frame_of(irg::polar_camera<double>{{0, 0.1, 0}, 5, 0.55, 0.3}));
  const auto place = [&](const point3& q) {
    const point3 c = transform_point(view, q);
    return point2{320 + 830 * c.x / -c.z, 215 - 830 * c.y / -c.z};
  };
  const auto at = [](double azimuth, double elevation) {
    return irg::to_point(irg::polar_to_cartesian(irg::polar_coordinates<double>{1, azimuth, elevation}));
  };
  constexpr double pi = irg::pi<double>;
  for (int i = 0; i < 72; ++i) {
    const double a = 2 * pi * i / 72, b = 2 * pi * (i + 1) / 72;
    stroke(p, place(at(a, 0)), place(at(b, 0)), pale, 2);
    if (a <= pi + 0.01) stroke(p, place(at(0.9, a - pi / 2)), place(at(0.9, b - pi / 2)), pale, 2);
  }
  const point3 centre{0, 0, 0}, tip[] = {{0.45, 0, 0}, {0, 0.45, 0}, {0, 0, 0.45}};
  for (int i = 0; i < 3; ++i) {
    stroke(p, place(centre), place(tip[i]), ink, 1.6);
    const irg::cell c = cell_of(place(tip[i]));
    letter(p, "xyz" [i], { c.x + 4, c.y - 6 }, 2, ink);
  }
  for (const auto& [azimuth, elevation] : {std::pair{0.9, 0.0}, {0.9, 0.8}, {0.9, pi / 2}, {2.4, 0.0}, {-0.7, 0.0}}) {
    const auto f = irg::frame_of(irg::polar_camera<double>{centre, 1, azimuth, elevation});
    const auto arm = [&](const irg::vec<double, 3>& axis, irg::rgba8 colour) {
      stroke(p, place(f.position), place(f.position + axis * 0.24), colour, 2);
    };
    arm(f.right, red);
    arm(f.up, green);
    arm(f.forward, blue);
    dot(p, cell_of(place(f.position)), 4, ink);
  }
  return p;
}

}  // namespace viewing
