// SPDX-License-Identifier: MIT
#include <irg/core/instructions.hpp>

#include "core/lane_numbers.hpp"
#include "support/check_both.hpp"

namespace {

struct each_lane {
  template <class T, int N>
  void operator()() const {
    using P = irg::pack<T, N>;
    test::random r(N + 9);
    for (int round = 0; round < 300; ++round) {
      const P a = test::any_pack<T, N>(r);
      REQUIRE(test::lanes_are(irg::magnitude(a), [&](int i) { return std::fabs(a[i]); }));
      REQUIRE(test::lanes_are(irg::square_root_instruction(a), [&](int i) { return std::sqrt(a[i]); }));
    }
  }
};

TEST_CASE("magnitude, square_root_instruction: in every lane what the C library gives") {
  test::for_floating_lanes(each_lane{});
  CHECK_BOTH((irg::magnitude(-2.5) == 2.5 && irg::magnitude(-2.5f) == 2.5f && irg::magnitude(3.0) == 3.0));
  CHECK(!std::signbit(irg::magnitude(-0.0)));
  CHECK(irg::square_root_instruction(2.25) == 1.5);
}

template <int N>
void fused() {
  using P = irg::pack<double, N>;
  test::random r(N + 10);
  for (int round = 0; round < 300; ++round) {
    const auto number = [&](int) { return (r.unit() - 0.5) * 8; };
    const P a = irg::lanes<P>::generate(number), b = irg::lanes<P>::generate(number),
            c = irg::lanes<P>::generate(number);
    const auto once = [&](int i) { return std::fma(a[i], b[i], c[i]); };
    const auto twice = [&](int i) { return irg::product(a[i], b[i]) + c[i]; };
    const P sum = irg::fused_multiply_add(a, b, c);
    REQUIRE((irg::has_fused_multiply_add ? test::lanes_are(sum, once) : test::lanes_are(sum, twice)));
    REQUIRE(irg::fused_multiply_add(a[0], b[0], c[0]) == sum[0]);
  }
}

TEST_CASE("fused_multiply_add: rounded once where it says so, else twice") {
  fused<2>();
  fused<4>();
  fused<8>();
  fused<16>();
}

}  // namespace
