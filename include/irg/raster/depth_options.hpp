// SPDX-License-Identifier: MIT
// What a pixel's depth must be to be drawn, and whether drawing leaves it in the depth buffer. Both are known at
// compile time, so that a kernel has no branch for them; the same words serve numbers and packs.
#pragma once

#include <irg/core/lanes.hpp>
#include <irg/raster/depth.hpp>

namespace irg {

/// Which depths pass, compared with the stored one in the sense of a DepthOrder. A depth that is NaN never does.
enum class depth_test {
  nearer,  // the first drawn of two equal depths stays
  nearer_or_equal,  // the last drawn stays: a second pass over the same surfaces, a background at the farthest depth
  equal,  // a second pass that shades what an earlier one left visible
  always,  // drawing order decides
  never  // nothing is drawn
};

/// Whether a pixel that passes leaves its depth in the buffer.
enum class depth_write {
  on,
  off  // glass, marks on a surface: hidden by what is nearer, hiding nothing
};

/// Depth test and depth write as one type, to be handed to a kernel.
template <depth_test Test = depth_test::nearer, depth_write Write = depth_write::on>
struct depth_policy {
  static constexpr depth_test test = Test;
  static constexpr depth_write write = Write;
};

/// Depth test and depth write, known at compile time. Models: depth_policy.
template <class P>
concept DepthPolicy = requires {
  { P::test } -> std::convertible_to<depth_test>;
  { P::write } -> std::convertible_to<depth_write>;
};

inline namespace IRG_ABI {

/// Whether a depth passes the test against the stored one, or in which lanes.
/// shape   F is a number or a pack of them; a bool comes out, or the pack's mask
/// gives   false where the depth is NaN; against a stored NaN only `always` passes
/// exact   comparisons only
template <depth_test Test, DepthOrder Order, class F>
[[nodiscard]] IRG_INLINE constexpr typename lanes<F>::mask passes(const F& depth, const F& stored) noexcept {
  using mask = typename lanes<F>::mask;
  if constexpr (Test == depth_test::nearer)
    return Order::nearer(depth, stored);
  else if constexpr (Test == depth_test::nearer_or_equal)
    return static_cast<mask>(Order::nearer(depth, stored) | (depth == stored));
  else if constexpr (Test == depth_test::equal)
    return depth == stored;
  else if constexpr (Test == depth_test::always)
    return depth == depth;
  else
    return lanes<mask>::broadcast(0);
}

}  // namespace IRG_ABI
}  // namespace irg
