// SPDX-License-Identifier: MIT
// The error bounds of geometric functions where coordinates are of all sizes: each a random number times 2^k, k from
// the whole range of exponents, or one coordinate far below or above the others.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <irg/geometry/textbook/polygon.hpp>
#include <irg/geometry/textbook/intersect_planes.hpp>
#include <irg/geometry/barycentric.hpp>
#include <irg/geometry/textbook/barycentric.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/geometry/clip_line_cyrus_beck.hpp>
#include <irg/geometry/closest_point.hpp>
#include <irg/geometry/distance.hpp>
#include <irg/geometry/edge_equation.hpp>
#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/geometry/intersect_planes.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/line.hpp>
#include <irg/geometry/line_forms.hpp>
#include <irg/geometry/parametric_line.hpp>
#include <irg/geometry/parametric_plane.hpp>
#include <irg/geometry/plane_by_inversion.hpp>
#include <irg/geometry/plane_through_points.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/geometry/polygon_area.hpp>
#include <irg/geometry/polygon_centroid.hpp>
#include <irg/geometry/sphere.hpp>
#include <irg/geometry/split_polygon.hpp>
#include <irg/geometry/triangle_area.hpp>

#include "geometry/exact_quotients.hpp"
#include "geometry/nearest_cases.hpp"
#include "support/mixed_magnitudes.hpp"

#ifdef IRG_HAVE_MPFR

namespace {

using irg::point;
using irg::vec;
using E = test::big_rational;
using test::dot;
using test::error_in_ulp;
using test::exactly;
using test::place;
using test::operator-;

using test::mixed::number;
using test::mixed::sizes;
using test::mixed::sweep;
using test::quotients::of;
using test::quotients::quotient_error;
using test::quotients::root_error;

constexpr double wrong = 1e9;

template <class T>
std::string named(const char* what) {
  return std::string(what) + (sizeof(T) == 4 ? ", float" : ", double");
}

// Points of mixed sizes; some share coordinates, of some the last is near the line through the first two.
template <class T, int N, std::size_t Count>
std::array<point<T, N>, Count> points(test::random& r, sizes which) {
  std::array<point<T, N>, Count> p{};
  const auto kind = r.integer(0, 3);
  for (std::size_t i = 0; i < Count; ++i)
    for (int k = 0; k < N; ++k)
      p[i][k] = kind == 1 && i > 0 && r.integer(0, 2) == 0 ? p[i - 1][k] : number<T>(r, which);
  if (kind == 2 && Count > 2) {
    const T t = static_cast<T>(3 * r.unit() - 1);
    for (int k = 0; k < N; ++k) {
      const T near = p[0][k] + (p[1][k] - p[0][k]) * t;
      if (std::isfinite(near)) p[Count - 1][k] = near;
    }
  }
  return p;
}

template <std::size_t D>
E gram(const place<D>& u, const place<D>& v) {
  return dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
}

template <class T>
E twice_area(const point<T, 2>& a, const point<T, 2>& b, const point<T, 2>& c) {
  return of(a.x) * (of(b.y) - of(c.y)) + of(b.x) * (of(c.y) - of(a.y)) + of(c.x) * (of(a.y) - of(b.y));
}

template <class T>
int sign_of(T x) {
  return (x > 0) - (x < 0);
}

template <class T>
double off_from_area(T got, const E& twice) {
  const bool no_sign = got == 0 && abs(twice) < of(std::numeric_limits<T>::denorm_min()) * 4;
  if (!no_sign && sign_of(got) != twice.sign()) return wrong;
  return error_in_ulp(got, twice.times_power_of_two(-1));
}

}  // namespace

TEST_CASE_TEMPLATE("mixed magnitudes: areas of triangles", T, double, float) {
  // 1.1 ulp, and 1.6 where subnormal, as a share of the bound.
  const auto share = [](T got, const E& twice) {
    const bool is_subnormal = std::fabs(got) < std::numeric_limits<T>::min();
    return off_from_area(got, twice) / (is_subnormal ? 1.6 : 1.1);
  };
  sweep(
      named<T>("signed_triangle_area, of its bound"), 1,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 2, 3>(r, which);
        return share(signed_triangle_area(p[0], p[1], p[2]), twice_area(p[0], p[1], p[2]));
      },
      3000);
  sweep(
      named<T>("triangle_area in the plane, of its bound"), 1,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 2, 3>(r, which);
        return share(triangle_area(p[0], p[1], p[2]), abs(twice_area(p[0], p[1], p[2])));
      },
      3000);
  sweep(
      named<T>("triangle_area in space"), 2,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 3>(r, which);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]);
        return root_error(triangle_area(p[0], p[1], p[2]), gram(b - a, c - a), E(4));
      },
      3000);
  sweep(
      named<T>("triangle_area_from_sides"), 6,
      [&](test::random& r, sizes which) {
        T a = std::fabs(number<T>(r, which)), b = r.integer(0, 2) == 0 ? a : std::fabs(number<T>(r, which));
        T c = r.integer(0, 1) == 0 ? a + b : std::fabs(number<T>(r, which));
        if (r.integer(0, 1) == 0) c = std::nextafter(c, T(0));
        if (r.integer(0, 1) == 0) std::swap(a, c);
        if (!std::isfinite(a) || !std::isfinite(c)) return 0.0;
        const auto got = irg::triangle_area_from_sides(a, b, c);
        const E x = of(a), y = of(b), z = of(c);
        const bool exists = !(x + y < z || y + z < x || z + x < y);
        if (exists != got.has_value()) return wrong;
        if (!got) return 0.0;
        return root_error(*got, (x + y + z) * (x + y - z) * (x - y + z) * (y + z - x), E(16));
      },
      3000);
}

namespace {

template <class T>
std::vector<point<T, 2>> any_ring(test::random& r, sizes which) {
  const auto p = points<T, 2, 6>(r, which);
  return {p.begin(), p.begin() + r.integer(3, 6)};
}
template <class T>
const point<T, 2>& after(const std::vector<point<T, 2>>& ring, std::size_t i) {
  return ring[(i + 1) % ring.size()];
}
template <class T>
E twice_area(const std::vector<point<T, 2>>& ring) {
  E twice = 0;  // by trapezia
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto &p = ring[i], &q = after(ring, i);
    twice = twice + (of(p.x) - of(q.x)) * (of(p.y) + of(q.y));
  }
  return twice;
}

}  // namespace

