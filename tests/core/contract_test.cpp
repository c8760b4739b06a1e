// SPDX-License-Identifier: MIT
#include <irg/core/contract.hpp>

#include <type_traits>

#if defined(__unix__)
#include <csignal>

#include <sys/wait.h>
#include <unistd.h>
#endif

#include "support/check_both.hpp"

namespace {

constexpr int half_of_even(int x) {
  IRG_EXPECTS(x % 2 == 0);
  return x / 2;
}

constexpr int looked = [] {
  int count = 0;
  IRG_EXPECTS(++count == 1);  // evaluated once in constant evaluation, whatever the build
  return count;
}();
static_assert(looked == 1);

// A broken precondition is no constant: the same fact as a compile error is in must_not_compile/contract.cpp.
template <int X>
concept half_is_constant = requires { typename std::integral_constant<int, half_of_even(X)>; };
static_assert(half_is_constant<4> && half_is_constant<0> && half_is_constant<-6>);

template <int A, int B>
constexpr bool ordered = A < B;
constexpr int expectation_in_expression(int x) { return IRG_EXPECTS(x > 0 && ordered<1, 2>), x; }  // commas do no harm

#if defined(__unix__)
// Runs f in a child process that is silent and without doctest's handlers; true when abort() ended it.
template <class F>
bool dies(F f) {
  const int child = fork();
  if (child == 0) {
    close(1);
    close(2);
    std::signal(SIGABRT, SIG_DFL);
    f();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
}
#endif

}  // namespace

TEST_CASE("contract: kept, nothing happens") {
  CHECK_BOTH(half_of_even(8) == 4);
  CHECK_BOTH(expectation_in_expression(3) == 3);
}

TEST_CASE("contract: broken at run time, debug builds abort and release builds go on") {
#if defined(__unix__)
  volatile int odd = 7;
#ifdef NDEBUG
  CHECK(!dies([&] { (void)half_of_even(odd); }));
  CHECK(half_of_even(odd) == 3);
  int evaluations = 0;
  IRG_EXPECTS(++evaluations == 1);
  CHECK(evaluations == 0);
#else
  CHECK(dies([&] { (void)half_of_even(odd); }));
  CHECK(!dies([&] { (void)half_of_even(8); }));
#endif
#else
  MESSAGE("skipped: child processes are not available");
#endif
}
