// SPDX-License-Identifier: MIT
// Four triangles side by side, and which of them a ray may cross.
#pragma once

#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/spatial/cross_triangle.hpp>

namespace irg::detail {

template <Floating T>
struct triangle_block {
  static constexpr int width = 4;
  T v[3][3][width];  // corner, axis, triangle
};

inline namespace IRG_ABI {

template <class F, class T>
IRG_INLINE constexpr F load_widened(const T* p) noexcept {
  using floats = typename lanes<F>::template rebind<T>;
  return converted<double>(lanes<floats>::load(p));
}

/// A bit for each triangle that is not certainly passed by; the sides of these into `sides`.
template <class F, class T>
IRG_INLINE constexpr unsigned meet_triangles(const triangle_block<T>& block, const ray_shear& s, double bound,
                                             double (&sides)[3][triangle_block<T>::width]) noexcept {
  unsigned bits = 0;
  const auto all = [](double x) { return lanes<F>::broadcast(x); };
  const F ox = all(s.origin[0]), oy = all(s.origin[1]), oz = all(s.origin[2]);
  const F above = all(bound), below = all(-bound);
  for (int k = 0; k < triangle_block<T>::width; k += lanes<F>::count) {
    const auto& v = block.v;
    const F corner[3][3] = {
        {load_widened<F>(v[0][s.x] + k), load_widened<F>(v[0][s.y] + k), load_widened<F>(v[0][s.z] + k)},
        {load_widened<F>(v[1][s.x] + k), load_widened<F>(v[1][s.y] + k), load_widened<F>(v[1][s.z] + k)},
        {load_widened<F>(v[2][s.x] + k), load_widened<F>(v[2][s.y] + k), load_widened<F>(v[2][s.z] + k)}};
    const sheared_sides<F> t = sides_round<F>(s, ox, oy, oz, corner);
    // Of a NaN, which is on no side, the others decide.
    const F least = low_of(t.ab, low_of(t.bc, t.ca)), most = high_of(t.ab, high_of(t.bc, t.ca));
    constexpr unsigned full = (1u << lanes<F>::count) - 1;
    const unsigned passed = static_cast<unsigned>(mask_bits(both(least < below, above < most)));
    bits |= (full & ~passed) << k;
    lanes<F>::store(sides[0] + k, t.bc);
    lanes<F>::store(sides[1] + k, t.ca);
    lanes<F>::store(sides[2] + k, t.ab);
  }
  return bits;
}

template <class T>
IRG_INLINE constexpr unsigned triangles_met(const triangle_block<T>& block, const ray_shear& s, double bound,
                                            double (&sides)[3][triangle_block<T>::width]) noexcept {
  if (!has_lanes || std::is_constant_evaluated()) return meet_triangles<double>(block, s, bound, sides);
  return meet_triangles<pack<double, native_lanes<double>>>(block, s, bound, sides);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
