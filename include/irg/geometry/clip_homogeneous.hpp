// SPDX-License-Identifier: MIT
// Clipping in clip space, before the division by w: what lies behind the eye, at the eye or at infinity is cut away
// while it still has coordinates. Sutherland and Hodgman's algorithm for convex polygons, and the same cuts for
// segments. Nothing is allocated.
//
// Two polygons that share an edge stay joined without a crack: a cut is always computed from the vertex inside to the
// vertex outside, whichever way the edge is walked, and depends on nothing but these two.
#pragma once

#include <limits>
#include <optional>

#include <irg/math/vec.hpp>

namespace irg {

/// Boundaries of the clip space, as a set. z_near and z_far are named after the reversed depth: nearest is z = w,
/// farthest z = 0; with the standard depth the two change places.
enum class clip_planes : unsigned {
  none = 0,
  z_near = 1,   // w - z >= 0
  z_far = 2,    // z >= 0
  left = 4,     // guard_x * w + x >= 0
  right = 8,    // guard_x * w - x >= 0
  bottom = 16,  // guard_y * w + y >= 0
  top = 32,     // guard_y * w - y >= 0
  depth = z_near | z_far,
  sides = left | right | bottom | top,
  all = depth | sides
};

/// The part of clip space to keep: the enabled boundaries, the sides widened by the guard factors (1 is the picture's
/// own border; a larger guard band leaves the trimming of most polygons to the rasterizer).
template <Scalar T>
struct clip_volume {
  clip_planes planes = clip_planes::all;
  T guard_x = T(1), guard_y = T(1);
  bool operator==(const clip_volume&) const = default;
};

/// A vertex in clip space with K numbers to be interpolated.
template <Scalar T, int K>
struct clip_vertex {
  hpoint<T, 3> position;
  T attributes[static_cast<std::size_t>(K)]{};
  bool operator==(const clip_vertex&) const = default;
};
template <Scalar T>
struct clip_vertex<T, 0> {
  hpoint<T, 3> position;
  bool operator==(const clip_vertex&) const = default;
};

/// A vertex type that can be clipped: it is copied, default-made, and has a member `position` in clip space.
template <class V>
concept ClipVertex = std::default_initializable<V> && requires(const V v) {
  requires HomogeneousPoint<std::remove_cvref_t<decltype(v.position)>>;
  requires std::same_as<std::remove_cvref_t<decltype(v.position)>,
                        hpoint<scalar_of<std::remove_cvref_t<decltype(v.position)>>, 3>>;
};

/// The number type of a clip vertex.
template <ClipVertex V>
using clip_scalar = scalar_of<std::remove_cvref_t<decltype(V::position)>>;

/// What is left of a polygon: vertices[0] to vertices[count - 1]. A triangle cut by six planes has at most nine.
template <ClipVertex V, int Capacity = 9>
struct clipped_polygon {
  V vertices[static_cast<std::size_t>(Capacity)]{};
  int count = 0;
  [[nodiscard]] IRG_INLINE constexpr bool empty() const noexcept { return count == 0; }
  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return static_cast<std::size_t>(count); }
  IRG_INLINE constexpr const V& operator[](std::size_t i) const noexcept { return vertices[i]; }
  [[nodiscard]] IRG_INLINE constexpr const V* begin() const noexcept { return vertices; }
  [[nodiscard]] IRG_INLINE constexpr const V* end() const noexcept { return vertices + count; }
  IRG_APART constexpr bool operator==(const clipped_polygon& o) const {
    for (int i = 0; i < count && count == o.count; ++i)
      if (!(vertices[i] == o.vertices[i])) return false;
    return count == o.count;
  }
};

/// What is left of a segment.
template <ClipVertex V>
struct clipped_segment {
  V first, second;
  bool operator==(const clipped_segment&) const = default;
};

