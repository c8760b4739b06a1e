// SPDX-License-Identifier: MIT
// A window cut into convex cells in each of which one face is seen, or none. Cells are cut in halves while many faces
// reach into them, then along the sides of faces, the nearest first, and where two planes meet.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/hidden/detail/edge_crossing.hpp>
#include <irg/raster/window.hpp>

namespace irg::detail {

// Lines of a picture and the points where two of them meet, exactly: a line is the side of a face, the place where the
// planes of two faces are equally deep, or an upright or level one. Its coefficients are integers of 64, 192 or 448
// bits, so that the sign of a determinant tells on which side of a line a point lies; doubles are asked first.

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
    const auto weight = side_coefficients(f, i == 2 ? 0 : i + 1);
    const wide_int<N> depth = depth_as_integer<N>(f.depth[i], lowest);
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
  return {minimum(p.lowest, q.lowest), maximum(p.highest, q.highest)};
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
      if (size.word[i] != 0) top = maximum(top, i);
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
  const place_ratio<N + 1> r{size_of_integer(x) * wide_int<1>(1), w * wide_int<1>(std::int64_t{1} << 30)};
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

// A corner of a cell, and the line from it to the next one: two cells that share a boundary have it on one line.
struct cell_corner {
  std::uint32_t point, line;
};
// A face that may be seen in a cell; bit i says that the cell lies inside its side i.
struct cell_candidate {
  std::uint32_t face;
  std::uint8_t inside;
};
// The box of a cell's corners as they are rounded, which keeps their order with whole numbers.
struct cell_box {
  double low[2], high[2];
};
struct window_cell {
  std::vector<cell_corner> corners{};  // clockwise on the screen (y down)
  std::vector<cell_candidate> faces{};
};
struct finished_cell {
  std::vector<cell_corner> corners{};
  std::uint32_t number = no_index;
};

inline namespace IRG_ABI {

// A window that is being cut.
template <class Face>
struct window_cutting {
  std::span<const Face> faces;  // that have an area
  std::span<const std::uint32_t> numbers;
  std::vector<float> nearest{}, farthest{};  // of each face
  std::vector<picture_line> sides{};  // three of each face
  std::vector<picture_line> lines{};
  std::vector<picture_point> points{};
  std::vector<finished_cell> cells{};
};

template <class Cutting>
constexpr int words_of(const Cutting& s, const picture_point& p) noexcept {
  return maximum(s.lines[p.line[0]].words, s.lines[p.line[1]].words);
}
template <int N, class Cutting>
constexpr exact_meeting<N> exact_meeting_of(const Cutting& s, const picture_point& p) noexcept {
  return point_on_both(coefficients_of<N>(s.faces, s.lines[p.line[0]]),
                       coefficients_of<N>(s.faces, s.lines[p.line[1]]));
}
template <class Cutting>
constexpr std::uint32_t add_meeting(Cutting& s, std::uint32_t l, std::uint32_t m) {
  picture_point p{{minimum(l, m), maximum(l, m)}};
  with_line_words(words_of(s, p), [&](auto n) {
    const auto e = exact_meeting_of<n.value>(s, p);
    p.x = place_in_window(e.x, e.w, p.is_exact[0]);
    p.y = place_in_window(e.y, e.w, p.is_exact[1]);
  });
  s.points.push_back(p);
  return static_cast<std::uint32_t>(s.points.size() - 1);
}

// -1, 0, 1: the side of a line on which a point lies.
template <class Cutting>
constexpr int side_of_picture_line(const Cutting& s, const picture_line& line, const picture_point& p) noexcept {
  // Within 2^-23 of the point in x and y, the products within 2^-50 of their sizes.
  const double ax = line.a * p.x, by = line.b * p.y, value = ax + by + line.c;
  const double bound =
      (magnitude(line.a) + magnitude(line.b)) * 0x1p-22 + (magnitude(ax) + magnitude(by) + magnitude(line.c)) * 0x1p-49;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  const picture_line &l = s.lines[p.line[0]], &m = s.lines[p.line[1]];
  if (is_one_line(line, l) || is_one_line(line, m)) return 0;
  return with_line_words(maximum(line.words, maximum(l.words, m.words)), [&](auto n) {
    const auto e = coefficients_of<n.value>(s.faces, line);
    const auto q = point_on_both(coefficients_of<n.value>(s.faces, l), coefficients_of<n.value>(s.faces, m));
    return (e.a * q.x + e.b * q.y + e.c * q.w).sign();
  });
}
// Whether a coordinate of one point is less than (-1), equal to or greater than that of another.
template <class Cutting>
constexpr int compare_coordinate(const Cutting& s, int axis, const picture_point& p, const picture_point& q) noexcept {
  const double u = axis == 0 ? p.x : p.y, v = axis == 0 ? q.x : q.y;
  if (u != v) return u < v ? -1 : 1;  // rounding keeps the order
  if (p.is_exact[axis] && q.is_exact[axis]) return 0;
  if (p.line[0] == q.line[0] && p.line[1] == q.line[1]) return 0;
  return with_line_words(maximum(words_of(s, p), words_of(s, q)), [&](auto n) {
    const auto a = exact_meeting_of<n.value>(s, p), b = exact_meeting_of<n.value>(s, q);
    return axis == 0 ? (a.x * b.w - b.x * a.w).sign() : (a.y * b.w - b.y * a.w).sign();
  });
}
// Whether two lines have one direction.
template <class Cutting>
constexpr bool have_one_direction(const Cutting& s, const picture_line& l, const picture_line& m) noexcept {
  return is_one_line(l, m) || with_line_words(maximum(l.words, m.words), [&](auto n) {
           const auto p = coefficients_of<n.value>(s.faces, l), q = coefficients_of<n.value>(s.faces, m);
           return (p.a * q.b - q.a * p.b).sign() == 0;
         });
}

// The sides of a line on which a cell lies: bit 0 its negative one, bit 1 its positive one.
template <class Cutting>
constexpr unsigned sides_of_cell(const Cutting& s, const picture_line& line, const window_cell& cell) noexcept {
  unsigned sides = 0;
  for (const cell_corner& c : cell.corners) {
    const int side = side_of_picture_line(s, line, s.points[c.point]);
    sides |= side < 0 ? 1u : side > 0 ? 2u : 0u;
    if (sides == 3) break;
  }
  return sides;
}

// 1 where face f is seen before face g all over a cell, -1 where g is, 0 where neither is: then they meet in `line`.
template <class Cutting>
constexpr int compare_in_cell(const Cutting& s, std::uint32_t f, std::uint32_t g, const window_cell& cell,
                              picture_line& line) noexcept {
  if (s.farthest[f] > s.nearest[g]) return 1;
  if (s.farthest[g] > s.nearest[f]) return -1;
  line = meeting_line(s.faces, f, g);
  const unsigned sides = sides_of_cell(s, line, cell);
  if (sides == 3) return 0;
  if (sides == 0) return s.numbers[f] <= s.numbers[g] ? 1 : -1;
  return sides == 2 ? 1 : -1;
}

template <class Cutting>
constexpr cell_box box_of_cell(const Cutting& s, const window_cell& cell) noexcept {
  const picture_point& first = s.points[cell.corners[0].point];
  cell_box box{{first.x, first.y}, {first.x, first.y}};
  for (const cell_corner& c : cell.corners) {
    const double at[2] = {s.points[c.point].x, s.points[c.point].y};
    for (int i = 0; i < 2; ++i) {
      box.low[i] = minimum(box.low[i], at[i]);
      box.high[i] = maximum(box.high[i], at[i]);
    }
  }
  return box;
}

// Leaves out the faces beside the cell.
template <class Cutting>
constexpr void drop_faces_beside(const Cutting& s, window_cell& cell) {
  const cell_box box = box_of_cell(s, cell);
  std::size_t kept = 0;
  for (cell_candidate c : cell.faces) {
    const subpixel(&p)[3] = s.faces[c.face].p;  // corners are whole numbers: rounded places do not pass them
    bool beside = c.inside == 0 && (maximum(p[0].x, maximum(p[1].x, p[2].x)) < box.low[0] ||
                                    minimum(p[0].x, minimum(p[1].x, p[2].x)) > box.high[0] ||
                                    maximum(p[0].y, maximum(p[1].y, p[2].y)) < box.low[1] ||
                                    minimum(p[0].y, minimum(p[1].y, p[2].y)) > box.high[1]);
    for (int i = 0; i < 3 && !beside; ++i) {
      if ((c.inside >> i & 1) != 0) continue;
      const unsigned sides = sides_of_cell(s, s.sides[std::size_t{3} * c.face + static_cast<unsigned>(i)], cell);
      beside = (sides & 2) == 0;
      if (sides == 2) c.inside = static_cast<std::uint8_t>(c.inside | 1 << i);
    }
    if (!beside) cell.faces[kept++] = c;
  }
  cell.faces.resize(kept, cell_candidate{});
}

// Puts a face that covers the cell, and before which no other such face lies, to the front, and leaves out what is
// behind it. Says where it meets another one that covers the cell, if it does.
template <class Cutting>
constexpr bool drop_faces_behind(const Cutting& s, window_cell& cell, picture_line& meeting) {
  picture_line line;
  std::size_t best = cell.faces.size();
  for (std::size_t i = 0; i < cell.faces.size(); ++i)
    if (cell.faces[i].inside == 7 &&
        (best == cell.faces.size() || compare_in_cell(s, cell.faces[best].face, cell.faces[i].face, cell, line) < 0))
      best = i;
  if (best == cell.faces.size()) return false;
  std::swap(cell.faces[0], cell.faces[best]);
  bool meets = false;
  for (std::size_t i = 1; i < cell.faces.size();) {
    const int first = compare_in_cell(s, cell.faces[0].face, cell.faces[i].face, cell, line);
    const bool covers_cell = cell.faces[i].inside == 7;
    if (first < 0 && covers_cell) {  // ask all again
      std::swap(cell.faces[0], cell.faces[i]);
      meets = false;
    }
    if (first > 0 || (first < 0 && covers_cell)) {
      cell.faces[i] = cell.faces.back();
      cell.faces.pop_back();
      if (first < 0) i = 1;
      continue;
    }
    if (first == 0 && covers_cell) {
      meets = true;
      meeting = line;
    }
    ++i;
  }
  return meets;
}

// The line through the middle of a cell's box, where it parts the faces: across the longer side, or, where it cuts
// few of them, across the other one.
template <class Cutting>
constexpr bool halve_cell(const Cutting& s, const window_cell& cell, std::size_t reaching, picture_line& line) {
  const cell_box box = box_of_cell(s, cell);
  const int longer = box.high[0] - box.low[0] < box.high[1] - box.low[1] ? 1 : 0;
  return halve_cell_across(s, longer, box, cell, reaching + reaching / 2, line) ||
         halve_cell_across(s, 1 - longer, box, cell, reaching + reaching / 8, line);
}
// most   faces in both halves together
template <class Cutting>
constexpr bool halve_cell_across(const Cutting& s, int axis, const cell_box& box, const window_cell& cell,
                                 std::size_t most, picture_line& line) {
  const double low = box.low[axis], high = box.high[axis];
  if (high - low < 4) return false;
  const auto middle = static_cast<std::int32_t>((low + high) / 2);
  std::size_t below = 0, above = 0;
  for (const cell_candidate& c : cell.faces) {
    if (c.inside == 7) continue;
    bool is_below = false, is_above = false;
    for (const subpixel& p : s.faces[c.face].p) {
      is_below = is_below || (axis == 0 ? p.x : p.y) < middle;
      is_above = is_above || (axis == 0 ? p.x : p.y) > middle;
    }
    below += is_below ? 1u : 0u;
    above += is_above ? 1u : 0u;
  }
  if (below + above > most) return false;
  line = line_of_axis(axis == 0 ? picture_line_kind::upright : picture_line_kind::level, middle);
  return sides_of_cell(s, line, cell) == 3;
}

template <class Cutting>
constexpr void split_cell(Cutting& s, const window_cell& cell, const picture_line& by,
                          std::vector<window_cell>& waiting) {
  const auto line = static_cast<std::uint32_t>(s.lines.size());
  s.lines.push_back(by);
  window_cell half[2];
  const std::size_t n = cell.corners.size();
  int side = side_of_picture_line(s, by, s.points[cell.corners[0].point]);
  for (std::size_t i = 0; i < n; ++i) {
    const cell_corner& c = cell.corners[i];
    const int next = side_of_picture_line(s, by, s.points[cell.corners[i + 1 == n ? 0 : i + 1].point]);
    for (int h = 0; h < 2; ++h) {
      const int own = h == 0 ? -1 : 1;
      if (side == own)
        half[h].corners.push_back(c);
      else if (side == 0)  // the cut begins here, where the boundary leaves this half, or ends
        half[h].corners.push_back({c.point, next == own ? c.line : line});
    }
    if (side * next < 0) {
      const std::uint32_t p = add_meeting(s, c.line, line);
      for (int h = 0; h < 2; ++h) half[h].corners.push_back({p, next == (h == 0 ? -1 : 1) ? c.line : line});
    }
    side = next;
  }
  for (window_cell& part : half) {
    part.faces = cell.faces;
    waiting.push_back(std::move(part));
  }
}

// Cuts a cell where a face's side or a meeting of planes runs through it; it is finished where none does.
template <class Cutting>
constexpr void cut_or_finish(Cutting& s, window_cell&& cell, std::vector<window_cell>& waiting) {
  constexpr std::size_t few = 6;  // faces are not worth a cut that follows none of them
  drop_faces_beside(s, cell);
  picture_line line;
  const bool meets = drop_faces_behind(s, cell, line);
  std::size_t reaching = 0;
  const cell_candidate* next = nullptr;
  for (const cell_candidate& c : cell.faces) {
    if (c.inside == 7) continue;
    ++reaching;
    if (next == nullptr || s.nearest[c.face] > s.nearest[next->face]) next = &c;
  }
  if (reaching > few && halve_cell(s, cell, reaching, line)) return split_cell(s, cell, line, waiting);
  if (next != nullptr) {
    unsigned side = 0;
    while ((next->inside >> side & 1) != 0) ++side;
    return split_cell(s, cell, s.sides[std::size_t{3} * next->face + side], waiting);
  }
  if (meets) return split_cell(s, cell, line, waiting);
  s.cells.push_back({std::move(cell.corners), cell.faces.empty() ? no_index : s.numbers[cell.faces[0].face]});
}

template <class Cutting>
constexpr void cut_into_cells(Cutting& s, const cell_window& w) {
  s.sides.reserve(3 * s.faces.size());
  for (std::uint32_t f = 0; f < s.faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) s.sides.push_back(line_of_side(s.faces, f, i));
    const float(&depth)[3] = s.faces[f].depth;
    s.nearest.push_back(maximum(depth[0], maximum(depth[1], depth[2])));
    s.farthest.push_back(minimum(depth[0], minimum(depth[1], depth[2])));
  }
  window_cell all;
  const auto edge = [&](picture_line_kind kind, int pixel) {
    s.lines.push_back(line_of_axis(kind, static_cast<std::int32_t>(pixel * one_pixel)));
  };
  edge(picture_line_kind::level, w.y_first);
  edge(picture_line_kind::upright, w.x_last);
  edge(picture_line_kind::level, w.y_last);
  edge(picture_line_kind::upright, w.x_first);
  for (std::uint32_t i = 0; i < 4; ++i) all.corners.push_back({add_meeting(s, (i + 3) % 4, i), i});
  for (std::uint32_t f = 0; f < s.faces.size(); ++f) all.faces.push_back({f, 0});
  std::vector<window_cell> waiting;
  waiting.push_back(std::move(all));
  while (!waiting.empty()) {
    window_cell cell = std::move(waiting.back());
    waiting.pop_back();
    cut_or_finish(s, std::move(cell), waiting);
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail
