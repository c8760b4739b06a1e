// SPDX-License-Identifier: MIT
// What a pixel shader is given, and the shaders that need no light: one colour, and three vertex colours.
#pragma once

#include <concepts>

#include <irg/colour/pixel.hpp>
#include <irg/core/lanes.hpp>

namespace irg {

/// One pixel of a triangle, or one per lane when F is a pack: the weights of its second and third vertex, corrected for
/// perspective (the first has the rest of 1), and its depth.
template <class F>
struct pixel_weights {
  F weight1, weight2, depth;

  /// The value at the pixel of a quantity given at the three vertices.
  [[nodiscard]] IRG_INLINE constexpr F interpolate(float at0, float at1, float at2) const noexcept {
    using f = lanes<F>;
    return f::broadcast(at0) + (product(weight1, f::broadcast(at1 - at0)) + product(weight2, f::broadcast(at2 - at0)));
  }
};

/// Turns the weights at a pixel into a pixel of type P.
template <class S, class P>
concept PixelShader = requires(const S shader, const pixel_weights<float> at) {
  { shader(at) } -> std::convertible_to<P>;
};

/// A pixel shader that works in lanes: light(weights) gives the light of all lanes at once, encode(light of one) its
/// pixel.
template <class S, class P>
concept LaneShader =
    PixelShader<S, P> && requires(const S shader, const pixel_weights<float> at, const rgb<float> light) {
      { shader.light(at) } -> std::same_as<rgb<float>>;
      { shader.encode(light) } -> std::convertible_to<P>;
    };

/// The same pixel everywhere.
template <class P>
struct solid_shader {
  P pixel;
  template <class F>
  IRG_INLINE constexpr P operator()(const pixel_weights<F>&) const noexcept {
    return pixel;
  }
};

/// Colours given at the vertices, linear in between (Gouraud 1971); Encode turns the light of a pixel into its bytes.
template <class P, class Encode>
struct vertex_colour_shader {
  rgb<float> at0, at1, at2;
  Encode encode_light;

  template <class F>
  [[nodiscard]] IRG_INLINE constexpr rgb<F> light(const pixel_weights<F>& at) const noexcept {
    return {at.interpolate(at0.r, at1.r, at2.r), at.interpolate(at0.g, at1.g, at2.g),
            at.interpolate(at0.b, at1.b, at2.b)};
  }
  [[nodiscard]] IRG_INLINE constexpr P encode(const rgb<float>& c) const { return encode_light(c); }
  IRG_INLINE constexpr P operator()(const pixel_weights<float>& at) const { return encode(light(at)); }
};

/// One intensity at each vertex, linear in between: the triangle of a Gouraud exercise.
/// exact   the float nearest to the weighted sum within three roundings; then rounded to the nearest integer and
///         limited to 0..255 when P is an 8-bit integer
template <class P>
struct intensity_shader {
  float at0, at1, at2;

  template <class F>
  IRG_INLINE constexpr P operator()(const pixel_weights<F>& at) const noexcept {
    const float value = at.interpolate(at0, at1, at2);
    if constexpr (std::integral<P>)
      return static_cast<P>(clamped(value, 0.0f, 255.0f) + 0.5f);
    else
      return static_cast<P>(value);
  }
};

}  // namespace irg
