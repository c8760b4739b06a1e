// SPDX-License-Identifier: MIT
// Archetypes: the poorest types that meet each concept. They have what the concept asks and nothing more, so an
// algorithm that accepts them asks for no more than its concept says. Everything implicit is left out on purpose.
#pragma once

#include <cstddef>

#include <irg/core/mesh_concept.hpp>
#include <irg/core/plane_concept.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/core/ring.hpp>
#include <irg/core/sinks.hpp>
#include <irg/spatial/grid_concept.hpp>

namespace archetype {

/// A number with the operations of Scalar alone: no +=, no >, no conversion to or from built-in types but the explicit
/// one from int. Its value can be read by the tests through value().
class scalar {
public:
  constexpr scalar() = default;
  constexpr explicit scalar(int value) : value_(value) {}
  constexpr long value() const { return value_; }
  friend constexpr bool operator==(const scalar&, const scalar&) = default;
  friend constexpr bool operator<(const scalar& a, const scalar& b) { return a.value_ < b.value_; }
  friend constexpr scalar operator+(const scalar& a, const scalar& b) { return raw(a.value_ + b.value_); }
  friend constexpr scalar operator-(const scalar& a, const scalar& b) { return raw(a.value_ - b.value_); }
  friend constexpr scalar operator*(const scalar& a, const scalar& b) { return raw(a.value_ * b.value_); }
  friend constexpr scalar operator/(const scalar& a, const scalar& b) { return raw(a.value_ / b.value_); }
  friend constexpr scalar operator-(const scalar& a) { return raw(-a.value_); }

private:
  static constexpr scalar raw(long value) {
    scalar s;
    s.value_ = value;
    return s;
  }
  long value_ = 0;
};

/// N coordinates behind names that irg cannot guess: no default constructor, no assignment, no ==, no operators.
template <class T, int N, irg::coordinate_kind Kind>
class coordinates {
public:
  coordinates() = delete;
  coordinates& operator=(const coordinates&) = delete;
  constexpr coordinates(const coordinates&) = default;

