// SPDX-License-Identifier: MIT
// irg as the pipeline's benchmarks call it: everything that depends on its interface stands here and in irg_draw.cpp,
// which is compiled once for all of them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <irg/colour/srgb_lanes.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/render/occlusion_culling.hpp>
#include <irg/render/occlusion_mask.hpp>

#include "render/scenes.hpp"

namespace bench::own {

// The colours of the vertices, to bytes as the peers do it: linear, rounded to the nearest.
struct vertex_colours {
  static constexpr int attribute_count = 3;
  const scene& of;

  const float* attributes(const irg::triangle_batch<float>& batch, std::uint32_t vertex, irg::facing) const {
    return &of.colours[of.objects[batch.object].first_vertex + vertex].r;
  }
  static std::uint8_t byte(float v) { return static_cast<std::uint8_t>(irg::clamped(v, 0.0f, 1.0f) * 255 + 0.5f); }
  irg::rgba8 pixel(const std::array<float, 3>& light) const {
    return {byte(light[0]), byte(light[1]), byte(light[2]), 255};
  }
  // The same in lanes; byte 0 of a word is red, as on every processor that irg has lanes for.
  template <int N>
  IRG_INLINE irg::pack<std::uint32_t, N> pixels(const std::array<irg::pack<float, N>, 3>& light) const {
    using floats = irg::pack<float, N>;
    const floats zero = irg::lanes<floats>::broadcast(0), one = irg::lanes<floats>::broadcast(1);
    const auto bytes = [&](const floats& v) {
      const floats inside = irg::select(one < v, one, irg::select(v < zero, zero, v));
      return irg::converted<std::int32_t>(inside * 255.0f + 0.5f);
    };
    const auto word = bytes(light[0]) | bytes(light[1]) << 8 | bytes(light[2]) << 16;
    return irg::bits_as<std::uint32_t>(word) | 0xff000000u;
  }
};

// The same, encoded as sRGB, as irg::render writes its pictures.
struct encoded_colours {
  static constexpr int attribute_count = 3;
  const scene& of;

  const float* attributes(const irg::triangle_batch<float>& batch, std::uint32_t vertex, irg::facing side) const {
    return vertex_colours{of}.attributes(batch, vertex, side);
  }
  irg::rgba8 pixel(const std::array<float, 3>& light) const { return irg::encode({light[0], light[1], light[2]}); }
  template <int N>
  IRG_INLINE irg::pack<std::uint32_t, N> pixels(const std::array<irg::pack<float, N>, 3>& light) const {
    return irg::encode_lanes(light[0], light[1], light[2]);
  }
};

/// A scene ready to be drawn by irg, one batch per object. What is allocated is kept from frame to frame.
class renderer {
public:
  explicit renderer(const scene& s);

  /// Clears to black, draws the scene with the colours of its vertices.
  irg::render_counts draw(irg::image<irg::rgba8>& picture, irg::image<float>& depth, const irg::skip_options& skip,
                          int threads);
  /// The same with pixels in sRGB.
  irg::render_counts draw_encoded(irg::image<irg::rgba8>& picture, irg::image<float>& depth);
  /// Draws the number of the visible triangle, plus 1, into each pixel.
  void draw_ids(irg::image<std::uint32_t>& ids, irg::image<float>& depth);
  /// Draws the depth alone.
  irg::render_counts draw_depth(irg::image<float>& depth, int threads);
  /// Clears an occlusion mask and draws everything into it.
  void draw_mask(irg::occlusion_mask<>& mask, int threads);
  /// Where the vertices were snapped to; anything for those that have to be clipped.
  std::vector<irg::subpixel> snapped();

private:
  // The triangles of objects that are left out whole.
  struct left_out {
    std::uint32_t beyond = 0, occluded = 0;
  };
  std::span<const irg::point<float, 3>> positions_of(const scene_object& o) const {
    return {scene_.positions.data() + o.first_vertex, o.vertices};
  }
  std::span<const irg::triangle_indices> triangles_of(const scene_object& o) const {
    return {triangles_.data() + o.first_triangle, o.triangles};
  }
  void project(std::size_t object, int threads);
  left_out collect(const irg::skip_options& skip, int threads);
  template <class Picture, class MakeShader>
  irg::render_counts draw_with(Picture& picture, irg::image<float>& depth, const MakeShader& make_shader,
                               const irg::skip_options& skip, int threads);

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
std::string skips_of(const irg::render_counts& s);

}  // namespace bench::own
