// SPDX-License-Identifier: MIT
// How large an object is.
#pragma once

#include <cstddef>

#include <irg/geometry/box.hpp>

namespace irg {

/// What is known of an object before it is drawn: a box around all its positions, and how many triangles it has.
template <Floating T>
struct object_extent {
  box<T, 3> bounds;
  std::size_t triangles = 0;
  bool operator==(const object_extent&) const = default;
};

}  // namespace irg
