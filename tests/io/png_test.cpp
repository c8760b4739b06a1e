// SPDX-License-Identifier: MIT
#include <irg/io/png.hpp>

#include <array>
#include <cstdlib>
#include <cstring>
#include <limits>

#ifdef IRG_HAVE_PNG
#include <png.h>
#endif

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/png_oracle.hpp"
#include "support/random.hpp"

using irg::image;
using irg::image_view;
using irg::png_options;
using irg::rgba8;
using test::bytes;

namespace {

constexpr auto stored = png_options::compression::stored;
constexpr auto fast = png_options::compression::fast;
constexpr auto good = png_options::compression::good;

// Pixels made when they are read; it counts the readings.
template <class F>
struct virtual_raster {
  int columns, rows;
  F pixel;
  int* reads = nullptr;
  constexpr int width() const { return columns; }
  constexpr int height() const { return rows; }
  constexpr auto operator()(int x, int y) const {
    if (reads != nullptr) ++*reads;
    return pixel(x, y);
  }
};
template <class F>
virtual_raster(int, int, F) -> virtual_raster<F>;
template <class F>
virtual_raster(int, int, F, int*) -> virtual_raster<F>;

#ifdef IRG_HAVE_PNG
// libpng's opinion of a file, as 8-bit RGBA.
image<rgba8> libpng_decode(const bytes& file) {
  png_image info;
  std::memset(&info, 0, sizeof info);
  info.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&info, file.data(), file.size()) == 0) return {};
  info.format = PNG_FORMAT_RGBA;
  image<rgba8> out(static_cast<int>(info.width), static_cast<int>(info.height));
  if (png_image_finish_read(&info, nullptr, out.data(), 0, nullptr) == 0) return {};
  return out;
}
#endif

template <class R>
image<rgba8> plain_copy(const R& raster) {
  using irg::to_rgba8;
  image<rgba8> out(irg::width_of(raster), irg::height_of(raster));
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x) out(x, y) = to_rgba8(irg::get_pixel(raster, x, y));
  return out;
}

// Encodes, decodes by both oracles and compares; nullptr when all agree.
template <class R>
const char* round_trip(const R& raster, const png_options& options, int colour_type) {
  const auto file = irg::encode_png(raster, options);
  if (!file) return file.error().message;
  const image<rgba8> wanted = plain_copy(raster);
  const test::decoded_png back = test::decode_png(*file);
  if (back.error != nullptr) return back.error;
  if (back.colour_type != colour_type) return "colour type";
  if (back.srgb_chunks != 1) return "no sRGB chunk";
  if (!(back.picture == wanted)) return "other pixels";
#ifdef IRG_HAVE_PNG
  if (!(libpng_decode(*file) == wanted)) return "other pixels in libpng";
#endif
  return nullptr;
}

#define CHECK_ROUND_TRIP(...)                        \
  do {                                               \
    const char* const why = round_trip(__VA_ARGS__); \
    CHECK_MESSAGE(why == nullptr, (why ? why : "")); \
  } while (false)

enum class kind { noise, gradient, constant };

rgba8 sample(kind k, int x, int y, test::random& random) {
  const auto byte = [](std::uint64_t n) { return static_cast<std::uint8_t>(n); };
  const std::uint64_t n = random.next();
  const auto i = static_cast<std::uint64_t>(x), j = static_cast<std::uint64_t>(y);
  if (k == kind::noise) return {byte(n), byte(n >> 8), byte(n >> 16), byte(n >> 24)};
  if (k == kind::gradient) return {byte(9 * i), byte(7 * j), byte(i * j), byte(255 - 3 * i)};
  return {200, 100, 50, 128};
}

constexpr std::uint64_t fnv(std::span<const std::uint8_t> data) {
  std::uint64_t h = 14695981039346656037u;
  for (const std::uint8_t b : data) h = (h ^ b) * 1099511628211u;
  return h;
}

