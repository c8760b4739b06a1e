#include <cstdio>
#include <irg/visibility/visibility_polygon.hpp>

int main() {
  const irg::segment<double, 2> walls[] = {{{1, 1}, {1, -1}}, {{-2, -1}, {-1, 2}}, {{-1, 0}, {-3, 1}}};
  const irg::box<double, 2> room{{-4, -4}, {4, 4}};
  const auto seen = irg::visibility_polygon(irg::point<double, 2>{0, 0}, room, walls);
  for (const auto& corner : seen.ring) std::printf("%.17g %.17g\n", corner.at.x, corner.at.y);
}
