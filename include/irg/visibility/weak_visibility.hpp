// SPDX-License-Identifier: MIT
// From where in the plane all of a source is seen, some of it, or nothing: weak visibility from a segment; light,
// penumbra and umbra of a point, a segment or an area that shines; what two regions see of each other.
//
// What is seen changes at obstacles, and at sight lines to the source past two ends. These cut the window into parts,
// each of which sees as much as one place in it does.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/checked.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/segment.hpp>
#include <irg/visibility/detail/source_regions_builder.hpp>
#include <irg/visibility/sight_result.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The parts of the window from where all of the source is seen, some of it, and nothing.
/// shape   `source` is a point, the two ends of a segment, or a ring, of any direction, whose inside is part of it.
///         Source and obstacles may reach out of the window; obstacles may touch, cross, overlap and be points
/// needs   fewer than 2^15 ends
/// gives   parts that have an area, with their boundaries; what is seen by no more than a point of the source counts
///         as nothing. No rings where the window is empty or flat, and for what sight_result.hpp calls not answered
/// exact   every decision, for all finite floats and doubles; vertices are given points, bit for bit, or correctly
///         rounded crossings of lines through two given points
/// cost    n ends have n^2 sight lines, of which those that obstacles cut off are skipped; the m others meet in up to
///         m^2 places, each of which costs n log n. Made for plans of some dozens of walls
/// source  irg's own, by the critical lines of Suri and O'Rourke 1986
template <Floating T>
[[nodiscard]] constexpr source_regions<T> weak_visibility(
    std::span<const point<T, 2>> source, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const box<T, 2>& window) {
  return detail::source_regions_builder<T>(window).run(source, obstacles, detail::line_choice::needed);
}

/// The same for the segment from source.a to source.b.
template <Floating T>
[[nodiscard]] constexpr source_regions<T> weak_visibility(
    const segment<T, 2>& source, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const box<T, 2>& window) {
  const point<T, 2> ends[] = {source.a, source.b};
  return weak_visibility(std::span<const point<T, 2>>(ends), obstacles, window);
}

/// The same for an area with holes, or several of them as one source: what is inside of an odd number of rings; or for
/// several segments, lists of two points each, which may touch and cross.
/// needs   rings that meet neither each other nor themselves, else the status says so
template <Floating T>
[[nodiscard]] constexpr source_regions<T> weak_visibility(
    std::span<const std::vector<point<T, 2>>> source, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const box<T, 2>& window) {
  return detail::source_regions_builder<T>(window).run(source, obstacles, detail::line_choice::needed);
}

/// What a point, a segment or an area sees of the inside of a ring, and it of them: each place in one each place in the
/// other, some of them, or nothing.
/// shape   the source as for weak_visibility; `region` is a ring that does not meet itself. Neither stops sight
/// gives   what is seen in single lines only counts as nothing; `none` beside every status but `done`
/// exact   for all finite floats and doubles
/// cost    as weak_visibility
template <Floating T>
[[nodiscard]] constexpr checked<seen_share, visibility_status> sight_between(
    std::span<const point<T, 2>> source, std::span<const std::type_identity_t<point<T, 2>>> region,
    std::span<const std::type_identity_t<segment<T, 2>>> obstacles) {
  return detail::source_regions_builder<T>(region).run_whole(source, obstacles);
}

}  // namespace IRG_ABI
}  // namespace irg
