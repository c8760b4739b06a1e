// SPDX-License-Identifier: MIT
// Where the rows of an antialiased line go: to a sink as runs of coverages, or mixed straight into a raster's row.
// A writer runs over the raster's row y, columns [first, last); column x is pixel sign * (x - origin) of
// `row`, which gives 1/2 + 255 * the covered area of a pixel or of several at once.
#pragma once

#include <array>
#include <bit>

#include <irg/core/sinks.hpp>
#include <irg/raster/detail/line_aa_shape.hpp>
#include <irg/raster/detail/mix_kernel.hpp>
#include <irg/raster/paint.hpp>
#include <irg/raster/window.hpp>

namespace irg::detail::inline IRG_ABI {

// Antialiased lines about one pixel wide and not too long, seen along their longer axis: of each step along it, such a
// line touches four pixels aside at most.
//
// Steps between the caps take the even function of aa_thin_row, its distances measured from the line's middle: a half
// turn about it only changes signs. The two steps at either cap come from the cap's own corner, both caps at once, in
// frames that a half turn exchanges. So neither end comes first, and a to b has the pixels of b to a; x and y may be
// exchanged, too.
//
// At a cap, let C(j) be the area of the step's part below j. With L and R the sides of the rectangle below and above,
//     C(j) = the mean over the step of max(j - L, 0) - max(j - R, 0)
// and a pixel's area is C(j + 1) - C(j). L consists of the cap and a long edge, R is the other long edge.

// Towards zero.
template <class F>
IRG_INLINE constexpr auto aa_truncate(const F& x) noexcept {
  return converted<std::int32_t>(x);
}

// Four bytes in one word, a the lowest.
template <class J>
IRG_INLINE constexpr J aa_word(const J& a, const J& b, const J& c, const J& d) noexcept {
  return (a | (b << 8)) | ((c << 16) | (d << 24));
}

// Coverages 0 to 255 of pixels e and on as the bytes that they are in a word of four.
IRG_INLINE constexpr std::uint32_t aa_bytes(std::int32_t c, unsigned e) noexcept {
  return static_cast<std::uint32_t>(c) << (8 * e);
}
IRG_INLINE std::uint32_t aa_bytes(const pack<std::int32_t, 4>& c, unsigned) noexcept { return packed_bytes(c); }

// Four pixels aside: those from `aside` on at step `along`, with a coverage in each byte.
struct aa_step {
  int along, aside;
  std::uint32_t coverage;
};

// Positions along a longer line would lose bits.
inline constexpr int aa_slender_length = 512 * one_pixel;

// F is float, or four lanes.
template <class F>
struct aa_slender {
  static constexpr unsigned count = static_cast<unsigned>(lanes<F>::count), parts = 4 / count;
  static constexpr int walk_bits = 20;

  float slope, inverse, across, cap, before;  // cap: how many steps a cap takes; before: how far it lies before the end
  // The steps at the ends: two at a, two at b. Their pixels are those from `aside` on at step `along`.
  struct {
    std::int32_t along[4] = {}, aside[4] = {}, coverage[4] = {};
  } ends;
  // The steps between.
  int first = 0, steps = 0;  // steps < 0: the caps meet
  bool fits = false;
  int middle = 0;  // positions aside are relative to it
  float aside[4] = {};  // of the pixels' centres, relative to the line's middle
  float along = 0;  // of the first step, likewise
  float change = 0;  // aside per step
  std::int32_t walk = 0, walk_step = 0;  // to the four pixels, in 2^-20

