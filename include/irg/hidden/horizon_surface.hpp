// SPDX-License-Identifier: MIT
// A surface over the unit square as curves for the floating horizon, in pixels: horizon_view.hpp says how it is seen,
// horizon_curves.hpp has the same curves without pixels.
#pragma once

#include <irg/hidden/floating_horizon.hpp>
#include <irg/hidden/horizon_view.hpp>

namespace irg::inline IRG_ABI {

/// How many columns the horizon of a view needs.
/// gives   1 where the yaw is no number, with which nothing is drawn
template <class View>
[[nodiscard]] constexpr int horizon_width(const View& view) noexcept {
  const detail::turned_view t = detail::turn_view(view);
  const double level = product(t.view.width, t.cos_yaw);
  return (level == level ? static_cast<int>(level + 0.5) : 0) + t.offset + 1;
}

/// Draws a surface y = height(x, z) over the unit square: every curve's samples go to the horizon, and what is seen to
/// sink(from, to, side).
/// shape   column floor(x' width + 1/2) + ceil(width sin yaw), row floor(y' height + 1/2), y up
/// needs   a horizon of horizon_width(view) columns
/// gives   a gap where a height is NaN or infinite, or its row beyond 2^30; widths, curves and samples count as 2^28 at
///         most, curves as 2 at least
/// exact   x' = x cos - z sin, z' = x sin + z cos, y' = y cos + z' sin, each operation rounded once
/// cost    a call of height for each sample
/// source  Special-cases chapter, 2.1 and 2.2
template <class Horizon, class Height, class Sink>
constexpr void draw_horizon_surface(Horizon& horizon, const Height& height, const horizon_view& given, Sink&& sink) {
  const detail::turned_view t = detail::turn_view(given);
  const auto add = [&](double x, double z) {
    const point<double, 2> at = detail::turned_place(t, x, height(x, z), z);
    const double row = at.y + 0.5;
    if (!(row >= -0x1p30 && row <= 0x1p30)) return horizon.begin_curve();
    const auto rounded_down = [](double v) {
      const auto i = static_cast<int>(v);
      return static_cast<double>(i) > v ? i - 1 : i;
    };
    horizon.add(cell{rounded_down(at.x + 0.5) + t.offset, rounded_down(row)}, sink);
  };
  detail::visit_horizon_samples(t, detail::eye_at_infinity, [&] { horizon.begin_curve(); }, add);
}

}  // namespace irg::inline IRG_ABI
