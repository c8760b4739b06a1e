// SPDX-License-Identifier: MIT
// Panels of the studio as rows of cells, each with the lines of the script that it says, and the panel of
// transformations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "studio.hpp"

#include "../support/number_output.hpp"

namespace program {

/// How a cell looks. Switches are on or off; a value is a number that can be changed, a reading one that cannot, or the
/// name of a column.
enum class cell_look { label, reading, heading, button, off, on, value };

/// What keys and panels are about.
struct studio_choice {
  std::size_t body = 0, transformation = 0;
  irg::studio_stage stage = irg::studio_stage::before;  // of the transformation; new ones go there, too
  irg::studio_view view = irg::studio_view::main;
  bool operator==(const studio_choice&) const = default;
};

/// A cell. Pressing it says `press`, or opens `edit` to be changed, or makes `choice` the choice; minus and plus, and the
/// wheel, say `less` and `more`.
struct panel_cell {
  std::string text{};
  int left = 0, width = 0;
  cell_look look = cell_look::label;
  std::string press{}, edit{}, less{}, more{};
  std::optional<studio_choice> choice{};

  bool can_be_pressed() const { return !press.empty() || !edit.empty() || choice; }
};

/// A row; the chosen one is bright.
struct panel_row {
  std::vector<panel_cell> cells{};
  bool chosen = false;
};

using panel_rows = std::vector<panel_row>;

inline constexpr int panel_width = 344, panel_margin = 6;

/// The parts of a line of a script as one text.
inline std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

/// The name of a body as a word of a script.
inline std::string quoted(const irg::studio_body<double>& b) { return "\"" + std::string(b.body.name) + "\""; }

/// Numbers as words of a script, a blank before each: the first ones of an array, or the three of a place or direction.
template <std::size_t N>
std::string words_of(const std::array<double, N>& numbers, std::size_t count = N) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += " " + shortest(numbers[i]);
  return text;
}
template <class Triple>
std::string words_of(const Triple& v) {
  return words_of(std::array<double, 3>{v[0], v[1], v[2]});
}

namespace panel {

using irg::studio_stage;
using irg::studio_view;
using body = irg::studio_body<double>;
using transformation = irg::studio_transformation<double>;

// A number in few digits: as it is shown, and what a step leads to.
inline std::string shown(double v, int digits = 4) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, v == 0 ? 0 : v);
  return text;
}
inline double rounded(double v, int digits) { return std::strtod(shown(v, digits).c_str(), nullptr); }
inline double next_of(double v, double step, int way) { return rounded((std::floor(v / step + 0.5) + way) * step, 10); }
inline double grown(double v, int way) {
  if (v == 0) return 0.1 * way;
  return rounded(way > 0 ? v * 1.25 : v * 0.8, 3);
}

// Puts cells side by side.
class row_writer {
public:
  explicit row_writer(panel_rows& rows) : row_(rows.emplace_back()) {}

  row_writer& skip(int width) { return left_ += width, *this; }
  row_writer& chosen(bool is) { return row_.chosen = is, *this; }
  row_writer& add(std::string text, int width, cell_look look) {
    row_.cells.push_back({std::move(text), left_, width, look});
    return skip(width);
  }
  row_writer& label(std::string text, int width) { return add(std::move(text), width, cell_look::label); }
  row_writer& reading(std::string text, int width) { return add(std::move(text), width, cell_look::reading); }
  row_writer& heading(std::string text, int width = panel_width) {
    return add(std::move(text), width, cell_look::heading);
  }
  row_writer& button(std::string text, int width, std::string press) {
    add(std::move(text), width, cell_look::button);
    return row_.cells.back().press = std::move(press), *this;
  }
  row_writer& change(std::string text, int width, bool on, std::string press) {
    add(std::move(text), width, on ? cell_look::on : cell_look::off);
    return row_.cells.back().press = std::move(press), *this;
  }
  row_writer& choose(std::string text, int width, cell_look look, const studio_choice& choice) {
    add(std::move(text), width, look);
    return row_.cells.back().choice = choice, *this;
  }
  // A number: line_of(number) is the line that makes it another one, to(number, way) the next one.
  template <class LineOf, class To>
  row_writer& value(double v, int width, const LineOf& line_of, const To& to) {
    add(shown(v), width, cell_look::value);
    panel_cell& c = row_.cells.back();
    c.edit = line_of(v);
    c.less = line_of(to(v, -1));
    c.more = line_of(to(v, 1));
    return *this;
  }

private:
  panel_row& row_;
  int left_ = panel_margin;
};

// Steps of a number, and such that do not leave a range.
inline auto by(double step) {
  return [step](double v, int way) { return next_of(v, step, way); };
}
inline auto by_within(double step, double low, double high) {
  return [=](double v, int way) { return std::clamp(next_of(v, step, way), low, high); };
}

inline const char* name_of(studio_stage s) { return s == studio_stage::before ? "before" : "after"; }
inline const char* name_of(studio_view v) { return v == studio_view::main ? "main" : "outer"; }
// What a number of a transformation is stepped by.
inline double next_number(const transformation& t, std::size_t i, double v, int way) {
  switch (t.kind) {
    case irg::studio_map::scale: return grown(v, way);
    case irg::studio_map::rotate_x:
    case irg::studio_map::rotate_y:
    case irg::studio_map::rotate_z: return next_of(v, 5, way);
    case irg::studio_map::rotate: return next_of(v, i == 3 ? 5 : 0.25, way);
    case irg::studio_map::shear:
    case irg::studio_map::matrix: return next_of(v, 0.1, way);
    default: return next_of(v, 0.25, way);
  }
}

