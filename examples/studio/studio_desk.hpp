// SPDX-License-Identifier: MIT
// The studio with its panels, as keys and the mouse change it. Whatever they do is said as a line of the script, and
// done by it. Nothing here knows of windows.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "panel_drawing.hpp"
#include "studio_session.hpp"
#include "studio_view_panel.hpp"

namespace program {

class studio_desk {
public:
  explicit studio_desk(studio_session& session) : session_(session) {}

  void resize(int width, int height) {
    width_ = width, height_ = height;
    if (picture_.width() == width && picture_.height() == height) return;
    picture_ = irg::image<irg::rgba8>(width, height);
    session_.resize(width, height);
  }
  irg::image<irg::rgba8>& draw() {
    lay_out();
    const auto all = picture_.view();
    const int left = panels_left(), bottom = std::max(height_ - line_height, 1);
    for (const irg::studio_view v : {irg::studio_view::main, irg::studio_view::outer}) {
      const int from = view_left(v), to = v == irg::studio_view::main ? view_left(irg::studio_view::outer) : width_;
      const auto part = part_of(all, {from, 0}, {to - from, bottom});
      session_.draw(part, v);
      if (left > 0)
        draw_view_name(part, v == irg::studio_view::main ? "main camera" : "outer camera", v == choice_.view);
    }
    if (left > 0) {
      for (std::size_t i = 0; i < 2; ++i)
        draw_panel(part_of(all, {0, panels_[i].top}, {left, panels_[i].height}), panels_[i].rows, panels_[i].scrolled,
                   focus_ && focus_->panel == i ? std::optional(focus_->at) : std::nullopt);
      paint(part_of(all, {left - 1, 0}, {1, bottom}), panel_colours.line);
    }
    if (help_) draw_keys(part_of(all, {left, 0}, {width_ - left, bottom}));
    draw_line_below(part_of(all, {0, bottom}, {width_, height_ - bottom}), typed_, session_.sentence());
    return picture_;
  }

  /// A key by its name in small letters, `shift-` before it where that is held; false at the end.
  bool key(std::string_view name) {
    lay_out();
    if (name == "f7") return save_window(), true;
    if (typed_) return key_while_typing(name), true;
    if (name == "escape") return false;
    if (focus_ && key_in_panel(name)) return true;
    if (key_of_desk(name) || key_of_view(name)) return true;
    if (const auto* b = chosen_body()) key_of_body(name, *b);
    return true;
  }
  /// Text that was typed.
  void type(std::string_view text) {
    if (typed_) typed_->insert(text);
  }
  /// The mouse: a button pressed, the wheel turned upwards by steps, the mouse moved with a button held.
  void press(int x, int y, bool only_holds = false) {
    lay_out();
    held_.reset();
    if (only_holds && (y >= height_ - line_height || x < panels_left())) return;
    if (y >= height_ - line_height) return open_line("");
    if (x >= panels_left()) {
      held_ = choice_.view = view_at(x);
      focus_.reset();
      return;
    }
    const std::size_t i = y < panels_[1].top ? 0 : 1;
    if (const auto at = cell_at(panels_[i].rows, x, y - panels_[i].top + panels_[i].scrolled)) {
      focus_ = focus{i, *at};
      press_cell(panels_[i].rows[at->row].cells[at->cell]);
    }
  }
  void wheel(int x, int y, int steps) {
    lay_out();
    if (x >= panels_left()) {
      say("orbit " + std::string(panel::name_of(view_at(x))) + " 0 0 " + (steps > 0 ? "0.9" : "1.1"));
      return;
    }
    if (y >= height_ - line_height) return;
    shown_panel& p = panels_[y < panels_[1].top ? 0 : 1];
    if (const auto at = cell_at(p.rows, x, y - p.top + p.scrolled)) {
      const panel_cell c = p.rows[at->row].cells[at->cell];
      if (!c.more.empty()) {
        say(steps > 0 ? c.more : c.less);
        return;
      }
    }
    p.scrolled = std::clamp(p.scrolled - steps * 2 * row_height, 0, p.hidden());
  }
  void drag(int dx, int dy, bool sideways) {
    if (!held_) return;
    const std::string view = panel::name_of(*held_);
    if (sideways)
      say(sideways_line(view, dx, dy));
    else
      say("orbit " + view + " " + std::to_string(-dx) + " " + std::to_string(dy));
  }
  void drop_file(const std::string& file) { say("load \"" + file + "\""); }

private:
  struct focus {
    std::size_t panel = 0;
    cell_place at{};
  };
  struct shown_panel {
    panel_rows rows{};
    int top = 0, height = 0, scrolled = 0;
    int hidden() const { return std::max(static_cast<int>(rows.size()) * row_height + 2 * panel_margin - height, 0); }
  };

