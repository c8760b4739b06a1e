// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/back_faces.hpp>
#include <irg/hidden/back_faces.hpp>
#include <irg/hidden/textbook/zbuffer.hpp>
#include <irg/raster/image.hpp>

#include <array>

#include "hashes.hpp"

namespace {

// Polygons in parallel projection and in perspective, depths by the plane and by steps, in floats and doubles.
template <class T>
constexpr std::uint64_t textbook_buffers(int rounds) {
  using P = irg::point<T, 3>;
  test::random r(31);
  determinism::hasher h;
  const int size = rounds < 10 ? 7 : 60;
  irg::image<int> ids(size, size);
  irg::image<T> depth(size, size);
  const irg::textbook::zbuffer buffers{irg::nearer_is_greater{}, ids, depth};
  for (int i = 0; i < rounds; ++i) {
    const auto any = [&](double low, double high) { return static_cast<T>(low + irg::product(high - low, r.unit())); };
    const auto corner = [&] {
      const T x = any(-5, size + 5), y = any(-5, size + 5);
      return P{x, y, any(-40, 15)};
    };
    if (i % 4 == 0) buffers.clear(-1, T(-1000));
    const P a = corner(), b = corner(), c = corner();
    const auto how = i % 2 ? irg::textbook::depth_evaluation::steps : irg::textbook::depth_evaluation::plane;
    if (i % 4 < 2)
      irg::textbook::zbuffer_polygon(buffers, std::array{a, b, c}, i, {how});
    else
      irg::textbook::zbuffer_polygon_perspective(buffers, std::array{a, b, c}, T(20), i, {how});
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        h.add(ids(x, y));
        h.add(depth(x, y));
      }
  }
  return h.value();
}
constexpr std::uint64_t hidden_zbuffer_float(int rounds) { return textbook_buffers<float>(rounds); }
constexpr std::uint64_t hidden_zbuffer_double(int rounds) { return textbook_buffers<double>(rounds); }
HASHED(hidden_zbuffer_float, 8, 400);
HASHED(hidden_zbuffer_double, 8, 400);

// Which side of triangles an eye sees, near it and infinitely far away.
constexpr std::uint64_t hidden_back_faces(int rounds) {
  test::random r(32);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto number = [&] { return i % 2 ? static_cast<double>(r.integer(-3, 3)) : r.unit() - 0.5; };
    irg::mesh<double> m;
    for (int k = 0; k < 3; ++k) m.positions.push_back({number(), number(), number()});
    irg::add_face(m, std::array{0, 1, 2});
    const irg::point<double, 3> eye{number(), number(), number()};
    h.add(static_cast<int>(irg::side_of_face(m, 0, irg::hpoint<double, 3>{eye.x, eye.y, eye.z, i % 3 ? 1.0 : 0.0})));
    h.add(irg::textbook::mixed_product(m.positions[0], m.positions[1], m.positions[2], eye.z));
    const irg::vec<double, 3> n = irg::textbook::face_normal(m.positions[0], m.positions[1], m.positions[2]);
    h.add(static_cast<int>(irg::side_by_angle(n, m.positions[0], eye)));
    const irg::point<double, 2> flat[] = {{m.positions[0].x, m.positions[0].y},
                                          {m.positions[1].x, m.positions[1].y},
                                          {m.positions[2].x, m.positions[2].y}};
    h.add(static_cast<int>(irg::side_by_order(flat)));
    h.add(irg::textbook::is_back_by_edges(flat) ? 1 : 0);
  }
  return h.value();
}
HASHED(hidden_back_faces, 20, 20000);

}  // namespace
