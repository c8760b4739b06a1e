// SPDX-License-Identifier: MIT
#include <irg/io/obj.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <locale.h>
#include <new>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/mesh/validate.hpp>

#include "io/memory_in_use.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

// Every byte that this program asks for and gives back is counted, so that the reader's memory can be bounded.
namespace {

using irg::read_obj;
using text = std::string_view;
using mesh = irg::mesh<double>;

constexpr text square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string with_square(text s) { return std::string(square) + std::string(s); }

/// Runs the tasks from the last to the first.
struct from_the_end {
  template <class Task>
  void operator()(std::size_t count, Task&& task) const {
    for (std::size_t i = count; i > 0; --i) task(i - 1);
  }
};

/// A text cut into pieces of so many bytes is read if and only if it is without a cut, and to the same mesh.
template <class T, class E>
void check_pieces(text s, irg::obj_options options, std::size_t bytes, const E& executor) {
  CAPTURE(bytes);
  const auto whole = read_obj<T>(s, options);
  s = irg::detail::without_byte_order_mark(s);
  irg::detail::obj_pieces<T> pieces(s, options.unused, bytes);
  REQUIRE(pieces.read(executor) == whole.has_value());
  if (whole) REQUIRE(pieces.whole.content.made == *whole);
}

/// The error as "line:column message", or "" for a mesh. A mesh must be sound in every way that can be checked.
std::string outcome(text s, irg::obj_options options = {}) {
  const auto r = read_obj(s, options);
  if (s.size() > 2 && s.size() < 4000 && !s.starts_with("\xFF\xFE") && !s.starts_with("\xFE\xFF"))
    check_pieces<double>(s, options, s.size() / 3 + 1, from_the_end{});
  if (r) {
    REQUIRE(irg::validate(*r) == irg::mesh_finding{});
    const mesh triangles = irg::triangulated(*r);
    REQUIRE(irg::validate(triangles) == irg::mesh_finding{});
    REQUIRE(triangles.face_count() == r->corners.size() - 2 * r->face_count());
    return "";
  }
  REQUIRE((r.error().line >= 1) == (r.error().column >= 1));  // 0:0: the whole text is meant
  REQUIRE(std::string_view(r.error().message).size() > 10);
  return std::to_string(r.error().line) + ":" + std::to_string(r.error().column) + " " + r.error().message;
}

/// The mesh of a text that must have one.
mesh of(text s) {
  const std::string problem = outcome(s);
  INFO(problem);
  REQUIRE(problem.empty());
  return *read_obj(s);
}

std::vector<std::uint32_t> face(const mesh& m, std::size_t f) {
  std::vector<std::uint32_t> indices;
  for (std::size_t k = 0; k < m.face_size(f); ++k) indices.push_back(m.corner(f, k).position);
  return indices;
}
using indices = std::vector<std::uint32_t>;

/// The sizes of the faces of a text, or -1 for an error: what constant evaluation compares.
constexpr int corner_count(text s) {
  const auto r = read_obj(s);
  return r ? static_cast<int>(r->corners.size()) : -1;
}
constexpr bool fails_at(text s, std::size_t line, std::size_t column) {
  const auto r = read_obj(s);
  return !r && r.error().line == line && r.error().column == column;
}

constexpr std::uint32_t none = irg::no_index;

}  // namespace

TEST_CASE("obj: a triangle by hand, at compile time, too") {
  CHECK_BOTH([] {
    const auto r = read_obj<float>(
        "# a comment\nv 0.5 -1 2e1\nv 1 0 0\nv 0 1 0\nvt 0.25 0.75\nvn 0 0 1\nf 1/1/1 2//1 3/1 4\nv 7 8 9\n");
    const std::uint32_t nothing = irg::no_index;
    return r && r->positions.size() == 4 && r->positions[0] == irg::point<float, 3>{0.5f, -1, 20} &&
           r->positions[3] == irg::point<float, 3>{7, 8, 9} && r->normals.size() == 1 &&
           r->normals[0] == irg::vec<float, 3>{0, 0, 1} && r->texcoords[0] == irg::vec<float, 2>{0.25f, 0.75f} &&
           r->face_count() == 1 && r->face_size(0) == 4 && r->corner(0, 0) == irg::mesh_corner{0, 0, 0} &&
           r->corner(0, 1) == irg::mesh_corner{1, 0, nothing} && r->corner(0, 2) == irg::mesh_corner{2, nothing, 0} &&
           r->corner(0, 3) == irg::mesh_corner{3, nothing, nothing};
  }() == true);
}

TEST_CASE("obj: negative indices count back from what was read so far") {
  const mesh m =
      of("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\nv 1 1 0\nvn 1 0 0\nf -3//-1 "
         "-1//-1 -2//-1\n");
  CHECK(face(m, 0) == indices{0, 1, 2});
  CHECK(face(m, 1) == indices{1, 3, 2});
  CHECK(m.corner(0, 0) == irg::mesh_corner{0, 0, 0});
  CHECK(m.corner(1, 0) == irg::mesh_corner{1, 1, none});
  CHECK_BOTH(corner_count("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1") == 3);
}

TEST_CASE("obj: negative indices that reach too far") {
  CHECK(outcome("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -4\n") ==
        "4:9 negative vertex index reaches back beyond the first vertex");
  CHECK(outcome("f -1 -1 -1") == "1:3 negative vertex index reaches back beyond the first vertex");
  CHECK(outcome("v 0 0 0\nf -2147483648 1 1") == "2:3 negative vertex index reaches back beyond the first vertex");
  CHECK(outcome("v 0 0 0\nf 1/-1 1 1") == "2:5 negative texture coordinate index reaches back beyond the first one");
  CHECK(outcome("v 0 0 0\nf 1//-1 1 1") == "2:6 negative normal index reaches back beyond the first normal");
  CHECK(outcome("v 0 0 0\nf 1 1 -99999999999999999999\n") ==
        "2:7 negative vertex index reaches back beyond the first vertex");
  CHECK(outcome("v 0 0 0\nf -1 -1 -2\nv 0 0 0") == "2:9 negative vertex index reaches back beyond the first vertex");
}

