// SPDX-License-Identifier: MIT
// Clipping: convex polygons against a window, and segments against a window. Time per polygon or segment, and how far
// the corners of the results are from the exact ones; polygons include the area of what is left, so that results are
// used.
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <irg/geometry/clip_line_cohen_sutherland.hpp>
#include <irg/geometry/clip_line_cyrus_beck.hpp>
#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/geometry/clip_line_nicholl_lee_nicholl.hpp>
#include <irg/geometry/clip_sutherland_hodgman.hpp>

#ifdef IRG_HAVE_POLYCLIPPING
#include <polyclipping/clipper.hpp>
#endif
#ifdef IRG_HAVE_BOOST
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
#include <opencv2/imgproc.hpp>
#endif

#include "support/measure.hpp"

namespace {

using P = irg::point<double, 2>;
using polygon = std::vector<P>;
const irg::box<double, 2> window{{200, 200}, {800, 800}};

template <class Ring>
double twice_area(const Ring& ring, std::size_t n) {
  double area = 0;
  for (std::size_t i = 0, last = n - 1; i < n; last = i++) area += ring[last].x * ring[i].y - ring[last].y * ring[i].x;
  return area;
}

// ---- The textbook's passes, one for each boundary that the polygon's box is beyond, with the textbook's cuts.

template <class In, class Cut>
std::size_t textbook_pass(const P* from, std::size_t n, P* to, In in, Cut cut) {
  std::size_t m = 0;
  P p = from[n - 1];
  bool p_in = in(p);
  for (std::size_t i = 0; i < n; ++i) {
    const P q = from[i];
    const bool q_in = in(q);
    if (p_in != q_in) to[m++] = cut(p, q);
    if (q_in) to[m++] = q;
    p = q, p_in = q_in;
  }
  return m;
}

std::size_t textbook_clip(const polygon& given, const irg::box<double, 2>& w, P* out, P* room) {
  std::size_t n = given.size();
  double low[2] = {given[0].x, given[0].y}, high[2] = {given[0].x, given[0].y};
  for (const P& p : given)
    for (int k = 0; k < 2; ++k) low[k] = p[k] < low[k] ? p[k] : low[k], high[k] = high[k] < p[k] ? p[k] : high[k];
  const P* from = given.data();
  P *to = room, *next = out;
  for (int k = 0; k < 2; ++k)
    for (int side = 0; side < 2; ++side) {
      const double bound = side == 0 ? w.low[k] : w.high[k];
      if (side == 0 ? low[k] >= bound : high[k] <= bound) continue;
      n = textbook_pass(
          from, n, to, [&](const P& p) { return side == 0 ? p[k] >= bound : p[k] <= bound; },
          [&](const P& p, const P& q) {
            P cut;
            cut[k] = bound, cut[1 - k] = p[1 - k] + (q[1 - k] - p[1 - k]) * (bound - p[k]) / (q[k] - p[k]);
            return cut;
          });
      if (n == 0) return 0;
      from = to;
      std::swap(to, next);
    }
  if (from != out) std::copy(from, from + n, out);
  return n;
}

// ---- The exact area of what is left, nearly: the same passes in long double.

double exact_area(const polygon& given, const irg::box<double, 2>& w) {
  using L = std::array<long double, 2>;
  std::vector<L> from, to;
  for (const P& p : given) from.push_back({p.x, p.y});
  for (std::size_t k = 0; k < 2; ++k)
    for (int side = 0; side < 2; ++side) {
      const long double bound = side == 0 ? w.low[static_cast<int>(k)] : w.high[static_cast<int>(k)];
      const auto in = [&](const L& p) { return side == 0 ? p[k] >= bound : p[k] <= bound; };
      to.clear();
      for (std::size_t i = 0; i < from.size(); ++i) {
        const L &p = from[i], &q = from[(i + 1) % from.size()];
        if (in(p)) to.push_back(p);
        if (in(p) == in(q)) continue;
        L cut;
        cut[k] = bound, cut[1 - k] = p[1 - k] + (q[1 - k] - p[1 - k]) * (bound - p[k]) / (q[k] - p[k]);
        to.push_back(cut);
      }
      from.swap(to);
    }
  long double area = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const L &p = from[i], &q = from[(i + 1) % from.size()];
    area += p[0] * q[1] - p[1] * q[0];
  }
  return static_cast<double>(area);
}

