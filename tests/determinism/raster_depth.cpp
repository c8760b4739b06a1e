// SPDX-License-Identifier: MIT
#include <irg/raster/depth_format.hpp>
#include <irg/raster/face_order.hpp>
#include <irg/raster/triangle_coverage.hpp>

#include "hashes.hpp"

namespace {

constexpr std::uint64_t raster_depth_formats(int rounds) {
  test::random r(32);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto z = static_cast<float>(irg::product(1.2, r.unit()) - 0.1);
    h.add(irg::depth_unorm16::encode(z));
    h.add(irg::depth_unorm24::encode(z));
    h.add(irg::depth24_stencil8::encode(z, 3));
    h.add(irg::depth_unorm24::decode(irg::depth_unorm24::encode(z)));
    const double distance = 0.1 + irg::product(900.0, r.unit());
    h.add(irg::depth_resolution(irg::depth_float_reversed{}, 0.1, 1000.0, distance));
    h.add(irg::depth_resolution(irg::depth_float{}, 0.1, 1000.0, distance));
    h.add(irg::depth_resolution(irg::depth_unorm24{}, 0.1, 1000.0, distance));
    h.add(irg::depth_resolution(irg::depth_inverse_w{}, 0.1, 1000.0, distance));
  }
  return h.value();
}
HASHED(raster_depth_formats, 50, 20000);

// Faces on a lattice, so that many depths are equal or close; of two in three the depths are next to each other, of one
// far apart.
constexpr std::uint64_t raster_face_order(int rounds) {
  test::random r(33);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto face = [&](std::uint32_t number) {
      irg::screen_vertex v[3];
      for (auto& c : v) {
        const auto step = static_cast<float>(r.integer(0, 3));
        c.position = {static_cast<std::int32_t>(128 * r.integer(-8, 40)),
                      static_cast<std::int32_t>(128 * r.integer(-8, 40))};
        c.depth = i % 3 == 0 ? step * 0x1p-149f : i % 3 == 1 ? step * 0x1p-70f + 0.25f * step : 1.0f + step * 0x1p-23f;
      }
      return irg::make_screen_face(v[0], v[1], v[2], number);
    };
    const irg::screen_face a = face(0), b = face(1);
    const int x = static_cast<int>(r.integer(-9, 20)), y = static_cast<int>(r.integer(-9, 20));
    h.add(irg::compare_depths(a, b, x, y) + 1);
    h.add(irg::is_nearer<irg::nearer_is_less>(a, b, x, y));
    h.add(irg::sign_of(irg::side_of_face(a, b.v[0])) + 1);
    h.add(static_cast<int>(irg::classify(a.coverage, {x, y, x + 4, y + 4})));
  }
  return h.value();
}
HASHED(raster_face_order, 50, 20000);

}  // namespace
