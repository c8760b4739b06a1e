// SPDX-License-Identifier: MIT
#include <irg/raster/draw_counts.hpp>

#include "support/check_both.hpp"

namespace {

constexpr irg::skip_counts sum_of(irg::skip_counts a, const irg::skip_counts& b) { return a += b; }
constexpr irg::render_counts sum_of(irg::render_counts a, const irg::render_counts& b) { return a += b; }

TEST_CASE("skip_counts and render_counts: sums take every member along") {
  CHECK_BOTH(sum_of(irg::skip_counts{1, 2, 3, 4, 5}, irg::skip_counts{10, 20, 30, 40, 50}) ==
             irg::skip_counts{11, 22, 33, 44, 55});
  CHECK_BOTH(sum_of(irg::render_counts{1, {2, 3, 4, 5, 6}, {6, 7, 8}, 9, 100},
                    irg::render_counts{10, {20, 30, 40, 50, 60}, {60, 70, 80}, 90, 200}) ==
             irg::render_counts{11, {22, 33, 44, 55, 66}, {66, 77, 88}, 99, 300});
}

TEST_CASE("skip_counts and render_counts: all begin at 0") {
  CHECK_BOTH(irg::skip_counts{} == irg::skip_counts{0, 0, 0, 0, 0});
  CHECK_BOTH(irg::render_counts{} == irg::render_counts{0, {0, 0, 0, 0, 0}, {0, 0, 0}, 0, 0});
}

TEST_CASE("skip_counts and render_counts: comparison looks at every member") {
  const irg::render_counts zero;
  for (int member = 0; member < 11; ++member) {
    irg::render_counts s;
    std::int64_t* const at[11] = {&s.triangles,     &s.skipped.frustum,  &s.skipped.backface,
                                  &s.skipped.tiny,  &s.skipped.occluded, &s.pixels.tested,
                                  &s.pixels.shaded, &s.pixels.ties,      &s.drawn,
                                  &s.clipped,       &s.skipped.rooms};
    ++*at[member];
    CHECK(!(s == zero));
  }
}

}  // namespace
