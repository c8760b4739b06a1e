// SPDX-License-Identifier: MIT
#include <irg/io/plan_text.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "support/check_both.hpp"
#include "support/house_plans.hpp"

namespace {

constexpr std::string_view rooms =
    "# two rooms\n"
    "cell hall 0 0  4 0  4 3  0 3\n"
    "heights hall 0 2.5 # low\n"
    "cell study 4 0 8 0 8 3 4 3\n"
    "portal hall study 4 1 4 2\n";

// Whether the text, after the rooms or alone, is refused at this place.
constexpr bool refused(std::string_view text, std::size_t line, std::size_t column, std::string_view part) {
  const auto plan = irg::read_plan(text);
  return !plan && plan.error().line == line && plan.error().column == column &&
         std::string_view(plan.error().message).find(part) != part.npos;
}

TEST_CASE("plan_text: what is read is written, and read again") {
  CHECK_BOTH(irg::read_plan(rooms)->names[1] == irg::part_name("study"));
  CHECK_BOTH(irg::read_plan(rooms)->plan.cells[0].ceiling == 2.5);
  CHECK_BOTH(irg::read_plan(rooms)->plan.portals.size() == 1);
  CHECK_BOTH(irg::read_plan("")->plan.cells.empty());
  const auto zero = irg::read_plan(std::string_view("cell a\0b 0 0 1 0 0 1\n", 21));  // any byte but blanks and #
  REQUIRE(zero.has_value());
  const auto with_zero = irg::encode_plan(*zero);
  CHECK(*irg::read_plan(std::string(with_zero.begin(), with_zero.end())) == *zero);
  CHECK_BOTH(irg::read_plan(" # nothing")->plan.cells.empty());
  CHECK_BOTH([] {
    const auto plan = *irg::read_plan(rooms);
    const auto bytes = irg::encode_plan(plan);
    std::vector<char> text(bytes.size(), ' ');
    for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(bytes[i]);
    return *irg::read_plan(std::string_view(text.data(), text.size())) == plan;
  }());
  test::random r(5);
  for (int i = 0; i < 10; ++i) {
    irg::named_plan<irg::cell_plan<double>> house{test::random_house<double>(r, 200, 7), {}};
    for (std::size_t c = 0; c < house.plan.cells.size(); ++c)
      house.names.push_back(irg::part_name("room" + std::to_string(c)));
    house.plan.cells[0].ceiling = 1 / (r.unit() + 0.1);
    const auto bytes = irg::encode_plan(house);
    const auto again = irg::read_plan(std::string(bytes.begin(), bytes.end()));
    REQUIRE(again.has_value());
    CHECK(*again == house);
  }
}

TEST_CASE("plan_text: every text cut short or with a byte changed is read or refused with a place in it") {
  const std::string text(rooms);
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const auto plan = irg::read_plan(std::string_view(text).substr(0, i));
    if (!plan) CHECK(plan.error().line >= 1);
    if (!plan) CHECK(plan.error().line <= 6);
    for (const char c : {'\0', '#', '-', '9', '\n', 'x'}) {
      std::string other = text;
      if (i < text.size()) other[i] = c;
      const auto read = irg::read_plan(other);
      if (!read) CHECK(read.error().column >= 1);
    }
  }
}

TEST_CASE("plan_text: errors with their places") {
  CHECK_BOTH(refused("room a 0 0", 1, 1, "none of cell"));
  CHECK_BOTH(refused("cell", 1, 5, "name"));
  CHECK_BOTH(refused("\xEF\xBB\xBF cell", 1, 6, "name"));  // a byte order mark does not count
  CHECK_BOTH(refused("cell a 0 0 1 0 1", 1, 17, "a number is expected"));
  CHECK_BOTH(refused("cell a 0 0 1 0 1 x", 1, 18, "decimal number"));
  CHECK_BOTH(refused("cell a 0 0 1 0 nan 1", 1, 16, "not finite"));
  CHECK_BOTH(refused("cell a 0 0 1 0 1e999 1", 1, 16, "too large"));
  CHECK_BOTH(refused("cell a 0 0 1 0", 1, 1, "fewer than three"));
  CHECK_BOTH(refused("\n cell a 0 0 4 0 1 1 0 4", 2, 2, "not convex"));
  CHECK_BOTH(refused("cell a 0 0 0 1 1 0", 1, 1, "counter-clockwise"));
  CHECK_BOTH(refused("cell a 0 0 1 0 0 1\ncell a 0 0 1 0 0 1", 2, 6, "taken"));
  CHECK_BOTH(refused("cell a 0 0 1 0 0 1\nheights a 2 1", 2, 1, "below"));
  CHECK_BOTH(refused("cell a 0 0 1 0 0 1\nheights a 1 2\nheights a 1 2", 3, 1, "twice"));
  CHECK_BOTH(refused("cell a 0 0 1 0 0 1\nheights b 2 1", 2, 9, "no cell"));
  CHECK_BOTH(refused("portal a b 0 0 1 1", 1, 8, "no cell"));
  CHECK_BOTH(refused("cell a 0 0 1 0 0 1\nportal a a 0 0 1 0", 2, 1, "mirrors"));
  CHECK_BOTH(refused("cell a 0 0 1 0 0 1\nheights a 0 1 2", 2, 15, "nothing more"));
  CHECK(refused(std::string(rooms) + "portal hall study 4 1 4 2", 6, 1, "overlaps"));
  CHECK(refused(std::string(rooms) + "portal hall study 4 1 4 1", 6, 1, "one point"));
  CHECK(refused(std::string(rooms) + "portal hall study 3 1 4 1", 6, 1, "side of both"));
}

