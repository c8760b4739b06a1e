// SPDX-License-Identifier: MIT
// The inner loop of draw_line: a line as a walk in fixed point over rows of pixels, with one division per line and no
// branch per step but the loop's own. The cells are exactly those of line_bresenham.
//
// Step i of n lies aside by floor(v), v = (2*i*m + n - 1 + tie) / 2n, a multiple of 1/2n. So any number from v up to,
// but without, v + 1/2n has the same floor. The walk computes part + i * slope in units of 2^-k, where
//     slope = ceil(m * 2^k / n) - 1      is short of the true slope by at most one unit (0 when m is 0), and
//     part  = v(0) * 2^k + steps         rounded up, makes up for it in advance.
// The sum is never below v, and above it by less than steps + 1 units: right as long as 2n * (steps + 1) <= 2^k.
//   k = 32  serves whole lines up to n = 46340;
//   k = 64  serves the visible steps (fewer than 2^31) of every other line (n < 2^32).
// A step aside happens when the sum's fraction overflows: the carry selects the step. The octant is a mask. As branches
// both would be mispredicted again and again, which is what the textbook loop pays for.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/raster/detail/line_frame.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>

namespace irg::detail::inline IRG_ABI {

// Which way a line runs. The masks have all bits set when their name is true, else none.
struct line_octant {
  std::ptrdiff_t sign_x, sign_y;  // 1 or -1
  std::ptrdiff_t steep;

  // What to add per step along the line's longer axis, and per step aside, where pixels and rows are that far apart.
  IRG_INLINE constexpr std::ptrdiff_t along(std::ptrdiff_t pixel, std::ptrdiff_t row) const noexcept {
    return (sign_x * pixel & ~steep) | (sign_y * row & steep);
  }
  IRG_INLINE constexpr std::ptrdiff_t aside(std::ptrdiff_t pixel, std::ptrdiff_t row) const noexcept {
    return (sign_x * pixel & steep) | (sign_y * row & ~steep);
  }
};

// A walk over `cells` cells from `start` on.
template <class Fraction>
struct line_walk {
  Fraction part, slope;
  int cells;
  cell start;
  line_octant octant;
};

inline constexpr std::int64_t longest_walk_in_32_bits = 46340;  // 2n * (n + 1) <= 2^32

// Lines steeper than 45 degrees touch a new row, that is a new cache line, at every step. In a raster larger than the
// caches near the core it pays to ask for those some steps ahead.
inline constexpr std::ptrdiff_t raster_that_misses_caches = std::ptrdiff_t{1} << 20;  // bytes
inline constexpr int cells_fetched_ahead = 16;

// The pixels of a raster as bytes: pixel (x, y) is at first + y * distance + x * sizeof(P).
template <class P>
struct byte_rows {
  char* first;
  std::ptrdiff_t distance;

  IRG_INLINE std::ptrdiff_t offset(cell c) const noexcept {
    return c.y * distance + c.x * static_cast<std::ptrdiff_t>(sizeof(P));
  }
  IRG_INLINE P* at(std::ptrdiff_t offset) const noexcept { return reinterpret_cast<P*>(first + offset); }
};

// needs   a raster that is not empty
template <EvenRowRaster R>
IRG_INLINE byte_rows<pixel_of<R>> byte_rows_of(R& raster) noexcept {
  return {reinterpret_cast<char*>(raster_traits<R>::row(raster, 0)), bytes_per_row_of(raster)};
}

// How far it is to the next cell: `straight`, or `aside` when the fraction overflows. Compilers make a branch of the
// plain words here, or a mask that waits for the mask before it; both cost more than the rest of the step. (&: part is
// written before aside is read, so they must not share a register.)
template <class Fraction>
IRG_INLINE std::ptrdiff_t step(Fraction& part, Fraction slope, std::ptrdiff_t straight, std::ptrdiff_t aside) noexcept {
#if defined(__GNUC__) && defined(__x86_64__) && defined(__LP64__)
  asm("add {%2, %0|%0, %2}\n\tcmovc {%3, %1|%1, %3}" : "+&r"(part), "+r"(straight) : "r"(slope), "r"(aside) : "cc");
  return straight;
#else
  part += slope;
  return part < slope ? aside : straight;
#endif
}

// A walk over bytes.
template <class Fraction>
struct byte_walk {
  std::ptrdiff_t here, straight, aside;
  Fraction part, slope;

