// SPDX-License-Identifier: MIT
// part_name: the name of a run of faces. Converts to and from the strings that a program uses, and needs the header of
// none of them; other than std::string it can be made in constant evaluation by every compiler.
#pragma once

#include <concepts>
#include <cstddef>
#include <vector>

#include <irg/core/config.hpp>

namespace irg {

/// Some text that is kept.
/// shape   size() characters from data() on, without a zero at the end
class part_name {
public:
  constexpr part_name() = default;

  /// A copy of a literal or of another text that ends with a zero.
  IRG_INLINE constexpr part_name(const char* s) {
    while (*s != '\0') characters_.push_back(*s++);
  }
  /// A copy of a string, of whatever type.
  template <class String>
    requires requires(const String& s) {
      { s.data() } -> std::convertible_to<const char*>;
      { s.size() } -> std::convertible_to<std::size_t>;
    }
  IRG_INLINE constexpr part_name(const String& s) : characters_(s.data(), s.data() + s.size()) {}

  [[nodiscard]] IRG_INLINE constexpr const char* data() const noexcept { return characters_.data(); }
  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return characters_.size(); }
  [[nodiscard]] IRG_INLINE constexpr bool empty() const noexcept { return characters_.empty(); }
  IRG_INLINE constexpr void push_back(char c) { characters_.push_back(c); }

  /// std::string_view, std::string, or what else is made of a pointer and a size.
  template <class String>
    requires std::constructible_from<String, const char*, std::size_t>
  IRG_INLINE constexpr operator String() const {
    return String(data(), size());
  }

  bool operator==(const part_name&) const = default;

private:
  std::vector<char> characters_{};
};

}  // namespace irg
