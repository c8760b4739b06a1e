// SPDX-License-Identifier: MIT
// What comes out of clip_sutherland_hodgman, corner by corner, against rationals (GMP): of each edge the part in the region
// by its parameters, in the order of the edges, rounded; the rest are corners of the region, and the area is right.
// Regions and polygons of all sizes, in and beside each other.
#include <irg/geometry/clip_sutherland_hodgman.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <irg/geometry/textbook/clip_sutherland_hodgman.hpp>
#include <irg/geometry/convex_hull.hpp>

#include "line_clip_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

template <class T>
using ring = std::vector<irg::point<T, 2>>;

// A slanted region inside of a square of this size comes back as it is, and so it does when it is clipped again.
template <class T>
constexpr bool returns_region(T size) {
  using P = irg::point<T, 2>;
  const std::array<P, 4> square{P{-size, -size}, P{size, -size}, P{size, size}, P{-size, size}};
  const std::array<P, 3> region{P{T(0.1), T(0.3)}, P{T(0.7), T(0.2)}, P{T(0.6), T(0.9)}};
  const std::array<P, 3> clockwise{region[2], region[1], region[0]};
  for (const auto& r : {region, clockwise}) {
    const ring<T> kept = clip_sutherland_hodgman(square, r);
    if (kept.size() != 3 || clip_sutherland_hodgman(kept, r) != kept) return false;
    for (const P& p : kept)
      if (!(p == region[0] || p == region[1] || p == region[2])) return false;
  }
  return true;
}

}  // namespace

static_assert(returns_region(1e9) && returns_region(1e18) && returns_region(1e300) && returns_region(1e9f));

TEST_CASE("clip_sutherland_hodgman: a region in a polygon of any size comes back as it is") {
  for (double size = 1; size < 1e308; size *= 9) CHECK(returns_region(size));
  for (float size = 1; size < 1e38f; size *= 9) CHECK(returns_region(size));
}

TEST_CASE("clip_sutherland_hodgman: planes: polygons that are not flat stay in the region, and what comes out stays") {
  using S = irg::point<double, 3>;
  using A = irg::attributed_point<double, 3, 1>;
  test::random r(17);
  int changed = 0, outside = 0, apart = 0, not_empty = 0;
  for (int k = 0; k < line_cases::release_or(4000); ++k) {
    const auto draw = [&] { return r.unit() * 2 - 1; };
    const double rough = std::ldexp(1.0, -static_cast<int>(r.integer(0, 60)));
    const S o{draw(), draw(), draw()}, u{draw(), draw(), draw()}, w{draw(), draw(), draw()};
    std::vector<S> polygon;
    const auto n = r.integer(4, 8);
    for (int i = 0; i < n; ++i) {
      const double c = 2 * std::cos(6.283185307179586 * i / static_cast<double>(n));
      const double s = 2 * std::sin(6.283185307179586 * i / static_cast<double>(n));
      const double x = rough * draw(), y = rough * draw(), z = rough * draw();
      polygon.push_back({o.x + c * u.x + s * w.x + x, o.y + c * u.y + s * w.y + y, o.z + c * u.z + s * w.z + z});
    }
    std::vector<irg::plane<double>> planes;
    for (auto m = r.integer(2, 6); m > 0; --m) planes.push_back({draw(), draw(), draw(), r.unit() * 0.3});
    const auto kept = clip_sutherland_hodgman(polygon, planes);
    not_empty += kept.empty() ? 0 : 1;
    changed += kept.empty() || clip_sutherland_hodgman(kept, planes) == kept ? 0 : 1;
    for (const S& p : kept)
      for (const auto& l : planes) outside += irg::plane_value(l, p) < -4e-15 ? 1 : 0;
    std::vector<A> carrying;
    for (const S& p : polygon) carrying.push_back({p, {p.x}});
    const auto carried = clip_sutherland_hodgman(carrying, planes);
    apart += carried.size() == kept.size() ? 0 : 1;
    for (std::size_t i = 0; i < kept.size() && i < carried.size(); ++i) {
      apart += carried[i].position == kept[i] ? 0 : 1;
      apart += std::abs(carried[i].attributes[0] - kept[i].x) <= 1e-12 + 20 * rough ? 0 : 1;
    }
  }
  CHECK(changed == 0);
  CHECK(outside == 0);
  CHECK(apart == 0);
  CHECK(not_empty > 1000);
}

