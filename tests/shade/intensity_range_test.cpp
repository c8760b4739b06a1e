// SPDX-License-Identifier: MIT
#include <irg/shade/intensity_range.hpp>

#include <irg/math/sqrt.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using test::rational;

template <class I, std::size_t N, class T, class How>
constexpr std::array<I, N> fitted(std::array<I, N> intensities, T maximum, const How& how) {
  irg::fit_intensities(std::span<I>(intensities), maximum, how);
  return intensities;
}

constexpr auto by_clamp = irg::intensity_range::clamp;
constexpr auto by_rescale = irg::intensity_range::rescale;

constexpr auto straight = [](const auto& t) { return t; };
constexpr auto squared = [](const auto& t) { return t * t; };
constexpr auto root = [](auto t) { return irg::sqrt(t); };

static_assert(irg::IntensityCurve<decltype(squared), float> && irg::IntensityCurve<decltype(squared), rational>);
static_assert(irg::IntensityCurve<float (*)(float), float> && !irg::IntensityCurve<decltype(squared), int>);
static_assert(!irg::IntensityCurve<irg::intensity_range, double>);

}  // namespace

TEST_CASE("intensity_range: the course's values") {
  CHECK_BOTH(irg::clamp_intensity(rational(290), rational(255)) == rational(255));
  constexpr std::array<rational, 3> three{rational(40), rational(120), rational(290)};
  CHECK_BOTH(fitted(three, rational(255), by_rescale) ==
             std::array<rational, 3>{rational(1020, 29), rational(3060, 29), rational(255)});
  CHECK_BOTH(fitted(three, rational(255), by_clamp) ==
             std::array<rational, 3>{rational(40), rational(120), rational(255)});
  CHECK_BOTH(fitted(std::array<double, 3>{40, 120, 290}, 255.0, by_rescale) ==
             std::array<double, 3>{1020.0 / 29, 3060.0 / 29, 255});
}

TEST_CASE("intensity_range: colours keep their hue when rescaled, not when clamped") {
  using colour = irg::rgb<float>;
  constexpr std::array<colour, 2> two{colour{4.0f, 2.0f, 1.0f}, colour{0.5f, 1.0f, 0.25f}};
  CHECK_BOTH(fitted(two, 1.0f, by_rescale) ==
             std::array<colour, 2>{colour{1.0f, 0.5f, 0.25f}, colour{0.125f, 0.25f, 0.0625f}});
  CHECK_BOTH(fitted(two, 1.0f, by_clamp) == std::array<colour, 2>{colour{1.0f, 1.0f, 1.0f}, colour{0.5f, 1.0f, 0.25f}});
}

TEST_CASE("intensity_range: nothing over the range, nothing at all, and what is no intensity") {
  constexpr float inf = std::numeric_limits<float>::infinity(), no_number = std::numeric_limits<float>::quiet_NaN();
  CHECK_BOTH(fitted(std::array<float, 2>{0.1f, 1.0f}, 1.0f, by_rescale) == std::array<float, 2>{0.1f, 1.0f});
  std::array<float, 1000> all_within{};  // unchanged to the last bit, though x * 0.7f / 0.7f is not always x
  for (std::size_t i = 0; i < all_within.size(); ++i) all_within[i] = static_cast<float>(i) * 0.0007f;
  CHECK(fitted(all_within, 0.7f, by_rescale) == all_within);
  CHECK_BOTH(fitted(std::array<float, 0>{}, 1.0f, by_rescale) == std::array<float, 0>{});
  CHECK_BOTH(fitted(std::array<float, 4>{-1.0f, inf, no_number, -inf}, 1.0f, by_clamp) ==
             std::array<float, 4>{0.0f, 1.0f, 0.0f, 0.0f});
  // A NaN does not hide the largest. (Arithmetic with NaN is no constant expression.)
  CHECK(fitted(std::array<float, 3>{no_number, 4.0f, 2.0f}, 1.0f, by_rescale)[1] == 1.0f);
  CHECK(fitted(std::array<float, 3>{4.0f, no_number, 2.0f}, 1.0f, by_rescale)[2] == 0.5f);
}

TEST_CASE("intensity_range: rescaled intensities are within the range, whatever their size") {
  using colour = irg::rgb<double>;
  CHECK_BOTH(fitted(std::array<colour, 2>{colour{0x1p1023, 0x1p1022, 0}, colour{0x1p1000, 1, 2}}, 256.0, by_rescale) ==
             std::array<colour, 2>{colour{256, 128, 0}, colour{0x1p-15, 0x1p-1015, 0x1p-1014}});
  CHECK_BOTH(fitted(std::array<float, 2>{0x1p127f, 0x1p126f}, 255.0f, by_rescale) ==
             std::array<float, 2>{255.0f, 127.5f});
  int over = 0;
  for (int k = 1; k <= 1000; ++k) {
    const double maximum = 1 + k / 700.0, largest = maximum * (1 + k * 0.37);
    over += fitted(std::array<double, 1>{largest}, maximum, by_rescale)[0] > maximum ? 1 : 0;
  }
  CHECK(over == 0);
}

