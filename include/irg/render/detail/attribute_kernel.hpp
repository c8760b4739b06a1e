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
  static constexpr int N = tile_lanes;
  static constexpr unsigned everyone = (1u << N) - 1;
  static constexpr std::size_t K = static_cast<std::size_t>(Shading::attribute_count);
  using floats = pack<float, N>;
  using integers = pack<std::int32_t, N>;
  using values = std::array<floats, K>;
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
    const piece_weights* piece;
    float at0[K], change1[K], change2[K];  // of the attributes, from the first vertex to the others
  };
  std::vector<std::uint32_t> kept_at{};  // by place: where in `kept`, counted from 1
  std::vector<uniform> kept{};

  // Each triangle that is still seen is made ready once.
  IRG_INLINE const uniform& prepared(std::uint32_t place) {
    if (kept_at[place] == 0) prepare(place);
    return kept[kept_at[place] - 1];
  }
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
                    find.is_piece(number) ? &find.piece(number).weights : nullptr,
                    {},
                    {},
                    {}});
    uniform& u = kept.back();
    for (std::size_t j = 0; j < K; ++j) {
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
    for (std::size_t j = 0; j < K; ++j)
      v[j] =
          F::broadcast(u.at0[j]) + (at.weight1 * F::broadcast(u.change1[j]) + at.weight2 * F::broadcast(u.change2[j]));
    return v;
  }

  IRG_INLINE integers ids_at(int x, int y) const noexcept {
    integers ids;
    std::memcpy(&ids.v, t.id + (y - window.y_first) * tile_stride + (x - window.x_first), sizeof ids.v);
    return ids;
  }

  // A run of registers whose pixels all show one triangle; returns where it ends.
  IRG_INLINE int shade_run(const uniform& u, int x, int y) {
    using I = lanes<integers>;
    using F = lanes<floats>;
    pixel* const row = raster_traits<Colour>::row(colour, y);
    const integers same = I::broadcast(static_cast<std::int32_t>(u.place));
    integers f[3];
    for (int i = 0; i < 3; ++i)
      f[i] = integers{I::broadcast(static_cast<std::int32_t>(u.s.edge[i](x, y))).v +
                      I::broadcast(u.s.edge[i].right).v * I::ramp().v};
    do {
      const auto at =
          perspective_weights(u.s, u.s.template weight<floats>(0, f[0]), u.s.template weight<floats>(1, f[1]),
                              u.s.template weight<floats>(2, f[2]), F::broadcast(0));
      write(row + x, of_one(u, at), I::broadcast(0), everyone);
      for (int i = 0; i < 3; ++i) f[i] = f[i] + I::broadcast(u.s.edge[i].right * N);
      x += N;
    } while (x + N <= window.x_last && mask_bits(ids_at(x, y) == same) == everyone);
    return x;
  }

  // The attributes of N pixels in a row, each of a triangle of its own; `shown` has a bit for each pixel that shows one.
  // gives   false when they are not all small triangles of one batch that show the same side
  IRG_INLINE bool of_many(const integers& ids, unsigned shown, int x_first, int y, values& out) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    const integers some = I::broadcast(ids.v[std::countr_zero(shown)]);
    const integers number = gather<std::int32_t>(numbers.data(), select(ids == I::broadcast(-1), some, ids));
    corner_lanes<N> c;
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
    if (flipped != 0 && flipped != everyone) return false;  // of both sides
    const float* const base = shading.attributes(*batch, 0, flipped != 0 ? facing::front : facing::back);
    for (std::size_t j = 0; j < K; ++j) {
      floats at[3];
      for (int k = 0; k < 3; ++k)
        at[k] = gather<float>(base, integers{c.vertex[k].v * Shading::attribute_count + static_cast<int>(j)});
      out[j] = at[0] + (w1 * (at[1] - at[0]) + w2 * (at[2] - at[0]));
    }
    return true;
  }

  // Writes the pixels that show a triangle, and the background, if there is one, to the others that lie in the picture.
  IRG_INLINE void write(pixel* to, const values& v, const integers& nothing, unsigned inside) const noexcept {
    const unsigned shown = ~mask_bits(nothing) & everyone;
    if constexpr (LaneAttributeShading<Shading, N> && sizeof(pixel) == 4) {
      using words = pack<std::uint32_t, N>;
      words w = shading.pixels(v);
      if (background != nullptr)
        w = select(nothing, lanes<words>::broadcast(std::bit_cast<std::uint32_t>(*background)), w);
      if (inside == everyone && (background != nullptr || shown == everyone)) {
        std::memcpy(static_cast<void*>(to), &w.v, sizeof w.v);
        return;
      }
      std::uint32_t word[N];
      std::memcpy(word, &w.v, sizeof word);
      for (unsigned bits = background != nullptr ? inside : shown; bits != 0; bits &= bits - 1)
        std::memcpy(static_cast<void*>(to + std::countr_zero(bits)), word + std::countr_zero(bits), sizeof *word);
    } else {
      for (unsigned bits = shown; bits != 0; bits &= bits - 1) {
        const int i = std::countr_zero(bits);
        std::array<float, K> one;
        for (std::size_t j = 0; j < K; ++j) one[j] = v[j].v[i];
        to[i] = shading.pixel(one);
      }
      if (background != nullptr)
        for (unsigned bits = inside & ~shown; bits != 0; bits &= bits - 1) to[std::countr_zero(bits)] = *background;
    }
  }

  // Registers of pixels from x on, up to where it returns; adds to `shaded` how many pixels show a triangle.
  IRG_INLINE int shade(int x, int y, std::int64_t& shaded) {
    const unsigned inside = (1u << lesser(window.x_last - x, N)) - 1;
    const integers ids = ids_at(x, y);
    const integers nothing = ids == lanes<integers>::broadcast(-1);
    const unsigned shown = ~mask_bits(nothing) & everyone;
    pixel* const to = raster_traits<Colour>::row(colour, y) + x;
    if (shown == 0) {
      if (background != nullptr) fill_pixels(to, static_cast<std::size_t>(std::popcount(inside)), *background);
      return x + N;
    }
    const auto like = [&](int i) { return mask_bits(ids == lanes<integers>::broadcast(ids.v[i])) & shown; };
    const unsigned one = like(std::countr_zero(shown)), others = shown & ~one;
    if (one == everyone)
      if (const uniform& u = prepared(static_cast<std::uint32_t>(ids.v[0])); u.narrow) {
        const int end = shade_run(u, x, y);
        shaded += end - x;
        return end;
      }
    shaded += std::popcount(shown);
    values v;
    // Of three triangles and more, each pixel for itself.
    if (others == 0 || like(std::countr_zero(others)) == others || !of_many(ids, shown, x, y, v)) {
      unsigned pending = shown;
      do {
        const integers id = lanes<integers>::broadcast(ids.v[std::countr_zero(pending)]), same = ids == id;
        const uniform& u = prepared(static_cast<std::uint32_t>(id.v[0]));
        const values of_this = of_one(u, weights_at<N>(u.s, u.narrow, x, y, lanes<floats>::broadcast(0)));
        const bool first = pending == shown;
        for (std::size_t j = 0; j < K; ++j) v[j] = first ? of_this[j] : select(same, of_this[j], v[j]);
        pending &= ~mask_bits(same);
      } while (pending != 0);
    }
    write(to, v, nothing, inside);
    return x + N;
  }

  // The whole tile; returns the number of pixels that show a triangle.
  IRG_NOINLINE std::int64_t operator()() {
    kept_at.assign(numbers.size(), 0);
    std::int64_t shaded = 0;
    for (int y = window.y_first; y < window.y_last; ++y)
      for (int x = window.x_first; x < window.x_last;) x = shade(x, y, shaded);
    return shaded;
  }
};

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
