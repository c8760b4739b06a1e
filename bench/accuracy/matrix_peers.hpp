// SPDX-License-Identifier: MIT
// The libraries of vectors and matrices that the studies are compared with, where they are installed.
#pragma once

#ifdef IRG_HAVE_GLM
#include <glm/glm.hpp>
#endif
#ifdef IRG_HAVE_EIGEN
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12's own header for AVX-512, which Eigen calls
#endif
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#endif
