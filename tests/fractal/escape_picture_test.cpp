// SPDX-License-Identifier: MIT
#include <irg/fractal/escape_picture.hpp>

#include <cmath>
#include <cstdint>

#include <irg/core/threads.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::draw_julia;
using irg::draw_mandelbrot;
using irg::make_escape_limit;
using irg::skipping;

namespace {

using counts = irg::image<int>;
using job = irg::escape_job<double>;
constexpr irg::point<double, 2> course_c{0.32, 0.043};

constexpr int mandelbrot_table[9][9] = {
    {4, 4, 4, 5, 5, 8, 16, 5, 4},       {4, 5, 5, 6, 8, 16, 16, 7, 5},       {5, 6, 7, 8, 16, 16, 16, 16, 6},
    {7, 11, 16, 15, 16, 16, 16, 16, 7}, {16, 16, 16, 16, 16, 16, 16, 16, 6}, {7, 11, 16, 15, 16, 16, 16, 16, 7},
    {5, 6, 7, 8, 16, 16, 16, 16, 6},    {4, 5, 5, 6, 8, 16, 16, 7, 5},       {4, 4, 4, 5, 5, 8, 16, 5, 4}};
constexpr int julia_table[9][9] = {  // from the lowest row up
    {3, 3, 4, 5, 5, 5, 4, 3, 3},        {3, 5, 16, 16, 10, 16, 16, 5, 4}, {4, 16, 16, 16, 16, 16, 16, 15, 4},
    {4, 8, 16, 16, 16, 15, 12, 16, 4},  {4, 6, 10, 16, 16, 16, 10, 6, 4}, {4, 16, 12, 15, 16, 16, 16, 8, 4},
    {4, 15, 16, 16, 16, 16, 16, 16, 4}, {4, 5, 16, 16, 10, 16, 16, 5, 3}, {3, 3, 4, 5, 5, 5, 4, 3, 3}};

constexpr job course_job(irg::view_window<double> window, int size) {
  return {{window, size, size}, make_escape_limit(100.0, 16), {}};
}
constexpr job mandelbrot_job(int size) { return course_job({-1.5, 0.5, -1, 1}, size); }
constexpr job julia_job(int size) { return course_job({-1, 1, -1.2, 1.2}, size); }

constexpr bool course_tables() {
  counts m(9, 9), j(9, 9);
  draw_mandelbrot(m, mandelbrot_job(9));
  draw_julia(j, julia_job(9), course_c);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x)
      if (m(x, 8 - y) != mandelbrot_table[y][x] || j(x, 8 - y) != julia_table[y][x]) return false;
  return true;
}

// How many counts are not those of one point alone.
template <class T, class Count>
int wrong(const irg::image<int>& drawn, const irg::escape_job<T>& j, const Count& count) {
  int n = 0;
  for (int y = 0; y < drawn.height(); ++y)
    for (int x = 0; x < drawn.width(); ++x) n += drawn(x, y) != count(j.plane.at(x, y));
  return n;
}

template <class T>
void try_random_windows() {
  test::random r(8);
  for (int i = 0; i < 60; ++i) {
    const auto any = [&](double about, double reach) { return static_cast<T>(about + (2 * r.unit() - 1) * reach); };
    const double reach = std::ldexp(1.0, -static_cast<int>(r.integer(0, sizeof(T) == 4 ? 15 : 40)));
    const T x = any(-0.5, 1.2), y = any(0, 1.1);
    irg::escape_job<T> j{{{x, any(static_cast<double>(x), reach), y, any(static_cast<double>(y), reach)},
                          static_cast<int>(r.integer(2, 70)),
                          static_cast<int>(r.integer(2, 12))},
                         make_escape_limit(i % 4 == 0   ? T(1e6)
                                           : i % 4 == 1 ? T(0.5)
                                                        : T(2),
                                           static_cast<int>(r.integer(0, 500))),
                         {}};
    if (i % 5 == 0) j.plane.sampling = irg::plane_sampling::centres;
    counts on(j.plane.width, j.plane.height), off = on, parallel = on, julia = on;
    const auto stats = draw_mandelbrot(on, j);
    CHECK(stats.pixels == std::int64_t{j.plane.width} * j.plane.height);
    CHECK(draw_mandelbrot(parallel, j, irg::parallel{3}) == stats);
    j.skip = {skipping::off, skipping::off, skipping::off};
    CHECK((draw_mandelbrot(off, j) == irg::escape_counts{stats.pixels, 0, 0}));
    CHECK(on == off);
    CHECK(on == parallel);
    CHECK(wrong(on, j, [&](const irg::point<T, 2>& c) { return mandelbrot_count(c, j.limit); }) == 0);
    const irg::point<T, 2> c{any(-0.3, 0.8), any(0, 0.8)};
    j.skip = {};
    draw_julia(julia, j, c);
    CHECK(wrong(julia, j, [&](const irg::point<T, 2>& z) { return julia_count(z, c, j.limit); }) == 0);
  }
}

std::int64_t sum(const counts& c, int& at_most) {
  std::int64_t s = 0;
  for (int y = 0; y < c.height(); ++y)
    for (int x = 0; x < c.width(); ++x) s += c(x, y), at_most += c(x, y) == 16;
  return s;
}

}  // namespace

