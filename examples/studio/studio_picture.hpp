// SPDX-License-Identifier: MIT
// The studio as one function from a state and events to a picture: the main view on the left, on the right what an
// outer camera sees of the bodies and of the main camera with its pyramid.
//
// Faces are drawn by the renderer, bodies of opacity 1 first; transparent ones are blended over them; edges, points and
// helpers come last, seen where no opaque face is nearer.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/mesh/normals.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/projected_vertices.hpp>
#include <irg/render/detail/shade/object_shading.hpp>
#include <irg/render/draw_transparent.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/render/wireframe.hpp>

#include "studio_events.hpp"

namespace irg {
namespace detail {

// A body in the world: its faces by surface, and where all its points are.
template <class T>
struct placed_body {
  stored_body<T> source;
  mat<T, 4, 4> placement;
  bool can_be_seen = false;
  mesh<T> shape;
  std::vector<prepared_object<T>> parts;
  std::vector<std::uint32_t> surface_of_part;  // the number of surfaces for faces without one
};

}  // namespace detail

/// What the pictures of a studio keep from one to the next. Any studio's pictures may use it; it changes none.
template <Floating T>
struct studio_memory {
  struct view_memory {
    std::vector<detail::placed_body<T>> bodies;
    image<float> depth;
    draw_workspace workspace;
  };
  std::array<view_memory, 2> views;
};

/// The colours of what is no body.
struct studio_colours {
  rgba8 background{250, 249, 246, 255}, beside{222, 221, 216, 255};
  rgba8 edge{32, 44, 66, 255}, dot{176, 58, 46, 255}, camera{110, 60, 140, 255}, pyramid{180, 140, 40, 255};
  std::array<rgba8, 3> axis{rgba8{200, 40, 40, 255}, rgba8{30, 140, 50, 255}, rgba8{40, 80, 210, 255}};
};

inline namespace IRG_ABI {

/// Draws one view of a studio into a picture, as large as its screen's proportions allow.
/// needs   a studio that apply_event() has made
/// gives   bodies that a projection takes to infinity or behind its eye are not drawn
/// exact   the same bytes for every memory, compiler and instruction set. Which of the bodies' pixels are seen is as in
///         render(); of lines and points it is rounded: they count as seen unless all pixels around are nearer
/// cost    bodies are made ready when they have changed; then their vertices and triangles, and the pixels
template <Floating T>
constexpr void draw_studio_view(image_view<rgba8> picture, const studio<T>& s, studio_view view,
                                studio_memory<T>& memory, const studio_colours& colours = {});

/// Draws both views side by side, and a sentence below where there is one.
/// needs   a studio that apply_event() has made
/// exact   as draw_studio_view
template <Floating T>
constexpr void draw_studio(image_view<rgba8> picture, const studio<T>& s, studio_memory<T>& memory,
                           std::string_view sentence = {}, const studio_colours& colours = {});

/// The studio as one function: events happen one after another, and a picture is taken.
/// gives   the status of the last event that could not be, whose sentence the picture shows; else done
/// exact   as draw_studio_view
template <Floating T>
constexpr studio_status run_studio(studio<T>& s, std::type_identity_t<std::span<const studio_event<T>>> events,
                                   image_view<rgba8> picture, studio_memory<T>& memory);

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

// The bodies made ready for pictures, and kept as long as they stay the same.

template <class T>
constexpr bool is_affine(const mat<T, 4, 4>& m) noexcept {
  return m(3, 0) == T(0) && m(3, 1) == T(0) && m(3, 2) == T(0) && m(3, 3) == T(1);
}

// The shape where the placement puts it; false when a point goes to infinity or behind the eye of a projection.
template <class T>
constexpr bool place_shape(mesh<T>& shape, const mat<T, 4, 4>& placement) {
  bool good = true;
  if (is_affine(placement)) {
    shape = transformed(std::move(shape), placement);
  } else {
    for (point<T, 3>& p : shape.positions) {
      const hpoint<T, 3> q = placement * p;
      good = good && T(0) < q.w;
      p = {q.x / q.w, q.y / q.w, q.z / q.w};
    }
  }
  for (const point<T, 3>& p : shape.positions) good = good && is_finite(p);
  return good;
}

// The faces of a body put together by their surfaces, those without one last: of surface s from first[s] on.
struct faces_by_surface {
  std::vector<std::uint32_t> first, face;

  constexpr faces_by_surface(std::span<const std::uint32_t> surface_of_face, std::uint32_t surfaces)
      : first(surfaces + std::size_t{2}, 0u), face(surface_of_face.size(), 0u) {
    for (const std::uint32_t s : surface_of_face) ++first[minimum(s, surfaces) + std::size_t{1}];
    for (std::size_t s = 0; s <= surfaces; ++s) first[s + 1] += first[s];
    std::vector<std::uint32_t> next = first;
    for (std::uint32_t f = 0; f < face.size(); ++f) face[next[minimum(surface_of_face[f], surfaces)]++] = f;
  }
  constexpr std::span<const std::uint32_t> of(std::uint32_t surface) const noexcept {
    return {face.data() + first[surface], first[surface + 1] - first[surface]};
  }
};

// Some faces of a mesh that has a normal for each position, and the positions that they name. `number` has none for
// each position, before and after.
template <class T>
constexpr mesh<T> part_of_mesh(const mesh<T>& m, std::span<const std::uint32_t> faces,
                               std::vector<std::uint32_t>& number) {
  mesh<T> out;
  for (const std::uint32_t f : faces) {
    for (std::size_t k = 0; k < m.face_size(f); ++k) {
      const std::uint32_t p = m.corner(f, k).position;
      if (number[p] == no_index) {
        number[p] = static_cast<std::uint32_t>(out.positions.size());
        out.positions.push_back(m.positions[p]);
        out.normals.push_back(m.normals[p]);
      }
      out.corners.push_back({number[p], number[p], no_index});
    }
    out.face_starts.push_back(static_cast<std::uint32_t>(out.corners.size()));
  }
  for (const std::uint32_t f : faces)
    for (std::size_t k = 0; k < m.face_size(f); ++k) number[m.corner(f, k).position] = no_index;
  return out;
}

template <class T>
constexpr void place_body(placed_body<T>& p, const stored_body<T>& b, const mat<T, 4, 4>& placement) {
  if (p.source == b && p.placement == placement) return;
  placed_body<T> made{b, placement, false, b.shape, {}, {}};  // `p` stays as it is if memory gives out
  made.can_be_seen = place_shape(made.shape, placement);
  const auto surfaces = static_cast<std::uint32_t>(b.surfaces.size());
  if (made.can_be_seen) {
    mesh<T> smooth = made.shape;
    assign_vertex_normals(smooth, normal_weight::average);
    const faces_by_surface faces(b.surface_of_face, surfaces);
    std::vector<std::uint32_t> number(smooth.positions.size(), no_index);
    for (std::uint32_t s = 0; s <= surfaces; ++s) {
      if (faces.of(s).empty()) continue;
      made.parts.push_back(prepare_object(object<T>{part_of_mesh(smooth, faces.of(s), number)}));
      made.surface_of_part.push_back(s);
    }
  }
  p = std::move(made);
}

// What light does on a surface of a body, its colour in it.
template <class T>
constexpr material<T> studio_material(const stored_body<T>& b, std::uint32_t surface, studio_shading shading) noexcept {
  const stored_surface<T> s = surface < b.surfaces.size() ? b.surfaces[surface] : stored_surface<T>{};
  const rgb<float> light = decode(s.colour);
  const rgb<T> colour{static_cast<T>(light.r), static_cast<T>(light.g), static_cast<T>(light.b)};
  if (shading == studio_shading::none) return {colour, {}, {}, T(1)};
  const auto coloured = [&](const rgb<T>& share) {
    return rgb<T>{share.r * colour.r, share.g * colour.g, share.b * colour.b};
  };
  return {coloured(s.reflection.ambient), coloured(s.reflection.diffuse), s.reflection.specular,
          s.reflection.shininess};
}

// Lines and points in a picture that has depths: seen where no face is clearly nearer.

// A picture with depths, greater ones nearer, and the way from the world into it.
template <class T>
struct studio_canvas {
  image_view<rgba8> colour;
  const image<float>& depth;
  mat<T, 4, 4> to_clip;
  screen_mapping<T> mapping;

  // An edge lies in its faces, whose depths at the pixel's centre may be a little nearer or farther than the line's. So
  // it counts as seen unless all pixels around are nearer.
  constexpr bool sees_rounded(cell c, float own) const noexcept {
    for (int y = maximum(c.y - 1, 0); y <= minimum(c.y + 1, depth.height() - 1); ++y)
      for (int x = maximum(c.x - 1, 0); x <= minimum(c.x + 1, depth.width() - 1); ++x)
        if (depth(x, y) <= own) return true;
    return false;
  }

  static constexpr cell cell_at(const screen_vertex& v) noexcept {
    return {v.position.x >> subpixel_bits, v.position.y >> subpixel_bits};
  }

  constexpr void line_rounded(const hpoint<T, 3>& a, const hpoint<T, 3>& b, const rgba8& paint) {
    const auto left =
        clip_segment_homogeneous(clip_vertex<T, 0>{to_clip * a}, clip_vertex<T, 0>{to_clip * b}, mapping.guard);
    if (!left) return;
    if (!(T(0) < left->first.position.w && T(0) < left->second.position.w)) return;
    const screen_vertex from = to_screen(left->first.position, mapping), to = to_screen(left->second.position, mapping);
    const cell first = cell_at(from), last = cell_at(to);
    const int dx = last.x - first.x, dy = last.y - first.y;
    const bool flat = (dy < 0 ? -dy : dy) <= (dx < 0 ? -dx : dx);
    const int way = flat ? dx : dy;
    const float rise = to.depth - from.depth, steps = static_cast<float>(way == 0 ? 1 : way);
    line_bresenham(first, last, {0, 0, colour.width(), colour.height()}, [&](cell c) {
      const float gone = static_cast<float>(flat ? c.x - first.x : c.y - first.y);
      if (sees_rounded(c, from.depth + product(rise, gone / steps))) colour(c.x, c.y) = paint;
    });
  }
  constexpr void line_rounded(const point<T, 3>& a, const point<T, 3>& b, const rgba8& paint) {
    line_rounded(to_homogeneous(a), to_homogeneous(b), paint);
  }

  // Where a position is on the screen, if it is.
  constexpr std::optional<screen_vertex> place_of(const point<T, 3>& p) const noexcept {
    const hpoint<T, 3> at = to_clip * p;
    if (clip_code(at, mapping) != clip_code_pair{}) return std::nullopt;
    return to_screen(at, mapping);
  }

  // Nine pixels.
  constexpr void dot_rounded(const point<T, 3>& p, const rgba8& paint) {
    const auto v = place_of(p);
    if (!v || !sees_rounded(cell_at(*v), v->depth)) return;
    const cell c = cell_at(*v);
    for (int y = maximum(c.y - 1, 0); y <= minimum(c.y + 1, colour.height() - 1); ++y)
      for (int x = maximum(c.x - 1, 0); x <= minimum(c.x + 1, colour.width() - 1); ++x) colour(x, y) = paint;
  }

  constexpr void label(std::string_view text, const point<T, 3>& p, const rgba8& paint) {
    if (const auto v = place_of(p)) {
      const cell c = cell_at(*v);
      draw_text(colour, text, {static_cast<double>(c.x + 3), static_cast<double>(c.y - 3)}, {.size = 13}, paint);
    }
  }
};

// Encodes light with an opacity.
struct glass_encoding {
  std::uint8_t opacity;
  IRG_INLINE constexpr rgba8 operator()(const rgb<float>& light) const noexcept { return encode(light, opacity); }
};

// A part of a body in a picture: how it is lit, and how it is drawn.
template <class T>
struct studio_object {
  object_shading<T> shading;
  studio_shading how;
  face_culling culling;
  std::uint8_t opacity;
};

// The pixel shaders of transparent objects: one colour for a face, or colours between the vertices. Backs that are not
// to be seen have no opacity.
template <class T>
struct glass_pixels {
  std::span<const studio_object<T>> objects;

  constexpr auto operator()(const triangle_batch<T>& batch, std::uint32_t triangle, facing side) const noexcept {
    const studio_object<T>& o = objects[batch.object];
    const bool unseen = side == facing::back && o.culling == face_culling::back;
    const auto& frame = kept_of(o.shading.made);
    const auto& body = o.shading.made.body;
    rgb<float> at[3] = {};
    if (o.how == studio_shading::none || o.how == studio_shading::flat) {
      const std::uint32_t f = body.face_of[triangle];
      at[0] = at[1] = at[2] = side == facing::front ? frame.face_colours[f] : o.shading.face_colour(f, side);
    } else if (!unseen) {
      for (int k = 0; k < 3; ++k) {
        const auto& light = frame.vertex_colours[side == facing::back ? 1 : 0][body.triangles[triangle].v[k]];
        at[k] = {light[0], light[1], light[2]};
      }
    }
    const auto opacity = unseen ? std::uint8_t{0} : o.opacity;
    return vertex_colour_shader<rgba8, glass_encoding>{at[0], at[1], at[2], {opacity}};
  }
};

// A view of the studio while it is drawn.
template <class T>
struct studio_drawing {
  const studio<T>& s;
  studio_view view;
  image_view<rgba8> picture;
  typename studio_memory<T>::view_memory& memory;
  const studio_colours& colours;
  camera<T> seen_from;
  checked<mat<T, 4, 4>, projection_status> projection;
  mat<T, 4, 4> to_clip;
  screen_mapping<T> mapping;
  std::vector<studio_object<T>> objects;
  std::vector<light<T>> lamps;

  constexpr studio_drawing(const studio<T>& of, studio_view v, image_view<rgba8> to,
                           typename studio_memory<T>::view_memory& m, const studio_colours& c)
      : s(of), view(v), picture(to), memory(m), colours(c), seen_from(camera_of(of.of(v))),
        projection(view_projection_checked(seen_from, static_cast<T>(to.width()) / static_cast<T>(to.height()))),
        to_clip(projection.value), mapping(map_to_screen<T>({to.width(), to.height()})), lamps(of.lamps) {
    const T left = T(1) - s.ambient;
    for (light<T>& l : lamps) l.intensity = {left * l.intensity.r, left * l.intensity.g, left * l.intensity.b};
    if (memory.depth.width() != to.width() || memory.depth.height() != to.height())
      memory.depth = image<float>(to.width(), to.height());
  }

  constexpr void draw() {
    clear(picture, colours.background);
    if (!projection.ok()) return;  // of a screen that is hardly a pixel wide, say
    clear(memory.depth, nearer_is_greater::farthest);
    prepare();
    opaque();
    transparent();
    studio_canvas<T> canvas{picture, memory.depth, to_clip, mapping};
    for (std::size_t i = 0; i < s.bodies.size(); ++i)
      if (memory.bodies[i].can_be_seen) edges_and_points(canvas, s.bodies[i], memory.bodies[i].shape);
    helpers(canvas);
  }

  // The bodies where they stand, and the shading of those whose faces are shown.
  constexpr void prepare() {
    memory.bodies.resize(s.bodies.size());
    for (std::size_t i = 0; i < s.bodies.size(); ++i) {
      const studio_body<T>& b = s.bodies[i];
      placed_body<T>& placed = memory.bodies[i];
      place_body(placed, b.body, placement_of(s, b));
      if (!b.shows(studio_part::faces)) continue;
      for (std::size_t k = 0; k < placed.parts.size(); ++k) {
        prepared_object<T>& part = placed.parts[k];
        const std::uint32_t surface = placed.surface_of_part[k];
        part.surface = studio_material(b.body, surface, b.shading);
        add_object(part, b, surface < b.body.surfaces.size() ? b.body.surfaces[surface].colour.a : std::uint8_t{255});
      }
    }
  }
  constexpr void add_object(prepared_object<T>& part, const studio_body<T>& b, std::uint8_t opacity) {
    const bool unlit = b.shading == studio_shading::none;
    const T around = unlit ? T(1) : s.ambient;
    const lighting<T> light{{around, around, around},
                            unlit ? std::span<const light_of>() : std::span<const light_of>(lamps)};
    const face_culling culling = b.shows(studio_part::backs) ? face_culling::none : face_culling::back;
    objects.push_back({object_shading<T>(part, light, viewpoint(seen_from)), b.shading, culling,
                       static_cast<std::uint8_t>(b.opacity * static_cast<T>(opacity) + T(0.5))});
    const studio_object<T>& o = objects.back();
    const bool flat = unlit || b.shading == studio_shading::flat;
    const bool phong = b.shading == studio_shading::phong && o.opacity == 255;
    objects.back().shading.prepare(flat    ? picture_style::flat
                                   : phong ? picture_style::phong
                                           : picture_style::gouraud,
                                   culling, as_executor(sequential{}));
    project_vertices<T>(part.body.positions, to_clip, mapping, kept_of(part).vertices);
  }

  constexpr void opaque() {
    for (const studio_object<T>& o : objects) {
      if (o.opacity != 255) continue;
      const prepared_object<T>& made = o.shading.made;
      const triangle_batch<T> batch[1] = {{&kept_of(made).vertices, made.body.triangles, 0, 0}};
      const std::span<const object_shading<T>> one(&o.shading, 1);
      const auto draw = [&](const auto& pixels) {
        shade_batches(render_target{picture, memory.depth}, projected_triangles<T>{batch, mapping}, pixels,
                      {.culling = o.culling, .workspace = &memory.workspace});
      };
      if (o.how == studio_shading::gouraud)
        draw(gouraud_pixels<encoded_light, T>{one});
      else if (o.how == studio_shading::phong)
        draw(phong_pixels<encoded_light, T>{one});
      else
        draw(flat_pixels<encoded_light, T>{one});
    }
  }

  constexpr void transparent() {
    std::vector<triangle_batch<T>> batches;
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (objects[i].opacity == 255 || objects[i].opacity == 0) continue;
      const prepared_object<T>& made = objects[i].shading.made;
      batches.push_back({&kept_of(made).vertices, made.body.triangles, number, static_cast<std::uint32_t>(i)});
      number += static_cast<std::uint32_t>(made.body.triangles.size());
    }
    if (!batches.empty())
      draw_transparent(render_target{picture, memory.depth}, projected_triangles<T>{batches, mapping},
                       glass_pixels<T>{objects});
  }

  // Edges of faces that all face away are left out where backs are, or the faces hide them anyway.
  constexpr void edges_and_points(studio_canvas<T>& canvas, const studio_body<T>& b, const mesh<T>& shape) {
    if (b.shows(studio_part::edges)) {
      std::vector<std::uint64_t> front, all;
      const bool choose = !b.shows(studio_part::backs);
      if (choose) {
        const auto vertices = project_vertices<T>(shape.positions, to_clip, mapping);
        for (std::size_t f = 0; f < shape.face_count(); ++f)
          for (std::size_t k = 0, n = shape.face_size(f), back = shows_back(vertices, shape, f); k < n; ++k) {
            const std::uint64_t e = edge_of(shape.corner(f, k).position, shape.corner(f, (k + 1) % n).position);
            all.push_back(e);
            if (back == 0) front.push_back(e);
          }
        std::sort(all.begin(), all.end());
        std::sort(front.begin(), front.end());
      }
      for (const stored_edge& e : b.body.edges) {
        const std::uint64_t key = edge_of(e.from, e.to);
        if (choose && !std::binary_search(front.begin(), front.end(), key) &&
            std::binary_search(all.begin(), all.end(), key))
          continue;
        canvas.line_rounded(shape.positions[minimum(e.from, e.to)], shape.positions[maximum(e.from, e.to)],
                            colours.edge);
      }
    }
    if (b.shows(studio_part::points))
      for (const point<T, 3>& p : shape.positions) canvas.dot_rounded(p, colours.dot);
  }

  constexpr void axes(studio_canvas<T>& canvas, const point<T, 3>& origin, const std::array<vec<T, 3>, 3>& along) {
    constexpr std::string_view names = "xyz";
    for (std::size_t i = 0; i < 3; ++i) {
      canvas.line_rounded(origin, origin + along[i], colours.axis[i]);
      canvas.label(names.substr(i, 1), origin + along[i], colours.axis[i]);
    }
  }

  constexpr void helpers(studio_canvas<T>& canvas) {
    const studio_camera<T>&here = s.of(view), &c = s.of(studio_view::main);
    const view_pyramid<T>& p = c.pyramid;
    const camera_frame<T> f = look_at_frame(c.eye, c.target, c.up);
    const T half = length(c.target - c.eye) / T(2);
    if (here.shows(studio_helper::world_axes))
      axes(canvas, {}, {vec<T, 3>{half, T(0), T(0)}, vec<T, 3>{T(0), half, T(0)}, vec<T, 3>{T(0), T(0), half}});
    if (here.shows(studio_helper::camera_axes))
      axes(canvas, f.position, {f.right * p.distance, f.up * p.distance, -f.forward * p.distance});
    if (here.shows(studio_helper::camera)) {
      const point<T, 3> middle = f.position + f.forward * p.distance;
      const vec<T, 3> x = f.right * (p.width / T(2)), y = f.up * (p.height / T(2));
      const point<T, 3> corner[4] = {middle - x - y, middle + x - y, middle + x + y, middle - x + y};
      for (int k = 0; k < 4; ++k) {
        canvas.line_rounded(f.position, corner[k], colours.camera);
        canvas.line_rounded(corner[k], corner[(k + 1) % 4], colours.camera);
      }
    }
    if (!here.shows(studio_helper::pyramid)) return;
    const auto corners = frustum_corners(frustum_of(view_projection_checked(camera_of(c), p.width / p.height).value));
    if (!corners) return;
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4})
        if ((i & bit) == 0) canvas.line_rounded(corners->at[i], corners->at[i | bit], colours.pyramid);
  }

