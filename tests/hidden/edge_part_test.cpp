// SPDX-License-Identifier: MIT
#include <irg/hidden/edge_part.hpp>

#include "support/check_both.hpp"

TEST_CASE("edge_part: an edge, what is seen of it, where") {
  constexpr irg::edge_part p{3, irg::line_visibility::hidden, 0.25, 1};
  CHECK_BOTH(p.edge == 3);
  CHECK_BOTH(p.visibility == irg::line_visibility::hidden);
  CHECK_BOTH(p.from < p.to);
}
