// SPDX-License-Identifier: MIT
// Escape counts of the Mandelbrot set, 1920x1080, 256 steps: by irg with and without what it skips, and by the plain
// loop with its root. Wrong are counts that are not the plain loop's.
#include <cmath>
#include <vector>

#include <irg/fractal/escape_picture.hpp>
#include <irg/raster/image.hpp>

#include "support/measure.hpp"

namespace {

using namespace bench;

template <class T>
int plain_count(T cx, T cy, T radius, int most) {
  T x = 0, y = 0;
  int k = -1;
  do {
    ++k;
    const T next = irg::product(x, x) - irg::product(y, y) + cx;
    y = irg::product(2 * x, y) + cy;
    x = next;
  } while (std::sqrt(irg::product(x, x) + irg::product(y, y)) < radius && k < most);
  return k;
}

template <class T>
void enter_case(const std::string& name, const irg::view_window<T>& window, int most) {
  const int width = smoke() ? 96 : 1920, height = smoke() ? 54 : 1080;
  const irg::escape_job<T> job{{window, width, height}, irg::make_escape_limit(T(2), most), {}};
  auto& counts = keep(irg::image<int>(width, height));
  auto& truth = keep_lazy([job] {
    auto all = std::make_unique<irg::image<int>>(job.plane.width, job.plane.height);
    for (int y = 0; y < all->height(); ++y)
      for (int x = 0; x < all->width(); ++x) {
        const auto c = job.plane.at(x, y);
        (*all)(x, y) = plain_count(c.x, c.y, T(2), job.limit.most);
      }
    return all;
  });
  const contest what{"escape", name + build_suffix(), "picture", 1, "", ""};
  const auto add = [&](const std::string& who, auto draw) {
    contender c{who, [&counts, draw] { draw(counts); }};
    c.judge = [&counts, &truth] {
      errors e;
      e.wrong = 0;
      for (int y = 0; y < counts.height(); ++y)
        for (int x = 0; x < counts.width(); ++x) e.wrong += counts(x, y) != (**truth)(x, y);
      if (e.wrong != 0) e.broken = "a count is not the plain loop's";
      return e;
    };
    enter(what, std::move(c));
  };
  add("irg", [job](irg::image<int>& to) { irg::draw_mandelbrot(to, job); });
  add("irg:no skips", [job](irg::image<int>& to) {
    irg::escape_job<T> all = job;
    all.skip = {irg::skipping::off, irg::skipping::off, irg::skipping::off};
    irg::draw_mandelbrot(to, all);
  });
  add("plain loop", [job](irg::image<int>& to) {
    for (int y = 0; y < to.height(); ++y)
      for (int x = 0; x < to.width(); ++x) {
        const auto c = job.plane.at(x, y);
        to(x, y) = plain_count(c.x, c.y, T(2), job.limit.most);
      }
  });
}

}  // namespace

int main(int argc, char** argv) {
  enter_case<double>("whole set 256", {-2, 1, -1.2, 1.2}, 256);
  enter_case<float>("whole set 256 float", {-2, 1, -1.2f, 1.2f}, 256);
  enter_case<double>("seahorse valley 2000", {-0.76, -0.73, 0.1, 0.117}, 2000);
  return run_benchmarks(argc, argv);
}
