// SPDX-License-Identifier: MIT
// What of a grid surface's edges is seen, by the definition: for each edge every place where anything could change, and
// between two such places one point, for which all edges are asked whether they pass above or below the line of sight,
// nearer to the eye. Rationals, no order of facets, no perimeters.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <irg/hidden/grid_surface.hpp>

#include "support/big_rational.hpp"

#ifdef IRG_HAVE_MPFR

namespace test {

class grid_surface_oracle {
  using Q = big_rational;
  struct place3 {
    Q x, y, z;  // less the eye's
  };
  struct edge {
    int i1, j1, i2, j2;
    place3 a, b;
  };

public:
  grid_surface_oracle(const irg::grid_surface& s, const irg::point<double, 3>& eye) {
    const auto n = static_cast<int>(s.x.size()), m = static_cast<int>(s.z.size());
    const auto at = [&](int i, int j) {
      const auto p = static_cast<std::size_t>(i), q = static_cast<std::size_t>(j);
      return place3{Q(s.x[p]) - Q(eye.x), Q(s.heights[p * s.z.size() + q]) - Q(eye.y), Q(s.z[q]) - Q(eye.z)};
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < m; ++j) {
        vertices_.push_back(at(i, j));
        if (j + 1 < m) edges_.push_back({i, j, i, j + 1, at(i, j), at(i, j + 1)});
        if (i + 1 < n) edges_.push_back({i, j, i + 1, j, at(i, j), at(i + 1, j)});
      }
    front_ = s.x.front() <= eye.x && eye.x <= s.x.back() && s.z.front() <= eye.z && eye.z <= s.z.back();
    if (front_) find_side(n, m, at);
  }

  bool on_surface() const { return front_ && side_ == 0; }

  std::vector<irg::grid_edge_part> parts() {
    std::vector<irg::grid_edge_part> out;
    for (const edge& g : edges_) {
      std::vector<Q> t{Q(0), Q(1)};
      const auto add = [&](const Q& v) {
        if (v.sign() > 0 && v < Q(1)) t.push_back(v);
      };
      for (const place3& v : vertices_) {
        add_zero(cross(g.a, v), cross(g.b, v), add);  // the vertex's direction
        if (cross(g.a, g.b).sign() == 0 && cross(g.a, v).sign() == 0 && cross(g.b, v).sign() == 0) {
          const bool along_x = g.i1 != g.i2;
          const auto rise = [&](const place3& p) { return (along_x ? v.x : v.z) * p.y - v.y * (along_x ? p.x : p.z); };
          add_zero(rise(g.a), rise(g.b), add);
        }
      }
      for (const edge& e : edges_) add_zero(volume(e, g.a), volume(e, g.b), add);
      std::sort(t.begin(), t.end());
      bool open = false;
      for (std::size_t k = 0; k + 1 < t.size(); ++k) {
        if (!(t[k] < t[k + 1])) continue;
        const bool seen = !hidden(along(g, (t[k] + t[k + 1]) / Q(2)));
        const double from = nearest<double>(t[k]), to = nearest<double>(t[k + 1]);
        if (seen && open) out.back().to = to;
        if (seen && !open) out.push_back({g.i1, g.j1, g.i2, g.j2, from, to});
        if (!seen) hidden_length += to - from;
        open = seen;
      }
      length += 1;
    }
    return out;
  }

  double hidden_length = 0, length = 0;

private:
  static Q cross(const place3& a, const place3& b) { return a.x * b.z - a.z * b.x; }
  static Q volume(const edge& e, const place3& c) {
    return (e.a.y * e.b.z - e.a.z * e.b.y) * c.x + (e.a.z * e.b.x - e.a.x * e.b.z) * c.y +
           (e.a.x * e.b.y - e.a.y * e.b.x) * c.z;
  }
  template <class Add>
  static void add_zero(const Q& at_a, const Q& at_b, const Add& add) {
    if (at_a.sign() * at_b.sign() < 0) add(at_a / (at_a - at_b));
  }
  static place3 along(const edge& g, const Q& t) {
    return {g.a.x + (g.b.x - g.a.x) * t, g.a.y + (g.b.y - g.a.y) * t, g.a.z + (g.b.z - g.a.z) * t};
  }

  bool hidden(const place3& p) const {
    if (p.x.sign() == 0 && p.z.sign() == 0) return false;
    bool above = false, below = false;
    const auto judge = [&](const place3& c) {  // a point in the plane through p and the upright line at the eye
      const Q r = p.x.sign() != 0 ? c.x / p.x : c.z / p.z;
      if (r.sign() <= 0 || !(r < Q(1))) return;
      const int s = (c.y - r * p.y).sign();
      above = above || s > 0;
      below = below || s < 0;
    };
    for (const edge& e : edges_) {
      const Q a = cross(p, e.a), b = cross(p, e.b);
      if (a.sign() * b.sign() < 0) {
        judge(along(e, a / (a - b)));
      } else {
        if (a.sign() == 0) judge(e.a);
        if (b.sign() == 0) judge(e.b);
      }
    }
    return front_ ? (side_ < 0 ? above : below) : above && below;
  }

  // The sign of the bilinear height over the eye, less the eye's.
  template <class At>
  void find_side(int n, int m, const At& at) {
    for (int i = 0; i + 1 < n; ++i)
      for (int j = 0; j + 1 < m; ++j) {
        const place3 p = at(i, j), q = at(i + 1, j), r = at(i, j + 1), s = at(i + 1, j + 1);
        if (p.x.sign() > 0 || q.x.sign() < 0 || p.z.sign() > 0 || r.z.sign() < 0) continue;
        const Q u = (Q(0) - p.x) / (q.x - p.x), v = (Q(0) - p.z) / (r.z - p.z), one(1);
        side_ = (((one - u) * p.y + u * q.y) * (one - v) + ((one - u) * r.y + u * s.y) * v).sign();
      }
  }

  std::vector<place3> vertices_;
  std::vector<edge> edges_;
  bool front_ = false;
  int side_ = 0;
};

}  // namespace test

#endif
