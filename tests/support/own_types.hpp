// SPDX-License-Identifier: MIT
// Types that are not irg's, in one place: GLM's, Eigen's and OpenCV's where they are installed, and plain structs whose
// members irg finds by their names. What knows less than these stands in archetypes.hpp.
#pragma once

#ifdef IRG_HAVE_GLM
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#endif
#ifdef IRG_HAVE_EIGEN
#include <Eigen/Core>
#endif
#ifdef IRG_HAVE_OPENCV
#include <opencv2/core.hpp>
#endif

namespace own {

template <class T>
struct plain2 {
  T x, y;
};
template <class T>
struct plain3 {
  T x, y, z;
};
template <class T>
struct plain4 {
  T x, y, z, w;
};
struct plain_cell {
  int x, y;
};
struct plain_plane {
  double a, b, c, d;
};

}  // namespace own
