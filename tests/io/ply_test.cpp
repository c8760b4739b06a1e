// SPDX-License-Identifier: MIT
#include <irg/io/ply.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/mesh_files.hpp"
#include "support/random.hpp"

namespace {

using irg::mesh_encoding;
using irg::read_ply;
using test::as_text;

constexpr mesh_encoding encodings[] = {mesh_encoding::text, mesh_encoding::little_endian, mesh_encoding::big_endian};

constexpr std::string_view square =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1e0 0\n0 1 -0.5\n4 0 1 2 3\n";

std::string outcome(std::string_view bytes) { return test::outcome_of(read_ply(bytes)); }
std::string with(std::string text, std::string_view word, std::string_view other) {
  return text.replace(text.find(word), word.size(), other);
}
std::string damaged(std::string_view word, std::string_view other) {
  return outcome(with(std::string(square), word, other));
}

/// A head for one vertex of odd properties, a strange element, two faces.
std::string odd_head(std::string_view format, std::string_view line_end = "\n") {
  const std::string_view lines[] = {"ply",
                                    "",
                                    "obj_info anything",
                                    "element strange 2",
                                    "property list ushort double a",
                                    "property char b",
                                    "element face 2",
                                    "property uchar red",
                                    "property list int16 uint8 vertex_index",
                                    "property list uint8 float32 texcoord",
                                    "element vertex 3",
                                    "property double z",
                                    "property uint y",
                                    "property short x",
                                    "property list char char tags",
                                    "property float ny",
                                    "property float nz",
                                    "property float nx",
                                    "property float64 u",
                                    "property int8 v",
                                    "element nothing 99999999999",
                                    "end_header"};
  std::string head;
  for (const std::string_view line : lines)
    head += (line.empty() ? "format " + std::string(format) + " 1.0" : std::string(line)) + std::string(line_end);
  return head;
}

std::string odd_bytes(bool big, std::string_view line_end) {
  test::byte_file f;
  f.bytes = odd_head(big ? "binary_big_endian" : "binary_little_endian", line_end);
  const int one = 1;
  f.reversed = (*reinterpret_cast<const char*>(&one) == 1) == big;
  f.put(std::uint16_t{2}).put(1.0).put(std::numeric_limits<double>::quiet_NaN()).put('x');
  f.put(std::uint16_t{0}).put('y');
  f.put(std::uint8_t{9}).put(std::int16_t{3}).put(std::uint8_t{2}).put(std::uint8_t{1}).put(std::uint8_t{0});
  f.put(std::uint8_t{1}).put(0.25f);
  f.put(std::uint8_t{9}).put(std::int16_t{4});
  for (const int v : {0, 1, 2, 1}) f.put(static_cast<std::uint8_t>(v));
  f.put(std::uint8_t{0});
  for (const int v : {0, 1, 2}) {
    f.put(1e-300 * v).put(std::uint32_t{4294967295u}).put(std::int16_t{-32768});
    f.put(std::int8_t{1}).put('t');
    f.put(0.5f).put(-1.0f).put(static_cast<float>(v)).put(1e300).put(std::int8_t{-7});
  }
  return f.bytes;
}

constexpr std::string_view odd_words =
    "2 1 nan 120\n0 121\n9 3 2 1 0 1 0.25 9 4 0 1 2 1\t0 \n"
    "0 4294967295 -32768 1 116 0.5 -1 0 1e300 -7\n1e-300 4294967295 -32768 1 116 0.5 -1 1 1e300 -7\n"
    "2e-300 4294967295 -32768 1 116 0.5 -1 2 1e300 -7";

/// A reader as strict as vcglib's, on which MeshLab stands, written for this test alone: elements vertex and face,
/// numbers of vertices float or double, one list whose two types are a pair that vcglib knows.
struct strict_ply {
  std::string refused = "";
  std::string count_type = "", index_type = "";
  std::vector<double> numbers{};  // of all vertices
  std::size_t numbers_of_vertex = 0;
  std::vector<std::vector<double>> faces{};

