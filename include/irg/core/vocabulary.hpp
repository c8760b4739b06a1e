// SPDX-License-Identifier: MIT
// The words that many chapters share: on which side, inside or outside, which way round, which way it faces; the size
// of a picture; a value and how it came about; no index. And where types of your own come in, each explained in its
// header:
//
//   yours                    enters by                what fits without a word from you
//   a vector, a point        coordinate_traits<T>     x, y, z, w; [i] of fixed size        core/coordinates.hpp
//   a polygon                ring_traits<T>           size() and [i]; arrays               core/ring.hpp
//   a plane                  plane_traits<T>          a, b, c, d; four coordinates         core/plane_concept.hpp
//   an image                 raster_traits<T>         width(), height() and (x, y)         core/raster_concept.hpp
//   a mesh                   mesh_traits<T>           irg's own                            core/mesh_concept.hpp
//   a matrix                 matrix_traits<T>         GLM's, Eigen's, OpenCV's             math/matrix_concept.hpp
//   a grid of cells          grid_traits<T>           extent() and is_full(cell)           spatial/grid_concept.hpp
//   a thread pool            being called             executor(count, task)                core/executor.hpp
//   what takes the output    being called             sink(cell), sink(span), ...          core/sinks.hpp
#pragma once

#include <cstdint>

#include <irg/core/contract.hpp>

namespace irg {

/// What stands for no index: of a vertex, a face, a node.
inline constexpr std::uint32_t no_index = 0xffffffffu;

/// On which side of a plane or a line a point lies: where the normal points to (above), on it, or on the other side.
/// The values are the signs of the equation there.
enum class side { below = -1, on = 0, above = 1 };

/// Where a point lies with regard to a polygon, a body or another region that has a boundary.
enum class location { outside = -1, boundary = 0, inside = 1 };

/// What an eye sees of a face: the inner side (back), its edge, or the outer side (front). The values are the signs of
/// its plane's equation at the eye.
enum class facing { back = -1, edge_on = 0, front = 1 };

/// Which faces are left out because of the way they face.
enum class face_culling { back, none };

/// Which way round a polygon or a triangle runs, as the sign of its area says: `degenerate` when that is zero.
enum class orientation { clockwise = -1, degenerate = 0, counter_clockwise = 1 };

/// How something lies with regard to a region: a box to a view frustum, a window of pixels to a triangle.
enum class containment {
  outside,  // surely no point of it is in the region
  crossing,  // anything else
  inside  // surely all of it is in the region
};

/// How many pixels a picture has: in a row, and rows.
struct extent2 {
  int width = 0, height = 0;
  bool operator==(const extent2&) const = default;
};

/// The words whose values are signs: -1, 0 and 1.
template <class E>
inline constexpr bool is_sign_word = false;
template <>
inline constexpr bool is_sign_word<side> = true;
template <>
inline constexpr bool is_sign_word<location> = true;
template <>
inline constexpr bool is_sign_word<facing> = true;
template <>
inline constexpr bool is_sign_word<orientation> = true;

inline namespace IRG_ABI {

/// -1, 0 or 1: the sign that a side, a location, a facing or an orientation stands for.
/// exact   always
template <class E>
  requires(is_sign_word<E>)
[[nodiscard]] IRG_INLINE constexpr int sign_of(E word) noexcept {
  return static_cast<int>(word);
}

/// The word of the other sign: below for above, outside for inside, back for front, clockwise for counter-clockwise.
/// What stands for zero stays.
/// exact   always
template <class E>
  requires(is_sign_word<E>)
[[nodiscard]] IRG_INLINE constexpr E opposite(E word) noexcept {
  return static_cast<E>(-static_cast<int>(word));
}

}  // namespace IRG_ABI

/// Three indices of vertices, counter-clockwise seen from outside.
struct triangle_indices {
  std::uint32_t v[3];
  bool operator==(const triangle_indices&) const = default;
};

/// A value that is harmless always, and what its arguments amounted to. True when the value is what was asked for.
/// shape   S is an enum whose first value says that all is well
template <class T, class S>
struct [[nodiscard]] checked {
  T value{};
  S status{};

  [[nodiscard]] IRG_INLINE constexpr bool ok() const noexcept { return status == S{}; }
  IRG_INLINE constexpr explicit operator bool() const noexcept { return ok(); }
  /// The value, where nothing else is expected.
  /// needs   ok()
  [[nodiscard]] IRG_INLINE constexpr T expected() const noexcept { return IRG_EXPECTS(ok()), value; }
  [[nodiscard, deprecated("irg: is_ordinary is now ok")]] IRG_INLINE constexpr bool is_ordinary() const noexcept {
    return ok();
  }
  bool operator==(const checked&) const = default;
};

}  // namespace irg
