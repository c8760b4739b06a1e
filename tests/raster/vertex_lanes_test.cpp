// SPDX-License-Identifier: MIT
#include <irg/raster/vertex_lanes.hpp>

#include <doctest/doctest.h>

namespace {

template <int N>
void there_and_back() {
  irg::screen_vertex vertices[64], back[static_cast<unsigned>(N)];
  for (int i = 0; i < 64; ++i) {
    const auto f = static_cast<float>(i);
    vertices[i] = {{i - 30, 1000000 * i - 7}, 0.25f * f - 3.0f, 1.0f / (f + 1.0f)};
  }
  const auto index = [](int i) { return (37 * i + 11) % 64; };
  const auto v = irg::load_vertices<N>(vertices, index);
  for (int i = 0; i < N; ++i) {
    const irg::screen_vertex& from = vertices[index(i)];
    CHECK(v.x[i] == from.position.x);
    CHECK(v.y[i] == from.position.y);
    CHECK(v.depth[i] == from.depth);
    CHECK(v.inverse_w[i] == from.inverse_w);
  }
  irg::store_vertices<N>(back, v);
  for (int i = 0; i < N; ++i) {
    const irg::screen_vertex& from = vertices[index(i)];
    CHECK(back[i].position == from.position);
    CHECK(back[i].depth == from.depth);
    CHECK(back[i].inverse_w == from.inverse_w);
  }
}

TEST_CASE("vertex lanes: from anywhere in memory, and back in a row") {
  there_and_back<2>();
  there_and_back<4>();
  there_and_back<8>();
  there_and_back<16>();
}

}  // namespace
