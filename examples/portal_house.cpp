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
#include <irg/raster/image.hpp>
#include <irg/render/render_rooms.hpp>
#include <irg/scene/room_mesh.hpp>
#include <irg/visibility/potentially_visible.hpp>

#include "support/command_line.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "support/text_input.hpp"

namespace {

constexpr std::string_view help =
    R"(portal_house - which rooms of a house can be seen from which

Reads a plan, a line for each cell, its heights and each portal:
  cell NAME x y x y x y ...      a convex room, counter-clockwise
  heights NAME floor ceiling     0 and 1 where there are none
  portal NAME NAME x y x y       an opening that lies in a side of both cells
Prints for each cell the cells that can be seen from somewhere in it.

  --input FILE         read the plan from FILE
  --eye X,Y,Z          print what an eye there sees instead, and draw the picture from it
  --look X,Y,Z         what the eye looks at (one unit along x)
  --sets FILE          write the sets of cells, a bit for each pair
  --skip on|off        whether rooms that no portal shows are left out of the picture (on)
  -o OUT               draw the picture from the eye: .png, .ppm or .svg
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
      s.sets = line.value_of(word);
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

irg::named_plan<double> read_house(const program::command_line& line, const std::string& input) {
  const std::string text = program::read_text(line, input, "plan");
  auto plan = irg::read_plan(text);
  if (!plan) line.fail(program::with_place(plan.error(), input.empty() ? "stdin" : input));
  return *std::move(plan);
}

// The name of each cell and of those that sees(cell, other) says so of.
template <class Sees>
std::string names_of(const irg::named_plan<double>& house, std::uint32_t cell, const Sees& sees) {
  std::string text(house.names[cell]);
  text += ':';
  for (std::uint32_t other = 0; other < house.names.size(); ++other)
    if (sees(other)) text += ' ' + std::string(house.names[other]);
  return text + '\n';
}

place place_of(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

// The cells that the eye sees, from the first cell that it stands in.
std::string seen_by_eye(const program::command_line& line, const irg::named_plan<double>& house,
                        const irg::portal_graph<double>& doors, const place& eye) {
  for (std::uint32_t c = 0; c < house.names.size(); ++c) {
    const irg::plan_cell<double>& cell = house.plan.cells[c];
    const irg::point<double, 2> from{eye.x, eye.y};
    if (eye.z < cell.floor || cell.ceiling < eye.z ||
        irg::point_in_convex_polygon(cell.corners, from) == irg::location::outside)
      continue;
    std::vector<bool> seen(house.names.size(), false);
    irg::view_through_openings(house.plan, doors, c, {from, irg::view_reach::all_round, {}, {}}, eye.z,
                               [&](std::uint32_t other, const auto&) { seen[other] = true; });
    return names_of(house, c, [&](std::uint32_t other) { return seen[other]; });
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
  const irg::render_stats stats = irg::render(building, picture, depth, options);
  text += "triangles: " + std::to_string(stats.triangles) + ", " + std::to_string(stats.skipped.rooms) +
          " of them in rooms that were skipped\n";
  return picture;
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const irg::named_plan<double> house = read_house(line, s.input);
  const irg::portal_graph<double> doors(house.plan);
  std::string text;
  irg::visible_sets sets;
  if (s.eye.empty() || !s.sets.empty()) sets = irg::potentially_visible(doors);
  if (s.eye.empty())
    for (std::uint32_t c = 0; c < house.names.size(); ++c)
      text += names_of(house, c, [&](std::uint32_t other) {
        return sets.seen.is_full({static_cast<int>(other), static_cast<int>(c), 0});
      });
  else
    text = seen_by_eye(line, house, doors, place_of(s.eye));
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(house.plan, camera_of(line, s), s, text));
  if (!s.sets.empty())
    if (const auto error = irg::write_file_atomically(s.sets, irg::encode_visible_sets(sets)))
      line.fail(std::string(error->message) + ": " + s.sets);
  std::fwrite(text.data(), 1, text.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "portal_house", help}, "this plan", run); }
