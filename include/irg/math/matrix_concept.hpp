// SPDX-License-Identifier: MIT
// Matrices of others, of a size that the compiler knows. The one customisation point is matrix_traits<T>; it fits
// Eigen's of fixed size, cv::Matx and GLM's. to_mat makes irg's own of one, from_mat one of irg's own.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include <irg/math/mat.hpp>

namespace irg {

namespace detail {

template <class T>
concept entered_by_call = requires(const T& m) { requires Number<std::remove_cvref_t<decltype(m(0, 0))>>; };
// Columns of numbers, as in GLM, which names its types of column and row.
template <class T>
concept has_columns = requires(const T& m) {
  requires Coordinates<typename T::col_type> && Coordinates<typename T::row_type>;
  requires std::same_as<std::remove_cvref_t<decltype(m[0])>, typename T::col_type>;
};

}  // namespace detail

/// How irg reads and writes a matrix. Members: scalar, rows, columns, get(m, row, column), set(m, row, column, x).
template <class T>
struct matrix_traits {};

// Eigen's.
template <class T>
  requires(detail::entered_by_call<T> && T::RowsAtCompileTime >= 1 && T::ColsAtCompileTime >= 1)
struct matrix_traits<T> {
  using scalar = std::remove_cvref_t<decltype(std::declval<const T&>()(0, 0))>;
  static constexpr int rows = T::RowsAtCompileTime, columns = T::ColsAtCompileTime;
  IRG_INLINE static constexpr scalar get(const T& m, int row, int column) { return m(row, column); }
  IRG_INLINE static constexpr void set(T& m, int row, int column, const scalar& x) { m(row, column) = x; }
};

// irg's own and OpenCV's.
template <template <class, int, int> class M, class S, int R, int C>
  requires detail::entered_by_call<M<S, R, C>>
struct matrix_traits<M<S, R, C>> {
  using scalar = S;
  static constexpr int rows = R, columns = C;
  IRG_INLINE static constexpr S get(const M<S, R, C>& m, int row, int column) { return m(row, column); }
  IRG_INLINE static constexpr void set(M<S, R, C>& m, int row, int column, const S& x) { m(row, column) = x; }
};

template <detail::has_columns T>
struct matrix_traits<T> {
  using scalar = scalar_of<typename T::col_type>;
  static constexpr int rows = size_of<typename T::col_type>, columns = size_of<typename T::row_type>;
  IRG_INLINE static constexpr scalar get(const T& m, int row, int column) { return m[column][row]; }
  IRG_INLINE static constexpr void set(T& m, int row, int column, const scalar& x) { m[column][row] = x; }
};

/// A matrix of fixed size. Models: mat, glm::dmat4, Eigen::Matrix3f, cv::Matx33d.
template <class T>
concept Matrix = std::default_initializable<T> && requires(const T& m, T& to) {
  requires Scalar<typename matrix_traits<T>::scalar>;
  requires(matrix_traits<T>::rows >= 1 && matrix_traits<T>::columns >= 1);
  { matrix_traits<T>::get(m, 0, 0) } -> std::convertible_to<typename matrix_traits<T>::scalar>;
  matrix_traits<T>::set(to, 0, 0, matrix_traits<T>::get(m, 0, 0));
};

inline namespace IRG_ABI {

/// irg's own of a matrix of any type, with the same entries: row by row, whatever the type's own order.
template <Matrix M>
[[nodiscard]] constexpr auto to_mat(const M& m) {
  using traits = matrix_traits<M>;
  return generate_mat<typename traits::scalar, traits::rows, traits::columns>(
      [&](int r, int c) { return traits::get(m, r, c); });
}

/// A matrix of any type with the entries of a: `from_mat<glm::dmat4>(a)`.
template <Matrix M, class T, int R, int C>
  requires(matrix_traits<M>::rows == R && matrix_traits<M>::columns == C &&
           std::same_as<typename matrix_traits<M>::scalar, T>)
[[nodiscard]] constexpr M from_mat(const mat<T, R, C>& a) {
  M m{};
  for (int r = 0; r < R; ++r)
    for (int c = 0; c < C; ++c) matrix_traits<M>::set(m, r, c, a(r, c));
  return m;
}

}  // namespace IRG_ABI
}  // namespace irg
