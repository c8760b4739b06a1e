// SPDX-License-Identifier: MIT
// render: a scene becomes a picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/mesh/validate.hpp>
#include <irg/render/detail/object_selection.hpp>
#include <irg/render/detail/styled_drawing.hpp>
#include <irg/render/wireframe.hpp>
#include <irg/scene/scene.hpp>
#include <irg/view/affine.hpp>

namespace irg {

/// The stages of rendering, told to an observer as each one ends.
enum class render_stage { prepare, shade, project, draw };

/// An observer of stages that does nothing.
struct no_observer {
  IRG_INLINE constexpr void operator()(render_stage) const noexcept {}
};

/// The colours of a picture that do not come from its scene.
struct picture_colours {
  rgba8 background{250, 249, 246, 255};
  rgba8 line{32, 44, 66, 255};
};

namespace detail {
inline namespace IRG_ABI {

template <class R>
constexpr std::int64_t count_other_than(const R& raster, const pixel_of<R>& background) {
  std::int64_t count = 0;
  for (int y = 0; y < height_of(raster); ++y)
    for (int x = 0; x < width_of(raster); ++x) count += get_pixel(raster, x, y) == background ? 0 : 1;
  return count;
}

// The edges of one object.
template <class T, class Colour, class E, class Observer>
constexpr render_stats draw_object_wire(const mesh<T>& shape, Colour& colour, const mat<T, 4, 4>& to_clip,
                                        const screen_mapping<T>& mapping, const render_options& options,
                                        const picture_colours& colours, const E& executor, Observer& observer) {
  const auto vertices = project_vertices<T>(shape.positions, to_clip, mapping);
  observer(render_stage::project);
  const render_stats stats = draw_wireframe(colour, vertices, shape, mapping, colours.line, options.culling, executor);
  observer(render_stage::draw);
  return stats;
}

// The faces of all objects, in the style that the options name.
template <class Order, class T, class Colour, class Depth, class E, class Observer>
constexpr render_stats draw_filled(const scene<T>& world, Colour& colour, Depth& depth, const mat<T, 4, 4>& to_clip,
                                   const screen_mapping<T>& mapping, const render_options& options,
                                   const rgba8& background, const E& executor, Observer& observer) {
  const lighting<T> light{world.ambient, world.lights};
  const point<T, 3> eye = viewpoint(world.view);
  const object_selection chosen = select_objects<Order>(world, to_clip, width_of(colour), height_of(colour), options);
  std::vector<object_shading<T>> objects;
  std::vector<projected_vertices<T>> vertices(chosen.drawn.size(), projected_vertices<T>{});
  std::vector<triangle_batch<T>> batches;
  objects.reserve(chosen.drawn.size());
  batches.reserve(chosen.drawn.size());
  std::uint32_t number = 0;
  for (const std::uint32_t k : chosen.drawn) {
    const object<T>& o = world.objects[k];
    object_shading<T>& shading = objects.emplace_back(transform_mesh(o.shape, o.placement), o.surface, light, eye);
    observer(render_stage::prepare);
    shading.prepare(options.style, options.culling, executor);
    observer(render_stage::shade);
    const std::size_t i = batches.size();
    project_vertices<T>(vertices[i], shading.body.positions, to_clip, mapping, executor);
    batches.push_back({&vertices[i], shading.body.triangles, number, static_cast<std::uint32_t>(i)});
    number += static_cast<std::uint32_t>(shading.body.triangles.size());
    observer(render_stage::project);
  }
  const styled_objects<T> styled{objects, batches, mapping, options};
  render_stats stats = options.intensities == intensity_range::rescale
                           ? draw_rescaled<Order>(styled, colour, depth, background, executor)
                           : draw_styled<Order, encoded_light>(styled, colour, depth, background, executor);
  stats.triangles += chosen.beyond + chosen.occluded;
  stats.skipped.frustum += chosen.beyond;
  stats.skipped.occluded += chosen.occluded;
  observer(render_stage::draw);
  return stats;
}

template <class Order, class T, class Colour, class Depth, class E, class Observer>
constexpr render_stats render_ordered(const scene<T>& world, Colour& colour, Depth& depth,
                                      const render_options& options, const picture_colours& colours, const E& executor,
                                      Observer& observer) {
  const int width = width_of(colour), height = height_of(colour);
  render_stats stats;
  for ([[maybe_unused]] const object<T>& o : world.objects)
    IRG_EXPECTS(find_face_defect(o.shape).defect == mesh_defect::none);
  if (width == 0 || height == 0) return stats;
  const screen_mapping<T> mapping = map_to_screen<T>(width, height);
  const mat<T, 4, 4> to_clip = view_projection(world.view, static_cast<T>(width) / static_cast<T>(height));
  if (options.style != picture_style::wire)
    return draw_filled<Order>(world, colour, depth, to_clip, mapping, options, colours.background, executor, observer);
  clear(colour, colours.background);
  clear(depth, Order::farthest);
  for (const object<T>& o : world.objects)
    stats += draw_object_wire(transform_mesh(o.shape, o.placement), colour, to_clip, mapping, options, colours,
                              executor, observer);
  stats.drawn = count_other_than(colour, colours.background);
  return stats;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Renders a scene into a picture and its depth buffer, both overwritten, and returns what it did.
/// shape   colour and depth have one size, at most 65536 x 65536
/// needs   meshes whose faces have no defect that validate (mesh/validate.hpp) knows, no index out of range above all:
///         a contract, checked in constant evaluation and in debug builds; a camera in its domain
/// gives   the background alone for a scene without objects; of equal depths the first object and face wins; with
///         hidden_surface_method::none, what is drawn later covers what was drawn before
/// exact   the same bytes for every executor, compiler, instruction set and for skipping on and off
/// cost    the vertices and triangles once, then the pixels
template <Floating T, RowRaster Colour, RowRaster Depth, Executor E = sequential, class Observer = no_observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_stats render(const scene<T>& world, Colour& colour, Depth& depth, const render_options& options = {},
                              const picture_colours& colours = {}, const E& executor = {}, Observer&& observer = {}) {
  if (options.hidden == hidden_surface_method::none)
    return detail::render_ordered<drawing_order>(world, colour, depth, options, colours, executor, observer);
  return detail::render_ordered<nearer_is_greater>(world, colour, depth, options, colours, executor, observer);
}

}  // namespace IRG_ABI
}  // namespace irg
