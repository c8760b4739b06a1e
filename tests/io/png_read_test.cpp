// SPDX-License-Identifier: MIT
#include <irg/io/png_read.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <irg/io/png.hpp>

#include "support/check_both.hpp"
#include "support/png_oracle.hpp"
#include "support/random.hpp"

#ifdef IRG_HAVE_PNG
#include <png.h>
#include <zlib.h>
#endif

namespace {

using irg::read_png;
using irg::rgba8;
using file = std::vector<std::uint8_t>;

void put_big_endian(file& f, std::uint32_t n) {
  for (int shift = 24; shift >= 0; shift -= 8) f.push_back(static_cast<std::uint8_t>(n >> shift));
}
void put_chunk(file& f, std::string_view name, const file& data) {
  put_big_endian(f, static_cast<std::uint32_t>(data.size()));
  file checked(name.begin(), name.end());
  checked.insert(checked.end(), data.begin(), data.end());
  f.insert(f.end(), checked.begin(), checked.end());
  put_big_endian(f, test::slow_crc(checked));
}

struct head {
  std::uint32_t width = 1, height = 1;
  int depth = 8, type = 0, interlaced = 0;
};

file begin(const head& h) {
  file f = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, data;
  put_big_endian(data, h.width);
  put_big_endian(data, h.height);
  for (const int byte : {h.depth, h.type, 0, 0, h.interlaced}) data.push_back(static_cast<std::uint8_t>(byte));
  put_chunk(f, "IHDR", data);
  return f;
}
/// A zlib stream of one stored block.
file stored(const file& data) {
  file z = {0x78, 0x01, 1};
  const auto n = static_cast<unsigned>(data.size());
  for (const unsigned byte : {n & 255, n >> 8, ~n & 255, ~n >> 8 & 255}) z.push_back(static_cast<std::uint8_t>(byte));
  z.insert(z.end(), data.begin(), data.end());
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : data) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  put_big_endian(z, b << 16 | a);
  return z;
}
file finish(file f, const file& stream) {
  put_chunk(f, "IDAT", stream);
  put_chunk(f, "IEND", {});
  return f;
}
file gray_file(const file& rows, const head& h = {}) { return finish(begin(h), stored(rows)); }

std::string outcome(const file& f, irg::png_read_options options = {}) {
  const auto r = read_png(f, options);
  if (r) return "";
  REQUIRE(r.error().line == 0);
  REQUIRE(r.error().column >= 1);
  REQUIRE(r.error().column <= f.size() + 1);
  REQUIRE(std::strlen(r.error().message) > 10);
  return std::to_string(r.error().column) + " " + r.error().message;
}

constexpr std::uint8_t two_by_one[] = {0x89, 'P', 'N',  'G',  '\r', '\n', 0x1a, '\n', 0,    0, 0,    13,  'I',
                                       'H',  'D', 'R',  0,    0,    0,    2,    0,    0,    0, 1,    1,   0,
                                       0,    0,   0,    0x79, 0x8b, 0x67, 0x2c, 0,    0,    0, 13,   'I', 'D',
                                       'A',  'T', 0x78, 0x01, 1,    2,    0,    0xfd, 0xff, 0, 0x40, 0};

}  // namespace

TEST_CASE("png_read: what irg writes, at compile time, too") {
  CHECK_BOTH([] {
    irg::image<rgba8> picture(3, 2, rgba8{1, 2, 3, 4});
    picture(1, 1) = {250, 7, 7, 255};
    picture(2, 0) = {0, 0, 0, 0};
    const auto file = irg::encode_png(picture);
    const auto read = read_png(*file);
    if (!read) return false;
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x)
        if (!((*read)(x, y) == picture(x, y))) return false;
    return read->width() == 3 && read->height() == 2;
  }());
  CHECK_BOTH(read_png(two_by_one).error().column == 30);  // the checksum of the header is wrong, on purpose
  CHECK_BOTH(!read_png(std::string_view("\x89PNG")));
  const auto bytes = irg::encode_png(irg::image<std::uint8_t>(2, 2, 9));
  CHECK(read_png(std::string(bytes->begin(), bytes->end()))->operator()(1, 1) == rgba8{9, 9, 9, 255});
}

