// SPDX-License-Identifier: MIT
// The steps of values_of.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include <irg/math/detail/polynomial_arguments.hpp>
#include <irg/math/detail/twofold.hpp>
#include <irg/math/exact/exact_number.hpp>
#include <irg/math/exact/known_number.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail::inline IRG_ABI {

IRG_INLINE constexpr bool suits_twofold(double x) noexcept { return is_zero_or_within<-80, 80>(x); }

// each(x) for every number of what a polynomial gave, in the same arrangement.
template <class N, class F>
IRG_INLINE constexpr auto for_numbers(const N& x, const F& each) noexcept {
  return each(x);
}
template <class N, int D, class F>
IRG_INLINE constexpr auto for_numbers(const vec<N, D>& v, const F& each) noexcept {
  return generate_coordinates<vec<decltype(each(v[0])), D>>([&](int i) IRG_INLINE_LAMBDA { return each(v[i]); });
}
template <class N, std::size_t D, class F>
IRG_INLINE constexpr auto for_numbers(const std::array<N, D>& v, const F& each) noexcept {
  return [&]<std::size_t... J>(std::index_sequence<J...>) IRG_INLINE_LAMBDA {
    return std::array<decltype(each(v[0])), D>{each(v[J])...};
  }(std::make_index_sequence<D>{});
}
template <class... N, class F>
IRG_INLINE constexpr auto for_numbers(const std::tuple<N...>& t, const F& each) noexcept {
  return std::apply([&](const N&... x) IRG_INLINE_LAMBDA { return std::tuple{for_numbers(x, each)...}; }, t);
}

IRG_INLINE constexpr known_number known_of(const twofold& x) noexcept { return {x.high, x.low, 0}; }

template <int Degree, class Polynomial, class... A>
IRG_NOINLINE constexpr auto exact_values_of(const Polynomial& polynomial, const A&... arguments) noexcept {
  using number = exact_number<Degree>;
  const auto exact = [](const auto& x) { return exactly<number>(x); };
  return for_numbers(polynomial(in_numbers<number>(arguments, exact)...), [](const number& x) { return x.rounded(); });
}

}  // namespace irg::detail::inline IRG_ABI
