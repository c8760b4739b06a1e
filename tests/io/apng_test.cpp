// SPDX-License-Identifier: MIT
#include <irg/io/apng.hpp>

#include <bit>
#include <new>
#include <string_view>

#include <irg/raster/image.hpp>

#include "memory_in_use.hpp"
#include "support/check_both.hpp"
#include "support/png_oracle.hpp"
#include "support/random.hpp"

using irg::animation_options;
using irg::encode_animation;
using irg::png_animation;

namespace {

using frame = irg::image<irg::rgba8>;

constexpr frame moving_dot(int width, int height, int step) {
  frame f(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      f(x, y) = (x + y * width) % 7 == step ? irg::rgba8{255, 200, 0, 255} : irg::rgba8{0, 0, 60, 255};
  return f;
}

std::string_view message_of(const irg::result<std::vector<std::uint8_t>, irg::encode_error>& r) {
  return r ? "" : r.error().message;
}

}  // namespace

TEST_CASE("encode_animation: every picture comes back, with its time") {
  test::random r(3);
  for (int trial = 0; trial < 12; ++trial) {
    const int width = static_cast<int>(r.integer(1, 19)), height = static_cast<int>(r.integer(1, 13));
    std::vector<frame> frames;
    for (int i = 0; i < 1 + trial % 5; ++i) {
      frames.push_back(moving_dot(width, height, i));
      const std::uint64_t n = r.next();
      frames.back()(0, 0) = std::bit_cast<irg::rgba8>(static_cast<std::uint32_t>(n));
    }
    const animation_options how{static_cast<int>(r.integer(0, 65535)), trial, irg::png_options::compression(trial % 3)};
    const auto file = encode_animation(std::span<const frame>(frames), how);
    REQUIRE(file);
    const test::decoded_png back = test::decode_png(*file);
    CHECK_MESSAGE(back.error == nullptr, (back.error != nullptr ? back.error : ""));
    CHECK(back.repeats == static_cast<unsigned>(trial));
    REQUIRE(back.shown.size() == frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      CHECK(back.shown[i] == frames[i]);
      CHECK(back.seconds[i] == how.milliseconds / 1000.0);
    }
    CHECK(back.srgb_chunks == 1);
  }
}

TEST_CASE("encode_animation: pictures of several chunks") {
  frame noise(600, 500);
  test::random r(4);
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 600; ++x) noise(x, y) = std::bit_cast<irg::rgba8>(static_cast<std::uint32_t>(r.next()));
  const frame two[] = {noise, noise};
  const auto file = encode_animation(std::span<const frame>(two), {40, 0, irg::png_options::compression::stored});
  REQUIRE(file);
  const test::decoded_png back = test::decode_png(*file);
  CHECK_MESSAGE(back.error == nullptr, (back.error != nullptr ? back.error : ""));
  CHECK(back.data_chunks == 2);
  REQUIRE(back.shown.size() == 2);
  CHECK(back.shown[1] == noise);
}

TEST_CASE("png_animation: picture by picture it is the same file, also in constant evaluation") {
  std::vector<frame> frames;
  for (int i = 0; i < 4; ++i) frames.push_back(moving_dot(5, 3, i));
  const auto whole = encode_animation(std::span<const frame>(frames));
  REQUIRE(whole);
  png_animation<frame> animation(4);
  std::vector<std::uint8_t> file;
  for (const frame& f : frames) {
    const auto bytes = animation.add(f);
    REQUIRE(bytes);
    file.insert(file.end(), bytes->begin(), bytes->end());
  }
  CHECK(file == *whole);
  CHECK(message_of(animation.add(frames[0])) == "animation has all its pictures");
  constexpr auto sum = [] {
    const frame two[] = {moving_dot(3, 2, 0), moving_dot(3, 2, 1)};
    const auto made = encode_animation(std::span<const frame>(two));
    std::uint32_t n = 0;
    for (const std::uint8_t b : *made) n = n * 31 + b;
    return n;
  };
  constexpr std::uint32_t early = sum();
  CHECK(early == sum());
}

TEST_CASE("png_animation: what is refused, and changes nothing") {
  const frame one(2, 2), other(2, 3), none(0, 2);
  CHECK(message_of(encode_animation(std::span<const frame>())) == "animation needs at least one picture");
  CHECK(message_of(png_animation<frame>(0).add(one)) == "animation needs at least one picture");
  CHECK(message_of(png_animation<frame>(-1).add(one)) == "animation needs at least one picture");
  CHECK(message_of(png_animation<frame>(1).add(none)) == "picture needs at least one pixel");
  CHECK(message_of(png_animation<frame>(1, {65536, 0}).add(one)) != "");
  CHECK(message_of(png_animation<frame>(1, {-1, 0}).add(one)) != "");
  CHECK(message_of(png_animation<frame>(1, {40, -1}).add(one)) != "");
  png_animation<frame> animation(2);
  std::vector<std::uint8_t> file = *animation.add(one);
  CHECK(message_of(animation.add(other)) == "pictures of an animation have one size");
  const auto rest = animation.add(one);
  REQUIRE(rest);
  file.insert(file.end(), rest->begin(), rest->end());
  CHECK(test::decode_png(file).error == nullptr);
}

#ifdef __cpp_exceptions
TEST_CASE("png_animation: where memory gives out, the next try gives the same file") {
  const std::vector<frame> frames{moving_dot(5, 4, 0), moving_dot(5, 4, 1), moving_dot(5, 4, 2)};
  const auto whole = encode_animation(std::span<const frame>(frames));
  REQUIRE(whole);
  png_animation<frame> animation(3);
  std::vector<std::uint8_t> file, part;
  for (const frame& f : frames) {
    bool failed = true;
    for (long left = 0; failed && left < 1000; ++left) {
      test::allocations_left = left;
      try {
        part = *animation.add(f);
        failed = false;
      } catch (const std::bad_alloc&) {
      }
      test::allocations_left = -1;
    }
    file.insert(file.end(), part.begin(), part.end());
  }
  CHECK(file == *whole);
}
#endif