  template <class... S>
  static constexpr coordinates of(const S&... c) {
    return coordinates(tag{}, c...);
  }
  constexpr const T& nth(int i) const { return hidden_[i]; }

private:
  struct tag {};
  template <class... S>
  constexpr explicit coordinates(tag, const S&... c) : hidden_{c...} {}
  T hidden_[static_cast<std::size_t>(N)];
};

template <class T, int N>
using vector = coordinates<T, N, irg::coordinate_kind::vector>;
template <class T, int N>
using point = coordinates<T, N, irg::coordinate_kind::point>;
template <class T, int N>
using homogeneous_point = coordinates<T, N, irg::coordinate_kind::homogeneous>;

/// Coordinates that may be a vector or a point, as most foreign types'.
template <class T, int N>
using any_kind = coordinates<T, N, irg::coordinate_kind::any>;

/// Points and vectors that are made without a value and assigned, too: for algorithms that keep rows of them.
template <class T, int N, irg::coordinate_kind Kind>
class kept_coordinates {
public:
  constexpr kept_coordinates() = default;
  template <class... S>
  static constexpr kept_coordinates of(const S&... c) {
    kept_coordinates made;
    int i = 0;
    ((made.hidden_[i++] = c), ...);
    return made;
  }
  constexpr const T& nth(int i) const { return hidden_[i]; }

private:
  T hidden_[static_cast<std::size_t>(N)]{};
};
template <class T, int N>
using kept_vector = kept_coordinates<T, N, irg::coordinate_kind::vector>;
template <class T, int N>
using kept_point = kept_coordinates<T, N, irg::coordinate_kind::point>;
template <class T, int N>
using kept_homogeneous_point = kept_coordinates<T, N, irg::coordinate_kind::homogeneous>;

/// A plane of which only the coefficients can be read.
template <class T>
class plane {
public:
  constexpr plane(T a, T b, T c, T d) : hidden_{a, b, c, d} {}
  plane& operator=(const plane&) = delete;
  constexpr plane(const plane&) = delete;
  constexpr T nth(int i) const { return hidden_[i]; }

private:
  T hidden_[4];
};

/// A ring of N points that can neither be copied nor iterated; its size is no std::size_t.
template <class P, int N>
class ring {
public:
  template <class... Q>
  constexpr explicit ring(const Q&... points) : hidden_{points...} {}
  ring(const ring&) = delete;
  ring& operator=(const ring&) = delete;
  constexpr int how_many() const { return N; }
  constexpr const P& nth(std::size_t i) const { return hidden_[i]; }

private:
  P hidden_[static_cast<std::size_t>(N)];
};

/// Two rings that can neither be copied nor iterated; their number is no std::size_t.
template <class P, int N>
class rings {
public:
  rings(const rings&) = delete;
  rings& operator=(const rings&) = delete;
  constexpr short size() const { return 2; }
  constexpr const ring<P, N>& operator[](std::size_t i) const { return hidden_[i]; }

private:
  ring<P, N> hidden_[2];
};

/// A tetrahedron that can only be asked what mesh_traits asks; it cannot be copied.
template <class P>
class mesh {
public:
  constexpr mesh(const P& a, const P& b, const P& c, const P& d) : hidden_{a, b, c, d} {}
  mesh(const mesh&) = delete;
  mesh& operator=(const mesh&) = delete;
  constexpr const P& nth(std::size_t v) const { return hidden_[v]; }
  static constexpr unsigned char faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

private:
  P hidden_[4];
};

/// A pixel that can be copied, and nothing else.
struct pixel {
  unsigned char tint;
};

/// A raster that is computed when read; it cannot be copied.
class readable_raster {
public:
  readable_raster() = default;
  readable_raster(const readable_raster&) = delete;
  readable_raster& operator=(const readable_raster&) = delete;
  static constexpr short columns = 8, rows = 6;
  constexpr pixel peek(int x, int y) const { return {static_cast<unsigned char>(10 * y + x)}; }
};

/// A raster of P's that can be written pixel by pixel only.
template <class P>
class writable_raster {
public:
  writable_raster() = default;
  writable_raster(const writable_raster&) = delete;
  writable_raster& operator=(const writable_raster&) = delete;
  static constexpr short columns = 8, rows = 6;
  constexpr P peek(int x, int y) const { return hidden_[y][x]; }
  constexpr void poke(int x, int y, const P& p) { hidden_[y][x] = p; }

protected:
  P hidden_[static_cast<std::size_t>(rows)][static_cast<std::size_t>(columns)]{};
};

/// A writable raster that gives its rows away too.
template <class P>
class row_raster : public writable_raster<P> {
public:
  constexpr P* line(int y) { return this->hidden_[y]; }
};

/// A row raster whose rows are the same distance apart.
template <class P>
class even_row_raster : public row_raster<P> {};

/// A raster of depths: a number per pixel.
using depth_raster = writable_raster<float>;

/// Sinks that take exactly their argument, cannot be copied, and count their calls. Their result is of no use.
template <class... Arguments>
class sink {
public:
  struct useless {};
  sink() = default;
  sink(const sink&) = delete;
  sink& operator=(const sink&) = delete;
  constexpr useless operator()(const Arguments&...) {
    ++calls;
    return {};
  }
  // Anything else, converted or not, is refused.
  template <class... Other>
  void operator()(const Other&...) = delete;
  int calls = 0;
};
using cell_sink = sink<irg::cell>;
using span_sink = sink<irg::span_of_cells>;
template <class P>
using segment_sink = sink<P, P>;

/// A grid of cells with walls that can only be asked what grid_traits asks; it cannot be copied.
class grid {
public:
  grid() = default;
  grid(const grid&) = delete;
  grid& operator=(const grid&) = delete;
  static constexpr irg::grid_extent how_large() { return {4, 3, 2}; }
  static constexpr bool stands(const irg::cell3& c, int axis) { return (c.x + c.y + c.z + axis) % 5 == 0; }
};

/// Predicates that take exactly their argument and cannot be copied.
template <class Argument>
class predicate {
public:
  predicate() = default;
  predicate(const predicate&) = delete;
  predicate& operator=(const predicate&) = delete;
  constexpr bool operator()(const Argument&) { return true; }
  template <class... Other>
  bool operator()(const Other&...) = delete;
};

/// A callable that takes anything and gives nothing of use, and one that gives a value whatever it is asked.
class takes_all {
public:
  struct useless {};
  template <class... Arguments>
  constexpr useless operator()(const Arguments&...) const {
    return {};
  }
};
template <class Value>
class gives {
public:
  template <class... Arguments>
  constexpr Value operator()(const Arguments&...) const {
    return Value();
  }
};

}  // namespace archetype

