// SPDX-License-Identifier: MIT
// The worst inputs that bench/accuracy found, by function. Those of triangles stand in the tests of their headers.
#include <array>

#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/geometry/plane_through_points.hpp>
#include <irg/geometry/polygon_area.hpp>

#include "line_clip_cases.hpp"
#include "support/big_rational.hpp"
#include "support/check_both.hpp"

#ifdef IRG_HAVE_MPFR

using test::big_rational;

TEST_CASE("worst inputs: areas of polygons") {
  using P = irg::point<double, 2>;
  using ring = std::array<P, 16>;
  constexpr ring all[] = {{{{0x1.7d78405aaa758p+26, 0x1.7d784p+26},
                            {0x1.7d78403f58302p+26, 0x1.7d78401a3cf71p+26},
                            {0x1.7d78402dee3bep+26, 0x1.7d78402dee3bep+26},
                            {0x1.7d784028a92fep+26, 0x1.7d7840622a002p+26},
                            {0x1.7d784p+26, 0x1.7d7840799ca0dp+26},
                            {0x1.7d783fdf6609ep+26, 0x1.7d78404eb4efp+26},
                            {0x1.7d783fd2b9438p+26, 0x1.7d78402d46bc8p+26},
                            {0x1.7d783f95d2fbep+26, 0x1.7d78402bfabeep+26},
                            {0x1.7d783f81ed5b3p+26, 0x1.7d784p+26},
                            {0x1.7d783fa3549fep+26, 0x1.7d783fd99d74cp+26},
                            {0x1.7d783fc8e7d6cp+26, 0x1.7d783fc8e7d6cp+26},
                            {0x1.7d783fd4ee483p+26, 0x1.7d783f98058fep+26},
                            {0x1.7d784p+26, 0x1.7d783fb6085d7p+26},
                            {0x1.7d78402476ce5p+26, 0x1.7d783fa7f7c9p+26},
                            {0x1.7d784048046cep+26, 0x1.7d783fb7fb932p+26},
                            {0x1.7d78406c4a977p+26, 0x1.7d783fd324ed3p+26}}},
                          {{{0x1.11c9148d2657cp+0, 0x0p+0},
                            {0x1.401ce28ff06f8p+0, 0x1.0930addf01233p-1},
                            {0x1.189408408d197p+0, 0x1.189408408d196p+0},
                            {0x1.8cb30b9805455p-2, 0x1.dedbc8a92b9cp-1},
                            {0x1.0de1e61e109ffp-53, 0x1.e95517a7ee06ep+0},
                            {-0x1.3c2275c683ca3p-1, 0x1.7d9bb50759664p+0},
                            {-0x1.89adf790a67cp-1, 0x1.89adf790a67c1p-1},
                            {-0x1.a37b45c64211dp+0, 0x1.5b8287894400ap-1},
                            {-0x1.a37b45c6d0d99p+0, 0x1.5b8287894400ap-1},
                            {-0x1.89adf790cd3efp-1, 0x1.89adf790a67c1p-1},
                            {-0x1.3c2275c70a67dp-1, 0x1.7d9bb50759664p+0},
                            {0x1.0de1e61e4f26ep-53, 0x1.e95517a7ee06ep+0},
                            {0x1.8cb30b98084bfp-2, 0x1.dedbc8a92b9cp-1},
                            {0x1.18940840948ffp+0, 0x1.189408408d196p+0},
                            {0x1.401ce290242bap+0, 0x1.0930addf01233p-1},
                            {0x1.11c9148d674f2p+0, 0x0p+0}}}};
  for (const ring& r : all) {
    big_rational twice = 0;
    for (std::size_t i = 0; i < r.size(); ++i) {
      const P &p = r[i], &q = r[(i + 1) % r.size()];
      twice = twice + big_rational(p.x) * big_rational(q.y) - big_rational(q.x) * big_rational(p.y);
    }
    const big_rational exact = twice / big_rational(2);
    CHECK(test::error_in_ulp(irg::polygon_area(r), exact) <= 0.51);
    CHECK(test::error_in_ulp(irg::polygon_area_exact(r), exact) <= 0.5);
  }
}

TEST_CASE("worst inputs: planes through three points") {
  using P = irg::point<double, 3>;
  using Q = irg::point<big_rational, 3>;
  constexpr P all[][3] = {{{0x1.e84807c9c4381p+19, 0x1.e8481f09acedep+19, 0x1.e847ebe6eff0ap+19},
                           {0x1.e847e00a2a969p+19, 0x1.e8480197ff76dp+19, 0x1.e847dfbb69a12p+19},
                           {0x1.e8481d390e64bp+19, 0x1.e847f2f5effaep+19, 0x1.e84827cf24b74p+19}},
                          {{0x1.d64c3408a64ddp-1, 0x1.94cab41fd4261p-2, 0x1.069f954792c31p+0},
                           {-0x1.fa00ceaba2a7ap-1, 0x1.3888792606e4ap-3, -0x1.645342f389292p-1},
                           {-0x1.653bfb0c157b4p-2, -0x1.dfd54d8d3b135p-1, -0x1.e3d6ab0e5ace8p-1}}};
  const auto exact = [](const P& p) { return Q{big_rational(p.x), big_rational(p.y), big_rational(p.z)}; };
  for (const auto& [p, q, r] : all) {
    const auto plane = irg::plane_through_accurate(p, q, r);
    const auto want = irg::plane_through(exact(p), exact(q), exact(r));
    REQUIRE((plane && want));
    CHECK(test::error_in_ulp(plane->a, want->a) <= 0.501);
    CHECK(test::error_in_ulp(plane->b, want->b) <= 0.501);
    CHECK(test::error_in_ulp(plane->c, want->c) <= 0.501);
    CHECK(test::error_in_ulp(plane->d, want->d) <= 0.501);
  }
}

TEST_CASE("worst inputs: clipping of lines") {
  using P = irg::point<double, 2>;
  constexpr irg::box<double, 2> window{{-1, -1}, {1, 1}};
  constexpr P all[][2] = {
      {{-0x1.416d819b664b4p+59, 0x1.de796e6b8bdbcp+58}, {0x1.41946850ff938p+1, -0x1.983e019571a5p+0}},
      {{-0x1.120c3b89b634ap+0, -0x1.ca5b794d430b8p-2}, {0x1.19163e2105618p+0, 0x1.3d6e6dfb60b5p+0}},
      {{-0x1.120c3b89b634ap+1022, -0x1.ca5b794d430b8p+1020}, {0x1.19163e2105618p+1022, 0x1.3d6e6dfb60b5p+1022}},
      {{0x1.dda8722ea5126p+0, -0x1.fffffffffffffp-1}, {0x1.0a9e5fdec337p-3, -0x1p+0}}};
  for (const auto& [a, b] : all) CHECK(line_cases::is_exact<2>(clip_line_liang_barsky(a, b, window), a, b, window));
}

#endif
