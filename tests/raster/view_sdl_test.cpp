// SPDX-License-Identifier: MIT
#include <irg/raster/view_sdl.hpp>

#include <cstring>

#include <irg/raster/fill_span.hpp>
#ifdef IRG_HAVE_SDL2
#include <SDL2/SDL_surface.h>
#endif

#include "support/check_both.hpp"

namespace {

// SDL 2's structures as far as the view looks at them, so that every refusal can be provoked without SDL.
struct pixel_format {
  std::uint8_t BitsPerPixel = 32, BytesPerPixel = 4;
  std::uint32_t Rmask = 0, Gmask = 0, Bmask = 0, Amask = 0;
  const int* palette = nullptr;
};
struct surface {
  std::uint32_t flags = 0;
  pixel_format* format = nullptr;
  int w = 4, h = 3, pitch = 16;
  void* pixels = nullptr;
  int locked = 0;
};

static_assert(irg::SdlSurface<surface> && !irg::SdlSurface<pixel_format> && !irg::SdlSurface<int>);
static_assert(irg::SdlPixel<irg::rgba8> && irg::SdlPixel<irg::bgra8> && irg::SdlPixel<irg::rgb8>);
static_assert(irg::SdlPixel<std::uint8_t> && irg::SdlPixel<std::uint16_t> && irg::SdlPixel<std::uint32_t>);
static_assert(!irg::SdlPixel<float> && !irg::SdlPixel<irg::rgb<float>> && !irg::SdlPixel<std::uint64_t> &&
              !irg::SdlPixel<pixel_format>);

alignas(16) unsigned char memory[256];

// The format of P on a machine of the given byte order.
template <class P>
constexpr pixel_format format_of(std::endian order) {
  using layout = irg::pixel_layout<P>;
  const auto mask = [&](int place) { return irg::detail::sdl_mask(place, layout::count, order); };
  return {8 * sizeof(P), sizeof(P), mask(layout::red), mask(layout::green), mask(layout::blue), mask(layout::alpha)};
}

template <class P>
bool refuses_with_reason(pixel_format f, surface s = {}) {
  s.format = &f;
  if (s.pixels == nullptr) s.pixels = memory;
  const auto v = irg::view_sdl<P>(&s);
  return !v && std::strlen(v.error().reason) > 10;
}
template <class P>
bool accepts(pixel_format f, surface s = {}) {
  s.format = &f;
  if (s.pixels == nullptr) s.pixels = memory;
  return irg::view_sdl<P>(&s).has_value();
}

constexpr auto native = std::endian::native;
constexpr auto little = std::endian::little, big = std::endian::big;

}  // namespace

TEST_CASE("view_sdl: masks name bytes in the machine's order") {
  // SDL_PIXELFORMAT_RGBA32 is ABGR8888 on little-endian machines, RGBA8888 on big-endian ones.
  CHECK_BOTH(format_of<irg::rgba8>(little).Rmask == 0x000000ffu);
  CHECK_BOTH(format_of<irg::rgba8>(little).Amask == 0xff000000u);
  CHECK_BOTH(format_of<irg::rgba8>(big).Rmask == 0xff000000u);
  CHECK_BOTH(format_of<irg::rgba8>(big).Amask == 0x000000ffu);
  CHECK_BOTH(format_of<irg::bgra8>(little).Rmask == 0x00ff0000u);
  CHECK_BOTH(format_of<irg::bgra8>(big).Bmask == 0xff000000u);
  CHECK_BOTH(format_of<irg::rgb8>(little).Rmask == 0x0000ffu);
  CHECK_BOTH(format_of<irg::rgb8>(big).Rmask == 0xff0000u);
  CHECK_BOTH(format_of<irg::rgb8>(big).Amask == 0u);
}

TEST_CASE("view_sdl: the same check on machines of both byte orders") {
  using irg::detail::sdl_format_mismatch;
  for (const auto order : {little, big}) {
    CHECK(sdl_format_mismatch<irg::rgba8>(format_of<irg::rgba8>(order), order) == nullptr);
    CHECK(sdl_format_mismatch<irg::bgra8>(format_of<irg::bgra8>(order), order) == nullptr);
    CHECK(sdl_format_mismatch<irg::rgb8>(format_of<irg::rgb8>(order), order) == nullptr);
    CHECK(sdl_format_mismatch<irg::rgba8>(format_of<irg::bgra8>(order), order) != nullptr);
    const auto other = order == little ? big : little;
    CHECK(sdl_format_mismatch<irg::rgba8>(format_of<irg::rgba8>(order), other) != nullptr);
    CHECK(sdl_format_mismatch<irg::rgb8>(format_of<irg::rgb8>(order), other) != nullptr);
  }
}

