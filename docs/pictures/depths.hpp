// SPDX-License-Identifier: MIT
// A scene beside its depth buffers, and the resolution of the depth formats as a plot. Included by pictures.cpp.
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include <irg/hidden/textbook/zbuffer.hpp>
#include <irg/raster/depth_format.hpp>
#include <irg/raster/image.hpp>

#include "enlarged.hpp"

namespace depths {

using namespace enlarging;

constexpr int width = 240, height = 180;
constexpr double eye = 300, back = -620;

// Draws the scene; `away` is 1 where z points at the viewer, -1 where it is the distance.
template <class Order>
void draw(const irg::textbook::zbuffer<Order, picture, irg::image<double>>& buffers, double away) {
  using P = irg::point<double, 3>;
  const auto polygon = [&](auto ring, irg::rgba8 colour) {
    for (P& p : ring) p = {p.x, -p.y, away * p.z};  // rows run down
    irg::textbook::zbuffer_polygon_perspective(buffers, ring, away * eye, colour, {width / 2, height / 2});
  };
  for (int i = 0; i < 10; ++i)
    for (int k = 0; k < 9; ++k) {
      const double left = -300 + 60 * i, right = left + 60, front = 120 - 80 * k, rear = front - 80;
      polygon(std::array{P{left, -70, front}, P{right, -70, front}, P{right, -70, rear}, P{left, -70, rear}},
              (i + k) % 2 ? irg::rgba8{226, 220, 206, 255} : irg::rgba8{186, 178, 162, 255});
    }
  const auto panel = [&](P from, P to, double top, irg::rgba8 colour) {
    polygon(std::array{from, to, P{to.x, top, to.z}, P{from.x, top, from.z}}, colour);
  };
  panel({-90, -70, -60}, {130, -70, -330}, 25, {92, 142, 196, 255});
  panel({95, -70, -40}, {-110, -70, -260}, 5, {204, 96, 72, 255});
  const P tip{-75, -5, 40}, base[] = {{-105, -70, 70}, {-45, -70, 70}, {-45, -70, 10}, {-105, -70, 10}};
  const irg::rgba8 sides[] = {{236, 190, 92, 255}, {206, 150, 60, 255}, {160, 110, 40, 255}, {190, 140, 60, 255}};
  for (int i = 0; i < 4; ++i) polygon(std::array{base[i], base[(i + 1) % 4], tip}, sides[i]);
}

// The scene; its depths towards the viewer; its distances.
inline picture forms() {
  constexpr int gap = 12;
  picture all(3 * width + 2 * gap, height, {255, 255, 255, 255});
  const auto grey = [](const irg::image<double>& depth, double d, double darkest, double brightest) {
    picture p(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double t = 255 * (d - 1 / depth(x, y) - darkest) / (brightest - darkest);
        const auto v = static_cast<std::uint8_t>(std::lround(irg::clamped(t, 0.0, 255.0)));
        p(x, y) = {v, v, v, 255};
      }
    return p;
  };
  picture screen(width, height);
  irg::image<double> depth(width, height);
  const irg::textbook::zbuffer toward{irg::nearer_is_greater{}, screen, depth};
  toward.clear({120, 160, 196, 255}, 1 / (eye - back));
  draw(toward, 1);
  paste(all, screen, 0, 0);
  paste(all, grey(depth, eye, back, 110), width + gap, 0);
  const irg::textbook::zbuffer distances{irg::nearer_is_less{}, screen, depth};
  distances.clear({120, 160, 196, 255}, 1 / (back - eye));
  draw(distances, -1);
  paste(all, grey(depth, -eye, -110, -back), 2 * (width + gap), 0);
  return all;
}

// depth_resolution over the distance, both logarithmic, for near 0.1 and far 10 000.
inline bool write_plot(const std::string& path) {
  std::FILE* f = std::fopen(path.c_str(), "w");
  if (f == nullptr) return false;
  constexpr double z_near = 0.1, z_far = 1e4, left = 70, top = 20, inner_width = 420, inner_height = 300;
  constexpr int low = -8, high = 0;  // powers of ten of separation / distance
  const auto across = [&](double d) { return left + inner_width * std::log10(d / z_near) / 5; };
  const auto up = [&](double share) { return top + inner_height * (high - std::log10(share)) / (high - low); };
  std::fprintf(f,
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 380\" font-family=\"sans-serif\" "
               "font-size=\"12\">\n<rect width=\"640\" height=\"380\" fill=\"#faf9f6\"/>\n");
  const auto text = [&](double x, double y, const char* anchor, const char* colour, const char* words) {
    std::fprintf(f, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>\n", x, y, anchor, colour,
                 words);
  };
  const auto rule = [&](double x1, double y1, double x2, double y2) {
    std::fprintf(f, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#dedcd6\"/>\n", x1, y1, x2, y2);
  };
  for (int e = low; e <= high; ++e) {
    const double y = up(std::pow(10.0, e));
    rule(left, y, left + inner_width, y);
    text(left - 8, y + 4, "end", "#20304a", ("1e" + std::to_string(e)).c_str());
  }
  for (int e = -1; e <= 4; ++e) {
    const double x = across(std::pow(10.0, e));
    rule(x, top, x, top + inner_height);
    char label[16];
    std::snprintf(label, sizeof label, "%g", std::pow(10.0, e));
    text(x, top + inner_height + 18, "middle", "#20304a", label);
  }
  text(left + inner_width / 2, top + inner_height + 38, "middle", "#20304a", "distance (near 0.1, far 10000)");
  std::fprintf(f,
               "<text transform=\"translate(16 %.1f) rotate(-90)\" text-anchor=\"middle\" fill=\"#20304a\">"
               "least separation / distance</text>\n",
               top + inner_height / 2);
  const auto curve = [&](auto format, const char* colour, const char* dash, const char* name, double label_y) {
    std::fprintf(f, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" stroke-dasharray=\"%s\" d=\"", colour,
                 dash);
    for (int i = 0; i <= 200; ++i) {
      const double d = irg::minimum(z_near * std::pow(10.0, i / 40.0), z_far * (1 - 1e-6));
      const double share = irg::depth_resolution(format, z_near, z_far, d) / d;
      std::fprintf(f, "%c%.1f %.1f", i == 0 ? 'M' : 'L', across(d), irg::minimum(up(share), top + inner_height));
    }
    std::fprintf(f, "\"/>\n");
    text(left + inner_width + 8, label_y, "start", colour, name);
  };
  curve(irg::depth_unorm16{}, "#b04030", "none", "16 bits", up(0.86) + 4);
  curve(irg::depth_unorm24{}, "#c08020", "none", "24 bits", up(0.006) - 8);
  curve(irg::depth_float{}, "#407040", "5 4", "float", up(0.006) + 12);
  curve(irg::depth_inverse_w{}, "#2060a0", "none", "1/w, float", up(1e-7) - 8);
  curve(irg::depth_float_reversed{}, "#703090", "5 4", "reversed float", up(1e-7) + 12);
  std::fprintf(f, "</svg>\n");
  return std::fclose(f) == 0;
}

}  // namespace depths
