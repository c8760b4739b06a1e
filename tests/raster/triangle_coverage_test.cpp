// SPDX-License-Identifier: MIT
#include <irg/raster/triangle_coverage.hpp>

#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/core/lanes.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/exact.hpp"

namespace {

using irg::subpixel;
__extension__ typedef __int128 wide;

constexpr int pixel_count(subpixel a, subpixel b, subpixel c, irg::cell_window w = {-100, -100, 100, 100}) {
  int n = 0;
  irg::covered_spans(irg::cover_triangle(a, b, c), w, [&](irg::span_of_cells s) { n += s.x_last - s.x_first; });
  return n;
}

// The oracle is a scan line of exact fractions: a centre is covered when top <= y < bottom and left <= x < right, the
// half-open form of the top-left rule. It knows no edge function.
bool oracle_covers(const subpixel (&v)[3], int px, int py) {
  const std::int64_t x = std::int64_t{px} * 256 + 128, y = std::int64_t{py} * 256 + 128;
  int crossings_at_or_left = 0;  // edges crossing this row at or left of x
  for (int i = 0; i < 3; ++i) {
    subpixel p = v[i], q = v[(i + 1) % 3];
    if (p.y > q.y) {
      const subpixel t = p;
      p = q;
      q = t;
    }
    if (!(p.y <= y && y < q.y)) continue;  // level edges cross no row
    // crossing at p.x + (y - p.y) * (q.x - p.x) / (q.y - p.y) <= x
    if (wide{p.x} * (q.y - p.y) + wide{y - p.y} * (q.x - p.x) <= wide{x} * (q.y - p.y)) ++crossings_at_or_left;
  }
  return crossings_at_or_left == 1;
}

subpixel random_vertex(test::random& r, int extent) {
  return {static_cast<std::int32_t>(r.integer(-64, extent)), static_cast<std::int32_t>(r.integer(-64, extent))};
}

TEST_CASE("cover_triangle: a triangle by hand, in both windings and from every vertex") {
  constexpr subpixel a{0, 0}, b{1024, 0},
      c{0, 1024};  // 4 by 4 pixels, the hypotenuse through the centres of a diagonal
  CHECK_BOTH(pixel_count(a, b, c) == 6);               // the hypotenuse is a right edge: its centres are not covered
  CHECK_BOTH(pixel_count(a, c, b) == 6);
  CHECK_BOTH(pixel_count(b, c, a) == 6);
  CHECK_BOTH(pixel_count({1024, 0}, {1024, 1024}, {0, 1024}) == 10);  // here it is a left edge
  CHECK_BOTH(irg::covers(irg::cover_triangle(a, b, c), 0, 0));
  CHECK_BOTH(!irg::covers(irg::cover_triangle(a, b, c), 3, 0));
  CHECK_BOTH(irg::orientation_of(a, b, c) == irg::orientation::clockwise);
  CHECK_BOTH(irg::orientation_of(a, c, b) == irg::orientation::counter_clockwise);
}

TEST_CASE("cover_triangle: triangles without area cover nothing") {
  CHECK_BOTH(pixel_count({128, 128}, {128, 128}, {128, 128}) == 0);
  CHECK_BOTH(pixel_count({128, 128}, {128, 128}, {900, 700}) == 0);
  CHECK_BOTH(pixel_count({0, 0}, {512, 512}, {1024, 1024}) == 0);
  CHECK_BOTH(irg::orientation_of({0, 0}, {1, 1}, {2, 2}) == irg::orientation::degenerate);
}

TEST_CASE("cover_triangle: vertices at the limit of the domain") {
  constexpr int far = irg::snap_limit * 256;
  CHECK_BOTH(pixel_count({-far, -far}, {far, -far}, {-far, far}, {-8, -8, 8, 8}) ==
             120);  // half of it, without the diagonal
  CHECK_BOTH(pixel_count({far, far}, {far, -far}, {-far, far}, {-8, -8, 8, 8}) == 136);
  CHECK_BOTH(irg::cover_triangle({-far, -far}, {far, -far}, {-far, far}).double_area ==
             std::int64_t{far} * 2 * far * 2);
}

TEST_CASE("cover_triangle: a sliver of 1/256 pixel across 16k pixels") {
  // It is thinner than the distance between centres, and covers one pixel in about 256 of those it passes.
  const int n = pixel_count({0, 0}, {16384 * 256, 64 * 256}, {0, 1}, {0, 0, 16384, 64});
  CHECK(n > 0);
  CHECK(n < 16384);
  int expected = 0;
  const subpixel v[3] = {{0, 0}, {16384 * 256, 64 * 256}, {0, 1}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 16384; ++x) expected += oracle_covers(v, x, y);
  CHECK(n == expected);
}

TEST_CASE("cover_triangle: a centre on each side of a square belongs to the left and the top one") {
  // A square whose sides all pass through centres, cut along either diagonal.
  constexpr int l = 128, h = 128 + 512;
  CHECK_BOTH(pixel_count({l, l}, {h, l}, {h, h}) + pixel_count({l, l}, {h, h}, {l, h}) == 4);
  CHECK_BOTH(pixel_count({l, l}, {h, l}, {l, h}) + pixel_count({h, l}, {h, h}, {l, h}) == 4);
  CHECK_BOTH(irg::covers(irg::cover_triangle({l, l}, {h, l}, {l, h}), 0, 0));
  CHECK_BOTH(!irg::covers(irg::cover_triangle({h, l}, {h, h}, {l, h}), 2, 2));
}

TEST_CASE("cover_triangle: equals the rational oracle on 10,000 random triangles, 30 % of them slivers") {
  test::random random(20261121);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 1000000 : 10000;
  long covered = 0, wrong = 0, slivers = 0;
  for (int i = 0; i < trials; ++i) {
    subpixel v[3] = {random_vertex(random, 24 * 256), random_vertex(random, 24 * 256), random_vertex(random, 24 * 256)};
    if (i % 10 < 3) {  // a sliver: the third vertex within 3/256 of the line through the others
      const std::int64_t t = random.integer(0, 256);
      v[2].x = static_cast<std::int32_t>(v[0].x + (v[1].x - v[0].x) * t / 256 + random.integer(-3, 3));
      v[2].y = static_cast<std::int32_t>(v[0].y + (v[1].y - v[0].y) * t / 256 + random.integer(-3, 3));
      ++slivers;
    }
    const irg::triangle_coverage t = irg::cover_triangle(v[0], v[1], v[2]);
    std::vector<char> drawn(26 * 26, 0);
    irg::covered_spans(t, {-1, -1, 25, 25}, [&](irg::span_of_cells s) {
      for (int x = s.x_first; x < s.x_last; ++x) ++drawn[static_cast<std::size_t>((s.y + 1) * 26 + x + 1)];
    });
    for (int y = -1; y < 25; ++y)
      for (int x = -1; x < 25; ++x) {
        const bool expected = oracle_covers(v, x, y);
        wrong += expected != irg::covers(t, x, y);
        wrong += expected != (drawn[static_cast<std::size_t>((y + 1) * 26 + x + 1)] == 1);
        covered += expected;
      }
  }
  MESSAGE(trials, " triangles, ", slivers, " slivers, ", covered, " covered centres, ", wrong, " wrong");
  CHECK(covered > trials);
  CHECK(wrong == 0);
}

// Every quad of a lattice, cut along its diagonal: no centre twice, every centre of the inside and of the open diagonal
// exactly once. `per_pixel` lattice steps make a pixel; the lattice spans 4 pixels at most.
struct lattice_result {
  long long quads = 0, doubly = 0, holes = 0;
};

lattice_result quad_lattice(int points, int step) {
  struct sides {
    std::vector<unsigned> covered, inside;  // of each triangle on this side of the diagonal
  };
  const auto at = [&](int i) { return subpixel{(i % points) * step, (i / points) * step}; };
  lattice_result result;
  const int n = points * points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i == j) continue;
      const subpixel a = at(i), b = at(j);
      unsigned on_diagonal = 0;
      for (int p = 0; p < 16; ++p) {
        const subpixel c{(p % 4) * 256 + 128, (p / 4) * 256 + 128};
        const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
        const std::int64_t along = dx * (c.x - a.x) + dy * (c.y - a.y);
        if (irg::twice_signed_area(a, b, c) == 0 && along > 0 && along < dx * dx + dy * dy) on_diagonal |= 1u << p;
      }
      sides left, right;
      for (int k = 0; k < n; ++k) {
        const std::int64_t side = irg::twice_signed_area(a, b, at(k));
        if (side == 0) continue;
        unsigned covered = 0, inside = 0;
        const irg::triangle_coverage t = irg::cover_triangle(a, b, at(k));
        for (int p = 0; p < 16; ++p) {
          const subpixel c{(p % 4) * 256 + 128, (p / 4) * 256 + 128};
          if (irg::covers(t, p % 4, p / 4)) covered |= 1u << p;
          const std::int64_t s1 = irg::twice_signed_area(a, b, c), s2 = irg::twice_signed_area(b, at(k), c),
                             s3 = irg::twice_signed_area(at(k), a, c);
          if ((s1 > 0 && s2 > 0 && s3 > 0) || (s1 < 0 && s2 < 0 && s3 < 0)) inside |= 1u << p;
        }
        sides& s = side > 0 ? left : right;
        s.covered.push_back(covered);
        s.inside.push_back(inside);
      }
      for (std::size_t l = 0; l < left.covered.size(); ++l)
        for (std::size_t r = 0; r < right.covered.size(); ++r) {
          ++result.quads;
          if (left.covered[l] & right.covered[r]) ++result.doubly;
          const unsigned wanted = left.inside[l] | right.inside[r] | on_diagonal;
          if (wanted & ~(left.covered[l] | right.covered[r])) ++result.holes;
        }
    }
  return result;
}

