#include <array>
#include <cstdio>
#include <irg/curve/bezier_queries.hpp>
#include <irg/curve/bezier_surface.hpp>

int main() {
  using P = irg::point<double, 3>;
  const std::array points{P{0, 0, 0}, P{1, 3, 0}, P{4, 3, 2}, P{5, 0, 4}};
  for (int k = 0; k <= 100; ++k) {
    const P p = irg::bezier_point(points, k / 100.0);
    std::printf("%.17g %.17g %.17g\n", p.x, p.y, p.z);
  }
}
