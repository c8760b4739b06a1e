// SPDX-License-Identifier: MIT
#include <irg/colour/pixel_layout.hpp>

#include <bit>

#include "support/check_both.hpp"

namespace {

struct padded {  // a gap of one byte before the number
  std::uint8_t a;
  std::uint16_t b;
};
}  // namespace

template <>
struct irg::pixel_layout<padded> : irg::channel_layout<std::uint8_t, 2> {};

namespace {

static_assert(irg::ChannelPixel<irg::rgba8> && irg::ChannelPixel<irg::bgr8> && irg::ChannelPixel<float>);
static_assert(irg::ChannelPixel<irg::rgb<float>> && irg::pixel_layout<irg::rgb<double>>::count == 3);
static_assert(!irg::ChannelPixel<bool> && !irg::ChannelPixel<padded> && !irg::ChannelPixel<void*>);

// Which channel of P stands at byte `place`, found out by setting one channel at a time.
template <class P>
constexpr char channel_at(int place) {
  struct bytes {
    std::uint8_t at[sizeof(P)];
  };
  P red{}, green{}, blue{};
  red.r = green.g = blue.b = 7;
  return std::bit_cast<bytes>(red).at[place] == 7     ? 'r'
         : std::bit_cast<bytes>(green).at[place] == 7 ? 'g'
         : std::bit_cast<bytes>(blue).at[place] == 7  ? 'b'
                                                      : 'a';
}

template <class P>
constexpr bool layout_is_true() {
  using layout = irg::pixel_layout<P>;
  return channel_at<P>(layout::red) == 'r' && channel_at<P>(layout::green) == 'g' &&
         channel_at<P>(layout::blue) == 'b' && (layout::alpha < 0 || channel_at<P>(layout::alpha) == 'a') &&
         layout::count == static_cast<int>(sizeof(P));
}

TEST_CASE("pixel_layout: says where the channels really are") {
  CHECK_BOTH(layout_is_true<irg::rgba8>());
  CHECK_BOTH(layout_is_true<irg::bgra8>());
  CHECK_BOTH(layout_is_true<irg::rgb8>());
  CHECK_BOTH(layout_is_true<irg::bgr8>());
}

}  // namespace
