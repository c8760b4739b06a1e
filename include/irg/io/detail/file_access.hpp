// SPDX-License-Identifier: MIT
// What the operating system is asked about a file, and its bytes written.
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <irg/core/result.hpp>

#if defined(__unix__) || defined(__APPLE__)
#include <stdlib.h>
#define IRG_HAS_REALPATH 1
#endif
#if defined(__unix__) || defined(__APPLE__) || defined(__wasi__) || defined(_WIN32)
#include <sys/stat.h>
#define IRG_HAS_STAT 1
#endif

namespace irg {
namespace detail {
inline namespace IRG_ABI {

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

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