TEST_CASE("png_read: every size, effort and kind of picture that irg writes comes back") {
  test::random r(5);
  for (int trial = 0; trial < 60; ++trial) {
    const int width = static_cast<int>(r.integer(1, 70)), height = static_cast<int>(r.integer(1, 40));
    irg::image<rgba8> picture(width, height);
    const std::int64_t noise = r.integer(0, 8), opacity = r.integer(0, 1), gray = r.integer(0, 1);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const auto value = [&] { return static_cast<std::uint8_t>(x * y / 7 + r.integer(0, noise * noise * 3)); };
        rgba8 p;
        p.r = value();
        p.g = gray != 0 ? p.r : value();
        p.b = gray != 0 ? p.r : value();
        p.a = opacity != 0 ? value() : std::uint8_t{255};
        picture(x, y) = p;
      }
    for (const auto effort : {irg::png_options::compression::stored, irg::png_options::compression::fast,
                              irg::png_options::compression::good}) {
      const auto read = read_png(*irg::encode_png(picture, {effort, irg::png_options::channels::needed}));
      REQUIRE(read);
      CHECK(*read == picture);
    }
  }
}

TEST_CASE("png_read: depths, palettes and transparent colours by hand") {
  // one bit: 1 0 1
  const auto bits = read_png(gray_file({0, 0xa0}, {3, 1, 1, 0}));
  REQUIRE(bits);
  CHECK((*bits)(0, 0) == rgba8{255, 255, 255, 255});
  CHECK((*bits)(1, 0) == rgba8{0, 0, 0, 255});
  // two bits 0 1 2 3, four bits 0 15 7
  const auto pairs = read_png(gray_file({0, 0x1b}, {4, 1, 2, 0}));
  CHECK((*pairs)(1, 0).g == 85);
  CHECK((*pairs)(2, 0).g == 170);
  CHECK((*read_png(gray_file({0, 0x0f, 0x70}, {3, 1, 4, 0})))(2, 0).b == 119);
  // sixteen bits, rounded: 128 is below the middle between two bytes, 129 above
  const auto wide = read_png(gray_file({0, 0, 128, 0, 129, 255, 255}, {3, 1, 16, 0}));
  CHECK((*wide)(0, 0).r == 0);
  CHECK((*wide)(1, 0).r == 1);
  CHECK((*wide)(2, 0).r == 255);

  file f = begin({4, 1, 2, 3});
  put_chunk(f, "gAMA", {0, 0, 1, 2});
  put_chunk(f, "PLTE", {1, 2, 3, 4, 5, 6, 7, 8, 9});
  put_chunk(f, "tRNS", {10, 20});
  const auto palette = read_png(finish(f, stored({0, 0x18})));
  REQUIRE(palette);
  CHECK((*palette)(0, 0) == rgba8{1, 2, 3, 10});
  CHECK((*palette)(1, 0) == rgba8{4, 5, 6, 20});
  CHECK((*palette)(2, 0) == rgba8{7, 8, 9, 255});
  CHECK(outcome(finish(f, stored({0, 0x1b}))).find("pixel has a number beyond the palette") != std::string::npos);

  file keyed = begin({2, 1, 8, 2});
  put_chunk(keyed, "tRNS", {0, 1, 0, 2, 0, 3});
  const auto colours = read_png(finish(keyed, stored({0, 1, 2, 3, 1, 2, 4})));
  CHECK((*colours)(0, 0) == rgba8{1, 2, 3, 0});
  CHECK((*colours)(1, 0) == rgba8{1, 2, 4, 255});
  file wide_key = begin({2, 1, 16, 0});  // compared before it is rounded
  put_chunk(wide_key, "tRNS", {1, 2});
  const auto grays = read_png(finish(wide_key, stored({0, 1, 2, 1, 3})));
  CHECK((*grays)(0, 0).a == 0);
  CHECK((*grays)(1, 0).a == 255);
}

