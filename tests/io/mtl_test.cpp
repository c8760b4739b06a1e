// SPDX-License-Identifier: MIT
#include <irg/io/mtl.hpp>

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "support/check_both.hpp"
#include "support/mesh_files.hpp"

namespace {

using irg::read_mtl;

constexpr std::string_view two =
    "# by hand\nnewmtl red wood\nKa 0.1 0.2 0.3\n\tKd 1e0 0.5 0\nKs 0.25\nNs 40 # sharp\nd 0.75\nillum 2\nmap_Kd -s 2 "
    "2 2 a "
    "b.png\nbump c.png\n\nnewmtl glass\nTr 0.75\nNs 0\nKd spectral a.rfl\nKs xyz 1 2 3\nd -halo 0.5\n";

std::string outcome(std::string_view text) {
  const auto r = read_mtl(text);
  if (r) return "";
  REQUIRE(test::place_exists(text, r.error()));
  REQUIRE(std::strlen(r.error().message) > 10);
  return std::to_string(r.error().line) + ":" + std::to_string(r.error().column) + " " + r.error().message;
}

}  // namespace

TEST_CASE("mtl: materials by hand, at compile time, too") {
  CHECK_BOTH([] {
    const auto r = read_mtl<float>(two);
    if (!r || r->size() != 2) return false;
    const irg::mtl_material<float>&a = (*r)[0], &b = (*r)[1];
    return std::string_view(a.name) == "red wood" && a.reflection.ambient == irg::rgb<float>{0.1f, 0.2f, 0.3f} &&
           a.reflection.diffuse == irg::rgb<float>{1, 0.5f, 0} &&
           a.reflection.specular == irg::rgb<float>{0.25f, 0.25f, 0.25f} && a.reflection.shininess == 40 &&
           a.opacity == 0.75f && std::string_view(a.texture) == "-s 2 2 2 a b.png" &&
           std::string_view(b.name) == "glass" && b.opacity == 0.5f && b.reflection.shininess == 1 &&
           b.reflection.diffuse == irg::rgb<float>{1, 1, 1} && b.reflection.specular == irg::rgb<float>{} &&
           b.texture.empty();
  }());
  CHECK_BOTH(read_mtl("\n\nNs 1").error().line == 3);
  CHECK_BOTH(read_mtl("")->empty());
}

TEST_CASE("mtl: what is wrong is said where it stands") {
  CHECK(outcome("Kd 1 1 1") == "1:1 statement stands before the first material");
  CHECK(outcome("newmtl \n") == "1:8 material has no name");
  CHECK(outcome("newmtl a\nKd 1 1") == "2:7 colour has neither one number nor three");
  CHECK(outcome("newmtl a\nKd") == "2:3 colour has neither one number nor three");
  CHECK(outcome("newmtl a\nKd 1 -1 1") == "2:6 number is negative");
  CHECK(outcome("newmtl a\nKd 1 1e999 1") == "2:6 number is too large");
  CHECK(outcome("newmtl a\nKd nan 1 1") == "2:4 number is not finite");
  CHECK(outcome("newmtl a\nNs x") == "2:4 expected a decimal number");
  CHECK(outcome("newmtl a\nNs\n") == "2:3 statement has no number");
  CHECK(outcome("newmtl a\nNs -1") == "2:4 number is negative");
  CHECK(outcome("newmtl a\nd 1.5") == "2:3 opacity is more than 1");
  CHECK(outcome("newmtl a\nTr 2") == "2:4 opacity is more than 1");
}

