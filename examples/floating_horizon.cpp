// SPDX-License-Identifier: MIT
// floating_horizon - a surface of a function of two variables, drawn as curves that hide each other.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <irg/hidden/horizon_surface.hpp>
#include <irg/hidden/textbook/floating_horizon.hpp>
#include <irg/io/file.hpp>
#include <irg/math/hypot.hpp>
#include <irg/raster/line_aa.hpp>

#include "support/command_line.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(floating_horizon - a surface as curves, the near ones hiding the far ones

usage: floating_horizon [options]

Draws y = f(u, v) over the unit square, turned about the upright axis and tilted, as curves of constant v, of constant
u, or both. Prints how many segments are drawn.

  --function NAME      ripple (the default): cos(hypot(pi(2u-1), pi(2v-1)))
  --table FILE         heights in place of a function: rows of one length, the first at v = 0, at least 2 rows of 2
                       numbers, bilinear between them; # begins a comment
  --curves N           curves of each family, 2 to 10000 (41)
  --samples N          points of a whole curve, 2 to 10000000 (as many as it has columns)
  --width W            pixels of one unit to the right, up to 100000 (380)
  --height H           pixels of one unit upwards, up to 100000 (120)
  --yaw DEG            0 to 90 (29)
  --pitch DEG          -90 to 90 (40)
  --mode MODE          which curves (both):
                         z         of constant v
                         x         of constant u
                         both      pieces of one family between curves of the other, so that both hide
                         overlaid  z, then x, each as if alone: the wrong picture, in which one family shows through
                                   the other
  --test RULE          strict (the default): no line that a curve has not; seed: the source's equality test
  --list               print the segments instead: x1 y1 x2 y2
  --horizons           print the horizons instead: lower upper of each column, - - where nothing is
  -o OUT               draw the segments: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
)";

// Heights on a grid.
struct height_table {
  int width = 0, height = 0;
  std::vector<double> value{};

  double operator()(double u, double v) const {
    const auto place = [](double t, int n) {
      const double at = t * (n - 1);
      const int i = std::min(static_cast<int>(at), n - 2);
      return std::pair{i, at - i};
    };
    const auto [x, right] = place(u, width);
    const auto [z, away] = place(v, height);
    const auto at = [&](int i, int k) {
      return value[static_cast<std::size_t>(k) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
    };
    const auto between = [](double a, double b, double t) { return t <= 0 ? a : t >= 1 ? b : a * (1 - t) + b * t; };
    return between(between(at(x, z), at(x + 1, z), right), between(at(x, z + 1), at(x + 1, z + 1), right), away);
  }
};

struct settings : program::drawing_options {
  irg::horizon_view view;
  std::string table{};
  bool horizons = false, seed = false;
  bool overlaid = false;  // in place of view.families
};

settings read_settings(program::command_line& line) {
  settings s;
  constexpr double degree = irg::pi<double> / 180;
  s.view.yaw = 29 * degree, s.view.pitch = 40 * degree;
  const auto number = [&](std::string_view word, double low, double high) {
    const double n = line.numbers(word, 1)[0];
    if (!(n >= low && n <= high))
      line.fail("option " + std::string(word) + " needs a number from " + std::to_string(static_cast<int>(low)) +
                " to " + std::to_string(static_cast<int>(high)));
    return n;
  };
  const auto size = [&](std::string_view word) {
    const double n = number(word, 0, 100000);
    if (!(n > 0)) line.fail("option " + std::string(word) + " needs a positive number");
    return n;
  };
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--function")
      line.choice(word, {"ripple"});
    else if (word == "--table")
      s.table = line.file_of(word);
    else if (word == "--curves")
      s.view.curves = line.integer(word, 2, 10000);
    else if (word == "--samples")
      s.view.samples = line.integer(word, 2, 10000000);
    else if (word == "--width")
      s.view.width = size(word);
    else if (word == "--height")
      s.view.height = size(word);
    else if (word == "--yaw")
      s.view.yaw = number(word, 0, 90) * degree;
    else if (word == "--pitch")
      s.view.pitch = number(word, -90, 90) * degree;
    else if (word == "--mode") {
      const auto mode = line.choice(word, {"z", "x", "both", "overlaid"});
      s.overlaid = mode == 3;
      s.view.families = std::array{irg::horizon_curves::constant_z, irg::horizon_curves::constant_x,
                                   irg::horizon_curves::both, irg::horizon_curves::both}[mode];
    } else if (word == "--test")
      s.seed = line.choice(word, {"strict", "seed"}) == 1;
    else if (word == "--horizons")
      s.horizons = true;
    else if (word == "--input")
      line.refuse(word);
    else
      s.read(line, word);
  }
  if (s.list && s.horizons) line.fail("only one of --list and --horizons can be printed");
  if (s.overlaid && s.horizons)
    line.fail("option --horizons needs --mode z, x or both: each family has its own when they are overlaid");
  if (program::one_file(s.out, s.table)) line.fail("the table would be overwritten: " + s.table);
  return s;
}

