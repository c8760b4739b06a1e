// SPDX-License-Identifier: MIT
// Four triangles side by side, and which of them a ray may cross.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/spatial/bvh_node.hpp>
#include <irg/spatial/cross_triangle.hpp>

namespace irg::detail {

inline namespace IRG_ABI {

template <class F, class T>
IRG_INLINE constexpr F load_widened(const T* p) noexcept {
  using floats = typename lanes<F>::template rebind<T>;
  return converted<double>(lanes<floats>::load(p));
}

// Which triangles are certainly passed by: those with sides beyond the bound that turn both ways. Of a NaN, which is
// on no side, the others decide.
template <class F>
IRG_INLINE constexpr auto are_passed(const sheared_sides<F>& t, const F& bound) noexcept {
  const F least = minimum(t.ab, minimum(t.bc, t.ca)), most = maximum(t.ab, maximum(t.bc, t.ca));
  return both(least < -bound, bound < most);
}

/// A bit for each triangle that is not certainly passed by.
template <class F, class T>
IRG_INLINE constexpr unsigned meet_triangles(const triangle_block<T>& block, const ray_shear& s,
                                             double bound) noexcept {
  unsigned bits = 0;
  const auto all = [](double x) { return lanes<F>::broadcast(x); };
  const F origin[3] = {all(s.origin[0]), all(s.origin[1]), all(s.origin[2])};
  for (int k = 0; k < triangle_block<T>::width; k += lanes<F>::count) {
    const auto at = [&](int corner, int axis) { return load_widened<F>(block.v[corner][axis] + k); };
    const F corner[3][3] = {{at(0, s.x), at(0, s.y), at(0, s.z)},
                            {at(1, s.x), at(1, s.y), at(1, s.z)},
                            {at(2, s.x), at(2, s.y), at(2, s.z)}};
    const auto t = sides_of(corners_along<F>(origin, all(s.slope_x), all(s.slope_y), corner));
    constexpr unsigned full = (1u << lanes<F>::count) - 1;
    bits |= (full & ~static_cast<unsigned>(mask_bits(are_passed(t, all(bound))))) << k;
  }
  return bits;
}

template <class T>
IRG_INLINE constexpr unsigned triangles_met(const triangle_block<T>& block, const ray_shear& s, double bound) noexcept {
  if (!has_lanes || std::is_constant_evaluated()) return meet_triangles<double>(block, s, bound);
  return meet_triangles<pack<double, native_lanes<double>>>(block, s, bound);
}

// A ray as triangles of floats are seen from it, in floats. With u = 2^-24 and m the largest coordinate of a corner
// seen from the origin, x and y are off by h = 6.01u m, as in ray_shear. With S the largest of a triangle's x and y, at
// most 2m, sides are off by 4 S h + 2 h^2 and their roundings, 4u S^2: less than 33u m S + 73u^2 m^2. 4 e (S + e) is
// asked, e being 16u m, which leaves room for what is subnormal, too.
//
// With z counted from where the ray begins and W the largest of these, of at most 2m, the sum of sides times the
// opposite corners' z has the sign of the crossing's z times that of the sides. z is off by 4u m, so the sum by 3 W
// times what sides are off by, by 24u m S^2 and by roundings of 18u S^2 W: less than (4 W + S) times what is asked of
// sides. Its terms are of the third degree: m is below 2^40, so that none overflows, and what underflows is less than
// 2^-120.
struct float_shear {
  float origin[3], slope_x, slope_y;
  float start, along;  // where the ray begins along z, or less; 1 or -1 as it goes
  float error;  // e; 0 where floats tell nothing: numbers are not of middling size
  int x, y, z;
};

// Whether triangles are passed by in floats where rays are floats, too.
IRG_INLINE constexpr bool sees_in_floats() noexcept { return has_lanes && !std::is_constant_evaluated(); }

/// needs   m, which is not less than any coordinate in the tree seen from the origin
IRG_INLINE void set_float_shear(float_shear& s, const ray<float, 3>& r, double m) noexcept {
  const vec<float, 3>& d = r.direction;
  s.z = magnitude(d[1]) > magnitude(d[0]) ? 1 : 0;
  if (magnitude(d[2]) > magnitude(d[s.z])) s.z = 2;
  s.x = s.z == 2 ? 0 : s.z + 1;
  s.y = s.z == 0 ? 2 : s.z - 1;
  const float dz = d[s.z];
  s.origin[0] = r.origin[s.x];
  s.origin[1] = r.origin[s.y];
  s.origin[2] = r.origin[s.z];
  const bool middling = 0x1p-40 < m && m < 0x1p40 && magnitude(dz) >= 0x1p-60f;
  s.error = middling ? converted<float>(m * (0x1p-20 * (1 + 0x1p-20))) : 0.0f;
  if (!middling) return;
  s.slope_x = d[s.x] / dz;
  s.slope_y = d[s.y] / dz;
  s.along = dz < 0 ? -1.0f : 1.0f;
  s.start = minimum(maximum(r.low, 0.0f) * magnitude(dz), converted<float>(m)) * s.along;
}

// A bit for each triangle that the ray is neither certainly past nor certainly behind: it would cross it before its
// beginning. at(corner, axis) gives coordinates.
template <class F, class At>
IRG_INLINE unsigned triangles_ahead(const float_shear& s, const At& at) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  const F origin[3] = {all(s.origin[0]), all(s.origin[1]), all(s.origin[2])};
  const F corner[3][3] = {
      {at(0, s.x), at(0, s.y), at(0, s.z)}, {at(1, s.x), at(1, s.y), at(1, s.z)}, {at(2, s.x), at(2, s.y), at(2, s.z)}};
  const sheared_corners<F> c = corners_along<F>(origin, all(s.slope_x), all(s.slope_y), corner);
  const sheared_sides<F> t = sides_of(c);
  const auto largest = [](const F& a, const F& b, const F& d) {
    return maximum(magnitude(a), maximum(magnitude(b), magnitude(d)));
  };
  const F size = maximum(largest(c.x[0], c.x[1], c.x[2]), largest(c.y[0], c.y[1], c.y[2]));
  const F bound = (size + all(s.error)) * all(4 * s.error);
  const F start = all(s.start), za = c.z[0] - start, zb = c.z[1] - start, zc = c.z[2] - start;
  const F ahead = (t.bc * za + t.ca * zb + t.ab * zc) * all(s.along);
  const F ahead_bound = bound * (largest(za, zb, zc) * all(4.0f) + size) + all(0x1p-120f);
  const auto negative = minimum(t.ab, minimum(t.bc, t.ca)) < -bound;
  const auto positive = bound < maximum(t.ab, maximum(t.bc, t.ca));
  const auto passed = both(negative, positive | (ahead_bound < ahead)) | both(positive, ahead < -ahead_bound);
  constexpr unsigned full = (1u << lanes<F>::count) - 1;
  return full & ~static_cast<unsigned>(mask_bits(passed));
}

// The same for the triangles of a leaf: a bit for each of up to eight.
IRG_INLINE unsigned leaf_ahead(const triangle_block<float>* blocks, std::uint32_t leaf, const float_shear& s) noexcept {
  using half = pack<float, triangle_block<float>::width>;
  const std::uint32_t count = bvh_node::count_of(leaf);
  const auto* const first = blocks + bvh_node::number_of(leaf);
  const auto* const second = first + (count > bvh_node::block ? 1 : 0);
  const auto at = [&s](const triangle_block<float>& block) {
    return triangles_ahead<half>(s, [&](int c, int axis) { return lanes<half>::load(block.v[c][axis]); });
  };
  unsigned bits = 0;
  if constexpr (native_lanes<float> >= 8)
    bits = triangles_ahead<pack<float, 8>>(s, [&](int c, int axis) {
      return join_halves<float, 8>(lanes<half>::load(first->v[c][axis]), lanes<half>::load(second->v[c][axis]));
    });
  else
    bits = at(*first) | (count > bvh_node::block ? at(*second) << bvh_node::block : 0u);
  return bits & ((1u << count) - 1);
}

// The rays of a packet as triangles are seen from them, in floats and along one axis for all. With u = 2^-24 and m the
// largest coordinate of an origin or a corner: corners are off by u m, and seen from the origin by 2u m, slopes, of at
// most 2, by u of themselves, x and y by less than 13u m, of 32u m that `error` is. Sides of corners no farther than S
// from the ray, which is 3.1 m at most, are off by less than 65u m S + 400 u^2 m^2; 4 error (S + error) is asked.
struct packet_shear {
  static constexpr int size = 16;
  float origin[3][size], slope_x[size], slope_y[size];
  float error;  // 0 where rays do not go along one axis, and where squares of m are beyond floats: nothing is told then
  int x, y, z;
};

IRG_INLINE void set_packet_shear(packet_shear& s, double scale, const ray<float, 3>* rays) noexcept {
  const vec<float, 3>& first = rays[0].direction;
  s.z = magnitude(first[1]) > magnitude(first[0]) ? 1 : 0;
  if (magnitude(first[2]) > magnitude(first[s.z])) s.z = 2;
  s.x = s.z == 2 ? 0 : s.z + 1;
  s.y = s.z == 0 ? 2 : s.z - 1;
  float steepest = 0, most = 0;
  for (int k = 0; k < packet_shear::size; ++k) {
    const ray<float, 3>& r = rays[k];
    s.slope_x[k] = r.direction[s.x] / r.direction[s.z];
    s.slope_y[k] = r.direction[s.y] / r.direction[s.z];
    steepest = maximum(maximum(magnitude(s.slope_x[k]), magnitude(s.slope_y[k])), steepest);
    const int axes[3] = {s.x, s.y, s.z};
    for (int i = 0; i < 3; ++i) {
      s.origin[i][k] = r.origin[axes[i]];
      most = maximum(most, magnitude(s.origin[i][k]));
    }
  }
  const double m = (widened(most) + 1 / scale) * (1 + 0x1p-20);
  s.error = steepest <= 2.0f && 0x1p-40 < m && m < 0x1p60 ? converted<float>(m * 0x1p-19) : 0.0f;
}

// A bit for each ray that is not certainly past triangle k of a block.
template <class F, class T>
IRG_INLINE unsigned rays_at_triangle(const packet_shear& s, const triangle_block<T>& block, std::size_t k) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  const auto at = [&](int c, int axis) { return all(converted<float>(block.v[c][axis][k])); };
  const F corner[3][3] = {
      {at(0, s.x), at(0, s.y), at(0, s.z)}, {at(1, s.x), at(1, s.y), at(1, s.z)}, {at(2, s.x), at(2, s.y), at(2, s.z)}};
  unsigned bits = 0;
  for (int i = 0; i < packet_shear::size; i += lanes<F>::count) {
    const auto load = [i](const float* p) { return lanes<F>::load(p + i); };
    const F origin[3] = {load(s.origin[0]), load(s.origin[1]), load(s.origin[2])};
    const sheared_corners<F> c = corners_along<F>(origin, load(s.slope_x), load(s.slope_y), corner);
    const F x = maximum(magnitude(c.x[0]), maximum(magnitude(c.x[1]), magnitude(c.x[2])));
    const F y = maximum(magnitude(c.y[0]), maximum(magnitude(c.y[1]), magnitude(c.y[2])));
    const F bound = (maximum(x, y) + all(s.error)) * all(4 * s.error);
    constexpr unsigned full = (1u << lanes<F>::count) - 1;
    bits |= (full & ~static_cast<unsigned>(mask_bits(are_passed(sides_of(c), bound)))) << i;
  }
  return bits;
}

