// SPDX-License-Identifier: MIT
// The teapot's 32 patches as triangles handed to a sink: in equal steps, and within a tolerance. Errors: the farthest
// that patches are from their triangles, seen at the middles of these, in thousandths of the teapot's unit.
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <irg/curve/surface_tessellation.hpp>
#include <irg/mesh/teapot.hpp>

#include "support/measure.hpp"

namespace {

using point = irg::point<double, 3>;

struct work {
  std::array<irg::bezier_patch<point>, 32> patches = irg::teapot_patches<double>();
  double sum = 0, farthest = 0;
};

template <class Run>
void enter(const std::string& name, const std::string& who, int triangles, Run run) {
  work& w = bench::keep(work{});
  bench::contender c{
      who, [&w, run] {
        for (const auto& patch : w.patches)
          run(patch, [&w](const auto& p, const auto& q, const auto& r) { w.sum += p.point.x + q.point.y + r.point.z; });
      }};
  c.judge = [&w, run] {
    bench::errors e;
    e.max = 0;
    for (const auto& patch : w.patches)
      run(patch, [&](const auto& p, const auto& q, const auto& r) {
        const auto mean = [](double x, double y, double z) { return (x + y + z) / 3; };
        const point at = irg::patch_point(patch, mean(p.u.t, q.u.t, r.u.t), mean(p.v.t, q.v.t, r.v.t));
        const point flat{mean(p.point.x, q.point.x, r.point.x), mean(p.point.y, q.point.y, r.point.y),
                         mean(p.point.z, q.point.z, r.point.z)};
        e.max = std::fmax(e.max, 1000 * irg::length(at - flat));
      });
    return e;
  };
  bench::enter({"teapot to triangles", name + bench::build_suffix(), "triangle", triangles, "1/1000", ""},
               std::move(c));
}

int within_triangles(double tolerance) {
  int count = 0;
  for (const auto& patch : irg::teapot_patches<double>()) {
    const auto list = irg::net_of(patch);
    const auto nothing = [](const auto&, const auto&, const auto&) {};
    count += static_cast<int>(irg::tessellate_within(irg::control_net<point>{list, 4}, tolerance, nothing).triangles);
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  const int steps = bench::smoke() ? 3 : 40;
  enter("steps", "irg", 32 * 2 * steps * steps - 8 * steps,
        [steps](const auto& patch, auto sink) { irg::tessellate_steps(patch, steps, steps, sink); });
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    if (bench::smoke() && tolerance < 0.1) continue;
    enter("within " + std::to_string(tolerance).substr(0, 5), "irg", within_triangles(tolerance),
          [tolerance](const auto& patch, auto sink) {
            const auto list = irg::net_of(patch);
            irg::tessellate_within(irg::control_net<point>{list, 4}, tolerance, sink);
          });
  }
  return bench::run_benchmarks(argc, argv);
}
