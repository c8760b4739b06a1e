// SPDX-License-Identifier: MIT
// math: constexpr elementary functions, error-free arithmetic, decimal text, vectors, matrices.
#pragma once

#include <irg/math/constants.hpp>
#include <irg/math/decimal.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exponential.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/math/vec.hpp>
