// SPDX-License-Identifier: MIT
// Registers of pixels that show several triangles and are shaded at once: where a shader costs more than finding out
// what is seen, it should not run for a few pixels of a register at a time.
#pragma once

#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/raster/pixel_weights.hpp>
#include <irg/shade/phong_lanes.hpp>

namespace irg {
namespace detail {

// What is seen at a register of pixels, whatever triangles they show: positions and normals.
template <int N>
struct surface_points {
  alignas(64) double coordinate[6][static_cast<unsigned>(N)];
};

inline namespace IRG_ABI {

// A register of pixels whose shader is dear and the same for several triangles: it runs once for all of them.
template <class Shader, int Count, class P>
struct collected_points {
  static constexpr bool collects = false;
  P* const row;
};
template <class Shader, int Count, class P>
  requires(Count > 1 && requires(const Shader& s, surface_points<Count>& p, const pixel_weights<pack<float, Count>>& at,
                                 const pack<std::int32_t, Count>& chosen) { s.place(p, at, chosen); })
struct collected_points<Shader, Count, P> {
  static constexpr bool collects = true;
  P* const row;
  surface_points<Count> points{};  // g++ 12 does not see that only chosen lanes are read
  const phong_lanes<double>* light = nullptr;
  unsigned chosen = 0;

  IRG_INLINE explicit collected_points(P* to) noexcept : row(to) {}
  IRG_INLINE ~collected_points() { flush(); }
  IRG_INLINE void flush() {
    if (chosen != 0) shade_chosen();
    chosen = 0;
  }
  IRG_INLINE void add(const Shader& shader, const pixel_weights<pack<float, Count>>& at,
                      const pack<std::int32_t, Count>& shown, unsigned same) {
    if (light != shader.in_lanes) flush();
    light = shader.in_lanes;
    shader.place(points, at, shown);
    chosen |= same;
  }

private:
  // Once for many points: its code, the light model's, stands in one place and not at each call of flush.
  IRG_NOINLINE void shade_chosen() { Shader::shade(*light, points, chosen, row); }
};

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
