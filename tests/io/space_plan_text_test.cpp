// SPDX-License-Identifier: MIT
#include <irg/io/space_plan_text.hpp>

#include <string>
#include <string_view>
#include <vector>

#include "support/check_both.hpp"
#include "support/space_house.hpp"

namespace {

// A cube and a pyramid on it, with a hatch between them.
constexpr std::string_view hut =
    "point 0 0 0\npoint 4 0 0\npoint 4 4 0\npoint 0 4 0\n"  // 1 to 4
    "point 0 0 4\npoint 4 0 4\npoint 4 4 4\npoint 0 4 4\n"  // 5 to 8
    "point 2 2 6 # the top\n"
    "cell room\nface 4 3 2 1\nface 5 6 7 8\nface 1 2 6 5\nface 2 3 7 6\nface 3 4 8 7\nface 4 1 5 8\n"
    "cell roof\nface 8 7 6 5\nface 5 6 9\nface 6 7 9\nface 7 8 9\nface 8 5 9\n"
    "point 1 1 4\npoint 3 1 4\npoint 3 3 4\n"
    "portal room roof 10 11 12\n";  // line 26

std::string with(std::string_view part, std::string_view other) {
  std::string text(hut);
  return text.replace(text.find(part), part.size(), other);
}
constexpr bool is_refused(std::string_view text, std::size_t line, std::size_t column, std::string_view part) {
  const auto house = irg::read_space_plan(text);
  return !house && house.error().line == line && house.error().column == column &&
         std::string_view(house.error().message).find(part) != part.npos;
}

std::string text_of(const irg::named_plan<irg::space_plan<double>>& house) {
  const auto bytes = irg::encode_plan(house);
  return {bytes.begin(), bytes.end()};
}

TEST_CASE("space_plan_text: what is read is written, and read again") {
  CHECK_BOTH(irg::read_space_plan(hut)->names[1] == irg::part_name("roof"));
  CHECK_BOTH(irg::read_space_plan(hut)->plan.cells[1].size() == 5);
  CHECK_BOTH(irg::read_space_plan(hut)->plan.faces[0].size() == 6);
  CHECK_BOTH(irg::read_space_plan("")->plan.cells.empty());
  CHECK_BOTH(irg::read_space_plan<float>(hut)->plan.cells[0][0].y == 4);
  CHECK_BOTH(irg::is_space_plan(" # a hut\n point 0 0 0"));
  CHECK_BOTH(!irg::is_space_plan("cell a"));
  CHECK_BOTH(!irg::is_space_plan(""));
  const auto house = irg::read_space_plan(hut);
  CHECK(*irg::read_space_plan(text_of(*house)) == *house);
  const auto turned = irg::read_space_plan(with("10 11 12", "12 11 10"));
  REQUIRE(turned.has_value());
  CHECK(turned->plan.portals[0].first == 0);
  CHECK(irg::validate(turned->plan) == irg::space_plan_finding{});
  test::random r(5);
  for (int i = 0; i < 6; ++i) {
    irg::named_plan<irg::space_plan<double>> other{test::space_house(r, 3, 2, 1 + i % 2).plan, {}};
    for (auto& c : other.plan.cells)
      for (auto& v : c) v.x /= 2;
    for (auto& p : other.plan.portals)
      for (auto& v : p.ring) v.x /= 2;
    for (std::size_t c = 0; c < other.plan.cells.size(); ++c)
      other.names.push_back(irg::part_name("room" + std::to_string(c)));
    const auto once = irg::read_space_plan(text_of(other));  // with corners as the faces name them
    REQUIRE(once.has_value());
    const auto again = irg::read_space_plan(text_of(*once));
    REQUIRE(again.has_value());
    CHECK(*again == *once);
    CHECK(once->plan.portals == other.plan.portals);
  }
}

TEST_CASE("space_plan_text: what is refused, and where") {
  CHECK_BOTH(is_refused("room a", 1, 1, "none of point, cell, face and portal"));
  CHECK_BOTH(is_refused("point 1 2", 1, 10, "line ends where a number"));
  CHECK_BOTH(is_refused("\xEF\xBB\xBFpoint 1 2", 1, 10, "line ends where a number"));  // a mark of UTF-8
  CHECK_BOTH(is_refused("point 1 2 3 4", 1, 13, "nothing more"));
  CHECK_BOTH(is_refused("point 1 nan 3", 1, 9, "not finite"));
  CHECK_BOTH(is_refused("point 1 1e999 3", 1, 9, "too large"));
  CHECK_BOTH(is_refused("face 1 2 3", 1, 1, "no cell stands before"));
  CHECK_BOTH(is_refused("cell a\ncell a", 2, 6, "taken"));
  CHECK_BOTH(is_refused("cell a\nface 1", 2, 6, "no point of this number"));
  CHECK_BOTH(is_refused("point 0 0 0\ncell a\nface 1.5", 3, 6, "whole number"));
  CHECK_BOTH(is_refused("cell a", 1, 1, "fewer than four faces"));
  CHECK_BOTH(is_refused("portal a b", 1, 8, "no cell of this name"));
  CHECK_BOTH(is_refused("cell a\nportal a", 2, 9, "the line ends where a cell's name"));
  CHECK(is_refused(with("face 5 6 9\n", "face 9 6 5\n"), 19, 1, "not convex"));
  CHECK(is_refused(with("point 2 2 6", "point 2 2 3"), 18, 1, "not convex"));
  CHECK(is_refused(with("face 5 6 9", "face 5 6"), 19, 1, "fewer than three corners"));
  CHECK(is_refused(with("point 4 4 4", "point 4 4 5"), 12, 1, "not flat"));
  CHECK(is_refused(with("face 4 3 2 1", "face 4 2 3 1"), 11, 1, "the face is not convex"));
  CHECK(is_refused(with("face 8 5 9\n", "face 8 5 9 # \nface 5 6 9\n"), 17, 1, "do not close it"));
  CHECK(is_refused(with("room roof", "room room"), 26, 1, "mirrors are not supported"));
  CHECK(is_refused(with("10 11 12", "10 11"), 26, 1, "no area"));
  CHECK(is_refused(with("10 11 12", "10 11 10"), 26, 1, "no area"));
  CHECK(is_refused(with("10 11 12", "10 11 12 9"), 26, 1, "not flat"));
  CHECK(is_refused(with("10 11 12", "1 2 6 5"), 26, 1, "both sides"));
  CHECK(is_refused(with("point 3 1 4", "point 9 1 4"), 26, 1, "in a face of both"));
  CHECK(is_refused(with("10 11 12", "10 11 13"), 26, 24, "no point of this number"));
}

TEST_CASE("space_plan_text: every text cut short or with a byte changed is read or refused with a place in it") {
  const std::string text(hut);
  for (std::size_t i = 0; i <= text.size(); ++i)
    for (const char c : {'\0', '#', '-', '9', '\n', 'x'}) {
      std::string other = c == '\0' ? text.substr(0, i) : text;
      if (c != '\0' && i < text.size()) other[i] = c;
      const auto house = irg::read_space_plan(other);
      if (house) continue;
      CHECK(house.error().line >= 1);
      CHECK(house.error().line <= 28);
    }
}

}  // namespace
