// SPDX-License-Identifier: MIT
// draw_lines: many lines in one call, with the same bytes as one by one in their order. Where it pays they are sorted
// by tiles of the raster first, so that memory is met tile by tile instead of at random.
#pragma once

#include <irg/raster/detail/line_batch_kernel.hpp>
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
                          Memory&& memory = Memory{}) {
  const cell_window visible = window_of(raster);
  if (visible.empty()) return;
  if constexpr (EvenRowRaster<R> && !BlendFunction<Paint, R>) {
    if (!std::is_constant_evaluated()) {
      const auto value = static_cast<pixel_of<R>>(paint);
      const detail::batch_order order = detail::order_that_pays(lines, visible, sizeof value, true);
      if (order == detail::batch_order::by_middle)
        return detail::draw_lines_by_middle(raster, lines, visible, options, memory.pieces(), value);
      if (order == detail::batch_order::by_piece)
        return detail::draw_lines_by_piece(raster, lines, visible, options, memory.pieces(),
                                           [&](std::size_t) -> const pixel_of<R>& { return value; });
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(lines.size()); ++i)
    draw_line(raster, lines[i].from, lines[i].to, paint, options);
}

/// The same, each line in its own paint.
template <WritableRaster R, PaintedLineSequence<R> Lines, class Memory = line_batch>
  requires std::same_as<Memory&, line_batch&>
constexpr void draw_painted_lines(R& raster, const Lines& lines, const line_options& options = {},
                                  Memory&& memory = Memory{}) {
  const cell_window visible = window_of(raster);
  if (visible.empty()) return;
  using paint_type = std::remove_cvref_t<decltype(lines[std::size_t{}].paint)>;
  if constexpr (EvenRowRaster<R> && !BlendFunction<paint_type, R>) {
    if (!std::is_constant_evaluated() &&
        detail::order_that_pays(lines, visible, sizeof(pixel_of<R>), false) == detail::batch_order::by_piece)
      return detail::draw_lines_by_piece(raster, lines, visible, options, memory.pieces(),
                                         [&](std::size_t i) { return static_cast<pixel_of<R>>(lines[i].paint); });
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(lines.size()); ++i)
    draw_line(raster, lines[i].from, lines[i].to, lines[i].paint, options);
}

}  // namespace IRG_ABI
}  // namespace irg
