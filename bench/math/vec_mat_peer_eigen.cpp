// SPDX-License-Identifier: MIT
#if defined(IRG_HAVE_EIGEN)
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#endif

#include "math/vec_mat.hpp"

namespace bench {

#if defined(IRG_HAVE_EIGEN)
template <class T>
struct eigen_library {
  using v3 = Eigen::Matrix<T, 3, 1>;
  using v4 = Eigen::Matrix<T, 4, 1>;
  using m4 = Eigen::Matrix<T, 4, 4>;
  static v3 make3(const std::array<T, 3>& c) { return v3(c[0], c[1], c[2]); }
  static v4 make4(const std::array<T, 4>& c) { return v4(c[0], c[1], c[2], c[3]); }
  static m4 make16(const std::array<T, 16>& c) {
    m4 m;
    for (int i = 0; i < 16; ++i) m(i / 4, i % 4) = c[static_cast<std::size_t>(i)];
    return m;
  }
  static T get3(const v3& v, int i) { return v[i]; }
  static T get4(const v4& v, int i) { return v[i]; }
  static T get16(const m4& m, int i) { return m(i / 4, i % 4); }
  static T dot(const v3& a, const v3& b) { return a.dot(b); }
  static v3 cross(const v3& a, const v3& b) { return a.cross(b); }
  static T length(const v3& a) { return a.norm(); }
  static v3 normalize(const v3& a) { return a.normalized(); }
  static v4 apply(const m4& m, const v4& v) { return m * v; }
  static m4 multiply(const m4& a, const m4& b) { return a * b; }
  static m4 inverse(const m4& m) { return m.inverse(); }
  static v3 transform(const m4& m, const v3& p) {
    return m.template topLeftCorner<3, 3>() * p + m.template topRightCorner<3, 1>();
  }
};
#endif

template <class T>
static void enter(vec_mat_entries& to, const vec_mat_input<T>& in) {
#if defined(IRG_HAVE_EIGEN)
  enter_library<eigen_library<T>>(to, in, "Eigen");
#else
  static_cast<void>(to);
  static_cast<void>(in);
#endif
}

void enter_eigen(vec_mat_entries& to, const vec_mat_input<float>& in) { enter<float>(to, in); }
void enter_eigen(vec_mat_entries& to, const vec_mat_input<double>& in) { enter<double>(to, in); }

}  // namespace bench
