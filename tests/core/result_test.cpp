// SPDX-License-Identifier: MIT
#include <irg/core/result.hpp>

#include <memory>
#include <string>
#include <type_traits>

#include "support/check_both.hpp"

namespace {

enum class digit_error { empty, no_digit };

constexpr irg::result<int, digit_error> digit(const char* text) {
  if (*text == '\0') return digit_error::empty;
  if (*text < '0' || '9' < *text) return digit_error::no_digit;
  return *text - '0';
}

constexpr irg::result<int> line_two(bool good) {
  if (!good) return irg::parse_error{2, 7, "a face names a vertex that does not exist"};
  return 42;
}

// A failure costs nothing to build and a success carries no error: neither default-constructs what it lacks.
struct no_default {
  int v;
  constexpr explicit no_default(int x) : v(x) {}
};
static_assert(std::is_constructible_v<irg::result<no_default>, irg::parse_error>);
static_assert(!std::is_default_constructible_v<irg::result<int>>);  // it is one of the two, always
static_assert(!std::is_convertible_v<irg::result<int>, bool>);      // explicit: a result of 0 is no failure
static_assert(std::is_copy_constructible_v<irg::result<int>>);
static_assert(!std::is_copy_constructible_v<irg::result<std::unique_ptr<int>>>);
static_assert(std::is_move_constructible_v<irg::result<std::unique_ptr<int>>>);

constexpr int changed_in_place() {
  irg::result<int> r = 1;
  *r += 41;
  return *r;
}

// Half of an even number; counts how often it is asked.
struct half {
  int* asked;
  constexpr irg::result<int, digit_error> operator()(int x) const {
    ++*asked;
    if (x % 2 != 0) return digit_error::no_digit;
    return x / 2;
  }
};

constexpr int halved_twice(const char* text, int on_failure, int asked_then) {
  int asked = 0;
  const int found = digit(text).and_then(half{&asked}).and_then(half{&asked}).value_or(on_failure);
  return asked == asked_then ? found : -1;
}

constexpr irg::result<void, digit_error> check(const char* text) {
  if (const auto d = digit(text); !d) return d.error();
  return {};
}

}  // namespace

TEST_CASE("result: a value") {
  CHECK_BOTH(digit("7").has_value());
  CHECK_BOTH(static_cast<bool>(digit("0")));
  CHECK_BOTH(*digit("7") == 7);
  CHECK_BOTH(changed_in_place() == 42);
  CHECK_BOTH(*line_two(true) == 42);
}

TEST_CASE("result: an error") {
  CHECK_BOTH(!digit("").has_value());
  CHECK_BOTH(digit("").error() == digit_error::empty);
  CHECK_BOTH(digit("x").error() == digit_error::no_digit);
  CHECK_BOTH(line_two(false).error().line == 2);
  CHECK_BOTH(line_two(false).error().column == 7);
  CHECK(std::string(line_two(false).error().message) == "a face names a vertex that does not exist");
}

TEST_CASE("result: values that can only be moved, or that own memory") {
  irg::result<std::unique_ptr<int>> r = std::make_unique<int>(5);
  CHECK(**r == 5);
  const std::unique_ptr<int> taken = *std::move(r);
  CHECK(*taken == 5);
  irg::result<std::string> text = std::string(1000, 'x');
  CHECK(text->size() == 1000);
  const irg::result<std::string> copy = text;
  CHECK(copy->size() == 1000);
  CHECK(*copy == *text);
}

TEST_CASE("result: no_default") { CHECK_BOTH((*irg::result<no_default>(no_default(3))).v == 3); }

TEST_CASE("result: value_or, and_then and transform go on with a value, and not after an error") {
  CHECK_BOTH(digit("7").value_or(3) == 7);
  CHECK_BOTH(digit("x").value_or(3) == 3);
  CHECK_BOTH(halved_twice("8", 99, 2) == 2);
  CHECK_BOTH(halved_twice("6", 99, 2) == 99);
  CHECK_BOTH(halved_twice("5", 99, 1) == 99);
  CHECK_BOTH(halved_twice("", 99, 0) == 99);
  const auto wider = [](int x) { return 0.5 * x; };
  static_assert(std::is_same_v<decltype(digit("7").transform(wider)), irg::result<double, digit_error>>);
  CHECK_BOTH(*digit("7").transform(wider) == 3.5);
  CHECK_BOTH(digit("").transform(wider).error() == digit_error::empty);
  CHECK_BOTH(digit("7").transform([](int) {}).has_value());
}

TEST_CASE("result: what can only be moved is moved on") {
  irg::result<std::unique_ptr<int>> r = std::make_unique<int>(5);
  const auto taken = std::move(r).transform([](std::unique_ptr<int>&& p) { return std::move(p); });
  CHECK(**taken == 5);
  irg::result<std::unique_ptr<int>> none = irg::parse_error{1, 2, "nothing"};
  CHECK(*std::move(none).value_or(std::make_unique<int>(6)) == 6);
}

TEST_CASE("result<void>: done, or why not") {
  CHECK_BOTH(check("7").has_value());
  CHECK_BOTH(static_cast<bool>(check("7")));
  CHECK_BOTH(!check("x"));
  CHECK_BOTH(check("").error() == digit_error::empty);
  CHECK_BOTH(*check("7").and_then([] { return digit("4"); }) == 4);
  CHECK_BOTH(check("x").and_then([] { return digit("4"); }).error() == digit_error::no_digit);
  CHECK_BOTH(digit("x").and_then([](int) { return check("1"); }).error() == digit_error::no_digit);
}
