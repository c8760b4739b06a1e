// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/transformed_facets.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

// What a test's transform gives: the vertex's own numbers.
struct named_vertex {
  int i = -1, j = -1;
  friend bool operator==(const named_vertex&, const named_vertex&) = default;
};

}  // namespace

static_assert([] {
  // A grid of 2 x 2 facets from a corner: 9 vertices, for which 16 are transformed without memory.
  const std::array<double, 3> places{0, 1, 2};
  const auto loops = irg::covering_loops(places, places, -1, -1);
  const auto number = [](int i, int j) { return 10 * i + j; };
  const auto nothing = [](const irg::grid_facet&, const std::array<int, 4>&) {};
  return irg::textbook::visit_transformed_facets(loops, number, nothing).transforms == 9 &&
         irg::textbook::visit_transformed_facets(loops, number, nothing, irg::textbook::vertex_memory::none)
                 .transforms == 16;
}());

TEST_CASE("visit_transformed_facets: the covering order, right corners, no vertex three times") {
  using irg::textbook::vertex_memory;
  test::random r(12);
  int front = 0, corner = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const int n = static_cast<int>(r.integer(1, 7)), m = static_cast<int>(r.integer(1, 7));
    std::vector<double> xs, zs;
    for (int i = 0; i <= n; ++i) xs.push_back(i);
    for (int j = 0; j <= m; ++j) zs.push_back(j);
    // Eyes on grid lines, between them and on all sides.
    const double x = static_cast<double>(r.integer(-2, 2 * n + 2)) / 2;
    const double z = static_cast<double>(r.integer(-2, 2 * m + 2)) / 2;
    const irg::grid_covering loops = irg::covering_loops(xs, zs, x, z);
    for (const vertex_memory memory : {vertex_memory::none, vertex_memory::row}) {
      std::vector<int> asked(static_cast<std::size_t>((n + 1) * (m + 1)), 0);
      std::vector<irg::grid_facet> order, visited;
      int wrong = 0;
      const auto transform = [&](int i, int j) {
        ++asked[static_cast<std::size_t>(i * (m + 1) + j)];
        return named_vertex{i, j};
      };
      const auto counts = irg::textbook::visit_transformed_facets(
          loops, transform,
          [&](const irg::grid_facet& f, const std::array<named_vertex, 4>& c) {
            visited.push_back(f);
            for (int k = 0; k < 4; ++k)
              if (!(c[static_cast<std::size_t>(k)] == named_vertex{f.i - 1 + k / 2, f.j - 1 + k % 2})) ++wrong;
          },
          memory);
      irg::visit_in_covering_order(loops, [&](const irg::grid_facet& f) { order.push_back(f); });
      CHECK(wrong == 0);
      CHECK(visited == order);
      CHECK(counts.facets == n * m);
      int most = 0, least = 9, sum = 0;
      for (const int a : asked) most = std::max(most, a), least = std::min(least, a), sum += a;
      CHECK(counts.transforms == sum);
      CHECK(least >= 1);
      if (memory == vertex_memory::none) {
        CHECK(sum == 4 * n * m);
        continue;
      }
      const int over = loops.first_i <= n && loops.last_i >= 1 ? m : 0;  // beside the vertex under the eye
      const int across = loops.first_j <= m && loops.last_j >= 1 ? n : 0;
      CHECK(sum == (n + 1) * (m + 1) + over + across);
      CHECK(most <= 2);
      if (over == 0 && across == 0) {
        CHECK(most == 1);
        ++corner;
      }
      if (over > 0 && across > 0) ++front;
    }
  }
  CHECK(front > 50);
  CHECK(corner > 50);
}

TEST_CASE("visit_transformed_facets: the counts that the page shows") {
  std::vector<double> places;
  for (int i = 0; i <= 100; ++i) places.push_back(i);
  const auto transforms = [&](double x, double z, irg::textbook::vertex_memory memory) {
    const auto nothing = [](const irg::grid_facet&, const auto&) {};
    return irg::textbook::visit_transformed_facets(
               irg::covering_loops(places, places, x, z), [](int i, int j) { return named_vertex{i, j}; }, nothing,
               memory)
        .transforms;
  };
  using irg::textbook::vertex_memory;
  for (const double x : {-5.0, 50.5})
    for (const double z : {-5.0, 50.5}) CHECK(transforms(x, z, vertex_memory::none) == 40000);
  CHECK(transforms(-5, 105, vertex_memory::row) == 10201);
  CHECK(transforms(-5, 50.5, vertex_memory::row) == 10301);
  CHECK(transforms(30.25, 105, vertex_memory::row) == 10301);
  CHECK(transforms(30.25, 50.5, vertex_memory::row) == 10401);
}