TEST_CASE("png_read: what is wrong is said where it stands") {
  const head gray{2, 1, 8, 0, 0};
  const file good = gray_file({0, 5, 6}, gray);
  CHECK(outcome(good) == "");
  CHECK(outcome({}) == "1 file is no PNG: it begins otherwise");
  for (std::size_t length = 0; length < good.size(); ++length)
    CHECK(outcome({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)}) != "");
  file longer = good;
  longer.push_back(1);
  CHECK(outcome(longer) == "");
  CHECK(outcome(gray_file({0, 5, 6}, {0, 1, 8, 0})) == "17 picture needs at least one pixel");
  CHECK(outcome(gray_file({0, 5, 6}, {0x80000000u, 1, 8, 0})) == "17 picture is too large");
  CHECK(outcome(gray_file({0, 5, 6}, {65536, 65536, 8, 0})).find("irg::max_picture_pixels") != std::string::npos);
  CHECK(outcome(gray_file({0, 5, 6}, {30000, 30000, 8, 0})) ==
        "42 file is too short for the picture that its head promises");
  CHECK(outcome(good, {1}) == "17 picture has more pixels than the options allow");
  CHECK(outcome(good, {2}) == "");
  for (const head h : {head{1, 1, 3, 0}, head{1, 1, 16, 3}, head{1, 1, 4, 2}, head{1, 1, 8, 1}, head{1, 1, 8, 5},
                       head{1, 1, 8, 7}, head{1, 1, 4, 6}, head{1, 1, 0, 0}})
    CHECK(outcome(gray_file({0, 5}, h)) == "25 colour type and depth do not fit each other");
  CHECK(outcome(gray_file({0, 5, 6}, {2, 1, 8, 0, 2})) ==
        "27 compression, filter or interlacing is none of the format's");
  CHECK(outcome(gray_file({5, 5, 6}, gray)) == "42 row has a filter that there is not");
  CHECK(outcome(gray_file({0, 5}, gray)) == "42 compressed data are shorter than the picture");
  CHECK(outcome(gray_file({0, 5, 6, 7}, gray)) == "42 compressed data are longer than the picture");
  CHECK(outcome(finish(begin({1, 1, 8, 3}), stored({0, 0}))) == "42 there is no palette");
  file f = begin(gray);
  put_chunk(f, "PLTE", {1, 2, 3});
  CHECK(outcome(f) == "42 palette stands where none may stand");
  f = begin({1, 1, 8, 3});
  put_chunk(f, "PLTE", {1, 2});
  CHECK(outcome(f) == "42 palette is not of 1 to 256 colours");
  f = begin({1, 1, 8, 3});
  put_chunk(f, "tRNS", {1});
  CHECK(outcome(f) == "42 transparency stands before the palette");
  f = begin({1, 1, 8, 6});
  put_chunk(f, "tRNS", {1});
  CHECK(outcome(f) == "42 transparency stands where none may stand");
  f = begin(gray);
  put_chunk(f, "tRNS", {1});
  CHECK(outcome(f) == "42 transparency is not one colour");
  f = begin(gray);
  put_chunk(f, "ABcD", {});
  CHECK(outcome(f) == "38 chunk is needed for the picture, but not known");
  f = begin(gray);
  put_chunk(f, "\xfeHDR", {});  // a name is of letters, also of a chunk that may be skipped
  CHECK(outcome(f) == "38 chunk has a name that is not of letters");
  f = begin(gray);
  put_chunk(f, "tE[t", {});
  CHECK(outcome(f) == "40 chunk has a name that is not of letters");
  f = begin(gray);
  put_chunk(f, "IDAT", {});
  put_chunk(f, "tEXt", {});
  CHECK(outcome(finish(f, stored({0, 5, 6}))) == "66 data of the picture are interrupted");
  f = begin(gray);
  put_chunk(f, "IEND", {});
  CHECK(outcome(f) == "46 file has no pixels");
  file twice = stored({0, 5, 6});
  twice.push_back(0);
  CHECK(outcome(finish(begin(gray), twice)) == "42 compressed data go on after their end");
  twice = stored({0, 5, 6});
  twice.back() ^= 1;
  CHECK(outcome(finish(begin(gray), twice)) == "42 checksum of the compressed data is wrong");
}

