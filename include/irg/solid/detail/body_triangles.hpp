// SPDX-License-Identifier: MIT
// The triangles of two bodies over one list of positions, and which of them share sides.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/to_mesh.hpp>
#include <irg/core/triangle_indices.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/solid/detail/box_pairs.hpp>
#include <irg/solid/detail/triangle_contacts.hpp>

namespace irg::detail {

/// What stands against a mesh as the boundary of a body.
enum class surface_fault { none, not_finite, open_edge, edge_of_many_faces };

struct body_triangles {
  std::vector<point<double, 3>> positions;  // of the first body, then of the second
  std::vector<triangle_indices> triangles;  // equal positions are named by the first of them
  std::vector<std::uint32_t> face;  // of the body that the triangle is of
  std::vector<std::uint32_t> part;  // of the body, where it has parts
  std::vector<std::uint32_t> twin;  // of side 3t + k the side that runs back along it; none where more than two meet
  std::uint32_t second = 0;  // the first triangle of the second body
  surface_fault fault[2]{};

  constexpr int body_of(std::uint32_t t) const noexcept { return t < second ? 0 : 1; }
};

inline namespace IRG_ABI {

template <Floating T>
constexpr void append_body(body_triangles& b, const mesh<T>& m, surface_fault& fault) {
  const auto first = static_cast<std::uint32_t>(b.positions.size());
  for (const point<T, 3>& p : m.positions) {
    b.positions.push_back({widened(p.x), widened(p.y), widened(p.z)});
    if (!is_finite(p.x) || !is_finite(p.y) || !is_finite(p.z)) fault = surface_fault::not_finite;
  }
  if (fault != surface_fault::none) return;
  const mesh<T> triangles = triangulate(m);
  for (std::uint32_t i = 0; i < triangles.parts.size(); ++i)
    b.part.insert(b.part.end(), triangles.parts[i].face_count, i);
  b.part.resize(b.triangles.size() + triangles.face_count(), 0);
  b.triangles.reserve(b.triangles.size() + triangles.face_count());
  std::uint32_t face = 0, left = 0;
  for (std::size_t t = 0; t < triangles.face_count(); ++t) {
    if (left == 0) left = static_cast<std::uint32_t>(m.face_size(face++) - 2);
    --left;
    const mesh_corner* c = triangles.corners.data() + 3 * t;
    b.triangles.push_back({{first + c[0].position, first + c[1].position, first + c[2].position}});
    b.face.push_back(face - 1);
  }
}

// Lets equal positions go by the number of the first, and drops triangles that name one twice.
constexpr void merge_bodies(body_triangles& b) {
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
  std::uint32_t kept = 0, second = 0;
  for (std::uint32_t t = 0; t < b.triangles.size(); ++t) {
    if (t == b.second) second = kept;
    triangle_indices n = b.triangles[t];
    for (std::uint32_t& v : n.v) v = to[v];
    if (n.v[0] == n.v[1] || n.v[1] == n.v[2] || n.v[2] == n.v[0]) continue;
    b.triangles[kept] = n;
    b.part[kept] = b.part[t];
    b.face[kept++] = b.face[t];
  }
  b.second = b.second == b.triangles.size() ? kept : second;
  b.triangles.resize(kept, triangle_indices{});
  b.face.resize(kept, 0);
}

// Finds for each side of one body's triangles, from `first` to `last`, the one that runs back.
constexpr surface_fault pair_sides(body_triangles& b, std::uint32_t first, std::uint32_t last) {
  struct side {
    std::uint32_t high, corner;  // corner: 2 (3t + k), and 1 more where the side goes up
  };
  std::vector<std::uint32_t> start(b.positions.size() + 1, 0);
  const auto each_side = [&](const auto& use) {
    for (std::uint32_t t = first; t < last; ++t)
      for (std::uint32_t k = 0; k < 3; ++k) use(3 * t + k, b.triangles[t].v[k], b.triangles[t].v[(k + 1) % 3]);
  };
  each_side([&](std::uint32_t, std::uint32_t v, std::uint32_t w) { ++start[lesser(v, w) + std::size_t{1}]; });
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<side> sides(3 * std::size_t{last - first}, side{});
  each_side([&](std::uint32_t corner, std::uint32_t v, std::uint32_t w) {
    sides[start[lesser(v, w)]++] = {greater(v, w), 2 * corner + (v < w ? 1u : 0u)};
  });
  surface_fault fault = surface_fault::none;
  for (std::size_t v = 0, begin = 0; v + 1 < start.size(); begin = start[v++]) {
    const auto at = [&](std::size_t i) { return sides.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(begin), at(start[v]), [](const side& p, const side& q) { return p.high < q.high; });
    for (std::size_t i = begin, next = begin; i < start[v]; i = next) {
      int up = 0, down = 0;
      for (; next < start[v] && sides[next].high == sides[i].high; ++next) ++((sides[next].corner & 1) ? up : down);
      if (up != down) fault = up + down == 1 ? surface_fault::open_edge : surface_fault::edge_of_many_faces;
      if (up != 1 || down != 1) continue;
      b.twin[sides[i].corner / 2] = sides[i + 1].corner / 2;
      b.twin[sides[i + 1].corner / 2] = sides[i].corner / 2;
    }
  }
  return fault;
}

// Whether two triangles lie in one plane, look the same way and belong to one part of one body.
constexpr bool are_level(const body_triangles& b, std::uint32_t s, std::uint32_t t) noexcept {
  if (s == t) return true;
  if (b.body_of(s) != b.body_of(t) || b.part[s] != b.part[t]) return false;
  const auto at = [&](std::uint32_t i, int k) -> const point<double, 3>& { return b.positions[b.triangles[i].v[k]]; };
  for (int k = 0; k < 3; ++k)
    if (orient3d(at(s, 0), at(s, 1), at(s, 2), at(t, k)) != 0) return false;
  const seen_triangle seen = see_triangle(b.positions, b.triangles[s], s);
  return orientation_along(at(t, 0), at(t, 1), at(t, 2), seen.axis) == seen.turn;
}

template <class A, class B>
constexpr body_triangles make_body_triangles(const A& first, const B& second) {
  body_triangles b;
  append_body(b, first, b.fault[0]);
  b.second = static_cast<std::uint32_t>(b.triangles.size());
  append_body(b, second, b.fault[1]);
  if (b.fault[0] != surface_fault::none || b.fault[1] != surface_fault::none) return b;
  merge_bodies(b);
  b.twin.assign(3 * b.triangles.size(), no_index);
  b.fault[0] = pair_sides(b, 0, b.second);
  b.fault[1] = pair_sides(b, b.second, static_cast<std::uint32_t>(b.triangles.size()));
  return b;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
