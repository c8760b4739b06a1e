// SPDX-License-Identifier: MIT
// The size of tiles, and how their pixels are decided.
#pragma once

#include <concepts>

#include <irg/raster/depth.hpp>

namespace irg::detail {

inline constexpr int tile_size = 64, block_size = 8, blocks_across = tile_size / block_size;
inline constexpr int tile_stride = tile_size + block_size;  // runs of pixels may reach beyond the right border

// How pixels are decided in a tile: by depth, always for the later triangle, or by depth where nobody asks whose it is.
enum class tile_test { nearer, always, depth_only };

// The test where it matters which triangle is seen.
template <class Order>
inline constexpr tile_test test_of = std::same_as<Order, drawing_order> ? tile_test::always : tile_test::nearer;

// How an order of depths is turned into one of keys. Orders of other makers are drawn pixel by pixel.
template <class Order>
inline constexpr float key_sign = 0;
template <>
inline constexpr float key_sign<nearer_is_greater> = 1;
template <>
inline constexpr float key_sign<nearer_is_less> = -1;
template <>
inline constexpr float key_sign<drawing_order> = 1;

inline namespace IRG_ABI {

// Refuses an order of depths that irg::compiled has nothing for.
template <class Order>
constexpr void expect_known_order() noexcept {
  static_assert(IRG_BODIES != 0 || key_sign<Order> != 0,
                "irg::compiled knows the orders of depth in raster/depth.hpp: for one of your own define "
                "IRG_HEADER_ONLY before the first header of irg");
}

}  // namespace IRG_ABI
}  // namespace irg::detail
