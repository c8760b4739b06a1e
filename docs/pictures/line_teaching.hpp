// SPDX-License-Identifier: MIT
// The pictures of the pages on teaching forms of lines: which cells rounding moves, runs, cells by number.
#pragma once

#include <cstdint>

#include <irg/colour/pixel.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_cells.hpp>
#include <irg/raster/line_dda.hpp>
#include <irg/raster/line_run_slice.hpp>
#include <irg/raster/textbook/line_printed.hpp>

#include "enlarged.hpp"

namespace line_teaching {

using namespace enlarging;
inline constexpr irg::rgba8 blue{146, 184, 222, 255}, light_blue{200, 219, 238, 255}, red{224, 130, 108, 255};
inline constexpr int size = 24;

inline picture grid(int columns, int rows) {
  picture p(columns * size + 1, rows * size + 1, pale);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      for (int k = 1; k < size; ++k) irg::fill_span(p, {y * size + k, x * size + 1, (x + 1) * size}, paper);
  return p;
}

inline void square(picture& p, irg::cell c, irg::rgba8 colour) {
  for (int k = 1; k < size; ++k) irg::fill_span(p, {c.y * size + k, c.x * size + 1, (c.x + 1) * size}, colour);
}

inline void true_line(picture& p, irg::cell a, irg::cell b) {
  const auto centre = [](irg::cell c) { return irg::cell{c.x * size + size / 2, c.y * size + size / 2}; };
  irg::draw_line(p, centre(a), centre(b), ink);
}

// The cells of line_bresenham in blue, those that a form in doubles has instead in red.
template <class Form>
void compare(picture& p, irg::cell a, irg::cell b, const Form& form) {
  for (const irg::cell c : irg::line_cells(a, b)) square(p, c, blue);
  std::int64_t i = 0;
  form(a, b, [&](irg::cell c) {
    if (c != irg::line_cells(a, b)[i++]) square(p, c, red);
  });
  true_line(p, a, b);
}

// Where D > 0 fails: the first lines whose ties it spoils.
inline picture textbook() {
  picture p = grid(33, 12);
  const auto seed = [](irg::cell a, irg::cell b, auto emit) {
    irg::textbook::line_bresenham_printed<double>(a, b, emit);
  };
  compare(p, {1, 3}, {7, 8}, seed);
  compare(p, {8, 1}, {18, 10}, seed);
  compare(p, {19, 0}, {31, 10}, seed);
  return p;
}

inline picture dda() {
  picture p = grid(29, 15);
  const auto sums = [](irg::cell a, irg::cell b, auto emit) { irg::line_dda<double>(a, b, emit); };
  compare(p, {0, 3}, {12, 10}, sums);
  compare(p, {13, 1}, {27, 14}, sums);
  return p;
}

inline picture run_slice() {
  picture p = grid(30, 12);
  const auto runs = [&](irg::cell a, irg::cell b) {
    bool odd = false;
    irg::line_run_slice(a, b, [&](const irg::line_run& run) {
      for (const irg::cell c : irg::line_cells(run.first, run.last)) square(p, c, odd ? light_blue : blue);
      odd = !odd;
    });
    true_line(p, a, b);
  };
  runs({1, 1}, {20, 6});
  runs({1, 9}, {18, 10});
  runs({22, 1}, {28, 10});
  return p;
}

// Every fifth cell, asked for by its number.
inline picture cells() {
  picture p = grid(30, 10);
  const irg::line_cells line({1, 1}, {28, 8});
  for (const irg::cell c : line) square(p, c, light_blue);
  for (std::int64_t i = 0; i < line.size(); i += 5) square(p, line[i], red);
  true_line(p, {1, 1}, {28, 8});
  return p;
}

}  // namespace line_teaching
