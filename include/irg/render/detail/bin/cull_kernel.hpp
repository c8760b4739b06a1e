// SPDX-License-Identifier: MIT
// Which of N triangles are to be drawn, and their boxes of pixels: a register of triangles at a time.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/raster/triangle_coverage.hpp>
#include <irg/raster/vertex_lanes.hpp>
#include <irg/render/options.hpp>
#include <irg/raster/triangle_batch.hpp>
#include <irg/raster/window.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

static_assert(sizeof(triangle_indices) == 12);

// Asks for the vertices that a triangle names. They may be beyond the array.
IRG_INLINE void prefetch_vertices(const screen_vertex* screen, const triangle_indices& t) noexcept {
  for (const std::uint32_t v : t.v) prefetch(screen, static_cast<std::ptrdiff_t>(std::size_t{v} * sizeof *screen));
}

// The boxes of N triangles on the screen, and twice their areas.
template <int N>
struct triangle_boxes {
  using integers = pack<std::int32_t, N>;
  integers left, right, top, bottom;
  integers narrow;  // sides below 2^15, which leave the area within 31 bits and a sign; where not, it is of no account
  integers double_area;

  IRG_INLINE triangle_boxes(const integers (&x)[3], const integers (&y)[3]) noexcept
      : left(low_of(low_of(x[0], x[1]), x[2])), right(high_of(high_of(x[0], x[1]), x[2])),
        top(low_of(low_of(y[0], y[1]), y[2])), bottom(high_of(high_of(y[0], y[1]), y[2])),
        narrow(both(right - left < (1 << 15), bottom - top < (1 << 15))),
        double_area((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0])) {}
};

// What became of N triangles: one bit per lane.
template <int N>
struct culled_group {
  unsigned listed = 0;  // to be drawn: box(k) is not empty
  unsigned special = 0;  // too large for 32 bits, or to be clipped: not decided here
  skip_counts skipped;
  static constexpr unsigned count = N;
  std::int32_t x_first[count], y_first[count], x_last[count], y_last[count];

  IRG_INLINE cell_window box(std::uint32_t k) const noexcept { return {x_first[k], y_first[k], x_last[k], y_last[k]}; }
};

template <int N>
struct cull_kernel {
  using integers = pack<std::int32_t, N>;
  const screen_vertex* screen;
  const clip_code_pair* codes;
  std::int32_t vertices;  // how many there are
  clip_code_pair any;
  cell_window picture;
  face_culling culling;

  // Asks for the vertices of a later group; for its indices, which has to come long before.
  IRG_INLINE void fetch_ahead(const triangle_indices* t) const noexcept {
    for (int i = 0; i < N; ++i) prefetch_vertices(screen, t[i]);
  }
  IRG_INLINE static void fetch_indices(const triangle_indices* t) noexcept {
    constexpr std::size_t line = 64;
    for (std::size_t i = 0; i < N * sizeof *t; i += line) prefetch(t, static_cast<std::ptrdiff_t>(i));
  }

  // Whether all corners of N triangles name vertices.
  IRG_INLINE bool indices_valid(const triangle_indices* t) const noexcept {
    using J = lanes<integers>;
    integers valid = J::broadcast(-1);
    for (int k = 0; k < 3; ++k) {
      const integers w = J::load_bytes(reinterpret_cast<const char*>(t) + k * static_cast<int>(sizeof w));
      valid = both(valid, both(w >= 0, w < vertices));
    }
    return mask_bits(valid) == (1u << N) - 1;
  }

  IRG_INLINE culled_group<N> operator()(const triangle_indices* t, const skip_options& skip) const noexcept {
    using J = lanes<integers>;
    culled_group<N> group;
    if (!indices_valid(t)) {  // some name vertices that are not there
      group.special = (1u << N) - 1;
      return group;
    }
    integers x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      const auto corner = load_vertices<N>(screen, [&](int i) { return t[i].v[k]; });
      x[k] = corner.x;
      y[k] = corner.y;
    }
    unsigned alive = (1u << N) - 1;
    if (any.outside != 0 || any.cut != 0) {
      unsigned cut = 0, outside = 0;
      for (unsigned bits = alive; bits != 0; bits &= bits - 1) {
        const int i = std::countr_zero(bits);
        const clip_code_pair a = codes[t[i].v[0]], b = codes[t[i].v[1]], c = codes[t[i].v[2]];
        if ((a | b | c).cut != 0) cut |= 1u << i;
        if ((a & b & c).outside != 0) outside |= 1u << i;
      }
      group.special = cut;
      alive &= ~cut;
      if (skip.frustum == skipping::on) {
        group.skipped.frustum += std::popcount(alive & outside);
        alive &= ~outside;
      }
    }

    const triangle_boxes<N> boxes(x, y);
    const unsigned narrow = mask_bits(boxes.narrow);
    const integers &area = boxes.double_area, zero = J::broadcast(0);
    group.special |= alive & ~narrow;
    alive &= narrow;
    if (culling == face_culling::back) {
      const unsigned back = mask_bits(zero < area) & alive;
      group.skipped.backface += std::popcount(back);
      alive &= ~back;
    }
    if (alive == 0) return group;  // often, as neighbours face the same way
    // The centres within the box, then those within the picture.
    const integers x_first = first_centre(boxes.left), x_last = last_centre(boxes.right);
    const integers y_first = first_centre(boxes.top), y_last = last_centre(boxes.bottom);
    const unsigned tiny =
        alive & (mask_bits(area == zero) | mask_bits(x_first >= x_last) | mask_bits(y_first >= y_last));
    const integers seen_x_first = high_of(x_first, J::broadcast(picture.x_first)),
                   seen_x_last = low_of(x_last, J::broadcast(picture.x_last)),
                   seen_y_first = high_of(y_first, J::broadcast(picture.y_first)),
                   seen_y_last = low_of(y_last, J::broadcast(picture.y_last));
    const unsigned unseen =
        alive & ~tiny & (mask_bits(seen_x_first >= seen_x_last) | mask_bits(seen_y_first >= seen_y_last));
    if (skip.tiny == skipping::on)
      group.skipped.tiny += std::popcount(tiny);
    else
      group.special |= tiny;
    if (skip.frustum == skipping::on) group.skipped.frustum += std::popcount(unseen);
    group.listed = alive & ~tiny & ~unseen;
    J::store(group.x_first, seen_x_first);
    J::store(group.x_last, seen_x_last);
    J::store(group.y_first, seen_y_first);
    J::store(group.y_last, seen_y_last);
    return group;
  }
};

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
