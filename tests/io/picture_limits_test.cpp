// SPDX-License-Identifier: MIT
#include <irg/io/picture_limits.hpp>

#include <limits>
#include <string_view>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"

namespace {

constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();

static_assert(irg::EncodableRaster<irg::image<irg::rgba8>> &&
              irg::EncodableRaster<irg::image_view<const std::uint8_t>>);
static_assert(!irg::EncodableRaster<irg::image<float>> && !irg::EncodableRaster<int>);

constexpr bool accepted(int width, int height) { return !irg::detail::refuse_picture_size(width, height); }

TEST_CASE("picture sizes: I1, at least one pixel, at most max_picture_pixels, counted without overflow") {
  CHECK_BOTH(accepted(1, 1));
  CHECK_BOTH(accepted(32768, 32768) == (sizeof(std::size_t) > 4));
  CHECK_BOTH(!accepted(32769, 32768));
  CHECK_BOTH(!accepted(0, 5));
  CHECK_BOTH(!accepted(5, 0));
  CHECK_BOTH(!accepted(-1, 5));
  CHECK_BOTH(!accepted(least, least));
  CHECK_BOTH(!accepted(most, most));      // their product needs 62 bits
  CHECK_BOTH(!accepted(65536, 65536));    // 0 in 32 bits
  CHECK_BOTH(!accepted(50000, 85899));    // 4,294,950,000: just below 2^32
}

TEST_CASE("picture sizes: the reason fits the fault") {
  const auto reason = [](int w, int h) { return std::string_view(irg::detail::refuse_picture_size(w, h)->message); };
  CHECK(reason(0, 1) != reason(-1, 1));
  CHECK(reason(0, 1) != reason(most, most));
  CHECK(reason(most, most).find("too large") != std::string_view::npos);
}

}  // namespace
