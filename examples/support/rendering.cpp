// SPDX-License-Identifier: MIT
// Draws a scene for the programs. It stands in a file of its own so that the renderer is compiled once for all of them.
#include "rendering.hpp"

#include <cstdio>
#include <string>

#include <irg/core/threads.hpp>
#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/hidden/classical_methods.hpp>
#include <irg/hidden/line_drawing.hpp>
#include <irg/io/file.hpp>
#include <irg/io/svg_drawing.hpp>
#include <irg/mesh/merge_positions.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/render/render_traced.hpp>
#include <irg/trace/ray_tracing.hpp>

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
std::string stats_json(const irg::render_counts& s, const timings& ms, std::uint64_t hash) {
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
irg::render_counts draw(const render_settings& s, const irg::scene<double>& world, irg::image<irg::rgba8>& picture,
                        irg::image<float>& depth, const Observer& observer) {
  irg::render_options options = s.options;
  options.hidden =
      s.hidden == hidden_name::none ? irg::hidden_surface_method::none : irg::hidden_surface_method::zbuffer;
  const irg::parallel threads{s.threads};
  if (options.style == irg::picture_style::wire || s.hidden == hidden_name::none || s.hidden == hidden_name::zbuffer)
    return irg::render(world, {picture, depth}, options, threads, observer);
  if (s.follows_rays()) {
    const irg::optics<double> optic{{s.mirror, s.mirror, s.mirror}, {}, 1};
    const std::vector<irg::optics<double>> optics(world.objects.size(), optic);
    irg::traced_options<double> traced;
    traced.culling = options.culling;
    traced.samples = s.samples;
    traced.limits.shadows = s.shadows ? irg::shadow_rays::on : irg::shadow_rays::off;
    traced.optics = optics;
    irg::render_counts stats = irg::render_traced(world, picture, traced, threads);
    stats.drawn = 0;
    const irg::rgba8 background = irg::picture_colours().background;
    for (int y = 0; y < s.size.height; ++y)
      for (int x = 0; x < s.size.width; ++x) stats.drawn += picture(x, y) == background ? 0 : 1;
    observer(irg::render_stage::draw);
    return stats;
  }
  if (s.hidden == hidden_name::raytrace) {
    const irg::render_counts stats = irg::render_with(irg::ray_tracing<>{}, world, {picture, depth}, options, threads);
    observer(irg::render_stage::draw);
    return stats;
  }
  using irg::classical_method;
  const auto method = s.hidden == hidden_name::painter   ? classical_method::painter_newell
                      : s.hidden == hidden_name::warnock ? classical_method::warnock
                      : s.hidden == hidden_name::bsp     ? classical_method::bsp
                                                         : classical_method::ray_casting;
  const irg::render_counts stats =
      irg::render_with(irg::hidden_surfaces_by{method}, world, {picture, depth}, options, threads);
  observer(irg::render_stage::draw);
  return stats;
}

/// Appends text.
struct text_sink {
  std::string text{};
  void operator()(std::string_view piece) { text.append(piece); }
};

/// Draws lines into the picture and into its drawing in vectors.
class line_painter {
public:
  line_painter(irg::image<irg::rgba8>& picture, irg::svg_drawing<text_sink>& svg) : picture_(picture), svg_(svg) {}
  void draw(const irg::point<double, 2>& a, const irg::point<double, 2>& b) {
    svg_.add_line(a, b);
    paint(a, b);
  }
  /// What of a line is in the picture, as dashes.
  void draw_dashed(const irg::point<double, 2>& a, const irg::point<double, 2>& b, double dash) {
    const double width = picture_.width(), height = picture_.height();
    const auto seen = irg::clip_line_liang_barsky(a, b, irg::box<double, 2>{{0, 0}, {width, height}});
    if (!seen) return;
    svg_.add_line(seen->first, seen->second);
    const auto way = seen->second - seen->first;
    const double length = irg::length(way);
    for (double at = 0; at < length; at += 2 * dash) {
      const double end = at + dash < length ? at + dash : length;
      paint(seen->first + way * (at / length), seen->first + way * (end / length));
    }
  }
  std::int64_t shaded() const { return shaded_; }

private:
  void paint(const irg::point<double, 2>& a, const irg::point<double, 2>& b) {
    const irg::rgba8 colour = irg::picture_colours().line;
    irg::line_aa(irg::snap(a), irg::snap(b), {0, 0, picture_.width(), picture_.height()},
                 [&](const irg::coverage_span& run) {
                   for (int x = run.x_first; x < run.x_last; ++x) {
                     const auto coverage = run.coverage[x - run.x_first];
                     if (coverage == 0) continue;  // a run may begin and end beside the line
                     ++shaded_;
                     paint_pixel(picture_, x, run.y, colour, coverage);
                   }
                 });
  }
  irg::image<irg::rgba8>& picture_;
  irg::svg_drawing<text_sink>& svg_;
  std::int64_t shaded_ = 0;
};

/// The faces of a body with one position for all that are equal, without what has no three corners then: of triangles
/// that a file lists each by itself, neighbours are known.
irg::mesh<double> joined(const irg::mesh<double>& shape) {
  const irg::mesh<double> merged = irg::with_merged_positions(shape);
  irg::mesh<double> out;
  out.positions = merged.positions;
  std::vector<std::uint32_t> face;
  for (std::size_t f = 0; f < merged.face_count(); ++f) {
    face.clear();
    for (std::size_t k = 0; k < merged.face_size(f); ++k) {
      const std::uint32_t v = merged.corner(f, k).position;
      if (face.empty() || face.back() != v) face.push_back(v);
    }
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() > 2) irg::add_face(out, face);
  }
  return out;
}