TEST_CASE_TEMPLATE("mixed magnitudes: areas of polygons", T, double, float) {
  sweep(
      named<T>("polygon_area"), 0.51,
      [&](test::random& r, sizes which) {
        const auto ring = any_ring<T>(r, which);
        return error_in_ulp(irg::polygon_area(ring), twice_area(ring).times_power_of_two(-1));
      },
      2000);
  sweep(
      named<T>("polygon_area_exact"), 0,
      [&](test::random& r, sizes which) {
        const auto ring = any_ring<T>(r, which);
        return irg::polygon_area_exact(ring) == test::nearest<T>(twice_area(ring).times_power_of_two(-1)) ? 0.0 : wrong;
      },
      2000);
  sweep(
      named<T>("polygon_centroid"), 0.52,
      [&](test::random& r, sizes which) {
        const auto ring = any_ring<T>(r, which);
        const E twice = twice_area(ring);
        const auto got = irg::polygon_centroid(ring);
        if (got.has_value() != (twice.sign() != 0)) return wrong;
        if (!got) return 0.0;
        E moment[2] = {0, 0};
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto &p = ring[i], &q = after(ring, i);
          const E dx = of(p.x) - of(q.x), dy = of(q.y) - of(p.y);
          moment[0] = moment[0] + dy * (of(p.x) * of(p.x) + of(p.x) * of(q.x) + of(q.x) * of(q.x));
          moment[1] = moment[1] + dx * (of(p.y) * of(p.y) + of(p.y) * of(q.y) + of(q.y) * of(q.y));
        }
        double worst = 0;
        for (int k = 0; k < 2; ++k) {
          worst = std::fmax(worst, quotient_error((*got)[k], moment[k], twice * 3));
        }
        return worst;
      },
      2000);
  test::real sum, x, y;
  sweep(
      named<T>("polygon_perimeter"), 2,
      [&](test::random& r, sizes which) {
        const auto ring = any_ring<T>(r, which);
        mpfr_set_zero(sum, 1);
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto &p = ring[i], &q = after(ring, i);
          if (!std::isfinite(q.x - p.x) || !std::isfinite(q.y - p.y)) return 0.0;
          mpfr_set_d(x, static_cast<double>(q.x), MPFR_RNDN), mpfr_sub_d(x, x, static_cast<double>(p.x), MPFR_RNDN);
          mpfr_set_d(y, static_cast<double>(q.y), MPFR_RNDN), mpfr_sub_d(y, y, static_cast<double>(p.y), MPFR_RNDN);
          mpfr_hypot(x, x, y, MPFR_RNDN);
          mpfr_add(sum, sum, x, MPFR_RNDN);
        }
        return test::ulp_error(irg::polygon_perimeter(ring), sum);
      },
      2000);
}

TEST_CASE_TEMPLATE("mixed magnitudes: edges and boxes", T, double, float) {
  sweep(
      named<T>("edge_through"), 1,
      [](test::random& r, sizes which) {
        const auto p = points<T, 2, 2>(r, which);
        const auto e = irg::edge_through(p[0], p[1]);
        const E c = of(p[0].x) * of(p[1].y) - of(p[1].x) * of(p[0].y);
        if (e.a != test::nearest<T>(of(p[0].y) - of(p[1].y)) || e.b != test::nearest<T>(of(p[1].x) - of(p[0].x)))
          return wrong;
        const bool underflows = abs(c) < of(std::numeric_limits<T>::min());
        return error_in_ulp(e.c, c) - (underflows ? 2 : 0);
      },
      3000);
  sweep(
      named<T>("box: size, centre and sphere"), 2,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 2>(r, which);
        irg::box<T, 3> b;
        for (const auto& q : p) b = bounding_box(b, q);
        const auto s = extent(b);
        const auto middle = centre(b);
        E squared = 0;
        for (int k = 0; k < 3; ++k) {
          const E low = of(b.low[k]), high = of(b.high[k]), half = (low + high).times_power_of_two(-1);
          if (s[k] != test::nearest<T>(high - low)) return wrong;
          if (error_in_ulp(middle[k], half) > 0.5) return wrong;
          const E up = high - of(middle[k]), down = of(middle[k]) - low;
          squared = squared + (up < down ? down * down : up * up);
        }
        return root_error(bounding_sphere_of(b).radius, squared, E(1));
      },
      3000);
}

TEST_CASE_TEMPLATE("mixed magnitudes: barycentric coordinates", T, double, float) {
  using P2 = point<T, 2>;
  // The share of the bound: 2 ulp for subnormal numbers and large ones.
  const auto share = [](T got, const E& area, const E& whole) {
    const double error = quotient_error(got, area, whole), size = std::fabs(static_cast<double>(got));
    const bool is_far = size < static_cast<double>(std::numeric_limits<T>::min()) || size > 0x1p960;
    const bool has_sign = !(abs(area) < abs(whole) * of(std::numeric_limits<T>::denorm_min()));
    if (has_sign && sign_of(got) != area.sign() * whole.sign()) return wrong;
    return error / (is_far ? 2 : sizeof(T) == 4 ? 0.501 : 0.51);
  };
  const auto compare = [&](const std::optional<vec<T, 3>>& got, const P2& a, const P2& b, const P2& c, const P2& t) {
    const E whole = twice_area(a, b, c);
    if (got.has_value() != (whole.sign() != 0)) return wrong;
    if (!got) return 0.0;
    const double first = share(got->x, twice_area(t, b, c), whole), second = share(got->y, twice_area(a, t, c), whole);
    return std::fmax(first, std::fmax(second, share(got->z, twice_area(a, b, t), whole)));
  };
  sweep(
      named<T>("barycentric, of its bound"), 1,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 2, 4>(r, which);
        return compare(barycentric(p[0], p[1], p[2], p[3]), p[0], p[1], p[2], p[3]);
      },
      2000);
  sweep(
      named<T>("barycentric in space, of its bound"), 1,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        P2 seen[3][4];
        E size[3];
        int best = 0;
        for (int k = 0; k < 3; ++k) {
          for (std::size_t i = 0; i < 4; ++i) seen[k][i] = {p[i][(k + 1) % 3], p[i][(k + 2) % 3]};
          size[k] = abs(twice_area(seen[k][0], seen[k][1], seen[k][2]));
          if (size[best] < size[k]) best = k;
        }
        if (widest_view(p[0], p[1], p[2]) != (size[best].sign() == 0 ? std::nullopt : std::optional(best)))
          return wrong;
        const P2* s = seen[best];
        if (irg::textbook::barycentric_replaced(p[0], p[1], p[2], p[3], best) != barycentric(p[0], p[1], p[2], p[3]))
          return wrong;
        return compare(barycentric(p[0], p[1], p[2], p[3]), s[0], s[1], s[2], s[3]);
      },
      2000);
}

