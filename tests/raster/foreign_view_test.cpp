// SPDX-License-Identifier: MIT
#include <irg/raster/foreign_view.hpp>

#include <string_view>

#include <irg/colour/pixel.hpp>

#include "support/check_both.hpp"

namespace {

alignas(16) char memory[64];

std::string_view refusal(const irg::foreign_view<std::uint32_t>& v) { return v ? "" : v.error().reason; }

TEST_CASE("foreign rows: a view of the very bytes, in the given order") {
  memory[16] = 77;
  const auto v = irg::detail::foreign_rows<irg::rgba8>(memory, 3, 4, 16);
  REQUIRE(v);
  CHECK(v->width() == 3);
  CHECK(v->height() == 4);
  CHECK((*v)(0, 1).r == 77);
  const auto upside_down = irg::detail::foreign_rows<irg::rgba8>(memory + 48, 3, 4, -16);
  REQUIRE(upside_down);
  CHECK((*upside_down)(0, 2).r == 77);
}

TEST_CASE("foreign rows: refused with a reason where they cannot be read as such") {
  CHECK(refusal(irg::detail::foreign_rows<std::uint32_t>(memory, 4, 4, 16)).empty());
  CHECK(refusal(irg::detail::foreign_rows<std::uint32_t>(memory, -1, 4, 16)) == "its size is negative");
  CHECK(refusal(irg::detail::foreign_rows<std::uint32_t>(memory, 4, -4, 16)) == "its size is negative");
  CHECK(refusal(irg::detail::foreign_rows<std::uint32_t>(memory + 1, 2, 2, 16)) ==
        "its rows are not aligned for the pixel type");
  CHECK(refusal(irg::detail::foreign_rows<std::uint32_t>(memory, 2, 2, 18)) ==
        "its rows are not aligned for the pixel type");
  CHECK(refusal(irg::detail::foreign_rows<std::uint32_t>(memory, 5, 2, 16)) == "its rows overlap");
  CHECK(refusal(irg::detail::foreign_rows<std::uint32_t>(memory, 5, 2, -16)) == "its rows overlap");
  CHECK(refusal(irg::detail::foreign_rows<std::uint32_t>(memory, 5, 1, 0)).empty());  // one row has no neighbour
}

}  // namespace
