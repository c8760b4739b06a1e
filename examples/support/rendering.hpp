// SPDX-License-Identifier: MIT
// What programs that draw a model share: their options, the model, the camera and the lamp that stand where nothing else
// is said, and what a picture is reported with.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/mesh/crease_normals.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/render.hpp>
#include <irg/view/axonometry.hpp>

#include "command_line.hpp"
#include "model_input.hpp"
#include "picture_options.hpp"

namespace program {

/// The options that all these programs have, as --help shows them.
inline constexpr std::string_view render_options_help =
    R"(  --stats FILE.json    what was drawn and skipped, milliseconds per stage, a hash of the picture
  --size WxH           pixels (1280x720)
  --eye x,y,z          where the eye stands (so far from the centre that the whole model is seen)
  --target x,y,z       what it looks at, not the eye's own place (the centre of the model)
  --up x,y,z           what is up, not 0,0,0 (0,1,0); where it is along the view, an axis stands in
  --fov DEG            vertical angle of view (40)
  --project KIND       perspective, orthographic, isometric, dimetric, trimetric, oblique (seen from the
                       front, depth at half its length); the last four fix the direction of the view, and
                       --eye sets with --target how far away the eye is
  --hidden METHOD      zbuffer, painter (Newell, Newell and Sancha), warnock, bsp, raycast, raytrace, none; the
                       first six draw the same picture
  --shadows SWITCH     on, off (off), with --hidden raytrace: lamps throw shadows; drawn in style phong
  --mirror SHARE       0 to 1 (0), with --hidden raytrace: how much the model mirrors itself; in style phong
  --samples N          1 to 16 (1), with --hidden raytrace: N x N rays a pixel; in style phong
  --style STYLE        gouraud, wire, hidden-line, flat, phong; an .svg of hidden-line is made of lines
  --edges WHICH        sharp, outline, all: what --style hidden-line draws; sharp ones are borders, the outline and
                       edges sharper than --crease, or than 30 where that is not given
  --hidden-edges WHAT  none, dashed: what is drawn of hidden edges, with --style hidden-line
  --light x,y,z        a lamp's position; repeatable (one lamp at infinity, over the eye's left shoulder)
  --cull WHAT          back, none (back; none with --hidden-edges dashed: hidden edges are those of back faces)
  --crease DEG         edges sharper than this stay sharp where the model has no normals (60)
  --skip SWITCH        on, off: leave out work that cannot change the picture
  --threads N          1 to 256 (1)
)";

/// Ends the program where the eye is at the target.
inline void expect_direction(const command_line& line, const irg::point<double, 3>& eye,
                             const irg::point<double, 3>& target) {
  if (eye == target) line.fail("the eye is at the target, so that there is no direction to look in");
}

/// The kinds of --project.
enum class view_kind { perspective, orthographic, isometric, dimetric, trimetric, oblique };

/// The names of --edges.
enum class edge_choice { sharp, outline, all };

/// The names of --hidden.
enum class hidden_name { zbuffer, painter, warnock, bsp, raycast, raytrace, none };

/// What the options say. A picture's name is what `-o` gives.
struct render_settings {
  std::string model, out, stats;
  picture_size size{1280, 720};
  int threads = 1;
  std::optional<irg::point<double, 3>> eye, target;
  irg::vec<double, 3> up{0, 1, 0};
  double angle = 40, crease = 60;  // degrees
  double edge_crease = 30;  // degrees, of the edges that --style hidden-line draws; --crease sets it, too
  edge_choice edges = edge_choice::sharp;  // with hidden_line
  view_kind project = view_kind::perspective;
  hidden_name hidden = hidden_name::zbuffer;
  std::vector<irg::light<double>> lights;
  irg::render_options options;
  bool hidden_line = false;  // in place of options.style
  bool dashed = false;  // hidden edges, with hidden_line
  bool says_culling = false;  // --cull was given
  bool shadows = false;
  bool fit = false;  // the model into [-1, 1]
  double mirror = 0;
  int samples = 1;

  /// Whether rays go on from what is seen.
  bool follows_rays() const { return shadows || mirror > 0 || samples > 1; }

