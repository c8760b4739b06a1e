// SPDX-License-Identifier: MIT
// Curves: the weights of both forms of a Bezier curve, steps of equal length, frames. Included by pictures.cpp.
#pragma once

#include <array>
#include <vector>

#include <irg/curve/arc_length.hpp>
#include <irg/curve/bezier_edge_form.hpp>
#include <irg/curve/bspline_fit.hpp>
#include <irg/curve/constant_speed.hpp>
#include <irg/curve/curve_frame.hpp>
#include <irg/curve/flatten.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/render/render.hpp>

#include "sketch.hpp"

namespace curve_pictures {

using namespace sketching;

constexpr irg::rgba8 families[] = {blue, red, green, {190, 140, 40, 255}, {150, 96, 160, 255}, {92, 142, 196, 255}};

// The cubic weights of both forms over t: left Bernstein's, right Bezier's.
inline picture weights() {
  picture p(1320, 560, paper);
  for (const bool by_edges : {false, true}) {
    const double left = by_edges ? 700 : 40, bottom = 520, size = 480;
    outline(p, {{left, bottom}, {left, bottom - size}, {left + 580, bottom - size}, {left + 580, bottom}}, 2, grey);
    for (std::size_t i = 0; i <= 3; ++i) {
      ring line;
      for (int k = 0; k <= 100; ++k) {
        std::array<double, 4> value{};
        const double t = k / 100.0;
        by_edges ? irg::bezier_weights<double>(t, value) : irg::bernstein_basis<double>(t, value);
        line.push_back({left + 580 * t, bottom - size * value[i]});
      }
      stroke(p, line, 5, families[i]);
    }
  }
  return halved(p);
}

// A cubic with dots at equal steps of its parameter (blue, above) and at equal steps of its length (red, below).
inline void equal_steps(picture& p) {
  for (const bool by_length : {false, true}) {
    const double down = by_length ? 270 : 0;
    const std::array<point2, 4> cubic{point2{40, 260 + down}, {60, -60 + down}, {120, 70 + down}, {560, 240 + down}};
    const auto speed = [&](double t) { return irg::length(irg::bezier_sample(cubic, t).derivative); };
    std::array<double, 33> lengths{};
    const auto table = irg::arc_lengths<double>(speed, 0, 1, lengths);
    ring line;
    for (int k = 0; k <= 100; ++k) line.push_back(irg::bezier_point(cubic, k / 100.0));
    stroke(p, line, 3, grey);
    for (int k = 0; k <= 20; ++k) {
      const double t = by_length ? irg::parameter_at_length(speed, table, table.length() * k / 20) : k / 20.0;
      mark(p, irg::bezier_point(cubic, t), 6, by_length ? red : blue);
    }
  }
}

// Normals (red) and binormals (blue) carried along a rising curve without turning about it.
inline void carried_frames(picture& p) {
  const oblique_view view({930, 290}, 150);
  const auto place = [](double t) {
    return point3{1.6 * irg::cos(t), 1.1 * irg::sin(t) + 0.5 * irg::sin(3 * t), 0.9 * irg::cos(2 * t)};
  };
  constexpr int steps = 48;
  const auto at = [&](int k) { return place(irg::two_pi<double> * k / steps); };
  auto frame = *irg::frame_with_up(at(1) - at(-1), vec3{0, 0, 1});
  ring line{view.at(at(0))};
  for (int k = 1; k <= steps; ++k) line.push_back(view.at(at(k)));
  stroke(p, line, 4, ink);
  for (int k = 0; k < steps; ++k) {
    const point2 foot = view.at(at(k));
    stroke(p, {foot, view.at(at(k) + 0.4 * frame.normal)}, 3, red);
    stroke(p, {foot, view.at(at(k) + 0.4 * frame.binormal)}, 3, blue);
    frame = irg::rotation_minimizing_frame(frame, at(k + 1) - at(k), at(k + 2) - at(k));
  }
}

inline picture paths() {
  picture p(1320, 580, paper);
  equal_steps(p);
  carried_frames(p);
  return halved(p);
}

// One curve (pale) as polylines that stay within 16, 4 and 1 pixels of it.
inline picture flattened() {
  picture p(1320, 400, paper);
  for (int i = 0; i < 3; ++i) {
    const double left = 440.0 * i;
    const std::array<point2, 5> curve{
        point2{left + 30, 360}, {left + 60, -260}, {left + 250, 780}, {left + 330, -260}, {left + 410, 350}};
    ring smooth, line;
    for (int k = 0; k <= 200; ++k) smooth.push_back(irg::bezier_point(curve, k / 200.0));
    stroke(p, smooth, 12, pale);
    std::array<point2, 15> scratch{};
    irg::flatten(curve, i == 0 ? 16 : i == 1 ? 4 : 1, scratch, [&](const point2& q) { line.push_back(q); });
    stroke(p, line, 3, red);
    for (const point2& q : line) mark(p, q, 6, ink);
  }
  return halved(p);
}

// Left a cubic through points: parameters like distances (red), at equal steps (blue). Right 60 scattered points and
// the curve of 8 control points nearest to them.
inline picture fitted() {
  picture p(1320, 420, paper);
  const auto draw = [&](const ring& points, irg::fit_spacing spacing, std::size_t count, irg::rgba8 colour) {
    std::vector<double> places(points.size()), knots(count + 4), scratch(4);
    ring control(count), line;
    if (irg::parametrize(std::span<const point2>(points), spacing, places) != irg::bspline_fit_status::ok)
      return control;
    irg::fit_knots(std::span<const double>(places), 3, count, knots);
    const auto u = *irg::make_bspline_knots(std::span<const double>(knots), 3);
    static_cast<void>(
        irg::bspline_least_squares(u, places, std::span<const point2>(points), irg::fit_ends::through, control));
    for (int k = 0; k <= 240; ++k) line.push_back(*irg::bspline_point(u, control, k / 240., scratch));
    stroke(p, line, 5, colour);
    return control;
  };
  const ring few{{60, 330}, {150, 90}, {180, 80}, {210, 90}, {330, 340}, {480, 120}, {600, 320}};
  draw(few, irg::fit_spacing::uniform, few.size(), blue);
  draw(few, irg::fit_spacing::chord_length, few.size(), red);
  for (const point2& q : few) mark(p, q, 8, ink);
  ring many;
  for (int k = 0; k < 60; ++k) {
    const double t = k / 59.;
    many.push_back({710 + 560 * t + 16 * irg::sin(37. * k * k),
                    210 + 150 * irg::sin(8 * t) * (1 - t / 2) + 24 * irg::cos(91. * k * k)});
  }
  many.front() = {710, 210};
  for (const point2& q : many) disc(p, q, 6, grey);
  const ring control = draw(many, irg::fit_spacing::uniform, 8, red);
  stroke(p, control, 2, blue);
  for (const point2& q : control) mark(p, q, 7, blue);
  return halved(p);
}

// Eight pictures at equal distances along a curve around the teapot, in wire form without back faces.
inline picture flight() {
  const std::array<point3, 5> way{point3{7, 1, 5}, {-3, 9, 9}, {-12, 2, 2}, {-5, -3, -8}, {6, 3, -7}};
  const auto sample = [&](double t) { return irg::bezier_sample(way, t); };
  std::array<double, 65> lengths{};
  const irg::constant_speed motion(sample, 0., 1., std::span<double>(lengths));
  irg::scene<double> world;
  world.objects.push_back({irg::shape_teapot<double>({4, irg::teapot_bottom::with})});
  irg::render_options options;
  options.style = irg::picture_style::wire;
  picture all(660, 250, paper), small(162, 122);
  irg::image<float> depth(162, 122);
  for (int k = 0; k < 8; ++k) {
    world.view.eye = motion.at(k / 7.).point;
    world.view.target = {0.2, 1.5, 0};
    world.view = irg::with_depth_range(world.view, point3{0.2, 1.5, 0}, 4.);
    irg::render(world, {small, depth}, options);
    for (int y = 0; y < 122; ++y)
      for (int x = 0; x < 162; ++x) all(2 + 165 * (k % 4) + x, 2 + 125 * (k / 4) + y) = small(x, y);
  }
  return all;
}

}  // namespace curve_pictures