#ifdef IRG_HAVE_MPFR
namespace {

using line_cases::mpq;
using exact_place = irg::point<mpq, 2>;

template <class T>
mpq q(T x) {
  return mpq(static_cast<double>(x));
}

template <class P>
void leave_out_twins(std::vector<P>& places) {
  places.erase(std::unique(places.begin(), places.end()), places.end());
  while (places.size() > 1 && places.front() == places.back()) places.pop_back();
}
template <class P>
bool same_cycle(const std::vector<P>& a, std::vector<P> b) {
  for (std::size_t shift = 0; shift < b.size(); ++shift) {
    if (a == b) return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return a == b;
}

// The parts of a polygon's edges on the inner sides of boundaries, end by end. value(k, p) is a boundary's.
template <class P, class E, class Value>
std::vector<P> visible_ends(const std::vector<P>& polygon, std::size_t boundaries, const Value& value) {
  using T = irg::scalar_of<P>;
  const auto exact = [](const P& p) {
    return irg::generate_coordinates<E>([&](int i) { return q(irg::coordinate(p, i)); });
  };
  std::vector<P> ends;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const E a = exact(polygon[i]), b = exact(polygon[(i + 1) % polygon.size()]);
    mpq first(0), last(1);
    bool visible = true, starts_inside = true;
    for (std::size_t k = 0; k < boundaries; ++k) {
      const mpq at_a = value(k, a), at_b = value(k, b);
      starts_inside = starts_inside && at_a.sign() >= 0;
      if (at_a.sign() < 0 && at_b.sign() < 0) visible = false;
      if (at_a.sign() < 0 && at_b.sign() >= 0) first = std::max(first, at_a / (at_a - at_b));
      if (at_a.sign() >= 0 && at_b.sign() < 0) last = std::min(last, at_a / (at_a - at_b));
    }
    const auto at = [&](const mpq& t) {
      return irg::generate_coordinates<P>([&](int axis) {
        const mpq &from = irg::coordinate(a, axis), &to = irg::coordinate(b, axis);
        return nearest<T>(from + t * (to - from)) + T(0);
      });
    };
    if (starts_inside) ends.push_back(polygon[i]);
    if (!visible || last < first) continue;
    if (mpq(0) < first && first < mpq(1)) ends.push_back(at(first));
    if (first < last && last < mpq(1)) ends.push_back(at(last));
  }
  return ends;
}

// How the numbers of a case are drawn: around a middle, of a size, or with any exponent at all.
template <class T>
struct frame {
  double x = 0, y = 0, size = 1;
  bool lattice = false, any = false;

