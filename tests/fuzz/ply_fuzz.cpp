// SPDX-License-Identifier: MIT
// libFuzzer target: any bytes give a sound mesh or an error with a place; what is written of the mesh reads as it again.
#include <cstdint>
#include <string_view>

#include <irg/io/ply.hpp>

#include "checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const auto read = irg::read_ply<double>(text);
  const bool sound = fuzz::check_mesh(text, read);
  fuzz::require(sound || !fuzz::check_mesh(text, irg::read_ply<float>(text)));
  if (!sound) return 0;
  // Attributes that no corner names are not written.
  const auto positions_as_read = [&](const irg::result<irg::mesh<double>>& again) {
    fuzz::require(again.has_value() && again->positions == read->positions &&
                  again->corners.size() == read->corners.size());
    fuzz::require(read->corners.empty() || *again == *read);
  };
  for (const auto e : {irg::mesh_encoding::text, irg::mesh_encoding::little_endian, irg::mesh_encoding::big_endian})
    positions_as_read(irg::read_ply<double>(fuzz::bytes_of(irg::encode_ply(*read, e))));
  return 0;
}
