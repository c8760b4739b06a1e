// SPDX-License-Identifier: MIT
#include <irg/mesh/edge_ends.hpp>

#include <map>
#include <set>
#include <utility>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::edge_end;

// Two triangles with the edge from 1 to 2 in common.
constexpr irg::mesh<double> two_triangles() {
  irg::mesh<double> m;
  for (int i = 0; i < 4; ++i) m.positions.push_back({static_cast<double>(i % 2), static_cast<double>(i / 2), 0});
  for (const std::uint32_t i : {0u, 1u, 2u, 2u, 1u, 3u}) m.corners.push_back({i});
  m.face_starts = {0, 3, 6};
  return m;
}

TEST_CASE("edge_ends: by hand") {
  CHECK_BOTH(irg::edge_ends(irg::mesh<double>{}).empty());
  CHECK_BOTH(irg::edge_ends(two_triangles()).size() == 12);
  CHECK_BOTH(irg::edge_ends(two_triangles())[0] == edge_end{0, 1, 0, true});
  CHECK_BOTH(irg::edge_ends(two_triangles())[1] == edge_end{0, 2, 0, false});
  // At position 1: to 0, to 2 of both faces, to 3.
  CHECK_BOTH(irg::edge_ends(two_triangles())[2] == edge_end{1, 0, 1, false});
  CHECK_BOTH(irg::edge_ends(two_triangles())[3] == edge_end{1, 2, 1, true});
  CHECK_BOTH(irg::edge_ends(two_triangles())[4] == edge_end{1, 2, 4, false});
}

TEST_CASE("edge_ends: sorted, and the sides of every face twice (oracle: a map of pairs of positions)") {
  test::random random(12);
  for (int i = 0; i < 200; ++i) {
    irg::mesh<float> m;
    m.positions.resize(9);
    const auto faces = random.integer(0, 12);
    for (std::int64_t f = 0; f < faces; ++f) {
      for (std::int64_t k = random.integer(3, 6); k > 0; --k)
        m.corners.push_back({static_cast<std::uint32_t>(random.integer(0, 8))});
      m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
    }
    std::multiset<edge_end> due;
    for (std::size_t f = 0; f < m.face_count(); ++f)
      for (std::size_t k = 0; k < m.face_size(f); ++k) {
        const std::uint32_t at = m.face_starts[f], here = at + static_cast<std::uint32_t>(k);
        const std::uint32_t next = at + static_cast<std::uint32_t>((k + 1) % m.face_size(f));
        due.insert({m.corners[here].position, m.corners[next].position, here, true});
        due.insert({m.corners[next].position, m.corners[here].position, next, false});
      }
    const auto ends = irg::edge_ends(m);
    REQUIRE(std::is_sorted(ends.begin(), ends.end()));
    REQUIRE(std::multiset<edge_end>(ends.begin(), ends.end()) == due);
  }
}

}  // namespace
