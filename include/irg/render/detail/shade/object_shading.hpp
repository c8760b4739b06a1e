// SPDX-License-Identifier: MIT
// The pixel shaders of the objects of a picture, in each of its styles.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/colour/srgb_lanes.hpp>
#include <irg/core/conversion.hpp>
#include <irg/core/interleaved_lanes.hpp>
#include <irg/raster/pixel_weights.hpp>
#include <irg/raster/triangle_batch.hpp>
#include <irg/render/detail/shade/collected_points.hpp>
#include <irg/render/drawable.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/shade/phong_lanes.hpp>
#include <irg/shade/shading.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// The light at the vertices of a body, a register of them at a time.

// Vertices of a body, and whether light falls on their fronts or their backs.
template <class T>
struct lit_vertices {
  const drawable<T>& body;
  T towards;  // 1 or -1: the normals' sense
  std::span<std::array<float, 3>> light;
};

template <class T>
constexpr void light_vertex(const lit_vertices<T>& to, std::size_t v, const phong_shader<T>& shader) {
  const vec<T, 3>& n = to.body.normals[v];
  const rgb<T> light = shader(to.body.positions[v], T(0) < to.towards ? n : -n);
  to.light[v] = {converted<float>(light.r), converted<float>(light.g), converted<float>(light.b)};
}

// The light of the vertices from first to last - 1, as the shader gives it one by one.
// needs   in doubles: `many` made of the shader
template <class T>
constexpr void light_vertices(const lit_vertices<T>& to, std::size_t first, std::size_t last,
                              const phong_shader<T>& shader, const phong_lanes<T>* many) {
  if constexpr (std::same_as<T, double>) {
    using f = lanes<pack<double, native_lanes<double>>>;
    if (!std::is_constant_evaluated() && many != nullptr)
      for (; last - first >= static_cast<std::size_t>(f::count); first += static_cast<std::size_t>(f::count)) {
        const auto coordinates = [&](const auto& all) { return load_triples<f::count>(&all[first].x); };
        triple_lanes<double, f::count> n = coordinates(to.body.normals);
        if (to.towards < 0) n = {-n.x, -n.y, -n.z};
        const auto light = (*many)(coordinates(to.body.positions), n);
        const auto r = converted<float>(light.r), g = converted<float>(light.g), b = converted<float>(light.b);
        for (int i = 0; i < f::count; ++i) to.light[first + static_cast<std::size_t>(i)] = {r[i], g[i], b[i]};
      }
  }
  for (; first < last; ++first) light_vertex(to, first, shader);
}

}  // namespace IRG_ABI

// What light becomes in the picture: its pixel; or it stays as it is until the range of all of it is known.
struct encoded_light {
  IRG_INLINE constexpr rgba8 operator()(const rgb<float>& light) const noexcept { return encode(light); }
};
struct light_itself {
  IRG_INLINE constexpr rgb<float> operator()(const rgb<float>& light) const noexcept { return light; }
};

// Phong shading of one triangle.
template <Floating T, class Output>
struct IRG_APART phong_pixel_shader {
  const phong_shader<T>& shader;
  const phong_lanes<T>* in_lanes;  // of doubles
  point<T, 3> position;
  vec<T, 3> normal;
  vec<T, 3> to_position[2], to_normal[2];  // from the first corner to the second and the third

  constexpr phong_pixel_shader(const phong_shader<T>& s, const phong_lanes<T>* many, const point<T, 3> (&p)[3],
                               const vec<T, 3> (&n)[3]) noexcept
      : shader(s), in_lanes(many), position(p[0]), normal(n[0]), to_position{p[1] - p[0], p[2] - p[0]},
        to_normal{n[1] - n[0], n[2] - n[0]} {}

  IRG_INLINE constexpr auto operator()(const pixel_weights<float>& at) const {
    const T s = converted<T>(at.weight1), t = converted<T>(at.weight2);
    const point<T, 3> p = position + (to_position[0] * s + to_position[1] * t);
    const vec<T, 3> n = normal + (to_normal[0] * s + to_normal[1] * t);
    const rgb<T> light = shader(p, n);
    return Output{}({converted<float>(light.r), converted<float>(light.g), converted<float>(light.b)});
  }

  // What is seen at a register of pixels of objects that share their light: positions and normals.
  template <int N>
    requires std::same_as<T, double>
  struct collected {
    using f = lanes<pack<double, minimum(N, native_lanes<double>)>>;
    static constexpr int parts = N / f::count;
    alignas(64) double coordinate[6][static_cast<unsigned>(N)];
    const phong_lanes<T>* light = nullptr;

