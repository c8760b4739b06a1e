// SPDX-License-Identifier: MIT
#include <irg/io/body_xml.hpp>

#include <chrono>
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

using irg::read_body_xml;
using irg::rgba8;
using test::as_text;
using body = irg::stored_body<double>;

constexpr std::string_view triangle =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<!-- by hand -->\n"
    "<body name='a &amp; b&#x21;'>\n"
    "  <surfaces><surface colour=\"#ff8000\" diffuse=\"1 0.5 0.25\" shininess=\"40\"/></surfaces>\n"
    "  <points>\n"
    "    <point x=\"0\" y=\"0\" z=\"0\"/>\n"
    "    <point x=\"1\" y=\"0\" z=\"0\"></point>\n"
    "    <point z=\"-0.5\" y=\"1e0\" x=\"0\"/>\n"
    "  </points>\n"
    "  <edges><edge points=\"0 2\"/></edges>\n"
    "  <faces><face points=\"0 1 2\" surface=\"0\"/><face points=\"2 1 0\"/></faces>\n"
    "</body>\n";

std::string outcome(std::string_view text) {
  const auto r = read_body_xml(text);
  if (r) {
    for (const body& b : *r) REQUIRE(irg::validate(b.shape) == irg::mesh_finding{});
    REQUIRE(irg::validate(irg::to_mesh(*r)) == irg::mesh_finding{});
    return "";
  }
  REQUIRE(test::place_exists(text, r.error()));
  REQUIRE(std::string_view(r.error().message).size() > 10);
  return std::to_string(r.error().line) + ":" + std::to_string(r.error().column) + " " + r.error().message;
}
std::string damaged(std::string_view word, std::string_view other) {
  std::string text(triangle);
  return outcome(text.replace(text.find(word), word.size(), other));
}
std::string repeated(std::string_view text, int count) {
  std::string s;
  for (int i = 0; i < count; ++i) s += text;
  return s;
}
/// Within the points of a body.
std::string around(std::string_view text) { return "<body><points>" + std::string(text) + "</points><faces/></body>"; }

}  // namespace

TEST_CASE("body xml: a triangle by hand, at compile time, too") {
  CHECK_BOTH([] {
    const auto r = read_body_xml<float>(triangle);
    if (!r || r->size() != 1) return false;
    const irg::stored_body<float>& b = (*r)[0];
    return std::string_view(b.name) == "a & b!" &&
           b.shape.positions == std::vector<irg::point<float, 3>>{{0, 0, 0}, {1, 0, 0}, {0, 1, -0.5f}} &&
           b.edges == std::vector<irg::stored_edge>{{0, 2}} && b.shape.face_count() == 2 && b.surface_of_face[0] == 0 &&
           b.surface_of_face[1] == irg::no_index && b.surfaces[0].colour == rgba8{255, 128, 0, 255} &&
           b.surfaces[0].reflection.diffuse == irg::rgb<float>{1, 0.5f, 0.25f} &&
           b.surfaces[0].reflection.ambient == irg::rgb<float>{1, 1, 1} && b.surfaces[0].reflection.shininess == 40;
  }());
  CHECK_BOTH([] {
    const auto r = read_body_xml("<body>\n<points><point x='1'/></points></body>");
    return !r && r.error().line == 2 && r.error().column == 10;
  }());
}

TEST_CASE("body xml: several bodies make one mesh of parts") {
  const std::string one(triangle.substr(triangle.find("<body")));
  CHECK(read_body_xml("<body name='a\r\nb\rc\nd\t&#13;&#10;e'><points/><faces/></body>")->front().name ==
        irg::part_name("a b c d \r\ne"));
  const auto r = read_body_xml("<bodies>" + one + one + "<body name='none'><points/><faces/></body></bodies>");
  REQUIRE(r);
  REQUIRE(r->size() == 3);
  const auto m = irg::to_mesh(*r);
  CHECK(irg::validate(m) == irg::mesh_finding{});
  CHECK(m.positions.size() == 6);
  CHECK(m.corner(2, 2).position == 5);
  REQUIRE(m.parts.size() == 2);
  CHECK(std::string(m.parts[1].object) == "a & b!");
}

