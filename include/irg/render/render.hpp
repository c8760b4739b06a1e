// SPDX-License-Identifier: MIT
// render: a scene becomes a picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/validate.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/detail/shade/object_shading.hpp>
#include <irg/render/detail/visible/method_tiles.hpp>
#include <irg/render/options.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/render/wireframe.hpp>
#include <irg/scene/scene.hpp>
#include <irg/shade/intensity_range.hpp>
#include <irg/shade/per_channel.hpp>

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
template <Floating T, RowRaster Colour = image<rgba8>, RowRaster Depth = image<float>, Executor E = sequential,
          class Observer = no_observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_stats render(const scene<T>& world, render_target<Colour, Depth> target,
                              const render_options& options = {}, const E& executor = {}, Observer&& observer = {});

/// As above, with a hidden-surface method of the caller's: the picture is what the method says is seen, shaded as ever.
/// gives   what the method finds. Nothing is left out because something else hides it, `options.hidden` has no say, and
///         edges are not faces: `wire` is drawn as `flat`. A method that says that it `finds_nearest()` is not asked
///         about windows that show the front faces of one convex body alone: pixels.convex counts these faces
/// exact   where the method finds the nearest face by the picture's rule, the bytes of the z-buffer, depths included
template <Floating T, RowRaster Colour = image<rgba8>, RowRaster Depth = image<float>, HiddenSurfaceMethod<T> Method,
          Executor E = sequential>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_stats render(const Method& method, const scene<T>& world, render_target<Colour, Depth> target,
                              render_options options = {}, const E& executor = {});