TEST_CASE("cover_triangle: exactly once on every quad of the 9 x 9 half-pixel lattice") {
  const lattice_result r = quad_lattice(9, 128);
  MESSAGE(r.quads, " quads, ", r.doubly, " with a pixel drawn twice, ", r.holes, " with a hole");
  CHECK(r.quads == 7043824);
  CHECK(r.doubly == 0);
  CHECK(r.holes == 0);
}

TEST_CASE("cover_triangle: exactly once on every quad of the 13 x 13 quarter-pixel lattice [release]" *
          doctest::skip(std::getenv("IRG_RELEASE_TIER") == nullptr)) {
  const lattice_result r = quad_lattice(13, 64);
  MESSAGE(r.quads, " quads, ", r.doubly, " with a pixel drawn twice, ", r.holes, " with a hole");
  CHECK(r.quads == 143758304);
  CHECK(r.doubly == 0);
  CHECK(r.holes == 0);
}

TEST_CASE("cover_triangle: fans of 3 to 12 triangles own their centre vertex once") {
  test::random random(7);
  for (int spokes = 3; spokes <= 12; ++spokes)
    for (const subpixel hub : {subpixel{128 + 512, 128 + 512}, subpixel{512, 512}, subpixel{600, 700}}) {
      std::vector<subpixel> rim;  // counter-clockwise around the hub, no two spokes more than 180 degrees apart
      for (int s = 0; s < spokes; ++s) {
        const int x[12] = {900, 800, 450, 0, -450, -800, -900, -800, -450, 0, 450, 800};
        const int k = s * 12 / spokes;
        rim.push_back({hub.x + x[k] + static_cast<int>(random.integer(-20, 20)),
                       hub.y + x[(k + 9) % 12] + static_cast<int>(random.integer(-20, 20))});
      }
      int count[6][6] = {};
      for (std::size_t s = 0; s < rim.size(); ++s) {
        const auto t = irg::cover_triangle(hub, rim[s], rim[(s + 1) % rim.size()]);
        for (int y = 0; y < 6; ++y)
          for (int x = 0; x < 6; ++x) count[y][x] += irg::covers(t, x, y);
      }
      for (auto& row : count)
        for (const int c : row) CHECK(c <= 1);
      CHECK(count[hub.y / 256][hub.x / 256] == 1);
    }
}

