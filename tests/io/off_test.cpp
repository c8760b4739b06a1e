// SPDX-License-Identifier: MIT
#include <irg/io/off.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/mesh_files.hpp"
#include "support/random.hpp"

namespace {

using irg::read_off;
using test::as_text;

constexpr std::string_view square = "OFF # by hand\n4 1 0\n0 0 0\n1 0 0\n\n1 1e0 0\n0 1 -0.5\n4 0 1 2 3\n";

std::string outcome(std::string_view bytes) { return test::outcome_of(read_off(bytes)); }
std::string damaged(std::string_view word, std::string_view other) {
  std::string text(square);
  return outcome(text.replace(text.find(word), word.size(), other));
}

std::string binary(std::string_view word, int colours) {
  test::byte_file f;
  f.bytes = std::string(word) + " BINARY\n";
  const int one = 1;
  f.reversed = *reinterpret_cast<const char*>(&one) == 1;
  f.put(std::int32_t{3}).put(std::int32_t{1}).put(std::int32_t{0});
  for (int v = 0; v < 3; ++v) {
    for (int c = 0; c < 3; ++c) f.put(static_cast<float>(v + c));
    if (word.find('N') != word.npos) f.put(0.0f).put(0.0f).put(static_cast<float>(v));
    if (word.find('C') != word.npos) f.put(0.1f).put(0.2f).put(0.3f).put(1.0f);
    if (word.find("ST") != word.npos) f.put(0.5f).put(static_cast<float>(v));
  }
  f.put(std::int32_t{3}).put(std::int32_t{2}).put(std::int32_t{1}).put(std::int32_t{0}).put(std::int32_t{colours});
  for (int i = 0; i < colours; ++i) f.put(1.0f);
  return f.bytes;
}

}  // namespace

TEST_CASE("off: a square of text, at compile time, too") {
  CHECK_BOTH([] {
    const auto r = read_off<float>(square);
    return r && r->positions == std::vector<irg::point<float, 3>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, -0.5f}} &&
           r->face_count() == 1 && r->face_size(0) == 4 && r->corner(0, 3) == irg::mesh_corner{3};
  }());
  CHECK_BOTH([] {
    const auto r = read_off("OFF\n1 1 0\n0 0 0\n3 0 0 1\n");
    return !r && r.error().line == 4 && r.error().column == 7;
  }());
}

TEST_CASE("off: normals, texture coordinates and colours of any length") {
  const auto r = read_off(
      "# made\nSTCNOFF\n3 1 3\n0 0 0 0 0 1 255 0 0 0.5 0.25\n1 0 0 0 1 0 1 1 1 1 0 1\n0 1 0 1 0 0 7 9\n"
      "3 0 1 2 255 255 0\n");
  REQUIRE(test::outcome_of(r) == "");
  CHECK(r->normals == std::vector<irg::vec<double, 3>>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
  CHECK(r->texcoords == std::vector<irg::vec<double, 2>>{{0.5, 0.25}, {0, 1}, {7, 9}});
  CHECK(r->corner(0, 1) == irg::mesh_corner{1, 1, 1});
  CHECK(read_off("COFF\n1 0 0\n0 0 0 1 0 0 1\n")->texcoords.empty());
  CHECK(read_off("STOFF 1 0 0 0 0 0 1 2")->texcoords[0] == irg::vec<double, 2>{1, 2});
}

namespace {

/// Where the numbers of a vertex stand, and how its colour is written.
struct vertex_lines {
  std::string_view word;  // the first of the file
  int colour = 0;         // how many numbers
  bool whole = true;      // of 255; otherwise shares of 1
  bool colour_first = false;
  int vertices_of_line = 1;
};

std::string lines_of(const irg::mesh<double>& m, const vertex_lines& how, test::random& r) {
  std::string s = std::string(how.word) + "\n# by hand\n" + std::to_string(m.positions.size()) + " " +
                  std::to_string(m.face_count()) + " 0\n\n";
  const auto put = [&](double x) {
    const auto whole = static_cast<std::int64_t>(x);
    s += x == static_cast<double>(whole) ? std::to_string(whole) : std::to_string(whole) + ".5";
    s += " ";
  };
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    const auto colour = [&] {
      for (int i = 0; i < how.colour; ++i)
        put(how.whole ? (i == 3 ? 255 : double(r.integer(0, 255))) : i == 3 ? 1 : 0.5);
    };
    for (int i = 0; i < 3; ++i) put(m.positions[v][i]);
    if (how.colour_first) colour();
    for (int i = 0; i < 3 && !m.normals.empty(); ++i) put(m.normals[v][i]);
    if (!how.colour_first) colour();
    for (int i = 0; i < 2 && !m.texcoords.empty(); ++i) put(m.texcoords[v][i]);
    if (static_cast<int>(v) % how.vertices_of_line == how.vertices_of_line - 1) s += "# a vertex\n";
  }
  s += "\n";
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    s += std::to_string(m.face_size(f));
    for (std::size_t k = 0; k < m.face_size(f); ++k) s += " " + std::to_string(m.corner(f, k).position);
    for (std::int64_t i = r.integer(0, 1) * 3; i > 0; --i) s += " 200";
    s += "\n";
  }
  return s;
}

