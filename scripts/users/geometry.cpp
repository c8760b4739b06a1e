#include <cstdio>
#include <vector>
#include <irg/geometry/convex_hull.hpp>
#include <irg/geometry/polygon_overlay.hpp>
#include <irg/geometry/triangulate_monotone.hpp>

int main() {
  using ring = std::vector<irg::point<double, 2>>;
  const ring comb{{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const ring bar{{-1, 2}, {9, 2}, {9, 9}, {-1, 9}};
  const auto teeth = irg::polygon_boolean(comb, bar, irg::boolean_operation::intersection);
  std::printf("%zu rings\n", teeth.rings.size());
  for (const auto& r : teeth.rings)
    for (const auto& p : r) std::printf("%.17g %.17g\n", p.x, p.y);
}
