// SPDX-License-Identifier: MIT
// line_styled: the cells of a dashed line. The pattern runs along the longer axis, one position per cell, from the
// line's start on; clipping does not shift it, and it carries on from line to line.
#pragma once

#include <cstddef>
#include <span>

#include <irg/raster/subpixel.hpp>
#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/paint.hpp>

namespace irg {

/// Dashes and gaps by length: runs[0] cells drawn, runs[1] left out, and so on; after the last run the next one is of
/// the other kind, so an odd number of runs repeats with dashes and gaps exchanged. Runs of 0 cells are allowed; no
/// runs, or all of them 0, draw the whole line. The runs are not copied.
struct dash_runs {
  std::span<const std::uint32_t> runs;
};

/// Dashes by the bits of a mask, the lowest first: position i is drawn when bit (i / repeat) mod 16 is 1, as OpenGL's
/// line stipple does. A repeat of 0 counts as 1.
struct dash_mask {
  std::uint16_t mask = 0xffff;
  std::uint32_t repeat = 1;
  bool operator==(const dash_mask&) const = default;
};

/// How a line is dashed: by dash_runs or a dash_mask, from which position of it on, and with which ends and ties.
template <class Pattern>
  requires std::same_as<Pattern, dash_runs> || std::same_as<Pattern, dash_mask>
struct line_dashes {
  Pattern pattern{};
  std::uint64_t phase = 0;
  line_options options{};
  bool operator==(const line_dashes&) const = default;
};
template <class Pattern, class... More>
line_dashes(Pattern, More...) -> line_dashes<Pattern>;

namespace detail::inline IRG_ABI {

// Walks over a pattern: how many positions remain of its present run, and whether they are drawn.
class dash_runs_walk {
public:
  constexpr explicit dash_runs_walk(const dash_runs& pattern) noexcept : runs_(pattern.runs) {
    for (const std::uint32_t run : runs_) length_ += run;
  }
  // The position modulo the pattern's length.
  constexpr std::uint64_t reduced(std::uint64_t position) const noexcept {
    return length_ == 0 ? 0 : position % (runs_.size() % 2 == 0 ? length_ : 2 * length_);
  }
  constexpr void go_to(std::uint64_t position) noexcept {
    if (length_ == 0) return;
    position = reduced(position);
    drawn_ = position < length_ || runs_.size() % 2 == 0;
    if (position >= length_) position -= length_;
    for (index_ = 0; position >= runs_[index_]; ++index_, drawn_ = !drawn_) position -= runs_[index_];
    left_ = runs_[index_] - position;
  }
  // Whether the present position is drawn; moves on by one.
  constexpr bool next() noexcept {
    if (length_ == 0) return true;
    for (; left_ == 0; left_ = runs_[index_], drawn_ = !drawn_) index_ = index_ + 1 == runs_.size() ? 0 : index_ + 1;
    --left_;
    return drawn_;
  }

private:
  std::span<const std::uint32_t> runs_;
  std::uint64_t length_ = 0, left_ = 0;
  std::size_t index_ = 0;
  bool drawn_ = true;
};

class dash_mask_walk {
public:
  constexpr explicit dash_mask_walk(const dash_mask& pattern) noexcept
      : mask_(pattern.mask), repeat_(maximum(pattern.repeat, std::uint32_t{1})) {}
  constexpr std::uint64_t reduced(std::uint64_t position) const noexcept {
    return position % (std::uint64_t{16} * repeat_);
  }
  constexpr void go_to(std::uint64_t position) noexcept {
    bit_ = static_cast<unsigned>(position / repeat_ % 16);
    left_ = repeat_ - static_cast<std::uint32_t>(position % repeat_);
  }
  constexpr bool next() noexcept {
    if (left_ == 0) {
      bit_ = (bit_ + 1) % 16;
      left_ = repeat_;
    }
    --left_;
    return (mask_ >> bit_ & 1u) != 0;
  }

private:
  std::uint32_t mask_, repeat_, left_ = 0;
  unsigned bit_ = 0;
};

constexpr dash_runs_walk walk_of(const dash_runs& pattern) noexcept { return dash_runs_walk(pattern); }
constexpr dash_mask_walk walk_of(const dash_mask& pattern) noexcept { return dash_mask_walk(pattern); }

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Calls sink(cell) for the drawn cells of the dashed line from a to b that lie in the window, in order from a on.
/// shape   cell i of the line, counted from a along the longer axis, is drawn as the pattern's position phase + i says
/// gives   the phase at b, with which the next line of a polyline goes on (draw its lines half-open, or each shared
///         vertex is drawn twice)
/// exact   for all int coordinates; clipped cells are the unclipped line's; cells, ends and ties as line_bresenham
/// cost    an addition and a subtraction per visible cell; the pattern's runs are added up once per line
template <class Pattern, CellSink Sink>
constexpr std::uint64_t line_styled(cell a, cell b, const line_dashes<Pattern>& dashes, const cell_window& window,
                                    Sink&& sink) {
  auto walk = detail::walk_of(dashes.pattern);
  const std::uint64_t phase = walk.reduced(dashes.phase);  // below 2^62 or so: a line's steps cannot overflow
  const detail::bresenham_frame f = detail::frame_of(a, b, dashes.options.ties);
  if (!window.empty()) {
    const detail::step_range steps = detail::visible_steps(f, window, dashes.options.ends);
    if (steps.first < steps.last) {
      walk.go_to(phase + static_cast<std::uint64_t>(steps.first));
      line_bresenham(
          a, b, window,
          [&](cell c) {
            if (walk.next()) sink(c);
          },
          dashes.options);
    }
  }
  return walk.reduced(phase + static_cast<std::uint64_t>(f.n));
}

/// Paints the drawn pixels of the dashed line from a to b.
/// gives   the phase at b
/// exact   the cells of line_styled
template <class Pattern, WritableRaster R, CellOrPosition P = cell, PaintFor<R> Paint = pixel_of<R>>
constexpr std::uint64_t draw_line_styled(R& raster, const P& a, const P& b, const line_dashes<Pattern>& dashes,
                                         const Paint& paint) {
  return line_styled(as_cell(a), as_cell(b), dashes, window_of(raster),
                     [&](cell c) { paint_pixel(raster, c.x, c.y, paint); });
}

}  // namespace IRG_ABI
}  // namespace irg
