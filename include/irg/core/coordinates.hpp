// SPDX-License-Identifier: MIT
// Vectors, points and homogeneous points: anything with a fixed number of coordinates.
//
// The one customisation point is coordinate_traits<T>. It fits, without a word from the user,
//   * types with members x and y, or x, y and z, or x, y, z and w, of one type     (plain structs, GLM),
//   * std::array and other tuple-like types with operator[],
//   * fixed-size column vectors with RowsAtCompileTime and operator[] (Eigen).
// each where T{c...} makes one from its coordinates. Rectangles with x, y, w and h, or width and height, are refused,
// not mistaken for points. Any other type is admitted by specialising it:
//
//   template <> struct irg::coordinate_traits<my::vector> {
//     using scalar = float;
//     static constexpr int size = 3;
//     static constexpr auto kind = irg::coordinate_kind::any;
//     static constexpr float get(const my::vector& v, int i) { return v.at(i); }
//     static constexpr my::vector make(float x, float y, float z) { return my::vector(x, y, z); }
//   };
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/core/scalar.hpp>

namespace irg {

/// What a coordinate type means. `any` serves as vector and as point: foreign types seldom tell the two apart.
enum class coordinate_kind { any, vector, point, homogeneous };

namespace detail {

template <class T>
concept has_xy = requires(const T& v) {
  requires Number<std::remove_cvref_t<decltype(v.x)>>;
  requires std::same_as<std::remove_cvref_t<decltype(v.x)>, std::remove_cvref_t<decltype(v.y)>>;
};
template <class T>
concept has_z = requires(const T& v) { v.z; };
template <class T>
concept has_w = requires(const T& v) { v.w; };
template <class T>
concept has_extent = requires(const T& v) {
  v.width;
  v.height;
};
// x and y; x, y and z; or x, y, z and w, all of one type. A w without z may be a width or a weight: it is not guessed.
template <class T>
concept has_named_coordinates =
    has_xy<T> && !has_extent<T> && (has_z<T> || !has_w<T>) && (!has_z<T> || requires(const T& v) {
      requires std::same_as<std::remove_cvref_t<decltype(v.x)>, std::remove_cvref_t<decltype(v.z)>>;
    }) && (!has_w<T> || requires(const T& v) {
      requires std::same_as<std::remove_cvref_t<decltype(v.x)>, std::remove_cvref_t<decltype(v.w)>>;
    });
template <class T>
concept subscriptable = requires(const T& v, int i) { requires Number<std::remove_cvref_t<decltype(v[i])>>; };
template <class T>
concept tuple_sized = requires { std::tuple_size<T>::value; };
template <class T>
concept eigen_like = requires { requires(T::RowsAtCompileTime >= 1) && (T::ColsAtCompileTime == 1); };

// Only irg's own meaning of `kind` counts: a foreign type may have a member of that name for purposes of its own.
template <class T>
constexpr coordinate_kind kind_of() {
  if constexpr (requires { requires std::same_as<decltype(T::kind), const coordinate_kind>; })
    return T::kind;
  else
    return coordinate_kind::any;
}

template <class T, class Traits, class S, int... J>
constexpr bool makes_from(std::integer_sequence<int, J...>) {
  return requires(const S c) {
    { Traits::make((static_cast<void>(J), c)...) } -> std::convertible_to<T>;
  };
}

template <class T, class Traits, class S>
concept made_from_coordinates = makes_from<T, Traits, S>(std::make_integer_sequence<int, Traits::size>{});

}  // namespace detail

/// How irg reads and makes a type with coordinates. Members: scalar, size, kind, get(v, i), make(coordinates...).
template <class T>
struct coordinate_traits {};

template <detail::has_named_coordinates T>
struct coordinate_traits<T> {
  using scalar = std::remove_cvref_t<decltype(std::declval<const T&>().x)>;
  static constexpr int size = detail::has_w<T> ? 4 : detail::has_z<T> ? 3 : 2;
  static constexpr coordinate_kind kind = detail::kind_of<T>();

  IRG_INLINE static constexpr scalar get(const T& v, int i) noexcept(std::is_nothrow_copy_constructible_v<scalar>) {
    if constexpr (size == 4)
      return i == 0 ? v.x : i == 1 ? v.y : i == 2 ? v.z : v.w;
    else if constexpr (size == 3)
      return i == 0 ? v.x : i == 1 ? v.y : v.z;
    else
      return i == 0 ? v.x : v.y;
  }
  template <class... S>
    requires requires(const S&... c) { T{static_cast<scalar>(c)...}; }
  IRG_INLINE static constexpr T make(const S&... c) noexcept(std::is_arithmetic_v<scalar>) {
    return T{converted<scalar>(c)...};
  }
};

template <class T>
  requires(!detail::has_named_coordinates<T> && detail::subscriptable<T> &&
           (detail::tuple_sized<T> || detail::eigen_like<T>))
struct coordinate_traits<T> {
  using scalar = std::remove_cvref_t<decltype(std::declval<const T&>()[std::declval<int>()])>;
  static constexpr int size = [] {
    if constexpr (detail::tuple_sized<T>)
      return static_cast<int>(std::tuple_size<T>::value);
    else
      return static_cast<int>(T::RowsAtCompileTime);
  }();
  static constexpr coordinate_kind kind = detail::kind_of<T>();

