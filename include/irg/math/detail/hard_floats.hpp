// SPDX-License-Identifier: MIT
// Floats whose result lies so close to the middle of two floats that the kernels in double do not tell on which side.
// These are all there are: every float has been tried (docs/math/elementary.md names the run).
#pragma once

#include <array>

#include <irg/math/detail/unrounded.hpp>

namespace irg::detail {

struct hard_float {
  float argument, result;
};

// What -x gives when x gives y: nothing in common, y, or -y. Of the latter two the tables have positive arguments only.
enum class symmetry { none, even, odd };

inline constexpr std::array<hard_float, 1> hard_sines{{{0x1.33333p+13f, -0x1.63f4bap-2f}}};
inline constexpr std::array<hard_float, 3> hard_cosines{
    {{0x1.4555p+51f, 0x1.115d7ep-1f}, {0x1.3170fp+63f, 0x1.fe2976p-1f}, {0x1.2b9622p+67f, 0x1.f0285ep-1f}}};
inline constexpr std::array<hard_float, 1> hard_arctangents{{{0x1.1ad646p-4f, 0x1.1a6386p-4f}}};
inline constexpr std::array<hard_float, 2> hard_arccosines{
    {{0x1.110b46p-26f, 0x1.921fb6p+0f}, {0x1.04c444p-12f, 0x1.920f6ap+0f}}};
inline constexpr std::array<hard_float, 2> hard_powers_of_two{
    {{0x1.853a6ep-9f, 0x1.00870ap+0f}, {-0x1.e7526ep-6f, 0x1.f58d62p-1f}}};

inline namespace IRG_ABI {

// The float nearest to a function's result at x, which `result` is but for the hard floats; doubles as they are.
template <symmetry S, Floating T, std::size_t N>
IRG_INLINE constexpr T nearest_result(T x, double result, const std::array<hard_float, N>& hard) noexcept {
  if constexpr (std::is_same_v<T, float>)
    for (const hard_float& h : hard)
      if ((S == symmetry::none ? x : magnitude(x)) == h.argument)
        return S == symmetry::odd && is_negative(x) ? -h.result : h.result;
  return narrowed<T>(result);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