  explicit strict_ply(const std::string& bytes) {
    std::size_t at = 0, vertices = 0, face_count = 0;
    bool text = false, big = false;
    std::string vertex_type;
    for (std::string line; line != "end_header" && refused.empty();) {
      const std::size_t end = bytes.find('\n', at);
      line = bytes.substr(at, end - at);
      at = end + 1;
      const std::size_t last_blank = line.rfind(' ');
      const std::string last = line.substr(last_blank + 1), before = line.substr(0, last_blank);
      if (before == "element vertex") vertices = std::stoul(last);
      if (before == "element face") face_count = std::stoul(last);
      if (before == "property float" || before == "property double") {
        vertex_type = before.substr(9);
        ++numbers_of_vertex;
      }
      text = text || line == "format ascii 1.0";
      big = big || line == "format binary_big_endian 1.0";
      if (!before.starts_with("property list ")) continue;
      if (last != "vertex_indices") refused = "name of the list";
      const std::size_t middle = before.rfind(' ');
      count_type = before.substr(14, middle - 14);
      index_type = before.substr(middle + 1);
      const bool usual = count_type == "uchar" || count_type == "char" || count_type == "int";
      const bool whole = index_type == "int" || index_type == "uint" || index_type == "short";
      if (!(usual && whole) && !(count_type == "ushort" && index_type == "uint")) refused = "types of the list";
    }
    const auto next = [&](const std::string& type) -> double {
      if (text) {
        at = bytes.find_first_not_of(" \n", at);
        const std::size_t end = bytes.find_first_of(" \n", at);
        const double x = std::strtod(bytes.substr(at, end - at).c_str(), nullptr);
        at = end;
        return x;
      }
      const std::size_t size = type.ends_with("char") ? 1 : type.ends_with("short") ? 2 : type == "double" ? 8 : 4;
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < size; ++i)
        bits |= std::uint64_t{static_cast<std::uint8_t>(bytes.at(at + (big ? size - 1 - i : i)))} << (8 * i);
      at += size;
      if (type == "double") return std::bit_cast<double>(bits);
      if (type == "float") return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
      return type == "int" ? static_cast<std::int32_t>(bits) : static_cast<double>(bits);
    };
    if (!refused.empty()) return;
    for (std::size_t i = 0; i < vertices * numbers_of_vertex; ++i) numbers.push_back(next(vertex_type));
    for (std::size_t f = 0; f < face_count; ++f) {
      const auto corners = static_cast<std::size_t>(next(count_type));
      faces.push_back({});
      for (std::size_t k = 0; k < corners; ++k) faces.back().push_back(next(index_type));
    }
    if (bytes.find_first_not_of(" \n", text ? at : bytes.size()) != bytes.npos || (!text && at != bytes.size()))
      refused = "bytes left over";
  }
};

}  // namespace

TEST_CASE("ply: a square of text, at compile time, too") {
  CHECK_BOTH([] {
    const auto r = read_ply<float>(square);
    return r && r->positions == std::vector<irg::point<float, 3>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, -0.5f}} &&
           r->face_count() == 1 && r->face_size(0) == 4 && r->corner(0, 3) == irg::mesh_corner{3} && r->parts.empty();
  }());
  CHECK_BOTH([] {
    const auto r = read_ply("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n");
    return !r && r.error().line == 6 && r.error().column == 1;
  }());
  CHECK_BOTH([] {
    const char bytes[] =
        "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\nproperty short y\nproperty uchar z\n"
        "end_header\n\xff\x01\x02\xff";
    const auto r = read_ply<float>({bytes, sizeof bytes - 1});
    return r && r->positions == std::vector<irg::point<float, 3>>{{-1, 258, 255}};
  }());
}

TEST_CASE("ply: every type, lists, strange elements and properties, faces before vertices, in all forms") {
  const auto text = read_ply(odd_head("ascii") + std::string(odd_words));
  REQUIRE(test::outcome_of(text) == "");
  REQUIRE(text->positions.size() == 3);
  CHECK(text->positions[2] == irg::point<double, 3>{-32768, 4294967295.0, 2e-300});
  CHECK(text->normals[1] == irg::vec<double, 3>{1, 0.5, -1});
  CHECK(text->texcoords[0] == irg::vec<double, 2>{1e300, -7});
  REQUIRE(text->face_count() == 2);
  CHECK(text->corner(0, 0) == irg::mesh_corner{2, 2, 2});
  CHECK(text->corner(1, 3) == irg::mesh_corner{1, 1, 1});
  for (const char* line_end : {"\n", "\r\n", "\r"}) {
    CHECK(*read_ply(odd_head("ascii", line_end) + std::string(odd_words)) == *text);
    for (const bool big : {false, true}) {
      const auto r = read_ply(odd_bytes(big, line_end));
      REQUIRE(test::outcome_of(r) == "");
      CHECK(*r == *text);
    }
  }
}

