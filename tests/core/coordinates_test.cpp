// SPDX-License-Identifier: MIT
#include <limits>
#include <irg/core/coordinates.hpp>

#include <array>
#include <complex>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/own_types.hpp"

namespace {

using irg::coordinate_kind;

using plain2 = own::plain2<float>;
using plain3 = own::plain3<double>;
using plain4 = own::plain4<int>;
struct vertex {  // coordinates with passengers: readable, and made with the passengers' defaults
  float x = 0, y = 0, z = 0;
  std::uint32_t colour = 7;
  int kind = 5;  // of no concern to irg
};
struct tagged {
  static constexpr int kind = 3;  // likewise
  float x, y;
};
struct marked_point {
  static constexpr coordinate_kind kind = coordinate_kind::point;
  float x, y;
};
struct base {
  float x, y;
};
struct derived : base {
  constexpr derived(float a, float b) : base{a, b} {}
};

struct rectangle {  // as SDL_Rect: w is a width
  int x, y, w, h;
};
struct extended {  // as GdkRectangle, and Rectangle of raylib
  float x, y, width, height;
};
struct weighted {  // as a homogeneous point of the plane, perhaps: to be said, not guessed
  float x, y, w;
};
struct mixed {
  float x, y;
  int z;
};
struct mixed4 {
  float x, y, z;
  int w;
};
struct flags2 {
  bool x, y;
};
struct only_x {
  float x;
};
struct methods {
  float x() const;
  float y() const;
};
class unmakeable {
public:
  float x = 0, y = 0;
  unmakeable(const std::string&);
};

// 1. Each concept both ways.
static_assert(irg::Vector<plain2> && irg::Point<plain2> && !irg::HomogeneousPoint<plain2>);
static_assert(irg::Vector<plain3> && irg::Point<plain3> && irg::HomogeneousPoint<plain3>);
static_assert(irg::Vector<plain4> && irg::Point<plain4> && irg::HomogeneousPoint<plain4>);
static_assert(irg::Vector<vertex> && irg::Vector<tagged> && irg::Vector<derived>);
static_assert(irg::Vector<std::array<double, 3>> && irg::Vector<std::array<int, 9>> &&
              irg::Vector<std::array<float, 1>>);
static_assert(irg::size_of<plain2> == 2 && irg::size_of<plain3> == 3 && irg::size_of<plain4> == 4);
static_assert(irg::size_of<vertex> == 3 && irg::size_of<std::array<int, 9>> == 9);
static_assert(std::same_as<irg::scalar_of<plain3>, double> && std::same_as<irg::scalar_of<std::array<int, 9>>, int>);

static_assert(irg::Point<marked_point> && !irg::Vector<marked_point>);
static_assert(irg::coordinate_traits<vertex>::kind == coordinate_kind::any);
static_assert(irg::coordinate_traits<tagged>::kind == coordinate_kind::any);

static_assert(!irg::Coordinates<rectangle> && !irg::Coordinates<extended> && !irg::Coordinates<weighted>);
static_assert(!irg::Coordinates<mixed> && !irg::Coordinates<mixed4>);
static_assert(!irg::Coordinates<flags2> && !irg::Coordinates<std::array<bool, 3>>);
static_assert(!irg::Coordinates<only_x> && !irg::Coordinates<methods> && !irg::Coordinates<unmakeable>);
static_assert(!irg::Coordinates<std::array<float, 0>> && !irg::Coordinates<std::array<std::string, 2>>);
static_assert(!irg::Coordinates<std::vector<float>> && !irg::Coordinates<float> && !irg::Coordinates<float*>);
static_assert(!irg::Coordinates<std::complex<float>> && !irg::Coordinates<std::pair<int, int>> &&
              !irg::Coordinates<void>);

using poor_vector = archetype::vector<archetype::scalar, 3>;
using poor_point = archetype::point<archetype::scalar, 2>;
using poor_homogeneous = archetype::homogeneous_point<archetype::scalar, 4>;
static_assert(irg::Vector<poor_vector> && !irg::Point<poor_vector> && !irg::HomogeneousPoint<poor_vector>);
static_assert(!irg::Vector<poor_point> && irg::Point<poor_point> && !irg::HomogeneousPoint<poor_point>);
static_assert(!irg::Vector<poor_homogeneous> && !irg::Point<poor_homogeneous> &&
              irg::HomogeneousPoint<poor_homogeneous>);
static_assert(!irg::Coordinates<archetype::pixel>);

// The coordinates 10, 20, ... written to a T and read back.
template <class T>
constexpr bool round_trip() {
  using scalar = irg::scalar_of<T>;
  const T made = irg::generate_coordinates<T>([](int i) { return scalar(10 * (i + 1)); });
  for (int i = 0; i < irg::size_of<T>; ++i)
    if (!(irg::coordinate(made, i) == scalar(10 * (i + 1)))) return false;
  return true;
}

}  // namespace

TEST_CASE("coordinates: plain structs, arrays and archetypes are read and made") {
  CHECK_BOTH((round_trip<plain2>() && round_trip<plain3>() && round_trip<plain4>()));
  CHECK_BOTH((round_trip<std::array<double, 1>>() && round_trip<std::array<std::int8_t, 7>>()));
  CHECK_BOTH((round_trip<tagged>() && round_trip<marked_point>() && round_trip<derived>()));
  CHECK_BOTH((round_trip<poor_vector>() && round_trip<poor_point>() && round_trip<poor_homogeneous>()));
}

