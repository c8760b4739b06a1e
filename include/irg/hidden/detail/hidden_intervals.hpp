// SPDX-License-Identifier: MIT
// What faces hide of an edge: the interval of each, and their union.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <irg/hidden/detail/edge_crossing.hpp>

namespace irg {
namespace detail {

struct hidden_interval {
  edge_crossing from, to;
};

inline namespace IRG_ABI {

// What a face hides of an edge, if that has a length: where all its edge functions are 0 or more (its sides belong to
// it, so that nothing shows between two faces) and its plane is nearer.
template <class Face, class Edge>
constexpr std::optional<hidden_interval> interval_hidden_by(const Face& f, const Edge& e) noexcept {
  hidden_interval hidden{edge_start, edge_finish};
  const auto begin_at = [&](const edge_crossing& c) {
    if (compare_places(hidden.from, c, e) < 0) hidden.from = c;
  };
  const auto end_at = [&](const edge_crossing& c) {
    if (compare_places(c, hidden.to, e) < 0) hidden.to = c;
  };
  std::int64_t at_start[3], at_end[3];
  for (int i = 0; i < 3; ++i) {
    at_start[i] = side_at(f, i, e.p[0]);
    at_end[i] = side_at(f, i, e.p[1]);
    if (lesser(at_start[i], at_end[i]) < 0 && greater(at_start[i], at_end[i]) <= 0) return std::nullopt;
  }
  for (int i = 0; i < 3; ++i)
    if (at_start[i] < 0)
      begin_at(side_crossing(f, i, at_start[i], at_end[i]));
    else if (at_end[i] < 0)
      end_at(side_crossing(f, i, at_start[i], at_end[i]));
  if (compare_places(hidden.from, hidden.to, e) >= 0) return std::nullopt;
  const int start = nearness_sign(f, e, 0), end = nearness_sign(f, e, 1);
  if (start <= 0 && end <= 0) return std::nullopt;
  if (start < 0) begin_at(plane_crossing(f, e));
  if (end < 0) end_at(plane_crossing(f, e));
  if (compare_places(hidden.from, hidden.to, e) >= 0) return std::nullopt;
  return hidden;
}

}  // namespace IRG_ABI

// Intervals of one edge, apart from each other and in order: those that touch are one.
template <class Interval>
class IRG_APART interval_union {
public:
  constexpr void clear() noexcept { list_.clear(); }

  constexpr void add(const Interval& added, const hidden_edge& e) {
    const auto first = std::partition_point(list_.begin(), list_.end(),
                                            [&](const Interval& i) { return compare_places(i.to, added.from, e) < 0; });
    Interval whole = added;
    auto last = first;
    for (; last != list_.end() && compare_places(last->from, whole.to, e) <= 0; ++last) {
      if (compare_places(last->from, whole.from, e) < 0) whole.from = last->from;
      if (compare_places(whole.to, last->to, e) < 0) whole.to = last->to;
    }
    if (first == last) {
      list_.insert(first, whole);
    } else {
      *first = whole;
      list_.erase(first + 1, last);
    }
  }

  // Whether nothing of the edge is left.
  constexpr bool is_whole() const noexcept {
    return list_.size() == 1 && list_[0].from.kind == crossing_kind::start && list_[0].to.kind == crossing_kind::end;
  }
  constexpr const std::vector<Interval>& intervals() const noexcept { return list_; }

private:
  std::vector<Interval> list_;
};

}  // namespace detail
}  // namespace irg
