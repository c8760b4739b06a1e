// SPDX-License-Identifier: MIT
// A finished tile turned into colours: only what is visible is shaded, once.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/piece_weights.hpp>
#include <irg/render/attribute_shading.hpp>
#include <irg/render/detail/shade/collected_points.hpp>
#include <irg/render/detail/visible/tile.hpp>
#include <irg/render/detail/visible/visible_window.hpp>

namespace irg::detail::inline IRG_ABI {

// The weights at a pixel of a piece, for the vertices of its source triangle.
template <class F>
IRG_INLINE constexpr pixel_weights<F> in_source(const pixel_weights<F>& at, const piece_weights& w) noexcept {
  const auto& [a, b, c] = w.corner;
  return {at.interpolate(a.second, b.second, c.second), at.interpolate(a.third, b.third, c.third), at.depth};
}

// The pixel shader of the source triangle of what has this number.
template <class T, class MakeShader>
constexpr auto shader_for(const MakeShader& make_shader, const triangle_finder<T>& find, std::uint32_t number,
                          facing side) {
  const std::uint32_t source = find.source(number);
  const triangle_batch<T>& batch = find.batch_of(source);
  if constexpr (AttributeShading<MakeShader, triangle_batch<T>>)
    return pixel_shader_of(make_shader, batch, source - batch.first_number, side);
  else
    return make_shader(batch, source - batch.first_number, side);
}

// Whether make_shader gives pixel shaders of triangles of batches, and whether these give pixels of type P.
template <class MakeShader, class T>
concept shades_batches = AttributeShading<MakeShader, triangle_batch<T>> ||
                         requires(const MakeShader& make_shader, const triangle_batch<T>& batch) {
                           make_shader(batch, std::uint32_t{}, facing::front);
                         };
template <class MakeShader, class T>
using batch_shader = std::remove_cvref_t<decltype(shader_for(
    std::declval<const MakeShader&>(), std::declval<const triangle_finder<T>&>(), std::uint32_t{}, facing::front))>;
template <class MakeShader, class T, class P>
concept shades_into = shades_batches<MakeShader, T> && PixelShader<batch_shader<MakeShader, T>, P>;

// Whether blend(pixel, what a shader gives) is a pixel of type P.
template <class Blend, class MakeShader, class T, class P>
concept blends_into =
    shades_batches<MakeShader, T> &&
    requires(const Blend& blend, const P& there, const batch_shader<MakeShader, T>& shader, pixel_weights<float> at) {
      { blend(there, shader(at)) } -> std::convertible_to<P>;
    };

// Where the corners of a piece lie in its source triangle; null for a triangle that was not clipped.
template <class T>
IRG_INLINE constexpr const piece_weights* piece_weights_of(const triangle_finder<T>& find,
                                                           std::uint32_t number) noexcept {
  return find.is_piece(number) ? &find.piece(number).weights : nullptr;
}

// What the pixels of one triangle share, and its shader.
template <class Shader>
struct shading_setup {
  triangle_setup s;
  bool narrow;  // F fits 32 bits all over the window
  const piece_weights* piece;
  Shader shader;
};

// The perspective-correct weights of the pixels from (x, y) on, as shade_triangle has them.
template <class F>
IRG_INLINE constexpr pixel_weights<F> weights_from(const triangle_setup& s, bool narrow, int x, int y,
                                                   const F& depth) noexcept {
  constexpr int count = lanes<F>::count;
  F b[3]{};
  for (int i = 0; i < 3; ++i) {
    const std::int64_t f = s.edge[i](x, y);
    if constexpr (count == 1) {
      b[i] = s.weight<F>(i, f);
    } else {
      const auto row = [&]<class L>(L) {
        using integer = typename lanes<L>::scalar;
        return lanes<L>::broadcast(static_cast<integer>(f)) +
               lanes<L>::broadcast(static_cast<integer>(s.edge[i].right)) * lanes<L>::ramp();
      };
      b[i] = narrow ? s.weight<F>(i, row(pack<std::int32_t, count>{})) : s.weight<F>(i, row(wide_pack<count>{}));
    }
  }
  return perspective_weights(s, b[0], b[1], b[2], depth);
}

// Colours what a window shows, with one shader per triangle.
template <class T, class MakeShader>
struct shade_by_triangle {
  const visible_window& v;
  const triangle_finder<T>& find;
  const MakeShader& make_shader;

