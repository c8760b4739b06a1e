// SPDX-License-Identifier: MIT
// How the accuracy studies print their input.
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string>
#include <type_traits>

#include "support/random_numbers.hpp"

namespace bench {

/// The doubles that an item is made of, as C++ reads them back.
template <class Item>
std::string text_of(const Item& item) {
  static_assert(std::is_trivially_copyable_v<Item> && sizeof(Item) % sizeof(double) == 0, "an item is made of doubles");
  std::array<double, sizeof(Item) / sizeof(double)> all;
  std::memcpy(all.data(), &item, sizeof item);
  std::string text;
  char word[40];
  for (const double x : all) {
    std::snprintf(word, sizeof word, "%s%a", text.empty() ? "" : " ", x);
    text += word;
  }
  return text;
}
inline std::string text_of(const std::string& item) { return item; }

/// The items of a distribution as text, for study::panel.
template <class Items>
auto text_of_items(const Items& items) {
  return [&items](std::size_t i) { return text_of(items[i]); };
}

}  // namespace bench