TEST_CASE("view_sdl: channel orders") {
  CHECK(accepts<irg::rgba8>(format_of<irg::rgba8>(native)));
  CHECK(accepts<irg::bgra8>(format_of<irg::bgra8>(native)));
  CHECK(accepts<irg::rgb8>(format_of<irg::rgb8>(native)));
  CHECK(refuses_with_reason<irg::rgba8>(format_of<irg::bgra8>(native)));
  CHECK(refuses_with_reason<irg::bgra8>(format_of<irg::rgba8>(native)));
  CHECK(refuses_with_reason<irg::rgb8>(format_of<irg::rgba8>(native)));
  CHECK(refuses_with_reason<irg::rgba8>(format_of<irg::rgb8>(native)));

  pixel_format without_opacity = format_of<irg::bgra8>(native);  // as a window's surface has it
  without_opacity.Amask = 0;
  CHECK(accepts<irg::bgra8>(without_opacity));
  pixel_format strange_opacity = format_of<irg::bgra8>(native);
  strange_opacity.Amask = 0x80000000u;
  CHECK(refuses_with_reason<irg::bgra8>(strange_opacity));
  pixel_format deep = format_of<irg::rgba8>(native);  // ten bits per channel in four bytes
  deep.Rmask = 0x3ff, deep.Gmask = 0xffc00, deep.Bmask = 0x3ff00000, deep.Amask = 0xc0000000;
  CHECK(refuses_with_reason<irg::rgba8>(deep));
}

TEST_CASE("view_sdl: raw numbers and palettes") {
  const int colours = 0;
  pixel_format f;
  f.BitsPerPixel = 8, f.BytesPerPixel = 1, f.palette = &colours;
  CHECK(accepts<std::uint8_t>(f));  // indices into the palette
  CHECK(refuses_with_reason<std::uint16_t>(f));
  CHECK(refuses_with_reason<irg::rgba8>(f));
  f.BitsPerPixel = 4;
  CHECK(refuses_with_reason<std::uint8_t>(f));  // two pixels in a byte
  f.BitsPerPixel = 1;
  CHECK(refuses_with_reason<std::uint8_t>(f));
  pixel_format rgb565;
  rgb565.BitsPerPixel = 16, rgb565.BytesPerPixel = 2;
  CHECK(accepts<std::uint16_t>(rgb565));
  CHECK(refuses_with_reason<std::uint32_t>(rgb565));
  CHECK(accepts<std::uint32_t>(format_of<irg::bgra8>(native)));
  pixel_format painted = format_of<irg::rgba8>(native);
  painted.palette = &colours;
  CHECK(refuses_with_reason<irg::rgba8>(painted));
}

TEST_CASE("view_sdl: surfaces whose pixels cannot be touched") {
  const pixel_format f = format_of<irg::rgba8>(native);
  surface encoded;
  encoded.flags = 2;  // SDL_RLEACCEL
  CHECK(refuses_with_reason<irg::rgba8>(f, encoded));
  encoded.locked = 1;
  CHECK(accepts<irg::rgba8>(f, encoded));

  pixel_format g = f;
  surface unlocked;
  unlocked.format = &g;
  CHECK(!irg::view_sdl<irg::rgba8>(&unlocked));  // pixels are null until it is locked
  unlocked.format = nullptr;
  CHECK(!irg::view_sdl<irg::rgba8>(&unlocked));
  surface* nothing = nullptr;
  CHECK(!irg::view_sdl<irg::rgba8>(nothing));

  surface misaligned;
  misaligned.pitch = 18;
  pixel_format raw = f;
  CHECK(refuses_with_reason<std::uint32_t>(raw, misaligned));
  CHECK(accepts<irg::rgba8>(raw, misaligned));  // bytes need no alignment
  surface overlapping;
  overlapping.pitch = 12;
  CHECK(refuses_with_reason<irg::rgba8>(f, overlapping));
}

