// SPDX-License-Identifier: MIT
#include <irg/raster/depth_format.hpp>

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

}  // namespace
