// SPDX-License-Identifier: MIT
// Points of rational B-splines: a cubic curve of 100 control points, a bicubic surface of 20 by 20, degree and knots
// alike for all. Errors in 2^-53 for control points within 1, against de Boor's algorithm in twice the precision.
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <irg/curve/bspline.hpp>
#include <irg/curve/bspline_surface.hpp>
#include <irg/math/double_double.hpp>

#include "../tests/support/random.hpp"
#include "support/measure.hpp"

#if defined(IRG_HAVE_OCCT)
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#endif

namespace {

using point = irg::point<double, 3>;
using hpoint = irg::hpoint<double, 3>;
using wide = irg::double_double;

struct work {
  std::size_t rows = 1, columns = 1;  // a curve has one row
  std::vector<point> points{}, found{};
  std::vector<hpoint> homogeneous{};
  std::vector<double> weights{}, knots_u{}, knots_v{};
  std::vector<irg::vec<double, 2>> places{};
  irg::bspline_surface<hpoint, 3> surface() const {
    return {irg::bspline_knots<double, 3>(knots_u), irg::bspline_knots<double, 3>(knots_v), {homogeneous, columns}};
  }
};

std::vector<double> uniform_knots(std::size_t count) {
  std::vector<double> u(4, 0);
  for (std::size_t i = 1; i + 3 < count; ++i) u.push_back(static_cast<double>(i));
  u.resize(count + 4, static_cast<double>(count) - 3);
  return u;
}

work make(std::size_t rows, std::size_t columns, int count) {
  work w;
  w.rows = rows;
  w.columns = columns;
  test::random r(23);
  for (std::size_t k = 0; k < rows * columns; ++k) {
    w.points.push_back({2 * r.unit() - 1, 2 * r.unit() - 1, 2 * r.unit() - 1});
    w.weights.push_back(0.5 + r.unit());
    w.homogeneous.push_back(irg::to_homogeneous(w.points[k], w.weights[k]));
  }
  w.knots_u = uniform_knots(rows > 1 ? rows : 4);
  w.knots_v = uniform_knots(columns);
  for (int k = 0; k < count; ++k) w.places.push_back({w.knots_u.back() * r.unit(), w.knots_v.back() * r.unit()});
  w.found.resize(w.places.size());
  return w;
}

// The four basis functions at t, in twice the precision.
std::array<wide, 4> basis_at(const std::vector<double>& u, std::size_t low, double t) {
  std::array<wide, 4> b{wide(1)};
  for (std::size_t k = 1; k < 4; ++k) {
    wide carried(0);
    for (std::size_t i = 0; i < k; ++i) {
      const wide from(u[low + 1 + i - k]), to(u[low + 1 + i]);
      const wide part = b[i] / (to - from);
      b[i] = carried + (to - wide(t)) * part;
      carried = (wide(t) - from) * part;
    }
    b[k] = carried;
  }
  return b;
}
std::size_t stretch(const std::vector<double>& u, double t) {
  std::size_t low = 3;
  while (low + 5 < u.size() && u[low + 1] <= t) ++low;
  return low;
}

void enter_case(const std::string& name, std::size_t rows, std::size_t columns) {
  const int count = bench::smoke() ? 20 : 4096;
  work& w = bench::keep(make(rows, columns, count));
  auto& truth = bench::keep_lazy([&w] {
    auto all = std::make_unique<std::vector<std::array<wide, 3>>>();
    for (const auto& at : w.places) {
      const std::size_t i0 = w.rows > 1 ? stretch(w.knots_u, at.x) - 3 : 0, j0 = stretch(w.knots_v, at.y) - 3;
      const auto bu = w.rows > 1 ? basis_at(w.knots_u, i0 + 3, at.x) : std::array<wide, 4>{wide(1)};
      const auto bv = basis_at(w.knots_v, j0 + 3, at.y);
      std::array<wide, 3> sum{};
      wide weight(0);
      for (std::size_t i = 0; i < (w.rows > 1 ? 4u : 1u); ++i)
        for (std::size_t j = 0; j < 4; ++j) {
          const std::size_t k = (i0 + i) * w.columns + j0 + j;
          const wide part = bu[i] * bv[j] * wide(w.weights[k]);
          weight = weight + part;
          for (int axis = 0; axis < 3; ++axis)
            sum[static_cast<std::size_t>(axis)] = sum[static_cast<std::size_t>(axis)] + part * wide(w.points[k][axis]);
        }
      for (wide& s : sum) s = s / weight;
      all->push_back(sum);
    }
    return all;
  });
  const bench::contest what{"NURBS points", name + bench::build_suffix(), "point", count, "u", ""};
  const auto enter = [&](const std::string& who, auto one) {
    bench::contender c{who, [&w, one] {
                         for (std::size_t k = 0; k < w.places.size(); ++k) w.found[k] = one(w, w.places[k]);
                       }};
    c.judge = [&w, &truth] {
      bench::errors e;
      e.max = e.mean = e.wrong = 0;
      for (std::size_t k = 0; k < w.found.size(); ++k)
        for (int i = 0; i < 3; ++i) {
          const double off = std::fabs((wide(w.found[k][i]) - (**truth)[k][static_cast<std::size_t>(i)]).high) * 0x1p53;
          e.max = std::fmax(e.max, off);
          e.mean += off / static_cast<double>(3 * w.found.size());
        }
      return e;
    };
    bench::enter(what, std::move(c));
  };
  if (rows == 1) {
    const irg::bspline_knots<double, 3> knots(w.knots_v);
    enter("irg", [knots](const work& v, const auto& at) { return *irg::nurbs_point(knots, v.homogeneous, at.y); });
    enter("irg:weights apart",
          [knots](const work& v, const auto& at) { return *irg::nurbs_point(knots, v.points, v.weights, at.y); });
  } else {
    const auto surface = w.surface();
    enter("irg", [surface](const work&, const auto& at) { return *irg::nurbs_surface_point(surface, at.x, at.y); });
    enter("irg:with derivatives",
          [surface](const work&, const auto& at) { return irg::nurbs_surface_sample(surface, at.x, at.y)->point; });
  }
#if defined(IRG_HAVE_OCCT)
  const auto list = [](const std::vector<double>& u, TColStd_Array1OfReal& values, TColStd_Array1OfInteger& times) {
    for (int i = 1; i <= values.Length(); ++i) {
      values.SetValue(i, u[static_cast<std::size_t>(i + 2)]);
      times.SetValue(i, i == 1 || i == values.Length() ? 4 : 1);
    }
  };
  const auto as_int = [](std::size_t n) { return static_cast<int>(n); };
  TColStd_Array1OfReal values_v(1, as_int(columns) - 2);
  TColStd_Array1OfInteger times_v(1, as_int(columns) - 2);
  list(w.knots_v, values_v, times_v);
  const auto to_point = [](const gp_Pnt& p) { return point{p.X(), p.Y(), p.Z()}; };
  if (rows == 1) {
    TColgp_Array1OfPnt poles(1, as_int(columns));
    TColStd_Array1OfReal weights(1, as_int(columns));
    for (std::size_t k = 0; k < columns; ++k) {
      poles.SetValue(as_int(k) + 1, gp_Pnt(w.points[k].x, w.points[k].y, w.points[k].z));
      weights.SetValue(as_int(k) + 1, w.weights[k]);
    }
    const Handle(Geom_BSplineCurve) peer = new Geom_BSplineCurve(poles, weights, values_v, times_v, 3);
    enter("Open CASCADE", [peer, to_point](const work&, const auto& at) {
      gp_Pnt p;
      peer->D0(at.y, p);
      return to_point(p);
    });
    auto& cached = bench::keep(GeomAdaptor_Curve(peer));
    enter("Open CASCADE:cached", [&cached, to_point](const work&, const auto& at) {
      gp_Pnt p;
      cached.D0(at.y, p);
      return to_point(p);
    });
    return;
  }
  TColStd_Array1OfReal values_u(1, as_int(rows) - 2);
  TColStd_Array1OfInteger times_u(1, as_int(rows) - 2);
  list(w.knots_u, values_u, times_u);
  TColgp_Array2OfPnt poles(1, as_int(rows), 1, as_int(columns));
  TColStd_Array2OfReal weights(1, as_int(rows), 1, as_int(columns));
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      const point& p = w.points[i * columns + j];
      poles.SetValue(as_int(i) + 1, as_int(j) + 1, gp_Pnt(p.x, p.y, p.z));
      weights.SetValue(as_int(i) + 1, as_int(j) + 1, w.weights[i * columns + j]);
    }
  const Handle(Geom_BSplineSurface) peer =
      new Geom_BSplineSurface(poles, weights, values_u, values_v, times_u, times_v, 3, 3);
  enter("Open CASCADE", [peer, to_point](const work&, const auto& at) {
    gp_Pnt p;
    peer->D0(at.x, at.y, p);
    return to_point(p);
  });
  auto& cached = bench::keep(GeomAdaptor_Surface(peer));
  enter("Open CASCADE:cached", [&cached, to_point](const work&, const auto& at) {
    gp_Pnt p;
    cached.D0(at.x, at.y, p);
    return to_point(p);
  });
#endif
}

}  // namespace

int main(int argc, char** argv) {
  enter_case("cubic curve of 100", 1, 100);
  enter_case("bicubic surface of 20 by 20", 20, 20);
  return bench::run_benchmarks(argc, argv);
}
