// SPDX-License-Identifier: MIT
// What functions that read the outside world return: the value, or the place and the reason of the failure.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include <irg/core/contract.hpp>

namespace irg {

/// Where and why a text could not be read.
/// shape   line and column count from 1; column counts bytes. In a file that is no text line is 0 and column the byte,
///         from 1. Both are 0 when no place applies
struct parse_error {
  std::size_t line = 0;
  std::size_t column = 0;
  const char* message = "";  // one sentence without a full stop, of static storage
};

/// Either a value or an error, never half of each.
template <class T, class E = parse_error>
class [[nodiscard]] result {
public:
  IRG_INLINE constexpr result(T value) : value_(std::move(value)) {}
  IRG_INLINE constexpr result(E error) : error_(std::move(error)) {}

  [[nodiscard]] IRG_INLINE constexpr bool has_value() const noexcept { return value_.has_value(); }
  IRG_INLINE constexpr explicit operator bool() const noexcept { return value_.has_value(); }

  /// needs   has_value()
  IRG_INLINE constexpr T& operator*() & noexcept { return IRG_EXPECTS(has_value()), *value_; }
  IRG_INLINE constexpr const T& operator*() const& noexcept { return IRG_EXPECTS(has_value()), *value_; }
  IRG_INLINE constexpr T&& operator*() && noexcept { return IRG_EXPECTS(has_value()), *std::move(value_); }
  IRG_INLINE constexpr T* operator->() noexcept { return IRG_EXPECTS(has_value()), &*value_; }
  IRG_INLINE constexpr const T* operator->() const noexcept { return IRG_EXPECTS(has_value()), &*value_; }

  /// needs   !has_value()
  [[nodiscard]] IRG_INLINE constexpr const E& error() const noexcept { return IRG_EXPECTS(!has_value()), error_; }

private:
  std::optional<T> value_{};
  E error_{};
};

}  // namespace irg
