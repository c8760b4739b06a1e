// SPDX-License-Identifier: MIT
// A sink with a state, which can be neither copied nor moved, goes through every function of the chapter that takes one
// and keeps what it counted.
#include <array>
#include <vector>

#include <irg/curve/bezier_forward.hpp>
#include <irg/curve/bezier_queries.hpp>
#include <irg/curve/bezier_surface.hpp>
#include <irg/curve/bezier_zeros.hpp>
#include <irg/curve/bspline_knots.hpp>
#include <irg/curve/bspline_surface.hpp>
#include <irg/curve/flatten.hpp>
#include <irg/curve/surface_tessellation.hpp>
#include <irg/curve/surface_trimming.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>

#include "support/check_both.hpp"

namespace {

using P2 = irg::point<double, 2>;
using P3 = irg::point<double, 3>;
using N = irg::vec<double, 1>;

struct counting_sink {
  int calls = 0;
  constexpr counting_sink() = default;
  counting_sink(const counting_sink&) = delete;
  counting_sink& operator=(const counting_sink&) = delete;
  template <class... T>
  constexpr void operator()(T&&...) {
    ++calls;
  }
};

constexpr std::array<P2, 4> arch{P2{0, 0}, P2{1, 2}, P2{2, 2}, P2{3, 0}};
constexpr std::array<P2, 5> saw{P2{0, 0}, P2{4, 0}, P2{4, 3}, P2{2, 1}, P2{0, 3}};
constexpr irg::bezier_patch<P3, 2, 2> dome() {
  irg::bezier_patch<P3, 2, 2> patch{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      patch.points[i][j] = {static_cast<double>(i), static_cast<double>(j), i == 1 && j == 1 ? 2.0 : 0.0};
  return patch;
}

}  // namespace

TEST_CASE("sinks keep their state: curves") {
  counting_sink flat, forward, crossings, roots, pieces;
  std::array<P2, 12> scratch{};
  std::array<N, 16> numbers{};
  irg::flatten(arch, 0.01, scratch, flat);
  CHECK(flat.calls > 3);
  irg::bezier_forward(arch, 8, scratch, forward);
  CHECK(forward.calls == 9);
  CHECK(irg::bezier_line_intersections(arch, P2{0, 1}, P2{3, 1}, numbers, crossings));
  CHECK(crossings.calls == 2);
  const std::array<N, 2> rising{N{-1}, N{1}};
  irg::bernstein_roots<double>(rising, 0.0, numbers, roots);
  CHECK(roots.calls == 1);
  const int points_before = flat.calls;
  irg::flatten(arch, 0.01, flat);
  CHECK(flat.calls == 2 * points_before);
  irg::bezier_forward(arch, 8, forward);
  CHECK(forward.calls == 18);
  CHECK(irg::bezier_line_intersections(arch, P2{0, 1}, P2{3, 1}, crossings));
  CHECK(crossings.calls == 4);
  irg::bernstein_roots<double>(rising, 0.0, roots);
  CHECK(roots.calls == 2);
  const std::array<double, 6> list{0, 0, 1, 2, 3, 3};
  std::array<double, 8> shares{};
  irg::bspline_bezier_pieces(irg::bspline_knots<double, 1>(list), arch, shares, std::span<P2>(scratch), pieces);
  CHECK(pieces.calls == 3);
  irg::bspline_bezier_pieces(irg::bspline_knots<double, 1>(list), arch, pieces);
  CHECK(pieces.calls == 6);
}

TEST_CASE("sinks keep their state: surfaces and polygons") {
  counting_sink lattice, steps, within, trimmed, ears, patches;
  const auto patch = dome();
  irg::tessellate(patch, 3, 2, lattice);
  CHECK(lattice.calls == 12);
  static_cast<void>(irg::tessellate_steps(patch, 3, 2, steps));
  CHECK(steps.calls == 12);
  const std::vector<P3> points{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 2},
                               {1, 2, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}};
  const irg::control_net<P3> net{points, 3};
  static_cast<void>(irg::tessellate_within(net, 0.1, within));
  CHECK(within.calls > 2);
  CHECK(irg::tessellate_trimmed(net, std::array{P2{0, 0}, P2{1, 0}, P2{0, 1}}, 0.1, trimmed));
  CHECK(trimmed.calls > 2);
  const std::array<double, 5> list{0, 0, 1, 2, 2};
  const irg::bspline_knots<double, 1> along(list);
  std::array<double, 8> shares{};
  std::array<P3, 4> corners{};
  const irg::bspline_surface<P3, 1> surface{along, along, net};
  irg::bspline_surface_patches(surface, shares, corners, patches);
  CHECK(patches.calls == 4);
  irg::bspline_surface_patches(surface, patches);
  CHECK(patches.calls == 8);
  irg::ear_clipping_memory<double> memory;
  CHECK(irg::triangulate_ear_clipping(saw, ears, memory));
  CHECK(ears.calls == 3);
}