  // a and b: the ends along the longer axis and aside, with 0 < |b.y - a.y| <= |b.x - a.x| <= aa_slender_length.
  IRG_INLINE constexpr aa_slender(const subpixel& a, const subpixel& b, std::int32_t width,
                                  line_aa_caps caps) noexcept {
    const std::int32_t du = b.x - a.x, dv = b.y - a.y, turn_u = du >> 31, turn_v = dv >> 31;
    const float u = static_cast<float>((du ^ turn_u) - turn_u), v = static_cast<float>((dv ^ turn_v) - turn_v);
    const std::int64_t square = std::int64_t{du} * du + std::int64_t{dv} * dv;
    const float full = static_cast<float>(width) * (1.0f / one_pixel),
                unit = full / irg::sqrt(static_cast<float>(square)), cu = u * unit, cv = v * unit;
    slope = v / u, inverse = u / v;
    across = cu + product(cv, slope), cap = cv;
    before = 0.5f * (caps == line_aa_caps::square ? cv - cu : cv);
    compute_ends(a, b, turn_u, turn_v);
    fits = across <= 1.0f + slope && across >= 1.0f - slope && across + slope <= 3.0f && cap <= 1.0f && steps >= 0;
    const std::int32_t twice_u = a.x + b.x, twice_v = a.y + b.y;
    middle = twice_v >> (subpixel_bits + 1);
    constexpr float per_unit = 1.0f / (2 * one_pixel);
    const int from = half_pixel * 2 - (twice_v & (2 * one_pixel - 1));
    for (int k = 0; k < 4; ++k)
      aside[static_cast<unsigned>(k)] = static_cast<float>(from + 2 * one_pixel * k) * per_unit;
    along = static_cast<float>(2 * one_pixel * first + 2 * half_pixel - twice_u) * per_unit;
    change = turn_u == turn_v ? slope : -slope;
    constexpr float one_walk = 1 << walk_bits;
    const float start =
        product(change, along) - 0.5f * (across + slope) + static_cast<float>(twice_v & (2 * one_pixel - 1)) * per_unit;
    walk = static_cast<std::int32_t>((start + 512.0f) * one_walk) - (512 << walk_bits);
    walk_step = static_cast<std::int32_t>(change * one_walk);
  }

  using integers = std::conditional_t<count == 1, std::int32_t, pack<std::int32_t, 4>>;

  // From a the first two steps are seen, from b the others.
  IRG_INLINE static constexpr integers seen_from(std::int32_t at_a, std::int32_t at_b, unsigned e) noexcept {
    if constexpr (count == 1)
      return e < 2 ? at_a : at_b;
    else
      return pack_of(at_a, at_a, at_b, at_b);
  }

  IRG_INLINE constexpr void compute_ends(const subpixel& a, const subpixel& b, std::int32_t turn_u,
                                         std::int32_t turn_v) noexcept {
    // Where the line starts from either end, in frames in which it runs right and down.
    const std::int32_t ua = (a.x ^ turn_u) - turn_u, ub = turn_u - (b.x ^ turn_u), va = (a.y ^ turn_v) - turn_v,
                       vb = turn_v - (b.y ^ turn_v);
    for (unsigned e = 0; e < parts; ++e)
      compute_end(seen_from(ua, ub, e), seen_from(va, vb, e), seen_from(turn_u, ~turn_u, e),
                  seen_from(turn_v, ~turn_v, e), e);
    // Both ends' second steps lie beside the steps between.
    const std::int32_t after_a = (ends.along[1] ^ turn_u) + 1, after_b = (ends.along[3] ^ ~turn_u) + 1;
    steps = -after_a - after_b, first = turn_u != 0 ? after_b : after_a;
  }

