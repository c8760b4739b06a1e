// SPDX-License-Identifier: MIT
// Sight in space past the faces of a mesh: between two points, exactly; between two regions, what is sure, exactly; and
// how much, by random sight lines with error bars.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/math/vec.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/visibility/sight_result.hpp>
#if IRG_BODIES
#include <irg/core/contract.hpp>
#include <irg/core/contraction.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/visibility/detail/space_blockers.hpp>
#endif

namespace irg {

/// Whether the corners of a region are those of a flat polygon or of a box.
enum class region_shape { flat, box };

/// A region of space: a point, the two ends of a segment, a flat convex polygon in its order, or a box.
template <Floating T>
struct space_region {
  std::vector<point<T, 3>> corners;
  region_shape shape = region_shape::flat;
  bool operator==(const space_region&) const = default;
};

/// How many random sight lines, which ones, and how wide error bars are.
struct sight_sampling_options {
  std::int64_t lines = 1000;
  std::uint64_t seed = 1;
  double deviations = 2.5758293035489004;  ///< of the normal distribution: 99 of 100 error bars hold the true share
  bool operator==(const sight_sampling_options&) const = default;
};

/// How many of some sight lines are free, and between which limits the true share lies, as often as was asked for.
struct sampled_sight {
  std::int64_t lines = 0, seen = 0;
  double share = 0, low = 0, high = 1;
  bool operator==(const sampled_sight&) const = default;
};

inline namespace IRG_ABI {

/// A box as a region.
template <Floating T>
[[nodiscard]] constexpr space_region<T> region_of(const box<T, 3>& b) {
  space_region<T> out{{}, region_shape::box};
  for (unsigned i = 0; i < 8; ++i)
    out.corners.push_back(
        {(i & 1u) != 0 ? b.high.x : b.low.x, (i & 2u) != 0 ? b.high.y : b.low.y, (i & 4u) != 0 ? b.high.z : b.low.z});
  return out;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// Whether q is seen from p: no face of the mesh is in the way, strictly between the two.
/// shape   faces are convex and flat; others count as the triangles from their first corner. Faces without area stop
///         nothing
/// needs   finite coordinates
/// gives   true when p == q; a face that the way touches, or runs along, stops it; the same with p and q exchanged
/// exact   for all finite floats and doubles
/// cost    a pass over the faces; some 20 ns for each on one side of whose plane both lie
template <Floating T>
[[nodiscard]] IRG_API bool has_line_of_sight(const point<T, 3>& p, const point<T, 3>& q,
                                             const mesh<T>& blockers) noexcept;

/// What two convex regions see of each other for sure: every place in one every place in the other, some of them some,
/// or none any. Nothing where that is not known.
/// shape   faces as for see. Regions may touch and overlap; they stop no sight
/// needs   finite coordinates; a region with a corner at least
/// gives   `all` whenever it is so but for faces in one plane with both regions, single lines along the border of all
///         between them not counted: those faces beside a region touch; `some` when one of 64 random lines
///         between places in the regions is free; `none` when a single face parts the regions and every line between
///         corners meets it. What several faces hide together is not known. A face that has a flat region in its plane
///         does not hide it, so that regions may be faces of the mesh
/// exact   `all` and `none`, for all finite floats and doubles; `some` too, but for places in a slanted region, which
///         are rounded to numbers beside it
/// cost    for each face near the regions the planes through three of their corners; a has_line_of_sight() for each
///         line
/// source  irg's own, by planes that part convex hulls
template <Floating T>
[[nodiscard]] IRG_API std::optional<seen_share> sure_sight(const space_region<T>& a, const space_region<T>& b,
                                                           const mesh<T>& blockers);

/// The share of the lines between places in two regions that are free, by random ones, with error bars.
/// shape   as sure_sight; places are spread evenly over segments, areas and boxes
/// needs   1 <= how.lines, 0 <= how.deviations
/// gives   the same lines for the same seed, everywhere
/// exact   each line, between two rounded places; the error bars are Wilson's
/// cost    a has_line_of_sight() for each line, past the faces near the regions
/// source  Wilson 1927
template <Floating T>
[[nodiscard]] IRG_API sampled_sight sample_sight(const space_region<T>& a, const space_region<T>& b,
                                                 const mesh<T>& blockers, const sight_sampling_options& how = {});

/// What is sure about each face of a mesh, seen from a region past the others.
/// shape   as sure_sight, a value for each face, which counts as seen from both sides
/// cost    sure_sight for each face
template <Floating T>
[[nodiscard]] IRG_API std::vector<std::optional<seen_share>> sure_sight_of_faces(const space_region<T>& from,
                                                                                 const mesh<T>& m);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API bool has_line_of_sight(const point<T, 3>& p, const point<T, 3>& q,
                                             const mesh<T>& blockers) noexcept {
  for (std::size_t f = 0; f < blockers.face_count(); ++f)
    for (std::size_t k = 2; k < blockers.face_size(f); ++k)
      if (detail::stops_sight(p, q, detail::fan_triangle(blockers, f, k))) return false;
  return true;
}

template <Floating T>
[[nodiscard]] IRG_API std::optional<seen_share> sure_sight(const space_region<T>& a, const space_region<T>& b,
                                                           const mesh<T>& blockers) {
  IRG_EXPECTS(!a.corners.empty() && !b.corners.empty());
  const detail::space_blockers<T> between(a.corners, b.corners, blockers);
  if (between.frees_all()) return seen_share::all;
  if (a.corners.size() == 1 && b.corners.size() == 1)
    return between.lets_by(a.corners[0], b.corners[0]) ? seen_share::all : seen_share::none;
  if (between.hides_all()) return seen_share::none;
  detail::place_chooser chooser{1};
  for (int i = 0; i < 64; ++i) {
    const point<T, 3> p = chooser.place_in<T>(a.corners, a.shape == region_shape::box);
    if (between.lets_by(p, chooser.place_in<T>(b.corners, b.shape == region_shape::box))) return seen_share::some;
  }
  return std::nullopt;
}

template <Floating T>
[[nodiscard]] IRG_API sampled_sight sample_sight(const space_region<T>& a, const space_region<T>& b,
                                                 const mesh<T>& blockers, const sight_sampling_options& how) {
  IRG_EXPECTS(!a.corners.empty() && !b.corners.empty() && how.lines >= 1 && how.deviations >= 0);
  const detail::space_blockers<T> between(a.corners, b.corners, blockers);
  detail::place_chooser chooser{how.seed};
  sampled_sight out{how.lines, 0, 0, 0, 1};
  for (std::int64_t i = 0; i < how.lines; ++i) {
    const point<T, 3> p = chooser.place_in<T>(a.corners, a.shape == region_shape::box);
    out.seen += between.lets_by(p, chooser.place_in<T>(b.corners, b.shape == region_shape::box));
  }
  const double n = static_cast<double>(out.lines), z2 = product(how.deviations, how.deviations);
  out.share = static_cast<double>(out.seen) / n;
  const double middle = (out.share + z2 / (2 * n)) / (1 + z2 / n);
  const double spread = sqrt(product(out.share, 1 - out.share) / n + z2 / n / (4 * n));
  const double reach = product(how.deviations / (1 + z2 / n), spread);
  out.low = out.seen == 0 ? 0 : middle - reach;
  out.high = out.seen == out.lines ? 1 : middle + reach;
  return out;
}

template <Floating T>
[[nodiscard]] IRG_API std::vector<std::optional<seen_share>> sure_sight_of_faces(const space_region<T>& from,
                                                                                 const mesh<T>& m) {
  std::vector<std::optional<seen_share>> out;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    space_region<T> face;
    for (std::size_t k = 0; k < m.face_size(f); ++k) face.corners.push_back(m.positions[m.corner(f, k).position]);
    out.push_back(sure_sight(from, face, m));
  }
  return out;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
