// SPDX-License-Identifier: MIT
// How the weights of a triangle's vertices change from pixel to pixel, perspective included: what a shader needs to
// know how large a pixel is on the surface.
//
// Let p_i = (x_i W, -y_i H, w_i) be the vertices in clip space, W and H half of the picture's size in pixels, and
//     c_0 = p_1 x p_2,  c_1 = p_2 x p_0,  c_2 = p_0 x p_1,  D = p_0 . c_0.
// The point at (X, Y) of the picture, in pixels to the right of its centre and below it, has the weights
//     b_i = w g_i,  g_i = c_i . (X, Y, 1) / D,  1 / w = g_0 + g_1 + g_2,
// and so
//     d b_i / dX = w (g_i' - b_i (g_0' + g_1' + g_2')),  g_i' = dg_i / dX = (c_i).x / D,
// and with Y alike. Nothing is divided by a w, so vertices may lie behind the eye.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/raster/pixel_weights.hpp>
#include <irg/raster/triangle_batch.hpp>

namespace irg {

/// How the weights of a triangle's second and third vertex change on the way to the right and downwards, per pixel.
template <class F = float>
struct weight_changes {
  F weight1_right{}, weight2_right{}, weight1_down{}, weight2_down{};

  /// How a quantity given at the three vertices changes to the right.
  [[nodiscard]] IRG_INLINE constexpr F right(float at0, float at1, float at2) const noexcept {
    return sum(weight1_right, weight2_right, at1 - at0, at2 - at0);
  }
  /// How it changes downwards.
  [[nodiscard]] IRG_INLINE constexpr F down(float at0, float at1, float at2) const noexcept {
    return sum(weight1_down, weight2_down, at1 - at0, at2 - at0);
  }

private:
  IRG_INLINE static constexpr F sum(const F& weight1, const F& weight2, float to1, float to2) noexcept {
    return product(weight1, lanes<F>::broadcast(to1)) + product(weight2, lanes<F>::broadcast(to2));
  }
};

/// The derivatives of a triangle's weights, ready to be taken at its pixels. Those of a triangle that is seen exactly
/// from its edge are 0.
struct weight_derivatives {
  float right[3]{}, down[3]{};  // of g_1, g_2, and g_0 + g_1 + g_2
  float w[3]{};  // of the vertices; on a scale on which the largest is 1, as the others are

  /// The derivatives at a pixel's centre.
  /// exact   four roundings of a float, relative to |g'| w and |b g'| w, and those of the pixel's weights
  template <class F = float>
  IRG_INLINE constexpr weight_changes<F> operator()(const pixel_weights<F>& at) const noexcept {
    const F here = at.interpolate(w[0], w[1], w[2]);
    const auto change = [&](float own, const F& weight, float all) IRG_INLINE_LAMBDA {
      return product(here, lanes<F>::broadcast(own) - product(weight, lanes<F>::broadcast(all)));
    };
    return {change(right[0], at.weight1, right[2]), change(right[1], at.weight2, right[2]),
            change(down[0], at.weight1, down[2]), change(down[1], at.weight2, down[2])};
  }
  bool operator==(const weight_derivatives&) const = default;
};

namespace detail::inline IRG_ABI {

// A float, not beyond the range of floats.
IRG_INLINE constexpr float limited_float(double x) noexcept { return converted<float>(clamped(x, -0x1p100, 0x1p100)); }

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The derivatives of the weights of a triangle of a batch: of the whole triangle, also where it is clipped.
/// needs   a triangle whose vertices are there, projected with `mapping`
/// exact   in doubles from clip space, then rounded to floats
/// source  Olano and Greer 1997, for weights that are linear in homogeneous coordinates
template <Floating T>
[[nodiscard]] constexpr weight_derivatives make_weight_derivatives(const triangle_batch<T>& batch,
                                                                   std::uint32_t triangle,
                                                                   const screen_mapping<T>& mapping) noexcept {
  vec<double, 3> p[3];
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    const hpoint<T, 3> v = clip_position(*batch.vertices, batch.triangles[triangle].v[i]);
    const double w = widened(v.w);
    p[i] = {product(widened(v.x), widened(mapping.half_width)), -product(widened(v.y), widened(mapping.half_height)),
            w};
    largest = maximum(largest, w < 0 ? -w : w);
  }
  if (!(0 < largest)) return {};
  for (vec<double, 3>& v : p) v = {v.x / largest, v.y / largest, v.z / largest};
  const vec<double, 3> c0 = cross(p[1], p[2]), c1 = cross(p[2], p[0]), c2 = cross(p[0], p[1]);
  const double d = dot(p[0], c0);
  if (d == 0) return {};
  weight_derivatives r;
  const double sum_right = c0.x + (c1.x + c2.x), sum_down = c0.y + (c1.y + c2.y);
  for (int i = 0; i < 3; ++i) {
    r.right[i] = detail::limited_float((i == 0 ? c1.x : i == 1 ? c2.x : sum_right) / d);
    r.down[i] = detail::limited_float((i == 0 ? c1.y : i == 1 ? c2.y : sum_down) / d);
    r.w[i] = converted<float>(p[i].z);
  }
  return r;
}

}  // namespace IRG_ABI
}  // namespace irg
