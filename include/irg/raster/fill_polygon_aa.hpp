// SPDX-License-Identifier: MIT
// Polygons of any shape with smooth edges: rings with holes, rings that cross themselves and each other, under either
// fill rule. The coverage of a pixel is the area of the inside within it, also where edges cross in the pixel.
//
// Edges that two polygons share stay visible as seams; see fill_convex_aa.hpp.
#pragma once

#include <algorithm>
#include <vector>

#include <irg/core/contraction.hpp>
#include <irg/core/function_ref.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/detail/area_kernel.hpp>
#include <irg/raster/detail/compiled_rasters.hpp>
#include <irg/raster/detail/polygon_bands.hpp>
#include <irg/raster/detail/polygon_fill_kernel.hpp>
#include <irg/raster/detail/snapped_ring.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/triangle_coverage.hpp>
#include <irg/raster/window.hpp>

namespace irg {
namespace detail {

inline constexpr int fine_bits = 32;  // positions: pixels in 32.32 fixed point
inline constexpr std::int64_t fine_one = std::int64_t{1} << fine_bits;
inline constexpr int snapped_to_fine = fine_bits - subpixel_bits;

// An edge, level ones too: they join the groups of what they connect.
struct area_line {
  subpixel upper{}, lower{};
  int direction = 0;  // 1 downwards, -1 upwards, 0 level
  double slope = 0;  // x per y

