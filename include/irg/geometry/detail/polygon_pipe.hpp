// SPDX-License-Identifier: MIT
// Sutherland and Hodgman's reentrant polygon clipper: every boundary, or pair of parallel ones, is a stage that takes
// vertices one by one, keeps what is inside and hands it to the next. It needs no room for anything but two vertices
// per stage.
//
// A vertex arrives with the number of the polygon's edge that leads to it, or along_boundary. Cuts are made on the
// whole edge as it was given, whatever the stages before have left of it: they are as exact as the edge, and the same
// for both polygons that share it.
#pragma once

#include <cstddef>
#include <type_traits>

#include <irg/geometry/attributed_point.hpp>

namespace irg::detail {

inline constexpr std::ptrdiff_t along_boundary = -1;

template <class V>
struct pipe_stage {
  V first{}, last{};
  int first_place = 0, last_place = 0;
  bool started = false;
};

// Region: count() stages; place(s, p), -1 or 1 where p is beyond a boundary of stage s, 0 elsewhere; is_on(s, place,
// p), whether p is on that boundary; cut(s, place, a, b), the vertex on it between a and b, the same for b and a.
// Stages: an array of pipe_stage<V>. Sink: put(v), and enter(v) where the polygon was
// outside before.
template <class V, class Region, class Stages, class Edge, class Sink>
class polygon_pipe {
public:
  IRG_INLINE constexpr polygon_pipe(const Region& region, Stages& stages, const Edge& edge, Sink& sink) noexcept
      : region_(region), stages_(stages), edge_(edge), sink_(sink) {}

  // One more vertex; the edge with the number `by` leads to it.
  template <class Index>
  constexpr void take(Index s, const V& v, std::ptrdiff_t by, bool enters) {
    if constexpr (is_end<Index>()) {
      enters ? sink_.enter(v) : sink_.put(v);
    } else {
      if (s == region_.count()) return enters ? sink_.enter(v) : sink_.put(v);
      pipe_stage<V>& stage = stages_[s];
      const int place = region_.place(s, position_of(v));
      if (!stage.started) {
        stage.started = true;
        stage.first = v, stage.first_place = place;
        if (place == 0) take(after(s), v, by, enters);
      } else {
        const bool was_beyond = stage.last_place != 0;
        const std::ptrdiff_t arrives_by = step(s, v, place, by);
        if (place == 0) take(after(s), v, arrives_by, enters || was_beyond);
      }
      stage.last = v, stage.last_place = place;
    }
  }

  // The vertices since the last one that was taken lie where it lies, v being the last of them.
  template <class Index>
  constexpr void pass_over(Index s, const V& v) {
    if constexpr (!is_end<Index>()) {
      if (s == region_.count()) return;
      stages_[s].last = v;
      if (stages_[s].last_place == 0) pass_over(after(s), v);
    }
  }

  // The end: the last vertex is joined to the first, by the edge with this number.
  template <class Index>
  constexpr void close(Index s, std::ptrdiff_t by) {
    if constexpr (!is_end<Index>()) {
      if (s == region_.count() || !stages_[s].started) return;
      const std::ptrdiff_t arrives_by = step(s, stages_[s].first, stages_[s].first_place, by);
      close(after(s), stages_[s].first_place == 0 ? arrives_by : along_boundary);
    }
  }

private:
  template <class Index>
  static constexpr bool is_end() noexcept {
    if constexpr (requires { Index::value; })
      return Index::value == Region::stages;
    else
      return false;
  }
  IRG_INLINE static constexpr std::size_t after(std::size_t s) noexcept { return s + 1; }
  template <std::size_t S>
  IRG_INLINE static constexpr auto after(std::integral_constant<std::size_t, S>) noexcept {
    return std::integral_constant<std::size_t, S + 1>{};
  }

  // The cuts between the last vertex and v; what leads to v in the next stage.
  template <class Index>
  constexpr std::ptrdiff_t step(Index s, const V& v, int place, std::ptrdiff_t by) {
    const pipe_stage<V>& stage = stages_[s];
    const int was = stage.last_place;
    if (was == place) return by;
    if (was != 0) {
      if (place == 0 && region_.is_on(s, was, position_of(v))) return along_boundary;
      take(after(s), cut(s, was, v, by), along_boundary, true);
    }
    if (place != 0 && !(was == 0 && region_.is_on(s, place, position_of(stage.last))))
      take(after(s), cut(s, place, v, by), by, true);
    return by;
  }
  constexpr V cut(std::size_t s, int place, const V& to, std::ptrdiff_t by) const {
    if (by == along_boundary) return region_.cut(s, place, stages_[s].last, to);
    return region_.cut(s, place, edge_(by), edge_(by + 1));
  }

  const Region& region_;
  Stages& stages_;
  const Edge& edge_;
  Sink& sink_;
};

}  // namespace irg::detail
