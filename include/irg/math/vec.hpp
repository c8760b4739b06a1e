// SPDX-License-Identifier: MIT
// vec<T, N>, point<T, N> and hpoint<T, N>: plain aggregates, told apart by type so that a transformation does the right
// thing to each. Functions such as dot and cross take any Vector, the operators only irg's own types.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/contraction.hpp>
#include <irg/core/contract.hpp>
#include <irg/core/coordinates.hpp>

namespace irg {

#define IRG_COORDINATES_2                                                                   \
  T x{}, y{};                                                                               \
  IRG_INLINE constexpr const T& operator[](int i) const noexcept { return i == 0 ? x : y; } \
  IRG_INLINE constexpr T& operator[](int i) noexcept { return i == 0 ? x : y; }
#define IRG_COORDINATES_3                                                                                \
  T x{}, y{}, z{};                                                                                       \
  IRG_INLINE constexpr const T& operator[](int i) const noexcept { return i == 0 ? x : i == 1 ? y : z; } \
  IRG_INLINE constexpr T& operator[](int i) noexcept { return i == 0 ? x : i == 1 ? y : z; }
#define IRG_COORDINATES_4                                                                                             \
  T x{}, y{}, z{}, w{};                                                                                               \
  IRG_INLINE constexpr const T& operator[](int i) const noexcept { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; } \
  IRG_INLINE constexpr T& operator[](int i) noexcept { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }

#define IRG_COORDINATES_ANY(size)                                                        \
  T elements[static_cast<std::size_t>(size)]{};                                          \
  IRG_INLINE constexpr const T& operator[](int i) const noexcept { return elements[i]; } \
  IRG_INLINE constexpr T& operator[](int i) noexcept { return elements[i]; }

/// A displacement with N coordinates.
template <Number T, int N>
struct vec {
  static constexpr coordinate_kind kind = coordinate_kind::vector;
  IRG_COORDINATES_ANY(N)
  bool operator==(const vec&) const = default;
};
template <Number T>
struct vec<T, 2> {
  static constexpr coordinate_kind kind = coordinate_kind::vector;
  IRG_COORDINATES_2
  bool operator==(const vec&) const = default;
};
template <Number T>
struct vec<T, 3> {
  static constexpr coordinate_kind kind = coordinate_kind::vector;
  IRG_COORDINATES_3
  bool operator==(const vec&) const = default;
};
template <Number T>
struct vec<T, 4> {
  static constexpr coordinate_kind kind = coordinate_kind::vector;
  IRG_COORDINATES_4
  bool operator==(const vec&) const = default;
};

/// A position in N-dimensional space.
template <Number T, int N>
struct point {
  static constexpr coordinate_kind kind = coordinate_kind::point;
  IRG_COORDINATES_ANY(N)
  bool operator==(const point&) const = default;
};
template <Number T>
struct point<T, 2> {
  static constexpr coordinate_kind kind = coordinate_kind::point;
  IRG_COORDINATES_2
  bool operator==(const point&) const = default;
};
template <Number T>
struct point<T, 3> {
  static constexpr coordinate_kind kind = coordinate_kind::point;
  IRG_COORDINATES_3
  bool operator==(const point&) const = default;
};

/// A position of N-dimensional projective space, the weight last: x, y, w as x, y, z in the plane, x, y, z, w in space.
/// Weight 0 is a direction; all coordinates 0 is no position. == compares coordinates; proportional ones are the same
/// position.
template <Number T, int N>
struct hpoint {
  static constexpr coordinate_kind kind = coordinate_kind::homogeneous;
  IRG_COORDINATES_ANY(N + 1)
  bool operator==(const hpoint&) const = default;
};
template <Number T>
struct hpoint<T, 2> {
  static constexpr coordinate_kind kind = coordinate_kind::homogeneous;
  IRG_COORDINATES_3
  bool operator==(const hpoint&) const = default;
};
template <Number T>
struct hpoint<T, 3> {
  static constexpr coordinate_kind kind = coordinate_kind::homogeneous;
  IRG_COORDINATES_4
  bool operator==(const hpoint&) const = default;
};

#undef IRG_COORDINATES_ANY
#undef IRG_COORDINATES_2
#undef IRG_COORDINATES_3
#undef IRG_COORDINATES_4

namespace detail {
template <class V, class T, int Size>
struct element_traits {
  using scalar = T;
  static constexpr int size = Size;
  static constexpr coordinate_kind kind = V::kind;
  IRG_INLINE static constexpr T get(const V& v, int i) noexcept { return v.elements[i]; }
  template <class... S>
  IRG_INLINE static constexpr V make(S... c) noexcept {
    return {{converted<T>(c)...}};
  }
};
}  // namespace detail

template <class T, int N>
  requires(N != 2 && N != 3 && N != 4)
struct coordinate_traits<vec<T, N>> : detail::element_traits<vec<T, N>, T, N> {};
template <class T, int N>
  requires(N != 2 && N != 3)
struct coordinate_traits<point<T, N>> : detail::element_traits<point<T, N>, T, N> {};
template <class T, int N>
  requires(N != 2 && N != 3)
struct coordinate_traits<hpoint<T, N>> : detail::element_traits<hpoint<T, N>, T, N + 1> {};

template <class T, std::same_as<T>... More>
vec(T, More...) -> vec<T, 1 + static_cast<int>(sizeof...(More))>;

namespace detail {
/// irg's own vec, point and hpoint: the types that carry operators.
template <class T>
inline constexpr bool is_own = false;
template <class T, int N>
inline constexpr bool is_own<vec<T, N>> = true;
template <class T, int N>
inline constexpr bool is_own<point<T, N>> = true;
template <class T, int N>
inline constexpr bool is_own<hpoint<T, N>> = true;
}  // namespace detail

inline namespace IRG_ABI {

template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr vec<T, N> operator+(const vec<T, N>& a,
                                                       const vec<T, N>& b) noexcept(std::is_arithmetic_v<T>) {
  return generate_coordinates<vec<T, N>>([&](int i) IRG_INLINE_LAMBDA { return a[i] + b[i]; });
}
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr vec<T, N> operator-(const vec<T, N>& a,
                                                       const vec<T, N>& b) noexcept(std::is_arithmetic_v<T>) {
  return generate_coordinates<vec<T, N>>([&](int i) IRG_INLINE_LAMBDA { return a[i] - b[i]; });
}
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr vec<T, N> operator-(const vec<T, N>& a) noexcept(std::is_arithmetic_v<T>) {
  return generate_coordinates<vec<T, N>>([&](int i) IRG_INLINE_LAMBDA { return -a[i]; });
}
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr vec<T, N> operator*(const vec<T, N>& a,
                                                       std::type_identity_t<T> s) noexcept(std::is_arithmetic_v<T>) {
  return generate_coordinates<vec<T, N>>([&](int i) IRG_INLINE_LAMBDA { return product(a[i], s); });
}
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr vec<T, N> operator*(std::type_identity_t<T> s,
                                                       const vec<T, N>& a) noexcept(std::is_arithmetic_v<T>) {
  return a * s;
}
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr vec<T, N> operator/(const vec<T, N>& a,
                                                       std::type_identity_t<T> s) noexcept(std::is_arithmetic_v<T>) {
  return generate_coordinates<vec<T, N>>([&](int i) IRG_INLINE_LAMBDA { return a[i] / s; });
}
template <class T, int N>
IRG_INLINE constexpr vec<T, N>& operator+=(vec<T, N>& a, const vec<T, N>& b) noexcept(std::is_arithmetic_v<T>) {
  return a = a + b;
}
template <class T, int N>
IRG_INLINE constexpr vec<T, N>& operator-=(vec<T, N>& a, const vec<T, N>& b) noexcept(std::is_arithmetic_v<T>) {
  return a = a - b;
}
template <class T, int N>
IRG_INLINE constexpr vec<T, N>& operator*=(vec<T, N>& a, std::type_identity_t<T> s) noexcept(std::is_arithmetic_v<T>) {
  return a = a * s;
}

template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr vec<T, N> operator-(const point<T, N>& a,
                                                       const point<T, N>& b) noexcept(std::is_arithmetic_v<T>) {
  return generate_coordinates<vec<T, N>>([&](int i) IRG_INLINE_LAMBDA { return a[i] - b[i]; });
}
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr point<T, N> operator+(const point<T, N>& a,
                                                         const vec<T, N>& v) noexcept(std::is_arithmetic_v<T>) {
  return generate_coordinates<point<T, N>>([&](int i) IRG_INLINE_LAMBDA { return a[i] + v[i]; });
}
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr point<T, N> operator-(const point<T, N>& a,
                                                         const vec<T, N>& v) noexcept(std::is_arithmetic_v<T>) {
  return generate_coordinates<point<T, N>>([&](int i) IRG_INLINE_LAMBDA { return a[i] - v[i]; });
}

/// Writes the coordinates, "(1, 2, 3)".
template <class S, class V>
  requires(detail::is_own<V>) && TextStream<S, scalar_of<V>>
constexpr S& operator<<(S& stream, const V& v) {
  return print_list(stream, size_of<V>, [&](int i) { return v[i]; });
}

/// The sum of the products of the coordinates.
/// gives   no NaN for coordinates below 2^510 (float: 2^62) in size, up to eight of them; beyond, infinities may meet
/// exact   each product and each sum rounded once, from the first coordinate to the last, never fused: the same bits
///         everywhere, which is what dot_fast and other libraries' products give up for their nanosecond
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>>)
[[nodiscard]] IRG_INLINE constexpr scalar_of<A> dot(const A& a,
                                                    const B& b) noexcept(std::is_arithmetic_v<scalar_of<A>>) {
  scalar_of<A> sum = product(coordinate(a, 0), coordinate(b, 0));
  for (int i = 1; i < size_of<A>; ++i) sum = sum + product(coordinate(a, i), coordinate(b, i));
  return sum;
}

/// The dot product for loops that the compiler is to vectorise: products may be fused with sums, so its last bits
/// depend on compiler, flags and surroundings. dot_products (math/vector_batch.hpp) is as fast with the bits of dot.
/// gives   no NaN where dot gives none
/// exact   within N u times the sum of the absolute values of the N products (u = 2^-53, float 2^-24), unless something
///         underflows
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] IRG_INLINE constexpr scalar_of<A> dot_fast(const A& a, const B& b) noexcept {
  scalar_of<A> sum = coordinate(a, 0) * coordinate(b, 0);
  for (int i = 1; i < size_of<A>; ++i) sum = sum + coordinate(a, i) * coordinate(b, i);
  return sum;
}