TEST_CASE("intensity_range: a curve of shares of the largest") {
  using colour = irg::rgb<float>;
  constexpr std::array<rational, 3> three{rational(40), rational(120), rational(290)};
  CHECK_BOTH(fitted(three, rational(255), straight) == fitted(three, rational(255), by_rescale));
  CHECK_BOTH(fitted(three, rational(255), squared) ==
             std::array<rational, 3>{rational(255 * 16, 841), rational(255 * 144, 841), rational(255)});
  CHECK_BOTH(fitted(std::array<colour, 2>{colour{16, 4, 1}, colour{0, 9, 0.25f}}, 2.0f, root) ==
             std::array<colour, 2>{colour{2, 1, 0.5f}, colour{0, 1.5f, 0.25f}});
  // Within the range, too: there the shares are those of the maximum, and no picture jumps where a lamp passes it.
  CHECK_BOTH(fitted(std::array<double, 2>{64, 16}, 256.0, root) == std::array<double, 2>{128, 64});
  CHECK_BOTH(fitted(std::array<double, 2>{64, 16}, 256.0, straight) == std::array<double, 2>{64, 16});
}

TEST_CASE("intensity_range: a curve is asked for 0 to 1, and held to it") {
  constexpr double inf = std::numeric_limits<double>::infinity(), no_number = std::numeric_limits<double>::quiet_NaN();
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  constexpr std::array<double, 3> three{0, 1, 4};
  CHECK_BOTH(fitted(three, 2.0, [](double t) { return 3 * t; }) == std::array<double, 3>{0, 1.5, 2});
  CHECK_BOTH(fitted(three, 2.0, [](double t) { return t - 0.5; }) == std::array<double, 3>{0, 0, 1});
  CHECK_BOTH(fitted(three, 2.0, [](double t) { return t < 1 ? inf : no_number; }) == std::array<double, 3>{2, 2, 0});
  CHECK_BOTH(fitted(std::array<float, 2>{1, 4}, 2.0f, [](float t) { return 1 - t; }) == std::array<float, 2>{1.5f, 0});
  CHECK_BOTH(fitted(std::array<double, 3>{most, most / 2, least}, 1.0, root) ==
             std::array<double, 3>{1, irg::sqrt(0.5), 0});
  CHECK_BOTH(fitted(std::array<double, 2>{least, 0}, least, straight) == std::array<double, 2>{least, 0});
  CHECK_BOTH(fitted(std::array<double, 2>{0, 0}, 0.0, root) == std::array<double, 2>{0, 0});
  CHECK_BOTH(fitted(std::array<double, 2>{0, 3}, 0.0, root) == std::array<double, 2>{0, 0});
  CHECK_BOTH(fitted(std::array<float, 0>{}, 1.0f, root) == std::array<float, 0>{});
  int outside = 0;
  const auto watched = [&](double t) { return outside += t >= 0 && t <= 1 ? 0 : 1, t; };
  CHECK(fitted(std::array<double, 4>{no_number, -1, 4, 2}, 1.0, watched) == std::array<double, 4>{0, 0, 1, 0.5});
  CHECK(fitted(std::array<double, 3>{inf, 1, -inf}, 1.0, watched) == std::array<double, 3>{0, 0, 0});
  CHECK(outside == 0);
}

TEST_CASE("intensity_range: a curve's results against wider numbers, of any size") {
  test::random r(7);
  const auto any = [&](std::int64_t exponent) {  // from half of 2^exponent to all of it
    return std::ldexp(0.5 + r.unit() / 2, static_cast<int>(exponent));
  };
  const long double u = 0x1p-53L;
  for (int trial = 0; trial < 500; ++trial) {
    std::array<double, 4> all{};
    const std::int64_t size = r.integer(-200, 200);
    for (double& i : all) i = any(size + r.integer(-20, 20));
    const double maximum = any(size + r.integer(-30, 30));
    const auto out = fitted(all, maximum, squared);
    double largest = maximum;
    for (const double i : all) largest = std::fmax(largest, i);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const long double share = static_cast<long double>(all[i]) / static_cast<long double>(largest);
      const long double exact = share * share * static_cast<long double>(maximum);
      CHECK((std::fabs(static_cast<long double>(out[i]) - exact) <= exact * 4.01L * u && out[i] <= maximum));
    }
  }
}
