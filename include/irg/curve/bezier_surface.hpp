// SPDX-License-Identifier: MIT
// Tensor-product Bezier patches: bicubic by default, any pair of degrees by choice, or of degrees known when running.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/curve/bezier.hpp>
#include <irg/curve/detail/parallel_vectors.hpp>
#include <irg/math/length.hpp>

namespace irg {

/// A patch of degree U along u and V along v.
/// shape   points[i][j]: i runs along u, j along v; points[0][0] is at (0, 0), points[U][V] at (1, 1)
template <CurvePoint P, int U = 3, int V = U>
  requires(U >= 1 && V >= 1)
struct bezier_patch {
  std::array<std::array<P, static_cast<std::size_t>(V) + 1>, static_cast<std::size_t>(U) + 1> points{};
  bool operator==(const bezier_patch&) const = default;
};

/// Control points of a surface in rows, referring to yours: points[i * columns + j], i along u, j along v.
/// needs   as many points as rows times columns, columns > 0
template <CurvePoint P>
struct control_net {
  std::span<const P> points{};
  std::size_t columns = 1;
  [[nodiscard]] IRG_APART constexpr std::size_t rows() const noexcept { return points.size() / columns; }
  IRG_APART constexpr const P& operator()(std::size_t i, std::size_t j) const noexcept {
    return points[i * columns + j];
  }
};

/// A point of a surface with the first derivatives along u and v and the mixed second one.
template <CurvePoint P>
struct surface_sample {
  using vector = typename detail::displacement_of<P>::type;
  P point{};
  vector du{}, dv{}, duv{};
  bool operator==(const surface_sample&) const = default;
};

namespace detail::inline IRG_ABI {

// The sample from the two chords along u of every column, or from one row twice for degree 0 along u. Both are lost.
template <CurvePoint P>
constexpr surface_sample<P> sample_of_chords(std::span<P> first_row, std::span<P> last_row, int degree_u,
                                             const curve_parameter<scalar_of<P>>& u,
                                             const curve_parameter<scalar_of<P>>& v) noexcept {
  const int degree_v = static_cast<int>(first_row.size()) - 1;
  const std::size_t last = degree_v > 0 ? 1 : 0;
  reduce(first_row, last + 1, v);
  reduce(last_row, last + 1, v);
  const auto blended = [](const P& a, const P& b, const auto& at, int degree) {
    return degree > 0 ? blend(a, b, at) : a;
  };
  const P near_v = blended(first_row[0], first_row[last], v, degree_v),
          far_v = blended(last_row[0], last_row[last], v, degree_v);
  const P u_near = blended(first_row[0], last_row[0], u, degree_u),
          u_far = blended(first_row[last], last_row[last], u, degree_u);
  const auto at_near = scaled_difference(first_row[0], first_row[last], degree_v),
             at_far = scaled_difference(last_row[0], last_row[last], degree_v);
  return {blended(near_v, far_v, u, degree_u), scaled_difference(near_v, far_v, degree_u),
          scaled_difference(u_near, u_far, degree_v), scaled_difference(at_near, at_far, degree_u)};
}

// How many points patch_sample works in.
template <CurvePoint P>
constexpr std::size_t sample_room(const control_net<P>& net) noexcept {
  return 2 * net.columns + net.rows();
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The point of the patch at (u, v) with its derivatives, by de Casteljau's algorithm along u, then along v.
/// needs   nothing; outside [0, 1] the polynomial continues
/// exact   corners bit for bit; a border depends on that border's control points alone and equals the curve's
///         bezier_point bit for bit, so that patches that share border points share the border without a gap
/// cost    bicubic: 36 blends of points
/// source  de Casteljau 1959; Farin 2002
template <CurvePoint P, int U, int V>
[[nodiscard]] constexpr surface_sample<P> patch_sample(const bezier_patch<P, U, V>& patch,
                                                       curve_parameter<scalar_of<P>> u,
                                                       curve_parameter<scalar_of<P>> v) noexcept {
  // Two chords along u for every j, then two chords of each along v: the bilinear net that touches the patch here.
  std::array<P, static_cast<std::size_t>(V) + 1> first_row{}, last_row{};
  for (std::size_t j = 0; j <= static_cast<std::size_t>(V); ++j) {
    std::array<P, static_cast<std::size_t>(U) + 1> along{};
    for (std::size_t i = 0; i <= static_cast<std::size_t>(U); ++i) along[i] = patch.points[i][j];
    detail::reduce(std::span<P>(along), 2, u);
    first_row[j] = along[0];
    last_row[j] = along[1];
  }
  return detail::sample_of_chords(std::span<P>(first_row), std::span<P>(last_row), U, u, v);
}

/// The point at (u, v) of the Bezier surface that these points control, with its derivatives; any degree from 0.
/// needs   one or more rows and columns; scratch for 2 * columns + rows points, its contents are lost
/// exact   as the form with a patch, and equal to it bit for bit
template <CurvePoint P>
constexpr surface_sample<P> patch_sample(const control_net<P>& net,
                                         std::type_identity_t<curve_parameter<scalar_of<P>>> u,
                                         std::type_identity_t<curve_parameter<scalar_of<P>>> v,
                                         std::type_identity_t<std::span<P>> scratch) noexcept {
  const std::size_t rows = net.rows(), columns = net.columns;
  IRG_EXPECTS(rows > 0 && scratch.size() >= detail::sample_room(net));
  const auto first_row = scratch.first(columns), last_row = scratch.subspan(columns, columns),
             along = scratch.subspan(2 * columns, rows);
  for (std::size_t j = 0; j < columns; ++j) {
    for (std::size_t i = 0; i < rows; ++i) along[i] = net(i, j);
    detail::reduce(along, 2, u);
    first_row[j] = along[0];
    last_row[j] = along[rows > 1 ? 1 : 0];
  }
  return detail::sample_of_chords(first_row, last_row, static_cast<int>(rows) - 1, u, v);
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <CurvePoint P, WorkspaceFor<P> W = curve_workspace<P>>
[[nodiscard]] constexpr surface_sample<P> patch_sample(const control_net<P>& net, curve_parameter<scalar_of<P>> u,
                                                       curve_parameter<scalar_of<P>> v, W&& memory = W{}) {
  return patch_sample(net, u, v, detail::room_for(memory.points, detail::sample_room(net)));
}

/// The point of the patch at (u, v).
/// exact   as patch_sample
template <CurvePoint P, int U, int V>
[[nodiscard]] constexpr P patch_point(const bezier_patch<P, U, V>& patch, curve_parameter<scalar_of<P>> u,
                                      curve_parameter<scalar_of<P>> v) noexcept {
  return patch_sample(patch, u, v).point;
}

/// The normal of length 1 at (u, v): the direction of du x dv, seen from whose tip v lies counter-clockwise of u. Where
/// one derivative is zero, as along a border that has shrunk to a point, it is the limit from inside the patch.
/// gives   nothing where that limit needs derivatives beyond the mixed one, the two derivatives are parallel, or one is
///         not finite
/// exact   a cross product and try_normalized of the derivatives in s
template <CartesianPoint P>
  requires(size_of<P> == 3 && Floating<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<typename surface_sample<P>::vector> surface_normal(
    const surface_sample<P>& s, curve_parameter<scalar_of<P>> u, curve_parameter<scalar_of<P>> v) noexcept {
  using vector = typename surface_sample<P>::vector;
  const auto is_zero = [](const vector& d) {
    return coordinate(d, 0) == 0 && coordinate(d, 1) == 0 && coordinate(d, 2) == 0;
  };
  // Near v = 0, du = v * duv to first order; near v = 1 it is (v - 1) * duv; likewise dv.
  const auto inward = [&](const curve_parameter<scalar_of<P>>& p) {
    return p.t < p.rest ? s.duv : generate_coordinates<vector>([&](int i) { return -coordinate(s.duv, i); });
  };
  if (is_zero(s.du) && is_zero(s.dv)) return std::nullopt;
  const vector along_u = is_zero(s.du) ? inward(v) : s.du;
  const vector along_v = is_zero(s.dv) ? inward(u) : s.dv;
  const auto first = try_normalized(along_u), second = try_normalized(along_v);
  if (!first || !second) return std::nullopt;
  const vector across = cross(*first, *second);
  // So small it may be what the directions were rounded by.
  if (length_squared(across) <= std::numeric_limits<scalar_of<P>>::epsilon() && detail::are_parallel(along_u, along_v))
    return std::nullopt;
  return try_normalized(across);
}

/// The normal of length 1 of the patch at (u, v).
/// gives   and is exact as surface_normal
template <CartesianPoint P, int U, int V>
  requires(size_of<P> == 3 && Floating<scalar_of<P>>)
[[nodiscard]] constexpr auto patch_normal(const bezier_patch<P, U, V>& patch, curve_parameter<scalar_of<P>> u,
                                          curve_parameter<scalar_of<P>> v) noexcept {
  return surface_normal(patch_sample(patch, u, v), u, v);
}

/// Evaluates the patch on a lattice of n by m cells: calls visit(i, j, sample) for i = 0..n and j = 0..m, j fastest, at
/// u = i/n and v = j/m.
/// needs   n > 0, m > 0
/// exact   as patch_sample at curve_fraction: mirrored patches have mirrored lattices bit for bit
/// cost    (n + 1)*(m + 1) samples
template <CurvePoint P, int U, int V, class Visit>
constexpr void tessellate(const bezier_patch<P, U, V>& patch, int n, int m, Visit&& visit) {
  IRG_EXPECTS(n > 0 && m > 0);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      visit(i, j, patch_sample(patch, curve_fraction<scalar_of<P>>(i, n), curve_fraction<scalar_of<P>>(j, m)));
}

}  // namespace IRG_ABI
}  // namespace irg
