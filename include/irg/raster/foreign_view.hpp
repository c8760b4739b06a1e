// SPDX-License-Identifier: MIT
// foreign_view<P>: the answer of view_opencv and view_sdl, and the checks on memory that they share.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/result.hpp>
#include <irg/raster/image.hpp>

namespace irg {

/// Why an image of another library cannot be seen as rows of the wanted pixel type.
struct view_refusal {
  const char* reason = "";  // one sentence without a full stop, of static storage
};

/// A view of somebody else's pixels, or the reason why there is none.
template <class P>
using foreign_view = result<image_view<P>, view_refusal>;

namespace detail::inline IRG_ABI {

// Rows of P at `data`, or the reason why they cannot be read as such. Data is char or const char, as P is const or not.
template <class P, class Data>
foreign_view<P> foreign_rows(Data* data, int width, int height, std::ptrdiff_t stride) noexcept {
  if (width < 0 || height < 0) return view_refusal{"its size is negative"};
  const auto alignment = static_cast<std::ptrdiff_t>(alignof(P));
  if (reinterpret_cast<std::uintptr_t>(data) % alignof(P) != 0 || stride % alignment != 0)
    return view_refusal{"its rows are not aligned for the pixel type"};
  const std::ptrdiff_t row_bytes = static_cast<std::ptrdiff_t>(width) * static_cast<std::ptrdiff_t>(sizeof(P));
  if (height > 1 && (stride < 0 ? -stride : stride) < row_bytes) return view_refusal{"its rows overlap"};
  return image_view<P>(reinterpret_cast<P*>(data), width, height, stride);
}

}  // namespace detail::inline IRG_ABI
}  // namespace irg