TEST_CASE("cover_triangle: a triangle moved by whole pixels covers the same pixels, moved") {
  test::random random(16);
  for (int i = 0; i < 300; ++i) {
    const subpixel v[3] = {random_vertex(random, 2000), random_vertex(random, 2000), random_vertex(random, 2000)};
    const int mx = static_cast<int>(random.integer(-30000, 30000)),
              my = static_cast<int>(random.integer(-30000, 30000));
    const auto moved = [&](subpixel p) { return subpixel{p.x + mx * 256, p.y + my * 256}; };
    const auto t = irg::cover_triangle(v[0], v[1], v[2]);
    const auto u = irg::cover_triangle(moved(v[0]), moved(v[1]), moved(v[2]));
    for (int y = -1; y < 9; ++y)
      for (int x = -1; x < 9; ++x) REQUIRE(irg::covers(t, x, y) == irg::covers(u, x + mx, y + my));
  }
}

TEST_CASE("covered_spans: work ends at the window, however large the triangle") {
  constexpr int far = irg::snap_limit * 256;
  int rows = 0;
  irg::covered_spans(irg::cover_triangle({-far, -far}, {far, -far}, {0, far}), {10, 10, 20, 13},
                     [&](irg::span_of_cells s) {
                       CHECK(s.x_first == 10);
                       CHECK(s.x_last == 20);
                       ++rows;
                     });
  CHECK(rows == 3);
  irg::covered_spans(irg::cover_triangle({0, 0}, {512, 0}, {0, 512}), {5, 5, 5, 9},
                     [&](irg::span_of_cells) { ++rows; });
  CHECK(rows == 3);  // an empty window gets no call
}

