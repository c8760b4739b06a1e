// SPDX-License-Identifier: MIT
// The triangles of bodies over one list of positions, and which of them share sides.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/to_mesh.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/solid/detail/box_pairs.hpp>
#include <irg/solid/detail/triangle_contacts.hpp>

namespace irg::detail {

/// What stands against a mesh as the boundary of a body.
enum class surface_fault { none, not_finite, open_edge, edge_of_many_faces };

struct IRG_APART body_triangles {
  std::vector<point<double, 3>> positions;  // of one body after another
  std::vector<triangle_indices> triangles;  // equal positions are named by the first of them
  std::vector<std::uint32_t> face;  // of the body that the triangle is of
  std::vector<std::uint32_t> part;  // of the body, where it has parts
  std::vector<std::uint32_t> twin;  // of side 3t + k the side that runs back along it; none where more than two meet
  std::vector<std::uint32_t> body;  // that the triangle is of
  std::vector<std::uint32_t> ends;  // of each body, the triangle after its last one
  surface_fault fault = surface_fault::none;
  std::uint32_t faulty = 0;  // the body that it is found in

  constexpr std::uint32_t first_of(std::uint32_t b) const noexcept { return b == 0 ? 0 : ends[b - 1]; }
};

/// A side of a triangle, by its ends.
struct triangle_side {
  std::uint32_t low, high, triangle;
  constexpr auto operator<=>(const triangle_side&) const = default;
};

/// Where triangles lie.
struct body_boxes {
  std::vector<space_box> triangles{}, bodies{};
  std::vector<box_tree> trees{};  // of the triangles of each body, seen from above
};

inline namespace IRG_ABI {

template <Floating T>
constexpr void append_body(body_triangles& b, const mesh<T>& m) {
  const auto body = static_cast<std::uint32_t>(b.ends.size());
  const auto first = static_cast<std::uint32_t>(b.positions.size());
  for (const point<T, 3>& p : m.positions) {
    b.positions.push_back({widened(p.x), widened(p.y), widened(p.z)});
    if (!is_finite(p.x) || !is_finite(p.y) || !is_finite(p.z)) {
      b.fault = surface_fault::not_finite;
      b.faulty = body;
    }
  }
  if (b.fault != surface_fault::none) return;
  const mesh<T> triangles = triangulated(m);
  for (std::uint32_t i = 0; i < triangles.parts.size(); ++i)
    b.part.insert(b.part.end(), triangles.parts[i].face_count, i);
  b.part.resize(b.triangles.size() + triangles.face_count(), 0);
  b.body.resize(b.part.size(), body);
  b.triangles.reserve(b.part.size());
  std::uint32_t face = 0, left = 0;
  for (std::size_t t = 0; t < triangles.face_count(); ++t) {
    if (left == 0) left = static_cast<std::uint32_t>(m.face_size(face++) - 2);
    --left;
    const mesh_corner* c = triangles.corners.data() + 3 * t;
    b.triangles.push_back({{first + c[0].position, first + c[1].position, first + c[2].position}});
    b.face.push_back(face - 1);
  }
  b.ends.push_back(static_cast<std::uint32_t>(b.triangles.size()));
}

// Lets equal positions go by the number of the first, and drops triangles that name one twice.
template <class Bodies>
constexpr void merge_bodies(Bodies& b) {
  struct key {
    point<double, 3> at;
    std::uint32_t index;
  };
  std::vector<key> keys;
  keys.reserve(b.positions.size());
  for (std::uint32_t v = 0; v < b.positions.size(); ++v) {
    const point<double, 3>& p = b.positions[v];
    keys.push_back({{p.x + 0.0, p.y + 0.0, p.z + 0.0}, v});  // no -0
  }
  std::sort(keys.begin(), keys.end(), [](const key& p, const key& q) {
    for (int i = 0; i < 3; ++i)
      if (p.at[i] != q.at[i]) return p.at[i] < q.at[i];
    return p.index < q.index;
  });
  std::vector<std::uint32_t> to(b.positions.size(), 0);
  for (std::size_t i = 0, group = 0; i < keys.size(); ++i) {
    if (!(keys[i].at == keys[group].at)) group = i;
    to[keys[i].index] = keys[group].index;
  }
  std::uint32_t kept = 0;
  for (std::uint32_t& end : b.ends) end = 0;
  for (std::uint32_t t = 0; t < b.triangles.size(); ++t) {
    triangle_indices n = b.triangles[t];
    for (std::uint32_t& v : n.v) v = to[v];
    if (n.v[0] == n.v[1] || n.v[1] == n.v[2] || n.v[2] == n.v[0]) continue;
    b.triangles[kept] = n;
    b.part[kept] = b.part[t];
    b.body[kept] = b.body[t];
    b.face[kept++] = b.face[t];
    b.ends[b.body[t]] = kept;
  }
  for (std::size_t i = 1; i < b.ends.size(); ++i) b.ends[i] = maximum(b.ends[i], b.ends[i - 1]);
  b.triangles.resize(kept, triangle_indices{});
  b.face.resize(kept, 0);
}

// Finds for each side of a triangle the one of the same body that runs back, and what is wrong with the first body that
// is no surface.
template <class Bodies>
constexpr void pair_sides(Bodies& b) {
  b.twin.assign(3 * b.triangles.size(), no_index);
  struct side {
    std::uint32_t high, corner;  // corner: 2 (3t + k), and 1 more where the side goes up
  };
  std::vector<std::uint32_t> start(b.positions.size() + 1, 0);
  const auto each_side = [&](const auto& use) {
    for (std::uint32_t t = 0; t < b.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) use(3 * t + k, b.triangles[t].v[k], b.triangles[t].v[(k + 1) % 3]);
  };
  each_side([&](std::uint32_t, std::uint32_t v, std::uint32_t w) { ++start[minimum(v, w) + std::size_t{1}]; });
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<side> sides(3 * b.triangles.size(), side{});
  each_side([&](std::uint32_t corner, std::uint32_t v, std::uint32_t w) {
    sides[start[minimum(v, w)]++] = {maximum(v, w), 2 * corner + (v < w ? 1u : 0u)};
  });
  const auto body_of = [&](std::size_t i) { return b.body[sides[i].corner / 6]; };
  for (std::size_t v = 0, begin = 0; v + 1 < start.size(); begin = start[v++]) {
    const auto at = [&](std::size_t i) { return sides.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(begin), at(start[v]), [](const side& p, const side& q) {
      return p.high != q.high ? p.high < q.high : p.corner < q.corner;  // so those of a body stand together
    });
    for (std::size_t i = begin, next = begin; i < start[v]; i = next) {
      int up = 0, down = 0;
      for (; next < start[v] && sides[next].high == sides[i].high && body_of(next) == body_of(i); ++next)
        ++((sides[next].corner & 1) ? up : down);
      if (up != down && (b.fault == surface_fault::none || body_of(i) <= b.faulty)) {
        b.fault = up + down == 1 ? surface_fault::open_edge : surface_fault::edge_of_many_faces;
        b.faulty = body_of(i);
      }
      if (up != 1 || down != 1) continue;
      b.twin[sides[i].corner / 2] = sides[i + 1].corner / 2;
      b.twin[sides[i + 1].corner / 2] = sides[i].corner / 2;
    }
  }
}

// Whether two triangles lie in one plane, look the same way and belong to one part of one body.
template <class Bodies>
constexpr bool are_level(const Bodies& b, std::uint32_t s, std::uint32_t t) noexcept {
  if (s == t) return true;
  if (b.body[s] != b.body[t] || b.part[s] != b.part[t]) return false;
  const auto at = [&](std::uint32_t i, int k) -> const point<double, 3>& { return b.positions[b.triangles[i].v[k]]; };
  for (int k = 0; k < 3; ++k)
    if (orient3d(at(s, 0), at(s, 1), at(s, 2), at(t, k)) != 0) return false;
  const seen_triangle seen = see_triangle(b.positions, b.triangles[s], s);
  return orientation_along(seen.axis, at(t, 0), at(t, 1), at(t, 2)) == seen.turn;
}

template <class P>
constexpr space_box box_of_triangle(const std::vector<P>& positions, const triangle_indices& t) noexcept {
  space_box box = no_box();
  for (const std::uint32_t v : t.v) box.add(positions[v]);
  return box;
}

template <class Bodies>
constexpr body_boxes boxes_of_bodies(const Bodies& b) {
  body_boxes boxes;
  boxes.triangles.reserve(b.triangles.size());
  boxes.bodies.assign(b.ends.size(), no_box());
  std::vector<std::vector<std::uint32_t>> members(b.ends.size());
  for (std::uint32_t t = 0; t < b.triangles.size(); ++t) {
    const space_box box = box_of_triangle(b.positions, b.triangles[t]);
    boxes.triangles.push_back(box);
    boxes.bodies[b.body[t]].add(box);
    members[b.body[t]].push_back(t);
  }
  for (std::vector<std::uint32_t>& of : members) boxes.trees.emplace_back(std::move(of), 2);
  return boxes;
}

// Calls use(t) for the triangles of a body that may stand over p, or over a point within `slack` of it.
template <class Boxes, class Use>
constexpr void each_above(Boxes& boxes, std::uint32_t body, const point<double, 3>& p, double slack, const Use& use) {
  const auto is_off = [&](const space_box& box) { return is_off_ray_upward(box, p, slack); };
  if (!is_off(boxes.bodies[body])) boxes.trees[body].each(boxes.triangles, is_off, use);
}

template <class M>
constexpr body_triangles make_body_triangles(const std::vector<const M*>& bodies) {
  body_triangles b;
  for (const M* m : bodies) {
    append_body(b, *m);
    if (b.fault != surface_fault::none) return b;
  }
  merge_bodies(b);
  pair_sides(b);
  return b;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
