// SPDX-License-Identifier: MIT
#include <irg/trace/ray_tracing.hpp>

#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include <doctest/doctest.h>

#include "support/face_oracle.hpp"
#include "support/random.hpp"

namespace {

// Faces with corners on a lattice of half pixels and few depths, so that many tie, or anywhere.
std::vector<irg::screen_face> faces(test::random& r, int count, int size, bool lattice) {
  std::vector<irg::screen_face> all;
  for (int i = 0; i < count; ++i) {
    const float level = static_cast<float>(r.integer(0, 2)) * 0.25f;
    const auto vertex = [&] {
      const auto place = [&] {
        return static_cast<std::int32_t>(lattice ? r.integer(-2, 2 * size + 2) * 128
                                                 : r.integer(-300, size * 256 + 300));
      };
      irg::screen_vertex v{};
      v.position = {place(), place()};
      v.depth =
          lattice ? (i % 2 == 0 ? level : static_cast<float>(r.integer(0, 4)) * 0.25f) : static_cast<float>(r.unit());
      return v;
    };
    const auto a = vertex(), b = vertex(), c = vertex();
    all.push_back(irg::make_screen_face(a, b, c, static_cast<std::uint32_t>(i)));
  }
  return all;
}

template <class Order>
int differing(test::random& r, int round, std::int64_t* ties = nullptr) {
  constexpr int size = 12;
  const auto all = faces(r, static_cast<int>(r.integer(0, 30)), size, round % 2 == 0);
  irg::image<std::uint32_t> ids(size, size, irg::no_index);
  irg::draw_counts counts;
  irg::ray_tracing<Order>{}(all, {0, 0, 7, size}, ids, counts);
  irg::ray_tracing<Order>{}(all, {7, 0, size, size}, ids, counts);
  int different = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      different += ids(x, y) !=
                   irg::picture_face_at<Order>(std::span<const irg::screen_face>(all), x, y).value_or(irg::no_index);
  if (ties != nullptr) *ties += counts.ties;
  return different;
}

TEST_CASE("ray_tracing: the picture, in each pixel of random scenes, with ties and without") {
  test::random r(51);
  int wrong = 0;
  std::int64_t ties = 0;
  const int rounds = std::getenv("IRG_RELEASE_TIER") != nullptr ? 10000 : 150;
  for (int i = 0; i < rounds; ++i)
    wrong += i % 3 == 0 ? differing<irg::nearer_is_less>(r, i) : differing<irg::nearer_is_greater>(r, i, &ties);
  CHECK(wrong == 0);
  CHECK(ties > 100);
}

TEST_CASE("ray_tracing: drawing order, no faces, faces without area") {
  static_assert([] {
    irg::image<std::uint32_t> ids(2, 2, irg::no_index);
    irg::draw_counts counts;
    const irg::screen_vertex a{{0, 0}, 0.5f}, b{{512, 0}, 0.5f}, c{{0, 512}, 0.5f};
    const std::vector<irg::screen_face> one{irg::make_screen_face(a, b, c, 7), irg::make_screen_face(a, a, b, 8)};
    irg::ray_tracing<>{}(one, {0, 0, 2, 2}, ids, counts);
    return ids(0, 0) == 7 && ids(1, 1) == irg::no_index && counts.tested == 1;
  }());
  test::random r(52);
  CHECK(differing<irg::drawing_order>(r, 0) == 0);
  irg::image<std::uint32_t> ids(3, 3, irg::no_index);
  irg::draw_counts counts;
  irg::ray_tracing<>{}(std::vector<irg::screen_face>{}, {0, 0, 3, 3}, ids, counts);
  CHECK(ids(1, 1) == irg::no_index);
}

}  // namespace
