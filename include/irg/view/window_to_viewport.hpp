// SPDX-License-Identifier: MIT
// From a window of the picture plane (y up) to a viewport of the image (y down) and back, with the picture stretched or
// with its aspect ratio kept.
#pragma once

#include <initializer_list>
#include <limits>

#include <irg/core/vocabulary.hpp>
#include <irg/math/length.hpp>
#include <irg/view/view_window.hpp>
#include <irg/view/viewport.hpp>

namespace irg {

/// What becomes of the aspect ratio where window and viewport differ.
enum class window_fit {
  stretch,  // the window fills the viewport, each axis on its own scale
  whole,  // one scale: all of the window is seen, centred, with empty strips beside it
  fill  // one scale: no empty strip, the window's ends lie outside of the viewport
};

/// What window and viewport amount to.
enum class [[nodiscard]] window_status {
  ok,
  bad_window,  // without width or height, or not finite
  bad_viewport,  // width or height not positive, or not finite
  not_representable,  // a scale would overflow or vanish
  ordinary [[deprecated("irg: ordinary is now ok")]] = ok
};

/// Picture plane to image: the upper left corner of the window comes to `onto`, from there on `scale` pixels are one
/// unit. Negative scales belong to mirrored windows.
template <Real T>
struct window_mapping {
  point<T, 2> corner{};
  point<T, 2> onto{};
  vec<T, 2> scale{T(1), T(1)};
  bool operator==(const window_mapping&) const = default;
};

namespace detail::inline IRG_ABI {

template <class T>
constexpr bool all_at_most_half(std::initializer_list<T> numbers) noexcept {
  if constexpr (Floating<T>)
    for (const T& x : numbers)
      if (!(magnitude(x) <= (std::numeric_limits<T>::max)() / 2)) return false;
  return true;
}

// a/b where that is neither infinite nor subnormal; else 0.
template <class T>
constexpr T representable_scale(const T& a, const T& b) noexcept {
  if constexpr (Floating<T>) {
    constexpr T largest = (std::numeric_limits<T>::max)() / 4, least = (std::numeric_limits<T>::min)();
    if (magnitude(b) < T(1) && !(magnitude(a) <= magnitude(b) * largest)) return T(0);
    if (!(magnitude(b) * least <= magnitude(a))) return T(0);
  }
  return a / b;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The mapping from a window to a viewport, or why there is none.
/// shape   a window whose sides are exchanged comes out mirrored
/// gives   bad_window, bad_viewport, not_representable
/// exact   in rationals; in floats scales within 2u, `onto` within 4u of the viewport's borders
/// source  Hank n.d., 4.2.2
template <Real T>
[[nodiscard]] constexpr checked<window_mapping<T>, window_status> window_to_viewport(
    const view_window<T>& window, const viewport<T>& view, window_fit fit = window_fit::stretch) noexcept {
  const auto refused = [](window_status why) { return checked<window_mapping<T>, window_status>{{}, why}; };
  if (!detail::all_at_most_half({window.left, window.right, window.bottom, window.top}) ||
      window.left == window.right || window.bottom == window.top)
    return refused(window_status::bad_window);
  if (!detail::all_at_most_half({view.x, view.y, view.width, view.height}) || !(T(0) < view.width) ||
      !(T(0) < view.height))
    return refused(window_status::bad_viewport);
  const T width = window.right - window.left, height = window.top - window.bottom;
  T x = detail::representable_scale(view.width, width), y = detail::representable_scale(view.height, height);
  if (x == T(0) || y == T(0)) return refused(window_status::not_representable);
  const auto size = [](const T& v) { return v < T(0) ? T(-v) : v; };
  T seen_width = view.width, seen_height = view.height;
  if (fit != window_fit::stretch) {
    const bool width_decides = (size(x) < size(y)) == (fit == window_fit::whole);
    const T one = width_decides ? size(x) : size(y);
    if constexpr (Floating<T>)
      if (T(1) < one && (std::numeric_limits<T>::max)() / T(4) / one < (width_decides ? size(height) : size(width)))
        return refused(window_status::not_representable);
    if (width_decides)
      seen_height = product(size(height), one);
    else
      seen_width = product(size(width), one);
    x = width < T(0) ? T(-one) : one;
    y = height < T(0) ? T(-one) : one;
  }
  return {{{window.left, window.top},
           {view.x + (view.width - seen_width) / T(2), view.y + (view.height - seen_height) / T(2)},
           {x, y}},
          window_status::ok};
}

/// Where a position of the picture plane lies in the image.
/// exact   in rationals; in floats each operation is rounded once
template <class T>
[[nodiscard]] IRG_INLINE constexpr point<T, 2> to_pixels(const window_mapping<T>& m, const point<T, 2>& p) noexcept {
  return {m.onto.x + product(p.x - m.corner.x, m.scale.x), m.onto.y + product(m.corner.y - p.y, m.scale.y)};
}

/// The position of the picture plane that is seen at a place of the image: the inverse of to_pixels.
/// exact   in rationals; in floats each operation is rounded once
template <class T>
[[nodiscard]] IRG_INLINE constexpr point<T, 2> from_pixels(const window_mapping<T>& m, const point<T, 2>& p) noexcept {
  return {m.corner.x + (p.x - m.onto.x) / m.scale.x, m.corner.y - (p.y - m.onto.y) / m.scale.y};
}

/// The part of a viewport that a picture of the given aspect ratio (width over height) fills; with `fill` the viewport
/// is a part of it. What to_pixels does with it keeps the ratio.
/// gives   the viewport itself for an aspect that is not positive, and with `stretch`
/// exact   in rationals; in floats within 3u of the viewport's borders
template <Real T>
[[nodiscard]] constexpr viewport<T> fitted_viewport(const viewport<T>& view, const std::type_identity_t<T>& aspect,
                                                    window_fit fit) noexcept {
  if (!(T(0) < aspect) || fit == window_fit::stretch) return view;
  const T width = product(view.height, aspect);
  if ((width < view.width) == (fit == window_fit::whole))
    return {view.x + (view.width - width) / T(2), view.y, width, view.height};
  const T height = view.width / aspect;
  return {view.x, view.y + (view.height - height) / T(2), view.width, height};
}

}  // namespace IRG_ABI
}  // namespace irg
