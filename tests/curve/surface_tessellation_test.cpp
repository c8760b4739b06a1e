// SPDX-License-Identifier: MIT
#include <irg/curve/surface_tessellation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <irg/curve/surface_nets.hpp>
#include <irg/geometry/closest_point.hpp>
#include <irg/mesh/teapot.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P3 = irg::point<double, 3>;
using H3 = irg::hpoint<double, 3>;
using place = std::pair<double, double>;
constexpr double none = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

template <class P>
struct triangle_of {
  std::array<irg::surface_corner<P>, 3> at;
};

template <class P>
std::vector<triangle_of<P>> triangles_within(const irg::control_net<P>& net, double tolerance,
                                             irg::surface_tessellation& done) {
  std::vector<triangle_of<P>> all;
  done = irg::tessellate_within(net, tolerance,
                                [&](const auto& a, const auto& b, const auto& c) { all.push_back({{a, b, c}}); });
  CHECK(done.triangles == all.size());
  return all;
}

P3 cartesian(const P3& p) { return p; }
P3 cartesian(const H3& p) { return irg::to_cartesian(p); }

// The farthest that the surface is from its triangles: each place from the triangle over it.
template <class P>
double farthest(const irg::control_net<P>& net, const std::vector<triangle_of<P>>& all) {
  std::vector<P> room(2 * net.columns + net.rows());
  double most = 0;
  for (const auto& t : all)
    for (int k = 0; k <= 3; ++k)
      for (int l = 0; k + l <= 3; ++l) {
        const std::array<double, 3> w{k / 3., l / 3., (3 - k - l) / 3.};
        double u = 0, v = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          u += w[i] * t.at[i].u.t;
          v += w[i] * t.at[i].v.t;
        }
        const P3 p = cartesian(irg::patch_sample(net, u, v, room).point);
        const auto near = irg::closest_point_on_triangle(t.at[0].point, t.at[1].point, t.at[2].point, p);
        if (near) most = std::fmax(most, irg::length(p - near->at));
      }
  return most;
}