TEST_CASE("body xml: what belongs to others is passed over") {
  CHECK(outcome("<body xmlns='a' xmlns:o='b' o:id='1'><o:x y='z'><point/><o:deep/></o:x><points><?other ?></points>"
                "<faces o:n='1'/></body><!-- end --> \n<?end?>") == "");
  CHECK(outcome("\xEF\xBB\xBF<body><points></points \n ><faces\t/></body>") == "");
  CHECK(outcome("<?xml version='1.1' encoding='us-ascii' standalone='yes' ?><body><points/><faces/></body>") == "");
}

TEST_CASE("body xml: an element with a prefix is passed over with the text that it holds") {
  CHECK_BOTH([] {
    const auto r = read_body_xml("<body><o:a>text</o:a><points/><faces/></body>");
    return r && r->size() == 1;
  }());
  // Wherever an element may stand, whatever stands in it.
  const std::string held[] = {"text",
                              " 1 < 2 ",
                              "a &amp; b &#x41; &lt;",
                              "x<![CDATA[ <b> & ]] > &no; ]]>y",
                              "<![CDATA[]]>",
                              "<![CDATA[]]]]>",
                              "caf\xc3\xa9 > ] ]> ]]",
                              "a<p/>b<o:q r='s'>c<point/>d</o:q>e<!-- f -->g<?h i?>j"};
  const auto places = [](const std::string& e) {
    return std::vector<std::string>{"<bodies>" + e + "<body><points/><faces/></body>" + e + "</bodies>",
                                    "<body>" + e + "<points/>" + e + "<faces/></body>",
                                    "<body><points><point x='0' y='0' z='0'>" + e + "</point>" + e +
                                        "</points><edges><edge points='0 0'>" + e + "</edge></edges><faces>" + e +
                                        "<face points='0 0 0'>" + e + "</face></faces></body>"};
  };
  for (const std::string& h : held) {
    const bool is_bad = h == held[1];
    for (const std::string& text : places("<o:note o:id='7'>" + h + "</o:note>")) {
      INFO(text);
      const std::string said = outcome(text);
      CHECK((said == "") == !is_bad);
      if (is_bad) CHECK(said.find("expected the name of an element") != std::string::npos);
    }
    if (h.starts_with("<!")) continue;
    for (const std::string& text : places("<note>" + h + "</note>"))  // without a prefix it is unknown
      CHECK(outcome(text).find("element is not known here") != std::string::npos);
    for (const std::string& text : places(h))
      CHECK(outcome(text).find("text stands where only elements may stand") != std::string::npos);
  }
  const auto within = [](std::string_view text) { return outcome("<body><o:a>" + std::string(text)); };
  CHECK(within("b</o:a>c<points/><faces/></body>") == "1:19 text stands where only elements may stand");
  CHECK(within("<o:b/></o:a>c<points/><faces/></body>") == "1:24 text stands where only elements may stand");
  CHECK(within("<o:b>c</o:b></o:a><![CDATA[]]>") == "1:30 document types, entities and character data are not read");
  CHECK(within("b &other;</o:a>") == "1:14 entity is none of the five that are read");
  CHECK(within("b &</o:a>") == "1:14 entity is none of the five that are read");
  CHECK(within("b ]]> c</o:a>") == "1:14 end of character data stands in text");
  CHECK(within("<![CDATA[ ]>") == "1:24 character data do not end");
  CHECK(within("<![cdata[ ]]>") == "1:12 document types, entities and character data are not read");
  CHECK(within("<!DOCTYPE a>") == "1:12 document types, entities and character data are not read");
  CHECK(within("b") == "1:13 text ends before its elements do");
  CHECK(within("b</o:b>") == "1:13 element ends that is not the last one begun");
  CHECK(outcome("<o:a>b</o:a>") == "1:2 first element is neither bodies nor body");
  CHECK(outcome("<body><o:a>" + repeated("&#", 500000) + "</o:a>") == "1:12 entity is none of the five that are read");
  CHECK(outcome("<body><o:a>" + repeated("]", 5000000) + repeated("<![CDATA[]]>", 100000) +
                "</o:a><points/><faces/></body>") == "");
}

