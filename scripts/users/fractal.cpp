#include <cstdio>
#include <irg/fractal/escape_picture.hpp>
#include <irg/raster/image.hpp>

int main() {
  irg::image<int> counts(320, 256);
  const irg::escape_job<double> job{{{-2.2, 0.8, -1.2, 1.2}, 320, 256}, irg::make_escape_limit(2.0, 256), {}};
  irg::draw_mandelbrot(counts, job);
  unsigned sum = 0;
  for (int y = 0; y < counts.height(); ++y)
    for (int x = 0; x < counts.width(); ++x) sum = sum * 31 + static_cast<unsigned>(counts(x, y));
  std::printf("%u\n", sum);
}
