// SPDX-License-Identifier: MIT
// render_traced: a scene becomes a picture with shadows, mirrors and glass. What each pixel shows first is what
// render() shows there, to the bit; from there on rays tell what light arrives.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

#include <irg/core/executor.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/render.hpp>
#include <irg/trace/trace_ray.hpp>
#if IRG_BODIES
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/render/prepared_scene.hpp>
#endif

namespace irg {

/// How a traced picture is taken: of samples by samples rays a pixel, 1 to 16, on a grid; fewer where a side of the
/// picture would be of more than 65536 of them.
/// shape   optic i belongs to object i; objects beyond their number are opaque and mirror nothing
template <Floating T>
struct traced_options {
  trace_options<T> limits{};
  int samples = 1;
  face_culling culling = face_culling::back;
  picture_colours colours{};  // of which the background is seen
  std::span<const irg::optics<T>> optics{};
};

/// An executor that tells, after each task, that it is done: for a bar that shows how far long work has come. It calls
/// from whatever thread the task ran on.
template <Executor E, class Report>
struct reporting {
  const E& executor;
  const Report& report;

  template <class Task>
  IRG_APART constexpr void operator()(std::size_t count, const Task& task) const {
    executor(count, [&](std::size_t i) {
      task(i);
      report(i, count);
    });
  }
};
template <class E, class Report>
reporting(const E&, const Report&) -> reporting<E, Report>;

inline namespace IRG_ABI {

/// Renders a scene by rays into a picture, which is overwritten, and returns what it did.
/// needs   as render
/// gives   the background alone for a scene without objects, and where rays leave the scene. Normals are those of the
///         style phong; where they come to 0, the triangle's own, where render() has ambient light alone. But for such
///         places it gives the bytes of render() in that style with shadows off, no optics and one sample
/// exact   the triangle that each sample shows first, as render(); the same bytes for every executor and compiler
/// cost    as trace_ray for each sample; allocates a picture of all samples, and a tree
/// source  Whitted 1980
template <Floating T, RowRaster Colour, Executor E = sequential>
  requires std::same_as<pixel_of<Colour>, rgba8>
constexpr render_counts render_traced(const scene<T>& world, Colour& colour, const traced_options<T>& options = {},
                                      const E& executor = {});
template <Floating T, RowRaster Colour, Executor E = sequential>
  requires std::same_as<pixel_of<Colour>, rgba8>
[[deprecated("irg: render_traced(world, picture, {.optics = ..}, executor)")]] constexpr render_counts render_traced(
    const scene<T>& world, std::type_identity_t<std::span<const optics<T>>> optic, Colour& colour,
    traced_options<T> options = {}, const E& executor = {}) {
  options.optics = optic;
  return render_traced(world, colour, options, executor);
}

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, class Colour>
IRG_API render_counts trace_picture(const scene<T>& world, Colour& colour, const traced_options<T>& options,
                                    const executor_ref& executor);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <Floating T, RowRaster Colour, Executor E>
  requires std::same_as<pixel_of<Colour>, rgba8>
constexpr render_counts render_traced(const scene<T>& world, Colour& colour, const traced_options<T>& options,
                                      const E& executor) {
  return detail::on_rows(
      colour, [&](auto& rows) { return detail::trace_picture(world, rows, options, as_executor(executor)); });
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Makes shaders that trace what comes from a triangle's point to the eye.
template <class T>
struct traced_shading {
  const ray_world<T>& world;
  const trace_options<T>& limits;
  point<T, 3> eye;

  struct pixel_shader {
    const traced_shading& shading;
    std::uint32_t triangle;
    facing side;

    constexpr rgb<float> operator()(const pixel_weights<float>& at) const noexcept {
      const surface_point<T> s =
          shading.world.point_of(triangle, converted<T>(at.weight1), converted<T>(at.weight2), side);
      const rgb<T> light = trace_from(shading.world, s, shading.eye, shading.limits);
      return {converted<float>(light.r), converted<float>(light.g), converted<float>(light.b)};
    }
  };

  constexpr pixel_shader operator()(const triangle_batch<T>& batch, std::uint32_t triangle,
                                    facing side) const noexcept {
    return {*this, world.first_triangle(batch.object) + triangle, side};
  }
};

// Each pixel the mean of samples by samples.
template <class Colour>
constexpr void encode_means(Colour& colour, const image<rgb<float>>& light, int samples) {
  const float share = 1.0f / static_cast<float>(samples * samples);
  for (int y = 0; y < height_of(colour); ++y)
    for (int x = 0; x < width_of(colour); ++x) {
      rgb<float> sum = light(x * samples, y * samples);
      for (int k = 1; k < samples * samples; ++k)
        sum = sum + light(x * samples + k % samples, y * samples + k / samples);
      if (samples > 1) sum = {product(sum.r, share), product(sum.g, share), product(sum.b, share)};
      set_pixel(colour, x, y, encode(sum));
    }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, class Colour>
IRG_API render_counts trace_picture(const scene<T>& world, Colour& colour, const traced_options<T>& options,
                                    const executor_ref& executor) {
  if (width_of(colour) == 0 || height_of(colour) == 0) return {};
  const int longer = maximum(width_of(colour), height_of(colour));
  const int samples = clamped(minimum(options.samples, 65536 / longer), 1, 16);
  const int width = width_of(colour) * samples, height = height_of(colour) * samples;
  prepared_scene<T> ready = prepare_scene(world);
  std::vector<traced_body<T>> bodies;
  std::vector<triangle_batch<T>> batches;
  const screen_mapping<T> mapping = map_to_screen<T>({width, height});
  const mat<T, 4, 4> to_clip = view_projection(world.view, static_cast<T>(width) / static_cast<T>(height));
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < ready.objects.size(); ++i) {
    prepared_object<T>& o = ready.objects[i];
    bodies.push_back({o.body.positions, o.body.normals, o.body.triangles, o.surface,
                      i < options.optics.size() ? options.optics[i] : optics<T>{}});
    project_vertices<T>(o.body.positions, to_clip, mapping, kept_of(o).vertices, executor);
    batches.push_back({&kept_of(o).vertices, o.body.triangles, number, static_cast<std::uint32_t>(i)});
    number += static_cast<std::uint32_t>(o.body.triangles.size());
  }
  const rgb<float> back = decode(options.colours.background);
  const ray_world<T> rays(std::move(bodies), {world.ambient, world.lights, world.distance, world.k},
                          {converted<T>(back.r), converted<T>(back.g), converted<T>(back.b)}, executor);
  image<rgb<float>> light(width, height);
  image<float> depth(width, height);
  const traced_shading<T> shading{rays, options.limits, viewpoint(world.view)};
  const render_counts stats =
      shade_batches<nearer_is_greater>(render_target{light, depth}, projected_triangles<T>{batches, mapping}, shading,
                                       {.culling = options.culling,
                                        .clear = clearing::before_drawing,
                                        .background = back,
                                        .workspace = &ready.workspace},
                                       executor);
  encode_means(colour, light, samples);
  return stats;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
