// SPDX-License-Identifier: MIT
// The counts of one row of pixels.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/fractal/detail/escape_disc.hpp>
#include <irg/fractal/detail/escape_kernel.hpp>
#include <irg/fractal/escape_job.hpp>
#include <irg/fractal/julia.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// What differs between the two pictures of z^2 + c: which of z and c is the pixel.
template <class T>
struct mandelbrot_orbits {
  static constexpr bool has_interior = true;
  // After the first step an orbit is at c: who is inside has a c inside.
  IRG_INLINE static constexpr bool stays_out(const escape_limit<T>& limit) noexcept { return T(4) <= limit.square; }
  IRG_INLINE constexpr int operator()(const point<T, 2>& at, const escape_limit<T>& limit) const noexcept {
    return mandelbrot_count(at, limit);
  }
  constexpr int common(const escape_disc<T>& pixels, const escape_limit<T>& limit) const noexcept {
    return common_count(escape_disc<T>{}, pixels, limit);
  }
  template <class F>
  IRG_INLINE void begin(const F& real, const F& imaginary, F& x, F& y, F& cx, F& cy) const noexcept {
    x = y = lanes<F>::broadcast(T(0));
    cx = real;
    cy = imaginary;
  }
};
template <class T>
struct julia_orbits {
  static constexpr bool has_interior = false;
  point<T, 2> c;
  IRG_INLINE constexpr bool stays_out(const escape_limit<T>& limit) const noexcept {
    return T(4) <= limit.square && squared_size(c.x, c.y) < limit.square;
  }
  IRG_INLINE constexpr int operator()(const point<T, 2>& at, const escape_limit<T>& limit) const noexcept {
    return julia_count(at, c, limit);
  }
  constexpr int common(const escape_disc<T>& pixels, const escape_limit<T>& limit) const noexcept {
    return common_count(pixels, escape_disc<T>{c, T(0)}, limit);
  }
  template <class F>
  IRG_INLINE void begin(const F& real, const F& imaginary, F& x, F& y, F& cx, F& cy) const noexcept {
    x = real;
    y = imaginary;
    cx = lanes<F>::broadcast(c.x);
    cy = lanes<F>::broadcast(c.y);
  }
};

// Whether points of the cardioid and the disc need no orbit: theirs stay in |z| <= 2, but may leave a smaller disc.
template <class Orbits, class T>
constexpr bool skips_interior(const escape_job<T>& job) noexcept {
  return Orbits::has_interior && job.skip.interior == skipping::on && T(4) <= job.limit.square;
}

// One row, pixel by pixel, for constant evaluation.
template <class T, class Orbits, class P>
constexpr escape_stats escape_row_plainly(P* row, int y, const escape_job<T>& job, const Orbits& orbits) {
  escape_stats stats{job.plane.width, 0, 0};
  const bool skips = skips_interior<Orbits>(job);
  for (int x = 0; x < job.plane.width; ++x) {
    const point<T, 2> at = job.plane.at(x, y);
    const bool known = skips && mandelbrot_part_of(at) != mandelbrot_part::elsewhere;
    stats.interior += known;
    row[x] = static_cast<P>(known ? job.limit.most : orbits(at, job.limit));
  }
  return stats;
}

// Orbits that outlast their neighbours, side by side with others of their kind.
template <class T, class P, unsigned Capacity>
struct escape_queue {
  unsigned count = 0;
  T x[Capacity]{}, y[Capacity]{}, cx[Capacity]{}, cy[Capacity]{};
  P* pixel[Capacity];
};

// Some rows in lanes. All orbits begin together; the few that are still inside when most have left go on in a queue.
template <class T, class Orbits, class P>
class escape_rows {
  using F = pack<T, widest_lanes<T>>;
  using f = lanes<F>;
  static constexpr unsigned packs = sizeof(F) == 64 ? 4 : 2;
  using kernel = escape_kernel<F, packs>;
  using mask = typename kernel::mask;
  static constexpr int square_side = 16;  // a multiple of the lanes of a pack
  static constexpr int short_steps = 16;  // a multiple of the kernel's block, like the places where cycles are sought

public:
  IRG_INLINE escape_rows(const escape_job<T>& job, const Orbits& orbits) noexcept
      : job_(job), orbits_(orbits), skips_(skips_interior<Orbits>(job)), stays_out_(orbits.stays_out(job.limit)) {}