  // One step at an end, or all four at once, from where the line starts there; turn says on which axes the frame is
  // turned: all bits or none.
  IRG_INLINE constexpr void compute_end(const integers& start_u, const integers& start_v, const integers& turn_u,
                                        const integers& turn_v, unsigned e) noexcept {
    const auto all = [](float x) { return lanes<F>::broadcast(x); };
    const auto fraction = [](const integers& i) { return to_float(i & (one_pixel - 1)); };
    constexpr float earlier[4] = {-1.0f, 0.0f, -1.0f, 0.0f};
    const F zero = all(0.0f), one = all(1.0f), m = all(slope), per = all(inverse), unit = all(1.0f / one_pixel);
    // 4 and 8 are added so that what is truncated is positive.
    const F u = product(fraction(start_u), unit) + all(4.0f), v = product(fraction(start_v), unit) + all(8.0f);
    // The cap ends and the lower long edge begins at `low`, the cap and the upper long edge begin at `high`.
    const F end = u + all(before), top = to_float(aa_truncate(end)) + lanes<F>::load(earlier + e), low = end - top,
            high = low - all(cap);
    const F low_from = low_of(low, one), high_from = high_of(low_of(high, one), zero);
    const F low_part = one - low_from, high_part = one - high_from, cap_part = low_from - high_from;
    const F edge = (v - all(0.5f * across)) + product(m, top - u);  // the lower edge, seen from the step's top
    const F column = to_float(aa_truncate(edge)), x = edge - column;
    const F low_x = x + product(m, low_from), high_x = (x + all(across)) + product(m, high_from),
            cap_x = (x + product(m, low)) + product(low - low_from, per);
    const F low_rise = product(m, low_part), high_rise = product(m, high_part), cap_rise = product(cap_part, per);
    const F half_inverse = all(aa_full * 0.5f * inverse), half_slope = all(aa_full * 0.5f * slope);
    const F low_full = product(low_part, all(aa_full)), high_full = product(high_part, all(aa_full)),
            cap_full = product(cap_part, all(aa_full));
    const auto below = [&](float boundary) {
      const F j = all(boundary), dl = j - low_x, dh = j - high_x, dc = j - cap_x;
      const F l = low_of(high_of(dl, zero), low_rise), h = low_of(high_of(dh, zero), high_rise), c0 = high_of(dc, zero),
              c1 = high_of(dc - cap_rise, zero);
      const F squares =
          product(product(l, l) - product(h, h), half_inverse) + product(product(c0, c0) - product(c1, c1), half_slope);
      return squares +
             (product(low_full, high_of(dl - low_rise, zero)) - product(high_full, high_of(dh - high_rise, zero)));
    };
    const F half = all(0.5f), four = all(4.0f);
    const F c1 = below(1.0f), c2 = below(2.0f), c3 = below(3.0f);
    const F whole = (product(low_full, (four - low_x) - product(low_rise, half)) +
                     product(cap_full, (four - cap_x) - product(cap_rise, half))) -
                    product(high_full, (four - high_x) - product(high_rise, half));
    const integers p0 = aa_truncate(c1 + half), p1 = aa_truncate((c2 - c1) + half), p2 = aa_truncate((c3 - c2) + half),
                   p3 = aa_truncate((whole - c3) + half);
    const integers i = (start_u >> subpixel_bits) + aa_truncate(top - all(4.0f)),
                   j = (start_v >> subpixel_bits) + aa_truncate(column - all(8.0f));
    const integers turned = aa_word(p3, p2, p1, p0), straight = aa_word(p0, p1, p2, p3);
    lanes<integers>::store(ends.along + e, i ^ turn_u);
    lanes<integers>::store(ends.aside + e, (j ^ turn_v) - (turn_v & 3));
    lanes<integers>::store(ends.coverage + e, (turn_v & turned) | (~turn_v & straight));
  }
};

// The steps of a slender line between its caps. F may hold the pixels of two steps.
template <class F>
struct aa_slender_steps {
  F b0, b1, b2, b3, m, inverse, change;