  // The byte of the next cell.
  IRG_INLINE std::ptrdiff_t next() noexcept {
    const std::ptrdiff_t at = here;
    here += step(part, slope, straight, aside);
    return at;
  }
};

template <class P, class Fraction>
IRG_INLINE byte_walk<Fraction> bytes_of(const byte_rows<P>& rows, const line_walk<Fraction>& walk) noexcept {
  constexpr auto size = static_cast<std::ptrdiff_t>(sizeof(P));
  const std::ptrdiff_t along = walk.octant.along(size, rows.distance), aside = walk.octant.aside(size, rows.distance);
  return {rows.offset(walk.start), along, along + aside, walk.part, walk.slope};
}

// Calls plot(pixel) for the next cells of a walk, in order.
// needs   cells > 0
template <class P, class Fraction, class Plot>
IRG_INLINE void walk_bytes(const byte_rows<P>& rows, byte_walk<Fraction>& bytes, int cells, const Plot& plot) {
  do plot(rows.at(bytes.next()));
  while (--cells > 0);
}

template <class P, class Fraction, class Plot>
IRG_INLINE void walk_line(const byte_rows<P>& rows, const line_walk<Fraction>& walk, const Plot& plot) {
  byte_walk<Fraction> bytes = bytes_of(rows, walk);
  walk_bytes(rows, bytes, walk.cells, plot);
}

// The same, asking for the pixels of a block of cells before any of them is touched.
template <class P, class Fraction, class Plot>
IRG_NOINLINE void walk_line_ahead(const byte_rows<P> rows, const line_walk<Fraction> walk, const Plot plot) {
  byte_walk<Fraction> bytes = bytes_of(rows, walk);
  for (int cells = walk.cells; cells > 0; cells -= cells_fetched_ahead) {
    const int block = minimum(cells, cells_fetched_ahead);
    byte_walk<Fraction> scout = bytes;
    for (int i = 0; i < block; ++i) prefetch_to_write(rows.first + scout.next());
    walk_bytes(rows, bytes, block, plot);
  }
}

// Whether walk_line_ahead pays.
template <class Fraction>
IRG_INLINE bool misses_caches(const line_walk<Fraction>& walk, std::ptrdiff_t distance, int height) noexcept {
  return walk.cells > cells_fetched_ahead && walk.octant.steep &&
         (distance < 0 ? -distance : distance) * height > raster_that_misses_caches;
}

// needs   cells less than 2^31 apart
IRG_INLINE constexpr line_octant octant_of(cell a, cell b, bool steep) noexcept {
  return {((b.x - a.x) >> 31) | 1, ((b.y - a.y) >> 31) | 1, -static_cast<std::ptrdiff_t>(steep)};
}

IRG_INLINE constexpr line_octant octant_of(const bresenham_frame& f) noexcept {
  return {f.steep ? f.sign_aside : f.sign_along, f.steep ? f.sign_along : f.sign_aside,
          -static_cast<std::ptrdiff_t>(f.steep)};
}

// The slope and the first part of a walk of n steps from a line's start, m of them aside. v(0) is (n - 1)/2n, or 1/2
// where ties go to the end's side; the parts are 2^31 - 1, the greatest number below the tie, and 2^31 + n.
// needs   1 <= n <= longest_walk_in_32_bits, m <= n
IRG_INLINE constexpr std::uint32_t slope_32(std::uint64_t n, std::uint64_t m) noexcept {
  return static_cast<std::uint32_t>(((m << 32) - (m != 0 ? 1u : 0u)) / n);
}
IRG_INLINE constexpr std::uint32_t part_32(std::uint32_t n, bool to_the_end) noexcept {
  return to_the_end ? 0x80000000u + n : 0x7fffffffu;
}

// The walk over a whole line.
// needs   1 <= n <= longest_walk_in_32_bits, n and m being the line's longer and shorter extent
IRG_INLINE constexpr line_walk<std::uint32_t> whole_walk(cell a, std::uint32_t n, std::uint32_t m,
                                                         const line_octant& octant,
                                                         const line_options& options) noexcept {
  const bool to_the_end = options.ties == line_ties::symmetric && (octant.steep ? octant.sign_y : octant.sign_x) < 0;
  return {part_32(n, to_the_end), slope_32(n, m), static_cast<int>(n) + (options.ends == line_ends::closed ? 1 : 0), a,
          octant};
}

// The steps [first, last) of a line, as whole_walk would reach them.
// needs   f.n <= longest_walk_in_32_bits
constexpr line_walk<std::uint32_t> walk_of_steps_32(const bresenham_frame& f, const step_range& steps) noexcept {
  const std::uint32_t slope = slope_32(static_cast<std::uint64_t>(f.n != 0 ? f.n : 1), static_cast<std::uint64_t>(f.m));
  const std::uint64_t sum =
      part_32(static_cast<std::uint32_t>(f.n), f.tie != 0) + static_cast<std::uint64_t>(steps.first) * slope;
  return {static_cast<std::uint32_t>(sum), slope, static_cast<int>(steps.last - steps.first),
          f.at(steps.first, static_cast<std::int64_t>(sum >> 32)), octant_of(f)};
}

// The same for every line, with 128-bit divisions.
// needs   fewer than 2^31 steps, f.n > 0
constexpr line_walk<std::uint64_t> walk_of_steps_64(const bresenham_frame& f, const step_range& steps) noexcept {
  const int128 twice = int128{2} * f.n, v = int128{2} * steps.first * f.m + f.n - 1 + f.tie;
  const auto count = static_cast<std::uint64_t>(steps.last - steps.first);
  const auto aside = static_cast<std::int64_t>(v / twice);
  const auto wide = [](auto x) { return static_cast<uint128>(x); };
  const auto part = static_cast<std::uint64_t>((wide(v - twice * aside) << 64) / wide(twice)) + count;
  const auto slope = static_cast<std::uint64_t>(((wide(f.m) << 64) - (f.m != 0 ? 1u : 0u)) / wide(f.n));
  return {part, slope, static_cast<int>(count), f.at(steps.first, aside), octant_of(f)};
}

// The lines that walk_line_in leaves over.
template <EvenRowRaster R, class Plot>
IRG_NOINLINE void walk_clipped_line(R& raster, cell a, cell b, const cell_window& window, const line_options& options,
                                    Plot plot) {
  const bresenham_frame f = frame_of(a, b, options.ties);
  const auto draw = [&](const auto& walk) {
    const byte_rows<pixel_of<R>> rows = byte_rows_of(raster);
    if (misses_caches(walk, rows.distance, height_of(raster)))
      walk_line_ahead(rows, walk, plot);
    else
      walk_line(rows, walk, plot);
  };
  if (f.n <= longest_walk_in_32_bits) {
    const step_range steps = visible_steps<std::int64_t>(f, window, options.ends);
    if (steps.first < steps.last) draw(walk_of_steps_32(f, steps));
  } else {
    const step_range steps = visible_steps(f, window, options.ends);
    if (steps.first < steps.last) draw(walk_of_steps_64(f, steps));
  }
}

// Calls plot(pixel) for each pixel of the line from a to b that lies in the window, in order.
// needs   a window within the raster
template <EvenRowRaster R, class Plot>
IRG_INLINE void walk_line_in(R& raster, cell a, cell b, const cell_window& window, const line_options& options,
                             Plot plot) {
  const int left = minimum(a.x, b.x), right = maximum(a.x, b.x), top = minimum(a.y, b.y), bottom = maximum(a.y, b.y);
  // Counted, not joined by "and", so that there is one branch: of one for each side, those that a line far away takes
  // could not be foretold.
  const int held = int{left >= window.x_first} + int{right < window.x_last} + int{top >= window.y_first} +
                   int{bottom < window.y_last};
  if (held < 4) {
    const int apart = int{right < window.x_first} + int{left >= window.x_last} + int{bottom < window.y_first} +
                      int{top >= window.y_last};
    if (apart == 0 && !window.empty()) walk_clipped_line(raster, a, b, window, options, plot);
    return;
  }
  const int width = right - left, height = bottom - top;  // no overflow: both are less than the window's
  const auto n = static_cast<std::uint32_t>(maximum(width, height)),
             m = static_cast<std::uint32_t>(minimum(width, height));
  if (n - 1 >= longest_walk_in_32_bits) return walk_clipped_line(raster, a, b, window, options, plot);  // 0, too
  const line_walk<std::uint32_t> walk = whole_walk(a, n, m, octant_of(a, b, height >= width), options);
  const byte_rows<pixel_of<R>> rows = byte_rows_of(raster);
  if (misses_caches(walk, rows.distance, height_of(raster))) return walk_line_ahead(rows, walk, plot);
  walk_line(rows, walk, plot);
}

// Writes value to the pixels of a level line.
// needs   a.y == b.y
template <RowRaster R>
IRG_NOINLINE constexpr void draw_level_line(R& raster, cell a, cell b, const cell_window& window, line_ends ends,
                                            const pixel_of<R>& value) {
  const std::int64_t closed = ends == line_ends::closed ? 1 : 0;
  const std::int64_t low = a.x <= b.x ? a.x : b.x + 1 - closed,
                     high = a.x <= b.x ? b.x + closed : a.x + std::int64_t{1};
  const int first = static_cast<int>(maximum(low, std::int64_t{window.x_first}));
  const int last = static_cast<int>(minimum(high, std::int64_t{window.x_last}));
  if (a.y >= window.y_first && a.y < window.y_last && first < last)
    fill_pixels(raster_traits<R>::row(raster, a.y) + first, static_cast<std::size_t>(last - first), value);
}

}  // namespace irg::detail::inline IRG_ABI
