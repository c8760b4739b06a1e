// SPDX-License-Identifier: MIT
// mat<T, R, C>: matrices of R rows and C columns that act on column vectors, M * v, so that the transformation written
// last is applied first. Points, directions and homogeneous points are told apart by type.
#pragma once

#include <irg/math/detail/elimination.hpp>
#include <irg/math/detail/mat_kernel.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// R rows of C numbers, stored row by row; `mat<double, 2, 2>{{1, 2}, {3, 4}}` has the rows (1, 2) and (3, 4).
/// shape   more than four rows, and rows that are an array, in one more pair of braces; what is not given is 0
template <Scalar T, int R, int C>
  requires(R >= 1 && C >= 1)
struct mat {
  using entries = const T[static_cast<std::size_t>(C)];

  T m[static_cast<std::size_t>(R)][static_cast<std::size_t>(C)]{};

  constexpr mat() = default;
  IRG_INLINE constexpr mat(entries (&rows)[static_cast<std::size_t>(R)]) noexcept {
    for (int r = 0; r < R; ++r)
      for (int c = 0; c < C; ++c) m[r][c] = rows[r][c];
  }
  IRG_INLINE constexpr mat(entries& a) noexcept
    requires(R == 1 && C > 1)
  {
    for (int c = 0; c < C; ++c) m[0][c] = a[c];
  }
  IRG_INLINE constexpr mat(entries& a, entries& b) noexcept
    requires(R == 2)
  {
    for (int c = 0; c < C; ++c) m[0][c] = a[c], m[1][c] = b[c];
  }
  IRG_INLINE constexpr mat(entries& a, entries& b, entries& d) noexcept
    requires(R == 3)
  {
    for (int c = 0; c < C; ++c) m[0][c] = a[c], m[1][c] = b[c], m[2][c] = d[c];
  }
  IRG_INLINE constexpr mat(entries& a, entries& b, entries& d, entries& e) noexcept
    requires(R == 4)
  {
    for (int c = 0; c < C; ++c) m[0][c] = a[c], m[1][c] = b[c], m[2][c] = d[c], m[3][c] = e[c];
  }

  IRG_INLINE constexpr const T& operator()(int row, int column) const noexcept { return m[row][column]; }
  IRG_INLINE constexpr T& operator()(int row, int column) noexcept { return m[row][column]; }
  bool operator==(const mat&) const = default;
};