height_table read_table(const program::command_line& line, const std::string& name) {
  const auto text = irg::load_file(name);
  if (!text) line.fail(std::string(text.error().message) + ": " + name);
  height_table t;
  int row = 1;
  const char *p = text->data(), *const end = p + text->size(), *begin = p;
  if (std::string_view(p, text->size()).starts_with("\xEF\xBB\xBF")) p += 3;  // a byte order mark
  const auto wrong = [&](const std::string& what, const char* at) {
    line.fail(what + ": " + name + ":" + std::to_string(row) + ":" + std::to_string(at - begin + 1));
  };
  const auto ends_line = [&] { return p == end || *p == '\n' || *p == '\r'; };
  for (; p < end; ++row) {
    begin = p;
    int columns = 0;
    while (!ends_line()) {
      if (*p == ' ' || *p == '\t' || *p == '\f' || *p == '\v') {
        ++p;
      } else if (*p == '#') {
        while (!ends_line()) ++p;
      } else {
        const auto n = irg::parse_decimal<double>(p, end);
        const bool ended = n.end == end || (*n.end >= 0 && static_cast<unsigned char>(*n.end) <= 32) || *n.end == '#';
        if (n.status == irg::decimal_status::none || !ended) wrong("a height is not a number", p);
        if (n.status == irg::decimal_status::overflow) wrong("a height is too large", p);
        if (t.height > 0 && columns == t.width)
          wrong("a row is longer than the first, which has " + std::to_string(t.width) + " heights", p);
        if (t.value.size() == std::size_t{1} << 26) wrong("the table has more than 67108864 heights", p);
        t.value.push_back(n.value);
        ++columns;
        p = n.end;
      }
    }
    if (columns > 0 && t.height > 0 && columns < t.width)
      wrong("a row is shorter than the first, which has " + std::to_string(t.width) + " heights", p);
    if (columns == 1 && t.height == 0) wrong("a row has at least 2 heights", p);
    if (columns > 0) t.width = columns, ++t.height;
    if (p < end && *p == '\r' && p + 1 < end && p[1] == '\n') ++p;
    if (p < end) ++p;
  }
  if (t.height < 2) line.fail("the table has less than 2 rows: " + name + ":" + std::to_string(row) + ":1");
  return t;
}

struct segment {
  irg::cell from, to;
};

// Draws with a horizon of either kind, and prints its columns if that is asked for.
template <class Horizon, class Height>
std::vector<segment> drawn_with(Horizon&& horizon, const settings& s, const Height& height) {
  std::vector<segment> segments;
  draw_horizon_surface(horizon, height, s.view, [&](const irg::cell& a, const irg::cell& b, irg::horizon_side) {
    if (!(a == b)) segments.push_back({a, b});
  });
  for (int x = 0; s.horizons && x < horizon.columns(); ++x) {
    if (horizon[x].is_set)
      std::printf("%d %d\n", horizon[x].lower, horizon[x].upper);
    else
      std::puts("- -");
  }
  return segments;
}

template <class Height>
std::vector<segment> segments_of(const settings& s, const Height& height) {
  if (s.overlaid) {
    settings alone = s;
    alone.overlaid = false;
    alone.view.families = irg::horizon_curves::constant_z;
    std::vector<segment> segments = segments_of(alone, height);
    alone.view.families = irg::horizon_curves::constant_x;
    for (const segment& g : segments_of(alone, height)) segments.push_back(g);
    return segments;
  }
  const int columns = irg::horizon_width(s.view);
  return s.seed ? drawn_with(irg::textbook::floating_horizon(columns), s, height)
                : drawn_with(irg::floating_horizon(columns), s, height);
}

void draw(const program::command_line& line, const settings& s, const std::vector<segment>& segments) {
  irg::image<irg::rgba8> picture(s.size.width, s.size.height, irg::rgba8{250, 249, 246, 255});
  irg::cell low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()}, high{-low.x, -low.y};
  for (const segment& g : segments)
    for (const irg::cell& c : {g.from, g.to}) {
      low = {std::min(low.x, c.x), std::min(low.y, c.y)};
      high = {std::max(high.x, c.x), std::max(high.y, c.y)};
    }
  const auto room = [](int pixels) { return pixels > 40 ? pixels - 20.0 : pixels / 2.0; };
  const double wide = std::max(1.0, static_cast<double>(high.x) - low.x),
               tall = std::max(1.0, static_cast<double>(high.y) - low.y);
  const double scale = std::min(room(s.size.width) / wide, room(s.size.height) / tall);
  const auto place = [&](const irg::cell& c) {
    return irg::point<double, 2>{s.size.width / 2.0 + (c.x - (static_cast<double>(low.x) + high.x) / 2) * scale,
                                 s.size.height / 2.0 - (c.y - (static_cast<double>(low.y) + high.y) / 2) * scale};
  };
  for (const segment& g : segments) irg::draw_line_aa(picture, place(g.from), place(g.to), irg::rgba8{32, 44, 66, 255});
  program::write_picture(line, s.out, picture);
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  std::vector<segment> segments;
  if (!s.table.empty()) {
    segments = segments_of(s, read_table(line, s.table));
  } else {
    segments = segments_of(s, [](double u, double v) {
      return irg::cos(irg::hypot(irg::pi<double> * (2 * u - 1), irg::pi<double> * (2 * v - 1)));
    });
  }
  if (!s.out.empty()) draw(line, s, segments);
  if (s.list)
    for (const segment& g : segments) std::printf("%d %d %d %d\n", g.from.x, g.from.y, g.to.x, g.to.y);
  else if (!s.horizons)
    std::printf("segments: %zu\n", segments.size());
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "floating_horizon", help}, "this many samples", run);
}
