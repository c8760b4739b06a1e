// SPDX-License-Identifier: MIT
// Bodies as trees of operations on bodies: kept as they were said, made a mesh on demand, or looked through along
// upright lines without any mesh being made.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/solid/boolean.hpp>
#include <irg/solid/point_in_solid.hpp>

namespace irg {

/// A step of a tree: a body, or an operation on two earlier steps.
struct csg_step {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t body = none;  // of bodies; none for an operation
  boolean_operation operation{};
  std::uint32_t first = none, second = none;  // steps
};

/// A tree of operations as a value.
/// shape   steps stand behind those that they use; the last one is the whole. No step: nothing
template <Floating T>
struct csg_tree {
  std::vector<mesh<T>> bodies;
  std::vector<csg_step> steps;

  constexpr csg_tree() {}
  /// A body by itself.
  constexpr explicit csg_tree(mesh<T> body) : steps{{0, {}, csg_step::none, csg_step::none}} {
    bodies.push_back(std::move(body));
  }
};

/// A stretch of a line that lies inside of a body.
template <Floating T>
struct solid_span {
  T from{}, to{};
  constexpr bool operator==(const solid_span&) const = default;
};

namespace detail {
inline namespace IRG_ABI {

// Where the upright line at (x, y), moved by infinitely little, goes through a body's surface: heights, and 1 where it
// comes in.
template <Floating T>
constexpr std::vector<std::pair<double, int>> upright_crossings(const mesh<T>& body, T x, T y) {
  std::vector<std::pair<double, int>> found;
  const point<T, 3> p{x, y, T(0)};
  each_solid_triangle(triangulate(body), [&](const auto& a, const auto& b, const auto& c) {
    const int ab = orientation_along(a, b, p, 2), bc = orientation_along(b, c, p, 2),
              ca = orientation_along(c, a, p, 2);
    const bool none_right = ab >= 0 && bc >= 0 && ca >= 0, none_left = ab <= 0 && bc <= 0 && ca <= 0;
    if (none_right == none_left) return;
    const int turn = none_right ? 1 : -1;
    if (orientation_of_moved(a, b, ab) != turn || orientation_of_moved(b, c, bc) != turn ||
        orientation_of_moved(c, a, ca) != turn)
      return;
    const auto wide = [](const auto& q) { return point<double, 3>{widened(q.x), widened(q.y), widened(q.z)}; };
    const double px = widened(x), py = widened(y);
    const auto meeting =
        intersect_plane_line(wide(a), wide(b), wide(c), point<double, 3>{px, py, 0.0}, point<double, 3>{px, py, 1.0});
    found.push_back({meeting.at.z, -turn});
  });
  std::sort(found.begin(), found.end());
  return found;
}

// The heights at which the line comes into a body and leaves it.
template <Floating T>
constexpr std::vector<T> upright_ends(const mesh<T>& body, T x, T y) {
  std::vector<T> ends;
  int winding = 0;
  for (const auto& [height, change] : upright_crossings(body, x, y)) {
    const T at = converted<T>(height);
    const bool was_in = winding != 0, is_in = (winding += change) != 0;
    if (was_in == is_in) continue;
    if (!ends.empty() && ends.back() == at)
      ends.pop_back();
    else
      ends.push_back(at);
  }
  return ends;
}

// The ends of stretches where a combination of two sets of stretches is, from theirs.
template <Floating T>
constexpr std::vector<T> combine_ends(const std::vector<T>& a, const std::vector<T>& b, boolean_operation operation) {
  std::vector<T> ends;
  for (std::size_t i = 0, k = 0; i < a.size() || k < b.size();) {
    const T at = k == b.size() || (i < a.size() && a[i] <= b[k]) ? a[i] : b[k];
    while (i < a.size() && a[i] == at) ++i;
    while (k < b.size() && b[k] == at) ++k;
    if (is_in_combination(i % 2 == 1, k % 2 == 1, operation) != (ends.size() % 2 == 1)) ends.push_back(at);
  }
  return ends;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The tree of an operation on two trees.
/// cost    both are copied, or moved
template <Floating T>
[[nodiscard]] constexpr csg_tree<T> combine(csg_tree<T> first, csg_tree<T> second, boolean_operation operation) {
  const auto bodies = static_cast<std::uint32_t>(first.bodies.size());
  const auto steps = static_cast<std::uint32_t>(first.steps.size());
  for (mesh<T>& body : second.bodies) first.bodies.push_back(std::move(body));
  for (csg_step step : second.steps) {
    if (step.body != csg_step::none) step.body += bodies;
    if (step.first != csg_step::none) step.first += steps;
    if (step.second != csg_step::none) step.second += steps;
    first.steps.push_back(step);
  }
  const auto last = [](std::size_t size) { return size == 0 ? csg_step::none : static_cast<std::uint32_t>(size - 1); };
  first.steps.push_back(
      {csg_step::none, operation, last(steps), second.steps.empty() ? csg_step::none : last(first.steps.size())});
  return first;
}

/// The mesh of a tree.
/// shape   faces and corners tell where they come from among the tree's bodies
/// needs   bodies as solid_boolean
/// gives   as solid_boolean; a status other than done, and no faces, where one of the bodies that the last step uses is
///         none
/// exact   every decision, as deep as the tree may be: all bodies are cut at each other at once, and each corner is one
///         of theirs or where three of their planes meet, rounded when it is handed out and nowhere before
/// cost    as solid_boolean for all pairs of bodies whose boxes meet; a look at each body for each part of each; nothing
///         recurs
/// source  Zhou et al. 2016; Cherchi et al. 2020 (crossings of cuts as meetings of three planes)
template <Floating T>
[[nodiscard]] constexpr solid_boolean_result<T> mesh_of(const csg_tree<T>& tree) {
  if (tree.steps.empty()) return {};
  std::vector<unsigned char> is_used(tree.steps.size(), 0);
  is_used.back() = 1;
  const mesh<T> nothing;
  std::vector<const mesh<T>*> bodies(tree.bodies.size(), &nothing);
  for (std::size_t i = tree.steps.size(); i-- > 0;) {
    const csg_step& step = tree.steps[i];
    if (is_used[i] == 0) continue;
    if (step.body != csg_step::none) bodies[step.body] = &tree.bodies[step.body];
    if (step.first != csg_step::none) is_used[step.first] = 1;
    if (step.second != csg_step::none) is_used[step.second] = 1;
  }
  std::vector<unsigned char> is_in(tree.steps.size(), 0);
  return detail::combine_bodies<T>(bodies, [&](const std::vector<unsigned char>& in) {
    const auto value = [&](std::uint32_t s) { return s != csg_step::none && is_in[s] != 0; };
    for (std::size_t i = 0; i < tree.steps.size(); ++i) {
      const csg_step& step = tree.steps[i];
      is_in[i] = step.body != csg_step::none
                     ? in[step.body]
                     : detail::is_in_combination(value(step.first), value(step.second), step.operation);
    }
    return is_in.back() != 0;
  });
}

/// The stretches of the upright line at (x, y) that lie inside of a tree's body, from below.
/// shape   each ends before the next begins
/// needs   bodies as solid_boolean, finite numbers
/// gives   what the line moved by infinitely little along x, and infinitely less along y, goes through, so that sides
///         and corners are no special case
/// exact   which faces are met; heights within 1 ulp, and what lies between two faces nearer than that may be missing
/// cost    linear in the bodies' faces for each line; to look along another direction, turn the bodies
/// source  Hoffmann 1989; Edelsbrunner and Muecke 1990 (the move)
template <Floating T>
[[nodiscard]] constexpr std::vector<solid_span<T>> spans_upward(const csg_tree<T>& tree, T x, T y) {
  std::vector<std::vector<T>> ends(tree.steps.size(), std::vector<T>{});
  const std::vector<T> nothing;
  for (std::size_t i = 0; i < tree.steps.size(); ++i) {
    const csg_step& step = tree.steps[i];
    const std::vector<T>& first = step.first == csg_step::none ? nothing : ends[step.first];
    const std::vector<T>& second = step.second == csg_step::none ? nothing : ends[step.second];
    if (step.body != csg_step::none)
      ends[i] = detail::upright_ends(tree.bodies[step.body], x, y);
    else
      ends[i] = detail::combine_ends(first, second, step.operation);
  }
  std::vector<solid_span<T>> spans;
  for (std::size_t i = 0; !ends.empty() && i + 1 < ends.back().size(); i += 2)
    spans.push_back({ends.back()[i], ends.back()[i + 1]});
  return spans;
}

}  // namespace IRG_ABI
}  // namespace irg