  template <class S>
  IRG_INLINE constexpr explicit aa_slender_steps(const S& s) noexcept {
    const auto all = [](float x) { return lanes<F>::broadcast(x); };
    const float outer = 0.5f * ((1.0f + s.slope) + s.across);
    b0 = all(outer), b1 = all(outer - s.slope), b2 = all(outer - 1.0f), b3 = all(outer - s.across), m = all(s.slope);
    inverse = all(aa_full * 0.5f * s.inverse), change = all(s.change);
  }
  // 1/2 + 255 * the area of pixels whose centres are aside + column from the line's middle, in steps `along` from it.
  IRG_INLINE constexpr F operator()(const F& aside, const F& column, const F& along) const noexcept {
    const F zero = lanes<F>::broadcast(0.0f), u = magnitude((aside + column) - product(change, along)),
            v = high_of(low_of(b0 - u, m), zero), z2 = high_of(b2 - u, zero), z3 = high_of(b3 - u, zero);
    return (product((product(v, v) - product(z2, z2)) - product(z3, z3), inverse) +
            product(high_of(b1 - u, zero), lanes<F>::broadcast(aa_full))) +
           lanes<F>::broadcast(aa_half);
  }
};

// Step k of the four at the ends.
template <class F>
constexpr aa_step aa_end_step(const aa_slender<F>& s, unsigned k) noexcept {
  return {s.ends.along[k], s.ends.aside[k], static_cast<std::uint32_t>(s.ends.coverage[k])};
}
// Step i of those between.
template <class F>
constexpr aa_step aa_step_between(const aa_slender<F>& s, const aa_slender_steps<F>& steps, int i) noexcept {
  constexpr unsigned count = aa_slender<F>::count;
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  const int column = (s.walk + s.walk_step * i) >> aa_slender<F>::walk_bits;
  aa_step step{s.first + i, s.middle + column, 0};
  for (unsigned e = 0; e < 4; e += count) {
    step.coverage |= aa_bytes(aa_truncate(steps(lanes<F>::load(s.aside + e), all(static_cast<float>(column)),
                                                all(s.along + static_cast<float>(i)))),
                              e);
  }
  return step;
}

// Flat lines go this way up to here: then whole rows are faster than columns. The same on all targets: the two ways may
// round a coverage differently.
inline constexpr int aa_slender_flat = 32 * one_pixel;

// The bytes of a word, the lowest first, with as many zeros after them: all written at once.
IRG_INLINE constexpr std::array<std::uint8_t, 8> aa_in_memory(std::uint32_t word) noexcept {
  const std::uint64_t w = word;
  if constexpr (std::endian::native == std::endian::little) return std::bit_cast<std::array<std::uint8_t, 8>>(w);
  return std::bit_cast<std::array<std::uint8_t, 8>>(
      static_cast<std::uint64_t>(aa_word(static_cast<int>(w >> 24), static_cast<int>(w >> 16 & 255),
                                         static_cast<int>(w >> 8 & 255), static_cast<int>(w & 255)))
      << 32);
}

// A row's pixels as far as the window holds them.
template <class Writer>
IRG_INLINE constexpr void aa_write_bytes(const cell_window& w, Writer& writer, int y, int first, int last,
                                         const std::uint8_t* coverage) {
  const int from = greater(first, w.x_first), to = lesser(last, w.x_last);
  if (y >= w.y_first && y < w.y_last && from < to) writer.bytes(y, from, to, coverage + (from - first));
}

// The steps of a steep slender line: each a row.
template <class Writer>
constexpr void aa_write_steep(const aa_slender<typename Writer::four>& s, const cell_window& w, Writer& writer) {
  const aa_slender_steps<typename Writer::four> between(s);
  const auto write = [&](const aa_step& e) {
    aa_write_bytes(w, writer, e.along, e.aside, e.aside + 4, aa_in_memory(e.coverage).data());
  };
  for (unsigned k = 0; k < 4; ++k) write(aa_end_step(s, k));
  const int first = greater(w.y_first, s.first), last = lesser(w.y_last, s.first + s.steps);
  for (int y = first; y < last; ++y) write(aa_step_between(s, between, y - s.first));
}

// The steps of a flat one, each a column: gathered into rows.
template <class Writer>
constexpr void aa_write_flat(const aa_slender<typename Writer::four>& s, const cell_window& w, Writer& writer) {
  constexpr unsigned most = aa_slender_flat / one_pixel + 12;  // at most 4 pixels beyond each end, 4 to a step
  struct row {
    int first = most, last = 0;
    std::uint8_t coverage[most] = {};
  };
  const aa_slender_steps<typename Writer::four> between(s);
  const int x = s.first - 2;
  int y = s.ends.aside[0], y_last = y;
  for (const int a : s.ends.aside) {
    y = lesser(y, a);
    y_last = greater(y_last, a + 4);
  }
  row rows[most];
  const auto gather = [&](const aa_step& e) {
    const int column = e.along - x;
    for (int k = 0; k < 4; ++k) {
      row& r = rows[e.aside - y + k];
      r.coverage[column] = static_cast<std::uint8_t>(e.coverage >> (8 * k) & 255u);
      r.first = lesser(r.first, column), r.last = greater(r.last, column + 1);
    }
  };
  for (unsigned k = 0; k < 4; ++k) gather(aa_end_step(s, k));
  for (int i = 0; i < s.steps; ++i) gather(aa_step_between(s, between, i));
  for (int i = 0; i < y_last - y; ++i) {
    const row& r = rows[i];
    aa_write_bytes(w, writer, y + i, x + r.first, x + r.last, r.coverage + r.first);
  }
}

// Draws the line if it is slender, and nothing at all if it lies beside the window; false when that is left to others.
template <class Writer>
IRG_INLINE constexpr bool aa_draw_slender(const subpixel& a, const subpixel& b, const line_aa_options& options,
                                          const cell_window& w, Writer& writer) {
  const std::int32_t left = lesser(a.x, b.x), right = greater(a.x, b.x), top = lesser(a.y, b.y),
                     bottom = greater(a.y, b.y);
  // Pixels beyond the ends that may be written. The sides are counted, so that there is one branch for all of them.
  const int beyond = 5 + (options.width >> subpixel_bits);
  const int x_first = (left >> subpixel_bits) - beyond, x_last = (right >> subpixel_bits) + beyond,
            y_first = (top >> subpixel_bits) - beyond, y_last = (bottom >> subpixel_bits) + beyond;
  if (int{x_first >= w.x_last} + int{x_last < w.x_first} + int{y_first >= w.y_last} + int{y_last < w.y_first} != 0)
    return true;
  const std::int32_t dx = right - left, dy = bottom - top;
  const bool steep = dx <= dy;
  if (dx == 0 || dy == 0 || dy > aa_slender_length || (!steep && dx > aa_slender_flat) ||
      options.width >= 2 * one_pixel)
    return false;
  const bool inside = x_first >= w.x_first && x_last < w.x_last && y_first >= w.y_first && y_last < w.y_last;
  const subpixel from = steep ? subpixel{a.y, a.x} : a, to = steep ? subpixel{b.y, b.x} : b;
  const aa_slender<typename Writer::four> s(from, to, options.width, options.caps);
  if (!s.fits) return false;
  if constexpr (Writer::writes_slender) {
    if (inside) {
      if (steep)
        writer.steep_inside(s);
      else
        writer.flat_inside(s);
      return true;
    }
  }
  if (w.empty()) return true;
  if (steep)
    aa_write_steep(s, w, writer);
  else
    aa_write_flat(s, w, writer);
  return true;
}

// The pixels that one call of a row computes.
using aa_lanes = pack<float, native_lanes<float>>;
using aa_four = pack<float, 4>;

// The number of pixel x + i in lane i. Exact: no line has 2^24 pixels in a row.
template <class F>
IRG_INLINE constexpr F aa_indices(int x, int origin, int sign) noexcept {
  const F i = lanes<F>::ramp(), k = lanes<F>::broadcast(static_cast<float>(sign * (x - origin)));
  return sign > 0 ? k + i : k - i;
}

// Emits coverage spans of a few hundred pixels at most. F is float in constant evaluation.
template <class F, class Sink>
struct aa_span_writer {
  using number = F;
  using four = std::conditional_t<std::is_same_v<F, float>, float, aa_four>;
  static constexpr bool writes_whole_chunks = false, writes_slender = false;
  static constexpr int capacity = 256;
  Sink& sink;
  std::uint8_t coverage[capacity + lanes<F>::count] = {};