  // One row but for the squares whose count is known: it is 0 or more in known[x / square_side].
  IRG_NOINLINE void row(P* row, int y, const int* known) noexcept {
    const F margin = f::broadcast(T(0) - static_cast<T>(interior_margin)),
            imaginary = f::broadcast(job_.plane.imaginary(static_cast<T>(y)));
    const T height = job_.plane.imaginary(static_cast<T>(y));
    const bool low = skips_ && height > T(-0.65f) && height < T(0.65f);  // as the cardioid is
    stats_.pixels += job_.plane.width;
    for (std::int64_t x = 0; x < job_.plane.width; x += kernel::count) {
      if (all_known(known, x)) continue;
      kernel k;
      const int here = static_cast<int>(lesser<std::int64_t>(kernel::count, job_.plane.width - x));
      const bool looks_inside =
          low && meets_interior(job_.plane.real(static_cast<T>(x)), job_.plane.real(static_cast<T>(x + here - 1)));
      for (unsigned p = 0; p < packs; ++p) {
        using number = typename lanes<mask>::scalar;
        const std::int64_t first = x + static_cast<int>(p) * f::count;
        const bool is_known = first < job_.plane.width && known[first / square_side] >= 0;
        const int to_do = is_known ? 0 : here - static_cast<int>(p) * f::count;
        const mask in_row = lanes<mask>::ramp() < lanes<mask>::broadcast(static_cast<number>(to_do));
        const F real = job_.plane.real(f::ramp() + f::broadcast(static_cast<T>(first)));
        orbits_.begin(real, imaginary, k.x[p], k.y[p], k.cx[p], k.cy[p]);
        k.inside[p] = in_row;  // those past its end have left before they begin
        k.counts[p] = lanes<mask>::broadcast(0);
        if (!looks_inside) continue;
        const mask inner =
            in_row & ((outside_cardioid(real, imaginary) < margin) | (outside_disc(real, imaginary) < margin));
        stats_.interior += std::popcount(mask_bits(inner));
        k.inside[p] = in_row & ~inner;
        k.counts[p] = select(inner, lanes<mask>::broadcast(job_.limit.most), k.counts[p]);
      }
      k.begin();
      k.run_short(job_.limit, lesser(short_steps, job_.limit.most));
      const bool later = !goes_on(k);
      store(k, row + x, here);
      if (later) keep_for_later(k, row + x);
    }
  }

  // Draws the rows from y to before `end`.
  template <class RowAt>
  IRG_NOINLINE void band(const RowAt& row_at, int y, int end) {
    const int width = job_.plane.width;
    std::vector<int> known(static_cast<std::size_t>((width + square_side - 1) / square_side), -1);
    for (int top = y; top < end; top += square_side) {
      const int bottom = lesser(top + square_side, end);
      if (job_.skip.squares == skipping::on) find_squares(known.data(), top, bottom);
      for (int at = top; at < bottom; ++at) {
        P* const pixels = row_at(at);
        row(pixels, at, known.data());
        for (std::size_t k = 0; k < known.size(); ++k) {
          if (known[k] < 0) continue;
          const int first = static_cast<int>(k) * square_side, last = lesser(first + square_side, width);
          for (int x = first; x < last; ++x) pixels[x] = static_cast<P>(known[k]);
          stats_.squares += last - first;
        }
      }
    }
  }

  IRG_NOINLINE escape_stats finish() noexcept {
    if (queue_.count > 0) run_queue();
    return stats_;
  }

private:
  // The counts of the squares between two rows, each of which one orbit of discs may tell.
  IRG_NOINLINE void find_squares(int* known, int top, int bottom) const noexcept {
    for (int x = 0; x < job_.plane.width; x += square_side) {
      const int last = lesser(x + square_side, job_.plane.width) - 1;
      *known++ = orbits_.common(disc_about(job_.plane.at(x, top), job_.plane.at(last, bottom - 1)), job_.limit);
    }
  }
  IRG_INLINE bool all_known(const int* known, std::int64_t x) const noexcept {
    for (std::int64_t at = x; at < x + kernel::count && at < job_.plane.width; at += square_side)
      if (known[at / square_side] < 0) return false;
    return true;
  }
  // Whether the cardioid and the disc reach between two real parts.
  IRG_INLINE static bool meets_interior(T a, T b) noexcept {
    return lesser(a, b) < T(0.376f) && greater(a, b) > T(-1.251f);
  }
  IRG_INLINE static void store(const kernel& k, P* to, int here) noexcept {
    using counted = pack<P, f::count>;
    for (unsigned p = 0; p < packs; ++p) {
      const int first = static_cast<int>(p) * f::count;
      const auto some = converted<P>(k.counts[p]);
      if (here - first >= f::count)
        lanes<counted>::store(to + first, some);
      else
        for (int i = 0; i < here - first; ++i) to[first + i] = some[i];
    }
  }
  IRG_INLINE int run(kernel& k) noexcept {
    return k.run(job_.limit, short_steps, stays_out_, job_.skip.cycles == skipping::on);
  }

