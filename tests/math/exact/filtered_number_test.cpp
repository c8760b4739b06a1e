// SPDX-License-Identifier: MIT
#include <irg/math/exact/filtered_number.hpp>

#include <array>
#include <limits>

#include "support/check_both.hpp"

namespace {

constexpr auto area = [](const auto& a, const auto& b, const auto& c) { return cross(b - a, c - a); };
using P = irg::point<double, 2>;

}  // namespace

TEST_CASE("filtered numbers: the value and the sum of the sizes of its terms") {
  using irg::filtered_input;
  using irg::filtered_number;
  static_assert(irg::Number<filtered_number> && irg::Number<filtered_input>);
  CHECK_BOTH(filtered_number{2, 2} - filtered_number{3, 3} == filtered_number{-1, 5});
  CHECK_BOTH(filtered_input{2} - filtered_input{3} == filtered_number{-1, 1});
  CHECK_BOTH(filtered_input{2} + filtered_input{-3} == filtered_number{-1, 1});
  CHECK_BOTH(filtered_input{2} * filtered_input{-3} + filtered_input{5} == filtered_number{-1, 11});
}

TEST_CASE("filtered_value_of: nothing where something could over- or underflow") {
  CHECK_BOTH(irg::filtered_value_of<2>(area, P{0, 0}, P{2, 0}, P{1, 3}) == irg::filtered_number{6, 6});
  CHECK_BOTH(!irg::filtered_value_of<2>(area, P{0, 0}, P{1e200, 0}, P{1, 3}));
  CHECK_BOTH(!irg::filtered_value_of<2>(area, P{0, 0}, P{5e-324, 0}, P{1, 3}));
  CHECK_BOTH(!irg::filtered_value_of<2>(area, P{0, 0}, P{std::numeric_limits<double>::quiet_NaN(), 0}, P{1, 3}));
}

TEST_CASE("suits_filter: moderate numbers and zeros; of floats those that are not subnormal") {
  CHECK_BOTH(irg::suits_filter<2>(0.0));
  CHECK_BOTH(irg::suits_filter<2>(-0x1p-400));
  CHECK_BOTH(!irg::suits_filter<2>(0x1p400));
  CHECK_BOTH(!irg::suits_filter<2>(0x1.fffffffffffffp-401));
  CHECK_BOTH(!irg::suits_filter<5>(std::numeric_limits<double>::quiet_NaN()));
  CHECK_BOTH(irg::suits_filter<5>(0x1.fp129));
  CHECK_BOTH(!irg::suits_filter<5>(0x1p130));
  CHECK_BOTH(irg::suits_filter<2>(std::numeric_limits<float>::max()));
  CHECK_BOTH(irg::suits_filter<2>(-0x1p-126f));
  CHECK_BOTH(!irg::suits_filter<2>(0x1p-127f));
  CHECK_BOTH(irg::suits_filter<2>(-0.0f));
  CHECK_BOTH(!irg::suits_filter<9>(0x1p50f));
  CHECK_BOTH(irg::suits_filter<9>(0x1p49f));
  CHECK_BOTH(!irg::suits_filter<2>(std::numeric_limits<float>::infinity()));
}
