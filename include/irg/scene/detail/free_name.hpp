// SPDX-License-Identifier: MIT
// The names of bodies that come into the studio: no two have the same.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <irg/scene/studio.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// The number of a name among those that begin with `plain`: 1 for itself, n for plain(n) up to `most`, 0 for others.
constexpr std::size_t number_of_name(std::string_view name, std::string_view plain, std::size_t most) noexcept {
  if (!name.starts_with(plain)) return 0;
  name.remove_prefix(plain.size());
  if (name.empty()) return 1;
  if (name.size() < 3 || name.front() != '(' || name.back() != ')' || name[1] == '0') return 0;
  std::size_t n = 0;
  for (const char c : name.substr(1, name.size() - 2)) {
    if (c < '0' || c > '9') return 0;
    n = 10 * n + static_cast<std::size_t>(c - '0');
    if (n > most) return 0;
  }
  return n < 2 ? 0 : n;
}

// Names are words of scripts in quotes and values of XML: quotes and control characters become question marks.
template <class T>
constexpr part_name free_name(const studio<T>& s, const part_name& wanted) {
  part_name name;
  for (const char c : std::string_view(wanted))
    name.push_back(static_cast<unsigned char>(c) < 32 || c == 127 || c == '"' ? '?' : c);
  const std::size_t most = s.bodies.size() + 1;  // a number up to this is free
  std::vector<char> is_taken(most + 1, '\0');
  for (const studio_body<T>& b : s.bodies) is_taken[number_of_name(b.body.name, name, most)] = 1;
  std::size_t n = 1;
  while (is_taken[n] != 0) ++n;
  if (n == 1) return name;
  char digits[20] = {};
  std::size_t first = sizeof digits;
  for (; n != 0; n /= 10) digits[--first] = static_cast<char>('0' + n % 10);
  name.push_back('(');
  for (; first < sizeof digits; ++first) name.push_back(digits[first]);
  name.push_back(')');
  return name;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