/// As above, of a scene that was made ready before: objects are neither moved nor cut nor copied again, and colours are
/// worked out anew only where light, eye or style have changed since the last picture.
/// shape   prepare_scene(world) makes such a scene
/// exact   the same bytes as from the scene it was made of
/// cost    the vertices once, then the pixels
template <Floating T, RowRaster Colour = image<rgba8>, RowRaster Depth = image<float>, Executor E = sequential,
          class Observer = no_observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_stats render(prepared_scene<T>& world, render_target<Colour, Depth> target,
                              const render_options& options = {}, const E& executor = {}, Observer&& observer = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail {

// Which objects of a scene have to be drawn: neither beyond the frustum nor hidden whole by others. Decided by their
// boxes, before anything is made of them.

// The objects of a scene, prepared when they are asked for: those that are not seen never are.
template <class T>
struct IRG_APART objects_to_prepare {
  std::span<const object<T>> source;
  std::vector<object_extent<T>> extents;
  std::vector<prepared_object<T>> made;
  std::vector<std::uint8_t> is_made;

  constexpr explicit objects_to_prepare(std::span<const object<T>> objects)
      : source(objects), is_made(objects.size(), 0) {
    extents.reserve(source.size());
    made.reserve(source.size());
    for (const object<T>& o : source) {
      extents.push_back(extent_of(o));
      made.emplace_back();  // filling the vector would compile the copying of all that an object has
    }
  }
  constexpr std::size_t size() const noexcept { return source.size(); }
  constexpr const object_extent<T>& extent(std::size_t i) const noexcept { return extents[i]; }
  constexpr mesh<T> shape(std::size_t i) const { return transformed(source[i].shape, source[i].placement); }
  constexpr prepared_object<T>& operator[](std::size_t i) {
    if (is_made[i] == 0) made[i] = prepare_object(source[i]);
    is_made[i] = 1;
    return made[i];
  }
};

// The objects of a scene that are prepared already.
template <class T>
struct IRG_APART prepared_objects {
  std::span<prepared_object<T>> made;

  constexpr std::size_t size() const noexcept { return made.size(); }
  constexpr const object_extent<T>& extent(std::size_t i) const noexcept { return made[i].extent; }
  constexpr const mesh<T>& shape(std::size_t i) const noexcept { return made[i].shape; }
  constexpr prepared_object<T>& operator[](std::size_t i) const noexcept { return made[i]; }
};

// What is to be drawn, and how many triangles need not be.
struct object_selection {
  std::vector<std::uint32_t> drawn;  // numbers of objects
  std::int64_t beyond = 0, occluded = 0;
};

inline namespace IRG_ABI {

template <class T, class Objects>
IRG_NOINLINE constexpr object_selection select_objects(Objects& objects, const mat<T, 4, 4>& to_clip, int width,
                                                       int height, const render_options& options) {
  object_selection result;
  std::vector<object_extent<T>> extents;
  extents.reserve(objects.size());
  result.drawn.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) extents.push_back(objects.extent(i));
  occlusion_culling<T> boxes(to_clip, width, height);
  if (options.hidden != hidden_surface_method::none && options.skip.occluded == skipping::on)
    for (const std::uint32_t i : boxes.choose_occluders(extents)) {
      const drawable<T>& body = objects[i].body;
      boxes.add_occluder(body.positions, body.triangles, options.culling);
    }
  for (std::uint32_t i = 0; i < extents.size(); ++i) {
    const auto triangles = static_cast<std::int64_t>(extents[i].triangles);
    if (options.skip.frustum == skipping::on && boxes.is_beyond(extents[i].bounds))
      result.beyond += triangles;
    else if (boxes.hides(extents[i].bounds))
      result.occluded += triangles;
    else
      result.drawn.push_back(i);
  }
  return result;
}

}  // namespace IRG_ABI

// The objects of a picture, drawn in its style: light encoded at once, or kept until the brightest of it is known.

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

template <class R>
constexpr std::int64_t count_other_than(const R& raster, const pixel_of<R>& background) {
  std::int64_t count = 0;
  for (int y = 0; y < height_of(raster); ++y)
    for (int x = 0; x < width_of(raster); ++x) count += get_pixel(raster, x, y) == background ? 0 : 1;
  return count;
}

// Where a picture goes, and who takes part.
template <class Colour, class Depth, class E, class Observer>
struct picture_run {
  Colour& colour;
  Depth& depth;
  const E& executor;
  Observer& observer;
};
template <class Colour, class Depth, class E, class Observer>
picture_run(Colour&, Depth&, const E&, Observer&) -> picture_run<Colour, Depth, E, Observer>;

// A picture of one scene, before anything of its objects is known.
template <class T>
struct picture_frame {
  const camera<T>& view;
  lighting<T> light;
  const render_options& options;
  screen_mapping<T> mapping;
  mat<T, 4, 4> to_clip;

  constexpr picture_frame(const auto& world, int width, int height, const render_options& how)
      : view(world.view), light{world.ambient, world.lights, world.distance, world.k}, options(how),
        mapping(map_to_screen<T>(width, height)),
        to_clip(view_projection(view, static_cast<T>(width) / static_cast<T>(height))) {}
};

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

// The edges of all objects.
template <class T, class Objects, class Run>
constexpr render_stats draw_wire(const picture_frame<T>& f, Objects& objects, const Run& run) {
  clear(run.colour, f.options.colours.background);
  clear(run.depth, named_method{f.options.hidden}.farthest());
  render_stats stats;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const mesh<T>& shape = objects.shape(i);
    const auto vertices = project_vertices<T>(shape.positions, f.to_clip, f.mapping);
    run.observer(render_stage::project);
    stats += draw_wireframe<T>(run.colour, {vertices, shape, f.mapping, f.options.skip.frustum}, f.options.colours.line,
                               f.options.culling, run.executor);
    run.observer(render_stage::draw);
  }
  stats.drawn = count_other_than(run.colour, f.options.colours.background);
  return stats;
}

