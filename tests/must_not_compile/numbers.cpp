// SPDX-License-Identifier: MIT
// Numbers: what is no scalar, and flags that are refused. CASE 0 is the control and compiles.
#if CASE == 2  // -ffast-math
// expect: irg: -ffast-math and its parts break exact decisions
#define __FAST_MATH__ 1
#endif
#include <irg/core/contraction.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/vec.hpp>

#if CASE == 0
constexpr double x = irg::product(2.0, 3.0);
constexpr int y = irg::clamped(7, 0, 5);
#elif CASE == 1  // operands of two types: which rounding would be meant?
// expect: no matching function for call to .*product
constexpr double x = irg::product(2.0, 3.0f);
#elif CASE == 3  // pointers are no numbers
// expect: (constraint failure|constraints not satisfied)
irg::vec<int*, 2> x;
#elif CASE == 4  // a real number is asked for
// expect: (no matching function for call to .*half|constraints not satisfied)
template <irg::Real T>
constexpr T half(T x) {
  return x / T(2);
}
constexpr int x = half(7);
#elif CASE == 5  // a sum that is computed later, when its operands may be gone
// expect: no_expression
struct late {
  struct expression {
    expression(const late&, const late&);
    operator late() const;
  };
  late() = default;
  explicit late(int);
  bool operator==(const late&) const = default;
  bool operator<(const late&) const;
  expression operator+(const late&) const;
  late operator-(const late&) const;
  late operator*(const late&) const;
  late operator/(const late&) const;
  late operator-() const;
};
irg::vec<late, 2> x;
#endif