template <class T, int N, irg::coordinate_kind Kind>
struct irg::coordinate_traits<archetype::coordinates<T, N, Kind>> {
  using scalar = T;
  static constexpr int size = N;
  static constexpr auto kind = Kind;
  static constexpr const T& get(const archetype::coordinates<T, N, Kind>& v, int i) { return v.nth(i); }
  template <class... S>
    requires(sizeof...(S) == N)
  static constexpr archetype::coordinates<T, N, Kind> make(const S&... c) {
    return archetype::coordinates<T, N, Kind>::of(c...);
  }
};

template <class T, int N, irg::coordinate_kind Kind>
struct irg::coordinate_traits<archetype::kept_coordinates<T, N, Kind>> {
  using scalar = T;
  static constexpr int size = N;
  static constexpr auto kind = Kind;
  static constexpr const T& get(const archetype::kept_coordinates<T, N, Kind>& v, int i) { return v.nth(i); }
  template <class... S>
    requires(sizeof...(S) == N)
  static constexpr archetype::kept_coordinates<T, N, Kind> make(const S&... c) {
    return archetype::kept_coordinates<T, N, Kind>::of(c...);
  }
};

template <class T>
struct irg::plane_traits<archetype::plane<T>> {
  using scalar = T;
  static constexpr T coefficient(const archetype::plane<T>& p, int i) { return p.nth(i); }
};

template <class P, int N>
struct irg::ring_traits<archetype::ring<P, N>> {
  using point = P;
  static constexpr int size(const archetype::ring<P, N>& r) { return r.how_many(); }
  static constexpr const P& vertex(const archetype::ring<P, N>& r, std::size_t i) { return r.nth(i); }
};

template <class P>
struct irg::mesh_traits<archetype::mesh<P>> {
  using point = P;
  static constexpr short vertex_count(const archetype::mesh<P>&) { return 4; }
  static constexpr const P& position(const archetype::mesh<P>& m, std::size_t v) { return m.nth(v); }
  static constexpr int face_count(const archetype::mesh<P>&) { return 4; }
  static constexpr unsigned face_size(const archetype::mesh<P>&, std::size_t) { return 3; }
  static constexpr unsigned char face_vertex(const archetype::mesh<P>& m, std::size_t f, std::size_t k) {
    return m.faces[f][k];
  }
};

template <>
struct irg::raster_traits<archetype::readable_raster> {
  using pixel = archetype::pixel;
  static constexpr short width(const archetype::readable_raster& r) { return r.columns; }
  static constexpr short height(const archetype::readable_raster& r) { return r.rows; }
  static constexpr pixel get(const archetype::readable_raster& r, int x, int y) { return r.peek(x, y); }
};

template <class P>
struct irg::raster_traits<archetype::writable_raster<P>> {
  using pixel = P;
  static constexpr short width(const archetype::writable_raster<P>& r) { return r.columns; }
  static constexpr short height(const archetype::writable_raster<P>& r) { return r.rows; }
  static constexpr P get(const archetype::writable_raster<P>& r, int x, int y) { return r.peek(x, y); }
  static constexpr void set(archetype::writable_raster<P>& r, int x, int y, const P& p) { r.poke(x, y, p); }
};

template <class P>
struct irg::raster_traits<archetype::row_raster<P>> : irg::raster_traits<archetype::writable_raster<P>> {
  static constexpr P* row(archetype::row_raster<P>& r, int y) { return r.line(y); }
};

template <class P>
struct irg::raster_traits<archetype::even_row_raster<P>> : irg::raster_traits<archetype::row_raster<P>> {
  static constexpr std::ptrdiff_t bytes_per_row(const archetype::even_row_raster<P>& r) {
    return r.columns * static_cast<std::ptrdiff_t>(sizeof(P));
  }
};

template <>
struct irg::grid_traits<archetype::grid> {
  static constexpr irg::grid_extent extent(const archetype::grid& g) { return g.how_large(); }
  static constexpr bool is_full(const archetype::grid& g, const irg::cell3& c) { return g.stands(c, 3); }
  static constexpr bool has_wall(const archetype::grid& g, const irg::cell3& c, int axis) { return g.stands(c, axis); }
};
