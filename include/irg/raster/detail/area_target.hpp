// SPDX-License-Identifier: MIT
// Where rows of coverages go: to a sink as spans, or straight into pixels of four 8-bit channels.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/detail/mix_kernel.hpp>

namespace irg {
namespace detail {

// Gathers coverages into spans.
template <class Sink>
struct area_span_target {
  static constexpr bool takes_uncovered = false;  // columns without coverage
  static constexpr int most = 256;
  Sink& sink;
  int y = 0, x = 0, count = 0;
  std::uint8_t coverage[most] = {};

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
    for (int i = 0; i < n; ++i) coverage[count + i] = static_cast<std::uint8_t>(lane(c, i));
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
};

inline namespace IRG_ABI {

// Mixes a colour into rows.
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
  IRG_INLINE void mix_some(int x, int n, const pack<std::int32_t, N>& c) const noexcept {
    irg::detail::mix_some<N>(row + x, n, colour, in_both_halves<N>(c));
  }
  template <int N>
  IRG_INLINE void mix_all(int x, const pack<std::int32_t, N>& c) const noexcept {
    irg::detail::mix_all<N>(row + x, colour, in_both_halves<N>(c));
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
};

}  // namespace IRG_ABI

}  // namespace detail
}  // namespace irg