  const irg::studio_body<double>* chosen_body() const {
    const auto& bodies = session_.state().bodies;
    return choice_.body < bodies.size() ? &bodies[choice_.body] : nullptr;
  }
  int panels_left() const { return show_panels_ && width_ >= 2 * panel_width ? panel_width : 0; }
  int view_left(irg::studio_view v) const {
    const int left = panels_left();
    return v == irg::studio_view::main ? left : left + (width_ - left) / 2;
  }
  irg::studio_view view_at(int x) const {
    return x < view_left(irg::studio_view::outer) ? irg::studio_view::main : irg::studio_view::outer;
  }

  // The panels of the state, and what was chosen as far as it is still there.
  void lay_out() {
    const auto& bodies = session_.state().bodies;
    choice_.body = bodies.empty() ? 0 : std::min(choice_.body, bodies.size() - 1);
    const std::size_t count = bodies.empty() ? 0 : list().size();
    choice_.transformation = count == 0 ? 0 : std::min(choice_.transformation, count - 1);
    panels_[0].rows = transformation_panel(session_.state(), choice_);
    panels_[1].rows = view_panel(session_.state(), choice_);
    const int all = std::max(height_ - line_height, 0);
    panels_[1].height = std::min(23 * row_height + 2 * panel_margin, all * 3 / 5);
    panels_[0].height = panels_[1].top = all - panels_[1].height;
    for (shown_panel& p : panels_) p.scrolled = std::clamp(p.scrolled, 0, p.hidden());
    if (focus_) focus_->at = nearest_cell(panels_[focus_->panel].rows, focus_->at);
  }
  const std::vector<irg::studio_transformation<double>>& list() const {
    return session_.state().bodies[choice_.body].transformations[static_cast<std::size_t>(choice_.stage)];
  }

  void press_cell(const panel_cell& c) {
    const std::string edit = c.edit, press = c.press;  // copies: what is said makes new panels
    if (c.choice) choice_ = *c.choice;
    if (!edit.empty()) return open_line(edit);
    if (!press.empty()) say(press);
  }
  void open_line(const std::string& text) {
    typed_.emplace();
    typed_->insert(text);
  }

  void key_while_typing(std::string_view name) {
    if (name == "escape") return typed_.reset();
    if (name != "return") return typed_->key(name);
    const std::string text = typed_->text;
    if (text.find_first_not_of(' ') == text.npos || say(text)) typed_.reset();
  }

  bool key_in_panel(std::string_view name) {
    shown_panel& p = panels_[focus_->panel];
    const panel_cell c = p.rows[focus_->at.row].cells[focus_->at.cell];
    const bool moves = name == "left" || name == "right" || name == "up" || name == "down";
    if (moves) {
      focus_->at = cell_beside(p.rows, focus_->at, name);
      const int top = static_cast<int>(focus_->at.row) * row_height;
      p.scrolled = std::clamp(p.scrolled, top + row_height + 2 * panel_margin - p.height, top);
      p.scrolled = std::clamp(p.scrolled, 0, p.hidden());
    } else if (name == "return") {
      press_cell(c);
    } else if ((name == "+" || name == "-") && !c.more.empty()) {
      say(name == "+" ? c.more : c.less);
    } else {
      return false;
    }
    return true;
  }

