// SPDX-License-Identifier: MIT
// Where the rows of antialiased shapes go: to a sink as spans, or mixed straight into pixels of four 8-bit channels.
//
// A target is given row by row, and the columns of a row from left to right: coverages of a pack of columns at a time,
// runs of whole coverage, or a run that is in memory already.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/detail/mix_kernel.hpp>

namespace irg::detail::inline IRG_ABI {

// Rows are computed in 255ths with 1/2 added, ready to be truncated.
inline constexpr float aa_full = 255.0f, aa_half = 0.5f;

// Gathers coverages into spans.
template <class Sink>
struct area_span_target {
  static constexpr bool takes_uncovered = false;  // columns without coverage
  static constexpr int most = 256;
  Sink& sink;
  int y = 0, x = 0, count = 0;
  std::uint8_t coverage[most + native_lanes<float>] = {};

  IRG_INLINE constexpr void begin(int row) noexcept { y = row; }
  IRG_INLINE constexpr void end() {
    if (count > 0) sink(coverage_span{y, x - count, x, coverage});
    count = 0;
  }
  // The first n coverages of a number or a pack, for the columns from `at` on.
  template <class Coverages>
  IRG_INLINE constexpr void mix_some(int at, int n, const Coverages& c) {
    if (count + n > most || at != x) {
      end();
      x = at;
    }
    for (int i = 0; i < lanes<Coverages>::count; ++i) coverage[count + i] = static_cast<std::uint8_t>(lane(c, i));
    count += n;
    x += n;
  }
  template <class Coverages>
  IRG_INLINE constexpr void mix_all(int at, const Coverages& c) {
    mix_some(at, lanes<Coverages>::count, c);
  }
  // The columns [first, last): the lower half of a pack for the first ones, the upper half for the last ones, whole
  // coverage between.
  template <class Coverages>
  IRG_INLINE constexpr void mix_ends(int first, int last, const Coverages& c) {
    constexpr int half = lanes<Coverages>::count / 2;
    mix_some(first, half, c);
    if (last - first > 2 * half) fill(first + half, last - first - 2 * half);
    for (int i = 0; i < half; ++i) mix_some(last - half + i, 1, lane(c, half + i));
  }
  // The same with a pack for each end.
  template <class Coverages>
  IRG_INLINE constexpr void mix_ends(int first, int last, const Coverages& c, const Coverages& d) {
    constexpr int n = lanes<Coverages>::count;
    mix_some(first, n, c);
    if (last - first > 2 * n) fill(first + n, last - first - 2 * n);
    mix_some(last - n, n, d);
  }
  IRG_INLINE constexpr void fill(int at, int n) {
    end();
    sink(coverage_span{y, at, at + n, nullptr});
  }
  // The columns [first, last) of a row: of(x) gives 1/2 + the coverages of a pack of columns from x on. The limit is of
  // use below.
  template <class F, class Coverages>
  constexpr void columns(int row, int first, int last, [[maybe_unused]] int limit, const Coverages& of) {
    constexpr int lane_count = lanes<F>::count;
    for (int at = first; at < last; at += most) {
      const int n = minimum(most, last - at);
      for (int i = 0; i < n; i += lane_count) {
        const auto c = converted<std::int32_t>(of(at + i));
        for (int k = 0; k < lane_count; ++k) coverage[i + k] = static_cast<std::uint8_t>(lane(c, k));
      }
      sink(coverage_span{row, at, at + n, coverage});
    }
  }
  constexpr void run(int row, int first, int last, const std::uint8_t* c) { sink(coverage_span{row, first, last, c}); }
};

struct area_range {
  int first = 0, last = 0;
};

// The number of pixel x + i in lane i, counted from the origin on in direction sign. Exact: no row has 2^24 pixels.
template <class F>
IRG_INLINE constexpr F area_indices(int x, int origin, int sign) noexcept {
  const F i = lanes<F>::ramp(), k = lanes<F>::broadcast(static_cast<float>(sign * (x - origin)));
  return sign > 0 ? k + i : k - i;
}

// Mixes a colour into rows. Packs have as many lanes as a register, or four.
template <class R>
struct area_mix_target {
  static constexpr bool takes_uncovered = true;  // they keep their value
  R& raster;
  mix_colour<mix_lanes> colour;
  std::ptrdiff_t ahead;
  pixel_of<R>* row = nullptr;

