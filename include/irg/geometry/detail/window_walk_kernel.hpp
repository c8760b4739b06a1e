// SPDX-License-Identifier: MIT
// Polygons of few plain points against a window: one walk from edge to edge that passes over a boundary; vertices
// between are copied. The result is that of window_pipe, in a fraction of its time. What is delicate only has to be
// noticed: a vertex on or next to a boundary that its edge crosses, a cut next to a corner of the window, two cuts at
// one place, a cut that is hard to round. The pipe does it then.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/crossing_kernel.hpp>
#include <irg/geometry/detail/window_codes_kernel.hpp>
#include <irg/geometry/detail/window_edges.hpp>

namespace irg::detail {

// Two numbers, without lanes: for constant evaluation.
struct plain_pair {
  double at[2];
};

inline constexpr std::ptrdiff_t is_delicate = -1;

inline namespace IRG_ABI {

IRG_INLINE constexpr plain_pair swapped(const plain_pair& p) noexcept { return {{p.at[1], p.at[0]}}; }

using walk_pair = pack<double, 2>;
IRG_INLINE walk_pair swapped(const walk_pair& p) noexcept { return shuffled<1, 0>(p); }

template <class Pair>
IRG_INLINE constexpr Pair pair_of(double x, double y) noexcept {
  if constexpr (std::is_same_v<Pair, plain_pair>)
    return {{x, y}};
  else
    return pack_of(x, y);
}
template <class Pair>
IRG_INLINE constexpr Pair load_pair(const double* p) noexcept {
  if constexpr (std::is_same_v<Pair, plain_pair>)
    return {{p[0], p[1]}};
  else
    return lanes<Pair>::load(p);
}
IRG_INLINE constexpr void store_pair(double* p, const plain_pair& v) noexcept { p[0] = v.at[0], p[1] = v.at[1]; }
IRG_INLINE void store_pair(double* p, const walk_pair& v) noexcept { lanes<walk_pair>::store(p, v); }
// The first or the second numbers of both.
IRG_INLINE constexpr plain_pair firsts(const plain_pair& a, const plain_pair& b) noexcept {
  return {{a.at[0], b.at[0]}};
}
IRG_INLINE constexpr plain_pair seconds(const plain_pair& a, const plain_pair& b) noexcept {
  return {{a.at[1], b.at[1]}};
}
IRG_INLINE walk_pair firsts(const walk_pair& a, const walk_pair& b) noexcept { return shuffled<0, 2>(a, b); }
IRG_INLINE walk_pair seconds(const walk_pair& a, const walk_pair& b) noexcept { return shuffled<1, 3>(a, b); }
// x, without a sign when it is zero, and y.
IRG_INLINE constexpr plain_pair corner_of(const plain_pair& x, double y) noexcept { return {{x.at[0] + 0.0, y}}; }
IRG_INLINE walk_pair corner_of(const walk_pair& x, double y) noexcept { return pack_of((x + walk_pair{})[0], y); }

// A window as the walk needs it: its corners' numbers; of the other axis in each lane, its bounds. With r the sum of
// the magnitudes of the polygon's coordinates, a guess is within 2^-48 r of the crossing, a refined one within 2^-97 r.
// What is no nearer to a boundary than `tolerance` is told to be on a side of it by guesses, which are known early (of
// floats, by rounded crossings), and its differences are so large that no underflow counts.
template <class Pair>
struct walked_window {
  double corners[8];
  Pair low, high;
  double tolerance, error;
};

// Where an edge crosses a boundary of x, as y in lane 0, and one of y, as x in lane 1. The y_place of the former; a bit
// for each lane that is delicate.
template <class Pair>
struct edge_crossings {
  Pair at;
  unsigned place, delicate;
};

// The number to which both ends of the interval around guess + correction are rounded; the numbers are floats.
template <class T>
IRG_INLINE constexpr bool rounds_to(double guess, double correction, double error, double& rounded) noexcept {
  if constexpr (std::is_same_v<T, float>) {
    const float low = converted<float>(guess - error), high = converted<float>(guess + error);
    rounded = widened(converted<float>(guess + 0.0));
    return low == high;
  } else {
    rounded = guess + correction;
    return guess + (correction - error) == guess + (correction + error);
  }
}

// By numbers, for lanes that are needed.
template <class T>
constexpr edge_crossings<plain_pair> cross_edge(const double* edge, const plain_pair& bounds, const plain_pair& last,
                                                const walked_window<plain_pair>& w, unsigned needed) noexcept {
  edge_crossings<plain_pair> found{{{0, 0}}, 0, 0};
  for (unsigned k = 0; k < 2; ++k) {
    if ((needed >> k & 1) == 0) continue;
    const double ax = edge[k], ay = edge[1 - k], bx = edge[2 + k], by = edge[3 - k], x = bounds.at[k];
    const unsigned bit = 1u << k;
    found.delicate |= bit;
    if (!(lesser(magnitude(x - ax), magnitude(bx - x)) > w.tolerance)) continue;
    const auto parts =
        refined_crossing(ay, parts_of_difference(bx, ax), parts_of_difference(by, ay), parts_of_difference(x, ax));
    const bool rounds = rounds_to<T>(parts.guess, parts.correction, w.error, found.at.at[k]) || ay == by;
    const double place = std::is_same_v<T, float> ? found.at.at[k] : parts.guess;
    const double below = place - w.low.at[k], above = w.high.at[k] - place, inner = lesser(below, above);
    const bool again = x == last.at[k] && found.at.at[k] == last.at[1 - k];
    if (k == 0) found.place = (below < 0 ? 1u : 0u) | (above < 0 ? 2u : 0u);
    if (rounds && !again && magnitude(inner) > w.tolerance) found.delicate ^= bit;
  }
  return found;
}

template <class T>
IRG_INLINE edge_crossings<walk_pair> cross_edge(const double* edge, const walk_pair& bounds, const walk_pair& last,
                                                const walked_window<walk_pair>& w, unsigned) noexcept {
  using L = lanes<walk_pair>;
  const walk_pair a = L::load(edge), b = L::load(edge + 2), y = swapped(a);
  const auto dx = parts_of_difference(b, a), s = parts_of_difference(bounds, a);
  const two_parts<walk_pair> dy{swapped(dx.value), swapped(dx.error)};
  const auto parts = refined_crossing(y, dx, dy, s);
  edge_crossings<walk_pair> found;
  walk_pair place = parts.guess;
  L::mask rounds{};
  if constexpr (std::is_same_v<T, float>) {
    double at[2];
    for (int k = 0; k < 2; ++k) set_lane(rounds, k, rounds_to<T>(parts.guess[k], 0, w.error, at[k]) ? -1 : 0);
    found.at = place = L::load(at);
  } else {
    const walk_pair error = L::broadcast(w.error);
    found.at = parts.guess + parts.correction;
    rounds = parts.guess + (parts.correction - error) == parts.guess + (parts.correction + error);
  }
  const walk_pair below = place - w.low, above = w.high - place, inner = low_of(below, above);
  const walk_pair nearest = low_of(low_of(magnitude(s.value), magnitude(b - bounds)), magnitude(inner));
  const auto level = dy.value == walk_pair{}, clear = L::broadcast(w.tolerance) < nearest;
  const auto again = (bounds == last) & (found.at == swapped(last));
  found.place = sign_bits(firsts(below, above));
  found.delicate = ~mask_bits(~again & clear & (rounds | level));
  return found;
}

// Copies points; three more are written behind them, and read, at run time.
template <class Pair>
IRG_INLINE constexpr void copy_points(const double* from, double* to, std::size_t numbers) noexcept {
  if constexpr (std::is_same_v<Pair, plain_pair>) {
    for (std::size_t i = 0; i < numbers; ++i) to[i] = from[i];
  } else {
    // Most runs are of four points or fewer. One by one: a wider load would wait for what was just stored.
    std::size_t i = 0;
    do {
      Pair p[4];
      for (std::size_t k = 0; k < 4; ++k) p[k] = opaque(lanes<Pair>::load(from + i + 2 * k));
      for (std::size_t k = 0; k < 4; ++k) lanes<Pair>::store(to + i + 2 * k, p[k]);
      i += 8;
    } while (i < numbers);
  }
}

// Writes the polygon's part in the window to `out`, which has room for so many points; their number, or is_delicate,
// also when four points more would not fit.
template <class T, class Pair>
IRG_INLINE constexpr std::ptrdiff_t walk_window(const coded_ring& ring, const box<T, 2>& window, double* const out,
                                                std::size_t room) noexcept {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto wide = [](T x) { return widened(x); };
  const double lx = wide(window.low.x), ly = wide(window.low.y), hx = wide(window.high.x), hy = wide(window.high.y);
  walked_window<Pair> w{{lx, ly, hx, ly, lx, hy, hx, hy},
                        pair_of<Pair>(ly, lx),
                        pair_of<Pair>(hy, hx),
                        ring.reach * 0x1p-45,
                        ring.reach * (std::is_same_v<T, float> ? 0x1p-48 : 0x1p-96)};
  const auto first_code = static_cast<unsigned>(ring.words[0] & 15);
  const bool starts_outside = (first_code & axis_bits<0>) != 0;
  constexpr unsigned unknown = 4 * static_cast<unsigned>(y_place::unknown);
  unsigned place = starts_outside ? unknown : 0, first_cut = 0, delicate = 0;
  const std::size_t end = 2 * room;
  std::size_t to = 0, run = 0;  // numbers written; the first one in the ring that is not copied yet
  Pair last = pair_of<Pair>(infinite, infinite);
  const auto copy_run = [&](std::size_t stop, std::size_t mask) {
    const std::size_t numbers = (stop - run) & mask;
    if (to + numbers + 8 > end) return false;
    copy_points<Pair>(ring.at + run, out + to, numbers);
    to += numbers, run = stop;
    return true;
  };
  for (std::size_t first = 0; first < ring.count; first += codes_per_word) {
    const std::size_t left = ring.count - first, here = left < codes_per_word ? left : codes_per_word;
    // Codes of the edges' first and second ends; those that pass a boundary of x, or one of y within in x.
    const std::uint64_t* const word = ring.words + first / codes_per_word;
    const std::uint64_t from = word[0], next = left > here ? word[1] & 15 : first_code;
    const std::uint64_t upto = from >> 4 | next << (4 * (here - 1)), changes = from ^ upto;
    const std::uint64_t by_axis = changes | changes >> 2, beyond = from | from >> 2;
    std::uint64_t edges = (by_axis | (by_axis >> 1 & ~beyond)) & (0x1111111111111111u >> (64 - 4 * here));
    // One loop, also for what is taken again: what two loops would share would have to be kept in memory.
    for (std::size_t second = 0; edges != 0;) {
      const auto at = static_cast<unsigned>(std::countr_zero(edges));
      const std::size_t key = second | (from >> at & 15) | (upto >> at & 15) << 4, edge = 2 * first + at / 2;
      const edge_kind& kind = edge_kinds[key];
      if (!copy_run(edge + 2, static_cast<std::size_t>(std::ptrdiff_t{kind.starts_within}))) return is_delicate;
      const Pair bounds = load_pair<Pair>(w.corners + kind.bounds);
      const auto cuts = cross_edge<T>(ring.at + edge, bounds, last, w, kind.needed);
      delicate |= cuts.delicate & kind.needed;
      const edge_output& output = edge_outputs[kind.row + place + cuts.place];
      first_cut = place == unknown ? cuts.place : first_cut;
      place = output.place;
      store_pair(out + to, corner_of(bounds, w.corners[output.corner]));
      second = 0;
      std::uint64_t later = edges & (edges - 1);
      if (output.rare != 0) [[unlikely]] {
        if ((output.rare & gives_up) != 0 || to + 16 > end) return is_delicate;
        if ((output.rare & has_two_corners) != 0)
          store_pair(out + to + 2, corner_of(bounds, w.corners[output.second_corner]));
        if ((output.rare & takes_again) != 0) second = 256, later = edges;
      }
      edges = later;
      store_pair(out + to + output.cut_x, firsts(bounds, cuts.at));
      store_pair(out + to + output.cut_y, seconds(cuts.at, bounds));
      to += output.advance;
      last = load_pair<Pair>(out + (to == 0 ? 0 : to - 2));
    }
  }
  const std::size_t n = ring.count - 1;
  const bool ends_within = (ring.words[n / codes_per_word] >> (4 * (n % codes_per_word)) & 15) == 0;
  if (!copy_run(2 * ring.count, std::size_t{0} - static_cast<std::size_t>(ends_within)) || delicate != 0)
    return is_delicate;
  if (starts_outside) {
    const Pair x = load_pair<Pair>(w.corners + ((first_code & 4) != 0 ? 2 : 0));
    const edge_output& output = edge_outputs[row_of(edge_role::closes) + place + first_cut];
    if ((output.rare & gives_up) != 0) return is_delicate;
    store_pair(out + to, corner_of(x, w.corners[output.corner]));
    store_pair(out + to + 2, corner_of(x, w.corners[output.second_corner]));
    to += output.advance;
  }
  while (to > 2 && out[to - 2] == out[0] && out[to - 1] == out[1]) to -= 2;
  return to < 6 ? 0 : static_cast<std::ptrdiff_t>(to / 2);
}

template <class T>
IRG_INLINE constexpr std::ptrdiff_t walk_ring(const coded_ring& ring, const box<T, 2>& window, double* out,
                                              std::size_t room) noexcept {
  // Nothing overflows, nor do the ends of an interval around a float.
  if (!(ring.reach > 0x1p-300 && ring.reach < (std::is_same_v<T, float> ? 0x1p120 : 0x1p200))) return is_delicate;
  if (ring.all != 0) return 0;
  return std::is_constant_evaluated() ? walk_window<T, plain_pair>(ring, window, out, room)
                                      : walk_window<T, walk_pair>(ring, window, out, room);
}

// The part of a polygon of three to few_vertices points in a window that is not empty: the number of its vertices, of
// which as many are written as fit; or is_delicate.
template <Point P, class T>
IRG_INLINE constexpr std::ptrdiff_t clip_few(std::span<const P> polygon, const box<T, 2>& window,
                                             std::span<P> out) noexcept {
  coded_ring ring;
  find_window_codes(polygon.data(), polygon.size(), window, ring);
  constexpr std::size_t most = 2 * few_vertices + 8;
  double made[2 * most];
  double* to = made;
  std::size_t room = most;
  if constexpr (std::is_same_v<P, point<double, 2>>)
    if (!std::is_constant_evaluated() && out.size() >= polygon.size() + 12)
      to = reinterpret_cast<double*>(out.data()), room = out.size();
  const std::ptrdiff_t count = walk_ring(ring, window, to, room);
  if (to == made)
    for (std::size_t i = 0; i < out.size() && static_cast<std::ptrdiff_t>(i) < count; ++i)
      out[i] = from_coordinates<P>(converted<T>(made[2 * i]), converted<T>(made[2 * i + 1]));
  return count;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
