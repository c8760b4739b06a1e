// SPDX-License-Identifier: MIT
// Numbers as the example programs print them: the fewest digits that lead back to the same number.
#pragma once

#include <charconv>
#include <string>

namespace program {

/// The shortest text that reads as the same number; whole ones below 2^53 without an exponent, -0 as 0.
inline std::string shortest(double v) {
  if (v == 0) return "0";
  char text[32];
  const auto end = v > -0x1p53 && v < 0x1p53 && v == static_cast<double>(static_cast<long long>(v))
                       ? std::to_chars(text, text + sizeof text, static_cast<long long>(v)).ptr
                       : std::to_chars(text, text + sizeof text, v).ptr;
  return {text, end};
}

}  // namespace program
