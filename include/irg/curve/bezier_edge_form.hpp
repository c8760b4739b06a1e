// SPDX-License-Identifier: MIT
// Bezier curves in Bezier's own form: p(t) = a_0 + sum a_i f_{i,n}(t), where a_0 is the first control point, a_i the
// edge from control point i - 1 to i, and f_{i,n} the sum of the Bernstein polynomials b_{j,n} with j >= i. Unlike
// these the weights f fall with i from 1 to t^n.
#pragma once

#include <cstddef>
#include <span>

#include <irg/curve/bezier.hpp>

namespace irg {

/// What edges and position vectors of points P are: vec for point, else P itself.
template <CurvePoint P>
using edge_of = typename detail::displacement_of<P>::type;

inline namespace IRG_ABI {

/// The edge vectors of a control polygon: edges[0] is the first point's position, edges[i] leads from point i - 1 to i.
/// needs   edges at least as long as points
/// exact   each difference rounded once
/// source  Bezier 1972; Mihajlovic 2016, 6.1
template <ControlPoints R>
constexpr void edges_of_control_polygon(const R& points, std::span<edge_of<control_point<R>>> edges) noexcept {
  const std::size_t n = ring_traits<R>::size(points);
  IRG_EXPECTS(edges.size() >= n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto to = ring_traits<R>::vertex(points, k);
    const auto from = ring_traits<R>::vertex(points, k > 0 ? k - 1 : 0);
    edges[k] = generate_coordinates<edge_of<control_point<R>>>(
        [&](int i) { return k > 0 ? coordinate(to, i) - coordinate(from, i) : coordinate(to, i); });
  }
}

/// The control points that have these edge vectors, the way back from edges_of_control_polygon.
/// needs   points at least as long as edges
/// exact   sums in order, each rounded once; the very same points where no difference had to be rounded
template <ControlPoints R, CurvePoint P>
constexpr void control_polygon_of_edges(const R& edges, std::span<P> points) noexcept {
  const std::size_t n = ring_traits<R>::size(edges);
  IRG_EXPECTS(points.size() >= n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto edge = ring_traits<R>::vertex(edges, k);
    points[k] = generate_coordinates<P>(
        [&](int i) { return k > 0 ? coordinate(points[k - 1], i) + coordinate(edge, i) : coordinate(edge, i); });
  }
}

/// Bezier's weight f_{i,n}(t) by the closed formula ((-t)^i / (i-1)!) d^(i-1)/dt^(i-1) of (1 - (1-t)^n) / (-t), carried
/// out: t^i times the sum over m = 0..n-i of C(m+i-1, m) (1-t)^m, which divides by nothing that can be 0.
/// gives   1 for i <= 0, 0 for i > n
/// exact   no term is negative within [0, 1]: relative error below 6*n*u, unless a factor underflows
/// cost    n - i steps and i products
/// source  Bezier 1972; Mihajlovic 2016, 6.1 (2)
template <Real T>
[[nodiscard]] constexpr T bezier_weight(int n, int i, T t) noexcept {
  if (i <= 0) return T(1);
  if (i > n) return T(0);
  const T rest = T(1) - t;
  T term = 1, sum = 1;
  for (int m = 1; m <= n - i; ++m) {
    term = product(product(term, static_cast<T>(m + i - 1)) / static_cast<T>(m), rest);
    sum = sum + term;
  }
  for (int k = 0; k < i; ++k) sum = product(sum, t);
  return sum;
}

/// All of Bezier's weights of degree weights.size() - 1 at t, by f_{i,n} = (1-t) f_{i,n-1} + t f_{i-1,n-1} with
/// f_{0,n} = 1 and f_{n+1,n} = 0.
/// needs   one weight or more
/// exact   within [0, 1] relative error below 3*n*u, unless one underflows; weights[0] is 1
/// cost    n*(n + 1)/2 steps
/// source  Mihajlovic 2016, 6.1 (3)
template <Real T>
constexpr void bezier_weights(std::type_identity_t<curve_parameter<T>> t, std::span<T> weights) noexcept {
  IRG_EXPECTS(!weights.empty());
  weights[0] = T(1);
  for (std::size_t n = 1; n < weights.size(); ++n) {
    weights[n] = product(t.t, weights[n - 1]);
    for (std::size_t done = 1; done < n; ++done) {
      const std::size_t i = n - done;
      weights[i] = product(t.rest, weights[i]) + product(t.t, weights[i - 1]);
    }
  }
}

/// The point (its position vector) at t of the Bezier curve that has these edge vectors.
/// needs   one edge vector or more; weights as long as edges, their contents are lost
/// exact   error below (4n + 2)*u times the sum of |a_i| f_i within [0, 1]: more than bezier_point's, because a sum of
///         edges is large where a curve comes back to where it was
/// cost    n*(n + 1)/2 steps and n + 1 products a coordinate
/// source  Bezier 1972; Mihajlovic 2016, 6.1 (1)
template <ControlPoints R>
constexpr control_point<R> bezier_point_of_edges(const R& edges, parameter_of<R> t,
                                                 std::span<scalar_of<control_point<R>>> weights) noexcept {
  const auto f = weights.first(ring_traits<R>::size(edges));
  bezier_weights<scalar_of<control_point<R>>>(t, f);
  return generate_coordinates<control_point<R>>([&](int axis) {
    auto sum = coordinate(ring_traits<R>::vertex(edges, 0), axis);
    for (std::size_t i = 1; i < f.size(); ++i)
      sum = sum + product(coordinate(ring_traits<R>::vertex(edges, i), axis), f[i]);
    return sum;
  });
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <ControlPoints R, WorkspaceFor<R> W = workspace_for<R>>
[[nodiscard]] constexpr control_point<R> bezier_point_of_edges(const R& edges, parameter_of<R> t, W&& memory = W{}) {
  return bezier_point_of_edges(edges, t, detail::room_for(memory.numbers, edges));
}

}  // namespace IRG_ABI
}  // namespace irg
