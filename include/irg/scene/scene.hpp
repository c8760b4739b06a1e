// SPDX-License-Identifier: MIT
// scene<T>: objects, lights and a camera. The one thing every rendering method draws from.
#pragma once

#include <vector>

#include <irg/math/mat.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/scene/camera.hpp>
#include <irg/shade/light.hpp>
#include <irg/shade/material.hpp>

namespace irg {

/// A body in the world: its shape, where it stands, and what it is made of.
template <Floating T>
struct object {
  mesh<T> shape;
  mat<T, 4, 4> placement = identity_matrix<T, 4>();
  material<T> surface{{T(1), T(1), T(1)}, {T(1), T(1), T(1)}, {}, T(1)};
  bool operator==(const object&) const = default;
};

/// Everything a picture needs.
template <Floating T>
struct scene {
  std::vector<object<T>> objects;
  camera<T> view;
  std::vector<light<T>> lights;
  rgb<T> ambient{};
  distance_term distance = distance_term::none;  // whether lights weaken with the distance from the eye, by 1 / (r + k)
  T k = T(1);
  bool operator==(const scene&) const = default;
};

}  // namespace irg
