#include <cstdio>
#include <vector>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/image.hpp>

int main() {
  irg::image<irg::rgba8> picture(320, 240, {255, 255, 255, 255});
  const std::vector<irg::point<double, 2>> ring{{10, 10}, {300, 40}, {280, 200}, {30, 220}};
  irg::fill_polygon(picture, ring, irg::fill_rule::even_odd, {200, 30, 30, 255});
  irg::draw_line(picture, {5, 5}, {310, 230}, {0, 0, 0, 255});
  unsigned sum = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) sum = sum * 31 + picture(x, y).r;
  std::printf("%u\n", sum);
}
