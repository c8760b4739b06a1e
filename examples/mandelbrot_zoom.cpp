// SPDX-License-Identifier: MIT
// mandelbrot_zoom - a zoom into the Mandelbrot set, deeper than doubles reach, as an animated PNG.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/fractal/deep_mandelbrot.hpp>
#include <irg/fractal/escape_colour.hpp>
#include <irg/io/apng.hpp>
#include <irg/raster/image.hpp>

#include "support/command_line.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(mandelbrot_zoom - a zoom into the Mandelbrot set as an animated PNG

usage: mandelbrot_zoom -o OUT [options]

  -o OUT               the file, .png; needed
  --centre RE IM       decimals, of as many digits as the zoom is deep (a spiral that is good for 1e-48)
  --from WIDTH         of the first picture in the plane, up to 16 (3)
  --to WIDTH           of the last, from 1e-65 (1e-12)
  --pictures N         1 to 10000 (60)
  --steps M            of an orbit at most, 1 to 10000000 (3000)
  --delay MS           how long each picture is shown, 0 to 65535 (60)
  --size WxH           pixels (320x240)
  --threads N          1 to 256 (1)

Progress goes to standard error. Prints how many pictures there are, the steps of the longest orbit with many digits,
and how many glitches were cured.
)";

using digits = irg::fixed_point<6>;
using picture = irg::image<irg::rgba8>;

struct settings {
  digits re = *irg::parse_fixed_point<6>("-0.796018035679333599770602762027128618680016120069383332358641");
  digits im = *irg::parse_fixed_point<6>("0.152921489508950739029284976898362805189168098776991868427910");
  double from = 3, to = 1e-12;
  int pictures = 60, steps = 3000, delay = 60, threads = 1;
  program::picture_size size{320, 240};
  std::string out;
};

digits coordinate(program::command_line& line) {
  const std::string_view text = line.value_of("--centre");
  const auto value = irg::parse_fixed_point<6>(text);
  if (!value || std::abs(double(*value)) > 1000)
    line.fail("option --centre needs two decimals from -1000 to 1000, not '" + std::string(text) + "'");
  return *value;
}

double plane_width(program::command_line& line, std::string_view option) {
  const double width = line.numbers(option, 1)[0];
  if (!(width >= 1e-65 && width <= 16)) line.fail("option " + std::string(option) + " needs a width from 1e-65 to 16");
  return width;
}

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "-o") {
      s.out = line.value_of(word);
      if (irg::image_format_of_name(s.out) != irg::image_format::png)
        line.fail("the animation's name must end in .png, not: " + s.out);
    } else if (word == "--centre") {
      s.re = coordinate(line);
      s.im = coordinate(line);
    } else if (word == "--from") {
      s.from = plane_width(line, word);
    } else if (word == "--to") {
      s.to = plane_width(line, word);
    } else if (word == "--pictures") {
      s.pictures = line.integer(word, 1, 10000);
    } else if (word == "--steps") {
      s.steps = line.integer(word, 1, 10000000);
    } else if (word == "--delay") {
      s.delay = line.integer(word, 0, 65535);
    } else if (word == "--size") {
      s.size = program::read_size(line);
    } else if (word == "--threads") {
      s.threads = line.integer(word, 1, 256);
    } else {
      line.refuse(word);
    }
  }
  if (s.out.empty()) line.fail("option -o names the file, and is needed");
  return s;
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  irg::deep_escape_job<6> job{s.re, s.im, 0, irg::make_escape_limit(16.0, s.steps)};
  irg::image<int> counts(s.size.width, s.size.height);
  picture shown(s.size.width, s.size.height);
  irg::png_animation<picture> animation(s.pictures, {s.delay, 0});
  std::vector<std::uint8_t> file;
  long long longest = 0, glitches = 0;
  for (int i = 0; i < s.pictures; ++i) {
    const double done = s.pictures == 1 ? 0 : static_cast<double>(i) / (s.pictures - 1);
    const double width = s.from * std::pow(s.to / s.from, done);
    job.pixel = width / s.size.width;
    const irg::deep_escape_counts stats = irg::draw_deep_mandelbrot(counts, job, irg::parallel{s.threads});
    longest = stats.reference > longest ? stats.reference : longest;
    glitches += stats.rebased;
    for (int y = 0; y < shown.height(); ++y)
      for (int x = 0; x < shown.width(); ++x) shown(x, y) = irg::escape_colour(counts(x, y), s.steps);
    const auto bytes = animation.add(shown);
    if (!bytes) line.fail(bytes.error().message);
    file.insert(file.end(), bytes->begin(), bytes->end());
    std::fprintf(stderr, "picture %d of %d, width %.3g\n", i + 1, s.pictures, width);
  }
  if (const auto saved = irg::save_file(s.out, std::span<const std::uint8_t>(file)); !saved)
    line.fail(std::string(saved.error().message) + ": " + s.out);
  std::printf("pictures: %d\nlongest orbit: %lld\nglitches cured: %lld\n", s.pictures, longest, glitches);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "mandelbrot_zoom", help}, "this many pixels", run);
}
