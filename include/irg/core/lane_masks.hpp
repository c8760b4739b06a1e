// SPDX-License-Identifier: MIT
// Comparisons of packs, what is chosen by them, and what all lanes have together. A mask holds, for each lane, an
// integer of the lane's size: all its bits where the comparison holds, else none. The operators of packs, which differ
// between targets, stand before the functions to call.
#pragma once

#include <cstdint>
#include <type_traits>

#include <irg/core/lane_integers.hpp>
#include <irg/core/lane_shuffles.hpp>
#include <irg/core/pack.hpp>

namespace irg::inline IRG_ABI {

namespace lanes_detail {

// compare(r, a, b) gives r lane by lane.
template <class T, int N, class Op>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> compare(const pack<T, N>& a, const pack<T, N>& b, const Op& op) noexcept {
#ifdef IRG_LANES_VECTOR
  decltype(a.v < b.v) r;
  op(r, a.v, b.v);
  return {reinterpret_cast<typename mask_of_lanes<T, N>::storage>(r)};
#else
  using number = typename lanes<mask_of_lanes<T, N>>::scalar;
  return lanes<mask_of_lanes<T, N>>::generate([&](int i) {
    bool r;
    op(r, a[i], b[i]);
    return r ? number(-1) : number(0);
  });
#endif
}

// Pairs of doubles, for which g++ goes by way of AVX-512's mask registers where there are some.
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
template <class T, int N>
inline constexpr bool is_pair = std::is_same_v<T, double> && N == 2;
#endif

}  // namespace lanes_detail

template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> operator<(const pack<T, N>& a, const pack<T, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  if constexpr (lanes_detail::is_pair<T, N>)
    return {reinterpret_cast<typename mask_of_lanes<T, N>::storage>(__builtin_ia32_cmpltpd(a.v, b.v))};
#endif
  return lanes_detail::compare(a, b, [](auto& r, const auto& x, const auto& y) { r = x < y; });
}
template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> operator<=(const pack<T, N>& a, const pack<T, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  if constexpr (lanes_detail::is_pair<T, N>)
    return {reinterpret_cast<typename mask_of_lanes<T, N>::storage>(__builtin_ia32_cmplepd(a.v, b.v))};
#endif
  return lanes_detail::compare(a, b, [](auto& r, const auto& x, const auto& y) { r = x <= y; });
}
template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> operator>(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return b < a;
}
template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> operator>=(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return b <= a;
}
template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> operator==(const pack<T, N>& a, const pack<T, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  if constexpr (lanes_detail::is_pair<T, N>)
    return {reinterpret_cast<typename mask_of_lanes<T, N>::storage>(__builtin_ia32_cmpeqpd(a.v, b.v))};
#endif
  return lanes_detail::compare(a, b, [](auto& r, const auto& x, const auto& y) { r = x == y; });
}

/// Where a <= b does not hold: a is greater, or one of them is NaN.
template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> not_at_most(const pack<T, N>& a, const pack<T, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)  // g++ would compare and turn the result round
  using storage = typename mask_of_lanes<T, N>::storage;
  if constexpr (lanes_detail::is_pair<T, N>) return {reinterpret_cast<storage>(__builtin_ia32_cmpnlepd(a.v, b.v))};
#ifdef __AVX__
  constexpr int not_less_or_equal = 6;
  if constexpr (std::is_same_v<T, double> && N == 4)
    return {reinterpret_cast<storage>(__builtin_ia32_cmppd256(a.v, b.v, not_less_or_equal))};
#endif
#endif
  return ~(a <= b);
}

/// The same with one number for all lanes.
template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> operator<(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a < lanes<pack<T, N>>::broadcast(b);
}
template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> operator<=(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a <= lanes<pack<T, N>>::broadcast(b);
}
template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> operator>(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a > lanes<pack<T, N>>::broadcast(b);
}
template <class T, int N>
[[nodiscard]] IRG_INLINE mask_of_lanes<T, N> operator>=(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a >= lanes<pack<T, N>>::broadcast(b);
}

