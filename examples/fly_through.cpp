// SPDX-License-Identifier: MIT
// fly_through - a body in wire form, seen from an eye that moves along a curve, or with a target or the body moved so.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/curve/bspline_fit.hpp>
#include <irg/curve/constant_speed.hpp>
#include <irg/io/apng.hpp>
#include <irg/render/render.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/rendering.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(fly_through - a body in wire form without back faces, along a curve at constant speed, or by its parameter

usage: fly_through MODEL [options]
MODEL is a file or teapot, cube, sphere, torus. Reads n, at least 1, and the n + 1 points of the path, 3 numbers each,
from standard input, and prints
  pictures: N          how many there are
  length: L            of the path

  -o OUT.png           the animated picture
  --frames NAME        each picture as NAME0001.png, NAME0002.png, ...
  --move WHAT          eye (default), target, body: what is moved; a body's centre follows the path
  --look WHERE         target (default), ahead: where a moved eye looks
  --curve KIND         through (default): a cubic spline through the points; bspline: the points control a cubic
                       spline; bezier: they control a Bezier curve
  --pictures N         1 to 10000 (60), equally far apart along the curve
  --steps DT           in their place a picture at each parameter t = k DT while it is at most 1, of a curve that t leads
                       from 0 to 1 through: over 0, at most 1, and at most 10000 pictures
  --delay MS           how long each is shown, 0 to 65535 (40)
  --size WxH           pixels (320x240)
  --eye x,y,z --target x,y,z --up x,y,z --fov DEG --cull back|none --threads N    as in render
  --input FILE         read the numbers from FILE
  --list               print a line k x y z, the place of what is moved, for each picture instead

Progress goes to standard error, a line for each picture.
)";

using point = irg::point<double, 3>;
using vector = irg::vec<double, 3>;
enum class moved { eye, target, body };
enum class path_kind { through, bspline, bezier };

struct settings : program::render_settings {
  std::string input, frames;
  moved what = moved::eye;
  path_kind path = path_kind::through;
  bool ahead = false, list = false;
  int pictures = 60, delay = 40;
  double step = 0;  // of the parameter; 0 for constant speed
};

std::string frame_name(const settings& s, std::size_t k) {
  std::string number = std::to_string(k);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  return s.frames + number + ".png";
}

// The value of --steps.
double read_step(program::command_line& line) {
  const double step = line.numbers("--steps", 1)[0];
  if (!(step > 0 && step <= 1)) line.fail("option --steps needs a number over 0 and at most 1");
  if (step * 10000 <= 1) line.fail("option --steps makes more than 10000 pictures");
  return step;
}

settings read_settings(program::command_line& line) {
  settings s;
  bool counts_pictures = false;
  s.size = {320, 240};
  s.options.style = irg::picture_style::wire;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--frames")
      s.frames = line.file_of(word);
    else if (word == "--input")
      s.input = line.file_of(word);
    else if (word == "--list")
      s.list = true;
    else if (word == "--move")
      s.what = static_cast<moved>(line.choice(word, {"eye", "target", "body"}));
    else if (word == "--look")
      s.ahead = line.choice(word, {"target", "ahead"}) == 1;
    else if (word == "--curve")
      s.path = static_cast<path_kind>(line.choice(word, {"through", "bspline", "bezier"}));
    else if (word == "--pictures") {
      s.pictures = line.integer(word, 1, 10000);
      counts_pictures = true;
    } else if (word == "--steps")
      s.step = read_step(line);
    else if (word == "--delay")
      s.delay = line.integer(word, 0, 65535);
    else if (word == "-o" || word == "--size" || word == "--eye" || word == "--target" || word == "--up" ||
             word == "--fov" || word == "--cull" || word == "--threads" || !word.starts_with('-'))
      s.read(line, word);
    else
      line.refuse(word);
  }
  if (s.step > 0 && counts_pictures) line.fail("options --pictures and --steps exclude each other");
  for (s.pictures = s.step > 0 ? 0 : s.pictures; s.step > 0 && s.pictures * s.step <= 1;) ++s.pictures;
  if (s.model.empty()) line.fail("no model given; --help tells how");
  if (s.out.empty() && s.frames.empty() && !s.list) line.fail("nothing to write; -o or --frames names it");
  if (!s.out.empty() && irg::image_format_of_name(s.out) != irg::image_format::png)
    line.fail("the animation's name must end in .png, not: " + s.out);
  if (program::one_file(s.out, s.input)) line.fail("the input would be overwritten: " + s.input);
  for (int k = 1; !s.frames.empty() && k <= s.pictures; ++k) {
    const std::string file = frame_name(s, static_cast<std::size_t>(k));
    if (program::one_file(file, s.input)) line.fail("the input would be overwritten: " + file);
    if (program::one_file(file, s.model)) line.fail("the model would be overwritten: " + file);
    if (program::one_file(file, s.out)) line.fail("the animation and a picture need two files, not both: " + file);
  }
  s.finish(line);
  return s;
}