private:
  using light_of = light<T>;
};

// The largest part of a picture that has the proportions of a screen, in its middle.
template <class T>
constexpr image_view<rgba8> screen_within(image_view<rgba8> all, const view_pyramid<T>& p) noexcept {
  const T wide = static_cast<T>(all.width()), high = static_cast<T>(all.height()), ratio = p.width / p.height;
  const bool limited = wide < high * ratio;  // by the width
  const int width = limited ? all.width() : static_cast<int>(clamped(high * ratio + T(0.5), T(1), wide));
  const int height = limited ? static_cast<int>(clamped(wide / ratio + T(0.5), T(1), high)) : all.height();
  return {all.row((all.height() - height) / 2) + (all.width() - width) / 2, width, height, all.stride()};
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

template <Floating T>
constexpr void draw_studio_view(image_view<rgba8> picture, const studio<T>& s, studio_view view,
                                studio_memory<T>& memory, const studio_colours& colours) {
  if (picture.width() <= 0 || picture.height() <= 0) return;
  clear(picture, colours.beside);
  detail::studio_drawing<T>(s, view, detail::screen_within(picture, s.of(view).pyramid),
                            memory.views[static_cast<std::size_t>(view)], colours)
      .draw();
}

template <Floating T>
constexpr void draw_studio(image_view<rgba8> picture, const studio<T>& s, studio_memory<T>& memory,
                           std::string_view sentence, const studio_colours& colours) {
  const int width = picture.width(), height = picture.height(), half = width / 2;
  if (width <= 0 || height <= 0) return;
  draw_studio_view({picture.row(0), half, height, picture.stride()}, s, studio_view::main, memory, colours);
  draw_studio_view({picture.row(0) + half, width - half, height, picture.stride()}, s, studio_view::outer, memory,
                   colours);
  for (int y = 0; y < height; ++y) picture(half, y) = colours.edge;
  draw_text(picture, sentence, {6.0, static_cast<double>(height - 8)}, {.size = 14}, colours.dot);
}

template <Floating T>
constexpr studio_status run_studio(studio<T>& s, std::type_identity_t<std::span<const studio_event<T>>> events,
                                   image_view<rgba8> picture, studio_memory<T>& memory) {
  studio_status last = studio_status::done;
  for (const studio_event<T>& e : events)
    if (const studio_status now = apply_event(s, e); now != studio_status::done) last = now;
  draw_studio(picture, s, memory, last == studio_status::done ? std::string_view() : sentence_of(last));
  return last;
}

}  // namespace IRG_ABI
}  // namespace irg
