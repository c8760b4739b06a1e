// SPDX-License-Identifier: MIT
// Bodies as trees of operations on bodies: kept as they were said, and made a mesh on demand. csg_spans looks through
// them without any mesh being made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/solid/boolean.hpp>

namespace irg {

/// A step of a tree: a body, or an operation on two earlier steps.
struct csg_step {
  [[deprecated("irg: no_index")]] static constexpr std::uint32_t none = no_index;
  std::uint32_t body = no_index;  // of bodies; none for an operation
  boolean_operation operation{};
  std::uint32_t first = no_index, second = no_index;  // steps
  bool operator==(const csg_step&) const = default;
};

/// A tree of operations as a value.
/// shape   steps stand behind those that they use; the last one is the whole. No step: nothing
template <Floating T>
struct csg_tree {
  std::vector<mesh<T>> bodies;
  std::vector<csg_step> steps;

  IRG_APART constexpr csg_tree() {}
  /// A body by itself.
  IRG_APART constexpr explicit csg_tree(mesh<T> body) : steps{{0, {}, no_index, no_index}} {
    bodies.push_back(std::move(body));
  }
  bool operator==(const csg_tree&) const = default;
};

namespace detail::inline IRG_ABI {

// Whether what lies in the bodies b with in[b] != 0 alone is in a tree's.
template <class Steps>
constexpr bool is_in_steps(const Steps& steps, const std::vector<unsigned char>& in,
                           std::vector<unsigned char>& scratch) {
  scratch.clear();
  const auto is_in = [&](std::uint32_t s) { return s != no_index && scratch[s] != 0; };
  for (const csg_step& step : steps) {
    const bool value = step.body != no_index ? in[step.body] != 0
                                             : is_in_combination(is_in(step.first), is_in(step.second), step.operation);
    scratch.push_back(value ? 1 : 0);
  }
  return !scratch.empty() && scratch.back() != 0;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The tree of an operation on two trees.
/// cost    both are copied, or moved
template <Floating T>
[[nodiscard]] constexpr csg_tree<T> csg_boolean(csg_tree<T> first, csg_tree<T> second, boolean_operation operation) {
  const auto bodies = static_cast<std::uint32_t>(first.bodies.size());
  const auto steps = static_cast<std::uint32_t>(first.steps.size());
  for (mesh<T>& body : second.bodies) first.bodies.push_back(std::move(body));
  for (csg_step step : second.steps) {
    if (step.body != no_index) step.body += bodies;
    if (step.first != no_index) step.first += steps;
    if (step.second != no_index) step.second += steps;
    first.steps.push_back(step);
  }
  const auto last = [](std::size_t size) { return size == 0 ? no_index : static_cast<std::uint32_t>(size - 1); };
  first.steps.push_back({no_index, operation, last(steps), second.steps.empty() ? no_index : last(first.steps.size())});
  return first;
}

/// The mesh of a tree.
/// shape   faces and corners tell where they come from among the tree's bodies
/// needs   bodies as solid_boolean
/// gives   as solid_boolean; a status other than ok, and no faces, where one of the bodies that the last step uses is
///         none
/// exact   every decision, as deep as the tree may be: all bodies are cut at each other at once, and each corner is one
///         of theirs or where three of their planes meet, rounded when it is handed out and nowhere before
/// cost    as solid_boolean for all pairs of bodies whose boxes meet; a look at each body for each part of each;
///         nothing recurs
/// source  Zhou et al. 2016; Cherchi et al. 2020 (crossings of cuts as meetings of three planes)
template <Floating T>
[[nodiscard]] constexpr solid_boolean_result<T> to_mesh(const csg_tree<T>& tree) {
  if (tree.steps.empty()) return {};
  std::vector<unsigned char> is_used(tree.steps.size(), 0);
  is_used[tree.steps.size() - 1] = 1;
  const mesh<T> nothing;
  std::vector<const mesh<T>*> bodies(tree.bodies.size(), &nothing);
  for (std::size_t i = tree.steps.size(); i-- > 0;) {
    const csg_step& step = tree.steps[i];
    if (is_used[i] == 0) continue;
    if (step.body != no_index) bodies[step.body] = &tree.bodies[step.body];
    if (step.first != no_index) is_used[step.first] = 1;
    if (step.second != no_index) is_used[step.second] = 1;
  }
  std::vector<unsigned char> scratch;
  const auto is_in = [&](const std::vector<unsigned char>& in) { return detail::is_in_steps(tree.steps, in, scratch); };
  return detail::boolean_of_bodies<T>(bodies, as_function<bool(const std::vector<unsigned char>&)>(is_in));
}

IRG_RENAMED(mesh_of, to_mesh)
IRG_RENAMED(combine, csg_boolean)

}  // namespace IRG_ABI
}  // namespace irg
