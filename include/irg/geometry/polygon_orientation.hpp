// SPDX-License-Identifier: MIT
// Which way round a polygon runs, decided exactly for the coordinates as they are, and how to turn it round.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include <irg/core/vocabulary.hpp>
#include <irg/geometry/detail/shoelace.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg {

/// A ring read in its own direction or the other way round; vertex 0 stays the first. It refers to the ring.
template <PlaneRing R>
class directed_ring {
public:
  IRG_INLINE constexpr directed_ring(const R& ring, bool reversed) noexcept : ring_(&ring), reversed_(reversed) {}
  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return ring_size(*ring_); }
  /// needs   i < size()
  IRG_INLINE constexpr ring_point<R> operator[](std::size_t i) const noexcept {
    return ring_vertex(*ring_, reversed_ ? size() - i : i);
  }

private:
  const R* ring_;
  bool reversed_;
};

inline namespace IRG_ABI {

/// Which way round the polygon runs (y up), by the sign of its area; where it crosses itself the parts' areas add up.
/// gives   `degenerate` for fewer than three vertices, collinear ones, a figure of eight whose halves cancel, and when
///         a coordinate is NaN or infinite
/// exact   for all finite floats and all integers; other scalars: as exact as their own + - * are
/// cost    one pass; nothing allocates
template <PlaneRing R>
[[nodiscard]] constexpr orientation orientation_of(const R& ring) noexcept {
  if (ring_size(ring) < 3 || !is_finite(ring)) return orientation::degenerate;
  return static_cast<orientation>(detail::shoelace_sign(ring));
}

/// The ring, read the other way round.
/// cost    constant; nothing is copied
template <PlaneRing R>
[[nodiscard]] constexpr directed_ring<R> reversed_ring(const R& ring) noexcept {
  return {ring, true};
}
/// needs   a ring that outlives the view
template <PlaneRing R>
[[nodiscard]] constexpr directed_ring<R> reversed_ring(const R&& ring) = delete;

/// The ring, read counter-clockwise.
/// gives   the ring in its own direction when its orientation is `degenerate`
/// cost    as orientation_of; nothing is copied
template <PlaneRing R>
[[nodiscard]] constexpr directed_ring<R> counter_clockwise_ring(const R& ring) noexcept {
  return {ring, orientation_of(ring) == orientation::clockwise};
}
/// needs   a ring that outlives the view
template <PlaneRing R>
[[nodiscard]] constexpr directed_ring<R> counter_clockwise_ring(const R&& ring) = delete;

/// Turns the ring round in place: the same vertices in the other order, the first stays first.
template <PlaneRing R>
  requires requires(R& r, std::size_t i) { std::swap(r[i], r[i]); }
constexpr void reverse_ring(R& ring) noexcept {
  const std::size_t n = ring_size(ring);
  for (std::size_t i = 1; i + i < n; ++i) std::swap(ring[i], ring[n - i]);
}

/// Makes the ring counter-clockwise (y up), reversing it when it runs clockwise; the first vertex stays first.
/// gives   which way it ran before; a `degenerate` one is left as it was
/// exact   as orientation_of
/// source  Mihajlovic 2016, 3.2, the repair of the orientation
template <PlaneRing R>
  requires requires(R& r, std::size_t i) { std::swap(r[i], r[i]); }
constexpr orientation make_counter_clockwise(R& ring) noexcept {
  const orientation before = orientation_of(ring);
  if (before == orientation::clockwise) reverse_ring(ring);
  return before;
}

}  // namespace IRG_ABI
}  // namespace irg
