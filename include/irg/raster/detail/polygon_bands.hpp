// SPDX-License-Identifier: MIT
// A batch of polygons sorted into bands of rows. A band stays in the second-level cache while all that touches it is
// painted, which is what large polygons wait for. Within a band the polygons keep their order, so every pixel is
// painted in it.
#pragma once

#include <irg/raster/detail/polygon_fill_kernel.hpp>

namespace irg::detail {

/// The rows of a polygon within the window, and what it costs to walk it and to paint it.
struct polygon_outline {
  int row_first = 0, row_last = 0;  // no rows: nothing to paint
  std::int64_t vertices = 0, pixels = 0;  // pixels of its box
  bool refused = false;
};

inline namespace IRG_ABI {

// Calls f(ring) for one ring or for each of many.
template <FillablePolygon P, class F>
constexpr void for_each_ring(const P& polygon, F&& f) {
  if constexpr (FillableRing<P>) {
    f(polygon);
  } else if constexpr (std::is_array_v<P>) {
    for (const auto& ring : polygon) f(ring);
  } else {
    const std::size_t n = static_cast<std::size_t>(polygon.size());
    for (std::size_t i = 0; i < n; ++i) f(polygon[i]);
  }
}

// The reach of the ring that reaches farthest.
template <FillablePolygon P>
constexpr ring_reach reach_of_polygon(const P& polygon) {
  ring_reach reach = ring_reach::within_snap_limit;
  for_each_ring(polygon, [&](const auto& ring) {
    const ring_reach r = reach_of(ring);
    if (reach == ring_reach::within_snap_limit || r == ring_reach::refused) reach = r;
  });
  return reach;
}

template <FillablePolygon P>
constexpr polygon_outline outline_of(const P& polygon, const cell_window& w) {
  polygon_outline o;
  const ring_reach reach = reach_of_polygon(polygon);
  o.refused = reach == ring_reach::refused;
  if (o.refused || w.empty()) return o;
  ring_extent<std::int64_t> extent;
  for_each_ring(polygon, [&](const auto& ring) {
    const std::size_t n = ring_size(ring);
    if (n < 3) return;
    for (std::size_t i = 0; i < n; ++i) extent.add(far_vertex(ring, i), i);
    o.vertices += static_cast<std::int64_t>(n);
  });
  if (o.vertices == 0) return o;
  const cell_window box = window_of_extent(extent, w);
  if (box.empty()) return o;
  o.row_first = box.y_first;
  o.row_last = box.y_last;
  o.pixels = (std::int64_t{box.x_last} - box.x_first) * (std::int64_t{box.y_last} - box.y_first);
  return o;
}

/// Where a batch stands in memory: the polygons of band k are items[starts[k]] to items[starts[k + 1] - 1].
struct polygon_bands {
  std::vector<polygon_outline> outlines;
  std::vector<std::size_t> starts;
  std::vector<std::uint32_t> items;
  int rows = 0;  // of a band
};

// How many bands, of `rows` rows each from y_first on, the outline touches.
constexpr std::int64_t bands_touched(const polygon_outline& o, int y_first, int rows) noexcept {
  return o.row_first >= o.row_last ? 0 : (o.row_last - 1 - y_first) / rows - (o.row_first - y_first) / rows + 1;
}

// Whether painting band by band pays, told from a sample of the polygons: the window's pixels are painted at least once
// over, and walking an edge again in each band (about as long as painting 128 pixels) costs less than it spares.
template <class P>
constexpr bool bands_pay(const P& polygons, std::size_t n, const cell_window& w, int rows) {
  const std::size_t stride = n / 64 + 1;
  std::int64_t pixels = 0, walks = 0;
  for (std::size_t i = 0; i < n; i += stride) {
    const polygon_outline o = outline_of(polygons[i], w);
    pixels += o.pixels;
    walks += o.vertices * bands_touched(o, w.y_first, rows);
  }
  const std::int64_t all = (std::int64_t{w.x_last} - w.x_first) * (std::int64_t{w.y_last} - w.y_first);
  return pixels / 128 > walks && pixels > all / static_cast<std::int64_t>(stride);
}

// Sorts the outlines into bands by counting.
// needs   a window that is not empty
template <class Bands>
constexpr void sort_into_bands(Bands& b, const cell_window& w) {
  const std::size_t count = static_cast<std::size_t>((w.y_last - w.y_first - 1) / b.rows) + 1;
  const auto for_each_band = [&](const polygon_outline& o, auto&& f) {
    if (o.row_first >= o.row_last) return;
    const int last = (o.row_last - 1 - w.y_first) / b.rows;
    for (int k = (o.row_first - w.y_first) / b.rows; k <= last; ++k) f(static_cast<std::size_t>(k));
  };
  b.starts.assign(count + 2, 0);
  for (const polygon_outline& o : b.outlines) for_each_band(o, [&](std::size_t k) { ++b.starts[k + 2]; });
  for (std::size_t k = 2; k < count + 2; ++k) b.starts[k] += b.starts[k - 1];
  b.items.assign(b.starts[count + 1], 0);
  for (std::size_t i = 0; i < b.outlines.size(); ++i)
    for_each_band(b.outlines[i], [&](std::size_t k) { b.items[b.starts[k + 1]++] = static_cast<std::uint32_t>(i); });
}

}  // namespace IRG_ABI
}  // namespace irg::detail
