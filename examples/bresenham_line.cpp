// SPDX-License-Identifier: MIT
// bresenham_line - the cells of a line by Bresenham's algorithm in four forms, beside a reference line.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_cells.hpp>
#include <irg/raster/line_run_slice.hpp>
#include <irg/raster/textbook/line_printed.hpp>
#include <irg/raster/textbook/line_bresenham.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(bresenham_line - the cells of a straight line

usage: bresenham_line [options] <NUMBERS

Reads x1 y1 x2 y2, whole numbers from -2147483648 to 2147483647, from standard input.

  --input FILE         read the numbers from FILE
  --method METHOD      which cells (integer):
                         integer    the nearest to the line, both ends; half-way cells on the side of x1 y1
                         symmetric  the same in both directions: half-way cells as if drawn with x rising, or with y
                                    rising where |y2 - y1| >= |x2 - x1|
                         textbook   as integer, computed with a distance in doubles; at most 1048576 steps
                         seed       as the course prints it: 0 to 45 degrees, without the last cell
  --window x0,y0,x1,y1 only the cells with x0 <= x <= x1 and y0 <= y <= y1
  --list               print the cells instead, x y, from x1 y1 on
  -o OUT               draw the line and the reference line, 20 rows further, enlarged where they are small: .png,
                       .ppm or .svg
  --size WxH           pixels of the picture (640x480)

Prints how many cells there are, and how many of them differ from the reference line's, moved back by 20 rows. The
reference is drawn run by run, beside seed cell by cell in whole numbers. All are counted: 2^32 take half a minute.
)";

enum class line_method { integer, symmetric, textbook, seed };

constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
constexpr std::int64_t longest_textbook_line = std::int64_t{1} << 20;
constexpr int reference_offset = 20;

// Cells with both borders included: unlike irg::cell_window it can hold the greatest int.
struct closed_window {
  int x_first = least, y_first = least, x_last = most, y_last = most;
  bool holds(irg::cell c) const { return c.x >= x_first && c.x <= x_last && c.y >= y_first && c.y <= y_last; }
};

struct settings : program::drawing_options {
  line_method method = line_method::integer;
  closed_window window;
};

struct problem {
  irg::cell a, b;
};

closed_window read_window(program::command_line& line) {
  const auto n = line.numbers("--window", 4);
  for (const double v : n)
    if (!(v >= least && v <= most) || v != static_cast<int>(v))
      line.fail("option --window needs whole numbers from -2147483648 to 2147483647");
  return {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]), static_cast<int>(n[3])};
}

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--method") {
      s.method = static_cast<line_method>(line.choice(word, {"integer", "symmetric", "textbook", "seed"}));
    } else if (word == "--window") {
      s.window = read_window(line);
    } else {
      s.read(line, word);
    }
  }
  s.finish(line);
  return s;
}

std::int64_t steps_of(const problem& p) {
  return std::max(std::abs(std::int64_t{p.b.x} - p.a.x), std::abs(std::int64_t{p.b.y} - p.a.y));
}

problem read_problem(program::command_line& line, const settings& s) {
  using program::number_input;
  problem p;
  number_input::prompt_if_terminal("x1 y1: ", s.input);
  number_input in(line, s.input);
  p.a.x = in.integer("x1");
  p.a.y = in.integer("y1");
  number_input::prompt_if_terminal("x2 y2: ", s.input);
  p.b.x = in.integer("x2");
  p.b.y = in.integer("y2");
  in.expect_end();
  const std::int64_t dx = std::int64_t{p.b.x} - p.a.x, dy = std::int64_t{p.b.y} - p.a.y;
  if (s.method == line_method::seed && (dx <= 0 || dy < 0 || dy > dx))
    in.fail_at_word("--method seed draws from 0 to 45 degrees only, where x1 < x2 and 0 <= y2 - y1 <= x2 - x1");
  if (s.method == line_method::textbook && steps_of(p) > longest_textbook_line)
    in.fail_at_word("--method textbook draws at most 1048576 steps, not " + std::to_string(steps_of(p)));
  return p;
}

