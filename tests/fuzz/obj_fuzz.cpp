// SPDX-License-Identifier: MIT
// libFuzzer target: any bytes give a sound mesh or an error with a place in the text.
#include <cstdint>
#include <string_view>

#include <irg/io/obj.hpp>

#include "checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const bool sound = fuzz::check_mesh(text, irg::read_obj<double>(text));
  const bool sound_as_float = fuzz::check_mesh(text, irg::read_obj<float>(text));
  fuzz::require(sound || !sound_as_float);  // a float overflows earlier, and nothing else differs
  if (fuzz::check_mesh(text, irg::read_obj<double>(text, {irg::obj_unused::refuse}))) fuzz::require(sound);
  return 0;
}
