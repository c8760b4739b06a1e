// SPDX-License-Identifier: MIT
#include <irg/core/interleaved_lanes.hpp>

#include <vector>

#include <doctest/doctest.h>

namespace {

// Numbers 1, 2, 3, ... at an odd address: sorted, put back, and nothing else touched.
template <class T, int N>
void there_and_back() {
  std::vector<T> from(3 * N + 2, T(0)), to(3 * N + 2, T(-1));
  for (int i = 0; i < 3 * N; ++i) from[static_cast<std::size_t>(i) + 1] = static_cast<T>(i + 1);
  const auto t = irg::load_triples<N>(from.data() + 1);
  for (int i = 0; i < N; ++i) {
    CHECK(t.x[i] == static_cast<T>(3 * i + 1));
    CHECK(t.y[i] == static_cast<T>(3 * i + 2));
    CHECK(t.z[i] == static_cast<T>(3 * i + 3));
  }
  irg::store_triples(to.data() + 1, t);
  CHECK(to.front() == T(-1));
  CHECK(to.back() == T(-1));
  for (std::size_t i = 1; i <= 3 * N; ++i) CHECK(to[i] == from[i]);
}

}  // namespace

TEST_CASE("interleaved lanes: there and back") {
  there_and_back<float, 1>();
  there_and_back<float, 2>();
  there_and_back<float, 4>();
  there_and_back<float, 8>();
  there_and_back<float, 16>();
  there_and_back<double, 2>();
  there_and_back<double, 4>();
  there_and_back<double, 8>();
  there_and_back<std::int32_t, 4>();
  there_and_back<std::int32_t, 8>();
}
