// SPDX-License-Identifier: MIT
// Containers of faces or edges as a library takes them that was compiled before.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/config.hpp>

namespace irg::detail::inline IRG_ABI {

// What use(items) gives: with a span of what lies side by side; with the container itself, or a copy of its items where
// bodies are elsewhere, which know no other containers.
// shape   items: a container with size() and [i]
template <class Item, class Items, class Use>
constexpr auto with_items(const Items& items, const Use& use) {
  if constexpr (requires {
                  { *items.data() } -> std::same_as<const Item&>;
                })
    return use(std::span<const Item>(items.data(), items.size()));
  else if constexpr (IRG_BODIES != 0)
    return use(items);
  else {
    std::vector<Item> copy;
    copy.reserve(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) copy.push_back(items[i]);
    return use(std::span<const Item>(copy.data(), copy.size()));
  }
}

}  // namespace irg::detail::inline IRG_ABI
