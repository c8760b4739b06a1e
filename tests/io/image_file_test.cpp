// SPDX-License-Identifier: MIT
#include <irg/io/image_file.hpp>

#include <cstdio>
#include <string>

#include "support/check_both.hpp"
#include "support/png_oracle.hpp"

using irg::image;
using irg::image_format;
using irg::image_format_of_name;
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
  CHECK_BOTH(image_format_of_name("a.png") == image_format::png);
  CHECK_BOTH(image_format_of_name("a.ppm") == image_format::ppm);
  CHECK_BOTH(image_format_of_name("a.Svg") == image_format::svg);
  CHECK_BOTH(image_format_of_name("folder.ppm/A.PNG") == image_format::png);
  CHECK_BOTH(image_format_of_name("a.png.PpM") == image_format::ppm);
  for (const char* path :
       {"", ".", "png", "apng", "a.png ", "a.jpg", "a.svgz", "a.pgm", "a.png/", "a.png/b", "a.pn", "a.p@g", ".pnG.x"}) {
    CAPTURE(path);
    CHECK(!image_format_of_name(path).has_value());
  }
}

TEST_CASE("a file holds the picture") {
  const image<rgba8> p = checkers(31, 17);
  for (const char* ending : {".png", ".PNG", ".ppm", ".Ppm", ".svg"}) {
    const temporary file(ending);
    CAPTURE(ending);
    REQUIRE(irg::save_image(file.path, p).has_value());
    const auto read = irg::load_file(file.path);
    REQUIRE(read.has_value());
    test::bytes bytes;
    for (const char c : *read) bytes.push_back(static_cast<std::uint8_t>(c));
    if (image_format_of_name(ending) == image_format::png) {
      CHECK(bytes == *irg::encode_png(p));
      CHECK(test::decode_png(bytes).picture == p);
    } else if (image_format_of_name(ending) == image_format::svg) {
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
  REQUIRE(irg::save_image(file.path, p, plain).has_value());
  CHECK(irg::load_file(file.path)->size() > 64 * 64 * 4);
}

TEST_CASE("an older file is replaced, by a whole one or not at all") {
  const temporary file(".ppm");
  REQUIRE(irg::save_image(file.path, checkers(2, 2)).has_value());
  const std::string before = *irg::load_file(file.path);
  CHECK(!irg::save_image(file.path, image<rgba8>(0, 5)).has_value());
  CHECK(*irg::load_file(file.path) == before);
  REQUIRE(irg::save_image(file.path, checkers(3, 1)).has_value());
  CHECK(*irg::load_file(file.path) != before);
}

TEST_CASE("what cannot be written is refused in a sentence, and nothing is left behind") {
  const temporary none(".png"), other(".jpg");
  const auto empty = irg::save_image(none.path, image<rgba8>());
  REQUIRE(!empty.has_value());
  CHECK(std::string(empty.error().message) == irg::encode_png(image<rgba8>()).error().message);
  CHECK(empty.error().line == 0);
  CHECK(empty.error().column == 0);
  CHECK(!exists(none.path));
  const auto unknown = irg::save_image(other.path, checkers(2, 2));
  REQUIRE(!unknown.has_value());
  CHECK(std::string(unknown.error().message).find(".png") != std::string::npos);
  CHECK(std::string(unknown.error().message).find(".ppm") != std::string::npos);
  CHECK(!exists(other.path));
  CHECK(!irg::save_image("irg_no_such_folder/a.png", checkers(2, 2)).has_value());
  CHECK(!irg::save_image("", checkers(2, 2)).has_value());
}

TEST_CASE("load_image: PNG and PPM by their bytes, in the pixels asked for") {
  const image<rgba8> p = checkers(9, 5);
  const temporary png(".png"), ppm(".ppm"), misnamed(".png");
  REQUIRE(irg::save_image(png.path, p).has_value());
  REQUIRE(irg::save_image(ppm.path, p).has_value());
  REQUIRE(irg::save_file(misnamed.path, std::span<const std::uint8_t>(*irg::encode_ppm(p))).has_value());
  CHECK(*irg::load_image(png.path) == p);
  CHECK(*irg::load_image(ppm.path) == irg::convert_image<rgba8>(irg::convert_image<irg::rgb8>(p)));
  CHECK(*irg::load_image(misnamed.path) == *irg::load_image(ppm.path));
  CHECK(*irg::load_image<std::uint8_t>(png.path) == irg::convert_image<std::uint8_t>(p));
}

TEST_CASE("load_image: the reason why there is no picture") {
  const temporary none(".png"), text(".png"), cut(".png");
  CHECK(std::string(irg::load_image(none.path).error().message) == "file does not exist");
  REQUIRE(irg::save_file(text.path, std::string_view("hello")).has_value());
  CHECK(std::string(irg::load_image(text.path).error().message) == "file is neither PNG nor PPM");
  const auto whole = *irg::encode_png(checkers(9, 5));
  REQUIRE(irg::save_file(cut.path, std::span<const std::uint8_t>(whole).first(whole.size() / 2)).has_value());
  CHECK(std::string(irg::load_image(cut.path).error().message) ==
        irg::read_png(std::span<const std::uint8_t>(whole).first(whole.size() / 2)).error().message);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
TEST_CASE("old names of calls on files do what they did") {
  const temporary png(".png"), plain(".txt");
  CHECK(!irg::write_image(png.path, checkers(2, 2)));
  CHECK(irg::write_image(png.path + ".jpg", checkers(2, 2)));
  CHECK(!irg::write_file_atomically(plain.path, std::string_view("old")));
  CHECK(*irg::read_file(plain.path) == "old");
  CHECK(irg::picture_format_of("a.svg") == image_format::svg);
  CHECK(*irg::encode_picture(checkers(2, 2), image_format::ppm) == *irg::encode_ppm(checkers(2, 2)));
}
#pragma GCC diagnostic pop
