// SPDX-License-Identifier: MIT
// convex_polygon - which way round a polygon runs, whether it is convex, its edges, where a point lies, and its pixels.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <irg/geometry/edge_equation.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_convexity.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/textbook/fill_convex.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/triangle_coverage.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/polygon_desk.hpp"
#include "support/run_or_fail.hpp"
#ifdef IRG_HAVE_SDL2
#include "support/polygon_window.hpp"
#endif

namespace {

constexpr std::string_view help =
    R"(convex_polygon - a polygon's orientation, convexity, edges and pixels, and where a point lies

usage: convex_polygon [options] <NUMBERS

Reads n, at least 3, then x y of each of the n vertices, then x y of a point, from standard input. Vertices may have
decimals and reach from -2097152 to 2097152; to be filled they are rounded to 1/256. y points up, but down with --rule
top-left.

  --input FILE         read the numbers from FILE
  --rule RULE          which pixels are filled (top-left):
                         top-left   centres (i+0.5, j+0.5) inside, or on a top or left edge
                         course     points (i, j) of rows from L to D, drawn if L < D
                         closed     points (i, j) inside and on the boundary
                         rounded    rows from L to D, both rounded, halves up, drawn if L < D
                         half-open  points (i, j) with L <= i < D, without the top row
                       A polygon that is not convex is filled by the non-zero rule with top-left, and refused by others.
  --list               print the filled rows instead: y, first x, last x (that pixel included)
  -o OUT               draw the polygon, enlarged where it is small: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
  --window             the vertices come from the mouse, a press of the left button each, in pixels of the window; a press
                       of the right button is the point. Return closes the polygon, of at least three vertices: the
                       numbers that would have been read are printed behind `input:`, then what is said to them. Backspace
                       takes the last vertex back, Delete all; F6 writes OUT, or convex_polygon.png; Escape ends
)";

enum class fill_choice { top_left, course, closed, rounded, half_open };

struct settings : program::drawing_options {
  fill_choice rule = fill_choice::top_left;
  bool window = false;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--rule") {
      s.rule = static_cast<fill_choice>(line.choice(word, {"top-left", "course", "closed", "rounded", "half-open"}));
    } else if (word == "--window") {
      s.window = program::can_show(line);
    } else {
      s.read(line, word);
    }
  }
  s.finish(line);
  if (s.window && (s.list || !s.input.empty())) line.fail("option --window goes with neither --list nor --input");
  return s;
}

using point = irg::point<double, 2>;

struct problem {
  std::vector<point> ring;
  std::vector<irg::subpixel> rounded;
  point p;
  bool convex = false;
};

constexpr const char* only_top_left = "the polygon is not convex; only --rule top-left fills such ones";
std::string too_few(std::size_t n) { return "a polygon has at least three vertices, not " + std::to_string(n); }

problem read_problem(program::command_line& line, const settings& s) {
  using program::number_input;
  problem out;
  number_input::prompt_if_terminal("number of vertices: ", s.input);
  number_input in(line, s.input);
  const int n = in.integer("n");
  if (n < 3) in.fail_at_word(n < 0 ? "n is less than 0" : too_few(static_cast<std::size_t>(n)));
  number_input::prompt_if_terminal("x y of each vertex: ", s.input);
  const auto coordinate = [&](const char* name, int i) {
    const std::string what = std::string(name) + " of vertex " + std::to_string(i + 1);
    const double v = in.number(what);
    if (!irg::can_snap(v)) in.fail_at_word(what + " is out of range, it is not from -2097152 to 2097152");
    return v;
  };
  for (int i = 0; i < n; ++i) {
    const double x = coordinate("x", i);
    out.ring.push_back({x, coordinate("y", i)});
    out.rounded.push_back(irg::snap(out.ring.back()));
  }
  out.convex = irg::is_convex(out.ring);
  if (!out.convex && s.rule != fill_choice::top_left) in.fail_at_word(only_top_left);
  number_input::prompt_if_terminal("x y of the point: ", s.input);
  out.p.x = in.number("x of the point");
  out.p.y = in.number("y of the point");
  in.expect_end();
  return out;
}

