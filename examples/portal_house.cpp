// SPDX-License-Identifier: MIT
// portal_house - which rooms of a house can be seen from which, and the picture from an eye in it.
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/geometry/point_in_convex_polygon.hpp>
#include <irg/io/file.hpp>
#include <irg/io/plan_text.hpp>
#include <irg/io/space_plan_text.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/render_rooms.hpp>
#include <irg/scene/room_mesh.hpp>
#include <irg/visibility/potentially_visible.hpp>
#include <irg/visibility/space_portals.hpp>

#include "support/command_line.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "support/text_input.hpp"

namespace {

constexpr std::string_view help =
    R"(portal_house - which rooms of a house can be seen from which

usage: portal_house [options] <PLAN

Reads a plan, a line for each cell, its heights and each portal:
  cell NAME x y x y x y ...      a convex room, counter-clockwise
  heights NAME floor ceiling     0 and 1 where there are none
  portal NAME NAME x y x y       an opening that lies in a side of both cells
Prints for each cell the cells that can be seen from somewhere in it.

Or a plan in space, of convex cells of any kind, whose first line is a point:
  point x y z                    numbered from 1
  cell NAME                      a convex cell, whose faces follow
  face n n n ...                 its corners, counter-clockwise as seen from outside
  portal NAME NAME n n n ...     an opening in a face of both cells

  --input FILE         read the plan from FILE
  --eye X,Y,Z          print what an eye there sees instead, and draw the picture from it
  --look X,Y,Z         what the eye looks at (one unit along x)
  --sets FILE          write the sets of cells, a bit for each pair
  --skip on|off        whether rooms that no portal shows are left out of the picture (on)
  -o OUT               draw the picture from the eye: .png, .ppm or .svg (no plan in space)
  --size WxH           pixels of the picture (640x480)
)";

using place = irg::point<double, 3>;

struct settings : program::drawing_options {
  std::vector<double> eye, look;
  std::string sets;
  irg::skipping skip = irg::skipping::on;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--eye")
      s.eye = line.numbers(word, 3);
    else if (word == "--look")
      s.look = line.numbers(word, 3);
    else if (word == "--sets")
      s.sets = line.file_of(word);
    else if (word == "--skip")
      s.skip = line.choice(word, {"on", "off"}) == 0 ? irg::skipping::on : irg::skipping::off;
    else if (word == "--list")
      line.refuse(word);
    else
      s.read(line, word);
  }
  s.finish(line);
  if (!s.out.empty() && s.eye.empty()) line.fail("a picture needs an eye: --eye X,Y,Z");
  if (!s.sets.empty() && (program::one_file(s.sets, s.input) || program::one_file(s.sets, s.out)))
    line.fail("a file would be overwritten: " + s.sets);
  return s;
}

// The plan that read(text) finds.
template <class Read>
auto read_house(const program::command_line& line, std::string_view text, const settings& s, const Read& read) {
  auto plan = read(text);
  if (!plan) line.fail(program::with_place(plan.error(), s.input.empty() ? "stdin" : s.input));
  return *std::move(plan);
}

// The name of each cell and of those that sees(cell, other) says so of.
template <class Sees>
std::string names_of(const std::vector<irg::part_name>& names, std::uint32_t cell, const Sees& sees) {
  std::string text(names[cell]);
  text += ':';
  for (std::uint32_t other = 0; other < names.size(); ++other)
    if (sees(other)) text += ' ' + std::string(names[other]);
  return text + '\n';
}
std::string names_of(const std::vector<irg::part_name>& names, const irg::visible_sets& sets) {
  std::string text;
  for (std::uint32_t c = 0; c < names.size(); ++c)
    text += names_of(names, c, [&](std::uint32_t other) {
      return sets.seen.is_full({static_cast<int>(other), static_cast<int>(c), 0});
    });
  return text;
}

void write_sets(const program::command_line& line, const settings& s, const irg::visible_sets& sets) {
  if (s.sets.empty()) return;
  if (const auto saved = irg::save_file(s.sets, irg::encode_visible_sets(sets)); !saved) {
    program::remove_written(s.out);
    line.fail(std::string(saved.error().message) + ": " + s.sets);
  }
}

