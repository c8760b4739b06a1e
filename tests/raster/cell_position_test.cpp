// SPDX-License-Identifier: MIT
#include <irg/raster/cell_position.hpp>
#include <irg/raster/subpixel.hpp>

#include <array>

#include <doctest/doctest.h>

namespace {

struct place {
  int x, y;
};
struct wide_place {
  long long x, y;
};
struct place_in_space {
  int x, y, z;
};

// Points of ints in the plane, and they alone.
static_assert(irg::CellPosition<place> && irg::CellPosition<std::array<int, 2>> &&
              irg::CellPosition<irg::point<int, 2>>);
static_assert(!irg::CellPosition<wide_place> && !irg::CellPosition<place_in_space> &&
              !irg::CellPosition<irg::point<float, 2>> && !irg::CellPosition<irg::vec<int, 2>>);
// A cell is one, and a snapped position is none, though both have an x and a y of type int.
static_assert(!irg::CellPosition<irg::cell> && !irg::CellPosition<irg::subpixel>);

static_assert(irg::as_cell(place{-2147483647 - 1, 2147483647}) == irg::cell{-2147483647 - 1, 2147483647});
static_assert(irg::as_cell(irg::cell{3, 4}) == irg::cell{3, 4});

}  // namespace

TEST_CASE("cell_position: ints snap as the cell that they name") {
  for (const int x : {-2147483647 - 1, -irg::snap_limit - 1, -irg::snap_limit, -1, 0, 7, irg::snap_limit - 1,
                      irg::snap_limit, 2147483647}) {
    const irg::cell c{x, 5};
    const place p{x, 5};
    CHECK(irg::can_snap(p) == irg::can_snap(c));
    if (irg::can_snap(c)) CHECK(irg::snap(p) == irg::snap(c));
  }
}
