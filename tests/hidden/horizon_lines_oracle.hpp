// SPDX-License-Identifier: MIT
// What of curves is seen, by the definition: for each step every place where anything could change, and between two
// such places one point, for which all nearer steps are asked whether they pass above or below. Rationals, no horizons.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <irg/hidden/horizon_lines.hpp>

#include "support/big_rational.hpp"

#ifdef IRG_HAVE_MPFR

namespace test {

class curve_oracle {
  using Q = big_rational;
  struct step {
    std::size_t k;
    Q x1, y1, x2, y2;
  };

public:
  std::vector<irg::edge_part> parts(const std::vector<irg::point<double, 2>>& points) {
    std::vector<irg::edge_part> out;
    std::vector<step> nearer;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const auto &a = points[k], &b = points[k + 1];
      if (!std::isfinite(a.x + a.y + b.x + b.y) || a == b) continue;
      const step g{k, Q(a.x), Q(a.y), Q(b.x), Q(b.y)};
      std::vector<Q> t{Q(0), Q(1)};
      const auto add = [&](const Q& at_start, const Q& at_end) {
        if (at_start.sign() * at_end.sign() < 0) t.push_back(at_start / (at_start - at_end));
      };
      for (const step& e : nearer) {
        add(e.x1 - g.x1, e.x1 - g.x2);
        add(e.x2 - g.x1, e.x2 - g.x2);
        add(side(e, g.x1, g.y1), side(e, g.x2, g.y2));
      }
      std::sort(t.begin(), t.end());
      bool open = false;
      for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        if (!(t[i] < t[i + 1])) continue;
        const Q at = (t[i] + t[i + 1]) / Q(2);
        const bool seen = !hidden(nearer, g.x1 + (g.x2 - g.x1) * at, g.y1 + (g.y2 - g.y1) * at);
        const double from = nearest<double>(t[i]), to = nearest<double>(t[i + 1]);
        if (seen && open) out.back().to = to;
        if (seen && !open) out.push_back({k, irg::line_visibility::visible, from, to});
        if (!seen) hidden_length += to - from;
        open = seen;
      }
      length += 1;
      if (a.x != b.x) nearer.push_back(g);
    }
    return out;
  }

  double hidden_length = 0, length = 0;

private:
  // How far a point lies to the left of a step.
  static Q side(const step& e, const Q& x, const Q& y) {
    return (e.x2 - e.x1) * (y - e.y1) - (e.y2 - e.y1) * (x - e.x1);
  }
  static bool hidden(const std::vector<step>& nearer, const Q& x, const Q& y) {
    bool above = false, below = false;
    for (const step& e : nearer) {
      if ((x - e.x1).sign() * (x - e.x2).sign() > 0) continue;
      const int s = side(e, x, y).sign() * (e.x2 - e.x1).sign();
      above = above || s < 0;
      below = below || s > 0;
    }
    return above && below;
  }
};

}  // namespace test

#endif
