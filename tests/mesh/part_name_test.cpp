// SPDX-License-Identifier: MIT
#include <irg/mesh/part_name.hpp>

#include <string>
#include <string_view>
#include <vector>

#include "support/check_both.hpp"

namespace {

using irg::part_name;

TEST_CASE("part_name: made of literals and strings of all kinds, and equal to them") {
  CHECK_BOTH(part_name("red car") == "red car");
  CHECK_BOTH(part_name("red car") != "red");
  CHECK_BOTH(part_name() == "");
  CHECK_BOTH(part_name(std::string_view("ab\0c", 4)).size() == 4);
  CHECK_BOTH(part_name(std::string_view("ab\0c", 4)) != "ab");
  CHECK_BOTH(part_name(std::vector<char>{'x', 'y'}) == "xy");
  CHECK(part_name(std::string("some name that is longer than a short string")) ==
        "some name that is longer than a short string");
}

TEST_CASE("part_name: becomes a string of the caller's type") {
  const part_name n("wheel");
  const std::string copy = n;
  const std::string_view seen = n;
  CHECK(copy == "wheel");
  CHECK(seen == "wheel");
  CHECK(seen.data() == n.data());
  CHECK(std::string(part_name()) == "");
  CHECK_BOTH(std::string_view(part_name("a b")) == "a b");
}

TEST_CASE("part_name: grows, and tells whether there is a name") {
  constexpr auto spelled = [] {
    part_name n;
    const bool nothing = n.empty();
    for (const char c : {'a', ' ', 'b'}) n.push_back(c);
    return nothing && !n.empty() && n.size() == 3 && n == "a b";
  };
  CHECK_BOTH(spelled());
}

}  // namespace
