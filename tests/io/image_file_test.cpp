// SPDX-License-Identifier: MIT
#include <irg/io/image_file.hpp>

#include <cstdio>
#include <string>

#include "support/check_both.hpp"
#include "support/png_oracle.hpp"

using irg::image;
using irg::picture_format;
using irg::picture_format_of;
using irg::rgba8;

namespace {

image<rgba8> checkers(int width, int height) {
  image<rgba8> p(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) p(x, y) = (x + y) % 2 == 0 ? rgba8{250, 20, 30, 255} : rgba8{1, 2, 3, 255};
  return p;
}

bool exists(const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  return file != nullptr && std::fclose(file) == 0;
}

// A name in the working folder; the file is gone when the test is over.
struct temporary {
  std::string path;
  explicit temporary(const std::string& ending) : path("irg_image_file_test" + ending) { std::remove(path.c_str()); }
  ~temporary() { std::remove(path.c_str()); }
  temporary(const temporary&) = delete;
  temporary& operator=(const temporary&) = delete;
};

}  // namespace

TEST_CASE("the ending names the format") {
  CHECK_BOTH(picture_format_of("a.png") == picture_format::png);
  CHECK_BOTH(picture_format_of("a.ppm") == picture_format::ppm);
  CHECK_BOTH(picture_format_of("a.Svg") == picture_format::svg);
  CHECK_BOTH(picture_format_of("folder.ppm/A.PNG") == picture_format::png);
  CHECK_BOTH(picture_format_of("a.png.PpM") == picture_format::ppm);
  for (const char* path :
       {"", ".", "png", "apng", "a.png ", "a.jpg", "a.svgz", "a.pgm", "a.png/", "a.png/b", "a.pn", "a.p@g", ".pnG.x"}) {
    CAPTURE(path);
    CHECK(!picture_format_of(path).has_value());
  }
}

TEST_CASE("a file holds the picture") {
  const image<rgba8> p = checkers(31, 17);
  for (const char* ending : {".png", ".PNG", ".ppm", ".Ppm", ".svg"}) {
    const temporary file(ending);
    CAPTURE(ending);
    REQUIRE(!irg::write_image(file.path, p).has_value());
    const auto read = irg::read_file(file.path);
    REQUIRE(read.has_value());
    test::bytes bytes;
    for (const char c : *read) bytes.push_back(static_cast<std::uint8_t>(c));
    if (picture_format_of(ending) == picture_format::png) {
      CHECK(bytes == *irg::encode_png(p));
      CHECK(test::decode_png(bytes).picture == p);
    } else if (picture_format_of(ending) == picture_format::svg) {
      CHECK(bytes == *irg::encode_svg(p));
    } else {
      CHECK(bytes == *irg::encode_ppm(p));
      CHECK((*irg::read_ppm(*read))(1, 0) == irg::rgb8{1, 2, 3});
    }
  }
}

TEST_CASE("options reach the encoder") {
  const temporary file(".png");
  const image<rgba8> p = checkers(64, 64);
  const irg::png_options plain{irg::png_options::compression::stored, irg::png_options::channels::rgba};
  REQUIRE(!irg::write_image(file.path, p, plain).has_value());
  CHECK(irg::read_file(file.path)->size() > 64 * 64 * 4);
}

TEST_CASE("an older file is replaced, by a whole one or not at all") {
  const temporary file(".ppm");
  REQUIRE(!irg::write_image(file.path, checkers(2, 2)).has_value());
  const std::string before = *irg::read_file(file.path);
  CHECK(irg::write_image(file.path, image<rgba8>(0, 5)).has_value());
  CHECK(*irg::read_file(file.path) == before);
  REQUIRE(!irg::write_image(file.path, checkers(3, 1)).has_value());
  CHECK(*irg::read_file(file.path) != before);
}

TEST_CASE("what cannot be written is refused in a sentence, and nothing is left behind") {
  const temporary none(".png"), other(".jpg");
  const auto empty = irg::write_image(none.path, image<rgba8>());
  REQUIRE(empty.has_value());
  CHECK(std::string(empty->message) == irg::encode_png(image<rgba8>()).error().message);
  CHECK(empty->line == 0);
  CHECK(empty->column == 0);
  CHECK(!exists(none.path));
  const auto unknown = irg::write_image(other.path, checkers(2, 2));
  REQUIRE(unknown.has_value());
  CHECK(std::string(unknown->message).find(".png") != std::string::npos);
  CHECK(std::string(unknown->message).find(".ppm") != std::string::npos);
  CHECK(!exists(other.path));
  CHECK(irg::write_image("irg_no_such_folder/a.png", checkers(2, 2)).has_value());
  CHECK(irg::write_image("", checkers(2, 2)).has_value());
}
