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

// Words from anywhere, a quadruple each; put back one behind the other.
template <int N>
void quadruples() {
  std::vector<float> from(4 * 3 * N), to(4 * N + 1, -1.0f);
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<float>(i + 1);
  const auto place = [](int i) { return static_cast<std::size_t>(4 * (i * 7 % (3 * N))); };
  const auto q = irg::load_quadruples<N>([&](int i) { return from.data() + place(i); });
  irg::store_quadruples<N>(to.data(), q);
  for (int i = 0; i < N; ++i) {
    const irg::pack<float, N>* const parts[] = {&q.x, &q.y, &q.z, &q.w};
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK((*parts[k])[i] == from[place(i) + k]);
      CHECK(to[4 * static_cast<std::size_t>(i) + k] == from[place(i) + k]);
    }
  }
  CHECK(to.back() == -1.0f);
}

}  // namespace

TEST_CASE("interleaved lanes: quadruples") {
  quadruples<1>();
  quadruples<2>();
  quadruples<4>();
  quadruples<8>();
  quadruples<16>();
}

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
