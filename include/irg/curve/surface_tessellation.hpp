// SPDX-License-Identifier: MIT
// Bezier surfaces as triangles: in given steps, or as few as a tolerance allows. Borders are cut by their own control
// points alone, so that patches that share a border's points meet without a crack.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/function_ref.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/curve/bezier_surface.hpp>
#include <irg/curve/detail/surface_bends.hpp>
#include <irg/curve/flatten.hpp>
#include <irg/math/homogeneous.hpp>
#include <irg/math/length.hpp>

namespace irg {

/// A corner of a triangle on a surface of control points P: its place, and the number it has among the corners of this
/// call, which are numbered from 0.
template <CurvePoint P>
struct surface_corner {
  std::size_t index = 0;
  curve_parameter<scalar_of<P>> u{}, v{};
  typename detail::surface_place<P>::type point{};
  IRG_APART constexpr bool operator==(const surface_corner& o) const {
    return index == o.index && u == o.u && v == o.v && same_place(point, o.point);
  }
};

/// What became of a surface; whether each triangle is within the tolerance.
struct surface_tessellation {
  std::size_t corners = 0, triangles = 0;
  bool within_tolerance = true;
  bool operator==(const surface_tessellation&) const = default;
};

inline namespace IRG_ABI {

/// The control points of a patch in one list, for control_net{list, V + 1}.
template <CurvePoint P, int U, int V>
[[nodiscard]] constexpr std::array<P, static_cast<std::size_t>((U + 1) * (V + 1))> net_of(
    const bezier_patch<P, U, V>& patch) noexcept;

/// Hands the triangles of a Bezier surface to sink(corner, corner, corner), no point of the surface farther from them
/// than the tolerance.
/// shape   counter-clockwise as u x v; the corners of a call are numbered, those of one place are one. Triangles of
///         which two corners are one point are left out. Rational surfaces are nets of hpoint, weights over 0
/// gives   nothing, and within_tolerance false, for control points or differences that are not finite and for weights
///         that are not over 0; no triangles for a net of one row or column. A direction is cut into some thousand
///         stretches at most, so that tolerance 0 ends, too
/// exact   the tolerance holds but for rounding; corners are within 3 degree u of patch_sample's, on borders
///         bezier_point's of the border. Two patches that share a border's control points bit for bit, whichever way it
///         runs, have the same corners on it, bit for bit
/// cost    some bends of boxes (a subdivision each) for each line, a sample for each corner
/// source  Filip, Magedson and Markot 1986 for the bound; irg's own: cells, borders and the frame between
template <CurvePoint P, class Sink>
  requires detail::PlacedPoint<P> && Floating<scalar_of<P>>
constexpr surface_tessellation tessellate_within(const control_net<P>& net,
                                                 std::type_identity_t<scalar_of<P>> tolerance, Sink&& sink);

/// Hands the triangles of a Bezier patch in n by m equal steps to sink(corner, corner, corner).
/// needs   n > 0, m > 0
/// exact   corners within 3 degree u of patch_sample's; on borders bezier_point's of the border, bit for bit, so that
///         patches that share a border's points and its steps meet without a crack
/// cost    for each corner a curve of degree V, for each of n + 1 rows V + 1 curves of degree U; keeps two rows
template <CurvePoint P, int U, int V, class Sink>
  requires detail::PlacedPoint<P> && Floating<scalar_of<P>>
constexpr surface_tessellation tessellate_steps(const bezier_patch<P, U, V>& patch, int n, int m, Sink&& sink);

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail {

// Programs without irg::compiled do without here: a sink is part of the innermost loop.
template <class P>
inline constexpr bool is_library_point = false;
template <Floating T>
inline constexpr bool is_library_point<point<T, 3>> = true;
template <Floating T>
inline constexpr bool is_library_point<hpoint<T, 3>> = true;

// What irg::compiled takes the control points of surfaces as.
template <class P>
concept CompiledControlPoint = is_library_point<P>;

template <CompiledControlPoint P>
using triangle_sink = function_ref<void(const surface_corner<P>&, const surface_corner<P>&, const surface_corner<P>&)>;

inline namespace IRG_COMPILED_ABI {

template <CompiledControlPoint P>
IRG_API surface_tessellation send_surface(const control_net<P>& net, scalar_of<P> tolerance,
                                          const triangle_sink<P>& sink);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

// Whether the points come before themselves in reverse, by the first coordinate that tells.
template <Coordinates P>
constexpr bool runs_forward(const std::vector<P>& points) noexcept {
  for (std::size_t k = 0, back = points.size() - 1; k < back; ++k, --back)
    for (int i = 0; i < size_of<P>; ++i)
      if (coordinate(points[k], i) != coordinate(points[back], i))
        return coordinate(points[k], i) < coordinate(points[back], i);
  return true;
}

// Cuts of a border, which a neighbour that has it the other way round makes in the same places.
template <Coordinates P>
constexpr patch_cuts cuts_of_border(std::vector<P> points, scalar_of<P> tolerance) {
  using T = scalar_of<P>;
  const bool forward = runs_forward(points);
  const auto turn = [](auto& list) {
    for (std::size_t k = 0, back = list.size() - 1; k < back; ++k, --back) std::swap(list[k], list[back]);
  };
  if (!forward) turn(points);
  patch_bends<P> bends({points, points.size()});
  auto cuts =
      cuts_where([&](int from, int to) { return bends.in({0, patch_steps, from, to}).vv <= product(T(4), tolerance); });
  if (!forward) {
    turn(cuts.places);
    for (int& place : cuts.places) place = patch_steps - place;
  }
  return cuts;
}

template <CurvePoint P>
constexpr typename surface_place<P>::type on_surface(const P& p) noexcept {
  if constexpr (coordinate_traits<P>::kind == coordinate_kind::homogeneous)
    return to_cartesian(p);
  else
    return p;
}

// Hands a triangle over unless two of its corners are one point, as at a pole.
template <CurvePoint P, class Sink>
constexpr void put_triangle(surface_tessellation& done, Sink& sink, const surface_corner<P>& a,
                            const surface_corner<P>& b, const surface_corner<P>& c) {
  if (same_place(a.point, b.point) || same_place(b.point, c.point) || same_place(c.point, a.point)) return;
  ++done.triangles;
  sink(a, b, c);
}

// Whether these control points, which all become one point of the surface, are a pole.
template <CurvePoint P>
constexpr bool is_pole(std::span<const P> points, std::size_t first, std::size_t step, std::size_t count) noexcept {
  for (std::size_t k = 1; k < count; ++k)
    if (!same_place(on_surface(points[first]), on_surface(points[first + k * step]))) return false;
  return true;
}

// A patch between its cut borders: an inner lattice, and around it a frame of triangles that joins it to the borders.
template <CurvePoint P, class Sink>
class framed_patch {
public:
  using T = scalar_of<P>;
  using corner = surface_corner<P>;

  constexpr framed_patch(const control_net<P>& net, T tolerance, Sink& sink)
      : net_(net), tolerance_(tolerance), sink_(sink), bends_(net), u_(cuts_of_patch(bends_, tolerance, true)),
        v_(cuts_of_patch(bends_, tolerance, false)), room_(2 * net.columns + net.rows(), P{}) {
    const std::size_t rows = net.rows(), columns = net.columns;
    const auto add = [&](std::size_t side, std::size_t first, std::size_t step, std::size_t count) {
      std::vector<P> points;
      for (std::size_t k = 0; k < count; ++k) points.push_back(net.points[first + k * step]);
      is_pole_[side] = is_pole(net.points, first, step, count);
      border_[side] = cuts_of_border(points, tolerance);
    };
    add(0, 0, columns, rows);  // v = 0, along u
    add(1, columns - 1, columns, rows);  // v = 1
    add(2, 0, 1, columns);  // u = 0, along v
    add(3, (rows - 1) * columns, 1, columns);
  }

  constexpr surface_tessellation run() {
    bool within = u_.within && v_.within;
    for (const patch_cuts& b : border_) within = within && b.within;
    bool is_lattice = true;
    for (int side = 0; side < 4; ++side) is_lattice = is_lattice && outer(side) == inner(side).places;
    if (!is_lattice) {
      if (u_.last() == 1) u_.halve(1);
      if (v_.last() == 1) v_.halve(1);
      int changes = 0;
      for (int side = within ? 0 : 4; side < 4;) {
        const fit f = fit_side(side, changes < 256);
        changes += f == fit::changed ? 1 : 0;
        within = within && f != fit::never;
        side = f == fit::changed ? 0 : side + 1;  // a cut more may touch the others
      }
    }
    put_lattice(is_lattice ? 0 : 1);
    if (!is_lattice) put_frame();
    done_.corners = corners_.size();
    done_.within_tolerance = within;
    return done_;
  }

private:
  enum class fit { good, changed, never };

  constexpr patch_cuts& inner(int side) { return side < 2 ? u_ : v_; }
  constexpr patch_cuts& across(int side) { return side < 2 ? v_ : u_; }
  // Where a border is cut: where its control points say. A pole, which is one point, goes along with the lattice.
  constexpr const std::vector<int>& outer(int side) {
    const auto k = static_cast<std::size_t>(side);
    return is_pole_[k] ? inner(side).places : border_[k].places;
  }

  // The triangles between a border (outer, at places 0 to last) and the lattice (inner, at places 1 to last - 1):
  // each(base on the border, k, j), whose base ends in outer k + 1 or inner j + 1 and whose apex is inner j or outer k.
  template <class Each>
  constexpr void each_in_side(int side, const Each& each) {
    const auto &out = outer(side), &in = inner(side).places;
    std::size_t k = 0, j = 1;
    while (k + 1 < out.size() || j + 2 < in.size()) {
      const bool outward = j + 2 >= in.size() || (k + 1 < out.size() && out[k] + out[k + 1] <= in[j] + in[j + 1]);
      if (!each(outward, k, j)) return;
      ++(outward ? k : j);
    }
  }

  // Whether even the widest triangle of a side, wherever it may be, is within the tolerance.
  constexpr bool fits_as_whole(int side, const surface_bends<T>& bends) {
    const auto &out = outer(side), &in = inner(side).places;
    int widest = 0;
    each_in_side(side, [&](bool outward, std::size_t k, std::size_t j) {
      const int from = minimum(out[k], in[j]), to = outward ? maximum(out[k + 1], in[j]) : maximum(out[k], in[j + 1]);
      widest = maximum(widest, to - from);
      return true;
    });
    const T share = static_cast<T>(widest) / static_cast<T>(patch_steps), square = product(share, share);
    const T uu = side < 2 ? product(bends.uu, square) : bends.uu, vv = side < 2 ? bends.vv : product(bends.vv, square);
    return surface_bends<T>{uu, product(bends.uv, share), vv}.error() <= tolerance_;
  }

  // Cuts the lattice further until the triangles of a side are within the tolerance: where one is too wide for its
  // border's bend, the lattice along it; otherwise the side itself is made narrower.
  constexpr fit fit_side(int side, bool may_change) {
    patch_cuts &along = inner(side), &width = across(side);
    const bool at_end = side % 2 == 1;
    const int low = at_end ? width[width.last() - 1] : 0, high = at_end ? patch_steps : width[1];
    const auto box = [&](int from, int to) {
      return side < 2 ? patch_box{from, to, low, high} : patch_box{low, high, from, to};
    };
    const auto& out = outer(side);
    if (fits_as_whole(side, bends_.in(box(0, patch_steps)))) return fit::good;
    fit result = fit::good;
    each_in_side(side, [&](bool outward, std::size_t k, std::size_t j) {
      const int a = outward ? out[k] : along[j], b = outward ? out[k + 1] : along[j + 1];
      const int apex = outward ? along[j] : out[k];
      const int from = minimum(a, apex), to = maximum(b, apex);
      const auto bends = bends_.in(box(from, to));
      if (bends.error() <= tolerance_) return true;
      // The stretch of the lattice that makes it wide: its base, or the one between the base and its apex.
      const std::size_t stretch = !outward ? j + 1 : apex > b ? j : apex < a ? j + 1 : 0;
      const T bend = side < 2 ? bends.uu : bends.vv;
      const bool is_wide =
          stretch > 0 && bend > product(T(4), tolerance_) && 8 * (along[stretch] - along[stretch - 1]) > to - from;
      const bool changed = may_change && ((is_wide && along.halve(stretch)) || width.halve(at_end ? width.last() : 1) ||
                                          (stretch > 0 && along.halve(stretch)));
      if (changed) {
        result = fit::changed;
        return false;
      }
      result = fit::never;
      return true;
    });
    return result;
  }

  constexpr corner& add_corner(int u, int v) {
    const auto at_u = curve_fraction<T>(u, patch_steps), at_v = curve_fraction<T>(v, patch_steps);
    corners_.push_back({corners_.size(), at_u, at_v, on_surface(patch_sample(net_, at_u, at_v, room_).point)});
    return corners_.back();
  }
  constexpr void put(std::size_t a, std::size_t b, std::size_t c) {
    put_triangle(done_, sink_, corners_[a], corners_[b], corners_[c]);
  }

  // The lattice but for `margin` lines on each side.
  constexpr void put_lattice(std::size_t margin) {
    const std::size_t n = u_.places.size() - 2 * margin, m = v_.places.size() - 2 * margin;
    const std::span<P> line = std::span(room_).first(net_.columns),
                       work = std::span(room_).subspan(net_.columns, net_.columns),
                       along = std::span(room_).subspan(2 * net_.columns, net_.rows());
    for (std::size_t i = 0; i < n; ++i) {
      const auto at_u = curve_fraction<T>(u_[i + margin], patch_steps);
      for (std::size_t j = 0; j < net_.columns; ++j) {
        for (std::size_t k = 0; k < along.size(); ++k) along[k] = net_(k, j);
        reduce(along, 1, at_u);
        line[j] = along[0];
      }
      for (std::size_t j = 0; j < m; ++j) {
        const auto at_v = curve_fraction<T>(v_[j + margin], patch_steps);
        for (std::size_t k = 0; k < line.size(); ++k) work[k] = line[k];
        reduce(work, 1, at_v);
        corners_.push_back({corners_.size(), at_u, at_v, on_surface(work[0])});
      }
    }
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t j = 0; j + 1 < m; ++j) {
        const std::size_t a = i * m + j, b = a + m;
        put(a, b, b + 1);
        put(a, b + 1, a + 1);
      }
  }

  constexpr void put_frame() {
    const std::size_t m = v_.places.size() - 2, n = u_.places.size() - 2, base = corners_.size();
    for (const int u : {0, patch_steps})
      for (const int v : {0, patch_steps}) add_corner(u, v);
    for (int side = 0; side < 4; ++side) {
      const auto& out = outer(side);
      const int fixed = side % 2 == 1 ? patch_steps : 0;
      constexpr std::size_t begins[] = {0, 1, 0, 2}, ends[] = {2, 3, 1, 3};  // of the corners above
      const auto at_side = static_cast<std::size_t>(side);
      const std::size_t begin = base + begins[at_side], end = base + ends[at_side];
      const std::size_t first = corners_.size() - 1;  // of the border's places: first + k for 0 < k < last
      for (std::size_t k = 1; k + 1 < out.size(); ++k) {
        corner& c = side < 2 ? add_corner(out[k], fixed) : add_corner(fixed, out[k]);
        if (is_pole_[at_side]) c.point = corners_[begin].point;
      }
      const auto on_border = [&](std::size_t k) { return k == 0 ? begin : k + 1 == out.size() ? end : first + k; };
      const auto inside = [&](std::size_t j) {
        return side < 2 ? (j - 1) * m + (side == 1 ? m - 1 : 0) : (side == 3 ? (n - 1) * m : 0) + (j - 1);
      };
      const bool turned = side == 1 || side == 2;
      each_in_side(side, [&](bool outward, std::size_t k, std::size_t j) {
        const std::size_t a = on_border(k), b = outward ? on_border(k + 1) : inside(j + 1), c = inside(j);
        turned ? put(b, a, c) : put(a, b, c);
        return true;
      });
    }
  }

  control_net<P> net_;
  T tolerance_;
  Sink& sink_;
  patch_bends<P> bends_;
  patch_cuts u_, v_, border_[4];
  bool is_pole_[4]{};
  std::vector<P> room_;
  std::vector<corner> corners_{};
  surface_tessellation done_{};
};

template <CurvePoint P, class Sink>
constexpr surface_tessellation tessellate_net(const control_net<P>& net, scalar_of<P> tolerance, Sink& sink) {
  if (!has_finite_bends(net)) return {0, 0, false};
  if (net.rows() < 2 || net.columns < 2) return {};
  return framed_patch<P, Sink>(net, tolerance, sink).run();
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::inline IRG_ABI {

template <CurvePoint P, int U, int V>
[[nodiscard]] constexpr std::array<P, static_cast<std::size_t>((U + 1) * (V + 1))> net_of(
    const bezier_patch<P, U, V>& patch) noexcept {
  std::array<P, static_cast<std::size_t>((U + 1) * (V + 1))> list{};
  for (std::size_t i = 0; i <= static_cast<std::size_t>(U); ++i)
    for (std::size_t j = 0; j <= static_cast<std::size_t>(V); ++j)
      list[i * (static_cast<std::size_t>(V) + 1) + j] = patch.points[i][j];
  return list;
}

template <CurvePoint P, class Sink>
  requires detail::PlacedPoint<P> && Floating<scalar_of<P>>
constexpr surface_tessellation tessellate_within(const control_net<P>& net,
                                                 std::type_identity_t<scalar_of<P>> tolerance, Sink&& sink) {
  if constexpr (!IRG_BODIES && detail::CompiledControlPoint<P>)
    return detail::send_surface(
        net, tolerance,
        as_function<void(const surface_corner<P>&, const surface_corner<P>&, const surface_corner<P>&)>(sink));
  else
    return detail::tessellate_net(net, tolerance, sink);
}

template <CurvePoint P, int U, int V, class Sink>
  requires detail::PlacedPoint<P> && Floating<scalar_of<P>>
constexpr surface_tessellation tessellate_steps(const bezier_patch<P, U, V>& patch, int n, int m, Sink&& sink) {
  using T = scalar_of<P>;
  using corner = surface_corner<P>;
  IRG_EXPECTS(n > 0 && m > 0);
  const std::size_t columns = static_cast<std::size_t>(m) + 1;
  const auto net = net_of(patch);
  const std::span<const P> list(net);
  constexpr std::size_t row = static_cast<std::size_t>(V) + 1, last_row = static_cast<std::size_t>(U) * row;
  const bool v_begins = detail::is_pole(list, 0, row, static_cast<std::size_t>(U) + 1),
             v_ends = detail::is_pole(list, row - 1, row, static_cast<std::size_t>(U) + 1);
  std::vector<corner> rows(2 * columns, corner{});
  surface_tessellation done;
  for (int i = 0; i <= n; ++i) {
    const auto u = curve_fraction<T>(i, n);
    std::array<P, static_cast<std::size_t>(V) + 1> line{};
    for (std::size_t j = 0; j < line.size(); ++j) {
      std::array<P, static_cast<std::size_t>(U) + 1> along{};
      for (std::size_t k = 0; k < along.size(); ++k) along[k] = patch.points[k][j];
      detail::reduce(std::span<P>(along), 1, u);
      line[j] = along[0];
    }
    const std::span<corner> before = std::span(rows).subspan(i % 2 == 0 ? columns : 0, columns),
                            now = std::span(rows).subspan(i % 2 == 0 ? 0 : columns, columns);
    if (v_begins) line[0] = net[0];
    if (v_ends) line[row - 1] = net[row - 1];
    const bool is_one =
        (i == 0 && detail::is_pole(list, 0, 1, row)) || (i == n && detail::is_pole(list, last_row, 1, row));
    for (int j = 0; j <= m; ++j) {
      const auto v = curve_fraction<T>(j, m);
      auto work = line;
      if (!is_one) detail::reduce(std::span<P>(work), 1, v);
      now[static_cast<std::size_t>(j)] = {done.corners++, u, v, detail::on_surface(work[0])};
    }
    for (std::size_t j = 0; i > 0 && j + 1 < columns; ++j) {
      detail::put_triangle(done, sink, before[j], now[j], now[j + 1]);
      detail::put_triangle(done, sink, before[j], now[j + 1], before[j + 1]);
    }
  }
  return done;
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <CompiledControlPoint P>
IRG_API surface_tessellation send_surface(const control_net<P>& net, scalar_of<P> tolerance,
                                          const triangle_sink<P>& sink) {
  return tessellate_net(net, tolerance, sink);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
