// SPDX-License-Identifier: MIT
#include <irg/render/detail/visible/streamed_rows.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/raster/image.hpp>
#include <irg/render/draw_triangles.hpp>

#include "support/random.hpp"

namespace {

using namespace irg;

// Rows of all lengths to all places within a line of the cache: what was there before and behind stays.
bool copies(detail::row_store how) {
  test::random r(1);
  std::vector<unsigned char> from(512), to(1024), expected(1024);
  for (auto& c : from) c = static_cast<unsigned char>(r.integer(0, 255));
  for (std::size_t place = 64; place < 64 + 64; place += 4)
    for (std::size_t bytes = 0; bytes <= 256; bytes += 4) {
      for (std::size_t i = 0; i < to.size(); ++i) to[i] = expected[i] = static_cast<unsigned char>(i * 7 + bytes);
      for (std::size_t i = 0; i < bytes; ++i) expected[place + i] = from[i + 3];
      detail::copy_row(to.data() + place, from.data() + 3, bytes, how);
      detail::end_of_rows(how);
      if (to != expected) return false;
    }
  return true;
}

using batch = triangle_batch<float>;

// Red and green of vertices that are close to each other in memory; large triangles and small ones.
struct colours {
  static constexpr int attribute_count = 2;
  std::span<const float> of_vertices;
  const float* attributes(const batch&, std::uint32_t vertex, facing) const { return of_vertices.data() + 2 * vertex; }
  rgba8 pixel(const std::array<float, 2>& v) const {
    return {static_cast<std::uint8_t>(v[0]), static_cast<std::uint8_t>(v[1]), 7, 255};
  }
  template <int N>
  pack<std::uint32_t, N> pixels(const std::array<pack<float, N>, 2>& v) const {
    const auto word = converted<std::int32_t>(v[0]) | converted<std::int32_t>(v[1]) << 8;
    return bits_as<std::uint32_t>(word) | 0xff070000u;
  }
};

// The order of depths by another name: irg does not know it and draws pixel by pixel.
struct plainly {
  static constexpr float farthest = 0.0f;
  template <class T>
  static constexpr auto nearer(const T& a, const T& b) noexcept {
    return b < a;
  }
};

}  // namespace

TEST_CASE("streamed_rows: a row is copied, and nothing else is touched") {
  CHECK(copies(detail::row_store::cached));
  CHECK(copies(detail::row_store::streamed));
}

TEST_CASE("streamed_rows: a picture that is streamed has the pixels of one that is drawn pixel by pixel") {
  constexpr int width = 1201, height = 900;
  static_assert(std::int64_t{width} * height >= detail::streamed_pixels);
  const screen_mapping<float> mapping = map_to_screen<float>({width, height});
  test::random r(2);
  std::vector<point<float, 3>> positions;
  std::vector<triangle_indices> indices;
  std::vector<float> of_vertices;
  for (std::uint32_t i = 0; i < 500; ++i) {
    const double size = i < 20 ? 1 : i < 200 ? 0.1 : 0.01, x = 2 * r.unit() - 1, y = 2 * r.unit() - 1;
    for (int k = 0; k < 3; ++k) {
      positions.push_back({static_cast<float>(x + size * (2 * r.unit() - 1)),
                           static_cast<float>(y + size * (2 * r.unit() - 1)),
                           static_cast<float>(0.1 + 0.8 * r.unit())});
      of_vertices.push_back(static_cast<float>(255 * r.unit()));
      of_vertices.push_back(static_cast<float>(255 * r.unit()));
    }
    indices.push_back({{3 * i, 3 * i + 1, 3 * i + 2}});
  }
  projected_vertices<float> vertices;
  project_vertices<float>(positions, identity_matrix<float, 4>(), mapping, vertices);
  const batch all[1] = {{&vertices, indices, 0, 0}};
  draw_options<rgba8> settings;
  settings.culling = face_culling::none;
  settings.clear = clearing::before_drawing;
  image<rgba8> picture(width, height), expected(width, height);
  image<float> depth(width, height), expected_depth(width, height);
  const auto fast = shade_batches<nearer_is_greater, float>(render_target{picture, depth}, {all, mapping},
                                                            colours{of_vertices}, settings);
  const auto plain = shade_batches<plainly, float>(render_target{expected, expected_depth}, {all, mapping},
                                                   colours{of_vertices}, settings);
  CHECK(fast.drawn == plain.drawn);
  CHECK(plain.skipped.occluded == 0);
  CHECK(fast.drawn > 100000);
  int wrong = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      wrong += get_pixel(picture, x, y) == get_pixel(expected, x, y) ? 0 : 1;
      wrong += get_pixel(depth, x, y) == get_pixel(expected_depth, x, y) ? 0 : 1;
    }
  CHECK(wrong == 0);
}
