// SPDX-License-Identifier: MIT
// Where the rows of an antialiased line go: to a sink as runs of coverages, or mixed straight into a raster's row.
// A writer runs over the raster's row y, columns [first, last); column x is pixel sign * (x - origin) of
// `row`, which gives 1/2 + 255 * the covered area of a pixel or of several at once.
#pragma once

#include <irg/core/sinks.hpp>
#include <irg/raster/detail/line_aa_slender.hpp>
#include <irg/raster/detail/mix_kernel.hpp>
#include <irg/raster/paint.hpp>
#include <irg/raster/window.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

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

}  // namespace IRG_ABI
}  // namespace irg::detail