std::vector<point> read_points(const program::command_line& line, const std::string& input, int most) {
  program::number_input in(line, input);
  program::number_input::prompt_if_terminal("n: ", input);
  const int n = in.integer("n", 1, most);
  std::vector<point> points;
  for (int k = 0; k <= n; ++k) {
    const std::string name = "point " + std::to_string(k);
    program::number_input::prompt_if_terminal("x y z of " + name + ": ", input);
    point p{};
    for (int i = 0; i < 3; ++i) p[i] = in.number(std::string(1, "xyz"[i]) + " of " + name);
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(p[i]) < 1e100)) in.fail_at_word(name + " is too far away");
    points.push_back(p);
  }
  in.expect_end();
  return points;
}

irg::mesh<double> load_model(const program::command_line& line, const std::string& name) {
  auto shape = program::read_model(line, name);
  if (shape.face_count() == 0) line.fail("the model has no faces: " + name);
  double largest = 0;
  for (const auto& p : shape.positions)
    for (int i = 0; i < 3; ++i) largest = std::fmax(largest, std::abs(p[i]));
  if (!(largest > 1e-100 && largest < 1e100)) line.fail("the model is too large or too small: " + name);
  return shape;
}

// The path as a spline: knots and control points.
class path {
public:
  path(const program::command_line& line, std::vector<point> points, path_kind kind) : points_(std::move(points)) {
    const int n = static_cast<int>(points_.size()) - 1;
    degree_ = kind == path_kind::bezier || n < 3 ? n : 3;
    const auto count = points_.size(), order = static_cast<std::size_t>(degree_) + 1;
    knots_.resize(count + order);
    std::vector<double> places(count);
    if (kind == path_kind::through) {
      if (irg::parametrize(std::span<const point>(points_), irg::fit_spacing::centripetal, places) !=
          irg::bspline_fit_status::ok)
        line.fail("all points of the path are one");
      irg::fit_knots(std::span<const double>(places), degree_, count, knots_);
    } else {
      for (std::size_t k = 0; k < knots_.size(); ++k)
        knots_[k] = k < order    ? 0
                    : k >= count ? static_cast<double>(count - order + 1)
                                 : static_cast<double>(k - order + 1);
    }
    const auto knots = irg::make_bspline_knots(std::span<const double>(knots_), degree_);
    if (!knots) line.fail("successive points of the path are one");
    if (kind == path_kind::through) {
      const std::vector<point> given = points_;
      if (!irg::bspline_interpolate(*knots, places, std::span<const point>(given), points_))
        line.fail("successive points of the path are one");
    }
    room_.resize(2 * order);
  }
  irg::bspline_knots<double, irg::degree_at_run_time> knots() const {
    return {std::span<const double>(knots_), degree_};
  }
  irg::curve_sample<point> operator()(double t) const {
    return *irg::bspline_sample(knots(), points_, t, std::span<vector>(room_));
  }
  std::size_t pieces() const { return 16 * (knots_.size() - static_cast<std::size_t>(degree_)); }

private:
  std::vector<point> points_;
  std::vector<double> knots_;
  mutable std::vector<vector> room_;
  int degree_ = 1;
};

irg::camera<double> camera_at(const settings& s, irg::camera<double> view, const irg::curve_sample<point>& place) {
  if (s.what == moved::eye) view.eye = place.point;
  if (s.what == moved::target) view.target = place.point;
  if (s.what == moved::eye && (s.ahead || view.target == view.eye))
    if (const auto along = irg::try_normalized(place.derivative)) view.target = view.eye + *along;
  return view;
}

