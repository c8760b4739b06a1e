// SPDX-License-Identifier: MIT
// Seeded input for the accuracy studies, and how their worst cases are printed.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <string>

namespace bench {

/// SplitMix64 (Steele, Lea, Flood 2014).
class numbers {
public:
  explicit numbers(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  int integer(int low, int high) { return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1)); }
  /// Of either sign, its logarithm to base 2 uniform.
  double of_exponent(double low, double high) {
    const double x = std::exp2(between(low, high));
    return (bits() & 1) != 0 ? x : -x;
  }

private:
  std::uint64_t state_;
};

/// Numbers as C++ reads them back.
inline std::string text_of(std::initializer_list<double> numbers) {
  std::string text;
  char word[40];
  for (const double x : numbers) {
    std::snprintf(word, sizeof word, "%a", x);
    text += (text.empty() ? "" : ", ") + std::string(word);
  }
  return text;
}

}  // namespace bench
