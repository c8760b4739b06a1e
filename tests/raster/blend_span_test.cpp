// SPDX-License-Identifier: MIT
#include <irg/raster/blend_span.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();

std::uint8_t random_byte(test::random& r) { return static_cast<std::uint8_t>(r.integer(0, 255)); }

template <class P>
P random_pixel(test::random& r) {
  if constexpr (std::is_floating_point_v<P>) {
    return static_cast<P>(r.unit());
  } else if constexpr (std::is_same_v<P, irg::rgb<float>>) {
    const auto red = static_cast<float>(r.unit()), green = static_cast<float>(r.unit());
    return {red, green, static_cast<float>(r.unit())};
  } else {
    P p;
    std::uint8_t bytes[sizeof(P)];
    for (std::uint8_t& b : bytes) b = random_byte(r);
    std::memcpy(static_cast<void*>(&p), bytes, sizeof p);
    return p;
  }
}

// Runs of all lengths and starts, with coverages of every kind, against mix() pixel by pixel.
template <class P>
void same_bytes_as_a_loop() {
  test::random r(1);
  std::vector<P> lanes(60), loop(60);
  for (std::size_t count = 0; count < 40; ++count)
    for (std::size_t offset = 0; offset < 9; ++offset) {
      for (std::size_t i = 0; i < lanes.size(); ++i) loop[i] = lanes[i] = random_pixel<P>(r);
      // Exactly as many coverages as pixels: a sanitizer sees one read too many.
      std::vector<std::uint8_t> coverage(count);
      for (std::uint8_t& c : coverage) c = offset % 3 == 0 ? random_byte(r) : r.integer(0, 1) == 0 ? 0 : 255;
      const P value = random_pixel<P>(r);
      irg::mix_pixels(lanes.data() + offset, count, coverage.data(), value);
      for (std::size_t i = 0; i < count; ++i) loop[offset + i] = irg::mix(loop[offset + i], value, coverage[i]);
      REQUIRE(std::memcmp(lanes.data(), loop.data(), lanes.size() * sizeof(P)) == 0);
    }
}

TEST_CASE("mix_pixels: lanes write what mix() gives, for every length, start and pixel type") {
  same_bytes_as_a_loop<irg::rgba8>();
  same_bytes_as_a_loop<irg::bgra8>();
  same_bytes_as_a_loop<irg::rgb8>();
  same_bytes_as_a_loop<irg::bgr8>();
  same_bytes_as_a_loop<std::uint8_t>();
  same_bytes_as_a_loop<float>();
  same_bytes_as_a_loop<double>();
  same_bytes_as_a_loop<irg::rgb<float>>();
}