  irg::point<T, 2> draw(test::random& r) const {
    const auto number = [&](double middle) -> T {
      constexpr int least = std::numeric_limits<T>::min_exponent, most = std::numeric_limits<T>::max_exponent;
      if (lattice) return static_cast<T>(r.integer(-4, 4));
      const double unit = r.unit() * 2 - 1;
      if (any) return static_cast<T>(std::ldexp(unit, static_cast<int>(r.integer(least, most))));
      return static_cast<T>(middle + size * unit);
    };
    const T a = number(x), b = number(y);
    return {a, b};
  }
};

template <class T>
struct clip_case {
  ring<T> polygon, region;
};

template <class T>
T nudged(test::random& r, T x) {
  for (auto k = r.integer(-2, 2); k != 0; k += k < 0 ? 1 : -1)
    x = std::nextafter(x, k < 0 ? -std::numeric_limits<T>::max() : std::numeric_limits<T>::max());
  return x;
}

template <class T>
clip_case<T> draw_clip_case(test::random& r) {
  constexpr int exponents = sizeof(T) == 8 ? 900 : 110;
  frame<T> of_polygon, of_region;
  const auto kind = r.integer(0, 8);
  if (kind == 1) of_polygon.lattice = of_region.lattice = true;
  if (kind == 2) of_polygon.any = of_region.any = true;
  if (kind == 3) of_polygon.size = std::pow(10.0, 30 * r.unit()), of_region.x = r.unit(), of_region.y = r.unit();
  if (kind == 4) {
    const double offset = std::ldexp(1.0, static_cast<int>(r.integer(0, sizeof(T) == 8 ? 50 : 20)));
    of_region.x = of_polygon.x = offset * r.unit(), of_region.y = of_polygon.y = -offset * r.unit();
    of_polygon.size = std::pow(10.0, 9 * r.unit());
  }
  if (kind == 5) {
    of_region.size = std::ldexp(1.0, -static_cast<int>(r.integer(0, exponents)));
    of_polygon.size = std::ldexp(1.0, static_cast<int>(r.integer(-exponents, exponents)));
  }
  if (kind == 8) of_polygon.size = 4;
  clip_case<T> c;
  ring<T> cloud;
  for (auto n = r.integer(3, 7); n > 0; --n) cloud.push_back(of_region.draw(r));
  if (kind == 7) {  // a needle
    const T y = static_cast<T>(r.unit() * 1e-6);
    cloud = {{T(1), T(0)}, {T(1), y}, {static_cast<T>(-1 - r.unit()), static_cast<T>(r.unit() * 1e-8)}};
  }
  for (const auto i : irg::convex_hull(cloud)) c.region.push_back(cloud[i]);
  if (r.integer(0, 1) != 0) std::reverse(c.region.begin(), c.region.end());
  for (auto n = r.integer(3, 7); n > 0; --n) c.polygon.push_back(of_polygon.draw(r));
  if (kind >= 6 && c.region.size() > 2)  // near or on the region's boundary
    for (auto& p : c.polygon)
      if (const auto i = static_cast<std::size_t>(r.integer(0, 9)); i < c.region.size()) {
        const auto a = c.region[i], b = c.region[(i + 1) % c.region.size()];
        const T t = r.integer(0, 2) == 0 ? T(0) : static_cast<T>(r.unit());
        p = {nudged(r, a.x + t * (b.x - a.x)), nudged(r, a.y + t * (b.y - a.y))};
      }
  return c;
}

// Twice the area of the region's part that lies in a ring, and what moving corners by half an ulp may change of it.
template <class R>
mpq twice_area(const R& places) {
  mpq sum(0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto &p = places[i], &next = places[i + 1 < places.size() ? i + 1 : 0];
    sum = sum + (mpq(p.x) * mpq(next.y) - mpq(p.y) * mpq(next.x));
  }
  return sum;
}
template <class T>
mpq area_tolerance(const ring<T>& region, std::size_t corners) {
  mpq ulp[2], extent[2];
  for (int i = 0; i < 2; ++i) {
    T low = region[0][i], high = low;
    for (const auto& p : region) low = std::min(low, p[i]), high = std::max(high, p[i]);
    const T size = std::max(std::abs(low), std::abs(high));
    ulp[i] = q(size) - q(std::nextafter(size, T(0))) + q(std::numeric_limits<T>::denorm_min());
    extent[i] = q(high) - q(low) + ulp[i];
  }
  return mpq(static_cast<int>(4 * corners + 4)) * (ulp[0] * extent[1] + ulp[1] * extent[0]);
}

// Whether points of the region round to p, or lie midway between it and the next number.
template <class T>
bool rounds_to(const irg::point<T, 2>& p, const std::vector<irg::line<mpq>>& lines) {
  constexpr T most = std::numeric_limits<T>::max();
  const auto midway = [&](T x, T to) { return (q(x) + q(std::nextafter(x, to))) / mpq(2); };
  const mpq left = midway(p.x, -most), right = midway(p.x, most), low = midway(p.y, -most), high = midway(p.y, most);
  const std::vector<exact_place> cell{{left, low}, {right, low}, {right, high}, {left, high}};
  return !irg::textbook::clip_sutherland_hodgman(cell, lines).empty();
}

struct verdict {
  int wrong = 0, changed = 0, not_empty = 0, with_region_corners = 0, kept_as_given = 0;
};

template <class T, class Region>
void judge(const clip_case<T>& c, const Region& region, verdict& v) {
  using P = irg::point<T, 2>;
  ring<T> ccw = c.region;
  std::vector<exact_place> exact, exact_region;
  for (const P& p : ccw) exact_region.push_back({q(p.x), q(p.y)});
  if (twice_area(exact_region).sign() < 0) {
    std::reverse(ccw.begin(), ccw.end());
    std::reverse(exact_region.begin(), exact_region.end());
  }
  std::vector<irg::line<mpq>> lines;
  for (std::size_t k = 0; k < ccw.size(); ++k) {
    const exact_place &a = exact_region[k], &b = exact_region[(k + 1) % ccw.size()];
    const mpq nx = a.y - b.y, ny = b.x - a.x;
    lines.push_back({nx, ny, -(nx * a.x + ny * a.y)});
  }
  for (const P& p : c.polygon) exact.push_back({q(p.x), q(p.y)});

  const ring<T> kept = clip_sutherland_hodgman(c.polygon, region);
  v.not_empty += kept.empty() ? 0 : 1;
  v.changed += kept.empty() || clip_sutherland_hodgman(kept, region) == kept ? 0 : 1;
  const auto is_region_corner = [&](const P& p) { return std::find(ccw.begin(), ccw.end(), p) != ccw.end(); };
  const auto without_region = [&](ring<T> places) {
    const auto end = std::remove_if(places.begin(), places.end(), is_region_corner);
    places.erase(end, places.end());
    leave_out_twins(places);
    return places;
  };
  const ring<T> ends = visible_ends<P, exact_place>(c.polygon, lines.size(), [&](std::size_t k, const exact_place& p) {
    return lines[k].a * p.x + lines[k].b * p.y + lines[k].c;
  });
  std::vector<exact_place> rounded;
  for (const P& p : kept) rounded.push_back({q(p.x), q(p.y)});
  const mpq area = twice_area(irg::textbook::clip_sutherland_hodgman(exact, lines));
  const bool same_area = !(area_tolerance(ccw, kept.size()) < abs(twice_area(rounded) - area));
  const bool same_corners = same_cycle(without_region(kept), without_region(ends));
  v.with_region_corners += std::any_of(kept.begin(), kept.end(), is_region_corner) ? 1 : 0;
  if (same_corners && same_area) return;
  if (kept.empty() && same_area) {  // no area, exactly or when rounded
    ring<T> all = ends;
    leave_out_twins(all);
    if (area.sign() == 0 || all.size() < 3) return;
  }
  ring<T> given = c.polygon;
  while (given.size() > 1 && given.front() == given.back()) given.pop_back();
  if (kept == given && std::all_of(kept.begin(), kept.end(), [&](const P& p) { return rounds_to(p, lines); })) {
    ++v.kept_as_given;
    return;
  }
  ++v.wrong;
}

template <class T>
verdict judge_convex(std::uint64_t seed, int rounds) {
  test::random r(seed);
  verdict v;
  for (int k = 0; k < rounds; ++k) {
    const auto c = draw_clip_case<T>(r);
    if (c.region.size() > 2) judge(c, c.region, v);
  }
  return v;
}
template <class T>
verdict judge_windows(std::uint64_t seed, int rounds) {
  test::random r(seed);
  verdict v;
  for (int k = 0; k < rounds; ++k) {
    auto c = draw_clip_case<T>(r);
    irg::box<T, 2> w;
    for (const auto& p : c.region) w = bounding_box(w, p);
    if (!(w.low.x < w.high.x && w.low.y < w.high.y)) continue;
    c.region = {w.low, {w.high.x, w.low.y}, w.high, {w.low.x, w.high.y}};
    judge(c, w, v);
  }
  return v;
}

// Space: a flat polygon against planes.
template <class T>
struct solid_case {
  std::vector<irg::point<T, 3>> polygon;
  std::vector<irg::plane<T>> planes;
};

template <class T>
solid_case<T> draw_solid_case(test::random& r) {
  constexpr int exponents = sizeof(T) == 8 ? 300 : 36;
  solid_case<T> c;
  const auto kind = r.integer(0, 5);
  const auto spread = [&](double size) { return static_cast<T>(size * (r.unit() * 2 - 1)); };
  const auto any = [&] {
    return static_cast<T>(std::ldexp(r.unit() * 2 - 1, static_cast<int>(r.integer(-exponents, exponents))));
  };
  const double size = kind == 2 ? std::pow(10.0, 30 * r.unit()) : 1,
               offset = kind == 3 ? std::pow(10.0, 12 * r.unit()) : 0;
  const auto number = [&]() -> T {
    return kind == 0   ? static_cast<T>(r.integer(-4, 4))
           : kind == 4 ? any()
                       : static_cast<T>(offset + static_cast<double>(spread(size)));
  };
  for (int i = 0; i < 3; ++i) {
    const T x = number(), y = number(), z = number();
    c.polygon.push_back({x, y, z});
  }
  if (kind == 0) {  // a parallelogram
    const auto &a = c.polygon[0], &b = c.polygon[1], &d = c.polygon[2];
    c.polygon.push_back({a.x + d.x - b.x, a.y + d.y - b.y, a.z + d.z - b.z});
  }
  for (auto n = r.integer(1, 6); n > 0; --n) {
    const auto normal = [&] { return kind == 0 ? static_cast<T>(r.integer(-3, 3)) : kind == 4 ? any() : spread(1); };
    irg::plane<T> l{normal(), normal(), normal(),
                    kind == 0   ? static_cast<T>(r.integer(-4, 4))
                    : kind == 4 ? any()
                                : static_cast<T>(r.unit() * 0.3)};
    if (kind == 3) l.d = -static_cast<T>(offset) * (l.a + l.b + l.c) + l.d;
    c.planes.push_back(l);
  }
  if (kind == 5) {  // a view pyramid
    c.planes = {{T(0), T(0), T(1), T(-0.1)}, {T(0), T(0), T(-1), T(10)}, {T(1), T(0), T(0.7), T(0)},
                {T(-1), T(0), T(0.7), T(0)}, {T(0), T(1), T(0.6), T(0)}, {T(0), T(-1), T(0.6), T(0)}};
    const T far = static_cast<T>(std::pow(10.0, 10 * r.unit()));
    for (auto& p : c.polygon) p = {spread(1) * far, spread(1) * far, spread(1) * far};
  }
  return c;
}

template <class T>
void judge(const solid_case<T>& c, verdict& v) {
  using P = irg::point<T, 3>;
  using E = irg::point<mpq, 3>;
  const auto kept = clip_sutherland_hodgman(c.polygon, c.planes);
  v.not_empty += kept.empty() ? 0 : 1;
  v.changed += kept.empty() || clip_sutherland_hodgman(kept, c.planes) == kept ? 0 : 1;
  const auto value = [&](std::size_t k, const E& p) {
    const auto& l = c.planes[k];
    return q(l.a) * p.x + q(l.b) * p.y + q(l.c) * p.z + q(l.d);
  };
  const std::vector<P> ends = visible_ends<P, E>(c.polygon, c.planes.size(), value);
  // Where two planes meet inside of the polygon, by parameters along two of its edges: a + s u + t w.
  const auto exact = [](const P& p) { return E{q(p.x), q(p.y), q(p.z)}; };
  const E a = exact(c.polygon[1]), b = exact(c.polygon[0]), d = exact(c.polygon[2]);
  const E u{b.x - a.x, b.y - a.y, b.z - a.z}, w{d.x - a.x, d.y - a.y, d.z - a.z};
  const mpq minors[] = {u.x * w.y - u.y * w.x, u.y * w.z - u.z * w.y, u.z * w.x - u.x * w.z};
  const bool flat = minors[0].sign() == 0 && minors[1].sign() == 0 && minors[2].sign() == 0;
  std::vector<P> inner;
  for (std::size_t j = 0; j < c.planes.size() && !flat; ++j)
    for (std::size_t k = 0; k < j; ++k) {
      const mpq ja = value(j, a), js = value(j, b) - ja, jt = value(j, d) - ja;
      const mpq ka = value(k, a), ks = value(k, b) - ka, kt = value(k, d) - ka;
      const mpq divisor = js * kt - jt * ks;
      if (divisor.sign() == 0) continue;
      const mpq s = (jt * ka - ja * kt) / divisor, t = (ja * ks - js * ka) / divisor;
      const mpq rest = mpq(1) - s - t;
      const bool in_polygon =
          s.sign() >= 0 && t.sign() >= 0 && (c.polygon.size() == 4 ? !(mpq(1) < s) && !(mpq(1) < t) : rest.sign() >= 0);
      if (!in_polygon) continue;
      const E at{a.x + s * u.x + t * w.x, a.y + s * u.y + t * w.y, a.z + s * u.z + t * w.z};
      bool inside = true;
      for (std::size_t l = 0; l < c.planes.size(); ++l) inside = inside && value(l, at).sign() >= 0;
      if (inside) inner.push_back({nearest<T>(at.x) + T(0), nearest<T>(at.y) + T(0), nearest<T>(at.z) + T(0)});
    }
  const auto is_inner = [&](const P& p) { return std::find(inner.begin(), inner.end(), p) != inner.end(); };
  const auto without_inner = [&](std::vector<P> places) {
    places.erase(std::remove_if(places.begin(), places.end(), is_inner), places.end());
    leave_out_twins(places);
    return places;
  };
  bool right = same_cycle(without_inner(kept), without_inner(ends));
  for (const P& p : inner) right = right && std::find(kept.begin(), kept.end(), p) != kept.end();
  v.with_region_corners += std::any_of(kept.begin(), kept.end(), is_inner) ? 1 : 0;
  if (kept.empty()) {  // no area, exactly or when rounded: what there is lies on a plane's line
    std::vector<P> all = ends;
    all.insert(all.end(), inner.begin(), inner.end());
    std::sort(all.begin(), all.end(),
              [](const P& f, const P& g) { return std::array{f.x, f.y, f.z} < std::array{g.x, g.y, g.z}; });
    leave_out_twins(all);
    right = all.size() < 3;
  }
  if (right) return;
  if (kept == c.polygon) {
    ++v.kept_as_given;
    return;
  }
  ++v.wrong;
}

template <class T>
verdict judge_planes(std::uint64_t seed, int rounds) {
  test::random r(seed);
  verdict v;
  for (int k = 0; k < rounds; ++k) judge(draw_solid_case<T>(r), v);
  return v;
}

// Rarely does a polygon come back as it is although not all of it is in the region.
void check(const verdict& v, int rounds) {
  CHECK(v.wrong == 0);
  CHECK(v.changed == 0);
  CHECK(v.not_empty > rounds / 3);
  CHECK(v.with_region_corners > rounds / 8);
  CHECK(v.kept_as_given < rounds / 100);
}

}  // namespace

TEST_CASE("clip_sutherland_hodgman: convex polygons of all sizes: every corner is the exact one, rounded") {
  const int doubles = line_cases::release_or(6000), floats = line_cases::release_or(4000);
  check(judge_convex<double>(11, doubles), doubles);
  check(judge_convex<float>(12, floats), floats);
}

TEST_CASE("clip_sutherland_hodgman: windows of all sizes: every corner is the exact one, rounded") {
  const int rounds = line_cases::release_or(2500);
  check(judge_windows<double>(13, rounds), rounds);
  check(judge_windows<float>(14, rounds), rounds);
}

TEST_CASE("clip_sutherland_hodgman: planes: every corner is the exact one, rounded") {
  const int rounds = line_cases::release_or(3000);
  check(judge_planes<double>(15, rounds), rounds);
  check(judge_planes<float>(16, rounds), rounds);
}
#endif
