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
#include <irg/render/detail/shade/tile_shading.hpp>
#include <irg/render/detail/visible/streamed_rows.hpp>

namespace irg::detail::inline IRG_ABI {

// What the pixels of a triangle share when they are coloured by attributes: made ready for one triangle, for N small
// ones at once, or for N pixels each of a triangle of its own. The numbers are the same in all three ways.

template <class Shading, int N>
concept LaneAttributeShading = requires(
    const Shading& s, const std::array<pack<float, N>, static_cast<std::size_t>(Shading::attribute_count)>& v) {
  { s.pixels(v) } -> std::same_as<pack<std::uint32_t, N>>;
};

// N small triangles of one batch, a lane each: differences of 32 bits suffice for their edges.
template <class T, int N>
struct small_lanes {
  using integers = pack<std::int32_t, N>;
  using floats = pack<float, N>;

  corner_lanes<N> c;
  const triangle_batch<T>* batch;
  integers double_area;

  // gives   false when they are not all small, or of several batches, or pieces
  IRG_INLINE bool collect(const triangle_finder<T>& find, const integers& number) noexcept {
    batch = c.collect(find, number);
    if (batch == nullptr) return false;
    const triangle_boxes<N> boxes(c.x, c.y);
    if (mask_bits(boxes.narrow) != (1u << N) - 1) return false;
    double_area = boxes.double_area;
    return true;
  }

  // Calls each(j, a, b, c) with attribute j at the three vertices.
  template <class Shading, class Each>
  IRG_INLINE void for_each_attribute(const Shading& shading, const integers& flip, const Each& each) const noexcept {
    const unsigned flipped = mask_bits(flip);
    const float* const front = shading.attributes(*batch, 0, flipped != 0 ? facing::front : facing::back);
    const float* const back = shading.attributes(*batch, 0, flipped != (1u << N) - 1 ? facing::back : facing::front);
    for (int j = 0; j < Shading::attribute_count; ++j) {
      floats at[3];
      for (int k = 0; k < 3; ++k) {
        const integers word = c.vertex[k] * Shading::attribute_count + j;
        at[k] = gather<float>(front, word);
        if (front != back) at[k] = select(flip, at[k], gather<float>(back, word));
      }
      each(static_cast<std::size_t>(j), at[0], at[1], at[2]);
    }
  }
};

template <class T, class Shading>
struct attribute_setup {
  static constexpr int lane_count = tile_lanes;
  static constexpr std::size_t value_count = static_cast<std::size_t>(Shading::attribute_count);
  using floats = pack<float, lane_count>;
  using integers = pack<std::int32_t, lane_count>;
  using values = std::array<floats, value_count>;
  using J = lanes<integers>;
  using F = lanes<floats>;

  triangle_finder<T> find;
  std::span<const std::uint32_t> numbers;  // the tile's list
  cell_window window;
  const Shading& shading;

  // What the pixels of one triangle share.
  struct uniform {
    std::uint32_t place;
    triangle_setup s;
    bool narrow;  // F fits 32 bits all over the tile
    const piece_weights* piece;
    float at0[value_count], change1[value_count],
        change2[value_count];  // of the attributes, from the first vertex to the others
  };

  IRG_NOINLINE uniform prepare(std::uint32_t place) const {
    const std::uint32_t number = numbers[place];
    const cell_window whole{window.x_first, window.y_first, window.x_first + tile_size, window.y_first + tile_size};
    const triangle_corners c = find.corners(number);
    const triangle_coverage coverage = cover_triangle(c.v[0]->position, c.v[1]->position, c.v[2]->position);
    const std::uint32_t source = find.source(number);
    const triangle_batch<T>& batch = find.batch_of(source);
    const auto of =
        pixel_shader_of(shading, batch, source - batch.first_number, coverage.flipped ? facing::front : facing::back);
    uniform u{place,
              set_up_triangle(coverage, *c.v[0], *c.v[1], *c.v[2]),
              fits_32_bits(coverage, whole, block_size),
              find.is_piece(number) ? &find.piece(number).weights : nullptr,
              {},
              {},
              {}};
    for (std::size_t j = 0; j < value_count; ++j) {
      u.at0[j] = of.a[j];
      u.change1[j] = of.b[j] - of.a[j];
      u.change2[j] = of.c[j] - of.a[j];
    }
    return u;
  }

