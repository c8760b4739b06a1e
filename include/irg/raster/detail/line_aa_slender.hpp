// SPDX-License-Identifier: MIT
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

#pragma once

#include <array>
#include <bit>

#include <irg/core/sinks.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/raster/detail/area_targets.hpp>
#include <irg/raster/line_style.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg::detail::inline IRG_ABI {

// Four numbers at once where F is a pack, one after the other where it is one number.
template <class F>
using aa_four = std::conditional_t<std::is_same_v<F, float>, float, pack<float, 4>>;

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
    const F end = u + all(before), top = to_float(converted<std::int32_t>(end)) + lanes<F>::load(earlier + e),
            low = end - top, high = low - all(cap);
    const F low_from = minimum(low, one), high_from = maximum(minimum(high, one), zero);
    const F low_part = one - low_from, high_part = one - high_from, cap_part = low_from - high_from;
    const F edge = (v - all(0.5f * across)) + product(m, top - u);  // the lower edge, seen from the step's top
    const F column = to_float(converted<std::int32_t>(edge)), x = edge - column;
    const F low_x = x + product(m, low_from), high_x = (x + all(across)) + product(m, high_from),
            cap_x = (x + product(m, low)) + product(low - low_from, per);
    const F low_rise = product(m, low_part), high_rise = product(m, high_part), cap_rise = product(cap_part, per);
    const F half_inverse = all(aa_full * 0.5f * inverse), half_slope = all(aa_full * 0.5f * slope);
    const F low_full = product(low_part, all(aa_full)), high_full = product(high_part, all(aa_full)),
            cap_full = product(cap_part, all(aa_full));
    const auto below = [&](float boundary) {
      const F j = all(boundary), dl = j - low_x, dh = j - high_x, dc = j - cap_x;
      const F l = minimum(maximum(dl, zero), low_rise), h = minimum(maximum(dh, zero), high_rise),
              c0 = maximum(dc, zero), c1 = maximum(dc - cap_rise, zero);
      const F squares =
          product(product(l, l) - product(h, h), half_inverse) + product(product(c0, c0) - product(c1, c1), half_slope);
      return squares +
             (product(low_full, maximum(dl - low_rise, zero)) - product(high_full, maximum(dh - high_rise, zero)));
    };
    const F half = all(0.5f), four = all(4.0f);
    const F c1 = below(1.0f), c2 = below(2.0f), c3 = below(3.0f);
    const F whole = (product(low_full, (four - low_x) - product(low_rise, half)) +
                     product(cap_full, (four - cap_x) - product(cap_rise, half))) -
                    product(high_full, (four - high_x) - product(high_rise, half));
    const integers p0 = converted<std::int32_t>(c1 + half), p1 = converted<std::int32_t>((c2 - c1) + half),
                   p2 = converted<std::int32_t>((c3 - c2) + half), p3 = converted<std::int32_t>((whole - c3) + half);
    const integers i = (start_u >> subpixel_bits) + converted<std::int32_t>(top - all(4.0f)),
                   j = (start_v >> subpixel_bits) + converted<std::int32_t>(column - all(8.0f));
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
            v = maximum(minimum(b0 - u, m), zero), z2 = maximum(b2 - u, zero), z3 = maximum(b3 - u, zero);
    return (product((product(v, v) - product(z2, z2)) - product(z3, z3), inverse) +
            product(maximum(b1 - u, zero), lanes<F>::broadcast(aa_full))) +
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
IRG_INLINE constexpr aa_step aa_step_between(const aa_slender<F>& s, const aa_slender_steps<F>& steps, int i) noexcept {
  constexpr unsigned count = aa_slender<F>::count;
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  const int column = (s.walk + s.walk_step * i) >> aa_slender<F>::walk_bits;
  aa_step step{s.first + i, s.middle + column, 0};
  for (unsigned e = 0; e < 4; e += count) {
    step.coverage |=
        aa_bytes(converted<std::int32_t>(steps(lanes<F>::load(s.aside + e), all(static_cast<float>(column)),
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
template <class Target>
IRG_INLINE constexpr void aa_send_bytes(const cell_window& w, Target& target, int y, int first, int last,
                                        const std::uint8_t* coverage) {
  const int from = maximum(first, w.x_first), to = minimum(last, w.x_last);
  if (y >= w.y_first && y < w.y_last && from < to) target.run(y, from, to, coverage + (from - first));
}

// The steps of a steep slender line: each a row.
template <class F, class Target>
constexpr void aa_send_steep(const aa_slender<F>& s, const cell_window& w, Target& target) {
  const aa_slender_steps<F> between(s);
  const auto send = [&](const aa_step& e) {
    aa_send_bytes(w, target, e.along, e.aside, e.aside + 4, aa_in_memory(e.coverage).data());
  };
  for (unsigned k = 0; k < 4; ++k) send(aa_end_step(s, k));
  const int first = maximum(w.y_first, s.first), last = minimum(w.y_last, s.first + s.steps);
  for (int y = first; y < last; ++y) send(aa_step_between(s, between, y - s.first));
}

// The steps of a flat one, each a column: gathered into rows.
template <class F, class Target>
constexpr void aa_send_flat(const aa_slender<F>& s, const cell_window& w, Target& target) {
  constexpr unsigned most = aa_slender_flat / one_pixel + 12;  // at most 4 pixels beyond each end, 4 to a step
  struct row {
    int first = most, last = 0;
    std::uint8_t coverage[most] = {};
  };
  const aa_slender_steps<F> between(s);
  const int x = s.first - 2;
  int y = s.ends.aside[0], y_last = y;
  for (const int a : s.ends.aside) {
    y = minimum(y, a);
    y_last = maximum(y_last, a + 4);
  }
  row rows[most];
  const auto gather = [&](const aa_step& e) {
    const int column = e.along - x;
    for (int k = 0; k < 4; ++k) {
      row& r = rows[e.aside - y + k];
      r.coverage[column] = static_cast<std::uint8_t>(e.coverage >> (8 * k) & 255u);
      r.first = minimum(r.first, column), r.last = maximum(r.last, column + 1);
    }
  };
  for (unsigned k = 0; k < 4; ++k) gather(aa_end_step(s, k));
  for (int i = 0; i < s.steps; ++i) gather(aa_step_between(s, between, i));
  for (int i = 0; i < y_last - y; ++i) {
    const row& r = rows[i];
    aa_send_bytes(w, target, y + i, x + r.first, x + r.last, r.coverage + r.first);
  }
}

// Slender lines that the window holds with some pixels around them are mixed in four pixels at a time, where they are.

template <class Target>
inline constexpr bool mixes_slender = false;
template <class R>
inline constexpr bool mixes_slender<area_mix_target<R>> = EvenRowRaster<R>;

// How four pixels are read and written that lie side by side, or above each other.
struct aa_beside {
  using W = lanes<mix_words_of<4>>;
  IRG_INLINE mix_words_of<4> read(const unsigned char* p) const noexcept { return W::load_bytes(p); }
  IRG_INLINE void write(unsigned char* p, const mix_words_of<4>& w) const noexcept { W::store_bytes(p, w); }
};
struct aa_above {
  std::ptrdiff_t pitch;
  IRG_INLINE mix_words_of<4> read(const unsigned char* p) const noexcept {
    const auto one = [&](int i) { return lanes<std::uint32_t>::load_bytes(p + i * pitch); };
    return pack_of(one(0), one(1), one(2), one(3));
  }
  IRG_INLINE void write(unsigned char* p, const mix_words_of<4>& w) const noexcept {
    for (int i = 0; i < 4; ++i) lanes<std::uint32_t>::store_bytes(p + i * pitch, w[i]);
  }
};

// The steps of a slender line, two at a time where registers hold eight pixels. From a step to the next and from a
// pixel aside to the next it is so many bytes; place(along, aside): where a pixel is.
template <class Fours, class Place>
IRG_INLINE void aa_mix_steps(const aa_slender<pack<float, 4>>& s, const mix_colour<mix_lanes>& colour,
                             std::ptrdiff_t along_bytes, std::ptrdiff_t aside_bytes, const Fours& fours,
                             const Place& place) noexcept {
  constexpr int N = mix_lanes, at_once = N / 4, bits = aa_slender<pack<float, 4>>::walk_bits;
  using F = pack<float, N>;
  const auto mix = [&](unsigned char* p, unsigned char* q, const mix_halves_of<N>& coverage) {
    if constexpr (at_once == 2) {
      const auto both = shuffled<0, 1, 2, 3, 4, 5, 6, 7>(fours.read(p), fours.read(q));
      const auto mixed = mix_words<N>(both, colour, coverage);
      fours.write(p, low_half(mixed));
      fours.write(q, high_half(mixed));
    } else {
      fours.write(p, mix_words<N>(fours.read(p), colour, coverage));
    }
  };
  for (int k = 0; k < 4; k += at_once) {
    unsigned char* const p = place(s.ends.along[k], s.ends.aside[k]);
    if constexpr (at_once == 2)
      mix(p, place(s.ends.along[k + 1], s.ends.aside[k + 1]),
          load_coverages<N>(reinterpret_cast<const std::uint8_t*>(s.ends.coverage + k)));
    else
      mix(p, p, load_coverages<N>(aa_in_memory(static_cast<std::uint32_t>(s.ends.coverage[k])).data()));
  }
  const auto by_step = [](float x, float y) {
    if constexpr (at_once == 2)
      return pack_of(x, x, x, x, y, y, y, y);
    else
      return lanes<F>::broadcast(x);
  };
  const aa_slender_steps<F> steps(s);
  const F aside = repeated<N>(lanes<pack<float, 4>>::load(s.aside));
  unsigned char* there = place(s.first, s.middle);
  std::int32_t walk = s.walk;
  float along = s.along;
  for (int n = s.steps; n > 0; n -= at_once) {
    const int c0 = walk >> bits, c1 = (walk + s.walk_step) >> bits;
    auto coverage = converted<std::int32_t>(
        steps(aside, by_step(static_cast<float>(c0), static_cast<float>(c1)), by_step(along, along + 1.0f)));
    // Of an odd number, the last is taken with a step behind it that gets coverage 0: a loop for it alone would cost
    // more, being mistaken half the time.
    if constexpr (at_once == 2) coverage = coverage & (pack_of(0, 0, 0, 0, 1, 1, 1, 1) < n);
    mix(there + c0 * aside_bytes, there + along_bytes + c1 * aside_bytes, in_both_halves<N>(coverage));
    walk += at_once * s.walk_step;
    along += static_cast<float>(at_once);
    there += at_once * along_bytes;
  }
}

// Step i of a steep line is row i, its pixels lie side by side; of a flat one it is column i, they lie above each
// other.
template <class R>
IRG_INLINE void aa_mix_slender(const area_mix_target<R>& target, const aa_slender<pack<float, 4>>& s,
                               bool steep) noexcept {
  const std::ptrdiff_t pitch = bytes_per_row_of(target.raster), size = sizeof(pixel_of<R>);
  const auto place = [&](int x, int y) {
    return reinterpret_cast<unsigned char*>(raster_traits<R>::row(target.raster, y) + x);
  };
  if (steep)
    aa_mix_steps(s, target.colour, pitch, size, aa_beside{}, [&](int y, int x) { return place(x, y); });
  else
    aa_mix_steps(s, target.colour, size, pitch, aa_above{pitch}, place);
}

// Draws the line if it is slender, and nothing at all if it lies beside the window; false when that is left to others.
template <class F, class Target>
IRG_INLINE constexpr bool aa_draw_slender(const subpixel& a, const subpixel& b, const line_aa_options& options,
                                          const cell_window& w, Target& target) {
  const std::int32_t left = minimum(a.x, b.x), right = maximum(a.x, b.x), top = minimum(a.y, b.y),
                     bottom = maximum(a.y, b.y);
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
  const aa_slender<aa_four<F>> s(from, to, options.width, options.caps);
  if (!s.fits) return false;
  if constexpr (mixes_slender<Target>) {
    if (inside) {
      aa_mix_slender(target, s, steep);
      return true;
    }
  }
  if (w.empty()) return true;
  if (steep)
    aa_send_steep(s, w, target);
  else
    aa_send_flat(s, w, target);
  return true;
}

}  // namespace irg::detail::inline IRG_ABI