TEST_CASE("obj: index 0") {
  CHECK(outcome(with_square("f 1 2 0")) == "5:7 vertex index is 0, but indices count from 1");
  CHECK(outcome(with_square("f 1 2 -0")) == "5:7 vertex index is 0, but indices count from 1");
  CHECK(outcome(with_square("vt 0 0\nf 1/0 2 3")) == "6:5 texture coordinate index is 0, but indices count from 1");
  CHECK(outcome(with_square("vn 0 0 1\nf 1//0 2 3")) == "6:6 normal index is 0, but indices count from 1");
  CHECK_BOTH(fails_at("v 0 0 0\nf 1 0 1", 2, 5));
}

TEST_CASE("obj: indices beyond every integer") {
  for (const char* big : {"99999999999", "4294967295", "4294967296", "4294967297", "18446744073709551617",
                          "9223372036854775808", "99999999999999999999999999999999999999999999"}) {
    INFO(std::string(big));
    const std::string i = big;
    CHECK(outcome(with_square("f 1 2 " + i)) == "5:7 face index is larger than the number of vertices");
    CHECK(outcome(with_square("vt 0\nf 1 2 3/" + i)) ==
          "6:9 texture coordinate index is larger than the number of texture coordinates");
    CHECK(outcome(with_square("f 1 2 3//" + i)) == "5:10 normal index is larger than the number of normals");
  }
}

TEST_CASE("obj: indices out of range") {
  CHECK(outcome(with_square("f 1 2 9")) == "5:7 face index is larger than the number of vertices");
  CHECK(outcome(with_square("f 1 2 5")) == "5:7 face index is larger than the number of vertices");
  CHECK(outcome(with_square("f 1 2 4")).empty());
  CHECK(outcome(with_square("f 1/1 2 3")) ==
        "5:5 texture coordinate index is larger than the number of texture coordinates");
  CHECK(outcome(with_square("f 1//1 2 3")) == "5:6 normal index is larger than the number of normals");
  CHECK(outcome(with_square("f 1 2 3\n  f 1 2 3\nf 1 7 8\nf 9 9 9")) ==
        "7:5 face index is larger than the number of vertices");
  CHECK_BOTH(fails_at("v 0 0 0\nf 1 1 2", 2, 7));
}

TEST_CASE("obj: forms of face corners") {
  const std::string data = with_square("vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 0 -1\n");
  const auto corners = [&](std::string_view s) { return of(data + "f " + std::string(s)).corners; };
  using list = std::vector<irg::mesh_corner>;
  CHECK(corners("1 2 3") == list{{0, none, none}, {1, none, none}, {2, none, none}});
  CHECK(corners("1/1 2/2 3/1") == list{{0, none, 0}, {1, none, 1}, {2, none, 0}});
  CHECK(corners("1//1 2//2 3//1") == list{{0, 0, none}, {1, 1, none}, {2, 0, none}});
  CHECK(corners("1/1/2 2/2/1 3/1/2") == list{{0, 1, 0}, {1, 0, 1}, {2, 1, 0}});
  CHECK(corners("1 2/2 3//1 4/1/2") == list{{0, none, none}, {1, none, 1}, {2, 0, none}, {3, 1, 0}});
  CHECK(corners("1/ 2// 3/1/") == list{{0, none, none}, {1, none, none}, {2, none, 0}});
  CHECK(corners("+1 02 003") == corners("1 2 3"));
  const std::string not_a_corner = "9:3 face corner is none of the forms 1, 1/2, 1//3 and 1/2/3";
  CHECK(outcome(data + "f 1/1/1/1 2 3") == not_a_corner);
  CHECK(outcome(data + "f 1/// 2 3") == "9:6 expected the index of a normal");
  CHECK(outcome(data + "f 1.5 2 3") == not_a_corner);
  CHECK(outcome(data + "f 1# 2 3") == not_a_corner);
  CHECK(outcome(data + "f 1x 2 3") == not_a_corner);
  CHECK(outcome(data + "f 1/x 2 3") == "9:5 expected the index of a texture coordinate");
  CHECK(outcome(data + "f 1/1/x 2 3") == "9:7 expected the index of a normal");
  CHECK(outcome(data + "f 1//x 2 3") == "9:6 expected the index of a normal");
  CHECK(outcome(data + "f /1 2 3") == "9:3 expected the index of a vertex");
  CHECK(outcome(data + "f / 2 3") == "9:3 expected the index of a vertex");
  CHECK(outcome(data + "f 1 / 2 3") == "9:5 expected the index of a vertex");
}

TEST_CASE("obj: faces that are none") {
  CHECK(outcome(with_square("f a b c")) == "5:3 expected the index of a vertex");
  CHECK(outcome(with_square("f")) == "5:1 face has fewer than three corners");
  CHECK(outcome(with_square("f 1 2")) == "5:1 face has fewer than three corners");
  CHECK(outcome(with_square("f 1")) == "5:1 face has fewer than three corners");
  CHECK(outcome(with_square("\tf # 1 2 3")) == "5:2 face has fewer than three corners");
  CHECK(outcome(with_square("f - - -")) == "5:3 expected the index of a vertex");
}

TEST_CASE("obj: forward references are legal, and checked at the end") {
  CHECK(of("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0").face_count() == 1);
  CHECK(outcome("f 1 2 3\nf 1 2 4\nf 2 3 5\nv 0 0 0\nv 1 0 0\nv 0 1 0") ==
        "2:7 face index is larger than the number of vertices");
  CHECK(outcome("f 1/2 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1") ==
        "1:5 texture coordinate index is larger than the number of texture coordinates");
  CHECK_BOTH(corner_count("f 1//1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 1 1") == 3);
  CHECK_BOTH(fails_at("f 1 2 3\nv 0 0 0\nv 1 0 0\n", 1, 7));
}

