// SPDX-License-Identifier: MIT
#include <irg/math/matrix_concept.hpp>

#include <array>

#include "support/check_both.hpp"
#include "support/own_types.hpp"

namespace {

// Row by row in one array, and told to irg below.
struct table {
  std::array<double, 6> entries{};
};
struct pair_of_numbers {
  double a, b;
};

constexpr irg::mat<double, 2, 3> counted{{1, 2, 3}, {4, 5, 6}};

// There and back, and an entry in its place.
template <class M>
constexpr bool goes_both_ways(const M& m) {
  return irg::to_mat(irg::from_mat<M>(irg::to_mat(m))) == irg::to_mat(m);
}

}  // namespace

template <>
struct irg::matrix_traits<table> {
  using scalar = double;
  static constexpr int rows = 2, columns = 3;
  static constexpr double get(const table& t, int r, int c) { return t.entries[static_cast<std::size_t>(3 * r + c)]; }
  static constexpr void set(table& t, int r, int c, double x) { t.entries[static_cast<std::size_t>(3 * r + c)] = x; }
};

static_assert(irg::Matrix<table> && irg::Matrix<irg::mat<int, 2, 2>>);
static_assert(!irg::Matrix<double> && !irg::Matrix<pair_of_numbers> && !irg::Matrix<irg::vec<double, 3>>);
static_assert(!irg::Matrix<std::array<double, 9>> && !irg::Matrix<std::array<std::array<double, 3>, 3>>);

TEST_CASE("matrix_concept: a type that traits describe, and irg's own") {
  CHECK_BOTH(irg::to_mat(table{{1, 2, 3, 4, 5, 6}}) == counted);
  CHECK_BOTH(irg::from_mat<table>(counted).entries == std::array<double, 6>{1, 2, 3, 4, 5, 6});
  CHECK_BOTH(goes_both_ways(counted));
}

#ifdef IRG_HAVE_GLM
TEST_CASE("matrix_concept: GLM's, which stand column by column") {
  static_assert(irg::Matrix<glm::dmat4> && irg::Matrix<glm::mat3x2>);
  glm::dmat3x2 m(1, 4, 2, 5, 3, 6);  // three columns of two
  CHECK(irg::to_mat(m) == counted);
  CHECK(irg::from_mat<glm::dmat3x2>(counted) == m);
  glm::dmat4 move(1);
  move[3] = {7, 8, 9, 1};
  CHECK(irg::transform_point(irg::to_mat(move), irg::point<double, 3>{1, 1, 1}) == irg::point<double, 3>{8, 9, 10});
  CHECK(goes_both_ways(move));
}
#endif

#ifdef IRG_HAVE_EIGEN
TEST_CASE("matrix_concept: Eigen's of fixed size") {
  static_assert(irg::Matrix<Eigen::Matrix4d> && !irg::Matrix<Eigen::MatrixXd>);
  Eigen::Matrix<double, 2, 3> m;
  m << 1, 2, 3, 4, 5, 6;
  CHECK(irg::to_mat(m) == counted);
  CHECK(irg::from_mat<Eigen::Matrix<double, 2, 3>>(counted) == m);
  CHECK(irg::to_mat(Eigen::Matrix<float, 2, 2, Eigen::RowMajor>(Eigen::Matrix2f::Identity())) ==
        irg::identity_matrix<float, 2>());
}
#endif

#ifdef IRG_HAVE_OPENCV
TEST_CASE("matrix_concept: cv::Matx") {
  static_assert(irg::Matrix<cv::Matx44f> && !irg::Matrix<cv::Mat> && !irg::Matrix<cv::Mat_<double>>);
  const cv::Matx<double, 2, 3> m(1, 2, 3, 4, 5, 6);
  CHECK(irg::to_mat(m) == counted);
  CHECK(irg::from_mat<cv::Matx<double, 2, 3>>(counted) == m);
}
#endif
