// SPDX-License-Identifier: MIT
// libFuzzer target: any bytes give a sound mesh or an error with a place; what is written of the mesh reads as it again.
#include <cstdint>
#include <string_view>

#include <irg/io/stl.hpp>

#include "checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const auto read = irg::read_stl<double>(text);
  const auto apart = irg::read_stl<float>(text, {irg::stl_positions::separate});
  const bool sound = fuzz::check_mesh(text, read);
  fuzz::require(sound || !fuzz::check_mesh(text, apart));
  if (!sound) return 0;
  const auto again = irg::read_stl<double>(fuzz::bytes_of(irg::encode_stl(*read)));
  fuzz::require(again.has_value() && again->positions == read->positions && again->corners == read->corners &&
                again->parts == read->parts);
  const auto bytes = irg::encode_stl(*read, irg::mesh_encoding::little_endian);
  if (bytes) fuzz::require(irg::read_stl<float>(fuzz::bytes_of(bytes))->face_count() == read->face_count());
  return 0;
}
