// SPDX-License-Identifier: MIT
// GLM's types and operations; Q chooses between packed ones and those that fill registers.
#pragma once

#include <glm/glm.hpp>

#include "math/vec_mat.hpp"

namespace bench {

template <class T, glm::qualifier Q>
struct glm_library {
  using v3 = glm::vec<3, T, Q>;
  using v4 = glm::vec<4, T, Q>;
  using m4 = glm::mat<4, 4, T, Q>;
  static v3 make3(const std::array<T, 3>& c) { return v3(c[0], c[1], c[2]); }
  static v4 make4(const std::array<T, 4>& c) { return v4(c[0], c[1], c[2], c[3]); }
  static m4 make16(const std::array<T, 16>& c) {
    m4 m;
    for (std::size_t i = 0; i < 16; ++i) m[static_cast<int>(i % 4)][static_cast<int>(i / 4)] = c[i];
    return m;
  }
  static T get3(const v3& v, int i) { return v[i]; }
  static T get4(const v4& v, int i) { return v[i]; }
  static T get16(const m4& m, int i) { return m[i % 4][i / 4]; }
  static T dot(const v3& a, const v3& b) { return glm::dot(a, b); }
  static v3 cross(const v3& a, const v3& b) { return glm::cross(a, b); }
  static T length(const v3& a) { return glm::length(a); }
  static v3 normalize(const v3& a) { return glm::normalize(a); }
  static v4 apply(const m4& m, const v4& v) { return m * v; }
  static m4 multiply(const m4& a, const m4& b) { return a * b; }
  static m4 inverse(const m4& m) { return glm::inverse(m); }
  static v3 transform(const m4& m, const v3& p) { return v3(m * v4(p, T(1))); }
};

}  // namespace bench
