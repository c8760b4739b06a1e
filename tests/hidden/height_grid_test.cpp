// SPDX-License-Identifier: MIT
#include <irg/hidden/height_grid.hpp>

#include <array>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"

using irg::sample_range;

TEST_CASE("places_of: the ends exactly, none, one") {
  constexpr auto ends = [](double from, double to, int count) {
    const auto p = irg::places_of(sample_range{from, to, count});
    return static_cast<int>(p.size()) == count && p.front() == from && p.back() == (count > 1 ? to : from);
  };
  CHECK_BOTH(ends(0.1, 0.7, 7));
  CHECK_BOTH(ends(-1e300, 1e300, 3));
  CHECK_BOTH(ends(2, 5, 1));
  CHECK_BOTH(irg::places_of(sample_range{0, 1, 0}).empty());
  CHECK_BOTH(irg::places_of(sample_range{0, 1, -3}).empty());
}

TEST_CASE("places_of: even steps between ends that are not 0") {
  CHECK_BOTH(irg::places_of(sample_range{2, 6, 5}) == std::vector<double>{2, 3, 4, 5, 6});
  CHECK_BOTH(irg::places_of(sample_range{8, -8, 5}) == std::vector<double>{8, 4, 0, -4, -8});
  CHECK_BOTH(irg::places_of(sample_range{}) == std::vector<double>{0, 1});
}

TEST_CASE("heights of functions, arrays and images: which is where") {
  constexpr auto plane = [](double x, double z) { return 10 * x + z; };
  const irg::height_grid f = irg::sample_heights(plane, sample_range{0, 2, 3}, sample_range{0, 1, 2});
  CHECK(f.heights == std::vector<double>{0, 1, 10, 11, 20, 21});
  constexpr std::array rows{1, 2, 3, 4, 5, 6};  // two rows of three
  const irg::height_grid a = irg::heights_of_rows(rows, 3);
  CHECK(a.x == std::vector<double>{0, 1, 2});
  CHECK(a.z == std::vector<double>{0, 1});
  CHECK(a.heights == std::vector<double>{1, 4, 2, 5, 3, 6});
  irg::image<std::uint8_t> image(3, 2);
  for (int x = 0; x < 3; ++x)
    image(x, 1) = static_cast<std::uint8_t>(x + 1), image(x, 0) = static_cast<std::uint8_t>(x + 4);
  CHECK(irg::heights_of_image(image, [](std::uint8_t v) { return v; }).heights == a.heights);
  CHECK(visible_grid_edges(a.surface(), {-1, 4, -1}, [](auto&&) {}).value.facets == 2);
  const auto none = irg::heights_of_image(irg::image<std::uint8_t>(0, 0), [](std::uint8_t v) { return v; });
  CHECK(visible_grid_edges(none.surface(), {-1, 4, -1}, [](auto&&) {}).status == irg::grid_surface_status::not_a_grid);
}

TEST_CASE("heights of arrays and images: whole places, which even steps miss from 23 on") {
  const std::vector<int> numbers(50 * 50, 0);
  const irg::image<std::uint8_t> image(50, 50);
  for (const auto& g :
       {irg::heights_of_rows(numbers, 50), irg::heights_of_image(image, [](std::uint8_t v) { return v; })})
    for (std::size_t i = 0; i < 50; ++i) CHECK((g.x[i] == static_cast<double>(i) && g.z[i] == g.x[i]));
  CHECK(irg::places_of(sample_range{0, 49, 50})[1] != 1);
}
