// SPDX-License-Identifier: MIT
#include <irg/raster/depth_format.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <irg/math/constants.hpp>
#include <irg/raster/depth_options.hpp>
#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::depth24_stencil8;
using irg::depth_fixed;
using irg::depth_float;
using irg::depth_float_reversed;
using irg::depth_inverse_w;
using irg::depth_resolution;
using irg::depth_unorm16;
using irg::depth_unorm24;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
constexpr double endless = std::numeric_limits<double>::infinity();
using reversed16 = depth_fixed<16, irg::nearer_is_greater>;

static_assert(irg::DepthFormat<depth_float_reversed> && irg::DepthFormat<depth_float> &&
              irg::DepthFormat<depth_inverse_w> && irg::DepthFormat<depth_unorm16> && irg::DepthFormat<depth_unorm24> &&
              irg::DepthFormat<depth24_stencil8> && irg::DepthFormat<reversed16>);
static_assert(!irg::DepthOrder<depth_float> &&
              !irg::DepthOrder<depth_unorm24>);  // drawn by orders they would be garbage
static_assert(!irg::DepthFormat<float> && !irg::DepthFormat<irg::nearer_is_less>);
static_assert(sizeof(depth_unorm16::stored) == 2 && sizeof(depth_unorm24::stored) == 4);
static_assert(noexcept(depth_unorm24::encode(0.5f)));

// Each lacks one thing that a depth format has.
struct without_encode : depth_float {
  static constexpr double encode(float);
};
struct without_decode : depth_float {
  static constexpr double decode(stored);
};
struct without_level : depth_float {
  static constexpr int level(float);
};
struct without_level_of : depth_float {
  static constexpr int level_of(stored);
};
struct without_with_level : depth_float {
  static constexpr double with_level(stored, float);
};
struct without_farthest : depth_float {
  static constexpr struct {
  } farthest{};
};
struct without_nearest : depth_float {
  static constexpr struct {
  } nearest{};
};
struct without_depth_at : depth_float {
  static constexpr float depth_at(double, double, double);
};
struct without_scale : depth_float {
  static constexpr float scale(double, double);
};
struct without_step_below : depth_float {
  static constexpr float step_below(double);
};
struct without_order : depth_float {
  struct order {};
};
struct derived_from_one : depth_float {};
static_assert(irg::DepthFormat<derived_from_one>);
static_assert(!irg::DepthFormat<without_encode> && !irg::DepthFormat<without_decode> &&
              !irg::DepthFormat<without_level> && !irg::DepthFormat<without_level_of> &&
              !irg::DepthFormat<without_with_level> && !irg::DepthFormat<without_farthest> &&
              !irg::DepthFormat<without_nearest> && !irg::DepthFormat<without_depth_at> &&
              !irg::DepthFormat<without_scale> && !irg::DepthFormat<without_step_below> &&
              !irg::DepthFormat<without_order>);

bool release() { return std::getenv("IRG_RELEASE_TIER") != nullptr; }

TEST_CASE("depth formats: ends, NaN and what lies beyond the range") {
  CHECK_BOTH(depth_unorm16::encode(0.0f) == 0);
  CHECK_BOTH(depth_unorm16::encode(1.0f) == 65535);
  CHECK_BOTH(depth_unorm16::encode(-0.0f) == 0);
  CHECK_BOTH(depth_unorm16::encode(-inf) == 0);
  CHECK_BOTH(depth_unorm16::encode(inf) == 65535);
  CHECK_BOTH(depth_unorm16::encode(nan) == depth_unorm16::farthest);
  CHECK_BOTH(reversed16::encode(nan) == 0);
  static_assert(reversed16::farthest == 0 && reversed16::nearest == 65535);
  CHECK_BOTH(depth_unorm24::encode(1.0f) == 0xffffffu);
  CHECK_BOTH(depth_unorm24::encode(0.5f) == 0x800000u);  // 8388607.5: the greater on a tie
  CHECK_BOTH(depth_float::encode(2.0f) == 1.0f);
  CHECK_BOTH(depth_float::encode(nan) == 1.0f);
  CHECK_BOTH(depth_float_reversed::encode(nan) == 0.0f);
  CHECK_BOTH(depth_float_reversed::encode(1e-45f) == 1e-45f);
  CHECK_BOTH(depth_inverse_w::encode(10.0f) == 10.0f);
  CHECK_BOTH(depth_inverse_w::encode(-10.0f) == 0.0f);
  CHECK_BOTH(depth_inverse_w::encode(nan) == 0.0f);
  CHECK_BOTH(depth_inverse_w::encode(inf) == inf);
}

