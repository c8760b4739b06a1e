// SPDX-License-Identifier: MIT
#include <irg/core/sinks.hpp>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <irg/math/vec.hpp>
#include <irg/raster/line_bresenham.hpp>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"

namespace {

using point2 = irg::point<float, 2>;

constexpr auto takes_cell = [](irg::cell) {};
constexpr auto takes_span = [](const irg::span_of_cells&) {};
constexpr auto takes_segment = [](const point2&, const point2&) {};
constexpr auto takes_coverage = [](const irg::coverage_span&) {};
constexpr auto takes_anything = [](auto&&...) {};
constexpr auto takes_text = [](const std::string&) {};
constexpr auto takes_two_ints = [](int, int) {};
struct counter {
  int n = 0;
  constexpr void operator()(irg::cell) { ++n; }
};

static_assert(irg::cell_window{}.empty() && !irg::cell_window{2, 3, 3, 4}.empty() &&
              irg::cell_window{5, 0, 4, 9}.empty());
static_assert(irg::cell{} == irg::cell{0, 0} && irg::span_of_cells{} == irg::span_of_cells{0, 0, 0});
static_assert(irg::coverage_span{}.y == 0 && irg::coverage_span{}.x_first == 0 && irg::coverage_span{}.x_last == 0 &&
              irg::coverage_span{}.coverage == nullptr);

static_assert(irg::CellSink<decltype(takes_cell)> && irg::CellSink<decltype(takes_anything)> && irg::CellSink<counter>);
static_assert(irg::CellSink<counter&> && irg::CellSink<void (*)(irg::cell)> && irg::CellSink<archetype::cell_sink>);
static_assert(!irg::CellSink<const counter>);  // it changes when called
static_assert(!irg::CellSink<decltype(takes_span)> && !irg::CellSink<decltype(takes_text)>);
static_assert(!irg::CellSink<decltype(takes_two_ints)> && !irg::CellSink<int> && !irg::CellSink<void>);
static_assert(!irg::CellSink<int irg::cell::*>);  // std::invoke would take it, a call does not
static_assert(!irg::CellSink<std::vector<irg::cell>> && !irg::CellSink<archetype::span_sink>);

static_assert(irg::SpanSink<decltype(takes_span)> && irg::SpanSink<decltype(takes_anything)>);
static_assert(irg::SpanSink<archetype::span_sink> && !irg::SpanSink<archetype::cell_sink>);
static_assert(!irg::SpanSink<decltype(takes_cell)> && !irg::SpanSink<counter> && !irg::SpanSink<int>);

static_assert(irg::CoverageSink<decltype(takes_coverage)> && irg::CoverageSink<decltype(takes_anything)>);
static_assert(!irg::CoverageSink<decltype(takes_span)> && !irg::CoverageSink<decltype(takes_cell)>);
static_assert(!irg::SpanSink<decltype(takes_coverage)> && !irg::CoverageSink<int>);

static_assert(irg::SegmentSink<decltype(takes_segment), point2> && irg::SegmentSink<decltype(takes_anything), point2>);
static_assert(irg::SegmentSink<archetype::segment_sink<point2>, point2>);
static_assert(!irg::SegmentSink<decltype(takes_segment), irg::point<double, 2>>);
static_assert(!irg::SegmentSink<decltype(takes_cell), point2> && !irg::SegmentSink<int, point2>);

constexpr int cells_of_line() {
  archetype::cell_sink sink;
  irg::line_bresenham({0, 0}, {5, 2}, {0, 0, 100, 100}, sink);
  return sink.calls;
}

}  // namespace

TEST_CASE("sinks: algorithms call a sink that has nothing but its call") { CHECK_BOTH(cells_of_line() == 6); }

TEST_CASE("sinks: what they receive compares by value") {
  CHECK_BOTH(irg::cell{1, 2} == irg::cell{1, 2});
  CHECK_BOTH(irg::cell{1, 2} != irg::cell{2, 1});
  CHECK_BOTH(irg::span_of_cells{1, 2, 3} == irg::span_of_cells{1, 2, 3});
  CHECK_BOTH(irg::span_of_cells{1, 2, 3} != irg::span_of_cells{1, 2, 4});
}

TEST_CASE("cell: written as (x, y), and hashed: no two of many near by alike") {
  std::ostringstream out;
  out << irg::cell{-1, 2};
  CHECK(out.str() == "(-1, 2)");
  std::set<std::size_t> hashes;
  for (int x = -40; x < 40; ++x)
    for (int y = -40; y < 40; ++y) hashes.insert(std::hash<irg::cell>{}({x, y}));
  CHECK(hashes.size() == 6400);
}
