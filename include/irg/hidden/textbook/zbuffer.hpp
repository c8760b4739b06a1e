// SPDX-License-Identifier: MIT
// The z-buffer as textbooks have it: a screen buffer, a depth buffer cleared to the back plane, and a SetPixel that
// draws what is strictly nearer than what is there. Which depth is nearer, and how depths are kept, a type names.
//
// It is meant for reading and for comparison, and takes any raster and any number; draw_triangle and render are the
// ones for speed. Drawn from the faces of a picture (zbuffer_face), it gives the numbers that render gives.
#pragma once

#include <limits>

#include <irg/geometry/flat_ring.hpp>
#include <irg/hidden/plane_depth.hpp>
#include <irg/raster/depth_format.hpp>
#include <irg/raster/depth_options.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/screen_face.hpp>

namespace irg::textbook {

/// Stands for the buffer of object references where none is wanted.
struct no_references {};

/// What a polygon puts into its pixels where a buffer of object references is kept: value goes to the screen, reference
/// to that buffer.
template <class Value, class Reference>
struct object_value {
  Value value;
  Reference reference;
};
template <class Value, class Reference>
object_value(Value, Reference) -> object_value<Value, Reference>;

/// How depths are got along a polygon's rows.
enum class depth_evaluation {
  plane,  // from the plane's equation at each pixel
  steps  // by adding: z in parallel projection, 1/(d - z) in perspective
};

}  // namespace irg::textbook