TEST_CASE("obj: ends of lines, byte order marks, bytes 0") {
  const mesh expected = of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(of("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n") == expected);
  CHECK(of("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r") == expected);
  CHECK(of("v 0 0 0\n\rv 1 0 0\r\r\nv 0 1 0\n\nf 1 2 3") == expected);
  CHECK(of("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3") == expected);
  // Lines are counted alike whatever ends them, columns after the mark.
  CHECK(outcome("v 0 0 0\r\n\r\nv 0 0 x\r\n") == "3:7 expected a decimal number");
  CHECK(outcome("v 0 0 0\r\rv 0 0 x\r") == "3:7 expected a decimal number");
  CHECK(outcome("v 0 0 0\n\nv 0 0 x\n") == "3:7 expected a decimal number");
  CHECK(outcome("\xEF\xBB\xBFv 0 0 x") == "1:7 expected a decimal number");
  CHECK(outcome("v 0 0\r\nv 0 0 0") == "1:6 vertex has fewer than three coordinates");
  CHECK(outcome(text("v 0 0 0\nv 1\0 0 0\n", 17)) == "2:4 byte 0 stands in the text");
  CHECK(outcome(text("# \0\n", 4)) == "1:3 byte 0 stands in the text");
  CHECK(outcome(text("\xFF\xFEv\0 \0", 6)) == "0:0 text is UTF-16, but OBJ must be ASCII or UTF-8");
  CHECK(outcome(text("\xFE\xFF\0v\0 ", 6)) == "0:0 text is UTF-16, but OBJ must be ASCII or UTF-8");
  CHECK(outcome(text("v\0 \0", 4)) == "1:2 byte 0 stands in the text");
  CHECK(outcome("v 0 0 0\n\xEF\xBB\xBFv 0 0 0") == "2:1 expected a statement");
}

TEST_CASE("obj: continuation lines") {
  const mesh expected = of(with_square("f 1 2 3 4"));
  CHECK(of(with_square("f 1 2 \\\n3 4")) == expected);
  CHECK(of(with_square("f 1 2\\\n3 4")) == expected);
  CHECK(of(with_square("f\\\n 1 2 3 \\\r\n 4\r\n")) == expected);
  CHECK(of(with_square("f 1 \\\r2 3 4")) == expected);
  CHECK(of(with_square("f 1 2 3 4 \\\n\\\n\\\n")) == expected);
  CHECK(of(with_square("f 1 2 3 4\\")) == expected);
  CHECK(of(with_square("f 1 2 3 4 \\\r")) == expected);
  CHECK(of(with_square("# a comment is not continued \\\nf 1 2 3 4")) == expected);
  CHECK(of(with_square("curv 0 1 \\\nf 9 9 9\nf 1 2 3 4")) == expected);
  CHECK(outcome(with_square("f 1 2 \\ \n3 4")) == "5:7 expected the index of a vertex");
  CHECK(outcome(with_square("f 1 2\\3 4")) == "5:5 face corner is none of the forms 1, 1/2, 1//3 and 1/2/3");
  CHECK(outcome(with_square("f 1 2 3 \\\n4 \\\n 9")) == "7:2 face index is larger than the number of vertices");
  CHECK(outcome("v 0 0 \\") == "1:8 vertex has fewer than three coordinates");
  CHECK(outcome("\\") == "");
  CHECK(outcome("\\x") == "1:1 expected a statement");
  const mesh named = of(with_square("g two \\\nwords \\\nf 1 2 3 4"));
  CHECK(named.face_count() == 0);
  CHECK(of(with_square("g two\\\nwords\\\n\nf 1 2 3 4")).parts[0].group == "two words");

  // A comment behind any statement, whether it is read, skipped or a name, ends with its line.
  for (const text statement : {"", "v 0 0 0", "vn 0 0 1", "vt 0 0", "f 1 2 3", "mtllib a.mtl", "s 1", "s off", "l 1 2",
                               "p 1", "usemtl a", "usemtl", "o a b", "o", "g a", "g", "curv 0 1", "deg 3"})
    for (const text comment : {" #\\", " # C:\\models\\", "\t# # \\", " #a b\\\\", " \\\n # x\\"})
      for (const text end : {"\n", "\r", "\r\n"}) {
        const std::string spelled = std::string(statement) + std::string(comment) + std::string(end) + "f 1 2 3 4";
        CAPTURE(spelled);
        CHECK(of(with_square(spelled)).face_count() == (statement == "f 1 2 3" ? 2u : 1u));
      }
  CHECK(of(with_square("s 1#2 \\\nf 9 9 9\nf 1 2 3 4")) == expected);  // no comment: no word begins there
  CHECK(of(with_square("usemtl red #5\\\nf 1 2 3 4")).parts[0].material == "red #5\\");
  CHECK(of(with_square("usemtl red\\\n#5\\\nf 1 2 3 4")).parts[0].material == "red #5\\");
  CHECK(of(with_square("usemtl red#5\\\nand 6\nf 1 2 3 4")).parts[0].material == "red#5 and 6");
}

TEST_CASE("obj: long comments, faces and tokens") {
  CHECK(of(with_square("#" + std::string(2'000'000, 'x') + "\nf 1 2 3 4")).face_count() == 1);
  std::string f = "f";
  for (int i = 0; i < 1'000'000; ++i) f += i % 4 == 0 ? " 1" : i % 4 == 1 ? " 2" : i % 4 == 2 ? " 3" : " 4";
  const mesh m = of(with_square(f));
  CHECK(m.face_count() == 1);
  CHECK(m.corners.size() == 1'000'000);
  CHECK(outcome(with_square(std::string(1 << 20, 'q') + "\nf 1 2 3 4")).empty());
  CHECK(outcome("v 0 0 " + std::string(1 << 20, '1')) == "1:7 number is too large");
  CHECK(of("v 0 0 0." + std::string(1 << 20, '3')).positions[0].z == 1.0 / 3);
  CHECK(outcome("v 0 0 " + std::string(1 << 20, 'z')) == "1:7 expected a decimal number");
  CHECK(outcome(with_square("f 1 2 " + std::string(1 << 20, '1'))) ==
        "5:7 face index is larger than the number of vertices");
  CHECK(outcome(with_square("f 1 2 " + std::string(1 << 20, '0') + "3")).empty());
}

