// SPDX-License-Identifier: MIT
#include <irg/spatial/bsp_tree_3d.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <set>
#include <vector>

#include "mesh/short_memory.hpp"
#include "space_scenes.hpp"
#include "support/big_rational.hpp"
#include "support/check_both.hpp"

namespace {

using P = test::space_point;
using tree = irg::bsp_tree_3d<double>;
using irg::bsp_order;
using irg::no_index;

constexpr int order_from(const P& eye, bsp_order which) {
  // A floor, a wall through it, and a triangle beside both.
  const P v[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, -1}, {0.25, 0.25, 1}, {5, 5, 0.25}};
  const irg::triangle_indices t[] = {{{0, 1, 2}}, {{3, 4, 5}}};
  int digits = 0;
  tree(v, t, {.candidates = 1}).visit(eye, which, [&](const irg::bsp_piece_3d& p) {
    digits = digits * 10 + static_cast<int>(p.triangle) + 1;
  });
  return digits;
}

int depth_of(const tree& t) {
  std::vector<int> depth(t.data().nodes.size(), 1);
  int deepest = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {  // nodes below stand behind
    for (const std::uint32_t below : {t.data().nodes[i].front, t.data().nodes[i].back})
      if (below != irg::no_index) depth[below] = depth[i] + 1;
    deepest = std::max(deepest, depth[i]);
  }
  return deepest;
}

template <class Eye>
std::vector<irg::bsp_piece_3d> seen_from(const tree& t, const Eye& eye, bsp_order which) {
  std::vector<irg::bsp_piece_3d> seen;
  t.visit(eye, which, [&](const irg::bsp_piece_3d& p) { seen.push_back(p); });
  return seen;
}
std::vector<std::uint32_t> triangles_from(const tree& t, const P& eye, bsp_order which) {
  std::vector<std::uint32_t> seen;
  t.visit(eye, which, [&](const irg::bsp_piece_3d& p) { seen.push_back(p.triangle); });
  return seen;
}

// Triangles with corners anywhere in a cube, and the points that three of them have in common, in doubles.
struct crossing_triangles {
  std::vector<P> v;
  std::vector<irg::triangle_indices> t;

  crossing_triangles(int n, std::uint64_t seed) {
    test::random r(seed);
    for (int i = 0; i < 3 * n; ++i) {
      const double x = r.unit(), y = r.unit();
      v.push_back({x, y, r.unit()});
    }
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) t.push_back({{3 * i, 3 * i + 1, 3 * i + 2}});
  }
  std::size_t meeting_points() const {
    struct plane {
      irg::vec<double, 3> n;
      double d;
    };
    std::vector<plane> planes;
    for (const auto& [c] : t) {
      const auto n = cross(v[c[1]] - v[c[0]], v[c[2]] - v[c[0]]);
      planes.push_back({n, dot(n, v[c[0]] - P{0, 0, 0})});
    }
    const auto is_in = [&](std::size_t i, const P& p) {
      const auto& [c] = t[i];
      for (std::size_t k = 0; k < 3; ++k)
        if (dot(planes[i].n, cross(v[c[(k + 1) % 3]] - v[c[k]], p - v[c[k]])) < 0) return false;
      return true;
    };
    std::size_t points = 0;
    for (std::size_t i = 0; i < t.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k) {
          const auto &a = planes[i], &b = planes[j], &c = planes[k];
          const double whole = dot(a.n, cross(b.n, c.n));
          const auto at = (cross(b.n, c.n) * a.d + cross(c.n, a.n) * b.d + cross(a.n, b.n) * c.d) * (1 / whole);
          const P p{at[0], at[1], at[2]};
          points += is_in(i, p) && is_in(j, p) && is_in(k, p);
        }
    return points;
  }
};

TEST_CASE("bsp_tree_3d: growth, triangles through each other make little more pieces than they must") {
  const int most = std::getenv("IRG_RELEASE_TIER") != nullptr ? 384 : 192;
  for (int n = 96; n <= most; n *= 2) {
    const crossing_triangles scene(n, 71);
    const tree t(scene.v, scene.t);
    const std::size_t must = scene.meeting_points();
    INFO(n << " triangles, " << t.data().pieces.size() << " pieces, " << must << " points of three");
    CHECK(t.data().pieces.size() >= must);
    CHECK(t.data().pieces.size() <= must + static_cast<std::size_t>(n * n / 3));
  }
}

