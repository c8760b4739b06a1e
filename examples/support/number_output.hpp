// SPDX-License-Identifier: MIT
// Numbers as the example programs print them: the fewest digits that lead back to the same number.
#pragma once

#include <string>

#include <irg/math/decimal.hpp>

namespace program {

/// The shortest text that reads as the same number; whole ones below 2^53 without an exponent, -0 as 0.
inline std::string shortest(double v) {
  if (v == 0) return "0";
  char text[irg::longest_decimal<double>];
  char* const last = text + sizeof text;
  const bool whole = v > -0x1p53 && v < 0x1p53 && v == static_cast<double>(static_cast<long long>(v));
  return {text,
          whole ? *irg::print_integer(text, last, static_cast<long long>(v)) : *irg::print_decimal(text, last, v)};
}

}  // namespace program