// A little of everything a renderer makes: background, smooth shading, an edge, transparency.
constexpr rgba8 picture_at(int x, int y) {
  const int dx = x - 20, dy = y - 14, d = dx * dx + dy * dy;
  if (d > 150) return {30, 40, 50, 255};
  return {static_cast<std::uint8_t>(255 - d), static_cast<std::uint8_t>(120 + dx * 3),
          static_cast<std::uint8_t>(90 - dy * 4), static_cast<std::uint8_t>(x < 20 ? 255 : 250)};
}
constexpr image<rgba8> small_picture(int width, int height) {
  image<rgba8> p(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) p(x, y) = picture_at(x + 12, y + 8);
  return p;
}

}  // namespace

TEST_CASE("what encode_png takes") {
  CHECK_BOTH(irg::EncodableRaster<image<rgba8>>);
  CHECK_BOTH(irg::EncodableRaster<image_view<const irg::bgra8>>);
  CHECK_BOTH(irg::EncodableRaster<image<std::uint8_t>>);
  CHECK_BOTH(!irg::EncodableRaster<image<float>>);
  CHECK_BOTH(!irg::EncodableRaster<image<irg::rgb<float>>>);
  CHECK_BOTH(!irg::EncodableRaster<int>);
}

TEST_CASE("one pixel, byte by byte") {
  // Signature, IHDR 1 x 1 gray, sRGB, a zlib stream of one stored block, IEND; the checksums by an independent routine.
  const bytes file = *irg::encode_png(image<std::uint8_t>(1, 1, 7), {stored});
  const bytes expected = {
      0x89, 'P',  'N',  'G',  0x0d, 0x0a, 0x1a, 0x0a,  //
      0,    0,    0,    13,   'I',  'H',  'D',  'R',  0,    0,    0,    1,    0,    0,    0,    1, 8, 0, 0, 0, 0,  //
      0x3a, 0x7e, 0x9b, 0x55,  //
      0,    0,    0,    1,    's',  'R',  'G',  'B',  0,    0xae, 0xce, 0x1c, 0xe9,  //
      0,    0,    0,    13,   'I',  'D',  'A',  'T',  0x78, 0x01, 1,    2,    0,    0xfd, 0xff, 0, 7, 0, 9, 0, 8};
  REQUIRE(file.size() == expected.size() + 4 + 12);
  CHECK(bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(expected.size())) == expected);
  CHECK(test::decode_png(file).error == nullptr);
}

TEST_CASE("I3: every size to 17 x 17 comes back from both decoders") {
  test::random random(2024);
  for (int width = 1; width <= 17; ++width) {
    for (int height = 1; height <= 17; ++height) {
      CAPTURE(width);
      CAPTURE(height);
      for (const kind k : {kind::noise, kind::gradient, kind::constant}) {
        image<rgba8> rgba(width, height);
        image<irg::bgra8> bgra(width, height);
        image<irg::rgb8> rgb(width, height);
        image<std::uint8_t> gray(width, height);
        for (int y = 0; y < height; ++y) {
          for (int x = 0; x < width; ++x) {
            rgba8 p = sample(k, x, y, random);
            if (x == 0 && y == 0) p = {1, 2, 3, 4};  // so that the channels are needed
            rgba(x, y) = p;
            bgra(x, y) = {p.b, p.g, p.r, p.a};
            rgb(x, y) = {p.r, p.g, p.b};
            gray(x, y) = p.g;
          }
        }
        for (const auto effort : {stored, fast, good}) {
          CHECK_ROUND_TRIP(rgba, {effort}, 6);
          CHECK_ROUND_TRIP(rgb, {effort}, 2);
          CHECK_ROUND_TRIP(gray, {effort}, 0);
        }
        CHECK_ROUND_TRIP(bgra, {}, 6);
        CHECK(*irg::encode_png(bgra) == *irg::encode_png(rgba));
        CHECK_ROUND_TRIP(gray, {fast, png_options::channels::rgba}, 6);
      }
    }
  }
}

TEST_CASE("channels that no pixel needs are left out, and one pixel brings them back") {
  image<rgba8> p(5, 4, rgba8{90, 90, 90, 255});
  CHECK_ROUND_TRIP(p, {}, 0);
  p(4, 3).a = 254;
  CHECK_ROUND_TRIP(p, {}, 4);
  p(0, 3).b = 91;
  CHECK_ROUND_TRIP(p, {}, 6);
  p(4, 3).a = 255;
  CHECK_ROUND_TRIP(p, {}, 2);
  for (int c = 0; c < 3; ++c) {
    p = image<rgba8>(5, 4, rgba8{90, 90, 90, 255});
    (c == 0 ? p(2, 1).r : c == 1 ? p(2, 1).g : p(2, 1).b) = 89;
    CHECK_ROUND_TRIP(p, {}, 2);
  }
}

