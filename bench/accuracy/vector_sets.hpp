// SPDX-License-Identifier: MIT
// What the studies of vector kernels share: wrappers that run a function over all items.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/real.hpp"
#include "accuracy/sets.hpp"

namespace bench {

/// f(item) for every item, one number each.
template <class Items, class F>
implementation for_each_item(std::string name, const Items& items, F f, bool same_work = true) {
  return {std::move(name),
          [&items, f](double* out) {
            for (const auto& item : items) *out++ = static_cast<double>(f(item));
          },
          same_work};
}

template <class V>
double component(const V& v, int k) {
  if constexpr (requires { typename V::size_type; })
    return static_cast<double>(v[static_cast<typename V::size_type>(k)]);
  else
    return static_cast<double>(v[k]);
}

/// f(item) for every item, `N` numbers each, which operator[] of the result gives.
template <int N, class Items, class F>
implementation for_each_vector(std::string name, const Items& items, F f, bool same_work = true) {
  return {std::move(name),
          [&items, f](double* out) {
            for (const auto& item : items) {
              const auto v = f(item);
              for (int k = 0; k < N; ++k) *out++ = component(v, k);
            }
          },
          same_work};
}

}  // namespace bench