  /// Reads the value of --style.
  void read_style(command_line& line) {
    const auto choice = line.choice("--style", {"gouraud", "wire", "hidden-line", "flat", "phong"});
    hidden_line = choice == 2;
    options.style = std::array{irg::picture_style::gouraud, irg::picture_style::wire, irg::picture_style::wire,
                               irg::picture_style::flat, irg::picture_style::phong}[choice];
  }

  /// Reads the value of the option `word`, or takes the word as the model.
  void read(command_line& line, std::string_view word) {
    const auto triple = [&] {
      const auto n = line.numbers(word, 3);
      return irg::point<double, 3>{n[0], n[1], n[2]};
    };
    if (word == "-o")
      out = line.file_of(word);
    else if (word == "--stats")
      stats = line.file_of(word);
    else if (word == "--size")
      size = read_size(line);
    else if (word == "--eye")
      eye = triple();
    else if (word == "--target")
      target = triple();
    else if (word == "--up") {
      up = irg::to_vec(triple());
      if (up == irg::vec<double, 3>{}) line.fail("option --up needs a direction, not 0,0,0");
    } else if (word == "--fov") {
      angle = line.numbers(word, 1)[0];
      if (!(angle >= 1e-6 && angle < 180))
        line.fail("option --fov needs an angle from 0.000001 to less than 180 degrees");
    } else if (word == "--project")
      project = static_cast<view_kind>(
          line.choice(word, {"perspective", "orthographic", "isometric", "dimetric", "trimetric", "oblique"}));
    else if (word == "--hidden")
      hidden = static_cast<hidden_name>(
          line.choice(word, {"zbuffer", "painter", "warnock", "bsp", "raycast", "raytrace", "none"}));
    else if (word == "--edges")
      edges = static_cast<edge_choice>(line.choice(word, {"sharp", "outline", "all"}));
    else if (word == "--hidden-edges")
      dashed = line.choice(word, {"none", "dashed"}) == 1;
    else if (word == "--style")
      read_style(line);
    else if (word == "--light")
      lights.push_back({irg::to_homogeneous(triple()), {1, 1, 1}});
    else if (word == "--cull") {
      options.culling =
          std::array{irg::face_culling::back, irg::face_culling::none}[line.choice(word, {"back", "none"})];
      says_culling = true;
    } else if (word == "--crease") {
      crease = line.numbers(word, 1)[0];
      if (!(crease >= 0 && crease <= 180)) line.fail("option --crease needs an angle from 0 to 180 degrees");
      edge_crease = crease;
    } else if (word == "--skip")
      options.skip = std::array{irg::skip_options{}, irg::skip_nothing}[line.choice(word, {"on", "off"})];
    else if (word == "--shadows")
      shadows = line.choice(word, {"on", "off"}) == 0;
    else if (word == "--mirror") {
      mirror = line.numbers(word, 1)[0];
      if (!(mirror >= 0 && mirror <= 1)) line.fail("option --mirror needs a share from 0 to 1");
    } else if (word == "--samples")
      samples = line.integer(word, 1, 16);
    else if (word == "--threads")
      threads = line.integer(word, 1, 256);
    else if (word.size() > 1 && word[0] == '-')
      line.refuse(word);
    else if (model.empty())
      model = word;
    else
      line.fail("one model at a time, not also '" + std::string(word) + "'");
  }

  /// Ends the program when two of its files would be one, and where options contradict each other.
  void finish(const command_line& line) const {
    if (one_file(out, stats)) line.fail("the picture and the statistics need two files, not both: " + out);
    if (one_file(out, model) || one_file(stats, model)) line.fail("the model would be overwritten: " + model);
    if (eye && target) expect_direction(line, *eye, *target);
    if (follows_rays() && (hidden != hidden_name::raytrace || hidden_line || options.style == irg::picture_style::wire))
      line.fail("options --shadows, --mirror and --samples need --hidden raytrace and a style of faces");
  }
};

/// Models whose squares would leave the range of doubles are drawn at another size, which changes no pixel: everything
/// is multiplied by one power of two that brings the model near 1.
inline void bring_into_range(irg::mesh<double>& shape, render_settings& s) {
  double largest = 0;
  for (const auto& p : shape.positions) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (largest == 0 || (largest > 1e-100 && largest < 1e100)) return;
  const int exponent = -std::ilogb(largest);
  const auto scale = [&](auto& p) {
    p.x = std::ldexp(p.x, exponent), p.y = std::ldexp(p.y, exponent), p.z = std::ldexp(p.z, exponent);
  };
  for (auto& p : shape.positions) scale(p);
  if (s.eye) scale(*s.eye);
  if (s.target) scale(*s.target);
  for (auto& l : s.lights) scale(l.position);
}

