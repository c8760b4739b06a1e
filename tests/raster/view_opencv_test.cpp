// SPDX-License-Identifier: MIT
#include <irg/raster/view_opencv.hpp>

#include <cstring>

#include <irg/raster/fill_span.hpp>
#ifdef IRG_HAVE_OPENCV
#include <opencv2/core.hpp>
#endif

#include "support/check_both.hpp"

namespace {

// cv::Mat as far as the view looks at it, so that every refusal can be provoked without OpenCV.
struct matrix {
  int rows, cols;
  int depth_, channels_;
  std::ptrdiff_t step;
  unsigned char* data;
  int dims = 2;
  int depth() const { return depth_; }
  int channels() const { return channels_; }
};
struct no_step {
  int rows, cols, dims;
  unsigned char* data;
  int depth() const;
  int channels() const;
};

static_assert(irg::OpencvMatrix<matrix> && !irg::OpencvMatrix<no_step> && !irg::OpencvMatrix<int>);
static_assert(irg::OpencvPixel<irg::rgba8> && irg::OpencvPixel<irg::bgra8> && irg::OpencvPixel<irg::rgb8>);
static_assert(irg::OpencvPixel<std::uint8_t> && irg::OpencvPixel<float> && irg::OpencvPixel<irg::rgb<float>>);
static_assert(irg::OpencvPixel<irg::rgb<double>> && irg::OpencvPixel<std::int32_t> && irg::OpencvPixel<std::uint16_t>);
static_assert(!irg::OpencvPixel<std::uint32_t> && !irg::OpencvPixel<bool> && !irg::OpencvPixel<matrix>);
static_assert(irg::detail::opencv_depth<std::uint8_t> == 0 && irg::detail::opencv_depth<double> == 6);

constexpr int depth_8u = 0, depth_8s = 1, depth_32s = 4, depth_32f = 5;

template <class P>
bool accepts(const matrix& m) {
  return irg::view_opencv<P>(m).has_value();
}
template <class P>
bool refuses_with_reason(const matrix& m) {
  const auto v = irg::view_opencv<P>(m);
  return !v && std::strlen(v.error().reason) > 10;
}

alignas(16) unsigned char memory[256];
matrix of(int depth, int channels, std::ptrdiff_t step = 64) { return {3, 4, depth, channels, step, memory}; }

}  // namespace

TEST_CASE("view_opencv: the pixel type must be the matrix's") {
  CHECK(accepts<irg::rgba8>(of(depth_8u, 4)));
  CHECK(accepts<irg::bgra8>(of(depth_8u, 4)));  // OpenCV does not record the order of channels
  CHECK(accepts<irg::rgb8>(of(depth_8u, 3)));
  CHECK(accepts<std::uint8_t>(of(depth_8u, 1)));
  CHECK(accepts<float>(of(depth_32f, 1)));
  CHECK(accepts<irg::rgb<float>>(of(depth_32f, 3)));
  CHECK(accepts<std::int32_t>(of(depth_32s, 1)));
  // Exactly one of seven depths and one of four channel counts fits.
  int fitting_rgba8 = 0, fitting_float = 0, fitting_rgb = 0;
  for (int depth = 0; depth < 8; ++depth)
    for (int channels = 1; channels <= 4; ++channels) {
      fitting_rgba8 += accepts<irg::rgba8>(of(depth, channels));
      fitting_float += accepts<float>(of(depth, channels));
      fitting_rgb += accepts<irg::rgb<float>>(of(depth, channels));
    }
  CHECK(fitting_rgba8 == 1);
  CHECK(fitting_float == 1);
  CHECK(fitting_rgb == 1);
  CHECK(refuses_with_reason<irg::rgba8>(of(depth_8s, 4)));
  CHECK(refuses_with_reason<irg::rgba8>(of(depth_32s, 1)));  // four bytes as well, but one number
}

TEST_CASE("view_opencv: rows where they are") {
  matrix m = of(depth_8u, 4, 20);  // four pixels of four bytes and four bytes of padding
  const auto v = irg::view_opencv<irg::rgba8>(m);
  CHECK(v.has_value());
  if (!v) return;
  CHECK(v->width() == 4);
  CHECK(v->height() == 3);
  CHECK(v->stride() == 20);
  CHECK(reinterpret_cast<unsigned char*>(&(*v)(1, 2)) == memory + 44);

  m.step = -20;
  m.data = memory + 40;
  const auto up = irg::view_opencv<irg::rgba8>(m);
  CHECK(up.has_value());
  if (!up) return;
  CHECK(reinterpret_cast<unsigned char*>(&(*up)(0, 2)) == memory);

  m = of(depth_8u, 3, 13);  // rows that start at odd addresses
  CHECK(reinterpret_cast<unsigned char*>(&(*irg::view_opencv<irg::rgb8>(m))(1, 2)) == memory + 29);
}