TEST_CASE("depth formats: depth and stencil share a word, and the stencil does not count") {
  using f = depth24_stencil8;
  CHECK_BOTH(f::encode(1.0f, 0xab) == 0xffffffabu);
  CHECK_BOTH(f::level_of(0x123456abu) == 0x123456);
  CHECK_BOTH(f::level_of(0xffffffabu) == 0xffffff);
  CHECK_BOTH(f::stencil_of(0x123456abu) == 0xabu);
  CHECK_BOTH(f::with_level(0xabcdefabu, 0x123456) == 0x123456abu);
  CHECK_BOTH(f::decode(0xffffffabu) == 1.0f);
  CHECK_BOTH(!irg::is_nearer<f>(0x5ffu, 0x500u));
  CHECK_BOTH(!irg::is_nearer<f>(0x500u, 0x5ffu));
  CHECK_BOTH(irg::is_nearer<f>(0x5ffu, 0x600u));
  CHECK_BOTH(irg::is_nearer<f>(0x7fffffffu, 0x80000000u));
  CHECK_BOTH(f::level_of(f::farthest) == 0xffffff);
}

TEST_CASE("depth formats: what comes to the cleared value is not nearer than it") {
  const auto hidden = []<class F>(F, float z) { return !irg::is_nearer<F>(F::encode(z), F::farthest); };
  CHECK(hidden(depth_float{}, 1.0f));
  CHECK(!hidden(depth_float{}, 0x1.fffffep-1f));
  CHECK(hidden(depth_float_reversed{}, 0.0f));
  CHECK(!hidden(depth_float_reversed{}, 0x1p-149f));
  CHECK(hidden(depth_inverse_w{}, 0.0f));
  CHECK(hidden(depth_unorm16{}, 1.0f - 0x1p-18f));  // less than half a step in front of the far plane
  CHECK(!hidden(depth_unorm16{}, 1.0f - 0x1p-16f));
  CHECK(hidden(depth_unorm24{}, 1.0f));
  CHECK(!hidden(depth_unorm24{}, 0x1.fffffep-1f));  // 1 - 2^-24: just one step
  CHECK(irg::passes<irg::depth_test::nearer_or_equal, depth_unorm16::order>(depth_unorm16::encode(1.0f),
                                                                            depth_unorm16::farthest));
}

// Every value of Bits bits: its float encodes to itself, and the changes of value lie halfway between two, found by
// bisection on the floats' bits.
template <class F, class Order>
void check_values(std::uint32_t step) {
  const double largest = double{F::largest};
  std::uint32_t wrong = 0;
  for (std::uint32_t v = 0; v < F::largest; v += step) {
    const auto s = static_cast<typename F::stored>(v), next = static_cast<typename F::stored>(v + 1);
    wrong += F::encode(F::decode(s)) != s || !(F::decode(s) < F::decode(next)) ? 1u : 0u;
    wrong += irg::is_nearer<F>(s, next) != Order::nearer(0.0f, 1.0f) ? 1u : 0u;
    // The change from v to v + 1 is at the least float z with z * largest >= v + 1/2.
    const float middle = static_cast<float>((v + 0.5) / largest);
    float first = middle;
    while (static_cast<double>(first) * largest >= v + 0.5) first = std::nextafter(first, -1.0f);
    while (static_cast<double>(first) * largest < v + 0.5) first = std::nextafter(first, 2.0f);
    wrong += F::encode(first) != next || F::encode(std::nextafter(first, -1.0f)) != s ? 1u : 0u;
  }
  CHECK(wrong == 0);
}

TEST_CASE("depth formats: 16 bits, every value; monotone, rounded to nearest, back and forth") {
  check_values<depth_unorm16, irg::nearer_is_less>(1);
  check_values<reversed16, irg::nearer_is_greater>(1);
  check_values<depth_fixed<1>, irg::nearer_is_less>(1);
}

TEST_CASE("depth formats: 24 bits, every 97th value (each one in the release tier)") {
  check_values<depth_unorm24, irg::nearer_is_less>(release() ? 1 : 97);
}

TEST_CASE("depth formats: floats in rising order encode in rising order, right next to each other and far apart") {
  test::random r(5);
  std::uint32_t wrong = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto z = static_cast<float>(std::exp2(-40 * r.unit()));
    const float above = r.integer(0, 1) ? std::nextafter(z, 2.0f) : z * static_cast<float>(1 + r.unit());
    const auto rising = [&]<class F>(F) { return !(F::encode(above) < F::encode(z)); };
    wrong += rising(depth_unorm16{}) && rising(depth_unorm24{}) && rising(depth24_stencil8{}) &&
                     rising(depth_float{}) && rising(depth_inverse_w{})
                 ? 0u
                 : 1u;
    const double exact = std::min(1.0, static_cast<double>(z)) * 16777215.0;
    wrong += std::abs(static_cast<double>(depth_unorm24::encode(z)) - exact) <= 0.5 ? 0u : 1u;
    wrong += depth24_stencil8::encode(z, 7) == (depth_unorm24::encode(z) << 8 | 7u) ? 0u : 1u;
  }
  CHECK(wrong == 0);
}

