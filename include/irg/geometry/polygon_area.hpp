// SPDX-License-Identifier: MIT
// The signed area of polygons: positive where they run counter-clockwise (y up). Rings add up, so that holes that run
// the other way are taken off; where a ring crosses itself, its parts count as often as it runs round them.
#pragma once

#include <cstddef>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/geometry/detail/shoelace.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/error_free.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Twice the signed area, by the sum of x1*y2 - x2*y1: exactly, in a type that holds it.
/// gives   128 bits for integers of up to 32, a wide_int for longer ones, else the coordinates' own type
/// exact   in integers (for fewer than 2^60 vertices) and rationals
template <PlanePolygon P>
  requires(!Floating<scalar_of<polygon_point<P>>>)
[[nodiscard]] constexpr auto twice_signed_area(const P& polygon) noexcept {
  return detail::shoelace(polygon);
}

/// The signed area, correctly rounded.
/// gives   0 for rings of fewer than three vertices and for polygons without area; NaN when a coordinate is NaN or
///         infinite; infinity when the area overflows. A double for integers
/// exact   the nearest number for all finite floats and all integers, ties to even; other scalars: by their own
///         arithmetic, exact in rationals
/// cost    some 20 ns for a vertex; nothing allocates. polygon_area gives the same in a quarter of the time but for
///         outlines that run there and back so close together that nearly all cancels; for those this is the faster one
template <PlanePolygon P>
[[nodiscard]] constexpr auto polygon_area_exact(const P& polygon) noexcept {
  using T = scalar_of<polygon_point<P>>;
  if constexpr (Floating<T>) {
    if (!irg::is_finite(polygon)) return not_a_number<T>;
    auto twice = detail::shoelace(polygon);
    const double area = twice.rounded(-1);
    if constexpr (std::is_same_v<T, double>) {
      return area;
    } else {
      twice.subtract(area, 2.0);
      return rounded_once<T>(area, twice.sign());
    }
  } else if constexpr (std::integral<T>) {
    return rounded_to_double(wide_int<4>(detail::shoelace(polygon)), -1);
  } else {
    return T(detail::shoelace(polygon) / T(2));
  }
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Twice an area in two parts, and a bound of what they are off.
struct bounded_area {
  exact_sum<double> sum{0, 0};
  double size = 0;  // of all products
  bool is_moderate = true;  // nothing overflowed
};

// Adds a product of differences in two parts each.
IRG_INLINE constexpr void add_product(bounded_area& area, const exact_sum<double>& a,
                                      const exact_sum<double>& b) noexcept {
  const exact_sum<double> head = fast_two_product(a.value, b.value), total = two_sum(area.sum.value, head.value);
  // What is lost of tiny products depends on the instruction set, and counts nothing beside a sum of more than 2^-400.
  const double lost = magnitude(head.value) < 0x1p-900 ? 0.0 : head.error;
  const double rest = lost + (product(a.value, b.error) + product(a.error, b.value));
  area.sum = {total.value, area.sum.error + (total.error + rest)};
  area.size = area.size + magnitude(head.value);
}

// A vertex costs one product: (x - x of the first vertex) * (y of the next one - y of the one before). Differences are
// in two parts, so distance from the origin costs nothing.
template <PlaneRing R>
constexpr void add_ring_area(bounded_area& area, const R& ring) noexcept {
  struct vertex {
    double x, y;
  };
  const std::size_t n = ring_size(ring);
  const auto at = [&](std::size_t i) IRG_INLINE_LAMBDA {
    const auto& p = ring_vertex(ring, i);
    return vertex{widened(coordinate(p, 0)), widened(coordinate(p, 1))};
  };
  const auto moderate = [](const vertex& v)
                            IRG_INLINE_LAMBDA { return magnitude(v.x) <= 0x1p400 && magnitude(v.y) <= 0x1p400; };
  if (n < 3) return;
  const vertex first = at(0);
  vertex before = first, here = at(1);
  area.is_moderate = area.is_moderate && moderate(first) && moderate(here);
  if (!area.is_moderate) return;
  for (std::size_t i = 1; i < n; ++i) {
    const vertex next = i + 1 < n ? at(i + 1) : first;
    area.is_moderate = moderate(next);
    if (!area.is_moderate) return;
    add_product(area, two_sum(here.x, -first.x), two_sum(next.y, -before.y));
    before = here, here = next;
  }
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The signed area.
/// gives   as polygon_area_exact
/// exact   float and double: within 0.51 ulp for all finite coordinates; the rest as polygon_area_exact
/// cost    some 6 ns for a vertex; where the sum cancels too much to be sure of, polygon_area_exact
template <PlanePolygon P>
[[nodiscard]] constexpr auto polygon_area(const P& polygon) noexcept {
  using T = scalar_of<polygon_point<P>>;
  if constexpr (Floating<T>) {
    detail::bounded_area area;
    double vertices = 8;
    detail::each_ring(polygon, [&](const auto& ring) {
      vertices += static_cast<double>(ring_size(ring));
      detail::add_ring_area(area, ring);
      return area.is_moderate;
    });
    const double sum = area.sum.value + area.sum.error;
    // Sums of n terms in two parts, after Ogita, Rump and Oishi; 4 for the parts of each term.
    // Beside a sum of more than 2^-400 it does not count what underflowed.
    const double bound = product(product(vertices, vertices) * 0x1p-102, area.size), size = magnitude(sum);
    if (area.is_moderate && vertices < 0x1p40 && size > 0x1p-400 && size * 0x1p-60 >= bound)
      return converted<T>(sum * 0.5);
  }
  return polygon_area_exact(polygon);
}

/// The signed area by the sum of triangles from each ring's first vertex, in plain arithmetic.
/// gives   no NaN while coordinates are below 2^510 (float: 2^62) in size
/// exact   off by at most (n + 4) u times the sizes of both products of each triangle, halved, together (u = 2^-53,
///         float 2^-24), where nothing underflows: thin triangles may lose their digits, but distance from the origin
///         costs no more than the differences' own rounding
/// cost    about 2 ns for a vertex
template <PlanePolygon P>
  requires Floating<scalar_of<polygon_point<P>>>
[[nodiscard]] constexpr auto polygon_area_fast(const P& polygon) noexcept {
  using T = scalar_of<polygon_point<P>>;
  T twice(0);
  detail::each_ring(polygon, [&](const auto& ring) {
    const std::size_t n = ring_size(ring);
    if (n < 3) return true;
    const auto origin = ring_vertex(ring, 0), first = ring_vertex(ring, 1);
    T ux = coordinate(first, 0) - coordinate(origin, 0), uy = coordinate(first, 1) - coordinate(origin, 1);
    for (std::size_t i = 2; i < n; ++i) {
      const auto p = ring_vertex(ring, i);
      const T vx = coordinate(p, 0) - coordinate(origin, 0), vy = coordinate(p, 1) - coordinate(origin, 1);
      twice = twice + (product(ux, vy) - product(uy, vx));
      ux = vx;
      uy = vy;
    }
    return true;
  });
  return twice * T(0.5);
}

IRG_RENAMED(twice_polygon_area, twice_signed_area)

}  // namespace IRG_ABI
}  // namespace irg