TEST_CASE("each filter is found where it is best, and undone") {
  constexpr int n = 32;
  test::random random(5, test::in_every_round{});
  const auto noise = [&] { return static_cast<std::uint8_t>(random.next()); };
  image<std::uint8_t> p(n, 5 * 2);
  const auto row = [&](int y, auto f) {
    for (int x = 0; x < n; ++x) p(x, y) = static_cast<std::uint8_t>(f(x));
  };
  const auto at = [&](int x, int y) { return x < 0 || y < 0 ? 0 : int{p(x, y)}; };
  row(0, [&](int x) { return x % 7 == 0 ? 1 : 0; });  // none: small already
  row(1, [&](int) { return noise(); });
  row(2, [&](int x) { return 20 + 6 * x; });  // sub: a ramp below noise
  row(3, [&](int) { return noise(); });
  row(4, [&](int x) { return at(x, 3) + 1; });  // up: the row above again
  row(5, [&](int) { return noise(); });
  for (int x = 0; x < n; ++x) p(x, 6) = static_cast<std::uint8_t>((at(x - 1, 6) + at(x, 5)) / 2 + 1);  // average
  row(7, [&](int) { return noise(); });
  for (int x = 0; x < n; ++x) {  // paeth, by its definition
    const int a = at(x - 1, 8), b = at(x, 7), c = at(x - 1, 7), e = a + b - c;
    const int pa = std::abs(e - a), pb = std::abs(e - b), pc = std::abs(e - c);
    p(x, 8) = static_cast<std::uint8_t>((pa <= pb && pa <= pc ? a : pb <= pc ? b : c) + 1);
  }
  const test::decoded_png back = test::decode_png(*irg::encode_png(p));
  CHECK(back.error == nullptr);
  CHECK(back.filters == 31u);
  CHECK_ROUND_TRIP(p, {}, 0);
  CHECK(test::decode_png(*irg::encode_png(p, {stored})).filters == 1u);
}

TEST_CASE("views with gaps, upside down, and pictures that exist only when read") {
  const image<rgba8> whole = [] {
    image<rgba8> p(23, 19);
    test::random random(8);
    for (int y = 0; y < 19; ++y)
      for (int x = 0; x < 23; ++x) p(x, y) = sample(kind::noise, x, y, random);
    return p;
  }();
  constexpr std::ptrdiff_t stride = 23 * 4;
  const image_view<const rgba8> cut(whole.row(3) + 5, 7, 6, stride);
  CHECK_ROUND_TRIP(cut, {}, 6);
  const image_view<const rgba8> flipped(whole.row(18), 23, 19, -stride);
  CHECK_ROUND_TRIP(flipped, {}, 6);
  CHECK(test::decode_png(*irg::encode_png(flipped)).picture(4, 0) == whole(4, 18));
  const bytes odd(3 + 5 * 16, 77);  // rows of 5 RGB pixels, padded by one byte
  CHECK_ROUND_TRIP((image_view<const irg::rgb8>(reinterpret_cast<const irg::rgb8*>(odd.data()), 5, 5, 16)), {}, 0);

  int reads = 0;
  const virtual_raster made{
      300, 200, [](int x, int y) { return irg::rgb8{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 9}; },
      &reads};
  const bytes file = *irg::encode_png(made);
  CHECK(reads == 300 * 200);
  CHECK(test::decode_png(file).picture == plain_copy(made));
}

TEST_CASE("much data is cut into chunks") {
  test::random random(31);
  image<rgba8> p(700, 500);
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 700; ++x) p(x, y) = sample(kind::noise, x, y, random);
  const bytes file = *irg::encode_png(p);
  CHECK(test::decode_png(file).data_chunks == 2);
  CHECK_ROUND_TRIP(p, {}, 6);
}

