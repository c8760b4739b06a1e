// SPDX-License-Identifier: MIT
// The list of a tile, drawn: groups of triangles are set up together; those of a pixel or few are drawn together, too,
// the others one after the other. Where so much is drawn on top of each other that it pays, nearer triangles come
// first, and what lies behind them is passed over.
#pragma once

#include <cstdint>
#include <span>

#include <irg/render/detail/bin/corner_lanes.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>
#include <irg/render/detail/visible/tile_kernel.hpp>
#include <irg/render/detail/visible/visible_pixels.hpp>

namespace irg::detail::inline IRG_ABI {

// The drawing of a tile's list: what is drawn, and how far it has come.
template <class T>
struct tile_pass {
  triangle_finder<T> find;
  std::span<const std::uint32_t> numbers;  // what the tile has to draw; its pixels hold places in this list
  cell_window window;
  tile_order order;
  tile& out;
  std::uint8_t* seen;  // by source triangle: whether any part of it was not passed over
  float farthest_key;  // of a pixel that shows nothing
  tile_counts counts{tile_integers{}, tile_integers{}};
  std::int64_t tested = 0, ties = 0;
  float of_both_signs = 0;  // the greatest slack of triangles that have depths of both signs
  bool holds_farthest = false;  // whether some pixels show a triangle at the farthest key, which is not seen
};

// A group of triangles in registers, a lane each: F at the first pixel of each box, the plane of depths, and the boxes
// within the tile.
struct group_lanes {
  tile_integers f[3], right[3], down[3], x_first, y_first, columns, rows;
  tile_floats gain[3], rest, low, high, slack;
};

// What is left to do of a group: a bit for each triangle whose sides are too long for 32-bit lanes, and for each one
// that is drawn already.
struct group_state {
  unsigned large = 0, drawn = 0;
};

// Pixels.

template <class T>
IRG_INLINE void note_seen(const tile_pass<T>& p, std::uint32_t place) noexcept {
  store_relaxed(p.seen[p.find.source(p.numbers[place])], 1);
}

// Makes a pixel the triangle's.
template <class T>
IRG_INLINE void show_triangle(tile_pass<T>& p, std::uint32_t place, float key, int at) noexcept {
  p.out.key[at] = key;
  p.out.id[at] = place;
  if (!p.order.front_to_back) return;
  const int y = at / tile_stride, x = at % tile_stride;
  p.out.stale |= std::uint64_t{1} << (y / block_size * blocks_across + x / block_size);
}

// Makes a pixel the triangle's if that is the one that is seen there: keys are too close to tell. What lies at the
// farthest key is kept, though it is not seen: of what comes later, it may be the nearer one.
template <class T>
IRG_NOINLINE void decide_close(tile_pass<T>& p, std::uint32_t place, float key, int at) noexcept {
  const float stored = p.out.key[at], sign = p.order.sign;
  const std::uint32_t other = p.out.id[at];
  const bool at_farthest = key == p.farthest_key;
  if (key == stored) ++p.ties;
  bool is_seen = stored < key || (at_farthest && key == stored);
  if (other != no_index) {
    const numbered_depth a{p.numbers[place], key * sign}, b{p.numbers[other], stored * sign};
    const cell pixel{p.window.x_first + at % tile_stride, p.window.y_first + at / tile_stride};
    is_seen = sign < 0 ? is_seen_before<nearer_is_less>(a, b, pixel, p.find)
                       : is_seen_before<nearer_is_greater>(a, b, pixel, p.find);
  }
  if (!is_seen) return;
  show_triangle(p, place, key, at);
  p.holds_farthest |= at_farthest;
}

// The small triangles of a group: those whose boxes have two or three columns and rows at most.

// What small triangles cover: a pixel's number is across * row + column.
struct small_coverage {
  static constexpr int most = 3, across = 4;
  float key[most * across][tile_lanes];
  std::uint64_t words[tile_lanes / 4];  // 16 bits to a triangle, four triangles to a word
};

// Decides one pixel of each box at a time, the same in all lanes. Boxes without columns have no pixels.
template <class T>
IRG_INLINE void cover_small(tile_pass<T>& p, small_coverage& out, const group_lanes& g,
                            const tile_integers& columns) noexcept {
  using J = lanes<tile_integers>;
  tile_integers covered = J::broadcast(0), row[3] = {g.f[0], g.f[1], g.f[2]};
  const bool third_column = mask_bits(J::broadcast(2) < columns) != 0,
             third_row = mask_bits(J::broadcast(2) < g.rows) != 0;
  for (int y = 0; y < (third_row ? 3 : 2); ++y) {
    tile_integers f[3] = {row[0], row[1], row[2]};
    for (int x = 0; x < (third_column ? 3 : 2); ++x) {
      const int pixel = small_coverage::across * y + x;
      const tile_integers here =
          both(none_negative(f[0], f[1], f[2]), both(J::broadcast(x) < columns, J::broadcast(y) < g.rows));
      p.counts.tested = p.counts.tested - here;
      covered = covered | both(here, J::broadcast(1 << pixel));
      lanes<tile_floats>::store(out.key[pixel], depth_at<tile_floats>(f, g));
      for (int k = 0; k < 3; ++k) f[k] = f[k] + g.right[k];
    }
    for (int k = 0; k < 3; ++k) row[k] = row[k] + g.down[k];
  }
  lanes<pack<std::uint16_t, tile_lanes>>::store_bytes(out.words, converted<std::uint16_t>(covered));
}

// Draws what is covered one by one, in the order of the list; `which` has a bit for each small triangle, `columns` of
// the others are none.
template <tile_test Test, class T>
IRG_INLINE void draw_small(tile_pass<T>& p, const group_lanes& g, const tile_integers& columns,
                           const std::uint32_t* place, unsigned which) noexcept {
  using J = lanes<tile_integers>;
  using F = lanes<tile_floats>;
  for (unsigned bits = which; bits != 0; bits &= bits - 1) note_seen(p, place[std::countr_zero(bits)]);
  float slack[tile_lanes];
  F::store(slack, g.slack + F::broadcast(p.of_both_signs));
  small_coverage c;
  cover_small(p, c, g, columns);
  std::int32_t at[tile_lanes];
  J::store(at, g.y_first * J::broadcast(tile_stride) + g.x_first);
  for (int w = 0; w < tile_lanes / 4; ++w)
    for (std::uint64_t bits = first_lowest(c.words[w]); bits != 0; bits &= bits - 1) {
      const int bit = std::countr_zero(bits), i = 4 * w + bit / 16, pixel = bit % 16;
      const int here = at[i] + pixel / small_coverage::across * tile_stride + pixel % small_coverage::across;
      const float key = c.key[pixel][i];
      if constexpr (Test == tile_test::nearer)
        if (const float ahead = key - p.out.key[here]; ahead <= slack[i]) {
          if (-slack[i] <= ahead) decide_close(p, place[i], key, here);
          continue;
        }
      if constexpr (Test == tile_test::depth_only)
        if (key <= p.out.key[here]) continue;
      show_triangle(p, place[i], key, here);
    }
}

// The set-up of a group.

template <class T>
IRG_NOINLINE void note_both_signs(tile_pass<T>& p, const group_lanes& g) noexcept {
  for (int i = 0; i < tile_lanes; ++i)
    if (g.low[i] < 0 && 0 < g.high[i]) p.of_both_signs = maximum(p.of_both_signs, g.slack[i]);
}

// Edges, depths and boxes. Of triangles that are not narrow, only the boxes have a meaning.
template <class T>
IRG_INLINE void set_up_lanes(tile_pass<T>& p, group_lanes& g, const corner_lanes<tile_lanes>& c,
                             const triangle_boxes<tile_lanes>& boxes) noexcept {
  using J = lanes<tile_integers>;
  using F = lanes<tile_floats>;
  const auto within = [](const tile_integers& v, int least, int end) {
    return minimum(maximum(v, J::broadcast(least)), J::broadcast(end));
  };
  const cell_window& w = p.window;
  const tile_integers x_first = within(first_centre(boxes.left), w.x_first, w.x_last),
                      x_last = within(last_centre(boxes.right), w.x_first, w.x_last),
                      y_first = within(first_centre(boxes.top), w.y_first, w.y_last),
                      y_last = within(last_centre(boxes.bottom), w.y_first, w.y_last);
  const tile_integers zero = J::broadcast(0);
  const tile_floats sign = F::broadcast(p.order.sign);
  const edge_lanes<tile_lanes> edges(c.x, c.y, boxes.double_area);
  tile_floats part[3];
  for (int k = 0; k < 3; ++k) {
    const auto [f, rest] = edges(k, x_first, y_first);
    g.f[k] = f;
    g.right[k] = zero - edges.dy[k];
    g.down[k] = edges.dx[k];
    part[k] = rest * c.depth[k];
    g.gain[k] = (edges.scale * c.depth[k]) * sign;
  }
  g.rest = (part[0] + (part[1] + part[2])) * sign;
  const tile_floats key0 = c.depth[0] * sign, key1 = c.depth[1] * sign, key2 = c.depth[2] * sign;
  g.low = minimum(minimum(key0, key1), key2);
  g.high = maximum(maximum(key0, key1), key2);
  g.slack = slack_of(maximum(g.high, F::broadcast(0) - g.low));
  if (mask_bits(both(g.low < F::broadcast(0), F::broadcast(0) < g.high)) != 0) [[unlikely]]
    note_both_signs(p, g);
  g.x_first = x_first - J::broadcast(w.x_first);
  g.y_first = y_first - J::broadcast(w.y_first);
  g.columns = select(boxes.double_area == zero, zero, x_last - x_first);
  g.rows = y_last - y_first;
}

IRG_INLINE void store_group(tile_triangles& to, const group_lanes& g) noexcept {
  using J = lanes<tile_integers>;
  using F = lanes<tile_floats>;
  for (int k = 0; k < 3; ++k) {
    J::store(to.f[k], g.f[k]);
    J::store(to.right[k], g.right[k]);
    J::store(to.down[k], g.down[k]);
    F::store(to.gain[k], g.gain[k]);
  }
  F::store(to.rest, g.rest);
  F::store(to.low, g.low);
  F::store(to.high, g.high);
  F::store(to.slack, g.slack);
  J::store(to.x_first, g.x_first);
  J::store(to.x_last, g.x_first + g.columns);
  J::store(to.y_first, g.y_first);
  J::store(to.y_last, g.y_first + g.rows);
}

// Sets up `used` triangles, and draws the few_pixels ones.
template <tile_test Test, class T>
IRG_INLINE group_state set_up_group(tile_pass<T>& p, tile_triangles& out, std::size_t first, int used) noexcept {
  using J = lanes<tile_integers>;
  corner_lanes<tile_lanes> c;
  c.collect(p.find, p.numbers.data() + first, used);
  for (int i = 0; i < tile_lanes; ++i) out.place[i] = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(i);
  const triangle_boxes<tile_lanes> boxes(c.x, c.y);
  const unsigned everyone = (1u << used) - 1, large = ~mask_bits(boxes.narrow) & everyone;
  group_lanes g;
  set_up_lanes(p, g, c, boxes);
  // Where rejection pays, only the smallest do without it.
  const tile_integers end = J::broadcast(p.order.front_to_back ? small_coverage::most : small_coverage::most + 1);
  // They are drawn before the others of their group, which changes nothing unless the later one always wins.
  const tile_integers is_small =
      both(both(g.columns < end, g.rows < end), both(boxes.narrow, J::ramp() < J::broadcast(used)));
  const unsigned few_pixels = Test == tile_test::always ? 0u : mask_bits(is_small);
  if (few_pixels != 0) draw_small<Test>(p, g, both(g.columns, is_small), out.place, few_pixels);
  if (few_pixels != everyone) store_group(out, g);
  return {large, few_pixels};
}

// One triangle of a group that is not small.

// Draws a triangle that is ready: its box row by row when it is small, else block by block.
template <tile_test Test, class T, class J>
IRG_INLINE tile_rest draw_ready(tile_pass<T>& p, const tile_triangle<J>& t, const cell_window& box) noexcept {
  constexpr int small_box = 2 * block_size;
  tile& out = p.out;
  if (box.x_last - box.x_first > small_box || box.y_last - box.y_first > small_box) {
    const std::uint64_t blocks = blocks_to_draw(out, t, box, p.order.front_to_back);
    if (blocks == 0) return {};
    note_seen(p, t.place);
    return tile_blocks<Test>(out, t, {box, blocks}, p.counts, p.order.front_to_back);
  }
  if (p.order.front_to_back) {
    float farthest = beyond_everything;
    std::uint64_t touched = 0;
    for (int by = box.y_first / block_size; by * block_size < box.y_last; ++by)
      for (int bx = box.x_first / block_size; bx * block_size < box.x_last; ++bx) {
        farthest = minimum(farthest, out.farthest_key[by * blocks_across + bx]);
        touched |= std::uint64_t{1} << (by * blocks_across + bx);
      }
    if (t.high[0] + t.slack[0] < farthest) return {};
    out.stale |= touched;
  }
  note_seen(p, t.place);
  return tile_rows<Test>(out, t, box, p.counts);
}

// What drawing it has left to be done.
template <class T, class J>
IRG_INLINE void finish_triangle(tile_pass<T>& p, const tile_triangle<J>& t, const cell_window& box,
                                const tile_rest& rest) noexcept {
  rest.for_each(rest.beside, [&](const cell_window& part) { uncount_beside(p.out, t, box, part, p.counts); });
  rest.for_each(rest.close, [&](const cell_window& part) {
    close_pixels(p.out, t, box, part, [&](float key, int at) { decide_close(p, t.place, key, at); });
  });
}

template <class J>
IRG_INLINE void broadcast_depths(tile_triangle<J>& t, const tile_triangles& g, int i, float more_slack) noexcept {
  using F = lanes<tile_floats>;
  for (int k = 0; k < 3; ++k) t.gain[k] = F::broadcast(g.gain[k][i]);
  t.rest = F::broadcast(g.rest[i]);
  t.low = F::broadcast(g.low[i]);
  t.high = F::broadcast(g.high[i]);
  t.slack = F::broadcast(g.slack[i] + more_slack);
  t.minus_slack = F::broadcast(0) - t.slack;
  t.place = g.place[i];
}

IRG_INLINE tile_triangle<tile_integers> narrow_triangle(const tile_triangles& g, int i, float more_slack) noexcept {
  using J = lanes<tile_integers>;
  tile_triangle<tile_integers> t;
  for (int k = 0; k < 3; ++k) {
    t.f[k] = g.f[k][i];
    t.right[k] = g.right[k][i];
    t.down[k] = g.down[k][i];
    t.ramp[k] = J::ramp() * J::broadcast(g.right[k][i]);
  }
  broadcast_depths(t, g, i, more_slack);
  return t;
}

IRG_INLINE cell_window box_of(const tile_triangles& g, int i) noexcept {
  return {g.x_first[i], g.y_first[i], g.x_last[i], g.y_last[i]};
}

// Whether triangle i of a group lies behind all that the tile shows.
template <class T>
IRG_INLINE bool is_behind(const tile_pass<T>& p, const tile_triangles& g, int i) noexcept {
  return p.order.front_to_back && g.high[i] + (g.slack[i] + p.of_both_signs) < p.out.farthest;
}

template <class T>
IRG_NOINLINE void finish_narrow(tile_pass<T>& p, const tile_triangles& g, int i, const tile_rest& rest) noexcept {
  finish_triangle(p, narrow_triangle(g, i, p.of_both_signs), box_of(g, i), rest);
}

// Triangle i of a group.
template <tile_test Test, class T>
IRG_INLINE void draw_narrow(tile_pass<T>& p, const tile_triangles& g, int i) noexcept {
  const cell_window box = box_of(g, i);
  if (box.empty() || is_behind(p, g, i)) return;
  const tile_rest rest = draw_ready<Test>(p, narrow_triangle(g, i, p.of_both_signs), box);
  if (Test == tile_test::nearer && rest.any()) [[unlikely]]
    finish_narrow(p, g, i, rest);
}

// The same with edge functions of type J, whose box is `w` of the picture.
template <tile_test Test, class J, class T>
IRG_INLINE void draw_set_up(tile_pass<T>& p, const triangle_setup& s, const cell_window& w, const tile_triangles& g,
                            int i) noexcept {
  using integer = typename tile_triangle<J>::integer;
  tile_triangle<J> t;
  for (int k = 0; k < 3; ++k) {
    t.f[k] = static_cast<integer>(s.edge[k](w.x_first, w.y_first));
    t.right[k] = static_cast<integer>(s.edge[k].right);
    t.down[k] = static_cast<integer>(s.edge[k].down);
    t.ramp[k] = lanes<J>::ramp() * lanes<J>::broadcast(t.right[k]);
  }
  broadcast_depths(t, g, i, p.of_both_signs);
  const int x = p.window.x_first, y = p.window.y_first;
  const cell_window box{w.x_first - x, w.y_first - y, w.x_last - x, w.y_last - y};
  const tile_rest rest = draw_ready<Test>(p, t, box);
  if (Test == tile_test::nearer && rest.any()) finish_triangle(p, t, box, rest);
}

// A triangle with long sides: 32-bit lanes where F fits them all over the tile, else doubles, which hold it exactly.
template <tile_test Test, class T>
IRG_NOINLINE void draw_large(tile_pass<T>& p, const tile_triangles& g, int i) noexcept {
  if (is_behind(p, g, i)) return;
  const triangle_corners c = p.find.corners(p.numbers[g.place[i]]);
  const auto [coverage, setup] = cover_and_set_up(*c.v[0], *c.v[1], *c.v[2]);
  const cell_window w = intersect(coverage.bounds, p.window);
  if (coverage.double_area == 0 || w.empty()) return;
  tile_triangles one = g;
  for (int k = 0; k < 3; ++k) one.gain[k][i] = product(setup.depth.gain[k], p.order.sign);
  one.rest[i] = product(setup.depth.rest, p.order.sign);
  const int x = p.window.x_first, y = p.window.y_first;
  const cell_window whole{x, y, x + tile_size, y + tile_size};
  if (fits_32_bits(coverage, whole, block_size))
    draw_set_up<Test, tile_integers>(p, setup, w, one, i);
  else
    draw_set_up<Test, wide_pack<tile_lanes>>(p, setup, w, one, i);
}

// What is left to do of a group that is set up.
template <tile_test Test, class T>
IRG_INLINE void draw_rest(tile_pass<T>& p, const tile_triangles& g, const group_state& state, int used) noexcept {
  for (unsigned bits = ((1u << used) - 1) & ~state.drawn; bits != 0; bits &= bits - 1) {
    const int i = std::countr_zero(bits);
    if ((state.large >> i & 1) != 0)
      draw_large<Test>(p, g, i);
    else
      draw_narrow<Test>(p, g, i);
  }
}

// The list.

// Prefetches what later groups will read: their vertices, and before that the indices that name them.
template <class T>
IRG_INLINE void fetch_ahead(const tile_pass<T>& p, std::size_t first) noexcept {
  constexpr std::size_t vertices_ahead = 16, indices_ahead = 32;
  if (p.find.batches.size() != 1 || first + indices_ahead + tile_lanes > p.numbers.size()) return;
  const triangle_batch<T>& batch = p.find.batches[0];
  const screen_vertex* const screen = batch.vertices->screen.data();
  const auto named = [&](std::size_t i) {  // for a piece any triangle will do
    return batch.triangles.data() + minimum(p.numbers[i], p.find.bins->triangle_count - 1);
  };
  for (std::size_t i = first; i < first + tile_lanes; ++i) {
    prefetch(named(i + indices_ahead));
    prefetch_vertices(screen, *named(i + vertices_ahead));
  }
}

// Moves the counts from the lanes to where they cannot overflow.
template <class T>
IRG_INLINE void add_counts(tile_pass<T>& p) noexcept {
  p.tested += reduce_add(p.counts.tested);
  p.ties += reduce_add(p.counts.ties);
  p.counts = {lanes<tile_integers>::broadcast(0), lanes<tile_integers>::broadcast(0)};
}

// The whole list, eight triangles at a time however many lanes there are: so the counts, too, are equal everywhere.
// Not inlined: one copy serves all shaders, which keeps their callers quick to compile.
template <tile_test Test, class T>
IRG_NOINLINE void draw_list(tile_pass<T>& p) noexcept {
  constexpr std::size_t at_once = 8, refresh = 8 * at_once, counted = 1024 * at_once, groups = at_once / tile_lanes;
  static_assert(at_once % tile_lanes == 0);
  for (std::size_t first = 0; first < p.numbers.size(); first += at_once) {
    tile_triangles g[groups];
    group_state state[groups];
    int used[groups];
    for (std::size_t k = 0; k < groups; ++k) {
      const std::size_t from = minimum(first + k * tile_lanes, p.numbers.size());
      used[k] = static_cast<int>(minimum(p.numbers.size() - from, std::size_t{tile_lanes}));
      fetch_ahead(p, from);
      if (used[k] > 0) state[k] = set_up_group<Test>(p, g[k], from, used[k]);
    }
    for (std::size_t k = 0; k < groups; ++k)
      if (used[k] > 0) draw_rest<Test>(p, g[k], state[k], used[k]);
    if (p.order.front_to_back) {
      if (first % refresh == 0)
        refresh_far(p.out);
      else
        refresh_farthest(p.out);
    }
    if (first % counted == 0) add_counts(p);
  }
  if (p.holds_farthest) hide_key(p.out, p.farthest_key);
  add_counts(p);
}

}  // namespace irg::detail::inline IRG_ABI
