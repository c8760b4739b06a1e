// SPDX-License-Identifier: MIT
// Pictures of number types: a polynomial enclosed by intervals, the bits of an expansion's parts, the Mandelbrot set
// where double has no digits left.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <irg/math/double_double.hpp>
#include <irg/math/expansion.hpp>
#include <irg/math/interval.hpp>
#include <irg/math/polynomial.hpp>

#include "sketch.hpp"

namespace number_pictures {

using namespace sketching;

// x^4 - 3x^2 + x + 1 over 8, 16 and 32 intervals of x.
inline picture enclosures() {
  using ival = irg::interval<double>;
  constexpr std::array<double, 5> c{1, 1, -3, 0, 1};
  constexpr std::array<ival, 5> intervals{ival(1), ival(1), ival(-3), ival(0), ival(1)};
  constexpr int panel = 200, gap = 20, height = 230;
  picture p(3 * panel + 2 * gap, height, paper);
  int left = 0;
  for (const int boxes : {8, 16, 32}) {
    const auto place = [&](double x, double y) { return point2{left + (x + 2.1) * panel / 4.2, 130 - 12.5 * y}; };
    for (int i = 0; i < boxes; ++i) {
      const ival x(-2.1 + 4.2 * i / boxes, -2.1 + 4.2 * (i + 1) / boxes);
      const ival y = irg::evaluate_polynomial(intervals, x);
      const auto sign = certain_sign(y);
      const irg::rgba8 colour = !sign       ? yellow
                                : *sign > 0 ? irg::rgba8{150, 186, 224, 255}
                                            : irg::rgba8{228, 150, 132, 255};
      const double low = std::max(y.lower(), -7.6), high = std::min(y.upper(), 10.0);
      area(p, {place(x.lower(), low), place(x.upper(), low), place(x.upper(), high), place(x.lower(), high)}, colour);
    }
    stroke(p, {{left + 1.0, place(0, 0).y}, {left + panel - 1.0, place(0, 0).y}}, 1, grey);
    ring curve;
    for (int k = 0; k <= 210; ++k) {
      const double x = -2.1 + k / 50.0;
      curve.push_back(place(x, irg::evaluate_polynomial_exact(c, x)));
    }
    stroke(p, curve, 2, ink);
    left += panel + gap;
  }
  return p;
}

// The places of a row of bits: column 0 is worth 2^first, the next half of that.
struct bit_board {
  picture& p;
  int left, first, cell_width, cell_height;

  void cell(int place, int top, irg::rgba8 colour) const {
    const int x = left + (first - place) * cell_width;
    for (int y = top; y < top + cell_height - 1; ++y) irg::fill_span(p, {y, x, x + cell_width - 1}, colour);
  }
  // The 24 bits of a float where they count; those that are 1 are dark, blue in positive numbers, red in negative ones.
  void number(float x, int top) const {
    int exponent = 0;
    const auto bits = static_cast<std::int32_t>(std::ldexp(std::fabs(std::frexp(x, &exponent)), 24));
    for (int k = 0; k < 24; ++k) {
      const bool one = (bits >> (23 - k)) & 1;
      cell(exponent - 1 - k, top, one ? (x < 0 ? red : blue) : x < 0 ? light_red : light_blue);
    }
  }
  // The bits of the sum of floats, which is positive.
  template <int N>
  void sum(const irg::expansion<float, N>& e, int top) const {
    constexpr int places = 120;
    std::array<int, places> digits{};
    for (int i = 0; i < e.size; ++i) {
      int exponent = 0;
      const auto bits = static_cast<std::int32_t>(std::ldexp(std::frexp(e.parts[i], &exponent), 24));
      for (int k = 0; k < 24; ++k)
        if ((std::abs(bits) >> (23 - k)) & 1)
          digits[static_cast<std::size_t>(first - exponent + 1 + k)] += bits < 0 ? -1 : 1;
    }
    int last = 0;
    for (int k = places - 1, carry = 0; k >= 0; --k) {
      int& digit = digits[static_cast<std::size_t>(k)];
      digit += carry;
      carry = digit < 0 ? -1 : digit / 2;
      digit &= 1;
      if (digit && last == 0) last = k;
    }
    bool seen = false;
    for (int k = 0; k <= last; ++k) {
      seen = seen || digits[static_cast<std::size_t>(k)];
      if (seen) cell(first - k, top, digits[static_cast<std::size_t>(k)] ? ink : pale);
    }
  }
};

// 0.1 * 0.3 and 0.7 * 0.9 in floats, exactly; their product's parts; all bits of it.
inline picture parts() {
  picture p(708, 210, paper);
  const auto x = irg::exact_product_of(0.1f, 0.3f), y = irg::exact_product_of(0.7f, 0.9f);
  const auto product = compress(x * y);
  const bit_board board{p, 14, -1, 6, 16};
  int top = 10;
  const auto rows = [&](const auto& e) {
    for (int i = e.size - 1; i >= 0; --i, top += 16) board.number(e.parts[i], top);
    top += 14;
  };
  rows(x);
  rows(y);
  rows(product);
  board.sum(product, top);
  return p;
}

// How soon the orbit of 0 under z^2 + c leaves; c is a place plus steps of 2^-55.
template <class T>
int steps_to_leave(const T& real, const T& imaginary) {
  constexpr int most = 400;
  T x = 0, y = 0;
  for (int k = 0; k < most; ++k) {
    const T xx = x * x, yy = y * y;
    if (static_cast<double>(xx + yy) > 4) return k;
    y = T(2.0) * (x * y) + imaginary;
    x = xx - yy + real;
  }
  return most;
}

// The arms around a point where they never end, in double and in double_double.
inline picture mandelbrot() {
  using dd = irg::double_double;
  constexpr int size = 300, gap = 20;
  const dd real(-0x1.9e17388762281p-4, 0x1.ce18134b2e796p-59), imaginary(0x1.e99e62b30ffb3p-1, -0x1.56a85c8b09600p-57);
  picture p(2 * size + gap, size, {255, 255, 255, 255});
  const auto colour = [](int steps) {
    constexpr irg::rgba8 turns[] = {{32, 44, 66, 255},    {62, 112, 176, 255}, {206, 222, 240, 255},
                                    {250, 240, 210, 255}, {250, 190, 90, 255}, {150, 60, 40, 255}};
    const int phase = steps % 24;
    return irg::mix(turns[phase / 4], turns[(phase / 4 + 1) % 6], static_cast<std::uint8_t>(phase % 4 * 64));
  };
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i) {
      const dd re = real + (i - size / 2) * 0x1p-55, im = imaginary + (size / 2 - j) * 0x1p-55;
      p(i, j) = colour(steps_to_leave(static_cast<double>(re), static_cast<double>(im)));
      p(size + gap + i, j) = colour(steps_to_leave(re, im));
    }
  return p;
}

}  // namespace number_pictures