  bool key_of_desk(std::string_view k) {
    const std::size_t count = session_.state().bodies.size();
    if (k == "f1") return help_ = !help_, true;
    if (k == "f2") return next_focus(), true;
    if (k == "f4") return show_panels_ = !show_panels_, focus_.reset(), true;
    if (k == "return") return open_line(""), true;
    if (k == "f5") return say("save studio.xml"), true;
    if (k == "f6") return say("picture studio.png"), true;
    if (k == "f8") return say("restore studio.xml"), true;
    if (k == "tab" && count > 0) return choice_.body = (choice_.body + 1) % count, true;
    if (k == "shift-tab" && count > 0) return choice_.body = (choice_.body + count - 1) % count, true;
    if (k == "w") return choose_stage(other_stage()), true;
    return false;
  }
  void next_focus() {
    if (panels_left() == 0) return;
    if (!focus_)
      focus_ = focus{};
    else if (focus_->panel == 0)
      focus_ = focus{1, {}};
    else
      focus_.reset();
    lay_out();
  }
  irg::studio_stage other_stage() const {
    return choice_.stage == irg::studio_stage::before ? irg::studio_stage::after : irg::studio_stage::before;
  }
  void choose_stage(irg::studio_stage stage) {
    choice_.stage = stage;
    choice_.transformation = chosen_body() == nullptr || list().empty() ? 0 : list().size() - 1;
  }

  // Keys about the chosen view.
  bool key_of_view(std::string_view k) {
    const std::string view = panel::name_of(choice_.view);
    const irg::studio_camera<double>& c = session_.state().of(choice_.view);
    constexpr std::pair<const char*, const char*> orbits[] = {{"j", "-5 0"}, {"l", "5 0"},     {"i", "0 5"},
                                                              {"k", "0 -5"}, {"n", "0 0 0.9"}, {"m", "0 0 1.1"}};
    for (const auto& [name, by] : orbits)
      if (k == name) return say("orbit " + view + " " + by), true;
    if (k == "v") {
      choice_.view = choice_.view == irg::studio_view::main ? irg::studio_view::outer : irg::studio_view::main;
    } else if (k == "p") {
      constexpr const char* kinds[] = {"perspective", "orthographic", "cavalier", "cabinet",
                                       "isometric",   "dimetric",     "trimetric"};
      say("project " + view + " " + kinds[kind_ = (kind_ + 1) % 7]);
    } else if (k == "h") {
      const bool on = c.shows(irg::studio_helper::world_axes);
      for (const char* what : {"axes", "pyramid"}) say("helper " + view + " " + what + (on ? " off" : " on"));
    } else if (k == "g") {
      say("lamp " + std::to_string(session_.state().lamps.size() + 1) + words_of(c.eye) + " 1 0.5 0.5 0.5");
    } else if (k == "shift-g") {
      say("drop-lamp " + std::to_string(std::max<std::size_t>(session_.state().lamps.size(), 1)));
    } else {
      return false;
    }
    return true;
  }

  // Keys about the chosen body and the chosen one of its transformations.
  void key_of_body(std::string_view k, const irg::studio_body<double>& b) {
    constexpr std::pair<const char*, const char*> additions[] = {{"left", "translate -0.25 0 0"},
                                                                 {"right", "translate 0.25 0 0"},
                                                                 {"up", "translate 0 0.25 0"},
                                                                 {"down", "translate 0 -0.25 0"},
                                                                 {"pageup", "translate 0 0 -0.25"},
                                                                 {"pagedown", "translate 0 0 0.25"},
                                                                 {"x", "rotate-x 15"},
                                                                 {"y", "rotate-y 15"},
                                                                 {"z", "rotate-z 15"},
                                                                 {"shift-x", "rotate-x -15"},
                                                                 {"shift-y", "rotate-y -15"},
                                                                 {"shift-z", "rotate-z -15"},
                                                                 {"r", "rotate-y 15"},
                                                                 {"+", "scale 1.25 1.25 1.25"},
                                                                 {"-", "scale 0.8 0.8 0.8"}};
    constexpr const char* colours[] = {"255 255 255", "205 128 70", "60 120 200", "80 160 90",
                                       "220 200 90",  "200 70 60",  "150 90 180", "90 96 110"};
    const std::string name = " " + quoted(b) + " ", stage = panel::name_of(choice_.stage);
    const std::size_t shading = static_cast<std::size_t>(b.shading), chosen = choice_.transformation + 1;
    const std::string at = name + stage + " " + std::to_string(chosen);
    for (const auto& [key, what] : additions)
      if (k == key) say(joined({"add", name, stage, " ", what}));
    if (k == "a") say("add" + name + "after rotate-z 15");
    if (k.size() == 1 && k[0] >= '1' && k[0] <= '4') {
      const auto i = static_cast<std::size_t>(k[0] - '1');
      say("show" + name + panel::part_names[i] + panel::switched(b.parts[i]));
    }
    if (k == "s") say("shade" + name + panel::shading_names[(shading + 1) % 4]);
    if (k == "t") say("opacity" + name + (b.opacity < 1 ? "1" : "0.5"));
    if (k == "c") say("colour" + name + colours[colour_ = (colour_ + 1) % 8]);
    if (k == "[" || k == "]") choose_transformation(k == "]");
    if (k == "u" && chosen > 1) say("move" + at + " " + std::to_string(chosen - 1));
    if (k == "d" && chosen < list().size()) say("move" + at + " " + std::to_string(chosen + 1));
    if (k == "b") say("move" + at + " 1");
    if (k == "backspace") say("remove" + at);
    if (k == "delete") say("drop " + quoted(b));
  }
  // The next one or the one before, through both lists.
  void choose_transformation(bool next) {
    if (next && choice_.transformation + 1 < list().size()) {
      ++choice_.transformation;
    } else if (!next && choice_.transformation > 0) {
      --choice_.transformation;
    } else {
      choose_stage(other_stage());
      if (next) choice_.transformation = 0;
    }
  }

