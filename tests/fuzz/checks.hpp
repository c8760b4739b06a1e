// SPDX-License-Identifier: MIT
// What fuzz targets require of readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <irg/core/result.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/mesh/validate.hpp>

namespace fuzz {

inline void require(bool fact) {
  if (!fact) std::abort();
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The place of an error is a byte of the text, or the end of it, and counted as a reader of the text would count it; in
/// binary files a byte.
inline void check_place(std::string_view text, const irg::parse_error& error) {
  require(std::strlen(error.message) > 10);
  if (error.line == 0) return require(error.column <= text.size() + 1);
  std::size_t line = 1, column = 1;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (std::size_t i = 0;; ++i) {
    if (line == error.line && column == error.column) return;
    require(i < text.size());
    const bool ends_line = text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
    line += ends_line;
    column = ends_line ? 1 : column + 1;
  }
}

/// Whether a mesh came out; it must be sound, and cut into triangles as sound.
template <class T>
bool check_mesh(std::string_view text, const irg::result<irg::mesh<T>>& read) {
  if (!read) {
    check_place(text, read.error());
    return false;
  }
  require(irg::validate(*read).defect == irg::mesh_defect::none);
  const irg::mesh<T> triangles = irg::triangulated(*read);
  require(irg::validate(triangles).defect == irg::mesh_defect::none);
  require(triangles.face_count() == read->corners.size() - 2 * read->face_count());
  require(triangles.positions == read->positions);
  require(triangles.parts.size() == read->parts.size());
  return true;
}

/// The bytes that an encoder gave, as a text.
template <class Encoded>
std::string_view bytes_of(const Encoded& encoded) {
  require(encoded.has_value());
  return {reinterpret_cast<const char*>(encoded->data()), encoded->size()};
}

}  // namespace fuzz
