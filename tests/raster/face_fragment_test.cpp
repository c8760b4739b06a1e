// SPDX-License-Identifier: MIT
#include <irg/raster/face_fragment.hpp>

#include <vector>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

using irg::drawing_order;
using irg::face_fragment;
using irg::screen_face;
using greater = irg::nearer_is_greater;
using less = irg::nearer_is_less;

constexpr screen_face face(irg::subpixel a, irg::subpixel b, irg::subpixel c, float da, float db, float dc,
                           std::uint32_t number) {
  return irg::make_screen_face({a, da}, {b, db}, {c, dc}, number);
}
// A depth of 1/2 all over, and one that passes it at the centres of column 8.
constexpr screen_face half = face({0, 0}, {8192, 0}, {0, 8192}, 0.53125f, 0.53125f, 0.53125f, 4);
constexpr screen_face slope(std::uint32_t number) {
  return face({0, 0}, {4096, 0}, {0, 4096}, 0.0f, 1.0f, 0.0f, number);
}

TEST_CASE("face_fragment: by hand") {
  CHECK_BOTH(covers(face_fragment{&half}, 3, 3));
  CHECK_BOTH(!covers(face_fragment{&half}, -3, 3));
  static constexpr screen_face low = slope(3), high = slope(5);
  const auto columns = [](const screen_face& f, const screen_face& plane) constexpr {
    const auto parts = split_fragment({&f}, plane);
    const auto has = [](const face_fragment& p, int x) { return covers(p, x, 2) ? 1 : 0; };
    return has(parts.nearer, 7) + 2 * has(parts.nearer, 8) + 4 * has(parts.nearer, 9) + 8 * has(parts.farther, 7) +
           16 * has(parts.farther, 8) + 32 * has(parts.farther, 9);
  };
  CHECK_BOTH(columns(low, half) == 2 + 4 + 8);  // as deep in column 8, the lower number is the nearer
  CHECK_BOTH(columns(high, half) == 4 + 8 + 16);
  CHECK_BOTH(columns(half, low) == 1 + 16 + 32);
  CHECK_BOTH(columns(low, low) == 8 + 16 + 32);  // not nearer than itself
}

screen_face random_face(test::random& r, std::uint32_t number) {
  irg::screen_vertex v[3];
  for (auto& c : v)
    c = {{static_cast<std::int32_t>(r.integer(-2000, 7000)), static_cast<std::int32_t>(r.integer(-2000, 7000))},
         static_cast<float>(r.integer(0, 4)) / 4};  // so that there are equal depths
  return irg::make_screen_face(v[0], v[1], v[2], number);
}

template <irg::DepthOrder Order>
void partitions(std::uint64_t seed, int rounds) {
  test::random r(seed);
  long long pixels = 0, divided = 0, wrong = 0;
  for (int i = 0; i < rounds; ++i) {
    std::vector<screen_face> faces;
    for (std::uint32_t k = 0; k < 6; ++k) faces.push_back(random_face(r, k));
    const auto source = static_cast<std::size_t>(i) % faces.size();
    std::vector<face_fragment> parts{{&faces[source]}};
    for (const screen_face& f : faces) {
      if (&f == &faces[source] || f.coverage.double_area == 0) continue;
      const auto which = static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(parts.size()) - 1));
      auto cut = split_fragment(parts[which], f);
      parts[which] = cut.nearer;
      parts.push_back(cut.farther);
    }
    std::vector<int> seen(parts.size(), 0);
    for (int y = -5; y < 21; ++y)
      for (int x = -5; x < 21; ++x) {
        int holders = 0;
        for (std::size_t k = 0; k < parts.size(); ++k)
          if (irg::covers<Order>(parts[k], x, y)) ++holders, seen[k] = 1;
        wrong += holders != (covers(faces[source], x, y) ? 1 : 0);
        pixels += holders;
      }
    int used = 0;
    for (const int s : seen) used += s;
    divided += used > 1;
  }
  CHECK(wrong == 0);
  CHECK(pixels > 20 * rounds);
  if (std::is_same_v<Order, drawing_order>)
    CHECK(divided == 0);  // an order of whole faces
  else
    CHECK(divided > rounds / 4);
}

TEST_CASE("split_fragment: each pixel of a face belongs to one of its parts") {
  partitions<greater>(431, test::trials(300));
  partitions<less>(432, test::trials(300));
  partitions<drawing_order>(433, test::trials(300));
}

// Two faces that pass through each other have no order; one of them split by the other has: its farther part, the
// other, its nearer part, painted in this order, give the picture.
template <irg::DepthOrder Order>
void paints(std::uint64_t seed, int rounds) {
  test::random r(seed);
  long long both = 0, wrong = 0;
  for (int i = 0; i < rounds; ++i) {
    const auto first = static_cast<std::uint32_t>(i % 2);
    const screen_face faces[2] = {random_face(r, first), random_face(r, 1 - first)};
    if (faces[1].coverage.double_area == 0) continue;
    const auto parts = split_fragment({&faces[0]}, faces[1]);
    for (int y = -5; y < 21; ++y)
      for (int x = -5; x < 21; ++x) {
        std::uint32_t seen = irg::no_index;
        if (irg::covers<Order>(parts.farther, x, y)) seen = faces[0].number;
        if (covers(faces[1], x, y)) seen = faces[1].number;
        if (irg::covers<Order>(parts.nearer, x, y)) seen = faces[0].number;
        both += covers(faces[0], x, y) && covers(faces[1], x, y);
        wrong += seen != irg::picture_face_at<Order>(faces, x, y).value_or(irg::no_index);
      }
  }
  CHECK(wrong == 0);
  CHECK(both > 10 * rounds);
}

TEST_CASE("split_fragment: painted from back to front, parts give the picture") {
  paints<greater>(434, test::trials(300));
  paints<less>(435, test::trials(300));
}

}  // namespace