// The faces of all objects, in the style that the options name.
template <class Method, class T, class Objects, class Run>
constexpr render_stats draw_filled(const Method& method, const picture_frame<T>& f, Objects& objects,
                                   draw_workspace& workspace, const Run& run) {
  const point<T, 3> eye = viewpoint(f.view);
  const object_selection chosen =
      select_objects(objects, f.to_clip, width_of(run.colour), height_of(run.colour), f.options);
  std::vector<object_shading<T>> shadings;
  std::vector<triangle_batch<T>> batches;
  shadings.reserve(chosen.drawn.size());
  batches.reserve(chosen.drawn.size());
  std::uint32_t number = 0;
  for (const std::uint32_t k : chosen.drawn) {
    prepared_object<T>& o = objects[k];
    run.observer(render_stage::prepare);
    shadings.emplace_back(o, f.light, eye).prepare(f.options.style, f.options.culling, run.executor);
    run.observer(render_stage::shade);
    project_vertices<T>(o.frame.vertices, o.body.positions, f.to_clip, f.mapping, run.executor);
    batches.push_back({&o.frame.vertices, o.body.triangles, number, static_cast<std::uint32_t>(batches.size())});
    if constexpr (requires { method.note_object(k, number, o.body.triangles.size()); })
      method.note_object(k, number, o.body.triangles.size());
    number += static_cast<std::uint32_t>(o.body.triangles.size());
    run.observer(render_stage::project);
  }
  const styled_objects<T> styled{shadings, batches, f.mapping, f.options, workspace};
  const picture_target to{run.colour, run.depth, f.options.colours.background};
  render_stats stats = f.options.intensities == intensity_range::rescale
                           ? draw_rescaled(method, styled, to, run.executor)
                           : draw_styled<encoded_light>(method, styled, to, run.executor);
  stats.triangles += chosen.beyond + chosen.occluded;
  stats.skipped.frustum += chosen.beyond;
  stats.skipped.occluded += chosen.occluded;
  run.observer(render_stage::draw);
  return stats;
}

template <class T, class Objects, class Run>
constexpr render_stats draw_picture(const picture_frame<T>& f, Objects& objects, draw_workspace& workspace,
                                    const Run& run) {
  return f.options.style == picture_style::wire
             ? draw_wire(f, objects, run)
             : draw_filled(named_method{f.options.hidden}, f, objects, workspace, run);
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::inline IRG_ABI {

template <Floating T, RowRaster Colour, RowRaster Depth, Executor E, class Observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_stats render(const scene<T>& world, render_target<Colour, Depth> target, const render_options& options,
                              const E& executor, Observer&& observer) {
  const int width = width_of(target.colour), height = height_of(target.colour);
  for ([[maybe_unused]] const object<T>& o : world.objects)
    IRG_EXPECTS(validate_faces(o.shape).defect == mesh_defect::none);
  if (width == 0 || height == 0) return {};
  detail::objects_to_prepare<T> objects(world.objects);
  draw_workspace workspace;
  return detail::draw_picture<T>({world, width, height, options}, objects, workspace,
                                 detail::picture_run{target.colour, target.depth, executor, observer});
}

template <Floating T, RowRaster Colour, RowRaster Depth, HiddenSurfaceMethod<T> Method, Executor E>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_stats render(const Method& method, const scene<T>& world, render_target<Colour, Depth> target,
                              render_options options, const E& executor) {
  const int width = width_of(target.colour), height = height_of(target.colour);
  if (width == 0 || height == 0) return {};
  options.skip.occluded = skipping::off;
  if (options.style == picture_style::wire) options.style = picture_style::flat;
  image<std::uint32_t> ids(width, height, no_face);
  detail::convex_bodies bodies;
  bool fronts = false;
  if constexpr (requires { method.finds_nearest(); })
    fronts = method.finds_nearest() && options.culling == face_culling::back && options.skip.convex == skipping::on;
  if (fronts)
    for (const object<T>& o : world.objects) bodies.is_convex.push_back(is_convex_body(o.shape) ? 1 : 0);
  detail::objects_to_prepare<T> objects(world.objects);
  draw_workspace workspace;
  no_observer observer;
  return detail::draw_filled(detail::method_tiles<nearer_is_greater, Method>{method, ids, fronts ? &bodies : nullptr},
                             detail::picture_frame<T>(world, width, height, options), objects, workspace,
                             detail::picture_run{target.colour, target.depth, executor, observer});
}

template <Floating T, RowRaster Colour, RowRaster Depth, Executor E, class Observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_stats render(prepared_scene<T>& world, render_target<Colour, Depth> target,
                              const render_options& options, const E& executor, Observer&& observer) {
  const int width = width_of(target.colour), height = height_of(target.colour);
  if (width == 0 || height == 0) return {};
  detail::prepared_objects<T> objects{world.objects};
  return detail::draw_picture<T>({world, width, height, options}, objects, world.workspace,
                                 detail::picture_run{target.colour, target.depth, executor, observer});
}

}  // namespace irg::inline IRG_ABI