inline namespace IRG_ABI {

/// The matrix whose entry in row r and column c is f(r, c); f is called once for each, row by row.
template <Scalar T, int R, int C, class F>
[[nodiscard]] IRG_INLINE constexpr mat<T, R, C> generate_mat(const F& f) noexcept {
  mat<T, R, C> entries{};
  for (int r = 0; r < R; ++r)
    for (int c = 0; c < C; ++c) entries(r, c) = f(r, c);
  return entries;
}

/// The matrix that leaves everything where it is.
template <Scalar T, int N>
[[nodiscard]] constexpr mat<T, N, N> identity_matrix() noexcept {
  return generate_mat<T, N, N>([](int r, int c) { return r == c ? T(1) : T(0); });
}

/// Whether no entry is NaN or infinite.
template <class T, int R, int C>
[[nodiscard]] constexpr bool is_finite(const mat<T, R, C>& a) noexcept {
  return detail::entries_finite<T>(a, R, C);
}

/// The matrix with rows and columns exchanged.
template <class T, int R, int C>
[[nodiscard]] constexpr mat<T, C, R> transpose(const mat<T, R, C>& a) noexcept {
  return generate_mat<T, C, R>([&](int r, int c) { return a(c, r); });
}

template <class T, int R, int C>
[[nodiscard]] constexpr mat<T, R, C> operator+(const mat<T, R, C>& a, const mat<T, R, C>& b) noexcept {
  return generate_mat<T, R, C>([&](int r, int c) { return a(r, c) + b(r, c); });
}
template <class T, int R, int C>
[[nodiscard]] constexpr mat<T, R, C> operator-(const mat<T, R, C>& a, const mat<T, R, C>& b) noexcept {
  return generate_mat<T, R, C>([&](int r, int c) { return a(r, c) - b(r, c); });
}
template <class T, int R, int C>
[[nodiscard]] constexpr mat<T, R, C> operator-(const mat<T, R, C>& a) noexcept {
  return generate_mat<T, R, C>([&](int r, int c) { return -a(r, c); });
}
template <class T, int R, int C>
[[nodiscard]] constexpr mat<T, R, C> operator*(const mat<T, R, C>& a, std::type_identity_t<T> s) noexcept {
  return generate_mat<T, R, C>([&](int r, int c) { return product(a(r, c), s); });
}
template <class T, int R, int C>
[[nodiscard]] constexpr mat<T, R, C> operator*(std::type_identity_t<T> s, const mat<T, R, C>& a) noexcept {
  return a * s;
}

/// The matrix that applies b first, then a.
/// exact   each product and each sum rounded once, sums from left to right
template <class T, int R, int K, int C>
[[nodiscard]] IRG_INLINE constexpr mat<T, R, C> operator*(const mat<T, R, K>& a, const mat<T, K, C>& b) noexcept {
  mat<T, R, C> entries{};
  detail::multiply(a.m, b.m, entries.m);
  return entries;
}

/// The image of a vector.
/// exact   each product and each sum rounded once, sums from left to right
template <class T, int R, int C>
[[nodiscard]] IRG_INLINE constexpr vec<T, R> operator*(const mat<T, R, C>& a, const vec<T, C>& v) noexcept {
  return detail::image_of_row<vec<T, R>>(a.m, v);
}

/// The image of a homogeneous point; the matrix has one row and column more than the space has dimensions.
template <class T, int M, int N>
  requires(M == N + 1)
[[nodiscard]] IRG_INLINE constexpr hpoint<T, N> operator*(const mat<T, M, M>& a, const hpoint<T, N>& p) noexcept {
  return detail::image_of_row<hpoint<T, N>>(a.m, p);
}

/// The image of a point, a homogeneous point since the matrix may be projective. transform_point gives a point.
template <class T, int M, int N>
  requires(M == N + 1)
[[nodiscard]] IRG_INLINE constexpr hpoint<T, N> operator*(const mat<T, M, M>& a, const point<T, N>& p) noexcept {
  return detail::image_of_column<hpoint<T, N>, M>(a.m, [&](int k) IRG_INLINE_LAMBDA { return k < N ? p[k] : T(1); });
}

/// The image of a row vector, v * A * B being A first, then B: the form of lectures.
/// exact   bit for bit the column form of the transposed matrix, transpose(a) * v
template <class T, int R, int C>
[[nodiscard]] IRG_INLINE constexpr vec<T, C> operator*(const vec<T, R>& v, const mat<T, R, C>& a) noexcept {
  return transpose(a) * v;
}

/// The image of a homogeneous point as a row.
/// exact   bit for bit the column form of the transposed matrix
template <class T, int M, int N>
  requires(M == N + 1)
[[nodiscard]] IRG_INLINE constexpr hpoint<T, N> operator*(const hpoint<T, N>& p, const mat<T, M, M>& a) noexcept {
  return transpose(a) * p;
}

/// The image of a point as a row (x y z 1), a homogeneous point.
/// exact   bit for bit the column form of the transposed matrix
template <class T, int M, int N>
  requires(M == N + 1)
[[nodiscard]] IRG_INLINE constexpr hpoint<T, N> operator*(const point<T, N>& p, const mat<T, M, M>& a) noexcept {
  return transpose(a) * p;
}

/// The image of a position under an affine matrix, that is one with the last row 0 ... 0 1, which is not read.
/// shape   P is irg's point or any foreign Point with one coordinate less than the matrix has rows
template <class T, int M, Point P>
  requires(size_of<P> == M - 1 && std::same_as<scalar_of<P>, T>)
[[nodiscard]] IRG_INLINE constexpr P transform_point(const mat<T, M, M>& a, const P& p) noexcept {
  return detail::affine_image<P, M - 1, true>(a, [&](int k) IRG_INLINE_LAMBDA { return coordinate(p, k); });
}

/// The image of a displacement under an affine matrix: translations leave it alone. Surface normals take
/// transform_normal (view/affine.hpp) instead.
template <class T, int M, Vector V>
  requires(size_of<V> == M - 1 && std::same_as<scalar_of<V>, T>)
[[nodiscard]] IRG_INLINE constexpr V transform_vector(const mat<T, M, M>& a, const V& v) noexcept {
  return detail::affine_image<V, M - 1, false>(a, [&](int k) IRG_INLINE_LAMBDA { return coordinate(v, k); });
}

/// The matrix without one row and one column.
template <class T, int N>
  requires(N >= 2)
[[nodiscard]] constexpr mat<T, N - 1, N - 1> submatrix(const mat<T, N, N>& a, int row, int column) noexcept {
  return generate_mat<T, N - 1, N - 1>([&](int r, int c) { return a(r < row ? r : r + 1, c < column ? c : c + 1); });
}

/// The factor by which the matrix scales lengths, areas or volumes, negative when it turns left into right.
/// exact   in integers and rationals. In floats up to size 4 the error is at most 2u, 5u or 10u times the sum of the
///         absolute values of all 2, 6 or 24 products, barring over- and underflow (u = 2^-24 or 2^-53)
/// cost    up to size 4 no division; above it, elimination with partial pivoting
template <class T, int N>
  requires(N <= 4 || Real<T>)
[[nodiscard]] constexpr T determinant(const mat<T, N, N>& a) noexcept {
  const auto det = [&](int r, int c0, int c1) {
    return static_cast<T>(product(a(r, c0), a(r + 1, c1)) - product(a(r, c1), a(r + 1, c0)));
  };
  if constexpr (N == 1) {
    return a(0, 0);
  } else if constexpr (N == 2) {
    return det(0, 0, 1);
  } else if constexpr (N == 3) {
    return static_cast<T>(product(a(0, 0), det(1, 1, 2)) - product(a(0, 1), det(1, 0, 2)) +
                          product(a(0, 2), det(1, 0, 1)));
  } else if constexpr (N == 4) {  // Laplace: minors of the upper two rows times minors of the lower two
    return static_cast<T>(product(det(0, 0, 1), det(2, 2, 3)) - product(det(0, 0, 2), det(2, 1, 3)) +
                          product(det(0, 0, 3), det(2, 1, 2)) + product(det(0, 1, 2), det(2, 0, 3)) -
                          product(det(0, 1, 3), det(2, 0, 2)) + product(det(0, 2, 3), det(2, 0, 1)));
  } else {
    mat<T, N, N> rest = a;
    return detail::eliminated_determinant<T>(rest, N);
  }
}

/// The matrix of signed minors: its transpose times `a` is the determinant times the identity. It exists for singular
/// matrices too, and is what surface normals are transformed by.
template <class T, int N>
  requires(N == 2 || N == 3 || N == 4)
[[nodiscard]] constexpr mat<T, N, N> cofactor_matrix(const mat<T, N, N>& a) noexcept {
  if constexpr (N == 3) {  // counting rows and columns round and round gives the signs without a negation
    constexpr int next[] = {1, 2, 0}, last[] = {2, 0, 1};
    return generate_mat<T, 3, 3>([&](int r, int c) {
      return product(a(next[r], next[c]), a(last[r], last[c])) - product(a(next[r], last[c]), a(last[r], next[c]));
    });
  } else {
    return generate_mat<T, N, N>([&](int r, int c) {
      const T det = determinant(submatrix(a, r, c));
      return (r + c) % 2 == 0 ? det : -det;
    });
  }
}

/// Writes the rows, "((1, 2), (3, 4))".
template <class S, class T, int R, int C>
  requires TextStream<S, T>
constexpr S& operator<<(S& stream, const mat<T, R, C>& m) {
  return print_list(stream, R, [&](int r) { return generate_coordinates<vec<T, C>>([&](int c) { return m(r, c); }); });
}

IRG_REFUSES_VECTORS(transform_point);
IRG_REFUSES_POINTS(transform_vector);

}  // namespace IRG_ABI
}  // namespace irg