  IRG_INLINE area_mix_target(R& r, const pixel_of<R>& value) noexcept
      : raster(r), colour(prepare_mix(value)), ahead(bytes_to_row_below(r)) {}
  IRG_INLINE void begin(int y) { row = raster_traits<R>::row(raster, y); }
  IRG_INLINE void end() const noexcept {}
  template <int N>
  IRG_INLINE mix_colour<N> lanes_of_colour() const noexcept {
    if constexpr (N == mix_lanes)
      return colour;
    else
      return {low_half(colour.even), low_half(colour.odd), low_half(colour.whole)};
  }
  template <int N>
  IRG_INLINE void mix_some(int x, int n, const pack<std::int32_t, N>& c) const noexcept {
    irg::detail::mix_some<N>(row + x, n, lanes_of_colour<N>(), in_both_halves<N>(c));
  }
  template <int N>
  IRG_INLINE void mix_all(int x, const pack<std::int32_t, N>& c) const noexcept {
    irg::detail::mix_all<N>(row + x, lanes_of_colour<N>(), in_both_halves<N>(c));
  }
  template <int N>
  IRG_INLINE void mix_ends(int first, int last, const pack<std::int32_t, N>& c) const noexcept {
    irg::detail::mix_ends<N>(row + first, last - first, colour, in_both_halves<N>(c), ahead);
  }
  template <int N>
  IRG_INLINE void mix_ends(int first, int last, const pack<std::int32_t, N>& c,
                           const pack<std::int32_t, N>& d) const noexcept {
    irg::detail::mix_ends<N>(row + first, last - first, colour, in_both_halves<N>(c), in_both_halves<N>(d), ahead);
  }
  IRG_INLINE void fill(int x, int n) const noexcept { fill_words<mix_lanes>(row + x, n, colour, ahead); }
  // Packs reach beyond `last` as far as they end below the limit: what follows a row has coverage 0.
  template <class F, class Coverages>
  IRG_INLINE void columns(int y, int first, int last, int limit, const Coverages& of) const noexcept {
    constexpr int n = lanes<F>::count;
    if (first >= last) return;
    pixel_of<R>* const line = raster_traits<R>::row(raster, y);
    int x = first;
    for (; x < last && limit - x >= n; x += n)
      irg::detail::mix_all<n>(line + x, lanes_of_colour<n>(), in_both_halves<n>(converted<std::int32_t>(of(x))));
    if (x < last)
      irg::detail::mix_some<n>(line + x, last - x, lanes_of_colour<n>(),
                               in_both_halves<n>(converted<std::int32_t>(of(x))));
  }
  // A row of `length` columns from x on in direction sign: of(k) gives 1/2 + the coverages of columns number k. Fills:
  // those numbered as in `solid` are covered whole.
  // needs   the raster holds them and as many more as fill the last pack
  template <class F, bool Fills, class Coverages>
  IRG_INLINE void columns_inside(int y, int x, int sign, int length, const area_range& solid,
                                 const Coverages& of) noexcept {
    constexpr int n = lanes<F>::count;
    pixel_of<R>* const line = raster_traits<R>::row(raster, y);
    pixel_of<R>* there = line + (sign > 0 ? x : x - (n - 1));
    F k = sign > 0 ? lanes<F>::ramp() : lanes<F>::broadcast(n - 1) - lanes<F>::ramp();
    int done = 0, stop = length;
    if constexpr (Fills) {
      const int from = (solid.first + (n - 1)) & -n;
      if (solid.last - from >= mix_lanes) stop = from;
    }
    while (true) {
      for (; done < stop; done += n) {
        irg::detail::mix_all<n>(there, lanes_of_colour<n>(), in_both_halves<n>(converted<std::int32_t>(of(k))));
        there += sign * n;
        k = k + lanes<F>::broadcast(static_cast<float>(n));
      }
      if (!Fills || stop == length) return;
      const int filled = solid.last - stop;
      fill_words<mix_lanes>(line + (sign > 0 ? x + stop : x - solid.last + 1), filled, colour, ahead);
      there += sign * filled;
      k = k + lanes<F>::broadcast(static_cast<float>(filled));
      done = solid.last;
      stop = length;
    }
  }
  IRG_INLINE void run(int y, int first, int last, const std::uint8_t* c) const noexcept {
    mix_run(raster_traits<R>::row(raster, y) + first, static_cast<std::size_t>(last - first), c, colour);
  }
};

}  // namespace irg::detail::inline IRG_ABI