TEST_CASE("escape pictures: the course's samples, while compiling too") {
  CHECK_BOTH(course_tables());
  counts m(65, 65), j(65, 65);
  int m_most = 0, j_most = 0;
  draw_mandelbrot(m, mandelbrot_job(65));
  draw_julia(j, julia_job(65), course_c);
  CHECK(sum(m, m_most) == 47026);
  CHECK(sum(j, j_most) == 46350);
  CHECK(m_most == 1916);
  CHECK(j_most == 2017);
}

TEST_CASE("escape pictures: each pixel as alone, skips on and off, in lanes, threads, doubles and floats") {
  try_random_windows<double>();
  try_random_windows<float>();
}

TEST_CASE("escape pictures: rasters of 8 bits are refused, which hold too few counts") {
  static_assert(irg::CountRaster<irg::image<std::uint16_t>> && irg::CountRaster<counts>);
  static_assert(!irg::CountRaster<irg::image<std::uint8_t>> && !irg::CountRaster<irg::image<float>>);
}

TEST_CASE("escape pictures: what is skipped") {
  counts m(200, 160);
  const job whole{{{-2, 1, -1.2, 1.2}, 200, 160}, make_escape_limit(2.0, 5000), {}};
  const auto stats = draw_mandelbrot(m, whole);
  CHECK(stats.interior > 32000 * 0.18);
  CHECK(stats.cycles > 300);  // the smaller discs
  job small = whole;
  small.limit = make_escape_limit(1.0, 50);  // a disc that the set does not fit in
  CHECK(draw_mandelbrot(m, small).interior == 0);
}

TEST_CASE("escape pictures: squares that one orbit of discs tells, inside and outside") {
  for (const irg::view_window<double> window :
       {irg::view_window<double>{-0.135, -0.11, 0.735, 0.755},  // a disc of period 3
        irg::view_window<double>{-1.312, -1.31, -0.001, 0.001},  // of period 4
        irg::view_window<double>{-40, 40, -40, 40}}) {
    job j{{window, 100, 70}, make_escape_limit(2.0, 700), {skipping::off, skipping::off, skipping::on}};
    counts on(100, 70), off(100, 70);
    CHECK(draw_mandelbrot(on, j).squares > 2000);
    j.skip.squares = skipping::off;
    CHECK(draw_mandelbrot(off, j).squares == 0);
    CHECK(on == off);
    j.limit = make_escape_limit(30.0, 700);
    j.plane.window = {-1, 1, -1, 1};
    const irg::point<double, 2> c{-0.1, 0.1};  // most of its window is drawn to one point
    draw_julia(off, j, c);
    j.skip.squares = skipping::on;
    CHECK(draw_julia(on, j, c).squares > 2000);
    CHECK(on == off);
  }
}

TEST_CASE("escape pictures: orbits that touch the disc's border, which blocks of steps must not miss") {
  // About -2, whose orbit stays on the border of the disc of radius 2, and about other points of that circle.
  for (int i = 0; i < 40; ++i) {
    const double reach = std::ldexp(1.0, -i - 8), angle = 0.16 * i, at = i % 2 == 0 ? -2 : 2 * std::cos(angle),
                 up = i % 2 == 0 ? 0 : 2 * std::sin(angle);
    const job j{{{at - reach, at + reach, up - reach, up + reach}, 37, 5},
                make_escape_limit(2.0, 300),
                {skipping::off, skipping::off, skipping::off}};
    counts m(37, 5);
    draw_mandelbrot(m, j);
    CHECK(wrong(m, j, [&](const irg::point<double, 2>& c) { return mandelbrot_count(c, j.limit); }) == 0);
    const irg::point<double, 2> c{at, up};  // z about 0, 2 and c itself
    for (const double z : {0.0, 2.0, at}) {
      const job n{{{z - reach, z + reach, -reach, reach}, 37, 5}, j.limit, j.skip};
      draw_julia(m, n, c);
      CHECK(wrong(m, n, [&](const irg::point<double, 2>& p) { return julia_count(p, c, n.limit); }) == 0);
    }
  }
}

TEST_CASE("escape pictures: rows shorter than a register and the ends of rows skip what the others skip") {
  for (int width : {1, 3, 21}) {
    counts m(width, 2);
    const job inner{{{-0.7, 0.2, -0.1, 0.1}, width, 2},
                    make_escape_limit(2.0, 2147483647),
                    {skipping::off, skipping::on, skipping::off}};
    const auto stats = draw_mandelbrot(m, inner);  // each orbit ends in a point or a cycle; most is out of reach
    CHECK(stats == irg::escape_counts{2 * width, 0, 2 * width});
    for (int x = 0; x < width; ++x) CHECK(m(x, 0) == 2147483647);
  }
}

TEST_CASE("escape pictures: degenerate") {
  counts none(0, 0), one(1, 1), row(3, 1);
  CHECK((draw_mandelbrot(none, job{{{-2, 1, -1, 1}, 0, 0}, make_escape_limit(2.0, 9), {}}) == irg::escape_counts{}));
  draw_mandelbrot(one, job{{{0, 0, 1, 1}, 1, 1}, make_escape_limit(2.0, 9), {}});
  CHECK(one(0, 0) == 9);
  draw_julia(row, job{{{-9, 9, 0, 0}, 3, 1}, make_escape_limit(2.0, 0), {}}, course_c);
  CHECK(row(0, 0) == 0);
  irg::image<std::uint16_t> narrow(40, 40);
  draw_mandelbrot(narrow, job{{{-2, 1, -1, 1}, 40, 40}, make_escape_limit(2.0, 65535), {}});
  CHECK(narrow(20, 20) == 65535);
}
