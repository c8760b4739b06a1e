// SPDX-License-Identifier: MIT
// A finished tile turned into colours by attributes: triangle by triangle, N pixels at once, and where triangles are as
// small as pixels, N pixels of as many triangles.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/render/attribute_shading.hpp>
#include <irg/render/detail/bin/corner_lanes.hpp>
#include <irg/render/detail/shade/tile_shading.hpp>
#include <irg/render/detail/visible/streamed_rows.hpp>

namespace irg::detail::inline IRG_ABI {

template <class Shading, int N>
concept LaneAttributeShading = requires(
    const Shading& s, const std::array<pack<float, N>, static_cast<std::size_t>(Shading::attribute_count)>& v) {
  { s.pixels(v) } -> std::same_as<pack<std::uint32_t, N>>;
};

template <class Shading>
inline constexpr std::size_t attribute_count_of = static_cast<std::size_t>(Shading::attribute_count);

// The attributes of a register of pixels.
template <class Shading>
using attribute_values = std::array<tile_floats, attribute_count_of<Shading>>;

// A run of pixels of one triangle within a register, and the next run of that triangle.
struct pixel_run {
  std::uint32_t first;  // the register's first pixel, counted through the tile
  std::uint32_t next;

  IRG_INLINE int row() const noexcept { return static_cast<int>(first / tile_size); }
  IRG_INLINE int part() const noexcept { return static_cast<int>(first % tile_size / tile_lanes); }
  IRG_INLINE int at() const noexcept { return static_cast<int>(first) + row() * (tile_stride - tile_size); }
};
// The runs of a tile, the triangles that are seen in the order in which they were met, and the tile's colours.
struct run_list {
  std::uint32_t count = 0, triangles = 0;
  pixel_run list[tile_size * tile_size];
  std::uint32_t place[tile_size * tile_size];
  alignas(64) std::uint32_t words[static_cast<unsigned>(tile_size * tile_stride)];
  tile_floats row_number[tile_size];  // the numbers of rows, in every lane
};

// A tile's triangles, and where their attributes come from.
template <class T, class Shading>
struct attribute_source {
  triangle_finder<T> find;
  std::span<const std::uint32_t> numbers;  // the tile's list
  cell_window window;
  const Shading& shading;
};

// The colouring of a tile: what it shows, where it goes, and how far it has come.
template <class T, class Shading, class Colour>
struct attribute_pass {
  const std::uint32_t* place_at;  // what each pixel shows: its place in the list
  attribute_source<T, Shading> of;
  Colour& colour;
  const pixel_of<Colour>* background;  // for pixels without a triangle; null when they keep what is there
  std::vector<std::uint32_t> last_run{};  // by place: in run_list
};

inline constexpr unsigned whole_register = (1u << tile_lanes) - 1;
inline constexpr int registers_across = tile_size / tile_lanes;

// What the N pixels from a place in the tile on show.
IRG_INLINE tile_integers places_at(const std::uint32_t* place_at, int at) noexcept {
  return lanes<tile_integers>::load_bytes(place_at + at);
}

// What the pixels of a triangle share when they are coloured by attributes: made ready for one triangle, for N small
// ones at once, or for N pixels each of a triangle of its own. The numbers are the same in all three ways.

// What the pixels of one triangle share. Changes of attributes are from the first vertex to the others.
template <class Shading>
struct triangle_attributes {
  std::uint32_t place;
  triangle_setup s;
  bool narrow;  // F fits 32 bits all over the tile
  const piece_weights* piece;
  float at0[attribute_count_of<Shading>], change1[attribute_count_of<Shading>], change2[attribute_count_of<Shading>];
};
template <class T, class Shading>
IRG_NOINLINE triangle_attributes<Shading> prepare_triangle(const attribute_source<T, Shading>& p, std::uint32_t place) {
  const std::uint32_t number = p.numbers[place];
  const cell_window& w = p.window;
  const cell_window whole{w.x_first, w.y_first, w.x_first + tile_size, w.y_first + tile_size};
  const triangle_corners c = p.find.corners(number);
  const triangle_coverage coverage = cover_triangle(c.v[0]->position, c.v[1]->position, c.v[2]->position);
  const std::uint32_t source = p.find.source(number);
  const triangle_batch<T>& batch = p.find.batch_of(source);
  const auto of =
      pixel_shader_of(p.shading, batch, source - batch.first_number, coverage.flipped ? facing::front : facing::back);
  triangle_attributes<Shading> t{place,
                                 set_up_triangle(coverage, *c.v[0], *c.v[1], *c.v[2]),
                                 fits_32_bits(coverage, whole, block_size),
                                 piece_weights_of(p.find, number),
                                 {},
                                 {},
                                 {}};
  for (std::size_t j = 0; j < attribute_count_of<Shading>; ++j) {
    t.at0[j] = of.a[j];
    t.change1[j] = of.b[j] - of.a[j];
    t.change2[j] = of.c[j] - of.a[j];
  }
  return t;
}

// N small triangles of one batch, a lane each: differences of 32 bits suffice for their edges.
template <class T>
struct small_lanes {
  corner_lanes<tile_lanes> c;
  const triangle_batch<T>* batch;
  tile_integers double_area;
};
// gives   false when they are not all small, or of several batches, or pieces
template <class T>
IRG_INLINE bool collect_small(small_lanes<T>& s, const triangle_finder<T>& find, const tile_integers& number) noexcept {
  s.batch = s.c.collect(find, number);
  if (s.batch == nullptr) return false;
  const triangle_boxes<tile_lanes> boxes(s.c.x, s.c.y);
  if (mask_bits(boxes.narrow) != whole_register) return false;
  s.double_area = boxes.double_area;
  return true;
}

// Calls each(j, a, b, c) with attribute j at the three vertices.
template <class T, class Shading, class Each>
IRG_INLINE void for_each_attribute(const Shading& shading, const small_lanes<T>& s, const tile_integers& flip,
                                   const Each& each) noexcept {
  const unsigned flipped = mask_bits(flip);
  const float* const front = shading.attributes(*s.batch, 0, flipped != 0 ? facing::front : facing::back);
  const float* const back = shading.attributes(*s.batch, 0, flipped != whole_register ? facing::back : facing::front);
  for (int j = 0; j < Shading::attribute_count; ++j) {
    tile_floats at[3];
    for (int k = 0; k < 3; ++k) {
      const tile_integers word = s.c.vertex[k] * Shading::attribute_count + j;
      at[k] = gather<float>(front, word);
      if (front != back) at[k] = select(flip, at[k], gather<float>(back, word));
    }
    each(static_cast<std::size_t>(j), at[0], at[1], at[2]);
  }
}

// Small triangles that are seen, a lane each. F is at most 2^24 all over the tile, so floats hold it.
template <class Shading>
struct small_attributes {
  float f[3][tile_lanes], right[3][tile_lanes], down[3][tile_lanes];  // F at the tile's first pixel, and its steps
  float scale[tile_lanes], rest[3][tile_lanes], inverse_w[3][tile_lanes];
  float at0[attribute_count_of<Shading>][tile_lanes], change1[attribute_count_of<Shading>][tile_lanes],
      change2[attribute_count_of<Shading>][tile_lanes];
};
// Makes N triangles ready at once.
// gives   false when they are not all small triangles of one batch
template <class T, class Shading>
IRG_NOINLINE bool prepare_small(const attribute_source<T, Shading>& p, small_attributes<Shading>& out,
                                const tile_integers& number) noexcept {
  using J = lanes<tile_integers>;
  using F = lanes<tile_floats>;
  small_lanes<T> s;
  if (!collect_small(s, p.find, number)) return false;
  const edge_lanes<tile_lanes> edges(s.c.x, s.c.y, s.double_area);
  // F at the first pixel of the box, where nothing overflows, and from there at the tile's first.
  const auto first_of = [](const tile_integers(&v)[3], int least, int most) {
    const tile_integers low = minimum(minimum(v[0], v[1]), v[2]);
    return minimum(maximum(low >> subpixel_bits, J::broadcast(least)), J::broadcast(most));
  };
  const cell_window& w = p.window;
  const tile_integers column = first_of(s.c.x, w.x_first, w.x_last), row = first_of(s.c.y, w.y_first, w.y_last);
  F::store(out.scale, edges.scale);
  for (int k = 0; k < 3; ++k) {
    const auto [f, rest] = edges(k, column, row);
    F::store(out.f[k], to_float(f + edges.dy[k] * (column - J::broadcast(w.x_first)) -
                                edges.dx[k] * (row - J::broadcast(w.y_first))));
    F::store(out.right[k], to_float(J::broadcast(0) - edges.dy[k]));
    F::store(out.down[k], to_float(edges.dx[k]));
    F::store(out.rest[k], rest);
    F::store(out.inverse_w[k], s.c.inverse_w[k]);
  }
  for_each_attribute(p.shading, s, edges.flip,
                     [&](std::size_t j, const tile_floats& a, const tile_floats& b, const tile_floats& c) {
                       F::store(out.at0[j], a);
                       F::store(out.change1[j], b - a);
                       F::store(out.change2[j], c - a);
                     });
  return true;
}

// The attributes of N pixels in a row, each of a triangle of its own.
// shape   `places` has -1 for a pixel without one; `shown` a bit for each of the others
// gives   false when they are not all small triangles of one batch
template <class T, class Shading>
IRG_INLINE bool attributes_of_many(const attribute_source<T, Shading>& p, const tile_integers& places, unsigned shown,
                                   const cell& first, attribute_values<Shading>& out) noexcept {
  using J = lanes<tile_integers>;
  // A pixel that shows nothing takes another's triangle, which it may be far from: any finite number will do there.
  const tile_integers some = J::broadcast(places[std::countr_zero(shown)]);
  const tile_integers of_each = select(places == J::broadcast(-1), some, places);
  small_lanes<T> s;
  if (!collect_small(s, p.find, gather<std::int32_t>(p.numbers.data(), of_each))) return false;
  const edge_lanes<tile_lanes> edges(s.c.x, s.c.y, s.double_area);
  const tile_integers column = J::ramp() + J::broadcast(first.x), row = J::broadcast(first.y);
  tile_floats b[3];
  for (int k = 0; k < 3; ++k) {
    const auto [f, rest] = edges(k, column, row);
    b[k] = to_float(f) * edges.scale + rest;
  }
  const auto& w = s.c.inverse_w;
  const tile_floats b1 = b[1] * w[1], b2 = b[2] * w[2];
  const tile_floats inverse = lanes<tile_floats>::broadcast(1) / (b[0] * w[0] + (b1 + b2));
  const tile_floats weight1 = b1 * inverse, weight2 = b2 * inverse;
  for_each_attribute(p.shading, s, edges.flip,
                     [&](std::size_t j, const tile_floats& at0, const tile_floats& at1, const tile_floats& at2) {
                       out[j] = at0 + (weight1 * (at1 - at0) + weight2 * (at2 - at0));
                     });
  return true;
}

// What the pixels of one triangle share, in every lane.
template <class Shading>
struct broadcast_attributes {
  tile_floats scale, rest[3], inverse_w[3];
  attribute_values<Shading> at0, change1, change2;
  const piece_weights* piece;
};
template <class Shading>
IRG_INLINE broadcast_attributes<Shading> in_every_lane(const triangle_attributes<Shading>& t) noexcept {
  using F = lanes<tile_floats>;
  broadcast_attributes<Shading> s;
  s.scale = F::broadcast(t.s.scale);
  s.piece = t.piece;
  for (int e = 0; e < 3; ++e) {
    s.rest[e] = F::broadcast(t.s.rest[e]);
    s.inverse_w[e] = F::broadcast(t.s.inverse_w[e]);
  }
  for (std::size_t j = 0; j < s.at0.size(); ++j) {
    s.at0[j] = F::broadcast(t.at0[j]);
    s.change1[j] = F::broadcast(t.change1[j]);
    s.change2[j] = F::broadcast(t.change2[j]);
  }
  return s;
}
template <class Shading>
IRG_INLINE broadcast_attributes<Shading> in_every_lane(const small_attributes<Shading>& of, std::size_t i) noexcept {
  using F = lanes<tile_floats>;
  broadcast_attributes<Shading> s;
  s.scale = F::broadcast(of.scale[i]);
  s.piece = nullptr;
  for (int e = 0; e < 3; ++e) {
    s.rest[e] = F::broadcast(of.rest[e][i]);
    s.inverse_w[e] = F::broadcast(of.inverse_w[e][i]);
  }
  for (std::size_t j = 0; j < s.at0.size(); ++j) {
    s.at0[j] = F::broadcast(of.at0[j][i]);
    s.change1[j] = F::broadcast(of.change1[j][i]);
    s.change2[j] = F::broadcast(of.change2[j][i]);
  }
  return s;
}

// The attributes of N pixels from their edge functions: perspective-correct.
template <class Shading>
IRG_INLINE attribute_values<Shading> attributes_at(const broadcast_attributes<Shading>& s, const tile_floats& f0,
                                                   const tile_floats& f1, const tile_floats& f2) noexcept {
  const tile_floats b0 = f0 * s.scale + s.rest[0], b1 = f1 * s.scale + s.rest[1], b2 = f2 * s.scale + s.rest[2];
  const tile_floats w1 = b1 * s.inverse_w[1], w2 = b2 * s.inverse_w[2];
  const tile_floats inverse = lanes<tile_floats>::broadcast(1) / (b0 * s.inverse_w[0] + (w1 + w2));
  pixel_weights<tile_floats> at{w1 * inverse, w2 * inverse, lanes<tile_floats>::broadcast(0)};
  if (s.piece != nullptr) at = in_source(at, *s.piece);
  attribute_values<Shading> v;
  for (std::size_t j = 0; j < v.size(); ++j) v[j] = s.at0[j] + (at.weight1 * s.change1[j] + at.weight2 * s.change2[j]);
  return v;
}

// Calls with(edge) for the registers of a triangle that is not small, or a piece of one: edge(e, y, part) is edge
// function e at the register `part` of row y.
template <class With>
IRG_INLINE void with_edges(const triangle_setup& s, bool narrow, const cell_window& window, const With& with) {
  if (narrow) {
    using J = lanes<tile_integers>;
    tile_integers ramp[3];
    std::int32_t right[3], down[3];
    for (int e = 0; e < 3; ++e) {
      right[e] = static_cast<std::int32_t>(s.edge[e].right);
      down[e] = static_cast<std::int32_t>(s.edge[e].down);
      const auto origin = static_cast<std::int32_t>(s.edge[e](window.x_first, window.y_first));
      ramp[e] = J::broadcast(origin) + J::broadcast(right[e]) * J::ramp();
    }
    with([&](int e, int y, int part) {
      return to_float(ramp[e] + J::broadcast(right[e] * (part * tile_lanes) + down[e] * y));
    });
  } else {
    with([&](int e, int y, int part) {
      using wide = lanes<wide_pack<tile_lanes>>;
      const triangle_edge& edge = s.edge[e];
      const std::int64_t first = edge(window.x_first + part * tile_lanes, window.y_first + y);
      return to_float(wide::broadcast(static_cast<double>(first)) +
                      wide::broadcast(static_cast<double>(edge.right)) * wide::ramp());
    });
  }
}

// Runs: first it is found out where each triangle is seen.

template <class Shading>
IRG_INLINE void blend_values(const Shading& shading, std::uint32_t* to, const tile_integers& where,
                             const attribute_values<Shading>& v) noexcept {
  using words = lanes<pack<std::uint32_t, tile_lanes>>;
  words::store(to, select(where, shading.pixels(v), words::load(to)));
}

template <class T, class Shading, class Colour>
IRG_INLINE void add_run(attribute_pass<T, Shading, Colour>& p, run_list& runs, int first,
                        std::uint32_t place) noexcept {
  const std::uint32_t next = p.last_run[place];
  if (next == no_index) runs.place[runs.triangles++] = place;
  runs.list[runs.count] = {static_cast<std::uint32_t>(first), next};
  p.last_run[place] = runs.count++;
}

// A row of small triangles: three and more in a register are shaded now, each pixel for itself, unless they are listed
// already.
template <class T, class Shading, class Colour>
IRG_NOINLINE void collect_many(attribute_pass<T, Shading, Colour>& p, run_list& runs, int y, std::uint64_t starts) {
  using J = lanes<tile_integers>;
  for (int x = 0; x < tile_size; x += tile_lanes, starts >>= tile_lanes - 1, starts >>= 1) {
    unsigned firsts = static_cast<unsigned>(starts) & whole_register;
    const int at = y * tile_stride + x;
    if (std::popcount(firsts) > 2) {
      const tile_integers places = places_at(p.place_at, at), nothing = places == J::broadcast(-1);
      const tile_integers some = J::broadcast(places[std::countr_zero(firsts)]);
      const tile_integers met = gather<std::int32_t>(p.last_run.data(), select(nothing, some, places));
      attribute_values<Shading> v;
      if (mask_bits(met == J::broadcast(-1)) != 0 &&
          attributes_of_many(p.of, places, ~mask_bits(nothing) & whole_register,
                             {p.of.window.x_first + x, p.of.window.y_first + y}, v)) {
        blend_values(p.of.shading, runs.words + at, ~nothing, v);
        continue;
      }
    }
    for (; firsts != 0; firsts &= firsts - 1)
      add_run(p, runs, y * tile_size + x, p.place_at[at + std::countr_zero(firsts)]);
  }
}

// Lists the runs of a row.
// gives   the number of pixels that show a triangle
template <class T, class Shading, class Colour>
IRG_INLINE int collect_row(attribute_pass<T, Shading, Colour>& p, run_list& runs, int y) {
  // A bit for each pixel that shows another triangle than the next, that shows nothing, that starts a register.
  std::uint64_t last = 0, nothing = 0, first = 0;
  for (int x = 0; x < tile_size; x += tile_lanes) {
    const int at = y * tile_stride + x;
    const tile_integers places = places_at(p.place_at, at);
    last |= std::uint64_t{~mask_bits(places == places_at(p.place_at, at + 1)) & whole_register} << x;
    nothing |= std::uint64_t{mask_bits(places == lanes<tile_integers>::broadcast(-1))} << x;
    first |= std::uint64_t{1} << x;
  }
  std::uint64_t starts = (last << 1 | first) & ~nothing;
  const std::uint32_t* const place = p.place_at + y * tile_stride;
  if (std::popcount(starts) <= 3 * registers_across)
    for (; starts != 0; starts &= starts - 1) {
      const int x = std::countr_zero(starts);
      add_run(p, runs, y * tile_size + x / tile_lanes * tile_lanes, place[x]);
    }
  else
    collect_many(p, runs, y, starts);
  return tile_size - std::popcount(nothing);
}

// Then the triangles are shaded one after the other.

// Shades all runs of the k-th triangle that is seen.
template <class T, class Shading, class Colour, class Edge>
IRG_INLINE void shade_runs(const attribute_pass<T, Shading, Colour>& p, run_list& runs, std::uint32_t k,
                           const broadcast_attributes<Shading>& s, const Edge& edge) noexcept {
  const tile_integers place = lanes<tile_integers>::broadcast(static_cast<std::int32_t>(runs.place[k]));
  for (std::uint32_t i = p.last_run[runs.place[k]]; i != no_index;) {
    const pixel_run& run = runs.list[i];
    i = run.next;
    const int at = run.at(), y = run.row(), part = run.part();
    blend_values(p.of.shading, runs.words + at, places_at(p.place_at, at) == place,
                 attributes_at(s, edge(0, y, part), edge(1, y, part), edge(2, y, part)));
  }
}

// Integers of up to 2^24 in floats, as their products are.
template <class T, class Shading, class Colour>
IRG_INLINE void shade_small(const attribute_pass<T, Shading, Colour>& p, run_list& runs, std::uint32_t k,
                            const small_attributes<Shading>& of, std::size_t i) noexcept {
  using F = lanes<tile_floats>;
  tile_floats f[3], right[3], down[3], column[static_cast<unsigned>(registers_across)];
  for (int e = 0; e < 3; ++e) {
    f[e] = F::broadcast(of.f[e][i]);
    right[e] = F::broadcast(of.right[e][i]);
    down[e] = F::broadcast(of.down[e][i]);
  }
  for (int part = 0; part < registers_across; ++part)
    column[part] = F::ramp() + F::broadcast(static_cast<float>(part * tile_lanes));
  shade_runs(p, runs, k, in_every_lane(of, i),
             [&](int e, int y, int part) { return f[e] + down[e] * runs.row_number[y] + right[e] * column[part]; });
}

template <class T, class Shading, class Colour>
IRG_NOINLINE void shade_other(const attribute_pass<T, Shading, Colour>& p, run_list& runs, std::uint32_t k) {
  const triangle_attributes<Shading> t = prepare_triangle(p.of, runs.place[k]);
  const broadcast_attributes<Shading> s = in_every_lane(t);
  with_edges(t.s, t.narrow, p.of.window, [&](const auto& edge) { shade_runs(p, runs, k, s, edge); });
}

// Shades what is listed; N triangles are made ready at once.
template <class T, class Shading, class Colour>
IRG_INLINE void shade_listed(const attribute_pass<T, Shading, Colour>& p, run_list& runs) {
  for (int y = 0; y < tile_size; ++y) runs.row_number[y] = lanes<tile_floats>::broadcast(static_cast<float>(y));
  for (std::uint32_t first = 0; first < runs.triangles; first += tile_lanes) {
    const std::uint32_t used = minimum(runs.triangles - first, std::uint32_t{tile_lanes});
    tile_integers number;
    for (std::uint32_t i = 0; i < tile_lanes; ++i)
      set_lane(number, static_cast<int>(i),
               static_cast<std::int32_t>(p.of.numbers[runs.place[first + minimum(i, used - 1)]]));
    small_attributes<Shading> group;
    const bool all_small = prepare_small(p.of, group, number);
    for (std::uint32_t i = 0; i < used; ++i) {
      if (all_small)
        shade_small(p, runs, first + i, group, i);
      else
        shade_other(p, runs, first + i);
    }
  }
}

// The whole tile.

// With the colours of N pixels at once, which gather in the cache and leave for the picture at the end.
template <class T, class Shading, class Colour>
IRG_INLINE std::int64_t shade_in_lanes(attribute_pass<T, Shading, Colour>& p) {
  const cell_window& w = p.of.window;
  const int height = w.y_last - w.y_first;
  const auto bytes = static_cast<std::size_t>(w.x_last - w.x_first) * 4;
  const auto row_of = [&](int y) { return raster_traits<Colour>::row(p.colour, w.y_first + y) + w.x_first; };
  run_list runs;
  p.last_run.assign(p.of.numbers.size(), no_index);
  std::int64_t shaded = 0;
  for (int y = 0; y < height; ++y) {
    std::uint32_t* const row = runs.words + y * tile_stride;
    if (p.background != nullptr)
      fill_pixels(row, tile_stride, std::bit_cast<std::uint32_t>(*p.background));
    else
      std::memcpy(row, row_of(y), bytes);
    shaded += collect_row(p, runs, y);
  }
  shade_listed(p, runs);
  const row_store how = row_store_for(p.colour);
  for (int y = 0; y < height; ++y) copy_row(row_of(y), runs.words + y * tile_stride, bytes, how);
  end_of_rows(how);
  return shaded;
}

// Calls one(place) for each triangle that a register's pixels show.
template <class One>
IRG_INLINE void for_each_triangle(const tile_integers& places, unsigned shown, One&& one) {
  std::int32_t place[static_cast<unsigned>(tile_lanes)];
  lanes<tile_integers>::store(place, places);
  while (shown != 0) {
    const std::int32_t first = place[std::countr_zero(shown)];
    shown &= ~mask_bits(places == lanes<tile_integers>::broadcast(first));
    one(static_cast<std::uint32_t>(first));
  }
}

// Where colours are made one by one: those of the chosen pixels of a register.
template <class Shading, class P>
IRG_INLINE void shade_chosen(const Shading& shading, P* to, unsigned chosen, const attribute_values<Shading>& v) {
  for (; chosen != 0; chosen &= chosen - 1) {
    const int i = std::countr_zero(chosen);
    std::array<float, attribute_count_of<Shading>> one;
    for (std::size_t j = 0; j < one.size(); ++j) one[j] = lane(v[j], i);
    to[i] = shading.pixel(one);
  }
}
template <class T, class Shading, class Colour>
IRG_INLINE std::int64_t shade_one_by_one(const attribute_pass<T, Shading, Colour>& p) {
  using J = lanes<tile_integers>;
  std::vector<std::uint32_t> kept_at(p.of.numbers.size(), 0u);  // by place: where in `kept`, counted from 1
  std::vector<triangle_attributes<Shading>> kept;
  const cell_window& w = p.of.window;
  std::int64_t shaded = 0;
  for (int y = 0; y < w.y_last - w.y_first; ++y)
    for (int part = 0; part < registers_across; ++part) {
      const tile_integers places = places_at(p.place_at, y * tile_stride + part * tile_lanes);
      auto* const to = raster_traits<Colour>::row(p.colour, w.y_first + y) + w.x_first + part * tile_lanes;
      const unsigned shown = ~mask_bits(places == J::broadcast(-1)) & whole_register;
      shaded += std::popcount(shown);
      for_each_triangle(places, shown, [&](std::uint32_t place) {
        if (kept_at[place] == 0) {
          kept.push_back(prepare_triangle(p.of, place));
          kept_at[place] = static_cast<std::uint32_t>(kept.size());
        }
        const triangle_attributes<Shading>& t = kept[kept_at[place] - 1];
        attribute_values<Shading> v;
        with_edges(t.s, t.narrow, w, [&](const auto& edge) {
          v = attributes_at(in_every_lane(t), edge(0, y, part), edge(1, y, part), edge(2, y, part));
        });
        shade_chosen(p.of.shading, to, mask_bits(places == J::broadcast(static_cast<std::int32_t>(place))), v);
      });
    }
  return shaded;
}

// Returns the number of pixels that show a triangle.
template <class T, class Shading, class Colour>
IRG_NOINLINE std::int64_t shade_by_attributes(attribute_pass<T, Shading, Colour>& p) {
  if constexpr (LaneAttributeShading<Shading, tile_lanes> && sizeof(pixel_of<Colour>) == 4) {
    return shade_in_lanes(p);
  } else {
    const cell_window& w = p.of.window;
    if (p.background != nullptr)
      for (int y = w.y_first; y < w.y_last; ++y) fill_span(p.colour, {y, w.x_first, w.x_last}, *p.background);
    return shade_one_by_one(p);
  }
}

}  // namespace irg::detail::inline IRG_ABI
