// SPDX-License-Identifier: MIT
// mandelbrot_julia - escape counts of the Mandelbrot set or of a Julia set, as the university course computes them.
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include <irg/core/threads.hpp>
#include <irg/fractal/escape_colour.hpp>
#include <irg/fractal/escape_picture.hpp>
#include <irg/raster/image.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(mandelbrot_julia - how fast orbits of z^2 + c leave a disc

usage: mandelbrot_julia [options] <NUMBERS

Reads eps m umin umax vmin vmax xmax ymax from standard input: point (x, y), x from 0 to xmax and y from 0 to ymax, is
the number u + iv with u = (umax - umin)/xmax*x + umin and v = (vmax - vmin)/ymax*y + vmin. Its count k is the number of
steps z = z^2 + c, the first not counted, until |z| is no longer less than eps; at most m.

  --input FILE         read the numbers from FILE
  --julia RE IM        of the Julia set: orbits begin at the point, and c is RE + IM i. Without it the point is c, and
                       orbits begin at 0
  --list               print the counts instead: a row for each y, the first at vmin
  -o OUT               draw the counts, vmax at the top, what stays in the disc black: .png, .ppm or .svg
  --size WxH           pixels of the picture (xmax + 1 by ymax + 1)
  --threads N          1 to 256 (1)

Prints how many points there are.
)";

using complex_number = irg::point<double, 2>;

struct settings : program::drawing_options {
  std::optional<complex_number> julia;
  bool sized = false;
  int threads = 1;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--julia") {
      const double re = line.numbers(word, 1)[0];
      s.julia = complex_number{re, line.numbers(word, 1)[0]};
    } else if (word == "--threads") {
      s.threads = line.integer(word, 1, 256);
    } else {
      s.sized = s.sized || word == "--size";
      s.read(line, word);
    }
  }
  s.finish(line);
  return s;
}

irg::escape_job<double> read_problem(program::command_line& line, const settings& s) {
  using program::number_input;
  number_input::prompt_if_terminal("eps m umin umax vmin vmax xmax ymax: ", s.input);
  number_input in(line, s.input);
  irg::escape_job<double> job;
  const double eps = in.number("eps");
  job.limit = irg::make_escape_limit(eps, in.integer("m", 0));
  job.plane.window.left = in.number("umin");
  job.plane.window.right = in.number("umax");
  job.plane.window.bottom = in.number("vmin");
  job.plane.window.top = in.number("vmax");
  constexpr int most = 134217727;
  const int x_most = in.integer("xmax", 1, most), y_most = in.integer("ymax", 1, most);
  if ((std::int64_t{x_most} + 1) * (std::int64_t{y_most} + 1) > std::int64_t{1} << 27)
    in.fail_at_word("xmax and ymax make more than 134217728 points");
  in.expect_end();
  job.plane.width = x_most + 1;
  job.plane.height = y_most + 1;
  return job;
}

irg::image<int> counts_of(const irg::escape_job<double>& job, const settings& s) {
  irg::image<int> counts(job.plane.width, job.plane.height);
  if (s.julia)
    irg::draw_julia(counts, job, *s.julia, irg::parallel{s.threads});
  else
    irg::draw_mandelbrot(counts, job, irg::parallel{s.threads});
  return counts;
}

void draw(const program::command_line& line, irg::escape_job<double> job, const settings& s) {
  if (s.sized) {
    job.plane.width = s.size.width;
    job.plane.height = s.size.height;
  } else if (job.plane.width > 65535 || job.plane.height > 65535) {
    line.fail("a picture has at most 65535 columns and rows: name a --size");
  }
  const irg::image<int> counts = counts_of(job, s);
  irg::image<irg::rgba8> picture(counts.width(), counts.height());
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) picture(x, y) = irg::escape_colour(counts(x, y), job.limit.most);
  program::write_picture(line, s.out, picture);
}

void print_counts(const irg::image<int>& counts) {
  bool written = true;
  for (int y = counts.height() - 1; y >= 0 && written; --y)
    for (int x = 0; x < counts.width(); ++x)
      written = std::printf("%d%c", counts(x, y), x + 1 < counts.width() ? ' ' : '\n') > 0 && written;
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const irg::escape_job<double> job = read_problem(line, s);
  if (!s.out.empty()) draw(line, job, s);
  if (s.list)
    print_counts(counts_of(job, s));
  else
    std::printf("pixels: %lld\n", static_cast<long long>(std::int64_t{job.plane.width} * job.plane.height));
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "mandelbrot_julia", help}, "this many points", run);
}
