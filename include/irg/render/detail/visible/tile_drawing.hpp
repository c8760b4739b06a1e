// SPDX-License-Identifier: MIT
// The list of a tile, drawn: groups of triangles are made ready together; those of a pixel or few are drawn together,
// too, the others one after the other. Where so much is drawn on top of each other that it pays, nearer triangles come
// first, and what lies behind them is passed over.
#pragma once

#include <cstdint>
#include <span>

#include <irg/render/detail/visible/tile_kernel.hpp>
#include <irg/render/detail/visible/visible_window.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>

namespace irg::detail::inline IRG_ABI {

template <class T>
struct tile_painter {
  static constexpr int count = tile_triangles::most;
  using integers = pack<std::int32_t, count>;
  using floats = pack<float, count>;

  triangle_finder<T> find;
  std::span<const std::uint32_t> numbers;  // what the tile has to draw; its pixels hold places in this list
  cell_window window;
  tile_order order;
  tile& out;
  std::uint8_t* seen;  // by source triangle: whether any part of it was gone into
  float farthest_key;  // of a pixel that shows nothing
  tile_counts counts{lanes<integers>::broadcast(0), lanes<integers>::broadcast(0)};
  std::int64_t tested = 0, ties = 0;
  float of_both_signs = 0;  // the greatest slack of triangles that have depths of both signs
  bool holds_farthest = false;  // whether some pixels show a triangle at the farthest key, which is not seen

  IRG_INLINE void note_seen(std::uint32_t place) const noexcept { store_relaxed(seen[find.source(numbers[place])], 1); }

  // Triangles of few pixels, a lane each: F, depth and box, as in tile_triangles.
  struct dots {
    static constexpr int most = 3;  // columns and rows
    integers f[3], right[3], down[3], columns, rows, at;
    floats gain[3], rest, low, high, slack;
  };

  // Decides one pixel of each box at a time, the same in all lanes; what is covered is then drawn one by one, in the
  // order of the list.
  template <tile_test Test>
  IRG_INLINE void draw_dots(const dots& d, const std::uint32_t* place, unsigned which) noexcept {
    using J = lanes<integers>;
    for (unsigned bits = which; bits != 0; bits &= bits - 1) note_seen(place[std::countr_zero(bits)]);
    constexpr int across = 4;  // a pixel's number is across * row + column
    float key[dots::most * across][count], slack[count];
    lanes<floats>::store(slack, d.slack + lanes<floats>::broadcast(of_both_signs));
    integers covered = J::broadcast(0), row[3] = {d.f[0], d.f[1], d.f[2]};
    const bool third_column = mask_bits(J::broadcast(2) < d.columns) != 0,
               third_row = mask_bits(J::broadcast(2) < d.rows) != 0;
    for (int y = 0; y < (third_row ? 3 : 2); ++y) {
      integers f[3] = {row[0], row[1], row[2]};
      for (int x = 0; x < (third_column ? 3 : 2); ++x) {
        const int pixel = across * y + x;
        const integers here =
            both(none_negative(f[0], f[1], f[2]), both(J::broadcast(x) < d.columns, J::broadcast(y) < d.rows));
        counts.tested = counts.tested - here;
        covered = covered | both(here, J::broadcast(1 << pixel));
        lanes<floats>::store(key[pixel], depth_at<floats>(f, d));
        for (int k = 0; k < 3; ++k) f[k] = f[k] + d.right[k];
      }
      for (int k = 0; k < 3; ++k) row[k] = row[k] + d.down[k];
    }
    std::int32_t at[count];
    J::store(at, d.at);
    // 16 bits to a triangle, four triangles to a word.
    std::uint64_t words[count / 4];
    lanes<pack<std::uint16_t, count>>::store_bytes(words, converted<std::uint16_t>(covered));
    for (int w = 0; w < count / 4; ++w)
      for (std::uint64_t bits = first_lowest(words[w]); bits != 0; bits &= bits - 1) {
        const int bit = std::countr_zero(bits), i = 4 * w + bit / 16, pixel = bit % 16;
        const int place_of_pixel = at[i] + pixel / across * tile_stride + pixel % across;
        if constexpr (Test == tile_test::nearer)
          if (const float ahead = key[pixel][i] - out.key[place_of_pixel]; ahead <= slack[i]) {
            if (-slack[i] <= ahead) decide_close(place[i], key[pixel][i], place_of_pixel);
            continue;
          }
        if constexpr (Test == tile_test::depth_only)
          if (key[pixel][i] <= out.key[place_of_pixel]) continue;
        show(place[i], key[pixel][i], place_of_pixel);
      }
  }
  IRG_INLINE void show(std::uint32_t place, float key, int at) noexcept {
    out.key[at] = key;
    out.id[at] = place;
    if (order.front_to_back) {
      const int y = at / tile_stride, x = at % tile_stride;
      out.stale |= std::uint64_t{1} << (y / block_size * blocks_across + x / block_size);
    }
  }

