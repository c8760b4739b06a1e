// SPDX-License-Identifier: MIT
// The steps of depth_format.hpp.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/contract.hpp>
#include <irg/core/contraction.hpp>
#include <irg/core/lanes.hpp>
#include <irg/raster/depth.hpp>
#include <irg/raster/screen_vertex.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

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
  return select(z == z, low_of(all(most), high_of(all(0.0f), z)), all(farthest));
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
}  // namespace irg
