// SPDX-License-Identifier: MIT
#include <irg/view/viewport.hpp>

#include <algorithm>
#include <cmath>

#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::from_pixels;
using irg::hpoint;
using irg::point;
using irg::to_pixels;
using irg::viewport;
using irg::viewport_matrix;
using test::rational;

namespace {

using P = point<double, 3>;
using R = rational;
constexpr viewport<double> image{0, 0, 800, 600};

// Hank n.d., 4.2.2, as corrected: the window with its upper edge at `top`, y up, into the view.
constexpr point<R, 3> window_to_viewport(R left, R top, R width, R height, const viewport<R>& view, R x, R y) {
  const R nx = (x - left) / width * R(2) - R(1), ny = R(1) - (top - y) / height * R(2);
  return to_pixels(view, point<R, 3>{nx, ny, R(0)});
}

}  // namespace

TEST_CASE("viewport: by hand, in every life") {
  CHECK_BOTH(to_pixels(image, P{-1, 1, 0.5}) == P{0, 0, 0.5});     // upper left corner
  CHECK_BOTH(to_pixels(image, P{1, -1, 0.5}) == P{800, 600, 0.5});  // lower right: one past the last pixel
  CHECK_BOTH(to_pixels(image, P{0, 0, 0}) == P{400, 300, 0});
  CHECK_BOTH(to_pixels(image, hpoint<double, 3>{2, 2, 1, 4}) == P{600, 150, 0.25});
  CHECK_BOTH(from_pixels(image, point<double, 2>{600, 150}) == point<double, 2>{0.5, 0.5});
  // The centre of pixel (0, 0).
  CHECK_BOTH(to_pixels(viewport<double>{0, 0, 4, 4}, P{-0.75, 0.75, 0}) == P{0.5, 0.5, 0});
  CHECK_BOTH(transform_point(viewport_matrix(image), P{0.5, 0.5, 0.25}) == P{600, 150, 0.25});
  constexpr auto any = to_pixels(viewport<float>{3, 5, 77, 33}, point<float, 3>{0.1f, 0.7f, 0.3f});
  volatile float x = 0.1f;
  CHECK(to_pixels(viewport<float>{3, 5, 77, 33}, point<float, 3>{x, 0.7f, 0.3f}) == any);
}

TEST_CASE("viewport: Hank's values") {
  constexpr viewport<R> whole{0, 0, 800, 600};
  CHECK_BOTH(window_to_viewport(-4, 3, 8, 6, whole, -4, 3) == point<R, 3>{0, 0, 0});
  CHECK_BOTH(window_to_viewport(-4, 3, 8, 6, whole, 4, -3) == point<R, 3>{800, 600, 0});
  CHECK_BOTH(window_to_viewport(-4, 3, 8, 6, whole, 0, 0) == point<R, 3>{400, 300, 0});
  CHECK_BOTH(window_to_viewport(-4, 3, 8, 6, whole, 1, 2) == point<R, 3>{500, 100, 0});
  CHECK_BOTH(window_to_viewport(-4, 3, 8, 6, whole, -4, -3) == point<R, 3>{0, 600, 0});
  CHECK_BOTH(window_to_viewport(-4, 3, 8, 6, {100, 50, 200, 300}, 1, 2) == point<R, 3>{225, 100, 0});
  CHECK_BOTH(window_to_viewport(0, 5, 2, 4, whole, 0, 5) == point<R, 3>{0, 0, 0});
  CHECK_BOTH(window_to_viewport(0, 5, 2, 4, whole, 2, 1) == point<R, 3>{800, 600, 0});
  // The same window by orthographic projection.
  constexpr auto m = irg::orthographic(irg::view_window<double>{-4, 4, -3, 3}, 0, 1);
  CHECK_BOTH(to_pixels(image, m * P{1, 2, 0}) == P{500, 100, 1});
}

TEST_CASE("viewport: stays within its borders, and there and back") {
  test::random r(1);
  for (const viewport<float>& v : {viewport<float>{0, 0, 1, 1}, viewport<float>{0, 0, 65535, 1},
                                   viewport<float>{7, 9, 1920, 1080}, viewport<float>{-3, 0.5f, 13, 17}}) {
    for (int i = 0; i < 5000; ++i) {
      const float w = static_cast<float>(r.unit()) + 1e-6f;
      const float x = w * static_cast<float>(2 * r.unit() - 1), y = w * static_cast<float>(2 * r.unit() - 1);
      const auto p = to_pixels(v, hpoint<float, 3>{x, y, 0, w});
      CHECK((p.x >= v.x && p.x <= v.x + v.width && p.y >= v.y && p.y <= v.y + v.height));
      const auto back = from_pixels(v, point<float, 2>{p.x, p.y});
      const float lost = 8 * 0x1p-24f * (1 + (std::abs(v.x) + std::abs(v.y)) / std::min(v.width, v.height)) *
                         std::max(1.0f, std::max(std::abs(p.x) / v.width, std::abs(p.y) / v.height));
      CHECK(std::abs(back.x - x / w) <= lost);
      CHECK(std::abs(back.y - y / w) <= lost);
    }
  }
}