  // Makes a pixel the triangle's if that is the one that is seen there: keys are too close to tell. What lies at the
  // farthest key is kept, though it is not seen: of what comes later, it may be the nearer one.
  IRG_NOINLINE void decide_close(std::uint32_t place, float key, int at) noexcept {
    const float stored = out.key[at];
    const std::uint32_t other = out.id[at];
    const bool at_farthest = key == farthest_key;
    if (key == stored) ++ties;
    bool is_seen = stored < key || (at_farthest && key == stored);
    if (other != no_face) {
      const numbered_depth a{numbers[place], key * order.sign}, b{numbers[other], stored * order.sign};
      const cell pixel{window.x_first + at % tile_stride, window.y_first + at / tile_stride};
      is_seen = order.sign < 0 ? is_seen_before<nearer_is_less>(a, b, pixel, find)
                               : is_seen_before<nearer_is_greater>(a, b, pixel, find);
    }
    if (!is_seen) return;
    show(place, key, at);
    holds_farthest |= at_farthest;
  }

  // What is left to do of a group: a bit for each triangle whose sides are too long for 32-bit lanes, and for each one
  // that is drawn already.
  struct group_state {
    unsigned large = 0, drawn = 0;
  };

  // Sets up `used` triangles, and draws those whose boxes have two columns and rows at most.
  template <tile_test Test>
  IRG_INLINE group_state set_up_group(tile_triangles& g, std::size_t first, int used) noexcept {
    using J = lanes<integers>;
    using F = lanes<floats>;
    corner_lanes<count> c;
    c.collect(find, numbers.data() + first, used);
    const auto &x = c.x, &y = c.y;
    const auto& depth = c.depth;
    for (int i = 0; i < count; ++i) g.place[i] = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(i);
    const triangle_boxes<count> boxes(x, y);
    const integers &narrow = boxes.narrow, &area = boxes.double_area, zero = J::broadcast(0);
    const unsigned everyone = (1u << used) - 1, large = ~mask_bits(narrow) & everyone;

    const auto within = [&](const integers& v, int least, int end) {
      return low_of(high_of(v, J::broadcast(least)), J::broadcast(end));
    };
    const integers x_first = within(first_centre(boxes.left), window.x_first, window.x_last),
                   x_last = within(last_centre(boxes.right), window.x_first, window.x_last),
                   y_first = within(first_centre(boxes.top), window.y_first, window.y_last),
                   y_last = within(last_centre(boxes.bottom), window.y_first, window.y_last);

    const edge_lanes<count> edges(x, y, area);
    floats part[3];
    dots d;
    for (int k = 0; k < 3; ++k) {
      const auto [f, rest] = edges(k, x_first, y_first);
      d.f[k] = f;
      d.right[k] = zero - edges.dy[k];
      d.down[k] = edges.dx[k];
      part[k] = rest * depth[k];
      d.gain[k] = (edges.scale * depth[k]) * F::broadcast(order.sign);
    }
    d.rest = (part[0] + (part[1] + part[2])) * F::broadcast(order.sign);
    const floats key0 = depth[0] * F::broadcast(order.sign), key1 = depth[1] * F::broadcast(order.sign),
                 key2 = depth[2] * F::broadcast(order.sign);
    d.low = low_of(low_of(key0, key1), key2);
    d.high = high_of(high_of(key0, key1), key2);
    d.slack = slack_of(high_of(d.high, F::broadcast(0) - d.low));
    if (mask_bits(both(d.low < F::broadcast(0), F::broadcast(0) < d.high)) != 0) [[unlikely]]
      note_both_signs(d);
    d.columns = select(area == zero, zero, x_last - x_first);
    d.rows = y_last - y_first;
    // Where rejection pays, only the smallest do without it.
    const integers end = J::broadcast(order.front_to_back ? dots::most : dots::most + 1);
    // They are drawn before the others of their group, which is of no account unless the later one always wins.
    const integers is_dot = both(both(d.columns < end, d.rows < end), both(narrow, J::ramp() < J::broadcast(used)));
    const unsigned few = Test == tile_test::always ? 0u : mask_bits(is_dot);
    const integers columns = d.columns;
    if (few != 0) {
      d.columns = both(d.columns, is_dot);
      d.at = (y_first - J::broadcast(window.y_first)) * J::broadcast(tile_stride) +
             (x_first - J::broadcast(window.x_first));
      draw_dots<Test>(d, g.place, few);
    }
    if (few != everyone) {
      for (int k = 0; k < 3; ++k) {
        J::store(g.f[k], d.f[k]);
        J::store(g.right[k], d.right[k]);
        J::store(g.down[k], d.down[k]);
        F::store(g.gain[k], d.gain[k]);
      }
      F::store(g.rest, d.rest);
      F::store(g.low, d.low);
      F::store(g.high, d.high);
      F::store(g.slack, d.slack);
      J::store(g.x_first, x_first - J::broadcast(window.x_first));
      J::store(g.x_last, x_first + columns - J::broadcast(window.x_first));
      J::store(g.y_first, y_first - J::broadcast(window.y_first));
      J::store(g.y_last, y_last - J::broadcast(window.y_first));
    }
    return {large, few};
  }

