// SPDX-License-Identifier: MIT
// Panels as they look, and which cell is where.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <irg/raster/draw_text.hpp>
#include <irg/raster/image.hpp>

#include "studio_keys.hpp"
#include "studio_panels.hpp"

namespace program {

inline constexpr int row_height = 18, line_height = 24;

/// A line that is being typed, in UTF-8, with the place of its cursor.
struct typed_line {
  std::string text{};
  std::size_t cursor = 0;

  void insert(std::string_view what) {
    text.insert(cursor, what);
    cursor += what.size();
  }
  void key(std::string_view name) {
    const auto inside = [&](std::size_t i) { return i < text.size() && (text[i] & 0xC0) == 0x80; };
    std::size_t left = cursor, right = cursor;
    if (left > 0) do
        --left;
      while (left > 0 && inside(left));
    if (right < text.size()) do
        ++right;
      while (inside(right));
    if (name == "left") cursor = left;
    if (name == "right") cursor = right;
    if (name == "home") cursor = 0;
    if (name == "end") cursor = text.size();
    if (name == "delete") text.erase(cursor, right - cursor);
    if (name == "backspace") {
      text.erase(left, cursor - left);
      cursor = left;
    }
  }
};

/// Which cell of which row.
struct cell_place {
  std::size_t row = 0, cell = 0;
  bool operator==(const cell_place&) const = default;
};

/// The cell at a pixel of a panel that is not scrolled, if one that can be pressed is there.
inline std::optional<cell_place> cell_at(const panel_rows& rows, int x, int y) {
  const int row = (y - panel_margin) / row_height;
  if (y < panel_margin || row >= static_cast<int>(rows.size())) return std::nullopt;
  const auto& cells = rows[static_cast<std::size_t>(row)].cells;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (x >= cells[i].left && x < cells[i].left + cells[i].width && cells[i].can_be_pressed())
      return cell_place{static_cast<std::size_t>(row), i};
  return std::nullopt;
}

/// A cell that can be pressed, as near to a place as there is one.
/// needs   rows, of which one has such a cell
inline cell_place nearest_cell(const panel_rows& rows, cell_place at) {
  std::optional<cell_place> best;
  const auto away = [](std::size_t a, std::size_t b) { return a < b ? b - a : a - b; };
  const auto distance = [&](const cell_place& p) { return 1000 * away(p.row, at.row) + away(p.cell, at.cell); };
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].cells.size(); ++c)
      if (rows[r].cells[c].can_be_pressed() && (!best || distance({r, c}) < distance(*best))) best = cell_place{r, c};
  return best.value_or(cell_place{});
}

/// Where an arrow key leads: along the row, or to the cell of the next row with one that lies most below or above.
inline cell_place cell_beside(const panel_rows& rows, cell_place at, std::string_view way) {
  const auto middle = [](const panel_cell& c) { return c.left + c.width / 2; };
  const int from = middle(rows[at.row].cells[at.cell]);
  const auto along = [&](std::size_t row, const auto& better) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < rows[row].cells.size(); ++i)
      if (rows[row].cells[i].can_be_pressed() && better(i, best)) best = i;
    return best;
  };
  const auto nearer = [&](std::size_t row) {
    return [&, row](std::size_t i, const std::optional<std::size_t>& best) {
      const auto off = [&](std::size_t k) { return std::abs(middle(rows[row].cells[k]) - from); };
      return !best || off(i) < off(*best);
    };
  };
  if (way == "left" || way == "right") {
    const auto next = along(at.row, [&](std::size_t i, const std::optional<std::size_t>& best) {
      return way == "left" ? i < at.cell : i > at.cell && !best;
    });
    return {at.row, next.value_or(at.cell)};
  }
  for (std::size_t row = at.row; way == "up" ? row-- > 0 : ++row < rows.size();)
    if (const auto i = along(row, nearer(row))) return {row, *i};
  return at;
}

/// The colours of panels.
struct colours_of_panels {
  irg::rgba8 paper{243, 242, 238, 255}, line{190, 190, 184, 255}, ink{32, 44, 66, 255}, faint{98, 104, 116, 255};
  irg::rgba8 white{255, 255, 255, 255}, on{60, 116, 176, 255}, chosen{208, 224, 242, 255}, focus{204, 96, 72, 255};
  irg::rgba8 button{228, 228, 222, 255};
};
inline constexpr colours_of_panels panel_colours{};

/// A rectangle of a picture, as far as it is in it.
inline irg::image_view<irg::rgba8> part_of(irg::image_view<irg::rgba8> p, irg::cell at, irg::cell size) {
  const int left = std::clamp(at.x, 0, p.width()), top = std::clamp(at.y, 0, p.height());
  const int right = std::clamp(at.x + size.x, left, p.width()), bottom = std::clamp(at.y + size.y, top, p.height());
  if (left == right || top == bottom) return {p.row(0), 0, 0, p.stride()};
  return {p.row(top) + left, right - left, bottom - top, p.stride()};
}

/// One colour everywhere.
inline void paint(irg::image_view<irg::rgba8> p, irg::rgba8 colour) { irg::clear(p, colour); }

