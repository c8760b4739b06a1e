// SPDX-License-Identifier: MIT
// view_sdl<P>(surface): an SDL_Surface seen as an image_view<P> when it holds such pixels, refused with a reason when
// not. SDL is not included: whatever has SDL 2's members will do.
#pragma once

#include <bit>
#include <concepts>

#include <irg/colour/pixel_layout.hpp>
#include <irg/raster/foreign_view.hpp>

namespace irg {

/// An image whose format is known at run time only. Models: SDL_Surface of SDL 2.
template <class S>
concept SdlSurface = requires(const S s) {
  { s.w } -> std::convertible_to<int>;
  { s.h } -> std::convertible_to<int>;
  { s.pitch } -> std::convertible_to<int>;
  { s.pixels } -> std::convertible_to<const void*>;
  { s.flags } -> std::convertible_to<std::uint32_t>;
  { s.locked } -> std::convertible_to<int>;
  { s.format->BitsPerPixel } -> std::convertible_to<int>;
  { s.format->BytesPerPixel } -> std::convertible_to<int>;
  { s.format->Rmask } -> std::convertible_to<std::uint32_t>;
  s.format->Gmask, s.format->Bmask, s.format->Amask, s.format->palette;
};

/// A pixel type that SDL has too: 8-bit channels, or an integer of 8, 16 or 32 bits for the raw value of SDL_MapRGBA.
template <class P>
concept SdlPixel = ChannelPixel<P> && (std::same_as<typename pixel_layout<P>::channel, std::uint8_t> ||
                                       std::same_as<P, std::uint16_t> || std::same_as<P, std::uint32_t>);

namespace detail::inline IRG_ABI {

// SDL's mask for the byte at `place` of a pixel of `count` bytes: pixels are numbers in the machine's byte order.
constexpr std::uint32_t sdl_mask(int place, int count, std::endian order) noexcept {
  if (place < 0) return 0;
  return std::uint32_t{0xff} << (8 * (order == std::endian::little ? place : count - 1 - place));
}

// The reason why a surface of this format does not hold P's, or nullptr. A surface without opacity may have the byte.
template <class P, class Format>
const char* sdl_format_mismatch(const Format& format, std::endian order) noexcept {
  using layout = pixel_layout<P>;
  if (format.BytesPerPixel != static_cast<int>(sizeof(P)))
    return "the surface has another number of bytes per pixel than the pixel type";
  if (format.BitsPerPixel < 8) return "the surface packs several pixels into one byte";
  if constexpr (layout::count > 1) {
    const auto mask = [&](int place) { return sdl_mask(place, layout::count, order); };
    if (format.palette != nullptr) return "the surface has a palette";
    if (format.Rmask != mask(layout::red) || format.Gmask != mask(layout::green) || format.Bmask != mask(layout::blue))
      return "the surface has its channels in another order than the pixel type";
    if (format.Amask != mask(layout::alpha) && format.Amask != 0)
      return "the surface has its opacity at another place than the pixel type";
  } else {
    if (format.palette != nullptr && sizeof(P) != 1) return "the surface has a palette";
  }
  return nullptr;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The surface's pixels as an image_view<P>, or of const P when the surface is const; nothing is copied.
/// shape   row 0 at the top; any pitch; P = std::uint8_t gives the indices of a surface with a palette,
///         std::uint16_t and std::uint32_t the raw values of SDL_MapRGBA
/// needs   the surface outlives the view and stays locked where SDL_MUSTLOCK says that it must be
/// gives   a reason instead of a view for no surface, one that must be locked and is not, a palette (but see shape), or
///         channels of another size or order than P's, on machines of either byte order; a surface that ignores
///         opacity fits rgba8 and bgra8 when it keeps the byte
/// cost    constant
template <SdlPixel P, SdlSurface Surface>
auto view_sdl(Surface* surface) noexcept {
  using pixel = std::conditional_t<std::is_const_v<Surface>, const P, P>;
  using memory = std::conditional_t<std::is_const_v<Surface>, const void, void>;
  const auto refused = [](const char* reason) { return foreign_view<pixel>(view_refusal{reason}); };
  constexpr std::uint32_t run_length_encoded = 2;  // SDL_RLEACCEL

  if (surface == nullptr || surface->format == nullptr) return refused("there is no surface");
  if ((surface->flags & run_length_encoded) != 0 && surface->locked == 0)
    return refused("the surface is run-length encoded and must be locked first");
  if (surface->pixels == nullptr) return refused("the surface has no pixels or must be locked first");
  if (const char* reason = detail::sdl_format_mismatch<P>(*surface->format, std::endian::native))
    return refused(reason);
  return detail::foreign_rows<pixel>(static_cast<memory*>(surface->pixels), surface->w, surface->h, surface->pitch);
}

}  // namespace IRG_ABI
}  // namespace irg
