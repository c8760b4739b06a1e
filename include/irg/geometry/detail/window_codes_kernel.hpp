// SPDX-License-Identifier: MIT
// The codes of points against a window: one bit for each boundary that a point is beyond.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/clipped_line.hpp>

namespace irg::detail {

// Bits of a code, by axis: below the window in bits 0 and 1, above it in bits 2 and 3.
template <int Axis>
inline constexpr unsigned axis_bits = 5u << Axis;
template <int Axis>
inline constexpr unsigned below_bit = 1u << Axis;

inline namespace IRG_ABI {

// A NaN is beyond both boundaries of its axis.
template <class V, class T>
IRG_INLINE constexpr unsigned window_code(const V& v, const box<T, 2>& w) noexcept {
  unsigned code = 0;
  for (int i = 0; i < 2; ++i) {
    const T x = coordinate(position_of(v), i);
    bool below = x < w.low[i], above = w.high[i] < x;
    if constexpr (Floating<T>) below = !(w.low[i] <= x), above = !(x <= w.high[i]);
    code |= (static_cast<unsigned>(below) | static_cast<unsigned>(above) << 2) << i;
  }
  return code;
}

struct window_codes {
  unsigned any = 0, all = 15;
  bool finite = true;
};

// Codes of n points, what any and what all of them have set, and whether all coordinates are finite.
template <Point P, class T>
IRG_INLINE constexpr window_codes find_window_codes(const P* points, std::size_t n, const box<T, 2>& w,
                                                    std::uint8_t* codes) noexcept {
  window_codes found;
  const auto note = [&](std::size_t i, unsigned code) {
    codes[i] = static_cast<std::uint8_t>(code);
    found.any |= code, found.all &= code;
  };
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  if constexpr (std::is_same_v<P, point<double, 2>>)
    if (!std::is_constant_evaluated()) {
      typedef double two __attribute__((vector_size(16)));
      two nothing{};  // stays zero while all coordinates are finite
      const two low{w.low.x, w.low.y}, high{w.high.x, w.high.y};
      for (std::size_t i = 0; i < n; ++i) {
        two p;
        std::memcpy(&p, points + i, sizeof p);
        const auto within_low = reinterpret_cast<two>(low <= p), within_high = reinterpret_cast<two>(p <= high);
        nothing += p - p;
        note(i, static_cast<unsigned>(__builtin_ia32_movmskpd(within_low) | __builtin_ia32_movmskpd(within_high) << 2) ^
                    15u);
      }
      found.finite = nothing[0] == 0 && nothing[1] == 0;
      return found;
    }
#endif
  for (std::size_t i = 0; i < n; ++i) {
    note(i, window_code(points[i], w));
    found.finite = found.finite && has_finite_coordinates(points[i]);
  }
  return found;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