  // Eye and target go sideways by as much as the mouse does at the target's distance.
  std::string sideways_line(const std::string& view, int dx, int dy) const {
    irg::studio_camera<double> c = session_.state().of(*held_);
    const auto f = irg::look_at_frame(c.eye, c.target, c.up);
    const double pixel = irg::length(c.target - c.eye) * c.pyramid.height / c.pyramid.distance / std::max(height_, 1);
    const auto by = f.right * (-dx * pixel) + f.up * (dy * pixel);
    c.eye = c.eye + by, c.target = c.target + by;
    for (int k = 0; k < 3; ++k) c.eye[k] = panel::rounded(c.eye[k], 8), c.target[k] = panel::rounded(c.target[k], 8);
    return panel::aim_line(view, c);
  }

  // Says a line and does it; whether it could be. What it was about is the choice from then on.
  bool say(const std::string& text) {
    std::string why;
    const auto commands = irg::read_studio_script<double>(text);
    if (!commands) {
      session_.refuse(why = commands.error().message);
    } else {
      for (const auto& c : *commands) {
        why = session_.run(c);
        if (why.empty()) choose_from(c);
      }
    }
    std::printf("%s%s%s\n", text.c_str(), why.empty() ? "" : "  # refused: ", why.c_str());
    std::fflush(stdout);
    return why.empty();
  }
  void choose_from(const irg::studio_command<double>& c) {
    const auto& bodies = session_.state().bodies;
    if (c.action == irg::studio_action::load && !bodies.empty()) choice_.body = bodies.size() - 1;
    const auto choose = [&](const irg::part_name& name, irg::studio_stage stage, std::size_t which) {
      if (const auto i = irg::find_body(session_.state(), name)) choice_.body = *i;
      choice_.stage = stage;
      choice_.transformation = which;
    };
    if (const auto* e = std::get_if<irg::add_transformation<double>>(&c.event))
      choose(e->name, e->stage, std::size_t(-1));
    if (const auto* e = std::get_if<irg::change_transformation<double>>(&c.event)) choose(e->name, e->stage, e->which);
    if (const auto* e = std::get_if<irg::move_transformation>(&c.event)) choose(e->name, e->stage, e->to);
    if (const auto* e = std::get_if<irg::remove_transformation>(&c.event)) choose(e->name, e->stage, e->which);
    lay_out();
  }
  void save_window() { session_.write_picture("studio_window.png", draw()); }

  studio_session& session_;
  irg::image<irg::rgba8> picture_{};
  int width_ = 0, height_ = 0;
  studio_choice choice_{};
  std::array<shown_panel, 2> panels_{};
  std::optional<focus> focus_{};
  std::optional<irg::studio_view> held_{};  // the view in which a button was pressed
  std::optional<typed_line> typed_{};
  bool show_panels_ = true, help_ = false;
  std::size_t kind_ = 0, colour_ = 0;
};

}  // namespace program
