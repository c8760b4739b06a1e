// SPDX-License-Identifier: MIT
// Which pixels may show something of each room of a building, by the rectangles of its portals.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/raster/window.hpp>
#include <irg/render/prepared_scene.hpp>
#include <irg/visibility/view_through_portals.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

template <class T>
class room_windows {
public:
  constexpr room_windows(const cell_plan<T>& plan, const camera<T>& view, const cell_window& picture)
      : plan_(plan), view_(view), picture_(picture),
        to_clip_(view_projection(view, static_cast<T>(picture.x_last) / static_cast<T>(picture.y_last))),
        seen_(plan.cells.size(), cell_window{}) {}

  constexpr std::vector<cell_window> find(const portal_graph<T>& doors) {
    std::vector<std::uint32_t> changed;
    for (std::uint32_t c = 0; c < seen_.size(); ++c)
      if (is_in_reach(plan_.cells[c])) seen_[c] = picture_, changed.push_back(c);
    if (changed.empty() || view_.projection != projection_kind::perspective)
      seen_.assign(seen_.size(), picture_);
    else
      follow(doors, changed);
    return std::move(seen_);
  }

private:
  static constexpr cell_window not_known{-1, -1, -2, -2};

  constexpr void follow(const portal_graph<T>& doors, std::vector<std::uint32_t>& changed) {
    std::vector<cell_window> portals(plan_.portals.size(), not_known);
    while (!changed.empty()) {
      const std::uint32_t c = changed.back();
      changed.pop_back();
      for (const doorway<T>& d : doors.doors(c)) {
        if (portals[d.portal] == not_known) portals[d.portal] = window_of_door(d);
        const cell_window shown = intersect(seen_[c], portals[d.portal]);
        const cell_window grown = around(seen_[d.to], shown);
        if (grown == seen_[d.to]) continue;
        seen_[d.to] = grown;
        changed.push_back(d.to);
      }
    }
  }

  static constexpr cell_window around(const cell_window& a, const cell_window& b) noexcept {
    if (a.empty() || b.empty()) return a.empty() && !b.empty() ? b : a;
    return {lesser(a.x_first, b.x_first), lesser(a.y_first, b.y_first), greater(a.x_last, b.x_last),
            greater(a.y_last, b.y_last)};
  }

  // Whether a point of the near plane may lie in a cell, so that rays begin in it.
  constexpr bool is_in_reach(const plan_cell<T>& c) const noexcept {
    const T t = tan(view_.vertical_angle / T(2)),
            wide = static_cast<T>(picture_.x_last) / static_cast<T>(picture_.y_last);
    const T reach = view_.near_distance * (T(1) + t + t * wide);  // more than to the corners of the picture
    box<T, 3> b{};
    for (const point<T, 2>& p : c.corners)
      for (const T& z : {c.floor, c.ceiling}) b = enclosing_box(b, point<T, 3>{p.x, p.y, z});
    bool is_near = true;
    for (int i = 0; i < 3; ++i)
      is_near = is_near && b.low[i] - reach <= view_.eye[i] && view_.eye[i] <= b.high[i] + reach;
    return is_near;
  }

  // The pixels in which an opening may show something, and one more on each side.
  constexpr cell_window window_of_door(const doorway<T>& d) const {
    const auto opening = opening_of(plan_, d);
    if (!(opening[0].z < opening[2].z)) return {};
    clip_vertex<T, 0> corners[4]{};
    for (std::size_t i = 0; i < 4; ++i) {
      corners[i].position = to_clip_ * hpoint<T, 3>{opening[i].x, opening[i].y, opening[i].z, T(1)};
      for (int k = 0; k < 4; ++k)
        if (!(magnitude(corners[i].position[k]) < (std::numeric_limits<T>::max)() / T(64))) return picture_;
    }
    const auto kept = clip_homogeneous(corners, clip_volume<T>{clip_planes::sides, T(2), T(2)});
    cell_window out{};
    for (const auto& v : kept) {
      if (!(T(0) < v.position.w)) return picture_;
      const auto pixel = [](T x, T w, int size) {
        return static_cast<int>((x / w + T(1)) * (static_cast<T>(size) / T(2)) + T(size)) - size;  // rounded down
      };
      const int x = pixel(v.position.x, v.position.w, picture_.x_last);
      const int y = pixel(-v.position.y, v.position.w, picture_.y_last);
      out = around(out, {x - 1, y - 1, x + 2, y + 2});
    }
    return intersect(out, picture_);
  }

  const cell_plan<T>& plan_;
  const camera<T>& view_;
  cell_window picture_;
  mat<T, 4, 4> to_clip_;
  std::vector<cell_window> seen_;
};

// Some of the objects that are prepared.
template <class T>
struct chosen_objects {
  std::span<prepared_object<T>> made;
  std::vector<std::uint32_t> numbers{};

  constexpr std::size_t size() const noexcept { return numbers.size(); }
  constexpr const object_extent<T>& extent(std::size_t i) const noexcept { return made[numbers[i]].extent; }
  constexpr const mesh<T>& shape(std::size_t i) const noexcept { return made[numbers[i]].shape; }
  constexpr prepared_object<T>& operator[](std::size_t i) const noexcept { return made[numbers[i]]; }
};

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
