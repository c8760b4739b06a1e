// SPDX-License-Identifier: MIT
// Which of two faces is nearer at a pixel, exactly, and the face that is seen there. The depth of a face at a pixel's
// centre is that of the plane through its three corners, which are exact numbers: nothing is rounded, so that every
// method that asks here gives the same picture.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <irg/core/conversion.hpp>
#include <irg/math/float_bits.hpp>
#include <irg/math/wide_int.hpp>
#include <irg/raster/depth.hpp>
#include <irg/raster/screen_face.hpp>

namespace irg {

/// A face that covers a pixel, and its depth there as shade_triangle rounds it.
struct face_sample {
  const screen_face& face;
  float depth;
};

/// 1 where the greater depth is the nearer one, -1 where the lesser is, 0 for orders that do not ask for depths.
template <DepthOrder Order>
inline constexpr int depth_sense = Order::nearer(0.0f, 0.0f)   ? 0
                                   : Order::nearer(1.0f, 0.0f) ? 1
                                                               : -1;

inline namespace IRG_ABI {

/// 1 when face a is nearer than face b at the centre of pixel (x, y), -1 when b is, 0 where they are equally near.
/// shape   each is taken as its whole plane: neither needs to cover the pixel
/// needs   -snap_limit <= x, y < snap_limit
/// gives   0 where a face has no area, and for drawing_order, which knows no depths
/// exact   for all positions and finite depths, of any sign and size, subnormal ones included, under all floating-point
///         flags and with subnormals flushed to zero; depths that are not finite give some order
/// cost    about 40 operations on doubles where the planes are not nearly as deep as each other, else integers of 192
///         bits, and of 448 where depths differ by more than 2^37
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr int compare_depths(const screen_face& a, const screen_face& b, int x,
                                                      int y) noexcept;

/// The same of two faces that cover the pixel and whose rounded depths are at hand: these decide unless they are close.
/// needs   depths by shade_triangle, or any within 8 roundings of floats
/// exact   as above
/// cost    five comparisons of floats where depths are not negative and differ by more than 2^-20 of the greater one
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr int compare_depths(const face_sample& a, const face_sample& b, int x,
                                                      int y) noexcept;

/// Whether face a is seen before face b at pixel (x, y), where both cover it: it is nearer, or as near and of the lower
/// number. For drawing_order: it is drawn later, its number being higher.
/// shape   as compare_depths, whose cost and exactness it has; one of two faces with different numbers is always first
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr bool is_nearer(const screen_face& a, const screen_face& b, int x, int y) noexcept;
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr bool is_nearer(const face_sample& a, const face_sample& b, int x, int y) noexcept;

/// Whether face a is seen before face b where they are equally near: its number is the lower one; for drawing_order,
/// which draws it later, the higher one.
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr bool wins_tie(const screen_face& a, const screen_face& b) noexcept {
  return depth_sense<Order> == 0 ? b.number < a.number : a.number < b.number;
}

/// A depth as an integer of N words: d * 2^(149 - lowest).
/// needs   d finite, and 0 or integer_parts_of(d).place >= lowest; words enough, the last bit of which is the sign's
/// exact   always, in any mode of the processor
template <int N>
[[nodiscard]] constexpr wide_int<N> depth_as_integer(float d, int lowest) noexcept {
  const integer_parts<float> x = integer_parts_of(d);
  wide_int<N> v;
  if (x.significand == 0) return v;
  const int word = (x.place - lowest) / 64, bit = (x.place - lowest) % 64;
  v.word[word] = std::uint64_t{x.significand} << bit;
  if constexpr (N > 1)
    if (bit != 0) v.word[word + 1] = std::uint64_t{x.significand} >> (64 - bit);
  return x.negative ? -v : v;
}

/// On which side of the plane of a face a corner lies: above when in front of it, which is nearer, below when behind.
/// needs   the corner's position within snap_limit pixels of the origin
/// gives   `on` for a face without area, and for drawing_order
/// exact   as compare_depths; it is the sign of orient3d of the corners (x, y, depth)
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr side side_of_face(const screen_face& plane, const screen_vertex& corner) noexcept;

/// The number of the face that is seen in pixel (x, y): of those that cover its centre the one that is_nearer.
/// gives   nothing where none covers it
/// exact   this is the definition of the picture that every hidden-surface method draws
/// cost    every face is asked: for tests of methods that ask fewer
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] constexpr std::optional<std::uint32_t> picture_face_at(std::span<const screen_face> faces, int x,
                                                                     int y) noexcept {
  const screen_face* first = nullptr;
  for (const screen_face& f : faces)
    if (covers(f, x, y) && (first == nullptr || is_nearer<Order>(f, *first, x, y))) first = &f;
  return first == nullptr ? std::nullopt : std::optional(first->number);
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Which of two planes lies deeper at a place on the screen, exactly. A plane is given by a triangle's corners; its
// depth at p is (E0 d0 + E1 d1 + E2 d2) / A, where d are the depths of the corners, E the edge functions opposite to
// them at p and A = E0 + E1 + E2 > 0 twice the area. So the sign of a polynomial of degree 5 decides, which is written
// once and computed first in doubles with a bound of the error, then in integers of 192 bits, and of 448 where depths
// lie too far apart for that.

// The depth of a plane at some place: the mean of depths by weights that add up to `total`, which is positive.
template <class Weight, class Depth>
struct mean_depth {
  Weight weight[3], total;
  Depth depth[3];
};
// As it is at hand. Positions lie within 2^29, so edge functions, twice the areas of triangles in a square of side
// 2^30, are at most 2^60 in size.
using plane_depth_at = mean_depth<std::int64_t, float>;

// A number with the sign of the depth of a less that of b: their difference times both totals.
template <class Weight, class Depth>
IRG_INLINE constexpr auto depth_difference(const mean_depth<Weight, Depth>& a,
                                           const mean_depth<Weight, Depth>& b) noexcept {
  const auto sum = [](const mean_depth<Weight, Depth>& m) {
    return m.weight[0] * m.depth[0] + m.weight[1] * m.depth[1] + m.weight[2] * m.depth[2];
  };
  return sum(a) * b.total - sum(b) * a.total;
}

// The plane of a face at a place on the screen.
IRG_INLINE constexpr plane_depth_at plane_at(const screen_face& f, const subpixel& p) noexcept {
  const std::int64_t sign = f.coverage.flipped ? -1 : 1, total = f.coverage.double_area;
  const subpixel &a = f.v[0].position, &b = f.v[1].position, &c = f.v[2].position;
  const std::int64_t at_a = sign * twice_signed_area(p, b, c), at_b = sign * twice_signed_area(a, p, c);
  return {{at_a, at_b, total - at_a - at_b}, total, {f.v[0].depth, f.v[1].depth, f.v[2].depth}};
}

// The sign, or 0 where rounded arithmetic cannot tell.
//
// With S the value of the polynomial if all its terms were positive: a term passes at most 7 roundings (two conversions
// of integers, two products, two sums, the difference), so the result is off by less than 7u(1 + 2^-48) * S, u being
// 2^-53. The computed S is less than 8u * S too low, so that 8u times it is a bound. A processor that takes subnormal
// floats for zero makes a depth wrong by up to 2^-126; `least`, added to all sizes of depths, raises the bound by
// 2^-120 of the same weights. Nothing overflows or is subnormal: terms are 0 or from 2^-149 to 2^248. Fusing a product
// with a sum only takes roundings away.
template <class Plane>
IRG_INLINE constexpr int rounded_sign(const Plane& a, const Plane& b) noexcept {
  constexpr double factor = 0x1p-50, least = 0x1p-70;
  using rounded = mean_depth<double, double>;
  const auto magnitude = [](double x) { return x < 0 ? -x : x; };
  const auto value = [](const Plane& m) -> rounded {
    const auto number = [](std::int64_t w) { return static_cast<double>(w); };
    return {{number(m.weight[0]), number(m.weight[1]), number(m.weight[2])},
            number(m.total),
            {widened(m.depth[0]), widened(m.depth[1]), widened(m.depth[2])}};
  };
  const auto size = [&](const rounded& m, double total_sign) -> rounded {
    const auto depth = [&](int i) { return magnitude(m.depth[i]) + least; };
    return {{magnitude(m.weight[0]), magnitude(m.weight[1]), magnitude(m.weight[2])},
            total_sign * m.total,
            {depth(0), depth(1), depth(2)}};
  };
  const rounded va = value(a), vb = value(b);
  const double difference = depth_difference(va, vb);
  const double bound = factor * depth_difference(size(va, -1.0), size(vb, 1.0));  // the sign makes a sum of it
  return static_cast<int>(difference > bound) - static_cast<int>(difference < -bound);  // no branch
}

// The sign with depths as integers of N words, all multiplied by the same power of two.
template <int N, class Plane>
constexpr int integer_sign(const Plane& a, const Plane& b, int lowest) noexcept {
  const auto exact = [lowest](const Plane& m) -> mean_depth<wide_int<1>, wide_int<N>> {
    const auto depth = [lowest](float d) { return depth_as_integer<N>(d, lowest); };
    return {
        {m.weight[0], m.weight[1], m.weight[2]}, m.total, {depth(m.depth[0]), depth(m.depth[1]), depth(m.depth[2])}};
  };
  return depth_difference(exact(a), exact(b)).sign();
}

// Where depths lie within 37 powers of two of each other they are integers below 2^61, products with weights below
// 2^121, the sum of three below 2^123, and with the other total below 2^183: the difference fits in 192 bits. A float
// of any size is an integer below 2^278 times the least one, which makes the difference one below 2^401.
template <class Plane>
IRG_NOINLINE constexpr int exact_sign(const Plane& a, const Plane& b) noexcept {
  int lowest = 254, highest = 0;
  for (const Plane* m : {&a, &b})
    for (const float d : m->depth) {
      const integer_parts<float> x = integer_parts_of(d);
      if (x.significand == 0) continue;
      lowest = minimum(lowest, x.place);
      highest = maximum(highest, x.place);
    }
  return highest - lowest <= 37 ? integer_sign<1>(a, b, lowest) : integer_sign<5>(a, b, lowest);
}

// 1 where a is the greater depth, -1 where b is, 0 where they are equal.
template <class Plane>
IRG_INLINE constexpr int compare_depths_at(const Plane& a, const Plane& b) noexcept {
  const int sign = rounded_sign(a, b);
  return sign != 0 ? sign : exact_sign(a, b);
}

IRG_INLINE constexpr subpixel centre_of(int x, int y) noexcept {
  return {static_cast<std::int32_t>(std::int64_t{x} * one_pixel + half_pixel),
          static_cast<std::int32_t>(std::int64_t{y} * one_pixel + half_pixel)};
}

// Whether two depths that were rounded at a covered centre are in the order of the true ones.
//
// With u = 2^-24 and depths that are not negative, all terms of the rounded depth are positive and pass at most 8
// roundings (two of the scale, one of a rest or an edge function, two products, three sums), so both depths together
// are off by less than 16u(1 + 2^-16) of the greater one: 2^-20 of it, and the bound is a quarter more. That quarter
// is at least 2^-62 and covers what subnormal numbers lose, and processors that take them for zero: up to 2^-126 in
// each product of an edge function, below 2^53, and a gain, less than 2^-72 in all. A gain overflows only where twice
// the area is below 256: then edge functions are 0 in whole pixels, and the depth is NaN, which decides nothing.
IRG_INLINE constexpr bool rounded_depths_decide(const face_sample& a, const face_sample& b) noexcept {
  constexpr float factor = 0x1.4p-20f, least = 0x1p-40f;
  if (!(minimum(a.face.depth_low, b.face.depth_low) >= 0.0f)) return false;
  const float difference = a.depth - b.depth, largest = maximum(a.depth, b.depth);
  return largest >= least && maximum(difference, -difference) > largest * factor;
}

template <DepthOrder Order>
IRG_INLINE constexpr bool comes_first(int nearness, const screen_face& a, const screen_face& b) noexcept {
  if constexpr (depth_sense<Order> == 0)
    return wins_tie<Order>(a, b);
  else
    return nearness != 0 ? nearness > 0 : wins_tie<Order>(a, b);
}

// 1 where a is nearer at the centre of a pixel, -1 where b is, 0 where they are equally near.
template <DepthOrder Order>
IRG_INLINE constexpr int compare_planes(const screen_face& a, const screen_face& b, int x, int y) noexcept {
  if constexpr (depth_sense<Order> == 0) {
    return 0;
  } else {
    IRG_EXPECTS(-snap_limit <= x && x < snap_limit && -snap_limit <= y && y < snap_limit);
    if (a.coverage.double_area == 0 || b.coverage.double_area == 0) return 0;
    const subpixel centre = centre_of(x, y);
    return depth_sense<Order> * compare_depths_at(plane_at(a, centre), plane_at(b, centre));
  }
}
// The same, apart from code that seldom needs it.
template <DepthOrder Order>
IRG_NOINLINE constexpr int compare_close_planes(const screen_face& a, const screen_face& b, int x, int y) noexcept {
  return compare_planes<Order>(a, b, x, y);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <DepthOrder Order>
[[nodiscard]] IRG_INLINE constexpr int compare_depths(const screen_face& a, const screen_face& b, int x,
                                                      int y) noexcept {
  return detail::compare_planes<Order>(a, b, x, y);
}

template <DepthOrder Order>
[[nodiscard]] IRG_INLINE constexpr int compare_depths(const face_sample& a, const face_sample& b, int x,
                                                      int y) noexcept {
  if (!detail::rounded_depths_decide(a, b)) return detail::compare_close_planes<Order>(a.face, b.face, x, y);
  return depth_sense<Order> * (b.depth < a.depth ? 1 : -1);
}

template <DepthOrder Order>
[[nodiscard]] IRG_INLINE constexpr bool is_nearer(const screen_face& a, const screen_face& b, int x, int y) noexcept {
  return detail::comes_first<Order>(compare_depths<Order>(a, b, x, y), a, b);
}

template <DepthOrder Order>
[[nodiscard]] IRG_INLINE constexpr bool is_nearer(const face_sample& a, const face_sample& b, int x, int y) noexcept {
  if (depth_sense<Order> == 0 || !detail::rounded_depths_decide(a, b))
    return detail::comes_first<Order>(detail::compare_close_planes<Order>(a.face, b.face, x, y), a.face, b.face);
  return Order::nearer(a.depth, b.depth);
}

template <DepthOrder Order>
[[nodiscard]] IRG_INLINE constexpr side side_of_face(const screen_face& plane, const screen_vertex& corner) noexcept {
  if (plane.coverage.double_area == 0) return side::on;
  const detail::plane_depth_at here{{1, 0, 0}, 1, {corner.depth, 0.0f, 0.0f}};
  return static_cast<side>(depth_sense<Order> *
                           detail::compare_depths_at(here, detail::plane_at(plane, corner.position)));
}

}  // namespace IRG_ABI
}  // namespace irg
