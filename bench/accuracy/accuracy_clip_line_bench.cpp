// SPDX-License-Identifier: MIT
// Segments against windows: any ones, ones that graze corners, huge and subnormal ones: run time against error of the
// ends. A segment that is said to be visible and is not, or the other way round, counts as failed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <irg/geometry/clip_line_cohen_sutherland.hpp>
#include <irg/geometry/clip_line_cyrus_beck.hpp>
#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/geometry/clip_line_nicholl_lee_nicholl.hpp>

#include "accuracy/vector_sets.hpp"

#ifdef IRG_HAVE_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
#include <opencv2/imgproc.hpp>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using point2 = irg::point<double, 2>;
using box2 = irg::box<double, 2>;
using ends = std::array<double, 4>;  // x and y of both; NaN when nothing is visible
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr ends invisible{none, none, none, none};

struct set {
  std::string name;
  box2 window;
  std::vector<std::array<point2, 2>> segments;
};

std::vector<set> sets() {
  std::vector<set> all;
  const auto add = [&](const std::string& name, double size, auto next) {
    bench::random_numbers r(17);
    set s{name, {{-size, -size}, {size, size}}, {}};
    for (int i = 0; i < (bench::smoke() ? 16 : 2048); ++i) s.segments.push_back(next(r));
    all.push_back(s);
  };
  const auto any_of = [](double size) {
    return [size](bench::random_numbers& r) {
      const auto c = [&] { return size * r.between(-2, 2); };
      const double ax = c(), ay = c(), bx = c();
      return std::array{point2{ax, ay}, point2{bx, c()}};
    };
  };
  add("any segment", 1, any_of(1));
  add("past a corner at an ulp", 1, [](bench::random_numbers& r) {
    const double x = r.integer(0, 1) * 2 - 1, y = r.integer(0, 1) * 2 - 1;
    const double dx = x * r.unit(), dy = -y * r.unit();
    point2 a{x + dx, y + dy}, b{x - dx * (1 + r.unit()), 0};
    b.y = y + dy / dx * (b.x - x);
    if (r.integer(0, 1) == 1) a.x = std::nextafter(a.x, 9.0 * x);
    return std::array{a, b};
  });
  add("along an edge at an ulp", 1, [](bench::random_numbers& r) {
    const double y = r.integer(0, 1) * 2 - 1;
    const auto at = [&] { return r.integer(0, 2) == 0 ? y : std::nextafter(y, r.integer(0, 1) == 0 ? -9.0 : 9.0); };
    const double ax = r.between(-2, 2), bx = r.between(-2, 2), first = at();
    return std::array{point2{ax, first}, point2{bx, at()}};
  });
  add("from 2^60 away", 1, [](bench::random_numbers& r) {
    const double x = r.between(-0.5, 0.5), y = r.between(-0.5, 0.5), dx = r.between(-1, 1), dy = r.between(-1, 1);
    return std::array{point2{x - 0x1p60 * dx, y - 0x1p60 * dy}, point2{x + dx * 4, y + dy * 4}};
  });
  add("of size 2^1022", 0x1p1022, any_of(0x1p1022));
  add("of size 2^-1050 (subnormal)", 0x1p-1050, any_of(0x1p-1050));
  return all;
}

// Liang and Barsky in numbers of type R, of which only results are rounded.
template <class R, class Round>
ends liang_barsky(const box2& w, const point2& a, const point2& b, Round round) {
  R low = R(0), high = R(1);
  for (int k = 0; k < 2; ++k) {
    const R d = R(b[k]) - R(a[k]), below = R(w.low[k]) - R(a[k]), above = R(w.high[k]) - R(a[k]);
    if (d == R(0)) {
      if (R(0) < below || above < R(0)) return invisible;
      continue;
    }
    const R first = (d < R(0) ? above : below) / d, last = (d < R(0) ? below : above) / d;
    if (low < first) low = first;
    if (last < high) high = last;
  }
  if (high < low) return invisible;
  const auto at = [&](const R& t, int k) { return round(t == R(1) ? R(b[k]) : R(a[k]) + t * (R(b[k]) - R(a[k]))); };
  return {at(low, 0), at(low, 1), at(high, 0), at(high, 1)};
}

