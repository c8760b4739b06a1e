// SPDX-License-Identifier: MIT
// A grid surface as an eye sees it, and what is decided of it, exactly. Upright half-planes of sight turn about the
// upright line through the eye; the direction of one is (u, w) = (x, z) less the eye's, turning from u to w. An edge
// that no such half-plane contains is met by some of them, at one slope each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {

// Edges are twice the number of their lower vertex, and one more where they go along z. Vertex (i, j) is i*(m + 1) + j.
using grid_edge = std::uint32_t;
inline constexpr grid_edge no_grid_edge = ~grid_edge{0};

// The vertices of an edge in the sense in which directions turn.
struct turning_edge {
  std::uint32_t from, to;
};

inline namespace IRG_ABI {

// The differences of the point at 3k from the one at 0.
template <class X>
constexpr auto grid_differences(const X& x, std::size_t k) noexcept {
  return std::array{x[3 * k] - x[0], x[3 * k + 1] - x[1], x[3 * k + 2] - x[2]};
}
template <class A>
constexpr auto grid_normal(const A& a, const A& b) noexcept {
  return std::array{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class A, class B>
constexpr auto grid_dot(const A& a, const B& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
// The normal of the plane through point 0 and the points k and k + 1.
template <class X>
constexpr auto grid_normal_at(const X& x, std::size_t k) noexcept {
  return grid_normal(grid_differences(x, k), grid_differences(x, k + 1));
}

}  // namespace IRG_ABI

template <class T>
struct IRG_APART grid_sight {
  std::span<const T> x, z, heights;
  point<T, 3> eye;

  constexpr std::uint32_t rows() const noexcept { return static_cast<std::uint32_t>(z.size()); }
  constexpr std::uint32_t vertex(int i, int j) const noexcept {
    return static_cast<std::uint32_t>(i) * rows() + static_cast<std::uint32_t>(j);
  }
  constexpr point<T, 3> at(std::uint32_t v) const noexcept { return {x[v / rows()], heights[v], z[v % rows()]}; }
  constexpr point<T, 2> below(std::uint32_t v) const noexcept { return {x[v / rows()], z[v % rows()]}; }
  constexpr std::uint32_t low(grid_edge e) const noexcept { return e / 2; }
  constexpr std::uint32_t high(grid_edge e) const noexcept { return e / 2 + (e % 2 != 0 ? 1 : rows()); }

  // Edges along z turn upwards where they are at u > 0, those along x where they are at w < 0.
  constexpr turning_edge turning(grid_edge e) const noexcept {
    const point<T, 2> p = below(low(e));
    const bool upwards = e % 2 != 0 ? p.x > eye.x : p.y < eye.z;
    return upwards ? turning_edge{low(e), high(e)} : turning_edge{high(e), low(e)};
  }

  // 1 where the direction of vertex c lies behind that of b by less than half a turn, -1 where it lies before.
  constexpr int turn(std::uint32_t b, std::uint32_t c) const noexcept {
    return b == c ? 0 : orient2d(point<T, 2>{eye.x, eye.z}, below(b), below(c));
  }

  // The border that turns to the eye comes first: what is drawn hangs together, and a perimeter has no jumps.
  static constexpr bool has_jumps = false;
  // The four axes of the plane divide the directions.
  static constexpr std::uint32_t axes = 4;
  // 1 where the direction of vertex c lies behind axis k, of which the first is that of x, by less than half a turn.
  constexpr int behind_axis(std::uint32_t k, std::uint32_t c) const noexcept {
    const point<T, 2> p = below(c);
    const T a = k % 2 == 0 ? p.y : p.x, b = k % 2 == 0 ? eye.z : eye.x;
    const int sign = a < b ? -1 : a > b ? 1 : 0;
    return k == 0 || k == 3 ? sign : -sign;
  }

  // 1 where edge e passes above vertex c, -1 where below.
  constexpr int above_vertex(grid_edge e, std::uint32_t c) const noexcept {
    const turning_edge t = turning(e);
    return c == t.from || c == t.to ? 0 : orient3d(eye, at(t.from), at(t.to), at(c));
  }

  template <class... Vertex>
  constexpr auto coordinates(Vertex... v) const noexcept {
    std::array<T, 3 * sizeof...(v) + 3> out{eye.x, eye.y, eye.z};
    std::size_t next = 3;
    const auto put = [&](const point<T, 3>& p) {
      out[next] = p.x, out[next + 1] = p.y, out[next + 2] = p.z;
      next += 3;
    };
    (put(at(v)), ...);
    return out;
  }

  // 1 where f passes above e in the direction of vertex c, -1 where below.
  constexpr int compare_at(grid_edge f, grid_edge e, std::uint32_t c) const noexcept {
    const turning_edge s = turning(e), t = turning(f);
    const auto formula = [](const auto& p) {
      const auto n = grid_normal_at(p, 1), o = grid_normal_at(p, 3);
      const auto d = grid_differences(p, 5);
      return (n[0] * o[1] - o[0] * n[1]) * d[0] + (n[2] * o[1] - o[2] * n[1]) * d[2];
    };
    return irg::sign_of<5>(formula, coordinates(s.from, s.to, t.from, t.to, c));
  }

  // The sign of the triple product of the normals of three edges' planes.
  constexpr int planes_turn(grid_edge e, grid_edge f, grid_edge g) const noexcept {
    const turning_edge r = turning(e), s = turning(f), t = turning(g);
    const auto formula = [](const auto& p) {
      return grid_dot(grid_normal(grid_normal_at(p, 1), grid_normal_at(p, 3)), grid_normal_at(p, 5));
    };
    return irg::sign_of<6>(formula, coordinates(r.from, r.to, s.from, s.to, t.from, t.to));
  }

  // How far along g, from its lower vertex, it meets the plane of e.
  constexpr T place(grid_edge g, grid_edge e) const noexcept {
    const auto formula = [](const auto& p) {
      const auto n = grid_normal_at(p, 1);
      const auto a = grid_dot(n, grid_differences(p, 3)), b = grid_dot(n, grid_differences(p, 4));
      return std::array{a - b, a};
    };
    return irg::quotient_of<3>(formula, coordinates(low(e), high(e), low(g), high(g))).value_or(T(0));
  }

  // -1, 0 or 1: where g meets the plane of e before that of f, at one place, or behind.
  constexpr int compare_places(grid_edge g, grid_edge e, grid_edge f) const noexcept {
    const auto falls = [&](grid_edge of) {  // the sign of the difference that `place` divides by
      const int a = orient3d(eye, at(low(of)), at(high(of)), at(low(g)));
      return a != 0 ? a : -orient3d(eye, at(low(of)), at(high(of)), at(high(g)));
    };
    const auto formula = [](const auto& p) {
      const auto n = grid_normal_at(p, 1), o = grid_normal_at(p, 3);
      const auto a = grid_differences(p, 5), b = grid_differences(p, 6);
      return grid_dot(o, a) * grid_dot(n, b) - grid_dot(n, a) * grid_dot(o, b);
    };
    return falls(e) * falls(f) *
           irg::sign_of<6>(formula, coordinates(low(e), high(e), low(f), high(f), low(g), high(g)));
  }
};

}  // namespace irg::detail
