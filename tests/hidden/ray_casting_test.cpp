// SPDX-License-Identifier: MIT
#include <irg/hidden/ray_casting.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "method_scenes.hpp"
#include "support/check_both.hpp"

namespace {

constexpr irg::screen_face face(int x, int y, int size, float depth, std::uint32_t number) {
  return irg::make_screen_face({{x * 256, y * 256}, depth}, {{(x + size) * 256, y * 256}, depth},
                               {{x * 256, (y + size) * 256}, depth}, number);
}

}  // namespace

TEST_CASE("ray_casting: the nearest, of equally near ones the lowest number, nothing else") {
  constexpr auto run = [] {
    const std::vector<irg::screen_face> faces{face(0, 0, 8, 0.25f, 5), face(0, 0, 4, 0.5f, 7), face(1, 0, 4, 0.5f, 6)};
    irg::image<std::uint32_t> ids(8, 8, irg::no_index);
    irg::draw_counts counts;
    irg::ray_casting<>{}(faces, irg::cell_window{0, 0, 8, 8}, ids, counts);
    irg::image<std::uint32_t> other(8, 8, irg::no_index);
    irg::draw_counts ignored;
    irg::ray_casting<irg::nearer_is_less>{}(faces, irg::cell_window{0, 0, 8, 8}, other, ignored);
    return ids(0, 0) == 7 && ids(1, 0) == 6 && ids(3, 0) == 6 && ids(4, 0) == 5 && ids(7, 7) == irg::no_index &&
           other(0, 0) == 5 && counts.ties > 0 && counts.tested > counts.ties;
  };
  CHECK_BOTH(run());
}

TEST_CASE("ray_casting: only the window's pixels, faces without area not at all") {
  const std::vector<irg::screen_face> faces{
      face(0, 0, 8, 0.5f, 1), irg::make_screen_face({{0, 0}, 0.9f}, {{512, 512}, 0.9f}, {{1024, 1024}, 0.9f}, 0)};
  irg::image<std::uint32_t> ids(8, 8, 99u);
  irg::draw_counts counts;
  irg::ray_casting<>{}(faces, irg::cell_window{2, 1, 4, 3}, ids, counts);
  CHECK(ids(2, 1) == 1);
  CHECK(ids(1, 1) == 99);
  CHECK(ids(4, 1) == 99);
  CHECK(counts.tested == 4);
}

TEST_CASE("ray_casting: the exact picture") { CHECK(test::differing_pixels(irg::ray_casting<>{}, 1601, 18) == 0); }

// From 10,001 faces on, equal ones are looked for in a table; faces that differ must stay apart where they meet in it.
TEST_CASE(
    "ray_casting: of very many faces each is asked once, and those that differ in one number are not taken for equal") {
  constexpr int size = 3;
  test::random r(1602);
  test::face_list faces;
  // All differ in one number of one corner at most, so that it is each of these nine that tells those apart that meet.
  while (faces.size() < 12000) {
    std::array<irg::screen_vertex, 3> v{{{{-64, -64}, 0.5f}, {{1512, -64}, 0.25f}, {{-64, 1512}, 0.75f}}};
    irg::screen_vertex& changed = v[faces.size() % 3];
    const int by = static_cast<int>(r.integer(0, 1500));
    const auto which = r.integer(0, 2);
    if (which == 0) changed.position.x -= by;
    if (which == 1) changed.position.y -= by;
    if (which == 2) changed.depth += static_cast<float>(by) * 0x1p-20f;
    faces.push_back(irg::make_screen_face(v[0], v[1], v[2], static_cast<std::uint32_t>((faces.size() * 7919) % 12007)));
  }
  const auto tried = [&]<class Order>(Order) {
    // The faces that stay, by their corners, each with the number that is seen of equal ones.
    std::map<std::array<float, 9>, const irg::screen_face*> apart;
    for (const irg::screen_face& f : faces) {
      std::array<float, 9> key{};
      for (std::size_t i = 0; i < 3; ++i) {
        key[3 * i] = static_cast<float>(f.v[i].position.x), key[3 * i + 1] = static_cast<float>(f.v[i].position.y);
        key[3 * i + 2] = f.v[i].depth;
      }
      const auto [place, is_new] = apart.emplace(key, &f);
      const bool is_lower = f.number < place->second->number, is_last = irg::depth_sense<Order> == 0;
      if (!is_new && is_lower != is_last) place->second = &f;
    }
    irg::image<std::uint32_t> ids(size, size, irg::no_index);
    irg::draw_counts counts;
    irg::ray_casting<Order>{}(faces, irg::cell_window{0, 0, size, size}, ids, counts);
    long tested = 0;
    int wrong = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const irg::screen_face* seen = nullptr;
        for (const auto& [key, f] : apart) {
          if (!irg::covers(*f, x, y)) continue;
          ++tested;
          if (seen == nullptr || irg::is_nearer<Order>(*f, *seen, x, y)) seen = f;
        }
        wrong += ids(x, y) != (seen == nullptr ? irg::no_index : seen->number);
      }
    CHECK(wrong == 0);
    CHECK(static_cast<long>(counts.tested) == tested);
    CHECK(apart.size() < 10000);
    CHECK(apart.size() > 5000);
  };
  tried(irg::nearer_is_greater{});
  tried(irg::nearer_is_less{});
  tried(irg::drawing_order{});
}