namespace {

template <class T, std::size_t N>
std::array<E, N> rationals(const std::array<T, N>& x) {
  std::array<E, N> e;
  for (std::size_t i = 0; i < N; ++i) e[i] = of(x[i]);
  return e;
}

// The error of coefficients that may all be multiplied by one power of two, where the largest one is beyond the range
// or the largest of the first `leading` so small that digits are lost.
template <class T, std::size_t N>
double error_together(const std::array<T, N>& got, const std::array<E, N>& want, std::size_t leading) {
  std::size_t most = 0, lead = 0;
  for (std::size_t i = 0; i < N; ++i) {
    if (!std::isfinite(got[i])) return wrong;
    if (abs(want[most]) < abs(want[i])) most = i;
    if (i < leading && abs(want[lead]) < abs(want[i])) lead = i;
  }
  const test::quotients::near_number exact(want[most]), rounded(of(got[most]));
  if (rounded.value == 0) return wrong;
  int shift = rounded.exponent - exact.exponent;
  const double ratio = rounded.value / exact.value;
  if (ratio > 1.5) ++shift;
  if (ratio < 0.75) --shift;
  const int high = std::numeric_limits<T>::max_exponent - 5;
  const int low = std::numeric_limits<T>::min_exponent + std::numeric_limits<T>::digits + 2;
  if (shift != 0 && exact.exponent < high && want[lead].exponent() > low) return wrong;
  double worst = 0;
  for (std::size_t i = 0; i < N; ++i) worst = std::fmax(worst, error_in_ulp(got[i], want[i].times_power_of_two(shift)));
  return worst;
}

template <std::size_t N>
bool all_zero(const std::array<E, N>& x) {
  for (const E& v : x)
    if (v.sign() != 0) return false;
  return true;
}

template <class T, std::size_t N>
std::array<T, N> numbers(test::random& r, sizes which) {
  std::array<T, N> x{};
  for (T& v : x) v = number<T>(r, which);
  return x;
}

// The cross product as the minors of two rows.
std::array<E, 3> minors(const std::array<E, 3>& a, const std::array<E, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
E determinant(const std::array<E, 3>& a, const std::array<E, 3>& b, const std::array<E, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]);
}

}  // namespace

TEST_CASE_TEMPLATE("mixed magnitudes: lines of the plane", T, double, float) {
  using line = irg::line<T>;
  const auto off = [](const std::optional<line>& got, const std::array<E, 3>& want) {
    if (got.has_value() == all_zero(want)) return wrong;
    return got ? error_together<T, 3>({got->a, got->b, got->c}, want, 3) : 0.0;
  };
  sweep(
      named<T>("line_through"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 2, 2>(r, which);
        return off(line_through(p[0], p[1]), minors({of(p[0].x), of(p[0].y), E(1)}, {of(p[1].x), of(p[1].y), E(1)}));
      },
      3000);
  sweep(
      named<T>("line_through and intersection_point, homogeneous"), 0.501,
      [&](test::random& r, sizes which) {
        auto c = numbers<T, 6>(r, which);
        if (r.integer(0, 3) == 0) c[4] = c[1], c[3] = c[0];
        const irg::hpoint<T, 2> p{c[0], c[1], c[2]}, q{c[3], c[4], c[5]};
        const auto e = rationals(c);
        const auto want = minors({e[0], e[1], e[2]}, {e[3], e[4], e[5]});
        const auto common = intersection_point(line{c[0], c[1], c[2]}, line{c[3], c[4], c[5]});
        const auto as_line = common ? std::optional(line{common->x, common->y, common->z}) : std::nullopt;
        return std::fmax(off(line_through(p, q), want), off(as_line, want));
      },
      3000);
  sweep(
      named<T>("implicit_line_of"), 0.501,
      [&](test::random& r, sizes which) {
        const auto c = numbers<T, 4>(r, which);
        const auto e = rationals(c);
        return off(implicit_line_of(irg::parametric_line<T, 2>{{c[0], c[1]}, {c[2], c[3]}}),
                   minors({e[0], e[1], E(1)}, {e[2], e[3], E(0)}));
      },
      3000);
  sweep(
      named<T>("parametric_line_of"), 0.5,
      [&](test::random& r, sizes which) {
        const auto c = numbers<T, 3>(r, which);
        const auto e = rationals(c);
        const auto got = parametric_line_of(line{c[0], c[1], c[2]});
        if (!got) return c[0] == 0 && c[1] == 0 ? 0.0 : wrong;
        const bool on_y = std::fabs(c[0]) < std::fabs(c[1]);
        return quotient_error(got->origin[on_y ? 1 : 0], -e[2], e[on_y ? 1 : 0]);
      },
      3000);
  sweep(
      named<T>("point_between"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 2, 2>(r, which);
        const T t = r.integer(0, 1) == 0 ? static_cast<T>(r.unit()) : number<T>(r, which);
        const auto got = point_between(p[0], p[1], t);
        const auto along = [&](int k) { return of(p[0][k]) * (E(1) - of(t)) + of(p[1][k]) * of(t); };
        return std::fmax(error_in_ulp(got.x, along(0)), error_in_ulp(got.y, along(1)));
      },
      3000);
}