TEST_CASE("ply: a header with lone carriage returns may be followed by the byte of a line feed") {
  std::string s =
      "ply\rformat binary_little_endian 1.0\relement vertex 1\rproperty uchar x\rproperty uchar y\rproperty uchar z\r"
      "end_header\r";
  s += "\n\r\n";
  CHECK(read_ply(s)->positions[0] == irg::point<double, 3>{10, 13, 10});
}

TEST_CASE("ply: what is not given is not there") {
  const auto cloud = read_ply(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\n"
      "property float nx\nproperty float s\nend_header\n1 2 3 nan nan\n");
  REQUIRE(test::outcome_of(cloud) == "");  // a normal by half is none, and not looked at
  CHECK(cloud->face_count() == 0);
  CHECK(cloud->normals.empty());
  CHECK(cloud->texcoords.empty());
  CHECK(read_ply("ply\nformat ascii 1.0\nelement vertex 0\nend_header\n")->positions.empty());
}

TEST_CASE("ply: only the pairs of the page are texture coordinates, and one pair is read") {
  // Four properties behind x, y and z; of which two the numbers are read is worked out from the page's list by hand.
  constexpr std::string_view pairs[][2] = {
      {"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};
  std::vector<std::string_view> names;
  for (const auto& pair : pairs)
    for (const std::string_view name : pair) names.push_back(name);
  const auto file = [&](const std::vector<std::size_t>& which, bool bad) {
    std::string s = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
    for (const std::size_t i : which) s += "property float " + std::string(names[i]) + "\n";
    s += "end_header\n0 0 0";
    for (const std::size_t i : which) s += bad ? " nan" : " " + std::to_string(i);
    return s + "\n";
  };
  for (std::size_t a = 0; a < names.size(); ++a)
    for (std::size_t b = 0; b < names.size(); ++b) {
      if (a == b) continue;
      const bool belong = a / 2 == b / 2;
      const auto r = read_ply(file({a, b}, false));
      REQUIRE(test::outcome_of(r) == "");
      CHECK(r->texcoords.size() == (belong ? 1 : 0));
      if (belong) CHECK(r->texcoords[0] == irg::vec<double, 2>{double(a / 2 * 2), double(a / 2 * 2 + 1)});
      CHECK((outcome(file({a, b}, true)) == "") == !belong);  // what is passed over may be anything
    }
  std::vector<std::size_t> order = {0, 1, 2, 3, 4, 5, 6, 7};
  test::random r(77);
  for (int trial = 0; trial < 200; ++trial) {
    for (std::size_t i = order.size() - 1; i > 0; --i)
      std::swap(order[i], order[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(i)))]);
    const std::vector<std::size_t> some(order.begin(), order.begin() + r.integer(0, 8));
    const auto has = [&](std::size_t i) { return std::find(some.begin(), some.end(), i) != some.end(); };
    std::vector<irg::vec<double, 2>> expected;
    for (std::size_t pair = 0; pair < 8 && expected.empty(); pair += 2)
      if (has(pair) && has(pair + 1)) expected = {{double(pair), double(pair + 1)}};
    const auto cloud = read_ply(file(some, false));
    REQUIRE(test::outcome_of(cloud) == "");
    CHECK(cloud->texcoords == expected);
  }
  CHECK_BOTH([] {
    const auto two = read_ply(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int s\nproperty int x\nproperty int y\nproperty int u\n"
        "property int z\nproperty int v\nend_header\n9 1 2 4 3 5\n");
    return two && two->texcoords == std::vector<irg::vec<double, 2>>{{4, 5}};
  }());
}

