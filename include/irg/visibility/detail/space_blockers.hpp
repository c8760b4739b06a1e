// SPDX-License-Identifier: MIT
// The faces of a mesh that may stand between two convex regions of space, and whether they stop a line, leave all lines
// free or stop all of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <irg/core/contraction.hpp>
#include <irg/core/conversion.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::detail::inline IRG_ABI {

// Triangle k - 2 of those from the first corner of a face.
template <Floating T>
constexpr std::array<point<T, 3>, 3> fan_triangle(const mesh<T>& m, std::size_t f, std::size_t k) noexcept {
  const auto at = [&](std::size_t i) { return m.positions[m.corner(f, i).position]; };
  return {at(0), at(k - 1), at(k)};
}

// Whether the open segment from p to q meets a triangle, all three in one plane.
template <Floating T>
constexpr bool stops_in_plane(const point<T, 3>& p, const point<T, 3>& q,
                              const std::array<point<T, 3>, 3>& t) noexcept {
  for (int axis = 0; axis < 3; ++axis) {
    const auto flat = [axis](const point<T, 3>& v) { return point<T, 2>{v[(axis + 1) % 3], v[(axis + 2) % 3]}; };
    const point<T, 2> corner[] = {flat(t[0]), flat(t[1]), flat(t[2])};
    const int turn = orient2d(corner[0], corner[1], corner[2]);
    if (turn == 0) continue;
    const point<T, 2> from = flat(p), to = flat(q);
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const point<T, 2>&u = corner[i], &v = corner[(i + 1) % 3];
      const int at_p = orient2d(u, v, from) * turn, at_q = orient2d(u, v, to) * turn;
      if (at_p <= 0 && at_q <= 0 && at_p + at_q < 0) return false;
      const int side = orient2d(from, to, u);
      left += side > 0;
      right += side < 0;
    }
    return left < 3 && right < 3;
  }
  return false;  // it has no area
}

// Whether a triangle with an area is met strictly between p and q.
template <Floating T>
constexpr bool stops_sight(const point<T, 3>& p, const point<T, 3>& q, const std::array<point<T, 3>, 3>& t) noexcept {
  if (p == q) return false;
  const int from = orient3d(t[0], t[1], t[2], p), to = orient3d(t[0], t[1], t[2], q);
  if (from == 0 && to == 0) return stops_in_plane(p, q, t);
  if (from * to >= 0) return false;
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = orient3d(p, q, t[i], t[(i + 1) % 3]);
    left += side > 0;
    right += side < 0;
  }
  return left == 0 || right == 0;
}

// Whether a plane has the points of one list on one side or on it, not all of them on it, and those of the other on the
// other side or on it.
template <Floating T>
constexpr bool are_parted(std::span<const point<T, 3>> first, std::span<const point<T, 3>> second) noexcept {
  const std::size_t n = first.size(), all = n + second.size();
  const auto at = [&](std::size_t i) -> const point<T, 3>& { return i < n ? first[i] : second[i - n]; };
  for (std::size_t i = 0; i < all; ++i)
    for (std::size_t k = i + 1; k < all; ++k)
      for (std::size_t l = k + 1; l < all; ++l) {
        int side = 0;  // of the first list
        bool parts = true, leaves_plane = false;
        for (std::size_t v = 0; v < all && parts; ++v) {
          if (v == i || v == k || v == l) continue;
          const int here = (v < n ? 1 : -1) * orient3d(at(i), at(k), at(l), at(v));
          parts = here == 0 || side == 0 || here == side;
          if (here != 0) side = here;
          leaves_plane = leaves_plane || (v < n && here != 0);
        }
        if (parts && leaves_plane) return true;
      }
  return false;
}

