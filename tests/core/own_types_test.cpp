// SPDX-License-Identifier: MIT
// The snippets of docs/own-types.md, between [name] and [/name], quoted there verbatim.
#include <irg/core/coordinates.hpp>
#include <irg/core/mesh_concept.hpp>
#include <irg/core/plane_concept.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/matrix_concept.hpp>
#include <irg/math/vec.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/view_opencv.hpp>
#include <irg/raster/view_sdl.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#ifdef IRG_HAVE_OPENCV
#include <opencv2/core.hpp>
#endif
#ifdef IRG_HAVE_SDL2
#include <SDL2/SDL_surface.h>
#endif

#include "support/check_both.hpp"

// [vector]
namespace my {
struct vector3 {
  float x, y, z;
};
}  // namespace my

constexpr float length_squared = irg::dot(my::vector3{1, 2, 3}, my::vector3{1, 2, 3});
constexpr my::vector3 normal = irg::cross(my::vector3{1, 0, 0}, my::vector3{0, 1, 0});
// [/vector]
static_assert(length_squared == 14 && normal.z == 1);

// [odd vector]
namespace my {
class direction {  // no x, y, z to be seen
public:
  constexpr direction(double east, double north, double up) : east_(east), north_(north), up_(up) {}
  constexpr double along(int axis) const { return axis == 0 ? east_ : axis == 1 ? north_ : up_; }

private:
  double east_, north_, up_;
};
}  // namespace my

template <>
struct irg::coordinate_traits<my::direction> {
  using scalar = double;
  static constexpr int size = 3;
  static constexpr auto kind = irg::coordinate_kind::vector;
  static constexpr double get(const my::direction& d, int i) { return d.along(i); }
  static constexpr my::direction make(double e, double n, double u) { return {e, n, u}; }
};
// [/odd vector]
static_assert(irg::Vector<my::direction> && !irg::Point<my::direction>);
static_assert(irg::cross(my::direction(1, 0, 0), my::direction(0, 1, 0)).along(2) == 1);

// [point]
namespace my {
struct position {
  static constexpr auto kind = irg::coordinate_kind::point;
  double x, y;
};
}  // namespace my

static_assert(irg::Point<my::position> && !irg::Vector<my::position>);
// [/point]

#ifdef IRG_HAVE_OPENCV
// [cv::Vec]
template <class T, int N>
struct irg::coordinate_traits<cv::Vec<T, N>> {
  using scalar = T;
  static constexpr int size = N;
  static constexpr auto kind = irg::coordinate_kind::any;
  static T get(const cv::Vec<T, N>& v, int i) { return v[i]; }
  template <class... S>
    requires(sizeof...(S) == N)
  static cv::Vec<T, N> make(S... c) {
    return cv::Vec<T, N>(static_cast<T>(c)...);
  }
};
// [/cv::Vec]
static_assert(irg::Vector<cv::Vec3f> && irg::Point<cv::Vec2d>);
#endif

// [plane]
namespace my {
struct wall {  // all points p with dot(normal, p) == distance
  vector3 normal;
  float distance;
};
}  // namespace my

template <>
struct irg::plane_traits<my::wall> {
  using scalar = float;
  static constexpr float coefficient(const my::wall& w, int i) {
    return i == 3 ? -w.distance : irg::coordinate(w.normal, i);
  }
};
// [/plane]
static_assert(irg::Plane<my::wall> && irg::plane_coefficient(my::wall{{0, 1, 0}, 5}, 3) == -5);

// [matrix]
namespace my {
struct pose {  // the first three rows of a 4x4 matrix, row by row; the last one is 0 0 0 1
  std::array<double, 12> entries;
};
}  // namespace my

template <>
struct irg::matrix_traits<my::pose> {
  using scalar = double;
  static constexpr int rows = 3, columns = 4;
  static constexpr double get(const my::pose& m, int row, int column) {
    return m.entries[static_cast<std::size_t>(4 * row + column)];
  }
  static constexpr void set(my::pose& m, int row, int column, double x) {
    m.entries[static_cast<std::size_t>(4 * row + column)] = x;
  }
};

constexpr irg::mat<double, 3, 4> as_rows = irg::to_mat(my::pose{{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7}});
constexpr my::pose back = irg::from_mat<my::pose>(as_rows);
// [/matrix]
static_assert(as_rows(1, 3) == 6 && back.entries[11] == 7);

// [ring]
namespace my {
struct corner {
  short x, y;
  corner* next;
};
struct outline {  // any container will do; this one has to be told
  corner* first;
  int corners;
};
}  // namespace my

template <>
struct irg::ring_traits<my::outline> {
  using point = irg::point<short, 2>;
  static std::size_t size(const my::outline& o) { return static_cast<std::size_t>(o.corners); }
  static point vertex(const my::outline& o, std::size_t i) {
    const my::corner* c = o.first;
    for (; i > 0; --i) c = c->next;
    return {c->x, c->y};
  }
};
// [/ring]
static_assert(irg::PolygonRing<my::outline>);

// [mesh]
namespace my {
struct model {
  std::vector<vector3> vertices;
  std::vector<int> indices;  // three to a triangle, counter-clockwise seen from outside
};
}  // namespace my

template <>
struct irg::mesh_traits<my::model> {
  using point = my::vector3;
  static std::size_t vertex_count(const my::model& m) { return m.vertices.size(); }
  static const my::vector3& position(const my::model& m, std::size_t v) { return m.vertices[v]; }
  static std::size_t face_count(const my::model& m) { return m.indices.size() / 3; }
  static std::size_t face_size(const my::model&, std::size_t) { return 3; }
  static int face_vertex(const my::model& m, std::size_t f, std::size_t k) { return m.indices[3 * f + k]; }
};
// [/mesh]
static_assert(irg::Mesh<my::model>);