/// The model that the options name, which has to have faces, with normals everywhere; a very large or very small one,
/// and with it what the options place, at another size.
inline irg::mesh<double> load_model(const command_line& line, render_settings& s) {
  auto mesh = read_model(line, s.model);
  if (mesh.face_count() == 0) line.fail("the model has no faces: " + s.model);
  if (s.fit) fit_model(line, mesh, s.model);
  bring_into_range(mesh, s);
  irg::assign_crease_normals(mesh, irg::radians(s.crease));
  return mesh;
}

/// Whether a kind of view has a direction of its own.
inline bool fixes_direction(view_kind k) { return k != view_kind::perspective && k != view_kind::orthographic; }

/// From the target towards the eye, of length 1 where the kind of view fixes it.
inline irg::vec<double, 3> direction_of(const render_settings& s) {
  switch (s.project) {
    case view_kind::isometric: return irg::with_axis_up(irg::isometric<double>().to_viewer, s.up);
    case view_kind::dimetric: return irg::with_axis_up(irg::dimetric<double>().to_viewer, s.up);
    case view_kind::trimetric: return irg::with_axis_up(irg::trimetric<double>().to_viewer, s.up);
    case view_kind::oblique: return irg::with_axis_up(irg::vec<double, 3>{0, 0, 1}, s.up);
    default: return {1, 0.8, 1.6};
  }
}

/// Where the options put the camera; so far away that the whole model is seen where they do not say. Its eye may be at
/// its target.
inline irg::camera<double> placed_camera(const command_line& line, const render_settings& s,
                                         const irg::mesh<double>& shape) {
  const auto ball = irg::bounding_sphere_of(shape);
  const double angle = irg::radians(s.angle), aspect = static_cast<double>(s.size.width) / s.size.height;
  irg::camera<double> c;
  c.up = s.up;
  c.vertical_angle = angle;
  c.projection = s.project == view_kind::perspective ? irg::projection_kind::perspective
                 : s.project == view_kind::oblique   ? irg::projection_kind::oblique
                                                     : irg::projection_kind::orthographic;
  const irg::vec<double, 3> direction = direction_of(s);
  c = irg::camera_around(c, ball.centre, ball.radius, direction, aspect);
  if (s.target) c.target = *s.target;
  if (s.eye) c.eye = *s.eye;
  // Technical drawings look along their own direction, whatever eye and target are given.
  if (fixes_direction(s.project) && (s.eye || s.target)) c.eye = c.target + direction * irg::length(c.eye - c.target);
  c = irg::with_depth_range(c, ball.centre, ball.radius);
  const double reach = irg::length(c.eye - ball.centre) + ball.radius + irg::length(c.target - ball.centre);
  if (!(reach < 1e150)) line.fail("the eye or the target is too far from the model for a picture");
  return c;
}

/// The same; where the options put the eye at the target, or the one at the default of the other, the program ends.
inline irg::camera<double> camera_of(const command_line& line, const render_settings& s,
                                     const irg::mesh<double>& shape) {
  const irg::camera<double> c = placed_camera(line, s, shape);
  if (s.eye || s.target) expect_direction(line, c.eye, c.target);
  return c;
}

/// Over the eye's left shoulder, at infinity.
inline irg::light<double> shoulder_light(const irg::camera<double>& c) {
  const auto view = irg::look_at(c.eye, c.target, c.up);
  const auto axis = [&](int row) { return irg::vec<double, 3>{view(row, 0), view(row, 1), view(row, 2)}; };
  const auto d = axis(2) + axis(1) * 0.7 - axis(0) * 0.7;
  return {{d.x, d.y, d.z, 0.0}, {1, 1, 1}};
}

/// Milliseconds from lap to lap.
class stopwatch {
public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return ms;
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Milliseconds of the stages.
struct timings {
  double load = 0, stage[4] = {}, write = 0;
};

/// Draws the scene into the picture and the statistics that the options name, one of them at least.
void draw_scene(const command_line& line, const render_settings& s, const irg::scene<double>& world, timings ms);

}  // namespace program
