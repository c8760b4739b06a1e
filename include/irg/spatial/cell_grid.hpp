// SPDX-License-Identifier: MIT
// cell_grid: full and empty cells, one bit each.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/spatial/grid_concept.hpp>

namespace irg {

/// A set of cells of a box, one bit each: the full cells of a map, or the cells that are seen.
/// shape   each row begins with a word of its own; bits past the width are 0
/// gives   a grid without cells for an extent that has none
class cell_grid {
public:
  cell_grid() = default;
  /// An extent with all cells empty.
  IRG_INLINE constexpr explicit cell_grid(const grid_extent& extent)
      : extent_(extent.empty() ? grid_extent{0, 0, 0} : extent),
        words_per_row_((std::int64_t{extent_.width} + 63) / 64),
        words_(countable(extent_, words_per_row_), std::uint64_t{0}) {}

  [[nodiscard]] IRG_INLINE constexpr grid_extent extent() const noexcept { return extent_; }

  /// needs   a cell of the extent, here and below
  [[nodiscard]] IRG_INLINE constexpr bool is_full(const cell3& c) const noexcept {
    IRG_EXPECTS(extent_.holds(c));
    return (row(c.y, c.z)[c.x >> 6] >> (c.x & 63) & 1) != 0;
  }
  IRG_INLINE constexpr void set(const cell3& c, bool full = true) noexcept {
    IRG_EXPECTS(extent_.holds(c));
    std::uint64_t& word = row(c.y, c.z)[c.x >> 6];
    const std::uint64_t bit = std::uint64_t{1} << (c.x & 63);
    word = full ? word | bit : word & ~bit;
  }
  /// Fills the cells x_first to x_last - 1 of a row.
  /// needs   0 <= x_first, x_last <= width
  IRG_INLINE constexpr void set_run(int x_first, int x_last, int y, int z) noexcept {
    if (x_first >= x_last) return;
    std::uint64_t* const w = row(y, z);
    const int i = x_first >> 6, j = (x_last - 1) >> 6;
    const std::uint64_t from = ~std::uint64_t{0} << (x_first & 63),
                        to = ~std::uint64_t{0} >> (63 - ((x_last - 1) & 63));
    if (i == j) {
      w[i] |= from & to;
      return;
    }
    w[i] |= from;
    for (int k = i + 1; k < j; ++k) w[k] = ~std::uint64_t{0};
    w[j] |= to;
  }
  /// Empties all cells.
  IRG_INLINE constexpr void clear() noexcept {
    for (std::uint64_t& word : words_) word = 0;
  }

  /// How many cells are full.
  [[nodiscard]] IRG_INLINE constexpr std::int64_t count() const noexcept {
    std::int64_t n = 0;
    for (const std::uint64_t word : words_) n += std::popcount(word);
    return n;
  }
  /// Adds the full cells of another grid of the same extent.
  IRG_INLINE constexpr cell_grid& operator|=(const cell_grid& other) noexcept {
    IRG_EXPECTS(extent_ == other.extent_);
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
  }
  /// Keeps the cells that are full in another grid of the same extent, too.
  IRG_INLINE constexpr cell_grid& operator&=(const cell_grid& other) noexcept {
    IRG_EXPECTS(extent_ == other.extent_);
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
  }
  bool operator==(const cell_grid&) const = default;

  /// Calls sink(cell3) for the full cells, ordered by z, y and x.
  template <Cell3Sink Sink>
  IRG_INLINE constexpr void for_each(Sink&& sink) const {
    for (int z = 0; z < extent_.depth; ++z)
      for (int y = 0; y < extent_.height; ++y)
        for (int i = 0; i < words_per_row_; ++i)
          for (std::uint64_t rest = row(y, z)[i]; rest != 0; rest &= rest - 1)
            sink(cell3{i * 64 + std::countr_zero(rest), y, z});
  }

  /// The words of a row: bit x % 64 of word x / 64 is the cell x.
  [[nodiscard]] IRG_INLINE constexpr const std::uint64_t* row(int y, int z) const noexcept {
    return words_.data() + offset(y, z);
  }
  IRG_INLINE constexpr std::uint64_t* row(int y, int z) noexcept { return words_.data() + offset(y, z); }
  [[nodiscard]] IRG_INLINE constexpr int words_per_row() const noexcept { return static_cast<int>(words_per_row_); }

private:
  [[nodiscard]] IRG_INLINE constexpr std::int64_t offset(int y, int z) const noexcept {
    return (std::int64_t{z} * extent_.height + y) * words_per_row_;
  }
  // More words than can be counted become as many as no vector holds, so that it refuses them.
  IRG_INLINE static constexpr std::size_t countable(const grid_extent& e, std::int64_t words) noexcept {
    constexpr std::int64_t most = (std::numeric_limits<std::ptrdiff_t>::max)();
    const std::int64_t rows = std::int64_t{e.height} * e.depth;
    return static_cast<std::size_t>(rows != 0 && words > most / rows ? most : rows * words);
  }

  grid_extent extent_{0, 0, 0};
  std::int64_t words_per_row_ = 0;
  std::vector<std::uint64_t> words_{};
};

inline namespace IRG_ABI {

/// The full cells of any grid, as bits.
template <CellGrid G>
[[nodiscard]] constexpr cell_grid packed(const G& g) {
  cell_grid out(extent_of(g));
  const grid_extent e = out.extent();
  for (int z = 0; z < e.depth; ++z)
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x)
        if (is_full(g, {x, y, z})) out.set({x, y, z});
  return out;
}

/// A flat grid of a picture: the cells are full whose pixels full(pixel) says so of.
template <ReadableRaster R, std::predicate<pixel_of<R>> Full>
constexpr cell_grid grid_from_raster(const R& picture, Full&& full) {
  cell_grid out(grid_extent{width_of(picture), height_of(picture), 1});
  const grid_extent e = out.extent();
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x)
      if (full(get_pixel(picture, x, y))) out.set({x, y, 0});
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