TEST_CASE("png_read: damage is noticed: every byte has a checksum") {
  irg::image<rgba8> picture(9, 7, rgba8{1, 2, 3, 4});
  for (int i = 0; i < 7; ++i) picture(i, i) = {9, static_cast<std::uint8_t>(40 * i), 9, 200};
  const file good = *irg::encode_png(picture);
  test::random r(3);
  for (int trial = 0; trial < 4000; ++trial) {
    file f = good;
    const auto at = static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(good.size()) - 1));
    f[at] = static_cast<std::uint8_t>(f[at] ^ r.integer(1, 255));
    if (outcome(f) == "") CHECK(*read_png(f) == picture);  // a letter of a chunk that may be skipped, at most
  }
}

TEST_CASE("inflate: streams of disorder end with a reason") {
  test::random r(8);
  for (int trial = 0; trial < 20000; ++trial) {
    file z = {0x78, 0x01};
    const std::int64_t count = r.integer(0, 60);
    z.push_back(static_cast<std::uint8_t>(r.integer(0, 31) * 8 + r.integer(0, 3) * 2 + 1));
    for (std::int64_t i = 0; i < count; ++i) z.push_back(static_cast<std::uint8_t>(r.next()));
    irg::detail::inflater<file> in(z, 5000);
    if (!in.zlib()) CHECK(std::strlen(in.message) > 10);
    CHECK(in.out.size() <= 5000);
#ifdef IRG_HAVE_PNG
    // zlib says the same of the same stream, but for bytes behind its end.
    file expected(5000, 0);
    uLongf length = 5000;
    const bool good = uncompress(expected.data(), &length, z.data(), static_cast<uLong>(z.size())) == Z_OK;
    const bool longer =
        in.message != nullptr && std::string_view(in.message).find("after their end") != std::string::npos;
    CHECK(good == (in.message == nullptr || longer));
#endif
  }
}

TEST_CASE("inflate: blocks of fixed codes, and of others between them") {
  test::random r(9);
  for (int trial = 0; trial < 200; ++trial) {
    file z = {0x78, 0x01}, data;
    std::uint64_t pending = 0;
    int count = 0;
    const auto put = [&](std::uint64_t bits, int n) {
      for (pending |= bits << count, count += n; count >= 8; count -= 8, pending >>= 8)
        z.push_back(static_cast<std::uint8_t>(pending));
    };
    for (std::int64_t left = r.integer(1, 40); left >= 0; --left) {
      put(left == 0 ? 1 : 0, 1);
      if (r.integer(0, 2) != 0) {  // fixed: 0x30 + a number below 144, its highest bit first; then the end, 7 zeros
        put(1, 2);
        for (std::int64_t i = r.integer(0, 2); i > 0; --i) {
          const auto byte = static_cast<std::uint8_t>(r.integer(0, 143));
          for (int bit = 7; bit >= 0; --bit) put((byte + 0x30u) >> bit & 1, 1);
          data.push_back(byte);
        }
        put(0, 7);
        continue;
      }
      put(2, 2);  // 257 symbols and one distance: 138 + 118 words of no bits, then two of one; the end is a 0
      put(0, 5), put(0, 5), put(14, 4);
      for (int i = 0; i < 18; ++i) put(i == 2 || i == 17 ? 1 : 0, 3);
      put(1, 1), put(127, 7), put(1, 1), put(107, 7), put(0, 1), put(0, 1);
      put(0, 1);
    }
    put(0, (8 - count) % 8);
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : data) a += byte, b += a;
    put_big_endian(z, b % 65521 << 16 | a % 65521);
    irg::detail::inflater<file> in(z, 100);
    CHECK(in.zlib());
    CHECK(in.out == data);
  }
}

#ifdef IRG_HAVE_PNG

