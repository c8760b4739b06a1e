// SPDX-License-Identifier: MIT
// Whole objects that cannot be seen because their box lies beyond the frustum.
#pragma once

#include <irg/core/containment.hpp>
#include <irg/geometry/box.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/raster/screen_mapping.hpp>
#include <irg/view/frustum.hpp>

namespace irg {
namespace detail {

// Tells of boxes whether no triangle in them can be seen. Beyond a depth plane that is certain; beyond a border of the
// picture only where nothing is clipped, because clipping rounds, and may round a far-off corner into sight.
template <class T>
struct object_culling {
  frustum<T> picture, guard, depth;

  IRG_INLINE constexpr object_culling(const mat<T, 4, 4>& to_clip, const screen_mapping<T>& mapping) noexcept
      : picture(frustum_of(to_clip)), guard(frustum_of(with_guard(to_clip, mapping.guard))), depth(picture) {
    const plane<T> everything{T(0), T(0), T(0), T(1)};
    for (const auto side : {frustum_plane::left, frustum_plane::right, frustum_plane::bottom, frustum_plane::top})
      depth.planes[static_cast<int>(side)] = depth.weights[static_cast<int>(side)] = everything;
  }

  IRG_INLINE constexpr bool unseen(const box<T, 3>& b) const noexcept {
    return side_of(depth, b) == containment::outside || (side_of(picture, b) == containment::outside && unclipped(b));
  }
  // Whether no triangle in the box is clipped.
  IRG_INLINE constexpr bool unclipped(const box<T, 3>& b) const noexcept {
    return side_of(guard, b) == containment::inside;
  }

private:
  // The matrix of a picture that is wider and higher by the guard factors.
  IRG_INLINE static constexpr mat<T, 4, 4> with_guard(mat<T, 4, 4> m, const clip_volume<T>& v) noexcept {
    for (int c = 0; c < 4; ++c) {
      m(0, c) = m(0, c) / v.guard_x;
      m(1, c) = m(1, c) / v.guard_y;
    }
    return m;
  }
};

}  // namespace detail
}  // namespace irg
