// SPDX-License-Identifier: MIT
// Depth formats: how a depth buffer keeps a depth, which of two kept depths is nearer, what it is cleared to, and how
// far apart two surfaces must be to stay in order. A format is a type without members of its own, to be handed to what
// draws; the words with which depths are compared serve numbers and packs.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/contraction.hpp>
#include <irg/core/conversion.hpp>
#include <irg/core/lanes.hpp>
#include <irg/raster/depth.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg {

namespace detail::inline IRG_ABI {

// The largest gap between neighbouring floats below t, next to it: 2^(e-23) for t in (2^e, 2^(e+1)].
IRG_INLINE constexpr double float_gap_below(double t) noexcept {
  if (!(t > 0x1p-126)) return 0x1p-149;
  // Of the next number below t the exponent alone is left, less 23.
  return std::bit_cast<double>(((std::bit_cast<std::uint64_t>(t) - 1) >> 52 << 52) - (std::uint64_t{23} << 52));
}

// z, or the depth that hides nothing where z is NaN; limited to [0, most].
template <class F>
IRG_INLINE constexpr F depth_in_range(const F& z, float most, float farthest) noexcept {
  const auto all = [](float v) { return lanes<F>::broadcast(v); };
  return select(z == z, minimum(all(most), maximum(all(0.0f), z)), all(farthest));
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

}  // namespace detail::inline IRG_ABI

namespace detail {

// Depths as they are given, of any type, in an order.
template <class Order, class Z>
struct depth_as_given {
  using stored = Z;
  using order = Order;
  static constexpr float farthest = Order::farthest;
  template <class F>
  IRG_INLINE static constexpr F level(const F& z) noexcept {
    return z;
  }
  template <class S>
  IRG_INLINE static constexpr S level_of(const S& s) noexcept {
    return s;
  }
  template <class S>
  IRG_INLINE static constexpr S with_level(const S&, const S& level) noexcept {
    return level;
  }
};

enum class float_depths { up_to_one, unlimited };

// What the formats that keep a float that is not negative have in common, whichever way it runs.
template <class Order, float_depths Depths = float_depths::up_to_one>
struct depth_in_float : depth_as_given<Order, float> {
  static constexpr float most = Depths == float_depths::unlimited ? std::numeric_limits<float>::infinity() : 1.0f;
  static constexpr float nearest = Order::nearer(1.0f, 0.0f) ? most : 0.0f;
  template <class F>
  IRG_INLINE static constexpr F level(const F& z) noexcept {
    return depth_in_range(z, most, Order::farthest);
  }
  IRG_INLINE static constexpr float encode(float z) noexcept { return level(z); }
  IRG_INLINE static constexpr float decode(float s) noexcept { return s; }
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
    return minimum(detail::depth_scale(z_near, z_far) * (1.0 / z_near - 1.0 / distance), 1.0);
  }
};

/// One over the distance from the eye (1/w), in a float: nothing is scaled, there is no far plane. What is below 0 lies
/// behind the eye and counts as 0.
/// needs   a perspective projection, where w is the distance
struct depth_inverse_w : detail::depth_in_float<nearer_is_greater, detail::float_depths::unlimited> {
  IRG_INLINE static constexpr double scale(double, double) noexcept { return 1.0; }
  IRG_INLINE static constexpr double depth_at(double, double, double distance) noexcept { return 1.0 / distance; }
};

/// Depths in [0, 1] as whole multiples of 1/(2^Bits - 1): an integer, below which Low bits belong to something else.
template <int Bits, DepthOrder Order = nearer_is_less, int Low = 0>
struct depth_fixed {
  static_assert(1 <= Bits && Bits <= 24, "a float has no more bits to give");
  using stored = std::conditional_t<(Bits + Low > 16), std::uint32_t, std::uint16_t>;
  using order = Order;
  static constexpr bool reversed = Order::nearer(1.0f, 0.0f);
  static constexpr std::uint32_t largest = (std::uint32_t{1} << Bits) - 1;
  static constexpr stored low_bits = (stored{1} << Low) - 1;
  static constexpr stored farthest = static_cast<stored>((reversed ? 0 : largest) << Low),
                          nearest = static_cast<stored>((reversed ? largest : 0) << Low);

