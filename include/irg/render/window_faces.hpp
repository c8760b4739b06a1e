// SPDX-License-Identifier: MIT
// What a hidden-surface method is given, and what it gives: the faces that a window of the picture may show, and ids.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <irg/core/function_ref.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/screen_face.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>

namespace irg {

namespace detail {
struct make_window_faces;
}  // namespace detail

/// The faces that a window of the picture may show: those of its triangles, and the pieces of those that were clipped.
/// Faces beyond the picture, facing away or without a pixel centre are left out already, as the options say.
/// shape   numbers rise with i; pieces of one triangle follow each other, under its number
template <Floating T>
class window_faces {
public:
  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return numbers_.size(); }

  /// Face i.
  /// needs   i < size()
  /// cost    the set-up of a triangle
  IRG_INLINE constexpr screen_face operator[](std::size_t i) const noexcept {
    const detail::triangle_corners c = find_.corners(numbers_[i]);
    return make_screen_face(*c.v[0], *c.v[1], *c.v[2], find_.source(numbers_[i]));
  }

private:
  friend struct detail::make_window_faces;

  IRG_INLINE constexpr window_faces(const detail::triangle_finder<T>& find,
                                    std::span<const std::uint32_t> numbers) noexcept
      : find_(find), numbers_(numbers) {}

  detail::triangle_finder<T> find_;
  std::span<const std::uint32_t> numbers_;
};

namespace detail {

// The faces of the triangles that the finder knows by these numbers.
struct make_window_faces {
  template <Floating T>
  IRG_INLINE constexpr window_faces<T> operator()(const triangle_finder<T>& find,
                                                  std::span<const std::uint32_t> numbers) const noexcept {
    return {find, numbers};
  }
};

}  // namespace detail

/// A way to find out what is visible, called once for every window of the picture that some face touches:
///     method(faces, window, ids, counts)
/// It writes into the ids of the window's pixels the number of the face that is seen there, which covers the pixel's
/// centre, and leaves the others as they are: no_index. It counts in `counts` what it tested and found to tie. Windows
/// do not overlap, and executors may ask for several at the same time.
template <class M, class T>
concept HiddenSurfaceMethod =
    requires(const M& method, const window_faces<T>& faces, const cell_window& window, image<std::uint32_t>& ids,
             draw_counts& counts) { method(faces, window, ids, counts); };

namespace detail {

// Any method, by reference.
template <class T>
using method_signature = void(const window_faces<T>&, const cell_window&, image<std::uint32_t>&, draw_counts&);
template <class T>
using method_ref = function_ref<method_signature<T>>;

}  // namespace detail
}  // namespace irg
