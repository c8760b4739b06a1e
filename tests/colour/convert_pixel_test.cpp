// SPDX-License-Identifier: MIT
#include <irg/colour/convert_pixel.hpp>

#include <cstdint>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace own_pixels {

/// A type of one's own: opacity first.
struct argb {
  std::uint8_t a = 0, r = 0, g = 0, b = 0;
  constexpr bool operator==(const argb&) const = default;
};
constexpr irg::rgba8 to_rgba8(const argb& p) { return {p.r, p.g, p.b, p.a}; }

}  // namespace own_pixels

template <>
struct irg::pixel_decoding<own_pixels::argb> {
  static constexpr own_pixels::argb from(const irg::rgba8& p) { return {p.a, p.r, p.g, p.b}; }
};

namespace {

using irg::bgr8;
using irg::bgra8;
using irg::convert_pixel;
using irg::rgb8;
using irg::rgba8;
using light = irg::rgb<float>;

static_assert(irg::DecodablePixel<std::uint8_t> && !irg::DecodablePixel<int> && !irg::DecodablePixel<float>);
static_assert(irg::ConvertiblePixel<light> && !irg::ConvertiblePixel<irg::rgb<double>> && !irg::ConvertiblePixel<int>);

}  // namespace

TEST_CASE("convert_pixel: between every two types, at compile time, too") {
  constexpr rgba8 p{10, 20, 30, 40};
  CHECK_BOTH(convert_pixel<rgba8>(p) == p);
  CHECK_BOTH(convert_pixel<bgra8>(p) == bgra8{30, 20, 10, 40});
  CHECK_BOTH(convert_pixel<rgb8>(bgra8{30, 20, 10, 40}) == rgb8{10, 20, 30});
  CHECK_BOTH(convert_pixel<bgr8>(rgb8{10, 20, 30}) == bgr8{30, 20, 10});
  CHECK_BOTH(convert_pixel<rgba8>(bgr8{30, 20, 10}) == rgba8{10, 20, 30, 255});
  CHECK_BOTH(convert_pixel<std::uint8_t>(p) == 18);  // 2.99 + 11.74 + 3.42 = 18.15
  CHECK_BOTH(convert_pixel<rgb8>(std::uint8_t{7}) == rgb8{7, 7, 7});
  CHECK_BOTH(convert_pixel<own_pixels::argb>(bgra8{30, 20, 10, 40}) == own_pixels::argb{40, 10, 20, 30});
  CHECK_BOTH(convert_pixel<bgra8>(own_pixels::argb{40, 10, 20, 30}) == bgra8{30, 20, 10, 40});
  CHECK_BOTH(convert_pixel<rgba8>(light{0, 1, 2}) == rgba8{0, 255, 255, 255});
  CHECK_BOTH(convert_pixel<light>(rgb8{0, 255, 0}) == light{0, 1, 0});
}

TEST_CASE("convert_pixel: gray keeps its level, light its code, and a detour changes nothing") {
  for (int level = 0; level < 256; ++level) {
    const auto g = static_cast<std::uint8_t>(level);
    CHECK(irg::grey_level({g, g, g, 0}) == g);
    CHECK(convert_pixel<std::uint8_t>(convert_pixel<light>(g)) == g);
  }
  test::random r(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const std::uint64_t bits = r.next();
    const rgba8 p{static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                  static_cast<std::uint8_t>(bits >> 16), static_cast<std::uint8_t>(bits >> 24)};
    CHECK(convert_pixel<rgba8>(convert_pixel<own_pixels::argb>(convert_pixel<bgra8>(p))) == p);
    CHECK(convert_pixel<rgb8>(convert_pixel<light>(p)) == convert_pixel<rgb8>(p));
    const double gray = 0.299 * p.r + 0.587 * p.g + 0.114 * p.b;
    const int level = irg::grey_level(p);
    CHECK(level - gray <= 0.5 + 1e-9);
    CHECK(gray - level <= 0.5 + 1e-9);
  }
}
