// SPDX-License-Identifier: MIT
#include <irg/hidden/bsp_faces.hpp>

#include "method_scenes.hpp"
#include "support/check_both.hpp"

namespace {

irg::bsp_of_faces tree_of(test::face_scene kind, int n, int size) {
  test::face_scene_maker make(31, size);
  return irg::build_bsp(make(kind, n), irg::cell_window{0, 0, size, size});
}

}  // namespace

TEST_CASE("bsp_of_faces: one node for each face that nothing splits, in both orders of walking") {
  constexpr auto orders = [] {
    std::vector<irg::screen_face> faces;
    for (int i = 0; i < 5; ++i) {
      const float depth = 0.1f + 0.1f * static_cast<float>(i * 3 % 5);
      faces.push_back(irg::make_screen_face({{0, 0}, depth}, {{2048, 0}, depth}, {{0, 2048}, depth},
                                            static_cast<std::uint32_t>(i)));
    }
    const auto tree = irg::build_bsp(faces, irg::cell_window{0, 0, 4, 4});
    std::vector<std::uint32_t> back, front;
    walk_bsp(tree, irg::bsp_order::back_to_front, [&](const auto& n) { back.push_back(n.part.face->number); });
    walk_bsp(tree, irg::bsp_order::front_to_back, [&](const auto& n) { front.push_back(n.part.face->number); });
    return tree.counts.pieces == 5 && back == std::vector<std::uint32_t>{0, 2, 4, 1, 3} &&
           front == std::vector<std::uint32_t>{3, 1, 4, 2, 0};
  };
  CHECK_BOTH(orders());
  CHECK(irg::build_bsp(std::vector<irg::screen_face>{}, irg::cell_window{0, 0, 4, 4}).nodes.empty());
}

TEST_CASE("bsp_of_faces: parts of a face share no pixel and leave none out") {
  const auto tree = tree_of(test::face_scene::crossing, 12, 32);
  CHECK(tree.counts.pieces > tree.counts.faces);
  for (const auto& f : tree.faces)
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        int parts = 0;
        for (const auto& n : tree.nodes)
          parts += n.part.face == &f && x >= n.box.x_first && x < n.box.x_last && y >= n.box.y_first &&
                   y < n.box.y_last && covers(n.part, x, y);
        CHECK(parts == covers(f, x, y));
      }
}

TEST_CASE("bsp_of_faces: coplanar faces are not split; many parallel ones need no recursion") {
  const auto same = [] {
    std::vector<irg::screen_face> faces;
    for (std::uint32_t i = 0; i < 300; ++i) {
      const int x = static_cast<int>(i % 17) * 200, y = static_cast<int>(i % 13) * 250;
      const auto v = [&](int dx, int dy) {
        return irg::screen_vertex{{x + dx, y + dy},
                                  static_cast<float>((1 << 20) + 3 * (x + dx) - 5 * (y + dy)) * 0x1p-21f};
      };
      faces.push_back(irg::make_screen_face(v(0, 0), v(900, 100), v(50, 1200), i));
    }
    return faces;
  }();
  CHECK(irg::build_bsp(same, irg::cell_window{0, 0, 20, 20}).counts.pieces == 300);
  std::vector<irg::screen_face> parallel;
  for (std::uint32_t i = 0; i < 9000; ++i) {
    const float depth = static_cast<float>(i + 1) * 0x1p-14f;
    parallel.push_back(irg::make_screen_face({{0, 0}, depth}, {{900, 0}, depth}, {{0, 900}, depth}, i));
  }
  const auto tree = irg::build_bsp(parallel, irg::cell_window{0, 0, 4, 4});
  CHECK(tree.counts.pieces == 9000);
  CHECK(tree.counts.depth < 100);
  test::id_image ids(4, 4, irg::no_face);
  irg::draw_bsp(tree, ids);
  CHECK(ids(0, 0) == 8999);
}

TEST_CASE("bsp_painter: the exact picture") { CHECK(test::differing_pixels(irg::bsp_painter<>{}, 1606, 18) == 0); }