TEST_CASE("body xml: document types, entities and other documents are refused") {
  const std::string laughs =
      "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY lol \"lol\"><!ENTITY lol2 \"&lol;&lol;\">]>\n<body "
      "name=\"&lol2;\"/>";
  CHECK(outcome(laughs) == "2:1 document types, entities and character data are not read");
  CHECK(outcome("<!DOCTYPE a SYSTEM \"file:///etc/passwd\"><body/>") ==
        "1:1 document types, entities and character data are not read");
  CHECK(outcome("<body name='&other;'/>") == "1:13 entity is none of the five that are read");
  CHECK(outcome("<body name='&#0;'/>") == "1:13 entity is none of the five that are read");
  CHECK(outcome("<body name='&#xD800;'/>") == "1:13 entity is none of the five that are read");
  CHECK(outcome("<body name='&#99999999999999999999;'/>") == "1:13 entity is none of the five that are read");
  CHECK(outcome("<body name='&amp'/>") == "1:13 entity is none of the five that are read");
  CHECK(outcome(around("<![CDATA[x]]>")) == "1:15 document types, entities and character data are not read");
  CHECK(outcome("<svg/>") == "1:2 first element is neither bodies nor body");
}

TEST_CASE("body xml: what is not well-formed is said where it stands") {
  CHECK(outcome("") == "1:1 text has no element");
  CHECK(outcome("<?xml version='1.0'?>") == "1:22 text has no element");
  CHECK(outcome("x<body/>") == "1:1 text stands where only elements may stand");
  CHECK(outcome("<body>") == "1:7 text ends before its elements do");
  CHECK(outcome("<body") == "1:6 expected an attribute or the end of a tag");
  CHECK(outcome("<body></points>") == "1:7 element ends that is not the last one begun");
  CHECK(outcome("</body>") == "1:1 element ends that is not the last one begun");
  CHECK(outcome("<body name='a' name='b'/>") == "1:16 attribute stands there twice");
  CHECK(outcome("<body name='a'b='b'/>") == "1:15 expected a blank before an attribute");
  CHECK(outcome("<body name/>") == "1:11 expected = behind the name of an attribute");
  CHECK(outcome("<body name=a/>") == "1:12 expected a value in quotes");
  CHECK(outcome("<body name='a") == "1:14 value does not end");
  CHECK(outcome("<body name='<'/>") == "1:13 value holds the character <");
  CHECK(outcome("<body><points/><faces/></body><body/>") == "1:31 text goes on after its first element");
  CHECK(outcome("< body/>") == "1:2 expected the name of an element");
  CHECK(outcome("<!-- a -- b --><body/>") == "1:8 two dashes stand within a comment");
  CHECK(outcome("<!-- a") == "1:7 comment does not end");
  CHECK(outcome("<?a b") == "1:6 instruction does not end");
  CHECK(outcome("<? a?>") == "1:3 expected a name");
  CHECK(outcome(" <?xml version='1.0'?><body/>") == "1:4 declaration is not at the head");
  CHECK(outcome("<?xml version='2.0'?><body/>") == "1:16 version of XML is not 1");
  CHECK(outcome("<?xml version='1.x'?><body/>") == "1:16 version of XML is not 1");
  CHECK(outcome("<?xml?><body/>") == "1:8 version of XML is not 1");
  CHECK(outcome("<?xml version='1.0' coding='UTF-8'?><body/>") ==
        "1:21 declaration has version, encoding and standalone, in this order");
  CHECK(outcome("<?xml encoding='UTF-8' version='1.0'?><body/>") ==
        "1:24 declaration has version, encoding and standalone, in this order");
  CHECK(outcome("<?xml version='1.0' standalone='y'?><body/>") == "1:33 standalone is neither yes nor no");
  CHECK(outcome("<?a&b?><body/>") == "1:4 expected a blank behind the name of an instruction");
  CHECK(outcome("<?xml version='1.0' encoding='latin1'?><body/>") == "1:31 encoding is not UTF-8");
  CHECK(outcome(around("]]>")) == "1:15 text stands where only elements may stand");
  CHECK(outcome(std::string_view("<body\0/>", 8)) == "1:6 byte is no part of a character of UTF-8 that XML allows");
  for (const char* bad : {"\x80", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xff",
                          "\xef\xbf\xbf", "\x1b", "\xe2\x82"})
    CHECK(outcome("<body name='" + std::string(bad) + "'/>") ==
          "1:13 byte is no part of a character of UTF-8 that XML allows");
  CHECK(outcome("\xFF\xFE<").find("UTF-16") != std::string::npos);
}