constexpr int columns_outside(subpixel a, subpixel b, subpixel c, irg::cell_window w) {
  int n = 0;
  irg::covered_spans(irg::cover_triangle(a, b, c), w, [&](irg::span_of_cells s) {
    n += irg::maximum(w.x_first - s.x_first, 0) + irg::maximum(s.x_last - w.x_last, 0);
  });
  return n;
}

TEST_CASE("covered_spans: a level lower edge through centres, with the triangle right of the window") {
  CHECK_BOTH(columns_outside({5632, 2176}, {5760, 2176}, {5760, -2048}, {-3, -3, 20, 20}) == 0);
  CHECK_BOTH(columns_outside({0, 0}, {5632, 2176}, {5760, 2176}, {-3, -3, 20, 20}) == 0);
  CHECK_BOTH(irg::covered_span(irg::cover_triangle({0, 0}, {9, 9}, {18, 18}), 0, 5, 2).x_last == 2);
  test::random random(31);
  for (int i = 0; i < 6000; ++i) {
    const auto place = [&] { return static_cast<int>(random.integer(-2000, 6000)) & (i % 3 ? -1 : ~127); };
    const int ax = place(), ay = place(), bx = place(), by = place(), cx = place();
    const auto t = irg::cover_triangle({ax, ay}, {bx, by}, {cx, place()});
    const int low = static_cast<int>(random.integer(-3, 24)), high = static_cast<int>(random.integer(low, 25));
    for (int y = -3; y < 20; ++y) {
      const irg::span_of_cells s = irg::covered_span(t, y, low, high);
      REQUIRE((low <= s.x_first && s.x_first <= s.x_last && s.x_last <= high));
      int covered = 0;
      for (int x = low; x < high; ++x) covered += irg::covers(t, x, y);
      REQUIRE(covered == s.x_last - s.x_first);
    }
  }
}

