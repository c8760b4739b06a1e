// SPDX-License-Identifier: MIT
#include <irg/shade/intensity_range.hpp>

#include <array>
#include <limits>

#include "support/check_both.hpp"
#include "support/rational.hpp"

namespace {

using test::rational;

template <class I, std::size_t N, class T>
constexpr std::array<I, N> fitted(std::array<I, N> intensities, T maximum, irg::intensity_range range) {
  irg::fit_intensities(std::span<I>(intensities), maximum, range);
  return intensities;
}

constexpr auto by_clamp = irg::intensity_range::clamp;
constexpr auto by_rescale = irg::intensity_range::rescale;

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