TEST_CASE("ply: single letters and colours have no role but their own") {
  const auto cloud = read_ply(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty int r\nproperty int x\nproperty int g\nproperty int y\n"
      "property int b\nproperty int z\nproperty int a\nproperty float n\nproperty float w\nproperty float nx\n"
      "property float normal_y\nproperty float nz\nproperty uchar red\nproperty uchar red\nproperty int X\n"
      "property list uchar int u\nproperty int v\nend_header\n7 1 7 2 7 3 7 nan nan nan nan inf 300 - 7 1 7 7\n");
  REQUIRE(test::outcome_of(cloud) == "");
  CHECK(cloud->positions == std::vector<irg::point<double, 3>>{{1, 2, 3}});
  CHECK(cloud->normals.empty());
  CHECK(cloud->texcoords.empty());
  // Both names of the list of corners: the page's first counts, wherever it stands.
  for (const bool first : {true, false}) {
    const std::string lists[] = {"property list uchar int vertex_indices\n", "property list uchar int vertex_index\n"};
    std::string s = with(std::string(square), lists[0], lists[first ? 0 : 1] + lists[first ? 1 : 0]);
    s = with(s, "4 0 1 2 3", first ? "4 0 1 2 3 1 -5" : "1 -5 4 0 1 2 3");
    const auto both = read_ply(s);
    REQUIRE(test::outcome_of(both) == "");
    CHECK(both->face_size(0) == 4);
  }
  CHECK(outcome(with(std::string(square), "property float z\n",
                     "property float z\nproperty int s\nproperty int s\n")) == "9:1 property stands there twice");
}

TEST_CASE("ply: what is wrong is said where it stands") {
  CHECK(outcome("") == "1:1 file does not begin with the word ply");
  CHECK(outcome("\xEF\xBB\xBFplyx\n") == "1:1 file does not begin with the word ply");
  CHECK(outcome("ply x\n") == "1:5 expected the end of the line");
  CHECK(outcome("ply\n") == "2:1 expected the format in the second line");
  CHECK(outcome("ply\n form ascii 1.0\n") == "2:2 expected the format in the second line");
  CHECK(damaged("ascii", "text") == "2:8 format is none of ascii and the two binary ones");
  CHECK(damaged("1.0", "2.0") == "2:14 version of the format is not 1.0");
  CHECK(damaged("comment", "remark") == "3:1 expected element, property or end_header");
  CHECK(damaged("vertex 4", "vertex") == "4:15 element has no count");
  CHECK(damaged("vertex 4", "vertex -4") == "4:16 count of an element is negative");
  CHECK(damaged("vertex 4", "vertex four") == "4:16 expected a whole number");
  CHECK(damaged("element vertex 4", "element") == "4:8 element has no name");
  CHECK(damaged("element vertex 4\n", "") == "4:1 property stands before the first element");
  CHECK(damaged("element face 1", "element vertex 1") == "8:9 element stands there twice");
  CHECK(damaged("element face 1", "element tristrips 1") == "8:9 strips of triangles are not read");
  CHECK(damaged("float x", "real x") == "5:10 expected the type of a number");
  CHECK(damaged("float x", "float") == "5:15 property has no name");
  CHECK(damaged("float y", "float x") == "6:1 property stands there twice");
  CHECK(damaged("float y", "float w") == "11:1 vertices have no x, y and z");
  CHECK(damaged("list uchar int", "list float int") == "9:1 length of a list is no whole number");
  CHECK(damaged("list uchar int", "list uchar float") == "9:1 indices are no whole numbers");
  CHECK(damaged("vertex_indices", "indices") == "11:1 faces have no list vertex_indices");
  CHECK(damaged("element vertex 4", "element vert 4") == "11:1 there is no element vertex");
  CHECK(damaged("end_header\n0", "end_headr\n0") == "10:1 expected element, property or end_header");
  CHECK(damaged("1e0", "1e999") == "13:3 number is too large");
  CHECK(damaged("1e0", "inf") == "13:3 number is not finite");
  CHECK_BOTH([] {  // NaN
    constexpr char bytes[] =
        "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
        "end_header\n\x7f\xc0\0\0\0\0\0\0\0\0\0";
    return read_ply(std::string_view(bytes, sizeof(bytes))).error().column == sizeof(bytes) - 11;
  }());
  CHECK(damaged("1e0", "1,0") == "13:3 expected a decimal number");
  CHECK(damaged("4 0 1 2 3", "2 0 1") == "15:1 face has fewer than three corners");
  CHECK(damaged("4 0 1 2 3", "-4 0 1 2 3") == "15:1 length of a list is negative");
  CHECK(damaged("4 0 1 2 3", "4 0 1 2 4") == "15:9 face index is not smaller than the number of vertices");
  CHECK(damaged("4 0 1 2 3", "4 0 1 2 99999999999999999999") ==
        "15:9 face index is not smaller than the number of vertices");
  CHECK(damaged("4 0 1 2 3", "4 0 1 2 -1") == "15:9 index of a vertex is negative");
  CHECK(damaged("4 0 1 2 3", "4 0 1 2.0 3") == "15:7 expected a whole number");
  CHECK(damaged("4 0 1 2 3\n", "4 0 1 2") == "15:8 text ends where a whole number is expected");
  CHECK(damaged("4 0 1 2 3", "99999999999 0 1 2") == "15:1 list is longer than the file");
  CHECK(damaged("4 0 1 2 3", "4 0 1 2 3 5") == "15:11 file goes on after the last element");
  const std::string bytes = odd_bytes(true, "\n");
  const std::size_t head = odd_head("binary_big_endian").size();
  CHECK(outcome(bytes + "z") == "0:" + std::to_string(bytes.size() + 1) + " file goes on after the last element");
  CHECK(outcome(bytes.substr(0, head + 20)) ==
        "0:" + std::to_string(head + 21) + " file ends where a number is expected");
  CHECK(test::outcome_of(read_ply<float>(bytes)).find("number is too large") != std::string::npos);
}