TEST_CASE("mix_pixels: all 2^24 arguments of a channel, in lanes") {
  std::vector<irg::rgba8> row(256);
  std::vector<std::uint8_t> coverage(256);
  for (int c = 0; c < 256; ++c) coverage[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(c);
  for (int a = 0; a < 256; ++a)
    for (int b = 0; b < 256; b += 4) {
      const auto shade = [](int v) { return static_cast<std::uint8_t>(v); };
      const irg::rgba8 value{shade(b), shade(b + 1), shade(b + 2), shade(b + 3)};
      const irg::rgba8 there{shade(a), shade(a), shade(a), shade(a)};
      for (irg::rgba8& p : row) p = there;
      irg::mix_pixels(row.data(), row.size(), coverage.data(), value);
      for (std::size_t c = 0; c < 256; ++c) REQUIRE(row[c] == irg::mix(there, value, coverage[c]));
    }
}

// The primitives under it that other kernels call, next to memory that is not theirs.
template <int N>
void primitives_agree() {
  test::random r(2);
  for (int round = 0; round < 400; ++round) {
    const int count = 1 + round % (6 * N);
    const auto length = static_cast<std::size_t>(count);
    std::vector<irg::rgba8> there(length);  // exactly: a sanitizer sees what is read or written beyond
    for (irg::rgba8& p : there) p = random_pixel<irg::rgba8>(r);
    const auto value = random_pixel<irg::rgba8>(r);
    std::uint8_t coverage[2 * static_cast<unsigned>(N)];
    for (std::uint8_t& c : coverage) c = random_byte(r);
    const auto colour = irg::detail::prepare_mix<N>(value);
    const auto first = irg::detail::load_coverages<N>(coverage), second = irg::detail::load_coverages<N>(coverage + N);
    std::vector<irg::rgba8> expected = there, got = there;
    if (count <= N) {
      irg::detail::mix_some<N>(got.data(), count, colour, first);
      for (std::size_t i = 0; i < length; ++i) expected[i] = irg::mix(there[i], value, coverage[i]);
      REQUIRE(got == expected);
    }
    if (count >= N) {
      constexpr std::size_t half = N / 2;
      got = there;
      irg::detail::mix_ends<N>(got.data(), count, colour, first);
      expected.assign(length, value);
      for (std::size_t i = 0; i < half; ++i) {
        const std::size_t k = length - half + i;
        expected[i] = irg::mix(there[i], value, coverage[i]);
        expected[k] = irg::mix(there[k], value, coverage[half + i]);
      }
      REQUIRE(got == expected);
      irg::detail::fill_words<N>(got.data(), count, colour);
      REQUIRE(got == std::vector<irg::rgba8>(length, value));
    }
    if (count >= 2 * N) {
      got = there;
      irg::detail::mix_ends<N>(got.data(), count, colour, first, second);
      expected.assign(length, value);
      for (std::size_t i = 0; i < N; ++i) {
        const std::size_t k = length - N + i;
        expected[i] = irg::mix(there[i], value, coverage[i]);
        expected[k] = irg::mix(there[k], value, coverage[N + i]);
      }
      REQUIRE(got == expected);
    }
  }
}

// Runs long enough for aligned stores, at every distance of bytes from a cache line, between pixels that must stay.
template <int N>
void fills_at_every_alignment() {
  test::random r(3);
  constexpr std::size_t longest = 200, line = 64, size = 3 * line + longest * 4;
  struct alignas(line) memory {
    unsigned char byte[size];
  } there, got, expected;
  for (unsigned char& b : there.byte) b = random_byte(r);
  const auto value = random_pixel<irg::rgba8>(r);
  const auto colour = irg::detail::prepare_mix<N>(value);
  const std::uint8_t coverage[16] = {7, 255, 0, 90, 128, 3, 254, 1, 33, 0, 255, 17, 200, 64, 99, 180};
  const auto first = irg::detail::load_coverages<N>(coverage), second = irg::detail::load_coverages<N>(coverage + N);
  for (std::size_t count = 2 * N; count <= longest; ++count)
    for (std::size_t offset = line; offset < 2 * line; ++offset) {
      got = expected = there;
      const auto run = [&](memory& m) { return reinterpret_cast<irg::rgba8*>(m.byte + offset); };
      irg::detail::fill_words<N>(run(got), static_cast<int>(count), colour, 4 * 200);
      std::fill_n(run(expected), count, value);
      REQUIRE(std::memcmp(got.byte, expected.byte, size) == 0);
      got = there;
      irg::detail::mix_ends<N>(run(got), static_cast<int>(count), colour, first, second, -4 * 200);
      for (std::size_t i = 0; i < N; ++i) {
        const std::size_t k = count - N + i;
        run(expected)[i] = irg::mix(run(there)[i], value, coverage[i]);
        run(expected)[k] = irg::mix(run(there)[k], value, coverage[N + i]);
      }
      REQUIRE(std::memcmp(got.byte, expected.byte, size) == 0);
    }
}

TEST_CASE("mix kernel: long runs at every alignment") {
  fills_at_every_alignment<4>();
  if constexpr (irg::native_bytes == 32) fills_at_every_alignment<irg::detail::mix_lanes>();
}

TEST_CASE("mix kernel: whole packs, parts of packs and both ends of runs") {
  primitives_agree<4>();
  if constexpr (irg::native_bytes == 32) primitives_agree<irg::detail::mix_lanes>();
}

constexpr irg::image<irg::rgba8> blended(int y, int x_first, int x_last) {
  irg::image<irg::rgba8> i(5, 2, {0, 0, 0, 0});
  const std::uint8_t coverage[9] = {255, 0, 51, 102, 153, 204, 1, 2, 3};
  irg::blend_span(i, {y, x_first, x_last, coverage}, {255, 255, 255, 255});
  return i;
}

TEST_CASE("blend_span: each pixel by its coverage, cut to the raster") {
  CHECK_BOTH(blended(0, 0, 5)(0, 0).r == 255);
  CHECK_BOTH(blended(0, 0, 5)(1, 0).r == 0);
  CHECK_BOTH(blended(0, 0, 5)(2, 0).g == 51);
  CHECK_BOTH(blended(1, -2, 7)(0, 1).r == 51);
  CHECK_BOTH(blended(1, -2, 7)(4, 1).a == 1);
  CHECK_BOTH(blended(1, -2, 7)(0, 0).r == 0);
  CHECK_BOTH(blended(0, 3, 3)(3, 0).r == 0);  // empty
  CHECK_BOTH(blended(0, 4, 1)(3, 0).r == 0);
  CHECK_BOTH(blended(-1, 0, 5)(0, 0).r == 0);
  CHECK_BOTH(blended(2, 0, 5)(0, 1).r == 0);
}

constexpr bool whole_run() {
  irg::image<std::uint8_t> i(4, 1, 9);
  irg::blend_span(i, {0, 1, most, nullptr}, std::uint8_t{200});
  irg::blend_span(i, {0, least, -5, nullptr}, std::uint8_t{3});
  return i(0, 0) == 9 && i(1, 0) == 200 && i(3, 0) == 200;
}

constexpr bool function_runs_once() {
  irg::image<int> i(6, 1, 0);
  const std::uint8_t coverage[5] = {1, 0, 7, 255, 9};
  const auto count = [](int there, std::uint8_t c) { return there + 1000 + c; };
  irg::blend_span(i, {0, 0, 5, coverage}, count);
  irg::blend_span(i, {0, 5, 6, nullptr}, count);
  return i(0, 0) == 1001 && i(1, 0) == 0 && i(2, 0) == 1007 && i(3, 0) == 1255 && i(5, 0) == 1255;
}

// A raster without rows.
struct scattered {
  float pixel[3] = {1, 1, 1};
  constexpr int width() const { return 3; }
  constexpr int height() const { return 1; }
  constexpr float& operator()(int x, int) { return pixel[x]; }
  constexpr const float& operator()(int x, int) const { return pixel[x]; }
};

constexpr bool serves_any_raster() {
  scattered s;
  const std::uint8_t coverage[2] = {255, 0};
  irg::blend_span(s, {0, 0, 2, coverage}, 5.0f);
  irg::blend_span(s, {0, 2, 3, nullptr}, 6.0f);
  return s(0, 0) == 5 && s(1, 0) == 1 && s(2, 0) == 6;
}

TEST_CASE("blend_span: whole runs, functions, rasters without rows") {
  CHECK_BOTH(whole_run());
  CHECK_BOTH(function_runs_once());
  CHECK_BOTH(serves_any_raster());
}

TEST_CASE("blend_span: gaps between rows are left alone") {
  std::vector<irg::rgba8> memory(5 * 8, {1, 2, 3, 4});
  irg::image_view<irg::rgba8> upside_down(memory.data() + 4 * 8, 6, 5,
                                          -8 * static_cast<std::ptrdiff_t>(sizeof(irg::rgba8)));
  const std::uint8_t coverage[9] = {255, 255, 255, 255, 255, 255, 255, 255, 255};
  for (int y = -1; y < 6; ++y) irg::blend_span(upside_down, {y, -1, 8, coverage}, {9, 9, 9, 9});
  for (std::size_t y = 0; y < 5; ++y)
    for (std::size_t x = 0; x < 8; ++x)
      CHECK(memory[8 * y + x] == (x < 6 ? irg::rgba8{9, 9, 9, 9} : irg::rgba8{1, 2, 3, 4}));
}

}  // namespace
