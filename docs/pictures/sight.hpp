// SPDX-License-Identifier: MIT
// What is seen on maps of cells: each variant on the same map, corners, percentages, viewsheds, and the row sweep as a
// moving picture. Included by pictures.cpp.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <irg/io/file.hpp>
#include <irg/io/grid_text.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/visibility/field_of_view.hpp>
#include <irg/visibility/textbook/sight_2d.hpp>
#include <irg/visibility/viewshed.hpp>
#include <irg/visibility/visible_part.hpp>

#include "enlarged.hpp"

namespace sight_pictures {

using namespace enlarging;
using irg::cell;
constexpr irg::rgba8 dark{168, 168, 164, 255}, lit{255, 232, 158, 255}, half_lit{232, 214, 178, 255},
    full{60, 66, 84, 255}, unit{204, 96, 72, 255}, brown{120, 72, 40, 255}, blue{92, 142, 196, 255};

// A room of 20 x 21 cells with pillars, walls and doors; the unit stands at (9, 12).
inline irg::grid_text room() {
  auto map = irg::read_grid(
      "20 21 1\n"
      "....................\n"
      "....................\n"
      "...##........#......\n"
      "...##...............\n"
      "..............##....\n"
      "......#.............\n"
      "....................\n"
      "..#.......#.....#...\n"
      "....................\n"
      ".....#..............\n"
      "............#.......\n"
      "....................\n"
      "...#................\n"
      "......##.......###..\n"
      "......##.......#....\n"
      "...............#....\n"
      "..........#.........\n"
      "....##..............\n"
      "....................\n"
      "..#.........#.......\n"
      "....................\n"
      "9 12\n"
      "wall 8 9 0 y+ wall\nwall 9 9 0 y+ open-door\nwall 10 9 0 y+ wall\nwall 11 12 0 x+ closed-door\n"
      "wall 11 13 0 x+ wall\n");
  return *std::move(map);
}

// Cells as squares in the colours that colour_of(cell) gives, full cells and blocking walls over them.
template <class ColourOf>
picture drawn(const irg::walled_grid& map, int size, const ColourOf& colour_of) {
  const irg::grid_extent e = map.extent();
  picture small(e.width, e.height, paper);
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x) small(x, y) = map.is_full({x, y, 0}) ? full : colour_of(cell{x, y});
  picture big = enlarged(small, size);
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x)
      for (int k = -1; k <= 1; ++k) {
        if (map.has_wall({x, y, 0}, 0))
          for (int i = 0; i <= size; ++i) big((x + 1) * size + k, y * size + i) = brown;
        if (map.has_wall({x, y, 0}, 1))
          for (int i = 0; i <= size; ++i) big(x * size + i, (y + 1) * size + k) = brown;
      }
  return big;
}
inline picture seen_from(const irg::grid_text& map, const irg::cell_grid& seen, int size) {
  return drawn(map.grid, size, [&](cell c) {
    return irg::cell3(c) == map.units[0] ? unit : seen.is_full(c) ? lit : dark;
  });
}
inline cell viewer_of(const irg::grid_text& map) { return {map.units[0].x, map.units[0].y}; }

// Panels of one size in rows of `columns`, a gap between them.
inline picture table(const std::vector<picture>& panels, int columns) {
  constexpr int gap = 12;
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const int width = panels[0].width() + gap, height = panels[0].height() + gap;
  picture p(columns * width - gap, rows * height - gap, paper);
  for (int i = 0; i < static_cast<int>(panels.size()); ++i)
    paste(p, panels[static_cast<std::size_t>(i)], i % columns * width, i / columns * height);
  return p;
}

// Above: pinch, open, closed. Below: the thesis' algorithm with partial sight paler, permissive, restrictive.
inline picture variants() {
  constexpr int size = 13;
  const irg::grid_text map = room();
  std::vector<picture> panels;
  for (const irg::corner_rule rule : {irg::corner_rule::pinch, irg::corner_rule::open, irg::corner_rule::closed}) {
    irg::view_options o;
    o.rules.corners = rule;
    panels.push_back(seen_from(map, irg::field_of_view(map.grid, map.units[0], o), size));
  }
  const cell viewer = viewer_of(map);
  panels.push_back(drawn(map.grid, size, [&](cell c) {
    const irg::textbook::sight s = irg::textbook::sight_2d(map.grid, viewer, c);
    return c == viewer                          ? unit
           : s == irg::textbook::sight::full    ? lit
           : s == irg::textbook::sight::partial ? half_lit
                                                : dark;
  }));
  panels.push_back(seen_from(map, irg::field_of_view_permissive(map.grid, viewer), size));
  panels.push_back(seen_from(map, irg::field_of_view_restrictive(map.grid, viewer), size));
  return table(panels, 3);
}

