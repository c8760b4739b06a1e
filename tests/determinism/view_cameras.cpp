// SPDX-License-Identifier: MIT
// The textbook's view transform and projection, camera frames, polar cameras and lights.
#include <irg/geometry/compare.hpp>
#include <irg/shade/light_placement.hpp>
#include <irg/view/textbook/polar_camera.hpp>
#include <irg/view/textbook/project_perspective.hpp>
#include <irg/view/textbook/view_transform.hpp>

#include "hashes.hpp"

namespace {

template <class C>
constexpr void add_three(determinism::hasher& h, const C& c) {
  h.add(c.x), h.add(c.y), h.add(c.z);
}

template <class T>
constexpr void add_frame(determinism::hasher& h, const irg::camera_frame<T>& f) {
  add_three(h, f.position);
  for (const auto& axis : {f.right, f.up, f.forward}) add_three(h, axis);
  for (const auto& row : irg::view_matrix(f, irg::handedness::left).m)
    for (const T& entry : row) h.add(entry);
}

template <class T>
constexpr std::uint64_t cameras(int rounds) {
  test::random r(23);
  determinism::hasher h;
  const auto unit = [&] { return static_cast<T>(r.unit()) - T(0.5); };
  for (int k = 0; k < rounds; ++k) {
    const irg::point<T, 3> eye{unit(), unit(), unit()}, target{unit(), unit(), unit()}, p{unit(), unit(), unit()};
    const auto s = irg::textbook::view_transform_steps(eye, target);
    const auto t = irg::textbook::view_transform(eye, target);
    for (const auto& row : t.m)
      for (const T& entry : row) h.add(entry);
    h.add(s.h), add_three(h, s.g2);
    const irg::point<T, 3> seen = irg::textbook::transform_row(p, t);
    if (const auto q = irg::textbook::project_perspective(seen, s.h)) h.add(q->x), h.add(q->y);
    if (const auto q =
            irg::textbook::project_perspective(irg::point<T, 3>{unit() * T(1e-30), unit(), T(1e-36)}, T(1e35)))
      h.add(q->x), h.add(q->y);
    h.add(irg::order_along_line(eye, target, p, eye));
    irg::camera_frame<T> f = irg::look_at_frame(eye, target, irg::vec<T, 3>{unit(), unit(), unit()});
    add_frame(h, f);
    const auto angles = irg::polar_of(f, unit());
    h.add(angles.azimuth), h.add(angles.elevation), h.add(angles.roll);
    f.up = f.up + irg::vec<T, 3>{unit(), unit(), unit()} * T(0.1);
    add_frame(h, irg::orthonormalized(f));
    add_frame(h, irg::frame_of(irg::polar_camera<T>{target, unit(), T(9) * unit(), T(9) * unit(), unit()}));
    add_frame(h, irg::textbook::polar_frame(p.x, p.y, p.z));
    const auto lamp = irg::light_around(target, {unit(), unit(), unit()}, T(1), irg::polar_axis::z_up);
    add_three(h, lamp.position);
  }
  return h.value();
}

constexpr std::uint64_t view_cameras_float(int rounds) { return cameras<float>(rounds); }
constexpr std::uint64_t view_cameras_double(int rounds) { return cameras<double>(rounds); }
HASHED(view_cameras_float, 2, 2000);
HASHED(view_cameras_double, 2, 2000);

}  // namespace
