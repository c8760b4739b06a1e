// SPDX-License-Identifier: MIT
// How a surface over the unit square is seen by the floating horizon: turned about y, tilted about x and projected at
// right angles; curves of constant z, of constant x, or both, near ones first. Where both families are drawn, samples
// are taken so that they meet.
#pragma once

#include <irg/core/scalar.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/math/vec.hpp>

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
  bool operator==(const horizon_view&) const = default;
};

namespace detail::inline IRG_ABI {

// A view with the functions of its angles.
struct turned_view {
  horizon_view view;
  double cos_yaw, sin_yaw, cos_pitch, sin_pitch;
  int offset;  // of the columns: x may be negative
};

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
    if (!(x == x)) return 0;  // an angle that is no number
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
  const int whole = pixels == pixels ? static_cast<int>(pixels + 0.5) : 0;
  return whole < 1 ? crossing : (whole - 1) / crossing * crossing + crossing;
}

// Where a point of the surface is seen: x', y' in pixels, y up, each operation rounded once.
template <class View>
constexpr point<double, 2> turned_place(const View& t, double x, double y, double z) noexcept {
  const double turned_x = product(x, t.cos_yaw) - product(z, t.sin_yaw);
  const double turned_z = product(x, t.sin_yaw) + product(z, t.cos_yaw);
  return {product(turned_x, t.view.width),
          product(product(y, t.cos_pitch) + product(turned_z, t.sin_pitch), t.view.height)};
}

// From where curves are ordered: below x = 0 and z = 0, as at right angles with a yaw from 0 to 90 degrees.
inline constexpr point<double, 2> eye_at_infinity{-1, -1};

// 0 to count - 1, at equal places from 0 to 1, those beyond `eye` upwards, then those before it downwards.
template <class Visit>
constexpr void visit_away_from(double eye, int count, const Visit& visit) {
  const auto place = [&](int i) { return static_cast<double>(i) / (count - 1); };
  int first = 0;
  while (first < count && place(first) < eye) ++first;
  for (int i = first; i < count; ++i) visit(i);
  for (int i = first - 1; i >= 0; --i) visit(i);
}

// Calls begin() at the begin of each curve, or piece of one, and sample(x, z) for its points, in the order in which
// they are drawn from over (eye.x, eye.y): away from it. Beside the square in one coordinate, whole curves are those
// that lie across.
// needs   an eye that is not over the square
template <class View, class Begin, class Sample>
constexpr void visit_horizon_samples(const View& t, const point<double, 2>& eye, const Begin& begin,
                                     const Sample& sample) {
  const auto& view = t.view;
  const int crossing = view.curves - 1;
  const int steps_x = horizon_steps(view, t.cos_yaw), steps_z = horizon_steps(view, t.sin_yaw);
  const bool beside_x = !(eye.x > 0 && eye.x < 1), beside_z = !(eye.y > 0 && eye.y < 1);
  const bool both = view.families == horizon_curves::both;
  const bool z_first =
      view.families == horizon_curves::constant_z || (both && beside_z && (t.sin_yaw <= t.cos_yaw || !beside_x));
  // From sample `first` to `last` of a curve at one of `crossing` equal places.
  const auto curve = [&](bool of_constant_z, int at, int first, int last) {
    begin();
    const double place = static_cast<double>(at) / crossing;
    for (int i = first; i <= last; ++i)
      if (of_constant_z)
        sample(static_cast<double>(i) / steps_x, place);
      else
        sample(place, static_cast<double>(i) / steps_z);
  };
  const int part = (z_first ? steps_z : steps_x) / crossing, whole = z_first ? steps_x : steps_z;
  const double over = z_first ? eye.y : eye.x, across = z_first ? eye.x : eye.y;
  int done = 0;
  visit_away_from(over, view.curves, [&](int k) {
    curve(z_first, k, 0, whole);
    if (!both || ++done > crossing) return;
    const int strip = over < 1 ? k : k - 1;  // the one behind the curve
    visit_away_from(across, view.curves, [&](int i) { curve(!z_first, i, strip * part, (strip + 1) * part); });
  });
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The steps of a whole curve: the smallest positive multiple of the crossing curves' number that gives each column a
/// sample; `share` is the cosine of the yaw for curves of constant z, the sine for those of constant x.
/// gives   what view.samples asks for, where it does
/// exact   trunc((round(width*share) - 0.5)/n)*n + n, for n = curves - 1
/// source  Special-cases chapter, 2.2
template <class View>
[[nodiscard]] constexpr int sample_steps(const View& view, double share) noexcept {
  return detail::horizon_steps(detail::limited_view(view), share);
}

}  // namespace IRG_ABI
}  // namespace irg
