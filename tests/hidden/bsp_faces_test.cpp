// SPDX-License-Identifier: MIT
#include <irg/hidden/bsp_faces.hpp>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

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
  test::id_image ids(4, 4, irg::no_index);
  irg::draw_bsp(ids, tree);
  CHECK(ids(0, 0) == 8999);
}

TEST_CASE("bsp_painter: the exact picture") { CHECK(test::differing_pixels(irg::bsp_painter<>{}, 1606, 18) == 0); }

namespace {

// A bowl over a lattice, convex without rounding, and a lid of one plane: triangles whose corners are multiples of
// `step`, moved by `offset`, both in 1/256 pixel.
std::vector<irg::screen_face> bowl(int cells, int step, int offset) {
  std::vector<irg::screen_face> faces;
  const auto deep = [&](int i, int j) { return static_cast<float>(i * i + i * j + j * j) * 0x1p-20f; };
  const auto add = [&](const auto& a, const auto& b, const auto& c) {
    faces.push_back(irg::make_screen_face(a, b, c, static_cast<std::uint32_t>(faces.size())));
  };
  for (int i = -cells; i < cells; ++i)
    for (int j = -cells; j < cells; ++j) {
      const auto at = [&](int x, int y) {
        return irg::screen_vertex{{(x + cells) * step + offset, (y + cells) * step + offset}, deep(x, y)};
      };
      add(at(i, j), at(i + 1, j), at(i, j + 1));
      add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return faces;
}
// A cone of slices seen from aside, snapped.
std::vector<irg::screen_face> cone(int slices, double width, double height) {
  std::vector<irg::screen_face> faces;
  const auto snapped = [&](double x, double y, double z) {
    return irg::screen_vertex{
        {static_cast<std::int32_t>(std::lround(256 * width * (0.5 + 0.4 * x))),
         static_cast<std::int32_t>(std::lround(256 * height * (0.5 + 0.4 * (0.9 * y + 0.4 * z))))},
        static_cast<float>(0.5 + 0.2 * (0.9 * z - 0.4 * y))};
  };
  const auto rim = [&](int i) {
    const double angle = 6.283185307179586 * i / slices;
    return snapped(std::cos(angle), std::sin(angle), -0.5);
  };
  for (int i = 0; i < slices; ++i)
    for (const double tip : {0.8, -0.5})
      faces.push_back(
          irg::make_screen_face(snapped(0, 0, tip), rim(i), rim(i + 1), static_cast<std::uint32_t>(faces.size())));
  return faces;
}

// The tree's pieces, where it draws the picture.
std::int64_t pieces_of(const std::vector<irg::screen_face>& faces, int width, int height) {
  const auto tree = irg::build_bsp(faces, irg::cell_window{0, 0, width, height});
  test::id_image ids(width, height, irg::no_index);
  irg::draw_bsp(ids, tree);
  for (int y = 0; y < height; y += 1 + height / 40)
    for (int x = 0; x < width; x += 1 + width / 60)
      if (ids(x, y) != irg::picture_face_at(faces, x, y).value_or(irg::no_index)) return -1;
  return tree.counts.pieces;
}

}  // namespace

TEST_CASE("bsp_of_faces: growth, a convex body makes no pieces, also where centres of pixels lie on its edges") {
  for (const int cells : {3, std::getenv("IRG_RELEASE_TIER") != nullptr ? 20 : 5})
    for (const int step : {512, 768, 700})
      for (const int offset : {0, 128}) {
        const auto faces = bowl(cells, step, offset);
        const int size = 2 * cells * step / 256 + 1;
        CHECK(pieces_of(faces, size, size) == static_cast<std::int64_t>(faces.size()));
      }
}

TEST_CASE("bsp_of_faces: growth, a fan that is convex but for rounding makes few pieces") {
  for (const int slices : {std::getenv("IRG_RELEASE_TIER") != nullptr ? 1000 : 32, 64}) {
    const auto faces = cone(slices, 1200, 800);
    const std::int64_t pieces = pieces_of(faces, 1200, 800);
    CHECK(pieces >= static_cast<std::int64_t>(faces.size()));
    CHECK(pieces <= static_cast<std::int64_t>(faces.size() + faces.size() / 8));
  }
}

namespace {

// Strips behind each other, all of which lean the same way.
std::vector<irg::screen_face> row(int strips) {
  std::vector<irg::screen_face> faces;
  for (int i = 0; i < strips; ++i) {
    const float depth = static_cast<float>(i) * 0x1p-20f;
    faces.push_back(irg::make_screen_face({{0, 0}, depth}, {{20000, 0}, depth + 0x1p-6f}, {{0, 20000}, depth + 0x1p-7f},
                                          static_cast<std::uint32_t>(i)));
  }
  return faces;
}
// Cones in each other.
std::vector<irg::screen_face> shells(int number) {
  std::vector<irg::screen_face> faces;
  for (int i = 0; i < number; ++i)
    for (irg::screen_face f : cone(32, 400.0 * (i + 1) / number, 300.0 * (i + 1) / number)) {
      f.number = static_cast<std::uint32_t>(faces.size());
      faces.push_back(f);
    }
  return faces;
}

}  // namespace

TEST_CASE("bsp_of_faces: growth, few parts are asked for their side one by one: bowls, cones, rows, shells") {
  const auto check = [](const std::string& name, const std::vector<irg::screen_face>& faces, int size, double most) {
    const irg::bsp_counts counts = irg::build_bsp(faces, irg::cell_window{0, 0, size, size}).counts;
    INFO(name, ": ", counts.faces, " faces, ", counts.pieces, " pieces, ", counts.asked, " asked");
    const double n = static_cast<double>(counts.pieces);
    CHECK(static_cast<double>(counts.asked) <= most * n * std::log2(n));
  };
  const bool many = std::getenv("IRG_RELEASE_TIER") != nullptr;
  for (const int n : {1000, many ? 100'000 : 8000}) {
    const int cells = static_cast<int>(std::sqrt(n / 8.0));
    check("bowl", bowl(cells, 512, 0), 4 * cells + 1, 2);
    check("row", row(n), 80, 1);
  }
  for (const int n : {64, many ? 2000 : 256}) check("cone", cone(n, 1200, 800), 1200, 40);
  for (const int n : {4, many ? 60 : 12}) check("shells", shells(n), 400, 40);
}

TEST_CASE("bsp_of_faces: faces through each other are cut where their planes cut them") {
  // Sheets that all stand on edge to each other along one line of the picture: each is cut once by those before it.
  std::vector<irg::screen_face> fan;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const float low = 0.25f + static_cast<float>(i) * 0x1p-9f, high = 0.75f - static_cast<float>(i) * 0x1p-9f;
    fan.push_back(irg::make_screen_face({{0, 0}, low}, {{8192, 0}, high}, {{0, 40000}, low}, i));
  }
  CHECK(pieces_of(fan, 32, 32) <= 80);
}