  // Goes on with a group of which nearly all is inside.
  IRG_INLINE bool goes_on(kernel& k) noexcept {
    if (job_.limit.most <= short_steps) return true;
    int left = 0;
    for (unsigned p = 0; p < packs; ++p) left += std::popcount(mask_bits(k.inside[p]));
    if (left >= kernel::count * 3 / 4) stats_.cycles += run(k);
    return left == 0 || left >= kernel::count * 3 / 4;
  }

  IRG_INLINE void keep_for_later(const kernel& k, P* pixels) noexcept {
    constexpr auto n = static_cast<unsigned>(f::count);
    for (unsigned p = 0; p < packs; ++p) {
      auto bits = mask_bits(k.inside[p]);
      if (bits == 0) continue;
      T x[n], y[n], cx[n], cy[n];
      f::store(x, k.x[p]), f::store(y, k.y[p]), f::store(cx, k.cx[p]), f::store(cy, k.cy[p]);
      for (; bits != 0; bits &= bits - 1) {
        const auto i = static_cast<unsigned>(std::countr_zero(bits));
        const unsigned to = queue_.count++;
        queue_.x[to] = x[i], queue_.y[to] = y[i], queue_.cx[to] = cx[i], queue_.cy[to] = cy[i];
        queue_.pixel[to] = pixels + p * n + i;
      }
    }
    if (queue_.count >= static_cast<unsigned>(kernel::count)) run_queue();
  }

  // The last orbits of the queue, as many as run side by side.
  IRG_NOINLINE void run_queue() noexcept {
    const unsigned here = lesser(queue_.count, static_cast<unsigned>(kernel::count)), first = queue_.count - here;
    kernel k;
    for (unsigned p = 0; p < packs; ++p) {
      const auto at = [&](const T* all) { return f::load(all + first + p * static_cast<unsigned>(f::count)); };
      k.x[p] = at(queue_.x), k.y[p] = at(queue_.y), k.cx[p] = at(queue_.cx), k.cy[p] = at(queue_.cy);
      using number = typename lanes<mask>::scalar;
      k.inside[p] = lanes<mask>::ramp() <  // what is beyond has left before it begins
                    lanes<mask>::broadcast(static_cast<number>(static_cast<int>(here - p * f::count)));
      k.counts[p] = lanes<mask>::broadcast(short_steps);
    }
    k.begin();
    stats_.cycles += run(k);
    for (unsigned n = 0; n < here; ++n)
      *queue_.pixel[first + n] = static_cast<P>(lane(k.counts[n / f::count], static_cast<int>(n % f::count)));
    queue_.count = first;
  }

  const escape_job<T>& job_;
  const Orbits& orbits_;
  bool skips_, stays_out_;
  escape_stats stats_{};
  escape_queue<T, P, 2 * static_cast<unsigned>(kernel::count)> queue_{};
};

template <class P, class RowAt, class T, class Orbits>
escape_stats escape_band_in_lanes(const RowAt& row_at, int first, int last, const escape_job<T>& job,
                                  const Orbits& orbits) {
  escape_rows<T, Orbits, P> rows(job, orbits);
  rows.band(row_at, first, last);
  return rows.finish();
}

// The rows from `first` to before `last` of a picture of pixels P.
template <class P, class RowAt, class T, class Orbits>
constexpr escape_stats escape_band(const RowAt& row_at, int first, int last, const escape_job<T>& job,
                                   const Orbits& orbits) {
  if (!std::is_constant_evaluated()) return escape_band_in_lanes<P>(row_at, first, last, job, orbits);
  escape_stats stats;
  for (int y = first; y < last; ++y) stats += escape_row_plainly(row_at(y), y, job, orbits);
  return stats;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
