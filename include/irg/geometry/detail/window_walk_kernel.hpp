// SPDX-License-Identifier: MIT
// Polygons of few plain points against a window: one walk from edge to edge that passes over a boundary; vertices
// between are copied. The result is that of window_pipe, in a fraction of its time. What is delicate only has to be
// noticed: a vertex on or next to a boundary that its edge crosses, a cut next to a corner of the window, two cuts at
// one place, a cut that is hard to round. The pipe does it then.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/lanes.hpp>
#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/crossing_kernel.hpp>

namespace irg::detail {

// The codes of points against a window: one bit for each boundary that a point is beyond. Those of a whole polygon are
// packed into words, four bits a vertex, so that its passages over boundaries are found by a few operations on words.

// Bits of a code, by axis: below the window in bits 0 and 1, above it in bits 2 and 3.
template <int Axis>
inline constexpr unsigned axis_bits = 5u << Axis;

// The longest polygon that is clipped by way of words, and how many codes a word holds.
inline constexpr std::size_t few_vertices = 64, codes_per_word = 16;

// A polygon on the stack: its vertices as doubles, the first one again behind the last, and room for reading on; their
// codes; the bits that all codes have; the sum of all magnitudes, infinite when one of them is 2^200 or beyond. Not
// initialised on purpose.
struct coded_ring {
  double at[2 * (few_vertices + 4)];
  std::uint64_t words[few_vertices / codes_per_word + 1];
  std::size_t count;
  unsigned all;
  double reach;
};

inline namespace IRG_ABI {

// A NaN is beyond both boundaries of its axis.
template <class V, class T>
IRG_INLINE constexpr unsigned window_code(const V& v, const box<T, 2>& w) noexcept {
  unsigned code = 0;
  for (int i = 0; i < 2; ++i) {
    const T x = coordinate(position_of(v), i);
    bool below = x < w.low[i], above = w.high[i] < x;
    if constexpr (Floating<T>) {
      below = !(w.low[i] <= x);
      above = !(x <= w.high[i]);
    }
    code |= (static_cast<unsigned>(below) | static_cast<unsigned>(above) << 2) << i;
  }
  return code;
}

// Words of codes, from code(i) for vertices i, i + 1, ... i + Step - 1 where n is a multiple of Step.
template <unsigned Step, class Code>
IRG_INLINE constexpr void pack_codes(std::size_t n, std::uint64_t* words, const Code& code) noexcept {
  for (std::size_t i = 0;;) {
    std::uint64_t word = 0;
    unsigned shift = 0;
    for (; shift < 64 && i < n; shift += 4 * Step, i += Step) word |= std::uint64_t{code(i)} << shift;
    *words++ = word;
    if (shift < 64) return;
  }
}

template <Point P, class T>
constexpr void code_ring_plainly(const P* points, std::size_t n, const box<T, 2>& w, coded_ring& ring) noexcept {
  ring.reach = 0, ring.all = 15;
  pack_codes<1>(n, ring.words, [&](std::size_t i) {
    for (int k = 0; k < 2; ++k) {
      const double x = widened(coordinate(points[i], k));
      ring.at[2 * i + static_cast<std::size_t>(k)] = x;
      ring.reach = magnitude(x) < 0x1p200 ? ring.reach + magnitude(x) : std::numeric_limits<double>::infinity();
    }
    const unsigned code = window_code(points[i], w);
    ring.all &= code;
    return code;
  });
}

// The codes of N / 2 vertices, four bits each: which coordinates are below the window, then which are above.
template <int N>
IRG_INLINE unsigned codes_of_lanes(const pack<double, N>& p, const pack<double, N>& low,
                                   const pack<double, N>& high) noexcept {
  const auto words = [](const auto& mask) { return bits_as<float>(mask); };
  const auto below = words(not_at_most(low, p)), above = words(not_at_most(p, high));
  if constexpr (N == 2)
    return sign_bits(shuffled<0, 2, 4, 6>(below, above));
  else
    return sign_bits(shuffled<0, 2, 8, 10, 4, 6, 12, 14>(below, above));
}

// One vertex, or two where registers hold as many, at once. A register is stored by halves, as it will be read.
template <class T = double>
IRG_INLINE void code_ring(const point<double, 2>* points, std::size_t n, const box<double, 2>& w,
                          coded_ring& ring) noexcept {
  using two = pack<double, 2>;
  using four = pack<double, 4>;
  const two low = pack_of(w.low.x, w.low.y), high = pack_of(w.high.x, w.high.y);
  two reach{};
  unsigned all = 255;
  const auto code_one = [&](std::size_t i) {
    const two p = lanes<two>::load_bytes(points + i);
    lanes<two>::store(ring.at + 2 * i, p);
    reach = reach + magnitude(p);
    const unsigned code = codes_of_lanes(p, low, high);
    all &= code;
    return code;
  };
  if constexpr (native_lanes<double> >= 4) {
    const four low2 = repeated<4>(low), high2 = repeated<4>(high);
    four reach2{};
    const std::size_t even = n & ~std::size_t{1};
    pack_codes<2>(even, ring.words, [&](std::size_t i) {
      const four p = lanes<four>::load_bytes(points + i);
      lanes<two>::store(ring.at + 2 * i, low_half(p));
      lanes<two>::store(ring.at + 2 * i + 2, high_half(p));
      reach2 = reach2 + magnitude(p);
      const unsigned codes = codes_of_lanes(p, low2, high2);
      all &= codes;
      return codes;
    });
    all &= all >> 4;
    reach = low_half(reach2) + high_half(reach2);
    if (even < n) ring.words[even / codes_per_word] |= std::uint64_t{code_one(even)} << (4 * (even % codes_per_word));
  } else {
    pack_codes<1>(n, ring.words, code_one);
  }
  ring.all = all & 15;
  ring.reach = reach[0] + reach[1];
}

// The ring of n points, 3 <= n <= few_vertices.
template <Point P, class T>
IRG_INLINE constexpr void find_window_codes(const P* points, std::size_t n, const box<T, 2>& w,
                                            coded_ring& ring) noexcept {
  ring.count = n;
  if constexpr (std::is_same_v<P, point<double, 2>>)
    if (!std::is_constant_evaluated()) {
      code_ring(points, n, w, ring);
      std::memcpy(ring.at + 2 * n, points, sizeof(P));
      return;
    }
  code_ring_plainly(points, n, w, ring);
  ring.at[2 * n] = ring.at[0], ring.at[2 * n + 1] = ring.at[1];
}

}  // namespace IRG_ABI
// What to do with an edge of a polygon at a window: two tables that stand for the decisions of window_pipe's two
// stages, so that a walk along the polygon needs no branch that could not be foretold.
//
// The first stage, x, leaves the edge's part between the window's left and right boundary, and joins where the polygon
// went out to where it comes in again; the second stage, y, cuts what the first one leaves. An edge is cut at one
// boundary of each axis at a time: one that passes both boundaries of an axis is taken twice. One that is cut three
// times or more is left to the pipe.

// Where a vertex of the first stage lies in y: a bit for each boundary that it is beyond. The bit after_corner is added
// where the result ends at a corner of the window.
enum class y_place : std::uint8_t { within = 0, below = 1, above = 2, unknown = 3 };
inline constexpr unsigned after_corner = 4;

// What an edge does in x, and where its end that is within in x lies in y.
enum class edge_role : std::uint8_t {
  stays,  // within in x: only y is cut
  stays_first,  // passes both boundaries of y: where it passes the first one; then it stays
  leaves,  // goes out from a vertex within,
  leaves_below,
  leaves_above,
  enters,  // comes in to a vertex within,
  enters_below,
  enters_above,
  passes_in,  // passes both boundaries of x: where it comes in,
  passes_out,  // and where it goes out
  closes,  // no edge: joins the last vertex of the first stage to its first
  left_to_pipe  // passes both boundaries of either axis, or is no edge between numbers
};

// By the codes of the edge's ends. `bounds` is where the corner of the boundaries that it is cut at stands among the
// window's {low, low}, {high, low}, {low, high}, {high, high}, counted in numbers; `needed` has bit 0 set for a cut in
// x, bit 1 for one in y; `row` is the role's first entry in the table of outputs; `starts_within` is -1 where the first
// end is in the window, else 0.
struct alignas(8) edge_kind {
  std::uint8_t bounds, needed;
  std::uint16_t row;
  std::int8_t starts_within;
};

// By role, place of the stage's last vertex and place of the cut in x. Places behind the result are counted in numbers;
// what is not to be written goes behind what is.
struct IRG_APART alignas(8) edge_output {
  std::uint8_t corner, second_corner;  // where their y stands among the corners' numbers
  std::uint8_t cut_x, cut_y;  // where the cuts go
  std::uint8_t advance;  // the numbers that were written
  std::uint8_t place;  // four times that of the last vertex, from now on
  std::uint8_t rare;  // what seldom has to be done
};
inline constexpr unsigned takes_again = 1, has_two_corners = 2, gives_up = 4, outputs_per_role = 32;

IRG_APART constexpr std::uint16_t row_of(edge_role role) noexcept {
  return static_cast<std::uint16_t>(outputs_per_role * static_cast<unsigned>(role));
}

IRG_APART constexpr edge_kind kind_of_edge(unsigned from, unsigned to, bool second) noexcept {
  using enum edge_role;
  const unsigned xa = from & 5, xb = to & 5, ya = from >> 1 & 5, yb = to >> 1 & 5;
  edge_kind kind{0, 0, row_of(left_to_pipe), static_cast<std::int8_t>(from == 0 ? -1 : 0)};
  const bool are_numbers = xa != 5 && xb != 5 && ya != 5 && yb != 5;
  const bool passes_x = xa != xb && xa != 0 && xb != 0, passes_y = ya != yb && ya != 0 && yb != 0;
  if (!are_numbers || (passes_x && passes_y)) return kind;
  const bool leaves_x = xa == 0 && xb != 0;
  const unsigned x = !passes_x ? xa | xb : second ? xb : xa, from_y = leaves_x ? ya : yb;
  // Where both boundaries of y are passed, the one next to the end that is within in x is cut at first.
  const unsigned y = !passes_y ? ya | yb : xa != xb ? from_y : second ? yb : ya;
  kind.bounds = static_cast<std::uint8_t>((x == 4 ? 2 : 0) + (y == 4 ? 4 : 0));
  kind.needed = static_cast<std::uint8_t>((xa != xb ? 1 : 0) + (ya != yb ? 2 : 0));
  if (xa == xb)
    kind.row = row_of(passes_y && !second ? stays_first : stays);
  else if (passes_x)
    kind.row = row_of(second ? passes_out : passes_in);
  else if (leaves_x)
    kind.row = row_of(from_y == 0 ? leaves : from_y == 1 ? leaves_below : leaves_above);
  else
    kind.row = row_of(from_y == 0 ? enters : from_y == 1 ? enters_below : enters_above);
  return kind;
}

IRG_APART constexpr edge_output output_of_edge(edge_role role, y_place last, bool at_corner, y_place cut) noexcept {
  using enum edge_role;
  const auto y_of = [](y_place at) { return static_cast<std::uint8_t>(at == y_place::above ? 5 : 1); };
  constexpr std::uint8_t behind = 6;
  const auto place = [](y_place at) { return static_cast<std::uint8_t>(4 * static_cast<unsigned>(at)); };
  edge_output to{1, 1, behind, behind, 0, place(cut), 0};
  const auto next = [&] {
    return static_cast<std::uint8_t>((to.advance = static_cast<std::uint8_t>(to.advance + 2)) - 2);
  };
  if (role == left_to_pipe) to.rare = gives_up;
  if (role == stays_first) to.rare = takes_again;
  if (role == stays || role == stays_first) {
    to.cut_y = next();
    to.place = place(last);
  }
  if (role == left_to_pipe || role == stays || role == stays_first || cut == y_place::unknown) return to;
  const bool leaves_x = role == leaves || role == leaves_below || role == leaves_above || role == passes_out;
  if (!leaves_x && last != y_place::unknown && last != cut) {  // along the boundary, around the window's corners
    if (last != y_place::within) {
      to.corner = y_of(last);
      next();
    }
    if (cut != y_place::within) {
      if (to.advance != 0) to.rare = has_two_corners;
      (to.advance != 0 ? to.second_corner : to.corner) = y_of(cut), next();
    }
    if (at_corner) to.rare |= gives_up;  // perhaps the same corner
    at_corner = true;
  }
  const std::uint8_t at_corners = to.advance;
  if (role == passes_in) to.rare |= takes_again;
  const y_place other = role == leaves || role == enters               ? y_place::within
                        : role == leaves_below || role == enters_below ? y_place::below
                        : role == leaves_above || role == enters_above ? y_place::above
                        : role == passes_out                           ? last
                                                                       : cut;
  const bool within = cut == y_place::within, cuts_y = other != cut;
  if (cuts_y && !within && other != y_place::within) to.rare |= gives_up;  // cut twice in y
  if (cuts_y && leaves_x) to.cut_y = next();
  if (within && role != closes) to.cut_x = next();
  if (cuts_y && !leaves_x) to.cut_y = next();
  if (at_corner && to.advance == at_corners) to.place |= 4 * after_corner;
  return to;
}

// By the code of the edge's first end, and 16 times that of its second one; 256 on for an edge that is taken again.
inline constexpr auto edge_kinds = [] {
  std::array<edge_kind, 512> all{};
  for (unsigned key = 0; key < 512; ++key) all[key] = kind_of_edge(key & 15, key >> 4 & 15, key >= 256);
  return all;
}();

// By role, four times the last place, after_corner among it, and the cut's.
inline constexpr auto edge_outputs = [] {
  std::array<edge_output, outputs_per_role*(static_cast<unsigned>(edge_role::left_to_pipe) + 1)> all{};
  for (unsigned i = 0; i < all.size(); ++i)
    all[i] = output_of_edge(static_cast<edge_role>(i / outputs_per_role), static_cast<y_place>(i / 4 % 4),
                            (i / 4 & after_corner) != 0, static_cast<y_place>(i % 4));
  return all;
}();

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
    if (!(minimum(magnitude(x - ax), magnitude(bx - x)) > w.tolerance)) continue;
    const auto parts =
        refined_crossing(ay, parts_of_difference(bx, ax), parts_of_difference(by, ay), parts_of_difference(x, ax));
    const bool rounds = rounds_to<T>(parts.guess, parts.correction, w.error, found.at.at[k]) || ay == by;
    const double place = std::is_same_v<T, float> ? found.at.at[k] : parts.guess;
    const double below = place - w.low.at[k], above = w.high.at[k] - place, inner = minimum(below, above);
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
  const walk_pair below = place - w.low, above = w.high - place, inner = minimum(below, above);
  const walk_pair nearest = minimum(minimum(magnitude(s.value), magnitude(b - bounds)), magnitude(inner));
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
        if ((output.rare & takes_again) != 0) {
          second = 256;
          later = edges;
        }
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
