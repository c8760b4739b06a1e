// SPDX-License-Identifier: MIT
// irg as the pipeline's benchmarks call it: everything that depends on its interface stands here.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/raster/image.hpp>
#include <irg/render/draw_depth.hpp>
#include <irg/render/occlusion_culling.hpp>
#include <irg/render/occlusion_mask.hpp>
#include <irg/render/render.hpp>

#include "render/scenes.hpp"

namespace bench::own {

// The colours of the vertices, to bytes as the peers do it: linear, rounded to the nearest.
struct vertex_colours {
  static constexpr int attribute_count = 3;
  const scene& of;

  const float* attributes(const irg::triangle_batch<float>& batch, std::uint32_t vertex, irg::facing) const {
    return &of.colours[of.objects[batch.object].first_vertex + vertex].r;
  }
  static std::uint8_t byte(float v) { return static_cast<std::uint8_t>(irg::clamp(v, 0.0f, 1.0f) * 255 + 0.5f); }
  irg::rgba8 pixel(const std::array<float, 3>& light) const {
    return {byte(light[0]), byte(light[1]), byte(light[2]), 255};
  }
#ifdef IRG_LANES_VECTOR
  // The same in lanes; byte 0 of a word is red, as on every processor that irg has lanes for.
  template <int N>
  IRG_INLINE irg::pack<std::uint32_t, N> pixels(const std::array<irg::pack<float, N>, 3>& light) const {
    using floats = irg::pack<float, N>;
    const floats zero = irg::lanes<floats>::broadcast(0), one = irg::lanes<floats>::broadcast(1);
    const auto bytes = [&](const floats& v) {
      const floats inside = irg::select(one < v, one, irg::select(v < zero, zero, v));
      return __builtin_convertvector(inside.v * 255.0f + 0.5f, typename irg::pack<std::int32_t, N>::storage);
    };
    const auto word = bytes(light[0]) | bytes(light[1]) << 8 | bytes(light[2]) << 16;
    using words = typename irg::pack<std::uint32_t, N>::storage;
    return {__builtin_convertvector(word, words) | 0xff000000u};
  }
#endif
};

/// A scene ready to be drawn by irg, one batch per object. What is allocated is kept from frame to frame.
class renderer {
public:
  explicit renderer(const scene& s)
      : scene_(s), mapping_(irg::map_to_screen<float>(s.width, s.height)), vertices_(s.objects.size()),
        hidden_(s.to_clip, s.width, s.height) {
    triangles_.reserve(s.triangles.size());
    for (const scene_object& o : s.objects) {
      extents_.push_back({o.bounds, o.triangles});
      for (std::uint32_t i = 0; i < o.triangles; ++i) {
        const auto [a, b, c] = s.triangles[o.first_triangle + i].v;
        triangles_.push_back({{a - o.first_vertex, b - o.first_vertex, c - o.first_vertex}});
      }
    }
  }

  /// Clears to black, draws the scene with the colours of its vertices.
  template <class E = irg::sequential>
  irg::render_stats draw(irg::image<irg::rgba8>& picture, irg::image<float>& depth, const irg::skip_options& skip = {},
                         const E& executor = {}) {
    return draw_with(picture, depth, vertex_colours{scene_}, skip, executor);
  }

  /// Draws the number of the visible triangle, plus 1, into each pixel.
  void draw_ids(irg::image<std::uint32_t>& ids, irg::image<float>& depth) {
    const auto make_shader = [this](const irg::triangle_batch<float>& batch, std::uint32_t i, irg::facing) {
      return irg::solid_shader<std::uint32_t>{scene_.objects[batch.object].first_triangle + i + 1};
    };
    draw_with(ids, depth, make_shader, {}, irg::sequential{});
  }

  /// Draws the depth alone.
  template <class E = irg::sequential>
  irg::render_stats draw_depth(irg::image<float>& depth, const E& executor = {}) {
    collect({}, executor);
    return irg::draw_depth<irg::nearer_is_greater, float>(
        depth, batches_, mapping_, {scene_.culling, {}, irg::clearing::before_drawing}, workspace_, executor);
  }

  /// Clears an occlusion mask and draws everything into it.
  template <class E = irg::sequential>
  irg::occluder_counts draw_mask(irg::occlusion_mask<>& mask, const E& executor = {}) {
    collect({}, executor);
    mask.clear();
    return mask.draw<float>(batches_, mapping_, scene_.culling, executor);
  }

  /// Where the vertices were snapped to; anything for those that have to be clipped.
  std::vector<irg::subpixel> snapped() {
    for (std::size_t k = 0; k < vertices_.size(); ++k) project(k, irg::sequential{});
    std::vector<irg::subpixel> places;
    for (const auto& of_object : vertices_)
      for (const irg::screen_vertex& v : of_object.screen) places.push_back(v.position);
    return places;
  }

private:
  std::span<const irg::point<float, 3>> positions_of(const scene_object& o) const {
    return {scene_.positions.data() + o.first_vertex, o.vertices};
  }
  std::span<const irg::triangle_indices> triangles_of(const scene_object& o) const {
    return {triangles_.data() + o.first_triangle, o.triangles};
  }

  template <class E>
  void project(std::size_t object, const E& executor) {
    irg::project_vertices<float>(vertices_[object], positions_of(scene_.objects[object]), scene_.to_clip, mapping_,
                                 executor);
  }

  // The triangles of objects that are left out whole.
  struct left_out {
    std::uint32_t beyond = 0, occluded = 0;
  };

  // The batches of all other objects.
  template <class E>
  left_out collect(const irg::skip_options& skip, const E& executor) {
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
        project(k, executor);
        batches_.push_back({&vertices_[k], triangles_of(o), o.first_triangle - none.beyond - none.occluded,
                            static_cast<std::uint32_t>(k)});
      }
    }
    return none;
  }

  template <class Picture, class MakeShader, class E>
  irg::render_stats draw_with(Picture& picture, irg::image<float>& depth, const MakeShader& make_shader,
                              const irg::skip_options& skip, const E& executor) {
    const left_out whole = collect(skip, executor);
    irg::render_stats stats = irg::draw_batches<irg::nearer_is_greater, float>(
        picture, depth, batches_, mapping_, make_shader,
        irg::draw_settings<irg::pixel_of<Picture>>{scene_.culling, skip, irg::clearing::before_drawing, {}}, workspace_,
        executor);
    stats.triangles += whole.beyond + whole.occluded;
    stats.skipped.frustum += whole.beyond;
    stats.skipped.occluded += whole.occluded;
    return stats;
  }

  const scene& scene_;
  irg::screen_mapping<float> mapping_;
  std::vector<irg::triangle_indices> triangles_{};  // indices into the vertices of their object
  std::vector<irg::projected_vertices<float>> vertices_;
  std::vector<irg::triangle_batch<float>> batches_{};
  std::vector<irg::object_extent<float>> extents_{};
  irg::occlusion_culling<float> hidden_;
  irg::draw_workspace workspace_{};
};

/// Which share of the triangles was skipped, and why.
inline void print_skips(const irg::render_stats& s) {
  const auto share = [&s](std::int64_t n) { return 100 * static_cast<double>(n) / static_cast<double>(s.triangles); };
  std::printf(
      "  irg skipped: outside %.1f %%, back faces %.1f %%, without a centre %.1f %%, occluded %.1f %%; "
      "%lld pixels tested, %lld shaded\n",
      share(s.skipped.frustum), share(s.skipped.backface), share(s.skipped.tiny), share(s.skipped.occluded),
      static_cast<long long>(s.pixels.tested), static_cast<long long>(s.pixels.shaded));
}

}  // namespace bench::own
