// SPDX-License-Identifier: MIT
// Private to the chapter: where a Bezier patch is cut so that each cell stays within a tolerance, and where its borders
// are cut, which depends on the border alone.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <irg/curve/detail/patch_bends.hpp>
#include <irg/curve/flatten.hpp>

namespace irg::detail {

/// Places from 0 to patch_steps, rising; whether each stretch is within its part of the tolerance.
struct IRG_APART patch_cuts {
  std::vector<int> places{0};
  bool within = true;
  constexpr std::size_t last() const noexcept { return places.size() - 1; }
  constexpr int operator[](std::size_t k) const noexcept { return places[k]; }
  // Halves the stretch that ends in place k; false where it is too short.
  constexpr bool halve(std::size_t k) {
    const int middle = places[k - 1] + (places[k] - places[k - 1]) / 2;
    if (middle == places[k - 1]) return false;
    places.insert(places.begin() + static_cast<std::ptrdiff_t>(k), middle);
    return true;
  }
};

inline namespace IRG_ABI {

template <class IsWithin>
constexpr patch_cuts cuts_where(const IsWithin& is_within) {
  constexpr int most = 1024, least = patch_steps / most;  // shorter stretches are left to frames
  patch_cuts cuts;
  each_longest_stretch(
      most, 12, [&](int from, int to) { return is_within(from * least, to * least); },
      [&](int at, bool within) {
        cuts.places.push_back(at * least);
        cuts.within = cuts.within && within;
      });
  return cuts;
}

// Cuts along u (or v) whose strips may bend by half of the tolerance, the mixed derivative counted once: of a cell in
// two such strips the error is at most (a^2 uu + a^2 uv) / 8 + (b^2 vv + b^2 uv) / 8, for 2 a b <= a^2 + b^2.
template <Coordinates P>
constexpr patch_cuts cuts_of_patch(patch_bends<P>& bends, scalar_of<P> tolerance, bool along_u) {
  using T = scalar_of<P>;
  return cuts_where([&](int from, int to) {
    const T share = static_cast<T>(to - from) / static_cast<T>(patch_steps);
    const auto b = along_u ? bends.in({from, to, 0, patch_steps}) : bends.in({0, patch_steps, from, to});
    return (along_u ? b.uu : b.vv) + product(share, b.uv) <= product(T(4), tolerance);
  });
}

// Whether the points come before themselves in reverse, by the first coordinate that tells.
template <Coordinates P>
constexpr bool runs_forward(const std::vector<P>& points) noexcept {
  for (std::size_t k = 0, back = points.size() - 1; k < back; ++k, --back)
    for (int i = 0; i < size_of<P>; ++i)
      if (coordinate(points[k], i) != coordinate(points[back], i))
        return coordinate(points[k], i) < coordinate(points[back], i);
  return true;
}

// Cuts of a border, which a neighbour that has it the other way round makes in the same places.
template <Coordinates P>
constexpr patch_cuts cuts_of_border(std::vector<P> points, scalar_of<P> tolerance) {
  using T = scalar_of<P>;
  const bool forward = runs_forward(points);
  const auto turn = [](auto& list) {
    for (std::size_t k = 0, back = list.size() - 1; k < back; ++k, --back) {
      const auto kept = list[k];
      list[k] = list[back];
      list[back] = kept;
    }
  };
  if (!forward) turn(points);
  patch_bends<P> bends({points, points.size()});
  auto cuts =
      cuts_where([&](int from, int to) { return bends.in({0, patch_steps, from, to}).vv <= product(T(4), tolerance); });
  if (!forward) {
    turn(cuts.places);
    for (int& place : cuts.places) place = patch_steps - place;
  }
  return cuts;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
