// SPDX-License-Identifier: MIT
// Wavefront OBJ text to mesh<T>. Reads memory only: no file that the text names (mtllib, call) is ever opened. What is
// accepted, skipped and refused is listed in docs/io/obj.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include <irg/core/executor.hpp>
#include <irg/core/result.hpp>
#include <irg/io/detail/obj_pieces.hpp>
#include <irg/io/detail/obj_reader.hpp>

namespace irg {

/// How an OBJ text is read.
struct obj_options {
  obj_unused unused = obj_unused::skip;
};

inline namespace IRG_ABI {

/// The mesh that an OBJ text describes; its faces are the text's polygons.
/// shape   parts cover the faces in order, those before the first g, o or usemtl without names; a text that names
///         nothing has no parts
/// needs   the text in memory; it is not kept
/// gives   the first error with its line and column, in place of a half-read mesh; a text without faces is a mesh
///         without faces. The mesh passes validate(): finite numbers, three corners or more per face, every index in
///         range
/// exact   numbers are correctly rounded to T. The same mesh and the same error for every executor
/// cost    linear in the text; memory at most 64 times the text and 1 MiB. An executor reads pieces of 64 KiB, each by
///         itself
template <Floating T = double, Executor E = sequential>
[[nodiscard]] constexpr result<mesh<T>> read_obj(std::string_view text, obj_options options = {},
                                                 const E& executor = {}) {
  if (static_cast<std::uint64_t>(text.size()) >> 32 != 0) return parse_error{0, 0, "text is longer than 4 GiB"};
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return parse_error{0, 0, "text is UTF-16, but OBJ must be ASCII or UTF-8"};
  text = detail::without_byte_order_mark(text);
  if constexpr (!std::is_same_v<E, sequential>) {
    constexpr std::size_t piece_bytes = std::size_t{1} << 16;
    if (text.size() > 2 * piece_bytes)
      return detail::read_obj_in_pieces<T>(text, options.unused, piece_bytes, executor);
  }
  return detail::read_obj_in_one_go<T>(text, options.unused);
}

}  // namespace IRG_ABI
}  // namespace irg
