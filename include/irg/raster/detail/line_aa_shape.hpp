// SPDX-License-Identifier: MIT
// A line of a given width as a rectangle, seen in a frame in which it runs right and down, and the edges of its rows.
//
// All numbers are pixels relative to a whole pixel above and to the left of the line, so whole-pixel moves change no
// bit; lines that are mirror images of each other have the same frame, so their pixels mirror exactly. Of the two ends,
// the start is the one whose position within its pixel comes first, so that a to b and b to a have the same pixels.
// When the two positions are the same, the rectangle is its own image under a half turn: then each half is drawn from
// its own end, and the row in the middle is folded.
#pragma once

#include <cstdint>

#include <irg/core/conversion.hpp>
#include <irg/core/lanes.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/raster/detail/area_targets.hpp>
#include <irg/raster/line_style.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg::detail::inline IRG_ABI {

// The area that a rectangle covers of each pixel of a row.
//
// An edge that crosses a row from x = low to x = low + s (s >= 0) has, in a pixel whose right side is t to the right of
// low, the area G(t) on its right: the mean over the edge of how much of the pixel lies beyond it,
//     G(t) = ((v1^2 - v2^2) / (2 lo) + c - lo) / hi        lo = min(s, 1), hi = max(s, 1)
//     v1 = clamped(t, 0, lo),  c = clamped(t, lo, lo + hi),  v2 = max(c - hi, 0)
// times the height of the edge's part in the row. The rectangle's area in the pixel is the sum over the edges on its
// left less the sum over those on its right (Green's theorem, one pixel at a time). Nothing is accumulated along a row
// or from row to row, so a pixel's value depends neither on the window nor on the number of lanes.

// What an edge adds to the sum, but for two factors: square goes with 1 / (2 lo hi), linear with 1 / hi.
template <class F>
struct aa_moments {
  F square, linear;
};

template <class F>
IRG_INLINE constexpr aa_moments<F> aa_edge(F t, F lo, F hi, F lo_and_hi) noexcept {
  const F zero = lanes<F>::broadcast(0.0f);
  const F v1 = minimum(maximum(t, zero), lo), c = minimum(maximum(t, lo), lo_and_hi), v2 = maximum(c - hi, zero);
  return {product(v1, v1) - product(v2, v2), c};
}

// Edges nearer to vertical than this are taken as if they were that far from it: 1 / s stays finite, and no area
// changes by more than half of it.
inline constexpr float aa_least_slant = 0x1p-20f;
// A row that both long edges cross from top to bottom: the two have the same slant.
template <class F>
struct aa_band_row {
  F lo, hi, lo_and_hi, square, linear;  // the same in all rows of a line
  F left = lanes<F>::broadcast(0.0f), right = left;  // t of the two edges for pixel 0
  float across;

