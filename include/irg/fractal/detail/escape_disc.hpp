// SPDX-License-Identifier: MIT
// All orbits of z^2 + c that begin in a disc, with c in another, at once: a disc that holds them after each step, what
// each of them rounds included. Where it stays within the limit, or leaves it as a whole, they have one count.
#pragma once

#include <limits>

#include <irg/core/instructions.hpp>
#include <irg/core/scalar.hpp>
#include <irg/fractal/mandelbrot.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

template <class T>
struct escape_disc {
  point<T, 2> middle{};
  T reach{};
};

// The disc about a box of numbers.
template <class T>
constexpr escape_disc<T> disc_about(const point<T, 2>& a, const point<T, 2>& b) noexcept {
  const point<T, 2> m{(a.x + b.x) / 2, (a.y + b.y) / 2};
  const T x = greater(greater(a.x, b.x) - m.x, m.x - lesser(a.x, b.x)),
          y = greater(greater(a.y, b.y) - m.y, m.y - lesser(a.y, b.y));
  const T ulps = 8 * std::numeric_limits<T>::epsilon();
  const T size = sqrt(squared_size(x, y));
  return {m, size + product(size, ulps) + product(greater(magnitude(m.x), magnitude(m.y)), ulps)};
}

// The count that all orbits of z in one disc with c in another have, or -1 where they may differ.
// gives   -1 for limits beyond a radius of 2^10, whose rounding is large; `most` at once where the disc has come back
//         into itself
template <class T>
constexpr int common_count(escape_disc<T> z, const escape_disc<T>& c, const escape_limit<T>& limit) noexcept {
  constexpr T u = std::numeric_limits<T>::epsilon(), over = 1 + 64 * u;
  if (!(limit.square > 0 && limit.square <= T(0x1p20f))) return -1;
  const T radius = sqrt(limit.square), inner = radius - product(radius, 16 * u),
          outer = radius + product(radius, 16 * u);
  const T away = greater(magnitude(c.middle.x), magnitude(c.middle.y)) + c.reach;
  if (!(away <= T(0x1p20f))) return -1;
  // What a step rounds, the middle's and each orbit's.
  const T rounded = product(64 * u, limit.square + radius + away);
  const square_plus<T> f{c.middle};
  T size = product(sqrt(squared_size(z.middle.x, z.middle.y)), over);
  escape_disc<T> kept = z;
  for (int k = 0, next = 8; k < limit.most; ++k) {
    z.reach = product(product(2 * size + z.reach, z.reach) + c.reach, over) + rounded;
    z.middle = f(z.middle);
    size = product(sqrt(squared_size(z.middle.x, z.middle.y)), over);
    if (!(product(size + z.reach, over) < inner)) return size - product(size, 64 * u) - z.reach > outer ? k : -1;
    const T apart = sqrt(squared_size(z.middle.x - kept.middle.x, z.middle.y - kept.middle.y));
    if (product(apart + z.reach, over) < kept.reach) return limit.most;
    if (z.reach > radius) return -1;
    if (k == next) {
      z.reach += z.reach;  // else discs that grow towards what they will be never lie within an earlier one
      kept = z;
      next = next < limit.most / 2 ? 2 * next : limit.most;
    }
  }
  return limit.most;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
