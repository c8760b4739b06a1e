// SPDX-License-Identifier: MIT
// What is seen from a point of the plane, by brute force over all directions in which anything can change, in rationals.
#pragma once

#include "support/big_rational.hpp"

#ifdef IRG_HAVE_MPFR
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <irg/visibility/sight_result.hpp>
#include <irg/geometry/vocabulary.hpp>

namespace test::plane_sight {

using number = big_rational;
struct place {
  number x, y;
};
inline place operator-(const place& a, const place& b) { return {a.x - b.x, a.y - b.y}; }
inline place operator+(const place& a, const place& b) { return {a.x + b.x, a.y + b.y}; }
inline place operator*(const number& t, const place& a) { return {t * a.x, t * a.y}; }
inline number cross(const place& a, const place& b) { return a.x * b.y - a.y * b.x; }
inline number dot(const place& a, const place& b) { return a.x * b.x + a.y * b.y; }
inline bool same(const place& a, const place& b) { return a.x == b.x && a.y == b.y; }

struct edge {
  place a, b;
  irg::sight_stop stop;
  std::size_t index;
};
struct corner {
  place at;
  irg::sight_stop stop;
  std::size_t index;
};

// Where the ray from q along d, less than half a turn from both of the edge's ends, meets its line: q + t d.
inline std::optional<number> meets(const place& q, const place& d, const edge& e) {
  const place along = e.b - e.a;
  const number across = cross(d, along);
  if (across.sign() == 0) return std::nullopt;
  const number t = cross(e.a - q, along) / across, s = cross(e.a - q, d) / across;
  if (t.sign() <= 0 || s.sign() < 0 || (number(1) - s).sign() < 0) return std::nullopt;
  return t;
}

// Where sight along d ends in a single direction, when obstacles lack their ends.
inline std::optional<number> open_stop(const place& q, const place& d, const edge& e) {
  const place along = e.b - e.a;
  const bool closed = e.stop == irg::sight_stop::boundary;
  if (same(e.a, e.b)) return std::nullopt;
  if (cross(d, along).sign() != 0) {
    const auto t = meets(q, d, e);
    if (!t || closed) return t;
    const number s = cross(e.a - q, d) / cross(d, along);
    return s.sign() == 0 || s == number(1) ? std::nullopt : t;
  }
  if (cross(d, e.a - q).sign() != 0) return std::nullopt;
  const number ta = dot(e.a - q, d) / dot(d, d), tb = dot(e.b - q, d) / dot(d, d);
  const number low = ta < tb ? ta : tb, high = ta < tb ? tb : ta;
  if (high.sign() <= 0) return std::nullopt;
  return low.sign() < 0 ? number(0) : low;
}

class scene {
public:
  scene(const place& q, std::vector<edge> edges, const irg::sight_options& options)
      : q_(q), edges_(std::move(edges)), options_(options) {}

  // The winding number of the boundary round p, which is not on it.
  int winding(const place& p) const {
    int count = 0;
    for (const edge& e : edges_) {
      if (e.stop != irg::sight_stop::boundary || (p.y < e.a.y) == (p.y < e.b.y)) continue;
      const number x = e.a.x + (p.y - e.a.y) / (e.b.y - e.a.y) * (e.b.x - e.a.x);
      if (p.x < x) count += p.y < e.b.y ? 1 : -1;
    }
    return count;
  }
  bool is_inside(const place& p) const {
    const int w = winding(p);
    return options_.rule == irg::fill_rule::even_odd ? w % 2 != 0 : w != 0;
  }
  bool is_on(const edge& e) const {
    return cross(e.b - e.a, q_ - e.a).sign() == 0 && dot(e.a - q_, e.b - q_).sign() <= 0;
  }

  std::vector<corner> ring() {
    directions();
    std::vector<corner> out;
    const std::size_t n = all_.size();
    std::vector<int> seen;
    for (std::size_t i = 0; i < n; ++i) seen.push_back(nearest(between(all_[i], all_[(i + 1) % n])));
    for (std::size_t i = 0; i < n; ++i) add(out, all_[i], seen[(i + n - 1) % n], seen[i]);
    return out;
  }

private:
  place q_;
  std::vector<edge> edges_;
  irg::sight_options options_;
  std::vector<place> all_;  // directions

  static bool before(const place& a, const place& b) {
    const auto half = [](const place& d) { return d.y.sign() < 0 || (d.y.sign() == 0 && d.x.sign() < 0); };
    return half(a) != half(b) ? half(b) : cross(a, b).sign() > 0;
  }
  void directions() {
    const auto add = [&](const place& p) {
      if (!same(p, q_)) all_.push_back(p - q_);
    };
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      add(edges_[i].a);
      add(edges_[i].b);
      for (std::size_t k = 0; k < i; ++k) {
        const place u = edges_[i].b - edges_[i].a, v = edges_[k].b - edges_[k].a;
        const number across = cross(u, v);
        if (across.sign() == 0) continue;
        const number t = cross(edges_[k].a - edges_[i].a, v) / across;
        if (t.sign() >= 0 && (number(1) - t).sign() >= 0) add(edges_[i].a + t * u);
      }
    }
    std::sort(all_.begin(), all_.end(), before);
    all_.erase(std::unique(all_.begin(), all_.end(), [](const auto& a, const auto& b) { return !before(a, b); }),
               all_.end());
  }
  static place between(const place& a, const place& b) {
    const int turn = cross(a, b).sign();
    if (turn > 0) return number(1) / dot(a, a) * a + number(1) / dot(b, b) * b;
    return {-a.y, a.x};
  }
  // The nearest edge along d: -1 where the way leads out of the domain at once.
  int nearest(const place& d) const {
    int best = -1;
    number at;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (const auto t = meets(q_, d, edges_[i]); t && (best < 0 || *t < at)) best = static_cast<int>(i), at = *t;
    return best >= 0 && is_inside(q_ + at / 2 * d) ? best : -1;
  }
  place on(int e, const place& d) const {
    const place &a = edges_[static_cast<std::size_t>(e)].a, along = edges_[static_cast<std::size_t>(e)].b - a;
    return q_ + cross(a - q_, along) / cross(d, along) * d;
  }
  void push(std::vector<corner>& out, const place& at, int e) const {
    if (e < 0)
      out.push_back({at, irg::sight_stop::nothing, 0});
    else
      out.push_back({at, edges_[static_cast<std::size_t>(e)].stop, edges_[static_cast<std::size_t>(e)].index});
  }
  void add(std::vector<corner>& out, const place& d, int before_d, int after_d) const {
    if (before_d == after_d) {  // a needle needs ends on both sides
      return;
    }
    if (before_d < 0) return push(out, on(after_d, d), after_d);
    const place p = on(before_d, d);
    if (after_d < 0) {
      push(out, p, -1);
      return push(out, q_, -1);
    }
    const place r = on(after_d, d);
    if (options_.ends == irg::obstacle_ends::open) {
      std::optional<number> stop;
      for (const edge& e : edges_)
        if (const auto t = open_stop(q_, d, e); t && (!stop || *t < *stop)) stop = t;
      if (stop && (dot(d, p - q_) < *stop * dot(d, d)) && (dot(d, r - q_) < *stop * dot(d, d))) {
        push(out, p, -1);
        push(out, q_ + *stop * d, -1);
        return push(out, r, after_d);
      }
    }
    if (!same(p, r)) push(out, p, -1);
    push(out, r, after_d);
  }
};

}  // namespace test::plane_sight
#endif