// Fractions that are exact as long as their numbers fit: the printed procedure needs those over 4 (x2 - x1).
struct fraction {
  std::int64_t over = 0, under = 1;

  fraction() = default;
  explicit fraction(std::int64_t whole) : over(whole) {}
  fraction(std::int64_t above, std::int64_t below) : over(above), under(below) {}
  [[maybe_unused]] friend bool operator==(const fraction&, const fraction&) = default;
  fraction operator-() const { return {-over, under}; }
  friend fraction operator+(const fraction& a, const fraction& b) {
    if (a.under == b.under) return {a.over + b.over, a.under};
    if (b.under == 1) return {a.over + b.over * a.under, a.under};
    const std::int64_t common = std::lcm(a.under, b.under);
    return {a.over * (common / a.under) + b.over * (common / b.under), common};
  }
  friend fraction operator-(const fraction& a, const fraction& b) { return a + -b; }
  [[maybe_unused]] friend fraction operator*(const fraction& a, const fraction& b) {
    return {a.over * b.over, a.under * b.under};
  }
  // Of the slope and the half, so that distance and slope have one denominator from the start.
  friend fraction operator/(const fraction& a, const fraction& b) {
    return {4 * a.over * b.under, 4 * a.under * b.over};
  }
  friend bool operator<(const fraction& a, const fraction& b) { return a.over == 0 ? b.over > 0 : (a - b).over < 0; }
};

// Calls emit(cell) for the cells of the procedure as it is printed, computed without rounding.
template <class Emit>
void draw_as_printed(const problem& p, const Emit& emit) {
  irg::textbook::line_bresenham_printed<fraction>(p.a, p.b, emit);
}

// Calls use(range) with all cells of a line; with those that the printed procedure should draw for that.
template <class Use>
auto with_cells(const problem& p, line_method method, const Use& use) {
  if (method != line_method::textbook)
    return use(irg::line_cells(
        p.a, p.b, {.ties = method == line_method::symmetric ? irg::line_ties::symmetric : irg::line_ties::start_side}));
  std::vector<irg::cell> cells;
  irg::textbook::line_bresenham<double>(p.a, p.b, [&](irg::cell c) { cells.push_back(c); });
  return use(cells);
}

// Some steps of a line, from the first to the last - 1.
struct steps {
  std::int64_t first = 0, last = 0;
  std::int64_t count() const { return last > first ? last - first : 0; }
};

// The steps whose cells lie in the window, found by bisection: both coordinates only rise or only fall.
template <class Cells>
steps steps_in(const Cells& cells, const closed_window& w) {
  if (cells.empty()) return {};
  const auto within = [&](int irg::cell::* coordinate, int low, int high) {
    const bool rising = cells.front().*coordinate <= cells.back().*coordinate;
    const auto before = [&](irg::cell c) { return rising ? c.*coordinate < low : c.*coordinate > high; };
    const auto not_after = [&](irg::cell c) { return rising ? c.*coordinate <= high : c.*coordinate >= low; };
    return steps{std::ranges::partition_point(cells, before) - cells.begin(),
                 std::ranges::partition_point(cells, not_after) - cells.begin()};
  };
  const steps x = within(&irg::cell::x, w.x_first, w.x_last), y = within(&irg::cell::y, w.y_first, w.y_last);
  return {std::max(x.first, y.first), std::min(x.last, y.last)};
}

// Cells of a run, in its order.
template <class Emit>
void each_cell(const irg::line_run& run, const Emit& emit) {
  irg::cell c = run.first;
  emit(c);
  if (c == run.last) return;
  const int dx = (run.last.x > c.x) - (run.last.x < c.x), dy = (run.last.y > c.y) - (run.last.y < c.y);
  while (c != run.last) {
    c = {c.x + dx, c.y + dy};
    emit(c);
  }
}

// Calls emit(cell) for the line's cells in the window, in drawing order.
template <class Emit>
void each_cell_in(const problem& p, line_method method, const closed_window& window, const Emit& emit) {
  if (method == line_method::seed)
    return draw_as_printed(p, [&](irg::cell c) {
      if (window.holds(c)) emit(c);
    });
  with_cells(p, method, [&](const auto& cells) {
    const steps visible = steps_in(cells, window);
    for (std::int64_t i = visible.first; i < visible.last; ++i) emit(*(cells.begin() + i));
  });
}