TEST_CASE("mtl: libraries are named, and opened by the caller alone, beside the model alone") {
  CHECK_BOTH(irg::material_libraries("# mtllib no\nmtllib a b.mtl \nv 0 0 0\r\n mtllib\tc.mtl\nmtllib\nmtllibs d") ==
             std::vector<std::string_view>{"a b.mtl", "c.mtl"});
  CHECK_BOTH(irg::material_libraries("\xEF\xBB\xBFmtllib a.mtl") == std::vector<std::string_view>{"a.mtl"});
  for (const char* name : {"a.mtl", "a b", "..a", "a..mtl", "\xc3\xa9"}) CHECK(irg::is_plain_file_name(name));
  for (const char* name : {"", ".", "..", "/etc/passwd", "../a", "a/b", "a\\b", "C:a", "..\\a"})
    CHECK(!irg::is_plain_file_name(name));
  CHECK(!irg::is_plain_file_name(std::string_view("a\0b", 3)));

  int opened = 0;
  const auto open = [&](std::string_view name) -> irg::result<std::string> {
    ++opened;
    if (name == "missing.mtl") return irg::parse_error{0, 0, "file does not exist"};
    return std::string(name == "bad.mtl" ? "Ns 1" : two);
  };
  const auto materials = irg::read_materials<double>("mtllib a.mtl\nmtllib b.mtl\n", open);
  REQUIRE(materials);
  CHECK(materials->size() == 4);
  CHECK(opened == 2);
  opened = 0;
  std::string many = "mtllib b\nmtllib a\n";  // or a text of 1 MB could ask for 10^5 times its library
  for (int i = 0; i < 1000; ++i) many += "mtllib a\nmtllib b\n";
  const auto once = irg::read_materials<double>(many, [&](std::string_view name) -> irg::result<std::string> {
    ++opened;
    return "newmtl " + std::string(name);
  });
  REQUIRE(once);
  REQUIRE(once->size() == 2);
  CHECK(std::string_view((*once)[0].name) == "b");
  CHECK(opened == 2);
  CHECK(irg::read_materials<double>("v 0 0 0\n", open)->empty());
  CHECK(std::string(irg::read_materials<double>("mtllib missing.mtl", open).error().message) == "file does not exist");
  CHECK(irg::read_materials<double>("mtllib bad.mtl", open).error().line == 1);
  opened = 0;
  std::vector<std::string> asked;
  const auto beside =
      irg::read_materials<double>("mtllib ./b c.mtl\nmtllib b c.mtl\nmtllib .\\a\nmtllib ././a\n mtllib \t./.a\r\n",
                                  [&](std::string_view name) -> irg::result<std::string> {
                                    asked.emplace_back(name);
                                    return std::string("newmtl x");
                                  });
  REQUIRE(beside);
  CHECK(beside->size() == 3);  // a library is one under all its names
  CHECK(asked == std::vector<std::string>{"b c.mtl", "a", ".a"});
  for (const char* name : {"./", "./.", "./..", "./../a", ".//a", "./a/b", "/./a", "a/./b", "./C:a", "...", ".\\..\\a",
                           "./a/../b", "./\\a"}) {
    const auto elsewhere = irg::read_materials<double>("mtllib " + std::string(name), open);
    CHECK((elsewhere || std::string(elsewhere.error().message) == "library of materials is not beside the model"));
    CHECK(elsewhere.has_value() == (std::string_view(name) == "..."));
  }
  CHECK_BOTH([] {
    const auto found = [](std::string_view name) {
      return irg::result<std::string_view>(std::string_view(name == "a" ? "newmtl x" : "newmtl"));
    };
    return irg::read_materials<float>("mtllib ./a", found).has_value();
  }());
  opened = 0;
  CHECK(std::string(irg::read_materials<double>("mtllib ../../secret", open).error().message) ==
        "library of materials is not beside the model");
  CHECK(opened == 0);
}

TEST_CASE("mtl: disorder ends with a list or a place") {
  test::random r(6);
  const char* const words[] = {"newmtl ", "Ka ",       "Kd ",  "Ks ", "Ns ",  "d ",  "Tr ",  "map_Kd ",
                               "-halo ",  "spectral ", "xyz ", "1 ",  "0.5 ", "-1 ", "nan ", "1e999",
                               "#",       "\n",        "\r",   " ",   "x",    "\\\n"};
  for (int trial = 0; trial < 20000; ++trial) {
    std::string s = r.integer(0, 1) == 0 ? "newmtl a\n" : "";
    for (std::int64_t k = r.integer(0, 30); k > 0; --k) s += words[r.integer(0, 21)];
    outcome(s);
  }
}