  template <class G, class Row>
  constexpr void run(int y, int first, int last, int origin, int sign, const Row& row) {
    constexpr int count = lanes<G>::count;
    for (int x = first; x < last; x += capacity) {
      const int n = lesser(capacity, last - x);
      for (int i = 0; i < n; i += count) {
        const auto c = aa_truncate(row(aa_indices<G>(x + i, origin, sign)));
        for (int lane_of_it = 0; lane_of_it < count; ++lane_of_it)
          coverage[i + lane_of_it] = static_cast<std::uint8_t>(lane(c, lane_of_it));
      }
      sink(coverage_span{y, x, x + n, coverage});
    }
  }
  constexpr void bytes(int y, int first, int last, const std::uint8_t* c) { sink(coverage_span{y, first, last, c}); }
};

// Mixes a colour into the pixels of a row, a register at a time. Pixels of the window next to the run's last are
// written, too, with what they hold: their coverage is 0. No pixel outside the window is touched.
template <class R>
struct aa_mixing_writer {
  using number = aa_lanes;
  using four = aa_four;
  static constexpr bool writes_whole_chunks = true;
  using pixel = pixel_of<R>;
  R& raster;
  const pixel& value;
  int x_last;  // of the window
  mix_colour<lanes<number>::count> wide;
  mix_colour<4> narrow;