  // Small triangles that are seen, a lane each. F is at most 2^24 all over the tile, so floats hold it.
  struct small_triangles {
    float f[3][lane_count], right[3][lane_count], down[3][lane_count];  // F at the tile's first pixel, and its steps
    float scale[lane_count], rest[3][lane_count], inverse_w[3][lane_count];
    float at0[value_count][lane_count], change1[value_count][lane_count], change2[value_count][lane_count];
  };

  // Makes N triangles ready at once.
  // gives   false when they are not all small triangles of one batch
  IRG_NOINLINE bool prepare_small(small_triangles& out, const integers& number) const noexcept {
    small_lanes<T, lane_count> s;
    if (!s.collect(find, number)) return false;
    const edge_lanes<lane_count> edges(s.c.x, s.c.y, s.double_area);
    // F at the first pixel of the box, where nothing overflows, and from there at the tile's first.
    const auto first_of = [](const integers(&v)[3], int least, int most) {
      const integers low = low_of(low_of(v[0], v[1]), v[2]);
      return low_of(high_of(low >> subpixel_bits, J::broadcast(least)), J::broadcast(most));
    };
    const integers column = first_of(s.c.x, window.x_first, window.x_last),
                   row = first_of(s.c.y, window.y_first, window.y_last);
    F::store(out.scale, edges.scale);
    for (int k = 0; k < 3; ++k) {
      const auto [f, rest] = edges(k, column, row);
      F::store(out.f[k], to_float(f + edges.dy[k] * (column - J::broadcast(window.x_first)) -
                                  edges.dx[k] * (row - J::broadcast(window.y_first))));
      F::store(out.right[k], to_float(J::broadcast(0) - edges.dy[k]));
      F::store(out.down[k], to_float(edges.dx[k]));
      F::store(out.rest[k], rest);
      F::store(out.inverse_w[k], s.c.inverse_w[k]);
    }
    s.for_each_attribute(shading, edges.flip, [&](std::size_t j, const floats& a, const floats& b, const floats& c) {
      F::store(out.at0[j], a);
      F::store(out.change1[j], b - a);
      F::store(out.change2[j], c - a);
    });
    return true;
  }

  // The attributes of N pixels in a row, each of a triangle of its own.
  // shape   `ids` has -1 for a pixel without one; `shown` a bit for each of the others
  // gives   false when they are not all small triangles of one batch
  IRG_INLINE bool of_many(const integers& ids, unsigned shown, int x_first, int y, values& out) const noexcept {
    // A pixel that shows nothing takes another's triangle, which it may be far from: any finite number will do there.
    const integers some = J::broadcast(ids[std::countr_zero(shown)]);
    small_lanes<T, lane_count> s;
    if (!s.collect(find, gather<std::int32_t>(numbers.data(), select(ids == J::broadcast(-1), some, ids))))
      return false;
    const edge_lanes<lane_count> edges(s.c.x, s.c.y, s.double_area);
    const integers column = J::ramp() + J::broadcast(x_first), row = J::broadcast(y);
    floats b[3];
    for (int k = 0; k < 3; ++k) {
      const auto [f, rest] = edges(k, column, row);
      b[k] = to_float(f) * edges.scale + rest;
    }
    const auto& w = s.c.inverse_w;
    const floats b1 = b[1] * w[1], b2 = b[2] * w[2];
    const floats inverse = F::broadcast(1) / (b[0] * w[0] + (b1 + b2));
    const floats weight1 = b1 * inverse, weight2 = b2 * inverse;
    s.for_each_attribute(shading, edges.flip,
                         [&](std::size_t j, const floats& at0, const floats& at1, const floats& at2) {
                           out[j] = at0 + (weight1 * (at1 - at0) + weight2 * (at2 - at0));
                         });
    return true;
  }
};

template <class T, class Shading, class Colour>
struct attribute_kernel {
  using setup = attribute_setup<T, Shading>;
  using uniform = typename setup::uniform;
  using small_triangles = typename setup::small_triangles;
  using floats = typename setup::floats;
  using integers = typename setup::integers;
  using values = typename setup::values;
  using pixel = pixel_of<Colour>;
  static constexpr int lane_count = setup::lane_count;
  static constexpr unsigned everyone = (1u << lane_count) - 1;
  static constexpr std::uint32_t none = no_index;

