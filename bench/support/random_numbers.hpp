// SPDX-License-Identifier: MIT
// Seeded numbers: every machine measures the same workloads.
#pragma once

#include <cmath>
#include <cstdint>

namespace bench {

/// SplitMix64 (Steele, Lea, Flood 2014).
class random_numbers {
public:
  explicit random_numbers(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// In [low, high).
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// An integer in [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(next() % static_cast<std::uint64_t>(std::int64_t{high} - low + 1));
  }
  /// Of either sign, its logarithm to base 2 uniform.
  double of_exponent(double low, double high) {
    const double x = std::exp2(between(low, high));
    return (next() & 1) != 0 ? x : -x;
  }

private:
  std::uint64_t state_;
};

}  // namespace bench
