// SPDX-License-Identifier: MIT
// math: constexpr elementary functions, exact and doubled arithmetic, decimal text, vec, mat, solving, polynomials.
#pragma once

#include <irg/math/compensated.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/coordinate_system.hpp>
#include <irg/math/decimal.hpp>
#include <irg/math/determinant_exact.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact_sum.hpp>
#include <irg/math/expansion.hpp>
#include <irg/math/exponential.hpp>
#include <irg/math/homogeneous.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/int128.hpp>
#include <irg/math/interval.hpp>
#include <irg/math/inverse.hpp>
#include <irg/math/inverse_exact.hpp>
#include <irg/math/length.hpp>
#include <irg/math/lu.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/matrix.hpp>
#include <irg/math/polynomial.hpp>
#include <irg/math/roots.hpp>
#include <irg/math/solve.hpp>
#include <irg/math/solve_exact.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/transform_points.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/math/vec.hpp>
#include <irg/math/vector_batch.hpp>
#include <irg/math/vector_projection.hpp>
#include <irg/math/wide_int.hpp>
#include <irg/math/textbook/roots.hpp>
#include <irg/math/textbook/solve_gauss.hpp>
