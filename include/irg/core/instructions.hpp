// SPDX-License-Identifier: MIT
// Arithmetic that a processor has an instruction for and the language no word: magnitude, square root, fused
// multiply-add; of a number, and of each lane of a pack.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/lane_integers.hpp>
#include <irg/core/pack.hpp>

namespace irg::inline IRG_ABI {

/// |x| by clearing the sign bit.
#if defined(__GNUC__)  // stays in the floating-point registers, where g++ takes the bits through others
[[nodiscard]] IRG_INLINE constexpr double magnitude(double x) noexcept { return __builtin_fabs(x); }
[[nodiscard]] IRG_INLINE constexpr float magnitude(float x) noexcept { return __builtin_fabsf(x); }
#else
[[nodiscard]] IRG_INLINE constexpr double magnitude(double x) noexcept {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63));
}
[[nodiscard]] IRG_INLINE constexpr float magnitude(float x) noexcept {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) & 0x7fffffffu);
}
#endif
template <std::floating_point T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> magnitude(const pack<T, N>& x) noexcept {
  using bits = typename lanes<mask_of_lanes<T, N>>::scalar;
  return bits_as<T>(bits_as<bits>(x) & (std::numeric_limits<bits>::max)());
}

/// The square root at run time.
/// exact   correctly rounded
// __builtin_sqrt would branch to the C library for errno's sake.
template <Floating T>
[[nodiscard]] IRG_INLINE T square_root_instruction(T x) noexcept {
#if defined(__clang__) && __has_builtin(__builtin_elementwise_sqrt)
  return __builtin_elementwise_sqrt(x);
#elif defined(__SSE2__) && defined(__GNUC__) && !defined(__clang__)
  T root;
#ifdef __AVX__  // the older encoding among AVX instructions stalls for a hundred cycles and more
  if constexpr (std::is_same_v<T, float>)
    asm("vsqrtss %1, %1, %0" : "=x"(root) : "x"(x));
  else
    asm("vsqrtsd %1, %1, %0" : "=x"(root) : "x"(x));
#else
  root = x;  // in place: a register of its own would have to wait for what was in it
  if constexpr (std::is_same_v<T, float>)
    asm("sqrtss %0, %0" : "+x"(root));
  else
    asm("sqrtsd %0, %0" : "+x"(root));
#endif
  return root;
#elif defined(__GNUC__)
  if constexpr (std::is_same_v<T, float>)
    return __builtin_sqrtf(x);
  else
    return __builtin_sqrt(x);
#else
#error "irg: this compiler's square root instruction is not known"
#endif
}
template <std::floating_point T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> square_root_instruction(const pack<T, N>& x) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__clang__) && __has_builtin(__builtin_elementwise_sqrt)
  return {__builtin_elementwise_sqrt(x.v)};
#else
#if defined(IRG_LANES_VECTOR)
  [[maybe_unused]] constexpr bool is_float = std::is_same_v<T, float>;
#if defined(__SSE2__)
  if constexpr (is_float && N == 4) return {__builtin_ia32_sqrtps(x.v)};
  if constexpr (!is_float && N == 2) return {__builtin_ia32_sqrtpd(x.v)};
#endif
#if defined(__AVX__)
  if constexpr (is_float && N == 8) return {__builtin_ia32_sqrtps256(x.v)};
  if constexpr (!is_float && N == 4) return {__builtin_ia32_sqrtpd256(x.v)};
#endif
#if defined(__AVX512F__) && defined(__clang__)  // 4: rounding as the environment says
  if constexpr (is_float && N == 16) return {__builtin_ia32_sqrtps512(x.v, 4)};
  if constexpr (!is_float && N == 8) return {__builtin_ia32_sqrtpd512(x.v, 4)};
#elif defined(__AVX512F__)
  if constexpr (is_float && N == 16) return {__builtin_ia32_sqrtps512_mask(x.v, x.v, -1, 4)};
  if constexpr (!is_float && N == 8) return {__builtin_ia32_sqrtpd512_mask(x.v, x.v, -1, 4)};
#endif
#endif
  return lanes<pack<T, N>>::generate([&](int i) { return square_root_instruction(x[i]); });
#endif
}

/// Whether the target has an instruction that computes a*b + c with one rounding.
#if defined(__FMA__) || defined(__aarch64__)
inline constexpr bool has_fused_multiply_add = true;
#else
inline constexpr bool has_fused_multiply_add = false;
#endif

/// a*b + c at run time, rounded once where has_fused_multiply_add, else twice.
[[nodiscard]] IRG_INLINE double fused_multiply_add(double a, double b, double c) noexcept {
#if defined(__FMA__) || defined(__aarch64__)
  return __builtin_fma(a, b, c);
#else
  return product(a, b) + c;
#endif
}
[[nodiscard]] IRG_INLINE float fused_multiply_add(float a, float b, float c) noexcept {
#if defined(__FMA__) || defined(__aarch64__)
  return __builtin_fmaf(a, b, c);
#else
  return product(a, b) + c;
#endif
}
template <std::floating_point T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> fused_multiply_add(const pack<T, N>& a, const pack<T, N>& b,
                                                       const pack<T, N>& c) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__FMA__) && defined(__clang__) && __has_builtin(__builtin_elementwise_fma)
  return {__builtin_elementwise_fma(a.v, b.v, c.v)};
#else
#if defined(IRG_LANES_VECTOR) && defined(__FMA__)
  [[maybe_unused]] constexpr bool is_float = std::is_same_v<T, float>;
  if constexpr (is_float && N == 4) return {__builtin_ia32_vfmaddps(a.v, b.v, c.v)};
  if constexpr (!is_float && N == 2) return {__builtin_ia32_vfmaddpd(a.v, b.v, c.v)};
#ifdef __AVX__
  if constexpr (is_float && N == 8) return {__builtin_ia32_vfmaddps256(a.v, b.v, c.v)};
  if constexpr (!is_float && N == 4) return {__builtin_ia32_vfmaddpd256(a.v, b.v, c.v)};
#endif
#if defined(__AVX512F__)  // 4: rounding as the environment says
  if constexpr (is_float && N == 16)
    return {__builtin_ia32_vfmaddps512_mask(a.v, b.v, c.v, static_cast<unsigned short>(-1), 4)};
#endif
#endif
  if constexpr (has_fused_multiply_add)
    return lanes<pack<T, N>>::generate([&](int i) { return fused_multiply_add(a[i], b[i], c[i]); });
  else
    return a * b + c;
#endif
}

}  // namespace irg::inline IRG_ABI
