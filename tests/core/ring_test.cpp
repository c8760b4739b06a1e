// SPDX-License-Identifier: MIT
#include <irg/core/ring.hpp>

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <ranges>
#include <string>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/own_types.hpp"

namespace {

using point2 = irg::point<int, 2>;

struct unsized {
  point2 operator[](std::size_t) const;
};
struct small_ring {  // its size is a byte, its points are made when read
  std::uint8_t size() const { return 3; }
  point2 operator[](std::size_t i) const { return {static_cast<int>(i), 0}; }
};

static_assert(irg::PolygonRing<std::vector<point2>> && irg::PolygonRing<std::array<point2, 3>>);
static_assert(irg::PolygonRing<std::span<const point2>> && irg::PolygonRing<std::span<point2, 4>>);
static_assert(irg::PolygonRing<std::deque<point2>> && irg::PolygonRing<point2[4]> && irg::PolygonRing<small_ring>);
static_assert(irg::PolygonRing<std::vector<irg::hpoint<float, 3>>> &&
              irg::PolygonRing<std::vector<std::array<float, 2>>>);
static_assert(irg::PolygonRing<archetype::ring<archetype::point<archetype::scalar, 2>, 3>>);
static_assert(irg::PolygonRing<archetype::ring<archetype::homogeneous_point<archetype::scalar, 4>, 3>>);

static_assert(irg::PlaneRing<point2[4]> && !irg::SpaceRing<point2[4]> && irg::RingOf<point2[4], 2>);
static_assert(irg::SpaceRing<std::vector<irg::point<float, 3>>> && !irg::PlaneRing<std::vector<irg::hpoint<int, 2>>>);
static_assert(irg::RingSequence<std::vector<std::vector<point2>>> && irg::RingSequence<point2[2][4]>);
static_assert(!irg::RingSequence<std::vector<point2>> && !irg::RingSequence<point2[4]>);
static_assert(std::same_as<irg::ring_in<point2[2][4]>, point2[4]> && std::same_as<irg::ring_scalar<point2[4]>, int>);
static_assert(!irg::PolygonRing<std::vector<irg::vec<int, 2>>>);  // displacements are no positions
static_assert(!irg::PolygonRing<std::vector<float>> && !irg::PolygonRing<std::array<float, 4>> &&
              !irg::PolygonRing<std::string>);
static_assert(!irg::PolygonRing<unsized> && !irg::PolygonRing<point2> && !irg::PolygonRing<point2*>);
static_assert(!irg::PolygonRing<std::map<std::size_t, point2>> && !irg::PolygonRing<float[4]> &&
              !irg::PolygonRing<void>);
#ifdef IRG_HAVE_GLM
static_assert(irg::PolygonRing<std::vector<glm::vec2>> && irg::PolygonRing<std::vector<glm::vec4>>);
#endif
#ifdef IRG_HAVE_EIGEN
static_assert(irg::PolygonRing<std::vector<Eigen::Vector2f>> && !irg::PolygonRing<Eigen::Vector2f>);
#endif

// Twice the area by the shoelace formula, through the concept alone.
template <irg::PolygonRing R>
constexpr auto twice_area(const R& r) {
  using scalar = irg::scalar_of<irg::ring_point<R>>;
  scalar sum = scalar(0);
  for (std::size_t i = 0; i < irg::ring_size(r); ++i) {
    const auto a = irg::ring_vertex(r, i), b = irg::ring_vertex(r, i + 1);
    sum = sum + (irg::coordinate(a, 0) * irg::coordinate(b, 1) - irg::coordinate(b, 0) * irg::coordinate(a, 1));
  }
  return sum;
}

constexpr point2 square[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};

constexpr bool archetype_is_enough() {
  using number = archetype::scalar;
  using corner = archetype::point<number, 2>;
  const archetype::ring<corner, 3> triangle(corner::of(number(0), number(0)), corner::of(number(6), number(0)),
                                            corner::of(number(0), number(5)));
  return twice_area(triangle) == number(30);
}

}  // namespace

TEST_CASE("ring: containers that count by ints, and views, which count by signed numbers, are read without a warning") {
  struct int_ring {
    irg::point<double, 2> corners[3];
    constexpr int size() const { return 3; }
    constexpr const irg::point<double, 2>& operator[](int i) const { return corners[i]; }
  };
  CHECK_BOTH(irg::ring_vertex(int_ring{{{0, 0}, {4, 0}, {4, 3}}}, 5) == irg::point<double, 2>{4, 3});
  constexpr auto squares = std::views::iota(0, 5) | std::views::transform([](int i) {
                             return irg::point<double, 2>{static_cast<double>(i), static_cast<double>(i * i)};
                           });
  CHECK_BOTH(irg::ring_size(squares) == 5);
  CHECK_BOTH(irg::ring_vertex(squares, 8) == irg::point<double, 2>{3, 9});
}

TEST_CASE("ring: arrays, containers and spans are closed without repeating the first point") {
  CHECK_BOTH(irg::ring_size(square) == 4);
  CHECK_BOTH(twice_area(square) == 32);
  CHECK_BOTH(twice_area(std::span<const point2>(square)) == 32);
  CHECK_BOTH(twice_area(std::array<point2, 3>{{{0, 0}, {0, 5}, {6, 0}}}) == -30);
  CHECK_BOTH(archetype_is_enough());
  CHECK(twice_area(std::vector<point2>{{0, 0}, {6, 0}, {0, 5}}) == 30);
  CHECK(irg::ring_size(small_ring{}) == 3);
  CHECK(irg::ring_vertex(small_ring{}, 5) == point2{2, 0});
}

TEST_CASE("ring: indices go round and round") {
  CHECK_BOTH(irg::ring_vertex(square, 0) == point2{0, 0});
  CHECK_BOTH(irg::ring_vertex(square, 3) == point2{0, 4});
  CHECK_BOTH(irg::ring_vertex(square, 4) == point2{0, 0});
  CHECK_BOTH(irg::ring_vertex(square, 4'000'002) == point2{4, 4});
  CHECK_BOTH(irg::ring_vertex(std::array<point2, 1>{{{7, 8}}}, 9) == point2{7, 8});
}

TEST_CASE("ring: degenerate rings have sizes too") {
  CHECK(irg::ring_size(std::vector<point2>{}) == 0);
  CHECK_BOTH(irg::ring_size(std::span<const point2>{}) == 0);
  CHECK_BOTH(twice_area(std::array<point2, 2>{{{1, 2}, {3, 4}}}) == 0);
}
