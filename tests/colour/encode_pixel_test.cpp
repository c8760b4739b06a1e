// SPDX-License-Identifier: MIT
#include <irg/colour/encode_pixel.hpp>

#include "support/check_both.hpp"

namespace {
namespace foreign {

// A pixel type that knows nothing of irg but the name of the function.
struct rgb565 {
  std::uint16_t bits = 0;
};
constexpr irg::rgba8 to_rgba8(const rgb565& p) {
  const int r = p.bits >> 11, g = p.bits >> 5 & 63, b = p.bits & 31;
  return {static_cast<std::uint8_t>(r * 255 / 31), static_cast<std::uint8_t>(g * 255 / 63),
          static_cast<std::uint8_t>(b * 255 / 31), 255};
}

struct unknown {
  std::uint8_t level = 0;
};
struct wrong {
  [[maybe_unused]] friend constexpr int to_rgba8(const wrong&) { return 0; }
};

}  // namespace foreign

// What a template of irg would do: the name is found in the pixel's own namespace.
template <irg::EncodablePixel P>
constexpr irg::rgba8 encode(const P& p) {
  using irg::to_rgba8;
  return to_rgba8(p);
}

}  // namespace

TEST_CASE("which types are pixels of a picture file") {
  CHECK_BOTH((irg::EncodablePixel<irg::rgba8> && irg::EncodablePixel<irg::bgra8> && irg::EncodablePixel<irg::rgb8>));
  CHECK_BOTH((irg::EncodablePixel<std::uint8_t> && irg::EncodablePixel<foreign::rgb565>));
  // Light, depths and other numbers must not become bytes unseen.
  CHECK_BOTH((!irg::EncodablePixel<irg::rgb<float>> && !irg::EncodablePixel<float> && !irg::EncodablePixel<double>));
  CHECK_BOTH((!irg::EncodablePixel<int> && !irg::EncodablePixel<char> && !irg::EncodablePixel<bool>));
  CHECK_BOTH((!irg::EncodablePixel<std::uint16_t> && !irg::EncodablePixel<std::int8_t>));
  CHECK_BOTH((!irg::EncodablePixel<foreign::unknown> && !irg::EncodablePixel<foreign::wrong>));
}

TEST_CASE("channels keep their meaning") {
  CHECK_BOTH(encode(irg::rgba8{1, 2, 3, 4}) == irg::rgba8{1, 2, 3, 4});
  CHECK_BOTH(encode(irg::bgra8{1, 2, 3, 4}) == irg::rgba8{3, 2, 1, 4});
  CHECK_BOTH(encode(irg::rgb8{1, 2, 3}) == irg::rgba8{1, 2, 3, 255});
  CHECK_BOTH(encode(std::uint8_t{0}) == irg::rgba8{0, 0, 0, 255});
  CHECK_BOTH(encode(std::uint8_t{255}) == irg::rgba8{255, 255, 255, 255});
  CHECK_BOTH(encode(foreign::rgb565{0xf800}) == irg::rgba8{255, 0, 0, 255});
}