/// The vector at right angles to both, of the length of the parallelogram's area; counter-clockwise from a to b as
/// seen from its tip.
/// exact   each product and each difference rounded once; cross(a, a) is exactly zero where the products do not
///         overflow, that is for coordinates below 2^64 (float) or 2^512 (double)
template <Vector A, Vector B>
  requires(size_of<A> == 3 && size_of<B> == 3 && std::same_as<scalar_of<A>, scalar_of<B>>)
[[nodiscard]] IRG_INLINE constexpr A cross(const A& a, const B& b) noexcept(std::is_arithmetic_v<scalar_of<A>>) {
  const auto det = [&](int i, int j) IRG_INLINE_LAMBDA {
    return product(coordinate(a, i), coordinate(b, j)) - product(coordinate(a, j), coordinate(b, i));
  };
  return from_coordinates<A>(det(1, 2), det(2, 0), det(0, 1));
}

/// The area of the parallelogram of two vectors of the plane, positive where b lies counter-clockwise from a.
/// exact   each product and the difference rounded once
template <Vector A, Vector B>
  requires(size_of<A> == 2 && size_of<B> == 2 && std::same_as<scalar_of<A>, scalar_of<B>>)
[[nodiscard]] IRG_INLINE constexpr scalar_of<A> cross(const A& a,
                                                      const B& b) noexcept(std::is_arithmetic_v<scalar_of<A>>) {
  return product(coordinate(a, 0), coordinate(b, 1)) - product(coordinate(a, 1), coordinate(b, 0));
}

