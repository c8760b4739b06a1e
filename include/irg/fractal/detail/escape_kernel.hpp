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
  static constexpr int block = 8;  // steps between two looks whether anybody is left

  F cx[P], cy[P], x[P], y[P], xx[P], yy[P];
  mask inside[P], counts[P];  // inside: all bits set while the orbit is in the disc

  // The share of a disc's squared radius of 4 or more within which an orbit is not at the end of a block that was
  // outside of the disc on the way, |c| not beyond the radius: |z^2 + c| >= |z| (|z| - 1) >= |z| there, and near 2 a
  // step makes four times as much of what was rounded before.
  static constexpr T safe_share = T(1) - (sizeof(T) == 4 ? T(0x1p-5f) : T(0x1p-30));

  IRG_INLINE void advance(unsigned p) noexcept {
    y[p] = (x[p] + x[p]) * y[p] + cy[p];
    x[p] = xx[p] - yy[p] + cx[p];
    xx[p] = x[p] * x[p];
    yy[p] = y[p] * y[p];
  }
  IRG_INLINE void step(const F& square) noexcept {
    for (unsigned p = 0; p < P; ++p) {
      advance(p);
      inside[p] = both(inside[p], xx[p] + yy[p] < square);
      counts[p] = counts[p] - inside[p];
    }
  }
  // A block of steps without a look at who leaves: nothing where somebody may have.
  IRG_INLINE bool step_together(const F& safe) noexcept {
    F old_x[P], old_y[P];
    for (unsigned p = 0; p < P; ++p) old_x[p] = x[p], old_y[p] = y[p];
    for (int i = 0; i < block; ++i)
      for (unsigned p = 0; p < P; ++p) advance(p);
    mask left = both(inside[0], ~(xx[0] + yy[0] < safe));
    for (unsigned p = 1; p < P; ++p) left = left | both(inside[p], ~(xx[p] + yy[p] < safe));
    if (no_lane(left)) {
      const mask steps = lanes<mask>::broadcast(block);
      for (unsigned p = 0; p < P; ++p) counts[p] = counts[p] + both(inside[p], steps);
      return true;
    }
    for (unsigned p = 0; p < P; ++p) {
      x[p] = old_x[p], y[p] = old_y[p];
      xx[p] = x[p] * x[p];
      yy[p] = y[p] * y[p];
    }
    return false;
  }
  // A block of steps that looks after each.
  // gives   whether nobody left
  IRG_INLINE bool step_apart(const F& square) noexcept {
    mask before[P], left = lanes<mask>::broadcast(0);
    for (unsigned p = 0; p < P; ++p) before[p] = inside[p];
    for (int i = 0; i < block; ++i) step(square);
    for (unsigned p = 0; p < P; ++p) left = left | both(before[p], ~inside[p]);
    return no_lane(left);
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

  // Readies the squares of orbits that are at x, y.
  IRG_INLINE void begin() noexcept {
    for (unsigned p = 0; p < P; ++p) {
      xx[p] = x[p] * x[p];
      yy[p] = y[p] * y[p];
    }
  }

  // Counts `steps` steps of the orbits that are inside.
  IRG_INLINE void run_short(const escape_limit<T>& limit, int steps) noexcept {
    const F square = f::broadcast(limit.square);
    for (int n = 0; n < steps; ++n) {
      if (n % 4 == 0 && nobody_is_left()) return;
      step(square);
    }
  }

  // Counts the orbits that are at x, y after n steps, as long as they are inside, to the limit's end.
  // needs   |c| within the disc's radius for those inside, where `stays_out` says that who leaves does not come back
  // gives   how many were found to be cycles
  IRG_INLINE int run(const escape_limit<T>& limit, int n, bool stays_out, bool look_for_cycles) noexcept {
    const F square = f::broadcast(limit.square), safe = f::broadcast(limit.square * safe_share);
    F kept_x[P], kept_y[P];
    for (unsigned p = 0; p < P; ++p) kept_x[p] = x[p], kept_y[p] = y[p];
    int cycles = 0;
    bool together = stays_out;
    for (int next = 64; limit.most - n >= block; n += block) {
      if (nobody_is_left()) return cycles;
      const bool done = together && step_together(safe);
      if (!done) together = step_apart(square) && stays_out;
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
