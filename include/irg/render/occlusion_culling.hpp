// SPDX-License-Identifier: MIT
// occlusion_culling: objects that are hidden whole are found by their boxes, before a vertex of theirs is touched. The
// large and simple objects in front are drawn into a small mask; what lies behind it is left out.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/geometry/box.hpp>
#include <irg/raster/depth.hpp>
#include <irg/raster/projected_vertices.hpp>
#include <irg/raster/screen_mapping.hpp>
#include <irg/render/detail/occlude/object_extent.hpp>
#include <irg/render/detail/visible/tile_test.hpp>
#include <irg/view/frustum.hpp>
#if IRG_BODIES
#include <algorithm>

#include <irg/math/floor_division.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/triangle_batch.hpp>
#include <irg/render/detail/bin/scratch_portion.hpp>
#include <irg/render/detail/occlude/mask_query.hpp>
#include <irg/render/detail/visible/tile.hpp>
#endif

namespace irg {

/// An object that may be left out.
template <Floating T>
struct occludable_object {
  box<T, 3> bounds;  // around all positions
  std::span<const point<T, 3>> positions;
  std::span<const triangle_indices> triangles;
};

}  // namespace irg

namespace irg::detail {

// The memory of a mask. Keys as in tile.hpp.
struct block_mask {
  int width = 0, height = 0, across = 0, down = 0;  // in pixels and in blocks
  float sign = 1;
  std::vector<float> farthest_key, layer_key;  // by block
  std::vector<std::uint64_t> layer;  // the pixels that have `layer_key` or a nearer one, row after row

  IRG_INLINE constexpr std::size_t at(int bx, int by) const noexcept {
    return static_cast<std::size_t>(by) * static_cast<std::size_t>(across) + static_cast<std::size_t>(bx);
  }
};

// Tells of boxes whether no triangle in them can be seen. Beyond a depth plane that is certain; beyond a border of the
// picture only where nothing is clipped, because clipping rounds, and may round a far-off corner into sight.
template <class T>
struct object_culling {
  frustum<T> picture, guard, depth;

  IRG_INLINE constexpr object_culling(const mat<T, 4, 4>& to_clip, const screen_mapping<T>& mapping) noexcept;
  IRG_INLINE constexpr bool unseen(const box<T, 3>& b) const noexcept;
  // Whether no triangle in the box is clipped.
  IRG_INLINE constexpr bool unclipped(const box<T, 3>& b) const noexcept;
};

template <class T>
struct occlusion_view {
  mat<T, 4, 4> to_clip;
  screen_mapping<T> mapping;
  int width, height;
  float sign, farthest;  // of keys, as in tile.hpp
  object_culling<T> frustum;
  block_mask mask;  // without blocks until something is drawn
  projected_vertices<T> vertices;

  IRG_INLINE constexpr occlusion_view(const mat<T, 4, 4>& matrix, int w, int h, float key_sign, float farthest_key)
      : to_clip(matrix), mapping(map_to_screen<T>({maximum(w, 1), maximum(h, 1)})), width(w), height(h), sign(key_sign),
        farthest(farthest_key), frustum(to_clip, mapping) {}
  IRG_INLINE constexpr bool has_pixels() const noexcept { return width > 0 && height > 0; }
};

}  // namespace irg::detail

namespace irg {

/// Chooses occluders among the objects of a picture, and tells which of the others they hide.
/// shape   one view: a matrix to clip space and the size of the picture, at most 65536 x 65536
/// exact   shade_batches leaves the same picture and depths with the hidden objects and without them, as long as all
///         occluders that are not hidden themselves are drawn, with the same matrix, size, Order and culling of faces.
///         At every pixel a hidden object is farther than some occluder, never as near: ties are not concerned
/// source  Greene, Kass and Miller 1993 for asking for boxes first; Hasselgren, Andersson and Akenine-Moller 2016 for
///         blocks with one layer that is not yet complete
template <Floating T, DepthOrder Order = nearer_is_greater>
  requires(detail::key_sign<Order> != 0 && !std::same_as<Order, drawing_order>)
class occlusion_culling {
public:
  IRG_INLINE constexpr occlusion_culling(const mat<T, 4, 4>& to_clip, const extent2& size)
      : view_(to_clip, size.width, size.height, detail::key_sign<Order>, Order::farthest * detail::key_sign<Order>) {}
  [[deprecated("irg: occlusion_culling(to_clip, {width, height})")]] IRG_INLINE constexpr occlusion_culling(
      const mat<T, 4, 4>& to_clip, int width, int height)
      : occlusion_culling(to_clip, extent2{width, height}) {}