// The numbered files, removed again where not all of them can be written, for want of memory, too.
class numbered_files {
public:
  explicit numbered_files(const settings& s) : settings_(s) {}
  numbered_files(const numbered_files&) = delete;
  numbered_files& operator=(const numbered_files&) = delete;
  ~numbered_files() { remove(); }
  void write(const program::command_line& line, const irg::image<irg::rgba8>& picture) {
    const std::string file = frame_name(settings_, names_.size() + 1);
    if (const auto saved = irg::save_image(file, picture); !saved)
      fail(line, std::string(saved.error().message) + ": " + file);
    names_.push_back(file);
  }
  [[noreturn]] void fail(const program::command_line& line, const std::string& what) const {
    remove();
    line.fail(what);
  }
  void remove() const {
    for (const std::string& file : names_) program::remove_written(file);
  }
  void keep() { names_.clear(); }

private:
  const settings& settings_;
  std::vector<std::string> names_{};
};

void draw(const program::command_line& line, const settings& s, irg::scene<double>& world, const point& centre,
          const std::vector<irg::curve_sample<point>>& places, numbered_files& files) {
  const auto view = world.view;
  const double radius = irg::bounding_sphere_of(world.objects[0].shape).radius;
  irg::image<irg::rgba8> picture(s.size.width, s.size.height);
  irg::image<float> depth(s.size.width, s.size.height);
  irg::png_animation<irg::image<irg::rgba8>> animation(s.pictures, {s.delay, 0});
  std::vector<std::uint8_t> file;
  for (std::size_t k = 0; k < places.size(); ++k) {
    point at = centre;
    if (s.what == moved::body) {
      at = places[k].point;
      const vector way = at - centre;
      for (int i = 0; i < 3; ++i) world.objects[0].placement(i, 3) = way[i];
    }
    world.view = irg::with_depth_range(camera_at(s, view, places[k]), at, radius);
    irg::render(world, {picture, depth}, s.options, irg::parallel{s.threads});
    if (!s.frames.empty()) files.write(line, picture);
    if (!s.out.empty()) {
      const auto bytes = animation.add(picture);
      if (!bytes) files.fail(line, bytes.error().message);
      file.insert(file.end(), bytes->begin(), bytes->end());
    }
    std::fprintf(stderr, "picture %d of %d\n", static_cast<int>(k) + 1, s.pictures);
  }
  if (s.out.empty()) return;
  if (const auto saved = irg::save_file(s.out, std::span<const std::uint8_t>(file)); !saved)
    files.fail(line, std::string(saved.error().message) + ": " + s.out);
}

void run(program::command_line& line) {
  settings s = read_settings(line);
  const std::vector<point> points = read_points(line, s.input, s.path == path_kind::bezier ? 100 : 10000);
  const path way(line, points, s.path);
  const auto knots = way.knots();
  std::vector<double> lengths(way.pieces() + 1);
  const auto sample = [&](double t) { return way(t); };
  const irg::constant_speed motion(sample, knots.first(), knots.last(), std::span<double>(lengths));
  std::vector<irg::curve_sample<point>> places;
  places.reserve(static_cast<std::size_t>(s.pictures));
  for (int k = 0; k < s.pictures && s.step > 0; ++k)
    places.push_back(way(std::fmin(knots.first() + (knots.last() - knots.first()) * (k * s.step), knots.last())));
  for (int k = 0; k < s.pictures && s.step == 0; ++k)
    places.push_back(motion.at(s.pictures > 1 ? static_cast<double>(k) / (s.pictures - 1) : 0));
  numbered_files files(s);
  if (!s.out.empty() || !s.frames.empty()) {
    irg::scene<double> world;
    world.objects.push_back({load_model(line, s.model)});
    const auto& shape = world.objects[0].shape;  // an eye or a target that moves may pass the other
    world.view = s.what == moved::body ? program::camera_of(line, s, shape) : program::placed_camera(line, s, shape);
    draw(line, s, world, irg::bounding_sphere_of(world.objects[0].shape).centre, places, files);
  }
  if (s.list) {
    for (std::size_t k = 0; k < places.size(); ++k)
      std::printf("%d %s %s %s\n", static_cast<int>(k), program::shortest(places[k].point.x).c_str(),
                  program::shortest(places[k].point.y).c_str(), program::shortest(places[k].point.z).c_str());
  } else {
    std::printf("pictures: %d\nlength: %s\n", s.pictures, program::shortest(motion.length()).c_str());
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) files.remove();
  program::finish_output(line, s.out);
  files.keep();
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "fly_through", help}, "this model, path and size", run);
}