namespace panel {

inline void frame(irg::image_view<irg::rgba8> p, int thick, irg::rgba8 colour) {
  paint(part_of(p, {0, 0}, {p.width(), thick}), colour);
  paint(part_of(p, {0, p.height() - thick}, {p.width(), thick}), colour);
  paint(part_of(p, {0, 0}, {thick, p.height()}), colour);
  paint(part_of(p, {p.width() - thick, 0}, {thick, p.height()}), colour);
}

inline void text_in(irg::image_view<irg::rgba8> p, std::string_view text, irg::text_along along, irg::rgba8 colour,
                    double weight = 0, double size = 13) {
  const double x = along == irg::text_along::left     ? 3
                   : along == irg::text_along::centre ? p.width() / 2.0
                                                      : p.width() - 4.0;
  irg::draw_text(p, text, {x, p.height() / 2.0},
                 {.size = size, .weight = weight, .along = along, .across = irg::text_across::middle}, colour);
}

inline void draw_cell(irg::image_view<irg::rgba8> p, const panel_cell& c) {
  using enum cell_look;
  constexpr const auto& k = panel_colours;
  const auto box = part_of(p, {1, 1}, {p.width() - 2, p.height() - 2});
  if (c.look == heading) return text_in(p, c.text, irg::text_along::left, k.ink, 1.7);
  if (c.look == reading) return text_in(p, c.text, irg::text_along::right, k.faint);
  if (c.look == label) return text_in(p, c.text, irg::text_along::left, c.choice ? k.ink : k.faint);
  paint(box, c.look == on ? k.on : c.look == button ? k.button : k.white);
  frame(box, 1, c.look == on ? k.on : k.line);
  text_in(p, c.text, c.look == value ? irg::text_along::right : irg::text_along::centre,
          c.look == on ? k.white : k.ink);
}

}  // namespace panel

/// Draws a panel, scrolled up by some pixels, with a frame around the cell that keys are about.
inline void draw_panel(irg::image_view<irg::rgba8> p, const panel_rows& rows, int scrolled,
                       const std::optional<cell_place>& focus) {
  paint(p, panel_colours.paper);
  paint(part_of(p, {0, p.height() - 1}, {p.width(), 1}), panel_colours.line);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const int top = panel_margin + static_cast<int>(r) * row_height - scrolled;
    if (top < 0 || top + row_height > p.height()) continue;
    if (rows[r].chosen)
      paint(part_of(p, {panel_margin - 2, top}, {panel_width - 2 * panel_margin + 4, row_height}),
            panel_colours.chosen);
    for (std::size_t i = 0; i < rows[r].cells.size(); ++i) {
      const panel_cell& c = rows[r].cells[i];
      const auto part = part_of(p, {c.left, top}, {c.width, row_height});
      panel::draw_cell(part, c);
      if (focus == cell_place{r, i}) panel::frame(part, 2, panel_colours.focus);
    }
  }
  const int all = static_cast<int>(rows.size()) * row_height + 2 * panel_margin;
  if (all > p.height())  // how much of it is seen
    paint(part_of(p, {p.width() - 5, p.height() * scrolled / all}, {4, p.height() * p.height() / all}),
          panel_colours.on);
}

/// The name of a view in its upper corner; that of the chosen one is bright.
inline void draw_view_name(irg::image_view<irg::rgba8> p, std::string_view name, bool chosen) {
  const auto box = part_of(p, {0, 0}, {104, row_height + 2});
  paint(box, chosen ? panel_colours.on : panel_colours.button);
  panel::text_in(box, name, irg::text_along::centre, chosen ? panel_colours.white : panel_colours.ink);
  paint(part_of(p, {0, 0}, {1, p.height()}), panel_colours.line);
}

/// What keys and the mouse do, in two columns.
inline void draw_keys(irg::image_view<irg::rgba8> p) {
  paint(p, panel_colours.paper);
  int y = 8;
  for (const studio_key& k : studio_keys) {
    panel::text_in(part_of(p, {10, y}, {190, row_height}), k.key, irg::text_along::left, panel_colours.ink, 1.7);
    panel::text_in(part_of(p, {200, y}, {p.width() - 200, row_height}), k.what, irg::text_along::left,
                   panel_colours.ink);
    y += row_height;
  }
}

/// The line below: what is being typed, or how to begin, and why the last line could not be.
inline void draw_line_below(irg::image_view<irg::rgba8> p, const std::optional<typed_line>& typed,
                            std::string_view sentence) {
  if (p.width() <= 0 || p.height() <= 0) return;
  paint(p, typed ? panel_colours.white : panel_colours.button);
  paint(part_of(p, {0, 0}, {p.width(), 1}), panel_colours.line);
  const double wide = sentence.empty() ? 0 : irg::measure_text(sentence, 14).width + 16;
  panel::text_in(p, sentence, irg::text_along::right, panel_colours.focus, 0, 14);
  const int room = p.width() - static_cast<int>(wide) - 8;
  auto left = part_of(p, {8, 0}, {room, p.height()});
  if (!typed)
    return panel::text_in(left, "Return: a line of the script    F1: all keys    F2: panels by keys    Escape: end",
                          irg::text_along::left, panel_colours.faint);
  // The cursor is kept in sight.
  const double before = irg::measure_text(std::string_view(typed->text).substr(0, typed->cursor), 14).width;
  const double from = std::min(3.0, room - 12 - before);
  irg::draw_text(left, typed->text, {from, left.height() / 2.0}, {.size = 14, .across = irg::text_across::middle},
                 panel_colours.ink);
  paint(part_of(left, {static_cast<int>(from + before), 4}, {2, left.height() - 8}), panel_colours.focus);
}

}  // namespace program
