// SPDX-License-Identifier: MIT
// The control points of surfaces, how far a Bezier surface bends away from triangles on it, and where it is cut so that
// they keep within a tolerance.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/curve/bezier_surface.hpp>
#include <irg/curve/flatten.hpp>
#include <irg/math/homogeneous.hpp>
#include <irg/math/length.hpp>

namespace irg::detail {

// The points that a surface of P has: cartesian ones.
template <Coordinates P>
struct surface_place {
  using type = P;
};
template <class T, int N>
struct surface_place<hpoint<T, N>> {
  using type = point<T, N>;
};

// Control points of a surface that has places: of homogeneous ones, irg's own.
template <class P>
concept PlacedPoint = CurvePoint<P> && (coordinate_traits<P>::kind != coordinate_kind::homogeneous ||
                                        requires(const P& p) { try_to_cartesian(p); });

// How far a Bezier surface can be from triangles with corners on it, by the second differences of its
// control points.
//
// A triangle in a box of parameters, its corners on the surface: let W be the weights of a place as a mean of the
// corners. By Taylor's formula the surface is off the triangle's place by at most half of the mean of
// du^2 |S_uu| + 2 |du dv| |S_uv| + dv^2 |S_vv|, du and dv leading from the place to the corners; and means with weights
// W of du^2, |du dv| and dv^2 are at most a^2/4, a b/4 and b^2/4 for a box of a by b (a variance within an interval;
// Cauchy and Schwarz). So no triangle in the box is off by more than an eighth of a^2 |S_uu| + 2 a b |S_uv| +
// b^2 |S_vv|, whatever its shape; and derivatives are at most the differences of the control points of that box.

// Bounds of the second derivatives over a box that is the unit square: along u, mixed, along v.
template <class T>
struct IRG_APART surface_bends {
  T uu = 0, uv = 0, vv = 0;
  constexpr T error() const noexcept { return (uu + (uv + uv) + vv) / T(8); }
};

// Places from 0 to patch_steps, rising; whether each stretch is within its part of the tolerance.
struct IRG_APART patch_cuts {
  std::vector<int> places{0};
  bool within = true;
  constexpr std::size_t last() const noexcept { return places.size() - 1; }
  constexpr int operator[](std::size_t k) const noexcept { return places[k]; }
  // Halves the stretch that ends in place k; false where it is too short.
  constexpr bool halve(std::size_t k) {
    const int middle = places[k - 1] + (places[k] - places[k - 1]) / 2;
    if (middle == places[k - 1]) return false;
    places.insert(places.begin() + static_cast<std::ptrdiff_t>(k), middle);
    return true;
  }
};

inline namespace IRG_ABI {

template <class T>
constexpr void raise_to(T& largest, const T& size) noexcept {
  if (!(size <= largest) && largest == largest) largest = size;  // NaN stays
}

template <class T, int N>
constexpr T size_of_bend(const hpoint<T, N>& bend, const point<T, N>& origin, const T& reach) noexcept {
  const T w = coordinate(bend, N);
  return length(generate_coordinates<vec<T, N>>([&](int i) { return bend[i] - product(w, origin[i]); })) +
         product(reach, magnitude(w));
}

// The bends of a net over its own unit square. For rational ones: with x = A / w and an approximation L / l of it by
// homogeneous interpolation, x - L / l is ((A - L) - (L / l)(w - l)) / w, taken from an origin amid the points.
// needs   weights over 0
template <Coordinates P>
constexpr surface_bends<scalar_of<P>> bends_of(const control_net<P>& net) noexcept {
  using T = scalar_of<P>;
  using V = typename curve_sample<P>::vector;
  constexpr bool is_rational = coordinate_traits<P>::kind == coordinate_kind::homogeneous;
  const std::size_t rows = net.rows(), columns = net.columns;
  typename surface_place<P>::type origin{};
  T reach = 0, least = 1;
  if constexpr (is_rational) {
    constexpr int w = size_of<P> - 1;
    const T count = static_cast<T>(static_cast<int>(net.points.size()));
    least = net(0, 0)[w];
    for (const P& p : net.points)
      for (int i = 0; i < w; ++i) origin[i] = origin[i] + p[i] / p[w] / count;
    for (const P& p : net.points) {
      least = minimum(least, p[w]);
      raise_to(reach, length(to_cartesian(p) - origin));
    }
  }
  const auto size = [&](const V& bend) {
    if constexpr (is_rational)
      return size_of_bend(bend, origin, reach);
    else
      return length(bend);
  };
  const auto step = [](const P& a, const P& b) { return scaled_difference(a, b, 1); };
  const auto turn = [](const V& a, const V& b) {
    return generate_coordinates<V>([&](int i) { return coordinate(b, i) - coordinate(a, i); });
  };
  surface_bends<T> most;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      if (i + 2 < rows)
        raise_to(most.uu, size(turn(step(net(i, j), net(i + 1, j)), step(net(i + 1, j), net(i + 2, j)))));
      if (j + 2 < columns)
        raise_to(most.vv, size(turn(step(net(i, j), net(i, j + 1)), step(net(i, j + 1), net(i, j + 2)))));
      if (i + 1 < rows && j + 1 < columns)
        raise_to(most.uv, size(turn(step(net(i, j), net(i, j + 1)), step(net(i + 1, j), net(i + 1, j + 1)))));
    }
  const T m = static_cast<T>(static_cast<int>(rows) - 1), n = static_cast<T>(static_cast<int>(columns) - 1);
  return {product(most.uu, m * (m - 1)) / least, product(most.uv, m * n) / least,
          product(most.vv, n * (n - 1)) / least};
}

// A box of the parameters in steps of 1 / patch_steps.
struct patch_box {
  int u_from, u_to, v_from, v_to;
};
inline constexpr int patch_steps = 65536;

// Bends over boxes of a net; keeps its working space.
template <Coordinates P>
class patch_bends {
public:
  using T = scalar_of<P>;
  constexpr explicit patch_bends(const control_net<P>& net)
      : net_(net), cut_(net.points.size(), P{}), room_(3 * (net.rows() < net.columns ? net.columns : net.rows()), P{}) {
  }