// Triangles that cover the unit square once: all counter-clockwise, of area 1, each edge inside met from both sides.
template <class P>
void check_cover(const std::vector<triangle_of<P>>& all) {
  double area = 0;
  bool all_turn_left = true, all_meet = true;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  std::map<std::size_t, place> where;
  for (const auto& t : all) {
    const auto at = [&](std::size_t i) { return place(t.at[i % 3].u.t, t.at[i % 3].v.t); };
    const double twice = (at(1).first - at(0).first) * (at(2).second - at(0).second) -
                         (at(2).first - at(0).first) * (at(1).second - at(0).second);
    all_turn_left = all_turn_left && twice > 0;
    area += twice / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      where[t.at[i].index] = at(i);
      const std::size_t a = t.at[i].index, b = t.at[(i + 1) % 3].index;
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  CHECK(area == doctest::Approx(1).epsilon(1e-12));
  for (const auto& [edge, times] : edges) {
    const place a = where[edge.first], b = where[edge.second];
    const bool on_border = (a.first == b.first && (a.first == 0 || a.first == 1)) ||
                           (a.second == b.second && (a.second == 0 || a.second == 1));
    all_meet = all_meet && times == (on_border ? 1 : 2);
  }
  CHECK(all_turn_left);
  CHECK(all_meet);
}

std::vector<P3> random_net(test::random& r, std::size_t count) {
  std::vector<P3> points(count);
  for (P3& p : points) p = {r.unit(), r.unit(), r.unit()};
  return points;
}

// Points on one border, in their order along it.
template <class P>
std::vector<P3> on_border(const std::vector<triangle_of<P>>& all, int side) {
  std::map<double, P3> found;
  for (const auto& t : all)
    for (const auto& c : t.at) {
      const double across = side < 2 ? c.v.t : c.u.t, along = side < 2 ? c.u.t : c.v.t;
      if (across == side % 2) found[along] = c.point;
    }
  std::vector<P3> points;
  for (const auto& f : found) points.push_back(f.second);
  return points;
}

constexpr std::array<P3, 4> flat_square{P3{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};

}  // namespace

TEST_CASE("tessellate_within: two triangles of a flat patch; steps") {
  constexpr auto count = [] {
    return irg::tessellate_within(irg::control_net<P3>{flat_square, 2}, 0.1,
                                  [](const auto&, const auto&, const auto&) {});
  };
  CHECK_BOTH(count() == irg::surface_tessellation{4, 2, true});
  constexpr auto steps = [] {
    constexpr irg::bezier_patch<P3, 1, 1> patch{{{{flat_square[0], flat_square[1]}, {flat_square[2], flat_square[3]}}}};
    return irg::tessellate_steps(patch, 3, 2, [](const auto&, const auto&, const auto&) {});
  };
  CHECK_BOTH(steps() == irg::surface_tessellation{12, 12, true});
}

TEST_CASE("tessellate_within: the tolerance holds everywhere, and the square is covered once") {
  test::random r(51);
  double worst = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const auto rows = static_cast<std::size_t>(r.integer(2, 6)), columns = static_cast<std::size_t>(r.integer(2, 6));
    const double tolerance = std::pow(10., -1 - 2 * r.unit());
    irg::surface_tessellation done;
    const auto points = random_net(r, rows * columns);
    if (trial % 2 == 0) {
      const irg::control_net<P3> net{points, columns};
      const auto all = triangles_within(net, tolerance, done);
      worst = std::fmax(worst, farthest(net, all) / tolerance);
      check_cover(all);
    } else {
      std::vector<H3> weighted;
      for (const P3& p : points) weighted.push_back(irg::to_homogeneous(p, 0.25 + 2 * r.unit()));
      const irg::control_net<H3> net{weighted, columns};
      const auto all = triangles_within(net, tolerance, done);
      worst = std::fmax(worst, farthest(net, all) / tolerance);
      check_cover(all);
    }
    CHECK(done.within_tolerance);
  }
  MESSAGE("worst ", worst, " of the tolerance");
  CHECK(worst <= 1);
  CHECK(worst > 0.3);  // nor far better than asked for
}

TEST_CASE("tessellate_within: patches that share a border have the same corners on it, whichever way they run") {
  test::random r(52);
  for (int trial = 0; trial < 40; ++trial) {
    const auto first = random_net(r, 16);
    auto second = random_net(r, 16);
    const int side = static_cast<int>(r.integer(0, 3));
    const bool back = r.integer(0, 1) == 1;
    for (std::size_t k = 0; k < 4; ++k) {  // the first one's border u = 0 as any border of the second, either way round
      const std::size_t to = back ? 3 - k : k;
      second[side == 0 ? 4 * to : side == 1 ? 4 * to + 3 : side == 2 ? to : 12 + to] = first[k];
    }
    irg::surface_tessellation done;
    auto a = on_border(triangles_within<P3>({first, 4}, 0.003, done), 2);
    const auto b = on_border(triangles_within<P3>({second, 4}, 0.003, done), side);
    if (back) std::reverse(a.begin(), a.end());
    CHECK(a.size() > 5);
    CHECK(a == b);
  }
}

