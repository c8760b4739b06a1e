// SPDX-License-Identifier: MIT
// A BSP tree in bytes and back, so that a scene's tree is built once for all runs of a program. Works on memory only.
//
// "irgbsp1" and the size of a coordinate (4 or 8), each number little endian: the five lengths in 32 bits, then the
// vertices (3 coordinates), triangles (3 indices), nodes (source, axis, first, last, front, back, beside), pieces
// (triangle, limits) and limits (node, side, next).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/byte_cursor.hpp>
#include <irg/spatial/bsp_data_3d.hpp>

namespace irg {
namespace detail {

inline constexpr std::string_view bsp_mark = "irgbsp1";
inline constexpr std::size_t bsp_header = 8 + 5 * 4, bsp_words[4] = {3, 7, 2, 3};

inline namespace IRG_ABI {

constexpr const char* sentence_of(const bsp_fault& f) noexcept {
  if (f.defect == bsp_defect::index) return "number beyond what it counts";
  if (f.defect == bsp_defect::flat) return "triangle without area, or a coordinate that is not finite";
  return "these numbers are no tree";
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The bytes of a tree's data.
/// cost    linear
template <Floating T>
[[nodiscard]] constexpr std::vector<std::uint8_t> encode_bsp(const bsp_data_3d<T>& d) {
  constexpr auto little = detail::byte_order::little;
  std::vector<std::uint8_t> out;
  for (const char c : detail::bsp_mark) out.push_back(static_cast<std::uint8_t>(c));
  out.push_back(static_cast<std::uint8_t>(sizeof(T)));
  const auto put = [&](auto... words) {
    (detail::append_bytes<4>(out, static_cast<std::uint32_t>(words), little), ...);
  };
  put(d.vertices.size(), d.triangles.size(), d.nodes.size(), d.pieces.size(), d.limits.size());
  for (const point<T, 3>& p : d.vertices)
    for (int k = 0; k < 3; ++k) detail::append_bytes(out, p[k], little);
  for (const auto& [v] : d.triangles) put(v[0], v[1], v[2]);
  for (const bsp_node_3d& n : d.nodes) put(n.plane.source, n.plane.axis, n.first, n.last, n.front, n.back, n.beside);
  for (const bsp_piece_3d& p : d.pieces) put(p.triangle, p.limits);
  for (const bsp_limit_3d& l : d.limits) put(l.node, l.side, l.next);
  return out;
}

/// The data that bytes hold, checked by find_bsp_fault: a tree can be made of it.
/// needs   bytes written for the same T
/// gives   for anything else an error with line 0 and the byte, in place of half a tree
/// exact   every number as it was written
/// cost    linear; memory twice the bytes at most
template <Floating T>
[[nodiscard]] constexpr result<bsp_data_3d<T>> read_bsp(std::string_view bytes) {
  const auto wrong = [](std::size_t byte, const char* why) { return parse_error{0, byte + 1, why}; };
  if (bytes.substr(0, detail::bsp_mark.size()) != detail::bsp_mark) return wrong(0, "this is no BSP tree");
  if (bytes.size() < detail::bsp_header) return wrong(bytes.size(), "the bytes end within the lengths");
  if (bytes[7] != static_cast<char>(sizeof(T))) return wrong(7, "coordinates of another size");
  const auto word = [&](std::size_t at) {
    return static_cast<std::uint32_t>(detail::ordered_bits<4>(bytes.data() + at, detail::byte_order::little));
  };
  std::size_t length[5], start[6] = {detail::bsp_header};
  for (std::size_t i = 0; i < 5; ++i) {
    length[i] = word(8 + 4 * i);
    const std::size_t size = i == 0 ? 3 * sizeof(T) : 4 * detail::bsp_words[i - 1];
    if (length[i] > (bytes.size() - start[i]) / size) return wrong(8 + 4 * i, "more than the bytes hold");
    start[i + 1] = start[i] + length[i] * size;
  }
  if (start[5] != bytes.size()) return wrong(start[5], "bytes are left over");
  bsp_data_3d<T> d;
  d.vertices.reserve(length[0]);
  for (std::size_t i = 0, at = start[0]; i < length[0]; ++i, at += 3 * sizeof(T)) {
    point<T, 3> p;
    for (int k = 0; k < 3; ++k) {
      const char* number = bytes.data() + at + static_cast<std::size_t>(k) * sizeof(T);
      if constexpr (sizeof(T) == 4)
        p[k] = detail::load_float(number, detail::byte_order::little);
      else
        p[k] = detail::load_double(number, detail::byte_order::little);
    }
    d.vertices.push_back(p);
  }
  std::size_t at = start[1];
  const auto next = [&] { return word((at += 4) - 4); };
  // Lists in braces are evaluated from left to right.
  d.triangles.reserve(length[1]);
  for (std::size_t i = 0; i < length[1]; ++i) d.triangles.push_back(triangle_indices{{next(), next(), next()}});
  d.nodes.reserve(length[2]);
  for (std::size_t i = 0; i < length[2]; ++i)
    d.nodes.push_back(bsp_node_3d{{next(), next()}, next(), next(), next(), next(), next()});
  d.pieces.reserve(length[3]);
  for (std::size_t i = 0; i < length[3]; ++i) d.pieces.push_back(bsp_piece_3d{next(), next()});
  d.limits.reserve(length[4]);
  for (std::size_t i = 0; i < length[4]; ++i)
    d.limits.push_back(bsp_limit_3d{next(), static_cast<std::int32_t>(next()), next()});
  if (const bsp_fault f = find_bsp_fault(d); f.defect != bsp_defect::none) {
    const auto part = static_cast<std::size_t>(f.part);
    return wrong(start[part + 1] + f.place * 4 * detail::bsp_words[part], detail::sentence_of(f));
  }
  return d;
}

}  // namespace IRG_ABI
}  // namespace irg
