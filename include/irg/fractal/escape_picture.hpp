// SPDX-License-Identifier: MIT
// Escape counts of every pixel: of the Mandelbrot set, of a Julia set.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/core/instructions.hpp>
#include <irg/core/lanes.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/core/scalar.hpp>
#include <irg/fractal/complex_plane.hpp>
#include <irg/fractal/escape_time.hpp>
#include <irg/fractal/julia.hpp>
#include <irg/fractal/mandelbrot.hpp>
#include <irg/raster/draw_counts.hpp>

namespace irg {

// What a picture of escape counts is made of, what may be skipped, and what was.

/// What may be left out because its count is known. Counts do not change.
struct escape_options {
  skipping interior = skipping::on;  // points of the cardioid and the disc of period 2
  skipping cycles = skipping::on;    // orbits that come back to a point where they were before
  skipping squares = skipping::on;   // squares of pixels that one orbit of discs shows to have one count
  bool operator==(const escape_options&) const = default;
};

/// What was left out. Independent of the executor; cycles depend on the lanes that compute side by side.
struct escape_counts {
  std::int64_t pixels = 0;    // all
  std::int64_t interior = 0;  // without an orbit
  std::int64_t cycles = 0;    // whose orbit was cut short
  std::int64_t squares = 0;   // in squares of one count, without orbits of their own

  IRG_INLINE constexpr escape_counts& operator+=(const escape_counts& o) noexcept {
    pixels += o.pixels;
    interior += o.interior;
    cycles += o.cycles;
    squares += o.squares;
    return *this;
  }
  bool operator==(const escape_counts&) const = default;
};

/// The counts of a picture: how its orbits begin and end.
template <Floating T>
struct escape_job {
  complex_plane<T> plane{};
  escape_limit<T> limit{};
  escape_options skip{};
  bool operator==(const escape_job&) const = default;
};

}  // namespace irg

namespace irg {

/// A raster of counts.
template <class R>
concept CountRaster = RowRaster<R> && std::integral<pixel_of<R>> && (sizeof(pixel_of<R>) >= 2);

inline namespace IRG_ABI {

/// The counts of the Mandelbrot set in every pixel, and what was skipped.
/// shape   a raster of the plane's width and height, whose pixels hold numbers up to the limit's `most`
/// exact   those of mandelbrot_count of the pixel's number, with skips on and off, in lanes and one by one
/// cost    the orbits; allocates a few numbers per row
/// source  Mandelbrot 1980; Brent 1980 for cycles
template <CountRaster R, Floating T, Executor E = sequential>
constexpr escape_counts draw_mandelbrot(R& counts, const escape_job<T>& job, const E& executor = {});

/// The counts of the Julia set of z^2 + c in every pixel, and what was skipped.
/// shape   as draw_mandelbrot
/// exact   those of julia_count of the pixel's number, with skips on and off, in lanes and one by one
template <CountRaster R, Floating T, Executor E = sequential>
constexpr escape_counts draw_julia(R& counts, const escape_job<T>& job, const point<T, 2>& c, const E& executor = {});

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// All orbits of z^2 + c that begin in a disc, with c in another, at once: a disc that holds them after each step, what
// each of them rounds included. Where it stays within the limit, or leaves it as a whole, they have one count.

template <class T>
struct escape_disc {
  point<T, 2> middle{};
  T reach{};
};

// The disc about a box of numbers.
template <class T>
constexpr escape_disc<T> disc_about(const point<T, 2>& a, const point<T, 2>& b) noexcept {
  const point<T, 2> m{(a.x + b.x) / 2, (a.y + b.y) / 2};
  const T x = maximum(maximum(a.x, b.x) - m.x, m.x - minimum(a.x, b.x)),
          y = maximum(maximum(a.y, b.y) - m.y, m.y - minimum(a.y, b.y));
  const T ulps = 8 * std::numeric_limits<T>::epsilon();
  const T size = sqrt(squared_size(x, y));
  return {m, size + product(size, ulps) + product(maximum(magnitude(m.x), magnitude(m.y)), ulps)};
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
  const T away = maximum(magnitude(c.middle.x), magnitude(c.middle.y)) + c.reach;
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

// Escape counts of many orbits of z^2 + c at once.

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
    for (unsigned p = 0; p < P; ++p) {
      old_x[p] = x[p];
      old_y[p] = y[p];
    }
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
      x[p] = old_x[p];
      y[p] = old_y[p];
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
    for (unsigned p = 0; p < P; ++p) {
      kept_x[p] = x[p];
      kept_y[p] = y[p];
    }
    int cycles = 0;
    bool together = stays_out;
    for (int next = 64; limit.most - n >= block; n += block) {
      if (nobody_is_left()) return cycles;
      const bool done = together && step_together(safe);
      if (!done) together = step_apart(square) && stays_out;
      if (!look_for_cycles || n % 32 != 0 || n < 64) continue;
      if (n == next) {
        for (unsigned p = 0; p < P; ++p) {
          kept_x[p] = x[p];
          kept_y[p] = y[p];
        }
        next = next < limit.most / 2 ? 2 * next : limit.most;
      } else {
        cycles += find_cycles(kept_x, kept_y, limit.most);
      }
    }
    for (; n < limit.most; ++n) step(square);
    return cycles;
  }
};

// The counts of one row of pixels.

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
constexpr escape_counts escape_row_plainly(P* row, int y, const escape_job<T>& job, const Orbits& orbits) {
  escape_counts stats{job.plane.width, 0, 0};
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
      const int here = static_cast<int>(minimum<std::int64_t>(kernel::count, job_.plane.width - x));
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
      k.run_short(job_.limit, minimum(short_steps, job_.limit.most));
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
      const int bottom = minimum(top + square_side, end);
      if (job_.skip.squares == skipping::on) find_squares(known.data(), top, bottom);
      for (int at = top; at < bottom; ++at) {
        P* const pixels = row_at(at);
        row(pixels, at, known.data());
        for (std::size_t k = 0; k < known.size(); ++k) {
          if (known[k] < 0) continue;
          const int first = static_cast<int>(k) * square_side, last = minimum(first + square_side, width);
          for (int x = first; x < last; ++x) pixels[x] = static_cast<P>(known[k]);
          stats_.squares += last - first;
        }
      }
    }
  }

  IRG_NOINLINE escape_counts finish() noexcept {
    if (queue_.count > 0) run_queue();
    return stats_;
  }