  IRG_INLINE constexpr aa_band_row(float slant, float distance) noexcept : across(distance) {
    const float s = maximum(slant, aa_least_slant), one = 1.0f, inverse = one / s, l = minimum(s, one),
                h = maximum(s, one);
    lo = lanes<F>::broadcast(l), hi = lanes<F>::broadcast(h), lo_and_hi = lanes<F>::broadcast(s + one);
    square = lanes<F>::broadcast(aa_full * 0.5f * inverse);
    linear = lanes<F>::broadcast(aa_full * minimum(inverse, one));
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
//     (v^2 - z2^2 - z3^2) / 2m + max(b1 - u, 0)      v = clamped(b0 - u, 0, m),  z = max(b - u, 0)
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
    const F zero = lanes<F>::broadcast(0.0f), u = magnitude(x - shift), v = maximum(minimum(b0 - u, m), zero),
            z2 = maximum(b2 - u, zero), z3 = maximum(b3 - u, zero);
    return product((product(v, v) - product(z2, z2)) - product(z3, z3), inverse) +
           maximum(b1 - u, lanes<F>::broadcast(aa_half));
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

  // Edges e and following, the first two on the left: how far they reach, how high they are, t and columns of pixel 0.
  IRG_INLINE constexpr void enter(unsigned e, const F& slant, const F& rows, const F& from, const F& whole) noexcept {
    constexpr float sides[4] = {aa_full, aa_full, -aa_full, -aa_full};
    const F one = lanes<F>::broadcast(1.0f), s = maximum(slant, lanes<F>::broadcast(aa_least_slant)), inverse = one / s,
            weight = product(rows, lanes<F>::load(sides + e));
    lo[e] = minimum(s, one), hi[e] = maximum(s, one), both[e] = s + one;
    linear[e] = product(weight, minimum(inverse, one));
    square[e] = product(product(weight, lanes<F>::broadcast(0.5f)), inverse);
    t[e] = from;
    if constexpr (Far) columns[e] = whole;
  }
  IRG_INLINE constexpr F part(int e, F k) const noexcept {
    if constexpr (Far) k = k + columns[e];
    const aa_moments<F> m = aa_edge(k + t[e], lo[e], hi[e], both[e]);
    return product(m.square, square[e]) + product(m.linear - lo[e], linear[e]);
  }
  IRG_INLINE constexpr F operator()(F k) const noexcept {
    k = minimum(k, lanes<F>::broadcast(fold) - k);
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

// How the frame lies on the raster: column k of the frame is column origin + sign * k, where origin names a pixel.
struct aa_axis {
  std::int32_t start, base;  // where the line starts, in 1/256 pixel; the pixel that is number 0; both in the frame
  bool mirrored;
  IRG_INLINE constexpr int sign() const noexcept { return mirrored ? -1 : 1; }
  IRG_INLINE constexpr int at(int index) const noexcept { return mirrored ? -1 - (base + index) : base + index; }
  // The pixels of the indices [first, last), and the indices of the pixels [first, last): one is the other's inverse.
  IRG_INLINE constexpr area_range pixels(const area_range& i) const noexcept {
    return mirrored ? area_range{-base - i.last, -base - i.first} : area_range{base + i.first, base + i.last};
  }
  IRG_INLINE constexpr area_range indices(const area_range& p) const noexcept {
    return mirrored ? area_range{-base - p.last, -base - p.first} : area_range{p.first - base, p.last - base};
  }
};

// The frame's axis for a line from a to b: mirrored so that it rises.
IRG_INLINE constexpr aa_axis aa_axis_of(std::int32_t a, std::int32_t b, std::int32_t margin) noexcept {
  const bool mirrored = b < a;
  const std::int32_t start = mirrored ? -a : a;
  return {start, (start >> subpixel_bits) - margin, mirrored};
}

struct aa_frame {
  aa_axis x, y;
};

IRG_INLINE constexpr aa_frame aa_frame_of(const subpixel& a, const subpixel& b, std::int32_t margin) noexcept {
  return {aa_axis_of(a.x, b.x, margin), aa_axis_of(a.y, b.y, margin)};
}

// The position of the start within its pixel, as one number.
IRG_INLINE constexpr std::int32_t aa_fraction(const aa_frame& f) noexcept {
  constexpr std::int32_t fraction = one_pixel - 1;
  return (f.x.start & fraction) << subpixel_bits | (f.y.start & fraction);
}

// The edges top-left, left-bottom, top-right, right-bottom of the rectangle: each from (x, y) down to y_end, x_per_row
// aside. E is a number, or four lanes.
template <class E>
struct aa_edges {
  static constexpr unsigned count = static_cast<unsigned>(lanes<E>::count), parts = 4 / count;
  E x[parts] = {}, y[parts] = {}, y_end[parts] = {}, x_per_row[parts] = {};
};

// The same in floats, for shapes near the frame's origin.
template <class E>
constexpr aa_edges<E> aa_narrowed(const aa_edges<double>& edges) noexcept {
  aa_edges<E> narrow;
  for (unsigned i = 0; i < aa_edges<E>::parts; ++i) {
    const auto of = [&](const double(&all)[4]) {
      return lanes<E>::generate(
          [&](int k) { return static_cast<float>(all[i * aa_edges<E>::count + static_cast<unsigned>(k)]); });
    };
    narrow.x[i] = of(edges.x), narrow.y[i] = of(edges.y);
    narrow.y_end[i] = of(edges.y_end), narrow.x_per_row[i] = of(edges.x_per_row);
  }
  return narrow;
}

// The rectangle in its frame: corners top, left, right, bottom.
struct aa_shape {
  aa_edges<double> edges;
  double slant = 0, across = 0;  // of the long edges: x per row, and how far apart they are along a row
  // The same in 2^-40 pixel: how long the runs between the caps are, and from where to where they are covered whole.
  std::int64_t reach = 0, whole_from = 0, whole_to = 0;
  double slope = 0, width = 0;  // along the longer axis, and what it is wide along the shorter one
  bool thin = false;  // fit for aa_thin_row
  int first = 0, last = 0;  // the rows it touches, half-open
  int band_first = 0, band_last = 0;  // those that both long edges cross whole
  bool small_numbers = false;  // all coordinates are below 256: floats hold them to 2^-17
  int turned_x = 0, turned_y = 0;  // the half turn takes column k to turned_x - k and row r to turned_y - r
};

// needs  dx > 0 and dy > 0
constexpr aa_shape aa_shape_of(const aa_frame& f, std::int32_t dx, std::int32_t dy, std::int32_t width,
                               line_aa_caps caps) noexcept {
  const std::int64_t square = std::int64_t{dx} * dx + std::int64_t{dy} * dy;
  const double unit = 1.0 / one_pixel, inverse = 1.0 / irg::sqrt(static_cast<double>(square));
  const double half = width * (0.5 * unit), ux = product(dx * inverse, half), uy = product(dy * inverse, half);
  const double ex = caps == line_aa_caps::square ? ux : 0.0, ey = caps == line_aa_caps::square ? uy : 0.0;
  const double x = (f.x.start - f.x.base * one_pixel) * unit, y = (f.y.start - f.y.base * one_pixel) * unit;
  const double x0 = x - ex, y0 = y - ey, x1 = (x + dx * unit) + ex, y1 = (y + dy * unit) + ey;
  const double top = y0 - ux, left = y0 + ux, right = y1 - ux, bottom = y1 + ux;
  aa_shape s;
  s.slant = static_cast<double>(dx) / dy;
  const double back = -(static_cast<double>(dy) / dx);
  s.edges.x[0] = s.edges.x[2] = x0 + uy, s.edges.x[1] = x0 - uy, s.edges.x[3] = x1 + uy;
  s.edges.y[0] = s.edges.y[2] = top, s.edges.y[1] = left, s.edges.y[3] = right;
  s.edges.y_end[0] = left, s.edges.y_end[1] = s.edges.y_end[3] = bottom, s.edges.y_end[2] = right;
  s.edges.x_per_row[0] = s.edges.x_per_row[3] = back, s.edges.x_per_row[1] = s.edges.x_per_row[2] = s.slant;
  s.across = 2.0 * (uy + product(ux, s.slant));
  s.band_first = static_cast<int>(left) + 1, s.band_last = static_cast<int>(right);
  if (s.band_last < s.band_first) s.band_first = s.band_last = s.last;
  if (s.band_first < s.band_last) {
    s.reach = static_cast<std::int64_t>((s.slant + s.across) * 0x1p40);
    s.whole_from = static_cast<std::int64_t>(s.slant * 0x1p40),
    s.whole_to = static_cast<std::int64_t>(s.across * 0x1p40);
  }
  const double slope = dx <= dy ? s.slant : -back;
  s.slope = maximum(slope, static_cast<double>(aa_least_slant));
  s.width = dx <= dy ? s.across : 2.0 * (ux + product(uy, slope));
  s.thin = s.width <= 1.0 + s.slope && s.width >= 1.0 - s.slope;
  s.first = static_cast<int>(top), s.last = static_cast<int>(bottom) + 1;  // all coordinates are positive
  s.small_numbers = x1 + uy < 256.0 && bottom < 256.0;
  s.turned_x = ((2 * (f.x.start - f.x.base * one_pixel) + dx) >> subpixel_bits) - 1;
  s.turned_y = ((2 * (f.y.start - f.y.base * one_pixel) + dy) >> subpixel_bits) - 1;
  return s;
}

// The left end of the run of a row between the caps, from row to row, in 2^-40 pixel: exact sums of a slope rounded
// once, so 4 million rows are less than 2^-18 pixel off.
struct aa_walk {
  static constexpr int bits = 40;
  std::int64_t x, step;
  IRG_INLINE constexpr int column() const noexcept { return static_cast<int>(x >> bits); }
  // One past the column of what lies `beyond` the left end.
  IRG_INLINE constexpr int end_column(std::int64_t beyond) const noexcept {
    return static_cast<int>((x + beyond) >> bits) + 1;
  }
  IRG_INLINE constexpr std::int32_t fraction() const noexcept {
    return static_cast<std::int32_t>(x >> (bits - 24)) & 0xffffff;
  }
};

// needs   band_first <= r <= band_last
IRG_INLINE constexpr aa_walk aa_walk_at(const aa_shape& s, int r) noexcept {
  const double x = s.edges.x[1] + product(s.band_first - s.edges.y[1], s.slant);
  const auto step = static_cast<std::int64_t>(s.slant * 0x1p40);
  return {static_cast<std::int64_t>(x * 0x1p40) + step * (r - s.band_first), step};
}

inline constexpr float aa_nowhere = 0x1p30f;  // to the right of everything

// The columns of a row of edges, two on the left and two on the right: low and high are their bounds, those of edges
// that the row does not have being nowhere and 0.
template <class T>
IRG_INLINE constexpr area_range aa_columns_between(const T* low, const T* high) noexcept {
  const T least = minimum(low[0], low[1]), greatest = maximum(high[2], high[3]);
  if (!(least < greatest)) return {};
  return {static_cast<int>(least), static_cast<int>(greatest) + 1};
}

// Row r, its factors and its columns.
template <class F, class E>
IRG_INLINE constexpr area_range aa_enter(aa_cap_row<F, std::is_same_v<E, double>>& row, const aa_edges<E>& edges,
                                         int r) noexcept {
  constexpr unsigned count = aa_edges<E>::count, parts = aa_edges<E>::parts;
  using number = typename lanes<E>::scalar;
  using floats = typename lanes<E>::template rebind<float>;
  const auto all = [](auto v) { return lanes<E>::broadcast(static_cast<number>(v)); };
  const E top = all(r), below = all(r + 1), zero = all(0), nowhere = all(aa_nowhere);
  number low[4] = {}, high[4] = {}, start[4] = {};
  float slant[4] = {}, height[4] = {}, t[4] = {}, columns_before[4] = {};
  for (unsigned i = 0, e = 0; i < parts; ++i, e += count) {
    const E from = maximum(edges.y[i], top), to = minimum(edges.y_end[i], below), rows = maximum(to - from, zero);
    const E a = edges.x[i] + product(from - edges.y[i], edges.x_per_row[i]),
            b = edges.x[i] + product(to - edges.y[i], edges.x_per_row[i]);
    const E left = minimum(a, b), right = maximum(a, b);
    const auto is_there = zero < rows;
    lanes<E>::store(low + e, select(is_there, left, nowhere));
    lanes<E>::store(high + e, select(is_there, right, zero));
    lanes<E>::store(start + e, select(is_there, left, zero));
    lanes<floats>::store(slant + e, converted<float>(right - left));
    lanes<floats>::store(height + e, converted<float>(rows));
  }
  const area_range columns = aa_columns_between(low, high);
  const int after = columns.first + 1;
  for (unsigned i = 0, e = 0; i < parts; ++i, e += count) {
    if constexpr (std::is_same_v<E, double>) {
      const auto column = static_cast<int>(start[e]);
      columns_before[e] = static_cast<float>(after - column), t[e] = converted<float>(column - start[e]);
    } else {
      lanes<floats>::store(t + e, all(after) - lanes<E>::load(start + e));
    }
  }
  for (unsigned e = 0; e < 4; e += 4 / aa_cap_row<F>::parts)
    row.enter(e, lanes<F>::load(slant + e), lanes<F>::load(height + e), lanes<F>::load(t + e),
              lanes<F>::load(columns_before + e));
  return columns;
}

}  // namespace irg::detail::inline IRG_ABI
