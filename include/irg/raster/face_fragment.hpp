// SPDX-License-Identifier: MIT
// A part of a face, for methods that split faces: the face and the planes that limit it. Splitting makes no new corner
// and rounds nothing: which part a pixel belongs to is asked where it matters, at its centre, by the predicate that
// orders faces there. So the parts of a face share none of its pixels and leave none out.
#pragma once

#include <concepts>
#include <vector>

#include <irg/raster/face_order.hpp>

namespace irg {

/// Which part of a face a plane leaves: where the face is nearer than the plane, or where it is not.
enum class face_part { nearer, farther };

/// A limit of a fragment: the part of its face on one side of the plane of another.
struct face_limit {
  const screen_face* plane;
  face_part part;
};

/// The pixels of a face that lie within all limits.
/// needs   faces that stay where they are as long as the fragment lives
struct face_fragment {
  const screen_face* face;
  std::vector<face_limit> limits{};
};

/// The two parts of a fragment.
struct fragment_parts {
  face_fragment nearer, farther;
};

inline namespace IRG_ABI {

/// Whether pixel (x, y) belongs to the fragment: its face covers it, and within each limit is_nearer than the plane, or
/// is not.
/// needs   limits by faces with an area; -snap_limit <= x, y < snap_limit
/// exact   as is_nearer: where face and plane are equally deep, the lower number is the nearer
/// cost    one is_nearer for each limit, until one fails
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] constexpr bool covers(const face_fragment& fragment, int x, int y) noexcept {
  if (!covers(*fragment.face, x, y)) return false;
  for (const face_limit& l : fragment.limits)
    if (is_nearer<Order>(*fragment.face, *l.plane, x, y) != (l.part == face_part::nearer)) return false;
  return true;
}

/// The fragment, split by the plane of another face: each pixel of it belongs to one part.
/// needs   a face with an area, that stays where it is as long as the parts live
/// gives   a part without pixels where the plane does not cut the fragment
/// cost    allocates: copies the limits
template <std::same_as<face_fragment> Fragment = face_fragment>
[[nodiscard]] constexpr fragment_parts split_fragment(const Fragment& fragment, const screen_face& plane) {
  fragment_parts parts{fragment, fragment};
  parts.nearer.limits.push_back({&plane, face_part::nearer});
  parts.farther.limits.push_back({&plane, face_part::farther});
  return parts;
}

}  // namespace IRG_ABI
}  // namespace irg