TEST_CASE("view_opencv: a const matrix is for reading only") {
  matrix m = of(depth_8u, 4);
  static_assert(std::same_as<decltype(irg::view_opencv<irg::rgba8>(m)), irg::foreign_view<irg::rgba8>>);
  const matrix& c = m;
  static_assert(std::same_as<decltype(irg::view_opencv<irg::rgba8>(c)), irg::foreign_view<const irg::rgba8>>);
}

TEST_CASE("view_opencv: refused with a reason") {
  matrix m = of(depth_8u, 4);
  m.data = nullptr;
  CHECK(refuses_with_reason<irg::rgba8>(m));
  m = of(depth_8u, 4);
  m.rows = 0;
  CHECK(refuses_with_reason<irg::rgba8>(m));
  m = of(depth_8u, 4);
  m.dims = 3, m.rows = m.cols = -1;  // as cv::Mat has it
  CHECK(refuses_with_reason<irg::rgba8>(m));
  CHECK(std::strstr(irg::view_opencv<irg::rgba8>(m).error().reason, "dimensions") != nullptr);
  m = of(depth_8u, 4);
  m.cols = -4;
  CHECK(refuses_with_reason<irg::rgba8>(m));
  CHECK(refuses_with_reason<float>(of(depth_32f, 1, 18)));  // rows off the alignment of float
  m = of(depth_32f, 1);
  m.data = memory + 2;
  CHECK(refuses_with_reason<float>(m));
  CHECK(refuses_with_reason<irg::rgba8>(of(depth_8u, 4, 15)));
  CHECK(refuses_with_reason<irg::rgba8>(of(depth_8u, 4, 0)));
}

TEST_CASE("view_opencv: cv::Mat") {
#ifdef IRG_HAVE_OPENCV
  static_assert(irg::OpencvMatrix<cv::Mat> && irg::OpencvMatrix<cv::Mat_<cv::Vec3b>>);
  cv::Mat m(5, 7, CV_8UC4, cv::Scalar(0, 0, 0, 0));
  auto v = irg::view_opencv<irg::bgra8>(m);
  CHECK(v.has_value());
  if (!v) return;
  irg::fill_span(*v, {2, 3, 99}, irg::bgra8{1, 2, 3, 4});
  CHECK(m.at<cv::Vec4b>(2, 3) == cv::Vec4b(1, 2, 3, 4));
  CHECK(m.at<cv::Vec4b>(2, 6) == cv::Vec4b(1, 2, 3, 4));
  CHECK(m.at<cv::Vec4b>(2, 2) == cv::Vec4b(0, 0, 0, 0));
  CHECK(m.at<cv::Vec4b>(3, 3) == cv::Vec4b(0, 0, 0, 0));

  cv::Mat part = m(cv::Rect(2, 1, 3, 3));  // a window into the same pixels
  auto w = irg::view_opencv<irg::bgra8>(part);
  CHECK(w.has_value());
  if (!w) return;
  CHECK(w->width() == 3);
  CHECK((*w)(1, 1) == irg::bgra8{1, 2, 3, 4});

  cv::Mat_<cv::Vec3f> light(2, 2, cv::Vec3f(0, 0.5f, 1));
  const auto x = irg::view_opencv<irg::rgb<float>>(light);
  CHECK(x.has_value());
  if (!x) return;
  CHECK((*x)(1, 1).g == 0.5f);

  cv::Mat empty;
  CHECK(!irg::view_opencv<irg::bgra8>(empty));
  CHECK(!irg::view_opencv<irg::rgb8>(m));
  CHECK(!irg::view_opencv<std::uint8_t>(m));
  const int sizes[] = {2, 3, 4};
  cv::Mat cube(3, sizes, CV_8UC4);
  CHECK(!irg::view_opencv<irg::bgra8>(cube));
  for (int type : {CV_8SC4, CV_16UC4, CV_32SC1, CV_32FC1, CV_8UC3, CV_8UC2, CV_8UC(5)}) {
    cv::Mat other(2, 2, type);
    CHECK(!irg::view_opencv<irg::rgba8>(other));
  }
#else
  MESSAGE("skipped: OpenCV was not found");
#endif
}
