// SPDX-License-Identifier: MIT
#include <irg/core/triangle_indices.hpp>

#include <type_traits>

#include "support/check_both.hpp"

namespace {

TEST_CASE("triangle_indices: three words in a row, all of them compared") {
  using irg::triangle_indices;
  static_assert(std::is_trivially_copyable_v<triangle_indices> && sizeof(triangle_indices) == 12);
  CHECK_BOTH(triangle_indices{{1, 2, 3}} == triangle_indices{{1, 2, 3}});
  CHECK_BOTH(triangle_indices{{1, 2, 3}} != triangle_indices{{0, 2, 3}});
  CHECK_BOTH(triangle_indices{{1, 2, 3}} != triangle_indices{{1, 3, 3}});
  CHECK_BOTH(triangle_indices{{1, 2, 3}} != triangle_indices{{1, 2, 1}});
}

}  // namespace
