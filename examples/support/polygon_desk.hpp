// SPDX-License-Identifier: MIT
// A polygon drawn with the mouse, vertex by vertex, and a point that is asked for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <irg/io/image_file.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>

#include "number_output.hpp"

namespace program {

/// Which way y points: the pixels' rows downwards, or upwards from the lowest row.
enum class y_axis { down, up };

/// What the polygon's program knows of it.
/// needs   refusal(ring): why it cannot be answered for, or nothing; report(ring, point): the lines of the answer;
///         spans(ring, window, sink): its pixels, for a ring that is not refused
template <class Answers>
class polygon_desk {
public:
  using point = irg::point<double, 2>;

  polygon_desk(const Answers& answers, y_axis y, std::string file) : answers_(answers), y_(y), file_(std::move(file)) {}

  void resize(int width, int height) {
    if (picture_.width() != width || picture_.height() != height) picture_ = irg::image<irg::rgba8>(width, height);
  }

  irg::image<irg::rgba8>& draw() {
    constexpr irg::rgba8 paper{250, 249, 246, 255}, ink{32, 44, 66, 255}, blue{146, 184, 222, 255};
    constexpr irg::rgba8 red{204, 96, 72, 255};
    irg::clear(picture_, paper);
    if (answers_.refusal(ring_).empty())
      answers_.spans(ring_, {0, 0, picture_.width(), picture_.height()}, [&](const irg::span_of_cells& s) {
        irg::fill_span(picture_, {row(s.y), s.x_first, s.x_last}, blue);
      });
    for (std::size_t i = 0; i + 1 < ring_.size() + (is_closed_ ? 1 : 0); ++i)
      irg::draw_line(picture_, pixel(ring_[i]), pixel(ring_[(i + 1) % ring_.size()]), ink);
    for (const point& v : ring_) dot(pixel(v), 2, ink);
    for (int d = -5; d <= 5; ++d) {
      dot({pixel(asked_).x + d, pixel(asked_).y + d}, 0, red);
      dot({pixel(asked_).x + d, pixel(asked_).y - d}, 0, red);
    }
    int y = 6;
    const auto text = [&](std::string_view line, irg::rgba8 colour) {
      irg::draw_text(picture_, line, {8, static_cast<double>(y)}, {.size = 15, .across = irg::text_across::top},
                     colour);
      y += 19;
    };
    if (!sentence_.empty()) text(sentence_, red);
    text(is_closed_ ? "Delete: anew    right button: the point    F6: picture    Escape: end"
                    : "left button: a vertex    Backspace: one less    right button: the point    Return: close",
         ink);
    if (!is_closed_) return picture_;
    const std::string report = answers_.report(ring_, asked_);
    for (std::size_t at = 0; at < report.size() && y < picture_.height();) {
      const std::size_t end = std::min(report.find('\n', at), report.size());
      const std::string_view line = std::string_view(report).substr(at, end - at);
      if (!line.starts_with("edge:")) text(line, ink);
      at = end + 1;
    }
    return picture_;
  }

  /// A vertex at a pixel; one behind the end of a closed polygon begins another.
  void add_vertex(int x, int y) {
    if (is_closed_) begin_anew();
    sentence_.clear();
    ring_.push_back(position(x, y));
    say("vertex: ", ring_.back());
  }
  /// The point that is asked for, at a pixel.
  void ask(int x, int y) {
    asked_ = position(x, y);
    say("asked: ", asked_);
    if (is_closed_) answer();
  }
  /// A key by its name in small letters; false at the end.
  bool key(std::string_view name) {
    if (name == "escape") return false;
    if (name == "return") close();
    if (name == "delete") begin_anew(), std::puts("anew");
    if (name == "backspace" && !ring_.empty()) ring_.pop_back(), is_closed_ = false, std::puts("one less");
    if (name == "f6") save();
    std::fflush(stdout);
    return true;
  }

private:
  int row(int y) const { return y_ == y_axis::down ? y : picture_.height() - 1 - y; }
  irg::cell pixel(const point& p) const { return {static_cast<int>(p.x), row(static_cast<int>(p.y))}; }
  point position(int x, int y) const { return {static_cast<double>(x), static_cast<double>(row(y))}; }
  void dot(const irg::cell& at, int reach, irg::rgba8 colour) {
    for (int y = at.y - reach; y <= at.y + reach; ++y)
      irg::fill_span(picture_, {y, at.x - reach, at.x + reach + 1}, colour);
  }

  static void say(const char* what, const point& p) {
    std::printf("%s%s %s\n", what, shortest(p.x).c_str(), shortest(p.y).c_str());
    std::fflush(stdout);
  }
  void close() {
    sentence_ = answers_.refusal(ring_);
    is_closed_ = sentence_.empty();
    if (is_closed_)
      answer();
    else
      std::printf("refused: %s\n", sentence_.c_str());
  }
  // The numbers, as the program reads them, and what it says to them.
  void answer() {
    std::string text = "input: " + std::to_string(ring_.size());
    for (const point& p : ring_) text += " " + shortest(p.x) + " " + shortest(p.y);
    text += " " + shortest(asked_.x) + " " + shortest(asked_.y) + "\n" + answers_.report(ring_, asked_);
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
  }
  void begin_anew() {
    ring_.clear();
    sentence_.clear();
    is_closed_ = false;
  }
  void save() {
    const auto saved = irg::save_image(file_, draw());
    if (!saved) sentence_ = std::string(saved.error().message) + ": " + file_;
    std::printf("%s%s\n", saved ? "picture: " : "refused: ", saved ? file_.c_str() : sentence_.c_str());
  }

  const Answers& answers_;
  y_axis y_;
  std::string file_;
  std::vector<point> ring_{};
  point asked_{};
  bool is_closed_ = false;
  std::string sentence_{};
  irg::image<irg::rgba8> picture_{};
};

}  // namespace program
