// SPDX-License-Identifier: MIT
// Heights over a grid that own their numbers: from a function, from an array, from an image. From terrain files:
// io/terrain.hpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <irg/core/contraction.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/hidden/grid_surface.hpp>

namespace irg {

/// A surface over a grid with its numbers: heights[i*z.size() + j] is the height at (x[i], z[j]).
struct height_grid {
  std::vector<double> x{}, z{}, heights{};

  [[nodiscard]] IRG_APART constexpr grid_surface surface() const noexcept {
    return {{x.data(), x.size()}, {z.data(), z.size()}, {heights.data(), heights.size()}};
  }
  bool operator==(const height_grid&) const = default;
};

/// Where samples are taken: `count` even steps from `from` to `to`, both included.
struct sample_range {
  double from = 0, to = 1;
  int count = 2;
  bool operator==(const sample_range&) const = default;
};

namespace detail::inline IRG_ABI {

// 0, 1, 2 and on: even steps from 0 to count - 1 would be rounded.
template <class Int>
constexpr std::vector<double> whole_places(Int count) {
  std::vector<double> places(count > 0 ? static_cast<std::size_t>(count) : 0, 0.0);
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = static_cast<double>(k);
  return places;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The places of a range.
/// gives   none for a count below 1, `from` alone for 1
/// exact   the ends; between them from * (1 - t) + to * t with t = k / (count - 1), each operation rounded
template <class Range>
[[nodiscard]] constexpr std::vector<double> places_of(const Range& r) {
  std::vector<double> places;
  for (int k = 0; k < r.count; ++k) {
    const double t = r.count > 1 ? static_cast<double>(k) / (r.count - 1) : 0;
    places.push_back(k == 0 ? r.from : k + 1 == r.count ? r.to : product(r.from, 1 - t) + product(r.to, t));
  }
  return places;
}

/// The heights of a function of x and z at even steps.
/// cost    a call for each sample
template <class Height, class Range = sample_range>
[[nodiscard]] constexpr height_grid sample_heights(const Height& height, const Range& x, const Range& z) {
  height_grid g{places_of(x), places_of(z), {}};
  g.heights.reserve(g.x.size() * g.z.size());
  for (const double u : g.x)
    for (const double v : g.z) g.heights.push_back(static_cast<double>(height(u, v)));
  return g;
}

/// The heights of an array, its rows one after another: row k stands at z = k, column i at x = i.
/// needs   columns of 1 or more that divide the array's size
template <class Numbers>
[[nodiscard]] constexpr height_grid heights_of_rows(const Numbers& rows, int columns) {
  const auto width = static_cast<std::size_t>(columns);
  const int count = static_cast<int>(rows.size() / width);
  height_grid g{detail::whole_places(columns), detail::whole_places(count), {}};
  for (std::size_t i = 0; i < width; ++i)
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
      g.heights.push_back(static_cast<double>(rows[k * width + i]));
  return g;
}

/// The heights of an image, height_at(pixel) each: column i stands at x = i; the lowest row of the image is the
/// nearest, at z = 0.
template <ReadableRaster R, class HeightAt>
[[nodiscard]] constexpr height_grid heights_of_image(const R& image, const HeightAt& height_at) {
  const int width = width_of(image), height = height_of(image);
  height_grid g{detail::whole_places(width), detail::whole_places(height), {}};
  for (int i = 0; i < width; ++i)
    for (int k = 0; k < height; ++k)
      g.heights.push_back(static_cast<double>(height_at(get_pixel(image, i, height - 1 - k))));
  return g;
}

}  // namespace IRG_ABI
}  // namespace irg