ends ends_of(const std::optional<irg::clipped_line<point2>>& kept) {
  return kept ? ends{kept->first.x, kept->first.y, kept->second.x, kept->second.y} : invisible;
}

#ifdef IRG_HAVE_CGAL
ends cgal_clip(const box2& w, const point2& a, const point2& b) {
  using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const kernel::Iso_rectangle_2 window(w.low.x, w.low.y, w.high.x, w.high.y);
  const auto kept = CGAL::intersection(kernel::Segment_2({a.x, a.y}, {b.x, b.y}), window);
  if (!kept) return invisible;
  if (const auto* s = boost::get<kernel::Segment_2>(&*kept))
    return {s->source().x(), s->source().y(), s->target().x(), s->target().y()};
  const auto& p = boost::get<kernel::Point_2>(*kept);
  return {p.x(), p.y(), p.x(), p.y()};
}
#endif

#ifdef IRG_HAVE_OPENCV_IMGPROC
// The window from -1 to 1 on a grid of 2^-20.
ends opencv_clip(const point2& a, const point2& b) {
  const auto on_grid = [](double x) { return static_cast<std::int64_t>(std::llround(x * 0x1p20)) + (1 << 20); };
  const auto back = [](std::int64_t x) { return static_cast<double>(x - (1 << 20)) * 0x1p-20; };
  cv::Point2l p(on_grid(a.x), on_grid(a.y)), q(on_grid(b.x), on_grid(b.y));
  if (!cv::clipLine(cv::Size2l((1 << 21) + 1, (1 << 21) + 1), p, q)) return invisible;
  return {back(p.x), back(p.y), back(q.x), back(q.y)};
}
#endif

}  // namespace

int main(int argc, char** argv) {
  bench::study s("clip of a line by a window", "segment", bench::error_unit::ulp);
  for (const set& one : bench::keep(sets())) {
    const auto& items = one.segments;
    const box2& w = one.window;
    const std::array<point2, 4> ring{w.low, {w.high.x, w.low.y}, w.high, {w.low.x, w.high.y}};
    const auto exact = [w](const std::array<point2, 2>& p, bench::exact_results& out) {
      const std::size_t before = out.size();
      liang_barsky<real>(w, p[0], p[1], [&](const real& x) {
        out.push_back(x.result());
        return 0.0;
      });
      out.resize(before + 4, bench::exact_result{none});
    };
    const bench::distribution d{one.name, items.size(), 4, bench::exact_for(items, exact)};
    const auto entry = [&](const char* name, auto clip) {
      return bench::for_each_vector<4>(name, items, [clip](const auto& p) { return ends_of(clip(p[0], p[1])); });
    };
    using P = const point2&;
    std::vector<bench::implementation> who{
        entry("irg", [w](P a, P b) { return irg::clip_line_liang_barsky(a, b, w); }),
        entry("irg: Cohen-Sutherland", [w](P a, P b) { return irg::clip_line_cohen_sutherland(a, b, w); }),
        entry("irg: Nicholl-Lee-Nicholl", [w](P a, P b) { return irg::clip_line_nicholl_lee_nicholl(a, b, w); }),
        entry("irg: Cyrus-Beck", [ring](P a, P b) { return irg::clip_line_cyrus_beck(a, b, ring); }),
        bench::for_each_vector<4>(
            "Liang-Barsky in double", items,
            [w](const auto& p) { return liang_barsky<double>(w, p[0], p[1], [](double x) { return x; }); }),
        bench::for_each_vector<4>("Liang-Barsky in float", items, [w](const auto& p) {
          return liang_barsky<float>(w, p[0], p[1], [](float x) { return static_cast<double>(x); });
        })};
#ifdef IRG_HAVE_CGAL
    who.push_back(
        bench::for_each_vector<4>("CGAL intersection", items, [w](const auto& p) { return cgal_clip(w, p[0], p[1]); }));
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
    if (w.high.x == 1)
      who.push_back(bench::for_each_vector<4>(
          "OpenCV clipLine (2^-20 grid)", items, [](const auto& p) { return opencv_clip(p[0], p[1]); }, false));
#endif
    s.panel(d, who, bench::text_of_items(items));
  }
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_clip_line: skipped, MPFR was not found"); }
#endif
