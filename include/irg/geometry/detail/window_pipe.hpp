// SPDX-License-Identifier: MIT
// Sutherland and Hodgman's reentrant polygon clipper, for windows: each axis, with its two boundaries, is a stage that
// takes vertices one by one, keeps what is inside and hands it to the next. It needs no room for anything but two
// vertices per stage.
//
// A vertex arrives with the number of the polygon's edge that leads to it, or along_boundary. Cuts are made on the
// whole edge as it was given, whatever the stages before have left of it: they are as exact as the edge, and the same
// for both polygons that share it.
#pragma once

#include <cstddef>
#include <type_traits>

#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/axis_crossing.hpp>
#include <irg/geometry/orient2d.hpp>

namespace irg::detail {

inline constexpr std::ptrdiff_t along_boundary = -1;

// Where a vertex lies for a stage: -1 or 1 beyond a boundary, 0 elsewhere; `rounded` where a cut was rounded to a
// boundary's coordinate that it does not have exactly.
struct stage_place {
  int beyond = 0;
  bool rounded = false;
};
template <class V>
struct pipe_stage {
  V first{}, last{};
  stage_place first_place, last_place;
  bool started = false;
};

// edge(i) is the first end of the polygon's edge i. Sink: put(v), and enter(v) where the polygon was outside before.
template <class V, class F, class Edge, class Sink>
class IRG_APART window_pipe {
public:
  using T = vertex_scalar<V>;
  using P = vertex_position<V>;
  template <int Axis>
  using stage_of = std::integral_constant<int, Axis>;

  IRG_INLINE constexpr window_pipe(const box<T, 2>& window, const F& interpolate, const Edge& edge, Sink& sink) noexcept
      : window_(window), interpolate_(interpolate), edge_(edge), sink_(sink) {}

  // One more vertex; the edge with the number `by` leads to it. A cut lies on the edge `on`.
  template <int Axis>
  constexpr void take(stage_of<Axis> s, const V& v, std::ptrdiff_t by, bool enters,
                      std::ptrdiff_t on = along_boundary) {
    if constexpr (Axis == 2) {
      enters ? sink_.enter(v) : sink_.put(v);
    } else {
      pipe_stage<V>& stage = stages_[Axis];
      stage_place place{beyond<Axis>(position_of(v))};
      if constexpr (Axis == 1)
        if (on != along_boundary && (is_on<1>(-1, v) || is_on<1>(1, v))) place = settled(v, on);
      if (!stage.started) {
        stage.started = true;
        stage.first = v, stage.first_place = place;
        if (place.beyond == 0) take(after(s), v, by, enters, on);
      } else {
        const bool was_beyond = stage.last_place.beyond != 0;
        const std::ptrdiff_t arrives_by = step(s, v, place, by);
        if (place.beyond == 0) take(after(s), v, arrives_by, enters || was_beyond, on);
      }
      stage.last = v, stage.last_place = place;
    }
  }

  // The vertices since the last one that was taken lie where it lies, v being the last of them.
  template <int Axis>
  constexpr void pass_over(stage_of<Axis> s, const V& v) {
    if constexpr (Axis < 2) {
      stages_[Axis].last = v;
      if (stages_[Axis].last_place.beyond == 0) pass_over(after(s), v);
    }
  }

  // The end: the last vertex is joined to the first, by the edge with this number.
  template <int Axis>
  constexpr void close(stage_of<Axis> s, std::ptrdiff_t by) {
    if constexpr (Axis < 2) {
      const pipe_stage<V>& stage = stages_[Axis];
      if (!stage.started) return;
      const std::ptrdiff_t arrives_by = step(s, stage.first, stage.first_place, by);
      close(after(s), stage.first_place.beyond == 0 ? arrives_by : along_boundary);
    }
  }

private:
  template <int Axis>
  IRG_INLINE static constexpr auto after(stage_of<Axis>) noexcept {
    return stage_of<Axis + 1>{};
  }
  template <int Axis>
  IRG_INLINE constexpr const T& bound(int place) const noexcept {
    return place < 0 ? window_.low[Axis] : window_.high[Axis];
  }
  template <int Axis>
  IRG_INLINE constexpr int beyond(const P& p) const noexcept {
    const T x = coordinate(p, Axis);
    return static_cast<int>(window_.high[Axis] < x) - static_cast<int>(x < window_.low[Axis]);
  }
  template <int Axis>
  IRG_INLINE constexpr bool is_on(int place, const V& v) const noexcept {
    return coordinate(position_of(v), Axis) == bound<Axis>(place);
  }
  // A cut of the first axis that was rounded to a boundary of the second: the edge passes over or under that place.
  IRG_NOINLINE constexpr stage_place settled(const V& cut, std::ptrdiff_t on) const noexcept {
    const P &a = position_of(edge_(on)), &b = position_of(edge_(on + 1));
    const int turn = orient2d(a, b, position_of(cut)), off = coordinate(a, 0) < coordinate(b, 0) ? -turn : turn;
    return {off != 0 && is_on<1>(off, cut) ? off : 0, off != 0};
  }

  // The cuts between the last vertex and v; what leads to v in the next stage.
  template <int Axis>
  constexpr std::ptrdiff_t step(stage_of<Axis> s, const V& v, const stage_place& place, std::ptrdiff_t by) {
    const pipe_stage<V>& stage = stages_[Axis];
    const int was = stage.last_place.beyond, is = place.beyond;
    if (was == is) return by;
    if (was != 0) {
      if (is == 0 && !place.rounded && is_on<Axis>(was, v)) return along_boundary;
      take(after(s), cut<Axis>(was, v, by), along_boundary, true, by);
    }
    if (is != 0 && (was != 0 || stage.last_place.rounded || !is_on<Axis>(is, stage.last)))
      take(after(s), cut<Axis>(is, v, by), by, true, by);
    return by;
  }
  template <int Axis>
  constexpr V cut(int place, const V& to, std::ptrdiff_t by) const {
    const V *a = &stages_[Axis].last, *b = &to;
    if (by != along_boundary) a = &edge_(by), b = &edge_(by + 1);
    if (comes_before(position_of(*b), position_of(*a))) std::swap(a, b);
    const P &p = position_of(*a), &q = position_of(*b);
    const T x = bound<Axis>(place), low = coordinate(p, Axis), high = coordinate(q, Axis);
    const T y = axis_crossing_of(low, coordinate(p, 1 - Axis), high, coordinate(q, 1 - Axis), x);
    const P at = generate_coordinates<P>([&](int i) { return i == Axis ? x : y; });
    if constexpr (Point<V>)
      return at;
    else
      return placed_at(V(interpolate_(*a, *b, parameter_of(low, high, x))), at);
  }

  const box<T, 2>& window_;
  const F& interpolate_;
  const Edge& edge_;
  Sink& sink_;
  pipe_stage<V> stages_[2];
};

}  // namespace irg::detail
