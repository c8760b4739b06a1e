// SPDX-License-Identifier: MIT
// Rasters of any type: rectangles of pixels, x to the right, y down, (0, 0) at the top left.
//
// The one customisation point is raster_traits<T>. It fits, without a word from the user, types with members
// width(), height() and operator()(x, y). A raster may be virtual: operator() may compute its pixel. Types that also
// have row(y), a pointer to the first of width() pixels in sequence, are written faster.
#pragma once

#include <cstddef>

#include <irg/core/scalar.hpp>

namespace irg {

/// How irg reads and writes a raster. Members: pixel, width(r), height(r), get(r, x, y), and where they make sense
/// set(r, x, y, p), row(r, y) and bytes_per_row(r), the signed distance from each row to the next.
template <class T>
struct raster_traits {};

template <class T>
  requires requires(const T& r) {
    { r.width() } -> std::convertible_to<int>;
    { r.height() } -> std::convertible_to<int>;
    requires std::copyable<std::remove_cvref_t<decltype(r(0, 0))>>;
  }
struct raster_traits<T> {
  using pixel = std::remove_cvref_t<decltype(std::declval<const T&>()(0, 0))>;
  IRG_INLINE static constexpr int width(const T& r) { return static_cast<int>(r.width()); }
  IRG_INLINE static constexpr int height(const T& r) { return static_cast<int>(r.height()); }
  IRG_INLINE static constexpr pixel get(const T& r, int x, int y) { return r(x, y); }
  IRG_INLINE static constexpr void set(T& r, int x, int y, const pixel& p)
    requires std::assignable_from<decltype(r(x, y)), const pixel&>
  {
    r(x, y) = p;
  }
  IRG_INLINE static constexpr pixel* row(T& r, int y)
    requires std::same_as<decltype(r.row(y)), pixel*>
  {
    return r.row(y);
  }
  IRG_INLINE static constexpr std::ptrdiff_t bytes_per_row(const T& r)
    requires std::same_as<decltype(r.bytes_per_row()), std::ptrdiff_t>
  {
    return r.bytes_per_row();
  }
};

/// A rectangle of pixels that can be read.
template <class T>
concept ReadableRaster = requires(const T& r) {
  requires std::copyable<typename raster_traits<T>::pixel>;
  { raster_traits<T>::width(r) } -> std::convertible_to<int>;
  { raster_traits<T>::height(r) } -> std::convertible_to<int>;
  { raster_traits<T>::get(r, 0, 0) } -> std::convertible_to<typename raster_traits<T>::pixel>;
};

/// A rectangle of pixels that can be written one by one.
template <class T>
concept WritableRaster = ReadableRaster<T> && requires(T& r, const typename raster_traits<T>::pixel& p) {
  raster_traits<T>::set(r, 0, 0, p);
};

/// A writable raster whose pixels stand side by side in each row.
template <class T>
concept RowRaster = WritableRaster<T> && requires(T& r) {
  { raster_traits<T>::row(r, 0) } -> std::same_as<typename raster_traits<T>::pixel*>;
};

/// A row raster whose rows are all the same distance apart.
template <class T>
concept EvenRowRaster = RowRaster<T> && requires(const T& r) {
  { raster_traits<T>::bytes_per_row(r) } -> std::same_as<std::ptrdiff_t>;
};

/// A raster of depths: one ordered number per pixel.
template <class T>
concept DepthRaster = WritableRaster<T> && Scalar<typename raster_traits<T>::pixel>;

/// The pixel type of a raster.
template <ReadableRaster T>
using pixel_of = typename raster_traits<T>::pixel;

inline namespace IRG_ABI {

/// The number of pixels in a row of r.
template <ReadableRaster T>
[[nodiscard]] IRG_INLINE constexpr int width_of(const T& r) {
  return static_cast<int>(raster_traits<T>::width(r));
}

/// The number of rows of r.
template <ReadableRaster T>
[[nodiscard]] IRG_INLINE constexpr int height_of(const T& r) {
  return static_cast<int>(raster_traits<T>::height(r));
}

/// The bytes from each row of r to the next one, negative where rows stand bottom up.
template <EvenRowRaster T>
[[nodiscard]] IRG_INLINE constexpr std::ptrdiff_t bytes_per_row_of(const T& r) {
  return raster_traits<T>::bytes_per_row(r);
}

/// The pixel in column x of row y.
/// needs   0 <= x < width, 0 <= y < height
template <ReadableRaster T>
[[nodiscard]] IRG_INLINE constexpr pixel_of<T> get_pixel(const T& r, int x, int y) {
  return raster_traits<T>::get(r, x, y);
}

/// Writes the pixel in column x of row y.
/// needs   0 <= x < width, 0 <= y < height
template <WritableRaster T>
IRG_INLINE constexpr void set_pixel(T& r, int x, int y, const pixel_of<T>& p) {
  raster_traits<T>::set(r, x, y, p);
}

}  // namespace IRG_ABI
}  // namespace irg
