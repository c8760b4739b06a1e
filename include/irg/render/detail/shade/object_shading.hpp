// SPDX-License-Identifier: MIT
// The pixel shaders of the objects of a picture, in each of its styles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/colour/srgb.hpp>
#include <irg/colour/srgb_lanes.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/shade/shading.hpp>

namespace irg {
namespace detail {

// What light becomes in the picture: its pixel; or it stays as it is until the range of all of it is known.
struct encoded_light {
  IRG_INLINE constexpr rgba8 operator()(const rgb<float>& light) const noexcept { return encode(light); }
};
struct light_itself {
  IRG_INLINE constexpr rgb<float> operator()(const rgb<float>& light) const noexcept { return light; }
};

// Phong shading of one triangle.
template <Floating T, class Output>
struct phong_pixel_shader {
  const phong_shader<T>& shader;
  point<T, 3> position[3];
  vec<T, 3> normal[3];

  IRG_INLINE constexpr auto operator()(const pixel_weights<float>& at) const {
    const T s = converted<T>(at.weight1), t = converted<T>(at.weight2);
    const point<T, 3> p = position[0] + ((position[1] - position[0]) * s + (position[2] - position[0]) * t);
    const vec<T, 3> n = normal[0] + ((normal[1] - normal[0]) * s + (normal[2] - normal[0]) * t);
    const rgb<T> light = shader(p, n);
    return Output{}({converted<float>(light.r), converted<float>(light.g), converted<float>(light.b)});
  }
};

inline namespace IRG_ABI {

template <class T>
IRG_INLINE constexpr rgb<float> to_float_colour(const rgb<T>& c) noexcept {
  return {converted<float>(c.r), converted<float>(c.g), converted<float>(c.b)};
}

// One object of a picture: its triangles, its colours or what they come from.
template <class T>
struct object_shading {
  prepared_object<T>& made;
  flat_shader<T> flat;
  gouraud_shader<T> gouraud;
  phong_shader<T> phong;

  constexpr object_shading(prepared_object<T>& object, const lighting<T>& light, const point<T, 3>& eye)
      : made(object), flat{object.surface, light, eye}, gouraud{object.surface, light, eye},
        phong{object.surface, light, eye} {}

  // What a triangle's back shows has its normal turned towards the eye.
  constexpr rgb<float> face_colour(std::size_t f, facing side) const noexcept {
    const mesh<T>& shape = made.shape;
    const vec<T, 3> normal = face_normal(shape, f).value_or(vec<T, 3>{});
    vec<T, 3> sum{};  // about the first vertex: the mean of the differences
    const point<T, 3>& first = shape.positions[shape.corner(f, 0).position];
    for (std::size_t k = 1; k < shape.face_size(f); ++k) sum += shape.positions[shape.corner(f, k).position] - first;
    const point<T, 3> centre = first + sum / static_cast<T>(shape.face_size(f));
    return to_float_colour(flat(centre, side == facing::front ? normal : -normal));
  }

  // Works out the colours that the style keeps, unless they are there from the last picture.
  template <class E>
  constexpr void prepare(picture_style style, face_culling culling, const E& executor) {
    const lighting<T>& light = flat.light;
    object_frame<T>& frame = made.frame;
    shading_key<T> key{
        style,         culling,        made.surface, flat.eye, {light.lights.begin(), light.lights.end()},
        light.ambient, light.distance, light.k};
    if (frame.key == key) return;
    frame.key = std::move(key);
    if (style == picture_style::flat) {
      frame.face_colours.resize(made.shape.face_count(), rgb<float>{});
      for_portions(executor, made.shape.face_count(),
                   [&](std::size_t f) { frame.face_colours[f] = face_colour(f, facing::front); });
    }
    if (style != picture_style::gouraud) return;
    for (const facing side : {facing::front, facing::back}) {
      if (side == facing::back && culling == face_culling::back) continue;
      auto& colours = frame.vertex_colours[static_cast<int>(side)];
      colours.resize(made.body.positions.size(), std::array<float, 3>{});
      for_portions(executor, colours.size(), [&](std::size_t v) {
        const vec<T, 3>& n = made.body.normals[v];
        const auto [r, g, b] = to_float_colour(gouraud(made.body.positions[v], side == facing::front ? n : -n));
        colours[v] = {r, g, b};
      });
    }
  }

private:
  // Calls f(i) for i < count, a thousand of them in a task.
  template <class E, class F>
  static constexpr void for_portions(const E& executor, std::size_t count, const F& f) {
    constexpr std::size_t portion = 1024;
    executor((count + portion - 1) / portion, [&](std::size_t k) {
      for (std::size_t i = k * portion; i < lesser((k + 1) * portion, count); ++i) f(i);
    });
  }
};

// Makes the pixel shaders of flat faces.
template <class Output, class T>
struct flat_pixels {
  std::span<const object_shading<T>> objects;

  IRG_INLINE constexpr auto operator()(const triangle_batch<T>& batch, std::uint32_t triangle,
                                       facing side) const noexcept {
    const object_shading<T>& o = objects[batch.object];
    const std::uint32_t f = o.made.body.face_of[triangle];
    return solid_shader<decltype(Output{}({}))>{
        Output{}(side == facing::front ? o.made.frame.face_colours[f] : o.face_colour(f, side))};
  }
};

// Colours between the vertices.
template <class Output, class T>
struct gouraud_pixels {
  static constexpr int attribute_count = 3;
  std::span<const object_shading<T>> objects;

  IRG_INLINE constexpr const float* attributes(const triangle_batch<T>& batch, std::uint32_t vertex,
                                               facing side) const noexcept {
    return objects[batch.object].made.frame.vertex_colours[static_cast<int>(side)][vertex].data();
  }
  IRG_INLINE constexpr auto pixel(const std::array<float, 3>& light) const noexcept {
    return Output{}({light[0], light[1], light[2]});
  }
#ifdef IRG_LANES_VECTOR
  template <int N>
    requires std::same_as<Output, encoded_light>
  IRG_INLINE pack<std::uint32_t, N> pixels(const std::array<pack<float, N>, 3>& light) const noexcept {
    return encode_lanes(light[0], light[1], light[2]);
  }
#endif
};

// Makes the pixel shaders of Phong's style.
template <class Output, class T>
struct phong_pixels {
  std::span<const object_shading<T>> objects;

  IRG_INLINE constexpr phong_pixel_shader<T, Output> operator()(const triangle_batch<T>& batch, std::uint32_t triangle,
                                                                facing side) const noexcept {
    const object_shading<T>& o = objects[batch.object];
    const drawable<T>& body = o.made.body;
    const auto [a, b, c] = body.triangles[triangle].v;
    const auto normal = [&](std::uint32_t v) { return side == facing::front ? body.normals[v] : -body.normals[v]; };
    return {o.phong, {body.positions[a], body.positions[b], body.positions[c]}, {normal(a), normal(b), normal(c)}};
  }
};

}  // namespace IRG_ABI
}  // namespace detail

}  // namespace irg
