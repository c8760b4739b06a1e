// SPDX-License-Identifier: MIT
// Escape counts of many orbits of z^2 + c at once.
#pragma once

#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/fractal/mandelbrot.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// P packs of orbits side by side: one alone would wait for its own results.
template <class F, unsigned P>
struct escape_kernel {
  using f = lanes<F>;
  using T = typename f::scalar;
  using mask = typename f::mask;
  static constexpr int count = f::count * static_cast<int>(P);
  static constexpr int unrolled = 4;  // steps between two looks whether anybody is left

  F cx[P], cy[P], x[P], y[P], xx[P], yy[P];
  mask inside[P], counts[P];  // inside: all bits set while the orbit is in the disc

  IRG_INLINE void step(const F& square) noexcept {
    for (unsigned p = 0; p < P; ++p) {
      y[p] = (x[p] + x[p]) * y[p] + cy[p];
      x[p] = xx[p] - yy[p] + cx[p];
      xx[p] = x[p] * x[p];
      yy[p] = y[p] * y[p];
      inside[p] = both(inside[p], xx[p] + yy[p] < square);
      counts[p] = counts[p] - inside[p];
    }
  }
  IRG_INLINE bool nobody_is_left() const noexcept {
    mask any = inside[0];
    for (unsigned p = 1; p < P; ++p) any = any | inside[p];
    return no_lane(any);
  }

  // Orbits that are where they were before will stay for ever.
  // gives   how many were found
  IRG_INLINE int find_cycles(const F (&kept_x)[P], const F (&kept_y)[P], int most) noexcept {
    int found = 0;
    for (unsigned p = 0; p < P; ++p) {
      const mask again = both(inside[p], both(x[p] == kept_x[p], y[p] == kept_y[p]));
      if (no_lane(again)) continue;
      found += std::popcount(mask_bits(again));
      counts[p] = select(again, lanes<mask>::broadcast(most), counts[p]);
      inside[p] = both(inside[p], ~again);
    }
    return found;
  }

  // Counts the orbits that begin at x, y, as long as they are inside.
  // gives   how many were found to be cycles
  IRG_INLINE int run(const escape_limit<T>& limit, bool look_for_cycles) noexcept {
    const F square = f::broadcast(limit.square);
    for (unsigned p = 0; p < P; ++p) {
      xx[p] = x[p] * x[p];
      yy[p] = y[p] * y[p];
    }
    F kept_x[P], kept_y[P];
    int cycles = 0, n = 0;
    for (int next = 64; limit.most - n >= unrolled; n += unrolled) {
      if (nobody_is_left()) return cycles;
      for (int i = 0; i < unrolled; ++i) step(square);
      if (!look_for_cycles || n % 32 != 0 || n < 64) continue;
      if (n == next) {
        for (unsigned p = 0; p < P; ++p) kept_x[p] = x[p], kept_y[p] = y[p];
        next = next < limit.most / 2 ? 2 * next : limit.most;
      } else {
        cycles += find_cycles(kept_x, kept_y, limit.most);
      }
    }
    for (; n < limit.most; ++n) step(square);
    return cycles;
  }
};

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