/// a where the mask holds, b elsewhere.
template <class T>
[[nodiscard]] IRG_INLINE constexpr T select(bool mask, T a, T b) noexcept {
  return mask ? a : b;
}
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> select(const std::type_identity_t<mask_of_lanes<T, N>>& mask, const pack<T, N>& a,
                                           const pack<T, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE4_1__)
  if constexpr (lanes_detail::is_pair<T, N>)
    return {__builtin_ia32_blendvpd(b.v, a.v, reinterpret_cast<typename pack<T, N>::storage>(mask.v))};
#elif defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  if constexpr (sizeof(T) == 8) {  // masks of this size cannot be compared with zero
    const auto bits = (mask & bits_as<std::int64_t>(a)) | (~mask & bits_as<std::int64_t>(b));
    return bits_as<T>(bits);
  }
#endif
#ifdef IRG_LANES_VECTOR
  return {mask.v ? a.v : b.v};
#else
  return lanes<pack<T, N>>::generate([&](int i) { return mask[i] != 0 ? a[i] : b[i]; });
#endif
}

/// The smaller and the larger of two numbers, lane by lane; b when they are unordered. In one instruction where there
/// is one; g++ does not find the second.
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> minimum(const pack<T, N>& a, const pack<T, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  if constexpr (std::is_same_v<T, float> && N == 4) return {__builtin_ia32_minps(a.v, b.v)};
  if constexpr (std::is_same_v<T, double> && N == 2) return {__builtin_ia32_minpd(a.v, b.v)};
#ifdef __AVX__
  if constexpr (std::is_same_v<T, float> && N == 8) return {__builtin_ia32_minps256(a.v, b.v)};
  if constexpr (std::is_same_v<T, double> && N == 4) return {__builtin_ia32_minpd256(a.v, b.v)};
#endif
#endif
  return select(a < b, a, b);
}
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> maximum(const pack<T, N>& a, const pack<T, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  if constexpr (std::is_same_v<T, float> && N == 4) return {__builtin_ia32_maxps(a.v, b.v)};
  if constexpr (std::is_same_v<T, double> && N == 2) return {__builtin_ia32_maxpd(a.v, b.v)};
#ifdef __AVX__
  if constexpr (std::is_same_v<T, float> && N == 8) return {__builtin_ia32_maxps256(a.v, b.v)};
  if constexpr (std::is_same_v<T, double> && N == 4) return {__builtin_ia32_maxpd256(a.v, b.v)};
#endif
#endif
  return select(b < a, a, b);
}

/// Where both masks hold.
[[nodiscard]] IRG_INLINE constexpr bool both(bool a, bool b) noexcept { return a && b; }
template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> both(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return a & b;
}

/// Where none of three numbers is negative.
template <int N>
[[nodiscard]] IRG_INLINE pack<std::int32_t, N> none_negative(const pack<std::int32_t, N>& a,
                                                             const pack<std::int32_t, N>& b,
                                                             const pack<std::int32_t, N>& c) noexcept {
  return ~((a | b | c) >> 31);  // of >= 0 g++ 12 makes two instructions, again for each use
}

namespace lanes_detail {

// One bit per lane, set where the lane's sign bit is.
template <class T, int N>
[[nodiscard]] IRG_INLINE auto sign_bits(const pack<T, N>& p) noexcept {
  using bits = std::conditional_t<(N > 32), std::uint64_t, unsigned>;
  static_assert(N <= 64);
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  if constexpr (sizeof p > native_bytes) {
    return static_cast<bits>(sign_bits(low_half(p)) | bits{sign_bits(high_half(p))} << (N / 2));
  } else {
#ifdef __AVX__
    if constexpr (sizeof(T) == 4 && N == 8) return static_cast<bits>(__builtin_ia32_movmskps256(bits_as<float>(p).v));
    if constexpr (sizeof(T) == 8 && N == 4) return static_cast<bits>(__builtin_ia32_movmskpd256(bits_as<double>(p).v));
#endif
#ifdef __AVX2__
    if constexpr (sizeof(T) == 1 && N == 32) return static_cast<bits>(__builtin_ia32_pmovmskb256(bits_as<char>(p).v));
#endif
    if constexpr (sizeof(T) == 4 && N == 4) return static_cast<bits>(__builtin_ia32_movmskps(bits_as<float>(p).v));
    if constexpr (sizeof(T) == 8 && N == 2) return static_cast<bits>(__builtin_ia32_movmskpd(bits_as<double>(p).v));
    if constexpr (sizeof(T) == 1 && N == 16) return static_cast<bits>(__builtin_ia32_pmovmskb128(bits_as<char>(p).v));
  }
#endif
  const auto numbers = bits_as<typename lanes<mask_of_lanes<T, N>>::scalar>(p);
  bits all = 0;
  for (int i = 0; i < N; ++i) all |= numbers[i] < 0 ? bits{1} << i : bits{0};
  return all;
}

}  // namespace lanes_detail

