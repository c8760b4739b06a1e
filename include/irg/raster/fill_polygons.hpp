// SPDX-License-Identifier: MIT
// Many polygons in one call, in their order, with one paint or one for each.
#pragma once

#include <irg/raster/detail/polygon_bands.hpp>
#include <irg/raster/fill_polygon.hpp>

namespace irg {

/// Any number of polygons, each one ring or a container of rings.
template <class P>
concept FillablePolygons = requires(const P& polygons, std::size_t i) {
  { polygons.size() } -> std::convertible_to<std::size_t>;
  requires FillablePolygon<std::remove_cvref_t<decltype(polygons[i])>>;
};

/// One paint, or a container of them, one for each polygon.
template <class T, class R>
concept PaintsFor = PaintFor<T, R> || requires(const T& paints, std::size_t i) {
  requires PaintFor<std::remove_cvref_t<decltype(paints[i])>, R>;
};

namespace detail::inline IRG_ABI {

// A band of rows that stays in the second-level cache of most processors, with room for what else is in use.
inline constexpr std::int64_t polygon_band_bytes = 512 * 1024;

template <WritableRaster R, PaintsFor<R> Paints>
constexpr decltype(auto) paint_at(const Paints& paints, std::size_t i) {
  if constexpr (PaintFor<Paints, R>)
    return (paints);
  else
    return paints[i];
}

// The height of the bands in which to paint the polygons; 0 when they had better be painted in their order.
template <WritableRaster R, FillablePolygons P>
constexpr int polygon_band_height(const R&, const P& polygons, std::size_t n, const cell_window& w) {
  if constexpr (RowRaster<R>) {
    if (w.empty() || n > 0xffffffffu) return 0;
    const std::int64_t row_bytes =
        (std::int64_t{w.x_last} - w.x_first) * static_cast<std::int64_t>(sizeof(pixel_of<R>));
    const std::int64_t rows = maximum(polygon_band_bytes / row_bytes, std::int64_t{8});
    if (rows >= (w.y_last - w.y_first) / 4) return 0;  // the window as good as fits the cache
    if (bands_pay(polygons, n, w, static_cast<int>(rows))) return static_cast<int>(rows);
  }
  return 0;
}

// Calls f(i, band) for each polygon i and each band of rows it touches, in the order of the bands, then of the
// polygons; false when a polygon is refused.
// needs   a window that is not empty
template <FillablePolygons P, class F>
constexpr bool for_each_in_band(const P& polygons, std::size_t n, const cell_window& w, polygon_bands& bands, F&& f) {
  bool all = true;
  bands.outlines.clear();
  for (std::size_t i = 0; i < n; ++i) {
    bands.outlines.push_back(outline_of(polygons[i], w));
    all = all && !bands.outlines.back().refused;
  }
  sort_into_bands(bands, w);
  std::size_t item = 0;
  for (std::size_t k = 0; k + 2 < bands.starts.size(); ++k) {
    cell_window band = w;
    band.y_first = w.y_first + static_cast<int>(k) * bands.rows;
    if (w.y_last - band.y_first > bands.rows) band.y_last = band.y_first + bands.rows;
    for (; item < bands.starts[k + 1]; ++item) f(static_cast<std::size_t>(bands.items[item]), band);
  }
  return all;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Paints many polygons: the pixels are those of one fill_polygon after another.
/// needs   as many paints as polygons, when there is more than one
/// gives   false when a polygon was left out because it has a vertex that fill_polygon refuses; the others are painted.
///         A blend function is called for a pixel in the order of the polygons, but for different pixels in any order
/// cost    that of the polygons one by one, or less: where the pixels of a large raster are painted more than once, it
///         is worked through in bands that fit the second-level cache, with 32 bytes a polygon and 4 a polygon and band
template <WritableRaster R, FillablePolygons P, PaintsFor<R> Paints = pixel_of<R>, class Workspace = fill_workspace>
  requires std::same_as<Workspace&, fill_workspace&>
constexpr bool fill_polygons(R& raster, const P& polygons, fill_rule rule, const Paints& paints,
                             Workspace&& workspace = Workspace{}) {
  const std::size_t n = static_cast<std::size_t>(polygons.size());
  const cell_window w = window_of(raster);
  const auto paint_one = [&](auto& target, std::size_t i) {
    return fill_polygon(target, polygons[i], rule, detail::paint_at<R>(paints, i), workspace);
  };
  workspace.bands.rows = detail::polygon_band_height(raster, polygons, n, w);
  if (workspace.bands.rows > 0)
    return detail::for_each_in_band(polygons, n, w, workspace.bands, [&](std::size_t i, const cell_window& band) {
      const auto part = within(raster, band);
      paint_one(part, i);
    });
  bool all = true;
  for (std::size_t i = 0; i < n; ++i) all = paint_one(raster, i) && all;
  return all;
}

}  // namespace IRG_ABI
}  // namespace irg
