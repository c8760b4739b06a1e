// SPDX-License-Identifier: MIT
#include <irg/core/checked.hpp>

#include "support/check_both.hpp"

namespace {

enum class outcome { ordinary, refused };
using number = irg::checked<int, outcome>;

}  // namespace

TEST_CASE("checked: a value and what became of it") {
  CHECK_BOTH((number{7}.is_ordinary() && number{7}.value == 7));
  CHECK_BOTH(!(number{0, outcome::refused}.is_ordinary()));
  CHECK_BOTH((number{0, outcome::refused} != number{0}));
  CHECK_BOTH((number{} == number{0, outcome::ordinary}));
}
