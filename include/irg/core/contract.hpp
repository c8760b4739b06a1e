// SPDX-License-Identifier: MIT
// IRG_EXPECTS(condition): a precondition. A broken one is a compile error in constant evaluation, a message and
// abort() in debug builds, and costs nothing in release builds (NDEBUG).
#pragma once

#include <type_traits>

#include <irg/core/config.hpp>

#ifndef NDEBUG
#include <cstdio>
#include <cstdlib>
#endif

namespace irg::detail::inline IRG_ABI {

#ifdef NDEBUG
// Not constexpr: reaching this call makes the expression no constant, which is the compile error that is wanted.
inline void precondition_broken() noexcept {}
#else
[[noreturn]] inline void precondition_broken(const char* condition, const char* file = __builtin_FILE(),
                                             int line = __builtin_LINE()) noexcept {
  std::fprintf(stderr, "irg: broken precondition: %s (%s:%d)\n", condition, file, line);
  std::abort();
}
#endif

}  // namespace irg::detail::inline IRG_ABI

#ifdef NDEBUG
#define IRG_EXPECTS(...) \
  ((std::is_constant_evaluated() && !(__VA_ARGS__)) ? ::irg::detail::precondition_broken() : void())
#else
#define IRG_EXPECTS(...) ((__VA_ARGS__) ? void() : ::irg::detail::precondition_broken(#__VA_ARGS__))
#endif
