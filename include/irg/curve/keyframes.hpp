// SPDX-License-Identifier: MIT
// Motion through points at given times: a cubic between each two keyframes, of one tangent in each keyframe.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/curve/bezier.hpp>

namespace irg {

/// A place and the time to be there.
template <Coordinates P>
struct keyframe {
  scalar_of<P> time{};
  P place = zero_coordinates<P>();
  IRG_APART constexpr bool operator==(const keyframe& o) const { return time == o.time && same_place(place, o.place); }
};

namespace detail::inline IRG_ABI {

/// A third of the way that the velocity at frames[k] leads in `span` of time: the velocity of the parabola through the
/// frame and its two neighbours; at either end, that of the straight line to the only neighbour.
template <Coordinates P>
constexpr typename curve_sample<P>::vector third_of_way(std::span<const keyframe<P>> frames, std::size_t k,
                                                        scalar_of<P> span) noexcept {
  using T = scalar_of<P>;
  const std::size_t before = k > 0 ? k - 1 : k, after = k + 1 < frames.size() ? k + 1 : k;
  // As a share of the distance: a velocity may overflow where the way does not, and so may the share.
  const auto way = [&](std::size_t i, std::size_t j, int axis) {
    const T distance = coordinate(frames[j].place, axis) - coordinate(frames[i].place, axis);
    const T time = frames[j].time - frames[i].time;
    if (distance == T(0)) return distance;
    if (T(1) <= time || span <= time * (std::numeric_limits<T>::max)()) return product(distance, span / time);
    return span < T(1) ? product(distance, span) / time : product(distance / time, span);
  };
  return generate_coordinates<typename curve_sample<P>::vector>([&](int axis) {
    if (before == k || after == k) return way(before, after, axis) / T(3);
    const T in = frames[k].time - frames[before].time, out = frames[after].time - frames[k].time, all = in + out;
    return (product(way(before, k, axis), out / all) + product(way(k, after, axis), in / all)) / T(3);
  });
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Whether keyframes can be followed: one or more, with finite times that rise, the time from the first to the last one
/// finite, too.
template <Coordinates P>
[[nodiscard]] constexpr bool can_be_followed(std::span<const keyframe<P>> frames) noexcept {
  using T = scalar_of<P>;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if constexpr (Floating<T>)
      if (!is_finite(frames[k].time)) return false;
    if (k > 0 && !(frames[k - 1].time < frames[k].time)) return false;
  }
  if (frames.empty()) return false;
  if constexpr (Floating<T>)
    return frames[frames.size() - 1].time / 2 - frames[0].time / 2 <= (std::numeric_limits<T>::max)() / 2;
  return true;
}

/// Where something is at `time` on its way through all keyframes.
/// needs   can_be_followed
/// gives   the first place before the first time (and for NaN), the last one after the last. Beside a keyframe whose
///         velocity leads beyond the largest number before the next one, no finite places
/// exact   each keyframe's place bit for bit at its time; the velocity has no jumps between the first time and the last
/// source  Farin 2002, 9.8 (Bessel's tangents)
template <CurvePoint P>
  requires Floating<scalar_of<P>>
[[nodiscard]] constexpr P place_at(std::span<const keyframe<P>> frames,
                                   std::type_identity_t<scalar_of<P>> time) noexcept {
  using T = scalar_of<P>;
  IRG_EXPECTS(can_be_followed(frames));
  if (!(time > frames[0].time)) return frames[0].place;
  if (!(time < frames[frames.size() - 1].time)) return frames[frames.size() - 1].place;
  std::size_t low = 0, high = frames.size() - 1;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (time < frames[middle].time ? high : low) = middle;
  }
  const T span = frames[high].time - frames[low].time;
  const auto leave = detail::third_of_way(frames, low, span), arrive = detail::third_of_way(frames, high, span);
  const P &from = frames[low].place, &to = frames[high].place;
  const std::array<P, 4> cubic{
      from, generate_coordinates<P>([&](int i) { return coordinate(from, i) + coordinate(leave, i); }),
      generate_coordinates<P>([&](int i) { return coordinate(to, i) - coordinate(arrive, i); }), to};
  return bezier_point(cubic, (time - frames[low].time) / span);
}

}  // namespace IRG_ABI
}  // namespace irg