// The first and the last of the line's cells in a window, or its start twice.
std::pair<irg::cell, irg::cell> ends_in(const problem& p, line_method method, const closed_window& window) {
  irg::cell first = p.a, last = p.a;
  if (method == line_method::seed) {
    bool any = false;
    each_cell_in(p, method, window, [&](irg::cell c) {
      if (!any) first = c;
      any = true;
      last = c;
    });
    return {first, last};
  }
  return with_cells(p, method, [&](const auto& cells) {
    const steps visible = steps_in(cells, window);
    if (visible.count() == 0) return std::pair{p.a, p.a};
    return std::pair{*(cells.begin() + visible.first), *(cells.begin() + (visible.last - 1))};
  });
}

// Where the picture shows what: `zoom` pixels a cell; the line's box in the middle, or else its first visible cell.
struct camera {
  std::int64_t left, top, zoom;

  camera(irg::cell first, irg::cell last, const program::picture_size& size) {
    const std::int64_t low_x = std::min(first.x, last.x), high_x = std::max(first.x, last.x);
    const std::int64_t low_y = std::min(first.y, last.y), high_y = std::max(first.y, last.y) + std::int64_t{20};
    const std::int64_t wide = high_x - low_x + 3, high = high_y - low_y + 3;
    zoom = std::clamp<std::int64_t>(std::min(size.width / wide, size.height / high), 1, 64);
    const auto place = [&](std::int64_t low, std::int64_t extent, std::int64_t pixels, std::int64_t start) {
      return extent <= pixels / zoom ? low - 1 - (pixels / zoom - extent) / 2 : start - pixels / zoom / 2;
    };
    left = place(low_x, wide, size.width, first.x);
    top = place(low_y, high, size.height, first.y);
  }

  // The cells that a picture shows when it is moved down by `down` rows.
  closed_window cells(const program::picture_size& size, int down) const {
    const auto limited = [](std::int64_t v) { return static_cast<int>(std::clamp<std::int64_t>(v, least, most)); };
    return {limited(left), limited(top - down), limited(left + size.width / zoom),
            limited(top - down + size.height / zoom)};
  }

  void paint(irg::image<irg::rgba8>& picture, std::int64_t x, std::int64_t y, irg::rgba8 colour) const {
    const std::int64_t side = zoom < 4 ? zoom : zoom - 1, column = (x - left) * zoom, row = (y - top) * zoom;
    for (std::int64_t k = 0; k < side; ++k)
      irg::fill_span(picture, {static_cast<int>(row + k), static_cast<int>(column), static_cast<int>(column + side)},
                     colour);
  }
};

closed_window intersect(const closed_window& a, const closed_window& b) {
  return {std::max(a.x_first, b.x_first), std::max(a.y_first, b.y_first), std::min(a.x_last, b.x_last),
          std::min(a.y_last, b.y_last)};
}

// The reference line's cells in a window that holds the whole line or is not all of int from side to side. Where the
// window reaches the greatest int, which irg::cell_window cannot hold, the line is drawn mirrored.
template <class Emit>
void each_reference_cell(const problem& p, const closed_window& w, const Emit& emit) {
  const auto each = [&](const irg::line_run& run) { each_cell(run, emit); };
  if (w.holds(p.a) && w.holds(p.b)) return irg::line_run_slice(p.a, p.b, each);
  if (w.x_first > w.x_last || w.y_first > w.y_last) return;
  const bool mirror_x = w.x_last == most, mirror_y = w.y_last == most;
  const auto mirrored = [&](irg::cell c) { return irg::cell{mirror_x ? ~c.x : c.x, mirror_y ? ~c.y : c.y}; };
  const irg::cell low = mirrored({mirror_x ? w.x_last : w.x_first, mirror_y ? w.y_last : w.y_first});
  const irg::cell high = mirrored({mirror_x ? w.x_first : w.x_last, mirror_y ? w.y_first : w.y_last});
  irg::line_run_slice(mirrored(p.a), mirrored(p.b), {low.x, low.y, high.x + 1, high.y + 1},
                      [&](const irg::line_run& run) { each_cell(run, [&](irg::cell c) { emit(mirrored(c)); }); });
}

