// SPDX-License-Identifier: MIT
// Errors in units in the last place over how hard the input is, as plots: dot products and quadratic equations.
// Included by number_and_geometry_pages.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

#include <irg/math/textbook/roots.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/roots.hpp>
#include <irg/math/vec.hpp>

namespace error_plots {

// Numbers from 1 to 2, of any sign, from a seed (SplitMix64).
struct numbers {
  std::uint64_t state;
  double next() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    const double x = 1 + static_cast<double>(z >> 12) * 0x1p-52;
    return (z & 1) != 0 ? x : -x;
  }
};

inline double ulps(double got, double exact) {
  int exponent = 0;
  std::frexp(exact, &exponent);
  return std::fabs(got - exact) * std::ldexp(1.0, std::min(53 - exponent, 1023));
}

// The largest error of dot(a, b) when the products cancel to about 2^-cancelled of their size.
template <class F>
double dot_error(int cancelled, const F& dot) {
  numbers n{static_cast<std::uint64_t>(cancelled)};
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    irg::vec<double, 4> a, b;
    for (int k = 0; k < 4; ++k) a[k] = n.next();
    for (int k = 0; k < 2; ++k) b[k] = n.next();
    b.z = irg::dot_exact(a, b) / -a.z;
    b.w = (irg::dot_exact(a, b) + std::ldexp(n.next(), -cancelled)) / (cancelled < 50 ? 1 : -a.w);
    worst = std::max(worst, ulps(dot(a, b), irg::dot_exact(a, b)));
  }
  return worst;
}

// The largest error of a root when one is 2^apart times the other.
template <class F>
double root_error(int apart, const F& solve) {
  numbers n{static_cast<std::uint64_t>(apart)};
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    const double a = n.next(), x = n.next(), y = std::ldexp(n.next(), apart);
    const double b = -irg::product(a, x + y), c = irg::product(irg::product(a, x), y);
    const auto exact = irg::quadratic_roots(a, b, c);
    const auto got = solve(a, b, c);
    for (int k = 0; k < got.count && got.count == exact.count; ++k)
      worst = std::max(worst, ulps(got.root[k], exact.root[k]));
  }
  return worst;
}

// A plot of errors from 1/4 to 2^60 ulp over powers of two.
class plot {
public:
  plot(const std::string& path, int last, const char* axis) : file_(std::fopen(path.c_str(), "w")), last_(last) {
    if (file_ == nullptr) return;
    std::fprintf(file_,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 360\" font-family=\"sans-serif\" "
                 "font-size=\"12\">\n<rect width=\"640\" height=\"360\" fill=\"#faf9f6\"/>\n");
    for (int e = 0; e <= 60; e += 10) {
      rule(left, up(e), left + width, up(e));
      text(left - 8, up(e) + 4, "end", "#20304a", e == 0 ? "1" : "2^" + std::to_string(e));
    }
    for (int e = 0; e <= last; e += 10) {
      rule(across(e), up(60), across(e), up(-2));
      text(across(e), up(-2) + 18, "middle", "#20304a", e == 0 ? "1" : "2^" + std::to_string(e));
    }
    text(left + width / 2, up(-2) + 38, "middle", "#20304a", axis);
    std::fprintf(file_,
                 "<text transform=\"translate(16 %.1f) rotate(-90)\" text-anchor=\"middle\" fill=\"#20304a\">"
                 "largest error, ulp</text>\n",
                 up(29));
  }
  plot(const plot&) = delete;
  plot& operator=(const plot&) = delete;

  template <class F>
  void curve(const F& error_at, const char* colour, const char* name, double label_at) {
    if (file_ == nullptr) return;
    std::fprintf(file_, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" d=\"", colour);
    for (int e = 0; e <= last_; e += 2)
      std::fprintf(file_, "%c%.1f %.1f", e == 0 ? 'M' : 'L', across(e), up(std::log2(std::max(error_at(e), 0.25))));
    std::fprintf(file_, "\"/>\n");
    text(left + width + 8, up(label_at) + 4, "start", colour, name);
  }

  bool close() {
    if (file_ == nullptr) return false;
    std::fprintf(file_, "</svg>\n");
    return std::fclose(file_) == 0;
  }

private:
  static constexpr double left = 70, top = 20, width = 400, height = 290;
  double across(double power) const { return left + width * power / last_; }
  static double up(double power) { return top + height * (60 - irg::clamped(power, -2.0, 60.0)) / 62; }
  void text(double x, double y, const char* anchor, const char* colour, const std::string& words) {
    std::fprintf(file_, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>\n", x, y, anchor, colour,
                 words.c_str());
  }
  void rule(double x1, double y1, double x2, double y2) {
    std::fprintf(file_, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#dedcd6\"/>\n", x1, y1, x2, y2);
  }

  std::FILE* file_;
  int last_;
};

inline bool write_dots(const std::string& path) {
  using v4 = irg::vec<double, 4>;
  plot p(path, 100, "condition number");
  p.curve([](int e) { return dot_error(e, [](const v4& a, const v4& b) { return irg::dot(a, b); }); }, "#b04030", "dot",
          58);
  p.curve([](int e) { return dot_error(e, [](const v4& a, const v4& b) { return irg::dot_accurate(a, b); }); },
          "#407040", "dot_accurate", 48);
  p.curve([](int e) { return dot_error(e, [](const v4& a, const v4& b) { return irg::dot_exact(a, b); }); }, "#2060a0",
          "dot_exact (half an ulp)", -2);
  return p.close();
}

inline bool write_roots(const std::string& path) {
  plot p(path, 60, "larger root over smaller root");
  p.curve(
      [](int e) {
        return root_error(e, [](double a, double b, double c) { return irg::textbook::quadratic_roots(a, b, c); });
      },
      "#b04030", "textbook::quadratic_roots", 54);
  p.curve(
      [](int e) {
        return root_error(e, [](double a, double b, double c) { return irg::quadratic_roots_fast(a, b, c); });
      },
      "#407040", "quadratic_roots_fast", 2);
  p.curve(
      [](int e) { return root_error(e, [](double a, double b, double c) { return irg::quadratic_roots(a, b, c); }); },
      "#2060a0", "quadratic_roots", -2);
  return p.close();
}

}  // namespace error_plots