TEST_CASE("first_centre, last_centre, centres_within: centres at v count, those beside it do not") {
  CHECK_BOTH(irg::first_centre(128) == 0);
  CHECK_BOTH(irg::first_centre(129) == 1);
  CHECK_BOTH(irg::first_centre(-128) == -1);
  CHECK_BOTH(irg::last_centre(128) == 1);
  CHECK_BOTH(irg::last_centre(127) == 0);
  CHECK_BOTH(irg::last_centre(-129) == -1);
  CHECK_BOTH(irg::centres_within({0, 0}, {256, 128}, {100, 700}) == irg::cell_window{0, 0, 1, 3});
  CHECK_BOTH(irg::centres_within({130, 0}, {140, 900}, {150, 0}).empty());
  using integers = irg::pack<std::int32_t, 4>;
  const integers at = irg::lanes<integers>::broadcast(-300);
  CHECK(irg::first_centre(at)[2] == irg::first_centre(-300));
  CHECK(irg::last_centre(at)[3] == irg::last_centre(-300));
  for (int v = -2000; v <= 2000; ++v) {
    int first = -100, last = 100;
    while (first * 256 + 128 < v) ++first;
    while ((last - 1) * 256 + 128 > v) --last;
    REQUIRE(irg::first_centre(v) == first);
    REQUIRE(irg::last_centre(v) == last);
  }
}

using irg::cell_window;
using irg::classify;
using irg::containment;
using irg::cover_triangle;
using irg::subpixel;

constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
constexpr int far = irg::snap_limit * irg::one_pixel;

TEST_CASE("classify: by hand") {
  constexpr irg::triangle_coverage t = cover_triangle({0, 0}, {4096, 0}, {0, 4096});  // 16 by 16 pixels
  CHECK_BOTH(classify(t, {0, 0, 8, 8}) ==
             containment::inside);  // the last centre is (7.5, 7.5), on this side of x + y = 16
  CHECK_BOTH(classify(t, {0, 0, 9, 8}) == containment::crossing);  // (8.5, 7.5) is on the edge, and not covered
  CHECK_BOTH(classify(t, {-1, 0, 8, 8}) == containment::crossing);
  CHECK_BOTH(classify(t, {8, 8, 16, 16}) == containment::outside);  // beyond an edge, within the bounds
  CHECK_BOTH(classify(t, {16, 0, 20, 8}) == containment::outside);
  CHECK_BOTH(classify(t, {-9, -9, 30, 30}) == containment::crossing);
  CHECK_BOTH(classify(t, {3, 3, 4, 4}) == containment::inside);  // one pixel: covered or not
  CHECK_BOTH(classify(t, {12, 12, 13, 13}) == containment::outside);
}

TEST_CASE("classify: empty windows, triangles without area, slivers between centres") {
  constexpr irg::triangle_coverage t = cover_triangle({0, 0}, {4096, 0}, {0, 4096});
  CHECK_BOTH(classify(t, {}) == containment::outside);
  CHECK_BOTH(classify(t, {3, 3, 3, 9}) == containment::outside);
  CHECK_BOTH(classify(t, {9, 3, 3, 9}) == containment::outside);
  CHECK_BOTH(classify(cover_triangle({0, 0}, {512, 512}, {1024, 1024}), {0, 0, 4, 4}) == containment::outside);
  // Between the columns of centres at 0.5 and 1.5: its bounds hold no centre.
  CHECK_BOTH(classify(cover_triangle({200, 0}, {300, 0}, {250, 2000}), {0, 0, 4, 4}) == containment::outside);
  // Slanting, it has some in its bounds, and passes between them.
  constexpr irg::triangle_coverage sliver = cover_triangle({0, 200}, {4000, 4200}, {0, 201});
  CHECK_BOTH(classify(sliver, {0, 0, 16, 16}) == containment::crossing);
  CHECK_BOTH((!covers(sliver, 0, 0) && !covers(sliver, 0, 1) && !covers(sliver, 5, 5) && !covers(sliver, 5, 6)));
}

