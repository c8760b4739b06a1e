// SPDX-License-Identifier: MIT
// What the picture of a scene has to be: coverage from the snapped vertices in 64-bit integers, the visible triangle
// and the colour from the unrounded transform in doubles. Written independently of irg's rasterizer, pixel by pixel.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/scenes.hpp"

namespace bench {

/// The exact picture.
struct exact_picture {
  static constexpr std::int32_t background = -1;
  std::vector<std::int32_t> visible;  // the triangle seen in each pixel; of equal depths the one with the lower number
  std::vector<double> depth, next_depth;  // of the nearest and of the one behind it, both 0 where there is none
  std::int64_t covered = 0;  // pixels of all triangles together, of whichever side
  std::int64_t tested = 0;  // of those that are not culled
  std::int64_t drawn = 0;  // pixels that are not background
  std::int64_t not_judged = 0;  // triangles that would have to be clipped, and are not here

  /// Whether floats may take the next triangle for the nearest: the depths are within 8 units in the last place.
  bool is_close(std::size_t pixel) const {
    const float d = static_cast<float>(depth[pixel]);
    const double ulp = static_cast<double>(std::nextafter(d, 2.0f)) - static_cast<double>(d);
    return visible[pixel] != background && depth[pixel] - next_depth[pixel] <= 8 * ulp;
  }
};

/// A triangle as the oracle walks over it: three edge functions, positive inside.
struct exact_triangle {
  std::int64_t at_first[3], right[3], down[3];  // at the window's first centre; per pixel
  std::int64_t least[3];  // 0 for an edge whose points belong to the triangle, else 1
  irg::cell_window window;
  double area = 0;  // twice the area in 1/256 pixel squared; negative for those that face the eye
  bool any = false;
};

/// needs   coordinates within 2^15 pixels of the picture
exact_triangle exact_cover(const irg::subpixel (&p)[3], int width, int height);

/// Calls emit(x, y, weights) for each covered pixel; the weights add up to 1, rounded once each.
template <class Emit>
void each_covered(const exact_triangle& t, Emit emit) {
  if (!t.any) return;
  const double area = std::abs(t.area);
  for (int y = t.window.y_first; y < t.window.y_last; ++y) {
    std::int64_t e[3];
    for (std::size_t k = 0; k < 3; ++k) e[k] = t.at_first[k] + t.down[k] * (y - t.window.y_first);
    for (int x = t.window.x_first; x < t.window.x_last; ++x) {
      if (e[0] >= t.least[0] && e[1] >= t.least[1] && e[2] >= t.least[2])
        emit(x, y,
             std::array<double, 3>{static_cast<double>(e[0]) / area, static_cast<double>(e[1]) / area,
                                   static_cast<double>(e[2]) / area});
      for (std::size_t k = 0; k < 3; ++k) e[k] += t.right[k];
    }
  }
}

/// The vertex in clip space, from the floats of the scene, in doubles.
std::array<double, 4> exact_clip(const scene& s, std::uint32_t vertex);

/// Finds the exact picture. `snapped` are the vertices' places on the screen.
exact_picture find_exact_picture(const scene& s, const std::vector<irg::subpixel>& snapped);

/// How far a contender is from the exact picture.
struct verdict {
  std::int64_t wrong = 0;  // pixels whose coverage or visible triangle is not the exact one
  std::int64_t close = 0;  // pixels left out of that because two depths are too close to tell
  double max = 0, mean = 0;  // of colours or depths, where the triangle is the exact one
};

/// Judges a picture: ids are the triangles' numbers plus 1, 0 for the background. The colours' error is in 1/255.
verdict judge(const scene& s, const std::vector<irg::subpixel>& snapped, const exact_picture& exact,
              const std::uint32_t* ids, const irg::rgba8* colours);

/// Judges depths, 0 for the background: wrong are those that stand where nothing does, or do not where something does,
/// or are off by more than 2^-12, as another triangle's is. The error of the others is in 2^-24.
verdict judge_depth(const scene& s, const exact_picture& exact, const float* depth);

}  // namespace bench
