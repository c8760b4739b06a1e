// SPDX-License-Identifier: MIT
// Polygon rings: closed chains of points, the last joined to the first without being repeated. The one customisation
// point is ring_traits<T>; it fits every container with size() and operator[] (std::vector, std::array, std::span) and
// plain arrays. And fill_rule: what counts as the inside of rings that cross themselves or each other.
#pragma once

#include <cstddef>

#include <irg/core/coordinates.hpp>

namespace irg {

namespace detail {

// Braces refuse what would be narrowed: views count by signed numbers, some containers by ints.
template <class R, class Index>
concept counted_by = requires(const R& r, const Index i) { r[{i}]; };

/// i, of the type that r's own indices have.
template <class R>
IRG_INLINE constexpr auto own_index(std::size_t i) noexcept {
  constexpr bool as_it_is = counted_by<R, std::size_t>;
  if constexpr (!as_it_is && counted_by<R, std::ptrdiff_t>)
    return static_cast<std::ptrdiff_t>(i);
  else if constexpr (!as_it_is && counted_by<R, int>)
    return static_cast<int>(i);
  else
    return i;
}

}  // namespace detail

/// How irg reads a ring. Members: point (a Point or HomogeneousPoint), size(r), vertex(r, i).
template <class T>
struct ring_traits {};

template <class T>
  requires requires(const T& r, std::size_t i) {
    { r.size() } -> std::convertible_to<std::size_t>;
    requires Coordinates<std::remove_cvref_t<decltype(r[detail::own_index<T>(i)])>>;
  }
struct ring_traits<T> {
  using point = std::remove_cvref_t<decltype(std::declval<const T&>()[detail::own_index<T>(0)])>;
  IRG_INLINE static constexpr std::size_t size(const T& r) noexcept { return static_cast<std::size_t>(r.size()); }
  IRG_INLINE static constexpr point vertex(const T& r,
                                           std::size_t i) noexcept(noexcept(point(r[detail::own_index<T>(i)]))) {
    return r[detail::own_index<T>(i)];
  }
};

template <Coordinates P, std::size_t N>
struct ring_traits<P[N]> {
  using point = P;
  IRG_INLINE static constexpr std::size_t size(const P (&)[N]) noexcept { return N; }
  IRG_INLINE static constexpr const P& vertex(const P (&r)[N], std::size_t i) noexcept { return r[i]; }
};

/// A closed chain of points. Models: std::vector<point<T, 2>>, std::span<const glm::vec2>, a plain array.
template <class T>
concept PolygonRing = requires(const T& r, std::size_t i) {
  requires Point<typename ring_traits<T>::point> || HomogeneousPoint<typename ring_traits<T>::point>;
  { ring_traits<T>::size(r) } -> std::convertible_to<std::size_t>;
  { ring_traits<T>::vertex(r, i) } -> std::convertible_to<typename ring_traits<T>::point>;
};

/// The type of a ring's vertices.
template <PolygonRing T>
using ring_point = typename ring_traits<T>::point;

/// The number type of a ring's vertices.
template <PolygonRing T>
using ring_scalar = scalar_of<ring_point<T>>;

/// A ring of points with N coordinates.
template <class R, int N>
concept RingOf = PolygonRing<R> && Point<ring_point<R>> && (size_of<ring_point<R>> == N);

/// A ring of points of the plane, and one of points in space.
template <class R>
concept PlaneRing = RingOf<R, 2>;
template <class R>
concept SpaceRing = RingOf<R, 3>;

/// Any number of rings, in a container with size() and [] or a plain array.
template <class R>
concept RingSequence = requires(const R& rings, std::size_t i) {
  requires PolygonRing<std::remove_cvref_t<decltype(rings[i])>>;
  requires std::is_array_v<R> || requires {
    { rings.size() } -> std::convertible_to<std::size_t>;
  };
};

/// The type of the rings in a sequence.
template <RingSequence R>
using ring_in = std::remove_cvref_t<decltype(std::declval<const R&>()[0])>;

/// The inside of a set of rings, told by the winding number of a point: how often the rings run round it.
enum class fill_rule {
  even_odd,  // the winding number is odd; a ring inside another is a hole whichever way it runs
  non_zero,  // the winding number is not 0; a hole must run the other way than the ring around it
};

inline namespace IRG_ABI {

/// The number of vertices of a ring; 0, 1 and 2 are legal sizes of a degenerate one.
template <PolygonRing R>
[[nodiscard]] IRG_INLINE constexpr std::size_t ring_size(const R& r) noexcept(noexcept(ring_traits<R>::size(r))) {
  return static_cast<std::size_t>(ring_traits<R>::size(r));
}

/// Vertex i of a ring, counted round and round: vertex size is vertex 0 again.
/// needs   a ring that is not empty
template <PolygonRing R>
[[nodiscard]] IRG_INLINE constexpr ring_point<R> ring_vertex(const R& r, std::size_t i) noexcept(
    noexcept(ring_traits<R>::vertex(r, i))) {
  const std::size_t n = ring_size(r);
  return ring_traits<R>::vertex(r, i < n ? i : i % n);
}

}  // namespace IRG_ABI
}  // namespace irg
