// SPDX-License-Identifier: MIT
// view_opencv<P>(mat): a cv::Mat seen as an image_view<P> when it holds such pixels, refused with a reason when not.
// OpenCV is not included: whatever has rows, cols, dims, data, step, depth() and channels() with its meaning will do.
#pragma once

#include <concepts>

#include <irg/colour/pixel_layout.hpp>
#include <irg/raster/foreign_view.hpp>

namespace irg {

namespace detail {

/// OpenCV's number for a channel type (CV_8U is 0, ... CV_64F is 6); -1 for types that it lacks.
template <class Channel>
inline constexpr int opencv_depth = std::same_as<Channel, std::uint8_t>    ? 0
                                    : std::same_as<Channel, std::int8_t>   ? 1
                                    : std::same_as<Channel, std::uint16_t> ? 2
                                    : std::same_as<Channel, std::int16_t>  ? 3
                                    : std::same_as<Channel, std::int32_t>  ? 4
                                    : std::same_as<Channel, float>         ? 5
                                    : std::same_as<Channel, double>        ? 6
                                                                           : -1;

}  // namespace detail

/// A matrix whose type is known at run time only. Models: cv::Mat, cv::Mat_<T>.
template <class M>
concept OpencvMatrix = requires(const M m) {
  { m.rows } -> std::convertible_to<int>;
  { m.cols } -> std::convertible_to<int>;
  { m.dims } -> std::convertible_to<int>;
  { m.depth() } -> std::same_as<int>;
  { m.channels() } -> std::same_as<int>;
  requires std::convertible_to<decltype((m.data)), const unsigned char*>;
  static_cast<std::size_t>(m.step);
};

/// A pixel type that OpenCV has too. Models: std::uint8_t, float, rgb8, rgba8, bgra8, rgb<float>; not std::uint32_t.
template <class P>
concept OpencvPixel = ChannelPixel<P> && detail::opencv_depth<typename pixel_layout<P>::channel> >= 0;

inline namespace IRG_ABI {

/// The matrix's pixels as an image_view<P>, or of const P when the matrix is const; nothing is copied.
/// shape   row 0 at the top; any step; a submatrix is seen as itself
/// needs   the matrix's data outlives the view: a temporary matrix is refused by the compiler
/// gives   a reason instead of a view for a matrix that is empty, not of two dimensions, or of another channel type or
///         number of channels than P. The order of channels is the user's word: OpenCV does not record it, so rgba8
///         and bgra8 both fit CV_8UC4, and rgb8 fits CV_8UC3 although OpenCV's own functions make B, G, R
/// cost    constant
template <OpencvPixel P, OpencvMatrix Matrix>
auto view_opencv(Matrix& matrix) noexcept {
  using pixel = std::conditional_t<std::is_const_v<Matrix>, const P, P>;
  using byte = std::conditional_t<std::is_const_v<Matrix>, const unsigned char, unsigned char>;
  using layout = pixel_layout<P>;
  const auto refused = [](const char* reason) { return foreign_view<pixel>(view_refusal{reason}); };

  if (matrix.data == nullptr || matrix.rows == 0 || matrix.cols == 0) return refused("the matrix is empty");
  if (matrix.dims != 2) return refused("the matrix has more than two dimensions");
  if (matrix.channels() != layout::count)
    return refused("the matrix has another number of channels than the pixel type");
  if (matrix.depth() != detail::opencv_depth<typename layout::channel>)
    return refused("the matrix has another channel type than the pixel type");
  return detail::foreign_rows<pixel>(static_cast<byte*>(matrix.data), matrix.cols, matrix.rows,
                                     static_cast<std::ptrdiff_t>(static_cast<std::size_t>(matrix.step)));
}

}  // namespace IRG_ABI
}  // namespace irg
