// SPDX-License-Identifier: MIT
// Vectors and points: what the types forbid. CASE 0 is the control and compiles.
#include <irg/geometry/edge_equation.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/math/angle_between.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/vec.hpp>

#include <array>

using vec2 = irg::vec<float, 2>;
using vec3 = irg::vec<float, 3>;
using point3 = irg::point<float, 3>;
[[maybe_unused]] constexpr vec2 v2{1, 2};
[[maybe_unused]] constexpr vec3 v3{1, 2, 3};
[[maybe_unused]] constexpr point3 p3{1, 2, 3};

// What is refused is refused in a question too, and no error there.
template <class T>
concept has_product = requires(const T& a) { irg::dot(a, a); };
static_assert(has_product<vec3> && !has_product<point3>);

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
// expect: ^[^ ]*coordinates.cpp:[0-9:]* error: .*(PointWhereVectorIsWanted|a point stands where a vector is wanted)
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
#elif CASE == 12  // a point among vectors
// expect: ^[^ ]*coordinates.cpp:[0-9:]* error: .*(PointWhereVectorIsWanted|a point stands where a vector is wanted)
constexpr auto x = irg::cross(v3, p3);
#elif CASE == 13  // the transformation of vectors given a point
// expect: ^[^ ]*coordinates.cpp:[0-9:]* error: .*(PointWhereVectorIsWanted|a point stands where a vector is wanted)
constexpr auto x = irg::transform_vector(irg::mat<float, 4, 4>{}, p3);
#elif CASE == 14  // the transformation of points given a vector
// expect: ^[^ ]*coordinates.cpp:[0-9:]* error: .*(VectorWherePointIsWanted|a vector stands where a point is wanted)
constexpr auto x = irg::transform_point(irg::mat<float, 4, 4>{}, v3);
#elif CASE == 15  // a predicate of points given vectors
// expect: ^[^ ]*coordinates.cpp:[0-9:]* error: .*(VectorWherePointIsWanted|a vector stands where a point is wanted)
constexpr auto x = irg::orient2d(v2, v2, v2);
#elif CASE == 16  // a vector in a point's place: the types are named
// expect: ^[^ ]*coordinates.cpp:[0-9:]* error: (conversion from .*point|no viable conversion from .*point).*vec
vec3 x = p3;
#elif CASE == 17  // and the other way round
// expect: ^[^ ]*coordinates.cpp:[0-9:]* error: (conversion from .*vec|no viable conversion from .*vec).*point
point3 x = v3;
#elif CASE == 18  // an angle between points
// expect: ^[^ ]*coordinates.cpp:[0-9:]* error: .*(PointWhereVectorIsWanted|a point stands where a vector is wanted)
auto x = irg::angle_between(p3, p3);
#elif CASE == 19  // an edge through vectors
// expect: ^[^ ]*coordinates.cpp:[0-9:]* error: .*(VectorWherePointIsWanted|a vector stands where a point is wanted)
auto x = irg::edge_through(v2, v2);
#endif
