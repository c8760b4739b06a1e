// SPDX-License-Identifier: MIT
// The centre of gravity of a polygon's area: run time against error, about the origin, far from it, and of slivers.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <irg/geometry/polygon_centroid.hpp>

#include "accuracy/vector_sets.hpp"

#ifdef IRG_HAVE_BOOST
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using point2 = irg::point<double, 2>;
constexpr std::size_t corners = 8;
using polygon = std::array<point2, corners>;
struct set {
  std::string name;
  std::vector<polygon> polygons;
};

// Star-shaped about its middle, which lies `away` from the origin; `width` times as high as wide.
polygon make_polygon(bench::random_numbers& r, double away, double width, double size) {
  polygon p;
  for (std::size_t k = 0; k < corners; ++k) {
    const double turn = (static_cast<double>(k) + 0.8 * r.unit()) * 6.283185307179586 / corners;
    const double radius = size * r.between(0.3, 1);
    p[k] = {away + radius * std::cos(turn), away + width * radius * std::sin(turn)};
  }
  return p;
}

std::vector<set> make_sets() {
  struct kind {
    const char* name;
    double away, width, size;
  };
  std::vector<set> all;
  for (const kind& k : {kind{"about the origin", 0, 1, 1},
                        {"10^3 away", 1e3, 1, 1},
                        {"10^8 away", 1e8, 1, 1},
                        {"10^-6 wide and 10^3 away", 1e3, 1e-6, 1},
                        {"of size 2^200", 0, 1, 0x1p200},
                        {"of size 2^-400", 0, 1, 0x1p-400}}) {
    bench::random_numbers r(23);
    set s{k.name, {}};
    for (int i = 0; i < (bench::smoke() ? 16 : 1024); ++i)
      s.polygons.push_back(make_polygon(r, k.away, k.width, k.size));
    all.push_back(s);
  }
  return all;
}

void add_true_centre(const polygon& p, bench::exact_results& exact) {
  real x, y, area;
  for (std::size_t i = 0; i < corners; ++i) {
    const point2 &a = p[i], &b = p[(i + 1) % corners];
    const real part = real(a.x) * real(b.y) - real(b.x) * real(a.y);
    x = x + (real(a.x) + real(b.x)) * part;
    y = y + (real(a.y) + real(b.y)) * part;
    area = area + real(3) * part;
  }
  exact.push_back((x / area).result());
  exact.push_back((y / area).result());
}

point2 or_nan(const std::optional<point2>& p) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return p ? *p : point2{nan, nan};
}

// As the formula stands in books.
point2 shoelace(const polygon& p) {
  double x = 0, y = 0, area = 0;
  for (std::size_t i = 0; i < corners; ++i) {
    const point2 &a = p[i], &b = p[(i + 1) % corners];
    const double part = a.x * b.y - b.x * a.y;
    x += (a.x + b.x) * part;
    y += (a.y + b.y) * part;
    area += 3 * part;
  }
  return {x / area, y / area};
}

}  // namespace

int main(int argc, char** argv) {
  const bench::study s("centroid of a polygon", "polygon of 8 corners", bench::error_unit::ulp);
  for (const auto& one : bench::keep(make_sets())) {
    const auto& items = one.polygons;
    const bench::distribution d{one.name, items.size(), 2, bench::exact_for(items, add_true_centre)};
    std::vector<bench::implementation> who{
        bench::for_each_vector<2>("irg", items, [](const auto& p) { return or_nan(irg::polygon_centroid(p)); }),
        bench::for_each_vector<2>("irg: polygon_centroid_fast", items,
                                  [](const auto& p) { return or_nan(irg::polygon_centroid_fast(p)); }),
        bench::for_each_vector<2>("shoelace in double", items, shoelace)};
#ifdef IRG_HAVE_BOOST
    namespace geometry = boost::geometry;
    using place = geometry::model::d2::point_xy<double>;
    const auto to_ring = [](const polygon& p) {
      geometry::model::ring<place, false, false> ring;
      for (const point2& q : p) ring.push_back(place(q.x, q.y));
      return ring;
    };
    std::vector<decltype(to_ring(items[0]))> made;
    for (const polygon& p : items) made.push_back(to_ring(p));
    who.push_back(bench::for_each_vector<2>("Boost.Geometry", bench::keep(std::move(made)), [](const auto& ring) {
      place centre(0, 0);
      geometry::centroid(ring, centre);
      return std::array<double, 2>{centre.x(), centre.y()};
    }));
#endif
    s.panel(d, who, bench::text_of_items(items));
  }
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_centroid: skipped, MPFR was not found"); }
#endif