// A name that counts how often one is looked at.
struct watched_name {
  static inline std::size_t looks = 0;
  std::string text;
  explicit watched_name(std::string_view t) : text(t) {}
  operator std::string_view() const {
    ++looks;
    return text;
  }
};

// Two hundred names which the hash that once kept them put into one slot.
std::vector<std::string> colliding_names() {
  std::vector<std::string> names;
  for (int i = 0; names.size() < 200; ++i) {
    const std::string name = std::to_string(i);
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : name) hash = (hash ^ static_cast<std::uint8_t>(c)) * 1099511628211u;
    if (((hash ^ hash >> 32) & 511) == 0) names.push_back(name);
  }
  return names;
}

TEST_CASE("plan_text: names are found among any others") {
  test::random r(11);
  std::vector<std::string> names = colliding_names();
  for (int i = 0; i < 400; ++i) {  // of few letters, so that most begin alike or are the beginning of another
    std::string name;
    for (std::int64_t k = r.integer(1, 12); k > 0; --k) name += "\1a\377\0"[r.integer(0, 3)];
    names.push_back(name);
  }
  std::string text;
  for (const std::string& name : names) text += name + '\n';
  irg::detail::plan_lines<watched_name> lines(text);
  std::map<std::string, std::uint32_t> known;
  for (const std::string& name : names) {
    REQUIRE(lines.cursor.skip_space());
    const char* const at = lines.cursor.at;
    std::uint32_t cell = 0;
    const bool is_old = known.contains(name);
    CHECK(lines.known_cell(cell) == is_old);
    CHECK((!is_old || cell == known[name]));
    lines.cursor.at = at;
    watched_name::looks = 0;
    CHECK(lines.new_cell() == !is_old);
    CHECK(watched_name::looks <= 1);
    if (!is_old) known[name] = static_cast<std::uint32_t>(known.size());
    for (const auto& [old, number] : known) {
      if (known.size() % 50 != 0) break;
      irg::detail::plan_lines<watched_name>& same = lines;
      const irg::detail::text_cursor before = same.cursor;
      same.cursor = irg::detail::text_cursor(old, '#');
      CHECK(same.known_cell(cell));
      CHECK(cell == number);
      same.cursor = before;
    }
  }
}

TEST_CASE("plan_text: visible sets as bytes") {
  test::random r(6);
  for (const int levels : {0, 2, 3, 7}) {
    const auto sets = irg::potentially_visible(test::random_house<double>(r, 150, levels));
    const auto bytes = irg::encode_visible_sets(sets);
    const std::string text(bytes.begin(), bytes.end());
    const auto again = irg::read_visible_sets(text);
    REQUIRE(again.has_value());
    CHECK(*again == sets);
    CHECK(!irg::read_visible_sets(text + "x"));
    for (std::size_t i = 0; i < text.size(); i += 1 + text.size() / 50)
      CHECK(!irg::read_visible_sets(std::string_view(text).substr(0, i)));
  }
  const auto none = irg::encode_visible_sets(irg::visible_sets{});
  CHECK(irg::read_visible_sets(std::string(none.begin(), none.end())).has_value());
  CHECK(irg::read_visible_sets("visible cells 1 unfinished 0\n\3").error().column == 30);
  CHECK(irg::read_visible_sets("visible cells 2147483647 unfinished 0\n").error().line == 0);
  CHECK(irg::read_visible_sets("visible cells -1 unfinished 0\n").error().line == 1);
  CHECK(irg::read_visible_sets("visible  rooms 1 unfinished 0\n").error().column == 10);
}

}  // namespace
