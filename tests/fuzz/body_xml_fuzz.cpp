// SPDX-License-Identifier: MIT
// libFuzzer target: any bytes give sound bodies or an error with a place; what is written of them reads as them again.
#include <cstdint>
#include <string_view>

#include <irg/io/body_xml.hpp>

#include "checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const auto read = irg::read_body_xml<double>(text);
  if (!read) {
    fuzz::require(!irg::read_body_xml<float>(text).has_value());
    fuzz::check_place(text, read.error());
    return 0;
  }
  fuzz::check_mesh<double>(text, irg::to_mesh(*read));
  const auto again = irg::read_body_xml<double>(fuzz::bytes_of(irg::encode_body_xml(*read)));
  fuzz::require(again.has_value() && *again == *read);
  return 0;
}
