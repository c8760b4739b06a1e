// SPDX-License-Identifier: MIT
// A finished tile turned into colours by attributes: N pixels at once, be they of one triangle or of N.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include <irg/render/attribute_shading.hpp>
#include <irg/render/detail/tile_shading.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

#ifdef IRG_LANES_VECTOR

template <class Shading, int N>
concept LaneAttributeShading = requires(
    const Shading& s, const std::array<pack<float, N>, static_cast<std::size_t>(Shading::attribute_count)>& v) {
  { s.pixels(v) } -> std::same_as<pack<std::uint32_t, N>>;
};

template <class T, class Shading, class Colour>
struct attribute_kernel {
  static constexpr int lane_count = tile_lanes;
  static constexpr unsigned everyone = (1u << lane_count) - 1;
  static constexpr std::size_t value_count = static_cast<std::size_t>(Shading::attribute_count);
  using floats = pack<float, lane_count>;
  using integers = pack<std::int32_t, lane_count>;
  using values = std::array<floats, value_count>;
  using pixel = pixel_of<Colour>;

  const tile& t;
  triangle_finder<T> find;
  std::span<const std::uint32_t> numbers;  // the tile's list
  cell_window window;
  Colour& colour;
  const Shading& shading;
  const pixel* background;  // for pixels without a triangle; null when they keep what is there

  // What the pixels of one triangle share.
  struct uniform {
    std::uint32_t place;
    triangle_setup s;
    bool narrow;  // F fits 32 bits all over the tile
    std::int32_t origin[3];  // if so: F at the tile's first pixel
    const piece_weights* piece;
    float at0[value_count], change1[value_count],
        change2[value_count];  // of the attributes, from the first vertex to the others
  };
  std::vector<std::uint32_t> kept_at{};  // by place: where in `kept`, counted from 1
  std::vector<uniform> kept{};

  // Each triangle that is still seen is made ready once.
  IRG_NOINLINE void prepare(std::uint32_t place) {
    const std::uint32_t number = numbers[place];
    const cell_window whole{window.x_first, window.y_first, window.x_first + tile_size, window.y_first + tile_size};
    const triangle_corners c = find.corners(number);
    const triangle_coverage coverage = cover_triangle(c.v[0]->position, c.v[1]->position, c.v[2]->position);
    const std::uint32_t source = find.source(number);
    const triangle_batch<T>& batch = find.batch_of(source);
    const auto of =
        pixel_shader_of(shading, batch, source - batch.first_number, coverage.flipped ? facing::front : facing::back);
    kept.push_back({place,
                    set_up(coverage, *c.v[0], *c.v[1], *c.v[2]),
                    fits_32_bits(coverage, whole, block_size),
                    {},
                    find.is_piece(number) ? &find.piece(number).weights : nullptr,
                    {},
                    {},
                    {}});
    uniform& u = kept.back();
    for (int i = 0; i < 3 && u.narrow; ++i)
      u.origin[i] = static_cast<std::int32_t>(u.s.edge[i](window.x_first, window.y_first));
    for (std::size_t j = 0; j < value_count; ++j) {
      u.at0[j] = of.a[j];
      u.change1[j] = of.b[j] - of.a[j];
      u.change2[j] = of.c[j] - of.a[j];
    }
    kept_at[place] = static_cast<std::uint32_t>(kept.size());
  }

  // The attributes of N pixels in a row that show one triangle: fragment::interpolate with the differences kept.
  IRG_INLINE static values of_one(const uniform& u, fragment<floats> at) noexcept {
    using F = lanes<floats>;
    if (u.piece != nullptr) at = in_source(at, *u.piece);
    values v;
    for (std::size_t j = 0; j < value_count; ++j)
      v[j] =
          F::broadcast(u.at0[j]) + (at.weight1 * F::broadcast(u.change1[j]) + at.weight2 * F::broadcast(u.change2[j]));
    return v;
  }

  // What the N pixels from a place in the tile on show.
  IRG_INLINE integers ids_at(int at) const noexcept {
    integers ids;
    std::memcpy(&ids.v, t.id + at, sizeof ids.v);
    return ids;
  }

  // The attributes of N pixels in a row, each of a triangle of its own; `shown` has a bit for each pixel with one.
  // gives   false when they are not all small triangles of one batch
  IRG_INLINE bool of_many(const integers& ids, unsigned shown, int x_first, int y, values& out) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    const integers some = I::broadcast(ids.v[std::countr_zero(shown)]);
    const integers number = gather<std::int32_t>(numbers.data(), select(ids == I::broadcast(-1), some, ids));
    corner_lanes<lane_count> c;
    const triangle_batch<T>* const batch = c.collect(find, number);
    if (batch == nullptr) return false;
    const auto &x = c.x, &y_of = c.y;
    const auto& inverse_w = c.inverse_w;
    const integers left = low_of(low_of(x[0], x[1]), x[2]), right = high_of(high_of(x[0], x[1]), x[2]);
    const integers top = low_of(low_of(y_of[0], y_of[1]), y_of[2]),
                   bottom = high_of(high_of(y_of[0], y_of[1]), y_of[2]);
    const integers limit = I::broadcast(1 << 15), zero = I::broadcast(0), one = I::broadcast(1);
    if (mask_bits(both(right - left < limit, bottom - top < limit)) != everyone) return false;