/// The cross product for loops that the compiler is to vectorise: products may be fused with differences, so its last
/// bits depend on compiler, flags and surroundings; cross_fast(a, a) need not be zero. cross_products
/// (math/vector_batch.hpp) is as fast with the bits of cross.
/// gives   no NaN for coordinates below 2^511 (float: 2^63) in size
/// exact   each coordinate within 2 u times the sum of the absolute values of its two products (u = 2^-53, float
///         2^-24), unless something underflows
template <Vector A, Vector B>
  requires(size_of<A> == 3 && size_of<B> == 3 && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] IRG_INLINE constexpr A cross_fast(const A& a, const B& b) noexcept {
  const auto det = [&](int i, int j) IRG_INLINE_LAMBDA {
    return coordinate(a, i) * coordinate(b, j) - coordinate(a, j) * coordinate(b, i);
  };
  return from_coordinates<A>(det(1, 2), det(2, 0), det(0, 1));
}

/// The displacement from the origin to p.
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr vec<T, N> to_vec(const point<T, N>& p) noexcept {
  return generate_coordinates<vec<T, N>>([&](int i) IRG_INLINE_LAMBDA { return p[i]; });
}

/// The position that v leads to from the origin.
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr point<T, N> to_point(const vec<T, N>& v) noexcept {
  return generate_coordinates<point<T, N>>([&](int i) IRG_INLINE_LAMBDA { return v[i]; });
}

