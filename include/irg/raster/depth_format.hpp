// SPDX-License-Identifier: MIT
// Depth formats: how a depth buffer keeps a depth, which of two kept depths is nearer, what it is cleared to, and how
// far apart two surfaces must be to stay in order. A format is a type without members of its own.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/contract.hpp>
#include <irg/core/contraction.hpp>
#include <irg/raster/depth.hpp>

namespace irg {

namespace detail {
inline namespace IRG_ABI {

// The largest gap between neighbouring floats below t, next to it: 2^(e-23) for t in (2^e, 2^(e+1)].
IRG_INLINE constexpr double float_gap_below(double t) noexcept {
  if (!(t > 0x1p-126)) return 0x1p-149;
  // Of the next number below t the exponent alone is left, less 23.
  return std::bit_cast<double>(((std::bit_cast<std::uint64_t>(t) - 1) >> 52 << 52) - (std::uint64_t{23} << 52));
}

// z, or the depth that hides nothing where z is NaN; limited to [0, 1].
template <class Order>
IRG_INLINE constexpr float depth_in_range(float z) noexcept {
  return z != z ? static_cast<float>(Order::farthest) : clamp(z, 0.0f, 1.0f);
}

IRG_INLINE constexpr bool is_endless(double z_far) noexcept { return z_far > (std::numeric_limits<double>::max)(); }

// near * far / (far - near), by which 1/distance is scaled between the two planes.
IRG_INLINE constexpr double depth_scale(double z_near, double z_far) noexcept {
  return is_endless(z_far) ? z_near : z_near / (1.0 - z_near / z_far);
}

// Reversed depth rises from 0 on the far plane to 1 on the near one.
IRG_INLINE constexpr double reversed_depth(double z_near, double z_far, double distance) noexcept {
  const double end = is_endless(z_far) ? 1.0 : 1.0 - distance / z_far;
  return depth_scale(z_near, z_far) * end / distance;
}

}  // namespace IRG_ABI

// What the formats that keep z/w in a float have in common, whichever way it runs.
template <class Order>
struct depth_in_float {
  using stored = float;
  using order = Order;
  static constexpr stored farthest = Order::farthest, nearest = 1.0f - Order::farthest;
  IRG_INLINE static constexpr stored encode(float z) noexcept { return depth_in_range<order>(z); }
  IRG_INLINE static constexpr float decode(stored s) noexcept { return s; }
  IRG_INLINE static constexpr bool nearer(stored a, stored b) noexcept { return order::nearer(a, b); }
  IRG_INLINE static constexpr double scale(double z_near, double z_far) noexcept { return depth_scale(z_near, z_far); }
  IRG_INLINE static constexpr double step_below(double depth) noexcept { return float_gap_below(depth); }
};

}  // namespace detail

/// z/w of a reversed projection in a float: 1 on the near plane, 0 on the far one. irg's default.
struct depth_float_reversed : detail::depth_in_float<nearer_is_greater> {
  IRG_INLINE static constexpr double depth_at(double z_near, double z_far, double distance) noexcept {
    return detail::reversed_depth(z_near, z_far, distance);
  }
};

/// z/w of a standard projection in a float: 0 on the near plane, 1 on the far one, where floats are coarse.
struct depth_float : detail::depth_in_float<nearer_is_less> {
  IRG_INLINE static constexpr double depth_at(double z_near, double z_far, double distance) noexcept {
    return lesser(detail::depth_scale(z_near, z_far) * (1.0 / z_near - 1.0 / distance), 1.0);
  }
};

/// One over the distance from the eye (1/w), in a float: nothing is scaled, there is no far plane.
/// needs   a perspective projection, where w is the distance
struct depth_inverse_w {
  using stored = float;
  using order = nearer_is_greater;
  static constexpr stored farthest = 0.0f, nearest = std::numeric_limits<float>::infinity();
  /// The 1/w given; 0 for NaN and everything below 0, which is behind the eye.
  IRG_INLINE static constexpr stored encode(float inverse_w) noexcept { return 0.0f < inverse_w ? inverse_w : 0.0f; }
  IRG_INLINE static constexpr float decode(stored s) noexcept { return s; }
  IRG_INLINE static constexpr bool nearer(stored a, stored b) noexcept { return order::nearer(a, b); }
  IRG_INLINE static constexpr double scale(double, double) noexcept { return 1.0; }
  IRG_INLINE static constexpr double depth_at(double, double, double distance) noexcept { return 1.0 / distance; }
  IRG_INLINE static constexpr double step_below(double depth) noexcept { return detail::float_gap_below(depth); }
};

/// Depths in [0, 1] as whole multiples of 1/(2^Bits - 1), in the low bits of an integer.
template <int Bits, DepthOrder Order = nearer_is_less>
struct depth_fixed {
  static_assert(1 <= Bits && Bits <= 24, "a float has no more bits to give");
  using stored = std::conditional_t<(Bits > 16), std::uint32_t, std::uint16_t>;
  using order = Order;
  static constexpr bool reversed = Order::nearer(1.0f, 0.0f);
  static constexpr std::uint32_t largest = (std::uint32_t{1} << Bits) - 1;
  static constexpr stored farthest = static_cast<stored>(reversed ? 0 : largest),
                          nearest = static_cast<stored>(reversed ? largest : 0);

