// SPDX-License-Identifier: MIT
// The libraries of vectors and matrices that the studies are compared with, where they are installed: HAS_GLM, HAS_EIGEN.
#pragma once

#if __has_include(<glm/glm.hpp>)
#include <glm/glm.hpp>
#define HAS_GLM 1
#endif
#if __has_include(<eigen3/Eigen/LU>)
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12's own header for AVX-512, which Eigen calls
#endif
#include <eigen3/Eigen/Core>
#include <eigen3/Eigen/Geometry>
#include <eigen3/Eigen/LU>
#define HAS_EIGEN 1
#endif
