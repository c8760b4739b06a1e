// SPDX-License-Identifier: MIT
#include <irg/shade/light.hpp>

#include <array>
#include <limits>

#include "support/check_both.hpp"
#include "support/rational.hpp"

namespace {

using light = irg::light<double, double>;
using vec3 = irg::vec<double, 3>;
using point3 = irg::point<double, 3>;

constexpr bool is_zero(const vec3& v) { return v == vec3{0, 0, 0}; }

}  // namespace

TEST_CASE("light: plain aggregates") {
  static_assert(std::is_aggregate_v<light> && std::is_trivially_copyable_v<irg::lighting<float>>);
  static_assert(std::is_same_v<decltype(irg::light<float>::intensity), irg::rgb<float>>);
  CHECK_BOTH(light{}.position == irg::hpoint<double, 3>{0, 0, 0, 1});
  CHECK_BOTH(irg::lighting<float>{}.lights.empty());
  CHECK_BOTH(irg::lighting<float>{}.distance == irg::distance_term::none);
  CHECK_BOTH(irg::lighting<float>{}.k == 1.0f);
  CHECK_BOTH(irg::lighting<double>{}.k == 1.0);
  // lights of any contiguous container
  constexpr static std::array<light, 2> two{};
  CHECK_BOTH(irg::lighting<double, double>{0.0, two}.lights.size() == 2);
}

TEST_CASE("light: the direction to a source") {
  const auto direction = [](double x, double y, double z, double w, const point3& p) {
    return irg::direction_to_light(light{{x, y, z, w}, 1.0}, p);
  };
  CHECK_BOTH(direction(3, 2, 4, 1, {1, 1, 1}) == vec3{2, 1, 3});
  CHECK_BOTH(direction(6, 4, 8, 2, {1, 1, 1}) == vec3{4, 2, 6});      // the same place, twice as long
  CHECK_BOTH(direction(-6, -4, -8, -2, {1, 1, 1}) == vec3{4, 2, 6});  // and again
  CHECK_BOTH(direction(0, 0, 5, 0, {1, 2, 3}) == vec3{0, 0, 5});      // at infinity: from everywhere alike
  CHECK_BOTH(direction(0, 0, 5, 0, {-7, 0, 1e300}) == vec3{0, 0, 5});
  CHECK_BOTH(is_zero(direction(1, 2, 3, 1, {1, 2, 3})));  // in the point itself
  CHECK_BOTH(is_zero(direction(0, 0, 0, 0, {1, 2, 3})));  // no position at all
}

TEST_CASE("light: exact on rationals") {
  using test::rational;
  constexpr irg::light<rational, rational> source{{rational(3), rational(2), rational(4), rational(1)}, rational(200)};
  constexpr irg::point<rational, 3> centre{rational(1, 3), rational(0), rational(2, 3)};
  CHECK_BOTH(irg::direction_to_light(source, centre) ==
             irg::vec<rational, 3>{rational(8, 3), rational(2), rational(10, 3)});
}