TEST_CASE("obj: numbers") {
  const auto z = [](std::string_view number) { return of("v 0 0 " + std::string(number)).positions[0].z; };
  const auto why = [](std::string_view number) { return outcome("v 0 0 " + std::string(number)); };
  CHECK(why("nan") == "1:7 number is not finite");
  CHECK(why("-NaN(7)") == "1:7 number is not finite");
  CHECK(why("inf") == "1:7 number is not finite");
  CHECK(why("+Infinity") == "1:7 number is not finite");
  CHECK(why("1e999") == "1:7 number is too large");
  CHECK(why("-1e999") == "1:7 number is too large");
  CHECK(why("3E4570711268") == "1:7 number is too large");
  CHECK(z("1e-999") == 0);
  CHECK(z("0e4570711268") == 0);
  for (const char* s :
       {"0x10", "1,5", "1e", "1e+", ".", "-", "+", "--1", "1.2.3", "e5", "1d5", "1f", "\"1\"", "1#", "in", "x"}) {
    INFO(std::string(s));
    CHECK(why(s) == "1:7 expected a decimal number");
  }
  CHECK(z("5.") == 5);
  CHECK(z(".5") == 0.5);
  CHECK(z("+1E+2") == 100);
  CHECK(outcome("vn 0 0 nan") == "1:8 number is not finite");
  CHECK(outcome("vt 0 inf") == "1:6 number is not finite");
  CHECK(outcome("v 1 2 3 nan") == "1:9 number is not finite");
  CHECK(outcome("v 1 2 3 0.5 nan 1") == "1:13 number is not finite");  // a colour
  CHECK(outcome("v 1 2 3 0.5 1 1e999") == "1:15 number is too large");
  CHECK(outcome("v 1 2 3 1 0.5 red 1") == "1:15 expected a decimal number");
  CHECK(read_obj<float>("v 0 0 1e39").error().column == 7);
  CHECK(read_obj<float>("v 0 0 16777217.0000000000000001")->positions[0].z == 16777218.0f);
  CHECK_BOTH(fails_at("v 0 0 1e999", 1, 7));
  CHECK_BOTH(corner_count("v 0 0 1e-999") == 0);
}

TEST_CASE("obj: too few and too many numbers") {
  CHECK(outcome("v") == "1:2 vertex has fewer than three coordinates");
  CHECK(outcome("v 1 2\nv 1 2 3") == "1:6 vertex has fewer than three coordinates");
  CHECK(outcome("v 1 2 # 3") == "1:7 vertex has fewer than three coordinates");
  const irg::point<double, 3> p{1, 2, 3};
  CHECK(of("v 1 2 3 0.5").positions[0] == p);               // weight, not used
  CHECK(of("v 1 2 3 0.1 0.2 0.3").positions[0] == p);       // colour, not used
  CHECK(of("v 1 2 3 1 0.1 0.2 0.3").positions[0] == p);     // both
  CHECK(outcome("v 1 2 3 4 5 6 7 8") == "1:17 vertex has more than seven numbers");
  CHECK(outcome("vn 1 2") == "1:7 normal has fewer than three coordinates");
  CHECK(outcome("vn 1 2 3 4") == "1:10 normal has more than three coordinates");
  CHECK(outcome("vt") == "1:3 texture coordinate has no number");
  CHECK(of("vt 0.5").texcoords[0] == irg::vec<double, 2>{0.5, 0});
  CHECK(of("vt 0.5 0.25 0.125").texcoords[0] == irg::vec<double, 2>{0.5, 0.25});
  CHECK(outcome("vt 1 2 3 4") == "1:10 texture coordinate has more than three numbers");
}