// A box around the steps that the window leaves along the driving axis: the same steps of both lines. All of int from
// side to side only where the whole line is.
closed_window strip_of(const problem& p, const closed_window& window) {
  const std::int64_t dx = std::int64_t{p.b.x} - p.a.x, dy = std::int64_t{p.b.y} - p.a.y;
  const bool by_x = std::abs(dx) > std::abs(dy);
  closed_window strip{std::min(p.a.x, p.b.x), std::min(p.a.y, p.b.y), std::max(p.a.x, p.b.x), std::max(p.a.y, p.b.y)};
  strip = intersect(strip, by_x ? closed_window{window.x_first, least, window.x_last, most}
                                : closed_window{least, window.y_first, most, window.y_last});
  if (std::abs(dx) != std::abs(dy) || strip.y_first > strip.y_last) return strip;
  const auto diagonal = [&](int y) {
    return static_cast<int>(p.a.x + (dx < 0 ? -1 : 1) * std::abs(std::int64_t{y} - p.a.y));
  };
  std::tie(strip.x_first, strip.x_last) = std::minmax({diagonal(strip.y_first), diagonal(strip.y_last)});
  return strip;
}

// The line's cells in the window, and steps whose cell is not the reference line's, where either is in the window.
struct tally {
  std::int64_t cells = 0, differing = 0;
};

// Counted one by one, up to 2^32 of them; in one piece, so that walks and comparison keep their numbers in registers.
[[gnu::flatten]] tally count_cells(const problem& p, const settings& s) {
  return with_cells(p, s.method, [&](const auto& cells) {
    tally count;
    auto next = cells.begin();
    const auto compare_with_next = [&](irg::cell c) {
      const irg::cell other = *next;
      ++next;
      if (c != other) count.differing += s.window.holds(c) || s.window.holds(other);
    };
    if (s.method == line_method::seed) {  // whose own cells come one after the other, without the last
      draw_as_printed(p, [&](irg::cell c) {
        count.cells += s.window.holds(c);
        compare_with_next(c);
      });
      count.differing += s.window.holds(*next);
      return count;
    }
    count.cells = steps_in(cells, s.window).count();
    const closed_window strip = strip_of(p, s.window);
    next += steps_in(cells, strip).first;
    each_reference_cell(p, strip, compare_with_next);
    return count;
  });
}

irg::image<irg::rgba8> picture_of(const problem& p, const settings& s) {
  constexpr irg::rgba8 paper{250, 249, 246, 255}, blue{48, 90, 140, 255}, red{204, 96, 72, 255};
  irg::image<irg::rgba8> picture(s.size.width, s.size.height, paper);
  const auto [first, last] = ends_in(p, s.method, s.window);
  const camera view(first, last, s.size);
  each_reference_cell(p, intersect(s.window, view.cells(s.size, reference_offset)),
                      [&](irg::cell c) { view.paint(picture, c.x, std::int64_t{c.y} + reference_offset, red); });
  each_cell_in(p, s.method, intersect(s.window, view.cells(s.size, 0)),
               [&](irg::cell c) { view.paint(picture, c.x, c.y, blue); });
  return picture;
}

void print_cells(const problem& p, const settings& s) {
  bool written = true;
  each_cell_in(p, s.method, s.window, [&](irg::cell c) { written = written && std::printf("%d %d\n", c.x, c.y) >= 0; });
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const problem p = read_problem(line, s);
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(p, s));
  if (s.list) {
    print_cells(p, s);
  } else {
    const tally count = count_cells(p, s);
    std::printf("cells: %lld\ndiffering: %lld\n", static_cast<long long>(count.cells),
                static_cast<long long>(count.differing));
  }
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "bresenham_line", help}, "this line and this size", run);
}