  IRG_INLINE aa_mixing_writer(R& r, const pixel& v, const cell_window& w) noexcept
      : raster(r), value(v), x_last(w.x_last), wide(prepare_mix<lanes<number>::count>(v)), narrow(prepare_mix<4>(v)) {}

  template <class F>
  IRG_INLINE void mix_chunk(pixel* there, const F& coverage) const noexcept {
    constexpr int count = lanes<F>::count;
    const auto c = in_both_halves<count>(aa_truncate(coverage));
    if constexpr (count == 4)
      mix_all<count>(there, narrow, c);
    else
      mix_all<count>(there, wide, c);
  }

  template <class F, class Row>
  IRG_INLINE void run(int y, int first, int last, int origin, int sign, const Row& row) const noexcept {
    constexpr int count = lanes<F>::count;
    pixel* const line = raster_traits<R>::row(raster, y);
    int x = first;
    for (; x < last && x_last - x >= count; x += count) mix_chunk<F>(line + x, row(aa_indices<F>(x, origin, sign)));
    if (x >= last) return;
    float rest[static_cast<unsigned>(count)];
    lanes<F>::store(rest, row(aa_indices<F>(x, origin, sign)));
    for (int i = 0; x < last; ++x, ++i) line[x] = mix(line[x], value, static_cast<std::uint8_t>(aa_truncate(rest[i])));
  }

  // A run of `length` pixels from column `origin` on in direction `sign`.
  // needs   the window holds it and as many pixels behind it as fill the last chunk
  template <class F, class Row>
  IRG_INLINE void run_inside(int y, int length, int origin, int sign, const Row& row) const noexcept {
    constexpr int count = lanes<F>::count;
    pixel* there = raster_traits<R>::row(raster, y) + (sign > 0 ? origin : origin - (count - 1));
    F k = aa_indices<F>(sign > 0 ? 0 : 1 - count, 0, sign);
    for (int done = 0; done < length; done += count, there += sign * count) {
      mix_chunk<F>(there, row(k));
      k = k + lanes<F>::broadcast(static_cast<float>(count));
    }
  }

