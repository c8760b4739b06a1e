// SPDX-License-Identifier: MIT
#include <irg/core/vocabulary.hpp>

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

TEST_CASE("sign_of and opposite: of every word that is a sign") {
  const auto turns = [](auto word) {
    return sign_of(opposite(word)) == -sign_of(word) && opposite(opposite(word)) == word;
  };
  CHECK_BOTH((sign_of(irg::side::below) == -1 && sign_of(irg::facing::front) == 1));
  CHECK_BOTH((opposite(irg::side::above) == irg::side::below && opposite(irg::side::on) == irg::side::on));
  CHECK((turns(irg::side::above) && turns(irg::location::inside) && turns(irg::facing::back)));
  CHECK((turns(irg::orientation::clockwise) && turns(irg::facing::edge_on)));
}

enum class outcome { ordinary, refused };
using number = irg::checked<int, outcome>;

}  // namespace

TEST_CASE("checked: a value and what became of it") {
  CHECK_BOTH((number{7}.ok() && number{7}.value == 7));
  CHECK_BOTH(!(number{0, outcome::refused}.ok()));
  CHECK_BOTH((number{0, outcome::refused} != number{0}));
  CHECK_BOTH((number{} == number{0, outcome::ordinary}));
}