  // Where it is at a height below `row` (in 1/256 pixel), without rounding at its ends: edges that meet there, meet.
  IRG_INLINE constexpr std::int64_t x_at(std::int32_t row, std::int64_t y) const noexcept {
    const std::int64_t below = (std::int64_t{row - upper.y} << snapped_to_fine) + y;
    if (below == std::int64_t{lower.y - upper.y} << snapped_to_fine) return std::int64_t{lower.x} << snapped_to_fine;
    return (std::int64_t{upper.x} << snapped_to_fine) +
           static_cast<std::int64_t>(product(static_cast<double>(below), slope));
  }
};

// The part of an edge that lies in the present row; heights from the row's top on.
struct area_part {
  int line = 0;
  std::int64_t top = 0, bottom = 0;
  std::int64_t x_top = 0, x_bottom = 0;
  std::int64_t low = 0, high = 0;  // in x
};

// A part while its group is swept: in one band, from its top on.
struct area_swept {
  int part = 0, line = 0, direction = 0;
  int winding = 0;  // left of it
  int role = 0;  // 1: the inside begins here, -1: it ends, 0: neither
  int place = 0;  // in the order from left to right
  std::int64_t bottom = 0;  // where the edge leaves the row
  std::int64_t x_top = 0, x_bottom = 0;  // where it enters and leaves the band
  std::int64_t since = 0;  // the height down to which its area has been added
};

struct area_crossing {
  std::int64_t y = 0;
  int left = 0, right = 0;  // of those swept
  // For a heap whose top is the uppermost crossing.
  IRG_INLINE friend constexpr bool operator<(const area_crossing& a, const area_crossing& b) noexcept {
    return a.y != b.y ? a.y > b.y : a.left != b.left ? a.left > b.left : a.right > b.right;
  }
};

struct area_memory {
  std::vector<area_line> lines;
  std::vector<area_part> parts;
  std::vector<std::int64_t> heights;
  std::vector<int> beginning, order;
  std::vector<area_swept> swept;
  std::vector<area_crossing> crossings;
  std::vector<std::int64_t> change;  // of the area from column to column, in 2^-40
  std::vector<std::uint8_t> coverage;
};

}  // namespace detail

/// Memory that the areas of polygons need, to be used again by the next one.
struct coverage_workspace {
  detail::area_memory memory;
};

inline namespace IRG_ABI {

/// Calls sink(span) for runs of pixels of the window that the polygon's inside covers, whole or in part, row by row
/// from top to bottom, left to right, no pixel twice. How a row is cut into runs is not promised; a coverage may be 0.
/// shape   one ring, or a container of rings; holes are rings
/// units   floating vertices in pixels, snapped to 1/256 as by snap(); subpixel vertices as they are
/// gives   false and no span when a vertex is NaN, infinite or more than snap_limit pixels from the origin; else true.
///         Rings of less than 3 vertices count for nothing
/// exact   coverage is the area of the inside within the pixel in 255ths, rounded to the nearest: within 0.00198 (1/256
///         is 0.0039) of the exact area of the snapped polygon, whatever crosses in the pixel. No window changes a
///         pixel within it
/// cost    per row, sorting its edges (they are nearly in order); per pixel that an edge crosses, one closed form; per
///         crossing of edges, a few more. The workspace keeps memory for the edges, what crosses in a row, and one row.
///         A single convex ring goes the way of convex_coverage
/// source  Bentley and Ottmann 1979 (sweep and crossings), a pixel row at a time
template <FillablePolygon P, CoverageSink Sink, class Workspace = coverage_workspace>
  requires std::same_as<Workspace&, coverage_workspace&>
constexpr bool polygon_coverage(const P& polygon, fill_rule rule, const cell_window& window, Sink&& sink,
                                Workspace&& workspace = Workspace{});

/// Paints a polygon, each pixel as far as it is covered.
/// gives   false, and nothing painted, when a vertex is NaN, infinite or more than snap_limit pixels from the origin
/// exact   the pixels that polygon_coverage and blend_span make
template <WritableRaster R, FillablePolygon P, CoveragePaintFor<R> Paint = pixel_of<R>,
          class Workspace = coverage_workspace>
  requires std::same_as<Workspace&, coverage_workspace&>
constexpr bool fill_polygon_aa(R& raster, const P& polygon, fill_rule rule, const Paint& paint,
                               Workspace&& workspace = Workspace{});
/// The same of one ring in braces.
template <WritableRaster R, std::size_t N, CoveragePaintFor<R> Paint = pixel_of<R>,
          class Workspace = coverage_workspace>
  requires std::same_as<Workspace&, coverage_workspace&>
constexpr bool fill_polygon_aa(R& raster, const point<double, 2> (&ring)[N], fill_rule rule, const Paint& paint,
                               Workspace&& workspace = Workspace{}) {
  return fill_polygon_aa<R, point<double, 2>[N]>(raster, ring, rule, paint, workspace);
}

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

// The rows of the lines in memory.
// needs   w not empty
template <class Memory>
IRG_API void send_area_sweep(Memory& memory, fill_rule rule, const cell_window& w,
                             const function_ref<void(const coverage_span&)>& sink);
template <CompiledPixel P>
IRG_API void mix_area_sweep(const image_view<P>& raster, area_memory& memory, fill_rule rule, const cell_window& w,
                            const P& value);

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

// The area within each pixel that rings of any shape enclose under a fill rule.
//
// A row is cut into groups of edges that overlap in x. Beside a group no edge is, so the winding number there is one
// for the whole height of the row, and each group is swept on its own: from top to bottom, in bands between the heights
// where its edges begin or end, and within a band from one crossing of neighbours to the next. Between those heights
// the order of the edges stands, and the fill rule says which of them bound the inside; each such stretch of an edge
// adds or takes away the area on its right.
//
// Positions are whole multiples of 2^-32 of a pixel; those of crossings and on edges are rounded, by 2^-31 at most. The
// order within a band is not told from rounded crossings, but led from what it is at the top to what it is at the
// bottom by exchanging neighbours, so it is a sound one at every height. Areas are whole multiples of 2^-40, each a
// function of one stretch of one edge and of the column alone: sums are exact, and no window changes a pixel.

// Calls sink(coverage_span) for the rows of the lines in memory.
template <class Emit>
class polygon_sweep {
public:
  // needs   w not empty
  constexpr polygon_sweep(area_memory& memory, fill_rule rule, const cell_window& w, Emit& sink)
      : m_(memory), inside_bits_(rule == fill_rule::even_odd ? 1 : -1), w_(w), emit_(sink) {
    const auto width = static_cast<std::size_t>(std::int64_t{w.x_last} - w.x_first);
    m_.change.assign(width + 1, 0);
    m_.coverage.assign(width, 0);
  }

  constexpr void all_rows() {
    std::sort(m_.lines.begin(), m_.lines.end(), [](const area_line& a, const area_line& b) {
      return a.upper.y != b.upper.y ? a.upper.y < b.upper.y : a.upper.x < b.upper.x;
    });
    m_.parts.clear();
    std::size_t waiting = 0;
    for (int row = w_.y_first; row < w_.y_last; ++row) {
      if (m_.parts.empty()) {
        if (waiting == m_.lines.size()) return;
        row = maximum(row, m_.lines[waiting].upper.y >> subpixel_bits);
        if (row >= w_.y_last) return;
      }
      const std::int32_t top = row * one_pixel, bottom = top + one_pixel;
      row_top_ = top;
      const std::size_t before = m_.parts.size();
      for (; waiting < m_.lines.size() && m_.lines[waiting].upper.y < bottom; ++waiting)
        if (m_.lines[waiting].lower.y > top) m_.parts.push_back({static_cast<int>(waiting)});
      for (area_part& p : m_.parts) enter_row(p, top, bottom);
      put_in_order(m_.parts.size() - before);
      one_row(row);
      std::erase_if(m_.parts, [&](const area_part& p) { return line(p.line).lower.y <= bottom; });
    }
  }

private:
  static constexpr int area_bits = 40;
  static constexpr std::int64_t whole_pixel = std::int64_t{1} << area_bits;

  IRG_INLINE constexpr const area_line& line(int i) const noexcept { return m_.lines[static_cast<std::size_t>(i)]; }
  IRG_INLINE constexpr bool is_inside(int winding) const noexcept { return (winding & inside_bits_) != 0; }

  constexpr void enter_row(area_part& p, std::int32_t top, std::int32_t bottom) noexcept {
    const area_line& l = line(p.line);
    const bool comes_from_above = p.bottom == fine_one;
    p.top = comes_from_above ? 0 : std::int64_t{maximum(top, l.upper.y) - top} << snapped_to_fine;
    p.bottom = std::int64_t{minimum(bottom, l.lower.y) - top} << snapped_to_fine;
    p.x_top = comes_from_above   ? p.x_bottom
              : l.direction == 0 ? std::int64_t{l.upper.x} << snapped_to_fine
                                 : l.x_at(top, p.top);
    p.x_bottom = l.x_at(top, p.bottom);
    p.low = minimum(p.x_top, p.x_bottom);
    p.high = maximum(p.x_top, p.x_bottom);
  }

  // By their left ends; the parts of the row before are nearly in order.
  constexpr void put_in_order(std::size_t fresh) {
    const auto less = [](const area_part& a, const area_part& b) {
      return a.low != b.low ? a.low < b.low : a.line < b.line;
    };
    std::size_t moves_left = fresh > 16 ? 0 : 8 * m_.parts.size() + 64;
    for (std::size_t i = 1; i < m_.parts.size() && moves_left > 0; ++i)
      for (std::size_t k = i; k > 0 && less(m_.parts[k], m_.parts[k - 1]) && moves_left > 0; --k, --moves_left)
        std::swap(m_.parts[k], m_.parts[k - 1]);
    if (moves_left == 0) std::sort(m_.parts.begin(), m_.parts.end(), less);
  }

  constexpr void one_row(int row) {
    row_ = row;
    int winding = 0;
    run_first_ = run_last_ = w_.x_first;
    run_area_ = 0;
    const std::size_t n = m_.parts.size();
    for (std::size_t i = 0; i < n;) {
      std::int64_t high = m_.parts[i].high;
      std::int64_t turned = 0;  // the change of the winding number beyond the group, for each of fine_one heights
      std::size_t last = i;
      for (; last < n && m_.parts[last].low <= high; ++last) {
        const area_part& p = m_.parts[last];
        high = maximum(high, p.high);
        turned += line(p.line).direction * (p.bottom - p.top);
      }
      const std::int64_t from = m_.parts[i].low >> fine_bits, to = (high + (fine_one - 1)) >> fine_bits;
      if (from >= w_.x_last) break;
      const bool visible = to > w_.x_first;
      if (visible) {
        if (from >= run_last_) finish_run(is_inside(winding), limited(from));
        run_last_ = maximum(run_last_, limited(to));
        sweep_group(i, last, winding);
      }
      winding += static_cast<int>(turned / fine_one);
      if (!visible) run_area_ = is_inside(winding) ? whole_pixel : 0;
      i = last;
    }
    finish_run(is_inside(winding), w_.x_last);
  }

  IRG_INLINE constexpr int limited(std::int64_t x) const noexcept {
    return static_cast<int>(clamped(x, std::int64_t{w_.x_first}, std::int64_t{w_.x_last}));
  }

  // Sends the columns that the groups so far have touched, and what lies between them and the next group.
  constexpr void finish_run(bool inside, int next) {
    std::int64_t area = run_area_;
    int first = run_last_, last = run_first_;  // what is not 0
    for (int x = run_first_; x < run_last_; ++x) {
      area += change_at(x);
      change_at(x) = 0;
      // Rounded as coverage_of_area does.
      constexpr std::int64_t rounding = (whole_pixel >> 1) + (whole_pixel >> 10);
      const auto c =
          static_cast<std::uint8_t>((clamped(area, std::int64_t{0}, whole_pixel) * 255 + rounding) >> area_bits);
      coverage_at(x) = c;
      if (c == 0) continue;
      first = minimum(first, x);
      last = x + 1;
    }
    if (first < last) emit_(coverage_span{row_, first, last, &coverage_at(first)});
    change_at(run_last_) = 0;
    if (inside && run_last_ < next) emit_(coverage_span{row_, run_last_, next, nullptr});
    run_first_ = run_last_ = next;
    run_area_ = inside ? whole_pixel : 0;
  }

  // Adds what lies right of a stretch of an edge, or takes it away.
  constexpr void add_stretch(std::int64_t xa, std::int64_t xb, std::int64_t height, int role) {
    const std::int64_t low = minimum(xa, xb), high = maximum(xa, xb);
    const std::int64_t first = low >> fine_bits, last = (high + (fine_one - 1)) >> fine_bits;
    const std::int64_t whole = height << (area_bits - fine_bits);
    const double width = static_cast<double>(high - low) * 0x1p-32, tall = static_cast<double>(height) * 0x1p-32;
    const double scale = width > 0 ? tall / (width + width) : 0.0;
    std::int64_t so_far = 0;
    const std::int64_t stop = minimum(last, std::int64_t{w_.x_last});
    std::int64_t x = maximum(first, std::int64_t{w_.x_first});
    for (; x < stop; ++x) {
      const double from = static_cast<double>(low - (x << fine_bits)) * 0x1p-32;
      const double area = tall - uncovered_near(0.0, from, width, scale, tall);  // on its right
      const auto cut = static_cast<std::int64_t>(area * 0x1p40 + 0.5);
      change_at(x) += role * (cut - so_far);
      so_far = cut;
    }
    if (x <= w_.x_last) change_at(x) += role * (whole - so_far);
  }
  IRG_INLINE constexpr std::int64_t& change_at(std::int64_t x) noexcept {
    return m_.change[static_cast<std::size_t>(x - w_.x_first)];
  }

  IRG_INLINE constexpr std::uint8_t& coverage_at(int x) noexcept {
    return m_.coverage[static_cast<std::size_t>(std::int64_t{x} - w_.x_first)];
  }

  // Adds the areas of the group of parts [first, last), left of which the winding number is given.
  constexpr void sweep_group(std::size_t first, std::size_t last, int winding) {
    if (last - first == 1) {  // it crosses the whole row
      const area_part& p = m_.parts[first];
      const int role = int{is_inside(winding + line(p.line).direction)} - int{is_inside(winding)};
      if (role != 0) add_stretch(p.x_top, p.x_bottom, p.bottom - p.top, role);
      return;
    }
    m_.heights.clear();
    m_.beginning.clear();
    m_.swept.clear();
    for (std::size_t i = first; i < last; ++i) {
      m_.heights.push_back(m_.parts[i].top);
      m_.heights.push_back(m_.parts[i].bottom);
      if (m_.parts[i].top < m_.parts[i].bottom) m_.beginning.push_back(static_cast<int>(i));
    }
    std::sort(m_.heights.begin(), m_.heights.end());
    m_.heights.erase(std::unique(m_.heights.begin(), m_.heights.end()), m_.heights.end());
    std::sort(m_.beginning.begin(), m_.beginning.end(), [&](int a, int b) {
      const std::int64_t ya = part(a).top, yb = part(b).top;
      return ya != yb ? ya < yb : a < b;
    });
    std::size_t next = 0;
    for (std::size_t band = 0; band + 1 < m_.heights.size(); ++band) {
      const std::int64_t top = m_.heights[band], bottom = m_.heights[band + 1];
      std::erase_if(m_.swept, [&](const area_swept& s) { return s.bottom <= top; });
      for (; next < m_.beginning.size() && part(m_.beginning[next]).top == top; ++next) {
        const area_part& q = part(m_.beginning[next]);
        area_swept s;
        s.part = m_.beginning[next];
        s.line = q.line;
        s.direction = line(q.line).direction;
        s.bottom = q.bottom;
        m_.swept.push_back(s);
      }
      sweep_band(top, bottom, winding);
    }
  }

  IRG_INLINE constexpr const area_part& part(int i) const noexcept { return m_.parts[static_cast<std::size_t>(i)]; }
  IRG_INLINE constexpr area_swept& swept(int i) noexcept { return m_.swept[static_cast<std::size_t>(i)]; }

  constexpr void take_role(area_swept& s, int winding, std::int64_t y) noexcept {
    s.winding = winding;
    s.role = int{is_inside(winding + s.direction)} - int{is_inside(winding)};
    s.since = y;
  }
  // Adds the area of an edge down to a height.
  constexpr void settle(area_swept& s, std::int64_t y) {
    if (s.role != 0 && s.since < y) add_stretch(x_of(s, s.since), x_of(s, y), y - s.since, s.role);
  }
  IRG_INLINE constexpr std::int64_t x_of(const area_swept& s, std::int64_t y) const noexcept {
    return line(s.line).x_at(row_top_, y);
  }

  // All of m_.swept cross the band; no edge begins or ends within.
  constexpr void sweep_band(std::int64_t top, std::int64_t bottom, int winding) {
    for (area_swept& s : m_.swept) {
      const area_part& p = part(s.part);
      s.x_top = top == p.top ? p.x_top : x_of(s, top);
      s.x_bottom = bottom == p.bottom ? p.x_bottom : x_of(s, bottom);
    }
    std::sort(m_.swept.begin(), m_.swept.end(), [](const area_swept& a, const area_swept& b) {
      return a.x_top != b.x_top         ? a.x_top < b.x_top
             : a.x_bottom != b.x_bottom ? a.x_bottom < b.x_bottom
                                        : a.line < b.line;
    });
    band_top_ = top;
    const int n = static_cast<int>(m_.swept.size());
    m_.order.clear();
    m_.crossings.clear();
    for (int i = 0; i < n; ++i) {
      area_swept& s = swept(i);
      take_role(s, winding, top);
      winding += s.direction;
      s.place = i;
      m_.order.push_back(i);
      if (i > 0) expect_crossing(i - 1, i, top, bottom);
    }
    while (!m_.crossings.empty()) {
      std::pop_heap(m_.crossings.begin(), m_.crossings.end());
      const area_crossing c = m_.crossings.back();
      m_.crossings.pop_back();
      area_swept &a = swept(c.left), &b = swept(c.right);
      if (b.place != a.place + 1) continue;  // they have met others on the way, and will meet again
      settle(a, c.y);
      settle(b, c.y);
      const int left_of_both = a.winding, place = a.place;
      std::swap(m_.order[static_cast<std::size_t>(place)], m_.order[static_cast<std::size_t>(place) + 1]);
      std::swap(a.place, b.place);
      take_role(b, left_of_both, c.y);
      take_role(a, left_of_both + b.direction, c.y);
      if (place > 0) expect_crossing(m_.order[static_cast<std::size_t>(place) - 1], c.right, c.y, bottom);
      if (place + 2 < n) expect_crossing(c.left, m_.order[static_cast<std::size_t>(place) + 2], c.y, bottom);
    }
    for (area_swept& s : m_.swept) settle(s, bottom);
  }

  // Notes where two neighbours cross, at y or below, if they do so within the band.
  constexpr void expect_crossing(int left, int right, std::int64_t y, std::int64_t bottom) {
    const area_swept &a = swept(left), &b = swept(right);
    if (a.x_bottom <= b.x_bottom) return;
    const auto apart = static_cast<double>(b.x_top - a.x_top), beyond = static_cast<double>(a.x_bottom - b.x_bottom);
    const auto way = static_cast<double>(bottom - band_top_) * (apart / (apart + beyond));
    const std::int64_t at = band_top_ + static_cast<std::int64_t>(way);
    m_.crossings.push_back({clamped(at, y, bottom), left, right});
    std::push_heap(m_.crossings.begin(), m_.crossings.end());
  }

  area_memory& m_;
  int inside_bits_;
  cell_window w_;
  Emit& emit_;
  int row_ = 0;
  std::int32_t row_top_ = 0;  // in 1/256 pixel
  int run_first_ = 0, run_last_ = 0;  // columns touched and not sent yet
  std::int64_t run_area_ = 0;  // of the pixel left of them
  std::int64_t band_top_ = 0;
};

// Whether a ring that can be snapped turns one way only and goes round once.
template <FillableRing R>
constexpr bool is_convex_ring(const R& ring) {
  const std::size_t n = ring_size(ring);
  if (n <= 3) return true;
  if (!goes_down_and_up_once(ring)) return false;
  int sense = 0;
  std::size_t before = n - 2;
  subpixel a = near_vertex(ring, before), b = near_vertex(ring, n - 1);
  while (before > 0 && a == b) a = near_vertex(ring, --before);  // the turn at the last vertex counts, too
  for (std::size_t i = 0; i < n; ++i) {
    const subpixel c = near_vertex(ring, i);
    if (c == b) continue;
    const std::int64_t turn = twice_signed_area(a, b, c);
    const int way = turn > 0 ? 1 : turn < 0 ? -1 : 0;
    if (way == 0 && (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - b.x) < 0) return false;  // a spike
    if (way != 0 && sense != 0 && way != sense) return false;
    if (way != 0) sense = way;
    a = b;
    b = c;
  }
  return true;
}

// Collects the edges of a ring, and what they span.
template <FillableRing R>
constexpr void add_area_lines(std::vector<area_line>& lines, const R& ring, ring_extent<std::int32_t>& extent) {
  const std::size_t n = ring_size(ring);
  if (n < 3) return;
  subpixel a = near_vertex(ring, n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    const subpixel b = near_vertex(ring, i);
    extent.add(b, i);
    if (!(a == b)) {
      area_line l;
      l.direction = a.y < b.y ? 1 : a.y > b.y ? -1 : 0;
      l.upper = l.direction < 0 ? b : a;
      l.lower = l.direction < 0 ? a : b;
      if (l.direction != 0)
        l.slope = static_cast<double>(l.lower.x - l.upper.x) / static_cast<double>(l.lower.y - l.upper.y);
      lines.push_back(l);
    }
    a = b;
  }
}

// Collects the edges of a polygon that can be snapped; gives the pixels of the window that it may cover.
template <FillablePolygon P>
constexpr cell_window collect_area_lines(area_memory& m, const P& polygon, const cell_window& window) {
  m.lines.clear();
  ring_extent<std::int32_t> extent;
  for_each_ring(polygon, [&](const auto& ring) { add_area_lines(m.lines, ring, extent); });
  return m.lines.empty() ? cell_window{} : intersect(window, cells_of_extent(extent));
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <FillablePolygon P, CoverageSink Sink, class Workspace>
  requires std::same_as<Workspace&, coverage_workspace&>
constexpr bool polygon_coverage(const P& polygon, fill_rule rule, const cell_window& window, Sink&& sink,
                                Workspace&& workspace) {
  detail::area_memory& m = workspace.memory;
  if (detail::reach_of_polygon(polygon) != detail::ring_reach::within_snap_limit) return false;
  if constexpr (FillableRing<P>)
    if (detail::is_convex_ring(polygon)) return convex_coverage(polygon, window, sink);
  const cell_window w = detail::collect_area_lines(m, polygon, window);
  if (w.empty()) return true;
  if constexpr (detail::draws_in_library)
    detail::send_area_sweep(m, rule, w, as_function<void(const coverage_span&)>(sink));
  else
    detail::polygon_sweep(m, rule, w, sink).all_rows();
  return true;
}

template <WritableRaster R, FillablePolygon P, CoveragePaintFor<R> Paint, class Workspace>
  requires std::same_as<Workspace&, coverage_workspace&>
constexpr bool fill_polygon_aa(R& raster, const P& polygon, fill_rule rule, const Paint& paint, Workspace&& workspace) {
  if constexpr (FillableRing<P>)
    if (detail::reach_of(polygon) == detail::ring_reach::within_snap_limit && detail::is_convex_ring(polygon))
      return fill_convex_aa(raster, polygon, paint);
  if constexpr (detail::draws_in_library && detail::CompiledRaster<R> && !CoverageBlendFunction<Paint, R>) {
    if (detail::reach_of_polygon(polygon) != detail::ring_reach::within_snap_limit) return false;
    const cell_window w = detail::collect_area_lines(workspace.memory, polygon, window_of(raster));
    if (!w.empty()) detail::mix_area_sweep(view_of(raster), workspace.memory, rule, w, static_cast<pixel_of<R>>(paint));
    return true;
  } else {
    const auto blend = [&](const coverage_span& span) { blend_span(raster, span, paint); };
    return polygon_coverage(polygon, rule, window_of(raster), blend, workspace);
  }
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Memory>
IRG_API void send_area_sweep(Memory& memory, fill_rule rule, const cell_window& w,
                             const function_ref<void(const coverage_span&)>& sink) {
  polygon_sweep(memory, rule, w, sink).all_rows();
}

template <CompiledPixel P>
IRG_API void mix_area_sweep(const image_view<P>& raster, area_memory& memory, fill_rule rule, const cell_window& w,
                            const P& value) {
  image_view<P> target = raster;
  const auto blend = [&](const coverage_span& span) { blend_span(target, span, value); };
  polygon_sweep(memory, rule, w, blend).all_rows();
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