  constexpr surface_bends<T> in(const patch_box& box) {
    for (std::size_t k = 0; k < cut_.size(); ++k) cut_[k] = net_.points[k];
    for (std::size_t j = 0; j < net_.columns; ++j) cut_line(j, net_.columns, net_.rows(), box.u_from, box.u_to);
    for (std::size_t i = 0; i < net_.rows(); ++i) cut_line(i * net_.columns, 1, net_.columns, box.v_from, box.v_to);
    return bends_of(control_net<P>{cut_, net_.columns});
  }

private:
  constexpr void cut_line(std::size_t first, std::size_t step, std::size_t count, int from, int to) {
    const std::span<P> room(room_);
    const auto line = room.first(count), left = room.subspan(count, count), right = room.subspan(2 * count, count);
    if (count < 2 || (from == 0 && to == patch_steps)) return;
    for (std::size_t k = 0; k < count; ++k) line[k] = cut_[first + k * step];
    if (to < patch_steps) {
      bezier_split(line, curve_fraction<T>(to, patch_steps), left, right);
      for (std::size_t k = 0; k < count; ++k) line[k] = left[k];
    }
    if (from > 0) {
      bezier_split(line, curve_fraction<T>(from, to), left, right);
      for (std::size_t k = 0; k < count; ++k) line[k] = right[k];
    }
    for (std::size_t k = 0; k < count; ++k) cut_[first + k * step] = line[k];
  }

  control_net<P> net_;
  std::vector<P> cut_, room_;
};

// Whether the net can be cut into triangles within a tolerance: finite, also its bends, and weights over 0.
template <Coordinates P>
constexpr bool has_finite_bends(const control_net<P>& net) noexcept {
  for (const P& p : net.points) {
    if (!is_finite(p)) return false;
    if constexpr (coordinate_traits<P>::kind == coordinate_kind::homogeneous)
      if (!(coordinate(p, size_of<P> - 1) > 0) || !try_to_cartesian(p)) return false;
  }
  return net.rows() > 0 && is_finite(bends_of(net).error());
}

// Where a Bezier patch is cut so that each cell stays within a tolerance, and where its borders
// are cut, which depends on the border alone.

template <class IsWithin>
constexpr patch_cuts cuts_where(const IsWithin& is_within) {
  constexpr int most = 1024, least = patch_steps / most;  // shorter stretches are left to frames
  patch_cuts cuts;
  each_longest_stretch(
      most, 12, [&](int from, int to) { return is_within(from * least, to * least); },
      [&](int at, bool within) {
        cuts.places.push_back(at * least);
        cuts.within = cuts.within && within;
      });
  return cuts;
}

// Cuts along u (or v) whose strips may bend by half of the tolerance, the mixed derivative counted once: of a cell in
// two such strips the error is at most (a^2 uu + a^2 uv) / 8 + (b^2 vv + b^2 uv) / 8, for 2 a b <= a^2 + b^2.
template <Coordinates P>
constexpr patch_cuts cuts_of_patch(patch_bends<P>& bends, scalar_of<P> tolerance, bool along_u) {
  using T = scalar_of<P>;
  return cuts_where([&](int from, int to) {
    const T share = static_cast<T>(to - from) / static_cast<T>(patch_steps);
    const auto b = along_u ? bends.in({from, to, 0, patch_steps}) : bends.in({0, patch_steps, from, to});
    return (along_u ? b.uu : b.vv) + product(share, b.uv) <= product(T(4), tolerance);
  });
}

}  // namespace IRG_ABI
}  // namespace irg::detail
