// SPDX-License-Identifier: MIT
// grid_visibility - the cells of a map that units see, exactly or as a thesis does it.
#include <algorithm>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include <irg/io/grid_text.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/visibility/field_of_view.hpp>
#include <irg/visibility/unit_sight.hpp>
#include <irg/visibility/visible_part.hpp>

#include "support/cell_sight.hpp"
#include "support/command_line.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"
#include "support/text_input.hpp"

namespace {

constexpr std::string_view help =
    R"(grid_visibility - the cells of a map that units see

usage: grid_visibility [options] <MAP

Reads width height depth, then the map: depth layers of height rows of width cells, . empty and # full, then one
line per unit, x y [z], and per wall, wall x y z SIDE KIND: SIDE is x+, y+ or z+, between this cell and the next,
KIND is wall, half, open-door, closed-door or laser. Prints how many cells any unit sees, its own among them.

  --input FILE         read the map from FILE
  --method METHOD      how (sweep):
                         sweep    row by row, or sector by sector in space
                         exact    each cell by itself; the same cells
                         thesis   by the modified Bresenham line, with its own rule for corners
                         thesis-face-path
                                  the same, but a step along three axes is stopped by all cells that leave no way
                                  from face to face, not only by the two sets that are printed
  --corners RULE       when a corner stops a line through it (pinch); open and closed with sweep and exact only:
                         pinch    when no way leads round it
                         open     never
                         closed   when anything full touches it
  --list               print the cells that are seen instead: x y z
  --percent            print how much of each cell is seen instead: x y z percent, of the unit that sees most; depth 1
  --pairs              print who sees whom instead: a row of 0 and 1 per unit
  -o OUT               draw the layers: .png, .ppm or .svg; seen cells yellow, by the thesis those that are seen in part
                       green; walls across x and y as bars: wall blue, closed-door brown, and those that do not block,
                       half grey, open-door ochre, laser red; a map of more cells than pixels smaller
  --size WxH           pixels of the picture (640x480)
)";

enum class method { sweep, exact, thesis, thesis_face_path };

struct settings : program::drawing_options {
  method how = method::sweep;
  irg::line_of_sight_options rules;
  bool percent = false, pairs = false;

  bool by_thesis() const { return how == method::thesis || how == method::thesis_face_path; }
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--method")
      s.how = static_cast<method>(line.choice(word, {"sweep", "exact", "thesis", "thesis-face-path"}));
    else if (word == "--corners")
      s.rules.corners = static_cast<irg::corner_rule>(line.choice(word, {"pinch", "open", "closed"}));
    else if (word == "--percent")
      s.percent = true;
    else if (word == "--pairs")
      s.pairs = true;
    else
      s.read(line, word);
  }
  s.finish(line);
  if (s.by_thesis() && s.rules.corners != irg::corner_rule::pinch)
    line.fail("the thesis has its own rule for corners; --corners open and closed need --method sweep or exact");
  if (s.list + s.percent + s.pairs > 1) line.fail("only one of --list, --percent and --pairs can be printed");
  return s;
}

irg::grid_text read_map(const program::command_line& line, const std::string& input) {
  const std::string text = program::read_text(line, input, "map");
  auto map = irg::read_grid(text);
  if (!map) line.fail(program::with_place(map.error(), input.empty() ? "stdin" : input));
  return *std::move(map);
}

irg::textbook::sight sight_of(const irg::walled_grid& g, const irg::cell3& a, const irg::cell3& b, const settings& s) {
  using irg::textbook::sight;
  using rule = irg::textbook::three_axis_rule;
  if (!s.by_thesis()) return irg::has_line_of_sight(g, a, b, s.rules) ? sight::full : sight::blocked;
  return program::thesis_sight(g, a, b, s.how == method::thesis ? rule::thesis : rule::face_path);
}

program::cell_sight seen_cells(const irg::grid_text& map, const settings& s) {
  const irg::grid_extent e = map.grid.extent();
  if (s.how == method::sweep) {
    irg::view_options o;
    o.rules = s.rules;
    return {irg::field_of_view(map.grid, std::span(map.units), o), irg::cell_grid(e)};
  }
  return program::sight_by(e, std::span(map.units),
                           [&](const irg::cell3& u, const irg::cell3& c) { return sight_of(map.grid, u, c, s); });
}

std::string percent_text(const irg::grid_text& map) {
  const irg::grid_extent e = map.grid.extent();
  std::vector<double> most(static_cast<std::size_t>(e.width) * static_cast<std::size_t>(e.height), 0.0);
  for (const irg::cell3& u : map.units) {
    const std::vector<double> percent = irg::visible_percentages(map.grid, {u.x, u.y});
    for (std::size_t i = 0; i < most.size(); ++i) most[i] = std::max(most[i], percent[i]);
  }
  std::string text;
  for (std::size_t i = 0; i < most.size(); ++i)
    if (most[i] > 0)
      text += std::to_string(i % static_cast<std::size_t>(e.width)) + " " +
              std::to_string(i / static_cast<std::size_t>(e.width)) + " 0 " + program::shortest(most[i]) + "\n";
  return text;
}

std::string pairs_text(const irg::grid_text& map, const settings& s) {
  std::string text;
  for (std::size_t i = 0; i < map.units.size(); ++i)
    for (std::size_t j = 0; j < map.units.size(); ++j) {
      text += i == j || sight_of(map.grid, map.units[i], map.units[j], s) != irg::textbook::sight::blocked ? '1' : '0';
      text += j + 1 < map.units.size() ? ' ' : '\n';
    }
  return text;
}

