// SPDX-License-Identifier: MIT
// Which of two planes lies deeper at a place on the screen, exactly. A plane is given by a triangle's corners; its
// depth at p is (E0 d0 + E1 d1 + E2 d2) / A, where d are the depths of the corners, E the edge functions opposite to
// them at p and A = E0 + E1 + E2 > 0 twice the area. So the sign of a polynomial of degree 5 decides, which is written
// once and computed first in doubles with a bound of the error, then in integers of 192 bits, and of 448 where depths
// lie too far apart for that.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/core/conversion.hpp>
#include <irg/math/wide_int.hpp>
#include <irg/raster/screen_face.hpp>

namespace irg {
namespace detail {

// The depth of a plane at some place: the mean of depths by weights that add up to `total`, which is positive.
template <class Weight, class Depth>
struct mean_depth {
  Weight weight[3], total;
  Depth depth[3];
};
// As it is at hand. Positions lie within 2^29, so edge functions, twice the areas of triangles in a square of side
// 2^30, are at most 2^60 in size.
using plane_depth_at = mean_depth<std::int64_t, float>;

inline namespace IRG_ABI {

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
  const std::int64_t at_a = sign * signed_double_area(p, b, c), at_b = sign * signed_double_area(a, p, c);
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

// A float as +-significand * 2^(place - 149), told from its bits: no mode of the processor reaches it.
struct float_parts {
  std::uint32_t significand;
  int place;
  bool negative;
};
IRG_INLINE constexpr float_parts parts_of(float x) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t fraction = bits & 0x7fffff, field = (bits >> 23) & 0xff;
  return {field == 0 ? fraction : fraction | 0x800000, field == 0 ? 0 : static_cast<int>(field) - 1, bits >> 31 != 0};
}

// significand * 2^shift, with its sign, in N words, which are enough: the last is left to the sign.
template <int N>
constexpr wide_int<N> shifted(const float_parts& x, int shift) noexcept {
  const int word = shift / 64, bit = shift % 64;
  wide_int<N> v;
  v.word[word] = std::uint64_t{x.significand} << bit;
  if constexpr (N > 1)
    if (bit != 0) v.word[word + 1] = std::uint64_t{x.significand} >> (64 - bit);
  return x.negative ? -v : v;
}

// The sign with depths as integers of N words, all multiplied by the same power of two.
template <int N, class Plane>
constexpr int integer_sign(const Plane& a, const Plane& b, int lowest) noexcept {
  const auto exact = [lowest](const Plane& m) -> mean_depth<wide_int<1>, wide_int<N>> {
    const auto depth = [lowest](float d) {
      const float_parts x = parts_of(d);
      return x.significand == 0 ? wide_int<N>() : shifted<N>(x, x.place - lowest);
    };
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
      const float_parts x = parts_of(d);
      if (x.significand == 0) continue;
      lowest = lesser(lowest, x.place);
      highest = greater(highest, x.place);
    }
  return highest - lowest <= 37 ? integer_sign<1>(a, b, lowest) : integer_sign<5>(a, b, lowest);
}

// 1 where a is the greater depth, -1 where b is, 0 where they are equal.
template <class Plane>
IRG_INLINE constexpr int compare_depths_at(const Plane& a, const Plane& b) noexcept {
  const int sign = rounded_sign(a, b);
  return sign != 0 ? sign : exact_sign(a, b);
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