TEST_CASE("tessellate_within: the teapot has no cracks, and its poles no triangles without area") {
  const auto patches = irg::teapot_patches<double>();
  std::vector<std::vector<triangle_of<P3>>> meshes;
  std::size_t count = 0;
  for (const auto& patch : patches) {
    const auto list = irg::net_of(patch);
    irg::surface_tessellation done;
    meshes.push_back(triangles_within<P3>({list, 4}, 0.01, done));
    CHECK(done.within_tolerance);
    CHECK(farthest<P3>({list, 4}, meshes.back()) <= 0.01);
    bool all_have_area = true;
    for (const auto& t : meshes.back())
      all_have_area =
          all_have_area && irg::length(cross(t.at[1].point - t.at[0].point, t.at[2].point - t.at[0].point)) > 0;
    CHECK(all_have_area);
    count += meshes.back().size();
  }
  CHECK(count < 16000);
  // Borders met by two patches: u runs round, so that u = 1 of one patch is u = 0 of the next quarter's.
  const auto joined = [&](std::size_t a, std::size_t b, int side_a, int side_b) {
    CHECK(on_border(meshes[a], side_a) == on_border(meshes[b], side_b));
  };
  for (std::size_t q = 0; q < 4; ++q) {
    for (const std::size_t ring : {0u, 4u, 8u, 20u, 24u, 28u}) joined(ring + q, ring + (q + 1) % 4, 3, 2);
    joined(q, 4 + q, 1, 0);
    joined(4 + q, 8 + q, 1, 0);
    joined(8 + q, 28 + q, 1, 0);
    joined(20 + q, 24 + q, 1, 0);
  }
  std::size_t fixed = 0;
  for (const auto& patch : patches)
    fixed += irg::tessellate_steps(patch, 40, 40, [](const auto&, const auto&, const auto&) {}).triangles;
  CHECK(fixed == 32 * 3200 - 8 * 40);  // eight poles
}

TEST_CASE("tessellate_within: straight borders around a twisted patch, an octant of a sphere") {
  std::vector<P3> twisted(flat_square.begin(), flat_square.end());
  twisted[3].z = 1;
  irg::surface_tessellation done;
  auto all = triangles_within<P3>({twisted, 2}, 0.01, done);
  CHECK(done.within_tolerance);
  CHECK(farthest<P3>({twisted, 2}, all) <= 0.01);
  for (int side = 0; side < 4; ++side) CHECK(on_border(all, side).size() == 2);
  check_cover(all);
  constexpr std::array<irg::hpoint<double, 2>, 3> quarter{{{1, 0, 1}, {1, 1, 1}, {0, 2, 2}}};
  std::array<H3, 27> net{};
  irg::revolution_net<double>(quarter, net);
  const irg::control_net<H3> octant{std::span<const H3>(net).first(9), 3};
  const auto round = triangles_within(octant, 1e-3, done);
  CHECK(done.within_tolerance);
  CHECK(farthest(octant, round) <= 1e-3);
  CHECK(round.size() < 6500);
}

TEST_CASE("tessellate_within: tolerance 0, NaN, what is not finite, no weight") {
  irg::surface_tessellation done;
  const std::array<P3, 6> bent{P3{0, 0, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 0, 0}, {2, 1, 0}};
  const auto sink = [](const auto&, const auto&, const auto&) {};
  for (const double tolerance : {0.0, -1.0, none}) {
    done = irg::tessellate_within(irg::control_net<P3>{bent, 2}, tolerance, sink);
    CHECK(!done.within_tolerance);
    CHECK(done.triangles > 0);
  }
  CHECK(irg::tessellate_within(irg::control_net<P3>{bent, 2}, 1e-300, sink).triangles > 0);
  CHECK(irg::tessellate_within(irg::control_net<P3>{flat_square, 2}, 0, sink) == irg::surface_tessellation{4, 2, true});
  auto bad = bent;
  for (const double x : {none, inf, 1e308}) {
    bad[2].x = x;
    bad[3].x = -x;
    CHECK(irg::tessellate_within(irg::control_net<P3>{bad, 2}, 0.1, sink) == irg::surface_tessellation{0, 0, false});
  }
  for (const double w : {0.0, -1.0, none}) {
    std::array<H3, 4> net{H3{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, w}, {1, 1, 0, 1}};
    CHECK(irg::tessellate_within(irg::control_net<H3>{net, 2}, 0.1, sink) == irg::surface_tessellation{0, 0, false});
  }
  const std::array<P3, 4> one{P3{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  CHECK(irg::tessellate_within(irg::control_net<P3>{one, 2}, 0, sink).triangles == 0);
  CHECK(irg::tessellate_within(irg::control_net<P3>{std::span(one).first(1), 1}, 0, sink).triangles == 0);
}
