// SPDX-License-Identifier: MIT
// The inner loops of building a bvh, in lanes.
#pragma once

#include <cstdint>
#include <type_traits>

#include <irg/core/lanes.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// The lesser of 8 floats each.
template <class F>
IRG_INLINE constexpr void grow_by(float* around, const float* item) noexcept {
  for (int i = 0; i < 8; i += lanes<F>::count)
    lanes<F>::store(around + i, low_of(lanes<F>::load(item + i), lanes<F>::load(around + i)));
}
IRG_INLINE constexpr void grow_kernel(float* around, const float* item) noexcept {
  if (std::is_constant_evaluated())
    grow_by<float>(around, item);
  else
    grow_by<pack<float, native_lanes<float>>>(around, item);
}

// Twice the centre of an item, and that of the primitive's number, which is of no use: low + high.
template <class F>
IRG_INLINE constexpr void centre_by(float* centre, const float* item) noexcept {
  for (int i = 0; i < 4; i += lanes<F>::count)
    lanes<F>::store(centre + i, lanes<F>::load(item + i) - lanes<F>::load(item + 4 + i));
}
IRG_INLINE constexpr void centre_kernel(float* centre, const float* item) noexcept {
  if (std::is_constant_evaluated())
    centre_by<float>(centre, item);
  else
    centre_by<pack<float, 4>>(centre, item);
}

// The bins of an item along the axes: those of its centre.
template <class F>
IRG_INLINE constexpr void bins_by(std::int32_t* bin, const float* item, const float* least, const float* gain,
                                  std::int32_t last) noexcept {
  using J = typename lanes<F>::template rebind<std::int32_t>;
  for (int i = 0; i < 4; i += lanes<F>::count) {
    const F at = (lanes<F>::load(item + i) - lanes<F>::load(item + 4 + i)) - lanes<F>::load(least + i);
    const F place = low_of(at * lanes<F>::load(gain + i), lanes<F>::broadcast(static_cast<float>(last)));
    lanes<J>::store(bin + i, converted<std::int32_t>(place));
  }
}
IRG_INLINE constexpr void bins_kernel(std::int32_t* bin, const float* item, const float* least, const float* gain,
                                      std::int32_t last) noexcept {
  if (std::is_constant_evaluated())
    bins_by<float>(bin, item, least, gain, last);
  else
    bins_by<pack<float, 4>>(bin, item, least, gain, last);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