/// One bit per lane, lane 0 the lowest, set where the mask holds.
/// needs   masks of at most 64 lanes
[[nodiscard]] IRG_INLINE constexpr unsigned mask_bits(bool mask) noexcept { return mask ? 1u : 0u; }
template <std::signed_integral T, int N>
[[nodiscard]] IRG_INLINE auto mask_bits(const pack<T, N>& mask) noexcept {
  return lanes_detail::sign_bits(mask);
}

/// One bit per lane, lane 0 the lowest, set where the sign bit is: of -0 and of NaN, too.
template <std::floating_point T, int N>
[[nodiscard]] IRG_INLINE auto sign_bits(const pack<T, N>& p) noexcept {
  return lanes_detail::sign_bits(p);
}

/// Whether the mask holds in any lane, in all, in none.
template <class Mask>
[[nodiscard]] IRG_INLINE constexpr bool any_lane(const Mask& mask) noexcept {
  return mask_bits(mask) != 0;
}
template <class Mask>
[[nodiscard]] IRG_INLINE constexpr bool no_lane(const Mask& mask) noexcept {
  return mask_bits(mask) == 0;
}
template <class Mask>
[[nodiscard]] IRG_INLINE constexpr bool all_lanes(const Mask& mask) noexcept {
  const auto bits = mask_bits(mask);
  return bits == ~decltype(mask_bits(mask)){0} >> (8 * static_cast<int>(sizeof bits) - lanes<Mask>::count);
}

namespace lanes_detail {

template <class T, class Op>
[[nodiscard]] IRG_INLINE constexpr T folded(T x, const Op&) noexcept {
  return x;
}
template <class T, int N, class Op>
[[nodiscard]] IRG_INLINE T folded(const pack<T, N>& p, const Op& op) noexcept {
  if constexpr (N == 1)
    return p[0];
  else
    return folded(op(low_half(p), high_half(p)), op);
}

}  // namespace lanes_detail

/// The least and the greatest of all lanes, and their sum: each lane of the lower half with that of the upper, until
/// one is left.
/// exact   lanes 0 to 3 are summed as (0 + 2) + (1 + 3); the order follows the number of lanes. No NaN among floats
template <class F>
[[nodiscard]] IRG_INLINE constexpr auto reduce_min(const F& x) noexcept {
  return lanes_detail::folded(x, [](const auto& a, const auto& b) { return minimum(a, b); });
}
template <class F>
[[nodiscard]] IRG_INLINE constexpr auto reduce_max(const F& x) noexcept {
  return lanes_detail::folded(x, [](const auto& a, const auto& b) { return maximum(a, b); });
}
template <class F>
[[nodiscard]] IRG_INLINE constexpr auto reduce_add(const F& x) noexcept {
  return lanes_detail::folded(x, [](const auto& a, const auto& b) { return a + b; });
}

IRG_RENAMED(low_of, minimum)
IRG_RENAMED(high_of, maximum)
IRG_RENAMED(least_of, reduce_min)
IRG_RENAMED(greatest_of, reduce_max)
IRG_RENAMED(total, reduce_add)

}  // namespace irg::inline IRG_ABI
