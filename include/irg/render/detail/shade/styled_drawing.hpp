// SPDX-License-Identifier: MIT
// The objects of a picture, drawn in its style: light encoded at once, or kept until the brightest of it is known.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/raster/image.hpp>
#include <irg/render/detail/shade/object_shading.hpp>
#include <irg/shade/intensity_range.hpp>
#include <irg/shade/per_channel.hpp>

namespace irg {
namespace detail {
// A picture, its depths, and what it shows where there is nothing.
template <class Colour, class Depth>
struct picture_target {
  Colour& colour;
  Depth& depth;
  pixel_of<Colour> background;
};
template <class Colour, class Depth>
picture_target(Colour&, Depth&, pixel_of<Colour>) -> picture_target<Colour, Depth>;

inline namespace IRG_ABI {

// What drawing needs to know of the objects, whatever it draws into.
template <class T>
struct styled_objects {
  std::span<const object_shading<T>> objects;
  std::span<const triangle_batch<T>> batches;
  const screen_mapping<T>& mapping;
  const render_options& options;
  draw_workspace& workspace;
};

// Clears the picture and draws the objects, Output deciding what becomes of light.
template <class Output, class Method, class T, class Target, class E>
constexpr render_stats draw_styled(const Method& method, const styled_objects<T>& s, const Target& to,
                                   const E& executor) {
  const auto draw = [&]<class Shading>(const Shading& shading) {
    return draw_tiles<T>(
        method, to.depth,
        {s.batches, s.mapping, s.workspace, s.options.culling, s.options.skip, clearing::before_drawing},
        colour_tiles<T, std::remove_reference_t<decltype(to.colour)>, Shading>(to.colour, shading,
                                                                               clearing::before_drawing, to.background),
        executor);
  };
  if (s.options.style == picture_style::flat) return draw(flat_pixels<Output, T>{s.objects});
  if (s.options.style == picture_style::gouraud) return draw(gouraud_pixels<Output, T>{s.objects});
  return draw(phong_pixels<Output, T>{s.objects});
}

// As draw_styled; if some pixel is brighter than 1, all light of the picture is divided by the brightest channel's.
template <class Method, class T, class Target, class E>
constexpr render_stats draw_rescaled(const Method& method, const styled_objects<T>& s, const Target& to,
                                     const E& executor) {
  constexpr int rows = 64;
  const int width = width_of(to.colour), height = height_of(to.colour);
  image<rgb<float>> light(width, height);
  const render_stats stats = draw_styled<light_itself>(method, s, picture_target{light, to.depth, {}}, executor);
  const auto in_portions = [&](const auto& f) {
    executor(static_cast<std::size_t>((height + rows - 1) / rows), [&](std::size_t i) {
      const int first = static_cast<int>(i) * rows;
      for (int y = first; y < lesser(first + rows, height); ++y) f(i, y);
    });
  };
  std::vector<float> largest_of(static_cast<std::size_t>((height + rows - 1) / rows), 1.0f);
  in_portions([&](std::size_t i, int y) {
    for (int x = 0; x < width; ++x) largest_of[i] = largest_channel(largest_of[i], light(x, y));
  });
  float largest = 1.0f;
  for (const float l : largest_of) largest = greater(l, largest);
  in_portions([&](std::size_t, int y) {
    for (int x = 0; x < width; ++x) {
      const bool shown = get_pixel(to.depth, x, y) != method.farthest();
      const auto scaled = per_channel([&](float channel) { return channel / largest; }, light(x, y));
      set_pixel(to.colour, x, y, shown ? encode(scaled) : to.background);
    }
  });
  return stats;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
