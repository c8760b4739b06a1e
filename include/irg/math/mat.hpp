// SPDX-License-Identifier: MIT
// mat<T, R, C>: matrices of R rows and C columns that act on column vectors, M * v, so that the transformation written
// last is applied first. Points, directions and homogeneous points are told apart by type.
#pragma once

#include <limits>
#include <optional>

#include <irg/math/detail/float_bits.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// R rows of C numbers, stored row by row; `mat<double, 2, 2>{{{1, 2}, {3, 4}}}` has the rows (1, 2) and (3, 4).
template <Scalar T, int R, int C>
  requires(R >= 1 && C >= 1)
struct mat {
  T m[static_cast<std::size_t>(R)][static_cast<std::size_t>(C)]{};
  IRG_INLINE constexpr const T& operator()(int row, int column) const noexcept { return m[row][column]; }
  IRG_INLINE constexpr T& operator()(int row, int column) noexcept { return m[row][column]; }
  constexpr bool operator==(const mat&) const = default;
};

namespace detail {
inline namespace IRG_ABI {

template <class T>
IRG_INLINE constexpr T entry_size(const T& x) noexcept {
  return x < T(0) ? -x : x;
}

// The sum of a(k) * b(k) for k = 0 .. N - 1, from left to right.
template <int N, class A, class B>
IRG_INLINE constexpr auto sum_of_products(const A& a, const B& b) noexcept {
  auto sum = product(a(0), b(0));
  for (int k = 1; k < N; ++k) sum = sum + product(a(k), b(k));
  return sum;
}

// The matrix whose entry in row r and column c is f(r, c).
template <class T, int R, int C, class F>
IRG_INLINE constexpr mat<T, R, C> filled_mat(const F& f) noexcept {
  mat<T, R, C> entries{};
  for (int r = 0; r < R; ++r)
    for (int c = 0; c < C; ++c) entries(r, c) = f(r, c);
  return entries;
}

template <class T, int R, int C>
constexpr bool all_finite(const mat<T, R, C>& a) noexcept {
  if constexpr (Floating<T>)
    for (const auto& row : a.m)
      for (const T& entry : row)
        if (!is_finite(entry)) return false;
  return true;
}

// The row from k on whose entry in column k is largest.
template <class T, int N>
constexpr int pivot_row(const mat<T, N, N>& a, int k) noexcept {
  int best = k;
  for (int r = k + 1; r < N; ++r)
    if (entry_size(a(best, k)) < entry_size(a(r, k))) best = r;
  return best;
}

template <class T, int N>
constexpr void swap_rows(mat<T, N, N>& a, int r, int s) noexcept {
  for (int c = 0; c < N && r != s; ++c) {
    const T kept = a(r, c);
    a(r, c) = a(s, c);
    a(s, c) = kept;
  }
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The matrix that leaves everything where it is.
template <Scalar T, int N>
constexpr mat<T, N, N> identity() noexcept {
  return detail::filled_mat<T, N, N>([](int r, int c) { return r == c ? T(1) : T(0); });
}

/// The matrix with rows and columns exchanged.
template <class T, int R, int C>
constexpr mat<T, C, R> transpose(const mat<T, R, C>& a) noexcept {
  return detail::filled_mat<T, C, R>([&](int r, int c) { return a(c, r); });
}

template <class T, int R, int C>
constexpr mat<T, R, C> operator+(const mat<T, R, C>& a, const mat<T, R, C>& b) noexcept {
  return detail::filled_mat<T, R, C>([&](int r, int c) { return a(r, c) + b(r, c); });
}
template <class T, int R, int C>
constexpr mat<T, R, C> operator-(const mat<T, R, C>& a, const mat<T, R, C>& b) noexcept {
  return detail::filled_mat<T, R, C>([&](int r, int c) { return a(r, c) - b(r, c); });
}
template <class T, int R, int C>
constexpr mat<T, R, C> operator-(const mat<T, R, C>& a) noexcept {
  return detail::filled_mat<T, R, C>([&](int r, int c) { return -a(r, c); });
}
template <class T, int R, int C>
constexpr mat<T, R, C> operator*(const mat<T, R, C>& a, std::type_identity_t<T> s) noexcept {
  return detail::filled_mat<T, R, C>([&](int r, int c) { return product(a(r, c), s); });
}
template <class T, int R, int C>
constexpr mat<T, R, C> operator*(std::type_identity_t<T> s, const mat<T, R, C>& a) noexcept {
  return a * s;
}

/// The matrix that applies b first, then a.
/// exact   each product and each sum rounded once, sums from left to right
template <class T, int R, int K, int C>
constexpr mat<T, R, C> operator*(const mat<T, R, K>& a, const mat<T, K, C>& b) noexcept {
  return detail::filled_mat<T, R, C>([&](int r, int c) {
    return detail::sum_of_products<K>([&](int k) { return a(r, k); }, [&](int k) { return b(k, c); });
  });
}

/// The image of a vector.
/// exact   each product and each sum rounded once, sums from left to right
template <class T, int R, int C>
IRG_INLINE constexpr vec<T, R> operator*(const mat<T, R, C>& a, const vec<T, C>& v) noexcept {
  return generate_coordinates<vec<T, R>>(
      [&](int r) { return detail::sum_of_products<C>([&](int k) { return a(r, k); }, [&](int k) { return v[k]; }); });
}

/// The image of a homogeneous point; the matrix has one row and column more than the space has dimensions.
template <class T, int M, int N>
  requires(M == N + 1)
IRG_INLINE constexpr hpoint<T, N> operator*(const mat<T, M, M>& a, const hpoint<T, N>& p) noexcept {
  return generate_coordinates<hpoint<T, N>>(
      [&](int r) { return detail::sum_of_products<M>([&](int k) { return a(r, k); }, [&](int k) { return p[k]; }); });
}

/// The image of a point, a homogeneous point since the matrix may be projective. transform_point gives a point.
template <class T, int M, int N>
  requires(M == N + 1)
IRG_INLINE constexpr hpoint<T, N> operator*(const mat<T, M, M>& a, const point<T, N>& p) noexcept {
  return a * to_homogeneous(p);
}

/// The image of a position under an affine matrix, that is one with the last row 0 ... 0 1, which is not read.
/// shape   P is irg's point or any foreign Point with one coordinate less than the matrix has rows
template <class T, int M, Point P>
  requires(size_of<P> == M - 1 && std::same_as<scalar_of<P>, T>)
IRG_INLINE constexpr P transform_point(const mat<T, M, M>& a, const P& p) noexcept {
  return generate_coordinates<P>([&](int r) {
    return detail::sum_of_products<M - 1>([&](int k) { return a(r, k); }, [&](int k) { return coordinate(p, k); }) +
           a(r, M - 1);
  });
}

/// The image of a displacement under an affine matrix: translations leave it alone. Surface normals take
/// transform_normal (view/affine.hpp) instead.
template <class T, int M, Vector V>
  requires(size_of<V> == M - 1 && std::same_as<scalar_of<V>, T>)
IRG_INLINE constexpr V transform_vector(const mat<T, M, M>& a, const V& v) noexcept {
  return generate_coordinates<V>([&](int r) {
    return detail::sum_of_products<M - 1>([&](int k) { return a(r, k); }, [&](int k) { return coordinate(v, k); });
  });
}

/// The matrix without one row and one column.
template <class T, int N>
  requires(N >= 2)
constexpr mat<T, N - 1, N - 1> submatrix(const mat<T, N, N>& a, int row, int column) noexcept {
  return detail::filled_mat<T, N - 1, N - 1>(
      [&](int r, int c) { return a(r < row ? r : r + 1, c < column ? c : c + 1); });
}

/// The factor by which the matrix scales lengths, areas or volumes, negative when it turns left into right.
/// exact   in integers and rationals. In floats up to size 4 the error is at most 2u, 5u or 10u times the sum of the
///         absolute values of all 2, 6 or 24 products, barring over- and underflow (u = 2^-24 or 2^-53)
/// cost    up to size 4 no division; above it, elimination with partial pivoting
template <class T, int N>
  requires(N <= 4 || Real<T>)
constexpr T determinant(const mat<T, N, N>& a) noexcept {
  const auto minor = [&](int r, int c0, int c1) {
    return product(a(r, c0), a(r + 1, c1)) - product(a(r, c1), a(r + 1, c0));
  };
  if constexpr (N == 1) {
    return a(0, 0);
  } else if constexpr (N == 2) {
    return minor(0, 0, 1);
  } else if constexpr (N == 3) {
    return product(a(0, 0), minor(1, 1, 2)) - product(a(0, 1), minor(1, 0, 2)) + product(a(0, 2), minor(1, 0, 1));
  } else if constexpr (N == 4) {  // Laplace: minors of the upper two rows times minors of the lower two
    return product(minor(0, 0, 1), minor(2, 2, 3)) - product(minor(0, 0, 2), minor(2, 1, 3)) +
           product(minor(0, 0, 3), minor(2, 1, 2)) + product(minor(0, 1, 2), minor(2, 0, 3)) -
           product(minor(0, 1, 3), minor(2, 0, 2)) + product(minor(0, 2, 3), minor(2, 0, 1));
  } else {
    mat<T, N, N> rest = a;
    T factor = T(1);
    for (int k = 0; k < N; ++k) {
      const int pivot = detail::pivot_row(rest, k);
      if (rest(pivot, k) == T(0)) return T(0);
      if (pivot != k) factor = -factor;
      detail::swap_rows(rest, k, pivot);
      factor = product(factor, rest(k, k));
      for (int r = k + 1; r < N; ++r) {
        const T f = rest(r, k) / rest(k, k);
        for (int c = k; c < N; ++c) rest(r, c) = rest(r, c) - product(f, rest(k, c));
      }
    }
    return factor;
  }
}

/// The matrix of signed minors: its transpose times `a` is the determinant times the identity. It exists for singular
/// matrices too, and is what surface normals are transformed by.
template <class T, int N>
  requires(N == 2 || N == 3 || N == 4)
constexpr mat<T, N, N> cofactor_matrix(const mat<T, N, N>& a) noexcept {
  if constexpr (N == 3) {  // counting rows and columns round and round gives the signs without a negation
    constexpr int next[] = {1, 2, 0}, last[] = {2, 0, 1};
    return detail::filled_mat<T, 3, 3>([&](int r, int c) {
      return product(a(next[r], next[c]), a(last[r], last[c])) - product(a(next[r], last[c]), a(last[r], next[c]));
    });
  } else {
    return detail::filled_mat<T, N, N>([&](int r, int c) {
      const T minor = determinant(submatrix(a, r, c));
      return (r + c) % 2 == 0 ? minor : -minor;
    });
  }
}

/// The matrix that undoes `a`.
/// gives   nothing for a singular matrix. In floats also nothing when the result would have no correct digit (see
///         `exact`), when an entry is NaN or infinite, or when the inverse has an entry that is too large for T
/// exact   in rationals. In floats relative errors are about 8 u times the condition number; the condition that decides
///         whether a digit is correct, the largest sum of |x_ij * a_ji| over j for x = the inverse, must stay below
///         1/(2 N u). It does not depend on how rows and columns are scaled
/// cost    Gauss-Jordan elimination with partial pivoting, 2 N^3 operations
/// source  Higham, Accuracy and Stability of Numerical Algorithms, 2002, ch. 14; condition after Bauer, 1963
template <Real T, int N>
constexpr std::optional<mat<T, N, N>> inverse(const mat<T, N, N>& a) noexcept {
  if (!detail::all_finite(a)) return std::nullopt;
  mat<T, N, N> left = a, right = identity<T, N>();
  for (int k = 0; k < N; ++k) {
    const int pivot_at = detail::pivot_row(left, k);
    detail::swap_rows(left, k, pivot_at);
    detail::swap_rows(right, k, pivot_at);
    const T pivot = left(k, k);
    if (pivot == T(0)) return std::nullopt;
    for (int c = 0; c < N; ++c) {
      left(k, c) = left(k, c) / pivot;
      right(k, c) = right(k, c) / pivot;
    }
    for (int r = 0; r < N; ++r) {
      if (r == k) continue;
      const T f = left(r, k);
      for (int c = 0; c < N; ++c) {
        left(r, c) = left(r, c) - product(f, left(k, c));
        right(r, c) = right(r, c) - product(f, right(k, c));
      }
    }
  }
  if (!detail::all_finite(right)) return std::nullopt;
  if constexpr (Floating<T>) {
    for (int i = 0; i < N; ++i) {
      const T condition = detail::sum_of_products<N>([&](int j) { return detail::entry_size(right(i, j)); },
                                                     [&](int j) { return detail::entry_size(a(j, i)); });
      if (!(condition * (T(N) * std::numeric_limits<T>::epsilon()) < T(1))) return std::nullopt;
    }
  }
  return right;
}

}  // namespace IRG_ABI
}  // namespace irg
