// SPDX-License-Identifier: MIT
// cv::Mat_ as a raster. It counts rows first: told in five lines, so that nobody's matrix is taken for a picture by its
// looks.
#pragma once

#include <irg/core/raster_concept.hpp>

#ifdef IRG_HAVE_OPENCV
#include <opencv2/core.hpp>

template <class P>
struct irg::raster_traits<cv::Mat_<P>> {
  using pixel = P;
  static int width(const cv::Mat_<P>& m) { return m.cols; }
  static int height(const cv::Mat_<P>& m) { return m.rows; }
  static P get(const cv::Mat_<P>& m, int x, int y) { return m(y, x); }
  static void set(cv::Mat_<P>& m, int x, int y, const P& p) { m(y, x) = p; }
  static P* row(cv::Mat_<P>& m, int y) { return m[y]; }
};
#endif
