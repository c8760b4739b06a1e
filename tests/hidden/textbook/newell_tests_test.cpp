// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/newell_tests.hpp>

#include <array>

#include "support/check_both.hpp"

namespace {

using irg::newell_step;

template <class P, class Q>
constexpr std::array<bool, 5> all_tests(const P& p, const Q& q) {
  std::array<bool, 5> says{};
  for (std::size_t i = 0; i < 5; ++i) says[i] = irg::textbook::does_not_hide_by(static_cast<newell_step>(i), p, q);
  return says;
}

template <class T>
constexpr bool six_pairs() {
  using triangle = std::array<irg::point<T, 3>, 3>;
  struct pair_of_triangles {
    triangle p, q;
    std::array<bool, 5> says, swapped;
  };
  const triangle slope{{{T(0), T(0), T(0)}, {T(4), T(0), T(0)}, {T(0), T(8), T(0)}}};
  const triangle tilted{{{T(0), T(0), T(0)}, {T(2), T(0), T(5)}, {T(0), T(2), T(0)}}};
  const pair_of_triangles pairs[] = {{tilted,
                                      {{{T(3), T(0), T(1)}, {T(5), T(0), T(2)}, {T(3), T(2), T(3)}}},
                                      {true, false, false, false, true},
                                      {true, false, true, false, true}},
                                     {tilted,
                                      {{{T(0), T(3), T(1)}, {T(2), T(3), T(2)}, {T(0), T(5), T(3)}}},
                                      {false, true, false, false, true},
                                      {false, true, false, true, true}},
                                     {{{{T(0), T(0), T(0)}, {T(4), T(0), T(0)}, {T(0), T(4), T(3)}}},
                                      {{{T(0), T(0), T(2)}, {T(4), T(0), T(2)}, {T(0), T(4), T(5)}}},
                                      {false, false, true, true, false},
                                      {false, false, false, false, false}},
      // Twice the size, since one corner's depth is 5/2.
                                     {{{{T(0), T(0), T(0)}, {T(16), T(0), T(16)}, {T(0), T(16), T(0)}}},
                                      {{{T(2), T(2), T(4)}, {T(4), T(2), T(5)}, {T(2), T(4), T(12)}}},
                                      {false, false, false, true, false},
                                      {false, false, false, false, false}},
                                     {{{{T(0), T(0), T(0)}, {T(4), T(0), T(9)}, {T(0), T(4), T(0)}}},
                                      {{{T(4), T(4), T(5)}, {T(4), T(1), T(1)}, {T(1), T(4), T(1)}}},
                                      {false, false, false, false, true},
                                      {false, false, true, true, true}},
                                     {{{{T(0), T(0), T(0)}, {T(4), T(0), T(10)}, {T(0), T(4), T(10)}}},
                                      {{{T(1), T(1), T(1)}, {T(3), T(1), T(1)}, {T(1), T(3), T(1)}}},
                                      {false, false, false, false, false},
                                      {false, false, true, false, false}}};
  for (const pair_of_triangles& c : pairs)
    if (all_tests(c.p, c.q) != c.says || all_tests(c.q, c.p) != c.swapped) return false;
  return irg::textbook::newell_step_of(pairs[5].p, pairs[5].q) == newell_step::moved &&
         irg::textbook::newell_step_of(pairs[0].p, pairs[0].q) == newell_step::x_apart &&
         irg::textbook::newell_step_of(pairs[4].p, pairs[4].q) == newell_step::projections_apart &&
         all_tests(slope, slope) == std::array{false, false, true, true, false};
}

TEST_CASE("the five tests of depth sort, by hand, both ways round") {
  CHECK_BOTH(six_pairs<int>());
  CHECK_BOTH(six_pairs<double>());
}

TEST_CASE("the five tests of depth sort: polygons that touch, that are seen edge on, that are nothing") {
  constexpr auto quad = [](int x, int z) {
    return std::array<irg::point<int, 3>, 4>{{{x, 0, z}, {x + 4, 0, z}, {x + 4, 4, z}, {x, 4, z}}};
  };
  constexpr auto first = [](const auto& p, const auto& q) { return irg::textbook::newell_step_of(p, q); };
  CHECK_BOTH(first(quad(0, 3), quad(4, 0)) == newell_step::x_apart);
  CHECK_BOTH(first(quad(0, 3), quad(3, 0)) == newell_step::moved);
  CHECK_BOTH(first(quad(3, 0), quad(0, 3)) == newell_step::behind_plane);
  constexpr auto edge_on = std::array<irg::point<int, 3>, 3>{{{1, 1, 0}, {3, 3, 5}, {2, 2, 9}}};
  CHECK_BOTH(first(edge_on, quad(0, 3)) == newell_step::projections_apart);
  CHECK_BOTH(first(quad(0, 3), edge_on) == newell_step::projections_apart);
  CHECK_BOTH(first(std::array<irg::point<int, 3>, 0>{}, quad(0, 3)) == newell_step::x_apart);
}

}  // namespace