  /// The objects that are worth drawing as occluders, the best first: those whose box covers 1024 pixels or more for
  /// each of their triangles.
  /// gives   none among fewer than two objects; together at most a sixteenth of all triangles, though always up to 64,
  ///         and boxes of four times the picture's size, though always one
  /// cost    the boxes of objects of few triangles, and sorting those that qualify
  [[nodiscard]] IRG_APART IRG_INLINE constexpr std::vector<std::uint32_t> choose_occluders(
      std::span<const object_extent<T>> objects) const;

  /// Draws an occluder into the mask.
  /// gives   triangles that face away, where those are culled, and those with a corner that is not finite or not there
  ///         hide nothing
  /// cost    its vertices, and the blocks of 8 x 8 pixels that its triangles cover
  IRG_INLINE constexpr void add_occluder(std::span<const point<T, 3>> positions,
                                         std::span<const triangle_indices> triangles,
                                         face_culling culling = face_culling::back);

  /// Whether everything in a box is hidden by the occluders.
  /// gives   false for a box that is empty, has a coordinate that is not a number, or reaches before the near plane, to
  ///         the far plane, or beyond the guard band
  /// cost    eight corners, and the blocks of its rectangle until one shows
  [[nodiscard]] IRG_INLINE constexpr bool hides(const box<T, 3>& bounds) const noexcept;

  /// Whether everything in a box lies beyond a plane of the frustum.
  [[nodiscard]] IRG_INLINE constexpr bool is_beyond(const box<T, 3>& bounds) const noexcept {
    return view_.frustum.unseen(bounds);
  }

  /// The numbers of the objects that may be seen, in their order: not beyond the frustum, and not hidden by the
  /// occluders that are chosen among them, or were added before.
  /// cost    the boxes, and the occluders
  IRG_INLINE constexpr std::vector<std::uint32_t> visible_objects(std::span<const occludable_object<T>> objects,
                                                                  face_culling culling = face_culling::back);

  /// Forgets the occluders; the memory is kept for the next ones.
  IRG_INLINE constexpr void clear() noexcept { view_.mask.layer.clear(); }

private:
  detail::occlusion_view<T> view_;
};

}  // namespace irg