TEST_CASE_TEMPLATE("mixed magnitudes: planes", T, double, float) {
  using plane = irg::plane<T>;
  const auto off = [](const std::optional<plane>& got, const std::array<E, 4>& want) {
    const bool exists = want[0].sign() != 0 || want[1].sign() != 0 || want[2].sign() != 0;
    if (got.has_value() != exists) return wrong;
    return got ? error_together<T, 4>({got->a, got->b, got->c, got->d}, want, 3) : 0.0;
  };
  // Coefficients as determinants with a row of the matrix left out.
  const auto through = [](const std::array<E, 4>& p, const std::array<E, 4>& q, const std::array<E, 4>& s) {
    const auto without = [&](std::size_t i, std::size_t j, std::size_t k) {
      return determinant({p[i], p[j], p[k]}, {q[i], q[j], q[k]}, {s[i], s[j], s[k]});
    };
    return std::array<E, 4>{without(1, 2, 3), -without(0, 2, 3), without(0, 1, 3), -without(0, 1, 2)};
  };
  sweep(
      named<T>("plane_through_accurate"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 3>(r, which);
        const auto row = [&](std::size_t i) { return std::array<E, 4>{of(p[i].x), of(p[i].y), of(p[i].z), E(1)}; };
        return off(plane_through_accurate(p[0], p[1], p[2]), through(row(0), row(1), row(2)));
      },
      3000);
  sweep(
      named<T>("plane_through, homogeneous, and plane_by_inversion"), 0.501,
      [&](test::random& r, sizes which) {
        auto c = numbers<T, 13>(r, which);
        if (r.integer(0, 3) == 0) c[11] = c[7] = c[3] = 1;
        const irg::hpoint<T, 3> p{c[0], c[1], c[2], c[3]}, q{c[4], c[5], c[6], c[7]}, s{c[8], c[9], c[10], c[11]};
        const auto e = rationals(c);
        const auto want = through({e[0], e[1], e[2], e[3]}, {e[4], e[5], e[6], e[7]}, {e[8], e[9], e[10], e[11]});
        const auto inverted = plane_by_inversion(p, q, s, c[12]);
        using irg::inversion_status;
        const bool collinear = want[0].sign() == 0 && want[1].sign() == 0 && want[2].sign() == 0;
        const auto outcome = c[12] == 0            ? inversion_status::invalid
                             : want[3].sign() != 0 ? inversion_status::ok
                             : collinear           ? inversion_status::collinear
                                                   : inversion_status::through_origin;
        if (inverted.status != outcome) return wrong;
        double worst = off(plane_through(p, q, s), want);
        if (outcome != inversion_status::ok) return worst;
        const T got[3] = {inverted.value.a, inverted.value.b, inverted.value.c};
        for (std::size_t k = 0; k < 3; ++k) worst = std::fmax(worst, quotient_error(got[k], want[k] * e[12], want[3]));
        return inverted.value.d == c[12] ? worst : wrong;
      },
      3000);
  sweep(
      named<T>("plane_at"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 2>(r, which);
        const auto got = plane_at(p[0], to_vec(p[1]));
        const E d = -dot(exactly(p[0]), exactly(p[1]));
        if (!got) return p[1] == point<T, 3>{0, 0, 0} ? 0.0 : wrong;
        return got->a == p[1].x && got->b == p[1].y && got->c == p[1].z ? error_in_ulp(got->d, d) : wrong;
      },
      3000);
  sweep(
      named<T>("implicit_plane_of and parameters_of"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const irg::parametric_plane<T> given{to_vec(p[0]), to_vec(p[1]), p[2]};
        const auto u = exactly(p[0]), v = exactly(p[1]), o = exactly(p[2]), w = exactly(p[3]) - o;
        const auto n = minors(u, v);
        const double worst = off(implicit_plane_of(given), {n[0], n[1], n[2], -determinant(u, v, o)});
        const auto at = parameters_of(given, p[3]);
        const E whole = gram(u, v);
        if (at.has_value() != (whole.sign() != 0)) return wrong;
        if (!at) return worst;
        const double first = quotient_error(at->s1, dot(u, w) * dot(v, v) - dot(v, w) * dot(u, v), whole);
        const double second = quotient_error(at->s2, dot(v, w) * dot(u, u) - dot(u, w) * dot(u, v), whole);
        return std::fmax(worst, std::fmax(first, second));
      },
      1500);
}

namespace {

// A number p/q, q > 0, in no lowest terms.
struct quotient {
  E p = 0, q = 1;
};
bool operator<(const quotient& a, const quotient& b) { return a.p * b.q < b.p * a.q; }

// The nearest point of a segment to p: its parameter, cut off at the ends, and the squared distance.
template <std::size_t D>
struct segment_foot {
  quotient t, squared;
  segment_foot(const place<D>& a, const place<D>& b, const place<D>& p) {
    const auto u = b - a, w = p - a, v = p - b;
    t = {dot(u, w), dot(u, u)};
    if (t.p.sign() <= 0)
      t = {E(0), E(1)}, squared = {dot(w, w), E(1)};
    else if (!(t.p < t.q))
      t = {E(1), E(1)}, squared = {dot(v, v), E(1)};
    else
      squared = {gram(u, w), t.q};
  }
};
// The point at t between a and b.
template <class T, int N>
double off_between(const point<T, N>& got, const point<T, N>& a, const point<T, N>& b, const quotient& t) {
  double worst = 0;
  for (int k = 0; k < N; ++k)
    worst = std::fmax(worst, quotient_error(got[k], of(a[k]) * (t.q - t.p) + of(b[k]) * t.p, t.q));
  return worst;
}

// Squared distance of lines, and the parameters of the nearest points; q is 0 for parallel ones.
struct lines_foot {
  quotient t, s, squared;
  lines_foot(const place<3>& a, const place<3>& b, const place<3>& c, const place<3>& d) {
    const auto u = b - a, v = d - c, w = c - a;
    const E uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w), n = uu * vv - uv * uv;
    const E volume = determinant(u, v, w);
    t = {uw * vv - vw * uv, n}, s = {uw * uv - vw * uu, n}, squared = {volume * volume, n};
  }
  bool is_inside() const {
    return t.q.sign() > 0 && t.p.sign() >= 0 && !(t.q < t.p) && s.p.sign() >= 0 && !(s.q < s.p);
  }
};

template <class T, int N>
quotient squared_distance_of_segments(const std::array<point<T, N>, 4>& p) {
  const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]), d = exactly(p[3]);
  quotient least = segment_foot(c, d, a).squared;
  for (const auto& other : {segment_foot(c, d, b), segment_foot(a, b, c), segment_foot(a, b, d)})
    if (other.squared < least) least = other.squared;
  if constexpr (N == 3) {
    const lines_foot lines(a, b, c, d);
    if (lines.is_inside() && lines.squared < least) least = lines.squared;
  } else {
    const auto turn = [&](std::size_t i, std::size_t j, std::size_t k) { return twice_area(p[i], p[j], p[k]).sign(); };
    if (turn(0, 1, 2) * turn(0, 1, 3) < 0 && turn(2, 3, 0) * turn(2, 3, 1) < 0) least = {E(0), E(1)};
  }
  return least;
}

