// SPDX-License-Identifier: MIT
// mesh<T> to Wavefront OBJ text, with its normals, texture coordinates and the names of its parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/mesh_options.hpp>
#if IRG_BODIES
#include <irg/io/detail/text_writer.hpp>
#endif

namespace irg::inline IRG_COMPILED_ABI {

/// The bytes of an OBJ text that describes the mesh.
/// gives   an error when the mesh does not pass validate()
/// exact   read_obj<T> of the bytes gives the same mesh again: every position, normal and texture coordinate, used or
///         not, every face and every part, if all parts have faces, neighbouring ones differ in a name, a single part
///         has one, and names have no line breaks and bytes 0 (which become blanks) and no blanks at their ends
/// cost    linear
/// source  Wavefront
template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_obj(const mesh<T>& m);

}  // namespace irg::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

/// Writes a statement that names what follows. A blank behind a backslash keeps it from swallowing the next line.
template <class Bytes>
constexpr void write_obj_name(Bytes& out, std::string_view word, const part_name& name) {
  append_text(out, word);
  if (!name.empty()) append_text(out, " ");
  append_line_of(out, name);
  append_text(out, !name.empty() && name.data()[name.size() - 1] == '\\' ? " \n" : "\n");
}

/// Writes i, i/t, i//n or i/t/n, counted from 1.
template <class Bytes>
constexpr void write_obj_corner(Bytes& out, const mesh_corner& c) {
  const auto put = [&](std::uint32_t index) { append_number(out, std::uint64_t{index} + 1); };
  append_text(out, " ");
  put(c.position);
  if (c.texcoord != no_index || c.normal != no_index) append_text(out, "/");
  if (c.texcoord != no_index) put(c.texcoord);
  if (c.normal == no_index) return;
  append_text(out, "/");
  put(c.normal);
}

template <int Count, class Bytes, class Vectors>
constexpr void write_obj_vectors(Bytes& out, std::string_view word, const Vectors& vectors) {
  for (const auto& v : vectors) {
    append_text(out, word);
    append_numbers(out, v, Count);
    append_text(out, "\n");
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_obj(const mesh<T>& m) {
  if (const auto refused = detail::refuse_mesh(m)) return *refused;
  std::vector<std::uint8_t> out;
  detail::write_obj_vectors<3>(out, "v", m.positions);
  detail::write_obj_vectors<2>(out, "vt", m.texcoords);
  detail::write_obj_vectors<3>(out, "vn", m.normals);
  std::size_t part = 0;
  const mesh_part none;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    for (; part < m.parts.size() && m.parts[part].first_face == f; ++part) {
      const mesh_part &before = part == 0 ? none : m.parts[part - 1], &now = m.parts[part];
      if (now.object != before.object) detail::write_obj_name(out, "o", now.object);
      if (now.group != before.group) detail::write_obj_name(out, "g", now.group);
      if (now.material != before.material) detail::write_obj_name(out, "usemtl", now.material);
    }
    detail::append_text(out, "f");
    for (std::size_t k = 0; k < m.face_size(f); ++k) detail::write_obj_corner(out, m.corner(f, k));
    detail::append_text(out, "\n");
  }
  return out;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