// The kept value of an unrounded depth: what a format would keep if nothing but the format rounded.
template <class F>
typename F::stored kept(double depth) {
  if constexpr (std::same_as<typename F::stored, float>)
    return static_cast<float>(depth);
  else if constexpr (std::same_as<F, depth24_stencil8>)
    return static_cast<std::uint32_t>(std::floor(depth * 16777215.0 + 0.5)) << 8;
  else
    return static_cast<typename F::stored>(std::floor(depth * double{F::largest} + 0.5));
}

// Pairs that stand as far apart as depth_resolution says are in order, all; at half of it, some are not.
template <class F>
void check_resolution(F format, double z_near, double z_far) {
  test::random r(11);
  const double reach = std::min(z_far, z_near * 1e7);
  int wrong = 0, wrong_at_half = 0;
  const int trials = 20'000;
  for (int i = 0; i < trials; ++i) {
    const double distance = z_near * std::pow(reach / z_near, r.unit());
    const double s = depth_resolution(format, z_near, z_far, distance);
    const auto ordered = [&](double apart) {
      return irg::is_nearer<F>(kept<F>(F::depth_at(z_near, z_far, distance - apart)),
                               kept<F>(F::depth_at(z_near, z_far, distance)));
    };
    if (distance - s < z_near) continue;
    wrong += ordered(s * (1 + 1e-6) + distance * 1e-12) ? 0 : 1;
    wrong_at_half += ordered(s / 2) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(wrong_at_half > trials / 20);
}

TEST_CASE("depth_resolution: the separation that keeps order, and no more than twice the least one") {
  for (const double z_far : {1.0, 10.0, 1e4}) {
    check_resolution(depth_float_reversed{}, 0.1, z_far);
    check_resolution(depth_float{}, 0.1, z_far);
    check_resolution(depth_inverse_w{}, 0.1, z_far);
    check_resolution(depth_unorm16{}, 0.1, z_far);
    check_resolution(depth_unorm24{}, 0.1, z_far);
    check_resolution(depth24_stencil8{}, 0.1, z_far);
    check_resolution(reversed16{}, 0.1, z_far);
  }
  check_resolution(depth_float_reversed{}, 0.1, endless);
  check_resolution(depth_inverse_w{}, 0.1, endless);
}

TEST_CASE("depth_resolution: by hand") {
  // near 1, far infinite, 16 bits: depth 1 - 1/d; at d = 256 a step of 1/65535 is s with s / (256 (256 - s)) = 1/65535.
  CHECK_BOTH(depth_resolution(depth_unorm16{}, 1.0, endless, 256.0) ==
             256.0 * (256.0 / 65535.0 / (1.0 + 256.0 / 65535.0)));
  // Reversed float, far infinite: 2^-23 of the distance where depth is a power of two, whatever the distance.
  constexpr double at_2 = depth_resolution(depth_float_reversed{}, 1.0, endless, 2.0);
  static_assert(at_2 > 2 * 0.9999998 * 0x1p-23 && at_2 < 2 * 0x1p-23);
  CHECK_BOTH(depth_resolution(depth_float_reversed{}, 1.0, endless, 1048576.0) == at_2 * 524288.0);
  CHECK_BOTH(depth_resolution(depth_inverse_w{}, 1.0, 100.0, 2.0) == at_2);
  // near 1e-3, far 1e9.
  CHECK_BOTH(depth_resolution(depth_float_reversed{}, 1e-3, 1e9, 1e8) <= 1e8 * 0x1p-23);
  // 16 bits, near 0.1, far 1e5: at the far end nothing is told from anything behind 0.65.
  CHECK_BOTH(depth_resolution(depth_unorm16{}, 0.1, 1e5, 1e5) > 1e5 - 7000.0);
}

// The greatest separation / distance between near 0.1 and far, as docs/raster/depth_format.md has it.
template <class F>
double worst_share(F format, double ratio) {
  double worst = 0;
  for (int i = 0; i <= 500; ++i) {
    const double distance = std::min(0.1 * std::pow(ratio, i / 500.0), 0.1 * ratio);
    worst = std::max(worst, depth_resolution(format, 0.1, 0.1 * ratio, distance) / distance);
  }
  return worst;
}

TEST_CASE("depth_resolution: the table of the documentation") {
  constexpr double fixed24[] = {5.4e-7, 5.9e-6, 6e-5, 6e-4, 5.9e-3, 5.6e-2};
  constexpr double fixed16[] = {1.4e-4, 1.5e-3, 1.5e-2, 0.13, 0.6, 0.94};
  for (int e = 1; e <= 6; ++e) {
    const double ratio = std::pow(10.0, e);
    CHECK(worst_share(depth_float_reversed{}, ratio) <= 0x1p-23);
    CHECK(worst_share(depth_inverse_w{}, ratio) <= 0x1p-23);
    CHECK(worst_share(depth_float{}, ratio) == doctest::Approx(fixed24[e - 1]).epsilon(0.02));
    CHECK(worst_share(depth_unorm24{}, ratio) == doctest::Approx(fixed24[e - 1]).epsilon(0.02));
    CHECK(worst_share(depth_unorm16{}, ratio) == doctest::Approx(fixed16[e - 1]).epsilon(0.04));
  }
}

struct tally {
  int compared = 0, tied = 0, inverted = 0;
};

// What a pipeline keeps for a point at `distance`: irg's projection matrix, the division, the format, all in floats.
template <class F>
typename F::stored kept_by_pipeline(const irg::mat<float, 4, 4>& m, float distance) {
  const irg::hpoint<float, 3> clip = m * irg::point<float, 3>{distance / 3, -distance / 5, -distance};
  return F::encode(std::same_as<F, depth_inverse_w> ? 1.0f / clip.w : clip.z / clip.w);
}

// Pairs of distances, log-uniform in [0.1, 10^5], apart by `apart(d)`; with `steps` > 0 only those whose unrounded
// depths are that many kept steps apart.
template <class F, class Apart>
tally sort_pairs(int trials, double steps, const Apart& apart, double z_far = static_cast<double>(1e5f)) {
  const double z_near = static_cast<double>(0.1f);
  const bool reversed = F::order::nearer(1.0f, 0.0f);
  const auto m = irg::perspective(irg::half_pi<float>, 1.5f, 0.1f, static_cast<float>(z_far),
                                  reversed ? irg::depth_range::reversed : irg::depth_range::standard);
  test::random r(7);
  tally t;
  for (long i = 0; t.compared < trials && i < 100L * trials; ++i) {
    const auto d1 = static_cast<float>(std::pow(10.0, -1 + 6 * r.unit()));
    const auto d2 = static_cast<float>(static_cast<double>(d1) * (1 + apart(r)));
    if (!(d1 < d2) || d1 < 0.1f || !(d2 < 1e5f)) continue;
    const double t1 = F::depth_at(z_near, z_far, static_cast<double>(d1)),
                 t2 = F::depth_at(z_near, z_far, static_cast<double>(d2));
    if (std::abs(t1 - t2) < steps * F::step_below(std::max(t1, t2))) continue;
    ++t.compared;
    const auto s1 = kept_by_pipeline<F>(m, d1), s2 = kept_by_pipeline<F>(m, d2);
    t.tied += !irg::is_nearer<F>(s1, s2) && !irg::is_nearer<F>(s2, s1) ? 1 : 0;
    t.inverted += irg::is_nearer<F>(s2, s1) ? 1 : 0;
  }
  return t;
}

TEST_CASE(
    "depth formats: pairs 8 kept steps apart or more, near 0.1, far 1e5, through the projection: none misordered") {
  const int trials = release() ? 1'000'000 : 100'000;
  const auto any = [](test::random& r) { return std::pow(10.0, -8 + 9 * r.unit()); };
  const auto check = [&]<class F>(const char* name, F, double z_far = static_cast<double>(1e5f)) {
    const tally t = sort_pairs<F>(trials, 8, any, z_far);
    INFO(name);
    CHECK(t.compared == trials);
    CHECK(t.tied == 0);
    CHECK(t.inverted == 0);
  };
  check("reversed float", depth_float_reversed{});
  check("reversed float, endless", depth_float_reversed{}, endless);
  check("float", depth_float{});
  check("1/w", depth_inverse_w{});
  check("24 bits", depth_unorm24{});
  check("24 bits and stencil", depth24_stencil8{});
  check("16 bits", depth_unorm16{});
}

TEST_CASE("depth formats: pairs 1e-5 of their distance apart, near 0.1, far 1e5: how many are not told in order") {
  const int trials = release() ? 1'000'000 : 50'000;
  const auto close = [](test::random&) { return 1e-5; };
  const auto share = [&]<class F>(const char* name, F) {
    const tally t = sort_pairs<F>(trials, 0, close);
    const double percent = 100.0 * (t.tied + t.inverted) / t.compared;
    MESSAGE(std::string(name), ": ", percent, " %");
    return percent;
  };
  CHECK(share("reversed float", depth_float_reversed{}) == 0);
  CHECK(share("1/w", depth_inverse_w{}) == 0);
  CHECK(share("float", depth_float{}) > 40);
  CHECK(share("24 bits", depth_unorm24{}) > 40);
  CHECK(share("16 bits", depth_unorm16{}) > 80);
}

}  // namespace