  IRG_INLINE static constexpr scalar get(const T& v, int i) noexcept(std::is_nothrow_copy_constructible_v<scalar>) {
    if constexpr (detail::tuple_sized<T>)
      return v[static_cast<std::size_t>(i)];
    else
      return v[i];
  }
  template <class... S>
    requires requires(const S&... c) { T{static_cast<scalar>(c)...}; }
  IRG_INLINE static constexpr T make(const S&... c) noexcept(std::is_arithmetic_v<scalar>) {
    return T{converted<scalar>(c)...};
  }
};

/// A type with a fixed number of coordinates, readable by index and made from them.
template <class T>
concept Coordinates = requires(const T& v) {
  requires Number<typename coordinate_traits<T>::scalar>;
  requires(coordinate_traits<T>::size >= 1);
  requires std::same_as<std::remove_cvref_t<decltype(coordinate_traits<T>::kind)>, coordinate_kind>;
  { coordinate_traits<T>::get(v, 0) } -> std::convertible_to<typename coordinate_traits<T>::scalar>;
  requires detail::made_from_coordinates<T, coordinate_traits<T>, typename coordinate_traits<T>::scalar>;
};

/// A type whose coordinates are declared to mean that, and nothing else. Models of `point`: point, not glm::vec3.
template <class T, coordinate_kind Kind>
concept CoordinatesOfKind = Coordinates<T> && coordinate_traits<T>::kind == Kind;

/// A displacement. Models: vec, glm::vec3, Eigen::Vector3f, std::array<double, 3>, a struct with x, y and z.
template <class T>
concept Vector = Coordinates<T> && (coordinate_traits<T>::kind == coordinate_kind::any ||
                                    coordinate_traits<T>::kind == coordinate_kind::vector);

/// A position. Models: point, and every foreign type that is a Vector.
template <class T>
concept Point = Coordinates<T> && (coordinate_traits<T>::kind == coordinate_kind::any ||
                                   coordinate_traits<T>::kind == coordinate_kind::point);

/// A position of the projective space; the last coordinate is its weight. Models: hpoint, and every foreign type of
/// three or more coordinates, such as glm::vec4.
template <class T>
concept HomogeneousPoint =
    Coordinates<T> && (coordinate_traits<T>::kind == coordinate_kind::homogeneous ||
                       (coordinate_traits<T>::kind == coordinate_kind::any && coordinate_traits<T>::size >= 3));

/// The number type of a type with coordinates.
template <Coordinates T>
using scalar_of = typename coordinate_traits<T>::scalar;

/// How many coordinates a type has.
template <Coordinates T>
inline constexpr int size_of = coordinate_traits<T>::size;

// Said in the first line of the error: a function of vectors that is given a point is found, and not to be called; so
// is one of points that is given a vector. g++ prints the deleted function's parameters, clang the reason.
#ifdef __clang__
#define IRG_REFUSED(name, parameters, reason) \
  __attribute__((unavailable(reason))) int name(const parameters&...) noexcept
#else
#define IRG_REFUSED(name, parameters, reason) int name(const parameters&...) noexcept = delete
#endif
#define IRG_REFUSES_POINTS(name)                                                         \
  template <class... PointWhereVectorIsWanted>                                           \
    requires(... || CoordinatesOfKind<PointWhereVectorIsWanted, coordinate_kind::point>) \
  IRG_REFUSED(name, PointWhereVectorIsWanted, "a point stands where a vector is wanted")
#define IRG_REFUSES_VECTORS(name)                                                         \
  template <class... VectorWherePointIsWanted>                                            \
    requires(... || CoordinatesOfKind<VectorWherePointIsWanted, coordinate_kind::vector>) \
  IRG_REFUSED(name, VectorWherePointIsWanted, "a vector stands where a point is wanted")

inline namespace IRG_ABI {

/// Coordinate i of v.
/// needs   0 <= i < size_of<T>
template <Coordinates T>
[[nodiscard]] IRG_INLINE constexpr scalar_of<T> coordinate(const T& v,
                                                           int i) noexcept(noexcept(coordinate_traits<T>::get(v, i))) {
  return coordinate_traits<T>::get(v, i);
}

/// Whether all coordinates of a and b are equal: 0 and -0 are, NaN equals nothing.
template <Coordinates T>
[[nodiscard]] IRG_INLINE constexpr bool same_place(const T& a, const T& b) noexcept {
  for (int i = 0; i < size_of<T>; ++i)
    if (!(coordinate(a, i) == coordinate(b, i))) return false;
  return true;
}

/// Whether a comes before b: by the first coordinate in which they differ.
/// gives   false where that is NaN
template <Coordinates T>
[[nodiscard]] IRG_INLINE constexpr bool comes_before(const T& a, const T& b) noexcept {
  for (int i = 0; i < size_of<T>; ++i)
    if (!(coordinate(a, i) == coordinate(b, i))) return coordinate(a, i) < coordinate(b, i);
  return false;
}

/// A T with the given coordinates.
template <Coordinates T, class... S>
  requires(sizeof...(S) == static_cast<std::size_t>(size_of<T>))
[[nodiscard]] IRG_INLINE constexpr T from_coordinates(const S&... c) noexcept(
    noexcept(coordinate_traits<T>::make(c...))) {
  return coordinate_traits<T>::make(c...);
}

/// A T whose coordinate i is f(i); f is called once for each i, in no particular order.
template <Coordinates T, class F>
IRG_INLINE constexpr T generate_coordinates(F&& f) {
  return [&]<int... J>(std::integer_sequence<int, J...>) IRG_INLINE_LAMBDA {
    return coordinate_traits<T>::make(f(J)...);
  }(std::make_integer_sequence<int, size_of<T>>{});
}

/// A T whose coordinates are 0: what stands in a result without a point. Types need no default constructor for it, and
/// T{} of another library may hold anything.
template <Coordinates T>
[[nodiscard]] IRG_INLINE constexpr T zero_coordinates() {
  return generate_coordinates<T>([](int) { return scalar_of<T>(0); });
}

}  // namespace IRG_ABI
}  // namespace irg