template <Floating T>
class space_blockers {
public:
  constexpr space_blockers(std::span<const point<T, 3>> a, std::span<const point<T, 3>> b, const mesh<T>& m)
      : first_(a), second_(b), both_(a.begin(), a.end()) {
    both_.insert(both_.end(), b.begin(), b.end());
    box<T, 3> around{};
    for (const auto& p : both_) around = bounding_box(around, p);
    for (std::size_t f = 0; f < m.face_count(); ++f) add_face(m, f, around);
  }

  // Whether no face stops the way from p to q, places in the regions.
  constexpr bool lets_by(const point<T, 3>& p, const point<T, 3>& q) const noexcept {
    for (const auto& f : faces_)
      for (std::size_t k = 2; k < f.size(); ++k)
        if (stops_sight(p, q, {f[0], f[k - 1], f[k]})) return false;
    return true;
  }

  // Whether no face reaches into the convex hull of both regions, which all ways between them make up.
  constexpr bool frees_all() const noexcept {
    for (const auto& f : faces_)
      if (!are_parted<T>(both_, f)) return false;
    return true;
  }

  // Whether one face stops all ways. In its plane the ways between the regions fill the convex hull of those between
  // corners.
  constexpr bool hides_all() const noexcept {
    for (const auto& f : faces_)
      if (hides_all(f)) return true;
    return false;
  }

private:
  std::span<const point<T, 3>> first_, second_;
  std::vector<point<T, 3>> both_;
  std::vector<std::vector<point<T, 3>>> faces_{};  // flat ones

  constexpr void add_face(const mesh<T>& m, std::size_t f, const box<T, 3>& around) {
    std::vector<point<T, 3>> face;
    box<T, 3> b{};
    for (std::size_t k = 0; k < m.face_size(f); ++k) {
      face.push_back(m.positions[m.corner(f, k).position]);
      b = bounding_box(b, face.back());
    }
    if (face.size() < 3) return;
    for (int i = 0; i < 3; ++i)
      if (b.high[i] < around.low[i] || around.high[i] < b.low[i]) return;
    if (lies_in_plane(first_, face) != lies_in_plane(second_, face)) return;  // met at ends of ways only
    bool is_flat = true;
    for (std::size_t k = 3; k < face.size(); ++k)
      is_flat = is_flat && orient3d(face[0], face[1], face[2], face[k]) == 0;
    if (is_flat && (face.size() == 3 || has_area(face[0], face[1], face[2]))) {
      faces_.push_back(std::move(face));
      return;
    }
    for (std::size_t k = 2; k < face.size(); ++k) faces_.push_back({face[0], face[k - 1], face[k]});
  }

  static constexpr bool lies_in_plane(std::span<const point<T, 3>> region,
                                      const std::vector<point<T, 3>>& face) noexcept {
    for (std::size_t k = 2; k < face.size(); ++k)
      for (const auto& p : region)
        if (orient3d(face[0], face[k - 1], face[k], p) != 0) return false;
    return true;
  }

  static constexpr bool has_area(const point<T, 3>& a, const point<T, 3>& b, const point<T, 3>& c) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
      const auto flat = [axis](const point<T, 3>& v) { return point<T, 2>{v[(axis + 1) % 3], v[(axis + 2) % 3]}; };
      if (orient2d(flat(a), flat(b), flat(c)) != 0) return true;
    }
    return false;
  }

  constexpr bool hides_all(const std::vector<point<T, 3>>& f) const noexcept {
    const auto side = [&](std::span<const point<T, 3>> region) {  // 0 where it touches the plane
      int at = orient3d(f[0], f[1], f[2], region[0]);
      for (const auto& p : region)
        if (orient3d(f[0], f[1], f[2], p) != at) at = 0;
      return at;
    };
    if (side(first_) * side(second_) >= 0) return false;
    for (const auto& p : first_)
      for (const auto& q : second_) {
        int left = 0, right = 0;
        for (std::size_t i = 0; i < f.size(); ++i) {
          const int turn = orient3d(p, q, f[i], f[i + 1 < f.size() ? i + 1 : 0]);
          left += turn > 0;
          right += turn < 0;
        }
        if (left != 0 && right != 0) return false;
      }
    return true;
  }
};

