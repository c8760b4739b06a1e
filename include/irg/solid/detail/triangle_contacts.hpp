// SPDX-License-Identifier: MIT
// Where two triangles of space meet: the ends of the segment, or the corners of the polygon, that they have in common.
// Each is known by what it lies on, a corner, a side or the inside of either triangle, so that neighbours that meet in
// the same place name it alike. Signs of orient3d and orient2d decide everything.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/point_on_triangle.hpp>
#include <irg/core/vocabulary.hpp>

namespace irg::detail {

/// Places on a triangle: 0 to 2 are its corners, 3 to 5 the sides from these to the next, without ends.
inline constexpr std::uint8_t inside_triangle = 6, off_triangle = 7;

/// What a place is made of, the same for all triangles that meet there.
/// shape   a corner: its number; a side and a triangle: the side's corners, the lower first, and the triangle; two
///         sides: those of the first lot's, those of the second's; three triangles: their numbers and three_triangles
struct contact_key {
  std::uint32_t v[4];
  constexpr auto operator<=>(const contact_key&) const = default;
};
inline constexpr std::uint32_t three_triangles = no_index - 1;

struct triangle_contact {
  contact_key key;
  std::uint8_t at[2];  // the place on the first and on the second triangle
};

/// A triangle by its corners, with the axis along which it is looked at in its plane, and whether it runs
/// counter-clockwise then.
struct seen_triangle {
  const point<double, 3>* p[3];
  std::uint32_t v[3];
  std::uint32_t number;
  int axis = 0, turn = 0;  // turn is 0 for triangles without area
};

inline namespace IRG_ABI {

template <class P>
constexpr seen_triangle see_triangle(const std::vector<P>& points, const triangle_indices& t,
                                     std::uint32_t number) noexcept {
  seen_triangle s{{&points[t.v[0]], &points[t.v[1]], &points[t.v[2]]}, {t.v[0], t.v[1], t.v[2]}, number};
  double largest = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = seen_along(axis, *s.p[0]), b = seen_along(axis, *s.p[1]), c = seen_along(axis, *s.p[2]);
    const double area = magnitude((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    if (!(area > largest)) continue;
    largest = area;
    s.axis = axis;
  }
  s.turn = orientation_along(s.axis, *s.p[0], *s.p[1], *s.p[2]);
  for (int axis = 0; axis < 3 && s.turn == 0; ++axis)
    s.turn = orientation_along(s.axis = axis, *s.p[0], *s.p[1], *s.p[2]);
  return s;
}

// The place on a triangle that three signs tell, of the sides 0 to 2, all positive inside.
constexpr std::uint8_t place_of(const int (&sign)[3]) noexcept {
  int zeros = 0, last = 0;
  for (int k = 0; k < 3; ++k) {
    if (sign[k] < 0) return off_triangle;
    if (sign[k] != 0) continue;
    ++zeros;
    last = k;
  }
  if (zeros == 0) return inside_triangle;
  if (zeros == 1) return static_cast<std::uint8_t>(3 + last);
  // Sides k and k + 1 have corner k + 1 in common.
  return static_cast<std::uint8_t>(sign[0] != 0 ? 2 : sign[1] != 0 ? 0 : 1);
}

template <class Triangle>
class contact_finder {
public:
  triangle_contact contacts[16]{};
  int count = 0;
  bool are_coplanar = false;

  /// Finds the contacts of two triangles with area.
  constexpr contact_finder(const Triangle& a, const Triangle& b) noexcept : t_{&a, &b} {
    for (int k = 0; k < 3; ++k) side_[1][k] = is_corner(a, b.v[k]) ? 0 : orient3d(*a.p[0], *a.p[1], *a.p[2], *b.p[k]);
    if (are_beside(side_[1])) return;
    for (int k = 0; k < 3; ++k) side_[0][k] = is_corner(b, a.v[k]) ? 0 : orient3d(*b.p[0], *b.p[1], *b.p[2], *a.p[k]);
    if (are_beside(side_[0])) return;
    are_coplanar = side_[0][0] == 0 && side_[0][1] == 0 && side_[0][2] == 0;
    for (int which = 0; which < 2; ++which)
      for (int k = 0; k < 3; ++k) add_corner(which, k);
    if (are_coplanar) {
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) add_crossing(k, l);
    } else {
      for (int which = 0; which < 2; ++which)
        for (int k = 0; k < 3; ++k) add_piercing(which, k);
    }
  }

  /// Calls use(i, k, which, side) for the contacts that have a piece of either triangle's common part between them: all
  /// that is common (side is 3 then), or the sides of a common polygon, with the triangle's side that they lie on.
  template <class Use>
  constexpr void each_segment(const Use& use) const {
    if (!are_coplanar) {
      if (count == 2) use(0, 1, 0, 3);
      return;
    }
    for (int which = 0; which < 2; ++which)
      for (std::uint8_t k = 0; k < 3; ++k) {
        int found[2]{}, n = 0;
        for (int i = 0; i < count && n < 2; ++i)
          if (const std::uint8_t at = contacts[i].at[which]; at == k || at == (k + 1) % 3 || at == 3 + k)
            found[n++] = i;
        if (n == 2) use(found[0], found[1], which, int{k});
      }
  }

private:
  static constexpr bool are_beside(const int (&side)[3]) noexcept {
    return (side[0] > 0 && side[1] > 0 && side[2] > 0) || (side[0] < 0 && side[1] < 0 && side[2] < 0);
  }
  static constexpr bool is_corner(const Triangle& t, std::uint32_t v) noexcept {
    return t.v[0] == v || t.v[1] == v || t.v[2] == v;
  }

  constexpr void add(std::uint8_t at_first, std::uint8_t at_second) noexcept {
    const std::uint8_t at[2] = {at_first, at_second};
    contact_key key{{no_index, no_index, no_index, no_index}};
    if (at[0] < 3 || at[1] < 3) {
      key.v[0] = at[0] < 3 ? t_[0]->v[at[0]] : t_[1]->v[at[1]];
    } else {
      int next = 0;
      for (int which = 0; which < 2; ++which) {
        if (at[which] == inside_triangle) continue;
        const std::uint32_t a = t_[which]->v[at[which] - 3], b = t_[which]->v[(at[which] - 2) % 3];
        key.v[next++] = a < b ? a : b;
        key.v[next++] = a < b ? b : a;
      }
      if (next == 2) key.v[2] = t_[at[0] == inside_triangle ? 0 : 1]->number;
    }
    for (int i = 0; i < count; ++i)
      if (contacts[i].key == key) return;
    contacts[count++] = {key, {at[0], at[1]}};
  }
  constexpr void add(int which, std::uint8_t here, std::uint8_t there) noexcept {
    if (which == 0)
      add(here, there);
    else
      add(there, here);
  }

  // Corner k of one triangle, where it lies on the other.
  constexpr void add_corner(int which, int k) noexcept {
    if (side_[which][k] != 0) return;
    const seen_triangle &mine = *t_[which], &other = *t_[1 - which];
    const auto here = static_cast<std::uint8_t>(k);
    for (std::uint8_t l = 0; l < 3; ++l)
      if (other.v[l] == mine.v[k]) return add(which, here, l);
    int sign[3]{};
    for (int l = 0; l < 3; ++l)
      sign[l] = orientation_along(other.axis, *other.p[l], *other.p[(l + 1) % 3], *mine.p[k]) * other.turn;
    if (const std::uint8_t there = place_of(sign); there != off_triangle) add(which, here, there);
  }

  // Where side k of one triangle goes through the other's plane, if it meets the triangle there.
  constexpr void add_piercing(int which, int k) noexcept {
    const int l = (k + 1) % 3;
    if (side_[which][k] * side_[which][l] >= 0) return;
    const seen_triangle &mine = *t_[which], &other = *t_[1 - which];
    int sign[3]{}, sum = 0;
    for (int i = 0; i < 3; ++i) {
      sign[i] = orient3d(*mine.p[k], *mine.p[l], *other.p[i], *other.p[(i + 1) % 3]);
      sum += sign[i];
    }
    for (int& s : sign) s = sum < 0 ? -s : s;
    if (const std::uint8_t there = place_of(sign); there != off_triangle)
      add(which, static_cast<std::uint8_t>(3 + k), there);
  }

  // Where the insides of two sides cross, in a common plane.
  constexpr void add_crossing(int k, int l) noexcept {
    const seen_triangle &a = *t_[0], &b = *t_[1];
    const auto turn = [&](const auto* p, const auto* q, const auto* r) {
      return p == q || q == r || p == r ? 0 : orientation_along(a.axis, *p, *q, *r);
    };
    const auto *p = a.p[k], *q = a.p[(k + 1) % 3], *r = b.p[l], *s = b.p[(l + 1) % 3];
    if (turn(p, q, r) * turn(p, q, s) < 0 && turn(r, s, p) * turn(r, s, q) < 0)
      add(static_cast<std::uint8_t>(3 + k), static_cast<std::uint8_t>(3 + l));
  }

  const Triangle* t_[2];
  int side_[2][3]{};  // of the corners of one triangle against the plane of the other
};

}  // namespace IRG_ABI
}  // namespace irg::detail
