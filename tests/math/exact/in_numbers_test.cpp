// SPDX-License-Identifier: MIT
#include <irg/math/exact/in_numbers.hpp>

#include <array>

#include "support/check_both.hpp"

namespace {

// A number as it came, and what is made of two of them.
struct engine {
  double value = 0;
  constexpr bool operator==(const engine&) const = default;
  [[maybe_unused]] friend constexpr engine operator+(engine a, engine b) { return {a.value + b.value}; }
  [[maybe_unused]] friend constexpr engine operator-(engine a, engine b) { return {a.value - b.value}; }
  [[maybe_unused]] friend constexpr engine operator*(engine a, engine b) { return {a.value * b.value}; }
  [[maybe_unused]] friend constexpr engine operator-(engine a) { return {-a.value}; }
};
constexpr auto doubled = [](double x) { return engine{2 * x}; };

TEST_CASE("in_numbers: a number, and points and vectors as what they mean, every coordinate once") {
  static_assert(irg::Number<engine>);
  CHECK_BOTH(irg::in_numbers<engine>(3.0, doubled) == engine{6});
  CHECK_BOTH(irg::in_numbers<engine>(irg::point<double, 2>{1, 2}, doubled) == irg::point<engine, 2>{{2}, {4}});
  CHECK_BOTH(irg::in_numbers<engine>(irg::vec<double, 3>{1, 2, 3}, doubled) == irg::vec<engine, 3>{{2}, {4}, {6}});
  CHECK_BOTH(irg::in_numbers<engine>(irg::hpoint<double, 3>{1, 2, 3, 4}, doubled).w == engine{8});
  CHECK_BOTH(irg::in_numbers<engine>(std::array{1.0, 2.0}, doubled) == irg::point<engine, 2>{{2}, {4}});
  CHECK_BOTH(irg::in_numbers<engine>(std::array{1.0, 2.0, 3.0, 4.0}, doubled)[3] == engine{8});
}

}  // namespace
