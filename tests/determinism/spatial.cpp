// SPDX-License-Identifier: MIT
// Trees of boxes, bit for bit, and what rays cross of triangles in them.
#include "hashes.hpp"

#include <array>
#include <span>
#include <vector>

#include <irg/spatial/triangle_bvh.hpp>

namespace {

template <class T>
constexpr std::uint64_t crossings(int rounds, irg::bvh_method method) {
  determinism::hasher h;
  test::random r(81);
  for (int i = 0; i < rounds; ++i) {
    const bool small = rounds == 1;
    const int reach = i % 3 == 0 ? 5 : 4000;
    const auto c = [&] { return static_cast<T>(r.integer(-reach, reach)) / T(3); };
    std::vector<std::array<irg::point<T, 3>, 3>> all;
    for (int k = 0; k < (small ? 6 : 300); ++k) all.push_back({{{c(), c(), c()}, {c(), c(), c()}, {c(), c(), c()}}});
    const irg::triangle_bvh<T> tree(std::span<const std::array<irg::point<T, 3>, 3>>(all), {method});
    for (const irg::bvh_node& n : tree.tree().nodes) {
      for (const float x : n.bounds) h.add(x);
      for (const std::uint32_t child : n.child) h.add(child);
    }
    for (const std::uint32_t place : tree.tree().order) h.add(place);
    for (int k = 0; k < (small ? 2 : 100); ++k) {
      const irg::ray<T, 3> ray{{c(), c(), c()}, {c(), c(), c()}};
      if (const auto hit = irg::closest_hit(tree, ray)) {
        h.add(hit->triangle);
        h.add(hit->at.t);
        h.add(hit->at.weight_b);
        h.add(hit->at.weight_c);
      }
      irg::all_hits(tree, ray, [&](const irg::triangle_hit& x) { h.add(x.triangle); });
      h.add(irg::any_hit(tree, ray));
    }
  }
  return h.value();
}

constexpr std::uint64_t rays_by_area(int rounds) { return crossings<double>(rounds, irg::bvh_method::surface_area); }
constexpr std::uint64_t rays_by_place(int rounds) { return crossings<float>(rounds, irg::bvh_method::morton); }
constexpr std::uint64_t rays_by_cuts(int rounds) { return crossings<float>(rounds, irg::bvh_method::spatial_splits); }
HASHED(rays_by_area, 1, 30);
HASHED(rays_by_place, 1, 30);
HASHED(rays_by_cuts, 1, 30);

}  // namespace
