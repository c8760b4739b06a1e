// SPDX-License-Identifier: MIT
// The walk down both sides of a ring, from its topmost vertex to its lowest row.
//
// The edges of small rings are walked in fixed point: column = position >> 35. The position starts, and advances per
// row, too far by more than 0 and less than 4 units of 2^-35 column, so after k rows it is too far by less than
// 4 * (k + 1). The true position is a multiple of 1/dy from the next column, so the column is right as long as
// 4 * (k + 1) * dy < 2^35. A ring of at most 2^20 / 256 rows (dy <= 2^20) keeps that. The doubles that positions are
// computed in stay below 2^52 units, where their two roundings amount to 1 unit at most; so do those of the advances of
// all edges across two rows or more (dy > 256). Other edges never use theirs, which is below 2^61.
#pragma once

#include <span>

#include <irg/core/function_ref.hpp>
#include <irg/raster/detail/compiled_rasters.hpp>
#include <irg/raster/detail/snapped_ring.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/paint.hpp>
#include <irg/raster/window.hpp>

namespace irg::detail::inline IRG_COMPILED_ABI {

// walk_ring to a sink, and to pixels.
template <CompiledVertex V>
IRG_API bool send_ring_runs(std::span<const V> ring, const cell_window& w,
                            const function_ref<void(int, int, int)>& sink);
template <CompiledPixel P, CompiledVertex V>
IRG_API bool paint_ring_runs(const image_view<P>& raster, std::span<const V> ring, const P& value,
                             const cell_window& w);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

inline constexpr int fixed_edge_bits = 35;
inline constexpr std::int32_t fixed_edge_reach = 1 << 24;  // of coordinates, in 1/256 pixel
inline constexpr std::int32_t fixed_edge_height = 1 << 20;  // of the ring, in 1/256 pixel

inline constexpr int low_rows = 128;  // of rings that walk_low_ring() takes, and no more than so many per vertex:
inline constexpr int low_rows_per_vertex = 8;

// An edge of a small ring in one row.
struct fixed_edge {
  using vertex = subpixel;
  std::int64_t position = 0, advance = 0;

  IRG_INLINE constexpr fixed_edge() noexcept = default;
  IRG_INLINE constexpr fixed_edge(const subpixel& upper, const subpixel& lower, std::int64_t row) noexcept {
    const std::int64_t dx = std::int64_t{lower.x} - upper.x,
                       dy = maximum(std::int64_t{lower.y} - upper.y, std::int64_t{1});
    const std::int64_t below = minimum(maximum(row * one_pixel + half_pixel - upper.y, std::int64_t{0}), dy);
    const std::int64_t n = ((std::int64_t{upper.x} - half_pixel) * dy + below * dx - 1) >> subpixel_bits;
    const double unit = static_cast<double>(std::int64_t{1} << fixed_edge_bits) / static_cast<double>(dy);
    position = static_cast<std::int64_t>(static_cast<double>(n + dy) * unit) + 2;
    advance = static_cast<std::int64_t>(static_cast<double>(dx) * unit) + 2;
  }
  IRG_INLINE constexpr std::int64_t column() const noexcept { return position >> fixed_edge_bits; }
  IRG_INLINE constexpr void next() noexcept { position += advance; }
};

// An edge of any ring in one row.
struct far_edge {
  using vertex = far_subpixel;
  edge_walk<std::int64_t> walk;

