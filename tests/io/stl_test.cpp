// SPDX-License-Identifier: MIT
#include <irg/io/stl.hpp>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/mesh_files.hpp"
#include "support/random.hpp"

namespace {

using irg::mesh_encoding;
using irg::read_stl;
using test::as_text;

constexpr std::string_view triangle =
    "solid a b\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1e0 -0.5\n  endloop\n"
    " endfacet\nendsolid a b\n";

std::string outcome(std::string_view bytes) { return test::outcome_of(read_stl(bytes)); }
std::string with(std::string text, std::string_view word, std::string_view other) {
  return text.replace(text.find(word), word.size(), other);
}
std::string damaged(std::string_view word, std::string_view other) {
  return outcome(with(std::string(triangle), word, other));
}

/// A binary file of one triangle per three points, put together with memcpy; little-endian on every machine.
std::string binary(const std::vector<irg::point<float, 3>>& points) {
  test::byte_file f;
  f.bytes = std::string(80, 'h');
  f.reversed = std::endian::native == std::endian::big;
  f.put(static_cast<std::uint32_t>(points.size() / 3));
  for (std::size_t i = 0; i < points.size(); i += 3) {
    for (int k = 0; k < 3; ++k) f.put(std::numeric_limits<float>::quiet_NaN());  // a normal that nobody reads
    for (std::size_t k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c) f.put(points[i + k][c]);
    f.put(std::uint16_t{0x1234});
  }
  return f.bytes;
}

}  // namespace

TEST_CASE("stl: a triangle of text, at compile time, too") {
  CHECK_BOTH([] {
    const auto r = read_stl<float>(triangle);
    return r && r->positions == std::vector<irg::point<float, 3>>{{0, 0, 0}, {1, 0, 0}, {0, 1, -0.5f}} &&
           r->face_count() == 1 && r->corner(0, 2) == irg::mesh_corner{2} && r->normals.empty() &&
           r->parts.size() == 1 && r->parts[0].face_count == 1 && std::string_view(r->parts[0].object) == "a b";
  }());
  CHECK_BOTH([] {
    const auto r = read_stl("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 x\n");
    return !r && r.error().line == 5 && r.error().column == 12;
  }());
  CHECK_BOTH(!read_stl(""));
  CHECK_BOTH([] {  // infinity
    char bytes[134]{};
    bytes[80] = 1, bytes[98] = '\x80', bytes[99] = '\x7f';
    return read_stl(std::string_view(bytes, 134)).error().column == 97;
  }());
}

TEST_CASE("stl: the same triangle as bytes") {
  const auto r = read_stl(binary({{0, 0, 0}, {1, 0, 0}, {0, 1, -0.5f}}));
  REQUIRE(r);
  CHECK(r->positions == read_stl(triangle)->positions);
  CHECK(r->corners == read_stl(triangle)->corners);
  CHECK(r->parts.empty());
}

