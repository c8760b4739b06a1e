// SPDX-License-Identifier: MIT
// The errors of the ways to invert a 4x4 matrix over its condition number, as a plot. Included by
// number_and_geometry_pages.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include <irg/math/inverse.hpp>
#include <irg/math/exact_matrix.hpp>
#include <irg/math/trigonometry.hpp>

namespace inverse_errors {

using mat4 = irg::mat<double, 4, 4>;

// Numbers in [0, 1) from a seed (SplitMix64).
struct numbers {
  std::uint64_t state;
  double next() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
};

inline mat4 turned(numbers& n) {
  mat4 a = irg::identity_matrix<double, 4>();
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double angle = 6.28 * n.next(), c = irg::cos(angle), s = irg::sin(angle);
      mat4 turn = irg::identity_matrix<double, 4>();
      turn(i, i) = turn(j, j) = c;
      turn(i, j) = -s;
      turn(j, i) = s;
      a = a * turn;
    }
  return a;
}

inline double largest_of(const mat4& a) {
  double largest = 0;
  for (const auto& row : a.m)
    for (const double entry : row) largest = std::max(largest, std::fabs(entry));
  return largest;
}

// The largest error of invert(a), relative to the largest entry, for matrices of one condition number; absent when an
// inverse is.
template <class F>
std::optional<double> error_at(double condition, const F& invert) {
  numbers n{static_cast<std::uint64_t>(condition)};
  double worst = 0;
  for (int i = 0; i < 30; ++i) {
    const double steps[3][2] = {{1, 1}, {1 / condition, 1 / condition}, {std::pow(condition, -0.33), 1 / condition}};
    mat4 s{};
    s(0, 0) = 1;
    s(1, 1) = steps[i % 3][0];
    s(2, 2) = steps[i % 3][1];
    s(3, 3) = 1 / condition;
    const mat4 first = turned(n), a = first * s * turned(n);
    const std::optional<mat4> exact = irg::inverse_exact(a), x = invert(a);
    if (!exact) continue;
    if (!x) return std::nullopt;
    worst = std::max(worst, largest_of(*x - *exact) / largest_of(*exact));
  }
  return worst;
}

inline bool write_plot(const std::string& path) {
  std::FILE* f = std::fopen(path.c_str(), "w");
  if (f == nullptr) return false;
  constexpr double left = 70, top = 20, inner_width = 420, inner_height = 300, highest_condition = 18;
  constexpr int low = -17, high = 1;
  const auto across = [&](double power) { return left + inner_width * power / highest_condition; };
  const auto up = [&](double error) {
    const double power = irg::clamped(std::log10(error), static_cast<double>(low), static_cast<double>(high));
    return top + inner_height * (high - power) / (high - low);
  };
  std::fprintf(f,
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 380\" font-family=\"sans-serif\" "
               "font-size=\"12\">\n<rect width=\"640\" height=\"380\" fill=\"#faf9f6\"/>\n");
  const auto text = [&](double x, double y, const char* anchor, const char* colour, const std::string& words) {
    std::fprintf(f, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>\n", x, y, anchor, colour,
                 words.c_str());
  };
  const auto rule = [&](double x1, double y1, double x2, double y2) {
    std::fprintf(f, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#dedcd6\"/>\n", x1, y1, x2, y2);
  };
  for (int e = low + 1; e <= high; e += 2) {
    const double y = up(std::pow(10.0, e));
    rule(left, y, left + inner_width, y);
    text(left - 8, y + 4, "end", "#20304a", e == 1 ? "10" : e == 0 ? "1" : "1e" + std::to_string(e));
  }
  for (int e = 0; e <= 18; e += 3) {
    rule(across(e), top, across(e), top + inner_height);
    text(across(e), top + inner_height + 18, "middle", "#20304a", e == 0 ? "1" : "1e" + std::to_string(e));
  }
  text(left + inner_width / 2, top + inner_height + 38, "middle", "#20304a", "condition number");
  std::fprintf(f,
               "<text transform=\"translate(16 %.1f) rotate(-90)\" text-anchor=\"middle\" fill=\"#20304a\">"
               "largest relative error</text>\n",
               top + inner_height / 2);
  // Each curve ends where an inverse is refused.
  const auto curve = [&](const auto& invert, const char* colour, const char* dash, const char* name, double label_y) {
    std::fprintf(f, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" stroke-dasharray=\"%s\" d=\"", colour,
                 dash);
    double x = left, y = top;
    for (int i = 0; i <= 36; ++i) {
      const std::optional<double> error = error_at(std::pow(10.0, i / 2.0), invert);
      if (!error) break;
      x = across(i / 2.0);
      y = up(std::max(*error, 0x1p-53));
      std::fprintf(f, "%c%.1f %.1f", i == 0 ? 'M' : 'L', x, y);
    }
    std::fprintf(f, "\"/>\n<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.5\" fill=\"%s\"/>\n", x, y, colour);
    text(left + inner_width + 8, label_y, "start", colour, name);
  };
  const auto checked = [](const mat4& a) -> std::optional<mat4> {
    const mat4 x = irg::inverse_fast(a);
    return std::isfinite(largest_of(x)) ? std::optional(x) : std::optional(mat4{});
  };
  curve(checked, "#b04030", "none", "inverse_fast", up(10) + 12);
  curve([](const mat4& a) { return irg::inverse(a); }, "#c08020", "none", "inverse", up(1e-2));
  curve([](const mat4& a) { return irg::inverse_accurate(a); }, "#407040", "none", "inverse_accurate", up(1e-14));
  curve([](const mat4& a) { return irg::inverse_exact(a); }, "#2060a0", "5 4", "inverse_exact", up(1e-16) + 4);
  std::fprintf(f, "</svg>\n");
  return std::fclose(f) == 0;
}

}  // namespace inverse_errors
