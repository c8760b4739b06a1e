// SPDX-License-Identifier: MIT
// What writers of meshes share: the encodings, and the meshes that they refuse.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <irg/core/result.hpp>
#include <irg/io/picture_limits.hpp>
#if IRG_BODIES
#include <irg/mesh/validate.hpp>
#endif

namespace irg {

/// How a mesh's numbers stand in a file: as decimal text, or as bytes with the lowest or the highest first.
enum class mesh_encoding { text, little_endian, big_endian };

/// What to do with statements of OBJ that the mesh has no place for: points, lines, curves, smoothing groups and the
/// like.
enum class obj_unused { skip, refuse };

/// Files of more bytes are not read: 4 GiB, so that 32 bits count the corners of every mesh.
inline constexpr std::uint64_t max_mesh_file_bytes = 0xffffffffu;

#if IRG_BODIES
namespace detail::inline IRG_ABI {

/// The error for a file of more than max_mesh_file_bytes.
constexpr std::optional<parse_error> refuse_long_file(std::string_view bytes) noexcept {
  if (static_cast<std::uint64_t>(bytes.size()) <= max_mesh_file_bytes) return std::nullopt;
  return parse_error{0, 0, "file is longer than 4 GiB"};
}

/// The reason why a mesh is not written, if there is one.
template <Scalar T>
constexpr std::optional<encode_error> refuse_mesh(const mesh<T>& m) noexcept {
  switch (validate(m).defect) {
    case mesh_defect::none: return std::nullopt;
    case mesh_defect::bad_face_start: return encode_error{"mesh's faces do not follow each other"};
    case mesh_defect::short_face: return encode_error{"mesh has a face of fewer than three corners"};
    case mesh_defect::position_out_of_range: return encode_error{"mesh has a corner without a position"};
    case mesh_defect::normal_out_of_range: return encode_error{"mesh has a corner whose normal does not exist"};
    case mesh_defect::texcoord_out_of_range:
      return encode_error{"mesh has a corner whose texture coordinate does not exist"};
    case mesh_defect::position_not_finite: return encode_error{"mesh has a position that is not finite"};
    case mesh_defect::normal_not_finite: return encode_error{"mesh has a normal that is not finite"};
    case mesh_defect::texcoord_not_finite: return encode_error{"mesh has a texture coordinate that is not finite"};
    case mesh_defect::parts_do_not_cover_faces: break;
  }
  return encode_error{"mesh's parts do not cover its faces in order"};
}

}  // namespace detail::inline IRG_ABI
#endif
}  // namespace irg
