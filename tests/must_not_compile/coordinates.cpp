// SPDX-License-Identifier: MIT
// Vectors and points: what the types forbid. CASE 0 is the control and compiles.
#include <irg/math/vec.hpp>

#include <array>

using vec2 = irg::vec<float, 2>;
using vec3 = irg::vec<float, 3>;
using point3 = irg::point<float, 3>;
[[maybe_unused]] constexpr vec2 v2{1, 2};
[[maybe_unused]] constexpr vec3 v3{1, 2, 3};
[[maybe_unused]] constexpr point3 p3{1, 2, 3};

#if CASE == 0
constexpr auto sum = irg::dot(v3, v3) + irg::dot(v2, v2) + irg::cross(v3, v3).x + (p3 + v3).x + (p3 - p3).x;
constexpr auto made = irg::from_coordinates<vec2>(1, 2);
#elif CASE == 1  // dot of different sizes
// expect: no matching function for call to .*dot
constexpr auto x = irg::dot(v2, v3);
#elif CASE == 2  // cross of vectors of the plane and of space: of two of the plane it is their area
// expect: no matching function for call to .*cross
constexpr auto x = irg::cross(v2, v3);
#elif CASE == 3  // point plus point
// expect: (no match for|invalid operands)
constexpr auto x = p3 + p3;
#elif CASE == 4  // a vector of bool
// expect: (constraint failure|constraints not satisfied)
irg::vec<bool, 3> x;
#elif CASE == 5  // an operand of another number type
// expect: no matching function for call to .*dot
constexpr auto x = irg::dot(v3, irg::vec<double, 3>{1, 2, 3});
#elif CASE == 6  // dot of points
// expect: no matching function for call to .*dot
constexpr auto x = irg::dot(p3, p3);
#elif CASE == 7  // too few coordinates
// expect: no matching function for call to .*from_coordinates
constexpr auto x = irg::from_coordinates<vec3>(1, 2);
#elif CASE == 8  // a rectangle is no point
// expect: (constraint failure|constraints not satisfied)
struct rectangle {
  int x, y, w, h;
};
template <irg::Point P>
constexpr int first(const P& p) {
  return irg::coordinate(p, 0);
}
constexpr int x = first(rectangle{1, 2, 3, 4});
#elif CASE == 9  // a product of vectors: dot or cross must be said
// expect: (no match for|invalid operands)
constexpr auto x = v3 * v3;
#elif CASE == 10  // a vector added to a homogeneous point
// expect: (no match for|invalid operands)
constexpr auto x = irg::hpoint<float, 3>{1, 2, 3, 1} + v3;
#elif CASE == 11  // coordinates beyond the third have no names
// expect: no member named
constexpr auto x = irg::point<float, 5>{}.x;
#endif
