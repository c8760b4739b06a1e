// SPDX-License-Identifier: MIT
// Draws a scene for the programs. It stands in a file of its own so that the renderer is compiled once for all of them.
#include "rendering.hpp"

#include <cstdio>
#include <string>

#include <irg/core/threads.hpp>
#include <irg/hidden/classical_methods.hpp>
#include <irg/hidden/line_drawing.hpp>
#include <irg/io/file.hpp>
#include <irg/raster/line_aa.hpp>

namespace program {
namespace {

/// FNV-1a 64 of width and height, then red, green, blue and opacity of every pixel.
std::uint64_t hash_of(const irg::image<irg::rgba8>& picture) {
  std::uint64_t h = 14695981039346656037u;
  const auto byte = [&](unsigned b) { h = (h ^ (b & 255u)) * 1099511628211u; };
  for (const int n : {picture.width(), picture.height()})
    for (int shift = 0; shift < 32; shift += 8) byte(static_cast<unsigned>(n) >> shift);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const irg::rgba8 p = picture(x, y);
      for (const unsigned channel : {p.r, p.g, p.b, p.a}) byte(channel);
    }
  return h;
}

/// What --stats writes.
std::string stats_json(const irg::render_stats& s, const timings& ms, std::uint64_t hash) {
  char text[1200];
  const auto n = [](std::int64_t v) { return static_cast<long long>(v); };
  const int length = std::snprintf(
      text, sizeof text,
      "{\n  \"triangles\": %lld,\n"
      "  \"skipped\": {\"frustum\": %lld, \"backface\": %lld, \"small\": %lld, \"occluded\": %lld},\n"
      "  \"pixels_tested\": %lld,\n  \"pixels_shaded\": %lld,\n  \"pixels_drawn\": %lld,\n  \"depth_ties\": %lld,\n"
      "  \"ms\": {\"load\": %.3f, \"prepare\": %.3f, \"shade\": %.3f, \"project\": %.3f, \"draw\": %.3f, \"write\": "
      "%.3f},\n"
      "  \"hash\": \"%016llx\"\n}\n",
      n(s.triangles), n(s.skipped.frustum), n(s.skipped.backface), n(s.skipped.tiny), n(s.skipped.occluded),
      n(s.pixels.tested), n(s.pixels.shaded), n(s.drawn), n(s.pixels.ties), ms.load, ms.stage[0], ms.stage[1],
      ms.stage[2], ms.stage[3], ms.write, static_cast<unsigned long long>(hash));
  return {text, static_cast<std::size_t>(length)};
}

/// The picture by the method that the options name. Edges are not faces: `wire` knows none of the classical methods.
template <class Observer>
irg::render_stats draw(const render_settings& s, const irg::scene<double>& world, irg::image<irg::rgba8>& picture,
                       irg::image<float>& depth, const Observer& observer) {
  irg::render_options options = s.options;
  options.hidden =
      s.hidden == hidden_name::none ? irg::hidden_surface_method::none : irg::hidden_surface_method::zbuffer;
  const irg::parallel threads{s.threads};
  if (options.style == irg::picture_style::wire || s.hidden == hidden_name::none || s.hidden == hidden_name::zbuffer)
    return irg::render(world, picture, depth, options, {}, threads, observer);
  using irg::classical_method;
  const auto method = s.hidden == hidden_name::painter   ? classical_method::painter_newell
                      : s.hidden == hidden_name::warnock ? classical_method::warnock
                      : s.hidden == hidden_name::bsp     ? classical_method::bsp
                                                         : classical_method::ray_casting;
  const irg::render_stats stats = irg::render(irg::hidden_surfaces_by{method}, world, picture, depth, options, threads);
  observer(irg::render_stage::draw);
  return stats;
}

/// A line drawing as an SVG picture.
class svg_lines {
public:
  explicit svg_lines(const render_settings& s) : width_(s.size.width), height_(s.size.height) {
    const auto number = [](int n) { return std::to_string(n); };
    text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width_) + "\" height=\"" + number(height_) +
            "\" viewBox=\"0 0 " + number(width_) + " " + number(height_) + "\">\n<rect width=\"100%\" height=\"100%\"" +
            " fill=\"" + colour(colours_.background) + "\"/>\n<g stroke=\"" + colour(colours_.line) +
            "\" stroke-linecap=\"round\">\n";
  }
  void add(const irg::point<double, 2>& a, const irg::point<double, 2>& b) {
    if ((a.x < 0 && b.x < 0) || (a.y < 0 && b.y < 0) || (a.x > width_ && b.x > width_) ||
        (a.y > height_ && b.y > height_))
      return;
    char line[200];
    const int length = std::snprintf(line, sizeof line, "<line x1=\"%.9g\" y1=\"%.9g\" x2=\"%.9g\" y2=\"%.9g\"/>\n",
                                     a.x, a.y, b.x, b.y);
    text_.append(line, static_cast<std::size_t>(length));
  }
  std::string finished() const { return text_ + "</g>\n</svg>\n"; }

private:
  static std::string colour(irg::rgba8 c) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c.r, c.g, c.b);
    return text;
  }
  int width_, height_;
  std::string text_{};
  irg::picture_colours colours_{};
};