// Random places, the same everywhere for a seed.
struct place_chooser {
  std::uint64_t state;

  // From 0 to 1, a multiple of 2^-53.
  // source  Steele, Lea and Flood 2014
  constexpr double unit() noexcept {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

  // A place in a point, a segment, a flat convex polygon or a box, each as likely as any other.
  template <Floating T>
  constexpr point<T, 3> place_in(std::span<const point<T, 3>> corners, bool is_box) noexcept {
    const std::size_t n = corners.size();
    if (n == 1) return corners[0];
    const point<T, 3>& origin = corners[0];
    point<T, 3> out = origin;
    if (is_box) {
      for (int i = 0; i < 3; ++i) out[i] = between(origin[i], corners[n - 1][i], unit());
      return out;
    }
    const std::size_t k = n == 2 ? 1 : triangle_of(corners);
    double s = unit(), t = n == 2 ? 0 : unit();
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    for (int i = 0; i < 3; ++i) {
      const T along = between(origin[i], corners[k][i], s);
      out[i] = n == 2 ? along : plus(along, between(origin[i], corners[k + 1][i], t), origin[i]);
    }
    return out;
  }

private:
  // Whether sums and differences of coordinates may overflow.
  template <Floating T>
  static constexpr bool is_huge(T v) noexcept {
    constexpr T most = (std::numeric_limits<T>::max)() / 4;
    return v < -most || most < v;
  }
  // a + t (b - a), not beyond the two.
  template <Floating T>
  static constexpr T between(T a, T b, double t) noexcept {
    if (is_huge(a) || is_huge(b)) return 4 * between(a / 4, b / 4, t);
    const T v = a + product(converted<T>(t), b - a);
    const T low = a < b ? a : b, high = a < b ? b : a;
    return v < low ? low : high < v ? high : v;
  }

  // a + (b - from), which numbers can hold but for the rounding.
  template <Floating T>
  static constexpr T plus(T a, T b, T from) noexcept {
    if (!is_huge(a) && !is_huge(b) && !is_huge(from)) return a + (b - from);
    constexpr T most = (std::numeric_limits<T>::max)() / 4;
    const T v = a / 4 + (b / 4 - from / 4);
    return 4 * (v < -most ? -most : most < v ? most : v);
  }

  // One of the triangles from the first corner, as likely as it is large: its second corner.
  template <Floating T>
  constexpr std::size_t triangle_of(std::span<const point<T, 3>> corners) noexcept {
    double size = 0;
    for (const auto& p : corners)
      for (int i = 0; i < 3; ++i) size = maximum(size, magnitude(half_way(corners[0], p, i)));
    // Areas are products of four ways, which have to be near 1 for that.
    const double scale = size > 0 ? power_of_two(minimum(1023, -exponent_of(size))) : 1;
    double whole = 0;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) whole += area(corners, k, scale);
    double rest = whole * unit();
    for (std::size_t k = 1; k + 2 < corners.size(); ++k) {
      rest -= area(corners, k, scale);
      if (rest < 0) return k;
    }
    return corners.size() - 2;
  }
  template <Floating T>
  static constexpr double half_way(const point<T, 3>& from, const point<T, 3>& to, int axis) noexcept {
    return widened(to[axis]) / 2 - widened(from[axis]) / 2;
  }
  template <Floating T>
  static constexpr double area(std::span<const point<T, 3>> corners, std::size_t k, double scale) noexcept {
    const auto way = [&](std::size_t i, int axis) { return half_way(corners[0], corners[i], axis) * scale; };
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const int u = (i + 1) % 3, v = (i + 2) % 3;
      const double part = product(way(k, u), way(k + 1, v)) - product(way(k, v), way(k + 1, u));
      sum += product(part, part);
    }
    return irg::sqrt(sum);
  }
};

}  // namespace irg::detail::inline IRG_ABI
