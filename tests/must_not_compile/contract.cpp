// SPDX-License-Identifier: MIT
// Broken preconditions in constant evaluation. CASE 0 is the control and compiles.
#include <irg/core/result.hpp>
#include <irg/raster/image.hpp>

[[maybe_unused]] constexpr int picture[6] = {1, 2, 3, 4, 5, 6};
[[maybe_unused]] constexpr irg::image_view<const int> view(picture, 3, 2);
constexpr irg::result<int> failed() { return irg::parse_error{1, 1, "no number"}; }
constexpr irg::result<int> good() { return 5; }

#if CASE == 0
static_assert(view(2, 1) == 6 && *good() == 5 && failed().error().line == 1);
#elif CASE == 1  // a pixel outside: column
// expect: precondition_broken
static_assert(view(3, 0) == 4);
#elif CASE == 2  // a pixel outside: row
// expect: precondition_broken
static_assert(view(0, -1) == 0);
#elif CASE == 3  // the value of a failure
// expect: precondition_broken
static_assert(*failed() == 0);
#elif CASE == 4  // the error of a success
// expect: precondition_broken
static_assert(good().error().line == 0);
#elif CASE == 5  // an image of negative width
// expect: (precondition_broken|constant expression|length_error)
static_assert(irg::image<int>(-1, 2).height() == 2);
#elif CASE == 6  // rows that are off the alignment of their pixels
// expect: precondition_broken
constexpr irg::image_view<const int> skewed(picture, 1, 2, 5);
#endif
