// SPDX-License-Identifier: MIT
// Whole files in and out, by <cstdio> alone: no exceptions, and no file that is written by half.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <irg/core/result.hpp>
#if IRG_BODIES
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#if defined(__unix__) || defined(__APPLE__)
#include <stdlib.h>
#define IRG_HAS_REALPATH 1
#endif
#if defined(__unix__) || defined(__APPLE__) || defined(__wasi__) || defined(_WIN32)
#include <sys/stat.h>
#define IRG_HAS_STAT 1
#endif
#endif

namespace irg::detail::inline IRG_COMPILED_ABI {

// Constexpr in name alone: files are no affair of constant evaluation.
template <class Bytes = std::string>
IRG_API result<Bytes> load_bytes(const std::string& path);
template <class Bytes>
IRG_API result<void> save_bytes(const std::string& path, const Bytes& bytes);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

/// The bytes of a file.
/// gives   one sentence when the file does not exist, may not be opened, is a directory, cannot be read, is empty or
///         holds more than 4 GiB; line and column are 0
/// cost    twice the file's size in memory while it is read
[[nodiscard]] inline result<std::string> load_file(const std::string& path) { return detail::load_bytes(path); }

/// Writes a whole file: true when that succeeded, else the reason, and then the path is as it was before.
/// gives   the bytes go to a new file beside the path, which takes the path's place when all of them have arrived and
///         is removed otherwise. Links are followed; a file that stood there loses its permissions. What is neither
///         file nor directory, such as a pipe or /dev/null, is written to directly
[[nodiscard]] inline result<void> save_file(const std::string& path, std::string_view bytes) {
  return detail::save_bytes(path, bytes);
}

/// The same for bytes that are no text.
[[nodiscard]] inline result<void> save_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  return save_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

IRG_RENAMED(read_file, load_file)

/// The old form of save_file: the reason of a failure, where save_file is true when the file was written.
template <class Bytes>
[[nodiscard, deprecated("irg: use save_file, which is true when the file was written")]] std::optional<parse_error>
write_file_atomically(const std::string& path, const Bytes& bytes) {
  const result<void> saved = save_file(path, bytes);
  return saved ? std::nullopt : std::optional(saved.error());
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// What the operating system is asked about a file, and its bytes written.

enum class file_kind { unknown, regular, directory, other };

/// What stands at the path; unknown when nothing does, or where the system cannot say.
inline file_kind kind_of_file(const char* path) noexcept {
#ifdef IRG_HAS_STAT
  struct stat status{};
  if (stat(path, &status) != 0) return file_kind::unknown;
  if ((status.st_mode & S_IFMT) == S_IFREG) return file_kind::regular;
  return (status.st_mode & S_IFMT) == S_IFDIR ? file_kind::directory : file_kind::other;
#else
  return static_cast<void>(path), file_kind::unknown;
#endif
}

/// The path with its links followed, so that what they lead to is replaced and not the link; the path itself when that
/// fails.
inline std::string without_links(const std::string& path) {
#ifdef IRG_HAS_REALPATH
  if (char* const real = realpath(path.c_str(), nullptr); real != nullptr) {
    std::string resolved = real;
    std::free(real);
    return resolved;
  }
#endif
  return path;
}

/// More is not read: endless devices end, too.
inline constexpr std::size_t most_bytes = sizeof(std::size_t) > 4 ? std::size_t{1} << 32 : std::size_t{1} << 31;

/// The sentence for the system's reason not to open a file.
inline parse_error open_error(int reason, const char* missing, const char* otherwise) noexcept {
  if (reason == ENOENT) return {0, 0, missing};
  if (reason == EACCES) return {0, 0, "permission to open the file is denied"};
  if (reason == EISDIR) return {0, 0, "path is a directory, not a file"};
  if (reason == ENOTDIR) return {0, 0, "a part of the path is not a directory"};
  return {0, 0, otherwise};
}

/// Writes and closes; says whether everything arrived.
inline bool write_and_close(std::FILE* file, std::string_view bytes) noexcept {
  const bool written = bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  return (std::fclose(file) == 0) && written;
}

inline bool replace_file(const char* from, const char* to) noexcept {
#ifdef _WIN32
  std::remove(to);  // rename does not replace there
#endif
  return std::rename(from, to) == 0;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Bytes>
IRG_API result<Bytes> load_bytes(const std::string& path) {
  if (kind_of_file(path.c_str()) == file_kind::directory) return parse_error{0, 0, "path is a directory, not a file"};
  errno = 0;
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return open_error(errno, "file does not exist", "file cannot be opened");
  Bytes bytes;
  std::size_t filled = 0;
  do {
    bytes.resize(filled == 0 ? std::size_t{1} << 16 : 2 * filled);
    filled += std::fread(bytes.data() + filled, 1, bytes.size() - filled, file);
  } while (filled == bytes.size() && filled <= most_bytes);
  const bool broken = std::ferror(file) != 0;
  std::fclose(file);
  if (filled > most_bytes) return parse_error{0, 0, "file holds more than 4 GiB"};
  if (broken) return parse_error{0, 0, "file cannot be read"};
  if (filled == 0) return parse_error{0, 0, "file is empty"};
  bytes.resize(filled);
  return bytes;
}

template <class Bytes>
IRG_API result<void> save_bytes(const std::string& path, const Bytes& bytes) {
  const file_kind kind = kind_of_file(path.c_str());
  if (kind == file_kind::directory) return parse_error{0, 0, "path is a directory, not a file"};
  if (kind == file_kind::other) {
    std::FILE* const device = std::fopen(path.c_str(), "wb");
    if (device == nullptr) return open_error(errno, "file does not exist", "file cannot be opened");
    if (!write_and_close(device, bytes)) return parse_error{0, 0, "not all bytes could be written"};
    return {};
  }
  const std::string target = without_links(path);
  std::string beside;
  std::FILE* file = nullptr;
  errno = EEXIST;
  for (int attempt = 0; file == nullptr && errno == EEXIST && attempt < 1000; ++attempt) {
    beside = target + "." + std::to_string(attempt) + ".part";
    file = std::fopen(beside.c_str(), "wbx");  // x: never a file that another writer is at
  }
  if (file == nullptr) return open_error(errno, "folder of the file does not exist", "file cannot be created");
  const bool written = write_and_close(file, bytes);
  if (written && replace_file(beside.c_str(), target.c_str())) return {};
  std::remove(beside.c_str());
  return parse_error{0, 0, written ? "file cannot be replaced" : "not all bytes could be written"};
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