/// Interpolates clip vertices: everything at `t` of the way from a to b. Vertex types of your own bring a callable of
/// this shape along; the clipper then sets the coordinates that the cut fixes.
struct lerp_clip_vertex {
  template <class T, int K>
  IRG_INLINE constexpr clip_vertex<T, K> operator()(const clip_vertex<T, K>& a, const clip_vertex<T, K>& b,
                                                    const T& t) const noexcept {
    const auto lerp = [&](const T& from, const T& to) IRG_INLINE_LAMBDA { return from + product(t, to - from); };
    clip_vertex<T, K> between{};
    between.position =
        generate_coordinates<hpoint<T, 3>>([&](int i) IRG_INLINE_LAMBDA { return lerp(a.position[i], b.position[i]); });
    if constexpr (K > 0)
      for (int i = 0; i < K; ++i) between.attributes[i] = lerp(a.attributes[i], b.attributes[i]);
    return between;
  }
};

inline namespace IRG_ABI {

[[nodiscard]] IRG_INLINE constexpr clip_planes operator|(clip_planes a, clip_planes b) noexcept {
  return static_cast<clip_planes>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
[[nodiscard]] IRG_INLINE constexpr clip_planes operator&(clip_planes a, clip_planes b) noexcept {
  return static_cast<clip_planes>(static_cast<unsigned>(a) & static_cast<unsigned>(b));
}
/// The planes that are not in the set.
[[nodiscard]] IRG_INLINE constexpr clip_planes operator~(clip_planes a) noexcept {
  return static_cast<clip_planes>(~static_cast<unsigned>(a) & static_cast<unsigned>(clip_planes::all));
}
/// Whether the sets have a plane in common.
[[nodiscard]] IRG_INLINE constexpr bool overlap(clip_planes a, clip_planes b) noexcept {
  return (a & b) != clip_planes::none;
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Positive inside, 0 on the plane. Its sign is exact for the depth planes and where the guard factor is 1.
template <class T>
IRG_INLINE constexpr T clip_distance(const hpoint<T, 3>& p, clip_planes plane, const clip_volume<T>& v) noexcept {
  switch (plane) {
    case clip_planes::z_near: return p.w - p.z;
    case clip_planes::z_far: return p.z;
    case clip_planes::left: return product(v.guard_x, p.w) + p.x;
    case clip_planes::right: return product(v.guard_x, p.w) - p.x;
    case clip_planes::bottom: return product(v.guard_y, p.w) + p.y;
    default: return product(v.guard_y, p.w) - p.y;
  }
}

// Whether nothing that is computed from p overflows; false for NaN.
template <class T>
IRG_INLINE constexpr bool can_clip(const hpoint<T, 3>& p, const clip_volume<T>& v) noexcept {
  if constexpr (Floating<T>) {
    constexpr T limit = (std::numeric_limits<T>::max)() / 8;
    const auto fits = [](T x) { return -limit <= x && x <= limit; };
    return fits(p.x) && fits(p.y) && fits(p.z) && fits(p.w) && fits(product(v.guard_x, p.w)) &&
           fits(product(v.guard_y, p.w));
  } else {
    return true;
  }
}

template <class T>
IRG_INLINE constexpr bool is_no_position(const hpoint<T, 3>& p) noexcept {
  return p.w == T(0) && p.x == T(0) && p.y == T(0) && p.z == T(0);
}

// One coordinate of a cut: the bound itself where it was cut there, else moved back within the bounds that hold.
template <class T>
IRG_INLINE constexpr T confine(const T& x, const T& low, const T& high, clip_planes low_plane, clip_planes high_plane,
                               clip_planes cut_at, clip_planes held) noexcept {
  if (cut_at == low_plane) return low;
  if (cut_at == high_plane) return high;
  if (overlap(held, low_plane) && x < low) return low;
  if (overlap(held, high_plane) && high < x) return high;
  return x;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The enabled planes that p lies outside of. A polygon is all inside when the union of its vertices' codes is empty,
/// and all outside when their intersection is not.
/// gives   every enabled plane whose test meets a NaN
/// exact   for the depth planes and guard factors of 1; otherwise guard * w is rounded once
template <class T>
[[nodiscard]] constexpr clip_planes clip_code(const hpoint<T, 3>& p, const clip_volume<T>& volume = {}) noexcept {
  const auto outside = [&](clip_planes plane) {
    const T d = detail::clip_distance(p, plane, volume);
    return T(0) < d || d == T(0) ? clip_planes::none : plane;
  };
  return volume.planes & (outside(clip_planes::z_near) | outside(clip_planes::z_far) | outside(clip_planes::left) |
                          outside(clip_planes::right) | outside(clip_planes::bottom) | outside(clip_planes::top));
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Where the edge from a vertex inside (or on the plane) to one outside meets the plane. Rounding may leave the point
// beside the plane, or beyond planes that both ends lie inside of; it is moved back, so that clipping again changes
// nothing. Both polygons at the edge do the same, for nothing but the edge decides.
template <class V, class F>
constexpr V cut_edge(const V& inside, const V& outside, clip_planes plane, const clip_volume<clip_scalar<V>>& v,
                     const F& interpolate) {
  using T = clip_scalar<V>;
  const T d = clip_distance(inside.position, plane, v);
  if (d == T(0)) return inside;
  V meeting = interpolate(inside, outside, d / (d - clip_distance(outside.position, plane, v)));
  const clip_planes held = v.planes & ~(clip_code(inside.position, v) | clip_code(outside.position, v));
  hpoint<T, 3>& p = meeting.position;
  for (const clip_planes pair :
       {clip_planes::depth, clip_planes::left | clip_planes::right, clip_planes::bottom | clip_planes::top})
    if (overlap(pair, plane) && overlap(pair, held) && p.w < T(0))
      p.w = T(0);  // on one plane, inside the other: w >= 0
  const T x_high = product(v.guard_x, p.w), y_high = product(v.guard_y, p.w);
  p.x = confine(p.x, T(0) - x_high, x_high, clip_planes::left, clip_planes::right, plane, held);
  p.y = confine(p.y, T(0) - y_high, y_high, clip_planes::bottom, clip_planes::top, plane, held);
  p.z = confine(p.z, T(0), p.w, clip_planes::z_far, clip_planes::z_near, plane, held);
  return meeting;
}

// Polygons that are not convex could outgrow the capacity; what does not fit is left out.
template <class V, int C>
IRG_INLINE constexpr void append(clipped_polygon<V, C>& polygon, const V& vertex) {
  if (polygon.count < C) polygon.vertices[polygon.count++] = vertex;
}

template <class V, int C, class F>
constexpr clipped_polygon<V, C> cut_polygon(const clipped_polygon<V, C>& polygon, clip_planes plane,
                                            const clip_volume<clip_scalar<V>>& v, const F& interpolate) {
  using T = clip_scalar<V>;
  clipped_polygon<V, C> kept{};
  for (int i = 0; i < polygon.count; ++i) {
    const V& from = polygon.vertices[i];
    const V& to = polygon.vertices[i + 1 < polygon.count ? i + 1 : 0];
    const T d_from = clip_distance(from.position, plane, v), d_to = clip_distance(to.position, plane, v);
    if (!(d_from < T(0))) append(kept, from);
    if (d_from < T(0) && T(0) < d_to) append(kept, cut_edge(to, from, plane, v, interpolate));
    if (T(0) < d_from && d_to < T(0)) append(kept, cut_edge(from, to, plane, v, interpolate));
  }
  return kept;
}

template <int C, class V, class F>
constexpr clipped_polygon<V, C> clip_polygon(const V* vertices, int count, const clip_volume<clip_scalar<V>>& v,
                                             const F& interpolate) {
  clipped_polygon<V, C> kept{};
  clip_planes outside_any = clip_planes::none, outside_all = clip_planes::all;
  for (int i = 0; i < count; ++i) {
    if (!can_clip(vertices[i].position, v)) return clipped_polygon<V, C>{};
    const clip_planes code = clip_code(vertices[i].position, v);
    outside_any = outside_any | code;
    outside_all = outside_all & code;
    append(kept, vertices[i]);
  }
  if (outside_all != clip_planes::none) return clipped_polygon<V, C>{};
  for (unsigned bit = 1; bit <= static_cast<unsigned>(clip_planes::top); bit *= 2)
    if (const clip_planes plane{bit}; overlap(outside_any, plane)) kept = cut_polygon(kept, plane, v, interpolate);
  const int cut = kept.count;
  kept.count = 0;
  for (int i = 0; i < cut; ++i)
    if (!is_no_position(kept.vertices[i].position)) append(kept, V(kept.vertices[i]));
  if (kept.count < 3) kept.count = 0;
  return kept;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The part of a convex polygon that lies in the clip volume.
/// shape   vertices in either winding, which is kept, as is the first vertex when it is inside; points on a plane are
///         inside and are not doubled. `interpolate(a, b, t)` makes a vertex between two, lerp_clip_vertex as default
/// needs   guard factors > 0; a convex polygon (others come out with seams along the boundary, and lose vertices when
///         they outgrow the capacity)
/// gives   an empty polygon when nothing or no area is left, and when a coordinate is NaN, infinite or larger than an
///         eighth of the largest number. With both depth planes every w >= 0; with all planes every w > 0. Vertices
///         0, 0, 0, 0 stand for no position and are left out; without the sides, points at infinity (w = 0) may stay
/// exact   in rationals. In floats clip_code decides which vertices are inside. A cut's coordinate at its plane is
///         exact; every coordinate is within 16u * guard * the polygon's largest coordinate of what the interpolated
///         attributes say (found: 7u; where that underflows, 2 * guard of the smallest numbers). Clipping again changes
///         no bit; polygons that share an edge get the same bits on it
/// cost    a polygon all inside or all outside costs its codes; each plane that cuts costs one pass
/// source  Sutherland and Hodgman 1974; Blinn and Newell 1978
template <ClipVertex V, std::size_t N, class F = lerp_clip_vertex>
[[nodiscard]] constexpr clipped_polygon<V, static_cast<int>(N) + 6> clip_homogeneous(
    const V (&polygon)[N], const clip_volume<std::type_identity_t<clip_scalar<V>>>& volume = {},
    const F& interpolate = {}) noexcept(noexcept(interpolate(polygon[0], polygon[0], volume.guard_x))) {
  return detail::clip_polygon<static_cast<int>(N) + 6>(polygon, static_cast<int>(N), volume, interpolate);
}

/// As above, for what an earlier clip has left.
template <ClipVertex V, int N, class F = lerp_clip_vertex>
[[nodiscard]] constexpr clipped_polygon<V, N + 6> clip_homogeneous(
    const clipped_polygon<V, N>& polygon, const clip_volume<std::type_identity_t<clip_scalar<V>>>& volume = {},
    const F& interpolate = {}) noexcept(noexcept(interpolate(polygon[0], polygon[0], volume.guard_x))) {
  return detail::clip_polygon<N + 6>(polygon.vertices, polygon.count, volume, interpolate);
}

/// The part of a segment that lies in the clip volume, from `first` to `second`; the same points as on the edge of a
/// polygon.
/// gives   nothing when no point is left, when an end is 0, 0, 0, 0 or cannot be clipped (see clip_homogeneous); a
///         segment that touches the volume in one point gives this point twice
/// exact   as clip_homogeneous; swapping the ends swaps the result
template <ClipVertex V, class F = lerp_clip_vertex>
[[nodiscard]] constexpr std::optional<clipped_segment<V>> clip_segment_homogeneous(
    const V& first, const V& second, const clip_volume<std::type_identity_t<clip_scalar<V>>>& volume = {},
    const F& interpolate = {}) noexcept(noexcept(interpolate(first, second, volume.guard_x))) {
  clipped_segment<V> kept{first, second};
  if (!detail::can_clip(first.position, volume) || !detail::can_clip(second.position, volume)) return std::nullopt;
  const clip_planes outside = clip_code(first.position, volume) | clip_code(second.position, volume);
  for (unsigned bit = 1; bit <= static_cast<unsigned>(clip_planes::top); bit *= 2) {
    const clip_planes plane{bit};
    if (!overlap(outside, plane)) continue;
    const bool first_out = detail::clip_distance(kept.first.position, plane, volume) < clip_scalar<V>(0);
    const bool second_out = detail::clip_distance(kept.second.position, plane, volume) < clip_scalar<V>(0);
    if (first_out && second_out) return std::nullopt;
    if (first_out) kept.first = detail::cut_edge(kept.second, kept.first, plane, volume, interpolate);
    if (second_out) kept.second = detail::cut_edge(kept.first, kept.second, plane, volume, interpolate);
  }
  if (detail::is_no_position(kept.first.position) || detail::is_no_position(kept.second.position)) return std::nullopt;
  return kept;
}

}  // namespace IRG_ABI
}  // namespace irg