  IRG_NOINLINE void note_both_signs(const dots& d) noexcept {
    for (int i = 0; i < count; ++i)
      if (d.low[i] < 0 && 0 < d.high[i]) of_both_signs = greater(of_both_signs, d.slack[i]);
  }

  // Draws a triangle that is ready: its box row by row when it is small, else block by block.
  template <tile_test Test, class J>
  IRG_INLINE tile_rest draw_ready(const tile_triangle<J>& t, const cell_window& box) noexcept {
    constexpr int small_box = 2 * block_size;
    if (box.x_last - box.x_first > small_box || box.y_last - box.y_first > small_box) {
      const std::uint64_t blocks = blocks_to_draw(out, t, box, order.front_to_back);
      if (blocks == 0) return {};
      note_seen(t.place);
      return tile_blocks<Test>(out, t, {box, blocks}, counts, order.front_to_back);
    }
    if (order.front_to_back) {
      float farthest = beyond_everything;
      std::uint64_t touched = 0;
      for (int by = box.y_first / block_size; by * block_size < box.y_last; ++by)
        for (int bx = box.x_first / block_size; bx * block_size < box.x_last; ++bx) {
          farthest = lesser(farthest, out.farthest_key[by * blocks_across + bx]);
          touched |= std::uint64_t{1} << (by * blocks_across + bx);
        }
      if (t.high[0] + t.slack[0] < farthest) return {};
      out.stale |= touched;
    }
    note_seen(t.place);
    return tile_rows<Test>(out, t, box, counts);
  }
  // What drawing it has left to be done.
  template <class J>
  IRG_INLINE void finish(const tile_triangle<J>& t, const cell_window& box, const tile_rest& rest) noexcept {
    rest.for_each(rest.beside, [&](const cell_window& part) { uncount_beside(out, t, box, part, counts); });
    rest.for_each(rest.close, [&](const cell_window& part) {
      close_pixels(out, t, box, part, [&](float key, int at) { decide_close(t.place, key, at); });
    });
  }