  /// The multiple nearest to z, the greater on a tie; z is limited to [0, 1], NaN is the farthest.
  IRG_INLINE static constexpr stored encode(float z) noexcept {
    // 24 bits by 24: the product, its floor and what is left are exact.
    const double steps = widened(detail::depth_in_range<order>(z)) * double{largest};
    const auto whole = static_cast<std::int32_t>(steps);
    return static_cast<stored>(whole + (steps - static_cast<double>(whole) >= 0.5 ? 1 : 0));
  }
  /// The float nearest to s / (2^Bits - 1); encode() of it is s again.
  IRG_INLINE static constexpr float decode(stored s) noexcept {
    return static_cast<float>(s) / static_cast<float>(largest);
  }
  IRG_INLINE static constexpr bool nearer(stored a, stored b) noexcept { return order::nearer(a, b); }
  IRG_INLINE static constexpr double scale(double z_near, double z_far) noexcept {
    return detail::depth_scale(z_near, z_far);
  }
  IRG_INLINE static constexpr double depth_at(double z_near, double z_far, double distance) noexcept {
    return reversed ? depth_float_reversed::depth_at(z_near, z_far, distance)
                    : depth_float::depth_at(z_near, z_far, distance);
  }
  IRG_INLINE static constexpr double step_below(double) noexcept { return 1.0 / double{largest}; }
};

using depth_unorm16 = depth_fixed<16>;
using depth_unorm24 = depth_fixed<24>;

/// 24 bits of depth above 8 bits of stencil in one 32-bit word (OpenGL's UNSIGNED_INT_24_8).
struct depth24_stencil8 {
  using stored = std::uint32_t;
  using order = nearer_is_less;
  static constexpr stored farthest = depth_unorm24::largest << 8, nearest = 0;
  IRG_INLINE static constexpr stored pack(std::uint32_t depth, std::uint8_t stencil) noexcept {
    return depth << 8 | stencil;
  }
  IRG_INLINE static constexpr std::uint32_t depth_of(stored s) noexcept { return s >> 8; }
  IRG_INLINE static constexpr std::uint8_t stencil_of(stored s) noexcept { return static_cast<std::uint8_t>(s & 255u); }
  /// The word for z with stencil 0, or with the stencil given.
  IRG_INLINE static constexpr stored encode(float z, std::uint8_t stencil = 0) noexcept {
    return pack(depth_unorm24::encode(z), stencil);
  }
  IRG_INLINE static constexpr float decode(stored s) noexcept { return depth_unorm24::decode(depth_of(s)); }
  /// Whether a's depth is nearer than b's, whatever their stencils.
  IRG_INLINE static constexpr bool nearer(stored a, stored b) noexcept {
    return order::nearer(depth_of(a), depth_of(b));
  }
  IRG_INLINE static constexpr double scale(double z_near, double z_far) noexcept {
    return detail::depth_scale(z_near, z_far);
  }
  IRG_INLINE static constexpr double depth_at(double z_near, double z_far, double distance) noexcept {
    return depth_unorm24::depth_at(z_near, z_far, distance);
  }
  IRG_INLINE static constexpr double step_below(double depth) noexcept { return depth_unorm24::step_below(depth); }
};

/// A way to keep depths. Members: stored, order, farthest (what a buffer is cleared to), nearest, encode, decode,
/// nearer; and of perspective depth, depth_at(near, far, distance) unrounded, scale(near, far), which is
/// |d depth / d (1/distance)|, and step_below(depth), the gap between kept depths there.
/// Models: depth_float_reversed, depth_float, depth_inverse_w, depth_unorm16, depth_unorm24, depth24_stencil8.
template <class F>
concept DepthFormat = DepthOrder<typename F::order> && requires(float z, typename F::stored s, double x) {
  { F::encode(z) } -> std::same_as<typename F::stored>;
  { F::decode(s) } -> std::same_as<float>;
  { F::nearer(s, s) } -> std::same_as<bool>;
  { F::farthest } -> std::convertible_to<typename F::stored>;
  { F::nearest } -> std::convertible_to<typename F::stored>;
  { F::depth_at(x, x, x) } -> std::same_as<double>;
  { F::scale(x, x) } -> std::same_as<double>;
  { F::step_below(x) } -> std::same_as<double>;
};

inline namespace IRG_ABI {

/// How far in front of a surface at `distance` another must be for the format to keep the two in order: the least such
/// separation that holds wherever the surface lies between two kept depths.
/// units   those of z_near, z_far and distance, all measured from the eye along the view
/// needs   a perspective projection, 0 < z_near < z_far (which may be infinity), 0 < distance <= z_far
/// gives   infinity where `needs` is broken and not caught; more than distance - z_near where nothing between the near
///         plane and the surface is told from it
/// exact   within 10 ulp of the formula s = q d d / (k + q d), q the step and k the scale of the format; depths as a
///         pipeline computes them carry their own rounding beside (docs/raster/depth_format.md)
/// source  Akeley and Su 2006, Minimum triangle separation for correct z-buffer occlusion
template <DepthFormat F>
constexpr double depth_resolution(F, double z_near, double z_far, double distance) noexcept {
  const bool usable =
      0.0 < z_near && z_near < z_far && 0.0 < distance && distance <= z_far && !detail::is_endless(distance);
  IRG_EXPECTS(usable);
  if (!usable) return std::numeric_limits<double>::infinity();
  const double k = F::scale(z_near, z_far), depth = F::depth_at(z_near, z_far, distance);
  const auto separation = [&](double step) {
    return distance * (product(step, distance) / (k + product(step, distance)));
  };
  const double first = separation(F::step_below(depth));
  if (F::order::nearer(0.0f, 1.0f)) return first;  // depth falls towards the eye
  // Towards the eye depth rises, perhaps to where floats lie further apart.
  const double higher = depth + F::step_below(depth);
  return greater(first, separation(F::step_below(higher)));
}

}  // namespace IRG_ABI
}  // namespace irg