  const std::uint32_t* place_at;  // what each pixel shows: its place in the list
  setup set_up;
  Colour& colour;
  const pixel* background;  // for pixels without a triangle; null when they keep what is there
  std::vector<std::uint32_t> last_job{};  // by place: in job_list

  // What the N pixels from a place in the tile on show.
  IRG_INLINE integers ids_at(int at) const noexcept { return lanes<integers>::load_bytes(place_at + at); }

  // The registers of a tile's row.
  static constexpr int parts = tile_size / lane_count;

  // A run of pixels of one triangle within a register, and the next run of that triangle.
  struct job {
    std::uint32_t first;  // the register's first pixel, counted through the tile
    std::uint32_t next;
    IRG_INLINE int row() const noexcept { return static_cast<int>(first / tile_size); }
    IRG_INLINE int part() const noexcept { return static_cast<int>(first % tile_size / lane_count); }
    IRG_INLINE int at() const noexcept { return static_cast<int>(first) + row() * (tile_stride - tile_size); }
  };
  // The triangles that are seen, in the order in which they were met.
  struct job_list {
    std::uint32_t count = 0, triangles = 0;
    job list[tile_size * tile_size];
    std::uint32_t place[tile_size * tile_size];
    alignas(64) std::uint32_t words[static_cast<unsigned>(tile_size * tile_stride)];  // the colours
  };

  IRG_INLINE void add_job(job_list& jobs, int first, std::uint32_t place) noexcept {
    const std::uint32_t next = last_job[place];
    if (next == none) jobs.place[jobs.triangles++] = place;
    jobs.list[jobs.count] = {static_cast<std::uint32_t>(first), next};
    last_job[place] = jobs.count++;
  }

  // What the pixels of one triangle share, in every lane.
  struct shared {
    floats scale, rest[3], inverse_w[3];
    values at0, change1, change2;
    const piece_weights* piece;

