// SPDX-License-Identifier: MIT
// The area that a rectangle covers of each pixel of a row.
//
// An edge that crosses a row from x = low to x = low + s (s >= 0) has, in a pixel whose right side is t to the right of
// low, the area G(t) on its right: the mean over the edge of how much of the pixel lies beyond it,
//     G(t) = ((v1^2 - v2^2) / (2 lo) + c - lo) / hi        lo = min(s, 1), hi = max(s, 1)
//     v1 = clamp(t, 0, lo),  c = clamp(t, lo, lo + hi),  v2 = max(c - hi, 0)
// times the height of the edge's part in the row. The rectangle's area in the pixel is the sum over the edges on its
// left less the sum over those on its right (Green's theorem, one pixel at a time). Nothing is accumulated along a row
// or from row to row, so a pixel's value depends neither on the window nor on the number of lanes.
#pragma once

#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// What an edge adds to the sum, but for two factors: square goes with 1 / (2 lo hi), linear with 1 / hi.
template <class F>
struct aa_moments {
  F square, linear;
};

template <class F>
IRG_INLINE constexpr aa_moments<F> aa_edge(F t, F lo, F hi, F lo_and_hi) noexcept {
  const F zero = lanes<F>::broadcast(0.0f);
  const F v1 = low_of(high_of(t, zero), lo), c = low_of(high_of(t, lo), lo_and_hi), v2 = high_of(c - hi, zero);
  return {product(v1, v1) - product(v2, v2), c};
}

// Edges nearer to vertical than this are taken as if they were that far from it: 1 / s stays finite, and no area
// changes by more than half of it.
inline constexpr float aa_least_slant = 0x1p-20f;
// Coverage is computed in 255ths with 1/2 added, ready to be truncated.
inline constexpr float aa_full = 255.0f, aa_half = 0.5f;

// A row that both long edges cross from top to bottom: the two have the same slant.
template <class F>
struct aa_band_row {
  F lo, hi, lo_and_hi, square, linear;  // the same in all rows of a line
  F left = lanes<F>::broadcast(0.0f), right = left;  // t of the two edges for pixel 0
  float across;

  IRG_INLINE constexpr aa_band_row(float slant, float distance) noexcept : across(distance) {
    const float s = high_of(slant, aa_least_slant), one = 1.0f, inverse = one / s, l = low_of(s, one),
                h = high_of(s, one);
    lo = lanes<F>::broadcast(l), hi = lanes<F>::broadcast(h), lo_and_hi = lanes<F>::broadcast(s + one);
    square = lanes<F>::broadcast(aa_full * 0.5f * inverse);
    linear = lanes<F>::broadcast(aa_full * low_of(inverse, one));
  }
  IRG_INLINE constexpr void enter(std::int32_t fraction_in_24_bits) noexcept {
    const float l = 1.0f - static_cast<float>(fraction_in_24_bits) * 0x1p-24f;  // exact
    left = lanes<F>::broadcast(l), right = lanes<F>::broadcast(l - across);
  }
  // 1/2 + 255 * the area in pixel k.
  IRG_INLINE constexpr F operator()(F k) const noexcept {
    const aa_moments<F> a = aa_edge(k + left, lo, hi, lo_and_hi), b = aa_edge(k + right, lo, hi, lo_and_hi);
    return (product(a.square - b.square, square) + product(a.linear - b.linear, linear)) + lanes<F>::broadcast(aa_half);
  }
};

// The same for lines about one pixel wide, at a third of the cost. With m <= 1 the change of the centre line per pixel
// of the longer axis and w the width along the shorter one, the area is an even function of u, the distance of the
// pixel's centre from the centre line along the shorter axis: where |w - 1| <= m,
//     (v^2 - z2^2 - z3^2) / 2m + max(b1 - u, 0)      v = clamp(b0 - u, 0, m),  z = max(b - u, 0)
//     b0 = (1 + m + w) / 2,  b1 = b0 - m,  b2 = b0 - 1,  b3 = b0 - w
// All lengths are in 1/255 pixel, so that no factor is left over for the area.
template <class F>
struct aa_thin_row {
  F step, centre, b0, b1, b2, b3, m, inverse;
  F shift = lanes<F>::broadcast(0.0f);  // how far the row's first pixel begins before the run's left end
  float shift_unit;

