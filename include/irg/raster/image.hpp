// SPDX-License-Identifier: MIT
// image<P> owns its pixels; image_view<P> borrows them from anywhere, with any distance between rows, negative too.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>  // brings std::allocator; <memory> costs more

#include <irg/colour/pixel.hpp>
#include <irg/core/config.hpp>
#include <irg/core/contract.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/core/vocabulary.hpp>

namespace irg {
namespace detail {

// Memory for pixels that starts where a line of the cache does: rows of a picture can then be written line by line,
// without reading first what is overwritten.

template <class P>
struct IRG_APART line_allocator {
  using value_type = P;
  static constexpr std::align_val_t alignment{alignof(P) > 64 ? alignof(P) : 64};

  line_allocator() = default;
  template <class Q>
  IRG_INLINE constexpr line_allocator(const line_allocator<Q>&) noexcept {}

  IRG_INLINE constexpr P* allocate(std::size_t count) {
    if (std::is_constant_evaluated()) return std::allocator<P>{}.allocate(count);
    return static_cast<P*>(::operator new(count * sizeof(P), alignment));
  }
  IRG_INLINE constexpr void deallocate(P* memory, std::size_t count) noexcept {
    if (std::is_constant_evaluated()) return std::allocator<P>{}.deallocate(memory, count);
    ::operator delete(memory, alignment);
  }

  friend constexpr bool operator==(const line_allocator&, const line_allocator&) noexcept { return true; }
};

}  // namespace detail

/// A window onto pixels that somebody else owns. It writes through even when it is itself const, as a pointer does.
/// shape   height() rows of width() pixels; row y starts `stride` bytes after row y - 1, before it when stride < 0
///         (bottom-up images: first_row points at the top row, the last in memory)
/// needs   |stride| >= width * sizeof(P) and a multiple of alignof(P), or height <= 1
template <class P>
class [[gnu::visibility("default")]] image_view {
public:
  constexpr image_view() = default;
  /// A view of rows that follow each other without a gap.
  IRG_INLINE constexpr image_view(P* first_row, int width, int height) noexcept
      : image_view(first_row, width, height,
                   static_cast<std::ptrdiff_t>(width) * static_cast<std::ptrdiff_t>(sizeof(P))) {}
  IRG_INLINE constexpr image_view(P* first_row, int width, int height, std::ptrdiff_t stride_in_bytes) noexcept
      : first_(first_row), width_(width), height_(height), stride_(stride_in_bytes) {
    IRG_EXPECTS(width >= 0 && height >= 0);
    IRG_EXPECTS(stride_in_bytes % static_cast<std::ptrdiff_t>(alignof(P)) == 0);
  }

  /// The same window, for reading only.
  IRG_INLINE constexpr operator image_view<const P>() const noexcept
    requires(!std::is_const_v<P>)
  {
    return {first_, width_, height_, stride_};
  }

  [[nodiscard]] IRG_INLINE constexpr int width() const noexcept { return width_; }
  [[nodiscard]] IRG_INLINE constexpr int height() const noexcept { return height_; }
  [[nodiscard]] IRG_INLINE constexpr std::ptrdiff_t stride() const noexcept { return stride_; }
  [[nodiscard]] IRG_INLINE constexpr std::ptrdiff_t bytes_per_row() const noexcept { return stride_; }

  /// The pixels of row y.
  /// needs   0 <= y < height()
  [[nodiscard]] IRG_INLINE constexpr P* row(int y) const noexcept {
    IRG_EXPECTS(0 <= y && y < height_);
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(sizeof(P));
    if (stride_ % size == 0) return first_ + stride_ / size * y;
    return byte_offset(stride_ * y);
  }
  IRG_INLINE constexpr P& operator()(int x, int y) const noexcept {
    IRG_EXPECTS(0 <= x && x < width_);
    return row(y)[x];
  }

private:
  // Rows padded by a number of bytes that is no multiple of the pixel: possible at run time only.
  [[nodiscard]] IRG_INLINE P* byte_offset(std::ptrdiff_t bytes) const noexcept {
    if constexpr (std::is_const_v<P>)
      return reinterpret_cast<P*>(reinterpret_cast<const char*>(first_) + bytes);
    else
      return reinterpret_cast<P*>(reinterpret_cast<char*>(first_) + bytes);
  }

