// SPDX-License-Identifier: MIT
// Arrays of vectors: the results of dot, cross, normalized and normalized_fast, bit for bit, where a loop over those
// would take several times as long, because the guard against fused products keeps compilers from vectorising it.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include <irg/core/contract.hpp>
#include <irg/math/detail/coordinate_rows_kernel.hpp>
#include <irg/math/detail/vector_kernel.hpp>
#include <irg/math/length.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// Vectors in a row: a span, an array or a container of vec<float, 3> or vec<double, 3>, or of your own vectors of
/// three floats or doubles.
template <class R>
concept VectorArray = requires {
  requires Vector<detail::element_of<R>>;
  requires detail::Triple<detail::element_of<R>>;
};

inline namespace IRG_ABI {

/// out[i] = dot(a[i], b[i]).
/// needs   as many vectors in a, in b and numbers in `out`, which overlaps neither
/// exact   the bits of dot
template <VectorArray A, VectorArray B>
  requires std::same_as<detail::element_of<const A>, detail::element_of<const B>>
constexpr void dot_products(const A& a, const B& b, std::span<scalar_of<detail::element_of<const A>>> out) noexcept {
  const std::span from(a), with(b);
  IRG_EXPECTS(from.size() == with.size() && from.size() == out.size());
  if (from.empty()) return;
  const auto one = [&](std::size_t i) { out[i] = dot(from[i], with[i]); };
  detail::by_rows(
      from.size(), one, [&](auto* v, auto* w) { detail::dots(v, w, out.data(), from.size(), one); }, from[0], with[0]);
}

/// out[i] = cross(a[i], b[i]).
/// needs   as many vectors in a, b and `out`, which begins where one of them does or does not overlap it
/// exact   the bits of cross
template <VectorArray A, VectorArray B>
  requires std::same_as<detail::element_of<const A>, detail::element_of<const B>> &&
           std::copyable<detail::element_of<const A>>
constexpr void cross_products(const A& a, const B& b, std::span<detail::element_of<const A>> out) noexcept {
  const std::span from(a), with(b);
  IRG_EXPECTS(from.size() == with.size() && from.size() == out.size());
  if (from.empty()) return;
  const auto one = [&](std::size_t i) { out[i] = cross(from[i], with[i]); };
  detail::by_rows(
      from.size(), one, [&](auto* v, auto* w, auto* to) { detail::crosses(v, w, to, from.size(), one); }, from[0],
      with[0], out[0]);
}

/// out[i] = normalized(v[i]): the vector of length 1, or zero where there is no direction.
/// needs   as many vectors in v and `out`, which begins where v does or does not overlap it
/// exact   the bits of normalized
/// cost    floats take a fraction of a loop over normalized where the target has AVX2; doubles, and floats without it,
///         take that loop
template <VectorArray V>
  requires std::copyable<detail::element_of<const V>>
constexpr void normalize_vectors(const V& v, std::span<detail::element_of<const V>> out) noexcept {
  const std::span from(v);
  IRG_EXPECTS(from.size() == out.size());
  if (from.empty()) return;
  const auto one = [&](std::size_t i) { out[i] = normalized(from[i]); };
  detail::by_rows(
      from.size(), one, [&](auto* w, auto* to) { detail::normalize(w, to, from.size(), one); }, from[0], out[0]);
}

/// out[i] = normalized_fast(v[i]).
/// needs   as many vectors in v and `out`, which begins where v does or does not overlap it; vectors as for
///         normalized_fast
/// exact   the bits of normalized_fast
template <VectorArray V>
  requires std::copyable<detail::element_of<const V>>
constexpr void normalize_vectors_fast(const V& v, std::span<detail::element_of<const V>> out) noexcept {
  const std::span from(v);
  IRG_EXPECTS(from.size() == out.size());
  if (from.empty()) return;
  const auto one = [&](std::size_t i) { out[i] = normalized_fast(from[i]); };
  detail::by_rows(
      from.size(), one, [&](auto* w, auto* to) { detail::normalize_fast(w, to, from.size(), one); }, from[0], out[0]);
}

}  // namespace IRG_ABI
}  // namespace irg
