// SPDX-License-Identifier: MIT
// plot_surface - a surface with axes and labels, from a function, a terrain file or an image.
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <irg/hidden/plot_surface.hpp>
#include <irg/hidden/height_grid.hpp>
#include <irg/io/apng.hpp>
#include <irg/io/file.hpp>
#include <irg/io/png_read.hpp>
#include <irg/io/svg_plot.hpp>
#include <irg/io/terrain.hpp>
#include <irg/raster/image.hpp>

#include "support/command_line.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(plot_surface - a surface with axes, ticks and labels, without what it hides

usage: plot_surface [options]

  --function NAME      ripple (the default), saddle, peaks; crater has a hole
  --terrain FILE       heights of an Esri ASCII grid in place of a function
  --image FILE         heights of a PNG, dark is low
  --samples N          points of a function each way, 2 to 2000 (41)
  --style STYLE        lines (the default), facets
  --azimuth DEG        where the eye stands, from before the least z towards the least x (35)
  --elevation DEG      how far above, -90 to 90 (25)
  --labels X,Y,Z       beside the axes; y is the height (x,y,z)
  -o OUT               draw it: .png, .ppm or .svg
  --size WxH           pixels (640x480)
  --animate N          in N pictures, 1 to 200, in the order of drawing, as an animated .png

Prints which method finds what is seen, why, and how many lines and facets are drawn.
)";

struct settings {
  irg::surface_plot_options plot;
  std::string function = "ripple", terrain{}, image{}, out{};
  int samples = 41, pictures = 0;
};

void read_labels(program::command_line& line, irg::surface_plot_options& plot) {
  const std::string text(line.value_of("--labels"));
  const std::size_t first = text.find(','), second = first == text.npos ? text.npos : text.find(',', first + 1);
  if (second == text.npos || text.find(',', second + 1) != text.npos)
    line.fail("option --labels needs three texts with commas between");
  plot.x = text.substr(0, first), plot.y = text.substr(first + 1, second - first - 1), plot.z = text.substr(second + 1);
}

settings read_settings(program::command_line& line) {
  settings s;
  const auto degrees = [&](std::string_view word, double most) {
    const double n = line.numbers(word, 1)[0];
    if (!(n >= -most && n <= most))
      line.fail("option " + std::string(word) + " needs at most " + std::to_string(static_cast<int>(most)) +
                " degrees");
    return n;
  };
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--function")
      s.function =
          std::array{"ripple", "saddle", "peaks", "crater"}[line.choice(word, {"ripple", "saddle", "peaks", "crater"})];
    else if (word == "--terrain")
      s.terrain = line.file_of(word);
    else if (word == "--image")
      s.image = line.file_of(word);
    else if (word == "--samples")
      s.samples = line.integer(word, 2, 2000);
    else if (word == "--style")
      s.plot.style =
          line.choice(word, {"lines", "facets"}) == 1 ? irg::surface_style::facets : irg::surface_style::lines;
    else if (word == "--azimuth")
      s.plot.azimuth_degrees = degrees(word, 360);
    else if (word == "--elevation")
      s.plot.elevation_degrees = degrees(word, 90);
    else if (word == "--labels")
      read_labels(line, s.plot);
    else if (word == "--animate")
      s.pictures = line.integer(word, 1, 200);
    else if (word == "--size") {
      const auto size = program::read_size(line);
      s.plot.width = size.width, s.plot.height = size.height;
    } else if (word == "-o") {
      s.out = line.value_of(word);
      program::expect_picture_name(line, s.out);
    } else
      line.refuse(word);
  }
  if (!s.terrain.empty() && !s.image.empty()) line.fail("only one of --terrain and --image can be drawn");
  for (const std::string& in : {s.terrain, s.image})
    if (program::one_file(s.out, in)) line.fail("the input would be overwritten: " + in);
  if (s.pictures > 0 && irg::image_format_of_name(s.out) != irg::image_format::png)
    line.fail("option --animate needs -o with a name that ends in .png");
  return s;
}

