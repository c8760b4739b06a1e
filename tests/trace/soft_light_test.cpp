// SPDX-License-Identifier: MIT
#include <irg/trace/soft_light.hpp>

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "support/random.hpp"
#include "trace/worlds.hpp"

namespace {

using world = irg::ray_world<double>;
using P = irg::point<double, 3>;
using lamp = irg::area_light<double>;
constexpr irg::material<double> white{{}, {1, 1, 1}, {}, 1};

TEST_CASE("lit_share_of_rod: a shutter that covers a half, several of them, none") {
  const test::kept_body half(test::rectangle({0, -1, 1}, {9, 0, 0}, {0, 2, 0}), {});
  const auto share = [&](const P& p, const P& a, const P& b) {
    return irg::lit_share_of_rod(world({half.body(white)}, {}), p, a, b);
  };
  CHECK(share({0, 0, 0}, {-1, 0, 2}, {1, 0, 2}) == 0.5);
  CHECK(share({0.25, 0, 0}, {-1, 0, 2}, {1, 0, 2}) == 0.375);
  CHECK(share({9.5, 0, 0}, {-1, 0, 2}, {1, 0, 2}) == 0);
  CHECK(share({0, 0, 0}, {-1, 0, 0.5}, {1, 0, 0.5}) == 1);  // the shutter is behind the rod
  CHECK(share({0, 0, 1.5}, {-1, 0, 2}, {1, 0, 2}) == 1);    // and behind the point
  CHECK(share({0, 5, 0}, {-1, 5, 2}, {1, 5, 2}) == 1);      // beside it
  CHECK(share({0, 0, 0}, {1, 0, 2}, {1, 0, 2}) == 1);
  const test::kept_body left(test::rectangle({-9, -1, 0.75}, {8.75, 0, 0}, {0, 2, 0}), {});
  CHECK(irg::lit_share_of_rod(world({half.body(white), left.body(white)}, {}), P{0, 0, 0}, P{-1, 0, 2}, P{1, 0, 2}) ==
        doctest::Approx(1.0 / 3));
  CHECK(irg::lit_share_of_rod(world(), P{0, 0, 0}, P{-1, 0, 2}, P{1, 0, 2}) == 1);
}

TEST_CASE("lit_share_of_rod: the same share at every scale") {
  for (const double s : {1.0, 0x1p-300, 0x1p-900, 0x1p300, 0x1p900}) {
    const test::kept_body half(test::rectangle({0, -1, 1}, {9, 0, 0}, {0, 2, 0}), {}, s);
    CHECK(irg::lit_share_of_rod(world({half.body(white)}, {}), P{0.25 * s, 0, 0}, P{-s, 0, 2 * s}, P{s, 0, 2 * s}) ==
          0.375);
  }
}

TEST_CASE("lit_share_of_rod: against four thousand rays, among random triangles") {
  test::random r(81);
  for (int round = 0; round < 20; ++round) {
    irg::mesh<double> m;
    const auto c = [&](double low, double high) { return low + (high - low) * r.unit(); };
    for (std::uint32_t i = 0; i < 6; ++i) {
      for (int k = 0; k < 3; ++k) m.positions.push_back({c(-1, 1), c(-1, 1), c(0.2, 1.8)});
      irg::add_face(m, std::array{3 * i, 3 * i + 1, 3 * i + 2});
    }
    const test::kept_body body(m, {});
    const world w({body.body(white)}, {});
    const P p{c(-1, 1), c(-1, 1), 0}, a{-1, c(-1, 1), 2}, b{1, c(-1, 1), 2};
    int seen = 0;
    for (int i = 0; i < 4000; ++i)
      seen += !irg::any_hit(w.triangles(), irg::ray<double, 3>{p, (a + (b - a) * ((i + 0.5) / 4000)) - p, 0, 1});
    CHECK(std::abs(irg::lit_share_of_rod(w, p, a, b) - seen / 4000.0) < 0.004);
  }
}

TEST_CASE("soft_light_of_surface: penumbra of a panel; a panel far away is a lamp") {
  const test::kept_body floor(test::rectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), {}),
      roof(test::rectangle({0, -9, 1}, {9, 0, 0}, {0, 18, 0}), {});
  const world w({floor.body(white), roof.body(white)}, {});
  const std::vector<lamp> panel{{{-1, -1, 2}, {2, 0, 0}, {0, 2, 0}, {1, 1, 1}}};
  const auto at = [&](double x, int samples) {
    const auto s = w.meet(irg::ray<double, 3>{{x, 0.1, 0.5}, {0, 0, -1}});
    return irg::soft_light_of_surface(w, *s, P{0, 0, 9}, std::span<const lamp>(panel), samples).r;
  };
  CHECK(at(-1.5, 8) > at(0, 8));
  CHECK(at(0, 8) > at(0.5, 8));
  CHECK(at(1.2, 8) == 0);
  CHECK(std::abs(at(0, 8) - at(0, 64)) < 0.02);
  const std::vector<lamp> far{{{0, 0, 1000}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}},
      rod{{{0, 0, 1000}, {1, 0, 0}, {}, {1, 1, 1}}};
  const auto s = w.meet(irg::ray<double, 3>{{-3, 0.1, 0.5}, {0, 0, -1}});
  CHECK(irg::soft_light_of_surface(w, *s, P{0, 0, 9}, std::span<const lamp>(far), 3).r ==
        doctest::Approx(1).epsilon(1e-4));
  CHECK(irg::soft_light_of_surface(w, *s, P{0, 0, 9}, std::span<const lamp>(rod), 3).r ==
        doctest::Approx(1).epsilon(1e-4));
}

}  // namespace
