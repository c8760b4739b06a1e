// SPDX-License-Identifier: MIT
// Draws a scene for the programs. It stands in a file of its own so that the renderer is compiled once for all of them.
#include "rendering.hpp"

#include <cstdio>
#include <string>

#include <irg/core/threads.hpp>
#include <irg/io/file.hpp>
#include <irg/render/classical_methods.hpp>

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

}  // namespace

void draw_scene(const command_line& line, const render_settings& s, const irg::scene<double>& world, timings ms) {
  stopwatch watch;
  irg::image<irg::rgba8> picture(s.size.width, s.size.height);
  irg::image<float> depth(s.size.width, s.size.height);
  watch.lap();
  const irg::render_stats stats = draw(
      s, world, picture, depth, [&](irg::render_stage stage) { ms.stage[static_cast<int>(stage)] += watch.lap(); });
  if (stats.drawn == 0)
    line.hint(s.eye || s.target
                  ? "the picture is empty: nothing of the model is in view; without --eye and --target all of it is"
                  : "the picture is empty: no face of the model shows");
  const auto old_picture = irg::read_file(s.stats.empty() ? std::string() : s.out);
  watch.lap();
  if (!s.out.empty()) write_picture(line, s.out, picture);
  ms.write = watch.lap();
  if (s.stats.empty()) return;
  const std::string json = stats_json(stats, ms, hash_of(picture));
  if (const auto error = irg::write_file_atomically(s.stats, json)) {
    if (!s.out.empty() && (!old_picture || irg::write_file_atomically(s.out, *old_picture))) std::remove(s.out.c_str());
    line.fail(std::string(error->message) + ": " + s.stats);
  }
}

}  // namespace program
