// SPDX-License-Identifier: MIT
#include <irg/io/obj_write.hpp>

#include <cstdint>
#include <string>
#include <string_view>

#include <irg/io/obj.hpp>
#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/mesh_files.hpp"
#include "support/random.hpp"

namespace {

using irg::encode_obj;
using test::as_text;

}  // namespace

TEST_CASE("obj_write: the text of a triangle, at compile time, too") {
  CHECK_BOTH([] {
    irg::mesh<float> m;
    m.positions = {{0, 0.5f, 1e-30f}, {1, 0, 0}, {-1, 2, 3}};
    m.texcoords = {{0.25f, 1}};
    m.normals = {{0, 0, 1}};
    m.corners = {{0, 0, 0}, {1, irg::no_index, 0}, {2, 0}, {0}, {1}, {2}};
    m.face_starts = {0, 3, 6};
    m.parts = {{"a b", "", "m", 0, 1}, {"a b", "g", "", 1, 1}};
    constexpr std::string_view expected =
        "v 0 0.5 1e-30\nv 1 0 0\nv -1 2 3\nvt 0.25 1\nvn 0 0 1\no a b\nusemtl m\nf 1/1/1 2/1 3//1\ng g\nusemtl\nf 1 2 "
        "3\n";
    const auto bytes = encode_obj(m);
    if (!bytes || bytes->size() != expected.size()) return false;
    for (std::size_t i = 0; i < expected.size(); ++i)
      if ((*bytes)[i] != static_cast<std::uint8_t>(expected[i])) return false;
    return true;
  }());
  CHECK_BOTH(encode_obj(irg::mesh<double>{})->empty());
}

TEST_CASE_TEMPLATE("obj_write: what was written reads as the same mesh", T, float, double) {
  test::random r(91 + sizeof(T));
  const char* const names[] = {"", "a", "two words", "c#1", "# d", "back\\", "\\\\", "x \\ y", "\xc3\xa9"};
  for (int trial = 0; trial < 200; ++trial) {
    irg::mesh<T> m =
        test::random_mesh<T>(r, 9, trial % 3 == 0 ? test::attributes::none : test::attributes::of_vertices);
    if (!m.normals.empty())
      for (irg::mesh_corner& c : m.corners) {
        const auto last = static_cast<std::int64_t>(m.normals.size()) - 1;
        c.normal = r.integer(0, 2) == 0 ? irg::no_index : static_cast<std::uint32_t>(r.integer(0, last));
        c.texcoord = r.integer(0, 2) == 0 ? irg::no_index : static_cast<std::uint32_t>(r.integer(0, last));
      }
    for (std::size_t f = 0; trial % 2 == 1 && f < m.face_count();) {
      irg::mesh_part p{names[r.integer(0, 8)], names[r.integer(0, 8)], names[r.integer(0, 8)], f, 0};
      const bool same = !m.parts.empty() && m.parts.back().object == p.object && m.parts.back().group == p.group &&
                        m.parts.back().material == p.material;
      if (same || (m.parts.empty() && p.object.empty() && p.group.empty() && p.material.empty())) continue;
      p.face_count = static_cast<std::size_t>(r.integer(1, 5));
      if (p.face_count > m.face_count() - f) p.face_count = m.face_count() - f;
      f += p.face_count;
      m.parts.push_back(p);
    }
    const auto bytes = encode_obj(m);
    REQUIRE(bytes);
    const auto again = irg::read_obj<T>(as_text(*bytes));
    REQUIRE(test::outcome_of(again) == "");
    CHECK(*again == m);
  }
}

TEST_CASE("obj_write: names cannot break out of their line") {
  irg::mesh<double> m = irg::shape_tetrahedron<double>();
  m.parts = {{"a\nf 9 9 9", "b\r", "c\\", 0, 4}};
  const auto again = irg::read_obj(as_text(*encode_obj(m)));
  REQUIRE(test::outcome_of(again) == "");
  CHECK(std::string(again->parts[0].object) == "a f 9 9 9");
  CHECK(std::string(again->parts[0].group) == "b");
  CHECK(std::string(again->parts[0].material) == "c\\");
  CHECK(again->face_count() == 4);
  m.face_starts.pop_back();
  CHECK(!encode_obj(m));
}
