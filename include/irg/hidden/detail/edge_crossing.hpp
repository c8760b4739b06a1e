// SPDX-License-Identifier: MIT
// Where along an edge a face begins or ceases to hide it, exactly. Each function that decides is linear along the edge:
// the three edge functions of the face, and the nearness of its plane over that of the edge. With the values f and g of
// one at the two ends, it changes its sign at f / (f - g) of the way, a ratio of integers; ratios are compared as
// doubles where these are far apart, else by the integers. Nothing is rounded before a place is given out.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/math/float_bits.hpp>
#include <irg/raster/face_order.hpp>

namespace irg::detail::inline IRG_ABI {

// A face that hides what is behind it: clockwise on the screen (y down), depths such that the greater is the nearer.
struct hiding_face {
  subpixel p[3];
  float depth[3];
  friend constexpr bool operator==(const hiding_face&, const hiding_face&) = default;
};

// An edge, its depths likewise.
struct hidden_edge {
  subpixel p[2];
  float depth[2];
};

// Functions below are templates of faces and edges, though there is one type of each: only their callers compile them.

// Which function changes its sign at a place: one of the sides of a face, the nearness of its plane; or an end.
enum class crossing_kind : std::uint8_t { side_0, side_1, side_2, plane, start, end };

// A place along an edge: `rounded` is within 2^-50 of it.
struct edge_crossing {
  crossing_kind kind = crossing_kind::start;
  const hiding_face* face = nullptr;
  double rounded = 0.0;
};
inline constexpr edge_crossing edge_start{crossing_kind::start, nullptr, 0.0};
inline constexpr edge_crossing edge_finish{crossing_kind::end, nullptr, 1.0};

// A place as numerator / denominator in N words: 0 <= numerator <= denominator, 0 < denominator.
template <int N>
struct place_ratio {
  wide_int<N> numerator, denominator;
};

// The edge function of side i of a face: positive inside. At most 2^60 in size.
template <class Face>
IRG_INLINE constexpr std::int64_t side_at(const Face& f, int i, const subpixel& p) noexcept {
  return twice_signed_area(f.p[i], f.p[i == 2 ? 0 : i + 1], p);
}

// How much nearer the plane of a face is than a depth d at p, times twice its area: E1 d0 + E2 d1 + E0 d2 - A d.
template <class Weight, class Depth>
IRG_INLINE constexpr auto weighted_nearness(const Weight (&w)[4], const Depth (&d)[4]) noexcept {
  return w[0] * d[0] + w[1] * d[1] + (w[2] * d[2] - w[3] * d[3]);
}
struct nearness_terms {
  std::int64_t weight[4];
  float depth[4];
};
template <class Face, class Edge>
IRG_INLINE constexpr nearness_terms nearness_at(const Face& f, const Edge& e, int end) noexcept {
  const std::int64_t w0 = side_at(f, 1, e.p[end]), w1 = side_at(f, 2, e.p[end]), w2 = side_at(f, 0, e.p[end]);
  return {{w0, w1, w2, w0 + w1 + w2}, {f.depth[0], f.depth[1], f.depth[2], e.depth[end]}};
}

// The powers of two between which the depths of a face and an edge lie, as depth_comparison has them.
struct depth_places {
  int lowest = 254, highest = 0;
};
template <class Face, class Edge>
constexpr depth_places places_of(const Face& f, const Edge& e) noexcept {
  depth_places places;
  const auto take = [&](float d) {
    const integer_parts<float> x = integer_parts_of(d);
    if (x.significand == 0) return;
    places.lowest = minimum(places.lowest, x.place);
    places.highest = maximum(places.highest, x.place);
  };
  for (const float d : f.depth) take(d);
  for (const float d : e.depth) take(d);
  return places;
}
// Whether depths as integers fit in one word: then they are below 2^61, and nearness, of weights up to 2^60 each, is
// below 2^123 and fits in two words. Depths of all sizes take five words, below 2^278, and nearness six.
template <class Places>
constexpr bool depths_are_short(const Places& p) noexcept {
  return p.highest - p.lowest <= 37;
}

template <int N, class Terms>
constexpr wide_int<N + 1> exact_nearness(const Terms& t, int lowest) noexcept {
  wide_int<1> weight[4];
  wide_int<N> depth[4];
  for (int i = 0; i < 4; ++i) {
    weight[i] = t.weight[i];
    depth[i] = depth_as_integer<N>(t.depth[i], lowest);
  }
  return weighted_nearness(weight, depth);
}

// The sign of the nearness, 2 where doubles cannot tell. A term passes at most six roundings (two conversions, the sum
// of the weights is exact; a product, three sums), which 2^-50 of the sum of their sizes covers, as the 2^-70 added to
// the depths covers subnormal ones that are taken for zero.
template <class Terms>
IRG_INLINE constexpr int rounded_nearness(const Terms& t) noexcept {
  double weight[4], depth[4], size = 0;
  for (int i = 0; i < 4; ++i) {
    weight[i] = static_cast<double>(t.weight[i]);
    depth[i] = widened(t.depth[i]);
    size += (weight[i] < 0 ? -weight[i] : weight[i]) * ((depth[i] < 0 ? -depth[i] : depth[i]) + 0x1p-70);
  }
  const double value = weighted_nearness(weight, depth), bound = size * 0x1p-50;
  return value > bound ? 1 : value < -bound ? -1 : 2;
}
template <class Face, class Edge>
IRG_NOINLINE constexpr int exact_nearness_sign(const Face& f, const Edge& e, int end) noexcept {
  const depth_places places = places_of(f, e);
  const nearness_terms t = nearness_at(f, e, end);
  return depths_are_short(places) ? exact_nearness<1>(t, places.lowest).sign()
                                  : exact_nearness<5>(t, places.lowest).sign();
}

// 1 where the plane of the face is nearer than the edge at its start (0) or end (1), -1 where it is farther.
template <class Face, class Edge>
IRG_INLINE constexpr int nearness_sign(const Face& f, const Edge& e, int end) noexcept {
  for (int i = 0; i < 3; ++i)  // edges of the face itself, and of its neighbours
    if (f.p[i] == e.p[end] && f.depth[i] == e.depth[end]) return 0;
  const int sign = rounded_nearness(nearness_at(f, e, end));
  return sign != 2 ? sign : exact_nearness_sign(f, e, end);
}

// f / (f - g), where f and g differ in sign.
template <int N>
constexpr place_ratio<N> ratio_between(const wide_int<N>& f, const wide_int<N>& g) noexcept {
  return f.is_negative() ? place_ratio<N>{-f, g - f} : place_ratio<N>{f, f - g};
}

// The place of a crossing in N words: 1 where it lies on a side, 2 where depths are short, 6 always.
template <int N, class Edge>
constexpr place_ratio<N> ratio_of(const edge_crossing& c, const Edge& e, int lowest) noexcept {
  if (c.kind == crossing_kind::start) return {0, 1};
  if (c.kind == crossing_kind::end) return {1, 1};
  if (c.kind != crossing_kind::plane) {
    const int side = static_cast<int>(c.kind);
    return ratio_between(wide_int<N>(side_at(*c.face, side, e.p[0])), wide_int<N>(side_at(*c.face, side, e.p[1])));
  }
  if constexpr (N == 1)
    return {0, 1};
  else
    return ratio_between(exact_nearness<N - 1>(nearness_at(*c.face, e, 0), lowest),
                         exact_nearness<N - 1>(nearness_at(*c.face, e, 1), lowest));
}

// Calls f(words, lowest) with the words that the crossing's ratio takes.
template <class Edge, class F>
constexpr auto with_words(const edge_crossing& c, const Edge& e, const F& f) noexcept {
  if (c.kind != crossing_kind::plane) return f(std::integral_constant<int, 1>(), 0);
  const depth_places places = places_of(*c.face, e);
  if (depths_are_short(places)) return f(std::integral_constant<int, 2>(), places.lowest);
  return f(std::integral_constant<int, 6>(), places.lowest);
}

template <class Edge>
IRG_NOINLINE constexpr int compare_exactly(const edge_crossing& a, const edge_crossing& b, const Edge& e) noexcept {
  return with_words(a, e, [&](auto a_words, int a_lowest) {
    const auto p = ratio_of<a_words.value>(a, e, a_lowest);
    return with_words(b, e, [&](auto b_words, int b_lowest) {
      const auto q = ratio_of<b_words.value>(b, e, b_lowest);
      return (p.numerator * q.denominator - q.numerator * p.denominator).sign();
    });
  });
}

// -1 where place a comes before b on the edge, 1 where it comes after, 0 where they are one.
template <class Edge>
IRG_INLINE constexpr int compare_places(const edge_crossing& a, const edge_crossing& b, const Edge& e) noexcept {
  if (a.rounded < b.rounded - 0x1p-48) return -1;
  if (b.rounded < a.rounded - 0x1p-48) return 1;
  return a.kind == b.kind && a.face == b.face ? 0 : compare_exactly(a, b, e);
}

// A ratio as a double, within 2^-51: of both numbers the 62 leading bits of the denominator's are taken.
template <int N>
constexpr double rounded_ratio(const place_ratio<N>& r) noexcept {
  int top = N - 1;
  while (top > 0 && r.denominator.word[top] == 0) --top;
  const int drop = minimum(static_cast<int>(std::countl_zero(r.denominator.word[top])), 62) - 2;
  const auto leading = [&](const wide_int<N>& v) {
    if (drop < 0) return v.word[top] >> -drop;
    if (top == 0) return v.word[0];
    return drop == 0 ? v.word[top] : v.word[top] << drop | v.word[top - 1] >> (64 - drop);
  };
  return static_cast<double>(static_cast<std::int64_t>(leading(r.numerator))) /
         static_cast<double>(static_cast<std::int64_t>(leading(r.denominator)));
}

// The crossing where a face's side, or its plane, meets the edge.
template <class Face>
IRG_INLINE constexpr edge_crossing side_crossing(const Face& f, int side, std::int64_t at_start,
                                                 std::int64_t at_end) noexcept {
  return {static_cast<crossing_kind>(side), &f, static_cast<double>(at_start) / static_cast<double>(at_start - at_end)};
}
template <class Face, class Edge>
constexpr edge_crossing plane_crossing(const Face& f, const Edge& e) noexcept {
  edge_crossing c{crossing_kind::plane, &f, 0.0};
  c.rounded =
      with_words(c, e, [&](auto words, int lowest) { return rounded_ratio(ratio_of<words.value>(c, e, lowest)); });
  return c;
}

// The place in multiples of 2^-53, the nearest one: the same for each way to write one ratio.
template <class Edge>
constexpr double place_of(const edge_crossing& c, const Edge& e) noexcept {
  return with_words(c, e, [&](auto words, int lowest) {
    const auto r = ratio_of<words.value>(c, e, lowest);
    auto rest = r.numerator;
    if (rest == r.denominator) return 1.0;
    std::int64_t digits = 0;
    for (int bit = 0; bit < 54; ++bit) {  // long division; denominators leave their two top bits free
      rest += rest;
      const bool one = !(rest < r.denominator);
      if (one) rest -= r.denominator;
      digits = 2 * digits + (one ? 1 : 0);
    }
    const std::int64_t rounded = (digits + 1) / 2;
    return static_cast<double>(rounded) * 0x1p-53;
  });
}

}  // namespace irg::detail::inline IRG_ABI