TEST_CASE_TEMPLATE("ply: what was written reads as the same mesh", T, float, double) {
  test::random r(11 + sizeof(T));
  for (int trial = 0; trial < 90; ++trial) {
    const auto which = trial % 2 == 0 ? test::attributes::none : test::attributes::of_vertices;
    const irg::mesh<T> m = test::random_mesh<T>(r, 6, which);
    for (const mesh_encoding e : encodings) {
      const auto bytes = irg::encode_ply(m, e);
      REQUIRE(bytes);
      const auto again = read_ply<T>(as_text(*bytes));
      REQUIRE(test::outcome_of(again) == "");
      CHECK(*again == m);
    }
  }
}

TEST_CASE_TEMPLATE("ply: a strict reader takes what is written, for it finds the types that it knows", T, float,
                   double) {
  test::random r(51 + sizeof(T));
  for (int trial = 0; trial < 60; ++trial) {
    const auto which = trial % 2 == 0 ? test::attributes::none : test::attributes::of_vertices;
    irg::mesh<T> m = test::random_mesh<T>(r, 6, which);
    const bool many = trial % 4 > 1;
    if (many) {  // a face of as many corners as a byte counts, and one more
      const int corners = trial % 8 < 4 ? 255 : 256;
      for (int k = 0; k < corners; ++k) m.corners.push_back(m.corners[static_cast<std::size_t>(k) % 3]);
      m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
    }
    const bool beyond_a_byte = many && trial % 8 >= 4;
    for (const mesh_encoding e : encodings) {
      const strict_ply read(as_text(*irg::encode_ply(m, e)));
      REQUIRE(read.refused == "");
      CHECK(read.count_type == (beyond_a_byte ? "int" : "uchar"));
      CHECK(read.index_type == "int");
      const bool has = which == test::attributes::of_vertices;
      REQUIRE(read.numbers_of_vertex == (has ? 8 : 3));
      std::vector<double> numbers;
      for (std::size_t v = 0; v < m.positions.size(); ++v) {
        for (int i = 0; i < 3; ++i) numbers.push_back(static_cast<double>(m.positions[v][i]));
        for (int i = 0; has && i < 3; ++i) numbers.push_back(static_cast<double>(m.normals[v][i]));
        for (int i = 0; has && i < 2; ++i) numbers.push_back(static_cast<double>(m.texcoords[v][i]));
      }
      // A strict reader's text may round a float twice.
      if (e != mesh_encoding::text || sizeof(T) == 8) CHECK(read.numbers == numbers);
      REQUIRE(read.faces.size() == m.face_count());
      for (std::size_t f = 0; f < m.face_count(); ++f) {
        REQUIRE(read.faces[f].size() == m.face_size(f));
        for (std::size_t k = 0; k < m.face_size(f); ++k) CHECK(read.faces[f][k] == m.corner(f, k).position);
      }
      const auto again = read_ply<T>(as_text(*irg::encode_ply(m, e)));
      REQUIRE(test::outcome_of(again) == "");
      CHECK(*again == m);
    }
  }
}

