// SPDX-License-Identifier: MIT
// Light along rays among mirrors and glass, bit for bit.
#include "hashes.hpp"

#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/trace/trace_ray.hpp>

#include "trace/worlds.hpp"

namespace {

constexpr std::uint64_t traced_light(int rounds) {
  determinism::hasher h;
  test::random r(91);
  const bool small = rounds == 1;
  for (int i = 0; i < rounds; ++i) {
    const test::kept_body floor(test::rectangle({-9, -9, -2}, {18, 0, 0}, {0, 18, 0}), {});
    const test::kept_body ball(irg::shape_sphere<double>({.slices = small ? 4 : 16, .stacks = small ? 3 : 9}), {});
    const auto share = [&] { return r.unit() * 0.9; };
    const auto colour = [&] { return irg::rgb<double>{share(), share(), share()}; };
    const irg::material<double> dull{colour(), colour(), {}, 1}, polished{colour(), colour(), colour(), 17};
    const irg::optics<double> glass{colour(), colour(), 1 + r.unit()}, mirror{colour(), {}, 1};
    const std::vector<irg::light<double>> lamps{{{3, 2, 4, 1}, colour()}, {{-1, 1, 2, 0}, colour()}};
    const irg::rgb<double> ambient = colour(), sky = colour();
    const irg::ray_world<double> world({ball.body(polished, glass), floor.body(dull, mirror)}, {ambient, lamps}, sky);
    for (int k = 0; k < (small ? 2 : 100); ++k) {
      const irg::ray<double, 3> ray{{r.unit() * 4 - 2, r.unit() * 4 - 2, 3}, {r.unit() - 0.5, r.unit() - 0.5, -1}};
      const irg::rgb<double> light = irg::trace_ray(world, ray, {.bounces = small ? 2 : 6});
      h.add(light.r);
      h.add(light.g);
      h.add(light.b);
    }
  }
  return h.value();
}
HASHED(traced_light, 1, 20);

}  // namespace
