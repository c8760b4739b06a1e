// SPDX-License-Identifier: MIT
#include <irg/core/function_ref.hpp>

#include <memory>
#include <string>
#include <utility>

#include "support/check_both.hpp"

namespace {

// Compiled once, whatever it is given.
constexpr int twice(const irg::function_ref<int(int)>& f, int x) { return f(f(x)); }
constexpr void three_times(const irg::function_ref<void(int)>& f) {
  for (int i = 0; i < 3; ++i) f(i);
}

constexpr int free_function(int x) { return 3 * x; }

struct counter {
  int calls = 0;
  constexpr int operator()(int x) {
    ++calls;
    return x + calls;
  }
};

TEST_CASE("function_ref: functions, lambdas and objects with a state, in constant evaluation, too") {
  CHECK_BOTH(twice(irg::as_function<int(int)>(free_function), 2) == 18);
  CHECK_BOTH(twice(irg::as_function<int(int)>([](int x) { return x + 1; }), 2) == 4);
  constexpr auto counted = [] {
    counter c;
    const int last = twice(irg::as_function<int(int)>(c), 10);
    return 100 * c.calls + last;
  };
  CHECK_BOTH(counted() == 213);
}

TEST_CASE("function_ref: what is returned is dropped where nothing is asked for") {
  constexpr auto sum = [] {
    int s = 0;
    three_times(irg::as_function<void(int)>([&s](int i) { return s += i; }));
    return s;
  };
  CHECK_BOTH(sum() == 3);
}

TEST_CASE("function_ref: arguments arrive as they are: references, values that are moved") {
  std::string text = "a";
  const auto append = [](std::string& s, std::unique_ptr<char> c) { return &(s += *c); };
  const auto f = irg::as_function<std::string*(std::string&, std::unique_ptr<char>)>(append);
  const irg::function_ref<std::string*(std::string&, std::unique_ptr<char>)>& any = f;
  CHECK(any(text, std::make_unique<char>('b')) == &text);
  CHECK(text == "ab");
}

#ifdef __cpp_exceptions
TEST_CASE("function_ref: what is thrown comes through") {
  const auto thrower = [](int i) {
    if (i == 1) throw i;
  };
  CHECK_THROWS_AS(three_times(irg::as_function<void(int)>(thrower)), int);
}
#endif

}  // namespace