/// Draws the visible parts of all edges, into the picture and as lines.
irg::render_stats draw_hidden_lines(const render_settings& s, const irg::scene<double>& world,
                                    irg::image<irg::rgba8>& picture, svg_lines& svg, stopwatch& watch, timings& ms) {
  const irg::picture_colours colours;
  clear(picture, colours.background);
  const auto to_clip = view_projection(world.view, static_cast<double>(s.size.width) / s.size.height);
  irg::line_drawing drawing;
  for (const irg::object<double>& o : world.objects)
    add_mesh(drawing, o.shape, to_clip * o.placement, irg::map_to_screen<double>(s.size.width, s.size.height),
             {.edges = irg::drawn_edges::every, .culling = s.options.culling});
  ms.stage[static_cast<int>(irg::render_stage::project)] = watch.lap();
  if (s.hidden == hidden_name::none) drawing.faces.clear();
  irg::render_stats stats;
  stats.triangles = drawing.triangles;
  stats.skipped.backface = drawing.culled;
  irg::hidden_lines(drawing.faces, drawing.edges, [&](const irg::edge_part& part) {
    if (part.visibility == irg::line_visibility::hidden) return;
    const auto a = point_on(drawing.edges[part.edge], part.from), b = point_on(drawing.edges[part.edge], part.to);
    svg.add(a, b);
    irg::line_aa(irg::snap(a), irg::snap(b), {0, 0, s.size.width, s.size.height}, [&](const irg::coverage_span& run) {
      stats.pixels.shaded += run.x_last - run.x_first;
      for (int x = run.x_first; x < run.x_last; ++x)
        paint_pixel(picture, x, run.y, colours.line, run.coverage[x - run.x_first]);
    });
  });
  stats.pixels.tested = stats.pixels.shaded;
  for (int y = 0; y < s.size.height; ++y)
    for (int x = 0; x < s.size.width; ++x) stats.drawn += picture(x, y) == colours.background ? 0 : 1;
  ms.stage[static_cast<int>(irg::render_stage::draw)] = watch.lap();
  return stats;
}

}  // namespace

void draw_scene(const command_line& line, const render_settings& s, const irg::scene<double>& world, timings ms) {
  stopwatch watch;
  irg::image<irg::rgba8> picture(s.size.width, s.size.height);
  svg_lines svg(s);
  watch.lap();
  const irg::render_stats stats = [&] {
    if (s.hidden_line) return draw_hidden_lines(s, world, picture, svg, watch, ms);
    irg::image<float> depth(s.size.width, s.size.height);
    watch.lap();
    return draw(s, world, picture, depth,
                [&](irg::render_stage stage) { ms.stage[static_cast<int>(stage)] += watch.lap(); });
  }();
  if (stats.drawn == 0)
    line.hint(s.eye || s.target
                  ? "the picture is empty: nothing of the model is in view; without --eye and --target all of it is"
                  : "the picture is empty: no face of the model shows");
  const auto old_picture = irg::read_file(s.stats.empty() ? std::string() : s.out);
  watch.lap();
  if (s.hidden_line && !s.out.empty() && irg::picture_format_of(s.out) == irg::picture_format::svg) {
    if (const auto error = irg::write_file_atomically(s.out, svg.finished()))
      line.fail(std::string(error->message) + ": " + s.out);
  } else if (!s.out.empty()) {
    write_picture(line, s.out, picture);
  }
  ms.write = watch.lap();
  if (s.stats.empty()) return;
  const std::string json = stats_json(stats, ms, hash_of(picture));
  if (const auto error = irg::write_file_atomically(s.stats, json)) {
    if (!s.out.empty() && (!old_picture || irg::write_file_atomically(s.out, *old_picture))) std::remove(s.out.c_str());
    line.fail(std::string(error->message) + ": " + s.stats);
  }
}

}  // namespace program
