// SPDX-License-Identifier: MIT
// Registers of pixels that show several triangles and are shaded at once: where a shader costs more than finding out
// what is seen, it should not run for a few pixels of a register at a time.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <irg/core/lanes.hpp>
#include <irg/raster/pixel_weights.hpp>

namespace irg::detail::inline IRG_ABI {

// Writes the chosen ones of N pixels.
template <int N, class P>
IRG_INLINE void store_pixels(P* row, const pack<std::uint32_t, N>& words, unsigned chosen) noexcept {
  static_assert(sizeof(P) == 4);
  if (chosen == (1u << N) - 1) return lanes<pack<std::uint32_t, N>>::store_bytes(row, words);
  for (; chosen != 0; chosen &= chosen - 1) {
    const int i = std::countr_zero(chosen);
    row[i] = std::bit_cast<P>(words[i]);
  }
}

// A shader whose pixels are made of values, by what is the same for all triangles.
template <class Shader, int N>
concept ValueShader = requires(const Shader& s, const pixel_weights<pack<float, N>>& at) {
  { s.shading.pixels(s.values(at)) } -> std::same_as<pack<std::uint32_t, N>>;
};

// What a register of pixels is made of, whatever triangles they show.
template <class Shader, int N>
struct collected_values {
  using shading_type = std::remove_cvref_t<decltype(std::declval<Shader>().shading)>;
  using values = decltype(std::declval<Shader>().values(std::declval<pixel_weights<pack<float, N>>>()));
  const shading_type* shading = nullptr;
  values of;

  IRG_INLINE bool takes(const Shader&) const noexcept { return true; }
  IRG_INLINE void put(const Shader& shader, const pixel_weights<pack<float, N>>& at,
                      const pack<std::int32_t, N>& where) {
    const values made = shader.values(at);
    if (shading == nullptr)
      of = made;  // what is not seen of it does no harm
    else
      for (std::size_t i = 0; i < made.size(); ++i) of[i] = select(where, made[i], of[i]);
    shading = &shader.shading;
  }
  template <class P>
  IRG_INLINE void shade(P* row, unsigned chosen) {
    store_pixels(row, shading->pixels(of), chosen);
    shading = nullptr;
  }
};

// What a shader's pixels are collected in: something of its own, its values, or (void) nothing.
template <class Shader, int N, class P>
constexpr auto collection_of() noexcept {
  if constexpr (N > 1 && requires { typename Shader::template collected<N>; })
    return std::type_identity<typename Shader::template collected<N>>{};
  else if constexpr (N > 1 && sizeof(P) == 4 && ValueShader<Shader, N>)
    return std::type_identity<collected_values<Shader, N>>{};
  else
    return std::type_identity<void>{};
}
template <class Shader, int N, class P>
using collection = typename decltype(collection_of<Shader, N, P>())::type;

// A register of pixels whose shader is dear and the same for several triangles: it runs once for all of them.
template <class Shader, int N, class P>
struct collected_points {
  static constexpr bool collects = false;
  P* const row;
};
template <class Shader, int N, class P>
  requires(!std::is_void_v<collection<Shader, N, P>>)
struct collected_points<Shader, N, P> {
  static constexpr bool collects = true;
  P* const row;
  collection<Shader, N, P> points{};
  unsigned chosen = 0;

  IRG_INLINE explicit collected_points(P* to) noexcept : row(to) {}
  IRG_INLINE ~collected_points() { flush(); }
  IRG_INLINE void flush() {
    if (chosen != 0) shade_chosen();
    chosen = 0;
  }
  IRG_INLINE void add(const Shader& shader, const pixel_weights<pack<float, N>>& at, const pack<std::int32_t, N>& shown,
                      unsigned same) {
    if (!points.takes(shader)) flush();
    points.put(shader, at, shown);
    chosen |= same;
  }

private:
  // Once for many points: its code, the light model's, stands in one place and not at each call of flush.
  IRG_NOINLINE void shade_chosen() { points.shade(row, chosen); }
};

}  // namespace irg::detail::inline IRG_ABI