namespace {

/// A file in memory as libpng reads and writes it.
struct memory {
  file bytes;
  std::size_t at = 0;
  static void put(png_structp png, png_bytep data, png_size_t size) {
    auto* to = static_cast<memory*>(png_get_io_ptr(png));
    to->bytes.insert(to->bytes.end(), data, data + size);
  }
  static void take(png_structp png, png_bytep data, png_size_t size) {
    auto* from = static_cast<memory*>(png_get_io_ptr(png));
    if (from->bytes.size() - from->at < size) png_error(png, "cut off");
    std::memcpy(data, from->bytes.data() + from->at, size);
    from->at += size;
  }
};

/// The picture as libpng reads it, 16 bits scaled, of a file that it has written.
irg::image<rgba8> by_libpng(const file& f) {
  memory from{f};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_read_fn(png, &from, memory::take);
  png_read_info(png, info);
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  irg::image<rgba8> picture(static_cast<int>(png_get_image_width(png, info)),
                            static_cast<int>(png_get_image_height(png, info)));
  std::vector<png_bytep> rows;
  for (int y = 0; y < picture.height(); ++y) rows.push_back(&picture.row(y)->r);
  png_read_image(png, rows.data());
  png_destroy_read_struct(&png, &info, nullptr);
  return picture;
}

/// A picture of noise and slopes as libpng writes it.
file write_by_libpng(test::random& r, const head& h, bool transparent) {
  memory to;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &to, memory::put, nullptr);
  png_set_IHDR(png, info, h.width, h.height, h.depth, h.type, h.interlaced, 0, 0);
  std::vector<png_color> palette;
  if (h.type == 3) {
    for (int i = 0; i < 1 << h.depth; ++i) {
      const auto a = static_cast<png_byte>(r.next()), b = static_cast<png_byte>(r.next());
      palette.push_back({a, b, static_cast<png_byte>(r.next())});
    }
    png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  }
  if (transparent && h.type == 3) {
    std::vector<png_byte> alpha;
    for (std::size_t i = 0; i < palette.size() / 2 + 1; ++i) alpha.push_back(static_cast<png_byte>(r.next()));
    png_set_tRNS(png, info, alpha.data(), static_cast<int>(alpha.size()), nullptr);
  } else if (transparent && h.type < 4) {
    png_color_16 key;
    std::memset(&key, 0, sizeof key);
    key.gray = key.red = key.green = key.blue = static_cast<png_uint_16>(1);
    png_set_tRNS(png, info, nullptr, 0, &key);
  }
  png_set_compression_level(png, static_cast<int>(r.integer(0, 9)));
  png_set_compression_strategy(png, static_cast<int>(r.integer(0, 4)));  // fixed codes among them
  png_write_info(png, info);
  const png_size_t count = png_get_rowbytes(png, info);
  file rows(count * h.height);
  const std::int64_t noise = r.integer(0, 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = static_cast<std::uint8_t>(noise == 0 ? r.next() : noise == 1 ? i / 5 : noise == 2 ? r.next() & 1 : 1);
  std::vector<png_bytep> pointers;
  for (std::size_t y = 0; y < h.height; ++y) pointers.push_back(rows.data() + y * count);
  png_write_image(png, pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return to.bytes;
}

}  // namespace

TEST_CASE("png_read: libpng's pictures, every colour type, depth and interlacing, as libpng reads them") {
  test::random r(12);
  const struct {
    int type;
    std::vector<int> depths;
  } kinds[] = {{0, {1, 2, 4, 8, 16}}, {2, {8, 16}}, {3, {1, 2, 4, 8}}, {4, {8, 16}}, {6, {8, 16}}};
  int pictures = 0;
  for (const auto& kind : kinds)
    for (const int depth : kind.depths)
      for (int interlaced = 0; interlaced < 2; ++interlaced)
        for (int trial = 0; trial < 12; ++trial) {
          const auto width = static_cast<std::uint32_t>(r.integer(1, trial < 6 ? 9 : 80));
          const auto height = static_cast<std::uint32_t>(r.integer(1, trial < 6 ? 9 : 60));
          const file f = write_by_libpng(r, {width, height, depth, kind.type, interlaced}, trial % 2 == 1);
          const auto read = read_png(f);
          INFO(kind.type << " " << depth << " " << interlaced << " " << width << "x" << height);
          REQUIRE(read);
          const auto expected = by_libpng(f);
          REQUIRE(expected.width() == read->width());
          CHECK(*read == expected);
          ++pictures;
        }
  CHECK(pictures == 360);
}

#endif
