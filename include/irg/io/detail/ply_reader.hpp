// SPDX-License-Identifier: MIT
// The body of a PLY file, element by element as the header lists them. One text reads both forms: a source gives the
// next number, from words or from bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <irg/core/conversion.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/io/detail/byte_cursor.hpp>
#include <irg/io/detail/ply_header.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// Numbers as words, one after another.
struct ply_text_source {
  text_cursor cursor;

  constexpr const char* next() noexcept {
    cursor.skip_space();
    return cursor.at;
  }
  template <Floating T>
  constexpr bool number(ply_type, T& into) noexcept {
    return cursor.number(into);
  }
  constexpr bool whole(ply_type, std::int64_t& into) noexcept { return cursor.integer(into); }
  constexpr bool skip(ply_type) noexcept {
    if (!cursor.skip_space()) return cursor.fail(cursor.at, "text ends where a number is expected");
    cursor.word();
    return true;
  }
  constexpr bool skip(ply_type type, std::uint64_t count) noexcept {
    for (std::uint64_t i = 0; i < count; ++i)
      if (!skip(type)) return false;
    return true;
  }
};

/// Numbers as bytes.
struct ply_byte_source {
  text_cursor cursor;
  byte_order order;

  constexpr const char* next() const noexcept { return cursor.at; }
  static constexpr std::size_t size(ply_type t) noexcept {
    constexpr std::uint8_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(t)];
  }
  constexpr bool has(std::uint64_t bytes) noexcept {
    return static_cast<std::uint64_t>(cursor.last - cursor.at) >= bytes ||
           cursor.fail(cursor.last, "file ends where a number is expected");
  }
  constexpr bool whole(ply_type t, std::int64_t& into) noexcept {
    if (!has(size(t))) return false;
    switch (t) {
      case ply_type::int8:
        into = static_cast<std::uint8_t>(ordered_bits<1>(cursor.at, order));
        if (into > 127) into -= 256;
        break;
      case ply_type::uint8: into = static_cast<std::uint8_t>(ordered_bits<1>(cursor.at, order)); break;
      case ply_type::int16: into = static_cast<std::int16_t>(ordered_bits<2>(cursor.at, order)); break;
      case ply_type::uint16: into = static_cast<std::uint16_t>(ordered_bits<2>(cursor.at, order)); break;
      case ply_type::int32: into = static_cast<std::int32_t>(ordered_bits<4>(cursor.at, order)); break;
      default: into = static_cast<std::uint32_t>(ordered_bits<4>(cursor.at, order)); break;
    }
    cursor.at += size(t);
    return true;
  }
  template <Floating T>
  constexpr bool number(ply_type t, T& into) noexcept {
    if (!has(size(t))) return false;
    const char* const start = cursor.at;
    if (is_whole(t)) {
      std::int64_t n = 0;
      whole(t, n);
      into = converted<T>(static_cast<double>(n));
      return true;
    }
    cursor.at += size(t);
    const double x = t == ply_type::float32 ? converted<double>(load_float(start, order)) : load_double(start, order);
    if (!is_finite(x)) return cursor.fail(start, "number is not finite");
    if constexpr (sizeof(T) == 4)  // half a unit beyond the largest float
      if (!(x > -0x1.ffffffp127 && x < 0x1.ffffffp127)) return cursor.fail(start, "number is too large");
    into = converted<T>(x);
    return true;
  }
  constexpr bool skip(ply_type t) noexcept { return skip(t, 1); }
  constexpr bool skip(ply_type t, std::uint64_t count) noexcept {
    if (!has(count * size(t))) return false;  // lists are shorter than 2^32
    cursor.at += count * size(t);
    return true;
  }
};

/// Reads the body from `source`, or stops with its message.
template <Floating T, class Source, class Element>
struct ply_body_reader {
  Source source;
  const ply_header<Element>& header;
  mesh<T> read{};
  std::uint64_t vertex_count = 0;

  constexpr bool body() {
    for (const Element& e : header.elements)
      if (e.kind == ply_kind::vertex) vertex_count = e.count;
    for (const Element& e : header.elements) {
      if (e.properties.empty()) continue;  // nothing stands in the file, however many there are
      const bool good = e.kind == ply_kind::vertex ? vertices(e) : e.kind == ply_kind::face ? faces(e) : others(e);
      if (!good) return false;
    }
    if (source.next() != source.cursor.last)
      return source.cursor.fail(source.next(), "file goes on after the last element");
    return true;
  }

  constexpr bool skip(const ply_property& p) noexcept {
    if (p.count == ply_type::none) return source.skip(p.type);
    std::int64_t count = 0;
    return length(p, count) && source.skip(p.type, static_cast<std::uint64_t>(count));
  }

  constexpr bool length(const ply_property& p, std::int64_t& count) noexcept {
    const char* const start = source.next();
    if (!source.whole(p.count, count)) return false;
    if (count < 0) return source.cursor.fail(start, "length of a list is negative");
    return count <= 0xffffffff || source.cursor.fail(start, "list is longer than the file");
  }

  constexpr bool others(const Element& e) noexcept {
    for (std::uint64_t i = 0; i < e.count; ++i)
      for (const ply_property& p : e.properties)
        if (!skip(p)) return false;
    return true;
  }

  constexpr bool vertices(const Element& e) {
    const bool normals = e.has(ply_role::nx, ply_role::nz), texcoords = e.has(ply_role::s, ply_role::t);
    for (std::uint64_t i = 0; i < e.count; ++i) {
      std::array<T, ply_numbers> n{};
      for (const ply_property& p : e.properties) {
        const auto place = static_cast<std::size_t>(p.role);
        if (!(place < ply_numbers ? source.number(p.type, n[place]) : skip(p))) return false;
      }
      read.positions.push_back({n[0], n[1], n[2]});
      if (normals) read.normals.push_back({n[3], n[4], n[5]});
      if (texcoords) read.texcoords.push_back({n[6], n[7]});
    }
    return true;
  }

  constexpr bool faces(const Element& e) {
    for (std::uint64_t i = 0; i < e.count; ++i)
      for (const ply_property& p : e.properties)
        if (!(p.role == ply_role::indices ? face(p) : skip(p))) return false;
    return true;
  }

  constexpr bool face(const ply_property& p) {
    const char* const start = source.next();
    std::int64_t count = 0;
    if (!length(p, count)) return false;
    if (count < 3) return source.cursor.fail(start, "face has fewer than three corners");
    for (std::int64_t k = 0; k < count; ++k) {
      const char* const place = source.next();
      std::int64_t index = 0;
      if (!source.whole(p.type, index)) return false;
      if (index < 0) return source.cursor.fail(place, "index of a vertex is negative");
      if (static_cast<std::uint64_t>(index) >= vertex_count)
        return source.cursor.fail(place, "face index is not smaller than the number of vertices");
      read.corners.push_back({static_cast<std::uint32_t>(index), mesh_corner::none, mesh_corner::none});
    }
    read.face_starts.push_back(static_cast<std::uint32_t>(read.corners.size()));
    return true;
  }

  /// Vertices have one normal and one texture coordinate each.
  constexpr void name_attributes() noexcept {
    for (mesh_corner& c : read.corners) {
      if (!read.normals.empty()) c.normal = c.position;
      if (!read.texcoords.empty()) c.texcoord = c.position;
    }
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
