// SPDX-License-Identifier: MIT
// Which triangles each tile of the picture has to draw. A triangle is culled, clipped if need be, and put on the list
// of every tile that its box touches, in the order the triangles were given in.
//
// Triangles are taken in portions, each with lists of its own, so that threads never meet; a counting sort then lays
// the lists of all portions one after the other, tile by tile. The result does not depend on the number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <irg/core/executor.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/screen_mapping.hpp>
#include <irg/raster/triangle_batch.hpp>
#include <irg/render/detail/bin/drawing_lists.hpp>
#if IRG_BODIES
#include <bit>

#include <irg/core/conversion.hpp>
#include <irg/core/lanes.hpp>
#include <irg/raster/projected_vertices.hpp>
#include <irg/raster/screen_pieces.hpp>
#include <irg/raster/triangle_setup.hpp>
#include <irg/raster/vertex_lanes.hpp>
#include <irg/raster/window.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>
#endif

namespace irg::detail {

// How triangles are listed.
template <class T>
struct listing_rules {
  const screen_mapping<T>& mapping;
  picture_tiles grid;
  face_culling culling;
  skip_options skip{};
};

inline namespace IRG_COMPILED_ABI {

// Makes the lists of all tiles for the triangles of all batches.
template <Floating T>
IRG_API void bin_triangles(triangle_bins& bins, std::span<const triangle_batch<T>> batches,
                           const listing_rules<T>& rules, const executor_ref& executor);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail

#if IRG_BODIES
namespace irg::detail {
inline namespace IRG_ABI {

// Which of N triangles are to be drawn, and their boxes of pixels: a register of triangles at a time.

static_assert(sizeof(triangle_indices) == 12);

// Asks for the vertices that a triangle names. They may be beyond the array.
IRG_INLINE void prefetch_vertices(const screen_vertex* screen, const triangle_indices& t) noexcept {
  for (const std::uint32_t v : t.v) prefetch(screen, static_cast<std::ptrdiff_t>(std::size_t{v} * sizeof *screen));
}

// What became of N triangles: one bit per lane.
template <int N>
struct culled_group {
  unsigned listed = 0;  // to be drawn: box(k) is not empty
  unsigned special = 0;  // too large for 32 bits, or to be clipped: not decided here
  skip_counts skipped;
  static constexpr unsigned count = N;
  std::int32_t x_first[count], y_first[count], x_last[count], y_last[count];

  IRG_INLINE cell_window box(std::uint32_t k) const noexcept { return {x_first[k], y_first[k], x_last[k], y_last[k]}; }
};

template <int N>
struct cull_kernel {
  using integers = pack<std::int32_t, N>;
  const screen_vertex* screen;
  const clip_code_pair* codes;
  std::int32_t vertices;  // how many there are
  clip_code_pair any;
  cell_window picture;
  face_culling culling;

  // Asks for the vertices of a later group; for its indices, which has to come long before.
  IRG_INLINE void fetch_ahead(const triangle_indices* t) const noexcept {
    for (int i = 0; i < N; ++i) prefetch_vertices(screen, t[i]);
  }
  IRG_INLINE static void fetch_indices(const triangle_indices* t) noexcept {
    constexpr std::size_t line = 64;
    for (std::size_t i = 0; i < N * sizeof *t; i += line) prefetch(t, static_cast<std::ptrdiff_t>(i));
  }

  // Whether all corners of N triangles name vertices.
  IRG_INLINE bool indices_valid(const triangle_indices* t) const noexcept {
    using J = lanes<integers>;
    integers valid = J::broadcast(-1);
    for (int k = 0; k < 3; ++k) {
      const integers w = J::load_bytes(reinterpret_cast<const char*>(t) + k * static_cast<int>(sizeof w));
      valid = both(valid, both(w >= 0, w < vertices));
    }
    return mask_bits(valid) == (1u << N) - 1;
  }

  IRG_INLINE culled_group<N> operator()(const triangle_indices* t, const skip_options& skip) const noexcept {
    using J = lanes<integers>;
    culled_group<N> group;
    if (!indices_valid(t)) {  // some name vertices that are not there
      group.special = (1u << N) - 1;
      return group;
    }
    integers x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      const auto corner = load_vertices<N>(screen, [&](int i) { return t[i].v[k]; });
      x[k] = corner.x;
      y[k] = corner.y;
    }
    unsigned alive = (1u << N) - 1;
    if (any.outside != 0 || any.cut != 0) {
      unsigned cut = 0, outside = 0;
      for (unsigned bits = alive; bits != 0; bits &= bits - 1) {
        const int i = std::countr_zero(bits);
        const clip_code_pair a = codes[t[i].v[0]], b = codes[t[i].v[1]], c = codes[t[i].v[2]];
        if ((a | b | c).cut != 0) cut |= 1u << i;
        if ((a & b & c).outside != 0) outside |= 1u << i;
      }
      group.special = cut;
      alive &= ~cut;
      if (skip.frustum == skipping::on) {
        group.skipped.frustum += std::popcount(alive & outside);
        alive &= ~outside;
      }
    }

    const triangle_boxes<N> boxes(x, y);
    const unsigned narrow = mask_bits(boxes.narrow);
    const integers &area = boxes.double_area, zero = J::broadcast(0);
    group.special |= alive & ~narrow;
    alive &= narrow;
    if (culling == face_culling::back) {
      const unsigned back = mask_bits(zero < area) & alive;
      group.skipped.backface += std::popcount(back);
      alive &= ~back;
    }
    if (alive == 0) return group;  // often, as neighbours face the same way
    // The centres within the box, then those within the picture.
    const integers x_first = first_centre(boxes.left), x_last = last_centre(boxes.right);
    const integers y_first = first_centre(boxes.top), y_last = last_centre(boxes.bottom);
    const unsigned tiny =
        alive & (mask_bits(area == zero) | mask_bits(x_first >= x_last) | mask_bits(y_first >= y_last));
    const integers seen_x_first = maximum(x_first, J::broadcast(picture.x_first)),
                   seen_x_last = minimum(x_last, J::broadcast(picture.x_last)),
                   seen_y_first = maximum(y_first, J::broadcast(picture.y_first)),
                   seen_y_last = minimum(y_last, J::broadcast(picture.y_last));
    const unsigned unseen =
        alive & ~tiny & (mask_bits(seen_x_first >= seen_x_last) | mask_bits(seen_y_first >= seen_y_last));
    if (skip.tiny == skipping::on)
      group.skipped.tiny += std::popcount(tiny);
    else
      group.special |= tiny;
    if (skip.frustum == skipping::on) group.skipped.frustum += std::popcount(unseen);
    group.listed = alive & ~tiny & ~unseen;
    J::store(group.x_first, seen_x_first);
    J::store(group.x_last, seen_x_last);
    J::store(group.y_first, seen_y_first);
    J::store(group.y_last, seen_y_last);
    return group;
  }
};

}  // namespace IRG_ABI

inline namespace IRG_ABI {

// Where the pieces of a portion are numbered from until the portions before it are known.
inline constexpr std::uint32_t piece_bit = 0x80000000;

IRG_INLINE constexpr std::uint64_t entry_of(std::size_t tile, std::uint32_t number) noexcept {
  return static_cast<std::uint64_t>(tile) << 32 | number;
}

// Puts a number on the list of one tile, of which its box has `area` pixels.
// needs   room among the entries
template <class Portion>
IRG_INLINE constexpr void list_in_tile(Portion& p, std::uint32_t number, std::size_t tile,
                                       std::uint32_t area) noexcept {
  p.entries[p.entry_count++] = entry_of(tile, number);
  auto& share = p.of_tile[tile];
  ++share.count;
  share.area += area;
}

// Makes room for some more entries.
template <class Portion>
IRG_INLINE constexpr void reserve_entries(Portion& p, std::size_t more) {
  if (p.entries.size() - p.entry_count < more) p.entries.resize(2 * p.entries.size() + more, 0);
}

// Puts a number on the lists of the tiles that a box of pixels touches.
// needs   a box that is not empty and lies in the picture
template <class Portion>
IRG_INLINE constexpr void list_box(Portion& p, std::uint32_t number, const cell_window& box,
                                   const picture_tiles& grid) {
  const auto tile_of = [](int pixel) { return static_cast<int>(static_cast<unsigned>(pixel) / tile_size); };
  const auto list = [&](int x, int y, int w, int h) {
    reserve_entries(p, 1);
    list_in_tile(p, number, static_cast<std::size_t>(y * grid.across + x), static_cast<std::uint32_t>(w * h));
  };
  const int x_first = tile_of(box.x_first), x_last = tile_of(box.x_last - 1);
  const int y_first = tile_of(box.y_first), y_last = tile_of(box.y_last - 1);
  if (x_first == x_last && y_first == y_last)
    return list(x_first, y_first, box.x_last - box.x_first, box.y_last - box.y_first);
  for (int y = y_first; y <= y_last; ++y)
    for (int x = x_first; x <= x_last; ++x)
      list(x, y, minimum(box.x_last, (x + 1) * tile_size) - maximum(box.x_first, x * tile_size),
           minimum(box.y_last, (y + 1) * tile_size) - maximum(box.y_first, y * tile_size));
}

// What becomes of a triangle on the screen: of several pieces' fates the greatest counts.
enum class listing { tiny, out_of_sight, listed };

// The pixels that the box of three vertices touches, be it with their centres or not.
IRG_INLINE constexpr cell_window pixels_touched(const subpixel& a, const subpixel& b, const subpixel& c) noexcept {
  return {minimum(minimum(a.x, b.x), c.x) >> subpixel_bits, minimum(minimum(a.y, b.y), c.y) >> subpixel_bits,
          (maximum(maximum(a.x, b.x), c.x) >> subpixel_bits) + 1,
          (maximum(maximum(a.y, b.y), c.y) >> subpixel_bits) + 1};
}

// Lists one triangle, or says why not. Where tiny triangles are not skipped, they go through coverage to no effect.
template <class T>
constexpr listing list_triangle(bin_portion& p, std::uint32_t number, const triangle_corners& corners,
                                std::int64_t area, const listing_rules<T>& rules) {
  const subpixel &a = corners.v[0]->position, &b = corners.v[1]->position, &c = corners.v[2]->position;
  cell_window box = centres_within(a, b, c);
  if (area == 0 || box.empty()) {
    if (rules.skip.tiny == skipping::on) return listing::tiny;
    box = pixels_touched(a, b, c);
  }
  const cell_window seen = intersect(box, {0, 0, rules.grid.width, rules.grid.height});
  if (seen.empty()) return listing::out_of_sight;
  list_box(p, number, seen, rules.grid);
  return listing::listed;
}

IRG_INLINE constexpr void count_listing(bin_portion& p, listing fate, const skip_options& skip) noexcept {
  if (fate == listing::listed) ++p.listed;
  if (fate == listing::tiny && skip.tiny == skipping::on) ++p.skipped.tiny;
  if (fate == listing::out_of_sight && skip.frustum == skipping::on) ++p.skipped.frustum;
}

// Clips a triangle, and lists what is left of it as a fan of pieces. It faces one way, and is one skip at most, however
// many pieces it comes to.
template <class T>
constexpr void list_clipped(bin_portion& p, std::uint32_t source, const hpoint<T, 3> (&corner)[3],
                            const listing_rules<T>& rules) {
  const screen_pieces pieces = clip_to_screen(corner, rules.mapping, source);
  if (pieces.outside) return count_listing(p, listing::out_of_sight, rules.skip);
  if (pieces.double_area > 0 && rules.culling == face_culling::back) return static_cast<void>(++p.skipped.backface);
  listing result = listing::tiny;
  bool holds_centres = false;  // whatever is skipped
  for (const auto& [face, weights] : pieces) {
    const auto& [a, b, c] = face.v;
    const auto number = piece_bit | static_cast<std::uint32_t>(p.pieces.size());
    const clipped_piece piece{{a, b, c}, weights, source};
    const listing l = list_triangle(p, number, corners_of(piece.v), face.coverage.double_area, rules);
    if (l == listing::listed) p.pieces.push_back(piece);
    result = maximum(result, l);
    holds_centres |= !intersect(face.coverage.bounds, {0, 0, rules.grid.width, rules.grid.height}).empty();
  }
  p.clipped += holds_centres ? 1 : 0;
  count_listing(p, result, rules.skip);
}

// One triangle of a portion.
template <class T>
constexpr void list_one(bin_portion& p, const triangle_batch<T>& batch, std::uint32_t i, std::uint32_t number,
                        const listing_rules<T>& rules) {
  if (!has_vertices(batch, i)) return;
  const auto [a, b, c] = batch.triangles[i].v;
  const projected_vertices<T>& v = *batch.vertices;
  const clip_code_pair any = v.codes[a] | v.codes[b] | v.codes[c], all = v.codes[a] & v.codes[b] & v.codes[c];
  // Beyond one plane with all corners. Where clipping comes first, its rounding has a say in where the triangle
  // lands, and only the depth planes, by which it decides itself, are sure to change nothing.
  const clip_planes sure = any.cut == 0 ? clip_planes::all : clip_planes::depth;
  if (rules.skip.frustum == skipping::on && overlap(all.outside_planes(), sure))
    return static_cast<void>(++p.skipped.frustum);
  if (any.cut != 0)
    return list_clipped<T>(p, number, {clip_position(v, a), clip_position(v, b), clip_position(v, c)}, rules);
  const triangle_corners on_screen{{&v.screen[a], &v.screen[b], &v.screen[c]}};
  const std::int64_t area = twice_signed_area(v.screen[a].position, v.screen[b].position, v.screen[c].position);
  if (area > 0 && rules.culling == face_culling::back) return static_cast<void>(++p.skipped.backface);
  count_listing(p, list_triangle(p, number, on_screen, area, rules), rules.skip);
}

// The tiles that the boxes of a group lie in, as far as each lies in one.
template <int N>
struct group_tiles {
  unsigned one;  // a bit for each triangle that is listed, and in one tile only
  std::uint32_t tile[static_cast<unsigned>(N)], area[static_cast<unsigned>(N)];

  IRG_INLINE group_tiles(const culled_group<N>& group, int across) noexcept {
    using integers = pack<std::int32_t, N>;
    using J = lanes<integers>;
    constexpr int shift = std::countr_zero(static_cast<unsigned>(tile_size));
    const integers x_first = J::load(group.x_first), y_first = J::load(group.y_first), x_last = J::load(group.x_last),
                   y_last = J::load(group.y_last), tile_x = x_first >> shift, tile_y = y_first >> shift;
    one = group.listed & mask_bits(both((x_last - 1) >> shift == tile_x, (y_last - 1) >> shift == tile_y));
    const integers place = tile_y * J::broadcast(across) + tile_x, pixels = (x_last - x_first) * (y_last - y_first);
    J::store_bytes(tile, place);
    J::store_bytes(area, pixels);
  }
};

// The triangles of a portion, a register at a time; returns the first that is left to do.
template <class T>
IRG_INLINE std::uint32_t fill_in_lanes(bin_portion& p, const triangle_batch<T>& batch, const listing_rules<T>& rules) {
  const picture_tiles& grid = rules.grid;
  constexpr std::uint32_t count = native_lanes<std::int32_t>, vertices_ahead = 64, indices_ahead = 448;
  const cull_kernel<static_cast<int>(count)> kernel{batch.vertices->screen.data(),
                                                    batch.vertices->codes.data(),
                                                    static_cast<std::int32_t>(batch.vertices->screen.size()),
                                                    batch.vertices->any,
                                                    {0, 0, grid.width, grid.height},
                                                    rules.culling};
  std::uint32_t i = p.first;
  for (; i + count <= p.last; i += count) {
    const triangle_indices* const t = batch.triangles.data() + i;
    if (i + vertices_ahead + count <= p.last) kernel.fetch_ahead(t + vertices_ahead);
    if (i + indices_ahead + count <= p.last) kernel.fetch_indices(t + indices_ahead);
    const auto group = kernel(t, rules.skip);
    p.skipped += group.skipped;
    if ((group.listed | group.special) == 0) continue;
    p.listed += std::popcount(group.listed);
    const group_tiles<static_cast<int>(count)> tiles(group, grid.across);
    reserve_entries(p, count);
    for (unsigned bits = group.listed | group.special; bits != 0; bits &= bits - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(bits));
      if ((tiles.one >> k & 1) != 0) {
        list_in_tile(p, batch.first_number + i + k, tiles.tile[k], tiles.area[k]);
        continue;
      }
      if ((group.special >> k & 1) != 0)
        list_one(p, batch, i + k, batch.first_number + i + k, rules);
      else
        list_box(p, batch.first_number + i + k, group.box(k), grid);
      reserve_entries(p, count);
    }
  }
  return i;
}

// All triangles of a portion; in lanes where they can be.
template <class T>
constexpr void fill_portion(bin_portion& p, const triangle_batch<T>& batch, const listing_rules<T>& rules) {
  p.of_tile.assign(rules.grid.count(), tile_share{});
  p.entry_count = 0;
  p.pieces.clear();
  std::uint32_t i = p.first;
  if (!std::is_constant_evaluated()) i = fill_in_lanes(p, batch, rules);
  for (; i < p.last; ++i) list_one(p, batch, i, batch.first_number + i, rules);
}

// Lays the lists of all portions one after the other.
template <Executor E>
constexpr void join_portions(triangle_bins& bins, std::size_t tiles, const E& executor) {
  bins.tile_first.assign(tiles + 1, 0);
  bins.tile_area.assign(tiles, 0.0f);
  bins.skipped = {};
  bins.listed = bins.clipped = 0;
  bins.pieces.clear();
  for (bin_portion& p : bins.portions) {
    p.first_piece = bins.triangle_count + static_cast<std::uint32_t>(bins.pieces.size());
    bins.pieces.insert(bins.pieces.end(), p.pieces.begin(), p.pieces.end());
    bins.skipped += p.skipped;
    bins.listed += p.listed;
    bins.clipped += p.clipped;
  }
  std::uint32_t start = 0;
  for (std::size_t t = 0; t < tiles; ++t) {
    bins.tile_first[t] = start;
    for (bin_portion& p : bins.portions) {
      const std::uint32_t count = p.of_tile[t].count;
      p.of_tile[t].count = start;  // from here on: where the portion's next entry for the tile goes
      start += count;
      bins.tile_area[t] += static_cast<float>(p.of_tile[t].area);
    }
  }
  bins.tile_first[tiles] = start;
  bins.numbers.resize(start, 0);
  executor(bins.portions.size(), [&](std::size_t i) {
    bin_portion& p = bins.portions[i];
    for (const std::uint64_t entry : std::span(p.entries).first(p.entry_count)) {
      const auto number = static_cast<std::uint32_t>(entry & 0xffffffff);
      bins.numbers[p.of_tile[static_cast<std::size_t>(entry >> 32)].count++] =
          (number & piece_bit) != 0 ? p.first_piece + (number ^ piece_bit) : number;
    }
  });
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API void bin_triangles(triangle_bins& bins, std::span<const triangle_batch<T>> batches,
                           const listing_rules<T>& rules, const executor_ref& executor) {
  constexpr std::uint32_t portion = 1 << 15;
  std::size_t used = 0;
  bins.triangle_count = 0;
  for (std::size_t b = 0; b < batches.size(); ++b) {
    const auto count = static_cast<std::uint32_t>(batches[b].triangles.size());
    for (std::uint32_t first = 0; first < count; first += portion, ++used) {
      if (used == bins.portions.size()) bins.portions.emplace_back();
      bin_portion& p = bins.portions[used];
      p.batch = b;
      p.first = first;
      p.last = minimum(first + portion, count);
      p.skipped = {};
      p.listed = p.clipped = 0;
    }
    bins.triangle_count += count;
  }
  bins.portions.resize(used);
  executor(used, [&](std::size_t i) {
    bin_portion& p = bins.portions[i];
    fill_portion(p, batches[p.batch], rules);
  });
  join_portions(bins, rules.grid.count(), executor);
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
