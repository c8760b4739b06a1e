// SPDX-License-Identifier: MIT
#include <irg/io/mesh_file.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "io/memory_in_use.hpp"
#include "support/check_both.hpp"
#include "support/mesh_files.hpp"

// Every byte that this program asks for and gives back is counted, so that what headers claim can be seen to cost nothing.
namespace {

using irg::mesh_encoding;
using irg::mesh_format;
using irg::mesh_format_of;
using test::as_text;

constexpr mesh_encoding encodings[] = {mesh_encoding::text, mesh_encoding::little_endian, mesh_encoding::big_endian};

std::string repeated(std::string_view text, int count) {
  std::string s;
  for (int i = 0; i < count; ++i) s += text;
  return s;
}

std::vector<std::string> files_of(const irg::mesh<float>& m) {
  std::vector<std::string> files = {as_text(*irg::encode_off(m)), as_text(*irg::encode_stl(m)),
                                    as_text(*irg::encode_stl(m, mesh_encoding::little_endian)),
                                    as_text(*irg::encode_body_xml(std::vector{irg::store_body<float>("a", m)}))};
  for (const mesh_encoding e : encodings) files.push_back(as_text(*irg::encode_ply(m, e)));
  return files;
}

}  // namespace

TEST_CASE("mesh files: the format is known by the content, at compile time, too") {
  CHECK_BOTH(mesh_format_of("ply\nformat ascii 1.0\n") == mesh_format::ply);
  CHECK_BOTH(mesh_format_of("ply\r") == mesh_format::ply);
  CHECK_BOTH(mesh_format_of("ply \t\nformat ascii 1.0\n") == mesh_format::ply);  // as read_ply takes it
  CHECK_BOTH(mesh_format_of("ply") == mesh_format::ply);
  CHECK_BOTH(mesh_format_of("# by hand\n\n STCNOFF 1 0 0") == mesh_format::off);
  CHECK_BOTH(mesh_format_of("\xEF\xBB\xBFOFF3 1 0") == mesh_format::off);
  CHECK_BOTH(mesh_format_of(" Solid x\n") == mesh_format::stl);
  CHECK_BOTH(mesh_format_of("solidx\n") == mesh_format::obj);
  CHECK_BOTH(mesh_format_of("\n <body name='a'>") == mesh_format::body_xml);
  CHECK_BOTH(mesh_format_of("v 0 0 0\n") == mesh_format::obj);
  CHECK_BOTH(mesh_format_of("") == mesh_format::obj);
  CHECK_BOTH(mesh_format_of("plywood") == mesh_format::obj);
  CHECK_BOTH(irg::read_mesh<float>("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2")->face_count() == 1);
  CHECK_BOTH(irg::read_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3")->face_count() == 1);
  std::string bytes = as_text(*irg::encode_stl(irg::shape_cube<float>(), mesh_encoding::little_endian));
  CHECK(mesh_format_of(bytes) == mesh_format::stl);
  bytes.replace(0, 4, "ply\n");
  CHECK(mesh_format_of(bytes) == mesh_format::stl);  // a length that no other file has decides
}

TEST_CASE("mesh files: every format gives the same body") {
  const irg::mesh<float> cube = irg::triangulated(irg::shape_cube<float>());
  for (const std::string& bytes : files_of(cube)) {
    const auto r = irg::read_mesh<float>(bytes);
    REQUIRE(test::outcome_of(r) == "");
    CHECK(test::in_order_of_use(irg::with_merged_positions(test::without_attributes(*r))) ==
          test::in_order_of_use(test::without_attributes(cube)));
  }
}

TEST_CASE("mesh files: from the disk, or the reason why not") {
  const std::string path = "mesh_file_test.tmp";
  for (const std::string& bytes : files_of(irg::shape_tetrahedron<float>())) {
    REQUIRE(irg::save_file(path, std::string_view(bytes)));
    CHECK(irg::load_mesh<double>(path)->face_count() == 4);
  }
  std::remove(path.c_str());
  CHECK(std::string(irg::load_mesh<double>(path).error().message) == "file does not exist");
}

TEST_CASE("mesh files: written in the format of their name, read by their content") {
  CHECK_BOTH(irg::mesh_format_of_name("a/B.PLY") == mesh_format::ply);
  CHECK_BOTH(irg::mesh_format_of_name("xml") == std::nullopt);
  const irg::mesh<float> cube = test::without_attributes(irg::shape_tetrahedron<float>());
  for (const char* ending : {"obj", "stl", "ply", "off", "xml", "STL"}) {
    const std::string path = std::string("mesh_file_test.") + ending;
    for (const mesh_encoding e : encodings) {
      const auto saved = irg::save_mesh(path, cube, e);
      const auto format = *irg::mesh_format_of_name(path);
      const bool has_form = e == mesh_encoding::text || format == mesh_format::ply ||
                            (format == mesh_format::stl && e == mesh_encoding::little_endian);
      CHECK(saved.has_value() == has_form);
      if (!saved) continue;
      const auto again = irg::load_mesh<float>(path);
      REQUIRE(test::outcome_of(again) == "");
      CHECK(test::in_order_of_use(test::without_attributes(*again)) == test::in_order_of_use(cube));
    }
    std::remove(path.c_str());
  }
  CHECK(std::string(irg::save_mesh("mesh_file_test.3ds", cube).error().message).find(irg::mesh_endings) !=
        std::string::npos);
  irg::mesh<float> broken = cube;
  broken.corners[0].position = 99;
  CHECK(!irg::save_mesh("mesh_file_test.xml", broken));
}

TEST_CASE("mesh files: NaN in what is not used") {
  const auto outcome = [](std::string_view s) { return test::outcome_of(irg::read_mesh<double>(s)); };
  // Lines of numbers hold numbers.
  CHECK(outcome("v 0 0 0 nan 0 0\n") == "1:9 number is not finite");
  CHECK(outcome("OFF\n1 0 0\n0 0 0 nan 0 0\n") == "3:7 number is not finite");
  CHECK(outcome("COFF\n1 0 0\n0 0 0 1 nan 1 1\n") == "3:9 number is not finite");
  CHECK(outcome("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0 nan 0\n") == "6:11 number is not finite");
  CHECK(outcome(std::string_view("COFF BINARY\n\0\0\0\1\0\0\0\0\0\0\0\0"
                                 "\0\0\0\0\0\0\0\0\0\0\0\0\x7f\xc0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
                                 52)) == "0:37 number is not finite");
  // What readers are to pass over may be anything.
  CHECK(outcome("OFF BINARY\n" + std::string("\0\0\0\1\0\0\0\1\0\0\0\0", 12) + std::string(12, '\0') +
                std::string("\0\0\0\3", 4) + std::string(12, '\0') +
                std::string("\0\0\0\3\x7f\xc0\0\0\x7f\xc0\0\0\x7f\xc0\0\0", 16)) == "");
  CHECK(outcome("ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\n"
                "property float red\nend_header\n0 0 0 nan\n") == "");
  CHECK(outcome("solid\nfacet normal nan nan nan outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n"
                "endsolid\n") == "");
  CHECK(outcome("<body><points><point x='0' y='0' z='0' o:w='nan'><o:c>nan</o:c></point></points><faces/></body>") ==
        "");
}

TEST_CASE("mesh files: what cannot be read gets the sentence of the format that its name asks for") {
  const auto cube = irg::triangulated(irg::shape_cube<float>());
  std::string binary = as_text(*irg::encode_stl(cube, mesh_encoding::little_endian));
  const auto outcome = [](std::string_view bytes, mesh_format named) {
    return test::outcome_of(irg::read_mesh<float>(bytes, named));
  };
  const auto stl = mesh_format::stl, ply = mesh_format::ply, off = mesh_format::off, xml = mesh_format::body_xml,
             obj = mesh_format::obj;
  // What can be read is read, whatever it is called.
  for (const mesh_format named : {obj, stl, ply, off, xml}) {
    for (const std::string& bytes : files_of(cube)) CHECK(outcome(bytes, named) == "");
    CHECK(outcome(as_text(*irg::encode_obj(cube)), named) == "");
    CHECK(outcome("v 0 0 0\n", named) == "");
  }
  const std::string too_short = binary.substr(0, binary.size() - 1), too_long = binary + "\n";
  CHECK(outcome(too_short, stl) == "0:81 file is too short for the number of triangles that stands here");
  CHECK(outcome(too_long, stl) == "0:81 file is too long for the number of triangles that stands here");
  for (const char* head : {"ply\n", "OFF ", "# by hand\nOFF ", "<a/>", "v 0 0 0\n"}) {  // names of bodies and programs
    std::string bytes = too_short;
    bytes.replace(0, std::string_view(head).size(), head);
    CHECK(outcome(bytes, stl) == "0:81 file is too short for the number of triangles that stands here");
  }
  const std::string text = as_text(*irg::encode_stl(cube));
  for (const char* comment :
       {"# made by hand\n", "// made by hand\n", "; made by hand\n", "Made by hand\n", "\xC2\xA9 x\n"})
    CHECK(outcome(comment + text, stl) == "1:1 expected the word solid");
  CHECK(outcome("\n  facet normal 0 0 1\n", stl) == "2:3 expected the word solid");
  CHECK(outcome("", stl) == "1:1 text has no word solid");
  CHECK(outcome("", ply) == "1:1 file does not begin with the word ply");
  CHECK(outcome("made by hand\nply\nformat ascii 1.0\n", ply) == "1:1 file does not begin with the word ply");
  CHECK(outcome("Off\n3 1 0\n0 0 0\n", off) == "1:1 file does not begin with the word OFF");
  CHECK(outcome("3 1 0\n0 0 0\n", off) == "1:1 file does not begin with the word OFF");
  CHECK(outcome("x<body/>", xml) == "1:1 text stands where only elements may stand");
  CHECK(outcome("", xml) == "1:1 text has no element");
  CHECK(outcome("", obj) == "");
  CHECK(outcome("v 0 0\n", obj) == "1:6 vertex has fewer than three coordinates");
  CHECK(outcome("v 0 0\n", stl) == "1:1 expected the word solid");
  // OBJ has no mark: a file with that of another format is that, even under the name of an OBJ.
  CHECK(outcome("ply\nformat ascii 2.0\n", obj) == "2:14 version of the format is not 1.0");
  CHECK(outcome("solid\nface", obj) == "2:1 expected facet or endsolid");
  CHECK_BOTH(irg::read_mesh<float>("x\n", irg::mesh_format::off).error().line == 1);
  CHECK_BOTH(irg::read_mesh<float>("v 0 0 0\n", irg::mesh_format::off).has_value());

  for (const char* path : {"mesh_file_test.stl", "mesh_file_test.STL", "mesh_file_test.ply", "mesh_file_test.any"}) {
    REQUIRE(irg::save_file(path, std::string_view("// by hand\n" + text)));
    const std::string_view name = path;
    const auto r = irg::load_mesh<double>(path);
    CHECK(test::outcome_of(r) == (name.ends_with(".any")   ? "1:1 expected a statement"
                                  : name.ends_with(".ply") ? "1:1 file does not begin with the word ply"
                                                           : "1:1 expected the word solid"));
    std::remove(path);
  }
}

TEST_CASE("mesh files: materials come from the model's own folder alone") {
  const std::string path = "mesh_file_test.obj";
  const auto named = [&](std::string_view library) {
    REQUIRE(irg::save_file(path, "mtllib " + std::string(library) + "\nv 0 0 0\n"));
    return irg::load_materials<double>(path);
  };
  REQUIRE(irg::save_file("mesh file test.mtl", std::string_view("newmtl red\nKd 1 0 0\n")));
  const auto materials = named("mesh file test.mtl");
  REQUIRE(materials);
  CHECK(materials->at(0).reflection.diffuse == irg::rgb<double>{1, 0, 0});
  CHECK(named("./mesh file test.mtl")->size() == 1);
  CHECK(std::string(named("./../mesh file test.mtl").error().message) ==
        "library of materials is not beside the model");
  CHECK(std::string(named("/etc/passwd").error().message) == "library of materials is not beside the model");
  CHECK(std::string(named("none.mtl").error().message) == "file does not exist");
  std::remove("mesh file test.mtl");
  std::remove(path.c_str());
}

TEST_CASE("mesh files: memory is bounded by the bytes, whatever a header claims") {
  const std::string many = "99999999999";
  std::string torn;
  for (int i = 0; i < 30000; ++i) torn += "\x01\x02\x03";
  std::string faces;
  for (int i = 0; i < 30000; ++i) faces += std::string("\x03\0\0\0", 4);
  const std::string vertex = "property char x\nproperty char y\nproperty char z\n";
  const std::string attributes = vertex +
                                 "property char nx\nproperty char ny\nproperty char nz\nproperty char s\nproperty char "
                                 "t\n";
  const std::string list = "property list char uchar vertex_index\n";
  std::string lines;
  for (int i = 0; i < 30000; ++i) lines += "0 0 0\n";
  std::string solid = "solid a\n";
  for (int i = 0; i < 5000; ++i)
    solid += "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n";
  const std::string little = "ply\nformat binary_little_endian 1.0\n";
  const std::string files[] = {
      "OFF " + many + " " + many + " 0\n" + lines,
      "OFF 3 " + many + " 0\n0 0 0\n1 0 0\n0 1 0\n" + lines,
      "ply\nformat ascii 1.0\nelement vertex " + many + "\n" + vertex + "end_header\n" + lines,
      little + "element vertex " + many + "\n" + vertex + "end_header\n" + torn,
      little + "element vertex " + many + "\n" + attributes + "end_header\n" + torn,
      little + "element face 30000\n" + list + "element vertex 1\n" + vertex + "end_header\n" + faces + "abc",
      little + "element face 1\nproperty list uint uchar vertex_index\nelement vertex 1\n" + vertex +
          "end_header\n\xff\xff\xff\xff" + faces,
      little + "element nothing " + many + "\nelement vertex 1\n" + vertex + "end_header\nabc",
      std::string(80, ' ') + "\xff\xff\xff\xff" + faces,
      solid + "endsolid\n",
      "<bodies>" + repeated("<body name=''><points/><faces/></body>", 3000) + "</bodies>",
      "<body><surfaces>" + repeated("<surface/>", 20000) + "</surfaces><points/><faces/></body>",
      "<body><points><point x='0' y='0' z='0'/></points><faces><face points='" + repeated("0 ", 60000) +
          "'/></faces></body>",
      "<body><points><point x='0' y='0' z='0'/></points><edges>" + repeated("<edge points='0 0'/>", 9000) +
          "</edges><faces/></body>",
  };
  for (const std::string& s : files) {
    INFO(s.substr(0, 60));
    const std::size_t before = test::bytes_now;
    test::bytes_most = before;
    {
      const auto r = irg::read_mesh<double>(s);
      CHECK(test::bytes_most - before <= 64 * s.size() + (std::size_t{1} << 20));
      if (r) CHECK(irg::validate(*r) == irg::mesh_finding{});
    }
    CHECK(test::bytes_now == before);
  }
}
