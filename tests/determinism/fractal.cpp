// SPDX-License-Identifier: MIT
// Escape counts.
#include <irg/fractal/distance_estimate.hpp>
#include <irg/fractal/escape_picture.hpp>
#include <irg/fractal/precise_mandelbrot.hpp>
#include <irg/raster/image.hpp>

#include "hashes.hpp"
#include "support/random.hpp"

namespace {

template <class T>
constexpr std::uint64_t count_escapes(int rounds) {
  test::random r(17);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const T x = static_cast<T>(1.8 * r.unit() - 1.5), y = static_cast<T>(2 * r.unit() - 1);
    const T reach = static_cast<T>(i % 2 == 0 ? 0.5 : 0x1p-12);
    irg::image<int> counts(23, 3), julia(23, 3);
    const irg::escape_job<T> job{{{x - reach, x + reach, y - reach, y + reach}, 23, 3},
                                 irg::make_escape_limit(T(i % 3 == 0 ? 100 : 2), 40 + i),
                                 {}};
    irg::draw_mandelbrot(counts, job);
    irg::draw_julia(julia, job, {y, x / T(4)});
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 23; ++column) {
        h.add(static_cast<std::uint64_t>(counts(column, row)));
        h.add(static_cast<std::uint64_t>(julia(column, row)));
      }
  }
  return h.value();
}

constexpr std::uint64_t fractal_escape_counts(int rounds) { return count_escapes<double>(rounds); }
constexpr std::uint64_t fractal_escape_counts_float(int rounds) { return count_escapes<float>(rounds); }
HASHED(fractal_escape_counts, 1, 400);
HASHED(fractal_escape_counts_float, 1, 400);

// Sure counts, and bounds of distances.
constexpr std::uint64_t fractal_sure_counts(int rounds) {
  test::random r(18);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const double x = irg::product(1.8, r.unit()) - 1.5, y = 2 * r.unit() - 1;
    const irg::sure_count k = irg::sure_mandelbrot_count(
        irg::point<irg::double_double, 2>{irg::double_double(x, x * 0x1p-60), y}, irg::make_escape_limit(2.0, 90));
    h.add(static_cast<std::uint64_t>(k.count + (k.is_sure ? 1000 : 0)));
    const auto d = irg::mandelbrot_distance(irg::point<double, 2>{x, y}, irg::make_escape_limit(1000.0, 90));
    h.add(d.at_least);
    h.add(d.at_most);
  }
  return h.value();
}
HASHED(fractal_sure_counts, 3, 600);

}  // namespace