// Left: the cells that are seen. Right: how much of each.
inline picture parts() {
  constexpr int size = 18;
  const irg::grid_text map = room();
  const std::vector<double> percent = irg::visible_percentages(map.grid, viewer_of(map));
  const auto mixed = [](int a, int b, double part) { return static_cast<std::uint8_t>(a + (b - a) * part + 0.5); };
  const picture grey = drawn(map.grid, size, [&](cell c) {
    const double part = percent[static_cast<std::size_t>(c.y * 20 + c.x)] / 100;
    if (c == viewer_of(map)) return unit;
    return irg::rgba8{mixed(dark.r, lit.r, part), mixed(dark.g, lit.g, part), mixed(dark.b, lit.b, part), 255};
  });
  return table({seen_from(map, irg::field_of_view(map.grid, map.units[0]), size), grey}, 2);
}

inline void segment(picture& p, cell a, cell b, int size, irg::rgba8 colour) {
  irg::draw_line(p, cell{a.x * size + size / 2, a.y * size + size / 2},
                 cell{b.x * size + size / 2, b.y * size + size / 2}, colour);
  dot(p, {a.x * size + size / 2, a.y * size + size / 2}, 4, unit);
  dot(p, {b.x * size + size / 2, b.y * size + size / 2}, 4, unit);
}

// Lines that pass beside, through and between full cells: the cells that they cross are lit as far as they are seen.
inline picture corners() {
  constexpr int size = 30;
  std::vector<picture> panels;
  for (const std::vector<cell>& blocks : {std::vector<cell>{{2, 1}}, {{2, 1}, {1, 2}}, {{3, 2}}}) {
    irg::walled_grid map(irg::grid_extent{6, 5, 1});
    for (const cell c : blocks) map.set(c);
    picture p = drawn(map, size, [&](cell c) { return irg::has_line_of_sight(map, cell{0, 0}, c) ? lit : dark; });
    segment(p, {0, 0}, {4, 4}, size, ink);
    segment(p, {0, 0}, {5, 3}, size, ink);
    panels.push_back(p);
  }
  return table(panels, 3);
}

// The line of the modified algorithm from (0, 0) to (8, 4) and to (5, 5): its cells, and those it crosses in part.
inline picture thirds() {
  constexpr int size = 30;
  std::vector<picture> panels;
  for (const cell end : {cell{8, 4}, cell{5, 5}, cell{8, 3}}) {
    picture small(9, 6, paper);
    small(0, 0) = blue;
    irg::textbook::sight_steps({0, 0}, end, [&](const irg::textbook::sight_step& s) {
      small(s.next.x, s.next.y) = blue;
      if (s.through == irg::textbook::passage::corner)
        small(s.ahead.x, s.ahead.y) = small(s.aside.x, s.aside.y) = half_lit;
      if (s.through == irg::textbook::passage::ahead) small(s.ahead.x, s.ahead.y) = lit;
      if (s.through == irg::textbook::passage::aside) small(s.aside.x, s.aside.y) = lit;
      return true;
    });
    picture p = enlarged(small, size);
    segment(p, {0, 0}, end, size, ink);
    panels.push_back(p);
  }
  return table(panels, 3);
}

// The three answers on a line of 45 degrees, by colour: obstacles on both sides at once, on the left alone, and on the
// left first and later on the right.
inline picture answers() {
  constexpr int size = 30;
  constexpr irg::rgba8 partly_lit{178, 200, 140, 255};
  std::vector<picture> panels;
  for (const std::vector<cell>& blocks : {std::vector<cell>{{0, 1}, {1, 0}}, {{1, 2}}, {{1, 2}, {4, 3}}}) {
    irg::walled_grid map(irg::grid_extent{7, 6, 1});
    for (const cell c : blocks) map.set(c);
    picture p = drawn(map, size, [&](cell c) {
      const irg::textbook::sight s = irg::textbook::sight_2d(map, {0, 0}, c);
      return s == irg::textbook::sight::full ? lit : s == irg::textbook::sight::partial ? partly_lit : dark;
    });
    segment(p, {0, 0}, {5, 5}, size, ink);
    panels.push_back(p);
  }
  return table(panels, 3);
}