  // `rows` rows from y on between the caps of a thin line.
  // needs   as run_inside; runs of count pixels or less when Single
  template <bool Single, class F>
  IRG_INLINE void thin_rows_inside(int y, int sign_y, int rows, int base, int sign, aa_walk walk, std::int64_t reach,
                                   aa_thin_row<F> row) const noexcept {
    constexpr int count = lanes<F>::count;
    const int aside = sign > 0 ? 0 : 1 - count;
    const F fixed = row.before_shift(aa_indices<F>(aside, 0, sign));
    for (; rows > 0; --rows, y += sign_y, walk.x += walk.step) {
      row.enter(walk.fraction());
      const int column = walk.column();
      const int origin = base + (sign > 0 ? column : -column);
      if constexpr (Single)
        mix_chunk<F>(raster_traits<R>::row(raster, y) + origin + aside, row.shifted(fixed));
      else
        run_inside<F>(y, walk.end_column(reach) - column, origin, sign, row);
    }
  }
};

// Mixes a colour into the pixels of a slender line.
template <class R>
struct aa_slender_writer {
  using four = aa_four;
  static constexpr bool writes_slender = EvenRowRaster<R>;
  using pixel = pixel_of<R>;
  R& raster;
  const pixel& value;
  static constexpr int pixels_at_once = native_lanes<std::uint32_t>;  // of eight, two steps are taken at once
  mix_colour<pixels_at_once> colour;

  IRG_INLINE aa_slender_writer(R& r, const pixel& v) noexcept
      : raster(r), value(v), colour(prepare_mix<pixels_at_once>(v)) {}

  IRG_INLINE void bytes(int y, int first, int last, const std::uint8_t* coverage) const noexcept {
    mix_run(raster_traits<R>::row(raster, y) + first, static_cast<std::size_t>(last - first), coverage, value);
  }
  // Step i is row i, its pixels lie side by side.
  // needs   the window holds all its fours
  IRG_INLINE void steep_inside(const aa_slender<four>& s) const noexcept {
    const std::ptrdiff_t pitch = bytes_per_row_of(raster);
    draw(
        s, pitch, sizeof(pixel),
        [&](int k) { return bytes_of(raster_traits<R>::row(raster, s.ends.along[k]) + s.ends.aside[k]); },
        bytes_of(raster_traits<R>::row(raster, s.first) + s.middle), beside{});
  }
  // Step i is column i, its pixels lie above each other.
  IRG_INLINE void flat_inside(const aa_slender<four>& s) const noexcept {
    const std::ptrdiff_t pitch = bytes_per_row_of(raster);
    draw(
        s, sizeof(pixel), pitch,
        [&](int k) { return bytes_of(raster_traits<R>::row(raster, s.ends.aside[k]) + s.ends.along[k]); },
        bytes_of(raster_traits<R>::row(raster, s.middle) + s.first), above{pitch});
  }

private:
  using words = mix_words_of<4>;
  using W = lanes<words>;

  IRG_INLINE static unsigned char* bytes_of(pixel* p) noexcept { return reinterpret_cast<unsigned char*>(p); }

  // How four pixels are read and written that lie side by side, or above each other.
  struct beside {
    IRG_INLINE words read(const unsigned char* p) const noexcept { return W::load_bytes(p); }
    IRG_INLINE void write(unsigned char* p, const words& w) const noexcept { W::store_bytes(p, w); }
  };
  struct above {
    std::ptrdiff_t pitch;
    IRG_INLINE words read(const unsigned char* p) const noexcept {
      const auto one = [&](int i) { return lanes<std::uint32_t>::load_bytes(p + i * pitch); };
      return pack_of(one(0), one(1), one(2), one(3));
    }
    IRG_INLINE void write(unsigned char* p, const words& w) const noexcept {
      for (int i = 0; i < 4; ++i) lanes<std::uint32_t>::store_bytes(p + i * pitch, w[i]);
    }
  };

