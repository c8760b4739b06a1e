// SPDX-License-Identifier: MIT
#include <irg/core/memory_access.hpp>

#include "core/lane_numbers.hpp"
#include "support/check_both.hpp"

namespace {

template <class T>
void streams() {
  constexpr int N = irg::widest_lanes<T>;
  using P = irg::pack<T, N>;
  alignas(64) T to[std::size_t{3} * N] = {};
  test::random r(3);
  const P p = test::any_pack<T, N>(r);
  irg::stream(to + N, p);
  irg::end_of_streams();
  for (int i = 0; i < 3 * N; ++i) CHECK(test::same_lane(to[i], i < N || i >= 2 * N ? T(0) : p[i - N]));
}

TEST_CASE("stream: writes its pack and nothing else") {
  streams<float>();
  streams<double>();
}

TEST_CASE("prefetch: does nothing that can be seen, wherever it leads") {
  int x = 5;
  irg::prefetch(&x);
  irg::prefetch(&x, std::ptrdiff_t{1} << 40);
  irg::prefetch_to_write(&x, -64);
  CHECK(x == 5);
}

TEST_CASE("store_relaxed: writes the byte") {
  CHECK_BOTH([] {
    std::uint8_t bytes[3] = {};
    irg::store_relaxed(bytes[1], 200);
    return bytes[0] == 0 && bytes[1] == 200 && bytes[2] == 0;
  }());
}

}  // namespace