namespace irg::detail {
inline namespace IRG_ABI {

// The matrix of a picture that is wider and higher by the guard factors.
template <class T>
IRG_INLINE constexpr mat<T, 4, 4> with_guard(mat<T, 4, 4> m, const clip_volume<T>& v) noexcept {
  for (int c = 0; c < 4; ++c) {
    m(0, c) = m(0, c) / v.guard_x;
    m(1, c) = m(1, c) / v.guard_y;
  }
  return m;
}

}  // namespace IRG_ABI

template <class T>
IRG_INLINE constexpr object_culling<T>::object_culling(const mat<T, 4, 4>& to_clip,
                                                       const screen_mapping<T>& mapping) noexcept
    : picture(frustum_of(to_clip)), guard(frustum_of(with_guard(to_clip, mapping.guard))), depth(picture) {
  const plane<T> everything{T(0), T(0), T(0), T(1)};
  for (const auto side : {frustum_plane::left, frustum_plane::right, frustum_plane::bottom, frustum_plane::top})
    depth.planes[static_cast<int>(side)] = depth.weights[static_cast<int>(side)] = everything;
}

template <class T>
IRG_INLINE constexpr bool object_culling<T>::unseen(const box<T, 3>& b) const noexcept {
  return classify(depth, b) == containment::outside || (classify(picture, b) == containment::outside && unclipped(b));
}

template <class T>
IRG_INLINE constexpr bool object_culling<T>::unclipped(const box<T, 3>& b) const noexcept {
  return classify(guard, b) == containment::inside;
}

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API std::vector<std::uint32_t> choose_occluders(const occlusion_view<T>& v,
                                                    std::span<const object_extent<T>> objects);
template <Floating T>
IRG_API void add_occluder(occlusion_view<T>& v, std::span<const point<T, 3>> positions,
                          std::span<const triangle_indices> triangles, face_culling culling);
template <Floating T>
IRG_API bool hides_box(const occlusion_view<T>& v, const box<T, 3>& bounds) noexcept;
template <Floating T>
IRG_API std::vector<std::uint32_t> visible_objects(occlusion_view<T>& v, std::span<const occludable_object<T>> objects,
                                                   face_culling culling);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail

namespace irg {

template <Floating T, DepthOrder Order>
  requires(detail::key_sign<Order> != 0 && !std::same_as<Order, drawing_order>)
[[nodiscard]] IRG_INLINE constexpr std::vector<std::uint32_t> occlusion_culling<T, Order>::choose_occluders(
    std::span<const object_extent<T>> objects) const {
  return detail::choose_occluders(view_, objects);
}

template <Floating T, DepthOrder Order>
  requires(detail::key_sign<Order> != 0 && !std::same_as<Order, drawing_order>)
IRG_INLINE constexpr void occlusion_culling<T, Order>::add_occluder(std::span<const point<T, 3>> positions,
                                                                    std::span<const triangle_indices> triangles,
                                                                    face_culling culling) {
  detail::add_occluder(view_, positions, triangles, culling);
}

template <Floating T, DepthOrder Order>
  requires(detail::key_sign<Order> != 0 && !std::same_as<Order, drawing_order>)
[[nodiscard]] IRG_INLINE constexpr bool occlusion_culling<T, Order>::hides(const box<T, 3>& bounds) const noexcept {
  return detail::hides_box(view_, bounds);
}

template <Floating T, DepthOrder Order>
  requires(detail::key_sign<Order> != 0 && !std::same_as<Order, drawing_order>)
IRG_INLINE constexpr std::vector<std::uint32_t> occlusion_culling<T, Order>::visible_objects(
    std::span<const occludable_object<T>> objects, face_culling culling) {
  return detail::visible_objects(view_, objects, culling);
}

}  // namespace irg

#if IRG_BODIES
namespace irg::detail {
inline namespace IRG_ABI {

// What large triangles hide, by blocks of 8 x 8 pixels: for each block a key that no pixel of it lies behind, and one
// layer of triangles that so far cover it in part. When the layer covers the block it becomes the block's key, so that
// two triangles with a common edge hide as much as the face they were cut from. Coverage is exact to the pixel, depths
// are never nearer than those that drawing gives.

inline constexpr std::uint64_t whole_block = ~std::uint64_t{0};

// An empty mask.
constexpr void clear_block_mask(block_mask& m, int width, int height, float sign, float farthest) {
  m.width = width;
  m.height = height;
  m.across = (width + block_size - 1) / block_size;
  m.down = (height + block_size - 1) / block_size;
  m.sign = sign;
  const std::size_t count = static_cast<std::size_t>(m.across) * static_cast<std::size_t>(m.down);
  m.farthest_key.assign(count, farthest);
  m.layer_key.assign(count, farthest);
  m.layer.assign(count, 0);
}

// The pixels of a block that lie in a window; bit 8 * y + x.
constexpr std::uint64_t block_bits(const cell_window& w, int bx, int by) noexcept {
  const int x = bx * block_size, y = by * block_size;
  const cell_window in = intersect(w, {x, y, x + block_size, y + block_size});
  if (in.empty()) return 0;
  const auto bits_below = [](int n) { return n == 8 ? whole_block : (std::uint64_t{1} << 8 * n) - 1; };
  const std::uint64_t row = ((std::uint64_t{1} << (in.x_last - x)) - 1) & ~((std::uint64_t{1} << (in.x_first - x)) - 1);
  const std::uint64_t rows = bits_below(in.y_last - y) & ~bits_below(in.y_first - y);
  return row * 0x0101010101010101u & rows;
}

// The pixels of a block that a triangle covers.
constexpr std::uint64_t block_coverage(const triangle_coverage& t, int bx, int by) noexcept {
  std::uint64_t bits = 0;
  for (int y = 0; y < block_size; ++y) {
    const int row = by * block_size + y, x = bx * block_size;
    std::int64_t f[3] = {t.edge[0](x, row), t.edge[1](x, row), t.edge[2](x, row)};
    for (int i = 0; i < block_size; ++i) {
      bits |= std::uint64_t{(f[0] | f[1] | f[2]) >= 0} << (y * block_size + i);
      for (int k = 0; k < 3; ++k) f[k] += t.edge[k].right;
    }
  }
  return bits;
}

// Some pixels of a block at `key` or nearer. One layer cannot hold two depths: of two that are far apart the nearer one
// is kept alone.
constexpr void cover_block(block_mask& m, std::size_t block, std::uint64_t bits, float key) noexcept {
  float& farthest = m.farthest_key[block];
  float& layer_key = m.layer_key[block];
  std::uint64_t& layer = m.layer[block];
  if (!(farthest < key)) return;
  if (layer == 0 || !(farthest < layer_key) || key - layer_key > layer_key - farthest) {
    layer = bits;
    layer_key = key;
  } else if (layer_key - key <= key - farthest) {
    layer |= bits;
    layer_key = minimum(layer_key, key);
  }
  if (layer != whole_block) return;
  farthest = layer_key;
  layer = 0;
}

// The columns of blocks, between first and last, in whose row `by` an edge has some, and has all, pixels on its inner
// side.
struct block_columns {
  std::int64_t first, last, inner_first, inner_last;
};
constexpr void limit_columns(block_columns& c, const triangle_edge& e, int by) noexcept {
  constexpr std::int64_t far_side = block_size - 1;
  const std::int64_t at_start = e(0, by * block_size), step = std::int64_t{e.right} * block_size;
  const std::int64_t across = e.right * far_side, along = e.down * far_side, zero = 0;
  const auto limit = [&](std::int64_t f, std::int64_t& first, std::int64_t& last) {
    if (step > 0)
      first = maximum(first, -floor_div(f, step));
    else if (step < 0)
      last = minimum(last, floor_div(f, -step) + 1);
    else if (f < 0)
      last = first;
  };
  limit(at_start + maximum(across, zero) + maximum(along, zero), c.first, c.last);
  limit(at_start + minimum(across, zero) + minimum(along, zero), c.inner_first, c.inner_last);
}

// A plane of keys: that of a pixel is (base + right * X) + down * Y, with (X, Y) counted from vertex 0 in 1/256 pixel,
// or `low` where that is nearer.
struct key_plane {
  float base, right, down, low;

  IRG_INLINE constexpr float across(float x) const noexcept { return base + product(right, x); }
  IRG_INLINE constexpr float rise(float y) const noexcept { return product(down, y); }
};

// The plane through three vertices, lowered by what rounding may amount to, here and in shade_triangle: no covered
// pixel is farther. None is farther than the farthest vertex either, which is the better bound for slivers.
constexpr key_plane plane_below(const screen_vertex& a, const screen_vertex& b, const screen_vertex& c,
                                float sign) noexcept {
  const auto number = [](std::int64_t i) { return static_cast<float>(i); };
  const auto absolute = [](float v) { return v < 0 ? -v : v; };
  const subpixel &p = a.position, &q = b.position, &r = c.position;
  const float x1 = number(q.x - p.x), y1 = number(q.y - p.y), x2 = number(r.x - p.x), y2 = number(r.y - p.y);
  const float width = number(maximum(maximum(p.x, q.x), r.x) - minimum(minimum(p.x, q.x), r.x)),
              height = number(maximum(maximum(p.y, q.y), r.y) - minimum(minimum(p.y, q.y), r.y));
  const float key0 = product(a.depth, sign), key1 = product(b.depth, sign), key2 = product(c.depth, sign);
  const float inverse = 1.0f / number(twice_signed_area(p, q, r)), k1 = key1 - key0, k2 = key2 - key0;
  const float right1 = product(k1, y2), right2 = product(k2, y1), down1 = product(k2, x1), down2 = product(k1, x2);
  const float size_right = product(absolute(right1) + absolute(right2), absolute(inverse)),
              size_down = product(absolute(down1) + absolute(down2), absolute(inverse));
  const float size = (product(size_right, width) + product(size_down, height)) +
                     maximum(maximum(absolute(key0), absolute(key1)), absolute(key2));
  // Each path from vertices to a key takes less than 12 roundings of 2^-24, and shade_triangle's errs by 8 of them.
  const float bias = product(size, 0x1p-19f) + 0x1p-140f;
  return {key0 - bias, product(right1 - right2, inverse), product(down1 - down2, inverse),
          minimum(minimum(key0, key1), key2)};
}

// From a vertex to the centre of a pixel, in 1/256 pixel; exact.
IRG_INLINE constexpr float offset_to(int pixel, std::int32_t vertex) noexcept {
  return static_cast<float>(pixel * one_pixel + half_pixel - vertex);
}

// Draws a triangle.
constexpr void draw_block_mask(block_mask& m, const screen_vertex& a, const screen_vertex& b, const screen_vertex& c) {
  const triangle_coverage t = cover_triangle(a.position, b.position, c.position);
  const cell_window picture{0, 0, m.width, m.height}, w = intersect(t.bounds, picture);
  if (t.double_area == 0 || w.empty()) return;
  const key_plane plane = plane_below(a, b, c, m.sign);
  const int right = plane.right < 0 ? block_size - 1 : 0, down = plane.down < 0 ? block_size - 1 : 0;
  const cell_window blocks = squares_of(w, block_size);
  for (int by = blocks.y_first; by < blocks.y_last; ++by) {
    block_columns columns{blocks.x_first, blocks.x_last, blocks.x_first, blocks.x_last};
    for (const triangle_edge& e : t.edge) limit_columns(columns, e, by);
    // The farthest key in a block: rounding never turns the order of keys round, so it is in a corner.
    const float rise = plane.rise(offset_to(by * block_size + down, a.position.y));
    const auto key_of = [&](int bx) {
      const float key = plane.across(offset_to(bx * block_size + right, a.position.x)) + rise;
      return maximum(plane.low, key);
    };
    const auto in_part = [&](std::int64_t from, std::int64_t to) {
      for (std::int64_t i = from; i < to; ++i) {
        const int bx = static_cast<int>(i);
        const std::uint64_t bits = block_coverage(t, bx, by) | ~block_bits(picture, bx, by);
        cover_block(m, m.at(bx, by), bits, key_of(bx));
      }
    };
    if (columns.inner_first >= columns.inner_last) {
      in_part(columns.first, columns.last);
      continue;
    }
    in_part(columns.first, columns.inner_first);
    float* const row = m.farthest_key.data() + m.at(0, by);
    for (std::int64_t i = columns.inner_first; i < columns.inner_last; ++i) {
      const float key = key_of(static_cast<int>(i));
      row[i] = row[i] < key ? key : row[i];
    }
    in_part(columns.inner_last, columns.last);
  }
}

// Whether everything in a window of pixels that is at `key` or farther is hidden. Hidden means behind what was drawn:
// `key` or a nearer one at each pixel.
constexpr bool hidden_by_blocks(const block_mask& m, const cell_window& pixels, float key) noexcept {
  const cell_window w = intersect(pixels, {0, 0, m.width, m.height});
  if (w.empty() || !(key == key)) return false;
  return !any_square(w, block_size, [&](const cell_window& part, int bx, int by) {
    const std::size_t block = m.at(bx, by);
    if (key <= m.farthest_key[block]) return false;
    return !(key <= m.layer_key[block]) || (block_bits(part, bx, by) & ~m.layer[block]) != 0;
  });
}

}  // namespace IRG_ABI

// One view: which objects are worth drawing into the mask, drawing them, and asking for boxes.

// The pixels of an object's rectangle: for each of its triangles, and together.
struct occluder_worth {
  std::int64_t each, pixels;
  std::uint32_t object;