    IRG_INLINE values attributes(const floats& f0, const floats& f1, const floats& f2) const noexcept {
      const floats b0 = f0 * scale + rest[0], b1 = f1 * scale + rest[1], b2 = f2 * scale + rest[2];
      const floats w1 = b1 * inverse_w[1], w2 = b2 * inverse_w[2];
      const floats inverse = lanes<floats>::broadcast(1) / (b0 * inverse_w[0] + (w1 + w2));
      pixel_weights<floats> at{w1 * inverse, w2 * inverse, lanes<floats>::broadcast(0)};
      if (piece != nullptr) at = in_source(at, *piece);
      values v;
      for (std::size_t j = 0; j < v.size(); ++j) v[j] = at0[j] + (at.weight1 * change1[j] + at.weight2 * change2[j]);
      return v;
    }
  };
  IRG_INLINE static shared share(const uniform& u) noexcept {
    using F = lanes<floats>;
    shared s;
    s.scale = F::broadcast(u.s.scale);
    s.piece = u.piece;
    for (int e = 0; e < 3; ++e) {
      s.rest[e] = F::broadcast(u.s.rest[e]);
      s.inverse_w[e] = F::broadcast(u.s.inverse_w[e]);
    }
    for (std::size_t j = 0; j < s.at0.size(); ++j) {
      s.at0[j] = F::broadcast(u.at0[j]);
      s.change1[j] = F::broadcast(u.change1[j]);
      s.change2[j] = F::broadcast(u.change2[j]);
    }
    return s;
  }
  IRG_INLINE static shared share(const small_triangles& of, std::size_t i) noexcept {
    using F = lanes<floats>;
    shared s;
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

  // Calls f(edge function by number) for the registers of a triangle that is not small, or a piece of one:
  // edge(e, y, part) is an edge function at the register `part` of row y.
  template <class With>
  IRG_INLINE void with_edges(const uniform& u, const With& with) const noexcept {
    const cell_window& window = set_up.window;
    if (u.narrow) {
      integers ramp[3];
      std::int32_t right[3], down[3];
      for (int e = 0; e < 3; ++e) {
        right[e] = static_cast<std::int32_t>(u.s.edge[e].right);
        down[e] = static_cast<std::int32_t>(u.s.edge[e].down);
        const auto origin = static_cast<std::int32_t>(u.s.edge[e](window.x_first, window.y_first));
        ramp[e] = lanes<integers>::broadcast(origin) + lanes<integers>::broadcast(right[e]) * lanes<integers>::ramp();
      }
      with([&](int e, int y, int part) {
        return to_float(ramp[e] + lanes<integers>::broadcast(right[e] * (part * lane_count) + down[e] * y));
      });
    } else {
      with([&](int e, int y, int part) {
        using wide = lanes<wide_pack<lane_count>>;
        const triangle_edge& edge = u.s.edge[e];
        const std::int64_t first = edge(window.x_first + part * lane_count, window.y_first + y);
        return to_float(wide::broadcast(static_cast<double>(first)) +
                        wide::broadcast(static_cast<double>(edge.right)) * wide::ramp());
      });
    }
  }

  // Shades all runs of the k-th triangle that is seen.
  template <class Edge>
  IRG_INLINE void shade_runs(job_list& jobs, std::uint32_t k, const shared& s, const Edge& edge) const noexcept {
    const integers id = lanes<integers>::broadcast(static_cast<std::int32_t>(jobs.place[k]));
    for (std::uint32_t i = last_job[jobs.place[k]]; i != none;) {
      const job& run = jobs.list[i];
      i = run.next;
      const int at = run.at(), y = run.row(), part = run.part();
      blend(jobs.words + at, ids_at(at) == id, s.attributes(edge(0, y, part), edge(1, y, part), edge(2, y, part)));
    }
  }
  IRG_INLINE void blend(std::uint32_t* to, const integers& where, const values& v) const noexcept {
    using words = pack<std::uint32_t, lane_count>;
    lanes<words>::store(to, select(where, set_up.shading.pixels(v), lanes<words>::load(to)));
  }

  // Integers of up to 2^24 in floats, as their products are.
  IRG_INLINE void shade_small(job_list& jobs, std::uint32_t k, const small_triangles& of, std::size_t i,
                              const floats (&row)[tile_size]) const noexcept {
    using F = lanes<floats>;
    floats f[3], right[3], down[3], column[static_cast<unsigned>(parts)];
    for (int e = 0; e < 3; ++e) {
      f[e] = F::broadcast(of.f[e][i]);
      right[e] = F::broadcast(of.right[e][i]);
      down[e] = F::broadcast(of.down[e][i]);
    }
    for (int part = 0; part < parts; ++part)
      column[part] = F::ramp() + F::broadcast(static_cast<float>(part * lane_count));
    shade_runs(jobs, k, share(of, i),
               [&](int e, int y, int part) { return f[e] + down[e] * row[y] + right[e] * column[part]; });
  }
  IRG_NOINLINE void shade_other(job_list& jobs, std::uint32_t k) const {
    const uniform u = set_up.prepare(jobs.place[k]);
    const shared s = share(u);
    with_edges(u, [&](const auto& edge) { shade_runs(jobs, k, s, edge); });
  }

  // Shades what is listed, triangle by triangle; N of them are made ready at once.
  IRG_INLINE void shade_jobs(job_list& jobs) const {
    floats row[tile_size];
    for (int y = 0; y < tile_size; ++y) row[y] = lanes<floats>::broadcast(static_cast<float>(y));
    for (std::uint32_t first = 0; first < jobs.triangles; first += lane_count) {
      const std::uint32_t used = lesser(jobs.triangles - first, std::uint32_t{lane_count});
      integers number;
      for (std::uint32_t i = 0; i < lane_count; ++i)
        set_lane(number, static_cast<int>(i),
                 static_cast<std::int32_t>(set_up.numbers[jobs.place[first + lesser(i, used - 1)]]));
      small_triangles group;
      const bool all_small = set_up.prepare_small(group, number);
      for (std::uint32_t i = 0; i < used; ++i) {
        if (all_small)
          shade_small(jobs, first + i, group, i, row);
        else
          shade_other(jobs, first + i);
      }
    }
  }

  // Lists the runs of a row.
  // gives   the number of pixels that show a triangle
  IRG_INLINE int collect_row(job_list& jobs, int y) {
    // A bit for each pixel that shows another triangle than the next, that shows nothing, that starts a register.
    std::uint64_t last = 0, nothing = 0, first = 0;
    for (int part = 0; part < parts; ++part) {
      const int at = y * tile_stride + part * lane_count, x = part * lane_count;
      const integers ids = ids_at(at);
      last |= std::uint64_t{~mask_bits(ids == ids_at(at + 1)) & everyone} << x;
      nothing |= std::uint64_t{mask_bits(ids == lanes<integers>::broadcast(-1))} << x;
      first |= std::uint64_t{1} << x;
    }
    std::uint64_t starts = (last << 1 | first) & ~nothing;
    const std::uint32_t* const id = place_at + y * tile_stride;
    if (std::popcount(starts) <= 3 * parts)
      for (; starts != 0; starts &= starts - 1) {
        const int x = std::countr_zero(starts);
        add_job(jobs, y * tile_size + x / lane_count * lane_count, id[x]);
      }
    else
      collect_many(jobs, y, starts);
    return tile_size - std::popcount(nothing);
  }

  // A row of small triangles: three and more in a register are shaded now, each pixel for itself, unless they are
  // listed already.
  IRG_NOINLINE void collect_many(job_list& jobs, int y, std::uint64_t starts) {
    for (int x = 0; x < tile_size; x += lane_count, starts >>= lane_count - 1, starts >>= 1) {
      unsigned runs = static_cast<unsigned>(starts) & everyone;
      const int at = y * tile_stride + x;
      if (std::popcount(runs) > 2) {
        const integers ids = ids_at(at), nothing = ids == lanes<integers>::broadcast(-1);
        const integers some = lanes<integers>::broadcast(ids[std::countr_zero(runs)]);
        const integers met = gather<std::int32_t>(last_job.data(), select(nothing, some, ids));
        values v;
        if (mask_bits(met == lanes<integers>::broadcast(-1)) != 0 &&
            set_up.of_many(ids, ~mask_bits(nothing) & everyone, set_up.window.x_first + x, set_up.window.y_first + y,
                           v)) {
          blend(jobs.words + at, ~nothing, v);
          continue;
        }
      }
      for (; runs != 0; runs &= runs - 1) add_job(jobs, y * tile_size + x, place_at[at + std::countr_zero(runs)]);
    }
  }

  // The whole tile, with the colours of N pixels at once. First it is found out where each triangle is seen; then the
  // triangles are shaded one after the other. Colours gather in the cache and leave for the picture at the end.
  IRG_INLINE std::int64_t shade_in_lanes() {
    const int width = set_up.window.x_last - set_up.window.x_first,
              height = set_up.window.y_last - set_up.window.y_first;
    job_list jobs;
    last_job.assign(set_up.numbers.size(), none);
    std::int64_t shaded = 0;
    for (int y = 0; y < height; ++y) {
      std::uint32_t* const row = jobs.words + y * tile_stride;
      if (background != nullptr)
        fill_pixels(row, tile_stride, std::bit_cast<std::uint32_t>(*background));
      else
        std::memcpy(row, raster_traits<Colour>::row(colour, set_up.window.y_first + y) + set_up.window.x_first,
                    static_cast<std::size_t>(width) * 4);
      shaded += collect_row(jobs, y);
    }
    shade_jobs(jobs);
    const row_store how = row_store_for(colour);
    for (int y = 0; y < height; ++y)
      copy_row(raster_traits<Colour>::row(colour, set_up.window.y_first + y) + set_up.window.x_first,
               jobs.words + y * tile_stride, static_cast<std::size_t>(width) * 4, how);
    end_of_rows(how);
    return shaded;
  }

  // Calls one(id) for each triangle that a register's pixels show.
  template <class One>
  IRG_INLINE static void for_each_triangle(const integers& ids, unsigned shown, One&& one) {
    std::int32_t id[static_cast<unsigned>(lane_count)];
    lanes<integers>::store(id, ids);
    while (shown != 0) {
      const std::int32_t first = id[std::countr_zero(shown)];
      shown &= ~mask_bits(ids == lanes<integers>::broadcast(first));
      one(static_cast<std::uint32_t>(first));
    }
  }

  // The whole tile, where colours are made one by one.
  IRG_INLINE std::int64_t shade_one_by_one() {
    std::vector<std::uint32_t> kept_at(set_up.numbers.size(), 0u);  // by place: where in `kept`, counted from 1
    std::vector<uniform> kept;
    const cell_window& window = set_up.window;
    std::int64_t shaded = 0;
    for (int y = 0; y < window.y_last - window.y_first; ++y)
      for (int part = 0; part < parts; ++part) {
        const int at = y * tile_stride + part * lane_count;
        const integers ids = ids_at(at);
        pixel* const to = raster_traits<Colour>::row(colour, window.y_first + y) + window.x_first + part * lane_count;
        const unsigned shown = ~mask_bits(ids == lanes<integers>::broadcast(-1)) & everyone;
        shaded += std::popcount(shown);
        for_each_triangle(ids, shown, [&](std::uint32_t place) {
          if (kept_at[place] == 0) {
            kept.push_back(set_up.prepare(place));
            kept_at[place] = static_cast<std::uint32_t>(kept.size());
          }
          const uniform& u = kept[kept_at[place] - 1];
          values v;
          with_edges(u, [&](const auto& edge) {
            v = share(u).attributes(edge(0, y, part), edge(1, y, part), edge(2, y, part));
          });
          unsigned bits = mask_bits(ids == lanes<integers>::broadcast(static_cast<std::int32_t>(place)));
          for (; bits != 0; bits &= bits - 1) {
            std::array<float, std::tuple_size_v<values>> one;
            for (std::size_t j = 0; j < one.size(); ++j) one[j] = lane(v[j], std::countr_zero(bits));
            to[std::countr_zero(bits)] = set_up.shading.pixel(one);
          }
        });
      }
    return shaded;
  }

  // The whole tile; returns the number of pixels that show a triangle.
  std::int64_t operator()() {
    if constexpr (LaneAttributeShading<Shading, lane_count> && sizeof(pixel) == 4) {
      return shade_in_lanes();
    } else {
      if (background != nullptr)
        for (int y = set_up.window.y_first; y < set_up.window.y_last; ++y)
          fill_span(colour, {y, set_up.window.x_first, set_up.window.x_last}, *background);
      return shade_one_by_one();
    }
  }
};

}  // namespace irg::detail::inline IRG_ABI