TEST_CASE("ply: the types of lists at the ends of their ranges") {
  using irg::detail::ply_lists_of;
  using irg::detail::ply_type;
  CHECK_BOTH(ply_lists_of(255, 3).count == ply_type::uint8);
  CHECK_BOTH(ply_lists_of(256, 3).count == ply_type::int32);
  CHECK_BOTH(ply_lists_of(0x7fffffff, 3).count == ply_type::int32);
  CHECK_BOTH(ply_lists_of(0x80000000, 3).count == ply_type::uint32);
  CHECK_BOTH(ply_lists_of(0, 0).index == ply_type::int32);
  CHECK_BOTH(ply_lists_of(3, 0x80000000).index == ply_type::int32);  // the last index is one less
  CHECK_BOTH(ply_lists_of(3, 0x80000001).index == ply_type::uint32);
}

TEST_CASE("ply: corners that differ split their vertex, and keep what they name") {
  irg::mesh<float> m = irg::shape_cube<float>();
  m.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 0; k < m.face_size(f); ++k)
      m.corners[m.face_starts[f] + k].normal = static_cast<std::uint32_t>(f % 3);
  m.texcoords = {{0.5f, 0.25f}};
  m.corners[0].texcoord = 0;  // one alone is left out
  m.positions.push_back({7, 7, 7});
  for (const mesh_encoding e : encodings) {
    const auto again = read_ply<float>(as_text(*irg::encode_ply(m, e)));
    REQUIRE(test::outcome_of(again) == "");
    REQUIRE(again->corners.size() == m.corners.size());
    CHECK(again->texcoords.empty());
    CHECK(again->positions.size() == 8 * 3 + 1);
    for (std::size_t i = 0; i < m.corners.size(); ++i) {
      CHECK(again->positions[again->corners[i].position] == m.positions[m.corners[i].position]);
      CHECK(again->normals[again->corners[i].normal] == m.normals[m.corners[i].normal]);
    }
  }
  m.positions[0][1] = std::numeric_limits<float>::quiet_NaN();
  CHECK(std::string(irg::encode_ply(m).error().message) == "mesh has a position that is not finite");
}

TEST_CASE("ply: a cloud of points keeps its normals and texture coordinates, if they are as many") {
  irg::mesh<double> cloud;
  cloud.positions = {{1, 2, 3}, {4, 5, 6}};
  cloud.normals = {{0, 0, 1}, {0, 1, 0}};
  cloud.texcoords = {{0.5, 1}, {0, 0.25}};
  const auto again = read_ply<double>(as_text(*irg::encode_ply(cloud)));
  REQUIRE(test::outcome_of(again) == "");
  CHECK(*again == cloud);
  cloud.normals.pop_back();
  const auto without = read_ply<double>(as_text(*irg::encode_ply(cloud)));
  REQUIRE(test::outcome_of(without) == "");
  CHECK(without->normals.empty());
  CHECK(without->texcoords == cloud.texcoords);
}

TEST_CASE("ply: damage is noticed or leaves a sound mesh") {
  const auto read = [](std::string_view s) { return read_ply<float>(s); };
  test::damage(std::string(square), read, 3000, 1);
  test::damage(odd_bytes(false, "\r\n"), read, 3000, 2);
  const std::string bytes = as_text(*irg::encode_ply(irg::shape_cube<float>(), mesh_encoding::big_endian));
  CHECK(test::damage(bytes, read, 3000, 3) == static_cast<int>(bytes.size()));
}
