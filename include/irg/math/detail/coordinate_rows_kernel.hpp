// SPDX-License-Identifier: MIT
// Arrays of vectors and points as rows of numbers: irg's own types, and others that are three numbers in a row.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/core/lanes.hpp>
#include <irg/core/scalar.hpp>

namespace irg::detail {

template <class R>
using element_of = std::remove_cv_t<typename decltype(std::span(std::declval<R&>()))::element_type>;

// Three floating-point numbers and nothing else.
template <class V>
concept Triple = Coordinates<V> && size_of<V> == 3 && Floating<scalar_of<V>> && sizeof(V) == 3 * sizeof(scalar_of<V>);

// Where the numbers of a triple begin, where they follow each other; otherwise null.
template <class V>
IRG_INLINE constexpr auto row_of(V& v) noexcept {
  using number = scalar_of<std::remove_cv_t<V>>;
  using T = std::conditional_t<std::is_const_v<V>, const number, number>;
  T* first = nullptr;
  if constexpr (requires {
                  v.x, v.y, v.z;
                  requires std::same_as<decltype(&v.x), T*>;
                }) {
    if (&v.y == &v.x + 1 && &v.z == &v.x + 2) first = &v.x;
  } else if constexpr (requires { requires std::same_as<decltype(&v[0]), T*>; }) {
    if (&v[1] == &v[0] + 1 && &v[2] == &v[0] + 2) first = &v[0];
  }
  return first;
}

// Calls kernel(rows...) where there are lanes and all of the arrays' first elements are rows, otherwise one(i) for each
// of n elements.
template <class One, class Kernel, class... V>
IRG_INLINE constexpr void by_rows(std::size_t n, const One& one, const Kernel& kernel, V&... first) noexcept {
  // Whether addresses follow each other is no constant.
  if (has_lanes && !std::is_constant_evaluated() && (row_of(first) && ...)) return kernel(row_of(first)...);
  for (std::size_t i = 0; i < n; ++i) one(i);
}

}  // namespace irg::detail
