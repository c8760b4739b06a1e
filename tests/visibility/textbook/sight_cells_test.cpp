// SPDX-License-Identifier: MIT
#include <irg/visibility/textbook/sight_cells.hpp>

#include <cstdlib>
#include <utility>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::cell3;
using list = std::vector<cell3>;

constexpr list one_pass(const cell3& a, const cell3& b) {
  list out;
  irg::textbook::sight_cells_one_pass(a, b, [&](const cell3& c) { out.push_back(c); });
  return out;
}

static_assert(one_pass({0, 0, 0}, {2, 1, 0}) == list{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}});

TEST_CASE("one pass: the lists") {
  CHECK(one_pass({0, 0, 0}, {8, 0, 4}) ==
        list{{0, 0, 0}, {1, 0, 0}, {2, 0, 1}, {3, 0, 1}, {4, 0, 2}, {5, 0, 2}, {6, 0, 3}, {7, 0, 3}, {8, 0, 4}});
  CHECK(one_pass({0, 0, 0}, {8, 8, 4}) ==
        list{{0, 0, 0}, {1, 1, 0}, {2, 2, 1}, {3, 3, 1}, {4, 4, 2}, {5, 5, 2}, {6, 6, 3}, {7, 7, 3}, {8, 8, 4}});
  CHECK(one_pass({0, 0, 0}, {8, 6, 5}) ==
        list{{0, 0, 0}, {1, 1, 1}, {2, 1, 1}, {3, 2, 2}, {4, 3, 2}, {5, 4, 3}, {6, 4, 4}, {7, 5, 4}, {8, 6, 5}});
  CHECK(one_pass({0, 0, 0}, {3, 4, 5}) == list{{0, 0, 0}, {1, 1, 1}, {1, 2, 2}, {2, 2, 3}, {2, 3, 4}, {3, 4, 5}});
  CHECK(one_pass({0, 0, 0}, {2, 1, 7}) ==
        list{{0, 0, 0}, {0, 0, 1}, {1, 0, 2}, {1, 0, 3}, {1, 1, 4}, {1, 1, 5}, {2, 1, 6}, {2, 1, 7}});
  CHECK(one_pass({0, 0, 0}, {0, 0, 3}) == list{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}});
  CHECK(one_pass({0, 0, 0}, {-4, 2, 1}) == list{{0, 0, 0}, {-1, 1, 0}, {-2, 1, 1}, {-3, 2, 1}, {-4, 2, 1}});
  CHECK(one_pass({3, 2, 2}, {0, 0, 0}) == list{{3, 2, 2}, {2, 1, 1}, {1, 1, 1}, {0, 0, 0}});
}

TEST_CASE("two nested passes: where they differ from one") {
  using irg::textbook::sight_cells_nested;
  CHECK(sight_cells_nested({0, 0, 0}, {3, 4, 5}) ==
        list{{0, 0, 0}, {1, 1, 1}, {1, 2, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 5}});
  CHECK(sight_cells_nested({0, 0, 0}, {2, 1, 7}) ==
        list{{0, 0, 0}, {0, 0, 1}, {1, 0, 2}, {1, 0, 3}, {1, 0, 4}, {1, 0, 5}, {2, 1, 6}, {2, 1, 7}});
  list differing;
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 7; ++y)
      for (int z = 0; z < 7; ++z)
        if (one_pass({0, 0, 0}, {x, y, z}) != sight_cells_nested({0, 0, 0}, {x, y, z})) {
          differing.push_back({x, y, z});
          CHECK(z > std::max(x, y));
        }
  REQUIRE(differing.size() >= 4);
  CHECK(list(differing.begin(), differing.begin() + 4) == list{{1, 2, 3}, {1, 2, 4}, {1, 2, 5}, {1, 2, 6}});
}

TEST_CASE("both lists are the same both ways, and connected") {
  test::random r(3);
  const auto any = [&] {
    return cell3{static_cast<int>(r.integer(-6, 6)), static_cast<int>(r.integer(-6, 6)),
                 static_cast<int>(r.integer(-6, 6))};
  };
  for (int i = 0; i < 3000; ++i) {
    const cell3 a = any(), b = any();
    for (const auto& [there, back] :
         {std::pair{one_pass(a, b), one_pass(b, a)},
          std::pair{irg::textbook::sight_cells_nested(a, b), irg::textbook::sight_cells_nested(b, a)}}) {
      CHECK(there == list(back.rbegin(), back.rend()));
      CHECK(there.front() == a);
      CHECK(there.back() == b);
      for (std::size_t k = 1; k < there.size(); ++k)
        for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(there[k][axis] - there[k - 1][axis]) <= 1);
    }
  }
}

TEST_CASE("as printed, the height misses the target") {
  const auto last = [](const cell3& b) {
    double z = 0;
    irg::textbook::sight_heights_as_printed({0, 0, 0}, b, [&](double height) { z = height; });
    return z;
  };
  CHECK(last({8, 0, 4}) == 4);
  CHECK(last({8, 8, 4}) == 3);
  CHECK(last({8, 6, 5}) == 4);
  CHECK(last({3, 4, 5}) == 4);
  CHECK(last({2, 1, 7}) == doctest::Approx(6.261).epsilon(0.0001));
  CHECK(last({0, 0, 3}) == 0);
}

}  // namespace