// The nearest point of a triangle: on its face, or the nearest one of its edges.
struct triangle_nearest {
  std::array<E, 3> weight{};
  E whole = 0;
  quotient squared;
  triangle_nearest(const place<3>& a, const place<3>& b, const place<3>& c, const place<3>& p) {
    const auto u = b - a, v = c - a, w = p - a;
    const E uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
    whole = uu * vv - uv * uv;
    weight[1] = uw * vv - vw * uv, weight[2] = vw * uu - uw * uv, weight[0] = whole - weight[1] - weight[2];
    if (whole.sign() > 0 && weight[0].sign() >= 0 && weight[1].sign() >= 0 && weight[2].sign() >= 0) {
      const E volume = determinant(u, v, w);
      squared = {volume * volume, whole};
      return;
    }
    const place<3>* corner[3] = {&a, &b, &c};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const segment_foot foot(*corner[i], *corner[j], p);
      if (i > 0 && !(foot.squared < squared)) continue;
      squared = foot.squared, whole = foot.t.q;
      weight = {E(0), E(0), E(0)}, weight[j] = foot.t.p, weight[i] = foot.t.q - foot.t.p;
    }
  }
};

}  // namespace

TEST_CASE_TEMPLATE("mixed magnitudes: distances", T, double, float) {
  const auto off = [](const std::optional<T>& got, const quotient& squared) {
    if (got.has_value() == (squared.q.sign() == 0)) return wrong;
    return got ? root_error(*got, squared.p, squared.q) : 0.0;
  };
  const auto of_dimension = [&]<int N>(const char* where, std::integral_constant<int, N>) {
    sweep(
        named<T>("distance of points, to lines and segments") + where, 0.501,
        [&](test::random& r, sizes which) {
          const auto p = points<T, N, 3>(r, which);
          const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]);
          const double apart = off(distance(p[0], p[1]), {dot(b - a, b - a), E(1)});
          const double line = off(distance_to_line(p[0], p[1], p[2]), {gram(b - a, c - a), dot(b - a, b - a)});
          const double segment = off(distance_to_segment(p[0], p[1], p[2]), segment_foot(a, b, c).squared);
          return std::fmax(apart, std::fmax(line, segment));
        },
        1500);
    sweep(
        named<T>("distance_of_segments") + where, 0.501,
        [&](test::random& r, sizes which) {
          const auto p = points<T, N, 4>(r, which);
          return off(distance_of_segments(p[0], p[1], p[2], p[3]), squared_distance_of_segments(p));
        },
        1000);
  };
  of_dimension(" in the plane", std::integral_constant<int, 2>());
  of_dimension(" in space", std::integral_constant<int, 3>());
  sweep(
      named<T>("signed_distance"), 0.501,
      [&](test::random& r, sizes which) {
        const auto c = numbers<T, 7>(r, which);
        const auto e = rationals(c);
        const auto with_sign = [&](const std::optional<T>& got, const E& height, const E& squared) {
          if (got && sign_of(*got) != height.sign() && *got != 0) return wrong;
          return off(got ? std::optional(std::fabs(*got)) : got, {height * height, squared});
        };
        const double line = with_sign(signed_distance(irg::line<T>{c[0], c[1], c[2]}, point<T, 2>{c[3], c[4]}),
                                      e[0] * e[3] + e[1] * e[4] + e[2], e[0] * e[0] + e[1] * e[1]);
        const E height = e[0] * e[4] + e[1] * e[5] + e[2] * e[6] + e[3];
        return std::fmax(
            line, with_sign(signed_distance(irg::plane<T>{c[0], c[1], c[2], c[3]}, point<T, 3>{c[4], c[5], c[6]}),
                            height, e[0] * e[0] + e[1] * e[1] + e[2] * e[2]));
      },
      3000);
  sweep(
      named<T>("distance_to_triangle and distance_of_lines"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]), d = exactly(p[3]);
        const double triangle = off(distance_to_triangle(p[0], p[1], p[2], p[3]), triangle_nearest(a, b, c, d).squared);
        const lines_foot lines(a, b, c, d);
        const auto got = distance_of_lines(p[0], p[1], p[2], p[3]);
        if (p[0] == p[1] || p[2] == p[3]) return got ? wrong : triangle;
        const quotient parallel{gram(b - a, c - a), dot(b - a, b - a)};
        return std::fmax(triangle, off(got, lines.t.q.sign() == 0 ? parallel : lines.squared));
      },
      1000);
}

TEST_CASE_TEMPLATE("mixed magnitudes: nearest points", T, double, float) {
  sweep(
      named<T>("closest_point_on_line and on_segment"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 3>(r, which);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]);
        const auto on_line = closest_point_on_line(p[0], p[1], p[2]);
        const auto on_segment = closest_point_on_segment(p[0], p[1], p[2]);
        const segment_foot foot(a, b, c);
        double worst = off_between(on_segment->at, p[0], p[1], foot.t);
        worst = std::fmax(worst, quotient_error(on_segment->t, foot.t.p, foot.t.q));
        if (foot.t.p.sign() == 0 && !(on_segment->at == p[0])) return wrong;
        if (foot.t.p == foot.t.q && !(on_segment->at == p[1])) return wrong;
        if (p[0] == p[1]) return on_line ? wrong : worst;
        const quotient t{dot(b - a, c - a), dot(b - a, b - a)};
        worst = std::fmax(worst, quotient_error(on_line->t, t.p, t.q));
        return std::fmax(worst, off_between(on_line->at, p[0], p[1], t));
      },
      1000);
  sweep(
      named<T>("closest_point_on_plane"), 0.501,
      [](test::random& r, sizes which) {
        const auto c = numbers<T, 7>(r, which);
        const auto e = rationals(c);
        const auto got = closest_point_on_plane(irg::plane<T>{c[0], c[1], c[2], c[3]}, point<T, 3>{c[4], c[5], c[6]});
        const E squared = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        const E height = e[0] * e[4] + e[1] * e[5] + e[2] * e[6] + e[3];
        if (got.has_value() != (squared.sign() != 0)) return wrong;
        double worst = 0;
        for (std::size_t k = 0; got && k < 3; ++k)
          worst = std::fmax(worst,
                            quotient_error((*got)[static_cast<int>(k)], e[4 + k] * squared - e[k] * height, squared));
        return worst;
      },
      3000);
  sweep(
      named<T>("closest_point_on_triangle"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto got = closest_point_on_triangle(p[0], p[1], p[2], p[3]);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]);
        const triangle_nearest want(a, b, c, exactly(p[3]));
        double worst = 0;
    // A degenerate triangle's weights are not the only ones.
        const bool is_triangle = gram(b - a, c - a).sign() > 0;
        for (std::size_t i = 0; i < 3 && is_triangle; ++i)
          worst = std::fmax(worst, quotient_error(got->weights[i], want.weight[i], want.whole));
        for (int k = 0; k < 3; ++k) {
          const E at = of(p[0][k]) * want.weight[0] + of(p[1][k]) * want.weight[1] + of(p[2][k]) * want.weight[2];
          worst = std::fmax(worst, quotient_error(got->at[k], at, want.whole));
        }
        return worst;
      },
      1000);
  sweep(
      named<T>("closest_points_of_lines"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto got = closest_points_of_lines(p[0], p[1], p[2], p[3]);
        if (p[0] == p[1] || p[2] == p[3]) return got ? wrong : 0.0;
        const lines_foot want(exactly(p[0]), exactly(p[1]), exactly(p[2]), exactly(p[3]));
        if (want.t.q.sign() == 0) return got->first == p[0] ? 0.0 : wrong;
        const double first =
            std::fmax(quotient_error(got->t, want.t.p, want.t.q), off_between(got->first, p[0], p[1], want.t));
        const double second =
            std::fmax(quotient_error(got->s, want.s.p, want.s.q), off_between(got->second, p[2], p[3], want.s));
        return std::fmax(first, second);
      },
      1000);
}