  using shader_type = decltype(shader_for(make_shader, find, 0, facing::front));

  constexpr shading_setup<shader_type> prepare(std::uint32_t number) const {
    const triangle_corners c = find.corners(number);
    const covered_triangle t = cover_and_set_up(*c.v[0], *c.v[1], *c.v[2]);
    const cell_window whole{v.window.x_first, v.window.y_first, v.window.x_first + tile_size,
                            v.window.y_first + tile_size};
    return {t.setup, fits_32_bits(t.coverage, whole, block_size), piece_weights_of(find, number),
            shader_for(make_shader, find, number, t.coverage.flipped ? facing::front : facing::back)};
  }

  // F is float or a pack of them. Returns the number of pixels that show a triangle.
  template <class F, class Colour>
  constexpr std::int64_t in_lanes(Colour& colour) const {
    using integers = typename lanes<F>::template rebind<std::int32_t>;
    using J = lanes<integers>;
    constexpr int count = lanes<F>::count;
    std::int64_t shaded = 0;
    kept_setups kept;
    const cell_window& w = v.window;
    for (int by = w.y_first; by < w.y_last; by += block_size) {
      pixel_of<Colour>* rows[block_size]{};
      for (int y = by; y < minimum(by + block_size, w.y_last); ++y)
        rows[y - by] = raster_traits<Colour>::row(colour, y);
      for (int x = w.x_first; x < w.x_last; x += count)
        for (int y = by; y < minimum(by + block_size, w.y_last); ++y) {
          const int at = (y - w.y_first) * tile_stride + (x - w.x_first);
          const integers places = load_places<integers>(v.place + at);
          unsigned pending = ~mask_bits(places == J::broadcast(-1)) & ((1u << count) - 1);
          shaded += std::popcount(pending);
          const F depth = product(lanes<F>::load(v.key + at), lanes<F>::broadcast(v.sign));
          auto* const row = rows[y - by] + x;
          collected_points<shader_type, count, pixel_of<Colour>> points{row};
          while (pending != 0) {
            const auto place = static_cast<std::uint32_t>(lane(places, std::countr_zero(pending)));
            const shading_setup<shader_type>& setup = kept.of(*this, place);
            const auto shown = places == J::broadcast(static_cast<std::int32_t>(place));
            const unsigned same = mask_bits(shown) & pending;
            pixel_weights<F> where = weights_from<F>(setup.s, setup.narrow, x, y, depth);
            if (setup.piece != nullptr) where = in_source(where, *setup.piece);
            if constexpr (points.collects)
              points.add(setup.shader, where, shown, same);
            else
              shade_over<shader_type>{setup.shader}(row, same, where);
            pending &= ~same;
          }
        }
    }
    return shaded;
  }

private:
  // The triangles met last: neighbours come again with every row.
  struct kept_setups {
    static constexpr std::uint32_t count = 16;
    std::uint32_t place[count];
    std::optional<shading_setup<shader_type>> setup[count]{};

    constexpr kept_setups() noexcept {
      for (std::uint32_t& p : place) p = no_index;
    }
    IRG_INLINE constexpr const shading_setup<shader_type>& of(const shade_by_triangle& shade, std::uint32_t wanted) {
      const std::uint32_t i = wanted % count;
      if (place[i] != wanted) {
        setup[i].emplace(shade.prepare(shade.v.numbers[wanted]));
        place[i] = wanted;
      }
      return *setup[i];
    }
  };

  template <class J>
  IRG_INLINE static constexpr J load_places(const std::uint32_t* from) noexcept {
    if constexpr (lanes<J>::count == 1)
      return static_cast<J>(*from);
    else
      return bits_as<std::int32_t>(lanes<typename lanes<J>::template rebind<std::uint32_t>>::load(from));
  }
};

}  // namespace irg::detail::inline IRG_ABI