irg::height_grid read_heights(const program::command_line& line, const settings& s) {
  const std::string& name = s.terrain.empty() ? s.image : s.terrain;
  if (name.empty()) {
    const auto height = [&](double x, double z) {
      const double r = std::hypot(x, z);
      if (s.function == "saddle") return (x * x - z * z) / 4;
      if (s.function == "peaks")
        return 3 * std::exp(-(x - 1) * (x - 1) - z * z) + 2 * std::exp(-(x + 2) * (x + 2) - (z - 1) * (z - 1));
      if (s.function == "crater" && r < 1) return std::numeric_limits<double>::quiet_NaN();
      return s.function == "crater" ? 3 / (r * r) : 3 * std::cos(2 * r) / (1 + r);
    };
    const irg::sample_range range{-4, 4, s.samples};
    return irg::sample_heights(height, range, range);
  }
  const auto bytes = irg::load_file(name);
  if (!bytes) line.fail(std::string(bytes.error().message) + ": " + name);
  const auto refuse = [&](const irg::parse_error& e) {
    line.fail(std::string(e.message) + ": " + name + ":" + std::to_string(e.line) + ":" + std::to_string(e.column));
  };
  if (!s.terrain.empty()) {
    auto grid = irg::read_terrain({bytes->data(), bytes->size()});
    if (!grid) refuse(grid.error());
    return *std::move(grid);
  }
  const auto picture = irg::read_png(*bytes);
  if (!picture) refuse(picture.error());
  return irg::heights_of_image(*picture, [](const irg::rgba8& p) { return (p.r + p.g + p.b) / 3.0; });
}

void write_svg(const program::command_line& line, const std::string& out, const irg::surface_plot& plot) {
  std::string text;
  auto sink = [&](std::string_view piece) { text += piece; };
  irg::write_svg_plot(sink, plot);
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  if (const auto saved = irg::save_file(out, std::span<const std::uint8_t>(bytes, text.size())); !saved)
    line.fail(std::string(saved.error().message) + ": " + out);
}

// Every picture shows some more lines or facets, in the order of drawing.
void write_animation(const program::command_line& line, const settings& s, irg::surface_plot plot) {
  const std::vector<irg::plot_line> lines = std::move(plot.lines);
  const std::vector<irg::plot_facet> facets = std::move(plot.facets);
  irg::png_animation<irg::image<irg::rgba8>> animation(s.pictures, {80, 0});
  std::vector<std::uint8_t> file;
  const auto share = [&](std::size_t size, int i) {
    return static_cast<std::ptrdiff_t>(size * static_cast<std::size_t>(i) / static_cast<std::size_t>(s.pictures));
  };
  for (int i = 1; i <= s.pictures; ++i) {
    plot.lines.assign(lines.begin(), lines.begin() + share(lines.size(), i));
    plot.facets.assign(facets.begin(), facets.begin() + share(facets.size(), i));
    irg::image<irg::rgba8> picture(plot.width, plot.height, irg::plot_colours{}.paper);
    irg::draw_plot(picture, plot);
    const auto bytes = animation.add(picture);
    if (!bytes) line.fail(bytes.error().message);
    file.insert(file.end(), bytes->begin(), bytes->end());
    std::fprintf(stderr, "picture %d of %d\n", i, s.pictures);
  }
  if (const auto saved = irg::save_file(s.out, std::span<const std::uint8_t>(file)); !saved)
    line.fail(std::string(saved.error().message) + ": " + s.out);
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const irg::height_grid grid = read_heights(line, s);
  const auto plot = irg::plot_surface(grid.surface(), s.plot);
  if (plot.status == irg::grid_surface_status::eye_on_surface) line.fail("the eye lies on the surface");
  if (!plot.ok()) line.fail("there are no heights over a grid of 2x2 points or more");
  if (s.pictures > 0) {
    write_animation(line, s, plot.value);
  } else if (!s.out.empty() && irg::image_format_of_name(s.out) == irg::image_format::svg) {
    write_svg(line, s.out, plot.value);
  } else if (!s.out.empty()) {
    irg::image<irg::rgba8> picture(s.plot.width, s.plot.height, irg::plot_colours{}.paper);
    irg::draw_plot(picture, plot.value);
    program::write_picture(line, s.out, picture);
  }
  static constexpr std::array names{"perimeter", "floating horizon", "facets far to near"};
  std::printf("method: %s\nwhy: %s\nlines: %zu\nfacets: %zu\n", names[static_cast<std::size_t>(plot.value.method)],
              plot.value.why, plot.value.lines.size(), plot.value.facets.size());
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "plot_surface", help}, "this many heights", run); }
