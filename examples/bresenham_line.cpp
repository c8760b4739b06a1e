// SPDX-License-Identifier: MIT
// bresenham_line - the cells of a line by Bresenham's algorithm in four forms, beside a reference line.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_cells.hpp>
#include <irg/raster/line_run_slice.hpp>
#include <irg/raster/line_textbook.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(bresenham_line - the cells of a straight line

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
reference is drawn run by run.
)";

enum class line_method { integer, symmetric, textbook, seed };

constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
constexpr std::int64_t longest_textbook_line = std::int64_t{1} << 20;
constexpr std::int64_t longest_compared_line = std::int64_t{1} << 24;
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

// Calls use(range) with all cells of the line. In exact numbers the printed procedure gives the half-open line; doubles
// would add nothing but rounding errors.
template <class Use>
auto with_cells(const problem& p, line_method method, const Use& use) {
  if (method != line_method::textbook)
    return use(irg::line_cells(
        p.a, p.b,
        {.ends = method == line_method::seed ? irg::line_ends::half_open : irg::line_ends::closed,
         .ties = method == line_method::symmetric ? irg::line_ties::symmetric : irg::line_ties::start_side}));
  std::vector<irg::cell> cells;
  irg::line_bresenham_textbook<double>(p.a, p.b, [&](irg::cell c) { cells.push_back(c); });
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
  const int dx = (run.last.x > run.first.x) - (run.last.x < run.first.x);
  const int dy = (run.last.y > run.first.y) - (run.last.y < run.first.y);
  irg::cell c = run.first;
  emit(c);
  while (c != run.last) {
    c = {c.x + dx, c.y + dy};
    emit(c);
  }
}

// Steps whose cell is not the reference line's, where either cell is in the window: compared one by one.
std::int64_t count_differing(const problem& p, const settings& s) {
  return with_cells(p, s.method, [&](const auto& cells) {
    std::int64_t differing = 0;
    auto next = cells.begin();
    irg::line_run_slice(p.a, p.b, [&](const irg::line_run& run) {
      each_cell(run, [&](irg::cell reference) {
        if (next == cells.end()) {
          differing += s.window.holds(reference);
        } else if (const irg::cell c = *next++; c != reference) {
          differing += s.window.holds(c) || s.window.holds(reference);
        }
      });
    });
    return differing;
  });
}

// The same by counting, for lines too long to walk. `seed` lacks one cell; `symmetric` differs at exact ties of lines
// that run against their canonical direction. With a period of n / gcd(n, m) steps, ties are half-way through it.
std::int64_t derive_differing(const problem& p, const settings& s) {
  if (s.method == line_method::seed) return s.window.holds(p.b);
  const std::int64_t dx = std::int64_t{p.b.x} - p.a.x, dy = std::int64_t{p.b.y} - p.a.y;
  const bool by_x = std::abs(dx) > std::abs(dy), against = by_x ? dx < 0 : dy < 0;
  const std::int64_t period = steps_of(p) / std::gcd(dx, dy);
  if (s.method != line_method::symmetric || !against || period % 2 != 0) return 0;
  const auto visible = [&](line_method method) {
    return with_cells(p, method, [&](const auto& cells) { return steps_in(cells, s.window); });
  };
  const auto ties_before = [&](std::int64_t step) { return (step + period / 2 - 1) / period; };
  const auto ties_in = [&](const steps& k) { return k.count() == 0 ? 0 : ties_before(k.last) - ties_before(k.first); };
  const steps mine = visible(line_method::symmetric), other = visible(line_method::integer);
  const steps both{std::max(mine.first, other.first), std::min(mine.last, other.last)};
  return ties_in(mine) + ties_in(other) - ties_in(both);
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

// The reference line's cells in a window that is smaller than the whole of int. Where the window reaches the greatest
// int, which irg::cell_window cannot hold, the line is drawn mirrored.
template <class Emit>
void each_reference_cell(const problem& p, const closed_window& w, const Emit& emit) {
  if (w.x_first > w.x_last || w.y_first > w.y_last) return;
  const bool mirror_x = w.x_last == most, mirror_y = w.y_last == most;
  const auto mirrored = [&](irg::cell c) { return irg::cell{mirror_x ? ~c.x : c.x, mirror_y ? ~c.y : c.y}; };
  const irg::cell low = mirrored({mirror_x ? w.x_last : w.x_first, mirror_y ? w.y_last : w.y_first});
  const irg::cell high = mirrored({mirror_x ? w.x_first : w.x_last, mirror_y ? w.y_first : w.y_last});
  irg::line_run_slice(mirrored(p.a), mirrored(p.b), {low.x, low.y, high.x + 1, high.y + 1},
                      [&](const irg::line_run& run) { each_cell(run, [&](irg::cell c) { emit(mirrored(c)); }); });
}

irg::image<irg::rgba8> picture_of(const problem& p, const settings& s) {
  constexpr irg::rgba8 paper{250, 249, 246, 255}, blue{48, 90, 140, 255}, red{204, 96, 72, 255};
  irg::image<irg::rgba8> picture(s.size.width, s.size.height, paper);
  with_cells(p, s.method, [&](const auto& cells) {
    const steps all = steps_in(cells, s.window);
    const bool any = all.count() > 0;
    const camera view(any ? *(cells.begin() + all.first) : p.a, any ? *(cells.begin() + (all.last - 1)) : p.a, s.size);
    each_reference_cell(p, intersect(s.window, view.cells(s.size, reference_offset)),
                        [&](irg::cell c) { view.paint(picture, c.x, std::int64_t{c.y} + reference_offset, red); });
    const steps seen = steps_in(cells, intersect(s.window, view.cells(s.size, 0)));
    for (std::int64_t i = seen.first; i < seen.last; ++i) {
      const irg::cell c = *(cells.begin() + i);
      view.paint(picture, c.x, c.y, blue);
    }
  });
  return picture;
}

void print_cells(const problem& p, const settings& s) {
  with_cells(p, s.method, [&](const auto& cells) {
    const steps visible = steps_in(cells, s.window);
    if (visible.count() == 0) return;
    const auto end = cells.begin() + visible.last;
    for (auto at = cells.begin() + visible.first; at != end; ++at) {
      const irg::cell c = *at;
      if (std::printf("%d %d\n", c.x, c.y) < 0) return;
    }
  });
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const problem p = read_problem(line, s);
  if (!s.out.empty()) program::write_picture(line, s.out, picture_of(p, s));
  if (s.list) {
    print_cells(p, s);
  } else {
    const auto count = with_cells(p, s.method, [&](const auto& cells) { return steps_in(cells, s.window).count(); });
    const auto differing = steps_of(p) <= longest_compared_line ? count_differing(p, s) : derive_differing(p, s);
    std::printf("cells: %lld\ndiffering: %lld\n", static_cast<long long>(count), static_cast<long long>(differing));
  }
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "bresenham_line", help}, "this line and this size", run);
}
