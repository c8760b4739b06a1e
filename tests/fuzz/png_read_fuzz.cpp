// SPDX-License-Identifier: MIT
// libFuzzer target: any bytes give a picture that is written and read as itself, or an error with its byte. The
// checksums of the bytes are put right first: they would keep everything behind them from being reached.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/io/png.hpp>
#include <irg/io/png_read.hpp>

#include "checks.hpp"

namespace {

/// The file with the checksums of its chunks made right.
std::vector<std::uint8_t> with_checksums(std::span<const std::uint8_t> in) {
  std::vector<std::uint8_t> file(in.begin(), in.end());
  for (std::size_t at = 8; file.size() >= at + 12;) {
    const std::size_t length =
        std::size_t{file[at]} << 24 | std::size_t{file[at + 1]} << 16 | std::size_t{file[at + 2]} << 8 | file[at + 3];
    if (file.size() - at - 12 < length) break;
    const std::uint32_t sum = irg::detail::crc32(std::span<const std::uint8_t>(file).subspan(at + 4, length + 4));
    for (std::size_t i = 0; i < 4; ++i) file[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    at += length + 12;
  }
  return file;
}

void check(const std::vector<std::uint8_t>& file) {
  const auto read = irg::read_png(file, {1 << 16});
  if (!read) {
    fuzz::require(std::strlen(read.error().message) > 10);
    return fuzz::require(read.error().line == 0 && read.error().column >= 1 && read.error().column <= file.size() + 1);
  }
  fuzz::require(read->width() * read->height() <= 1 << 16);
  fuzz::require(*irg::read_png(*irg::encode_png(*read)) == *read);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check(with_checksums({data, size}));
  irg::detail::inflater<std::vector<std::uint8_t>> stream({data, size}, 1 << 16);
  fuzz::require(stream.zlib() || std::strlen(stream.message) > 10);
  return 0;
}