TEST_CASE("body xml: what is no body is said where it stands") {
  CHECK(outcome("<body/>") == "1:2 body has no points or no faces");
  CHECK(damaged("<edges>", "<lines>") == "10:4 element is not known here");
  CHECK(damaged("name=", "title=") == "3:7 attribute is not known here");
  CHECK(damaged("<point x=\"0\" y=\"0\" z=\"0\"/>", "<point x=\"0\" y=\"0\"/>") == "6:6 element lacks an attribute");
  CHECK(damaged("1e0", "1e999") == "8:24 number is too large");
  CHECK(damaged("1e0", "NaN") == "8:24 number is not finite");
  CHECK(damaged("1e0", "") == "8:24 attribute has too few numbers");
  CHECK(damaged("1e0", "1 2") == "8:26 attribute has too many numbers");
  CHECK(damaged("1e0", repeated("1", 1000000)) == "8:24 number is too large");
  CHECK(damaged("0 1 2", "0 1") == "11:11 face has fewer than three corners");
  CHECK(damaged("0 1 2", "0 1 3") == "11:28 point is none of those that stand before");
  CHECK(damaged("0 1 2", "0 1 -1") == "11:28 point is none of those that stand before");
  CHECK(damaged("0 1 2", "0 1 99999999999999999999") == "11:28 point is none of those that stand before");
  CHECK(damaged("0 1 2", "0,1,2") == "11:24 expected a whole number");
  CHECK(damaged("\"0 2\"", "\"0\"") == "10:11 edge has other than two points");
  CHECK(damaged("\"0 2\"", "\"0 7\"") == "10:26 point is none of those that stand before");
  CHECK(damaged("surface=\"0\"", "surface=\"1\"") == "11:40 surface is none of those that stand before");
  CHECK(damaged("surface=\"0\"", "surface=\"0 0\"") == "11:11 face has other than one surface");
  CHECK(damaged("#ff8000", "orange") == "4:30 colour is not written as #rrggbb or #rrggbbaa");
  CHECK(damaged("#ff8000", "#ff80g0") == "4:30 colour is not written as #rrggbb or #rrggbbaa");
  CHECK(damaged("1 0.5 0.25", "1 -0.5 0.25") == "4:48 share of the light is negative");
  CHECK(damaged("\"40\"", "\"0\"") == "4:71 shininess is not larger than 0");
  CHECK(outcome(around("<point x='0' y='0' z='0'><point/></point>")) == "1:41 element is not known here");
}

TEST_CASE("body xml: size is bounded: depth, attributes, names") {
  CHECK(outcome(repeated("<a>", 1000000)).find("first element") != std::string::npos);
  CHECK(outcome("<body>" + repeated("<o:a>", 1000000)).find("elements are nested too deeply") != std::string::npos);
  CHECK(outcome("<body>" + repeated("<o:a>", 31) + repeated("</o:a>", 31) + "<points/><faces/></body>") == "");
  std::string attributes;
  for (int i = 0; i < 1000000; ++i) attributes += " o:a" + std::to_string(i) + "=''";
  CHECK(outcome("<body" + attributes + "/>").find("element has too many attributes") != std::string::npos);
  CHECK(outcome("<body name='" + std::string(10000000, 'x') + "'><points/><faces/></body>") == "");
  CHECK(outcome(around(std::string(10000000, ' '))) == "");
}