  /// The multiple nearest to z, the greater on a tie; z is limited to [0, 1], NaN is the farthest.
  template <class F>
  IRG_INLINE static constexpr auto level(const F& z) noexcept {
    // 24 bits by 24: the product is exact, and so is the sum where it meets an integer.
    const auto in_range = converted<double>(detail::depth_in_range(z, 1.0f, Order::farthest));
    using D = lanes<std::remove_const_t<decltype(in_range)>>;
    return converted<std::int32_t>(product(in_range, D::broadcast(double{largest})) + D::broadcast(0.5));
  }
  template <class S>
  IRG_INLINE static constexpr auto level_of(const S& s) noexcept {
    return converted<std::int32_t>(s >> Low);
  }
  template <class K, class S>
  IRG_INLINE static constexpr S with_level(const S& s, const K& level) noexcept {
    return converted<stored>(converted<stored>(level) << Low | (s & low_bits));
  }
  /// What is kept of z, and in the low bits, where there are some, of `low`.
  IRG_INLINE static constexpr stored encode(float z, stored low = 0) noexcept { return with_level(low, level(z)); }
  /// The float nearest to s / (2^Bits - 1); encode() of it is s again.
  IRG_INLINE static constexpr float decode(stored s) noexcept {
    return static_cast<float>(level_of(s)) / static_cast<float>(largest);
  }
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

/// 24 bits of depth above 8 bits of stencil in one 32-bit word (OpenGL's UNSIGNED_INT_24_8). Depths are compared and
/// written without a look at the stencil.
struct depth24_stencil8 : depth_fixed<24, nearer_is_less, 8> {
  IRG_INLINE static constexpr std::uint8_t stencil_of(stored s) noexcept {
    return static_cast<std::uint8_t>(s & low_bits);
  }
};

/// A way to keep depths. Members: stored, order, farthest (what a buffer is cleared to), nearest, encode, decode; for
/// floats and packs of them level(z), the number that is compared, level_of(stored), with_level(stored, level); and of
/// perspective depth, depth_at(near, far, distance) unrounded, scale(near, far), which is |d depth / d (1/distance)|,
/// and step_below(depth), the gap between kept depths there.
/// Models: depth_float_reversed, depth_float, depth_inverse_w, depth_unorm16, depth_unorm24, depth24_stencil8.
template <class F>
concept DepthFormat = DepthOrder<typename F::order> && requires(float z, typename F::stored s, double x) {
  { F::encode(z) } -> std::same_as<typename F::stored>;
  { F::decode(s) } -> std::same_as<float>;
  { F::with_level(s, F::level(z)) } -> std::same_as<typename F::stored>;
  requires std::same_as<decltype(F::level_of(s)), decltype(F::level(z))>;
  { F::farthest } -> std::convertible_to<typename F::stored>;
  { F::nearest } -> std::convertible_to<typename F::stored>;
  { F::depth_at(x, x, x) } -> std::same_as<double>;
  { F::scale(x, x) } -> std::same_as<double>;
  { F::step_below(x) } -> std::same_as<double>;
};

/// How numbers of type Z are kept as depths: as a DepthFormat says, or in a DepthOrder, as they are given.
template <class How, class Z>
concept DepthKeeping = DepthOrder<How> || (DepthFormat<How> && std::same_as<typename How::stored, Z>);

/// The format that a DepthKeeping comes to.
template <class How, class Z>
  requires DepthKeeping<How, Z>
using depth_kept = typename std::conditional_t<DepthOrder<How>, std::type_identity<detail::depth_as_given<How, Z>>,
                                               std::type_identity<How>>::type;

inline namespace IRG_ABI {

/// Whether a kept depth is nearer than another.
template <DepthFormat F>
[[nodiscard]] IRG_INLINE constexpr bool is_nearer(typename F::stored a, typename F::stored b) noexcept {
  return F::order::nearer(F::level_of(a), F::level_of(b));
}

/// The vertex with the depth that is to be kept: 1/w for depth_inverse_w, else as it comes.
template <class How>
[[nodiscard]] IRG_INLINE constexpr screen_vertex vertex_for(screen_vertex v) noexcept {
  if constexpr (std::derived_from<How, depth_inverse_w>) v.depth = v.inverse_w;
  return v;
}

/// How far in front of a surface at `distance` another must be for the format to keep the two in order: the least such
/// separation that holds wherever the surface lies between two kept depths.
/// units   those of z_near, z_far and distance, all measured from the eye along the view
/// needs   a perspective projection, 0 < z_near < z_far (which may be infinity), 0 < distance <= z_far
/// gives   infinity where `needs` is broken and not caught; more than distance - z_near where nothing between the near
///         plane and the surface is told from it
/// exact   within 10 ulp of the formula s = q d d / (k + q d), q the step and k the scale of the format; depths as a
///         pipeline computes them carry their own rounding beside (docs/raster/depth_format.md)
/// source  Akeley and Su 2006
template <DepthFormat F>
[[nodiscard]] constexpr double depth_resolution(F, double z_near, double z_far, double distance) noexcept {
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
  return maximum(first, separation(F::step_below(higher)));
}

}  // namespace IRG_ABI
}  // namespace irg
