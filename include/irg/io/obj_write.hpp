// SPDX-License-Identifier: MIT
// mesh<T> to Wavefront OBJ text, with its normals, texture coordinates and the names of its parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/obj_write_steps.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/mesh_options.hpp>

namespace irg {

inline namespace IRG_ABI {

/// The bytes of an OBJ text that describes the mesh.
/// gives   an error when the mesh does not pass validate()
/// exact   read_obj<T> of the bytes gives the same mesh again: every position, normal and texture coordinate, used or
///         not, every face and every part, if all parts have faces, neighbouring ones differ in a name, a single part
///         has one, and names have no line breaks and bytes 0 (which become blanks) and no blanks at their ends
/// cost    linear
/// source  Wavefront
template <Floating T>
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_obj(const mesh<T>& m) {
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

}  // namespace IRG_ABI
}  // namespace irg
