// SPDX-License-Identifier: MIT
#include <irg/geometry/flat_relation.hpp>

#include "support/check_both.hpp"

TEST_CASE("flat_relation: what is not decided is none") {
  CHECK_BOTH(irg::flat_relation{} == irg::flat_relation::none);
}
