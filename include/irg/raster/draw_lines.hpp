// SPDX-License-Identifier: MIT
// draw_lines: many lines in one call, with the same bytes as one by one in their order. Where it pays they are sorted
// by tiles of the raster first, so that memory is met tile by tile instead of at random.
#pragma once

#include <cstddef>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/raster/detail/compiled_rasters.hpp>
#include <irg/raster/detail/line_kernel.hpp>
#include <irg/raster/draw_line.hpp>

namespace irg {

/// A line from a cell to a cell.
struct cell_line {
  cell from, to;
  friend constexpr bool operator==(const cell_line&, const cell_line&) = default;
};

/// A line that has its own paint.
template <class Paint>
struct painted_line {
  cell from, to;
  Paint paint;
};

/// Lines in sequence. Models: std::vector<cell_line>, std::span, any container whose elements have cells `from` and
/// `to`.
template <class T>
concept LineSequence = requires(const T& lines, std::size_t i) {
  { lines.size() } -> std::convertible_to<std::size_t>;
  { lines[i].from } -> std::convertible_to<cell>;
  { lines[i].to } -> std::convertible_to<cell>;
};

/// Lines in sequence that each have a member `paint`, fit for a raster of type R.
template <class T, class R>
concept PaintedLineSequence = LineSequence<T> && requires(const T& lines, std::size_t i) {
  requires PaintFor<std::remove_cvref_t<decltype(lines[i].paint)>, R>;
};

namespace detail {

struct line_piece {
  std::uint32_t part, slope;
  cell start;
  std::uint16_t cells;
  std::uint16_t octant;  // see octant_number
  std::uint32_t line;
};

// The memory of a batch: the pieces of each tile in the order of the lines; or whole lines, their tiles, and where in
// the sorted lines the next one of each tile goes.
template <class Piece = line_piece>
struct line_pieces {
  std::vector<std::vector<Piece>> of_tile;
  std::size_t count = 0;
  std::vector<cell_line> sorted;
  std::vector<std::uint32_t> tile, next;