/// Adds the edges that the options ask for, and the faces that hide.
void add_body(irg::line_drawing& drawing, const render_settings& s, irg::face_culling culling,
              const irg::mesh<double>& shape, const irg::mat<double, 4, 4>& to_clip) {
  irg::line_drawing_options<double> options;
  options.edges = s.edges == edge_choice::all       ? irg::drawn_edges::every
                  : s.edges == edge_choice::outline ? irg::drawn_edges::outline
                                                    : irg::drawn_edges::features;
  options.crease = irg::radians(s.edge_crease);
  options.culling = culling;
  options.frustum = s.options.skip.frustum;
  const irg::mesh<double> body = joined(shape);
  add_mesh(drawing, body, to_clip, irg::map_to_screen<double>({s.size.width, s.size.height}), options);
  const auto triangles = [](const irg::mesh<double>& m) {
    return static_cast<std::int64_t>(m.corners.size()) - 2 * static_cast<std::int64_t>(m.face_count());
  };
  const std::int64_t collapsed = triangles(shape) - triangles(body);  // which have no area, and so no front
  drawing.triangles += collapsed;
  if (s.options.culling == irg::face_culling::back) drawing.culled += collapsed;
}

/// Draws the visible parts of edges, into the picture and as lines; under them the hidden parts, if asked for.
irg::render_counts draw_hidden_lines(const render_settings& s, const irg::scene<double>& world,
                                     irg::image<irg::rgba8>& picture, text_sink& text, stopwatch& watch, timings& ms) {
  const irg::picture_colours colours;
  clear(picture, colours.background);
  const auto to_clip = view_projection(world.view, static_cast<double>(s.size.width) / s.size.height);
  // The hidden edges of a closed body are mostly those between faces that face away.
  const auto culling = s.dashed && !s.says_culling ? irg::face_culling::none : s.options.culling;
  irg::line_drawing drawing;
  for (const irg::object<double>& o : world.objects) add_body(drawing, s, culling, o.shape, to_clip * o.placement);
  ms.stage[static_cast<int>(irg::render_stage::project)] = watch.lap();
  if (s.hidden == hidden_name::none) drawing.faces.clear();
  if (s.options.skip.frustum == irg::skipping::on) leave_out_faces_beside_edges(drawing);
  irg::render_counts stats;
  stats.triangles = drawing.triangles;
  stats.skipped.frustum = drawing.beyond;
  stats.skipped.backface = drawing.culled;
  irg::svg_drawing svg(text, {s.size.width, s.size.height}, colours.background);
  line_painter painter(picture, svg);
  const auto end_of = [&](const irg::edge_part& part, double t) { return point_on(drawing.edges[part.edge], t); };
  std::vector<irg::edge_part> visible;
  constexpr double dash = 3;
  if (s.dashed) svg.begin_lines({.colour = colours.line, .width = 0.5, .dash = dash});
  irg::hidden_lines(drawing.faces, drawing.edges, [&](const irg::edge_part& part) {
    if (part.visibility == irg::line_visibility::visible)
      visible.push_back(part);
    else if (s.dashed)
      painter.draw_dashed(end_of(part, part.from), end_of(part, part.to), dash);
  });
  svg.begin_lines({.colour = colours.line});
  for (const irg::edge_part& part : visible) painter.draw(end_of(part, part.from), end_of(part, part.to));
  svg.finish();
  stats.pixels.tested = stats.pixels.shaded = painter.shaded();
  for (int y = 0; y < s.size.height; ++y)
    for (int x = 0; x < s.size.width; ++x) stats.drawn += picture(x, y) == colours.background ? 0 : 1;
  ms.stage[static_cast<int>(irg::render_stage::draw)] = watch.lap();
  return stats;
}

}  // namespace

void draw_scene(const command_line& line, const render_settings& s, const irg::scene<double>& world, timings ms) {
  stopwatch watch;
  irg::image<irg::rgba8> picture(s.size.width, s.size.height);
  text_sink svg;
  watch.lap();
  const irg::render_counts stats = [&] {
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
  const auto old_picture = irg::load_file(s.stats.empty() ? std::string() : s.out);
  watch.lap();
  if (s.hidden_line && !s.out.empty() && irg::image_format_of_name(s.out) == irg::image_format::svg) {
    if (const auto saved = irg::save_file(s.out, svg.text); !saved)
      line.fail(std::string(saved.error().message) + ": " + s.out);
  } else if (!s.out.empty()) {
    write_picture(line, s.out, picture);
  }
  ms.write = watch.lap();
  if (s.stats.empty()) return;
  const std::string json = stats_json(stats, ms, hash_of(picture));
  if (const auto saved = irg::save_file(s.stats, json); !saved) {
    if (!s.out.empty() && (!old_picture || !irg::save_file(s.out, *old_picture))) std::remove(s.out.c_str());
    line.fail(std::string(saved.error().message) + ": " + s.stats);
  }
}

}  // namespace program
