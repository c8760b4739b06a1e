// SPDX-License-Identifier: MIT
// The stretches of lines that lie inside of a tree's body, in any direction, without a mesh of it: what a picture of a
// tree is made from.
//
// A line that meets sides or corners is no special case: it stands as if moved by an infinitely small e along x, e^2
// along y and e^3 along z. Seen along the line, three signs tell whether a triangle is met; where one is zero, the
// first coordinate of side x direction that is not decides. Both triangles at a side agree on it, up to the side's
// direction, and triangles seen edge on are never met.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <irg/geometry/ray.hpp>
#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/vec.hpp>
#include <irg/solid/csg_tree.hpp>
#include <irg/solid/detail/body_triangles.hpp>
#include <irg/solid/detail/box_pairs.hpp>
#include <irg/solid/detail/exact_vertices.hpp>

namespace irg {

/// A stretch of a line that lies inside of a body, and the faces at which the line comes in and leaves.
template <Floating T>
struct solid_span {
  T from{}, to{};
  solid_face_origin entered{}, left{};  // body is no_index where the line begins or ends inside
  bool operator==(const solid_span&) const = default;
};

inline namespace IRG_ABI {

/// A tree made ready for lines.
template <Floating T>
class csg_spans {
public:
  /// needs   bodies as solid_boolean; one with positions that are not finite counts as nothing
  /// cost    linear; the triangles are allocated, the tree is copied without its bodies
  constexpr explicit csg_spans(const csg_tree<T>& tree) : steps_(tree.steps) {
    for (const mesh<T>& body : tree.bodies) {
      detail::append_body(bodies_, body);
      bodies_.fault = detail::surface_fault::none;
      bodies_.ends.resize(balls_.size() + 1, static_cast<std::uint32_t>(bodies_.triangles.size()));
      balls_.push_back(ball_round(static_cast<std::uint32_t>(balls_.size())));
    }
  }

  /// The stretches of a ray, from its low to its high end, in lengths of its direction.
  /// shape   each ends before the next begins
  /// gives   nothing for a ray without points; where faces of several bodies lie on each other, one of them
  /// exact   which faces are met, in which order, and what is inside between them; ends within 1 ulp, and a stretch
  ///         whose ends are one number then is missing
  /// cost    linear in the triangles of bodies whose balls the ray's line meets, some 20 ns each; those that are met
  ///         are sorted, and the tree is asked at each
  /// source  Hoffmann 1989; Edelsbrunner and Muecke 1990 (the move)
  [[nodiscard]] constexpr std::vector<solid_span<T>> along(const ray<T, 3>& r) const {
    if (r.empty()) return {};
    return within({wide(r.origin), {widened(r.direction.x), widened(r.direction.y), widened(r.direction.z)}},
                  maximum(r.low, T(0)), r.high);
  }

  /// The stretches of the upright line at (x, y), by their heights.
  /// needs   as along
  /// gives   as along
  /// exact   as along
  /// cost    as along
  [[nodiscard]] constexpr std::vector<solid_span<T>> upward(T x, T y) const {
    constexpr T most = std::numeric_limits<T>::infinity();
    if (!is_finite(x) || !is_finite(y)) return {};
    return within({{widened(x), widened(y), 0.0}, {0.0, 0.0, 1.0}}, -most, most);
  }

private:
  using place = point<double, 3>;
  struct line {
    place from;
    vec<double, 3> way;
  };
  struct ball {
    place centre;
    double radius2;
  };
  struct crossing {
    double at;
    std::uint32_t triangle;
    int change;  // of how often the surface runs round
  };

  [[nodiscard]] static constexpr place wide(const point<T, 3>& p) noexcept {
    return {widened(p.x), widened(p.y), widened(p.z)};
  }

  [[nodiscard]] constexpr ball ball_round(std::uint32_t body) const {
    detail::space_box box = detail::no_box();
    const auto each_corner = [&](const auto& use) {
      for (std::uint32_t t = bodies_.first_of(body); t < bodies_.ends[body]; ++t)
        for (int k = 0; k < 3; ++k) use(corner(t, k));
    };
    each_corner([&](const place& p) { box.add(p); });
    ball b{};
    for (int i = 0; i < 3; ++i) b.centre[i] = box.low[i] * 0.5 + box.high[i] * 0.5;
    each_corner([&](const place& p) { b.radius2 = maximum(b.radius2, dot(p - b.centre, p - b.centre)); });
    return b;
  }
  // False where rounding leaves it open: the distance, times the direction's length, is off by less than a part in 2^48
  // of the line's beginning's.
  [[nodiscard]] constexpr bool passes(const line& l, const ball& b) const noexcept {
    const auto to_centre = b.centre - l.from, beside = cross(to_centre, l.way);
    const double length2 = dot(l.way, l.way);
    const double most = b.radius2 * length2 * (1 + 0x1p-20) + dot(to_centre, to_centre) * length2 * 0x1p-40;
    return b.radius2 > detail::least_size && length2 > detail::least_size && most > detail::least_size &&
           dot(beside, beside) > most;
  }

  [[nodiscard]] constexpr const place& corner(std::uint32_t t, int k) const noexcept {
    return bodies_.positions[bodies_.triangles[t].v[k]];
  }

  // On which side the moved line passes the side from a to b; 0 where they are parallel.
  [[nodiscard]] static constexpr int turn(const line& l, const place& a, const place& b) noexcept {
    const int sign = sign_of<3>([](const auto& from, const auto& way, const auto& p,
                                   const auto& q) { return dot(cross(p - from, q - from), way); },
                                l.from, l.way, a, b);
    if (sign != 0) return sign;
    const auto moved = sign_of<2>(
        [](const auto& way, const auto& p, const auto& q) {
          const auto n = cross(way, q - p);
          return std::array{n.x, n.y, n.z};
        },
        l.way, a, b);
    return moved[0] != 0 ? moved[0] : moved[1] != 0 ? moved[1] : moved[2];
  }

  // {direction x normal, (corner - beginning) x normal}: the divisor and the dividend of where the line meets a plane.
  struct meeting {
    template <class P, class V>
    constexpr auto operator()(const P& from, const V& way, const P& a, const P& b, const P& c) const {
      const auto n = cross(b - a, c - a);
      return std::array{dot(way, n), dot(a - from, n)};
    }
  };

  constexpr void meet(const line& l, std::uint32_t t, std::vector<crossing>& met) const {
    const place &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
    const int out = turn(l, a, b);
    if (out == 0 || turn(l, b, c) != out || turn(l, c, a) != out) return;
    if (const auto at = quotient_of<3>(meeting{}, l.from, l.way, a, b, c)) met.push_back({*at, t, -out});
  }

  // -1, 0 or 1, as the line meets s before t, at the same place or after it.
  [[nodiscard]] constexpr int order(const line& l, const crossing& s, const crossing& t) const noexcept {
    if (s.at != t.at) return s.at < t.at ? -1 : 1;
    const auto [first, second, apart] = sign_of<6>(
        [](const auto& from, const auto& way, const auto& a, const auto& b, const auto& c, const auto& d, const auto& e,
           const auto& f) {
          const auto u = meeting{}(from, way, a, b, c), v = meeting{}(from, way, d, e, f);
          return std::array{u[0], v[0], u[1] * v[0] - v[1] * u[0]};
        },
        l.from, l.way, corner(s.triangle, 0), corner(s.triangle, 1), corner(s.triangle, 2), corner(t.triangle, 0),
        corner(t.triangle, 1), corner(t.triangle, 2));
    return first * second * apart;
  }

  [[nodiscard]] constexpr std::vector<solid_span<T>> within(const line& l, T low, T high) const {
    std::vector<crossing> met;
    for (std::uint32_t body = 0; body < balls_.size(); ++body)
      if (!passes(l, balls_[body]))
        for (std::uint32_t t = bodies_.first_of(body); t < bodies_.ends[body]; ++t) meet(l, t, met);
    std::sort(met.begin(), met.end(), [&](const crossing& s, const crossing& t) {
      const int way = s.triangle == t.triangle ? 0 : order(l, s, t);
      return way != 0 ? way < 0 : s.triangle < t.triangle;
    });
    std::vector<int> windings(balls_.size(), 0);
    std::vector<unsigned char> is_in(balls_.size(), 0), scratch;
    std::vector<solid_span<T>> spans;
    solid_span<T> open;
    bool was_in = false;
    for (std::size_t i = 0, next = 0; i < met.size(); i = next) {
      // Where several faces are met in one place, what is inside counts behind all of them.
      const crossing* by = &met[i];
      bool is_now = was_in;
      for (; next < met.size() && order(l, met[i], met[next]) == 0; ++next) {
        const std::uint32_t body = bodies_.body[met[next].triangle];
        is_in[body] = (windings[body] += met[next].change) != 0 ? 1 : 0;
        const bool is_behind = detail::is_in_steps(steps_, is_in, scratch);
        if (is_behind != is_now) by = &met[next];
        is_now = is_behind;
      }
      if (is_now == was_in) continue;
      const T at = converted<T>(by->at);
      const solid_face_origin face{bodies_.body[by->triangle], bodies_.face[by->triangle], (by->change > 0) != is_now};
      if (is_now)
        open = {at, {}, face, {}};
      else
        add(spans, {open.from, at, open.entered, face}, low, high);
      was_in = is_now;
    }
    return spans;
  }

  static constexpr void add(std::vector<solid_span<T>>& spans, solid_span<T> span, T low, T high) {
    constexpr solid_face_origin none{no_index, no_index, false};
    if (span.from < low) span = {low, span.to, none, span.left};
    if (high < span.to) span = {span.from, high, span.entered, none};
    if (!(span.from < span.to)) return;
    if (!spans.empty() && spans.back().to == span.from) {  // they are apart by less than numbers are
      span = {spans.back().from, span.to, spans.back().entered, span.left};
      spans.pop_back();
    }
    spans.push_back(span);
  }

  std::vector<csg_step> steps_;
  detail::body_triangles bodies_;
  std::vector<ball> balls_;
};

}  // namespace IRG_ABI
}  // namespace irg
