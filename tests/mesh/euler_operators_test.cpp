// SPDX-License-Identifier: MIT
#include <irg/mesh/euler_operators.hpp>

#include <new>
#include <vector>

#include <irg/mesh/from_half_edges.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/to_half_edges.hpp>

#include "short_memory.hpp"
#include "support/check_both.hpp"
#include "support/half_edge_facts.hpp"
#include "support/random.hpp"

namespace {

constexpr std::uint32_t none = irg::no_index;
using body = irg::half_edge_mesh<double>;

constexpr body tetrahedron() { return irg::to_half_edges(irg::shape_tetrahedron<double>()).value; }

}  // namespace

TEST_CASE("Euler operators: each and the one that undoes it, at compile time, too") {
  CHECK_BOTH([] {
    body b;
    const auto v = irg::make_shell<double>(b, {1, 2, 3});
    const bool made = irg::counts_of(b) == irg::half_edge_counts{1, 0, 1, 0, 1, 0, 0};
    return made && irg::kill_shell(b, v) && !irg::kill_shell(b, v) && irg::counts_of(b) == irg::half_edge_counts{};
  }());
  CHECK_BOTH([] {  // a vertex is split in two, and joined again
    body b = tetrahedron();
    const auto before = b;
    const auto first = b.half_edge_at[0], last = b.next_around(first);
    const std::uint32_t h = irg::make_edge_vertex<double>(b, first, last, {0, 0, 0}).value();
    const auto split = irg::counts_of(b);
    return split == irg::half_edge_counts{5, 7, 4, 0, 1, 0, 0} && irg::kill_edge_vertex(b, h) &&
           irg::counts_of(b) == irg::counts_of(before) && irg::to_mesh(b).face_count() == 4;
  }());
  CHECK_BOTH([] {  // an edge goes and comes
    body b = tetrahedron();
    const auto h = b.half_edge_at[0], next = b.next(h), last = b.next(b.twin(h));
    if (!irg::kill_edge_face(b, h) || irg::kill_edge_face(b, h)) return false;
    if (irg::counts_of(b) != irg::half_edge_counts{4, 5, 3, 0, 1, 0, 0}) return false;
    return irg::make_edge_face(b, last, next) && irg::counts_of(b).faces == 4;
  }());
  CHECK_BOTH([] {  // a dangling edge becomes a ring, and an edge again
    body b = tetrahedron();
    const auto h = b.half_edge_at[0];
    const std::uint32_t spike = irg::make_edge_vertex<double>(b, h, h, {0, 0, 0}).value();
    const std::uint32_t end = irg::make_edge_vertex<double>(b, b.twin(spike), b.twin(spike), {0, 0, 1}).value();
    const auto ring = irg::kill_edge_make_ring(b, spike);
    if (!ring || irg::counts_of(b) != irg::half_edge_counts{6, 7, 4, 1, 1, 0, 0}) return false;
    return irg::make_edge_kill_ring(b, h, end).has_value() &&
           irg::counts_of(b) == irg::half_edge_counts{6, 8, 4, 0, 1, 0, 0};
  }());
}

TEST_CASE("Euler operators: a ring is made in front of the others of its face, however many they are") {
  body b = tetrahedron();
  const auto h = b.half_edge_at[0], face = b.face(h);
  std::vector<std::uint32_t> rings, listed;
  for (int i = 0; i < 5000; ++i) {
    const std::uint32_t spike = irg::make_edge_vertex<double>(b, h, h, {0, 0, 0}).value();
    irg::make_edge_vertex<double>(b, b.twin(spike), b.twin(spike), {0, 0, 1});
    rings.insert(rings.begin(), irg::kill_edge_make_ring(b, spike).value());
  }
  irg::each_loop_of(b, face, [&](std::uint32_t l) { listed.push_back(l); });
  rings.insert(rings.begin(), b.faces[face]);
  CHECK(listed == rings);
  CHECK(test::is_sound(b));
  for (std::size_t i = 1; i < rings.size(); ++i) irg::make_face_kill_ring_hole(b, rings[i]);
  CHECK(irg::counts_of(b) == irg::half_edge_counts{10004, 5006, 5004, 0, 5001, 0, 0});
}

TEST_CASE("Euler operators: what cannot be done is refused and changes nothing") {
  body b = tetrahedron();
  const auto before = b;
  CHECK(!irg::make_edge_vertex<double>(b, 0, 999, {0, 0, 0}));
  CHECK(!irg::make_edge_vertex<double>(b, 0, 1, {0, 0, 0}));
  CHECK(!irg::make_edge_face(b, 0, 0));
  CHECK(!irg::make_edge_face(b, 0, 1));
  CHECK(!irg::kill_edge_make_ring(b, 0));
  CHECK(!irg::make_edge_kill_ring(b, 0, b.next(0)));
  CHECK(!irg::kill_face_make_ring_hole(b, 2, 2));
  CHECK(!irg::kill_face_make_ring_hole(b, 2, 7));
  CHECK(!irg::make_face_kill_ring_hole(b, 0));
  CHECK(!irg::make_face_kill_ring_hole(b, none));
  CHECK(!irg::kill_edge_face(b, none));
  CHECK(!irg::kill_edge_vertex(b, none));
  CHECK(!irg::kill_shell(b, {0, 0}));
  CHECK(b.half_edges == before.half_edges);
  CHECK(b.faces == before.faces);
}

