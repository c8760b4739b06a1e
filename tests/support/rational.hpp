// SPDX-License-Identifier: MIT
// A small exact rational: an oracle for algorithms over any Real, and a user-defined number type that proves they ask
// for no more than the concept says. Numbers must stay below 2^126; a test that outgrows them fails aloud.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace test {

__extension__ typedef __int128 int128;

class rational {
public:
  constexpr rational() = default;
  constexpr rational(std::int64_t numerator) : n_(numerator) {}
  constexpr rational(std::int64_t numerator, std::int64_t denominator) { *this = reduced(numerator, denominator); }
  /// The value of a double or float, exactly; |exponent| must be moderate.
  static constexpr rational of(double x) {
    int128 denominator = 1;
    while (x != static_cast<double>(static_cast<std::int64_t>(x))) x *= 2, denominator = checked(denominator, 2);
    return reduced(static_cast<std::int64_t>(x), denominator);
  }

  friend constexpr rational operator+(const rational& a, const rational& b) {
    const int128 g = gcd(a.d_, b.d_);
    return reduced(checked(a.n_, b.d_ / g) + checked(b.n_, a.d_ / g), checked(a.d_, b.d_ / g));
  }
  friend constexpr rational operator-(const rational& a, const rational& b) { return a + -b; }
  friend constexpr rational operator*(const rational& a, const rational& b) {
    const rational x = reduced(a.n_, b.d_), y = reduced(b.n_, a.d_);
    return reduced(checked(x.n_, y.n_), checked(x.d_, y.d_));
  }
  friend constexpr rational operator/(const rational& a, const rational& b) {
    if (b.n_ == 0) std::abort();
    return a * (b.n_ < 0 ? reduced(-b.d_, -b.n_) : reduced(b.d_, b.n_));
  }
  constexpr rational operator-() const { return reduced(-n_, d_); }
  friend constexpr bool operator<(const rational& a, const rational& b) { return (a - b).n_ < 0; }
  constexpr bool operator==(const rational&) const = default;

  /// The nearest double, nearly.
  constexpr explicit operator double() const { return static_cast<double>(n_) / static_cast<double>(d_); }

private:
  static constexpr int128 gcd(int128 a, int128 b) {
    if (a < 0) a = -a;
    while (b != 0) {
      const int128 rest = a % b;
      a = b, b = rest;
    }
    return a;
  }
  static constexpr int128 checked(int128 a, int128 b) {
    constexpr int128 limit = int128{1} << 126;
    const int128 size = a < 0 ? -a : a;
    if (b != 0 && size > limit / (b < 0 ? -b : b)) std::abort();
    return a * b;
  }
  static constexpr rational reduced(int128 n, int128 d) {
    const int128 g = gcd(n, d);
    rational r;
    r.n_ = g == 0 ? n : n / g;
    r.d_ = g == 0 ? 1 : d / g;
    return r;
  }
  int128 n_ = 0, d_ = 1;
};

}  // namespace test
