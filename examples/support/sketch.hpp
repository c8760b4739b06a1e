// SPDX-License-Identifier: MIT
// A drawing of lines and dots, collected first and then fitted into a picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <irg/raster/draw_line.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>

#include "picture_options.hpp"

namespace program {

/// Lines and dots of a plane with y up, or of space as they look from x, y, z > 0 with z up.
class sketch {
public:
  static constexpr irg::rgba8 paper{250, 249, 246, 255}, ink{32, 44, 66, 255}, grey{176, 178, 182, 255},
      red{204, 96, 72, 255}, blue{60, 116, 176, 255}, green{78, 148, 96, 255};
  using place = irg::point<double, 2>;
  using point = irg::point<double, 3>;

  void line(const place& a, const place& b, irg::rgba8 colour) {
    if (drawable(a) && drawable(b)) lines_.push_back({a, b, colour});
  }
  void dot(const place& at, irg::rgba8 colour) {
    if (drawable(at)) lines_.push_back({at, at, colour});
  }
  void line(const point& a, const point& b, irg::rgba8 colour) { line(seen(a), seen(b), colour); }
  void dot(const point& at, irg::rgba8 colour) { dot(seen(at), colour); }

  /// The drawing, as large as the picture lets it be, but for a margin.
  irg::image<irg::rgba8> picture(const picture_size& size) const {
    irg::image<irg::rgba8> out(size.width, size.height, paper);
    place low{}, high{};
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (const place& p : {lines_[i].from, lines_[i].to})
        for (int k = 0; k < 2; ++k) {
          low[k] = i == 0 ? p[k] : std::min(low[k], p[k]);
          high[k] = i == 0 ? p[k] : std::max(high[k], p[k]);
        }
    const double wide = (high.x - low.x) / (0.9 * size.width), tall = (high.y - low.y) / (0.9 * size.height);
    const double unit = std::max(wide, tall) > 0 ? std::max(wide, tall) : 1;
    const auto pixel = [&](const place& p) {
      return irg::cell{static_cast<int>(std::floor(size.width / 2.0 + (p.x - (low.x / 2 + high.x / 2)) / unit)),
                       static_cast<int>(std::floor(size.height / 2.0 - (p.y - (low.y / 2 + high.y / 2)) / unit))};
    };
    for (const stroke& s : lines_) {
      const irg::cell a = pixel(s.from), b = pixel(s.to);
      irg::draw_line(out, a, b, s.colour);
      if (s.from == s.to)
        for (int y = a.y - 3; y <= a.y + 3; ++y) irg::fill_span(out, {y, a.x - 3, a.x + 4}, s.colour);
    }
    return out;
  }

private:
  struct stroke {
    place from, to;
    irg::rgba8 colour;
  };

  // Isometric: x to the lower left, y to the right, z up.
  static place seen(const point& p) { return {(p.y - p.x) * 0.8660254037844386, p.z - (p.x + p.y) / 2}; }
  // So large that their differences would overflow: left out.
  static bool drawable(const place& p) { return std::abs(p.x) < 1e300 && std::abs(p.y) < 1e300; }

  std::vector<stroke> lines_;
};

}  // namespace program