  // centre_of_first: from the run's left end to the centre line, negative, along a row.
  IRG_INLINE constexpr aa_thin_row(float slope, float width, float change_of_u, float centre_of_first) noexcept {
    const auto set = [](float x) { return lanes<F>::broadcast(aa_full * x); };
    const float outer = 0.5f * (1.0f + slope + width);
    step = set(change_of_u), centre = set(product(centre_of_first, change_of_u)), m = set(slope);
    b0 = set(outer), b2 = set(outer - 1.0f), b3 = set(outer - width);
    b1 = lanes<F>::broadcast(aa_full * (outer - slope)) + lanes<F>::broadcast(aa_half);
    inverse = lanes<F>::broadcast(0.5f / (aa_full * slope));
    shift_unit = aa_full * change_of_u * 0x1p-24f;
  }
  IRG_INLINE constexpr void enter(std::int32_t fraction_in_24_bits) noexcept {
    shift = lanes<F>::broadcast(static_cast<float>(fraction_in_24_bits) * shift_unit);
  }
  IRG_INLINE constexpr F before_shift(F k) const noexcept { return product(k, step) + centre; }
  IRG_INLINE constexpr F shifted(F x) const noexcept {
    const F zero = lanes<F>::broadcast(0.0f), u = magnitude(x - shift), v = high_of(low_of(b0 - u, m), zero),
            z2 = high_of(b2 - u, zero), z3 = high_of(b3 - u, zero);
    return product((product(v, v) - product(z2, z2)) - product(z3, z3), inverse) +
           high_of(b1 - u, lanes<F>::broadcast(aa_half));
  }
  IRG_INLINE constexpr F operator()(F k) const noexcept { return shifted(before_shift(k)); }
};

// The sums of four packs, each summed as (0 + 2) + (1 + 3).
IRG_INLINE constexpr float aa_sum(float a, float b, float c, float d) noexcept { return (a + c) + (b + d); }
IRG_INLINE pack<float, 4> aa_sums(const pack<float, 4>& a, const pack<float, 4>& b, const pack<float, 4>& c,
                                  const pack<float, 4>& d) noexcept {
  const auto ab = shuffled<0, 4, 1, 5>(a, b) + shuffled<2, 6, 3, 7>(a, b);
  const auto cd = shuffled<0, 4, 1, 5>(c, d) + shuffled<2, 6, 3, 7>(c, d);
  return shuffled<0, 1, 4, 5>(ab, cd) + shuffled<2, 3, 6, 7>(ab, cd);
}

// A row with edges that end in it: four edges, those on the right side with negative factors. F is float, or four lanes
// with an edge each. Far: of a row of any length. The columns' part of t, a whole number, is kept apart then, so that
// an edge far from the row's first pixel is as exact as one beside it.
template <class F, bool Far = false>
struct aa_cap_row {
  static constexpr unsigned parts = 4u / static_cast<unsigned>(lanes<F>::count);
  static_assert(parts == 1 || parts == 4);
  F t[parts] = {}, lo[parts] = {}, hi[parts] = {}, both[parts] = {}, square[parts] = {}, linear[parts] = {};
  F columns[Far ? parts : 1] = {};
  float fold = 0x1p30f;  // pixel k is as pixel fold - k

  IRG_INLINE constexpr F part(int e, F k) const noexcept {
    if constexpr (Far) k = k + columns[e];
    const aa_moments<F> m = aa_edge(k + t[e], lo[e], hi[e], both[e]);
    return product(m.square, square[e]) + product(m.linear - lo[e], linear[e]);
  }
  IRG_INLINE constexpr F operator()(F k) const noexcept {
    k = low_of(k, lanes<F>::broadcast(fold) - k);
    if constexpr (parts == 4) {
      return aa_sum(part(0, k), part(1, k), part(2, k), part(3, k)) + aa_half;
    } else {
      const auto pixel = [&](int i) { return part(0, lanes<F>::broadcast(k[i])); };
      return aa_sums(pixel(0), pixel(1), pixel(2), pixel(3)) + lanes<F>::broadcast(aa_half);
    }
  }
};

// A row of a rectangle with level and upright sides: one value inside, others in the first and the last pixel.
// Everything here is a whole number below 2^24.
struct aa_box_row {
  float first = 0, inside = 0, last = 0, last_index = 0;

  template <class F>
  IRG_INLINE constexpr F operator()(F k) const noexcept {
    const auto all = [](float x) { return lanes<F>::broadcast(x); };
    const F from_last = select(k < all(last_index + 1.0f), all(last), all(0.0f));
    return select(k < all(1.0f), all(first), select(k < all(last_index), all(inside), from_last)) + all(aa_half);
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
