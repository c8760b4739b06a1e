// SPDX-License-Identifier: MIT
// OpenCV's drawing functions, through a cv::Mat on the canvas.
#pragma once

#include <memory>

#include <opencv2/imgproc.hpp>

#include "raster/lines.hpp"
#include "raster/polygons.hpp"

namespace bench::opencv {

inline cv::Mat wrap(const canvas& c) {
  cv::setNumThreads(1);
  return cv::Mat(c.height(), c.width(), CV_8UC4, c.pixels());
}

inline cv::Scalar colour() { return cv::Scalar::all(255); }

inline drawer lines(const canvas& c, line_list& lines, cv::LineTypes type) {
  drawer d{type == cv::LINE_AA ? "OpenCV LINE_AA" : "OpenCV line", {}};
  d.draw = [m = wrap(c), &lines, type](int first, int last) mutable {
    for (int k = first; k < last; ++k) {
      const segment& s = (*lines)[static_cast<std::size_t>(k)];
      cv::line(m, {s.a.x, s.a.y}, {s.b.x, s.b.y}, colour(), 1, type);
    }
  };
  if (type == cv::LINE_AA) d.note = "its own profile of three pixels across the line";
  return d;
}

/// All lines as open polygons of two points, in one call.
inline drawer line_batch(const canvas& c, line_list& lines) {
  auto& points = keep_lazy([&lines] {
    std::vector<cv::Point> all;
    for (const segment& s : *lines) all.insert(all.end(), {cv::Point(s.a.x, s.a.y), cv::Point(s.b.x, s.b.y)});
    return all;
  });
  return {"OpenCV polylines", [m = wrap(c), &points](int first, int last) mutable {
            std::vector<const cv::Point*> starts;
            for (int k = first; k < last; ++k) starts.push_back(points->data() + 2 * k);
            const std::vector<int> counts(starts.size(), 2);
            cv::polylines(m, starts.data(), counts.data(), static_cast<int>(starts.size()), false, colour());
          }};
}

enum class filler { convex, general };

/// OpenCV puts pixel centres at integers.
inline drawer fill(const canvas& c, const polygon_set& set, filler how, cv::LineTypes type) {
  auto& points = keep_lazy([&set] {
    std::vector<cv::Point> all;
    for (const irg::subpixel& v : *set.vertices) all.emplace_back(v.x - irg::half_pixel, v.y - irg::half_pixel);
    return all;
  });
  drawer d{how == filler::convex ? "OpenCV fillConvexPoly" : "OpenCV fillPoly", {}};
  d.draw = [m = wrap(c), &points, n = set.corners, how, type](int first, int last) mutable {
    for (int k = first; k < last; ++k) {
      const cv::Point* ring = points->data() + k * n;
      if (how == filler::convex)
        cv::fillConvexPoly(m, ring, n, colour(), type, irg::subpixel_bits);
      else
        cv::fillPoly(m, &ring, &n, 1, colour(), type, irg::subpixel_bits);
    }
  };
  d.same_work = false;
  d.note = "draws the outline too";
  return d;
}

}  // namespace bench::opencv
