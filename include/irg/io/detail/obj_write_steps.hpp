// SPDX-License-Identifier: MIT
// The steps of obj_write.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/mesh_options.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

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
  if (c.texcoord != mesh_corner::none || c.normal != mesh_corner::none) append_text(out, "/");
  if (c.texcoord != mesh_corner::none) put(c.texcoord);
  if (c.normal == mesh_corner::none) return;
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

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
