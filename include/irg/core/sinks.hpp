// SPDX-License-Identifier: MIT
// What rasterizers and clippers send their output to: callables that take one cell, one span or one segment. What a
// sink returns is ignored; it may be stateful and need not be copyable.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <typeindex>  // the lightest header that declares std::hash

#include <irg/core/scalar.hpp>

namespace irg {

/// One pixel of the infinite grid: column x, row y. Ordered by x, then y.
struct cell {
  int x = 0, y = 0;
  friend constexpr bool operator==(const cell&, const cell&) = default;
  friend constexpr bool operator<(const cell& a, const cell& b) noexcept { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

/// The pixels with x_first <= x < x_last and y_first <= y < y_last; none when either range is empty.
struct cell_window {
  int x_first = 0, y_first = 0, x_last = 0, y_last = 0;

  [[nodiscard]] IRG_INLINE constexpr bool empty() const noexcept { return x_first >= x_last || y_first >= y_last; }
  friend constexpr bool operator==(const cell_window&, const cell_window&) = default;
};

/// A run of pixels of row y: the columns x_first to x_last - 1, none when x_last <= x_first.
struct span_of_cells {
  int y = 0, x_first = 0, x_last = 0;
  friend constexpr bool operator==(const span_of_cells&, const span_of_cells&) = default;
};

/// A run of pixels of row y that are covered in part: the columns x_first to x_last - 1. coverage[i] belongs to column
/// x_first + i: 0 is untouched, 255 is covered whole. A null pointer says that all are covered whole.
struct coverage_span {
  int y = 0, x_first = 0, x_last = 0;
  const std::uint8_t* coverage = nullptr;
};

/// Receives cells, one call each.
template <class S>
concept CellSink = requires(S& sink, const cell c) { sink(c); };

/// Receives runs of cells, one call each.
template <class S>
concept SpanSink = requires(S& sink, const span_of_cells s) { sink(s); };

/// Receives runs of partly covered cells, one call each. The coverages are valid during the call only.
template <class S>
concept CoverageSink = requires(S& sink, const coverage_span s) { sink(s); };

/// Receives segments between two points, one call each.
template <class S, class P>
concept SegmentSink = requires(S& sink, const P& from, const P& to) { sink(from, to); };

inline namespace IRG_ABI {

/// Writes "(x, y)".
template <class S, std::same_as<cell> C>
  requires TextStream<S>
constexpr S& operator<<(S& stream, const C& c) {
  return print_list(stream, 2, [&](int i) { return i == 0 ? c.x : c.y; });
}

}  // namespace IRG_ABI
}  // namespace irg

/// The hash of a cell, for std::unordered_map and its like.
template <>
struct std::hash<irg::cell> {
  IRG_INLINE constexpr std::size_t operator()(const irg::cell& c) const noexcept {
    const auto x = static_cast<std::uint32_t>(c.x), y = static_cast<std::uint32_t>(c.y);
    const std::uint64_t h = (std::uint64_t{x} << 32 | y) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(h ^ h >> 32);
  }
};