constexpr irg::rgba8 paper{250, 249, 246, 255}, dark{150, 150, 146, 255}, lit{255, 228, 140, 255},
    partly_lit{178, 200, 140, 255}, full{60, 66, 84, 255}, seen_full{120, 96, 60, 255},
    partly_seen_full{96, 108, 64, 255}, unit{204, 96, 72, 255};

// The layers beside each other, a square per cell. Where there are more cells than pixels along an axis, a pixel stands
// for several, and shows the first of them.
struct map_layout {
  // So many cells on so many pixels.
  struct scale {
    std::int64_t cells, pixels;
  };
  std::int64_t side;  // pixels of a cell, 1 where there are more cells than pixels
  irg::grid_extent extent;
  scale across{}, down{};

  map_layout(const irg::grid_extent& e, const program::picture_size& size) : extent(e) {
    const std::int64_t columns = (std::int64_t{e.width} + 1) * e.depth + 1, rows = std::int64_t{e.height} + 2;
    side = std::max<std::int64_t>(1, std::min(size.width / columns, size.height / rows));
    across = columns > size.width ? scale{columns, size.width} : scale{1, side};
    down = rows > size.height ? scale{rows, size.height} : scale{1, side};
  }
  irg::cell3 cell_at(int x, int y) const {  // may be no cell of the map
    const std::int64_t column = x * across.cells / across.pixels - 1, row = y * down.cells / down.pixels - 1;
    const std::int64_t step = extent.width + std::int64_t{1};
    if (column < 0) return {-1, -1, -1};
    return {static_cast<int>(column % step), static_cast<int>(row), static_cast<int>(column / step)};
  }
  irg::cell corner_of(const irg::cell3& c) const {
    return {static_cast<int>((c.x + 1 + c.z * (extent.width + std::int64_t{1})) * across.pixels / across.cells),
            static_cast<int>((c.y + std::int64_t{1}) * down.pixels / down.cells)};
  }
};

// The walls across x and y, as bars over the lines between cells, those that block over the others; the whole map is in
// the picture.
void draw_walls(irg::image<irg::rgba8>& p, const irg::walled_grid& map, const map_layout& at) {
  const int side = static_cast<int>(at.side), thick = side / 12;
  const auto draw = [&](const irg::cell3& c, int axis) {
    const irg::cell corner = at.corner_of(c);
    const irg::rgba8 colour = program::colour_of(map.wall(c, axis));
    if (axis == 0)
      for (int row = 0; row <= side; ++row)
        irg::fill_span(p, {corner.y + row, corner.x + side - thick, corner.x + side + thick + 1}, colour);
    else
      for (int row = side - thick; row <= side + thick; ++row)
        irg::fill_span(p, {corner.y + row, corner.x, corner.x + side + 1}, colour);
  };
  for (const bool blocks : {false, true})
    for (int z = 0; z < at.extent.depth; ++z)
      for (int y = 0; y < at.extent.height; ++y)
        for (int x = 0; x < at.extent.width; ++x)
          for (int axis = 0; axis < 2; ++axis)
            if (map.wall({x, y, z}, axis) != irg::wall_kind::none && map.has_wall({x, y, z}, axis) == blocks)
              draw({x, y, z}, axis);
}

irg::image<irg::rgba8> picture_of(const irg::grid_text& map, const program::cell_sight& sight,
                                  const program::picture_size& size) {
  irg::image<irg::rgba8> p(size.width, size.height, paper);
  const map_layout at(map.grid.extent(), size);
  irg::cell_grid stood_on(map.grid.extent());
  for (const irg::cell3& u : map.units) stood_on.set(u);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const irg::cell3 c = at.cell_at(x, y);
      if (!at.extent.holds(c) || (at.side > 2 && (x % at.side == 0 || y % at.side == 0))) continue;
      const bool seen = sight.seen.is_full(c), partly = sight.partial.is_full(c);
      p(x, y) = stood_on.is_full(c)   ? unit
                : map.grid.is_full(c) ? (partly ? partly_seen_full
                                         : seen ? seen_full
                                                : full)
                : partly              ? partly_lit
                : seen                ? lit
                                      : dark;
    }
  for (const irg::cell3& u : map.units)  // a pixel may have shown another cell
    if (at.side == 1) p(at.corner_of(u).x, at.corner_of(u).y) = unit;
  if (at.side > 2 && map.grid.walled()) draw_walls(p, map.grid, at);
  return p;
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const irg::grid_text map = read_map(line, s.input);
  if (s.percent && map.grid.extent().depth != 1) line.fail("--percent supports maps of depth 1");
  std::string text;
  program::cell_sight sight;
  if (!s.pairs || !s.out.empty()) sight = seen_cells(map, s);
  if (s.percent)
    text = percent_text(map);
  else if (s.pairs)
    text = pairs_text(map, s);
  else if (s.list)
    sight.seen.for_each([&](const irg::cell3& c) {
      text += std::to_string(c.x) + " " + std::to_string(c.y) + " " + std::to_string(c.z) + "\n";
    });
  else
    text = "seen: " + std::to_string(sight.seen.count()) + "\n";
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(map, sight, s.size));
  std::fwrite(text.data(), 1, text.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "grid_visibility", help}, "this map", run); }
