// SPDX-License-Identifier: MIT
#include <irg/raster/convert_image.hpp>

#include <cstdint>
#include <vector>

#include "support/check_both.hpp"

namespace {

using irg::convert_image;
using irg::rgba8;

constexpr irg::image<rgba8> slopes(int width, int height) {
  irg::image<rgba8> picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      picture(x, y) = {static_cast<std::uint8_t>(3 * x), static_cast<std::uint8_t>(5 * y),
                       static_cast<std::uint8_t>(x ^ y), static_cast<std::uint8_t>(x + y)};
  return picture;
}

}  // namespace

TEST_CASE("convert_image: pixel by pixel, at compile time, too") {
  CHECK_BOTH([] {
    const auto picture = slopes(5, 3);
    const auto turned = convert_image<irg::bgra8>(picture);
    const auto gray = convert_image<std::uint8_t>(picture);
    bool same = turned.width() == 5 && gray.height() == 3;
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 5; ++x)
        same = same && irg::to_rgba8(turned(x, y)) == picture(x, y) && gray(x, y) == irg::grey_level(picture(x, y));
    return same;
  }());
  CHECK_BOTH(convert_image<irg::rgb8>(irg::image<rgba8>()).width() == 0);
  CHECK_BOTH(convert_image<rgba8>(slopes(4, 4))(3, 2) == slopes(4, 4)(3, 2));
}

TEST_CASE("convert_image: there and back, and into views of any stride") {
  const auto picture = slopes(70, 40);
  CHECK(convert_image<rgba8>(convert_image<irg::bgra8>(picture)) == picture);
  const auto light = convert_image<irg::rgb<float>>(picture);
  CHECK(convert_image<irg::rgb8>(light) == convert_image<irg::rgb8>(picture));

  std::vector<irg::bgr8> memory(70 * 40 + 3, irg::bgr8{});
  // upside down: the first row is the last in memory
  const irg::image_view<irg::bgr8> view(memory.data() + 70 * 39, 70, 40, -70 * 3);
  irg::convert_into(view, picture);
  CHECK(memory[0] == irg::convert_pixel<irg::bgr8>(picture(0, 39)));
  CHECK(memory[70 * 39 + 9] == irg::convert_pixel<irg::bgr8>(picture(9, 0)));
  CHECK(memory[70 * 40] == irg::bgr8{});
}
