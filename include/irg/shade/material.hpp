// SPDX-License-Identifier: MIT
// What a surface does with light. An intensity L is either a colour, rgb<T>, or one number T: the single channel that
// the textbook computes with, on a scale of 0 to 255 or any other.
#pragma once

#include <irg/colour/pixel.hpp>

namespace irg {

/// The share of the light that a surface reflects in each of the three ways of Phong's model, 0 to 1 per channel.
/// needs   shininess > 0; the larger, the smaller and sharper the highlight
/// source  Phong 1975
template <class T, class L = rgb<T>>
struct material {
  L ambient{};
  L diffuse{};
  L specular{};
  T shininess = T(1);
  bool operator==(const material&) const = default;
};

}  // namespace irg