/// Polygons over whole positions, with the normals of an axis and halves as texture coordinates where the word asks.
irg::mesh<double> lines_body(std::string_view word, test::random& r) {
  irg::mesh<double> m = test::random_mesh<double>(r, 6, test::attributes::of_vertices);
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    for (int i = 0; i < 3; ++i) m.positions[v][i] = double(r.integer(0, 300));
    m.normals[v] = {};
    m.normals[v][static_cast<int>(r.integer(0, 2))] = 1;
    m.texcoords[v] = {double(r.integer(0, 1)), 0.5};
  }
  for (irg::mesh_corner& c : m.corners) {
    if (word.find('N') == word.npos) c.normal = irg::no_index;
    if (word.find("ST") == word.npos) c.texcoord = irg::no_index;
  }
  if (word.find('N') == word.npos) m.normals.clear();
  if (word.find("ST") == word.npos) m.texcoords.clear();
  return m;
}

}  // namespace

TEST_CASE("off: colours of vertices are read past, whatever the first word says of them") {
  CHECK_BOTH([] {
    const auto r = read_off("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
    return r && r->face_count() == 1 && r->positions[1] == irg::point<double, 3>{1, 0, 0};
  }());
  CHECK_BOTH([] {  // as MeshLab writes it: the colour before the normal
    const auto r = read_off("NCOFF\n1 0 0\n1 2 3 0 0 9 255 0 -1 0\n");
    return r && r->normals[0] == irg::vec<double, 3>{0, -1, 0};
  }());
  test::random r(91);
  int read = 0;
  for (const char* word : {"OFF", "NOFF", "STOFF", "STNOFF", "COFF", "CNOFF", "NCOFF", "STCOFF", "STCNOFF", "NCSTOFF",
                           "CSTOFF", "NSTOFF", "STNCOFF"})
    for (const int colour : {0, 3, 4})
      for (const bool whole : {true, false})
        for (int trial = 0; trial < 12; ++trial) {
          const std::string_view w = word;
          const irg::mesh<double> m = lines_body(w, r);
          vertex_lines how{w, colour, whole};
          // Only with N before C, and four numbers of 255, may the colour stand first.
          how.colour_first = w.find("NC") != w.npos && colour == 4 && whole && trial % 2 == 0;
          const std::string text = lines_of(m, how, r);
          const auto got = read_off(text);
          INFO(text);
          REQUIRE(test::outcome_of(got) == "");
          CHECK(*got == m);
          ++read;
        }
  CHECK(read == 13 * 3 * 2 * 12);
}

TEST_CASE("off: two vertices on a line are no vertex with a colour") {
  test::random r(92);
  for (const char* word : {"OFF", "NOFF", "STOFF"})
    for (int trial = 0; trial < 60; ++trial) {
      const irg::mesh<double> m = lines_body(word, r);
      const auto got = read_off(lines_of(m, {word, 0, true, false, trial % 3 + 1}, r));
      REQUIRE(test::outcome_of(got) == "");
      CHECK(*got == m);
    }
  // Pentagons have six numbers, too: this one looks like eight vertices of six numbers up to the end of the text.
  const std::string pentagons =
      "OFF\n10 3 0\n0 0 0 1 0 0\n2 0 0 3 0 0\n4 0 0 5 0 0\n6 0 0 7 0 0\n8 0 0 9 0 0\n"
      "5 0 1 2 3 4\n5 5 6 7 8 9\n5 9 7 5 3 1\n";
  REQUIRE(outcome(pentagons) == "");
  CHECK(read_off(pentagons)->positions[9] == irg::point<double, 3>{9, 0, 0});
  CHECK(outcome("OFF\n4 1 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n4 0 1 2 4\n") ==
        "5:9 face index is not smaller than the number of vertices");
}

TEST_CASE("off: what is wrong beside a colour is said where it stands") {
  const std::string good = "OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n";
  const auto with = [&](std::string_view word, std::string_view other) {
    std::string text = good;
    return outcome(text.replace(text.rfind(word), word.size(), other));
  };
  CHECK(outcome(good) == "");
  CHECK(with("3 0 1 2", "3 0 1 3") == "6:7 face index is not smaller than the number of vertices");
  CHECK(with("3 0 1 2", "2 0 1") == "6:1 face has fewer than three corners");
  CHECK(with("0 0 255", "0 0 nan") == "5:11 number is not finite");
  CHECK(with("0 0 255", "0 0 1e999") == "5:11 number is too large");
  CHECK(with("0 0 255", "0 0 red") == "5:11 expected a decimal number");
  CHECK(with("1 0 0 0 255 0", "1 0 0 0 255") == "4:1 vertex has more or fewer numbers than the first one");
  CHECK(with("1 0 0 0 255 0", "1 0 0 0 255 0 255") == "4:1 vertex has more or fewer numbers than the first one");
  CHECK(with("3 0 1 2\n", "") == "6:1 text ends where a face is expected");
  CHECK(with("3 1 0", "4 1 0").find("more or fewer numbers") != std::string::npos);
  CHECK(with("3 0 1 2\n", "3 0 1 2\n3 0 1 2\n") == "7:1 text goes on after the last face");
  CHECK(outcome("COFF\n1 0 0\n0 0 0 nan 0 0\n") == "3:7 number is not finite");
  CHECK(outcome("NCOFF\n1 0 0\n0 0 0 0 0 1 2 3 4 5 6 7 8\n") ==
        "3:25 vertex has more numbers than a colour and a texture coordinate");
  CHECK(outcome("NNOFF\n1 0 0\n0 0 0 0 0 0\n") == "1:1 file does not begin with the word OFF");
  CHECK(outcome("N4COFF\n1 0 0\n0 0 0 0 0 0\n") == "1:1 points are not of three dimensions");
}

TEST_CASE("off: what writers do to the format") {
  CHECK(read_off("OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")->face_count() == 1);  // no white space
  CHECK(read_off("\xEF\xBB\xBFOFF\r\n3 1\r\n0 0 0 1 0 0\r0 1 0\r3 0 1 2")->face_count() == 1);  // no edges
  CHECK(read_off("OFF 0 0 0")->positions.empty());
}

TEST_CASE("off: bytes") {
  for (const char* word : {"OFF", "NOFF", "COFF", "STCNOFF"}) {
    const auto r = read_off(binary(word, 4));
    REQUIRE(test::outcome_of(r) == "");
    CHECK(r->positions[2] == irg::point<double, 3>{2, 3, 4});
    CHECK(r->corner(0, 0).position == 2);
    const bool all = std::string_view(word).size() > 4;
    if (all) CHECK(r->normals[2] == irg::vec<double, 3>{0, 0, 2});
    if (all) CHECK(r->texcoords[1] == irg::vec<double, 2>{0.5, 1});
  }
  const std::string bytes = binary("OFF", 0);
  const auto text_size = bytes.size();
  CHECK(outcome(bytes) == "");
  CHECK(outcome(bytes + "x") == "0:" + std::to_string(text_size + 1) + " file goes on after the last face");
  CHECK(outcome(binary("OFF", 5)) ==
        "0:" + std::to_string(text_size - 3) + " colour has fewer than no or more than four numbers");
}

TEST_CASE("off: what is wrong is said where it stands") {
  CHECK(outcome("") == "1:1 file does not begin with the word OFF");
  CHECK(outcome("OFFx 1 0 0") == "1:1 file does not begin with the word OFF");
  CHECK(outcome("4OFF 1 0 0") == "1:1 points are not of three dimensions");
  CHECK(outcome("nOFF 5 1 0 0") == "1:1 points are not of three dimensions");
  CHECK(outcome("OFF") == "1:4 text ends where a count is expected");
  CHECK(damaged("4 1 0", "-4 1 0") == "2:1 count is negative");
  CHECK(damaged("4 1 0", "4 x 0") == "2:3 expected a whole number");
  CHECK(damaged("4 1 0", "4 1 x") == "2:5 expected a whole number");
  CHECK(damaged("4 1 0", "99999999999999999999 1 0") == "9:1 text ends where a number is expected");
  CHECK(damaged("1e0", "1e999") == "6:3 number is too large");
  CHECK(damaged("1e0", "nan") == "6:3 number is not finite");
  CHECK_BOTH([] {  // infinity
    constexpr char bytes[] = "OFF BINARY\n\0\0\0\1\0\0\0\0\0\0\0\0\x7f\x80\0\0\0\0\0\0\0\0\0";
    return read_off(std::string_view(bytes, sizeof(bytes))).error().column == 24;
  }());
  CHECK(damaged("4 0 1 2 3", "2 0 1") == "8:1 face has fewer than three corners");
  CHECK(damaged("4 0 1 2 3", "4 0 1 2 4") == "8:9 face index is not smaller than the number of vertices");
  CHECK(damaged("4 0 1 2 3", "4 0 1 2 -1") == "8:9 index of a vertex is negative");
  CHECK(damaged("4 0 1 2 3", "4 0 1 2 3 red") == "8:11 expected a decimal number");
  CHECK(damaged("4 0 1 2 3\n", "4 0 1 2") == "8:8 text ends where a whole number is expected");
  CHECK(damaged("4 0 1 2 3\n", "") == "8:1 text ends where a face is expected");
  CHECK(outcome(std::string(square) + " x") == "9:2 text goes on after the last face");
  CHECK(outcome("STCOFF\n1 0 0\n0 0 0 1\n") == "3:8 vertex has no texture coordinate");
  CHECK(outcome("COFF\n1 0 0\n0 0 0 1 2 3 4 5 6 7\n") ==
        "3:19 vertex has more numbers than a colour and a texture coordinate");
}

TEST_CASE_TEMPLATE("off: what was written reads as the same mesh", T, float, double) {
  test::random r(31 + sizeof(T));
  for (int trial = 0; trial < 150; ++trial) {
    const auto which = trial % 2 == 0 ? test::attributes::none : test::attributes::of_vertices;
    const irg::mesh<T> m = test::random_mesh<T>(r, 6, which);
    const auto bytes = irg::encode_off(m);
    REQUIRE(bytes);
    const auto again = read_off<T>(as_text(*bytes));
    REQUIRE(test::outcome_of(again) == "");
    CHECK(*again == m);
  }
  irg::mesh<T> broken = irg::shape_cube<T>();
  broken.face_starts.back() = 3;
  CHECK(!irg::encode_off(broken));
}

TEST_CASE("off: a cloud of points keeps its normals and texture coordinates, if they are as many") {
  irg::mesh<double> cloud;
  cloud.positions = {{1, 2, 3}, {4, 5, 6}};
  cloud.normals = {{0, 0, 1}, {0, 1, 0}};
  cloud.texcoords = {{0.5, 1}, {0, 0.25}};
  const auto again = read_off<double>(as_text(*irg::encode_off(cloud)));
  REQUIRE(test::outcome_of(again) == "");
  CHECK(*again == cloud);
  cloud.normals.pop_back();
  const auto without = read_off<double>(as_text(*irg::encode_off(cloud)));
  REQUIRE(test::outcome_of(without) == "");
  CHECK(without->normals.empty());
  CHECK(without->texcoords == cloud.texcoords);
}

TEST_CASE("off: damage is noticed or leaves a sound mesh") {
  const auto read = [](std::string_view s) { return read_off<float>(s); };
  test::damage(std::string(square), read, 3000, 1);
  test::damage("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n", read, 6000, 3);
  test::damage("STNCOFF\n2 1 0\n0 0 0 25 0 0 255 0 1 0 7 8\n1 0 0 0 25 0 255 1 0 0 7 8\n3 0 1 0\n", read, 6000, 4);
  CHECK(test::damage(binary("STCNOFF", 3), read, 3000, 2) == static_cast<int>(binary("STCNOFF", 3).size()));
}