TEST_CASE("same_place, comes_before: coordinate by coordinate; NaN is nowhere") {
  using A = std::array<double, 3>;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(irg::same_place(A{0.0, 1, 2}, A{-0.0, 1, 2}));
  CHECK_BOTH(!irg::same_place(A{0, 1, 2}, A{0, 1, 3}));
  CHECK_BOTH(!irg::same_place(A{nan, 1, 2}, A{nan, 1, 2}));
  CHECK_BOTH(irg::comes_before(A{0, 1, 2}, A{0, 1, 3}));
  CHECK_BOTH(irg::comes_before(A{-1, 9, 9}, A{0, 1, 3}));
  CHECK_BOTH(!irg::comes_before(A{0, 1, 3}, A{0, 1, 3}));
  CHECK_BOTH(!irg::comes_before(A{nan, 1, 2}, A{0, 2, 3}));
  CHECK_BOTH(!irg::comes_before(A{0, 1, 2}, A{nan, 2, 3}));
}

TEST_CASE("coordinates: each keeps its place") {
  CHECK_BOTH(irg::from_coordinates<plain3>(1, 2.5f, 3.0).y == 2.5);
  CHECK_BOTH(irg::from_coordinates<plain4>(1, 2, 3, 4).w == 4);
  CHECK_BOTH(irg::coordinate(plain4{5, 6, 7, 8}, 0) == 5);
  CHECK_BOTH(irg::coordinate(plain4{5, 6, 7, 8}, 3) == 8);
  CHECK_BOTH(irg::coordinate(plain2{5, 6}, 1) == 6.0f);
}

TEST_CASE("coordinates: passengers get their defaults") {
  CHECK_BOTH((irg::from_coordinates<vertex>(1, 2, 3).z == 3.0f && irg::from_coordinates<vertex>(1, 2, 3).colour == 7));
}

TEST_CASE("coordinates: noexcept follows the type") {
  CHECK_BOTH((noexcept(irg::coordinate(std::declval<plain3>(), 0)) && noexcept(irg::from_coordinates<plain2>(1, 2))));
  CHECK_BOTH(!noexcept(irg::coordinate(std::declval<const poor_vector&>(), 0)));  // a user's code may throw
}

TEST_CASE("coordinates: GLM") {
#ifdef IRG_HAVE_GLM
  static_assert(irg::Vector<glm::vec2> && irg::Point<glm::vec2> && !irg::HomogeneousPoint<glm::vec2>);
  static_assert(irg::Vector<glm::vec3> && irg::Point<glm::vec3> && irg::Vector<glm::dvec3> && irg::Vector<glm::ivec2>);
  static_assert(irg::Vector<glm::vec4> && irg::HomogeneousPoint<glm::vec4> && irg::HomogeneousPoint<glm::dvec4>);
  static_assert(irg::size_of<glm::vec2> == 2 && irg::size_of<glm::dvec3> == 3 && irg::size_of<glm::vec4> == 4);
  static_assert(std::same_as<irg::scalar_of<glm::dvec3>, double> && std::same_as<irg::scalar_of<glm::vec4>, float>);
  static_assert(!irg::Coordinates<glm::bvec3> && !irg::Coordinates<glm::mat3>);
  CHECK_BOTH((round_trip<glm::vec2>() && round_trip<glm::vec3>() && round_trip<glm::vec4>()));
  CHECK_BOTH((round_trip<glm::dvec3>() && round_trip<glm::ivec2>()));
#else
  MESSAGE("skipped: GLM was not found");
#endif
}

TEST_CASE("coordinates: Eigen") {
#ifdef IRG_HAVE_EIGEN
  static_assert(irg::Vector<Eigen::Vector2f> && irg::Point<Eigen::Vector3d> && irg::HomogeneousPoint<Eigen::Vector4d>);
  static_assert(irg::Vector<Eigen::Matrix<double, 7, 1>> && irg::Vector<Eigen::Vector2i>);
  static_assert(irg::size_of<Eigen::Vector2f> == 2 && std::same_as<irg::scalar_of<Eigen::Vector2f>, float>);
  static_assert(!irg::Coordinates<Eigen::VectorXf>);      // its size is known at run time only
  static_assert(!irg::Coordinates<Eigen::RowVector3f>);   // irg's vectors are columns
  static_assert(!irg::Coordinates<Eigen::Matrix3f> && !irg::Coordinates<Eigen::MatrixXd>);
  CHECK(round_trip<Eigen::Vector2f>());
  CHECK(round_trip<Eigen::Vector3d>());
  CHECK(round_trip<Eigen::Vector4d>());
  CHECK(round_trip<Eigen::Matrix<double, 7, 1>>());
#else
  MESSAGE("skipped: Eigen was not found");
#endif
}

TEST_CASE("coordinates: OpenCV's points") {
#ifdef IRG_HAVE_OPENCV
  static_assert(irg::Point<cv::Point2f> && irg::Point<cv::Point> && irg::Vector<cv::Point3d>);
  static_assert(!irg::Coordinates<cv::Rect>);    // no point, although it has x and y
  static_assert(!irg::Coordinates<cv::Vec3f>);   // admitted by a line of traits: docs/own-types.md
  CHECK(round_trip<cv::Point2f>());
  CHECK(round_trip<cv::Point3d>());
#else
  MESSAGE("skipped: OpenCV was not found");
#endif
}

TEST_CASE("CoordinatesOfKind: what says so, and no type that may be a vector or a point") {
  static_assert(!irg::CoordinatesOfKind<plain3, coordinate_kind::point>);
  static_assert(!irg::CoordinatesOfKind<plain3, coordinate_kind::vector>);
  static_assert(irg::CoordinatesOfKind<plain3, coordinate_kind::any>);
  static_assert(!irg::CoordinatesOfKind<int, coordinate_kind::any>);
}