  IRG_INLINE constexpr far_edge() noexcept = default;
  IRG_INLINE constexpr far_edge(const far_subpixel& upper, const far_subpixel& lower, std::int64_t row) noexcept
      : walk(walk_edge(upper, lower, row)) {}
  IRG_INLINE constexpr std::int64_t column() const noexcept { return walk.column; }
  IRG_INLINE constexpr void next() noexcept { walk.next(); }
};

// One side of a ring: the vertex it has come to, and the edge that leads on from there.
template <class Edge>
struct ring_side {
  std::size_t i = 0;
  typename Edge::vertex at{};
  Edge edge{};
  int row_last = 0;  // the edge ends before this row
};

// Leads a side on to its first edge that reaches below row y: such an edge crosses row y, for every vertex passed on
// the way is above the row's centre. A ring whose lowest row is below y has one, be it convex or not.
template <bool Forward, class Edge, class Vertices>
IRG_INLINE constexpr void lead_on(ring_side<Edge>& side, std::size_t n, const Vertices& vertex, int y, int y_last) {
  std::int64_t reaches = 0;
  typename Edge::vertex from = side.at, to = from;
  do {
    from = to;
    side.i = next_vertex(side.i, n, Forward);
    to = vertex(side.i);
    reaches = row_from(to.y);
  } while (reaches <= y);
  side.edge = Edge(from, to, y);
  side.at = to;
  side.row_last = static_cast<int>(minimum(reaches, std::int64_t{y_last}));
}

// Calls sink(y, x_first, x_last) for each row of w that has columns between the two sides of the ring.
// needs   w not empty and within the rows that the ring's extent crosses; vertex(i) for i < n
template <class Edge, class Vertices, class Emit>
IRG_INLINE constexpr void walk_sides(std::size_t n, std::size_t topmost, const Vertices& vertex, const cell_window& w,
                                     Emit&& sink) {
  int y = w.y_first;
  ring_side<Edge> one{topmost, vertex(topmost), {}, y};
  ring_side<Edge> other = one;
  do {
    if (one.row_last == y) lead_on<true>(one, n, vertex, y, w.y_last);
    if (other.row_last == y) lead_on<false>(other, n, vertex, y, w.y_last);
    const int stop = minimum(one.row_last, other.row_last);
    do {
      const std::int64_t a = one.edge.column(), b = other.edge.column();
      const std::int64_t first = maximum(minimum(a, b), std::int64_t{w.x_first});
      const std::int64_t last = minimum(maximum(a, b), std::int64_t{w.x_last});
      if (first < last) sink(y, static_cast<int>(first), static_cast<int>(last));
      one.edge.next();
      other.edge.next();
    } while (++y < stop);
  } while (y < w.y_last);
}

// Writes the columns of one side of a ring, row by row. Every edge writes four rows at once, and more only when it has
// more: what it writes below its end, the next edge writes anew. So no row count is a branch, and level edges are no
// special case. Rows are counted from `top`; column has low_rows + 4 places.
template <bool Forward, class Vertices>
IRG_INLINE constexpr void columns_of_side(std::size_t n, std::size_t i, std::size_t lowest, const Vertices& vertex,
                                          int top, int rows, std::int32_t* column) {
  const auto row_of = [&](const subpixel& v) {
    return static_cast<int>(minimum(maximum(row_from(v.y) - top, std::int64_t{0}), std::int64_t{rows}));
  };
  subpixel from = vertex(i);
  int row = row_of(from);
  do {
    i = next_vertex(i, n, Forward);
    const subpixel to = vertex(i);
    const int end = row_of(to);
    if (row < end) {
      fixed_edge e(from, to, std::int64_t{top} + row);
      do {
        column[row] = static_cast<std::int32_t>(e.position >> fixed_edge_bits);
        column[row + 1] = static_cast<std::int32_t>((e.position + e.advance) >> fixed_edge_bits);
        column[row + 2] = static_cast<std::int32_t>((e.position + 2 * e.advance) >> fixed_edge_bits);
        column[row + 3] = static_cast<std::int32_t>((e.position + 3 * e.advance) >> fixed_edge_bits);
        e.position += 4 * e.advance;
        row += 4;
      } while (row < end);
    }
    row = end;
    from = to;
  } while (i != lowest);
}

// walk_sides() for rings of few rows, whose edges would keep a walk from row to row guessing.
template <class Vertices, class Emit>
IRG_INLINE constexpr void walk_low_ring(std::size_t n, const ring_extent<std::int32_t>& extent, const Vertices& vertex,
                                        const cell_window& w, Emit&& sink) {
  std::int32_t one[low_rows + 4], other[low_rows + 4];
  const int rows = w.y_last - w.y_first;
  columns_of_side<true>(n, extent.topmost, extent.lowest, vertex, w.y_first, rows, one);
  columns_of_side<false>(n, extent.topmost, extent.lowest, vertex, w.y_first, rows, other);
  for (int row = 0; row < rows; ++row) {
    const int first = maximum(minimum(one[row], other[row]), w.x_first),
              last = minimum(maximum(one[row], other[row]), w.x_last);
    if (first < last) sink(w.y_first + row, first, last);
  }
}

// The same for a triangle. Its three edges are made ready without a branch; the side of two edges goes over from the
// one to the other on the way. An edge that crosses no row of w is never walked, but its numbers must not overflow.
template <class Emit>
IRG_INLINE constexpr void walk_triangle(const subpixel (&corner)[3], const cell_window& w, Emit&& sink) {
  const auto key = [](const subpixel& v) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(std::int64_t{v.y}) << 32 |
                                     static_cast<std::uint32_t>(v.x));
  };
  const auto position = [](std::int64_t k) {
    return subpixel{static_cast<std::int32_t>(static_cast<std::uint32_t>(k & 0xffffffff)),
                    static_cast<std::int32_t>(k >> 32)};
  };
  const std::int64_t a = key(corner[0]), b = key(corner[1]), c = key(corner[2]);
  const std::int64_t less = minimum(a, b), more = maximum(a, b);
  const subpixel top = position(minimum(less, c)), middle = position(maximum(less, minimum(more, c))),
                 bottom = position(maximum(more, c));
  const int turn = static_cast<int>(clamped(row_from(middle.y), std::int64_t{w.y_first}, std::int64_t{w.y_last}));
  fixed_edge whole(top, bottom, w.y_first), part(top, middle, w.y_first);
  const fixed_edge lower(middle, bottom, turn);
  int y = w.y_first;
  do {
    part = y == turn ? lower : part;
    const int one = static_cast<int>(whole.column()), other = static_cast<int>(part.column());
    const int first = maximum(minimum(one, other), w.x_first), last = minimum(maximum(one, other), w.x_last);
    if (first < last) sink(y, first, last);
    whole.next();
    part.next();
  } while (++y < w.y_last);
}

