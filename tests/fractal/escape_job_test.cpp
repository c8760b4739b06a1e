// SPDX-License-Identifier: MIT
#include <irg/fractal/escape_picture.hpp>

#include "support/check_both.hpp"

TEST_CASE("escape_counts: sums; escape_job: everything is skipped unless said otherwise") {
  CHECK_BOTH((irg::escape_counts{} == irg::escape_counts{0, 0, 0, 0}));
  constexpr irg::escape_counts twice = [] {
    irg::escape_counts s{10, 2, 1, 3};
    return s += s;
  }();
  CHECK_BOTH((twice == irg::escape_counts{20, 4, 2, 6}));
  CHECK_BOTH(
      (irg::escape_job<double>{}.skip == irg::escape_options{irg::skipping::on, irg::skipping::on, irg::skipping::on}));
}