    const integers area = (x[1] - x[0]) * (y_of[2] - y_of[0]) - (y_of[1] - y_of[0]) * (x[2] - x[0]);
    const integers flip = area < zero;
    const auto turned = [&](const integers& v) { return integers{(v.v ^ flip.v) - flip.v}; };
    const floats scale = F::broadcast(one_pixel) / to_float(turned(area)),
                 unit = scale * F::broadcast(1.0f / one_pixel);
    // A pixel that shows nothing takes another's triangle, which it may be far from: any finite number will do there.
    const integers centre_x = (I::ramp() + I::broadcast(x_first)) * I::broadcast(one_pixel) + I::broadcast(half_pixel),
                   centre_y = I::broadcast(y * one_pixel + half_pixel);
    floats b[3];
    for (int k = 0; k < 3; ++k) {
      const int p = (k + 1) % 3, q = (k + 2) % 3;
      const integers dx = turned(x[q] - x[p]), dy = turned(y_of[q] - y_of[p]);
      const integers e = dx * (centre_y - y_of[p]) - dy * (centre_x - x[p]);
      const integers owns = (dy < zero) | both(dy == zero, zero < dx);
      const integers f{((e - one) - owns).v >> subpixel_bits};
      b[k] = to_float(f) * scale + to_float(e - f * I::broadcast(one_pixel)) * unit;
    }
    const floats inverse = F::broadcast(1) / (b[0] * inverse_w[0] + (b[1] * inverse_w[1] + b[2] * inverse_w[2]));
    const floats w1 = (b[1] * inverse_w[1]) * inverse, w2 = (b[2] * inverse_w[2]) * inverse;
    const unsigned flipped = mask_bits(flip);
    const float* const front = shading.attributes(*batch, 0, flipped != 0 ? facing::front : facing::back);
    const float* const back = shading.attributes(*batch, 0, flipped != everyone ? facing::back : facing::front);
    for (std::size_t j = 0; j < value_count; ++j) {
      floats at[3];
      for (int k = 0; k < 3; ++k) {
        const integers word{c.vertex[k].v * Shading::attribute_count + static_cast<int>(j)};
        at[k] = gather<float>(front, word);
        if (front != back) at[k] = select(flip, at[k], gather<float>(back, word));
      }
      out[j] = at[0] + (w1 * (at[1] - at[0]) + w2 * (at[2] - at[0]));
    }
    return true;
  }

  // The attributes of N pixels that show one triangle, from the place of the first of them in the tile.
  IRG_INLINE values of_one(const uniform& u, int at) const noexcept {
    using I = lanes<integers>;
    const int x = at % tile_stride, y = at / tile_stride;
    fragment<floats> where;
    if (u.narrow) [[likely]] {
      floats b[3];
      for (int i = 0; i < 3; ++i)
        b[i] = u.s.template weight<floats>(
            i, integers{I::broadcast(u.origin[i] + u.s.edge[i].right * x + u.s.edge[i].down * y).v +
                        I::broadcast(u.s.edge[i].right).v * I::ramp().v});
      where = perspective_weights(u.s, b[0], b[1], b[2], lanes<floats>::broadcast(0));
    } else {
      where = weights_at<lane_count>(u.s, false, window.x_first + x, window.y_first + y, lanes<floats>::broadcast(0));
    }
    return of_one(u, where);
  }

  // Some pixels of one triangle, those of a register that starts at a place in the tile.
  struct job {
    std::int32_t at;
    std::uint32_t kept;
  };
  struct job_list {
    static constexpr int most = tile_size * tile_size;
    int count = 0;
    job list[most];
  };

  // Calls one(id) for each triangle that a register's pixels show.
  template <class One>
  IRG_INLINE static void for_each_triangle(const integers& ids, unsigned shown, One&& one) {
    std::int32_t id[lane_count];
    std::memcpy(id, &ids.v, sizeof id);
    while (shown != 0) {
      const std::int32_t first = id[std::countr_zero(shown)];
      shown &= ~mask_bits(ids == lanes<integers>::broadcast(first));
      one(static_cast<std::uint32_t>(first));
    }
  }

  IRG_INLINE void add_jobs(job_list& jobs, int at, const integers& ids, unsigned shown) {
    for_each_triangle(ids, shown, [&](std::uint32_t place) {
      if (kept_at[place] == 0) prepare(place);
      jobs.list[jobs.count++] = {at, kept_at[place] - 1};
    });
  }

  // The whole tile, with the colours of N pixels at once. First it is found out which triangles each register shows;
  // the work itself then runs without a guess. Colours gather in the cache and leave for the picture at the end.
  IRG_INLINE std::int64_t shade_in_lanes() {
    using words = pack<std::uint32_t, lane_count>;
    const int width = window.x_last - window.x_first, height = window.y_last - window.y_first;
    alignas(64) std::uint32_t shaded_words[tile_size * tile_stride];
    std::int32_t many[tile_size * tile_size / lane_count];
    int many_count = 0;
    job_list jobs;
    std::int64_t shaded = 0;
    for (int y = 0; y < height; ++y) {
      std::uint32_t* const row = shaded_words + y * tile_stride;
      if (background != nullptr)
        fill_pixels(row, tile_stride, std::bit_cast<std::uint32_t>(*background));
      else
        std::memcpy(row, raster_traits<Colour>::row(colour, window.y_first + y) + window.x_first,
                    static_cast<std::size_t>(width) * 4);
      for (int x = 0; x < width; x += lane_count) {
        const int at = y * tile_stride + x;
        const integers ids = ids_at(at);
        const unsigned shown = ~mask_bits(ids == lanes<integers>::broadcast(-1)) & everyone;
        shaded += std::popcount(shown);
        if (shown == 0) continue;
        const unsigned others = shown & ~mask_bits(ids == lanes<integers>::broadcast(ids.v[std::countr_zero(shown)]));
        const unsigned rest =
            others &
            ~mask_bits(ids == lanes<integers>::broadcast(ids.v[std::countr_zero(others | (1u << (lane_count - 1)))]));
        if (rest != 0)
          many[many_count++] = at;  // three triangles or more: each pixel for itself
        else
          add_jobs(jobs, at, ids, shown);
      }
    }
    const auto blend = [&](int at, const integers& where, const values& v) {
      std::uint32_t* const to = shaded_words + at;
      const words mixed = select(where, shading.pixels(v), lanes<words>::load(to));
      lanes<words>::store(to, mixed);
    };
    for (int i = 0; i < many_count; ++i) {
      const int at = many[i];
      const integers ids = ids_at(at), nothing = ids == lanes<integers>::broadcast(-1);
      const unsigned shown = ~mask_bits(nothing) & everyone;
      values v;
      if (of_many(ids, shown, window.x_first + at % tile_stride, window.y_first + at / tile_stride, v))
        blend(at, integers{~nothing.v}, v);
      else
        add_jobs(jobs, at, ids, shown);
    }
    for (int i = 0; i < jobs.count; ++i) {
      const auto [at, k] = jobs.list[i];
      const uniform& u = kept[k];
      blend(at, ids_at(at) == lanes<integers>::broadcast(static_cast<std::int32_t>(u.place)), of_one(u, at));
    }
    for (int y = 0; y < height; ++y)
      std::memcpy(static_cast<void*>(raster_traits<Colour>::row(colour, window.y_first + y) + window.x_first),
                  shaded_words + y * tile_stride, static_cast<std::size_t>(width) * 4);
    return shaded;
  }

  // The whole tile, where colours are made one by one.
  IRG_INLINE std::int64_t shade_one_by_one() {
    std::int64_t shaded = 0;
    for (int y = 0; y < window.y_last - window.y_first; ++y)
      for (int x = 0; x < window.x_last - window.x_first; x += lane_count) {
        const int at = y * tile_stride + x;
        const integers ids = ids_at(at);
        pixel* const to = raster_traits<Colour>::row(colour, window.y_first + y) + window.x_first + x;
        const unsigned shown = ~mask_bits(ids == lanes<integers>::broadcast(-1)) & everyone;
        shaded += std::popcount(shown);
        for_each_triangle(ids, shown, [&](std::uint32_t place) {
          if (kept_at[place] == 0) prepare(place);
          const values v = of_one(kept[kept_at[place] - 1], at);
          unsigned bits = mask_bits(ids == lanes<integers>::broadcast(static_cast<std::int32_t>(place)));
          for (; bits != 0; bits &= bits - 1) {
            std::array<float, value_count> one;
            for (std::size_t j = 0; j < value_count; ++j) one[j] = lane(v[j], std::countr_zero(bits));
            to[std::countr_zero(bits)] = shading.pixel(one);
          }
        });
      }
    return shaded;
  }

  // The whole tile; returns the number of pixels that show a triangle.
  IRG_NOINLINE std::int64_t operator()() {
    kept_at.assign(numbers.size(), 0);
    if constexpr (LaneAttributeShading<Shading, lane_count> && sizeof(pixel) == 4) {
      return shade_in_lanes();
    } else {
      if (background != nullptr)
        for (int y = window.y_first; y < window.y_last; ++y)
          fill_span(colour, {y, window.x_first, window.x_last}, *background);
      return shade_one_by_one();
    }
  }
};

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