// The part of w that a ring of this extent can have pixels in.
template <class J>
IRG_INLINE constexpr cell_window window_of_extent(const ring_extent<J>& e, const cell_window& w) noexcept {
  const auto within = [](std::int64_t v, int low, int high) {
    return static_cast<int>(clamped(v, std::int64_t{low}, std::int64_t{high}));
  };
  if (w.empty()) return {};
  return {within(row_from(e.left), w.x_first, w.x_last), within(row_from(e.top), w.y_first, w.y_last),
          within(row_from(e.right), w.x_first, w.x_last), within(row_from(e.bottom), w.y_first, w.y_last)};
}

// The same for a ring that is too large for fixed_edge, or not to be filled at all: false then.
template <FillableRing R, class Emit>
IRG_NOINLINE constexpr bool walk_far_ring(const R& ring, const cell_window& window, Emit&& sink) {
  if (reach_of(ring) == ring_reach::refused) return false;
  const std::size_t n = ring_size(ring);
  ring_extent<std::int64_t> extent;
  for (std::size_t i = 0; i < n; ++i) extent.add(far_vertex(ring, i), i);
  if (n < 3) return true;
  const cell_window w = window_of_extent(extent, window);
  if (!w.empty()) walk_sides<far_edge>(n, extent.topmost, [&](std::size_t i) { return far_vertex(ring, i); }, w, sink);
  return true;
}

// Calls sink(y, x_first, x_last), x_first < x_last, for at most one run in each row of the window.
// gives   false, and no call, when a vertex is refused (see ring_reach)
template <FillableRing R, class Emit>
IRG_INLINE constexpr bool walk_ring(const R& ring, const cell_window& window, Emit&& sink) {
  constexpr std::size_t kept = is_snapped_ring<R> ? 1 : 32;  // vertices snapped once; longer rings are snapped twice
  std::int32_t kept_x[kept], kept_y[kept];
  const std::size_t n = ring_size(ring);
  ring_extent<std::int32_t> extent;
  for (std::size_t i = 0; i < n; ++i) {
    if constexpr (!is_snapped_ring<R>)
      if (reach_of_vertex(ring, i) != ring_reach::within_snap_limit) return walk_far_ring(ring, window, sink);
    const subpixel v = near_vertex(ring, i);
    if constexpr (!is_snapped_ring<R>) {
      if (i < kept) {
        kept_x[i] = v.x;
        kept_y[i] = v.y;
      }
    }
    extent.add(v, i);
  }
  if (n < 3) return true;
  if (extent.left < -fixed_edge_reach || extent.right > fixed_edge_reach || extent.top < -fixed_edge_reach ||
      extent.bottom > fixed_edge_reach || extent.bottom - extent.top > fixed_edge_height)
    return walk_far_ring(ring, window, sink);
  const cell_window w = window_of_extent(extent, window);
  if (w.empty()) return true;
  if (n == 3) {
    const subpixel corner[3] = {near_vertex(ring, 0), near_vertex(ring, 1), near_vertex(ring, 2)};
    walk_triangle(corner, w, sink);
    return true;
  }
  const auto walk = [&](const auto& vertex) {
    const int rows = w.y_last - w.y_first;
    if (rows <= low_rows && static_cast<std::size_t>(rows) <= low_rows_per_vertex * n)
      walk_low_ring(n, extent, vertex, w, sink);
    else
      walk_sides<fixed_edge>(n, extent.topmost, vertex, w, sink);
  };
  if constexpr (!is_snapped_ring<R>) {
    if (n <= kept) {
      walk([&](std::size_t i) { return subpixel{kept_x[i], kept_y[i]}; });
      return true;
    }
  }
  walk([&](std::size_t i) { return near_vertex(ring, i); });
  return true;
}

}  // namespace irg::detail::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <CompiledVertex V>
IRG_API bool send_ring_runs(std::span<const V> ring, const cell_window& w,
                            const function_ref<void(int, int, int)>& sink) {
  return walk_ring(ring, w, sink);
}

template <CompiledPixel P, CompiledVertex V>
IRG_API bool paint_ring_runs(const image_view<P>& raster, std::span<const V> ring, const P& value,
                             const cell_window& w) {
  image_view<P> target = raster;
  const std::ptrdiff_t ahead = bytes_to_row_below(target);
  return walk_ring(ring, w, [&](int y, int first, int last) { paint_run(target, y, first, last, value, ahead); });
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
