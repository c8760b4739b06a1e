// SPDX-License-Identifier: MIT
// What functions that read the outside world return: the value, or the place and the reason of the failure.
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
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

/// Either a value or an error, never half of each. True on success.
/// shape   `result<void, E>` is the answer of a command: nothing, or why it was not done
/// gives   `value_or(other)` the value, or the other. `and_then(f)` f(value), itself a result with the same kind of
///         error; `transform(f)` a result that holds f(value). Neither calls f after a failure: the error goes on
template <class T, class E = parse_error>
class [[nodiscard]] result {
public:
  using value_type = T;
  using error_type = E;

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

  template <class U>
  [[nodiscard]] constexpr T value_or(U&& other) const& {
    return has_value() ? *value_ : static_cast<T>(std::forward<U>(other));
  }
  template <class U>
  [[nodiscard]] constexpr T value_or(U&& other) && {
    return has_value() ? *std::move(value_) : static_cast<T>(std::forward<U>(other));
  }

  template <class F>
  constexpr auto and_then(F&& f) const& {
    return next(*this, std::forward<F>(f));
  }
  template <class F>
  constexpr auto and_then(F&& f) && {
    return next(std::move(*this), std::forward<F>(f));
  }

  template <class F>
  constexpr auto transform(F&& f) const& {
    return changed(*this, std::forward<F>(f));
  }
  template <class F>
  constexpr auto transform(F&& f) && {
    return changed(std::move(*this), std::forward<F>(f));
  }

private:
  template <class Self, class F>
  static constexpr auto next(Self&& self, F&& f) {
    using answer = std::invoke_result_t<F, decltype(*std::forward<Self>(self))>;
    return self ? f(*std::forward<Self>(self)) : answer(self.error_);
  }
  template <class Self, class F>
  static constexpr auto changed(Self&& self, F&& f) {
    using value = std::remove_cvref_t<std::invoke_result_t<F, decltype(*std::forward<Self>(self))>>;
    if (!self) return result<value, E>(self.error_);
    if constexpr (std::is_void_v<value>)
      return f(*std::forward<Self>(self)), result<value, E>();
    else
      return result<value, E>(f(*std::forward<Self>(self)));
  }

  std::optional<T> value_{};
  E error_{};
};

template <class E>
class [[nodiscard]] result<void, E> {
public:
  using value_type = void;
  using error_type = E;

  IRG_INLINE constexpr result() noexcept = default;
  IRG_INLINE constexpr result(E error) : error_(std::move(error)) {}

  [[nodiscard]] IRG_INLINE constexpr bool has_value() const noexcept { return !error_.has_value(); }
  IRG_INLINE constexpr explicit operator bool() const noexcept { return has_value(); }

  /// needs   !has_value()
  [[nodiscard]] IRG_INLINE constexpr const E& error() const noexcept { return IRG_EXPECTS(!has_value()), *error_; }

  template <class F>
  constexpr auto and_then(F&& f) const {
    return has_value() ? f() : std::invoke_result_t<F>(*error_);
  }

private:
  std::optional<E> error_{};
};

}  // namespace irg
