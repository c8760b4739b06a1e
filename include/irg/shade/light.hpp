// SPDX-License-Identifier: MIT
// Sources of light: points that radiate equally in all directions, points at infinity (the sun), and the ambient light
// that comes from everywhere. As in material.hpp an intensity L is a colour or one number.
#pragma once

#include <span>

#include <irg/colour/pixel.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A source of light. A position of weight 0 is at infinity: x, y and z are the direction towards the source.
template <Scalar T, class L = rgb<T>>
struct light {
  hpoint<T, 3> position{T(0), T(0), T(0), T(1)};
  L intensity{};
  bool operator==(const light&) const = default;
};

/// Whether a source's intensity depends on distance: not (7.9), or as L / (r + k), with r the distance from the point
/// to the viewer and k a constant, so that of two surfaces alike the farther one is darker (7.10).
enum class distance_term { none, viewer };

/// All the light of a scene. It borrows the sources.
/// needs   k >= 0, where distance is not none
template <Scalar T, class L = rgb<T>>
struct lighting {
  L ambient{};
  std::span<const light<T, L>> lights{};
  distance_term distance = distance_term::none;
  T k = T(1);
};

inline namespace IRG_ABI {

/// The direction from p to the source, not normalised: (x, y, z) - w p, turned round where w < 0. Zero for a source
/// that stands in p itself.
/// exact   for weight 1 and weight 0 each coordinate is rounded once at most
template <class T, class L>
[[nodiscard]] IRG_INLINE constexpr vec<T, 3> direction_to_light(const light<T, L>& source,
                                                                const point<T, 3>& p) noexcept {
  const hpoint<T, 3>& s = source.position;
  const vec<T, 3> d{s.x - product(s.w, p.x), s.y - product(s.w, p.y), s.z - product(s.w, p.z)};
  return s.w < T(0) ? -d : d;
}

}  // namespace IRG_ABI
}  // namespace irg
