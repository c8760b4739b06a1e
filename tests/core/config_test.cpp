// SPDX-License-Identifier: MIT
#include <irg/core/config.hpp>

#include <string_view>

#include "support/check_both.hpp"

// The functions' namespace, spelled out as text.
#define IRG_TEST_TEXT_OF(...) #__VA_ARGS__
#define IRG_TEST_TEXT(...) IRG_TEST_TEXT_OF(__VA_ARGS__)
constexpr std::string_view abi = IRG_TEST_TEXT(IRG_ABI);

TEST_CASE("config: the namespace of functions names major version, instruction set, checks and linkage") {
  CHECK_BOTH(abi.starts_with("v0_"));
#ifdef __AVX2__
  CHECK_BOTH(abi.find("avx") != abi.npos);
#else
  CHECK_BOTH(abi.find("avx2") == abi.npos);
#endif
#ifdef __FMA__
  CHECK_BOTH(abi.find("_fma_") != abi.npos);
#else
  CHECK_BOTH(abi.find("_plain_") != abi.npos);
#endif
#ifdef NDEBUG
  CHECK_BOTH(abi.ends_with("_release_header"));
#else
  CHECK_BOTH(abi.ends_with("_checked_header"));
#endif
}

TEST_CASE("config: floats are IEEE 754 and computed in their own width") {
  CHECK_BOTH(__FLT_EVAL_METHOD__ == 0);
  volatile float third = 1.0f / 3.0f, three = 3.0f;
  CHECK(third * three == 1.0f);
  volatile double large = 0x1p53, one = 1.0;
  CHECK((large + one) - large == 0.0);  // a wider register would keep the one
}