void polygons(int corners) {
  std::mt19937_64 random(static_cast<std::uint64_t>(corners));
  std::uniform_real_distribution<double> unit(0, 1);
  const std::size_t count = bench::smoke() ? 50 : 1000;
  auto& given = bench::keep(std::vector<polygon>(count));
  for (polygon& ring : given) {
    const P centre{1000 * unit(random), 1000 * unit(random)};
    const double radius = 50 + 300 * unit(random), turn = 6.283185307179586 * unit(random);
    for (int i = 0; i < corners; ++i) {
      const double angle = turn + 6.283185307179586 * i / corners;
      ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
  }
  const bench::contest c{"clip", "polygon " + std::to_string(corners), "polygon", static_cast<std::int64_t>(count),
                         "area"};
  const auto add = [&given, count, c](const char* name, bool same_work, const char* note, auto area_of) {
    auto& areas = bench::keep(std::vector<double>(count));
    bench::contender who{name, [&areas, count, area_of]() mutable {
                           for (std::size_t i = 0; i < count; ++i) areas[i] = area_of(i);
                           asm volatile("" : : "r"(areas.data()) : "memory");
                         }};
    who.judge = [&areas, &given, count] {
      bench::errors e{0, 0, 0};
      for (std::size_t i = 0; i < count; ++i) {
        const double exact = exact_area(given[i], window), off = std::abs(areas[i] - exact) / 2;
        e.max = std::max(e.max, off), e.mean += off / static_cast<double>(count);
        e.wrong += off > 1e-3 * (1 + std::abs(exact));
      }
      return e;
    };
    who.same_work = same_work;
    who.note = note;
    bench::enter(c, std::move(who));
  };
  add("irg", true, "cuts correctly rounded", [&given, out = std::vector<P>(200)](std::size_t i) mutable {
    const std::size_t n = clip_sutherland_hodgman(given[i], window, out);
    return n == 0 ? 0.0 : twice_area(out, n);
  });
  add("textbook", true, "fixed memory; boundaries that the box keeps are skipped",
      [&given, out = std::vector<P>(200), room = std::vector<P>(200)](std::size_t i) mutable {
        const std::size_t n = textbook_clip(given[i], window, out.data(), room.data());
        return n == 0 ? 0.0 : twice_area(out, n);
      });
#ifdef IRG_HAVE_POLYCLIPPING
  const double grid = 0x1p20;
  auto& paths = bench::keep(std::vector<ClipperLib::Path>());
  for (const polygon& ring : given) {
    paths.emplace_back();
    for (const P& p : ring)
      paths.back().emplace_back(static_cast<ClipperLib::cInt>(std::llround(p.x * grid)),
                                static_cast<ClipperLib::cInt>(std::llround(p.y * grid)));
  }
  const ClipperLib::Path frame{
      {200 << 20, 200 << 20}, {800 << 20, 200 << 20}, {800 << 20, 800 << 20}, {200 << 20, 800 << 20}};
  add("Clipper 6.4", true, "on a grid of 2^-20", [&paths, frame, grid](std::size_t i) {
    ClipperLib::Clipper clipper;
    clipper.AddPath(paths[i], ClipperLib::ptSubject, true);
    clipper.AddPath(frame, ClipperLib::ptClip, true);
    ClipperLib::Paths result;
    clipper.Execute(ClipperLib::ctIntersection, result);
    double area = 0;
    for (const auto& path : result) area += 2 * ClipperLib::Area(path);
    return area / (grid * grid);
  });
#endif
#ifdef IRG_HAVE_BOOST
  namespace bg = boost::geometry;
  using boost_point = bg::model::d2::point_xy<double>;
  using boost_polygon = bg::model::polygon<boost_point, false, false>;
  const bg::model::box<boost_point> boost_window({200, 200}, {800, 800});
  auto& boost_given = bench::keep(std::vector<boost_polygon>());
  for (const polygon& ring : given) {
    boost_given.emplace_back();
    for (const P& p : ring) bg::append(boost_given.back().outer(), boost_point(p.x, p.y));
  }
  add("Boost.Geometry", true, "", [&boost_given, boost_window](std::size_t i) {
    std::vector<boost_polygon> result;
    bg::intersection(boost_given[i], boost_window, result);
    double area = 0;
    for (const auto& r : result) area += 2 * bg::area(r);
    return area;
  });
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  auto& cv_given = bench::keep(std::vector<std::vector<cv::Point2f>>());
  for (const polygon& ring : given) {
    cv_given.emplace_back();
    for (const P& p : ring) cv_given.back().emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
  }
  const std::vector<cv::Point2f> cv_window{{200, 200}, {800, 200}, {800, 800}, {200, 800}};
  add("OpenCV", false, "intersectConvexConvex; float", [&cv_given, cv_window](std::size_t i) {
    std::vector<cv::Point2f> result;
    return 2 * static_cast<double>(cv::intersectConvexConvex(cv_given[i], cv_window, result));
  });
#endif
}

// ---- Segments. The error is the distance of a cut coordinate from the exact one in ulp; wrong are ends outside the
// window, and segments that are said to be visible when they are not, or the other way round.

struct cut_line {
  bool visible;
  double x1, y1, x2, y2;
};

// Liang and Barsky's program as textbooks have it.
template <class T>
cut_line textbook_line(T x1, T y1, T x2, T y2) {
  const T dx = x2 - x1, dy = y2 - y1;
  T low = 0, high = 1;
  const auto narrow = [&](T p, T q) {
    if (p == 0) return q >= 0;
    const T t = q / p;
    if (p < 0 ? t > high : t < low) return false;
    (p < 0 ? low : high) = p < 0 ? (t > low ? t : low) : (t < high ? t : high);
    return true;
  };
  if (!narrow(-dx, x1 - T(200)) || !narrow(dx, T(800) - x1) || !narrow(-dy, y1 - T(200)) || !narrow(dy, T(800) - y1))
    return {false, 0, 0, 0, 0};
  const auto wide = [](T v) { return static_cast<double>(v); };
  return {true, wide(x1 + low * dx), wide(y1 + low * dy), wide(x1 + high * dx), wide(y1 + high * dy)};
}

using segment = std::array<P, 2>;

bench::errors judge_segments(const std::vector<segment>& given, const std::vector<cut_line>& results) {
  const auto off_in_ulp = [](double x, long double exact) {
    const double ulp = std::nextafter(std::abs(x), 1e300) - std::abs(x);
    return static_cast<double>(std::abs(static_cast<long double>(x) - exact) / static_cast<long double>(ulp));
  };
  bench::errors e{0, 0, 0};
  double visible = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const cut_line& c = results[i];
    const auto exact = clip_line_liang_barsky(given[i][0], given[i][1], window);
    e.wrong += c.visible == exact.has_value() ? 0 : 1;
    if (!c.visible || !exact) continue;
    ++visible;
    const double ends[2][2] = {{c.x1, c.y1}, {c.x2, c.y2}};
    for (int end = 0; end < 2; ++end) {
      e.wrong += irg::contains(window, P{ends[end][0], ends[end][1]}) ? 0 : 1;
      const P right = end == 0 ? exact->first : exact->second;
      for (int axis = 0; axis < 2; ++axis) {
        // The exact coordinate in long double, from the boundary that the line is cut at.
        const P a = given[i][0], b = given[i][1];
        long double there = right[axis];
        const int other = 1 - axis;
        if (!(right == a) && !(right == b) &&
            (right[other] == window.low[other] || right[other] == window.high[other])) {
          using L = long double;
          there =
              L(a[axis]) + (L(b[axis]) - L(a[axis])) * ((L(right[other]) - L(a[other])) / (L(b[other]) - L(a[other])));
        }
        const double off = off_in_ulp(ends[end][axis], there);
        e.max = std::max(e.max, off), e.mean += off;
      }
    }
  }
  e.mean /= 4 * visible;
  return e;
}

