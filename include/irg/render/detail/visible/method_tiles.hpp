// SPDX-License-Identifier: MIT
// From ids, whoever wrote them, to what a window shows.
#pragma once

#include <cstdint>

#include <irg/core/executor.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/detail/visible/tile_driver.hpp>
#include <irg/render/window_faces.hpp>
#if IRG_BODIES
#include <algorithm>
#include <concepts>
#include <span>
#include <vector>

#include <irg/hidden/painter_once.hpp>
#include <irg/render/detail/visible/clear_window.hpp>
#include <irg/render/detail/visible/visible_pixels.hpp>
#endif

namespace irg::detail::inline IRG_COMPILED_ABI {

// Draws all tiles as a method finds what they show, which writes into `ids`, and hands each to `finish`.
template <class Order, Floating T, class Depth>
IRG_API render_counts draw_by_ids(const method_ref<T>& method, image<std::uint32_t>& ids, Depth& depth,
                                  const tile_job<T>& job, const tile_finish<T>& finish, const executor_ref& executor);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::detail {

// The numbers of triangles of the convex bodies in a picture of which only front faces are drawn.
struct IRG_APART convex_bodies {
  struct range {
    std::uint32_t first, end;
  };
  std::vector<range> drawn;  // numbers rise

  template <class T>
  constexpr void note(const triangle_batch<T>& body) {
    drawn.push_back({body.first_number, body.first_number + static_cast<std::uint32_t>(body.triangles.size())});
  }

  // Whether two triangles belong to one of them.
  template <std::same_as<std::uint32_t> N>
  [[nodiscard]] constexpr bool is_one(N a, N b) const noexcept {
    const auto after = std::upper_bound(drawn.begin(), drawn.end(), a, [](N n, const range& r) { return n < r.first; });
    return after != drawn.begin() && a < after[-1].end && after[-1].first <= b && b < after[-1].end;
  }
};

inline namespace IRG_ABI {

// The place in a tile's list of the triangle that has this number and covers a pixel, and its depth there; no_index
// where there is none. Of pieces the nearest: where snapping turned one round, two others may cover a centre. Lists are
// in the order of sources.
struct place_and_depth {
  std::uint32_t place = no_index;
  float depth = 0;
  covered_triangle t{};
};
template <class Order, class T>
constexpr place_and_depth place_of(std::uint32_t id, int x, int y, std::span<const std::uint32_t> numbers,
                                   const triangle_finder<T>& find) noexcept {
  std::size_t first = 0;
  for (std::size_t size = numbers.size(); size > 0;) {
    const std::size_t half = size / 2;
    if (find.source(numbers[first + half]) < id) {
      first += half + 1;
      size -= half + 1;
    } else {
      size = half;
    }
  }
  place_and_depth nearest;
  for (; first < numbers.size() && find.source(numbers[first]) == id; ++first) {
    const triangle_corners c = find.corners(numbers[first]);
    const covered_triangle t = cover_and_set_up(*c.v[0], *c.v[1], *c.v[2]);
    if (!covers(t.coverage, x, y)) continue;
    const float depth = depth_at(t.setup, x, y);
    if (nearest.place == no_index ||
        is_seen_before<Order>({numbers[first], depth}, {numbers[nearest.place], nearest.depth}, {x, y}, find))
      nearest = {static_cast<std::uint32_t>(first), depth, t};
  }
  return nearest;
}

// The places of the faces that ids name in a window, and their depths. Ids of faces that do not cover the pixel, are
// not on the window's list, or are no nearer there than the farthest depth, count as none.
template <class Order, class T, class Ids>
constexpr void find_places(visible_pixels& out, const Ids& ids, std::span<const std::uint32_t> numbers,
                           const triangle_finder<T>& find, const cell_window& w) {
  std::uint32_t last_id = no_index;
  place_and_depth last;
  for (int y = w.y_first; y < w.y_last; ++y)
    for (int x = w.x_first; x < w.x_last; ++x) {
      const std::uint32_t id = get_pixel(ids, x, y);
      if (id == no_index) continue;
      if (id == last_id && last.place != no_index && !find.is_piece(numbers[last.place]) &&
          covers(last.t.coverage, x, y))
        last.depth = depth_at(last.t.setup, x, y);
      else
        last = place_of<Order>(id, x, y, numbers, find);
      last_id = id;
      if (last.place == no_index || !Order::nearer(last.depth, Order::farthest)) continue;
      const std::size_t at = visible_pixels::at(w, x, y);
      out.place[at] = last.place;
      out.key[at] = last.depth;
    }
}

// Tiles whose ids another method finds. `ids` belongs to the picture, all no_index before. Where `bodies` are given,
// the method is not asked about tiles that show one convex body alone.
template <class Order, class T>
struct method_tiles {
  const method_ref<T>& method;
  image<std::uint32_t>& ids;
  const convex_bodies* bodies = nullptr;

  static constexpr float farthest() noexcept { return Order::farthest; }

  template <class Depth>
  constexpr draw_counts operator()(Depth& depth, const tile_job<T>& job, std::size_t i,
                                   const tile_finish<T>& finish) const {
    const cell_window w = picture_tiles(width_of(depth), height_of(depth)).window(i);
    const std::span<const std::uint32_t> numbers = job.lists.bins.list_of(i);
    const triangle_finder<T> find = job.finder();
    draw_counts counts;
    const window_faces<T> faces = make_window_faces{}(find, numbers);
    const bool alone = bodies != nullptr && !numbers.empty() &&
                       bodies->is_one(find.source(numbers.front()), find.source(numbers.back()));
    if (alone) {
      painter_once<Order>{}(faces, w, ids, counts);
      counts.convex = static_cast<std::int64_t>(faces.size());
    } else {
      method(faces, w, ids, counts);
    }
    mark_all_seen(job, numbers);
    visible_pixels pixels(w);
    find_places<Order>(pixels, ids, numbers, find, w);
    if (job.clear == clearing::before_drawing) clear_window(depth, w, Order::farthest);
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) {
        const std::size_t at = visible_pixels::at(w, x, y);
        if (pixels.place[at] != no_index) set_pixel(depth, x, y, pixels.key[at]);
      }
    counts.shaded = finish(visible_window{pixels.place.data(), pixels.key.data(), 1.0f, numbers, w}, find);
    return counts;
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Order, Floating T, class Depth>
IRG_API render_counts draw_by_ids(const method_ref<T>& method, image<std::uint32_t>& ids, Depth& depth,
                                  const tile_job<T>& job, const tile_finish<T>& finish, const executor_ref& executor) {
  return draw_tiles<T>(method_tiles<Order, T>{method, ids}, depth, job, finish, executor);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