TEST_CASE("hostile sizes are refused before a pixel is read") {
  int reads = 0;
  constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
  const int sizes[][2] = {{0, 0},         {0, 5},         {5, 0},        {-1, 5},          {5, -1},
                          {-1, -1},       {least, least}, {least, 1},    {most, most},     {most, 2},
                          {2, most},      {most, 1},      {1, most},     {100000, 100000}, {50000, 85899},
                          {65536, 65536}, {32768, 32769}, {46341, 46341}};
  for (const auto& [width, height] : sizes) {
    CAPTURE(width);
    CAPTURE(height);
    const virtual_raster huge{width, height, [](int, int) { return rgba8{}; }, &reads};
    const auto file = irg::encode_png(huge);
    CHECK(!file.has_value());
    CHECK(std::strlen(file.error().message) > 10);
    CHECK(!irg::encode_png(huge, {stored}).has_value());
  }
  CHECK(reads == 0);
  CHECK_BOTH(!irg::encode_png(image<rgba8>(0, 7)).has_value());
  CHECK_BOTH(!irg::encode_png(virtual_raster{most, most, [](int, int) { return rgba8{}; }}).has_value());
  CHECK(irg::max_picture_pixels <= std::uint64_t{1} << 30);
}

TEST_CASE("long thin pictures") {
  for (const auto effort : {stored, fast}) {
    CHECK_ROUND_TRIP((virtual_raster{100000, 1, [](int x, int) { return static_cast<std::uint8_t>(x / 3 * 7 >> 4); }}),
                     {effort}, 0);
    CHECK_ROUND_TRIP((virtual_raster{1, 100000, [](int, int y) { return static_cast<std::uint8_t>(y / 3 * 7 >> 4); }}),
                     {effort}, 0);
  }
}

TEST_CASE("the file's bytes are the same everywhere") {
  // Hashes of whole files, from one compiler once; every other compiler and flag set must find them again.
  const image<rgba8> p = small_picture(40, 28);
  CHECK(fnv(*irg::encode_png(p, {stored})) == 0x2a61e9d69999439cu);
  CHECK(fnv(*irg::encode_png(p, {fast})) == 0x4e1d0ea2582526d0u);
  const virtual_raster larger{500, 300, [](int x, int y) {  // several blocks
                                return irg::rgb8{static_cast<std::uint8_t>((x * x + y * y) >> 6),
                                                 static_cast<std::uint8_t>(x * y >> 9),
                                                 static_cast<std::uint8_t>((x ^ y) * 5)};
                              }};
  CHECK(fnv(*irg::encode_png(larger, {fast})) == 0xceaf08e4fcef086bu);
  CHECK(fnv(*irg::encode_png(larger, {good})) == 0x2fe22dc37aba3733u);
  CHECK_ROUND_TRIP(larger, {good}, 2);
  CHECK(fnv(*irg::encode_png(p, {good})) == 0x1abd51553e20faa1u);
}

namespace {
constexpr std::size_t constant_size = irg::encode_png(small_picture(16, 12))->size();
constexpr std::array<std::uint8_t, constant_size> constant_file = [] {
  std::array<std::uint8_t, constant_size> a{};
  const auto file = irg::encode_png(small_picture(16, 12));
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = (*file)[i];
  return a;
}();
}  // namespace

TEST_CASE("a file made by the compiler is the file made at run time") {
  CHECK(bytes(constant_file.begin(), constant_file.end()) == *irg::encode_png(small_picture(16, 12)));
  CHECK(test::decode_png(constant_file).picture == small_picture(16, 12));
  CHECK(constant_size < 16 * 12 * 4);
  static_assert(irg::encode_png(image<std::uint8_t>(1, 1, 7), {good})->size() > 57);
}

TEST_CASE("smaller than the pixels, and good is not larger than fast") {
  const virtual_raster shaded{256, 256, [](int x, int y) {
                                const int d = (x - 128) * (x - 128) + (y - 128) * (y - 128);
                                const auto level = static_cast<std::uint8_t>(d < 15000 ? 255 - d / 60 : 20);
                                return irg::rgb8{level, static_cast<std::uint8_t>(level / 2), 60};
                              }};
  const std::size_t quick = irg::encode_png(shaded)->size(), patient = irg::encode_png(shaded, {good})->size();
  CHECK(quick < 256 * 256 * 3 / 8);
  CHECK(patient <= quick);
}
