// SPDX-License-Identifier: MIT
// libFuzzer target: any bytes give a sound mesh or an error with a place; what is written of the mesh reads as it again.
#include <cstdint>
#include <string_view>

#include <irg/io/off.hpp>

#include "checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const auto read = irg::read_off<double>(text);
  const bool sound = fuzz::check_mesh(text, read);
  fuzz::require(sound || !fuzz::check_mesh(text, irg::read_off<float>(text)));
  if (!sound) return 0;
  const auto again = irg::read_off<double>(fuzz::bytes_of(irg::encode_off(*read)));
  fuzz::require(again.has_value() && again->positions == read->positions);
  fuzz::require(read->corners.empty() || *again == *read);  // attributes that no corner names are not written
  return 0;
}
