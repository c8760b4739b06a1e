// SPDX-License-Identifier: MIT
// How far matrices and the axes of cameras are from turns, and from each other: the greatest difference of an entry.
#pragma once

#include <irg/view/camera_frame.hpp>

namespace test {

// The rows of the upper left 3 x 3, each with each, from 1 and 0.
template <class T>
constexpr double from_orthonormal(const irg::mat<T, 4, 4>& m) {
  const auto a = submatrix(m, 3, 3);
  const auto gram = a * transpose(a);
  double worst = 0;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const double off = static_cast<double>(gram(r, c)) - (r == c ? 1 : 0);
      worst = irg::maximum(worst, off < 0 ? -off : off);
    }
  return worst;
}

// The same of the axes, and how far right x up is from the direction against the view.
template <class T>
constexpr double from_orthonormal(const irg::camera_frame<T>& f) {
  const irg::vec<T, 3> back = -f.forward, across = cross(f.right, f.up);
  double worst = from_orthonormal(irg::mat<T, 4, 4>{
      {{f.right.x, f.right.y, f.right.z, 0}, {f.up.x, f.up.y, f.up.z, 0}, {back.x, back.y, back.z, 0}, {0, 0, 0, 1}}});
  for (int i = 0; i < 3; ++i) {
    const double off = static_cast<double>(across[i] - back[i]);
    worst = irg::maximum(worst, off < 0 ? -off : off);
  }
  return worst;
}

template <class T>
constexpr double worst_difference(const irg::mat<T, 4, 4>& a, const irg::mat<T, 4, 4>& b) {
  double worst = 0;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) {
      const double off = static_cast<double>(a(r, c)) - static_cast<double>(b(r, c));
      worst = irg::maximum(worst, off < 0 ? -off : off);
    }
  return worst;
}

}  // namespace test
