// SPDX-License-Identifier: MIT
// Matrices whose sizes do not fit do not compile. CASE 0 is the control and compiles.
#include <irg/math/inverse.hpp>
#include <irg/math/solve.hpp>

template <int R, int C>
using mat = irg::mat<double, R, C>;

void use() {
#if CASE == 0
  (void)(mat<2, 3>{} * mat<3, 2>{});
  (void)(irg::vec<double, 2>{} * mat<2, 3>{});
  (void)irg::solve_gauss(mat<3, 4>{});
#elif CASE == 1
  // expect: (no match for .operator\*.|invalid operands)
  (void)(mat<2, 3>{} * mat<2, 3>{});
#elif CASE == 2
  // expect: (no match for .operator\+.|invalid operands)
  (void)(mat<2, 3>{} + mat<3, 2>{});
#elif CASE == 3
  // expect: (no match for .operator-.|invalid operands)
  (void)(mat<2, 2>{} - mat<3, 3>{});
#elif CASE == 4  // a row of three times a matrix of two rows
  // expect: (no match for .operator\*.|invalid operands)
  (void)(irg::vec<double, 3>{} * mat<2, 3>{});
#elif CASE == 5  // a point in space is no row of a 3x3 matrix: say whether it is linear or projective
  // expect: (no match for .operator\*.|invalid operands)
  (void)(irg::point<double, 3>{} * mat<3, 3>{});
#elif CASE == 6
  // expect: no matching function for call to .*determinant
  (void)determinant(mat<2, 3>{});
#elif CASE == 7
  // expect: no matching function for call to .*inverse
  (void)inverse(mat<3, 4>{});
#elif CASE == 8  // two equations for three unknowns
  // expect: no matching function for call to .*solve_gauss
  (void)irg::solve_gauss(mat<2, 4>{});
#elif CASE == 9  // integers have no inverse
  // expect: no matching function for call to .*inverse
  (void)inverse(irg::mat<int, 2, 2>{});
#elif CASE == 10  // a matrix has at least one row and one column
  // expect: (constraint failure|constraints not satisfied)
  mat<0, 2> none;
#endif
}