TEST_CASE("bsp_tree_3d: a wall through a floor, in constant evaluation too") {
  CHECK_BOTH(order_from({0, 0, 5}, bsp_order::back_to_front) == 212);
  CHECK_BOTH(order_from({0, 0, 5}, bsp_order::front_to_back) == 212);
  CHECK_BOTH(order_from({0, 0, -5}, bsp_order::back_to_front) == 212);
  // A corner with NaN: left out.
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr auto left_out = [] {
    const P v[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, nan}, {2, 0, 0}};
    const irg::triangle_indices t[] = {{{0, 1, 2}}, {{0, 1, 3}}};
    const tree bad(v, t);
    return bad.left_out() == 2 && bad.locate({0, 0, 0}) == irg::bsp_place{};
  };
  CHECK_BOTH(left_out());
}

TEST_CASE("bsp_tree_3d: 10^5 parallel planes stay in few levels; a round body makes no chain") {
  const test::space_scene s = test::storeys(100000);
  const tree t(s.vertices, s.triangles);
  CHECK(t.data().nodes.size() == 100000);
  CHECK(depth_of(t) <= 60);
  CHECK(t.splits() == 0);
  const auto up = triangles_from(t, {0, 0, -1}, bsp_order::front_to_back);
  CHECK((up.size() == 100000 && std::is_sorted(up.begin(), up.end())));
  CHECK(t.locate({5, 5, 77}).side == 0);
  const test::space_scene round = test::ball(100);
  const tree b(round.vertices, round.triangles);
  CHECK(depth_of(b) <= 150);
  CHECK(b.data().pieces.size() <= 50000);  // 2.5 for each triangle
}

TEST_CASE("bsp_tree_3d: coplanar triangles, either way round, at one node, the lower number nearer") {
  test::space_scene s;
  for (int i = 0; i < 1000; ++i) {
    const double x = i % 7, y = i % 5;
    if (i % 2 == 0)
      s.add({x, y, x + y}, {x + 3, y, x + y + 3}, {x, y + 2, x + y + 2});
    else
      s.add({x, y, x + y}, {x, y + 2, x + y + 2}, {x + 3, y, x + y + 3});
  }
  const tree t(s.vertices, s.triangles);
  REQUIRE(t.data().nodes.size() == 1);
  for (const P& eye : {P{0, 0, 9}, P{0, 0, -9}, P{1, 1, 2}}) {  // the last one in the plane
    const auto near = triangles_from(t, eye, bsp_order::front_to_back);
    CHECK((near.size() == 1000 && std::is_sorted(near.begin(), near.end())));
    const auto far = triangles_from(t, eye, bsp_order::back_to_front);
    CHECK((far.size() == 1000 && std::is_sorted(far.rbegin(), far.rend())));
  }
  CHECK(t.locate({1, 1, 2}) == irg::bsp_place{0, 0});
}

