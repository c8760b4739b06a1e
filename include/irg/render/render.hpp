// SPDX-License-Identifier: MIT
// render: a scene becomes a picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/render/drawable.hpp>
#include <irg/render/wireframe.hpp>
#include <irg/scene/scene.hpp>
#include <irg/shade/shading.hpp>
#include <irg/view/affine.hpp>

namespace irg {

/// The stages of rendering, told to an observer as each one ends.
enum class render_stage { prepare, shade, project, draw };

/// An observer of stages that does nothing.
struct no_observer {
  IRG_INLINE constexpr void operator()(render_stage) const noexcept {}
};

namespace detail {

// Light to an 8-bit sRGB pixel.
struct encode_srgb {
  IRG_INLINE constexpr rgba8 operator()(const rgb<float>& light) const noexcept { return encode(light); }
};

// Phong shading of one triangle: positions and normals of its source, weighed at the piece's corners.
template <Floating T>
struct phong_pixels {
  const phong_shader<T>& shader;
  point<T, 3> position[3];
  vec<T, 3> normal[3];
  triangle_shares shares;

  IRG_INLINE constexpr rgba8 operator()(const fragment<float>& at) const {
    // The weights of the source's second and third vertex at this pixel of the piece.
    const T s = T(at.interpolate(shares.corner[0].weight1, shares.corner[1].weight1, shares.corner[2].weight1));
    const T t = T(at.interpolate(shares.corner[0].weight2, shares.corner[1].weight2, shares.corner[2].weight2));
    const point<T, 3> p = position[0] + ((position[1] - position[0]) * s + (position[2] - position[0]) * t);
    const vec<T, 3> n = normal[0] + ((normal[1] - normal[0]) * s + (normal[2] - normal[0]) * t);
    const rgb<T> light = shader(p, n);
    return encode({static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b)});
  }
};

inline namespace IRG_ABI {

template <class T>
IRG_INLINE constexpr rgb<float> to_float_colour(const rgb<T>& c) noexcept {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

// The pixel shaders of one object's triangles, in each style.
template <class T>
struct object_shading {
  const drawable<T>& body;
  const mesh<T>& shape;
  flat_shader<T> flat;
  gouraud_shader<T> gouraud;
  phong_shader<T> phong;
  std::vector<rgb<float>> colours;  // of the faces when flat, of the vertices in Gouraud's style

  // What a triangle's back shows has its normal turned towards the eye.
  IRG_INLINE constexpr rgb<float> vertex_colour(std::uint32_t v, facing side) const noexcept {
    if (side == facing::front) return colours[v];
    return to_float_colour(gouraud(body.positions[v], -body.normals[v]));
  }

  constexpr rgb<float> face_colour(std::size_t f, facing side) const noexcept {
    const vec<T, 3> normal = face_normal(shape, f).value_or(vec<T, 3>{});
    vec<T, 3> sum{};  // about the first vertex: the mean of the differences
    const point<T, 3>& first = shape.positions[shape.corner(f, 0).position];
    for (std::size_t k = 1; k < shape.face_size(f); ++k) sum += shape.positions[shape.corner(f, k).position] - first;
    const point<T, 3> centre = first + sum / static_cast<T>(shape.face_size(f));
    return to_float_colour(flat(centre, side == facing::front ? normal : -normal));
  }

  constexpr auto flat_pixels() const {
    return [this](std::uint32_t triangle, const triangle_shares&, facing side) {
      const std::uint32_t f = body.face_of[triangle];
      return solid_shader<rgba8>{encode(side == facing::front ? colours[f] : face_colour(f, side))};
    };
  }
  constexpr auto gouraud_pixels() const {
    return [this](std::uint32_t triangle, const triangle_shares& shares, facing side) {
      const auto [a, b, c] = body.triangles[triangle].v;
      const rgb<float> at0 = vertex_colour(a, side), at1 = vertex_colour(b, side), at2 = vertex_colour(c, side);
      const auto corner = [&](int k) {
        return rgb<float>{shares(k, at0.r, at1.r, at2.r), shares(k, at0.g, at1.g, at2.g),
                          shares(k, at0.b, at1.b, at2.b)};
      };
      return vertex_colour_shader<rgba8, encode_srgb>{corner(0), corner(1), corner(2), {}};
    };
  }
  constexpr auto phong_pixels_of() const {
    return [this](std::uint32_t triangle, const triangle_shares& shares, facing side) {
      const auto [a, b, c] = body.triangles[triangle].v;
      const auto normal = [&](std::uint32_t v) { return side == facing::front ? body.normals[v] : -body.normals[v]; };
      return phong_pixels<T>{
          phong, {body.positions[a], body.positions[b], body.positions[c]}, {normal(a), normal(b), normal(c)}, shares};
    };
  }
};

}  // namespace IRG_ABI
}  // namespace detail

/// The colours of a picture that do not come from its scene.
struct picture_colours {
  rgba8 background{250, 249, 246, 255};
  rgba8 line{32, 44, 66, 255};
};

inline namespace IRG_ABI {

/// Renders a scene into a picture and its depth buffer, both overwritten, and returns what it did.
/// shape   colour and depth have one size, at most 65536 x 65536
/// needs   valid meshes (mesh/validate.hpp); a camera in its domain
/// gives   the background alone for a scene without objects; of equal depths the first object and face wins
/// exact   the same bytes for every executor, compiler, instruction set and for skipping on and off
/// cost    the vertices and triangles once, then the pixels
template <DepthOrder Order, Floating T, RowRaster Colour, RowRaster Depth, Executor E, class Observer>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_stats render_ordered(const scene<T>& world, Colour& colour, Depth& depth,
                                      const render_options& options, const picture_colours& colours, const E& executor,
                                      Observer&& observer) {
  const int width = width_of(colour), height = height_of(colour);
  render_stats stats;
  if (width == 0 || height == 0) return stats;
  const bool wire = options.style == picture_style::wire;
  bool cleared = false;  // the first object's bands clear themselves as they are drawn, while they are in the cache
  if (wire || world.objects.empty()) clear(colour, colours.background), clear(depth, Order::farthest), cleared = true;
  const screen_mapping<T> mapping = map_to_screen<T>(width, height);
  const mat<T, 4, 4> to_clip = view_projection(world.view, static_cast<T>(width) / static_cast<T>(height));
  const lighting<T> light{world.ambient, world.lights};
  for (const object<T>& o : world.objects) {
    const mesh<T> shape = transform_mesh(o.shape, o.placement);
    if (wire) {
      const auto vertices = project_vertices<T>(shape.positions, to_clip, mapping);
      observer(render_stage::project);
      stats += draw_wireframe(colour, vertices, shape, mapping, colours.line, options.culling, executor);
      observer(render_stage::draw);
      continue;
    }
    const drawable<T> body = make_drawable(shape);
    observer(render_stage::prepare);
    detail::object_shading<T> shading{body,
                                      shape,
                                      {o.surface, light, world.view.eye},
                                      {o.surface, light, world.view.eye},
                                      {o.surface, light, world.view.eye},
                                      {}};
    if (options.style == picture_style::flat)
      for (std::size_t f = 0; f < shape.face_count(); ++f)
        shading.colours.push_back(shading.face_colour(f, facing::front));
    if (options.style == picture_style::gouraud)
      for (std::size_t v = 0; v < body.positions.size(); ++v)
        shading.colours.push_back(detail::to_float_colour(shading.gouraud(body.positions[v], body.normals[v])));
    observer(render_stage::shade);
    const auto vertices = project_vertices<T>(body.positions, to_clip, mapping);
    observer(render_stage::project);
    draw_settings<rgba8> settings{options.culling, options.skip, {}};
    if (!cleared) settings.background = colours.background;
    cleared = true;
    const auto draw = [&](const auto& make_shader) {
      stats +=
          draw_triangles<Order, T>(colour, depth, vertices, body.triangles, mapping, make_shader, settings, executor);
    };
    if (options.style == picture_style::flat) draw(shading.flat_pixels());
    if (options.style == picture_style::gouraud) draw(shading.gouraud_pixels());
    if (options.style == picture_style::phong) draw(shading.phong_pixels_of());
    observer(render_stage::draw);
  }
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (wire ? !(get_pixel(colour, x, y) == colours.background) : !(get_pixel(depth, x, y) == Order::farthest))
        ++stats.drawn;
  return stats;
}

/// As above, the depth order taken from options.hidden: reversed depth, or drawing order where nothing is hidden.
template <Floating T, RowRaster Colour, RowRaster Depth, Executor E = sequential, class Observer = no_observer>
constexpr render_stats render(const scene<T>& world, Colour& colour, Depth& depth, const render_options& options = {},
                              const picture_colours& colours = {}, const E& executor = {}, Observer&& observer = {}) {
  if (options.hidden == hidden_surface_method::none)
    return render_ordered<drawing_order>(world, colour, depth, options, colours, executor, observer);
  return render_ordered<nearer_is_greater>(world, colour, depth, options, colours, executor, observer);
}

}  // namespace IRG_ABI
}  // namespace irg