  template <class J>
  IRG_INLINE void broadcast_depths(tile_triangle<J>& t, const tile_triangles& g, int i) const noexcept {
    using F = lanes<floats>;
    for (int k = 0; k < 3; ++k) t.gain[k] = F::broadcast(g.gain[k][i]);
    t.rest = F::broadcast(g.rest[i]);
    t.low = F::broadcast(g.low[i]);
    t.high = F::broadcast(g.high[i]);
    t.slack = F::broadcast(g.slack[i] + of_both_signs);
    t.minus_slack = F::broadcast(0) - t.slack;
    t.place = g.place[i];
  }
  IRG_INLINE tile_triangle<integers> small_triangle(const tile_triangles& g, int i) const noexcept {
    using J = lanes<integers>;
    tile_triangle<integers> t;
    for (int k = 0; k < 3; ++k) {
      t.f[k] = g.f[k][i];
      t.right[k] = g.right[k][i];
      t.down[k] = g.down[k][i];
      t.ramp[k] = J::ramp() * J::broadcast(g.right[k][i]);
    }
    broadcast_depths(t, g, i);
    return t;
  }

  // Whether triangle i of a group lies behind all that the tile shows.
  IRG_INLINE bool is_behind(const tile_triangles& g, int i) const noexcept {
    return order.front_to_back && g.high[i] + (g.slack[i] + of_both_signs) < out.farthest;
  }

  // Triangle i of a group.
  template <tile_test Test>
  IRG_INLINE void draw_small(const tile_triangles& g, int i) noexcept {
    if (g.x_first[i] >= g.x_last[i] || g.y_first[i] >= g.y_last[i]) return;
    if (is_behind(g, i)) return;
    const cell_window box{g.x_first[i], g.y_first[i], g.x_last[i], g.y_last[i]};
    const tile_rest rest = draw_ready<Test>(small_triangle(g, i), box);
    if (Test == tile_test::nearer && rest.any()) [[unlikely]]
      finish_small(g, i, rest);
  }
  IRG_NOINLINE void finish_small(const tile_triangles& g, int i, const tile_rest& rest) noexcept {
    finish(small_triangle(g, i), {g.x_first[i], g.y_first[i], g.x_last[i], g.y_last[i]}, rest);
  }

  // A triangle with long sides: 32-bit lanes where F fits them all over the tile, else doubles, which hold it exactly.
  template <tile_test Test>
  IRG_NOINLINE void draw_large(const tile_triangles& g, int i) noexcept {
    if (is_behind(g, i)) return;
    const triangle_corners c = find.corners(numbers[g.place[i]]);
    const covered_triangle covered = cover_and_set_up(*c.v[0], *c.v[1], *c.v[2]);
    const triangle_coverage& coverage = covered.coverage;
    const triangle_setup& s = covered.setup;
    const cell_window w = intersect(coverage.bounds, window);
    if (coverage.double_area == 0 || w.empty()) return;
    tile_triangles one = g;
    for (int k = 0; k < 3; ++k) one.gain[k][i] = product(s.depth.gain[k], order.sign);
    one.rest[i] = product(s.depth.rest, order.sign);
    const auto draw = [&]<class J>(J) {
      tile_triangle<J> t;
      using integer = typename tile_triangle<J>::integer;
      for (int k = 0; k < 3; ++k) {
        t.f[k] = static_cast<integer>(s.edge[k](w.x_first, w.y_first));
        t.right[k] = static_cast<integer>(s.edge[k].right);
        t.down[k] = static_cast<integer>(s.edge[k].down);
        t.ramp[k] = lanes<J>::ramp() * lanes<J>::broadcast(t.right[k]);
      }
      broadcast_depths(t, one, i);
      const cell_window box{w.x_first - window.x_first, w.y_first - window.y_first, w.x_last - window.x_first,
                            w.y_last - window.y_first};
      const tile_rest rest = draw_ready<Test>(t, box);
      if (Test == tile_test::nearer && rest.any()) finish(t, box, rest);
    };
    const cell_window whole{window.x_first, window.y_first, window.x_first + tile_size, window.y_first + tile_size};
    if (fits_32_bits(coverage, whole, block_size))
      draw(integers{});
    else
      draw(wide_pack<count>{});
  }