TEST_CASE("bsp_tree_3d: corners on a plane and sides in it cut nothing; three rods in turn are cut") {
  test::space_scene touching;
  touching.add({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  touching.add({1, 1, 0}, {2, 1, 3}, {1, 2, 3});     // a corner on it
  touching.add({1, 1, 0}, {2, 1, 0}, {1, 2, -3});    // a side in it
  const tree t(touching.vertices, touching.triangles, {.candidates = 1});
  CHECK(t.splits() == 0);
  test::space_scene joined;  // a side in common
  joined.add({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  joined.add({0, 0, 0}, {4, 0, 0}, {0, 0, 4});
  CHECK(tree(joined.vertices, joined.triangles).splits() == 0);
  const test::space_scene rods = test::three_rods();
  const tree r(rods.vertices, rods.triangles);
  CHECK(r.splits() > 0);
}

TEST_CASE("bsp_tree_3d: pieces as polygons make up their triangles") {
  test::random r(8);
  const test::space_scene s = test::whole_numbers(r, 20, false);
  const tree t(s.vertices, s.triangles);
  const auto area_of = [](const std::vector<P>& ring) {
    irg::vec<double, 3> sum{};
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const irg::vec<double, 3> u = ring[i - 1] - ring[0], v = ring[i] - ring[0];
      sum = sum + irg::cross(u, v);
    }
    return sum;
  };
  std::vector<irg::vec<double, 3>> left(s.triangles.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    const auto& [v] = s.triangles[i];
    left[i] = area_of({s.vertices[v[0]], s.vertices[v[1]], s.vertices[v[2]]});
  }
  for (const irg::bsp_piece_3d& p : t.data().pieces) left[p.triangle] = left[p.triangle] - area_of(t.rounded(p));
  for (const auto& rest : left)
    for (int k = 0; k < 3; ++k) CHECK(std::fabs(rest[k]) < 1e-9);
}

TEST_CASE("bsp_tree_3d: slivers of one ulp") {
  test::space_scene s;
  const double up = std::nextafter(1.0, 2.0);
  s.add({0, 0, 1}, {9, 0, 1}, {0, 9, 1});
  s.add({1, 1, up}, {2, 1, std::nextafter(1.0, 0.0)}, {1, 2, 5});
  s.add({1, 1, 1}, {2, 1, up}, {1, 2, 1});
  const tree t(s.vertices, s.triangles, {.candidates = 1});
  CHECK(t.splits() >= 1);
  for (const auto& p : t.data().pieces)
    for (std::uint32_t l = p.limits; l != irg::no_index; l = t.data().limits[l].next)
      CHECK(std::abs(t.data().limits[l].side) == 1);
}

TEST_CASE("bsp_tree_3d: what is merged in stands where it belongs, and goes again") {
  test::random r(9);
  const test::space_scene s = test::whole_numbers(r, 30, false), moving = test::whole_numbers(r, 12, false);
  test::space_scene all = s;
  for (const auto& [v] : moving.triangles) all.add(moving.vertices[v[0]], moving.vertices[v[1]], moving.vertices[v[2]]);
  tree t(s.vertices, s.triangles);
  const auto before = t.data();
  const auto seen_before = seen_from(t, P{3, 20, 7}, bsp_order::back_to_front);
  for (int frame = 0; frame < 3; ++frame) {
    t.merge(moving.vertices, moving.triangles);
    t.merge(s.vertices, s.triangles);  // all of it again, in the planes that are there
    CHECK(irg::find_bsp_fault(t.data()) == irg::bsp_fault{});
    CHECK(t.data().triangles.size() == 72);
    const auto near = triangles_from(t, {3, 20, 7}, bsp_order::front_to_back);
    const std::set<std::uint32_t> shown(near.begin(), near.end());
    CHECK(shown.size() + t.left_out() == 72);
    t.remove_merged();
    CHECK(t.data() == before);
    CHECK(seen_from(t, P{3, 20, 7}, bsp_order::back_to_front) == seen_before);
  }
  tree none;
  none.merge(s.vertices, s.triangles);
  CHECK(none.data() == before);
  none.remove_merged();
  CHECK(none.data().nodes.empty());
}

TEST_CASE("bsp_tree_3d: what is merged in time after time is visited, too") {
  test::random r(19);
  for (const int fixed : {0, 12}) {
    const test::space_scene s = test::whole_numbers(r, fixed, false);
    tree t(s.vertices, s.triangles);
    const auto before = t.data();
    for (int times = 0; times < 4; ++times) {
      const test::space_scene more = test::whole_numbers(r, 3, false);
      t.merge(more.vertices, more.triangles);
      const auto near = triangles_from(t, {3, 20, 7}, bsp_order::front_to_back);
      CHECK(near.size() == t.data().pieces.size());
      CHECK(std::set(near.begin(), near.end()).size() + t.left_out() == t.data().triangles.size());
    }
    t.remove_merged();
    CHECK(t.data() == before);
  }
}

TEST_CASE("bsp_tree_3d: many nodes in one plane are visited in either order") {
  irg::bsp_data_3d<double> d{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}}, {}, {}, {}};
  const std::uint32_t n = 15000;
  for (std::uint32_t i = 0; i < n; ++i) {
    d.nodes.push_back({{0, 3}, i, i + 1, irg::no_index, irg::no_index, i + 1 < n ? i + 1 : irg::no_index});
    d.pieces.push_back({0, irg::no_index});
  }
  const tree t(d);
  for (const bsp_order which : {bsp_order::front_to_back, bsp_order::back_to_front}) {
    std::uint32_t seen = 0;
    bool in_order = true;
    t.visit(P{0, 0, 1}, which, [&](const irg::bsp_piece_3d& p) {
      const std::uint32_t place = static_cast<std::uint32_t>(&p - t.data().pieces.data());
      in_order = in_order && place == (which == bsp_order::front_to_back ? seen : n - 1 - seen);
      ++seen;
    });
    CHECK(seen == n);
    CHECK(in_order);
  }
}

#ifdef __cpp_exceptions
TEST_CASE("bsp_tree_3d: where memory gives out while triangles are merged in, the tree is as it was") {
  test::random r(20);
  const test::space_scene s = test::whole_numbers(r, 12, false), one = test::whole_numbers(r, 4, false),
                          two = test::whole_numbers(r, 4, false);
  tree whole(s.vertices, s.triangles);
  whole.merge(one.vertices, one.triangles);
  const auto before = whole.data();
  const auto seen_before = seen_from(whole, P{3, 20, 7}, bsp_order::back_to_front);
  for (long left = 0;; ++left) {
    REQUIRE(left < 1000);
    tree t = whole;
    test::allocations_left = left;
    bool failed = false;
    try {
      t.merge(two.vertices, two.triangles);
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    test::allocations_left = -1;
    if (!failed) break;
    CHECK(t.data() == before);
    CHECK(t.splits() == whole.splits());
    CHECK(seen_from(t, P{3, 20, 7}, bsp_order::back_to_front) == seen_before);
    t.remove_merged();
    CHECK(t.data() == tree(s.vertices, s.triangles).data());
  }
}
#endif

TEST_CASE("bsp_tree_3d: a tree from its data is the same; what is wrong with data is told") {
  test::random r(4);
  const test::space_scene s = test::whole_numbers(r, 20, false);
  const tree t(s.vertices, s.triangles);
  const tree again(t.data());
  CHECK(again.data() == t.data());
  CHECK(seen_from(again, P{1, 2, 30}, bsp_order::back_to_front) == seen_from(t, P{1, 2, 30}, bsp_order::back_to_front));
  using irg::bsp_defect;
  using irg::bsp_part;
  const auto fault = [&](auto&& change) {
    auto d = t.data();
    change(d);
    return irg::find_bsp_fault(d);
  };
  CHECK(fault([](auto& d) { d.triangles[3].v[1] = 4000; }) == irg::bsp_fault{bsp_defect::index, bsp_part::triangle, 3});
  CHECK(fault([](auto& d) { d.nodes[0].front = 0; }) == irg::bsp_fault{bsp_defect::shape, bsp_part::node, 0});
  CHECK(fault([](auto& d) { d.nodes[0].back = d.nodes[0].front; }).defect == bsp_defect::shape);
  CHECK(fault([](auto& d) { d.nodes[2].plane.axis = 4; }) == irg::bsp_fault{bsp_defect::index, bsp_part::node, 2});
  CHECK(fault([](auto& d) { d.nodes.push_back({}); }).defect == bsp_defect::shape);
  CHECK(fault([](auto& d) { d.pieces.push_back({0, irg::no_index}); }).part == bsp_part::piece);
  CHECK(fault([](auto& d) { d.pieces[1].limits = 77777; }) == irg::bsp_fault{bsp_defect::index, bsp_part::piece, 1});
  CHECK(fault([](auto& d) { d.limits[0].next = 0; }) == irg::bsp_fault{bsp_defect::shape, bsp_part::limit, 0});
  CHECK(fault([](auto& d) { d.limits[1].side = 0; }) == irg::bsp_fault{bsp_defect::shape, bsp_part::limit, 1});
  CHECK(fault([](auto& d) {
          d.vertices[d.triangles[d.pieces[0].triangle].v[0]][0] = std::numeric_limits<double>::infinity();
        }).defect == bsp_defect::flat);
}

#ifdef IRG_HAVE_MPFR
using Q = test::big_rational;
struct place {
  Q v[3];
};
place exactly(const P& p) { return {{Q(p[0]), Q(p[1]), Q(p[2])}}; }

// The distance of a point from a plane, times something.
Q distance(const tree& t, const irg::bsp_plane_3d& plane, const place& p) {
  const auto& d = t.data();
  if (plane.axis < 3) return p.v[plane.axis] - Q(d.vertices[plane.source][static_cast<int>(plane.axis)]);
  const auto& [v] = d.triangles[plane.source];
  const place a = exactly(d.vertices[v[0]]), b = exactly(d.vertices[v[1]]), c = exactly(d.vertices[v[2]]);
  Q u[3], w[3], x[3];
  for (int k = 0; k < 3; ++k) u[k] = b.v[k] - a.v[k], w[k] = c.v[k] - a.v[k], x[k] = p.v[k] - a.v[k];
  return (u[1] * w[2] - u[2] * w[1]) * x[0] + (u[2] * w[0] - u[0] * w[2]) * x[1] + (u[0] * w[1] - u[1] * w[0]) * x[2];
}

// Whether a piece holds a point of its triangle: 1 within, 0 on its border, -1 outside.
int holds(const tree& t, const irg::bsp_piece_3d& piece, const place& p) {
  int in = 1;
  for (std::uint32_t l = piece.limits; l != irg::no_index; l = t.data().limits[l].next) {
    const auto& limit = t.data().limits[l];
    in = std::min(in, distance(t, t.data().nodes[limit.node].plane, p).sign() * limit.side);
  }
  return in;
}

place between(const tree& t, std::uint32_t triangle, test::random& r) {
  const auto& [v] = t.data().triangles[triangle];
  const Q i(static_cast<int>(r.integer(1, 50))), j(static_cast<int>(r.integer(1, 50))),
      k(static_cast<int>(r.integer(1, 50)));
  place p;
  for (int n = 0; n < 3; ++n)
    p.v[n] =
        (i * Q(t.data().vertices[v[0]][n]) + j * Q(t.data().vertices[v[1]][n]) + k * Q(t.data().vertices[v[2]][n])) /
        (i + j + k);
  return p;
}

// Where the ray from the eye over a point meets a triangle within its sides, as a share of that way; 0 where it does
// not.
Q meeting(const tree& t, std::uint32_t triangle, const place& eye, const place& over) {
  const irg::bsp_plane_3d plane{triangle, irg::bsp_plane_3d::of_triangle};
  const Q f = distance(t, plane, eye), g = distance(t, plane, over);
  if ((f - g).sign() == 0) return Q(0);
  const Q share = f / (f - g);
  if (share.sign() <= 0) return Q(0);
  const auto& [v] = t.data().triangles[triangle];
  // The ray passes the three sides on the same side.
  int turn = 0;
  for (int k = 0; k < 3; ++k) {
    const place a = exactly(t.data().vertices[v[k]]), b = exactly(t.data().vertices[v[(k + 1) % 3]]);
    Q x[3], y[3], z[3];
    for (int n = 0; n < 3; ++n) x[n] = a.v[n] - eye.v[n], y[n] = b.v[n] - eye.v[n], z[n] = over.v[n] - eye.v[n];
    const int s =
        ((x[1] * y[2] - x[2] * y[1]) * z[0] + (x[2] * y[0] - x[0] * y[2]) * z[1] + (x[0] * y[1] - x[1] * y[0]) * z[2])
            .sign();
    if (s == 0 || (turn != 0 && s != turn)) return Q(0);
    turn = s;
  }
  return share;
}

TEST_CASE("bsp_tree_3d: pieces tile their triangles, and lie on every ray in the order of the visit") {
  test::random r(16);
  int compared = 0, cut = 0, held = 0;
  const int scenes = std::getenv("IRG_RELEASE_TIER") != nullptr ? 2000 : 60;
  for (int scene = 0; scene < scenes; ++scene) {
    const test::space_scene s = test::whole_numbers(r, 14, scene % 3 == 0);
    tree t(s.vertices, s.triangles, {.candidates = scene % 2 == 0 ? std::size_t{1} : std::size_t{3}});
    for (int times = 0; scene % 4 == 3 && times < 3; ++times) {
      const test::space_scene more = test::whole_numbers(r, 3, false);
      t.merge(more.vertices, more.triangles);
    }
    cut += static_cast<int>(t.splits());
    const auto& pieces = t.data().pieces;
    REQUIRE(irg::find_bsp_fault(t.data()) == irg::bsp_fault{});
    std::vector<std::vector<std::size_t>> of(t.data().triangles.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) of[pieces[i].triangle].push_back(i);
    const auto piece_at = [&](std::uint32_t triangle, const place& p) {  // none on a border
      std::size_t found = pieces.size();
      int parts = 0;
      for (const std::size_t i : of[triangle]) {
        const int in = holds(t, pieces[i], p);
        if (in == 0) return pieces.size();
        if (in > 0) found = i, ++parts;
      }
      REQUIRE(parts == (of[triangle].empty() ? 0 : 1));
      ++held;
      return found;
    };
    for (int trial = 0; trial < 12; ++trial) {
      const auto whole = [&] { return static_cast<double>(r.integer(-7, 7)); };
      const double x = whole(), y = whole(), z = whole();
      const P eye{x, y, z};
      const auto aim = static_cast<std::uint32_t>(r.integer(0, static_cast<std::int64_t>(of.size()) - 1));
      if (of[aim].empty()) continue;
      const place over = between(t, aim, r), from = exactly(eye);
      std::vector<std::size_t> place_of(pieces.size());
      std::size_t n = 0;
      for (const auto& p : seen_from(t, eye, bsp_order::front_to_back))
        place_of[static_cast<std::size_t>(std::find(pieces.begin(), pieces.end(), p) - pieces.begin())] = n++;
      REQUIRE(n == pieces.size());
      struct hit {
        Q at;
        std::size_t visited;
      };
      std::vector<hit> hits;
      for (std::uint32_t i = 0; i < of.size(); ++i) {
        if (of[i].empty()) continue;
        const Q share = meeting(t, i, from, over);
        if (share.sign() == 0) continue;
        place p;
        for (int k = 0; k < 3; ++k) p.v[k] = from.v[k] + share * (over.v[k] - from.v[k]);
        const std::size_t piece = piece_at(i, p);
        if (piece != pieces.size()) hits.push_back({share, place_of[piece]});
      }
      std::sort(hits.begin(), hits.end(), [](const hit& a, const hit& b) { return a.visited < b.visited; });
      for (std::size_t k = 1; k < hits.size(); ++k) {
        REQUIRE(!(hits[k].at < hits[k - 1].at));
        ++compared;
      }
    }
  }
  CHECK(compared > 500);
  CHECK(cut > 500);
  CHECK(held > 1000);
}

TEST_CASE("bsp_tree_3d: no piece is empty, every limit cuts") {
  // Each piece has a point within: the mean of the corners that its sides and limits make, found in rationals by
  // clipping the triangle.
  test::random r(77);
  for (int scene = 0; scene < 12; ++scene) {
    const test::space_scene s = test::whole_numbers(r, 12, scene % 2 == 1);
    const tree t(s.vertices, s.triangles, {.candidates = 1});
    for (const auto& piece : t.data().pieces) {
      std::vector<place> ring;
      for (const std::uint32_t v : t.data().triangles[piece.triangle].v) ring.push_back(exactly(t.data().vertices[v]));
      for (std::uint32_t l = piece.limits; l != irg::no_index; l = t.data().limits[l].next) {
        const auto& limit = t.data().limits[l];
        std::vector<place> kept;
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const place &a = ring[i], &b = ring[(i + 1) % ring.size()];
          const auto& plane = t.data().nodes[limit.node].plane;
          const Q f = distance(t, plane, a) * Q(limit.side), g = distance(t, plane, b) * Q(limit.side);
          if (f.sign() >= 0) kept.push_back(a);
          if (f.sign() * g.sign() >= 0) continue;
          place c;
          for (int k = 0; k < 3; ++k) c.v[k] = a.v[k] + f / (f - g) * (b.v[k] - a.v[k]);
          kept.push_back(c);
        }
        ring = kept;
      }
      REQUIRE(ring.size() >= 3);
      place mean;
      for (const place& p : ring)
        for (int k = 0; k < 3; ++k) mean.v[k] = mean.v[k] + p.v[k] / Q(static_cast<int>(ring.size()));
      CHECK(holds(t, piece, mean) == 1);
    }
  }
}

TEST_CASE("bsp_tree_3d: the direction to an eye infinitely far away orders as an eye far enough") {
  test::random r(5);
  for (int scene = 0; scene < 20; ++scene) {
    const test::space_scene s = test::whole_numbers(r, 16, false);
    const tree t(s.vertices, s.triangles);
    const irg::vec<double, 3> to{static_cast<double>(r.integer(-9, 9)) + 0.25,
                                 static_cast<double>(r.integer(-9, 9)) + 0.125,
                                 static_cast<double>(r.integer(-9, 9)) + 0.0625};
    for (const auto order : {bsp_order::back_to_front, bsp_order::front_to_back})
      CHECK(seen_from(t, to, order) == seen_from(t, P{to[0] * 0x1p40, to[1] * 0x1p40, to[2] * 0x1p40}, order));
  }
}
#endif

}  // namespace