TEST_CASE("view_sdl: rows where they are, const for reading only") {
  pixel_format f = format_of<irg::rgba8>(native);
  surface s;
  s.format = &f, s.pixels = memory, s.pitch = 20;
  const auto v = irg::view_sdl<irg::rgba8>(&s);
  CHECK(v.has_value());
  if (!v) return;
  CHECK(v->width() == 4);
  CHECK(v->height() == 3);
  CHECK(reinterpret_cast<unsigned char*>(&(*v)(1, 2)) == memory + 44);
  s.pitch = -20, s.pixels = memory + 40;
  CHECK(reinterpret_cast<unsigned char*>(&(*irg::view_sdl<irg::rgba8>(&s))(0, 2)) == memory);
  const surface& c = s;
  static_assert(std::same_as<decltype(irg::view_sdl<irg::rgba8>(&c)), irg::foreign_view<const irg::rgba8>>);
  static_assert(std::same_as<decltype(irg::view_sdl<irg::rgba8>(&s)), irg::foreign_view<irg::rgba8>>);
}

TEST_CASE("view_sdl: SDL_Surface") {
#ifdef IRG_HAVE_SDL2
  static_assert(irg::SdlSurface<SDL_Surface>);
  const auto made = [](Uint32 f, int bits) { return SDL_CreateRGBSurfaceWithFormat(0, 5, 4, bits, f); };

  SDL_Surface* s = made(SDL_PIXELFORMAT_RGBA32, 32);
  auto v = irg::view_sdl<irg::rgba8>(s);
  CHECK(v.has_value());
  if (!v) return;
  irg::fill_span(*v, {2, 1, 3}, irg::rgba8{10, 20, 30, 40});
  const auto at = [&](int x, int y) {  // what SDL itself makes of the pixel
    Uint32 raw;
    std::memcpy(&raw, static_cast<const Uint8*>(s->pixels) + y * s->pitch + x * 4, 4);
    irg::rgba8 c;
    SDL_GetRGBA(raw, s->format, &c.r, &c.g, &c.b, &c.a);
    return c;
  };
  CHECK(at(1, 2) == irg::rgba8{10, 20, 30, 40});
  CHECK(at(2, 2) == irg::rgba8{10, 20, 30, 40});
  CHECK(at(3, 2) == irg::rgba8{0, 0, 0, 0});
  CHECK(!irg::view_sdl<irg::bgra8>(s));
  CHECK(irg::view_sdl<std::uint32_t>(s).has_value());
  SDL_FreeSurface(s);

  // Every format with 8 bits per channel fits exactly the pixel type that has its order.
  struct expectation {
    Uint32 format;
    int bits;
    bool rgba8, bgra8, rgb8;
  };
  for (const expectation& e : {expectation{SDL_PIXELFORMAT_RGBA32, 32, true, false, false},
                               expectation{SDL_PIXELFORMAT_BGRA32, 32, false, true, false},
                               expectation{SDL_PIXELFORMAT_ARGB32, 32, false, false, false},
                               expectation{SDL_PIXELFORMAT_RGB24, 24, false, false, true},
                               expectation{SDL_PIXELFORMAT_BGR24, 24, false, false, false},
                               expectation{SDL_PIXELFORMAT_RGB565, 16, false, false, false},
                               expectation{SDL_PIXELFORMAT_ARGB2101010, 32, false, false, false},
                               expectation{SDL_PIXELFORMAT_INDEX8, 8, false, false, false}}) {
    SDL_Surface* t = made(e.format, e.bits);
    CHECK(t != nullptr);
    if (t == nullptr) return;
    CHECK(irg::view_sdl<irg::rgba8>(t).has_value() == e.rgba8);
    CHECK(irg::view_sdl<irg::bgra8>(t).has_value() == e.bgra8);
    CHECK(irg::view_sdl<irg::rgb8>(t).has_value() == e.rgb8);
    CHECK(irg::view_sdl<std::uint8_t>(t).has_value() == (e.bits == 8));
    SDL_FreeSurface(t);
  }

  SDL_Surface* encoded = made(SDL_PIXELFORMAT_RGBA32, 32);
  SDL_SetSurfaceRLE(encoded, 1);
  SDL_Surface* screen = made(SDL_PIXELFORMAT_RGBA32, 32);
  SDL_BlitSurface(encoded, nullptr, screen, nullptr);  // the encoding happens at the first blit
  CHECK(SDL_MUSTLOCK(encoded));
  CHECK(!irg::view_sdl<irg::rgba8>(encoded));
  SDL_LockSurface(encoded);
  CHECK(irg::view_sdl<irg::rgba8>(encoded).has_value());
  SDL_UnlockSurface(encoded);
  SDL_FreeSurface(encoded);
  SDL_FreeSurface(screen);
#else
  MESSAGE("skipped: SDL 2 was not found");
#endif
}