// Hills, heights in 1/16 of a cell: slopes towards the light are brighter, what an eye on the left hill sees is warm.
inline picture hills() {
  constexpr int width = 240, height = 130;
  irg::image<int> heights(width, height);
  const auto hill = [](int x, int y, int cx, int cy, int radius, int top) {
    const std::int64_t d = (x - cx) * (x - cx) + (y - cy) * (y - cy), r = radius * radius;
    return d < r ? static_cast<int>(top * (r - d) * (r - d) / (r * r)) : 0;
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      heights(x, y) = hill(x, y, 55, 75, 55, 640) + hill(x, y, 170, 80, 62, 720) + hill(x, y, 125, 25, 30, 420) +
                      hill(x, y, 110, 100, 24, 240) + hill(x, y, 215, 20, 40, 330) + 2 * y;
  const cell eye{60, 72};
  const irg::cell_grid seen = irg::viewshed(heights, eye, {64, 0});
  picture p(3 * width, 3 * height);
  for (int y = 0; y < 3 * height; ++y)
    for (int x = 0; x < 3 * width; ++x) {
      const int column = x / 3, row = y / 3;
      const int slope = column == 0 || row == 0
                            ? 0
                            : 2 * heights(column, row) - heights(column - 1, row) - heights(column, row - 1) - 2;
      const int light = std::clamp(150 + 2 * slope + heights(column, row) / 16, 40, 255);
      const auto share = [&](int sixteenths) { return static_cast<std::uint8_t>(light * sixteenths / 16); };
      p(x, y) = seen.is_full(cell{column, row}) ? irg::rgba8{share(16), share(14), share(8), 255}
                                                : irg::rgba8{share(8), share(9), share(11), 255};
    }
  dot(p, {3 * eye.x + 1, 3 * eye.y + 1}, 4, unit);
  return p;
}

// The sweep as a moving picture: the rows of cells above and below the viewer light up in the sweep's order.
inline bool write_sweep(const std::string& path) {
  constexpr int size = 16;
  const irg::grid_text map = room();
  const irg::grid_extent e = map.grid.extent();
  const cell viewer = viewer_of(map);
  const irg::cell_grid seen = irg::field_of_view(map.grid, map.units[0]);
  char line[256];
  std::string svg;
  const auto add = [&](const char* format, auto... values) {
    std::snprintf(line, sizeof line, format, values...);
    svg += line;
  };
  const auto square = [&](cell c, const char* colour) {
    add("<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"%s\"", c.x * size, c.y * size, size - 1, size - 1,
        colour);
  };
  add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\">\n", e.width * size,
      e.height * size, e.width * size, e.height * size);
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x) {
      const cell c{x, y};
      square(c, map.grid.is_full(c) ? "#3c4254" : c == viewer ? "#cc6048" : "#a8a8a4");
      svg += "/>\n";
      if (map.grid.is_full(c) || !seen.is_full(c) || c == viewer) continue;
      const int row = std::max(viewer.y - y, y - viewer.y);
      square(c, "#ffe89e");
      const double at = 0.05 + 0.065 * row;
      add("><animate attributeName=\"opacity\" values=\"0;0;1;1\" keyTimes=\"0;%.3f;%.3f;1\" dur=\"8s\" "
          "repeatCount=\"indefinite\"/></rect>\n",
          at, at + 0.03);
    }
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x) {
      if (map.grid.has_wall({x, y, 0}, 0))
        add("<path d=\"M%d %dv%d\" stroke=\"#784828\" stroke-width=\"3\"/>\n", (x + 1) * size, y * size, size);
      if (map.grid.has_wall({x, y, 0}, 1))
        add("<path d=\"M%d %dh%d\" stroke=\"#784828\" stroke-width=\"3\"/>\n", x * size, (y + 1) * size, size);
    }
  svg += "</svg>\n";
  return irg::save_file(path, svg).has_value();
}

}  // namespace sight_pictures
