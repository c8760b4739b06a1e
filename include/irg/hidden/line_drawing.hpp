// SPDX-License-Identifier: MIT
// From meshes to a line drawing: the faces that hide, and the edges that are drawn, both on the screen. Which edges say
// what a body looks like is told by their role.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/hidden/hidden_lines.hpp>
#include <irg/math/mat.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/screen_mapping.hpp>
#if IRG_BODIES
#include <irg/math/angle_between.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/mesh/crease_normals.hpp>
#include <irg/mesh/edge_ends.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/raster/projected_vertices.hpp>
#include <irg/raster/screen_pieces.hpp>
#endif

namespace irg {

/// What an edge is to its body. Of several the first that holds.
enum class line_role {
  border,  // it belongs to one face only
  silhouette,  // of two faces one shows its front on the screen and the other does not
  crease,  // two faces meet at more than the angle named, or in opposite directions, or more than two meet
  smooth  // none of these
};

/// Which edges are drawn: all of them, those that are not smooth, or borders and silhouettes alone.
enum class drawn_edges { every, features, outline };

/// What goes into a line drawing.
/// units   crease in radians: two faces that turn by no more are smooth
template <Floating T>
struct line_drawing_options {
  drawn_edges edges = drawn_edges::features;
  T crease = T(0.5235987755982988);  // 30 degrees
  face_culling culling = face_culling::none;
  skipping frustum = skipping::off;  // on: edges beyond a border of the picture are left out, triangles are counted
  bool operator==(const line_drawing_options&) const = default;
};

/// Faces and edges on the screen, ready for hidden_lines; roles[i] is that of edges[i].
struct line_drawing {
  std::vector<screen_face> faces;
  std::vector<screen_edge> edges;
  std::vector<line_role> roles;
  std::int64_t triangles = 0;  // all of the meshes
  std::int64_t beyond = 0;  // of these wholly beyond a border of the picture or of the depth range, with frustum on
  std::int64_t culled = 0;  // of the others those that culling left out
  bool operator==(const line_drawing&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// Adds a mesh to a line drawing: its faces, as the renderer has them, and its edges, each once.
/// shape   edges from the lower vertex to the higher, in the order of these; polygons are cut into triangles by
///         triangulate, whose diagonals are no edges
/// needs   a mesh in which validate() finds no defect
/// gives   with culling, faces that turn their back or their edge to the eye neither hide nor have edges of their own;
///         an edge beyond the eye or the guard band is cut in the points where its faces are. With frustum on, edges
///         wholly more than two pixels beyond a border of the picture are left out, and triangles there are counted as
///         `beyond`, culled or not. They stay in faces: an edge that leaves the picture may end behind one, and its
///         pixels depend on where it ends
/// exact   sides are those of the snapped corners; the angle of a crease is that of rounded unit normals
/// cost    n log n in the edges at a vertex; allocates
template <Floating T>
IRG_API void add_mesh(line_drawing& drawing, const mesh<T>& m, const mat<T, 4, 4>& to_clip,
                      const screen_mapping<T>& mapping, const line_drawing_options<T>& options = {});

}  // namespace IRG_COMPILED_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <class Drawing>
IRG_API void leave_out_beside_edges(Drawing& drawing);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// Leaves out the faces that lie beside all edges, to be called when all meshes have been added.
/// gives   a drawing of which hidden_lines finds the same parts: every point of an edge lies in the box around all
///         edges, and only a face that covers it can hide it. Where add_mesh has left out the edges beyond the picture,
///         these are most faces beyond it
/// cost    linear
template <std::same_as<line_drawing> Drawing>
constexpr void leave_out_faces_beside_edges(Drawing& drawing) {
  detail::leave_out_beside_edges(drawing);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

constexpr screen_box box_of_corners(const screen_face& f) noexcept {
  return box_of({f.v[0].position, f.v[1].position, f.v[2].position});
}
constexpr screen_box around(const screen_box& a, const screen_box& b) noexcept {
  return {minimum(a.left, b.left), minimum(a.top, b.top), maximum(a.right, b.right), maximum(a.bottom, b.bottom)};
}

// A mesh on its way into a drawing.
template <class T>
class drawn_mesh {
public:
  constexpr drawn_mesh(const mesh<T>& m, const mat<T, 4, 4>& to_clip, const screen_mapping<T>& mapping,
                       const line_drawing_options<T>& options)
      : mesh_(m), mapping_(mapping), options_(options),
        vertices_(project_vertices<T>(std::span<const point<T, 3>>(m.positions), to_clip, mapping)),
        borders_(borders_of(mapping)), is_common_(T(0) < options.crease && options.crease < pi<T>),
        cosine_(is_common_ ? cos(options.crease) : T(0)) {}

  constexpr void add_to(line_drawing& drawing) {
    add_faces(drawing);
    const std::vector<edge_end> ends = edge_ends(mesh_);
    for (std::size_t i = 0, next = 0; i < ends.size(); i = next) {
      while (next < ends.size() && ends[next].from == ends[i].from && ends[next].to == ends[i].to) ++next;
      if (ends[i].from < ends[i].to) add_edge(drawing, {ends.data() + i, next - i});
    }
  }

private:
  struct face_direction {
    vec<T, 3> normal;
    bool is_known;
  };

  // Gives out what hides, and notes the side that each face turns to the eye, by its winding on the screen: 1 the
  // front, -1 the back, 0 its edge.
  constexpr void add_faces(line_drawing& drawing) {
    const bool is_cut = mesh_.corners.size() == 3 * mesh_.face_count();
    const mesh<T> cut = is_cut ? mesh<T>{} : triangulated(mesh_);
    const mesh<T>& triangles = is_cut ? mesh_ : cut;
    if (const std::size_t n = drawing.faces.size() + triangles.face_count(); n > drawing.faces.capacity())
      drawing.faces.reserve(maximum(n, 2 * drawing.faces.capacity()));  // bodies are added one by one
    face_of_corner_.reserve(mesh_.corners.size());
    side_.reserve(mesh_.face_count());
    for (std::size_t f = 0, t = 0; f < mesh_.face_count(); ++f) {
      const std::size_t end = t + mesh_.face_size(f) - 2;
      std::int64_t area = 0;
      for (std::size_t k = t; k < end; ++k) area += double_area_of(triangles, k);
      const bool left_out = options_.culling == face_culling::back && area >= 0;
      drawing.triangles += static_cast<std::int64_t>(end - t);
      for (; t < end; ++t) {
        if (options_.frustum == skipping::on && lies_beyond(triangles, t))
          ++drawing.beyond;
        else if (left_out)
          ++drawing.culled;
        if (!left_out) add_triangle(drawing, triangles, t);
      }
      side_.push_back(area < 0 ? 1 : area > 0 ? -1 : 0);
      face_of_corner_.resize(mesh_.face_starts[f + 1], static_cast<std::uint32_t>(f));
    }
  }

  // The picture's borders, two pixels farther out: lines up to two pixels wide along anything beyond cover nothing of
  // the picture. Asked of the snapped ends and corners that are drawn and not of clip codes, so that no rounding comes
  // after: a segment or a triangle lies in the box of its ends or corners, and a part of an edge between its ends.
  static constexpr screen_box borders_of(const screen_mapping<T>& m) noexcept {
    constexpr std::int32_t margin = 2 * one_pixel;
    return {snap(m.centre_x - m.half_width) - margin, snap(m.centre_y - m.half_height) - margin,
            snap(m.centre_x + m.half_width) + margin, snap(m.centre_y + m.half_height) + margin};
  }
  constexpr bool lies_beyond(const screen_box& b) const noexcept { return !boxes_meet(b, borders_); }
  // Whether nothing of a triangle is in the picture, neither its area nor a line along it.
  constexpr bool lies_beyond(const mesh<T>& triangles, std::size_t t) const noexcept {
    const triangle_corners c = corners_of(triangles, t);
    const auto& at = vertices_.screen;
    if (c.cut == 0) return lies_beyond(box_of({at[c.v[0]].position, at[c.v[1]].position, at[c.v[2]].position}));
    const screen_pieces pieces = pieces_of(c, 0);
    if (pieces.size() == 0) return pieces.outside;
    screen_box whole = box_of_corners(pieces[0].face);
    for (const screen_piece& p : pieces) whole = around(whole, box_of_corners(p.face));
    return lies_beyond(whole);
  }

  struct triangle_corners {
    std::uint32_t v[3];
    std::uint8_t cut;
  };
  constexpr triangle_corners corners_of(const mesh<T>& triangles, std::size_t t) const noexcept {
    triangle_corners c{{}, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      c.v[k] = triangles.corners[3 * t + k].position;
      c.cut |= vertices_.codes[c.v[k]].cut;
    }
    return c;
  }
  constexpr screen_pieces pieces_of(const triangle_corners& c, std::uint32_t number) const noexcept {
    const hpoint<T, 3> corner[3] = {clip_position(vertices_, c.v[0]), clip_position(vertices_, c.v[1]),
                                    clip_position(vertices_, c.v[2])};
    return clip_to_screen(corner, mapping_, number);
  }
  constexpr std::int64_t double_area_of(const mesh<T>& triangles, std::size_t t) const noexcept {
    const triangle_corners c = corners_of(triangles, t);
    const auto& at = vertices_.screen;
    return c.cut != 0 ? pieces_of(c, 0).double_area
                      : twice_signed_area(at[c.v[0]].position, at[c.v[1]].position, at[c.v[2]].position);
  }
  constexpr void add_triangle(line_drawing& drawing, const mesh<T>& triangles, std::size_t t) const {
    const triangle_corners c = corners_of(triangles, t);
    const auto number = static_cast<std::uint32_t>(drawing.faces.size());
    const auto& at = vertices_.screen;
    if (c.cut == 0)
      drawing.faces.push_back(make_screen_face(at[c.v[0]], at[c.v[1]], at[c.v[2]], number));
    else
      for (const screen_piece& p : pieces_of(c, number)) drawing.faces.push_back(p.face);
  }

  constexpr line_role role_of(std::span<const edge_end> ends) {
    if (ends.size() == 1) return line_role::border;
    if (ends.size() != 2) return line_role::crease;
    const std::uint32_t f = face_of_corner_[ends[0].corner], g = face_of_corner_[ends[1].corner];
    if ((side_[f] > 0) != (side_[g] > 0)) return line_role::silhouette;
    if (ends[0].leaves == ends[1].leaves) return line_role::crease;
    return turns_little(normal_of(f), normal_of(g)) ? line_role::smooth : line_role::crease;
  }

  // The unit normal, zero where the face has none. Worked out once for all edges.
  constexpr const vec<T, 3>& normal_of(std::uint32_t f) {
    if (normals_.empty()) normals_.assign(mesh_.face_count(), {vec<T, 3>{}, false});
    face_direction& n = normals_[f];
    if (!n.is_known) n = {face_normal(mesh_, f).value_or(vec<T, 3>{}), true};
    return n.normal;
  }
  // By the cosine where that is farther from the crease's than both are rounded, by the angle else.
  constexpr bool turns_little(const vec<T, 3>& a, const vec<T, 3>& b) const {
    if (a == vec<T, 3>{} || b == vec<T, 3>{}) return false;
    constexpr T rounding = 32 * std::numeric_limits<T>::epsilon();
    const T beyond = dot(a, b) - cosine_;
    if (is_common_ && (beyond > rounding || beyond < -rounding)) return beyond > T(0);
    return angle_between(a, b) <= options_.crease;
  }

  constexpr void add_edge(line_drawing& drawing, std::span<const edge_end> ends) {
    bool drawn = options_.culling == face_culling::none;
    for (const edge_end& e : ends) drawn = drawn || side_[face_of_corner_[e.corner]] > 0;
    if (!drawn) return;
    screen_edge line{{vertices_.screen[ends[0].from], vertices_.screen[ends[0].to]}};
    if ((vertices_.codes[ends[0].from].cut | vertices_.codes[ends[0].to].cut) != 0) {
      const auto left =
          clip_segment_homogeneous(clip_vertex<T, 0>{clip_position(vertices_, ends[0].from)},
                                   clip_vertex<T, 0>{clip_position(vertices_, ends[0].to)}, mapping_.guard);
      if (!left) return;
      line = {{to_screen(left->first.position, mapping_), to_screen(left->second.position, mapping_)}};
    }
    if (options_.frustum == skipping::on && lies_beyond(box_of({line.v[0].position, line.v[1].position}))) return;
    const line_role role = role_of(ends);
    if (options_.edges == drawn_edges::features && role == line_role::smooth) return;
    if (options_.edges == drawn_edges::outline && role != line_role::border && role != line_role::silhouette) return;
    drawing.edges.push_back(line);
    drawing.roles.push_back(role);
  }

  const mesh<T>& mesh_;
  const screen_mapping<T>& mapping_;
  const line_drawing_options<T>& options_;
  projected_vertices<T> vertices_;
  screen_box borders_;
  bool is_common_;  // between 0 and pi, where cosines fall as angles rise
  T cosine_;  // of the crease
  std::vector<face_direction> normals_{};
  std::vector<std::int8_t> side_{};  // of each face
  std::vector<std::uint32_t> face_of_corner_{};
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Drawing>
IRG_API void leave_out_beside_edges(Drawing& drawing) {
  if (drawing.edges.empty()) return drawing.faces.clear();
  const auto box_of_edge = [](const screen_edge& e) { return box_of({e.v[0].position, e.v[1].position}); };
  screen_box edges = box_of_edge(drawing.edges[0]);
  for (const screen_edge& e : drawing.edges) edges = around(edges, box_of_edge(e));
  std::erase_if(drawing.faces, [&](const screen_face& f) { return !boxes_meet(box_of_corners(f), edges); });
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void add_mesh(line_drawing& drawing, const mesh<T>& m, const mat<T, 4, 4>& to_clip,
                      const screen_mapping<T>& mapping, const line_drawing_options<T>& options) {
  detail::drawn_mesh<T>(m, to_clip, mapping, options).add_to(drawing);
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