namespace {

// Cramer's rule: column k of the rows replaced by the right side.
E replaced(std::array<std::array<E, 3>, 3> rows, const std::array<E, 3>& right, std::size_t k) {
  for (std::size_t i = 0; i < 3; ++i) rows[i][k] = right[i];
  return determinant(rows[0], rows[1], rows[2]);
}
E replaced(std::array<std::array<E, 2>, 2> rows, const std::array<E, 2>& right, std::size_t k) {
  for (std::size_t i = 0; i < 2; ++i) rows[i][k] = right[i];
  return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
}

// The sphere through points that are not in general position otherwise, by the equations of its centre: 2 (p_i - p_0) x
// = |p_i|^2 - |p_0|^2, and in space for a circle that it lies in the plane of the three.
template <class T, int N, std::size_t Count>
double off_from_sphere(test::random& r, sizes which) {
  constexpr std::size_t D = static_cast<std::size_t>(N);
  const auto p = points<T, N, Count>(r, which);
  const auto got = [&] {
    if constexpr (Count == 2) return sphere_through(p[0], p[1]);
    if constexpr (Count == 3) return sphere_through(p[0], p[1], p[2]);
    if constexpr (Count == 4) return sphere_through(p[0], p[1], p[2], p[3]);
  }();
  const auto o = exactly(p[0]);
  place<D> over;  // the centre times whole
  E whole = 2;
  if constexpr (Count == 2) {
    const auto q = exactly(p[1]);
    for (std::size_t k = 0; k < D; ++k) over[k] = o[k] + q[k];
    if (p[0] == p[1]) whole = 0;
  } else {
    std::array<std::array<E, D>, D> rows;
    std::array<E, D> right, unit{};
    for (std::size_t i = 0; i + 1 < Count; ++i) {
      const auto q = exactly(p[i + 1]);
      for (std::size_t k = 0; k < D; ++k) rows[i][k] = (q[k] - o[k]) * 2;
      right[i] = dot(q, q) - dot(o, o);
    }
    if constexpr (N == 3 && Count == 3) rows[2] = minors(rows[0], rows[1]), right[2] = dot(rows[2], o);
    for (std::size_t i = 0; i < D; ++i) unit[i] = rows[i][0];
    whole = replaced(rows, unit, 0);
    for (std::size_t k = 0; k < D; ++k) over[k] = replaced(rows, right, k);
  }
  if (got.has_value() != (whole.sign() != 0)) return wrong;
  if (!got) return 0;
  double worst = 0;
  place<D> way;
  for (std::size_t k = 0; k < D; ++k) {
    worst = std::fmax(worst, quotient_error(got->centre[static_cast<int>(k)], over[k], whole));
    way[k] = over[k] - o[k] * whole;
  }
  return std::fmax(worst, root_error(got->radius, dot(way, way), whole * whole));
}

}  // namespace

TEST_CASE_TEMPLATE("mixed magnitudes: spheres", T, double, float) {
  sweep(named<T>("sphere_through, 2 points of the plane"), 0.501, off_from_sphere<T, 2, 2>, 1000);
  sweep(named<T>("sphere_through, 3 points of the plane"), 0.501, off_from_sphere<T, 2, 3>, 1000);
  sweep(named<T>("sphere_through, 2 points"), 0.501, off_from_sphere<T, 3, 2>, 1000);
  sweep(named<T>("sphere_through, 3 points"), 0.501, off_from_sphere<T, 3, 3>, 500);
  sweep(named<T>("sphere_through, 4 points"), 0.501, off_from_sphere<T, 3, 4>, 500);
}

TEST_CASE_TEMPLATE("mixed magnitudes: nearest points of segments", T, double, float) {
  // Inside of both segments, or an end and the point nearest to it: an end as near as any, but for 2^-60.
  sweep(
      named<T>("closest_points_of_segments"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto got = closest_points_of_segments(p[0], p[1], p[2], p[3]);
        const quotient least = squared_distance_of_segments(p);
        if (!got) return wrong;
        if (least.p.sign() == 0) return got->first == got->second ? 0.0 : wrong;
        const place<3> e[4] = {exactly(p[0]), exactly(p[1]), exactly(p[2]), exactly(p[3])};
        const lines_foot lines(e[0], e[1], e[2], e[3]);
        const auto off = [&](const quotient& t, const quotient& s) {
          const double first = std::fmax(quotient_error(got->t, t.p, t.q), off_between(got->first, p[0], p[1], t));
          const double second = std::fmax(quotient_error(got->s, s.p, s.q), off_between(got->second, p[2], p[3], s));
          return std::fmax(first, second);
        };
        const quotient enough{least.p * (E(1) + E(0x1p-60)), least.q};
        double best = lines.is_inside() ? off(lines.t, lines.s) : wrong;
        for (std::size_t i = 0; i < 4; ++i) {
          const std::size_t other = i < 2 ? 2 : 0;
          const segment_foot foot(e[other], e[other + 1], e[i]);
          if (enough < foot.squared) continue;
          const quotient end{E(static_cast<int>(i % 2)), E(1)};
          best = std::fmin(best, i < 2 ? off(end, foot.t) : off(foot.t, end));
        }
        return best;
      },
      1000);
}