// [raster]
namespace my {
class canvas {
public:
  int width() const { return 80; }
  int height() const { return 24; }
  char& operator()(int x, int y) { return text_[y][x]; }
  char operator()(int x, int y) const { return text_[y][x]; }
  char* row(int y) { return text_[y]; }                // not needed, but faster
  std::ptrdiff_t bytes_per_row() const { return 80; }  // not needed, but lines are faster still

private:
  char text_[24][80] = {};
};
}  // namespace my

static_assert(irg::EvenRowRaster<my::canvas>);
// [/raster]

// [virtual raster]
namespace my {
struct ripples {  // computed when read, never stored
  int width() const { return 640; }
  int height() const { return 480; }
  float operator()(int x, int y) const { return std::sin(0.001f * static_cast<float>(x * x + y * y)); }
};
}  // namespace my

static_assert(irg::ReadableRaster<my::ripples> && !irg::WritableRaster<my::ripples>);
// [/virtual raster]

#ifdef IRG_HAVE_OPENCV
// [cv::Mat_]
template <class P>
struct irg::raster_traits<cv::Mat_<P>> {
  using pixel = P;
  static int width(const cv::Mat_<P>& m) { return m.cols; }
  static int height(const cv::Mat_<P>& m) { return m.rows; }
  static P get(const cv::Mat_<P>& m, int x, int y) { return m(y, x); }  // rows come first in OpenCV
  static void set(cv::Mat_<P>& m, int x, int y, const P& p) { m(y, x) = p; }
  static P* row(cv::Mat_<P>& m, int y) { return m[y]; }
};
// [/cv::Mat_]
static_assert(irg::RowRaster<cv::Mat_<cv::Vec3b>> && irg::DepthRaster<cv::Mat_<float>>);

// [cv::Mat]
std::string blacken(cv::Mat& mat) {
  auto view = irg::view_opencv<irg::bgra8>(mat);
  if (!view) return view.error().reason;
  irg::clear(*view, irg::bgra8{0, 0, 0, 255});
  return "done";
}
// [/cv::Mat]
#endif

#ifdef IRG_HAVE_SDL2
// [SDL_Surface]
std::string blacken(SDL_Surface* surface) {
  auto view = irg::view_sdl<irg::rgba8>(surface);
  if (!view) return view.error().reason;
  irg::clear(*view, irg::rgba8{0, 0, 0, 255});
  return "done";
}
// [/SDL_Surface]
#endif

// [pixel]
namespace my {
struct argb {
  unsigned char a, r, g, b;
};
}  // namespace my

template <>
struct irg::pixel_layout<my::argb> : irg::channel_layout<std::uint8_t, 4, 1, 2, 3, 0> {};
// [/pixel]
static_assert(irg::SdlPixel<my::argb> && irg::OpencvPixel<my::argb>);

TEST_CASE("own types: a ring that is a list") {
  my::corner c[3] = {{1, 2, &c[1]}, {3, 4, &c[2]}, {5, 6, &c[0]}};
  const my::outline o{&c[0], 3};
  CHECK(irg::ring_vertex(o, 2) == irg::point<short, 2>{5, 6});
  CHECK(irg::ring_vertex(o, 4) == irg::point<short, 2>{3, 4});
}

TEST_CASE("own types: a canvas of characters") {
  my::canvas c;
  irg::clear(c, ' ');
  irg::fill_span(c, {3, 70, 99}, '#');
  CHECK(c(69, 3) == ' ');
  CHECK(c(79, 3) == '#');
}

TEST_CASE("own types: OpenCV") {
#ifdef IRG_HAVE_OPENCV
  cv::Mat colour(2, 2, CV_8UC4, cv::Scalar(9, 9, 9, 9)), depth(2, 2, CV_32FC1);
  CHECK(blacken(colour) == "done");
  CHECK(colour.at<cv::Vec4b>(1, 1) == cv::Vec4b(0, 0, 0, 255));
  CHECK(blacken(depth) == "the matrix has another number of channels than the pixel type");
  CHECK(irg::cross(cv::Vec3f(1, 0, 0), cv::Vec3f(0, 1, 0)) == cv::Vec3f(0, 0, 1));
#else
  MESSAGE("skipped: OpenCV was not found");
#endif
}

TEST_CASE("own types: SDL") {
#ifdef IRG_HAVE_SDL2
  SDL_Surface* s = SDL_CreateRGBSurfaceWithFormat(0, 2, 2, 32, SDL_PIXELFORMAT_RGBA32);
  CHECK(blacken(s) == "done");
  CHECK(static_cast<unsigned char*>(s->pixels)[3] == 255);
  SDL_FreeSurface(s);
  SDL_Surface* other = SDL_CreateRGBSurfaceWithFormat(0, 2, 2, 24, SDL_PIXELFORMAT_RGB24);
  CHECK(blacken(other) == "the surface has another number of bytes per pixel than the pixel type");
  SDL_FreeSurface(other);
  SDL_Surface* argb = SDL_CreateRGBSurfaceWithFormat(0, 2, 2, 32, SDL_PIXELFORMAT_ARGB32);
  CHECK(irg::view_sdl<my::argb>(argb).has_value());
  CHECK(!irg::view_sdl<irg::rgba8>(argb));
  SDL_FreeSurface(argb);
#else
  MESSAGE("skipped: SDL 2 was not found");
#endif
}
