// SPDX-License-Identifier: MIT
// A surface over the unit square as curves for the floating horizon: turned about y, tilted about x and projected at
// right angles; curves of constant z, of constant x, or both, near ones first. Where both families are drawn, samples
// are taken so that they meet.
#pragma once

#include <irg/core/scalar.hpp>
#include <irg/hidden/floating_horizon.hpp>
#include <irg/math/trigonometry.hpp>

namespace irg {

/// Which curves are drawn. With both families the one that lies flatter in the picture goes first: z up to a yaw of 45
/// degrees, x beyond.
enum class horizon_curves { constant_z, constant_x, both };

/// How a surface over the unit square is seen.
/// shape   width and height of one unit in pixels; yaw from 0 to 90 degrees and pitch from -90 to 90, in radians; as
///         many curves of each family, 2 or more; samples: points of a whole curve, 2 or more, or 0 for as many as it
///         has columns
struct horizon_view {
  double width = 380, height = 120;
  double yaw = 0, pitch = 0;
  int curves = 41;
  int samples = 0;
  horizon_curves families = horizon_curves::both;
};

namespace detail {

// A view with the functions of its angles.
struct turned_view {
  horizon_view view;
  double cos_yaw, sin_yaw, cos_pitch, sin_pitch;
  int offset;  // of the columns: x may be negative
};

inline namespace IRG_ABI {

// The view within the range for which columns and samples are ints.
template <class V>
constexpr V limited_view(V v) noexcept {
  constexpr int most = 1 << 28;
  v.width = v.width > 0 ? (v.width < most ? v.width : most) : 0;
  v.curves = v.curves < 2 ? 2 : v.curves < most ? v.curves : most;
  v.samples = v.samples < 1 ? 0 : v.samples < 2 ? 2 : v.samples < most ? v.samples : most;
  return v;
}

template <class V>
constexpr turned_view turn_view(const V& given) noexcept {
  const V v = limited_view(given);
  const auto up = [](double x) {
    const auto below = static_cast<int>(x);
    return below + (static_cast<double>(below) < x ? 1 : 0);
  };
  return {v, cos(v.yaw), sin(v.yaw), cos(v.pitch), sin(v.pitch), up(product(v.width, sin(v.yaw)))};
}

template <class V>
constexpr int horizon_steps(const V& v, double share) noexcept {
  const int crossing = v.curves - 1;
  if (v.samples > 0) {
    const int steps = v.samples - 1;
    return v.families == horizon_curves::both ? (steps + crossing - 1) / crossing * crossing : steps;
  }
  const double pixels = product(v.width, share < 0 ? -share : share);
  const auto whole = static_cast<int>(pixels + 0.5);
  return whole < 1 ? crossing : (whole - 1) / crossing * crossing + crossing;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The steps of a whole curve: the smallest positive multiple of the crossing curves' number that gives each column a
/// sample; `share` is the cosine of the yaw for curves of constant z, the sine for those of constant x.
/// gives   what view.samples asks for, where it does
/// exact   trunc((round(width*share) - 0.5)/n)*n + n, for n = curves - 1
/// source  Special-cases chapter, 2.2
template <class View>
constexpr int sample_steps(const View& view, double share) noexcept {
  return detail::horizon_steps(detail::limited_view(view), share);
}

/// How many columns the horizon of a view needs.
template <class View>
constexpr int horizon_width(const View& view) noexcept {
  const detail::turned_view t = detail::turn_view(view);
  return static_cast<int>(product(t.view.width, t.cos_yaw) + 0.5) + t.offset + 1;
}

/// Draws a surface y = height(x, z) over the unit square: every curve's samples go to the horizon, and what is seen to
/// emit(from, to, side).
/// shape   column floor(x' width + 1/2) + ceil(width sin yaw), row floor(y' height + 1/2), y up
/// needs   a horizon of horizon_width(view) columns
/// gives   a gap where a height is NaN or infinite, or its row beyond 2^30; widths, curves and samples count as 2^28 at
///         most, curves as 2 at least
/// exact   x' = x cos - z sin, z' = x sin + z cos, y' = y cos + z' sin, each operation rounded once
/// cost    a call of height for each sample
/// source  Special-cases chapter, 2.1 and 2.2
template <class Horizon, class Height, class Sink>
constexpr void draw_horizon_surface(Horizon& horizon, const Height& height, const horizon_view& given, Sink&& emit) {
  const detail::turned_view t = detail::turn_view(given);
  const horizon_view& view = t.view;
  const int crossing = view.curves - 1;
  const int steps_x = detail::horizon_steps(view, t.cos_yaw), steps_z = detail::horizon_steps(view, t.sin_yaw);
  const auto add = [&](double x, double z) {
    const double turned_x = product(x, t.cos_yaw) - product(z, t.sin_yaw);
    const double turned_z = product(x, t.sin_yaw) + product(z, t.cos_yaw);
    const double row = product(product(height(x, z), t.cos_pitch) + product(turned_z, t.sin_pitch), view.height) + 0.5;
    if (!(row >= -0x1p30 && row <= 0x1p30)) return horizon.begin_curve();
    const auto rounded_down = [](double v) {
      const auto i = static_cast<int>(v);
      return static_cast<double>(i) > v ? i - 1 : i;
    };
    horizon.add(cell{rounded_down(product(turned_x, view.width) + 0.5) + t.offset, rounded_down(row)}, emit);
  };
  // From sample `first` to `last` of a curve at one of `of` equal places.
  const auto curve_of_constant_z = [&](int at, int of, int first, int last) {
    horizon.begin_curve();
    for (int i = first; i <= last; ++i) add(static_cast<double>(i) / steps_x, static_cast<double>(at) / of);
  };
  const auto curve_of_constant_x = [&](int at, int of, int first, int last) {
    horizon.begin_curve();
    for (int i = first; i <= last; ++i) add(static_cast<double>(at) / of, static_cast<double>(i) / steps_z);
  };
  const bool z_first =
      view.families == horizon_curves::constant_z || (view.families == horizon_curves::both && t.sin_yaw <= t.cos_yaw);
  for (int k = 0; k <= crossing; ++k) {
    if (z_first)
      curve_of_constant_z(k, crossing, 0, steps_x);
    else
      curve_of_constant_x(k, crossing, 0, steps_z);
    if (view.families != horizon_curves::both || k == crossing) continue;
    const int part = (z_first ? steps_z : steps_x) / crossing;
    for (int i = 0; i <= crossing; ++i)
      if (z_first)
        curve_of_constant_x(i, crossing, k * part, (k + 1) * part);
      else
        curve_of_constant_z(i, crossing, k * part, (k + 1) * part);
  }
}

}  // namespace IRG_ABI
}  // namespace irg