TEST_CASE_TEMPLATE("mixed magnitudes: intersections", T, double, float) {
  sweep(
      named<T>("intersect_segments"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 2, 4>(r, which);
        const auto got = intersect_segments(p[0], p[1], p[2], p[3]);
        const auto area = [&](std::size_t i, std::size_t j, std::size_t k) { return twice_area(p[i], p[j], p[k]); };
        const E c = area(0, 1, 2), d = area(0, 1, 3), a = area(2, 3, 0), b = area(2, 3, 1);
        if (c == d) return 0.0;  // parallel
        const bool meet = c.sign() * d.sign() <= 0 && a.sign() * b.sign() <= 0;
        if (meet != (got.relation == irg::segment_relation::point)) return wrong;
        if (!meet) return 0.0;
        const quotient t{a, a - b}, s{c, c - d};
        const double parameters = std::fmax(quotient_error(got.t, t.p, t.q), quotient_error(got.s, s.p, s.q));
        return std::fmax(parameters, off_between(got.first, p[0], p[1], t));
      },
      3000);
  sweep(
      named<T>("intersect_plane_line, parametric"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 5>(r, which);
        const place<3> u = exactly(p[0]), v = exactly(p[1]), o = exactly(p[2]), a = exactly(p[3]), w = exactly(p[4]);
        const auto got = intersect_plane_line(irg::parametric_plane<T>{to_vec(p[0]), to_vec(p[1]), p[2]},
                                              irg::parametric_line<T, 3>{p[3], to_vec(p[4])});
        // s1 u + s2 v - t w = a - o
        const std::array<std::array<E, 3>, 3> rows{{{u[0], v[0], w[0]}, {u[1], v[1], w[1]}, {u[2], v[2], w[2]}}};
        const E whole = determinant(rows[0], rows[1], rows[2]);
        using irg::flat_relation;
        if ((got.relation == flat_relation::crossing) != (whole.sign() != 0)) return wrong;
        if (whole.sign() == 0) return 0.0;
        const E t = -replaced(rows, a - o, 2);
        const double first = quotient_error(got.s1, replaced(rows, a - o, 0), whole);
        const double second = quotient_error(got.s2, replaced(rows, a - o, 1), whole);
        double worst = std::fmax(std::fmax(first, second), quotient_error(got.t, t, whole));
        for (std::size_t k = 0; k < 3; ++k)
          worst = std::fmax(worst, quotient_error(got.at[static_cast<int>(k)], a[k] * whole + w[k] * t, whole));
        return worst;
      },
      1000);
  sweep(
      named<T>("intersect_planes, the line"), 0.501,
      [](test::random& r, sizes which) {
        auto c = numbers<T, 8>(r, which);
        if (r.integer(0, 2) == 0) c[4] = c[0], c[5] = c[1];
        const auto e = rationals(c);
        const std::array<E, 3> n{e[0], e[1], e[2]}, m{e[4], e[5], e[6]}, u = minors(n, m);
        const auto got = intersect_planes(irg::plane<T>{c[0], c[1], c[2], c[3]}, irg::plane<T>{c[4], c[5], c[6], c[7]});
        if ((got.relation == irg::flat_relation::crossing) != !all_zero(u)) return wrong;
        if (all_zero(u)) return 0.0;
        const auto& along = got.line.direction;
        double worst = error_together<T, 3>({along.x, along.y, along.z}, u, 3);
        const E whole = determinant(n, m, u);
        const std::array<std::array<E, 3>, 3> rows{{n, m, u}};
        for (std::size_t k = 0; k < 3; ++k) {
          const E over = replaced(rows, {-e[3], -e[7], E(0)}, k);
          worst = std::fmax(worst, quotient_error(got.line.origin[static_cast<int>(k)], over, whole));
        }
        return worst;
      },
      1000);
  sweep(
      named<T>("textbook::intersect_planes"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 6>(r, which);
        place<3> e[6];
        for (std::size_t i = 0; i < 6; ++i) e[i] = exactly(p[i]);
        const irg::parametric_plane<T> one{to_vec(p[0]), to_vec(p[1]), p[2]}, two{to_vec(p[3]), to_vec(p[4]), p[5]};
        const auto got = irg::textbook::intersect_planes(one, two);
        const auto n = minors(e[0], e[1]);
        const bool exist = !all_zero(n) && !all_zero(minors(e[3], e[4]));
        const bool crossing = exist && !(dot(n, e[3]).sign() == 0 && dot(n, e[4]).sign() == 0);
        if ((got.relation == irg::flat_relation::crossing) != crossing) return wrong;
        if (!crossing) return 0.0;
        const bool hold_s4 = dot(n, e[3]).sign() != 0;
        const place<3>&along = e[hold_s4 ? 3 : 4], &held = e[hold_s4 ? 4 : 3];
        const E whole = dot(n, along);
        double worst = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const E zero = e[5][k] * whole + along[k] * dot(n, e[2] - e[5]);
          const E one_held = zero + held[k] * whole - along[k] * dot(n, held);
          worst = std::fmax(worst, quotient_error(got.at_zero[static_cast<int>(k)], zero, whole));
          worst = std::fmax(worst, quotient_error(got.at_one[static_cast<int>(k)], one_held, whole));
        }
        return worst;
      },
      1000);
}

