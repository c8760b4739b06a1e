// SPDX-License-Identifier: MIT
// The parts of an edge that one perimeter or two leave to be seen.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/hidden/detail/grid_perimeter.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// Sends the parts of an edge that its runs leave, over one perimeter or two.
template <class Sight>
class grid_parts {
public:
  constexpr explicit grid_parts(const Sight& sight) : sight_(&sight) {}

  constexpr void add(grid_edge g, const std::vector<grid_run>& runs) {
    const bool reversed = sight_->turning(g).from != sight_->low(g);
    const std::size_t count = runs.size();
    added_.clear();
    for (std::size_t k = 0; k < count; ++k) {
      const grid_run& r = runs[reversed ? count - 1 - k : k];
      const grid_edge first = reversed ? r.to : r.from, last = reversed ? r.from : r.to;
      added_.push_back({first, last, first == no_grid_edge ? 0.0 : sight_->place(g, first),
                        last == no_grid_edge ? 1.0 : sight_->place(g, last)});
    }
    merge(g);
  }

  // Calls sink(from, to) for each part of the edge.
  // gives   how many they are
  template <class Emit>
  constexpr std::int64_t send(const Emit& sink) {
    for (const run& r : runs_) sink(r.from, r.to);
    const auto count = static_cast<std::int64_t>(runs_.size());
    runs_.clear();
    return count;
  }

private:
  struct run {
    grid_edge first, last;
    double from, to;
  };
  // Whether a run begins at a place that another has not passed.
  constexpr bool begins_within(grid_edge g, const run& next, const run& before) const noexcept {
    if (next.from != before.to) return next.from < before.to;
    if (next.first == no_grid_edge || before.last == no_grid_edge || next.first == before.last) return true;
    return sight_->compare_places(g, next.first, before.last) <= 0;
  }
  constexpr bool ends_behind(grid_edge g, const run& a, const run& b) const noexcept {
    if (a.to != b.to || a.last == b.last) return a.to > b.to;
    if (a.last == no_grid_edge || b.last == no_grid_edge) return a.last == no_grid_edge;
    return sight_->compare_places(g, a.last, b.last) > 0;
  }
  constexpr bool begins_before(grid_edge g, const run& a, const run& b) const noexcept {
    if (a.from != b.from || a.first == b.first) return a.from < b.from;
    if (a.first == no_grid_edge || b.first == no_grid_edge) return a.first == no_grid_edge;
    return sight_->compare_places(g, a.first, b.first) < 0;
  }
  constexpr void merge(grid_edge g) {
    if (runs_.empty()) {
      runs_.swap(added_);
      return;
    }
    merged_.clear();
    for (std::size_t i = 0, k = 0; i < runs_.size() || k < added_.size();) {
      const bool old = k == added_.size() || (i < runs_.size() && !begins_before(g, added_[k], runs_[i]));
      const run& next = old ? runs_[i++] : added_[k++];
      if (merged_.empty() || !begins_within(g, next, merged_.back()))
        merged_.push_back(next);
      else if (ends_behind(g, next, merged_.back()))
        merged_.back().last = next.last, merged_.back().to = next.to;
    }
    runs_.swap(merged_);
  }

  const Sight* sight_;
  std::vector<run> runs_{}, added_{}, merged_{};
};

}  // namespace IRG_ABI
}  // namespace irg::detail