  P* first_ = nullptr;
  int width_ = 0, height_ = 0;
  std::ptrdiff_t stride_ = 0;
};

/// A rectangle of pixels in memory, row after row from the top; the first pixel is aligned to 64 bytes at run time.
template <class P>
class image {
  static_assert(!std::same_as<P, bool>, "std::vector<bool> holds no pixels one could point to; use unsigned char");

public:
  constexpr image() = default;
  /// An image of one colour.
  /// needs   width >= 0, height >= 0
  IRG_INLINE constexpr image(int width, int height, const P& fill = P{})
      : width_((IRG_EXPECTS(width >= 0 && height >= 0), width)), height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}
  /// The same of a size; not from bare braces, which could as well be an image.
  template <std::same_as<extent2> Extent>
  IRG_INLINE constexpr explicit image(const Extent& size, const P& fill = P{}) : image(size.width, size.height, fill) {}

  [[nodiscard]] IRG_INLINE constexpr int width() const noexcept { return width_; }
  [[nodiscard]] IRG_INLINE constexpr int height() const noexcept { return height_; }
  [[nodiscard]] IRG_INLINE constexpr std::ptrdiff_t bytes_per_row() const noexcept {
    return static_cast<std::ptrdiff_t>(width_) * static_cast<std::ptrdiff_t>(sizeof(P));
  }
  IRG_INLINE constexpr P* row(int y) noexcept { return pixels_.data() + offset(y); }
  [[nodiscard]] IRG_INLINE constexpr const P* row(int y) const noexcept { return pixels_.data() + offset(y); }
  IRG_INLINE constexpr P& operator()(int x, int y) noexcept { return row(y)[(IRG_EXPECTS(0 <= x && x < width_), x)]; }
  IRG_INLINE constexpr const P& operator()(int x, int y) const noexcept {
    return row(y)[(IRG_EXPECTS(0 <= x && x < width_), x)];
  }
  IRG_INLINE constexpr P* data() noexcept { return pixels_.data(); }
  [[nodiscard]] IRG_INLINE constexpr const P* data() const noexcept { return pixels_.data(); }

  IRG_INLINE constexpr image_view<P> view() noexcept { return {pixels_.data(), width_, height_}; }
  [[nodiscard]] IRG_INLINE constexpr image_view<const P> view() const noexcept {
    return {pixels_.data(), width_, height_};
  }
  /// The view, where one is asked for: functions that take views take images.
  IRG_INLINE constexpr operator image_view<P>() & noexcept { return view(); }
  IRG_INLINE constexpr operator image_view<const P>() const& noexcept { return view(); }

  bool operator==(const image&) const
    requires std::equality_comparable<P>
  = default;

private:
  [[nodiscard]] IRG_INLINE constexpr std::size_t offset(int y) const noexcept {
    IRG_EXPECTS(0 <= y && y < height_);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  }

  int width_ = 0, height_ = 0;
  std::vector<P, detail::line_allocator<P>> pixels_;
};

inline namespace IRG_ABI {

/// The pixels of a raster whose rows are all the same distance apart, as a view: what draws into views is compiled once
/// for all such rasters.
/// needs   a distance that is a multiple of the pixel's alignment
template <EvenRowRaster R>
[[nodiscard]] IRG_INLINE constexpr image_view<pixel_of<R>> view_of(R& r) {
  if (height_of(r) == 0) return {nullptr, width_of(r), 0};
  return {raster_traits<R>::row(r, 0), width_of(r), height_of(r), bytes_per_row_of(r)};
}

}  // namespace IRG_ABI
}  // namespace irg