private:
  // The counts of the squares between two rows, each of which one orbit of discs may tell.
  IRG_NOINLINE void find_squares(int* known, int top, int bottom) const noexcept {
    for (int x = 0; x < job_.plane.width; x += square_side) {
      const int last = minimum(x + square_side, job_.plane.width) - 1;
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
    return minimum(a, b) < T(0.376f) && maximum(a, b) > T(-1.251f);
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
      f::store(x, k.x[p]);
      f::store(y, k.y[p]);
      f::store(cx, k.cx[p]);
      f::store(cy, k.cy[p]);
      for (; bits != 0; bits &= bits - 1) {
        const auto i = static_cast<unsigned>(std::countr_zero(bits));
        const unsigned to = queue_.count++;
        queue_.x[to] = x[i];
        queue_.y[to] = y[i];
        queue_.cx[to] = cx[i];
        queue_.cy[to] = cy[i];
        queue_.pixel[to] = pixels + p * n + i;
      }
    }
    if (queue_.count >= static_cast<unsigned>(kernel::count)) run_queue();
  }

  // The last orbits of the queue, as many as run side by side.
  IRG_NOINLINE void run_queue() noexcept {
    const unsigned here = minimum(queue_.count, static_cast<unsigned>(kernel::count)), first = queue_.count - here;
    kernel k;
    for (unsigned p = 0; p < packs; ++p) {
      const auto at = [&](const T* all) { return f::load(all + first + p * static_cast<unsigned>(f::count)); };
      k.x[p] = at(queue_.x);
      k.y[p] = at(queue_.y);
      k.cx[p] = at(queue_.cx);
      k.cy[p] = at(queue_.cy);
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
  escape_counts stats_{};
  escape_queue<T, P, 2 * static_cast<unsigned>(kernel::count)> queue_{};
};

template <class P, class RowAt, class T, class Orbits>
escape_counts escape_band_in_lanes(const RowAt& row_at, int first, int last, const escape_job<T>& job,
                                   const Orbits& orbits) {
  escape_rows<T, Orbits, P> rows(job, orbits);
  rows.band(row_at, first, last);
  return rows.finish();
}

// The rows from `first` to before `last` of a picture of pixels P.
template <class P, class RowAt, class T, class Orbits>
constexpr escape_counts escape_band(const RowAt& row_at, int first, int last, const escape_job<T>& job,
                                    const Orbits& orbits) {
  if (!std::is_constant_evaluated()) return escape_band_in_lanes<P>(row_at, first, last, job, orbits);
  escape_counts stats;
  for (int y = first; y < last; ++y) stats += escape_row_plainly(row_at(y), y, job, orbits);
  return stats;
}

template <class R, class T, class Orbits, class E>
constexpr escape_counts draw_counts_of(R& counts, const escape_job<T>& job, const Orbits& orbits, const E& executor) {
  IRG_EXPECTS(width_of(counts) == job.plane.width && height_of(counts) == job.plane.height);
  constexpr int band = 16;  // rows of a task
  const int height = height_of(counts);
  std::vector<escape_counts> of_band(static_cast<std::size_t>((height + band - 1) / band), escape_counts{});
  executor(of_band.size(), [&](std::size_t i) {
    const int first = static_cast<int>(i) * band, last = minimum(first + band, height);
    const auto row_at = [&](int y) { return raster_traits<R>::row(counts, y); };
    of_band[i] = escape_band<pixel_of<R>>(row_at, first, last, job, orbits);
  });
  escape_counts stats;
  for (const escape_counts& s : of_band) stats += s;
  return stats;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <CountRaster R, Floating T, Executor E>
constexpr escape_counts draw_mandelbrot(R& counts, const escape_job<T>& job, const E& executor) {
  return detail::draw_counts_of(counts, job, detail::mandelbrot_orbits<T>{}, executor);
}

template <CountRaster R, Floating T, Executor E>
constexpr escape_counts draw_julia(R& counts, const escape_job<T>& job, const point<T, 2>& c, const E& executor) {
  return detail::draw_counts_of(counts, job, detail::julia_orbits<T>{c}, executor);
}

}  // namespace IRG_ABI
}  // namespace irg
