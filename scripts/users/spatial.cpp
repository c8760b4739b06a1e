#include <cstdio>
#include <vector>
#include <irg/spatial/triangle_bvh.hpp>

int main() {
  std::vector<irg::triangle_bvh<double>::triangle> triangles;
  for (int i = 0; i < 1000; ++i) triangles.push_back({{{i * 1.0, 0, 0}, {i + 0.9, 0, 0}, {i * 1.0, 1, 0.3 * i}}});
  const irg::triangle_bvh<double> tree(triangles);
  for (int i = 0; i < 1000; ++i)
    if (const auto hit = irg::closest_hit(tree, irg::ray<double, 3>{{i + 0.3, 0.2, -1}, {0, 0.001, 1}}))
      std::printf("%u %.17g\n", hit->triangle, hit->at.t);
}