  template <class End, class Fours>
  IRG_INLINE void draw(const aa_slender<four>& s, std::ptrdiff_t along_bytes, std::ptrdiff_t aside_bytes,
                       const End& end, unsigned char* there, const Fours& fours) const noexcept {
    if constexpr (pixels_at_once == 8)
      draw_by_two(s, along_bytes, aside_bytes, end, there, fours);
    else
      draw_by_one(s, along_bytes, aside_bytes, end, there, fours);
  }

  template <class End, class Fours>
  IRG_INLINE void draw_by_two(const aa_slender<four>& s, std::ptrdiff_t along_bytes, std::ptrdiff_t aside_bytes,
                              const End& end, unsigned char* there, const Fours& fours) const noexcept {
    constexpr int bits = aa_slender<four>::walk_bits;
    using eight = pack<float, 8>;
    const auto mix_two = [&](unsigned char* p, unsigned char* q, const mix_halves_of<8>& coverage) {
      const auto both = shuffled<0, 1, 2, 3, 4, 5, 6, 7>(fours.read(p), fours.read(q));
      const auto mixed = mix_words<8>(both, colour, coverage);
      fours.write(p, low_half(mixed));
      fours.write(q, high_half(mixed));
    };
    for (int k = 0; k < 4; k += 2)
      mix_two(end(k), end(k + 1), load_coverages<8>(reinterpret_cast<const std::uint8_t*>(s.ends.coverage + k)));
    const aa_slender_steps<eight> two(s);
    const eight aside = repeated<8>(lanes<four>::load(s.aside));
    // Of an odd number, the last is taken with a step behind it that gets coverage 0: a loop for it alone would cost
    // more, being mistaken half the time.
    const auto second = pack_of(0, 0, 0, 0, 1, 1, 1, 1);
    std::int32_t walk = s.walk;
    float along = s.along;
    for (int n = s.steps; n > 0; n -= 2, along += 2.0f, walk += 2 * s.walk_step, there += 2 * along_bytes) {
      const int c0 = walk >> bits, c1 = (walk + s.walk_step) >> bits;
      const float x0 = static_cast<float>(c0), x1 = static_cast<float>(c1), y1 = along + 1.0f;
      const eight column = pack_of(x0, x0, x0, x0, x1, x1, x1, x1),
                  at = pack_of(along, along, along, along, y1, y1, y1, y1);
      const auto coverage = aa_truncate(two(aside, column, at)) & (second < n);
      mix_two(there + c0 * aside_bytes, there + along_bytes + c1 * aside_bytes, in_both_halves<8>(coverage));
    }
  }

  template <class End, class Fours>
  IRG_INLINE void draw_by_one(const aa_slender<four>& s, std::ptrdiff_t along_bytes, std::ptrdiff_t aside_bytes,
                              const End& end, unsigned char* there, const Fours& fours) const noexcept {
    constexpr int bits = aa_slender<four>::walk_bits;
    const auto mix_four = [&](unsigned char* p, const mix_halves_of<4>& coverage) {
      fours.write(p, mix_words<4>(fours.read(p), colour, coverage));
    };
    for (int k = 0; k < 4; ++k)
      mix_four(end(k), load_coverages<4>(aa_in_memory(static_cast<std::uint32_t>(s.ends.coverage[k])).data()));
    const aa_slender_steps<four> one(s);
    const four aside = lanes<four>::load(s.aside);
    std::int32_t walk = s.walk;
    float along = s.along;
    for (int n = s.steps; n > 0; --n, along += 1.0f, walk += s.walk_step, there += along_bytes) {
      const int column = walk >> bits;
      mix_four(there + column * aside_bytes,
               in_both_halves<4>(aa_truncate(
                   one(aside, lanes<four>::broadcast(static_cast<float>(column)), lanes<four>::broadcast(along)))));
    }
  }
};

}  // namespace irg::detail::inline IRG_ABI