/// irg's own vector of a vector of another type.
template <Vector V>
[[nodiscard]] IRG_INLINE constexpr vec<scalar_of<V>, size_of<V>> to_vec(const V& v) noexcept {
  return generate_coordinates<vec<scalar_of<V>, size_of<V>>>([&](int i) IRG_INLINE_LAMBDA { return coordinate(v, i); });
}

/// irg's own point of a point of another type.
template <Point P>
[[nodiscard]] IRG_INLINE constexpr point<scalar_of<P>, size_of<P>> to_point(const P& p) noexcept {
  return generate_coordinates<point<scalar_of<P>, size_of<P>>>([&](int i)
                                                                   IRG_INLINE_LAMBDA { return coordinate(p, i); });
}

}  // namespace IRG_ABI

namespace detail {
// irg's own type of the same meaning; a foreign type that may be a vector or a point becomes an array, which may, too.
template <Coordinates P>
struct own_coordinates {
  using type = std::array<scalar_of<P>, static_cast<std::size_t>(size_of<P>)>;
};
template <CoordinatesOfKind<coordinate_kind::vector> P>
struct own_coordinates<P> {
  using type = vec<scalar_of<P>, size_of<P>>;
};
template <CoordinatesOfKind<coordinate_kind::point> P>
struct own_coordinates<P> {
  using type = point<scalar_of<P>, size_of<P>>;
};
template <CoordinatesOfKind<coordinate_kind::homogeneous> P>
struct own_coordinates<P> {
  using type = hpoint<scalar_of<P>, size_of<P> - 1>;
};
}  // namespace detail

/// What algorithms keep and change for a vector or point of type P: a P, where one can be made without a value and be
/// assigned; otherwise a type of irg's or an array.
template <Coordinates P>
using assignable = std::conditional_t<std::semiregular<P>, P, typename detail::own_coordinates<P>::type>;

inline namespace IRG_ABI {

/// p, in the type that can be kept and changed.
template <Coordinates P>
[[nodiscard]] IRG_INLINE constexpr assignable<P> as_assignable(const P& p) noexcept {
  if constexpr (std::same_as<assignable<P>, P>)
    return p;
  else
    return generate_coordinates<assignable<P>>([&](int i) IRG_INLINE_LAMBDA { return coordinate(p, i); });
}

/// The P that was kept.
template <Coordinates P>
[[nodiscard]] IRG_INLINE constexpr P from_assignable(const assignable<P>& kept) noexcept {
  if constexpr (std::same_as<assignable<P>, P>)
    return kept;
  else
    return generate_coordinates<P>([&](int i) IRG_INLINE_LAMBDA { return coordinate(kept, i); });
}

/// The homogeneous form of p, of weight 1.
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr hpoint<T, N> to_homogeneous(const point<T, N>& p) noexcept {
  return generate_coordinates<hpoint<T, N>>([&](int i) IRG_INLINE_LAMBDA { return i < N ? p[i] : T(1); });
}

/// The position that p stands for: its coordinates over its weight.
/// needs   a weight that is not 0
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr point<T, N> to_cartesian(const hpoint<T, N>& p) noexcept {
  return generate_coordinates<point<T, N>>([&](int i) IRG_INLINE_LAMBDA { return p[i] / p[N]; });
}

IRG_REFUSES_POINTS(cross);
IRG_REFUSES_POINTS(cross_fast);
IRG_REFUSES_POINTS(dot);
IRG_REFUSES_POINTS(dot_fast);

}  // namespace IRG_ABI
}  // namespace irg