// The hull of the rounded vertices. Rounding may push vertices of a convex polygon in by 1/256, so that their edges'
// lines, which the textbook's fill makes endless, would cut deep.
std::vector<irg::subpixel> rounded_hull(const problem& in) {
  std::vector<irg::subpixel> points = in.rounded, hull;
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const irg::subpixel p : points) {
      while (hull.size() >= base + 2 && irg::twice_signed_area(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// The rows of a hull with the vertices of at least a triangle. Each row is given only the two edges that it crosses:
// asking every edge in every row, as the textbook does, takes hours for a million vertices.
template <class Sink>
void hull_spans(const std::vector<irg::subpixel>& hull, irg::textbook::sample_rule rule, const irg::cell_window& window,
                Sink&& sink) {
  const auto next = [&](std::size_t i) { return i + 1 == hull.size() ? 0 : i + 1; };
  const auto before = [&](std::size_t i) { return i == 0 ? hull.size() - 1 : i - 1; };
  // counter-clockwise: `right` goes up from the lowest vertex as `left` goes back
  std::size_t right = 0, left = 0;
  int top = hull[0].y;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const irg::subpixel v = hull[i], r = hull[right], l = hull[left];
    if (v.y < r.y || (v.y == r.y && v.x > r.x)) right = i;
    if (v.y < l.y || (v.y == l.y && v.x < l.x)) left = i;
    top = std::max(top, v.y);
  }
  const int y_first = std::max((hull[right].y + irg::one_pixel - 1) >> irg::subpixel_bits, window.y_first);
  const int y_last = std::min((top >> irg::subpixel_bits) + 1, window.y_last);
  for (int y = y_first; y < y_last; ++y) {
    const auto is_passed = [&](const irg::subpixel& v) { return v.y <= y * irg::one_pixel && v.y < top; };
    while (is_passed(hull[next(right)])) right = next(right);
    while (is_passed(hull[before(left)])) left = before(left);
    const irg::subpixel slab[] = {hull[right], hull[next(right)], hull[before(left)], hull[left]};
    irg::textbook::convex_spans(slab, rule, {window.x_first, y, window.x_last, y + 1}, sink);
  }
}

template <class Sink>
void filled_spans(const problem& in, fill_choice rule, const irg::cell_window& window, Sink&& sink) {
  if (rule == fill_choice::top_left) {
    if (in.convex)
      irg::convex_spans(in.rounded, window, sink);
    else
      irg::polygon_spans(in.rounded, irg::fill_rule::non_zero, window, sink);
    return;
  }
  const irg::textbook::sample_rule rules[] = {irg::textbook::sample_rule::course, irg::textbook::sample_rule::closed,
                                              irg::textbook::sample_rule::rounded,
                                              irg::textbook::sample_rule::half_open};
  const std::vector<irg::subpixel> hull = rounded_hull(in);
  const irg::textbook::sample_rule sampled = rules[static_cast<int>(rule) - 1];
  if (hull.size() < 3)
    irg::textbook::convex_spans(hull, sampled, window, sink);
  else
    hull_spans(hull, sampled, window, sink);
}

constexpr irg::cell_window everything{-irg::snap_limit - 2, -irg::snap_limit - 2, irg::snap_limit + 2,
                                      irg::snap_limit + 2};

// Where the picture shows what: `zoom` pixels a cell, the polygon's box in its middle.
class camera {
public:
  camera(const problem& in, const settings& s) : width_(s.size.width), height_(s.size.height), flip_(sample_points(s)) {
    std::int64_t low_x = 0, high_x = 256, low_y = 0, high_y = 256;
    if (!in.rounded.empty()) {
      low_x = high_x = in.rounded[0].x;
      low_y = high_y = in.rounded[0].y;
    }
    for (const irg::subpixel v : in.rounded) {
      low_x = std::min<std::int64_t>(low_x, v.x), high_x = std::max<std::int64_t>(high_x, v.x);
      low_y = std::min<std::int64_t>(low_y, v.y), high_y = std::max<std::int64_t>(high_y, v.y);
    }
    const std::int64_t cells_wide = (high_x - low_x) / 256 + 3, cells_high = (high_y - low_y) / 256 + 3;
    zoom_ = std::clamp<std::int64_t>(std::min(s.size.width / cells_wide, s.size.height / cells_high), 1, 64);
    left_ = (low_x + high_x) / 512 - s.size.width / zoom_ / 2;
    top_ =
        flip_ ? (low_y + high_y) / 512 + s.size.height / zoom_ / 2 : (low_y + high_y) / 512 - s.size.height / zoom_ / 2;
  }

  std::int64_t zoom() const { return zoom_; }
  // The cells that may be seen.
  irg::cell_window cells() const {
    const auto limited = [](std::int64_t v) {
      return static_cast<int>(std::clamp<std::int64_t>(v, everything.x_first, everything.x_last));
    };
    const std::int64_t across = width_ / zoom_ + 2, down = height_ / zoom_ + 2;
    return {limited(left_ - 1), limited(flip_ ? top_ - down : top_ - 1), limited(left_ + across),
            limited(flip_ ? top_ + 2 : top_ + down)};
  }
  // The first picture column and row of a cell.
  std::int64_t column(std::int64_t x) const { return (x - left_) * zoom_; }
  std::int64_t row(std::int64_t y) const { return (flip_ ? top_ - y : y - top_) * zoom_; }
  // The picture's pixel for a position; integer sample points stand in the middle of their cells.
  irg::cell pixel(double x, double y) const {
    const auto limited = [](double v) { return static_cast<int>(std::clamp(std::floor(v), -1e9, 1e9)); };
    const double z = static_cast<double>(zoom_), l = static_cast<double>(left_), t = static_cast<double>(top_);
    return {limited((x - l + (flip_ ? 0.5 : 0.0)) * z), limited((flip_ ? t - y + 0.5 : y - t) * z)};
  }

private:
  static bool sample_points(const settings& s) { return s.rule != fill_choice::top_left; }
  std::int64_t width_, height_, zoom_ = 1, left_ = 0, top_ = 0;
  bool flip_;
};

irg::image<irg::rgba8> picture_of(const problem& in, const settings& s) {
  constexpr irg::rgba8 paper{250, 249, 246, 255}, ink{32, 44, 66, 255}, blue{146, 184, 222, 255}, red{204, 96, 72, 255};
  irg::image<irg::rgba8> p(s.size.width, s.size.height, paper);
  const camera view(in, s);
  const std::int64_t side = view.zoom() < 8 ? view.zoom() : view.zoom() - 1;  // large cells stand apart
  filled_spans(in, s.rule, view.cells(), [&](const irg::span_of_cells& span) {
    const auto top = static_cast<int>(view.row(span.y)), bottom = static_cast<int>(view.row(span.y) + side);
    for (int y = top; y < bottom; ++y)
      for (int x = span.x_first; x < span.x_last; ++x) {
        const auto left = static_cast<int>(view.column(x));
        irg::fill_span(p, {y, left, static_cast<int>(left + side)}, blue);
      }
  });
  for (std::size_t i = 0; i < in.ring.size(); ++i) {
    const point a = irg::ring_vertex(in.ring, i), b = irg::ring_vertex(in.ring, i + 1);
    irg::draw_line(p, view.pixel(a.x, a.y), view.pixel(b.x, b.y), ink);
  }
  const irg::cell at = view.pixel(in.p.x, in.p.y);
  for (int d = -4; d <= 4; ++d)
    for (const irg::cell c : {irg::cell{at.x + d, at.y + d}, irg::cell{at.x + d, at.y - d}})
      if (c.x >= 0 && c.x < s.size.width && c.y >= 0 && c.y < s.size.height) p(c.x, c.y) = red;
  return p;
}

std::string report_of(const problem& in, fill_choice rule) {
  const char* const orientations[] = {"clockwise", "degenerate", "counter-clockwise"};
  const char* const locations[] = {"outside", "boundary", "inside"};
  std::string text = std::string("orientation: ") + orientations[static_cast<int>(irg::orientation_of(in.ring)) + 1];
  text += std::string("\nconvex: ") + (in.convex ? "yes" : "no") + "\n";
  for (std::size_t i = 0; i < in.ring.size(); ++i) {
    const auto e = irg::edge_through(irg::ring_vertex(in.ring, i), irg::ring_vertex(in.ring, i + 1));
    text += "edge: " + program::shortest(e.a) + " " + program::shortest(e.b) + " " + program::shortest(e.c) + "\n";
  }
  text += std::string("point: ") + locations[static_cast<int>(irg::locate_point(in.ring, in.p)) + 1] + "\n";
  std::int64_t pixels = 0;
  filled_spans(in, rule, everything, [&](const irg::span_of_cells& s) { pixels += s.x_last - s.x_first; });
  return text + "pixels: " + std::to_string(pixels) + "\n";
}

// What a polygon drawn with the mouse is answered with.
struct answers {
  fill_choice rule;

  static problem problem_of(const std::vector<point>& ring, const point& p) {
    problem out{ring, {}, p, irg::is_convex(ring)};
    for (const point& v : ring) out.rounded.push_back(irg::snap(v));
    return out;
  }
  std::string refusal(const std::vector<point>& ring) const {
    if (ring.size() < 3) return too_few(ring.size());
    return rule == fill_choice::top_left || irg::is_convex(ring) ? "" : only_top_left;
  }
  std::string report(const std::vector<point>& ring, const point& p) const {
    return report_of(problem_of(ring, p), rule);
  }
  template <class Sink>
  void spans(const std::vector<point>& ring, const irg::cell_window& window, const Sink& sink) const {
    filled_spans(problem_of(ring, {}), rule, window, sink);
  }
};

#ifdef IRG_HAVE_SDL2
void show(program::command_line& line, const settings& s) {
  const answers all{s.rule};
  program::polygon_desk desk(all, s.rule == fill_choice::top_left ? program::y_axis::down : program::y_axis::up,
                             s.out.empty() ? "convex_polygon.png" : s.out);
  program::show_polygon_window(line, desk, s.size.width, s.size.height);
  program::finish_output(line, "");
}
#endif

void run(program::command_line& line) {
  const settings s = read_settings(line);
#ifdef IRG_HAVE_SDL2
  if (s.window) return show(line, s);
#endif
  const problem in = read_problem(line, s);
  const std::string report = s.list ? "" : report_of(in, s.rule);  // whole before anything is written: memory may end
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(in, s));
  if (s.list)
    filled_spans(in, s.rule, everything, [](const irg::span_of_cells& span) {
      std::printf("%d %d %d\n", span.y, span.x_first, span.x_last - 1);
    });
  else
    std::fwrite(report.data(), 1, report.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "convex_polygon", help}, "this polygon and this size", run);
}