TEST_CASE("stl: equal positions are shared unless they are to stay apart") {
  const std::string two = binary({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(read_stl(two)->positions.size() == 4);
  CHECK(read_stl(two, {irg::stl_positions::separate})->positions.size() == 6);
  CHECK(read_stl(two)->corner(1, 0).position == 1);
}

TEST_CASE("stl: bytes are told from text by the length they state, whatever the head says") {
  std::string bytes = binary({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  bytes.replace(0, 12, "solid facet ");
  CHECK(read_stl(bytes)->face_count() == 1);
  bytes.pop_back();
  CHECK(outcome(bytes) == "0:82 byte 0 stands in text, and binary STL would have another length");
  // In bytes that are no text a byte order mark counts.
  CHECK(outcome("\xEF\xBB\xBF" + bytes) == "0:85 byte 0 stands in text, and binary STL would have another length");
  CHECK(outcome("\xEF\xBB\xBFno text") == "1:1 expected the word solid");
}

TEST_CASE("stl: several solids, names, case and odd blanks") {
  const std::string text =
      "\xEF\xBB\xBFSOLID \t first one \r\nFACET NORMAL -nan(ind) 1.#QNAN x\r\nOUTER LOOP\r\nVERTEX 0 0 0 VERTEX 1 0 0 "
      "VERTEX 0 1 0\r\nENDLOOP ENDFACET\r\nENDSOLID what ever\r\nsolid empty\rendsolid\rsolid\rfacet normal 0 0 0 "
      "outer "
      "loop vertex 0 0 0\nvertex 0 1\n0\tvertex 0 0 1 endloop endfacet endsolid";
  const auto r = read_stl(text);
  REQUIRE(test::outcome_of(r) == "");
  REQUIRE(r->parts.size() == 2);
  CHECK(std::string(r->parts[0].object) == "first one");
  CHECK(r->parts[1].object.empty());
  CHECK(r->positions.size() == 4);
  CHECK(read_stl("solid nothing\nendsolid nothing")->face_count() == 0);
  const auto unnamed = read_stl(with(with(std::string(triangle), "solid a b", "solid"), "endsolid a b", "endsolid"));
  CHECK(unnamed->parts.empty());
}

TEST_CASE("stl: what is wrong is said where it stands") {
  CHECK(outcome("") == "1:1 text has no word solid");
  CHECK(outcome(" \n ") == "2:2 text has no word solid");
  CHECK(outcome("v 0 0 0\n") == "1:1 expected the word solid");
  CHECK(outcome("# by hand\n" + std::string(triangle)) == "1:1 expected the word solid");
  CHECK(outcome("\n " + std::string(200, 'x')) == "2:2 expected the word solid");
  CHECK(outcome("\x01") == "0:2 file is too short for STL, or no STL at all");
  CHECK(outcome("v 0\x7f") == "0:5 file is too short for STL, or no STL at all");
  CHECK(outcome(std::string(80, 'x') + std::string("\0\0\0\1", 4)) ==
        "0:81 file is too short for the number of triangles that stands here");
  CHECK(outcome(std::string(80, 'x') + "\t\n\x0b\xff") == "1:1 expected the word solid");  // as a count 7 GiB and more
  CHECK(outcome("solid") == "1:6 text ends within a solid");
  CHECK(damaged("facet", "face") == "2:2 expected facet or endsolid");
  CHECK(damaged("normal", "norm") == "2:8 expected the word normal");
  CHECK(damaged("0 0 1", "0 1") == "2:18 normal has fewer than three numbers");
  CHECK(damaged("0 0 1", "0 0 1 1") == "2:21 expected outer loop");
  CHECK(damaged("outer loop", "outer") == "4:4 expected outer loop");
  CHECK(damaged("   vertex 1 0 0\n", "") == "6:3 expected the word vertex: a facet has three");
  CHECK(damaged("  endloop", "vertex 1 1 1\n endloop") == "7:1 expected endloop: a facet has three vertices");
  CHECK(damaged("endfacet", "facet") == "8:2 expected endfacet");
  CHECK(damaged("1e0", "1e999") == "6:13 number is too large");
  CHECK(damaged("1e0", "-inf") == "6:13 number is not finite");
  CHECK(damaged("1e0", "0x1") == "6:13 expected a decimal number");
  CHECK(outcome(std::string(triangle) + "x") == "10:1 expected the word solid");
  std::string bytes = binary({{0, 0, 0}, {1, std::numeric_limits<float>::infinity(), 0}, {0, 1, 0}});
  CHECK(outcome(bytes) == "0:" + std::to_string(84 + 12 + 16 + 1) + " number is not finite");
  CHECK(outcome(bytes + "x") == "0:81 file is too long for the number of triangles that stands here");
  bytes.pop_back();
  CHECK(outcome(bytes) == "0:81 file is too short for the number of triangles that stands here");
  bytes.replace(80, 4, "\xff\xff\xff\xff");
  CHECK(outcome(bytes) == "0:81 file is too short for the number of triangles that stands here");
}

TEST_CASE_TEMPLATE("stl: text that was written reads as the same mesh", T, float, double) {
  test::random r(sizeof(T));
  for (int trial = 0; trial < 100; ++trial) {
    irg::mesh<T> m = test::in_order_of_use(test::random_mesh<T>(r, 3, test::attributes::none));
    if (trial % 2 == 1) m.parts = {{"one two", {}, {}, 0, 1}, {"", {}, {}, 1, m.face_count() - 1}};
    if (trial % 2 == 1 && m.face_count() < 2) continue;
    const auto bytes = irg::encode_stl(m);
    REQUIRE(bytes);
    const auto again = read_stl<T>(as_text(*bytes));
    REQUIRE(again);
    CHECK(*again == m);
  }
}

TEST_CASE("stl: bytes that were written read as the same mesh, and memcpy makes the same ones") {
  test::random r(7);
  for (int trial = 0; trial < 100; ++trial) {
    const auto m = test::in_order_of_use(test::random_mesh<float>(r, 3, test::attributes::none));
    const auto bytes = irg::encode_stl(m, mesh_encoding::little_endian);
    REQUIRE(bytes);
    const auto again = read_stl<float>(as_text(*bytes));
    REQUIRE(again);
    CHECK(*again == m);
    std::vector<irg::point<float, 3>> points;
    for (const irg::mesh_corner& c : m.corners) points.push_back(m.positions[c.position]);
    const std::string by_hand = binary(points);
    REQUIRE(by_hand.size() == bytes->size());
    for (std::size_t f = 0; f < m.face_count(); ++f)
      CHECK(by_hand.substr(84 + 50 * f + 12, 36) == as_text(*bytes).substr(84 + 50 * f + 12, 36));
  }
}

TEST_CASE("stl: polygons are cut, normals written, doubles refused beyond float") {
  const auto bytes = irg::encode_stl(irg::shape_cube<float>(), mesh_encoding::little_endian);
  REQUIRE(bytes->size() == 84 + 50 * 12);
  const auto cube = read_stl<float>(as_text(*bytes));
  CHECK(cube->positions.size() == 8);
  const std::string text = as_text(*irg::encode_stl(irg::shape_cube<double>()));
  CHECK(text.find("facet normal 0 0 1\n") != text.npos);
  CHECK(text.starts_with("solid\nfacet normal "));

  irg::mesh<double> m = irg::shape_tetrahedron<double>();
  m.positions[1] = {0, 0, -3.4028235677973364e38};  // rounds to the largest float
  CHECK(irg::encode_stl(m, mesh_encoding::little_endian));
  m.positions[1] = {0, 0, -3.4028235677973366e38};
  CHECK(std::string(irg::encode_stl(m, mesh_encoding::little_endian).error().message) ==
        "position is too large for the 32-bit floats of binary STL");
  CHECK(irg::encode_stl(m));
  CHECK(!irg::encode_stl(m, mesh_encoding::big_endian));
  m.corners[2].position = 4;
  CHECK(std::string(irg::encode_stl(m).error().message) == "mesh has a corner without a position");
  CHECK(as_text(*irg::encode_stl(irg::mesh<float>{})) == "solid\nendsolid\n");
}

TEST_CASE("stl: damage is noticed or leaves a sound mesh") {
  const auto read = [](std::string_view s) { return read_stl<double>(s); };
  const std::string text = as_text(*irg::encode_stl(irg::shape_tetrahedron<double>()));
  CHECK(test::damage(text, read, 2000, 1) == static_cast<int>(text.size()) - 1);  // but for the last line feed
  const std::string bytes = as_text(*irg::encode_stl(irg::shape_tetrahedron<double>(), mesh_encoding::little_endian));
  CHECK(test::damage(bytes, read, 2000, 2) == static_cast<int>(bytes.size()));
}
