// SPDX-License-Identifier: MIT
// pixel_layout<P>: where the channels of a pixel type lie in memory. It lets images of other libraries be checked
// against P before they are seen as rows of P. Specialise it for pixel types of your own:
//
//   template <> struct irg::pixel_layout<my::pixel> : irg::channel_layout<std::uint8_t, 4, 2, 1, 0, 3> {};   // BGRA
#pragma once

#include <cstdint>
#include <type_traits>

#include <irg/colour/pixel.hpp>

namespace irg {

/// A pixel of Count channels of one type side by side; Red to Alpha are their places, -1 for a channel that is absent.
template <class Channel, int Count, int Red = -1, int Green = -1, int Blue = -1, int Alpha = -1>
struct channel_layout {
  using channel = Channel;
  static constexpr int count = Count, red = Red, green = Green, blue = Blue, alpha = Alpha;
};

/// How the channels of P lie in memory. Members: channel, count, red, green, blue, alpha as in channel_layout.
template <class P>
struct pixel_layout {};

/// A number is one channel without a colour's name: a grey value, an index, a depth.
template <class T>
  requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>)
struct pixel_layout<T> : channel_layout<T, 1> {};

template <>
struct pixel_layout<rgba8> : channel_layout<std::uint8_t, 4, 0, 1, 2, 3> {};
template <>
struct pixel_layout<bgra8> : channel_layout<std::uint8_t, 4, 2, 1, 0, 3> {};
template <>
struct pixel_layout<rgb8> : channel_layout<std::uint8_t, 3, 0, 1, 2> {};
template <>
struct pixel_layout<bgr8> : channel_layout<std::uint8_t, 3, 2, 1, 0> {};
template <class T>
struct pixel_layout<rgb<T>> : channel_layout<T, 3, 0, 1, 2> {};

/// A pixel type whose channels fill it without a gap in a known order. Models: numbers, rgba8, bgra8, rgb8, bgr8,
/// rgb<float>.
template <class P>
concept ChannelPixel = std::is_trivially_copyable_v<P> && requires {
  typename pixel_layout<P>::channel;
  requires(pixel_layout<P>::count >= 1);
  requires sizeof(P) == static_cast<unsigned>(pixel_layout<P>::count) * sizeof(typename pixel_layout<P>::channel);
};

}  // namespace irg