TEST_CASE_TEMPLATE("body xml: what was written reads as the same bodies", T, float, double) {
  test::random r(41 + sizeof(T));
  const char* names[] = {"", "cube", "a<b>&\"'c\"", " two\nlines\t\r ", "t\xc3\xa9ny\xe2\x82\xac\xf0\x9f\x98\x80"};
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<irg::stored_body<T>> bodies;
    for (std::int64_t k = r.integer(0, 3); k > 0; --k) {
      irg::stored_body<T> b;
      b.name = names[r.integer(0, 4)];
      b.shape = test::random_mesh<T>(r, 7, test::attributes::none);
      const auto count = static_cast<std::int64_t>(b.shape.positions.size());
      for (std::int64_t e = r.integer(0, 5); e > 0; --e) {
        const auto from = static_cast<std::uint32_t>(r.integer(0, count - 1));
        b.edges.push_back({from, static_cast<std::uint32_t>(r.integer(0, count - 1))});
      }
      const std::int64_t surfaces = r.integer(0, 3);
      for (std::int64_t s = 0; s < surfaces; ++s) {
        irg::stored_surface<T> to;
        const std::uint64_t bits = r.next();
        to.colour = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                     static_cast<std::uint8_t>(bits >> 16), static_cast<std::uint8_t>(bits >> 24)};
        to.reflection.diffuse.g = static_cast<T>(r.unit());
        to.reflection.specular.b = static_cast<T>(r.unit());
        to.reflection.shininess = static_cast<T>(100 * r.unit() + 1e-30);
        b.surfaces.push_back(to);
      }
      for (std::size_t f = 0; f < b.shape.face_count(); ++f)
        b.surface_of_face.push_back(r.integer(0, 3) == 0 || surfaces == 0
                                        ? irg::no_index
                                        : static_cast<std::uint32_t>(r.integer(0, surfaces - 1)));
      bodies.push_back(b);
    }
    const auto bytes = irg::encode_body_xml(bodies);
    REQUIRE(bytes);
    const auto again = read_body_xml<T>(as_text(*bytes));
    REQUIRE(again);
    CHECK(*again == bodies);
  }
}

TEST_CASE("body xml: what cannot be written is refused with the reason") {
  const auto refusal = [](auto spoil) {
    body b = irg::store_body("cube", irg::shape_cube<double>());
    spoil(b);
    const auto bytes = irg::encode_body_xml(std::vector{b});
    return std::string(bytes ? "" : bytes.error().message);
  };
  CHECK(refusal([](body&) {}) == "");
  CHECK(refusal([](body& b) { b.name = "\x1b"; }) == "body's name holds bytes that XML does not allow");
  CHECK(refusal([](body& b) { b.name = "\xff"; }) == "body's name holds bytes that XML does not allow");
  CHECK(refusal([](body& b) { b.edges[0].to = 8; }) == "body has an edge without a point");
  CHECK(refusal([](body& b) { b.surface_of_face.pop_back(); }) ==
        "body has not one entry of surface_of_face for each face");
  CHECK(refusal([](body& b) { b.surface_of_face[0] = 1; }) == "body has a face whose surface does not exist");
  CHECK(refusal([](body& b) { b.surfaces[0].reflection.ambient.r = -1; }) ==
        "body has a surface whose shares of the light are none");
  CHECK(refusal([](body& b) { b.surfaces[0].reflection.shininess = std::numeric_limits<double>::quiet_NaN(); }) ==
        "body has a surface whose shininess is not larger than 0");
  CHECK_BOTH([] {
    irg::stored_body<double> b;
    b.surfaces.emplace_back();
    b.surfaces[0].reflection.shininess = std::numeric_limits<double>::infinity();
    return !irg::encode_body_xml(std::vector{b});
  }());
  CHECK(refusal([](body& b) { b.shape.positions[0][0] = std::numeric_limits<double>::infinity(); }) ==
        "mesh has a position that is not finite");
}

TEST_CASE("body xml: damage is noticed or leaves sound bodies") {
  const auto read = [](std::string_view s) -> irg::result<irg::mesh<double>> {
    const auto bodies = read_body_xml(s);
    if (!bodies) return bodies.error();
    return irg::to_mesh(*bodies);
  };
  CHECK(test::damage(std::string(triangle), read, 6000, 1) == static_cast<int>(triangle.size()) - 1);
  test::damage("<body><o:a>b&amp;<![CDATA[<c>]]>d<e f='g'>h</e></o:a><points/><faces/></body>", read, 6000, 2);
}