  // Asks for what later groups will read: their vertices, and before that the indices that name them.
  IRG_INLINE void fetch_ahead(std::size_t first) const noexcept {
    constexpr std::size_t vertices_ahead = 16, indices_ahead = 32;
    if (find.batches.size() != 1 || first + indices_ahead + count > numbers.size()) return;
    const triangle_batch<T>& batch = find.batches[0];
    const screen_vertex* const screen = batch.vertices->screen.data();
    const auto named = [&](std::size_t i) {  // for a piece any triangle will do
      return batch.triangles.data() + lesser(numbers[i], find.bins->triangle_count - 1);
    };
    for (std::size_t i = first; i < first + count; ++i) {
      prefetch(named(i + indices_ahead));
      prefetch_vertices(screen, *named(i + vertices_ahead));
    }
  }

  // The whole list, eight triangles at a time however many lanes there are: so the counts, too, are equal everywhere.
  // Not inlined: one copy serves all shaders, which keeps their callers quick to compile.
  template <tile_test Test>
  IRG_NOINLINE void draw_list() noexcept {
    constexpr std::size_t at_once = 8, refresh = 8 * at_once, counted = 1024 * at_once, groups = at_once / count;
    static_assert(at_once % count == 0);
    for (std::size_t first = 0; first < numbers.size(); first += at_once) {
      tile_triangles g[groups];
      group_state state[groups];
      int used[groups];
      for (std::size_t k = 0; k < groups; ++k) {
        const std::size_t from = lesser(first + k * count, numbers.size());
        used[k] = static_cast<int>(lesser(numbers.size() - from, std::size_t{count}));
        fetch_ahead(from);
        if (used[k] > 0) state[k] = set_up_group<Test>(g[k], from, used[k]);
      }
      for (std::size_t k = 0; k < groups; ++k)
        if (used[k] > 0) draw_rest<Test>(g[k], state[k], used[k]);
      if (order.front_to_back) {
        if (first % refresh == 0)
          refresh_far(out);
        else
          refresh_farthest(out);
      }
      if (first % counted == 0) add_counts();
    }
    if (holds_farthest) hide_key(out, farthest_key);
    add_counts();
  }

  // What is left to do of a group that is set up.
  template <tile_test Test>
  IRG_INLINE void draw_rest(const tile_triangles& g, const group_state& state, int used) noexcept {
    for (unsigned bits = ((1u << used) - 1) & ~state.drawn; bits != 0; bits &= bits - 1) {
      const int i = std::countr_zero(bits);
      if ((state.large >> i & 1) != 0)
        draw_large<Test>(g, i);
      else
        draw_small<Test>(g, i);
    }
  }

  // Moves the counts from the lanes to where they cannot overflow.
  IRG_INLINE void add_counts() noexcept {
    tested += total(counts.tested);
    ties += total(counts.ties);
    counts = {lanes<integers>::broadcast(0), lanes<integers>::broadcast(0)};
  }
};

}  // namespace irg::detail::inline IRG_ABI