namespace irg::detail {

template <class V>
inline constexpr bool is_object_value = false;
template <class V, class R>
inline constexpr bool is_object_value<textbook::object_value<V, R>> = true;

// A value for all pixels, or f(x, y, z) for each.
template <class V, class R, class Z>
concept PixelValue = std::convertible_to<const V&, pixel_of<R>> || requires(const V& f, const Z& z) {
  { f(0, 0, z) } -> std::convertible_to<pixel_of<R>>;
};

template <class R>
struct reference_of {
  using type = textbook::no_references;
};
template <WritableRaster R>
struct reference_of<R> {
  using type = pixel_of<R>;
};

inline namespace IRG_ABI {

template <WritableRaster R, class Z, PixelValue<R, Z> V>
IRG_INLINE constexpr void put_value(R& raster, int x, int y, const Z& z, const V& value) {
  if constexpr (std::convertible_to<const V&, pixel_of<R>>)
    set_pixel(raster, x, y, static_cast<pixel_of<R>>(value));
  else
    set_pixel(raster, x, y, static_cast<pixel_of<R>>(value(x, y, z)));
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::textbook {

/// What is drawn into one pixel: a pixel of the screen, with a reference where there is a buffer of them.
template <WritableRaster Screen, class References>
using zbuffer_value =
    std::conditional_t<std::same_as<References, no_references>, pixel_of<Screen>,
                       object_value<pixel_of<Screen>, typename detail::reference_of<References>::type>>;

/// Screen buffer, depth buffer and, where given, a buffer of object references, for drawing in one depth order. It
/// holds on to the rasters, it does not own them; where they differ in size, the pixels that all have count.
/// shape   zbuffer buffers{nearer_is_greater{}, screen, depth}; z towards the viewer with nearer_is_greater,
///         distance with nearer_is_less. In place of the order a DepthFormat: depths are then floats, and `depth`
///         keeps what the format says. A depth_policy may follow the rasters
template <class How, WritableRaster Screen, DepthRaster Depth, class References = no_references,
          DepthPolicy Policy = depth_policy<>>
  requires DepthKeeping<How, pixel_of<Depth>> && (std::same_as<References, no_references> || WritableRaster<References>)
class zbuffer {
  using kept = depth_kept<How, pixel_of<Depth>>;

public:
  using format = How;
  using order = typename kept::order;
  using stored_type = pixel_of<Depth>;
  using depth_type = std::conditional_t<DepthFormat<How>, float, stored_type>;
  using reference_type = typename detail::reference_of<References>::type;
  static constexpr bool has_references = !std::same_as<References, no_references>;
  using value_type = zbuffer_value<Screen, References>;

  IRG_INLINE constexpr zbuffer(How, Screen& screen, Depth& depth, Policy = {})
    requires(!has_references)
      : screen_(&screen), depth_(&depth) {}
  IRG_INLINE constexpr zbuffer(How, Screen& screen, Depth& depth, References& references, Policy = {})
    requires has_references
      : screen_(&screen), depth_(&depth), references_(&references) {}

  /// The pixels that all buffers have, and may be drawn.
  [[nodiscard]] IRG_INLINE constexpr cell_window window() const {
    const cell_window both = intersect(limit_, intersect(window_of(*screen_), window_of(*depth_)));
    if constexpr (has_references)
      return intersect(both, window_of(*references_));
    else
      return both;
  }

  /// The same buffers, of which nothing outside of a window is drawn.
  [[nodiscard]] IRG_INLINE constexpr zbuffer within(const cell_window& window) const noexcept {
    zbuffer part = *this;
    part.limit_ = intersect(limit_, window);
    return part;
  }

  /// Every pixel of the screen becomes the background, every depth that of the back plane: Zmin where nearer is
  /// greater. Without a back plane it is the farthest depth of the order or the format, as draw_depth clears to.
  IRG_APART constexpr void clear(const pixel_of<Screen>& background,
                                 const stored_type& back_plane = static_cast<stored_type>(kept::farthest)) const
    requires(!has_references)
  {
    irg::clear(*screen_, background);
    irg::clear(*depth_, back_plane);
  }
  IRG_APART constexpr void clear(const pixel_of<Screen>& background, const stored_type& back_plane,
                                 const reference_type& nothing) const
    requires has_references
  {
    irg::clear(*screen_, background);
    irg::clear(*depth_, back_plane);
    irg::clear(*references_, nothing);
  }

  /// Draws v at (x, y) if z passes the test, by default if it is nearer than the depth there, and says whether it did.
  /// v is a pixel or a function f(x, y, z) of one; with references it is an object_value.
  /// gives   false for pixels outside of the window and for NaN, by default for equal depths
  template <class V = value_type>
  IRG_INLINE constexpr bool set_pixel(int x, int y, const depth_type& z, const V& v) const {
    const cell_window w = window();
    if (x < w.x_first || x >= w.x_last || y < w.y_first || y >= w.y_last) return false;
    return set_pixel_within(x, y, z, v);
  }

  /// The same, unasked whether the pixel exists.
  /// needs   (x, y) in window()
  template <class V = value_type>
  IRG_INLINE constexpr bool set_pixel_within(int x, int y, const depth_type& z, const V& v) const {
    static_assert(detail::is_object_value<V> == has_references, "an object_value goes with a buffer of references");
    const stored_type stored = get_pixel(*depth_, x, y);
    const auto level = kept::level(z);
    if (!passes<Policy::test, order>(level, kept::level_of(stored))) return false;
    if constexpr (Policy::write == depth_write::on) irg::set_pixel(*depth_, x, y, kept::with_level(stored, level));
    if constexpr (has_references) {
      detail::put_value(*screen_, x, y, z, v.value);
      irg::set_pixel(*references_, x, y, static_cast<reference_type>(v.reference));
    } else {
      detail::put_value(*screen_, x, y, z, v);
    }
    return true;
  }

private:
  Screen* screen_;
  Depth* depth_;
  References* references_ = nullptr;
  static constexpr int most = (std::numeric_limits<int>::max)();
  cell_window limit_{-most, -most, most, most};
};

/// The buffers of a z-buffer. Models: zbuffer.
template <class B>
concept ZBuffer = requires(const B& buffers, const typename B::depth_type& z, const typename B::value_type& v) {
  { buffers.window() } -> std::convertible_to<cell_window>;
  { buffers.set_pixel_within(0, 0, z, v) } -> std::same_as<bool>;
};

/// How the depths of polygons are got, and where pixels take them.
template <Real T>
struct depth_sampling {
  depth_evaluation how = depth_evaluation::plane;
  picture_grid<T> grid{};
};

inline namespace IRG_ABI {

/// Draws a run of pixels, the depths taken from a walk, each by set_pixel. For coverage of any kind: every SpanSink can
/// call it.
/// gives   what lies outside of the buffers' window is left out
template <ZBuffer B, DepthWalk Walk, class V = typename B::value_type>
constexpr void zbuffer_span(const B& buffers, const span_of_cells& s, Walk& walk, const V& value) {
  const cell_window w = buffers.window();
  const int first = greater(s.x_first, w.x_first), last = lesser(s.x_last, w.x_last);
  if (s.y < w.y_first || s.y >= w.y_last || first >= last) return;
  walk.start(first, s.y);
  for (int x = first; x < last; ++x, walk.next())
    buffers.set_pixel_within(x, s.y, static_cast<typename B::depth_type>(walk.value()), value);
}

/// Draws a face of a picture: the pixels that it covers, with the depths that draw_triangle has there. Faces drawn in
/// the order of their numbers leave what render shows, but where two depths are too close to tell as floats.
/// gives   nothing for a face without area; depth_inverse_w keeps the corners' inverse_w
/// exact   coverage in integers; depths bit for bit those of draw_triangle and render
template <ZBuffer B, class V = typename B::value_type>
constexpr void zbuffer_face(const B& buffers, const screen_face& face, const V& value) {
  if (face.coverage.double_area == 0) return;
  using how = typename B::format;
  const triangle_setup setup = set_up_triangle(face.coverage, vertex_for<how>(face.v[0]), vertex_for<how>(face.v[1]),
                                               vertex_for<how>(face.v[2]));
  covered_spans(face.coverage, buffers.window(), [&](const span_of_cells& s) {
    for (int x = s.x_first; x < s.x_last; ++x)
      buffers.set_pixel_within(x, s.y, static_cast<typename B::depth_type>(depth_at(setup, x, s.y)), value);
  });
}

/// Draws a convex polygon in parallel projection: the pixels that fill_convex covers, with the depth of its plane.
/// shape   corners (x, y, z); x and y as on the picture plane, pixels unless the sampling's grid says otherwise
/// gives   false, and nothing drawn, when a coordinate is NaN, infinite or beyond 2^30; true and nothing drawn for
///         fewer than three corners, no area, and a polygon seen edge on (C = 0)
/// exact   coverage as fill_convex; depths within the bound of plane_depth, or depth_walk for `steps`, of the plane
///         through the corners, and never outside the range of the corners' depths
/// cost    one division and some products per pixel, or one addition (`steps`)
/// source  Hidden-surface slides; Fabris 2012, 2.2
template <ZBuffer B, SpaceRing R, class V = typename B::value_type>
  requires Floating<ring_scalar<R>>
constexpr bool zbuffer_polygon(const B& buffers, const R& ring, const V& value,
                               const depth_sampling<ring_scalar<R>>& sampling = {});

/// Draws a convex polygon as seen from (0, 0, d) on the picture plane z = 0: what zbuffer_polygon does with x' and y'.
/// The depth kept is z (`plane`) or 1/(d - z) (`steps`); clear the depth buffer to the same quantity of the back plane.
/// needs   nearer_is_greater with d > 0, nearer_is_less with d < 0
/// gives   false, and nothing drawn, when a coordinate or d is NaN, infinite or beyond 2^30, d is 0, or a corner is not
///         in front of the eye: clip first; true and nothing drawn as zbuffer_polygon, and when the plane holds the eye
/// exact   coverage: corners are projected in T, then as fill_convex; depths as there
template <ZBuffer B, SpaceRing R, class V = typename B::value_type>
  requires Floating<ring_scalar<R>>
constexpr bool zbuffer_polygon_perspective(const B& buffers, const R& ring, const ring_scalar<R>& d, const V& value,
                                           const depth_sampling<ring_scalar<R>>& sampling = {});

/// Fills in the screen from a buffer of object references: colour_of(reference) wherever a reference is not `nothing`.
/// For drawing references first and looking colours up once per pixel, at the end.
/// gives   pixels that one of the two rasters lacks are left alone
/// source  Hank n.d., 4.2.1.1
template <WritableRaster Screen, ReadableRaster References, class ColourOf>
  requires std::equality_comparable<pixel_of<References>> &&
           requires(const ColourOf& colour_of, const pixel_of<References>& r) {
             { colour_of(r) } -> std::convertible_to<pixel_of<Screen>>;
           }
constexpr void resolve_references(Screen& screen, const References& references, const pixel_of<References>& nothing,
                                  const ColourOf& colour_of) {
  const cell_window w = intersect(window_of(screen), window_of(references));
  for (int y = w.y_first; y < w.y_last; ++y)
    for (int x = w.x_first; x < w.x_last; ++x) {
      const pixel_of<References> r = get_pixel(references, x, y);
      if (!(r == nothing)) set_pixel(screen, x, y, static_cast<pixel_of<Screen>>(colour_of(r)));
    }
}

}  // namespace IRG_ABI
}  // namespace irg::textbook

namespace irg {
namespace detail {

// A polygon in space on its way into a z-buffer: its picture as a ring for fill_convex, and its rows.

// A polygon's corners on the picture plane, in pixels.
template <class R, class Project>
struct picture_ring {
  const R* ring;
  const Project* project;
};

}  // namespace detail

// How irg reads the picture of a polygon.
template <class R, class Project>
struct ring_traits<detail::picture_ring<R, Project>> {
  using point = irg::point<scalar_of<ring_point<R>>, 2>;
  IRG_INLINE static constexpr std::size_t size(const detail::picture_ring<R, Project>& r) noexcept {
    return ring_size(*r.ring);
  }
  IRG_INLINE static constexpr point vertex(const detail::picture_ring<R, Project>& r, std::size_t i) {
    return (*r.project)(ring_traits<R>::vertex(*r.ring, i));
  }
};

namespace detail {

// What keeps every depth of a polygon between its corners' depths.
template <class T>
struct depth_bounds {
  T low{}, high{};
};

inline namespace IRG_ABI {

inline constexpr double textbook_reach = 0x1p30;

// Whether every coordinate of every corner is a number within reach.
template <class R>
constexpr bool corners_within_reach(const R& ring) {
  using T = scalar_of<ring_point<R>>;
  constexpr T reach = static_cast<T>(textbook_reach);
  for (std::size_t i = 0; i < ring_size(ring); ++i)
    for (int k = 0; k < 3; ++k) {
      const T c = coordinate(ring_traits<R>::vertex(ring, i), k);
      if (!(-reach <= c && c <= reach)) return false;
    }
  return true;
}

// The greatest and least of f(vertex).
template <class T, class R, class F>
constexpr depth_bounds<T> bounds_over(const R& ring, const F& f) {
  depth_bounds<T> b;
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    const T v = f(ring_traits<R>::vertex(ring, i));
    b = i == 0 ? depth_bounds<T>{v, v} : depth_bounds<T>{lesser(b.low, v), greater(b.high, v)};
  }
  return b;
}

// The plane of a triangle by the determinant, of other polygons by Newell's sums.
template <class R>
constexpr auto polygon_plane(const R& ring) {
  if (ring_size(ring) != 3) return newell_plane(ring);
  return plane_through(ring_traits<R>::vertex(ring, 0), ring_traits<R>::vertex(ring, 1),
                       ring_traits<R>::vertex(ring, 2));
}

// v, kept within the bounds; the far bound where v is NaN.
template <class Order, class T>
IRG_INLINE constexpr T within_bounds(const T& v, const depth_bounds<T>& b) noexcept {
  if constexpr (Order::nearer(1.0f, 0.0f))
    return clamp(v, b.low, b.high);
  else
    return v < b.high ? (b.low < v ? v : b.low) : b.high;
}

template <class Buffers, class Walk, class T, class V>
constexpr void draw_row(const Buffers& buffers, const span_of_cells& s, Walk& walk, const depth_bounds<T>& b,
                        const V& value) {
  walk.start(s.x_first, s.y);
  for (int x = s.x_first; x < s.x_last; ++x, walk.next())
    buffers.set_pixel_within(
        x, s.y, static_cast<typename Buffers::depth_type>(within_bounds<typename Buffers::order>(walk.value(), b)),
        value);
}

template <class Buffers, class Picture, class Walk, class T, class V>
constexpr bool draw_polygon(const Buffers& buffers, const Picture& picture, Walk walk, const depth_bounds<T>& b,
                            const V& value) {
  return convex_spans(picture, buffers.window(), [&](const span_of_cells& s) { draw_row(buffers, s, walk, b, value); });
}

// A coordinate of the picture plane in pixels.
template <class T>
constexpr point<T, 2> on_grid(const picture_grid<T>& g, const T& x, const T& y) noexcept {
  const T half = T(1) / T(2);
  return {product(x, T(1) / g.per_column) + (half - g.x / g.per_column),
          product(y, T(1) / g.per_row) + (half - g.y / g.per_row)};
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg

namespace irg::textbook {
inline namespace IRG_ABI {

template <ZBuffer B, SpaceRing R, class V>
  requires Floating<ring_scalar<R>>
constexpr bool zbuffer_polygon(const B& buffers, const R& ring, const V& value,
                               const depth_sampling<ring_scalar<R>>& sampling) {
  using T = ring_scalar<R>;
  const auto& [how, grid] = sampling;
  if (!detail::corners_within_reach(ring)) return false;
  const auto p = detail::polygon_plane(ring);
  const auto steps = p ? plane_depth_steps(*p, grid) : std::nullopt;
  if (!steps) return true;
  const auto b = detail::bounds_over<T>(ring, [](const auto& v) { return coordinate(v, 2); });
  const auto project = [&](const auto& v) {
    return detail::on_grid(sampling.grid, coordinate(v, 0), coordinate(v, 1));
  };
  const detail::picture_ring<R, decltype(project)> picture{&ring, &project};
  return how == depth_evaluation::steps
             ? detail::draw_polygon(buffers, picture, depth_walk<T>(*steps), b, value)
             : detail::draw_polygon(buffers, picture, plane_walk<T>(*p, grid, b.low), b, value);
}

template <ZBuffer B, SpaceRing R, class V>
  requires Floating<ring_scalar<R>>
constexpr bool zbuffer_polygon_perspective(const B& buffers, const R& ring, const ring_scalar<R>& d, const V& value,
                                           const depth_sampling<ring_scalar<R>>& sampling) {
  using T = ring_scalar<R>;
  const auto& [how, grid] = sampling;
  constexpr T reach = static_cast<T>(detail::textbook_reach);
  if (!(T(0) < d ? d <= reach : d < T(0) && -reach <= d) || !detail::corners_within_reach(ring)) return false;
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    const T z = coordinate(ring_traits<R>::vertex(ring, i), 2);
    if (!(T(0) < d ? z < d : d < z)) return false;
  }
  const auto p = detail::polygon_plane(ring);
  const auto steps = p ? inverse_depth_steps(*p, d, grid) : std::nullopt;
  if (!steps) return true;
  const auto project = [&](const auto& v) {
    const T scale = d / (d - coordinate(v, 2));
    return detail::on_grid(sampling.grid, product(coordinate(v, 0), scale), product(coordinate(v, 1), scale));
  };
  const detail::picture_ring<R, decltype(project)> picture{&ring, &project};
  if (how == depth_evaluation::steps) {
    const auto b = detail::bounds_over<T>(ring, [&](const auto& v) { return T(1) / (d - coordinate(v, 2)); });
    return detail::draw_polygon(buffers, picture, depth_walk<T>(*steps), b, value);
  }
  const auto b = detail::bounds_over<T>(ring, [](const auto& v) { return coordinate(v, 2); });
  const T back = B::order::nearer(1.0f, 0.0f) ? b.low : b.high;
  return detail::draw_polygon(buffers, picture, plane_walk<T>(*p, d, grid, back), b, value);
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
