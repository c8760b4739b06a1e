// SPDX-License-Identifier: MIT
// Lanes in another order, and halves of packs.
#pragma once

#include <cstring>
#include <utility>

#include <irg/core/pack.hpp>

namespace irg::inline IRG_ABI {

/// The lanes J, in this order, of a and b, one behind the other.
template <int... J, class T, int N>
[[nodiscard]] IRG_INLINE pack<T, static_cast<int>(sizeof...(J))> shuffled(const pack<T, N>& a,
                                                                          const pack<T, N>& b) noexcept {
  static_assert(((J >= 0 && J < 2 * N) && ...));
#ifdef IRG_LANES_VECTOR
  return {__builtin_shufflevector(a.v, b.v, J...)};
#else
  return {{(J < N ? a[J % N] : b[J % N])...}};
#endif
}
/// The lanes J, in this order, of one pack.
template <int... J, class T, int N>
[[nodiscard]] IRG_INLINE pack<T, static_cast<int>(sizeof...(J))> shuffled(const pack<T, N>& a) noexcept {
  return shuffled<J...>(a, a);
}

namespace lanes_detail {

template <class Index, int... J, class T, int N>
[[nodiscard]] IRG_INLINE pack<T, static_cast<int>(sizeof...(J))> shuffled_by(
    const pack<T, N>& a, const pack<T, N>& b, std::integer_sequence<int, J...>) noexcept {
  return shuffled<Index{}(J)...>(a, b);
}

}  // namespace lanes_detail

/// The same with the order by a rule: lane i of M is lane index(i).
/// needs   index: a callable without state that takes constants to constants
template <int M, class T, int N, class Index>
[[nodiscard]] IRG_INLINE pack<T, M> shuffled_by(const pack<T, N>& a, const pack<T, N>& b, Index) noexcept {
  return lanes_detail::shuffled_by<Index>(a, b, std::make_integer_sequence<int, M>{});
}
template <int M, class T, int N, class Index>
[[nodiscard]] IRG_INLINE pack<T, M> shuffled_by(const pack<T, N>& a, Index index) noexcept {
  return shuffled_by<M>(a, a, index);
}

/// The lower and the upper half of the lanes.
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N / 2> low_half(const pack<T, N>& p) noexcept {
  return shuffled_by<N / 2>(p, [](int i) { return i; });
}
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N / 2> high_half(const pack<T, N>& p) noexcept {
  return shuffled_by<N / 2>(p, [](int i) { return i + N / 2; });
}

/// Two halves of a pack, put together.
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> join_halves(const pack<T, N / 2>& low, const pack<T, N / 2>& high) noexcept {
  if constexpr (sizeof(pack<T, N>) <= static_cast<unsigned>(widest_bytes)) {
    return shuffled_by<N>(low, high, [](int i) { return i; });
  } else {  // which g++ 12 would put together number by number
    pack<T, N> joined;
    std::memcpy(&joined.v, &low.v, sizeof low);
    std::memcpy(reinterpret_cast<char*>(&joined.v) + sizeof low, &high.v, sizeof high);
    return joined;
  }
}

/// M lanes: those of p again and again.
template <int M, class T, int N>
[[nodiscard]] IRG_INLINE pack<T, M> repeated(const pack<T, N>& p) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__AVX512F__) && !defined(__clang__)
  // g++ 12 makes a wider register of a narrower one by way of memory.
  if constexpr (std::is_same_v<T, float> && N == 4 && M == 16)
    return {__builtin_ia32_broadcastf32x4_512(p.v, typename pack<T, M>::storage{}, static_cast<unsigned short>(-1))};
  if constexpr (std::is_same_v<T, double> && N == 4 && M == 8)
    return {__builtin_ia32_broadcastf64x4_512(p.v, typename pack<T, M>::storage{}, static_cast<unsigned char>(-1))};
#endif
  return shuffled_by<M>(p, [](int i) { return i % N; });
}

}  // namespace irg::inline IRG_ABI
