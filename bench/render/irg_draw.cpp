// SPDX-License-Identifier: MIT
#include "render/irg_draw.hpp"

#include <cstdio>

#include <irg/core/threads.hpp>
#include <irg/render/draw_depth.hpp>

namespace bench::own {

renderer::renderer(const scene& s)
    : scene_(s), mapping_(irg::map_to_screen<float>({s.width, s.height})), vertices_(s.objects.size()),
      hidden_(s.to_clip, {s.width, s.height}) {
  triangles_.reserve(s.triangles.size());
  for (const scene_object& o : s.objects) {
    extents_.push_back({o.bounds, o.triangles});
    for (std::uint32_t i = 0; i < o.triangles; ++i) {
      const auto [a, b, c] = s.triangles[o.first_triangle + i].v;
      triangles_.push_back({{a - o.first_vertex, b - o.first_vertex, c - o.first_vertex}});
    }
  }
}

void renderer::project(std::size_t object, int threads) {
  irg::project_vertices<float>(positions_of(scene_.objects[object]), scene_.to_clip, mapping_, vertices_[object],
                               irg::parallel{threads});
}

// The batches of all objects but those that are left out.
renderer::left_out renderer::collect(const irg::skip_options& skip, int threads) {
  left_out none;
  hidden_.clear();
  if (skip.occluded == irg::skipping::on)
    for (const std::uint32_t k : hidden_.choose_occluders(extents_)) {
      const scene_object& o = scene_.objects[k];
      hidden_.add_occluder(positions_of(o), triangles_of(o), scene_.culling);
    }
  batches_.clear();
  for (std::size_t k = 0; k < vertices_.size(); ++k) {
    const scene_object& o = scene_.objects[k];
    if (skip.frustum == irg::skipping::on && hidden_.is_beyond(o.bounds)) {
      none.beyond += o.triangles;
    } else if (hidden_.hides(o.bounds)) {
      none.occluded += o.triangles;
    } else {
      project(k, threads);
      batches_.push_back({&vertices_[k], triangles_of(o), o.first_triangle - none.beyond - none.occluded,
                          static_cast<std::uint32_t>(k)});
    }
  }
  return none;
}

template <class Picture, class MakeShader>
irg::render_counts renderer::draw_with(Picture& picture, irg::image<float>& depth, const MakeShader& make_shader,
                                       const irg::skip_options& skip, int threads) {
  const left_out whole = collect(skip, threads);
  irg::render_counts stats = irg::shade_batches<irg::nearer_is_greater, float>(
      irg::render_target{picture, depth}, {batches_, mapping_}, make_shader,
      {.culling = scene_.culling, .skip = skip, .clear = irg::clearing::before_drawing, .workspace = &workspace_},
      irg::parallel{threads});
  stats.triangles += whole.beyond + whole.occluded;
  stats.skipped.frustum += whole.beyond;
  stats.skipped.occluded += whole.occluded;
  return stats;
}

irg::render_counts renderer::draw(irg::image<irg::rgba8>& picture, irg::image<float>& depth,
                                  const irg::skip_options& skip, int threads) {
  return draw_with(picture, depth, vertex_colours{scene_}, skip, threads);
}

irg::render_counts renderer::draw_encoded(irg::image<irg::rgba8>& picture, irg::image<float>& depth) {
  return draw_with(picture, depth, encoded_colours{scene_}, {}, 1);
}

void renderer::draw_ids(irg::image<std::uint32_t>& ids, irg::image<float>& depth) {
  const auto make_shader = [this](const irg::triangle_batch<float>& batch, std::uint32_t i, irg::facing) {
    return irg::solid_shader<std::uint32_t>{scene_.objects[batch.object].first_triangle + i + 1};
  };
  draw_with(ids, depth, make_shader, {}, 1);
}

irg::render_counts renderer::draw_depth(irg::image<float>& depth, int threads) {
  collect({}, threads);
  return irg::draw_depth<irg::nearer_is_greater, float>(
      depth, {batches_, mapping_},
      {.culling = scene_.culling, .clear = irg::clearing::before_drawing, .workspace = &workspace_},
      irg::parallel{threads});
}

void renderer::draw_mask(irg::occlusion_mask<>& mask, int threads) {
  collect({}, threads);
  mask.clear();
  (void)mask.draw<float>(batches_, mapping_, scene_.culling, irg::parallel{threads});
}

std::vector<irg::subpixel> renderer::snapped() {
  for (std::size_t k = 0; k < vertices_.size(); ++k) project(k, 1);
  std::vector<irg::subpixel> places;
  for (const auto& of_object : vertices_)
    for (const irg::screen_vertex& v : of_object.screen) places.push_back(v.position);
  return places;
}

std::string skips_of(const irg::render_counts& s) {
  const auto share = [&s](std::int64_t n) { return 100 * static_cast<double>(n) / static_cast<double>(s.triangles); };
  char text[200];
  std::snprintf(text, sizeof text,
                "skipped: outside %.1f %% back faces %.1f %% without a centre %.1f %% occluded %.1f %%; %lld px tested "
                "%lld px shaded",
                share(s.skipped.frustum), share(s.skipped.backface), share(s.skipped.tiny), share(s.skipped.occluded),
                static_cast<long long>(s.pixels.tested), static_cast<long long>(s.pixels.shaded));
  return text;
}

}  // namespace bench::own