  // Makes room for a number of tiles, all empty: an exception may have left pieces of an earlier call.
  IRG_INLINE void start(std::size_t tiles) {
    if (count != 0)
      for (std::vector<Piece>& t : of_tile) t.clear();
    count = 0;
    if (of_tile.size() < tiles) of_tile.resize(tiles);
  }
};

}  // namespace detail

/// The memory that draw_lines sorts in. One that is kept lets later calls do without allocation.
class line_batch {
public:
  /// For the use of draw_lines.
  IRG_INLINE detail::line_pieces<>& pieces() noexcept { return pieces_; }

private:
  detail::line_pieces<> pieces_;
};

inline namespace IRG_ABI {

/// Paints the lines one after the other, as draw_line does.
/// gives   nothing for an empty sequence and lines that miss the raster's window
/// exact   the bytes of one draw_line per line, in order; a function paint is called as often and in that order
/// cost    sorted when the raster exceeds the caches and the lines are long and many; allocates then, unless memory is
///         left from an earlier call
template <WritableRaster R, LineSequence Lines, PaintFor<R> Paint = pixel_of<R>, class Memory = line_batch>
  requires std::same_as<Memory&, line_batch&>
constexpr void draw_lines(R& raster, const Lines& lines, const Paint& paint, const line_options& options = {},
                          Memory&& memory = Memory{});

/// The same, each line in its own paint.
template <WritableRaster R, PaintedLineSequence<R> Lines, class Memory = line_batch>
  requires std::same_as<Memory&, line_batch&>
constexpr void draw_painted_lines(R& raster, const Lines& lines, const line_options& options = {},
                                  Memory&& memory = Memory{});

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <CompiledPixel P>
IRG_API void draw_line_batch(const image_view<P>& raster, const cell_window& w, std::span<const cell_line> lines,
                             const P& value, const line_options& options, line_batch& memory);
template <CompiledPixel P>
IRG_API void draw_painted_batch(const image_view<P>& raster, const cell_window& w,
                                std::span<const painted_line<P>> lines, const line_options& options,
                                line_batch& memory);

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

// The inner loops of draw_lines. Random lines over a picture that is larger than the caches wait for memory at nearly
// every cell. So lines are cut where they cross the borders of tiles, and the pieces drawn tile by tile, in each tile
// in the order of the lines. A pixel belongs to one tile, so it sees the lines in their order.
//
// A piece is the walk of line_kernel.hpp in small: it starts with the fraction that the whole line's walk has there, so
// its cells are the whole line's, and drawing it needs no division.

// The tiles of a window, numbered row by row.
struct tile_grid {
  cell_window window;
  int width_bits, height_bits;  // of a tile
  std::uint32_t columns, count;
};

inline constexpr int tile_row_bytes = 1024, tile_height_bits = 6;  // 64 KiB
inline constexpr std::uint32_t most_tiles = 4096;
inline constexpr std::size_t pieces_at_once = std::size_t{1} << 18;  // 6 MiB
inline constexpr std::size_t most_pieces_kept = 4 * pieces_at_once;  // room for them, in all tiles together

// How the lines of a batch are put in order: as given; whole, by the tile that holds their middle, which is only for
// lines that all write one value; or in pieces, by tile.
enum class batch_order { given, by_middle, by_piece };

// Sorting pays when every cache line of the window is met several times, by lines long enough to gain from it more than
// the sorting costs (measured on 1920 x 1080 pixels of 4 bytes).
inline constexpr std::uint64_t fewest_cells_per_cache_line = 3, cache_line_bytes = 64;
inline constexpr std::uint64_t shortest_by_middle = 12, shortest_by_piece = 48, longest_by_middle = 200;
inline constexpr std::size_t lines_sampled = 64, lines_at_once = std::size_t{1} << 18;

constexpr tile_grid tiles_of(const cell_window& window, std::size_t pixel_bytes) noexcept {
  tile_grid g{window, 4, tile_height_bits, 0, 0};
  while (g.width_bits < 10 && (pixel_bytes << (g.width_bits + 1)) <= tile_row_bytes) ++g.width_bits;
  const auto width = static_cast<std::uint32_t>(window.x_last - window.x_first) - 1,
             height = static_cast<std::uint32_t>(window.y_last - window.y_first) - 1;
  for (;;) {
    g.columns = (width >> g.width_bits) + 1;
    const std::uint64_t count = std::uint64_t{g.columns} * ((height >> g.height_bits) + 1);
    g.count = static_cast<std::uint32_t>(count);
    if (count <= most_tiles) return g;
    ++(g.width_bits < g.height_bits ? g.width_bits : g.height_bits);
  }
}

// Bits 0 to 2: to the left, upwards, steep.
IRG_INLINE constexpr unsigned octant_number(const line_octant& o) noexcept {
  return (o.sign_x < 0 ? 1u : 0u) | (o.sign_y < 0 ? 2u : 0u) | (o.steep ? 4u : 0u);
}

// The cells from position r of a tile of 2^bits to its end, r among them; to its beginning when backwards.
IRG_INLINE constexpr std::uint32_t cells_to_border(std::uint32_t r, int bits, bool backwards) noexcept {
  const std::uint32_t last = (1u << bits) - 1;
  return last + 1 - ((backwards ? r ^ last : r) & last);
}

// Calls sink(piece, tile) for the pieces of a walk, from its start to its end.
// needs   a walk in the grid's window
template <class Emit>
IRG_INLINE constexpr void cut_walk(const line_walk<std::uint32_t>& walk, const tile_grid& grid, std::uint32_t line,
                                   Emit&& sink) {
  const unsigned octant = octant_number(walk.octant);
  const bool left = octant & 1, up = octant & 2, steep = octant & 4;
  const std::uint64_t slope = walk.slope;
  std::uint32_t part = walk.part, cells = static_cast<std::uint32_t>(walk.cells);
  auto x = static_cast<std::uint32_t>(walk.start.x), y = static_cast<std::uint32_t>(walk.start.y);
  while (cells > 0) {
    const std::uint32_t in_x = x - static_cast<std::uint32_t>(grid.window.x_first),
                        in_y = y - static_cast<std::uint32_t>(grid.window.y_first);
    const std::uint32_t to_x = cells_to_border(in_x, grid.width_bits, left),
                        to_y = cells_to_border(in_y, grid.height_bits, up);
    const std::uint32_t along = steep ? to_y : to_x, aside = steep ? to_x : to_y;
    std::uint32_t count = minimum(cells, along);
    if ((part + (count - 1) * slope) >> 32 >= aside)  // the border aside comes first: where part + i * slope reaches it
      count = static_cast<std::uint32_t>(((std::uint64_t{aside} << 32) - part + slope - 1) / slope);
    sink(line_piece{part,
                    walk.slope,
                    {static_cast<int>(x), static_cast<int>(y)},
                    static_cast<std::uint16_t>(count),
                    static_cast<std::uint16_t>(octant),
                    line},
         (in_y >> grid.height_bits) * grid.columns + (in_x >> grid.width_bits));
    const std::uint64_t sum = part + count * slope;
    const auto steps_aside = static_cast<std::uint32_t>(sum >> 32);
    const std::uint32_t dx = steep ? steps_aside : count, dy = steep ? count : steps_aside;
    part = static_cast<std::uint32_t>(sum);
    x += left ? 0u - dx : dx;
    y += up ? 0u - dy : dy;
    cells -= count;
  }
}

// Draws the pieces of the first tiles and forgets them. value_of(line) is the pixel to write. Memory is kept for the
// next pieces, but not without end: lines that come in the order of the tiles would have every tile keep its most.
template <class P, class ValueOf>
void draw_pieces(const byte_rows<P>& rows, line_pieces<>& pieces, std::uint32_t tiles, const ValueOf& value_of) {
  constexpr auto size = static_cast<std::ptrdiff_t>(sizeof(P));
  std::ptrdiff_t straight[8], aside[8];
  for (int o = 0; o < 8; ++o) {
    const line_octant octant{o & 1 ? -1 : 1, o & 2 ? -1 : 1, o & 4 ? -1 : 0};
    straight[o] = octant.along(size, rows.distance);
    aside[o] = straight[o] + octant.aside(size, rows.distance);
  }
  if (pieces.count == 0) return;
  std::size_t kept = 0;
  for (std::uint32_t t = 0; t < tiles; ++t) {
    for (const line_piece& piece : pieces.of_tile[t]) {
      const P value = value_of(piece.line);
      byte_walk<std::uint32_t> bytes{rows.offset(piece.start), straight[piece.octant], aside[piece.octant], piece.part,
                                     piece.slope};
      walk_bytes(rows, bytes, piece.cells, [&](P* pixel) { *pixel = value; });
    }
    pieces.of_tile[t].clear();
    kept += pieces.of_tile[t].capacity();
    if (kept > most_pieces_kept) {
      kept -= pieces.of_tile[t].capacity();
      std::vector<line_piece>().swap(pieces.of_tile[t]);
    }
  }
  pieces.count = 0;
}

// The walk over the cells of a line that lie in the window; no cells when it misses.
// needs   lines no longer than longest_walk_in_32_bits
IRG_INLINE constexpr line_walk<std::uint32_t> visible_walk(cell a, cell b, const cell_window& window,
                                                           const line_options& options) noexcept {
  const bresenham_frame f = frame_of(a, b, options.ties);
  const step_range steps = visible_steps<std::int64_t>(f, window, options.ends);
  if (steps.first >= steps.last) return {};
  return walk_of_steps_32(f, steps);
}

// The longer side of what the window leaves of a line's box, in cells; 0 when that is nothing.
constexpr std::uint64_t visible_extent(cell a, cell b, const cell_window& w) noexcept {
  const cell_window box{maximum(minimum(a.x, b.x), w.x_first), maximum(minimum(a.y, b.y), w.y_first),
                        minimum(maximum(a.x, b.x), w.x_last - 1), minimum(maximum(a.y, b.y), w.y_last - 1)};
  if (box.x_first > box.x_last || box.y_first > box.y_last) return 0;
  return static_cast<std::uint64_t>(
             maximum(std::int64_t{box.x_last} - box.x_first, std::int64_t{box.y_last} - box.y_first)) +
         1;
}

// The order to draw in, from a sample of the lines.
template <class Lines>
constexpr batch_order order_that_pays(const Lines& lines, const cell_window& window, std::size_t pixel_bytes,
                                      bool one_value) noexcept {
  const std::uint64_t size = lines.size();
  const std::uint64_t bytes = static_cast<std::uint64_t>(std::int64_t{window.x_last} - window.x_first) *
                              static_cast<std::uint64_t>(std::int64_t{window.y_last} - window.y_first) * pixel_bytes;
  if (bytes <= raster_that_misses_caches || size < lines_sampled || size > 0xffffffffu) return batch_order::given;
  std::uint64_t cells = 0;
  for (std::size_t i = 0; i < lines_sampled; ++i) {
    const auto& line = lines[static_cast<std::size_t>(size / lines_sampled * i)];
    cells += visible_extent(line.from, line.to, window);
  }
  const std::uint64_t mean = cells / lines_sampled;
  if (mean * size < fewest_cells_per_cache_line * (bytes / cache_line_bytes)) return batch_order::given;
  if (one_value && mean <= longest_by_middle)
    return mean >= shortest_by_middle ? batch_order::by_middle : batch_order::given;
  return mean >= shortest_by_piece ? batch_order::by_piece : batch_order::given;
}

// Draws lines of one value whole, sorted by the tile of their middles.
// needs   a window within the raster, not empty
template <EvenRowRaster R, class Lines>
void draw_lines_by_middle(R& raster, const Lines& lines, const cell_window& window, const line_options& options,
                          line_pieces<>& memory, const pixel_of<R>& value) {
  const tile_grid grid = tiles_of(window, sizeof(pixel_of<R>));
  const auto size = static_cast<std::size_t>(lines.size());
  const auto middle = [](int a, int b, int first, int last) {
    const auto m = static_cast<int>((std::int64_t{a} + b) >> 1);
    return static_cast<std::uint32_t>(clamped(m, first, last - 1)) - static_cast<std::uint32_t>(first);
  };
  for (std::size_t begin = 0; begin < size; begin += lines_at_once) {
    const std::size_t count = minimum(size - begin, lines_at_once);
    memory.tile.resize(count);
    memory.sorted.resize(count);
    memory.next.assign(grid.count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      const cell a = lines[begin + i].from, b = lines[begin + i].to;
      memory.tile[i] = (middle(a.y, b.y, window.y_first, window.y_last) >> grid.height_bits) * grid.columns +
                       (middle(a.x, b.x, window.x_first, window.x_last) >> grid.width_bits);
      ++memory.next[memory.tile[i]];
    }
    std::uint32_t before = 0;
    for (std::uint32_t& next : memory.next) {
      const std::uint32_t in_tile = next;
      next = before;
      before += in_tile;
    }
    for (std::size_t i = 0; i < count; ++i)
      memory.sorted[memory.next[memory.tile[i]]++] = {lines[begin + i].from, lines[begin + i].to};
    for (const cell_line& line : memory.sorted)
      walk_line_in(raster, line.from, line.to, window, options, [value](pixel_of<R>* p) { *p = value; });
  }
}

// Draws lines cut into pieces, sorted by tile. value_of(i) is the pixel that line i writes.
// needs   a window within the raster, not empty
template <EvenRowRaster R, class Lines, class ValueOf>
void draw_lines_by_piece(R& raster, const Lines& lines, const cell_window& window, const line_options& options,
                         line_pieces<>& pieces, const ValueOf& value_of) {
  const byte_rows<pixel_of<R>> rows = byte_rows_of(raster);
  const tile_grid grid = tiles_of(window, sizeof(pixel_of<R>));
  pieces.start(grid.count);
  const auto size = static_cast<std::size_t>(lines.size());
  for (std::size_t i = 0; i < size; ++i) {
    const cell a = lines[i].from, b = lines[i].to;
    const int left = minimum(a.x, b.x), right = maximum(a.x, b.x), top = minimum(a.y, b.y), bottom = maximum(a.y, b.y);
    if ((right < window.x_first) | (left >= window.x_last) | (bottom < window.y_first) | (top >= window.y_last))
      continue;
    const std::int64_t width = std::int64_t{right} - left, height = std::int64_t{bottom} - top;
    const std::int64_t n = maximum(width, height), m = minimum(width, height);
    if (n > longest_walk_in_32_bits) {  // drawn by itself, after those before it
      draw_pieces(rows, pieces, grid.count, value_of);
      const pixel_of<R> value = value_of(i);
      walk_line_in(raster, a, b, window, options, [value](pixel_of<R>* p) { *p = value; });
      continue;
    }
    const bool inside = (left >= window.x_first) & (right < window.x_last) & (top >= window.y_first) &
                        (bottom < window.y_last) & (n != 0);
    const line_walk<std::uint32_t> walk =
        inside ? whole_walk(a, static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(m),
                            octant_of(a, b, height >= width), options)
               : visible_walk(a, b, window, options);
    cut_walk(walk, grid, static_cast<std::uint32_t>(i), [&](const line_piece& piece, std::uint32_t tile) {
      pieces.of_tile[tile].push_back(piece);
      ++pieces.count;
    });
    if (pieces.count >= pieces_at_once) draw_pieces(rows, pieces, grid.count, value_of);
  }
  draw_pieces(rows, pieces, grid.count, value_of);
}

// needs   a window that is not empty
template <WritableRaster R, class Lines, class Paint>
constexpr void draw_lines_in(R& raster, const Lines& lines, const Paint& paint, const line_options& options,
                             line_batch& memory) {
  const cell_window visible = window_of(raster);
  if constexpr (EvenRowRaster<R> && !BlendFunction<Paint, R>) {
    if (!std::is_constant_evaluated()) {
      const auto value = static_cast<pixel_of<R>>(paint);
      const batch_order order = order_that_pays(lines, visible, sizeof value, true);
      if (order == batch_order::by_middle)
        return draw_lines_by_middle(raster, lines, visible, options, memory.pieces(), value);
      if (order == batch_order::by_piece)
        return draw_lines_by_piece(raster, lines, visible, options, memory.pieces(),
                                   [&](std::size_t) -> const pixel_of<R>& { return value; });
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(lines.size()); ++i)
    draw_line(raster, lines[i].from, lines[i].to, paint, options);
}
template <WritableRaster R, class Lines>
constexpr void draw_painted_in(R& raster, const Lines& lines, const line_options& options, line_batch& memory) {
  const cell_window visible = window_of(raster);
  using paint_type = std::remove_cvref_t<decltype(lines[std::size_t{}].paint)>;
  if constexpr (EvenRowRaster<R> && !BlendFunction<paint_type, R>) {
    if (!std::is_constant_evaluated() &&
        order_that_pays(lines, visible, sizeof(pixel_of<R>), false) == batch_order::by_piece)
      return draw_lines_by_piece(raster, lines, visible, options, memory.pieces(),
                                 [&](std::size_t i) { return static_cast<pixel_of<R>>(lines[i].paint); });
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(lines.size()); ++i)
    draw_line(raster, lines[i].from, lines[i].to, lines[i].paint, options);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <WritableRaster R, LineSequence Lines, PaintFor<R> Paint, class Memory>
  requires std::same_as<Memory&, line_batch&>
constexpr void draw_lines(R& raster, const Lines& lines, const Paint& paint, const line_options& options,
                          Memory&& memory) {
  const cell_window visible = window_of(raster);
  if (visible.empty()) return;
  if constexpr (detail::draws_in_library && detail::CompiledRaster<R> && !BlendFunction<Paint, R> &&
                std::convertible_to<const Lines&, std::span<const cell_line>>)
    detail::draw_line_batch(view_of(raster), visible, lines, static_cast<pixel_of<R>>(paint), options, memory);
  else
    detail::draw_lines_in(raster, lines, paint, options, memory);
}

template <WritableRaster R, PaintedLineSequence<R> Lines, class Memory>
  requires std::same_as<Memory&, line_batch&>
constexpr void draw_painted_lines(R& raster, const Lines& lines, const line_options& options, Memory&& memory) {
  const cell_window visible = window_of(raster);
  if (visible.empty()) return;
  if constexpr (detail::draws_in_library && detail::CompiledRaster<R> &&
                std::convertible_to<const Lines&, std::span<const painted_line<pixel_of<R>>>>)
    detail::draw_painted_batch<pixel_of<R>>(view_of(raster), visible, lines, options, memory);
  else
    detail::draw_painted_in(raster, lines, options, memory);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <CompiledPixel P>
IRG_API void draw_line_batch(const image_view<P>& raster, const cell_window& w, std::span<const cell_line> lines,
                             const P& value, const line_options& options, line_batch& memory) {
  image_view<P> view = raster;
  const auto target = within(view, w);
  draw_lines_in(target, lines, value, options, memory);
}
template <CompiledPixel P>
IRG_API void draw_painted_batch(const image_view<P>& raster, const cell_window& w,
                                std::span<const painted_line<P>> lines, const line_options& options,
                                line_batch& memory) {
  image_view<P> view = raster;
  const auto target = within(view, w);
  draw_painted_in(target, lines, options, memory);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
