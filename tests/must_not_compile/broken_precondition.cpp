// SPDX-License-Identifier: MIT
// A broken precondition is no constant, with and without NDEBUG.
#if CASE == 3
#define NDEBUG
#endif
#include <irg/core/contract.hpp>
#include <irg/raster/image.hpp>

constexpr int checked(int n) {
  IRG_EXPECTS(n > 0);
  return n;
}

constexpr int row_of(int y) {
  int pixels[6]{};
  const irg::image_view<int> view(pixels, 3, 2);
  return view.row(y)[0];
}

#if CASE == 0
static_assert(checked(1) == 1 && row_of(1) == 0);
#elif CASE == 1
// expect: precondition_broken
static_assert(checked(0) == 0);
#elif CASE == 2
// expect: precondition_broken
static_assert(row_of(2) == 0);
#elif CASE == 3
// expect: precondition_broken
static_assert(checked(0) == 0);
#endif
