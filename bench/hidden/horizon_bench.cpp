// SPDX-License-Identifier: MIT
// Surfaces of 50 x 50 to 2000 x 2000 samples without what they hide: the floating horizon in pixels and in vectors, the
// perimeter method, and what plotting programs and renderers do instead: facets painted far to near with their edges
// (gnuplot's way), a z-buffer of their triangles. Wrong are columns whose horizon is not the extreme of all samples, and
// vector parts that another order of the same curves does not give. `growth` is the exponent of the number of samples in
// the time, between this size and the one before.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <irg/hidden/floating_horizon.hpp>
#include <irg/hidden/grid_surface.hpp>
#include <irg/hidden/horizon_curves.hpp>
#include <irg/hidden/horizon_lines.hpp>
#include <irg/hidden/horizon_surface.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/screen_face.hpp>
#include <irg/raster/triangle_setup.hpp>

#include "support/measure.hpp"

namespace {

using namespace bench;

// Hills, sampled beforehand: what is measured is the hiding.
struct hills {
  int n;
  std::vector<double> places{}, heights{};

  explicit hills(int count) : n(count) {
    for (int i = 0; i < n; ++i) places.push_back(static_cast<double>(i) / (n - 1));
    for (const double x : places)
      for (const double z : places)
        heights.push_back(0.3 * std::cos(9 * std::hypot(x - 0.5, z - 0.5)) +
                          0.05 * std::sin(40 * x) * std::cos(31 * z));
  }
  double at(int i, int j) const {
    return heights[static_cast<std::size_t>(i) * places.size() + static_cast<std::size_t>(j)];
  }
  double operator()(double x, double z) const {
    return at(static_cast<int>(x * (n - 1) + 0.5), static_cast<int>(z * (n - 1) + 0.5));
  }
  irg::grid_surface surface() const { return {places, places, heights}; }
};

irg::horizon_view view_of(int n) {
  irg::horizon_view v{1200, 700, irg::radians(29.0), irg::radians(40.0), n, n};
  v.families = irg::horizon_curves::constant_z;
  return v;
}

// Columns whose horizons are not the extremes of all samples.
double wrong_columns(const irg::floating_horizon<>& drawn, const hills& h, const irg::horizon_view& v) {
  struct extremes {
    std::vector<irg::horizon_column> columns;
    void begin_curve() {}
    void add(const irg::cell& c, int) { irg::detail::extend_horizon(columns[static_cast<std::size_t>(c.x)], c.y); }
  } all{std::vector<irg::horizon_column>(static_cast<std::size_t>(drawn.columns()))};
  irg::draw_horizon_surface(all, h, v, 0);
  double wrong = 0;
  for (int x = 0; x < drawn.columns(); ++x) wrong += drawn[x] == all.columns[static_cast<std::size_t>(x)] ? 0 : 1;
  return wrong;
}

constexpr int width = 1400, height = 1000;

// Where a sample is seen, for the two rasters.
irg::point<double, 2> seen(const hills& h, int i, int j) {
  const double x = h.places[static_cast<std::size_t>(i)], z = h.places[static_cast<std::size_t>(j)];
  return {600 * (x * 0.875 - z * 0.485) + 400, 800 - 350 * (h.at(i, j) * 0.766 + (x * 0.485 + z * 0.875) * 0.643)};
}

// Facets far to near, each filled and outlined: sorted by their distance, as gnuplot sorts them.
void paint_facets(const hills& h, irg::image<irg::rgba8>& picture) {
  struct facet {
    double distance;
    int i, j;
  };
  std::vector<facet> facets;
  for (int i = 0; i + 1 < h.n; ++i)
    for (int j = 0; j + 1 < h.n; ++j)
      facets.push_back(
          {h.places[static_cast<std::size_t>(i)] * 0.485 + h.places[static_cast<std::size_t>(j)] * 0.875, i, j});
  std::sort(facets.begin(), facets.end(), [](const facet& a, const facet& b) { return a.distance > b.distance; });
  const auto cell_of = [](const irg::point<double, 2>& p) {
    return irg::cell{static_cast<int>(p.x), static_cast<int>(p.y)};
  };
  for (const facet& f : facets) {
    const irg::point<double, 2> ring[] = {seen(h, f.i, f.j), seen(h, f.i + 1, f.j), seen(h, f.i + 1, f.j + 1),
                                          seen(h, f.i, f.j + 1)};
    irg::fill_convex(picture, ring, irg::rgba8{250, 249, 246, 255});
    for (int k = 0; k < 4; ++k)
      irg::draw_line(picture, cell_of(ring[k]), cell_of(ring[(k + 1) % 4]), irg::rgba8{32, 44, 66, 255});
  }
}

// Two triangles a facet, the nearest at each pixel.
void fill_depths(const hills& h, irg::image<float>& nearest, irg::image<std::uint32_t>& ids) {
  const auto corner = [&](int i, int j) {
    const auto p = seen(h, i, j);
    const double far = h.places[static_cast<std::size_t>(i)] * 0.485 + h.places[static_cast<std::size_t>(j)] * 0.875;
    irg::screen_vertex v{};
    v.position = irg::snap(p);
    v.depth = static_cast<float>(1 - far / 3);
    return v;
  };
  std::uint32_t number = 0;
  const auto draw = [&](const irg::screen_vertex& a, const irg::screen_vertex& b, const irg::screen_vertex& c) {
    const irg::screen_face f = irg::make_screen_face(a, b, c, number++);
    const irg::triangle_setup setup = irg::set_up_face(f);
    irg::covered_spans(f.coverage, {0, 0, width, height}, [&](const irg::span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x)
        if (const float z = irg::depth_at(setup, x, s.y); nearest(x, s.y) < z)
          nearest(x, s.y) = z, ids(x, s.y) = f.number;
    });
  };
  for (int i = 0; i + 1 < h.n; ++i)
    for (int j = 0; j + 1 < h.n; ++j) {
      draw(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
      draw(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
    }
}

using times = std::map<int, double>;

void enter_size(int n, std::map<std::string, times>& all) {
  auto& h = keep_lazy([n] { return hills(n); });
  const contest what{"horizon", std::to_string(n) + " x " + std::to_string(n), "sample", std::int64_t{n} * n};
  const auto add = [&](const std::string& who, auto work, auto judge, bool same) {
    times& of = all[who];
    contender c;
    c.name = who;
    c.seconds = [&h, &of, n, work] {
      static_cast<void>(*h);  // made before the clock starts
      const auto begin = std::chrono::steady_clock::now();
      work();
      const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      const auto at = of.emplace(n, s);
      if (s < at.first->second) at.first->second = s;
      return s;
    };
    c.judge = [&of, n, judge] {
      errors e;
      judge(e);
      const auto here = of.find(n);
      if (here != of.end() && here != of.begin()) {
        const auto before = std::prev(here);
        e.more.push_back({"growth", std::log(here->second / before->second) /
                                        std::log(static_cast<double>(n) * n / (1.0 * before->first * before->first))});
      }
      return e;
    };
    c.same_work = same;
    enter(what, std::move(c));
  };
  auto& horizon = keep(irg::floating_horizon<>(0));
  auto& lines = keep(std::int64_t{0});
  add(
      "irg",
      [&h, &horizon, &lines, n] {
        horizon = irg::floating_horizon<>(irg::horizon_width(view_of(n)));
        lines = 0;
        irg::draw_horizon_surface(horizon, *h, view_of(n),
                                  [&](const irg::cell&, const irg::cell&, irg::horizon_side) { ++lines; });
      },
      [&h, &horizon, &lines, n](errors& e) {
        e.wrong = wrong_columns(horizon, *h, view_of(n));
        if (e.wrong != 0) e.broken = "a horizon is not the extreme of all samples";
        e.more.push_back({"lines", static_cast<double>(lines)});
      },
      true);
  auto& counts = keep(irg::horizon_line_counts());
  add(
      "irg:vectors",
      [&h, &counts, n] {
        const auto curves = irg::horizon_curves_of(*h, view_of(n));
        counts = irg::visible_curves(curves.points, [](const irg::edge_part&) {});
      },
      [&counts](errors& e) {
        e.more.push_back({"parts", static_cast<double>(counts.parts)});
        e.more.push_back({"pieces", static_cast<double>(counts.pieces)});
      },
      true);
  auto& done = keep(irg::grid_surface_counts());
  add(
      "irg:perimeter",
      [&h, &done] {
        done = irg::visible_grid_edges((*h).surface(), {-1.2, 1.4, -1.7}, [](const irg::grid_edge_part&) {}).value;
      },
      [&done](errors& e) {
        e.more.push_back({"parts", static_cast<double>(done.parts)});
        e.more.push_back({"steps", static_cast<double>(done.steps)});
      },
      true);
  auto& picture = keep(irg::image<irg::rgba8>(width, height));
  add("painter as gnuplot's", [&h, &picture] { paint_facets(*h, picture); }, [](errors&) {}, false);
  auto& depths = keep(irg::image<float>(width, height));
  auto& ids = keep(irg::image<std::uint32_t>(width, height));
  add("z-buffer", [&h, &depths, &ids] { fill_depths(*h, depths, ids); }, [](errors&) {}, false);
}

}  // namespace

int main(int argc, char** argv) {
  auto& all = keep(std::map<std::string, times>());
  for (const int n : {50, 100, 200, 500, 1000, 2000})
    if (!smoke() || n <= 50) enter_size(n, all);
  return run_benchmarks(argc, argv);
}
