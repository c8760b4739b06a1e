// SPDX-License-Identifier: MIT
// How a file's name ends.
#pragma once

#include <cstddef>
#include <string_view>

#include <irg/io/detail/text_cursor.hpp>

namespace irg::detail::inline IRG_ABI {

/// Whether the name ends so, in either case.
/// needs   `lower` has no capitals
constexpr bool has_ending(std::string_view name, std::string_view lower) noexcept {
  return name.size() >= lower.size() && is_word(name.substr(name.size() - lower.size()), lower);
}

}  // namespace irg::detail::inline IRG_ABI
