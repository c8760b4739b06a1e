// SPDX-License-Identifier: MIT
// matrix<T>: a matrix whose numbers of rows and columns are known only at run time. Operations whose operands do not
// fit, or that have no result, say so in what they return; only memory that cannot be had is an exception. Where sizes
// are known to the compiler, mat<T, R, C> (math/mat.hpp) is the type to use: there, what does not fit does not compile.
#pragma once

#include <utility>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/result.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/solve.hpp>

namespace irg {

/// Why an operation on matrices has no result.
enum class [[nodiscard]] matrix_error {
  size_mismatch,  // the operands' numbers of rows and columns do not fit
  not_square,
  singular,  // there is no inverse
  dependent,  // a system of equations has infinitely many solutions
  inconsistent,  // a system of equations has none
  not_finite  // a number is NaN or infinite, or the result is too large
};

/// Rows of numbers, stored row by row.
template <Scalar T>
class matrix {
public:
  using value_type = T;

  constexpr matrix() = default;
  /// A matrix of zeros.
  /// needs   rows >= 0, columns >= 0
  IRG_INLINE constexpr matrix(int rows, int columns)
      : rows_(rows), columns_(columns), entries_(size_of_entries(rows, columns), T(0)) {}
  /// The entries of a matrix of fixed size.
  template <int R, int C>
  IRG_INLINE constexpr explicit matrix(const mat<T, R, C>& a) : matrix(R, C) {
    for (int r = 0; r < R; ++r)
      for (int c = 0; c < C; ++c) (*this)(r, c) = a(r, c);
  }