// One transformation: number, kind, its numbers by four, and its way up, down and out of the list.
inline void transformation_rows(panel_rows& rows, const body& b, std::size_t i, const studio_choice& choice,
                                studio_choice at) {
  at.transformation = i;
  const auto& list = b.transformations[static_cast<std::size_t>(at.stage)];
  const irg::studio_map_form& form = irg::studio_maps[static_cast<std::size_t>(list[i].kind)];
  const std::string where = " " + quoted(b) + " " + name_of(at.stage) + " ", number = std::to_string(i + 1);
  for (std::size_t first = 0; first < form.numbers; first += 4) {
    row_writer row(rows);
    row.chosen(at == choice);
    if (first == 0)
      row.choose(number + " " + std::string(form.name), 92, cell_look::label, at);
    else
      row.skip(92);
    for (std::size_t k = first; k < std::min(first + 4, form.numbers); ++k)
      row.value(
          list[i].numbers[k], 44,
          [&](double v) {
            transformation t = list[i];
            t.numbers[k] = v;
            return joined({"change", where, number, " ", form.name, words_of(t.numbers, form.numbers)});
          },
          [&](double v, int way) { return next_number(list[i], k, v, way); });
    if (first != 0) continue;
    row.skip(44 * (4 - static_cast<int>(std::min(form.numbers, std::size_t{4}))) + 4);
    row.button("^", 20, joined({"move", where, number, " ", std::to_string(i == 0 ? 1 : i)}));
    row.button("v", 20, joined({"move", where, number, " ", std::to_string(std::min(i + 2, list.size()))}));
    row.button("x", 20, joined({"remove", where, number}));
  }
}

inline void adding_rows(panel_rows& rows, const body& b, const studio_choice& choice) {
  const std::string start = "add " + quoted(b) + " " + name_of(choice.stage) + " ";
  const auto six = [&](const char* label, const auto& line_of) {
    row_writer row(rows);
    row.label(label, 46);
    for (int k = 0; k < 6; ++k)
      row.button(std::string(1, "xyz"[k / 2]) + (k % 2 == 0 ? "-" : "+"), 35, start + line_of(k / 2, k % 2 == 0));
    return row;
  };
  six("turn", [](int axis, bool back) { return std::string("rotate-") + "xyz"[axis] + (back ? " -15" : " 15"); });
  six("move", [](int axis, bool back) {
    std::array<double, 3> by{};
    by[static_cast<std::size_t>(axis)] = back ? -0.25 : 0.25;
    return "translate" + words_of(by);
  });
  six("scale",
      [](int axis, bool back) {
        std::array<double, 3> by{1, 1, 1};
        by[static_cast<std::size_t>(axis)] = back ? 0.8 : 1.25;
        return "scale" + words_of(by);
      })
      .skip(4)
      .button("all-", 36, start + "scale 0.8 0.8 0.8")
      .button("all+", 36, start + "scale 1.25 1.25 1.25");
  row_writer(rows)
      .label("other", 46)
      .button("axis", 36, start + "rotate 1 1 1 30")
      .button("shear", 44, start + "shear 0.5 0 0 0 0 0")
      .button("mirror", 46, start + "mirror 1 0 0 0")
      .button("parallel", 56, start + "parallel 0 1 0 1 1 -2 1")
      .button("central", 52, start + "central 0 1 0 1 0 10 0")
      .button("matrix", 50, start + "matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
}

}  // namespace panel

/// The panel of bodies and of the chosen one's two lists of transformations.
inline panel_rows transformation_panel(const irg::studio<double>& s, const studio_choice& choice) {
  using namespace panel;
  panel_rows rows;
  row_writer files(rows);
  files.heading("Bodies", 88);
  for (const char* shape : {"teapot", "cube", "sphere", "torus"})
    files.button(std::string("+ ") + shape, 61, std::string("load ") + shape);
  for (std::size_t i = 0; i < s.bodies.size(); ++i) {
    studio_choice other = choice;
    other.body = i;
    row_writer(rows)
        .chosen(i == choice.body)
        .choose(std::string(s.bodies[i].body.name), 276, cell_look::label, other)
        .skip(8)
        .button("drop", 48, "drop " + quoted(s.bodies[i]));
  }
  if (choice.body >= s.bodies.size()) {
    row_writer(rows).label("none: load one, or drop a file on the window", panel_width);
    return rows;
  }
  const body& b = s.bodies[choice.body];
  row_writer stages(rows);
  stages.heading("Add a transformation", 140);
  for (const studio_stage stage : {studio_stage::before, studio_stage::after}) {
    studio_choice other = choice;
    other.stage = stage;
    const std::size_t count = b.transformations[static_cast<std::size_t>(stage)].size();
    other.transformation = count == 0 ? 0 : count - 1;
    stages.choose(std::string(name_of(stage)) + " camera", 96, stage == choice.stage ? cell_look::on : cell_look::off,
                  stage == choice.stage ? choice : other);
  }
  adding_rows(rows, b, choice);
  for (const studio_stage stage : {studio_stage::before, studio_stage::after}) {
    const auto& list = b.transformations[static_cast<std::size_t>(stage)];
    row_writer(rows).heading(stage == studio_stage::before ? "Before the camera: in the world"
                                                           : "After it: in the camera's coordinates");
    if (list.empty()) row_writer(rows).label("none", 60);
    studio_choice at = choice;
    at.stage = stage;
    for (std::size_t i = 0; i < list.size(); ++i) transformation_rows(rows, b, i, choice, at);
  }
  return rows;
}

}  // namespace program