TEST_CASE("classify: windows of the whole range of ints, triangles at the limit") {
  constexpr irg::triangle_coverage t = cover_triangle({-far, -far}, {far, -far}, {-far, far});
  CHECK_BOTH(classify(t, {least, least, most, most}) == containment::crossing);
  CHECK_BOTH(classify(t, {least, least, least + 1, least + 1}) == containment::outside);
  CHECK_BOTH(classify(t, {most - 1, most - 1, most, most}) == containment::outside);
  CHECK_BOTH(classify(t, {-irg::snap_limit, -irg::snap_limit, 0, 0}) == containment::inside);
  CHECK_BOTH(classify(t, {-irg::snap_limit, -irg::snap_limit, 1, 0}) == containment::crossing);
  CHECK_BOTH(classify(t, {0, 0, most, most}) == containment::outside);
}

using place = irg::point<double, 2>;
bool in_closed(const place (&ring)[4], int n, const place& p) {
  bool no_left = true, no_right = true;
  for (int i = 0; i < n; ++i) {
    const int side = irg::orient2d(ring[i], ring[(i + 1) % n], p);
    no_left = no_left && side <= 0;
    no_right = no_right && side >= 0;
  }
  return no_left || no_right;
}
bool cross(const place& a, const place& b, const place& c, const place& d) {
  return irg::orient2d(a, b, c) * irg::orient2d(a, b, d) < 0 && irg::orient2d(c, d, a) * irg::orient2d(c, d, b) < 0;
}

// Whether two convex shapes meet, a corner of one in the other or sides that cross.
bool meet(const place (&a)[4], int n, const place (&b)[4], int m) {
  for (int i = 0; i < n; ++i)
    if (in_closed(b, m, a[i])) return true;
  for (int k = 0; k < m; ++k)
    if (in_closed(a, n, b[k])) return true;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < m; ++k)
      if (cross(a[i], a[(i + 1) % n], b[k], b[(k + 1) % m])) return true;
  return false;
}

TEST_CASE("classify: against every pixel") {
  test::random r(421);
  long long count[3] = {}, passing = 0, wrong = 0;
  for (int i = 0; i < test::trials(100'000); ++i) {
    const auto pixels = static_cast<int>(r.integer(1, 24));
    const auto coordinate = [&] {
      const auto v = static_cast<std::int32_t>(r.integer(-256, pixels * 256));
      return i % 4 == 0 ? v & ~127 : v;  // on centres and borders
    };
    const subpixel a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    subpixel c{coordinate(), coordinate()};
    if (i % 3 == 0)
      c = {a.x + static_cast<std::int32_t>(r.integer(-40, 40)), a.y + static_cast<std::int32_t>(r.integer(-40, 40))};
    const auto t = cover_triangle(a, b, c);
    cell_window w{static_cast<int>(r.integer(-2, 20)), static_cast<int>(r.integer(-2, 20)), 0, 0};
    if (i % 2 == 0) w.x_first = (a.x / 3 + b.x / 3 + c.x / 3) / 256, w.y_first = (a.y / 3 + b.y / 3 + c.y / 3) / 256;
    w.x_last = w.x_first + static_cast<int>(r.integer(0, 8));
    w.y_last = w.y_first + static_cast<int>(r.integer(0, 8));
    int covered = 0, all = 0;
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) ++all, covered += covers(t, x, y);
    const containment got = classify(t, w);
    ++count[static_cast<int>(got)];
    if (all == 0 || t.double_area == 0) {
      wrong += got != containment::outside;
      continue;
    }
    wrong += (got == containment::inside) != (covered == all);
    if (got == containment::outside) wrong += covered != 0;
    if (got != containment::crossing || covered != 0) continue;
    ++passing;  // none is covered, but the rectangle of the centres and the triangle meet
    const auto number = [](int v) { return static_cast<double>(v); };
    const double left = number(w.x_first * 256 + 128), right = number(w.x_last * 256 - 128),
                 top = number(w.y_first * 256 + 128), bottom = number(w.y_last * 256 - 128);
    const place centres[4] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
    const place corners[4] = {{number(a.x), number(a.y)}, {number(b.x), number(b.y)}, {number(c.x), number(c.y)}, {}};
    wrong += !meet(centres, 4, corners, 3);
  }
  CHECK(wrong == 0);
  for (const long long n : count) CHECK(n > test::trials(1'000));
  CHECK(passing > test::trials(100));
}

}  // namespace
