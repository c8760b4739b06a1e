// SPDX-License-Identifier: MIT
// After `using namespace irg` a bare call of an elementary function is irg's or an error, never the C library's.
#include <math.h>

#include <cmath>
#include <concepts>

#include <irg/math/exponential.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/trigonometry.hpp>

#include "support/check_both.hpp"

namespace with_directive {

using namespace irg;

#define CALLED(name)                                       \
  template <class... T>                                    \
  concept calls_##name = requires(T... x) { name(x...); }; \
  static_assert(!calls_##name<double> && !calls_##name<float>)
CALLED(sin);
CALLED(cos);
CALLED(tan);
CALLED(asin);
CALLED(acos);
CALLED(atan);
CALLED(exp);
CALLED(exp2);
CALLED(log);
CALLED(log2);
CALLED(log10);
CALLED(cbrt);
#undef CALLED

template <class... T>
concept calls_pow = requires(T... x) { pow(x...); };
template <class... T>
concept calls_atan2 = requires(T... x) { atan2(x...); };
template <class... T>
concept calls_hypot = requires(T... x) { hypot(x...); };
static_assert(!calls_pow<double, double> && !calls_pow<float, float>);
static_assert(!calls_atan2<double, double> && !calls_atan2<float, float>);
static_assert(!calls_hypot<double, double> && !calls_hypot<float, float>);

// Arguments of two types are irg's, and its square root is the C library's bit for bit.
constexpr double mixed_power = pow(1.1, 7), mixed_angle = atan2(1.0, 3.0f), mixed_length = hypot(0.1, 7);

}  // namespace with_directive

TEST_CASE("using namespace irg: what compiles is irg's") {
  using namespace with_directive;
  CHECK_BOTH(mixed_power == irg::pow(1.1, 7.0));
  CHECK_BOTH(mixed_angle == irg::atan2(1.0, 3.0));
  CHECK_BOTH(mixed_length == irg::hypot(0.1, 7.0));
}

TEST_CASE("irg:: and using-declarations take numbers of each kind") {
  using irg::cbrt, irg::pow, irg::sin;
  CHECK_BOTH((sin(0.0) == 0 && sin(0.0f) == 0 && cbrt(27.0) == 3 && cbrt(27.0f) == 3));
  CHECK_BOTH((pow(2.0, 3) == 8 && pow(2.0f, 3) == 8 && pow(2.0, 3.0f) == 8 && pow(2.0f, 3.0) == 8));
  static_assert(std::same_as<decltype(pow(2.0f, 3.0)), float> && std::same_as<decltype(pow(2.0, 3)), double>);
  static_assert(std::same_as<decltype(sin(1.0f)), float> && std::same_as<decltype(irg::hypot(3, 4)), double>);
}
