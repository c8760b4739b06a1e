// SPDX-License-Identifier: MIT
// The light at the vertices of a body, a register of them at a time.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/interleaved_lanes.hpp>
#include <irg/render/drawable.hpp>
#include <irg/shade/phong_lanes.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

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
}  // namespace detail
}  // namespace irg