TEST_CASE_TEMPLATE("mixed magnitudes: cuts", T, double, float) {
  sweep(
      named<T>("clip_line_cyrus_beck"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 2, 5>(r, which);
        const std::array<point<T, 2>, 3> region{p[2], p[3], p[4]};
        const auto got = clip_line_cyrus_beck(p[0], p[1], region);
        const int turn = twice_area(p[2], p[3], p[4]).sign();
        quotient low{E(0), E(1)}, high{E(1), E(1)};
        bool visible = turn != 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const auto &from = region[i], &to = region[(i + 1) % 3];
          const E at_a = twice_area(from, to, p[0]) * turn, at_b = twice_area(from, to, p[1]) * turn;
          if (at_a.sign() < 0 && at_b.sign() < 0) visible = false;
          if (at_a.sign() < 0 && at_b.sign() >= 0) low = std::max(low, quotient{-at_a, at_b - at_a});
          if (at_a.sign() >= 0 && at_b.sign() < 0) high = std::min(high, quotient{at_a, at_a - at_b});
        }
        visible = visible && !(high < low);
        if (visible != got.has_value()) return wrong;
        if (!got) return 0.0;
        const double first =
            std::fmax(quotient_error(got->t_first, low.p, low.q), off_between(got->first, p[0], p[1], low));
        const double second =
            std::fmax(quotient_error(got->t_second, high.p, high.q), off_between(got->second, p[0], p[1], high));
        return std::fmax(first, second);
      },
      2000);
  sweep(
      named<T>("split_polygon"), 1,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 3>(r, which);
        const auto c = numbers<T, 4>(r, which);
        const auto e = rationals(c);
        struct crossing {
          point<T, 3> front, back;
          quotient t;
        };
        std::vector<crossing> crossings;
        double worst = 0;
        const auto note = [&](const point<T, 3>& front, const point<T, 3>& back, T t) {
          const auto height = [&](const point<T, 3>& q) {
            return e[0] * of(q.x) + e[1] * of(q.y) + e[2] * of(q.z) + e[3];
          };
          const E at_front = height(front), at_back = height(back);
          crossings.push_back({front, back, {at_front, at_front - at_back}});
          worst = std::fmax(worst, quotient_error(t, at_front, at_front - at_back));
          return front;
        };
        const std::vector<point<T, 3>> ring(p.begin(), p.end());
        const auto parts = split_polygon(ring, irg::plane<T>{c[0], c[1], c[2], c[3]}, note);
        for (const auto* side : {&parts.front, &parts.back})
          for (const auto& part : *side)
            for (const auto& q : part) {
              if (q == p[0] || q == p[1] || q == p[2]) continue;
              double off = wrong;
              for (const auto& x : crossings) off = std::fmin(off, off_between(q, x.front, x.back, x.t));
              worst = std::fmax(worst, off);
            }
        return worst;
      },
      2000);
  // Positions against attributes that are the positions: as shares of guard * (16u * the largest coordinate + 2 * the
  // smallest number).
  sweep(
      named<T>("clip_homogeneous, of its bound"), 1,
      [](test::random& r, sizes which) {
        irg::clip_vertex<T, 4> corners[3];
        irg::clip_volume<T> volume;
        volume.guard_x = volume.guard_y = static_cast<T>(1 + 7 * r.unit());
        E largest = 0;
        for (auto& v : corners)
          for (int k = 0; k < 4; ++k) {
            v.position[k] = v.attributes[k] = number<T>(r, which) / 8;
            if (largest < abs(of(v.position[k]))) largest = abs(of(v.position[k]));
          }
        double worst = 0;
        const E guard = of(volume.guard_x), smallest = of(std::numeric_limits<T>::denorm_min());
        const E bound = guard * (largest * of(8 * std::numeric_limits<T>::epsilon()) + smallest * 2);
        for (const auto& v : clip_homogeneous(corners, volume))
          for (int k = 0; k < 4; ++k) {
            const test::quotients::near_number off(of(v.position[k]) - of(v.attributes[k])), unit(bound);
            worst = std::fmax(worst, std::fabs(std::ldexp(off.value / unit.value, off.exponent - unit.exponent)));
          }
        return worst;
      },
      3000);
}

TEST_CASE_TEMPLATE("mixed magnitudes: barycentric coordinates by equations", T, double, float) {
  sweep(
      named<T>("barycentric_direct"), 0.5,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto got = irg::textbook::barycentric_direct(p[0], p[1], p[2], p[3]);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]), t = exactly(p[3]);
        const E whole = determinant(a, b, c),
                over[3] = {determinant(t, b, c), determinant(a, t, c), determinant(a, b, t)};
        bool is_beyond = whole.sign() == 0;
        for (const E& v : over) is_beyond = is_beyond || abs(whole) * test::quotients::largest<T>() < abs(v);
        if (!got) return is_beyond ? 0.0 : wrong;
        double worst = is_beyond ? wrong : 0;
        for (int k = 0; k < 3; ++k) worst = std::fmax(worst, quotient_error((*got)[k], over[k], whole));
        return worst;
      },
      2000);
}

namespace {

// |got - exact| over the bound u * factor * size.
template <class T>
double share_of(T got, const E& exact, double factor, const E& size) {
  if (!std::isfinite(got)) return wrong;
  const test::quotients::near_number off(of(got) - exact), unit(size * E(factor));
  if (off.value == 0) return 0;
  const int place = std::numeric_limits<T>::digits;
  return std::fabs(std::ldexp(off.value / unit.value, off.exponent - unit.exponent + place));
}
// Whether terms stay in the range.
template <class T>
bool in_range(const E& term) {
  return term.sign() == 0 || (term.exponent() > std::numeric_limits<T>::min_exponent + 2 &&
                              term.exponent() < std::numeric_limits<T>::max_exponent - 4);
}

}  // namespace

TEST_CASE_TEMPLATE("mixed magnitudes: plain formulas, of their bounds", T, double, float) {
  sweep(
      named<T>("line_value and plane_value"), 1,
      [](test::random& r, sizes which) {
        const auto c = numbers<T, 7>(r, which);
        const auto e = rationals(c);
        const E terms[4] = {e[0] * e[4], e[1] * e[5], e[2] * e[6], e[3]};
        bool fits = true;
        E sum = 0, size = 0;
        for (const E& term : terms) {
          fits = fits && in_range<T>(term);
          sum = sum + term, size = size + abs(term);
        }
        if (!fits) return 0.0;
        const T in_space = plane_value(irg::plane<T>{c[0], c[1], c[2], c[3]}, point<T, 3>{c[4], c[5], c[6]});
        const T in_plane = line_value(irg::line<T>{c[0], c[1], c[3]}, point<T, 2>{c[4], c[5]});
        return std::fmax(share_of(in_space, sum, 4, size), share_of(in_plane, sum - terms[2], 3, size - abs(terms[2])));
      },
      3000);
  sweep(
      named<T>("polygon_area_fast and _textbook"), 1,
      [](test::random& r, sizes) {
        std::vector<point<T, 2>> ring(static_cast<std::size_t>(r.integer(3, 6)));
        const int reach = sizeof(T) == 4 ? 30 : 250;
        for (auto& p : ring)
          for (int k = 0; k < 2; ++k)
            p[k] = static_cast<T>(std::ldexp(2 * r.unit() - 1, static_cast<int>(r.integer(-reach, reach))));
        E triangles = 0, products = 0;  // in size
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto &p = ring[i], &q = after(ring, i);
          products = products + abs(of(p.x) * of(q.y)) + abs(of(q.x) * of(p.y));
          const E ux = of(p.x) - of(ring[0].x), uy = of(p.y) - of(ring[0].y);
          const E vx = of(q.x) - of(ring[0].x), vy = of(q.y) - of(ring[0].y);
          triangles = triangles + (abs(ux * vy) + abs(uy * vx)).times_power_of_two(-1);
        }
        const E area = twice_area(ring).times_power_of_two(-1);
        const auto n = static_cast<double>(ring.size());
        return std::fmax(share_of(irg::polygon_area_fast(ring), area, n + 4, triangles),
                         share_of(irg::textbook::polygon_area(ring), area, n + 1, products));
      },
      3000);
}

#endif