place place_of(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

// The cells that the eye sees, from the first cell that it stands in.
std::string seen_by_eye(const program::command_line& line, const irg::named_plan<irg::cell_plan<double>>& house,
                        const irg::portal_graph<double>& doors, const place& eye) {
  for (std::uint32_t c = 0; c < house.names.size(); ++c) {
    const irg::plan_cell<double>& cell = house.plan.cells[c];
    const irg::point<double, 2> from{eye.x, eye.y};
    if (eye.z < cell.floor || cell.ceiling < eye.z ||
        irg::point_in_convex_polygon(cell.corners, from) == irg::location::outside)
      continue;
    std::vector<bool> seen(house.names.size(), false);
    irg::view_through_openings({house.plan, doors}, c, {from, irg::view_reach::all_round, {}, {}}, eye.z,
                               [&](std::uint32_t other, const auto&) { seen[other] = true; });
    return names_of(house.names, c, [&](std::uint32_t other) { return seen[other]; });
  }
  line.fail("the eye is in no cell");
}

irg::camera<double> camera_of(const program::command_line& line, const settings& s) {
  irg::camera<double> view;
  view.eye = place_of(s.eye);
  view.target = s.look.empty() ? place{view.eye.x + 1, view.eye.y, view.eye.z} : place_of(s.look);
  if (view.target.x == view.eye.x && view.target.y == view.eye.y) line.fail("the eye cannot look straight up or down");
  view.up = {0, 0, 1};
  view.vertical_angle = 1;
  return view;
}

// The picture from the eye, each room in a colour of its own; says how many triangles were left out.
irg::image<irg::rgba8> picture_of(irg::cell_plan<double> plan, const irg::camera<double>& view, const settings& s,
                                  std::string& text) {
  irg::portal_graph<double> doors(plan);
  irg::scene<double> world;
  world.view = view;
  for (std::uint32_t c = 0; c < plan.cells.size(); ++c) {
    irg::object<double> room;
    room.shape = irg::room_mesh(plan, doors, c);
    const auto part = [&](std::uint32_t factor) { return 0.45 + 0.05 * (c * factor % 11); };
    room.surface.ambient = room.surface.diffuse = {part(3), part(5), part(7)};
    world.objects.push_back(std::move(room));
  }
  world.ambient = {0.5, 0.5, 0.5};
  world.lights.push_back({{-0.3, -0.55, 0.75, 0.0}, {0.5, 0.5, 0.5}});
  irg::prepared_rooms<double> building{std::move(plan), std::move(doors), irg::prepare_scene(world)};
  irg::image<irg::rgba8> picture(s.size.width, s.size.height, {});
  irg::image<float> depth(s.size.width, s.size.height, 0.0f);
  irg::render_options options;
  options.style = irg::picture_style::flat;
  options.skip.rooms = s.skip;
  const irg::render_counts stats = irg::render(building, {picture, depth}, options);
  text += "triangles: " + std::to_string(stats.triangles) + ", " + std::to_string(stats.skipped.rooms) +
          " of them in rooms that were skipped\n";
  return picture;
}

// Whether a place is in a cell or on its boundary.
bool is_in_cell(const irg::space_plan<double>& plan, std::uint32_t cell, const place& p) {
  const auto& corners = plan.cells[cell];
  for (const irg::space_face& f : plan.faces[cell])
    if (irg::orient3d(corners[f[0]], corners[f[1]], corners[f[2]], p) > 0) return false;
  return true;
}

std::string seen_by_eye(const program::command_line& line, const irg::named_plan<irg::space_plan<double>>& house,
                        const place& eye) {
  for (std::uint32_t c = 0; c < house.names.size(); ++c) {
    if (!is_in_cell(house.plan, c, eye)) continue;
    std::vector<bool> seen(house.names.size(), false);
    irg::view_through_portals(house.plan, c, eye, [&](std::uint32_t other) { seen[other] = true; });
    return names_of(house.names, c, [&](std::uint32_t other) { return seen[other]; });
  }
  line.fail("the eye is in no cell");
}

void run_in_space(program::command_line& line, const settings& s, std::string_view input) {
  if (!s.out.empty()) line.fail("a plan in space has no picture: it has no heights to draw rooms from");
  const auto house = read_house(line, input, s, irg::read_space_plan<double>);
  irg::visible_sets sets;
  if (s.eye.empty() || !s.sets.empty()) sets = irg::potentially_visible(house.plan);
  const std::string text = s.eye.empty() ? names_of(house.names, sets) : seen_by_eye(line, house, place_of(s.eye));
  write_sets(line, s, sets);
  std::fwrite(text.data(), 1, text.size(), stdout);
  program::finish_output(line, s.out, s.sets);
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const std::string input = program::read_text(line, s.input, "plan");
  if (irg::is_space_plan(input)) return run_in_space(line, s, input);
  const auto house = read_house(line, input, s, irg::read_plan<double>);
  const irg::portal_graph<double> doors(house.plan);
  irg::visible_sets sets;
  if (s.eye.empty() || !s.sets.empty()) sets = irg::potentially_visible(doors);
  std::string text = s.eye.empty() ? names_of(house.names, sets) : seen_by_eye(line, house, doors, place_of(s.eye));
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(house.plan, camera_of(line, s), s, text));
  write_sets(line, s, sets);
  std::fwrite(text.data(), 1, text.size(), stdout);
  program::finish_output(line, s.out, s.sets);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "portal_house", help}, "this plan", run); }
