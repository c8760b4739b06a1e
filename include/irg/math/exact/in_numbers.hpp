// SPDX-License-Identifier: MIT
// What a polynomial is handed: its arguments with every number replaced by one of the engine's, points as points,
// vectors as vectors. A type of the user's own takes part by an overload of in_numbers beside it.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <irg/core/coordinates.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/vec.hpp>

namespace irg::inline IRG_ABI {

/// number(x), of the type that stands for a number as it came.
template <class N, Scalar T, class F>
[[nodiscard]] IRG_INLINE constexpr auto in_numbers(const T& x, const F& number) noexcept {
  return number(x);
}
/// A vec or hpoint of N, a point or an array of numbers as they came: each coordinate through number(x).
template <class N, Coordinates C, class F>
[[nodiscard]] IRG_INLINE constexpr auto in_numbers(const C& c, const F& number) noexcept {
  using input = std::remove_cvref_t<decltype(number(coordinate(c, 0)))>;
  constexpr int size = size_of<C>;
  constexpr coordinate_kind kind = coordinate_traits<C>::kind;
  const auto make = [&]<class To>(std::type_identity<To>) IRG_INLINE_LAMBDA {
    return generate_coordinates<To>([&](int i) IRG_INLINE_LAMBDA { return number(coordinate(c, i)); });
  };
  if constexpr (kind == coordinate_kind::vector)
    return make(std::type_identity<vec<N, size>>{});
  else if constexpr (kind == coordinate_kind::homogeneous)
    return make(std::type_identity<hpoint<N, size - 1>>{});
  else if constexpr (size == 2 || size == 3)
    return make(std::type_identity<point<input, size>>{});
  else
    return make(std::type_identity<std::array<input, static_cast<std::size_t>(size)>>{});
}

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The number type of an argument.
template <class A>
struct scalar_in {};
template <Scalar T>
struct scalar_in<T> {
  using type = T;
};
template <Coordinates C>
struct scalar_in<C> {
  using type = scalar_of<C>;
};
template <template <class> class A, class T>
  requires(!Coordinates<A<T>> && !Scalar<A<T>>)
struct scalar_in<A<T>> {
  using type = T;
};
template <template <class, int> class A, class T, int N>
  requires(!Coordinates<A<T, N>> && !Scalar<A<T, N>>)
struct scalar_in<A<T, N>> {
  using type = T;
};
template <class A, class...>
struct first_scalar {
  using type = typename scalar_in<A>::type;
};
template <class... A>
using argument_scalar = typename first_scalar<A...>::type;

}  // namespace irg::detail::inline IRG_ABI