#ifdef __cpp_exceptions
TEST_CASE("Euler operators: where memory gives out, nothing has changed") {
  irg::mesh<double> m = irg::shape_cube<double>();
  m.parts = {{"a", {}, {}, 0, 5}, {"b", {}, {}, 5, 7}};
  body b = irg::to_half_edges(m).value;
  const auto lone = irg::make_shell<double>(b, {1, 2, 3});
  const std::uint32_t free = irg::make_edge_vertex<double>(b, 0u, 0u, {0.5, 0.5, 0.5}).value();
  const auto unchanged = [&](const body& x) {
    return x.positions == b.positions && x.half_edge_at == b.half_edge_at && x.half_edges == b.half_edges &&
           x.faces == b.faces && x.loops.size() == b.loops.size() && x.face_parts == b.face_parts &&
           x.attributes.size() == b.attributes.size() && x.lone_vertices.size() == b.lone_vertices.size();
  };
  const auto try_each = [&](const auto& change) {
    for (long left = 0;; ++left) {
      body x = b;  // without room for more
      test::allocations_left = left;
      bool failed = false;
      try {
        change(x);
      } catch (const std::bad_alloc&) {
        failed = true;
      }
      test::allocations_left = -1;
      REQUIRE(left < 20);
      CHECK(unchanged(x) == failed);
      if (!failed) return;
    }
  };
  try_each([](body& x) { static_cast<void>(irg::make_shell<double>(x, {0, 0, 0})); });
  try_each([](body& x) { irg::make_edge_vertex<double>(x, 0u, x.next_around(0), {0, 0, 0}); });
  try_each([&](body& x) { irg::make_edge_vertex<double>(x, lone, {0, 0, 0}); });
  try_each([](body& x) { irg::make_edge_face(x, 0u, x.next(x.next(0))); });
  try_each([&](body& x) { irg::kill_edge_make_ring(x, free); });
}
#endif

TEST_CASE("Euler operators: 20,000 steps at random, each sound and true to Euler's formula") {
  test::random r(20);
  std::size_t counts[10]{};
  for (int run = 0; run < 100; ++run) {
    body b = run % 2 ? tetrahedron() : body{};
    for (int step = 0; step < 200; ++step) {
      const auto before = irg::counts_of(b);
      const auto edges = static_cast<std::int64_t>(b.half_edges.size());
      const auto any = [&] { return static_cast<std::uint32_t>(r.integer(0, edges + 1)); };
      const auto near = [&](std::uint32_t h) {  // some steps on, or beyond
        for (std::int64_t k = r.integer(0, 4); k > 0 && h < b.half_edges.size() && b.half_edges[h].origin != none; --k)
          h = b.next(h);
        return h;
      };
      const auto round = [&](std::uint32_t h) {
        for (std::int64_t k = r.integer(0, 3); k > 0 && h < b.half_edges.size() && b.half_edges[h].origin != none; --k)
          h = b.next_around(h);
        return h;
      };
      const auto any_face = [&] { return static_cast<std::uint32_t>(r.integer(0, std::int64_t(b.faces.size()) + 1)); };
      const irg::point<double, 3> p{1, 2, 3};
      const auto h = any();
      irg::half_edge_counts e = before;
      std::size_t which = static_cast<std::size_t>(r.integer(0, 9));
      bool done = false;
      switch (which) {
        case 0:
          if (r.integer(0, 9) == 0 || before.vertices == 0) irg::make_shell(b, p), done = true, ++e.vertices, ++e.faces;
          break;
        case 1:
          done = !b.lone_vertices.empty() && r.integer(0, 1) == 0 && irg::kill_shell(b, b.lone_vertices.back());
          if (done) --e.vertices, --e.faces;
          break;
        case 2:
          done = !b.lone_vertices.empty() && r.integer(0, 1)
                     ? irg::make_edge_vertex(b, b.lone_vertices.front(), p).has_value()
                     : irg::make_edge_vertex(b, h, round(h), p).has_value();
          if (done) ++e.vertices, ++e.edges;
          break;
        case 3:
          done = r.integer(0, 2) == 0 && irg::kill_edge_vertex(b, h);
          if (done) --e.vertices, --e.edges;
          break;
        case 4:
          done = irg::make_edge_face(b, h, near(h)).has_value();
          if (done) ++e.edges, ++e.faces;
          break;
        case 5:
          done = r.integer(0, 2) == 0 && irg::kill_edge_face(b, h);
          if (done) --e.edges, --e.faces;
          break;
        case 6:
          done = irg::kill_edge_make_ring(b, h).has_value();
          if (done) --e.edges, ++e.rings;
          break;
        case 7:
          done = irg::make_edge_kill_ring(b, h, any()).has_value();
          if (done) ++e.edges, --e.rings;
          break;
        case 8:
          done = r.integer(0, 4) == 0 && irg::kill_face_make_ring_hole(b, any_face(), any_face()).has_value();
          if (done) --e.faces, ++e.rings;
          break;
        default:
          done =
              irg::make_face_kill_ring_hole(b, static_cast<std::uint32_t>(r.integer(0, std::int64_t(b.loops.size()))))
                  .has_value();
          if (done) ++e.faces, --e.rings;
      }
      counts[which] += done ? 1u : 0u;
      const auto after = irg::counts_of(b);
      INFO("operator ", which, " step ", step, " edge ", h);
      REQUIRE(test::is_sound(b));
      REQUIRE(after.vertices == e.vertices);
      REQUIRE(after.edges == e.edges);
      REQUIRE(after.faces == e.faces);
      REQUIRE(after.rings == e.rings);
      const auto euler = std::ptrdiff_t(after.vertices) - std::ptrdiff_t(after.edges) + std::ptrdiff_t(after.faces) -
                         std::ptrdiff_t(after.rings);
      REQUIRE(euler == 2 * (std::ptrdiff_t(after.shells) - after.genus));
      REQUIRE(after.genus >= 0);
    }
  }
  for (const std::size_t n : counts) CHECK(n > 10);
}