  IRG_INLINE constexpr bool operator<(const occluder_worth& o) const noexcept {
    return each != o.each ? o.each < each : object < o.object;
  }
};

inline namespace IRG_ABI {

// What makes an occluder: pixels for each of its triangles.
inline constexpr std::int64_t least_occluder_pixels = 16 * block_size * block_size;

template <class T>
constexpr mask_rectangle rectangle_of(const occlusion_view<T>& v, const box<T, 3>& bounds) noexcept {
  return project_box(bounds, v.to_clip, v.width, v.height, v.sign);
}

// The pixels of a box; all of the picture for one that reaches before the near plane.
template <class T>
constexpr std::int64_t pixels_of(const occlusion_view<T>& v, const box<T, 3>& bounds) noexcept {
  if (v.frustum.unseen(bounds)) return 0;
  const mask_rectangle r = rectangle_of(v, bounds);
  if (r.where == mask_place::outside) return 0;
  if (r.where == mask_place::before_the_eye) return std::int64_t{v.width} * v.height;
  return std::int64_t{r.pixels.x_last - r.pixels.x_first} * (r.pixels.y_last - r.pixels.y_first);
}

// See occlusion_culling::choose_occluders; object(i) has the bounds of object i, and how many triangles it has.
template <class T, class Object>
constexpr std::vector<std::uint32_t> choose_among(const occlusion_view<T>& v, std::size_t count, const Object& object) {
  std::vector<std::uint32_t> occluders;
  std::vector<occluder_worth> candidates;
  if (count < 2 || !v.has_pixels()) return occluders;
  const std::int64_t picture = std::int64_t{v.width} * v.height;
  std::int64_t triangles = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = static_cast<std::int64_t>(object(i).triangles);
    triangles += n;
    if (n == 0 || n > picture / least_occluder_pixels) continue;
    const std::int64_t pixels = pixels_of(v, object(i).bounds);
    if (pixels / n >= least_occluder_pixels) candidates.push_back({pixels / n, pixels, static_cast<std::uint32_t>(i)});
  }
  std::sort(candidates.begin(), candidates.end());
  std::int64_t pixels_left = 4 * picture, triangles_left = maximum(triangles / 16, std::int64_t{64});
  for (const occluder_worth& w : candidates) {
    const auto n = static_cast<std::int64_t>(object(w.object).triangles);
    if (n > triangles_left) continue;
    if (pixels_left < w.pixels && !occluders.empty()) break;
    occluders.push_back(w.object);
    pixels_left -= w.pixels;
    triangles_left -= n;
  }
  return occluders;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API std::vector<std::uint32_t> choose_occluders(const occlusion_view<T>& v,
                                                    std::span<const object_extent<T>> objects) {
  return choose_among(v, objects.size(), [&](std::size_t i) -> auto& { return objects[i]; });
}

template <Floating T>
IRG_API void add_occluder(occlusion_view<T>& v, std::span<const point<T, 3>> positions,
                          std::span<const triangle_indices> triangles, face_culling culling) {
  if (!v.has_pixels()) return;
  if (v.mask.layer.empty()) clear_block_mask(v.mask, v.width, v.height, v.sign, v.farthest);
  project_vertices<T>(positions, v.to_clip, v.mapping, v.vertices);
  const triangle_batch<T> batch{&v.vertices, triangles, 0};
  const listing_rules<T> rules{v.mapping, {v.width, v.height}, culling};
  bin_portion scratch = scratch_portion(rules.grid);
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    list_and_draw(scratch, batch, i, rules,
                  [&](const triangle_corners& c) { draw_block_mask(v.mask, *c.v[0], *c.v[1], *c.v[2]); });
}

template <Floating T>
IRG_API bool hides_box(const occlusion_view<T>& v, const box<T, 3>& bounds) noexcept {
  // What is clipped is rounded once more, so that its box would not be sure to hold it.
  if (v.mask.layer.empty() || !v.frustum.unclipped(bounds)) return false;
  const mask_rectangle r = rectangle_of(v, bounds);
  return r.where == mask_place::on_screen && hidden_by_blocks(v.mask, r.pixels, r.key);
}

template <Floating T>
IRG_API std::vector<std::uint32_t> visible_objects(occlusion_view<T>& v, std::span<const occludable_object<T>> objects,
                                                   face_culling culling) {
  struct extent {
    const box<T, 3>& bounds;
    std::size_t triangles;
  };
  const auto extent_of = [&](std::size_t i) { return extent{objects[i].bounds, objects[i].triangles.size()}; };
  for (const std::uint32_t i : choose_among(v, objects.size(), extent_of))
    add_occluder<T>(v, objects[i].positions, objects[i].triangles, culling);
  std::vector<std::uint32_t> visible;
  for (std::uint32_t i = 0; i < objects.size(); ++i)
    if (!v.frustum.unseen(objects[i].bounds) && !hides_box(v, objects[i].bounds)) visible.push_back(i);
  return visible;
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
