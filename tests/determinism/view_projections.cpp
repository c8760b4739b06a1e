// SPDX-License-Identifier: MIT
// Projection matrices, frustum planes and corners, axonometric directions, window mappings.
#include <irg/view/axonometry.hpp>
#include <irg/view/frustum.hpp>
#include <irg/view/oblique.hpp>
#include <irg/view/plane_projection.hpp>
#include <irg/view/view_pyramid.hpp>
#include <irg/view/window_to_viewport.hpp>

#include "hashes.hpp"

namespace {

template <class T>
constexpr void add_matrix(determinism::hasher& h, const irg::mat<T, 4, 4>& m) {
  for (const auto& row : m.m)
    for (const T& entry : row) h.add(entry);
}

template <class T>
constexpr std::uint64_t projections(int rounds) {
  test::random r(17);
  determinism::hasher h;
  const auto unit = [&] { return static_cast<T>(r.unit()); };
  for (int k = 0; k < rounds; ++k) {
    const irg::view_window<T> window{-unit(), unit() + T(0.1), -unit(), unit() + T(0.1)};
    const T near = unit() + T(0.01), far = near + irg::product(T(9), unit()) + T(1);
    const auto depth = r.integer(0, 1) ? irg::depth_range::reversed : irg::depth_range::standard;
    const T ratio[3] = {T(1) + unit(), T(1) + unit(), T(1) + unit()};
    const irg::oblique_depth<T> how{T(6) * unit(), unit()};
    const T distance = near + unit(), plane_z = -unit();
    const irg::axonometry<T> seen = irg::axonometry_by_ratios(ratio[0], ratio[1], ratio[2]);
    const irg::mat<T, 4, 4> view = irg::axonometric_view(seen.to_viewer);
    const irg::mat<T, 4, 4> m = irg::perspective(window, distance, near, far, depth) * view;
    add_matrix(h, m);
    add_matrix(h, irg::oblique(irg::oblique_depth<T>{how.angle, how.factor, plane_z}, window, near, far, depth) * view);
    add_matrix(h, irg::perspective(irg::view_pyramid<T>{unit() + T(0.1), unit() + T(1), unit() + T(1), near, far}));
    const irg::plane<T> onto{unit(), unit(), unit() + T(0.1), unit()};
    add_matrix(h, irg::central_projection_onto_checked(onto, irg::point<T, 3>{unit(), unit(), unit()}).value);
    const irg::frustum<T> f = irg::frustum_of(m, depth);
    for (const irg::plane<T>& p : f.planes) h.add(p.a), h.add(p.b), h.add(p.c), h.add(p.d);
    if (const auto corners = irg::frustum_corners(f))
      for (const auto& c : corners->at) h.add(c.x), h.add(c.y), h.add(c.z), h.add(c.w);
    const irg::point<T, 3> low{unit() - T(0.5), unit() - T(0.5), -T(4) * unit()};
    h.add(static_cast<int>(classify(f, irg::box<T, 3>{low, {low.x + unit(), low.y + unit(), low.z + unit()}})));
    h.add(static_cast<int>(classify(f, irg::bounding_sphere<T, 3>{low, unit()})));
    const auto mapping =
        irg::window_to_viewport(window, {unit(), unit(), unit() + T(99), unit() + T(50)}, irg::window_fit::whole).value;
    h.add(mapping.onto.x), h.add(mapping.onto.y), h.add(mapping.scale.x), h.add(mapping.scale.y);
  }
  return h.value();
}

constexpr std::uint64_t view_projections_float(int rounds) { return projections<float>(rounds); }
constexpr std::uint64_t view_projections_double(int rounds) { return projections<double>(rounds); }
HASHED(view_projections_float, 2, 2000);
HASHED(view_projections_double, 2, 2000);

}  // namespace
