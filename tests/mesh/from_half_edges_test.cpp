// SPDX-License-Identifier: MIT
#include <irg/mesh/from_half_edges.hpp>

#include <initializer_list>

#include <irg/mesh/euler_operators.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/to_half_edges.hpp>

#include "support/check_both.hpp"
#include "support/half_edge_facts.hpp"

namespace {

// A box of side 2 about the origin, from Euler operators alone: a square that is drawn out.
constexpr irg::half_edge_mesh<double> boxed(double half, double low, double high) {
  irg::half_edge_mesh<double> b;
  const auto v = irg::make_shell<double>(b, {-half, -half, low});
  const std::uint32_t ab = irg::make_edge_vertex<double>(b, v, {half, -half, low}).value();
  const std::uint32_t bc = irg::make_edge_vertex<double>(b, b.twin(ab), b.twin(ab), {half, half, low}).value();
  const std::uint32_t cd = irg::make_edge_vertex<double>(b, b.twin(bc), b.twin(bc), {-half, half, low}).value();
  // The walk round the tree is ab bc cd dc cb ba; an edge from d to a leaves two squares.
  irg::make_edge_face(b, ab, b.twin(cd));
  const std::uint32_t square[4] = {ab, bc, cd, b.next(cd)};
  std::uint32_t up[4]{};
  for (int i = 0; i < 4; ++i) {
    auto p = b.positions[b.origin(square[i])];
    p.z = high;
    up[i] = irg::make_edge_vertex<double>(b, square[i], square[i], p).value();
  }
  for (int i = 0; i < 4; ++i) irg::make_edge_face(b, b.twin(up[i]), i < 3 ? b.twin(up[i + 1]) : b.next(up[0]));
  return b;
}

double six_volumes(const irg::mesh<double>& m) {
  double sum = 0;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 2; k < m.face_size(f); ++k) {
      const auto a = m.positions[m.corner(f, 0).position], b = m.positions[m.corner(f, k - 1).position],
                 c = m.positions[m.corner(f, k).position];
      sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    }
  return sum;
}

}  // namespace

TEST_CASE("to_mesh: a box of Euler operators, at compile time, too") {
  CHECK_BOTH(irg::counts_of(boxed(1, -1, 1)) == irg::half_edge_counts{8, 12, 6, 0, 1, 0, 0});
  CHECK_BOTH(irg::to_mesh(boxed(1, -1, 1)).face_count() == 6);
  CHECK_BOTH(irg::to_mesh(irg::half_edge_mesh<double>{}) == irg::mesh<double>{});
  CHECK(test::is_sound(boxed(1, -1, 1)));
  CHECK(std::abs(six_volumes(irg::to_mesh(boxed(1, -1, 1)))) == 48);
}

TEST_CASE("to_mesh: a hole through a box is two rings, and the mesh has the volume that is left") {
  // The same box, and a shaft: the lower and upper square of a second box become rings of the first one's.
  const auto outer = irg::to_mesh(boxed(2, -1, 1));
  auto shaft = irg::to_mesh(boxed(1, -1, 1));
  for (std::size_t f = 0; f < shaft.face_count(); ++f)
    std::reverse(shaft.corners.begin() + static_cast<std::ptrdiff_t>(shaft.face_starts[f]),
                 shaft.corners.begin() + static_cast<std::ptrdiff_t>(shaft.face_starts[f + 1]));
  irg::mesh<double> both = outer;
  for (const auto& p : shaft.positions) both.positions.push_back(p);
  for (std::size_t f = 0; f < shaft.face_count(); ++f) {
    std::vector<std::size_t> names;
    names.reserve(shaft.face_size(f));
    for (std::size_t k = 0; k < shaft.face_size(f); ++k)
      names.push_back(shaft.corner(f, k).position + outer.positions.size());
    irg::add_face(both, names);
  }
  auto b = irg::to_half_edges(both).value;
  CHECK(irg::counts_of(b) == irg::half_edge_counts{16, 24, 12, 0, 2, 0, 0});
  const auto level = [&](std::uint32_t f) {  // 1 or -1 for a lid, 0 for a side
    double sum = 0;
    irg::each_half_edge_of(b, b.faces[f], [&](std::uint32_t h) { sum += b.positions[b.origin(h)].z; });
    return sum / 4;
  };
  for (std::uint32_t f = 6; f < 12; ++f)
    for (std::uint32_t g = 0; g < 6 && b.faces[f] != irg::no_index; ++g)
      if (level(f) != 0 && level(f) == level(g)) CHECK(irg::kill_face_make_ring_hole(b, f, g));
  CHECK(test::is_sound(b));
  CHECK(irg::counts_of(b) == irg::half_edge_counts{16, 24, 10, 2, 1, 0, 1});
  const auto m = irg::to_mesh(b);
  CHECK(m.face_count() == 8 + 16);
  CHECK(std::abs(six_volumes(m)) == 6 * (32 - 8));
  const auto again = irg::to_half_edges(m);
  CHECK(again.status == irg::half_edge_status::ok);
  CHECK(irg::counts_of(again.value).genus == 1);
}

TEST_CASE("shells_of: faces of two bodies, and of a face with a ring") {
  auto b = boxed(1, -1, 1);
  CHECK(irg::shells_of(b).count == 1);
  irg::make_shell<double>(b, {9, 9, 9});
  CHECK(irg::shells_of(b).count == 2);
  CHECK(irg::counts_of(b) == irg::half_edge_counts{9, 12, 7, 0, 2, 0, 0});
}

TEST_CASE("to_mesh: as many parts as faces take linear time; faces of no part come last") {
  irg::mesh<double> m = irg::shape_grid<double>({400, 250});
  for (std::size_t f = 0; f < m.face_count(); ++f) m.parts.push_back({f % 2 == 0 ? "even" : "odd", {}, {}, f, 1});
  auto b = irg::to_half_edges(m).value;
  CHECK(irg::to_mesh(b) == m);
  std::swap(b.face_parts[0], b.face_parts[2]);
  b.face_parts[1] = irg::no_index;
  const auto turned = irg::to_mesh(b);
  CHECK(turned.corners[0] == m.corners[6]);
  CHECK(turned.parts.size() == m.parts.size() + 1);
  CHECK(turned.parts[1].face_count == 0);
  CHECK(turned.parts.back().face_count == 1);
  CHECK(turned.corners.back() == m.corners[5]);
}
