// SPDX-License-Identifier: MIT
#include <irg/math/decimal_digit.hpp>

#include <string_view>

#include "support/check_both.hpp"

namespace {

TEST_CASE("is_decimal_digit, decimal_digit_value: the ten digits among all characters") {
  CHECK_BOTH(irg::is_decimal_digit('0'));
  CHECK_BOTH(irg::is_decimal_digit('9'));
  CHECK_BOTH(!irg::is_decimal_digit('/'));
  CHECK_BOTH(!irg::is_decimal_digit(':'));
  CHECK_BOTH(irg::decimal_digit_value('7') == 7);
  constexpr std::string_view digits = "0123456789";
  for (int code = -128; code < 256; ++code) {
    const char c = static_cast<char>(code);
    REQUIRE(irg::is_decimal_digit(c) == (digits.find(c) != digits.npos));
    if (irg::is_decimal_digit(c)) REQUIRE(irg::decimal_digit_value(c) == digits.find(c));
  }
}

}  // namespace
