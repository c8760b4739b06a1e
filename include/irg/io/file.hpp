// SPDX-License-Identifier: MIT
// Whole files in and out, by <cstdio> alone: no exceptions, and no file that is written by half.
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <irg/core/result.hpp>
#include <irg/io/detail/file_access.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The bytes of a file.
/// gives   one sentence when the file does not exist, may not be opened, is a directory, cannot be read, is empty or
///         holds more than 4 GiB; line and column are 0
/// cost    twice the file's size in memory while it is read
[[nodiscard]] inline result<std::string> read_file(const std::string& path) {
  if (detail::kind_of_file(path.c_str()) == detail::file_kind::directory)
    return parse_error{0, 0, "path is a directory, not a file"};
  errno = 0;
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return detail::open_error(errno, "file does not exist", "file cannot be opened");
  std::string bytes;
  std::size_t filled = 0;
  do {
    bytes.resize(filled == 0 ? std::size_t{1} << 16 : 2 * filled);
    filled += std::fread(bytes.data() + filled, 1, bytes.size() - filled, file);
  } while (filled == bytes.size() && filled <= detail::most_bytes);
  const bool broken = std::ferror(file) != 0;
  std::fclose(file);
  if (filled > detail::most_bytes) return parse_error{0, 0, "file holds more than 4 GiB"};
  if (broken) return parse_error{0, 0, "file cannot be read"};
  if (filled == 0) return parse_error{0, 0, "file is empty"};
  bytes.resize(filled);
  return bytes;
}

/// Writes a whole file; absent when that succeeded, else the reason, and then the path is as it was before.
/// gives   the bytes go to a new file beside the path, which takes the path's place when all of them have arrived and
///         is removed otherwise. Links are followed; a file that stood there loses its permissions. What is neither
///         file nor directory, such as a pipe or /dev/null, is written to directly
[[nodiscard]] inline std::optional<parse_error> write_file_atomically(const std::string& path, std::string_view bytes) {
  const detail::file_kind kind = detail::kind_of_file(path.c_str());
  if (kind == detail::file_kind::directory) return parse_error{0, 0, "path is a directory, not a file"};
  if (kind == detail::file_kind::other) {
    std::FILE* const device = std::fopen(path.c_str(), "wb");
    if (device == nullptr) return detail::open_error(errno, "file does not exist", "file cannot be opened");
    if (!detail::write_and_close(device, bytes)) return parse_error{0, 0, "not all bytes could be written"};
    return std::nullopt;
  }
  const std::string target = detail::without_links(path);
  std::string beside;
  std::FILE* file = nullptr;
  errno = EEXIST;
  for (int attempt = 0; file == nullptr && errno == EEXIST && attempt < 1000; ++attempt) {
    beside = target + "." + std::to_string(attempt) + ".part";
    file = std::fopen(beside.c_str(), "wbx");  // x: never a file that another writer is at
  }
  if (file == nullptr) return detail::open_error(errno, "folder of the file does not exist", "file cannot be created");
  const bool written = detail::write_and_close(file, bytes);
  if (written && detail::replace_file(beside.c_str(), target.c_str())) return std::nullopt;
  std::remove(beside.c_str());
  return parse_error{0, 0, written ? "file cannot be replaced" : "not all bytes could be written"};
}

/// The same for bytes that are no text.
[[nodiscard]] inline std::optional<parse_error> write_file_atomically(const std::string& path,
                                                                      std::span<const std::uint8_t> bytes) {
  return write_file_atomically(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace IRG_ABI
}  // namespace irg