    IRG_INLINE bool takes(const phong_pixel_shader& s) const noexcept {
      return light == nullptr || light == s.in_lanes;
    }
    IRG_INLINE void put(const phong_pixel_shader& of, const pixel_weights<pack<float, N>>& at,
                        const pack<std::int32_t, N>& chosen) noexcept {
      light = of.in_lanes;
      alignas(64) float weight1[static_cast<unsigned>(N)], weight2[static_cast<unsigned>(N)];
      alignas(64) std::int32_t mask[static_cast<unsigned>(N)];
      lanes<pack<float, N>>::store(weight1, at.weight1);
      lanes<pack<float, N>>::store(weight2, at.weight2);
      lanes<pack<std::int32_t, N>>::store(mask, chosen);
      for (int first = 0; first < N; first += f::count) {
        const auto few = [&](const auto* from) {
          return lanes<pack<std::remove_cvref_t<decltype(*from)>, f::count>>::load(from + first);
        };
        const auto s = converted<double>(few(weight1)), t = converted<double>(few(weight2));
        const auto where = converted<std::int64_t>(few(mask));
        const auto put = [&](double* to, T from, T to_second, T to_third) {
          const auto between = f::broadcast(from) + (f::broadcast(to_second) * s + f::broadcast(to_third) * t);
          f::store(to + first, select(where, between, f::load(to + first)));
        };
        for (int k = 0; k < 3; ++k) {
          put(coordinate[k], of.position[k], of.to_position[0][k], of.to_position[1][k]);
          put(coordinate[3 + k], of.normal[k], of.to_normal[0][k], of.to_normal[1][k]);
        }
      }
    }
    // Shades the chosen pixels of a row.
    template <class P>
    IRG_INLINE void shade(P* row, unsigned chosen) {
      using channels = rgb<pack<float, f::count>>;
      channels part[static_cast<unsigned>(parts)];
      for (int first = 0; first < N; first += f::count) {
        const auto of = [&](int k) {
          const auto at = [&](int i) { return f::load(coordinate[k + i] + first); };
          return triple_lanes<double, f::count>{at(0), at(1), at(2)};
        };
        const auto some = (*light)(of(0), of(3), chosen >> first);
        part[first / f::count] = {converted<float>(some.r), converted<float>(some.g), converted<float>(some.b)};
      }
      light = nullptr;
      const auto all = [&](auto channel) {
        if constexpr (parts == 1)
          return part[0].*channel;
        else
          return join_halves<float, N>(part[0].*channel, part[1].*channel);
      };
      const rgb<pack<float, N>> made{all(&channels::r), all(&channels::g), all(&channels::b)};
      if constexpr (std::same_as<Output, encoded_light> && sizeof(P) == 4) {
        store_pixels(row, encode_lanes(made.r, made.g, made.b), chosen);
      } else {
        for (; chosen != 0; chosen &= chosen - 1) {
          const int i = std::countr_zero(chosen);
          row[i] = Output{}({made.r[i], made.g[i], made.b[i]});
        }
      }
    }
  };
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
  phong_shader<T> phong;
  std::optional<phong_lanes<T>> phong_in_lanes{};  // of doubles, where the style needs it: at vertices, too

  constexpr object_shading(prepared_object<T>& object, const lighting<T>& light, const point<T, 3>& eye)
      : made(object), flat{object.surface, light, eye}, phong{object.surface, light, eye} {}

  constexpr const phong_lanes<T>* shared_light() const noexcept { return phong_in_lanes ? &*phong_in_lanes : nullptr; }

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
  constexpr void prepare(picture_style style, face_culling culling, const executor_ref& executor) {
    const lighting<T>& light = flat.light;
    object_frame<T>& frame = kept_of(made);
    shading_key<T> key{
        style,         culling,        made.surface, flat.eye, {light.lights.begin(), light.lights.end()},
        light.ambient, light.distance, light.k};
    if constexpr (std::same_as<T, double>)
      if (style == picture_style::phong || style == picture_style::gouraud) phong_in_lanes.emplace(phong);
    if (frame.key == key) return;
    frame.key.style = picture_style::wire;  // no colours: what is thrown from here on leaves none that seem ready
    if (style == picture_style::flat) {
      frame.face_colours.resize(made.shape.face_count(), rgb<float>{});
      for_portions(executor, made.shape.face_count(), [&](std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f) frame.face_colours[f] = face_colour(f, facing::front);
      });
    }
    for (const facing side : {facing::front, facing::back}) {
      if (style != picture_style::gouraud || (side == facing::back && culling == face_culling::back)) continue;
      auto& colours = frame.vertex_colours[side == facing::back ? 1 : 0];
      colours.resize(made.body.positions.size(), std::array<float, 3>{});
      const lit_vertices<T> to{made.body, side == facing::front ? T(1) : T(-1), colours};
      for_portions(executor, colours.size(), [&](std::size_t first, std::size_t last) {
        light_vertices(to, first, last, phong, shared_light());
      });
    }
    frame.key = std::move(key);
  }

private:
  // Calls f(first, last) for all of count, a thousand of them in a task.
  template <class F>
  static constexpr void for_portions(const executor_ref& executor, std::size_t count, const F& f) {
    constexpr std::size_t portion = 1024;
    executor((count + portion - 1) / portion,
             [&](std::size_t k) { f(k * portion, minimum((k + 1) * portion, count)); });
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
        Output{}(side == facing::front ? kept_of(o.made).face_colours[f] : o.face_colour(f, side))};
  }
};

// Colours between the vertices.
template <class Output, class T>
struct gouraud_pixels {
  static constexpr int attribute_count = 3;
  std::span<const object_shading<T>> objects;

  IRG_INLINE constexpr const float* attributes(const triangle_batch<T>& batch, std::uint32_t vertex,
                                               facing side) const noexcept {
    return kept_of(objects[batch.object].made).vertex_colours[side == facing::back ? 1 : 0][vertex].data();
  }
  IRG_INLINE constexpr auto pixel(const std::array<float, 3>& light) const noexcept {
    return Output{}({light[0], light[1], light[2]});
  }
  template <int N>
    requires std::same_as<Output, encoded_light>
  IRG_INLINE pack<std::uint32_t, N> pixels(const std::array<pack<float, N>, 3>& light) const noexcept {
    return encode_lanes(light[0], light[1], light[2]);
  }
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
    const point<T, 3> p[3] = {body.positions[a], body.positions[b], body.positions[c]};
    const vec<T, 3> n[3] = {normal(a), normal(b), normal(c)};
    return {o.phong, o.shared_light(), p, n};
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
