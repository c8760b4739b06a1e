// SPDX-License-Identifier: MIT
// render: a scene becomes a picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/executor.hpp>
#include <irg/core/function_ref.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/detail/visible/draw_target.hpp>
#include <irg/render/options.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/render/window_faces.hpp>
#include <irg/scene/scene.hpp>
#if IRG_BODIES
#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/validate.hpp>
#include <irg/render/detail/shade/object_shading.hpp>
#include <irg/render/detail/visible/method_tiles.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/render/occlusion_culling.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/render/wireframe.hpp>
#include <irg/shade/intensity_range.hpp>
#include <irg/shade/per_channel.hpp>
#endif

namespace irg {

/// The stages of rendering, told to an observer as each one ends.
enum class render_stage { prepare, shade, project, draw };

/// An observer of stages that does nothing.
struct no_observer {
  IRG_INLINE constexpr void operator()(render_stage) const noexcept {}
};

inline namespace IRG_ABI {

/// Renders a scene into a picture and its depth buffer, both overwritten, and returns what it did.
/// shape   into {picture, depth}, of one size, at most 65536 x 65536
/// needs   meshes whose faces have no defect that validate (mesh/validate.hpp) knows, no index out of range above all:
///         a contract, checked in constant evaluation and in debug builds; a camera in its domain
/// gives   the background alone for a scene without objects; of equal depths the first object and face wins; what lies
///         in the far plane, at the farthest depth itself, is not seen; with hidden_surface_method::none, what is drawn
///         later covers what was drawn before
/// exact   the same bytes for every executor, compiler, instruction set and for skipping on and off
/// cost    the vertices and triangles once, then the pixels
template <Floating T, RowRaster Colour = image_view<rgba8>, RowRaster Depth = image_view<float>,
          Executor E = sequential, class Observer = no_observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts render(const scene<T>& world, render_target<Colour, Depth> target,
                               const render_options& options = {}, const E& executor = {}, Observer&& observer = {});

/// Renders a scene with a hidden-surface method of the caller's: the picture is what the method says is seen, shaded as
/// ever.
/// needs   as render
/// gives   what the method finds. Nothing is left out because something else hides it, `options.hidden` has no say, and
///         edges are not faces: `wire` is drawn as `flat`. A method that says that it `finds_nearest()` is not asked
///         about windows that show the front faces of one convex body alone: pixels.convex counts these faces
/// exact   where the method finds the nearest face by the picture's rule, the bytes of the z-buffer, depths included
template <Floating T, RowRaster Colour = image_view<rgba8>, RowRaster Depth = image_view<float>,
          HiddenSurfaceMethod<T> Method, Executor E = sequential>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts render_with(const Method& method, const scene<T>& world, render_target<Colour, Depth> target,
                                    render_options options = {}, const E& executor = {});
template <Floating T, RowRaster Colour = image_view<rgba8>, RowRaster Depth = image_view<float>,
          HiddenSurfaceMethod<T> Method, Executor E = sequential>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
[[deprecated("irg: render_with(method, world, target, ..)")]] constexpr render_counts render(
    const Method& method, const scene<T>& world, render_target<Colour, Depth> target,
    const render_options& options = {}, const E& executor = {}) {
  return render_with(method, world, target, options, executor);
}

/// Renders a scene that was made ready before: objects are neither moved nor cut nor copied again, and colours are
/// worked out anew only where light, eye or style have changed since the last picture.
/// shape   prepare_scene(world) makes such a scene
/// exact   the same bytes as from the scene it was made of
/// cost    the vertices once, then the pixels
template <Floating T, RowRaster Colour = image_view<rgba8>, RowRaster Depth = image_view<float>,
          Executor E = sequential, class Observer = no_observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts render(prepared_scene<T>& world, render_target<Colour, Depth> target,
                               const render_options& options = {}, const E& executor = {}, Observer&& observer = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail {

// Where a picture goes, and who takes part.
template <class Colour, class Depth>
struct picture_run {
  Colour& colour;
  Depth& depth;
  const executor_ref& executor;
  const function_ref<void(render_stage)>& observer;
};
template <class Colour, class Depth>
picture_run(Colour&, Depth&, const executor_ref&, const function_ref<void(render_stage)>&)
    -> picture_run<Colour, Depth>;

// A hidden-surface method of the caller's, and whether it finds the nearest face.
template <class T>
struct window_method {
  const method_ref<T>& method;
  bool finds_nearest;
};

inline namespace IRG_COMPILED_ABI {

// Whether no mesh's faces have a defect.
template <Floating T>
IRG_API bool has_valid_faces(const scene<T>& world) noexcept;
template <Floating T, class Colour, class Depth>
IRG_API render_counts render_scene(const scene<T>& world, const render_options& options,
                                   const picture_run<Colour, Depth>& run);
template <Floating T, class Colour, class Depth>
IRG_API render_counts render_by(const window_method<T>& by, const scene<T>& world, render_options options,
                                const picture_run<Colour, Depth>& run);
template <Floating T, class Colour, class Depth>
IRG_API render_counts render_prepared(prepared_scene<T>& world, const render_options& options,
                                      const picture_run<Colour, Depth>& run);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail

namespace irg::inline IRG_ABI {

template <Floating T, RowRaster Colour, RowRaster Depth, Executor E, class Observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts render(const scene<T>& world, render_target<Colour, Depth> target,
                               const render_options& options, const E& executor, Observer&& observer) {
  IRG_EXPECTS(detail::has_valid_faces(world));
  return detail::on_rows_of(target, [&](auto& colour, auto& depth) {
    return detail::render_scene(
        world, options,
        detail::picture_run{colour, depth, as_executor(executor), as_function<void(render_stage)>(observer)});
  });
}

template <Floating T, RowRaster Colour, RowRaster Depth, HiddenSurfaceMethod<T> Method, Executor E>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts render_with(const Method& method, const scene<T>& world, render_target<Colour, Depth> target,
                                    render_options options, const E& executor) {
  bool finds_nearest = false;
  if constexpr (requires { method.finds_nearest(); }) finds_nearest = method.finds_nearest();
  const auto by = as_function<detail::method_signature<T>>(method);
  const no_observer observer;
  return detail::on_rows_of(target, [&](auto& colour, auto& depth) {
    return detail::render_by(
        detail::window_method<T>{by, finds_nearest}, world, options,
        detail::picture_run{colour, depth, as_executor(executor), as_function<void(render_stage)>(observer)});
  });
}

template <Floating T, RowRaster Colour, RowRaster Depth, Executor E, class Observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts render(prepared_scene<T>& world, render_target<Colour, Depth> target,
                               const render_options& options, const E& executor, Observer&& observer) {
  return detail::on_rows_of(target, [&](auto& colour, auto& depth) {
    return detail::render_prepared(
        world, options,
        detail::picture_run{colour, depth, as_executor(executor), as_function<void(render_stage)>(observer)});
  });
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail {

// A picture is made in stages, each a function of what the one before left:
//   scene      the objects, as they were modelled
//   prepared   those that are not seen to be hidden, in the world, as triangles  (prepared_object, select_objects)
//   projected  their colours or what these come from, and vertices on the screen (project_objects)
//   bins       for each tile the triangles that it may show                      (bin_triangles)
//   ids        for each pixel of a tile the triangle that is seen there          (zbuffer_tiles, method_tiles)
//   colours    the pixels of the tile                                            (colour_tiles)

// The objects of a picture. Where they have a source, only their extents are there at first: an object is prepared when
// it is asked for, and those that are not seen never are.
template <class T>
struct picture_objects {
  std::span<prepared_object<T>> made;
  std::span<const object<T>> source{};
};

// Which objects are to be drawn, and how many triangles need not be.
struct object_selection {
  std::vector<std::uint32_t> drawn;  // numbers of objects
  std::int64_t beyond = 0, occluded = 0;
};

// Objects on the screen, numbered through.
template <class T>
struct projected_objects {
  object_selection chosen;
  std::vector<object_shading<T>> shadings;  // of the drawn ones
  std::vector<triangle_batch<T>> batches;
};

inline namespace IRG_ABI {

// A picture of one scene, before anything of its objects is known.
template <class T>
struct picture_frame {
  const camera<T>& view;
  lighting<T> light;
  const render_options& options;
  int width, height;
  screen_mapping<T> mapping;
  mat<T, 4, 4> to_clip;

  constexpr picture_frame(const auto& world, int w, int h, const render_options& how)
      : view(world.view), light{world.ambient, world.lights, world.distance, world.k}, options(how), width(w),
        height(h), mapping(map_to_screen<T>({w, h})),
        to_clip(view_projection(view, static_cast<T>(w) / static_cast<T>(h))) {}
};

// From the scene to prepared objects.

// The objects of a scene, of which nothing is prepared but the extents.
template <class T>
constexpr std::vector<prepared_object<T>> extents_of(std::span<const object<T>> objects) {
  std::vector<prepared_object<T>> made;
  made.reserve(objects.size());
  for (const object<T>& o : objects) made.emplace_back().extent = extent_of(o);
  return made;
}

// Object i, prepared. One without positions has nothing to prepare.
template <class T>
constexpr prepared_object<T>& prepared(const picture_objects<T>& objects, std::size_t i) {
  prepared_object<T>& o = objects.made[i];
  if (!objects.source.empty() && o.shape.positions.empty()) prepare_rest(o, objects.source[i]);
  return o;
}

// Which of the candidates have to be drawn: neither beyond the frustum nor hidden whole by others. Decided by their
// boxes, before anything is made of them.
template <class T>
IRG_NOINLINE constexpr object_selection select_objects(const picture_frame<T>& f, const picture_objects<T>& objects,
                                                       std::span<const std::uint32_t> candidates) {
  const render_options& options = f.options;
  object_selection result;
  std::vector<object_extent<T>> extents;
  extents.reserve(candidates.size());
  result.drawn.reserve(candidates.size());
  for (const std::uint32_t k : candidates) extents.push_back(objects.made[k].extent);
  occlusion_culling<T> boxes(f.to_clip, {f.width, f.height});
  if (options.hidden != hidden_surface_method::none && options.skip.occluded == skipping::on)
    for (const std::uint32_t i : boxes.choose_occluders(extents)) {
      const drawable<T>& body = prepared(objects, candidates[i]).body;
      boxes.add_occluder(body.positions, body.triangles, options.culling);
    }
  for (std::size_t i = 0; i < extents.size(); ++i) {
    const auto triangles = static_cast<std::int64_t>(extents[i].triangles);
    if (options.skip.frustum == skipping::on && boxes.is_beyond(extents[i].bounds))
      result.beyond += triangles;
    else if (boxes.hides(extents[i].bounds))
      result.occluded += triangles;
    else
      result.drawn.push_back(candidates[i]);
  }
  return result;
}

constexpr std::vector<std::uint32_t> all_numbers(std::size_t count) {
  std::vector<std::uint32_t> numbers(count, 0);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<std::uint32_t>(i);
  return numbers;
}

// From prepared objects to the screen.

// Those candidates that are to be drawn: prepared, shaded as the style needs it before there are pixels, projected.
template <class T>
constexpr projected_objects<T> project_objects(const picture_frame<T>& f, const picture_objects<T>& objects,
                                               std::span<const std::uint32_t> candidates, const executor_ref& executor,
                                               const function_ref<void(render_stage)>& observer) {
  const point<T, 3> eye = viewpoint(f.view);
  projected_objects<T> to{select_objects(f, objects, candidates), {}, {}};
  to.shadings.reserve(to.chosen.drawn.size());
  to.batches.reserve(to.chosen.drawn.size());
  std::uint32_t number = 0;
  for (const std::uint32_t k : to.chosen.drawn) {
    prepared_object<T>& o = prepared(objects, k);
    observer(render_stage::prepare);
    to.shadings.emplace_back(o, f.light, eye).prepare(f.options.style, f.options.culling, executor);
    observer(render_stage::shade);
    project_vertices<T>(o.body.positions, f.to_clip, f.mapping, kept_of(o).vertices, executor);
    to.batches.push_back(
        {&kept_of(o).vertices, o.body.triangles, number, static_cast<std::uint32_t>(to.batches.size())});
    number += static_cast<std::uint32_t>(o.body.triangles.size());
    observer(render_stage::project);
  }
  return to;
}

// From the screen to the picture, in the style that the options name: light encoded at once, or kept until the
// brightest of it is known.

// A picture, its depths, and what it shows where there is nothing.
template <class Colour, class Depth>
struct picture_target {
  Colour& colour;
  Depth& depth;
  pixel_of<Colour> background;
};
template <class Colour, class Depth>
picture_target(Colour&, Depth&, pixel_of<Colour>) -> picture_target<Colour, Depth>;

// What drawing needs to know of the objects, whatever it draws into.
template <class T>
struct styled_objects {
  std::span<const object_shading<T>> objects;
  std::span<const triangle_batch<T>> batches;
  const screen_mapping<T>& mapping;
  const render_options& options;
  drawing_lists& lists;
};

// Clears the picture and draws the objects, Output deciding what becomes of light.
template <class Output, class Method, class T, class Target>
constexpr render_counts draw_styled(const Method& method, const styled_objects<T>& s, const Target& to,
                                    const executor_ref& executor) {
  const auto draw = [&]<class Shading>(const Shading& shading) {
    return draw_tiles<T>(method, to.depth,
                         {s.batches, s.mapping, s.lists, s.options.culling, s.options.skip, clearing::before_drawing},
                         colour_tiles<T, std::remove_reference_t<decltype(to.colour)>, Shading>(
                             to.colour, shading, clearing::before_drawing, to.background),
                         executor);
  };
  if (s.options.style == picture_style::flat) return draw(flat_pixels<Output, T>{s.objects});
  if (s.options.style == picture_style::gouraud) return draw(gouraud_pixels<Output, T>{s.objects});
  return draw(phong_pixels<Output, T>{s.objects});
}

// As draw_styled; if some pixel is brighter than 1, all light of the picture is divided by the brightest channel's.
template <class Method, class T, class Target>
constexpr render_counts draw_rescaled(const Method& method, const styled_objects<T>& s, const Target& to,
                                      const executor_ref& executor) {
  constexpr int rows = 64;
  const int width = width_of(to.colour), height = height_of(to.colour);
  image<rgb<float>> light(width, height);
  const render_counts stats = draw_styled<light_itself>(method, s, picture_target{light, to.depth, {}}, executor);
  const auto in_portions = [&](const auto& f) {
    executor(static_cast<std::size_t>((height + rows - 1) / rows), [&](std::size_t i) {
      const int first = static_cast<int>(i) * rows;
      for (int y = first; y < minimum(first + rows, height); ++y) f(i, y);
    });
  };
  std::vector<float> largest_of(static_cast<std::size_t>((height + rows - 1) / rows), 1.0f);
  in_portions([&](std::size_t i, int y) {
    for (int x = 0; x < width; ++x) largest_of[i] = largest_channel(largest_of[i], light(x, y));
  });
  float largest = 1.0f;
  for (const float l : largest_of) largest = maximum(l, largest);
  const auto row_of = []<class R>(R& raster, int y) { return raster_traits<R>::row(raster, y); };
  in_portions([&](std::size_t, int y) {
    const float* const depths = row_of(to.depth, y);
    rgba8* const pixels = row_of(to.colour, y);
    for (int x = 0; x < width; ++x) {
      const bool shown = depths[x] != method.farthest();
      const auto scaled = per_channel([&](float channel) { return channel / largest; }, light(x, y));
      pixels[x] = shown ? encode(scaled) : to.background;
    }
  });
  return stats;
}

// The one place where a method is chosen: the one that the options name, tile by tile, so that whatever calls it is
// compiled once for all.
struct named_method {
  hidden_surface_method name;

  constexpr float farthest() const noexcept {
    return name == hidden_surface_method::none ? drawing_order::farthest : nearer_is_greater::farthest;
  }
  template <class T, class Depth>
  constexpr draw_counts operator()(Depth& depth, const tile_job<T>& job, std::size_t i,
                                   const tile_finish<T>& finish) const {
    return name == hidden_surface_method::none ? zbuffer_method<drawing_order>{}(depth, job, i, finish)
                                               : zbuffer_method<nearer_is_greater>{}(depth, job, i, finish);
  }
};

// The faces of all objects.
template <class Method, class T, class Run>
constexpr render_counts draw_objects(const Method& method, const picture_frame<T>& f, const projected_objects<T>& seen,
                                     drawing_lists& lists, const Run& run) {
  const styled_objects<T> styled{seen.shadings, seen.batches, f.mapping, f.options, lists};
  const picture_target to{run.colour, run.depth, f.options.colours.background};
  render_counts stats = f.options.intensities == intensity_range::rescale
                            ? draw_rescaled(method, styled, to, run.executor)
                            : draw_styled<encoded_light>(method, styled, to, run.executor);
  stats.triangles += seen.chosen.beyond + seen.chosen.occluded;
  stats.skipped.frustum += seen.chosen.beyond;
  stats.skipped.occluded += seen.chosen.occluded;
  run.observer(render_stage::draw);
  return stats;
}

template <class R>
constexpr std::int64_t count_other_than(R& raster, const pixel_of<R>& background) {
  const int width = width_of(raster), height = height_of(raster);
  std::int64_t count = 0;
  for (int y = 0; y < height; ++y) {
    const pixel_of<R>* const row = raster_traits<R>::row(raster, y);
    for (int x = 0; x < width; ++x) count += row[x] == background ? 0 : 1;
  }
  return count;
}

// The edges of all objects.
template <class T, class Run>
constexpr render_counts draw_wire(const picture_frame<T>& f, const picture_objects<T>& objects,
                                  std::span<const std::uint32_t> candidates, const Run& run) {
  clear(run.colour, f.options.colours.background);
  clear(run.depth, named_method{f.options.hidden}.farthest());
  render_counts stats;
  for (const std::uint32_t k : candidates) {
    mesh<T> moved;
    if (!objects.source.empty()) moved = transformed(objects.source[k].shape, objects.source[k].placement);
    const mesh<T>& shape = objects.source.empty() ? objects.made[k].shape : moved;
    const auto vertices = project_vertices<T>(shape.positions, f.to_clip, f.mapping);
    run.observer(render_stage::project);
    stats += draw_wireframe<T>(run.colour, {vertices, shape, f.mapping, f.options.skip.frustum}, f.options.colours.line,
                               f.options.culling, run.executor);
    run.observer(render_stage::draw);
  }
  stats.drawn = count_other_than(run.colour, f.options.colours.background);
  return stats;
}

// All of it, for the candidates among the objects.
template <class T, class Run>
constexpr render_counts draw_picture(const picture_frame<T>& f, const picture_objects<T>& objects,
                                     std::span<const std::uint32_t> candidates, drawing_lists& lists, const Run& run) {
  if (f.options.style == picture_style::wire) return draw_wire(f, objects, candidates, run);
  const projected_objects<T> seen = project_objects(f, objects, candidates, run.executor, run.observer);
  return draw_objects(named_method{f.options.hidden}, f, seen, lists, run);
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API bool has_valid_faces(const scene<T>& world) noexcept {
  for (const object<T>& o : world.objects)
    if (validate_faces(o.shape).defect != mesh_defect::none) return false;
  return true;
}

template <Floating T, class Colour, class Depth>
IRG_API render_counts render_scene(const scene<T>& world, const render_options& options,
                                   const picture_run<Colour, Depth>& run) {
  const int width = width_of(run.colour), height = height_of(run.colour);
  if (width == 0 || height == 0) return {};
  std::vector<prepared_object<T>> made = extents_of<T>(world.objects);
  drawing_lists lists;
  return draw_picture<T>({world, width, height, options}, {made, world.objects}, all_numbers(made.size()), lists, run);
}

template <Floating T, class Colour, class Depth>
IRG_API render_counts render_by(const window_method<T>& by, const scene<T>& world, render_options options,
                                const picture_run<Colour, Depth>& run) {
  const int width = width_of(run.colour), height = height_of(run.colour);
  if (width == 0 || height == 0) return {};
  options.skip.occluded = skipping::off;
  if (options.style == picture_style::wire) options.style = picture_style::flat;
  std::vector<prepared_object<T>> made = extents_of<T>(world.objects);
  const picture_frame<T> frame(world, width, height, options);
  const projected_objects<T> seen =
      project_objects<T>(frame, {made, world.objects}, all_numbers(made.size()), run.executor, run.observer);
  convex_bodies bodies;
  const bool fronts = by.finds_nearest && options.culling == face_culling::back && options.skip.convex == skipping::on;
  if (fronts)
    for (std::size_t i = 0; i < seen.batches.size(); ++i)
      if (is_convex_body(world.objects[seen.chosen.drawn[i]].shape)) bodies.note(seen.batches[i]);
  image<std::uint32_t> ids(width, height, no_index);
  drawing_lists lists;
  return draw_objects(method_tiles<nearer_is_greater, T>{by.method, ids, fronts ? &bodies : nullptr}, frame, seen,
                      lists, run);
}

template <Floating T, class Colour, class Depth>
IRG_API render_counts render_prepared(prepared_scene<T>& world, const render_options& options,
                                      const picture_run<Colour, Depth>& run) {
  const int width = width_of(run.colour), height = height_of(run.colour);
  if (width == 0 || height == 0) return {};
  return draw_picture<T>({world, width, height, options}, {world.objects}, all_numbers(world.objects.size()),
                         lists_of(world.workspace), run);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