TEST_CASE("obj: polygons stay as they are written; triangulation keeps their area") {
  // Twice the signed area in the plane z = 0, exact on these small integers.
  const auto area = [](const mesh& m) {
    double sum = 0;
    for (std::size_t f = 0; f < m.face_count(); ++f)
      for (std::size_t k = 0; k < m.face_size(f); ++k) {
        const auto& p = m.positions[m.corner(f, k).position];
        const auto& q = m.positions[m.corner(f, (k + 1) % m.face_size(f)).position];
        sum += p.x * q.y - p.y * q.x;
      }
    return sum;
  };
  const struct {
    const char* what;
    text s;
    double twice_area;
  } cases[] = {
      {"quad", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4", 8},
      {"concave pentagon", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5", 20},
      {"bow tie", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 4 4 0\nf 1 2 3 4", 0},
      {"self-crossing with area", "v 0 0 0\nv 4 0 0\nv 1 3 0\nv 4 3 0\nv 0 5 0\nf 1 2 3 4 5", 23},
      {"collinear", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4", 0},
      {"one corner twice", "v 0 0 0\nv 4 0 0\nv 4 4 0\nf 1 1 2 3", 16},
      {"one corner only", "v 0 0 0\nf 1 1 1 1 1", 0},
      {"spike", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 9 9 0\nf 1 2 3 4 3", 16},
  };
  for (const auto& c : cases) {
    INFO(std::string(c.what));
    const mesh m = of(c.s);
    CHECK(m.face_count() == 1);
    CHECK(area(m) == c.twice_area);
    CHECK(area(irg::triangulated(m)) == c.twice_area);
  }
}

TEST_CASE("obj: points and lines beside faces are skipped, unchecked, or refused on request") {
  CHECK(of(with_square("l 1\nf 1 2 3\np 1 2 99999999999\nl 7 a\n")).face_count() == 1);
  CHECK(of(with_square("s off\ns 1\nmg 1 2\ncstype bezier\nvp 1 2\nf 1 2 3\nend\nunheard_of 1 2 3")).face_count() == 1);
  const irg::obj_options refuse{irg::obj_unused::refuse};
  CHECK(outcome(with_square("l 1\nf 1 2 3"), refuse) == "5:1 statement has no place in a mesh");
  CHECK(outcome(with_square("f 1 2 3\n  s off"), refuse) == "6:3 statement has no place in a mesh");
  CHECK(outcome(with_square("o a\ng b\nusemtl c\n# d\nf 1 2 3"), refuse).empty());
  // What is not even a word is no statement: text that has gone astray is not taken for one.
  for (const char* s : {"1 2 3", "-v 0 0 0",
                        "v\xC2\xA0"
                        "1 2 3",
                        "\xC2\xA0v 1 2 3", "<obj>", "v# 1 2 3", "v/1", "\x01", "vt,"}) {
    INFO(std::string(s));
    CHECK(outcome(s) == "1:1 expected a statement");
  }
}

TEST_CASE("obj: objects, groups and materials by name; no file is opened") {
  const mesh m =
      of(with_square("mtllib missing.mtl\nmtllib ../../etc/passwd\nf 1 2 3\no thing\nf 1 2 4\n"
                     "usemtl  red and #5 \ng a b\t\nf 2 3 4\nf 1 2 3\ng a b\nf 1 2 3\ng\nusemtl\no\nf 1 3 4\n"));
  REQUIRE(m.parts.size() == 4);
  CHECK(m.parts[0] == irg::mesh_part{"", "", "", 0, 1});
  CHECK(m.parts[1] == irg::mesh_part{"thing", "", "", 1, 1});
  CHECK(m.parts[2] == irg::mesh_part{"thing", "a b", "red and #5", 2, 3});
  CHECK(m.parts[3] == irg::mesh_part{"", "", "", 5, 1});
  CHECK(of(with_square("f 1 2 3")).parts.empty());
  CHECK(of(with_square("g a\ng b\nusemtl c\no d")).parts.empty());
  CHECK(of(with_square("g a\ng b\nf 1 2 3\ng c\ng d")).parts == std::vector<irg::mesh_part>{{"", "b", "", 0, 1}});

  std::string switches = std::string(square);
  for (int i = 0; i < 1'000'000; ++i) {
    switches += i % 3 == 0 ? "g a" : i % 3 == 1 ? "o b" : "usemtl c";
    switches += std::to_string(i % 10) + (i % 10 == 9 ? "\nf 1 2 3\n" : "\n");
  }
  const mesh many = of(switches);
  CHECK(many.face_count() == 100'000);
  CHECK(many.parts.size() > 10'000);
  for (const irg::mesh_part& part : many.parts) REQUIRE(part.face_count > 0);

  std::string repeated = with_square("usemtl " + std::string(100'000, 'm') + "\n");
  const std::size_t before = repeated.size();
  for (int i = 0; i < 10'000; ++i) repeated += i % 2 == 0 ? "g a\nf 1 2 3\n" : "g b\nf 1 2 3\n";
  CHECK(outcome(repeated).find(" long names are repeated over too many parts") != std::string::npos);
  CHECK(outcome(std::string_view(repeated).substr(0, before + 12 * 12)).empty());
  static_assert(read_obj("v 0 0 0\ng a\\\nb\nf 1 1 1")->parts[0].group == "a b");
  // 16 times a text of 256 MiB is more than 32 bits hold: not for an address to count.
  static_assert(std::is_same_v<decltype(irg::detail::obj_reader<double>::name_budget), std::uint64_t>);
}

TEST_CASE("obj: blanks") {
  const mesh expected = of(with_square("f 1 2 3 4"));
  CHECK(of(with_square("\t f\t\t1   2 \t3\v4 \f  ")) == expected);
  CHECK(of("v\t0  0 0   \n \t v 1 0 0\t\nv 1 1 0\n\n\n   \nv 0 1 0 # four\nf 1 2 3 4 #").positions.size() == 4);
}

TEST_CASE("obj: a comment begins where a token could; bytes beyond ASCII are no blanks") {
  CHECK(of(with_square("f 1 2 3 #4")).corners.size() == 3);
  CHECK(outcome(with_square("f 1 2 3\xA0")) == "5:7 face corner is none of the forms 1, 1/2, 1//3 and 1/2/3");
  CHECK(outcome("v 1 2 \xC2\xA0"
                "3") == "1:7 expected a decimal number");
  CHECK(of(with_square("g gr\xC3\xBC\xC2\xA0n\nf 1 2 3")).parts[0].group == "gr\xC3\xBC\xC2\xA0n");
}

TEST_CASE("obj: the locale changes nothing") {
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"})
    if (setlocale(LC_ALL, name) == nullptr) MESSAGE("skipped, not installed: locale ", std::string(name));
  CHECK(of("v 1.5 -0.25 1e-3").positions[0] == irg::point<double, 3>{1.5, -0.25, 0.001});
  CHECK(outcome("v 1,5 0 0") == "1:3 expected a decimal number");
  setlocale(LC_ALL, "C");
}

TEST_CASE("obj: empty texts, one byte, two bytes") {
  CHECK(of("") == mesh{});
  CHECK(of(text{}) == mesh{});
  CHECK(of("# nothing\n   # here\r\n\t\n") == mesh{});
  CHECK_BOTH(corner_count("") == 0);
  std::size_t meshes = 0;
  for (int a = 0; a < 256; ++a) {
    const char one[1] = {static_cast<char>(a)};
    // Blanks, ends of lines, #, the backslash and letters that begin words nobody knows; v and f lack their numbers.
    const bool empty = std::string_view(" \t\v\f\n\r#\\").find(one[0]) != text::npos ||
                       (irg::detail::is_letter(one[0]) && one[0] != 'v' && one[0] != 'f');
    CHECK((outcome(text(one, 1)) == "") == (a != 0 && empty));
    for (int b = 0; b < 256; ++b) {
      const char two[2] = {static_cast<char>(a), static_cast<char>(b)};
      meshes += outcome(text(two, 2)).empty();
    }
  }
  CHECK(meshes > 2000);
  CHECK(meshes < 20000);
}

TEST_CASE("obj: cut off at every byte") {
  const std::string whole =
      "# model\r\nmtllib a.mtl\r\no thing\r\nv 0 0 0\r\nv 1.5e0 -0.25 +3\r\nv 0 1 0 1\r\nvt 0.5 0.5\r\nvn 0 0 1\r\n"
      "g one\r\nusemtl red\r\nf 1/1/1 2/1/1 \\\r\n3/1/1\r\ns off\r\nl 1 2\r\nf -3//-1 -2//-1 -1//-1\r\nv 9 9 9\r\nf 4 "
      "1 2 3\r\n";
  const mesh full = of(whole);
  std::size_t sound = 0;
  for (std::size_t n = 0; n <= whole.size(); ++n) {
    const text prefix = text(whole).substr(0, n);
    const std::string problem = outcome(prefix);
    if (!problem.empty()) {
      // Only the statement that was cut can be at fault, and it is the last.
      const std::size_t last_line = 1 + static_cast<std::size_t>(std::count(prefix.begin(), prefix.end(), '\n'));
      CHECK(std::stoul(problem) + 1 >= last_line);
      continue;
    }
    ++sound;
    const mesh m = *read_obj(prefix);
    // What was read before is there, unchanged: vertices but the last, corners but the last face's.
    REQUIRE(m.positions.size() <= full.positions.size());
    for (std::size_t i = 0; i + 1 < m.positions.size(); ++i) REQUIRE(m.positions[i] == full.positions[i]);
    REQUIRE(m.face_count() <= full.face_count());
    for (std::size_t f = 0; f + 1 < m.face_count(); ++f) REQUIRE(face(m, f) == face(full, f));
  }
  CHECK(sound > whole.size() / 2);
  CHECK(sound < whole.size());
}

TEST_CASE("obj: memory is bounded by the text, time by its length") {
  const auto repeat = [](std::string_view line, std::size_t n, std::string_view head = square) {
    std::string s(head);
    for (std::size_t i = 0; i < n; ++i) s += line;
    return s;
  };
  std::string long_name = with_square("o " + std::string(15, 'n') + "\nusemtl " + std::string(300, 'm') + "\n");
  const std::string texts[] = {
      repeat("v 0 0 0\n", 200'000),
      repeat("vt 0\n", 300'000),
      repeat("vn 0 0 0\n", 200'000),
      repeat("f 1 1 1\n", 200'000),
      repeat(" 1", 1'000'000, "v 0 0 0\nf"),
      repeat("g a\nf 1 1 1\ng\nf 1 1 1\n", 100'000),
      repeat("g\n", 500'000),
      repeat("g abcdefghijklmnopqrstuvwxyz\nf 1 1 1\ng\nf 1 1 1\n", 50'000),
      repeat("f 1 1 1\n", 100'000, ""),
      repeat("g a\nf 1 1 1\ng b\nf 1 1 1\n", 20'000, long_name),
      repeat("#", 1'000'000),
      repeat("\\\n", 500'000),
      "v 0 0 0",
      repeat("g\nf 1 1 1\ng a\nf 1 1 1\n", 32'769,
             "v 0 0 0\no " + std::string(129, 'x') + "\nusemtl " + std::string(33, 'm') + "\n"),
  };
  const auto check = [](const std::string& s, auto&& read) {
    INFO(s.substr(s.size() > 40 ? s.size() - 40 : 0));
    const std::size_t before = test::bytes_now;
    test::bytes_most = before;
    {
      const auto r = read(s);
      CHECK(test::bytes_most - before <= 64 * s.size() + (std::size_t{1} << 20));
      if (r) CHECK(irg::validate(*r) == irg::mesh_finding{});
    }
    CHECK(test::bytes_now == before);
  };
  for (const std::string& s : texts) {
    check(s, [](const std::string& text) { return read_obj(text); });
    check(s, [](const std::string& text) { return read_obj(text, {}, irg::parallel{2}); });
  }
}

TEST_CASE("obj: lines that are read in one go mean what they mean when they are not") {
  // A tab instead of the first blank sends a line the long way.
  test::random r(404);
  int sound = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string quick, slow;
    const auto both = [&](std::string_view s) {
      quick += s;
      slow += s;
    };
    const auto line = [&](std::string_view word, std::string_view rest) {
      both(word);
      quick += ' ';
      slow += '\t';
      both(rest);
      both(r.integer(0, 3) == 0 ? "\r\n" : r.integer(0, 20) == 0 ? "\r" : "\n");
    };
    const auto number = [&] {
      std::string s = r.integer(0, 2) == 0 ? "-" : "";
      for (std::int64_t k = r.integer(r.integer(0, 200) == 0 ? 0 : 1, r.integer(0, 4) == 0 ? 17 : 4); k > 0; --k)
        s += static_cast<char>('0' + r.integer(0, 9));
      if (r.integer(0, 1) == 0) s += '.';
      for (std::int64_t k = r.integer(0, r.integer(0, 9) == 0 ? 20 : 6); k > 0; --k)
        s += static_cast<char>('0' + r.integer(0, 9));
      if (r.integer(0, 30) == 0) s += r.integer(0, 12) != 0 ? "e-7" : "x";
      return s + (r.integer(0, 10) == 0 ? "  " : r.integer(0, 40) == 0 ? "\\\n" : " ");
    };
    const auto index = [&] { return std::to_string(r.integer(r.integer(0, 90) == 0 ? -1 : 1, 9)); };
    for (int k = 0; k < 9; ++k) {
      line("v", number() + number() + number());
      line("vn", number() + number() + number());
      line("vt", number() + number());
    }
    for (std::int64_t k = r.integer(1, 6); k > 0; --k) {
      if (r.integer(0, 3) == 0) line("g", "name");
      std::string corners;
      for (std::int64_t c = r.integer(3, 10); c > 0; --c) {
        const std::int64_t form = r.integer(0, 20);
        corners += index();
        if (form % 4 == 1) corners += "/" + index();
        if (form % 4 == 2) corners += "//" + index();
        if (form % 4 == 3) corners += "/" + index() + "/" + index();
        if (form == 20 && r.integer(0, 5) == 0) corners += "/";
        corners += ' ';
      }
      line("f", corners);
    }
    if (trial % 5 == 0) quick.pop_back(), slow.pop_back();
    const auto a = read_obj<float>(quick), b = read_obj<float>(slow);
    REQUIRE(a.has_value() == b.has_value());
    sound += a ? 1 : 0;
    if (a) CHECK(*a == *b);
    if (!a) {
      CHECK(a.error().line == b.error().line);
      CHECK(a.error().column == b.error().column);
      CHECK(std::string_view(a.error().message) == b.error().message);
    }
  }
  CHECK(sound > 150);
  CHECK(sound < 850);
}

TEST_CASE("obj: an executor's pieces, cut anywhere, are the text in one go") {
  test::random r(505);
  int sound = 0;
  for (int trial = 0, n = std::getenv("IRG_RELEASE_TIER") ? 100000 : 500; trial < n; ++trial) {
    CAPTURE(trial);
    const auto chance = [&](int of) { return r.integer(0, of - 1) == 0; };
    const bool careless = chance(2);  // whether indices may name what is not there
    std::string s;
    std::int64_t filled[3] = {};
    const auto index = [&](std::size_t kind) {
      const std::int64_t most = filled[kind] + (careless && chance(40) ? 3 : 0);
      if (most == 0) return std::string(careless ? "-1" : "1");
      return std::to_string(chance(2) ? r.integer(1, most + (chance(30) ? 1 : 0)) : -r.integer(1, most));
    };
    const auto numbers = [&](int count) {
      std::string line;
      for (; count > 0; --count) line += ' ' + std::to_string(r.integer(-9, 9)) + (chance(2) ? ".5" : "");
      return line;
    };
    for (std::int64_t k = r.integer(1, 60); k > 0; --k) {
      const auto what = r.integer(0, 9);
      if (what < 4) {
        const auto kind = static_cast<std::size_t>(what == 3 ? 0 : what);
        s += (kind == 0 ? "v" : kind == 1 ? "vt" : "vn") + numbers(kind == 1 ? 2 : 3);
        ++filled[kind];
      } else if (what < 8 && filled[0] > 0) {
        s += 'f';
        for (std::int64_t c = r.integer(careless && chance(60) ? 2 : 3, 6); c > 0; --c) {
          s += ' ' + index(0);
          if (chance(3) && filled[1] > 0)
            s += '/' + index(1);
          else if (chance(3) && filled[2] > 0)
            s += "//" + index(2);
          if (chance(12)) s += chance(2) ? " \\\n" : "\\\r\n";
        }
      } else if (what == 8) {
        const char* const names[] = {"g a", "g b", "g", "o a", "o", "usemtl \\\n b", "usemtl c # d"};
        s += names[r.integer(0, 6)];
      } else {
        const char* const others[] = {"# \\", "", "s off", "l 1 2 \\\r\n3", "\t", "mtllib a # \\"};
        s += others[r.integer(0, 5)];
      }
      s += chance(5) ? "\r\n" : chance(9) ? "\r" : chance(9) ? "\\\n\n" : "\n";
    }
    if (chance(3)) s.pop_back();
    if (careless && chance(20)) s.insert(static_cast<std::size_t>(r.integer(0, 30)) % s.size(), 1, '\0');
    const bool reads = outcome(s).empty();
    sound += reads ? 1 : 0;
    check_pieces<float>(s, {}, static_cast<std::size_t>(r.integer(1, 60)), irg::parallel{trial % 50 == 0 ? 3 : 1});
  }
  CHECK(sound > 150);
  CHECK(sound < (std::getenv("IRG_RELEASE_TIER") ? 95000 : 475));
}

TEST_CASE("obj: with threads: the same mesh, the same error, memory of three meshes") {
  std::string s = "\xEF\xBB\xBFo a\n";
  for (int i = 0; i < 40'000; ++i) {
    const std::string n = std::to_string(i);
    s += "v " + n + " 0.25 -1\nvt 0.5 0." + n + "\n";
    if (i > 3) s += i % 2 == 0 ? "f -1/-1 -2/-2 -4/-3\n" : "f 1/2 2/1 " + n + "/3\n";
    if (i % 1000 == 0) s += "g part " + n + "\n";
  }
  const auto one = read_obj<float>(s);
  REQUIRE(one);
  const std::size_t size =
      one->positions.size() * 12 + one->texcoords.size() * 8 + one->corners.size() * 12 + one->face_starts.size() * 4;
  for (const int threads : {1, 2, 5}) {
    const std::size_t before = test::bytes_now;
    test::bytes_most = before;
    const auto r = read_obj<float>(s, {}, irg::parallel{threads});
    REQUIRE(r);
    CHECK(*r == *one);
    CHECK(test::bytes_most - before <= 3 * size);
  }
  for (const char* bad : {"f 1 2 40001\n", "f 1 2\n", "f 1 2 -40001\n", "v 1 2 x", "1"}) {
    const std::string broken = s + bad;
    const auto expected = read_obj<float>(broken).error(), e = read_obj<float>(broken, {}, irg::parallel{2}).error();
    CHECK(e.line == expected.line);
    CHECK(e.column == expected.column);
    CHECK(std::string_view(e.message) == expected.message);
  }
}

TEST_CASE("obj: blanks to the end of the text, beyond what is looked at in one go") {
  for (const std::size_t blanks : {40u, 60u, 70u, 79u, 80u, 81u, 200u})
    for (const char* line : {"v", "v 1", "v 1 2 3", "f 1 2 3", "f 1", "vt 1 2", "v -", "v 1.", "f 1/"}) {
      const std::string s = with_square(line);
      const std::vector<char> exact = [&] {  // nothing readable behind it
        std::vector<char> bytes(s.begin(), s.end());
        bytes.insert(bytes.end(), blanks, ' ');
        return bytes;
      }();
      const std::string whole = outcome(s), padded = outcome({exact.data(), exact.size()});
      CHECK(whole.substr(whole.find(' ') + 1) == padded.substr(padded.find(' ') + 1));
    }
}

TEST_CASE("obj: a byte 0 anywhere is the error, whatever else is wrong") {
  const std::string sound = with_square("# abc\ng name \\\n x\ns off # y\nvt 1 2\nf 1 2 3\n\nf 9 9 9\nv x\n");
  for (std::size_t i = 0; i <= sound.size(); ++i) {
    std::string s = sound;
    s.insert(i, 1, '\0');
    CHECK(outcome(s).ends_with(" byte 0 stands in the text"));
  }
}

TEST_CASE("obj: a long text, of which samples are taken, whatever they tell") {
  std::string long_text;
  for (int i = 0; i < 12000; ++i) long_text += "v 0.5 " + std::to_string(i) + " 1\n";
  const std::string faces_last = [&] {
    std::string s = long_text;
    for (int i = 1; i + 3 <= 12000; ++i)
      s += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 3) + "\n";
    return s;
  }();
  const mesh m = of(faces_last);
  CHECK(m.positions.size() == 12000);
  CHECK(m.face_count() == 11997);
  CHECK(face(m, 11996) == indices{11996, 11997, 11999});
  CHECK(of(long_text + std::string(500000, '#')).positions.size() == 12000);
  CHECK(of(std::string(500000, '\n') + long_text).positions.size() == 12000);
}

TEST_CASE("obj: seeded disorder never breaks the promises") {
  const std::string words[] = {"v ",
                               "vt ",
                               "vn ",
                               "f ",
                               "g ",
                               "o ",
                               "usemtl ",
                               "l ",
                               "#",
                               "\n",
                               "\r\n",
                               "\r",
                               "\\\n",
                               "\\",
                               " ",
                               "\t",
                               "0 ",
                               "1 ",
                               "2 ",
                               "3 ",
                               "-1 ",
                               "-2 ",
                               "/",
                               "//",
                               "1/1/1 ",
                               "1.5 ",
                               "1e9 ",
                               "1e400 ",
                               "nan ",
                               "x",
                               "v 0 0 0\n",
                               "v 1 0 0\n",
                               "v 0 1 1\n",
                               "vt 0 1\n",
                               "vn 0 0 1\n",
                               "f 1 2 3\n",
                               "f -1 -2 -3 -4\n"};
  test::random random(5);
  int meshes_with_faces = 0;
  for (int i = 0; i < 30'000; ++i) {
    std::string s(i % 2 == 0 ? square : "");
    const auto length = random.integer(0, i % 4 == 0 ? 5 : 24);
    for (int k = 0; k < length; ++k)
      s += words[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(std::size(words)) - 1))];
    if (outcome(s).empty() && read_obj(s)->face_count() > 0) ++meshes_with_faces;
  }
  CHECK(meshes_with_faces > 100);
}

#ifdef IRG_MODELS_DIR
namespace {

/// Edges used once, twice and more often.
std::tuple<long, long, long> edge_uses(const mesh& m) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 0; k < m.face_size(f); ++k) {
      const std::uint32_t a = m.corner(f, k).position, b = m.corner(f, (k + 1) % m.face_size(f)).position;
      edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  std::sort(edges.begin(), edges.end());
  long uses[3] = {};
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && edges[j] == edges[i]) ++j;
    ++uses[std::min<std::size_t>(j - i, 3) - 1];
    i = j;
  }
  return {uses[0], uses[1], uses[2]};
}

}  // namespace
#endif

TEST_CASE("obj: real models") {
#ifdef IRG_MODELS_DIR
  const struct {
    const char* name;
    std::size_t vertices, faces, triangles;
    long once, twice, more;
  } models[] = {
      {"ogre", 62194, 124008, 124008, 236, 185894, 0}, {"stanford-bunny", 35947, 69451, 69451, 223, 104065, 0},
      {"fandisk", 6475, 12946, 12946, 0, 19419, 0},    {"teapot", 3644, 6320, 6320, 1036, 8962, 0},
      {"spot", 2930, 5856, 5856, 0, 8784, 0},          {"cow", 2903, 5804, 5804, 0, 8706, 0},
      {"beetle", 1148, 2053, 0, 296, 2861, 47},        {"suzanne", 507, 500, 468 * 2 + 32, 42, 963, 0},
  };
  for (const auto& model : models) {
    INFO(std::string(model.name));
    const std::string path = std::string(IRG_MODELS_DIR) + "/" + model.name + ".obj";
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) {
      MESSAGE("skipped, not there: ", path);
      continue;
    }
    std::string s(std::size_t{1} << 23, '\0');
    s.resize(std::fread(s.data(), 1, s.size(), file));
    std::fclose(file);
    const mesh m = of(s);
    CHECK(m.positions.size() == model.vertices);
    CHECK(m.face_count() == model.faces);
    CHECK(edge_uses(m) == std::tuple{model.once, model.twice, model.more});
    if (model.triangles != 0) CHECK(irg::triangulated(m).face_count() == model.triangles);
    const auto as_float = read_obj<float>(s);
    REQUIRE(as_float);
    REQUIRE(as_float->corners == m.corners);
    for (const std::size_t bytes : {std::size_t{5000}, std::size_t{1} << 16, s.size() / 3})
      check_pieces<double>(s, {}, bytes, irg::parallel{2});
    CHECK(irg::validate(*as_float) == irg::mesh_finding{});
  }
#else
  MESSAGE("skipped: no folder of models was given (IRG_MODELS_DIR)");
#endif
}