void segments() {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(0, 1000);
  const std::size_t count = bench::smoke() ? 200 : 4000;
  auto& given = bench::keep(std::vector<segment>(count));
  for (auto& s : given)
    for (P& p : s) p.x = unit(random), p.y = unit(random);
  const bench::contest c{"clip", "segment", "segment", static_cast<std::int64_t>(count), "ulp"};
  const auto add = [&given, c](const char* name, bool same_work, const char* note, auto clip) {
    auto& results = bench::keep(std::vector<cut_line>(given.size()));
    bench::contender who{name, [&results, &given, clip] {
                           for (std::size_t i = 0; i < given.size(); ++i) results[i] = clip(given[i][0], given[i][1]);
                           asm volatile("" : : "r"(results.data()) : "memory");
                         }};
    who.judge = [&results, &given] { return judge_segments(given, results); };
    who.same_work = same_work;
    who.note = note;
    bench::enter(c, std::move(who));
  };
  const auto plain = [](const auto& kept) {
    if (!kept) return cut_line{false, 0, 0, 0, 0};
    return cut_line{true, kept->first.x, kept->first.y, kept->second.x, kept->second.y};
  };
  const std::array<P, 4> ring{P{200, 200}, P{800, 200}, P{800, 800}, P{200, 800}};
  add("irg:liang_barsky", true, "",
      [plain](const P& a, const P& b) { return plain(clip_line_liang_barsky(a, b, window)); });
  add("irg:cohen_sutherland", true, "",
      [plain](const P& a, const P& b) { return plain(clip_line_cohen_sutherland(a, b, window)); });
  add("irg:nicholl_lee_nicholl", true, "",
      [plain](const P& a, const P& b) { return plain(clip_line_nicholl_lee_nicholl(a, b, window)); });
  add("irg:cyrus_beck", true, "any convex polygon",
      [plain, ring](const P& a, const P& b) { return plain(clip_line_cyrus_beck(a, b, ring)); });
  add("textbook", true, "Liang-Barsky in double",
      [](const P& a, const P& b) { return textbook_line(a.x, a.y, b.x, b.y); });
#ifdef IRG_HAVE_BOOST
  namespace bg = boost::geometry;
  using boost_point = bg::model::d2::point_xy<double>;
  const bg::model::box<boost_point> boost_window({200, 200}, {800, 800});
  add("Boost.Geometry", true, "intersection of linestring and box", [boost_window](const P& a, const P& b) {
    bg::model::linestring<boost_point> line;
    line.emplace_back(a.x, a.y), line.emplace_back(b.x, b.y);
    std::vector<bg::model::linestring<boost_point>> kept;
    bg::intersection(line, boost_window, kept);
    if (kept.empty()) return cut_line{false, 0, 0, 0, 0};
    return cut_line{true, kept[0][0].x(), kept[0][0].y(), kept[0].back().x(), kept[0].back().y()};
  });
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  add("OpenCV", false, "clipLine; integers", [](const P& a, const P& b) {
    cv::Point p(static_cast<int>(a.x), static_cast<int>(a.y)), q(static_cast<int>(b.x), static_cast<int>(b.y));
    const bool visible = cv::clipLine(cv::Rect(200, 200, 601, 601), p, q);
    return cut_line{visible, static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(q.x),
                    static_cast<double>(q.y)};
  });
#endif
}

}  // namespace

int main(int argc, char** argv) {
  for (const int corners : {4, 8, 64}) polygons(corners);
  segments();
  return bench::run_benchmarks(argc, argv);
}
