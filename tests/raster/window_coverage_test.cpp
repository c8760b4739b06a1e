// SPDX-License-Identifier: MIT
#include <irg/raster/window_coverage.hpp>

#include <limits>

#include <irg/geometry/orient2d.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

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
