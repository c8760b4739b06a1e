// SPDX-License-Identifier: MIT
// Lines of a picture and the points where two of them meet, exactly: a line is the side of a face, the place where the
// planes of two faces are equally deep, or an upright or level one. Its coefficients are integers of 64, 192 or 448
// bits, so that the sign of a determinant tells on which side of a line a point lies; doubles are asked first.
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include <irg/hidden/detail/edge_crossing.hpp>

namespace irg {
namespace detail {

// side: side `part` of face f; meeting: where faces f and g are equally deep, f being nearer on its positive side.
enum class picture_line_kind : std::uint8_t { upright, level, side, meeting };

// A line a x + b y + c = 0 in units of 1/256 pixel; a, b, c times any positive number, each within 2^-50 of itself.
struct picture_line {
  picture_line_kind kind = picture_line_kind::upright;
  std::uint8_t part = 0;
  std::uint8_t words = 1;  // that its coefficients take
  std::uint32_t f = 0, g = 0;
  std::int32_t at = 0;
  double a = 0, b = 0, c = 0;
};
IRG_APART constexpr bool is_one_line(const picture_line& p, const picture_line& q) noexcept {
  return p.kind == q.kind && p.part == q.part && p.f == q.f && p.g == q.g && p.at == q.at;
}

// Where two lines meet, in units of 1/256 pixel, rounded to 2^-22 of these; whether that is the very point.
struct picture_point {
  std::uint32_t line[2]{};
  double x = 0, y = 0;
  bool is_exact[2]{};
};

template <int N>
struct line_terms {
  wide_int<N> a, b, c;
};

inline namespace IRG_ABI {

template <class Face>
constexpr line_terms<1> side_coefficients(const Face& f, int i) noexcept {
  const subpixel &p = f.p[i], &q = f.p[i == 2 ? 0 : i + 1];
  const std::int64_t a = std::int64_t{p.y} - q.y, b = std::int64_t{q.x} - p.x;
  return {a, b, -(a * p.x + b * p.y)};
}

// The depth of a face's plane times twice its area, depths being integers of N words: a x + b y + c.
template <int N, class Face>
constexpr line_terms<N + 1> plane_coefficients(const Face& f, int lowest) noexcept {
  line_terms<N + 1> plane{};
  for (int i = 0; i < 3; ++i) {
    const float_parts x = parts_of(f.depth[i]);
    if (x.significand == 0) continue;
    const auto weight = side_coefficients(f, i == 2 ? 0 : i + 1);
    const wide_int<N> depth = shifted<N>(x, x.place - lowest);
    plane.a += depth * weight.a;
    plane.b += depth * weight.b;
    plane.c += depth * weight.c;
  }
  return plane;
}

// Depths of one word are below 2^61, so that planes are below 2^123 and what follows is below 2^184; those of five
// words make it 2^401.
template <int N, class Face>
constexpr line_terms<N + 2> meeting_coefficients(const Face& f, const Face& g, int lowest) noexcept {
  const auto p = plane_coefficients<N>(f, lowest), q = plane_coefficients<N>(g, lowest);
  const wide_int<1> p_area = side_at(f, 0, f.p[2]), q_area = side_at(g, 0, g.p[2]);
  return {p.a * q_area - q.a * p_area, p.b * q_area - q.b * p_area, p.c * q_area - q.c * p_area};
}

template <class Face>
constexpr depth_places places_of_both(const Face& f, const Face& g) noexcept {
  const hidden_edge none{};
  const depth_places p = places_of(f, none), q = places_of(g, none);
  return {lesser(p.lowest, q.lowest), greater(p.highest, q.highest)};
}

template <int N, class Face>
constexpr line_terms<N> coefficients_of(std::span<const Face> faces, const picture_line& line) noexcept {
  if (line.kind == picture_line_kind::upright) return {1, 0, -line.at};
  if (line.kind == picture_line_kind::level) return {0, 1, -line.at};
  if constexpr (N > 1) {
    if (line.kind == picture_line_kind::meeting) {
      const Face &f = faces[line.f], &g = faces[line.g];
      return meeting_coefficients<N - 2>(f, g, places_of_both(f, g).lowest);
    }
  }
  const auto c = side_coefficients(faces[line.f], line.part);
  return {c.a, c.b, c.c};
}

template <int N>
constexpr wide_int<N> size_of_integer(const wide_int<N>& v) noexcept {
  return v.is_negative() ? -v : v;
}
// The number divided by 2^(64 top): no word of its size above that is in use.
template <int N>
constexpr double scaled_down(const wide_int<N>& v, int top) noexcept {
  const wide_int<N> size = size_of_integer(v);
  double sum = 0;
  for (int i = 0; i <= top; ++i) sum = sum * 0x1p-64 + static_cast<double>(size.word[i]);  // the last word counts 1
  return v.is_negative() ? -sum : sum;
}

template <int N, class Face>
constexpr void round_line(std::span<const Face> faces, picture_line& line) noexcept {
  const auto e = coefficients_of<N>(faces, line);
  int top = 0;
  for (const wide_int<N>* v : {&e.a, &e.b, &e.c}) {
    const wide_int<N> size = size_of_integer(*v);  // that of -2^64 has a word more than -2^64
    for (int i = 0; i < N; ++i)
      if (size.word[i] != 0) top = greater(top, i);
  }
  line.a = scaled_down(e.a, top);
  line.b = scaled_down(e.b, top);
  line.c = scaled_down(e.c, top);
}

template <class Face>
constexpr picture_line line_of_side(std::span<const Face> faces, std::uint32_t face, int part) noexcept {
  picture_line line{picture_line_kind::side, static_cast<std::uint8_t>(part), 1, face};
  round_line<1>(faces, line);
  return line;
}
template <class Face>
constexpr picture_line meeting_line(std::span<const Face> faces, std::uint32_t f, std::uint32_t g) noexcept {
  const bool is_short = depths_are_short(places_of_both(faces[f], faces[g]));
  picture_line line{picture_line_kind::meeting, 0, static_cast<std::uint8_t>(is_short ? 3 : 7), f, g};
  is_short ? round_line<3>(faces, line) : round_line<7>(faces, line);
  return line;
}
constexpr picture_line line_of_axis(picture_line_kind kind, std::int32_t at) noexcept {
  const bool upright = kind == picture_line_kind::upright;
  return {kind, 0, 1, 0, 0, at, upright ? 1.0 : 0.0, upright ? 0.0 : 1.0, -static_cast<double>(at)};
}

// Calls f(words) with enough of them.
template <class F>
constexpr auto with_line_words(int words, const F& f) noexcept {
  if (words <= 1) return f(std::integral_constant<int, 1>());
  if (words <= 3) return f(std::integral_constant<int, 3>());
  return f(std::integral_constant<int, 7>());
}

// The point (x / w, y / w), w > 0, where two lines meet that are not parallel.
template <int N>
struct exact_meeting {
  wide_int<2 * N> x, y, w;
};
template <int N>
constexpr exact_meeting<N> point_on_both(const line_terms<N>& p, const line_terms<N>& q) noexcept {
  exact_meeting<N> m{p.b * q.c - q.b * p.c, p.c * q.a - q.c * p.a, p.a * q.b - q.a * p.b};
  if (m.w.is_negative()) m = {-m.x, -m.y, -m.w};
  return m;
}

template <int N>
constexpr wide_int<N - 1> narrowed_by_one(const wide_int<N>& v) noexcept {
  wide_int<N - 1> low;
  for (int i = 0; i < N - 1; ++i) low.word[i] = v.word[i];
  return low;
}

// x / w as the nearest multiple of 2^-22, below 2^30 in size; whether nothing was lost.
template <int N>
constexpr double place_in_window(const wide_int<N>& x, const wide_int<N>& w, bool& is_exact) noexcept {
  const place_ratio<N + 1> r{(x.is_negative() ? -x : x) * wide_int<1>(1), w * wide_int<1>(std::int64_t{1} << 30)};
  const wide_int<N + 1> wide = w * wide_int<1>(1), twice = w * wide_int<1>(2);
  auto digits = static_cast<std::int64_t>(rounded_ratio(r) * 0x1p52);  // off by a few units, which are mended
  wide_int<N + 1> rest = narrowed_by_one(r.numerator * wide_int<1>(std::int64_t{1} << 23)) -
                         narrowed_by_one(twice * wide_int<1>(digits)) + wide;
  for (; rest.is_negative(); rest += twice) --digits;
  for (; !(rest < twice); rest -= twice) ++digits;
  is_exact = rest == wide;
  const double size = static_cast<double>(digits) * 0x1p-22;
  return x.is_negative() ? -size : size;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