  [[nodiscard]] IRG_INLINE constexpr int rows() const noexcept { return rows_; }
  [[nodiscard]] IRG_INLINE constexpr int columns() const noexcept { return columns_; }
  /// needs   0 <= row < rows(), 0 <= column < columns()
  IRG_INLINE constexpr const T& operator()(int row, int column) const noexcept { return entries_[index(row, column)]; }
  IRG_INLINE constexpr T& operator()(int row, int column) noexcept { return entries_[index(row, column)]; }
  bool operator==(const matrix&) const = default;

private:
  [[nodiscard]] IRG_APART static constexpr std::size_t size_of_entries(int rows, int columns) {
    IRG_EXPECTS(rows >= 0 && columns >= 0);
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  }
  [[nodiscard]] IRG_INLINE constexpr std::size_t index(int row, int column) const noexcept {
    IRG_EXPECTS(row >= 0 && row < rows_ && column >= 0 && column < columns_);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  int rows_ = 0, columns_ = 0;
  std::vector<T> entries_;
};

/// A matrix, or why there is none.
template <Scalar T>
using matrix_result = result<matrix<T>, matrix_error>;

namespace detail::inline IRG_ABI {

// The rows x columns matrix whose entries are f(row, column).
template <class T, class F>
constexpr matrix<T> filled_matrix(int rows, int columns, const F& f) {
  matrix<T> a(rows, columns);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) a(r, c) = f(r, c);
  return a;
}

// The determinant of n x n integers without fractions: every division below leaves no rest.
template <class T>
constexpr T integer_determinant(matrix<T>& a, int n) noexcept {
  T last = T(1), sign = T(1);
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    while (pivot < n && a(pivot, k) == T(0)) ++pivot;
    if (pivot == n) return T(0);
    if (pivot != k) sign = static_cast<T>(-sign);
    swap_rows(a, k, pivot, n);
    for (int r = k + 1; r < n; ++r)
      for (int c = k + 1; c < n; ++c) a(r, c) = static_cast<T>((a(r, c) * a(k, k) - a(r, k) * a(k, c)) / last);
    last = a(k, k);
  }
  return static_cast<T>(sign * last);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The n x n matrix that leaves everything where it is.
/// needs   n >= 0
template <Scalar T>
[[nodiscard]] constexpr matrix<T> identity_matrix(int n) {
  return detail::filled_matrix<T>(n, n, [](int r, int c) { return r == c ? T(1) : T(0); });
}

/// a + b.
/// gives   size_mismatch when a and b differ in size
template <class T>
[[nodiscard]] constexpr matrix_result<T> add(const matrix<T>& a, const matrix<T>& b) {
  if (a.rows() != b.rows() || a.columns() != b.columns()) return matrix_error::size_mismatch;
  return detail::filled_matrix<T>(a.rows(), a.columns(), [&](int r, int c) { return a(r, c) + b(r, c); });
}

/// a - b.
/// gives   size_mismatch when a and b differ in size
template <class T>
[[nodiscard]] constexpr matrix_result<T> subtract(const matrix<T>& a, const matrix<T>& b) {
  if (a.rows() != b.rows() || a.columns() != b.columns()) return matrix_error::size_mismatch;
  return detail::filled_matrix<T>(a.rows(), a.columns(), [&](int r, int c) { return a(r, c) - b(r, c); });
}

/// a * b: b applied first to a column, a first to a row.
/// gives   size_mismatch when a has not as many columns as b has rows
/// exact   each product and each sum rounded once, sums from left to right
template <class T>
[[nodiscard]] constexpr matrix_result<T> multiply(const matrix<T>& a, const matrix<T>& b) {
  if (a.columns() != b.rows()) return matrix_error::size_mismatch;
  return detail::filled_matrix<T>(a.rows(), b.columns(), [&](int r, int c) {
    if (a.columns() == 0) return T(0);
    T sum = product(a(r, 0), b(0, c));
    for (int k = 1; k < a.columns(); ++k) sum = sum + product(a(r, k), b(k, c));
    return sum;
  });
}

/// other * a: the product with the other factor in front.
/// gives   size_mismatch when `other` has not as many columns as a has rows
template <class T>
[[nodiscard]] constexpr matrix_result<T> pre_multiply(const matrix<T>& a, const matrix<T>& other) {
  return multiply(other, a);
}

/// Every entry times s.
template <class T>
[[nodiscard]] constexpr matrix<T> multiply(const matrix<T>& a, const std::type_identity_t<T>& s) {
  return detail::filled_matrix<T>(a.rows(), a.columns(), [&](int r, int c) { return product(a(r, c), s); });
}

/// Every entry times a whole number.
template <class T>
  requires(!std::same_as<T, int>)
[[nodiscard]] constexpr matrix<T> multiply(const matrix<T>& a, std::same_as<int> auto s) {
  return multiply(a, static_cast<T>(s));
}

/// The matrix with rows and columns exchanged.
template <class T>
[[nodiscard]] constexpr matrix<T> transpose(const matrix<T>& a) {
  return detail::filled_matrix<T>(a.columns(), a.rows(), [&](int r, int c) { return a(c, r); });
}

/// The determinant.
/// gives   not_square; 1 for the matrix without rows
/// exact   in rationals, and in integers while the minors' products fit into T; in floats by elimination with partial
///         pivoting, backward stable, and may overflow or underflow where the product of the pivots does
/// cost    n^3/3 multiplications
template <class T>
[[nodiscard]] constexpr result<T, matrix_error> determinant(const matrix<T>& a) {
  if (a.rows() != a.columns()) return matrix_error::not_square;
  matrix<T> rest = a;
  if constexpr (std::integral<T>)
    return detail::integer_determinant(rest, a.rows());
  else
    return detail::eliminated_determinant<T>(rest, a.rows());
}

/// The matrix that undoes a.
/// gives   not_square; not_finite when an entry is NaN or infinite or the inverse too large; singular as `inverse` of
///         mat: in floats also when no digit would be right
/// exact   as `inverse` of mat
/// cost    2 n^3 operations
template <Real T>
[[nodiscard]] constexpr matrix_result<T> inverse(const matrix<T>& a) {
  const int n = a.rows();
  if (n != a.columns()) return matrix_error::not_square;
  if (!detail::entries_finite<T>(a, n, n)) return matrix_error::not_finite;
  matrix<T> left = a, right = identity_matrix<T>(n);
  bool is_regular = detail::gauss_jordan<T>(left, right, n);
  if constexpr (Floating<T>) {
    // A pivot that overflows leaves zeros in `right` and a NaN in `left`: once more, nearer to the middle of the range.
    if (!detail::entries_finite<T>(left, n, n) || !detail::entries_finite<T>(right, n, n)) {
      T largest = T(0);
      for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) largest = maximum(detail::entry_size(a(r, c)), largest);
      const T scale = static_cast<T>(largest < static_cast<T>(sizeof(T) == 4 ? 0x1p32 : 0x1p512) ? 0x1p64 : 0x1p-64);
      left = multiply(a, scale);
      right = identity_matrix<T>(n);
      is_regular = detail::gauss_jordan<T>(left, right, n);
      right = multiply(right, scale);
    }
  }
  if (!is_regular) return matrix_error::singular;
  if (!detail::entries_finite<T>(left, n, n) || !detail::entries_finite<T>(right, n, n))
    return matrix_error::not_finite;
  if (!detail::inverse_has_digits<T>(a, right, n)) return matrix_error::singular;
  return right;
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// The column of the n numbers x(i), or why there is none.
template <Real T, class X>
constexpr matrix_result<T> solution_column(system_status status, int n, const X& x) {
  if (status == system_status::dependent) return matrix_error::dependent;
  if (status == system_status::inconsistent) return matrix_error::inconsistent;
  if (status == system_status::not_finite) return matrix_error::not_finite;
  matrix<T> solution = filled_matrix<T>(n, 1, [&](int r, int) { return static_cast<T>(x(r)); });
  if (!entries_finite<T>(solution, n, 1)) return matrix_error::not_finite;
  return solution;
}

template <Floating T, int N, class E>
constexpr matrix_result<T> solve_of_size(const E& entry) {
  const auto s = solve_gauss(generate_mat<T, N, N + 1>([&](int r, int c) { return static_cast<T>(entry(r, c)); }));
  return solution_column<T>(s.status, N, [&](int i) { return s.x[i]; });
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The column x with a * x = b.
/// gives   size_mismatch when b is no column of as many rows as a, not_square; dependent, inconsistent and not_finite
///         as solve_gauss
/// exact   as solve_gauss
template <Real T>
[[nodiscard]] constexpr matrix_result<T> solve(const matrix<T>& a, const matrix<T>& b) {
  const int n = a.rows();
  if (n != a.columns()) return matrix_error::not_square;
  if (b.columns() != 1 || b.rows() != n) return matrix_error::size_mismatch;
  using W = std::conditional_t<std::same_as<T, float>, double, T>;
  const auto entry = [&](int r, int c) { return static_cast<W>(c < n ? a(r, c) : b(r, 0)); };
  if constexpr (Floating<T>) {
    if (n == 2) return detail::solve_of_size<T, 2>(entry);
    if (n == 3) return detail::solve_of_size<T, 3>(entry);
    if (n == 4) return detail::solve_of_size<T, 4>(entry);
  }
  auto rows = detail::filled_matrix<W>(n, n + 1, entry);
  if (!detail::entries_finite<W>(rows, n, n + 1)) return matrix_error::not_finite;
  std::vector<int> numbers(4 * static_cast<std::size_t>(n), 0);
  std::vector<W> largest_term(static_cast<std::size_t>(n), W(0));
  matrix<W> x(n, 1);
  const detail::elimination_space<W> space{numbers.data(), numbers.data() + 2 * n, largest_term.data()};
  const detail::eliminated found = detail::solve_rows(rows, entry, n, space, [&](int i) -> W& { return x(i, 0); });
  return detail::solution_column<T>(found.status, n, [&](int i) { return x(i, 0); });
}

}  // namespace IRG_ABI
}  // namespace irg
