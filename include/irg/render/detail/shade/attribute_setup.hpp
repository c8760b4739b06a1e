// SPDX-License-Identifier: MIT
// What the pixels of a triangle share when they are coloured by attributes: made ready for one triangle, for N small
// ones at once, or for N pixels each of a triangle of its own. The numbers are the same in all three ways.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include <irg/render/attribute_shading.hpp>
#include <irg/render/detail/shade/tile_shading.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

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
  using J = lanes<integers>;
  using F = lanes<floats>;

  corner_lanes<N> c;
  const triangle_batch<T>* batch;
  integers flip, dx[3], dy[3];
  floats scale, unit;

  // gives   false when they are not all small, or of several batches, or pieces
  IRG_INLINE bool collect(const triangle_finder<T>& find, const integers& number) noexcept {
    batch = c.collect(find, number);
    if (batch == nullptr) return false;
    const integers width = high_of(high_of(c.x[0], c.x[1]), c.x[2]) - low_of(low_of(c.x[0], c.x[1]), c.x[2]);
    const integers height = high_of(high_of(c.y[0], c.y[1]), c.y[2]) - low_of(low_of(c.y[0], c.y[1]), c.y[2]);
    const integers limit = J::broadcast(1 << 15);
    if (mask_bits(both(width < limit, height < limit)) != (1u << N) - 1) return false;
    const integers area = (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.y[1] - c.y[0]) * (c.x[2] - c.x[0]);
    flip = area < J::broadcast(0);
    const auto turned = [&](const integers& v) { return (v ^ flip) - flip; };
    scale = F::broadcast(one_pixel) / to_float(turned(area));
    unit = scale * F::broadcast(1.0f / one_pixel);
    for (int k = 0; k < 3; ++k) {
      const int p = (k + 1) % 3, q = (k + 2) % 3;
      dx[k] = turned(c.x[q] - c.x[p]);
      dy[k] = turned(c.y[q] - c.y[p]);
    }
    return true;
  }

  // Edge function k at a pixel near the triangle, and what it leaves of the exact one, as a weight.
  struct edge_at {
    integers f;
    floats rest;
  };
  IRG_INLINE edge_at edge(int k, const integers& column, const integers& row) const noexcept {
    const int p = (k + 1) % 3;
    const integers zero = J::broadcast(0), pixel = J::broadcast(one_pixel), half = J::broadcast(half_pixel);
    const integers e = dx[k] * (row * pixel + half - c.y[p]) - dy[k] * (column * pixel + half - c.x[p]);
    const integers owns = (dy[k] < zero) | both(dy[k] == zero, zero < dx[k]);
    const integers f = ((e - J::broadcast(1)) - owns) >> subpixel_bits;
    return {f, to_float(e - f * pixel) * unit};
  }

  // Calls each(j, a, b, c) with attribute j at the three vertices.
  template <class Shading, class Each>
  IRG_INLINE void for_each_attribute(const Shading& shading, const Each& each) const noexcept {
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
    // F at the first pixel of the box, where nothing overflows, and from there at the tile's first.
    const auto first_of = [](const integers(&v)[3], int least, int most) {
      const integers low = low_of(low_of(v[0], v[1]), v[2]);
      return low_of(high_of(low >> subpixel_bits, J::broadcast(least)), J::broadcast(most));
    };
    const integers column = first_of(s.c.x, window.x_first, window.x_last),
                   row = first_of(s.c.y, window.y_first, window.y_last);
    F::store(out.scale, s.scale);
    for (int k = 0; k < 3; ++k) {
      const auto [f, rest] = s.edge(k, column, row);
      F::store(out.f[k], to_float(f + s.dy[k] * (column - J::broadcast(window.x_first)) -
                                  s.dx[k] * (row - J::broadcast(window.y_first))));
      F::store(out.right[k], to_float(J::broadcast(0) - s.dy[k]));
      F::store(out.down[k], to_float(s.dx[k]));
      F::store(out.rest[k], rest);
      F::store(out.inverse_w[k], s.c.inverse_w[k]);
    }
    s.for_each_attribute(shading, [&](std::size_t j, const floats& a, const floats& b, const floats& c) {
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
    const integers column = J::ramp() + J::broadcast(x_first), row = J::broadcast(y);
    floats b[3];
    for (int k = 0; k < 3; ++k) {
      const auto [f, rest] = s.edge(k, column, row);
      b[k] = to_float(f) * s.scale + rest;
    }
    const auto& w = s.c.inverse_w;
    const floats b1 = b[1] * w[1], b2 = b[2] * w[2];
    const floats inverse = F::broadcast(1) / (b[0] * w[0] + (b1 + b2));
    const floats weight1 = b1 * inverse, weight2 = b2 * inverse;
    s.for_each_attribute(shading, [&](std::size_t j, const floats& at0, const floats& at1, const floats& at2) {
      out[j] = at0 + (weight1 * (at1 - at0) + weight2 * (at2 - at0));
    });
    return true;
  }
};

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
