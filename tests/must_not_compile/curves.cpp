// SPDX-License-Identifier: MIT
// Curves without control points, or with less scratch than they need, are no constants. CASE 0 is the control and
// compiles.
#include <span>
#include <vector>

#include <irg/curve/bezier.hpp>

template <int Points, int Scratch>
constexpr double at_half() {
  std::vector<irg::point<double, 2>> control(Points, irg::point<double, 2>{3, 4});
  std::vector<irg::point<double, 2>> scratch(Scratch, irg::point<double, 2>{});
  return irg::bezier_point(control, 0.5, std::span<irg::point<double, 2>>(scratch)).x;
}

#if CASE == 0
static_assert(at_half<2, 2>() == 3 && at_half<2, 3>() == 3);
#elif CASE == 1
// expect: precondition_broken
static_assert(at_half<2, 1>() == 3);
#elif CASE == 2
// expect: precondition_broken
static_assert(at_half<0, 2>() == 3);
#endif