// No coordinate of a corner in the tree, seen from the origin, is larger.
IRG_INLINE constexpr double reach_of(const bvh& tree, const space_point& origin) noexcept {
  constexpr double slack = 1 + 0x1p-50;
  double most = 0;
  for (int i = 0; i < 3; ++i) most = maximum(most, magnitude(origin[i]));
  return (most + 1 / tree.scale) * slack;
}

IRG_INLINE constexpr double bound_of(const bvh& tree, const space_point& origin) noexcept {
  constexpr double largest = 0x1p250;
  const double m = reach_of(tree, origin);
  return m < largest ? side_bound(m) : std::numeric_limits<double>::infinity();
}

// A bit for each triangle of a leaf that is not certainly passed by.
template <class T>
IRG_INLINE constexpr unsigned leaf_met(std::span<const triangle_block<T>> blocks, std::uint32_t leaf,
                                       const ray_shear& s, double bound) noexcept {
  constexpr std::uint32_t width = bvh_node::block;
  const std::uint32_t count = bvh_node::count_of(leaf), block = bvh_node::number_of(leaf);
  unsigned bits = triangles_met(blocks[block], s, bound);
  if (count > width) bits |= triangles_met(blocks[block + 1], s, bound) << width;
  return bits & ((1u << count) - 1);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
