// SPDX-License-Identifier: MIT
// A finished tile turned into colours: only what is visible is shaded, once.
#pragma once

#include <cstdint>
#include <type_traits>

#include <irg/raster/fill_span.hpp>
#include <irg/render/attribute_shading.hpp>
#include <irg/render/detail/tile_drawing.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The weights at a pixel of a piece, for the vertices of its source triangle.
template <class F>
IRG_INLINE constexpr pixel_weights<F> in_source(const pixel_weights<F>& at, const piece_weights& w) noexcept {
  const auto& [a, b, c] = w.corner;
  return {at.interpolate(a.second, b.second, c.second), at.interpolate(a.third, b.third, c.third), at.depth};
}

// A shader of the source triangle, made one of the piece.
template <class Shader>
struct piece_shader {
  const Shader& shader;
  const piece_weights& weights;
  IRG_INLINE constexpr decltype(auto) operator()(const pixel_weights<float>& at) const {
    return shader(in_source(at, weights));
  }
};

// draw(shader) with the pixel shader of the triangle, or of the piece of one, that has this number.
template <class T, class MakeShader, class Draw>
constexpr auto with_pixel_shader(const MakeShader& make_shader, const triangle_finder<T>& find, std::uint32_t number,
                                 facing side, const Draw& draw) {
  const std::uint32_t source = find.source(number);
  const triangle_batch<T>& batch = find.batch_of(source);
  const auto shader = [&] {
    if constexpr (AttributeShading<MakeShader, triangle_batch<T>>)
      return pixel_shader_of(make_shader, batch, source - batch.first_number, side);
    else
      return make_shader(batch, source - batch.first_number, side);
  }();
  if (find.is_piece(number)) return draw(piece_shader<decltype(shader)>{shader, find.piece(number).weights});
  return draw(shader);
}

#ifdef IRG_LANES_VECTOR

// What the pixels of one triangle share, and its shader.
template <class Shader>
struct shading_setup {
  triangle_setup s;
  bool narrow;  // F fits 32 bits all over the tile
  const piece_weights* piece;
  Shader shader;
};

// The perspective-correct weights of N pixels in a row, as draw_triangle has them.
template <int N>
IRG_INLINE pixel_weights<pack<float, N>> weights_at(const triangle_setup& s, bool narrow, int x, int y,
                                                    const pack<float, N>& depth) noexcept {
  using floats = pack<float, N>;
  using F = lanes<floats>;
  floats b[3];
  for (int i = 0; i < 3; ++i) {
    const std::int64_t f = s.edge[i](x, y);
    using I = pack<std::int32_t, N>;
    using W = wide_pack<N>;
    const auto row = [&]<class L>(L) {
      using integer = typename lanes<L>::scalar;
      return lanes<L>::broadcast(static_cast<integer>(f)) +
             lanes<L>::broadcast(static_cast<integer>(s.edge[i].right)) * lanes<L>::ramp();
    };
    const floats wide = narrow ? to_float(row(I{})) : to_float(row(W{}));
    b[i] = wide * F::broadcast(s.scale) + F::broadcast(s.rest[i]);
  }
  return perspective_weights(s, b[0], b[1], b[2], depth);
}

// Shades the visible pixels of a tile with one shader per triangle, and returns how many they are.
template <class Colour, class T, class MakeShader>
IRG_INLINE std::int64_t shade_by_triangle(const tile& t, const triangle_finder<T>& find,
                                          std::span<const std::uint32_t> numbers, const cell_window& window, float sign,
                                          Colour& colour, const MakeShader& make_shader) {
  constexpr int lane_count = tile_lanes;
  using floats = pack<float, lane_count>;
  using F = lanes<floats>;
  using shader_type = std::remove_cvref_t<decltype(make_shader(find.batches[0], std::uint32_t{}, facing::front))>;
  const cell_window whole{window.x_first, window.y_first, window.x_first + tile_size, window.y_first + tile_size};
  const auto prepare = [&](std::uint32_t number) -> shading_setup<shader_type> {
    const triangle_corners c = find.corners(number);
    const triangle_coverage coverage = cover_triangle(c.v[0]->position, c.v[1]->position, c.v[2]->position);
    const std::uint32_t source = find.source(number);
    const triangle_batch<T>& batch = find.batch_of(source);
    return {set_up(coverage, *c.v[0], *c.v[1], *c.v[2]), fits_32_bits(coverage, whole, block_size),
            find.is_piece(number) ? &find.piece(number).weights : nullptr,
            make_shader(batch, source - batch.first_number, coverage.flipped ? facing::front : facing::back)};
  };
  std::int64_t shaded = 0;
  std::uint32_t current = no_triangle;
  std::optional<shading_setup<shader_type>> setup;
  for (int by = window.y_first; by < window.y_last; by += block_size)
    for (int x = window.x_first; x < window.x_last; x += lane_count)
      for (int y = by; y < lesser(by + block_size, window.y_last); ++y) {
        const int at = (y - window.y_first) * tile_stride + (x - window.x_first);
        pack<std::int32_t, lane_count> ids;
        std::memcpy(&ids.v, t.id + at, sizeof ids.v);
        unsigned pending =
            ~mask_bits(ids == lanes<pack<std::int32_t, lane_count>>::broadcast(-1)) & ((1u << lane_count) - 1);
        shaded += std::popcount(pending);
        const floats depth = F::load(t.key + at) * F::broadcast(sign);
        while (pending != 0) {
          const auto place = static_cast<std::uint32_t>(ids.v[std::countr_zero(pending)]);
          if (place != current) {
            setup.emplace(prepare(numbers[place]));
            current = place;
          }
          const unsigned same =
              mask_bits(ids == lanes<pack<std::int32_t, lane_count>>::broadcast(static_cast<std::int32_t>(place))) &
              pending;
          pixel_weights<floats> where = weights_at<lane_count>(setup->s, setup->narrow, x, y, depth);
          if (setup->piece != nullptr) where = in_source(where, *setup->piece);
          shade_pixels(raster_traits<Colour>::row(colour, y) + x, same, where, setup->shader);
          pending &= ~same;
        }
      }
  return shaded;
}

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
