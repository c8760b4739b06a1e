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
#if __has_include(<boost/geometry.hpp>)
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#define WITH_BOOST 1
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

struct judged {
  bench::contender racer;
  std::string same_work, note;
  std::vector<double>* areas;
};

void polygons(int corners) {
  std::mt19937_64 random(static_cast<std::uint64_t>(corners));
  std::uniform_real_distribution<double> unit(0, 1);
  const std::size_t count = bench::smoke() ? 50 : 1000;
  std::vector<polygon> given(count);
  for (polygon& ring : given) {
    const P centre{1000 * unit(random), 1000 * unit(random)};
    const double radius = 50 + 300 * unit(random), turn = 6.283185307179586 * unit(random);
    for (int i = 0; i < corners; ++i) {
      const double angle = turn + 6.283185307179586 * i / corners;
      ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
  }
  std::vector<judged> all;
  std::vector<std::vector<double>> areas(8, std::vector<double>(count));
  const auto add = [&](const char* name, const char* same_work, const char* note, auto area_of) {
    std::vector<double>& mine = areas[all.size()];
    all.push_back({{name,
                    [&mine, count, area_of] {
                      for (std::size_t i = 0; i < count; ++i) mine[i] = area_of(i);
                      asm volatile("" : : "r"(mine.data()) : "memory");
                    }},
                   same_work,
                   note,
                   &mine});
  };
  std::vector<P> out(200), room(200);
  add("irg", "yes", "cuts correctly rounded", [&](std::size_t i) {
    const std::size_t n = clip_sutherland_hodgman(given[i], window, out);
    return n == 0 ? 0.0 : twice_area(out, n);
  });
  add("textbook", "yes", "fixed memory; boundaries that the box keeps are skipped", [&](std::size_t i) {
    const std::size_t n = textbook_clip(given[i], window, out.data(), room.data());
    return n == 0 ? 0.0 : twice_area(out, n);
  });
#ifdef IRG_HAVE_POLYCLIPPING
  const double grid = 0x1p20;
  std::vector<ClipperLib::Path> paths;
  for (const polygon& ring : given) {
    paths.emplace_back();
    for (const P& p : ring)
      paths.back().emplace_back(static_cast<ClipperLib::cInt>(std::llround(p.x * grid)),
                                static_cast<ClipperLib::cInt>(std::llround(p.y * grid)));
  }
  const ClipperLib::Path frame{
      {200 << 20, 200 << 20}, {800 << 20, 200 << 20}, {800 << 20, 800 << 20}, {200 << 20, 800 << 20}};
  add("Clipper 6.4", "yes", "on a grid of 2^-20", [&](std::size_t i) {
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
#ifdef WITH_BOOST
  namespace bg = boost::geometry;
  using boost_point = bg::model::d2::point_xy<double>;
  using boost_polygon = bg::model::polygon<boost_point, false, false>;
  const bg::model::box<boost_point> boost_window({200, 200}, {800, 800});
  std::vector<boost_polygon> boost_given;
  for (const polygon& ring : given) {
    boost_given.emplace_back();
    for (const P& p : ring) bg::append(boost_given.back().outer(), boost_point(p.x, p.y));
  }
  add("Boost.Geometry", "yes", "", [&](std::size_t i) {
    std::vector<boost_polygon> result;
    bg::intersection(boost_given[i], boost_window, result);
    double area = 0;
    for (const auto& r : result) area += 2 * bg::area(r);
    return area;
  });
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  std::vector<std::vector<cv::Point2f>> cv_given;
  for (const polygon& ring : given) {
    cv_given.emplace_back();
    for (const P& p : ring) cv_given.back().emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
  }
  const std::vector<cv::Point2f> cv_window{{200, 200}, {800, 200}, {800, 800}, {200, 800}};
  add("OpenCV", "no", "intersectConvexConvex; float", [&](std::size_t i) {
    std::vector<cv::Point2f> result;
    return 2 * static_cast<double>(cv::intersectConvexConvex(cv_given[i], cv_window, result));
  });
#endif
  std::vector<bench::contender> racers;
  for (const judged& j : all) racers.push_back(j.racer);
  bench::race(racers, 21, 1e-3);
  const std::string name = "polygon " + std::to_string(corners);
  for (std::size_t k = 0; k < all.size(); ++k) {
    double most = 0, sum = 0;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double exact = exact_area(given[i], window), off = std::abs((*all[k].areas)[i] - exact) / 2;
      most = std::max(most, off), sum += off;
      wrong += off > 1e-3 * (1 + std::abs(exact)) ? 1u : 0u;
    }
    const double ns = racers[k].median() / static_cast<double>(count) * 1e9;
    std::printf("  %-12s %-26s %9.1f ns   %6.3f of it   area off by %.2g at most, %zu wrong\n", name.c_str(),
                racers[k].name.c_str(), ns, racers[0].median() / racers[k].median(), most, wrong);
    bench::report({.kernel = "clip",
                   .test_case = name,
                   .implementation = racers[k].name,
                   .same_work = all[k].same_work,
                   .ns_per_item = ns,
                   .items = static_cast<std::int64_t>(count),
                   .item = "polygon",
                   .max_error = bench::number(most),
                   .mean_error = bench::number(sum / static_cast<double>(count)),
                   .error_unit = "area",
                   .wrong = std::to_string(wrong),
                   .note = all[k].note});
  }
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

void segments() {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(0, 1000);
  const std::size_t count = bench::smoke() ? 200 : 4000;
  std::vector<std::array<P, 2>> given(count);
  for (auto& s : given)
    for (P& p : s) p.x = unit(random), p.y = unit(random);
  struct entry {
    bench::contender racer;
    std::string same_work, note;
  };
  std::vector<entry> all;
  std::vector<std::vector<cut_line>> results(8, std::vector<cut_line>(count));
  const auto add = [&](const char* name, const char* same_work, const char* note, auto clip) {
    std::vector<cut_line>& mine = results[all.size()];
    all.push_back({{name,
                    [&mine, &given, count, clip] {
                      for (std::size_t i = 0; i < count; ++i) mine[i] = clip(given[i][0], given[i][1]);
                      asm volatile("" : : "r"(mine.data()) : "memory");
                    }},
                   same_work,
                   note});
  };
  const auto plain = [](const auto& kept) {
    if (!kept) return cut_line{false, 0, 0, 0, 0};
    return cut_line{true, kept->first.x, kept->first.y, kept->second.x, kept->second.y};
  };
  const std::array<P, 4> ring{P{200, 200}, P{800, 200}, P{800, 800}, P{200, 800}};
  add("irg:liang_barsky", "yes", "",
      [&](const P& a, const P& b) { return plain(clip_line_liang_barsky(a, b, window)); });
  add("irg:cohen_sutherland", "yes", "",
      [&](const P& a, const P& b) { return plain(clip_line_cohen_sutherland(a, b, window)); });
  add("irg:nicholl_lee_nicholl", "yes", "",
      [&](const P& a, const P& b) { return plain(clip_line_nicholl_lee_nicholl(a, b, window)); });
  add("irg:cyrus_beck", "yes", "any convex polygon",
      [&](const P& a, const P& b) { return plain(clip_line_cyrus_beck(a, b, ring)); });
  add("textbook", "yes", "Liang-Barsky in double",
      [](const P& a, const P& b) { return textbook_line(a.x, a.y, b.x, b.y); });
#ifdef WITH_BOOST
  namespace bg = boost::geometry;
  using boost_point = bg::model::d2::point_xy<double>;
  const bg::model::box<boost_point> boost_window({200, 200}, {800, 800});
  add("Boost.Geometry", "yes", "intersection of linestring and box", [&](const P& a, const P& b) {
    bg::model::linestring<boost_point> line;
    line.emplace_back(a.x, a.y), line.emplace_back(b.x, b.y);
    std::vector<bg::model::linestring<boost_point>> kept;
    bg::intersection(line, boost_window, kept);
    if (kept.empty()) return cut_line{false, 0, 0, 0, 0};
    return cut_line{true, kept[0][0].x(), kept[0][0].y(), kept[0].back().x(), kept[0].back().y()};
  });
#endif
#ifdef IRG_HAVE_OPENCV_IMGPROC
  add("OpenCV", "no", "clipLine; integers", [](const P& a, const P& b) {
    cv::Point p(static_cast<int>(a.x), static_cast<int>(a.y)), q(static_cast<int>(b.x), static_cast<int>(b.y));
    const bool visible = cv::clipLine(cv::Rect(200, 200, 601, 601), p, q);
    return cut_line{visible, static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(q.x),
                    static_cast<double>(q.y)};
  });
#endif
  std::vector<bench::contender> racers;
  for (const entry& e : all) racers.push_back(e.racer);
  bench::race(racers, 21, 1e-3);
  const auto off_in_ulp = [](double x, long double exact) {
    const double ulp = std::nextafter(std::abs(x), 1e300) - std::abs(x);
    return static_cast<double>(std::abs(static_cast<long double>(x) - exact) / static_cast<long double>(ulp));
  };
  for (std::size_t k = 0; k < all.size(); ++k) {
    double most = 0, sum = 0;
    std::size_t wrong = 0, visible = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const cut_line& c = results[k][i];
      const auto exact = clip_line_liang_barsky(given[i][0], given[i][1], window);
      wrong += c.visible == exact.has_value() ? 0u : 1u;
      if (!c.visible || !exact) continue;
      ++visible;
      const double ends[2][2] = {{c.x1, c.y1}, {c.x2, c.y2}};
      for (int e = 0; e < 2; ++e) {
        wrong += irg::contains(window, P{ends[e][0], ends[e][1]}) ? 0u : 1u;
        const P right = e == 0 ? exact->first : exact->second;
        for (int axis = 0; axis < 2; ++axis) {
          // The exact coordinate in long double, from the boundary that the line is cut at.
          const P a = given[i][0], b = given[i][1];
          long double there = right[axis];
          const int other = 1 - axis;
          if (!(right == a) && !(right == b) &&
              (right[other] == window.low[other] || right[other] == window.high[other])) {
            using L = long double;
            there = L(a[axis]) +
                    (L(b[axis]) - L(a[axis])) * ((L(right[other]) - L(a[other])) / (L(b[other]) - L(a[other])));
          }
          const double off = off_in_ulp(ends[e][axis], there);
          most = std::max(most, off), sum += off;
        }
      }
    }
    const double ns = racers[k].median() / static_cast<double>(count) * 1e9;
    const double mean = sum / (4 * static_cast<double>(visible));
    std::printf("  %-12s %-26s %9.1f ns   off by %.3g ulp at most, %.2g on average, %zu wrong\n", "segment",
                racers[k].name.c_str(), ns, most, mean, wrong);
    bench::report({.kernel = "clip",
                   .test_case = "segment",
                   .implementation = racers[k].name,
                   .same_work = all[k].same_work,
                   .ns_per_item = ns,
                   .items = static_cast<std::int64_t>(count),
                   .item = "segment",
                   .max_error = bench::number(most),
                   .mean_error = bench::number(mean),
                   .error_unit = "ulp",
                   .wrong = std::to_string(wrong),
                   .note = all[k].note});
  }
}

}  // namespace

int main() {
  bench::stay_on_this_processor();
  for (const int corners : {4, 8, 64}) polygons(corners);
  segments();
  return 0;
}
