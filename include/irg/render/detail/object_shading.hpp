// SPDX-License-Identifier: MIT
// The pixel shaders of one object, in each style of picture.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/render/drawable.hpp>
#include <irg/shade/shading.hpp>

namespace irg {
namespace detail {

// Light to an 8-bit sRGB pixel.
struct encode_srgb {
  IRG_INLINE constexpr rgba8 operator()(const rgb<float>& light) const noexcept { return encode(light); }
};

// Phong shading of one triangle: positions and normals of its source, weighed at the piece's corners.
template <Floating T>
struct phong_pixel_shader {
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

  // Works out the colours that the style keeps.
  constexpr void prepare(picture_style style) {
    if (style == picture_style::flat)
      for (std::size_t f = 0; f < shape.face_count(); ++f) colours.push_back(face_colour(f, facing::front));
    if (style == picture_style::gouraud)
      for (std::size_t v = 0; v < body.positions.size(); ++v)
        colours.push_back(to_float_colour(gouraud(body.positions[v], body.normals[v])));
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
  constexpr auto phong_pixels() const {
    return [this](std::uint32_t triangle, const triangle_shares& shares, facing side) {
      const auto [a, b, c] = body.triangles[triangle].v;
      const auto normal = [&](std::uint32_t v) { return side == facing::front ? body.normals[v] : -body.normals[v]; };
      return phong_pixel_shader<T>{
          phong, {body.positions[a], body.positions[b], body.positions[c]}, {normal(a), normal(b), normal(c)}, shares};
    };
  }
};

}  // namespace IRG_ABI
}  // namespace detail

}  // namespace irg
