// SPDX-License-Identifier: MIT
// A number as other libraries have them: exact, never a constant, and with numeric_limits that are specialised although
// there is no end, whose NaN is no such number but becomes one.
#pragma once

#include <limits>

#include "support/rational.hpp"

namespace test {

class endless {
public:
  endless() {}
  explicit endless(int n) : value_(n) {}
  explicit endless(const rational& r) : value_(r) {}
  endless(const endless& e) : value_(e.value_) {}
  endless& operator=(const endless& e) {
    value_ = e.value_;
    return *this;
  }
  ~endless() {}
  friend endless operator+(const endless& a, const endless& b) { return endless(a.value_ + b.value_); }
  friend endless operator-(const endless& a, const endless& b) { return endless(a.value_ - b.value_); }
  friend endless operator*(const endless& a, const endless& b) { return endless(a.value_ * b.value_); }
  friend endless operator/(const endless& a, const endless& b) { return endless(a.value_ / b.value_); }
  friend endless operator-(const endless& a) { return endless(-a.value_); }
  friend bool operator<(const endless& a, const endless& b) { return a.value_ < b.value_; }
  friend bool operator==(const endless& a, const endless& b) { return a.value_ == b.value_; }

private:
  rational value_;
};

/// What stands for a number until it is asked for.
struct no_endless {
  no_endless() = default;
  no_endless(const endless&) {}
  operator endless() const { return {}; }
};

}  // namespace test

template <>
struct std::numeric_limits<test::endless> : std::numeric_limits<test::rational> {
  static constexpr bool is_specialized = true;
  static test::endless max() { return {}; }
  static test::no_endless quiet_NaN() { return {}; }
};
