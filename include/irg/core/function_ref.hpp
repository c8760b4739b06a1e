// SPDX-License-Identifier: MIT
// A reference to something that can be called, whatever its type: a function that takes one is compiled once for all
// callers, as a template is not.
#pragma once

#include <type_traits>

#include <irg/core/config.hpp>

namespace irg {

/// Something that can be called as Signature says, such as void(int): as_function<Signature>(f) makes one of f. It
/// refers to f and is handed on as `const function_ref<Signature>&`, in constant evaluation, too.
/// cost    a virtual call: for what is asked once a stage or a task, not once a pixel
template <class Signature>
struct function_ref;
template <class R, class... Arguments>
struct function_ref<R(Arguments...)> {
  virtual constexpr R operator()(Arguments... arguments) const = 0;

protected:
  constexpr ~function_ref() = default;
};

namespace detail::inline IRG_ABI {

template <class F, class Signature>
struct function_ref_to;
template <class F, class R, class... Arguments>
struct function_ref_to<F, R(Arguments...)> final : function_ref<R(Arguments...)> {
  F& f;

  constexpr explicit function_ref_to(F& to) noexcept : f(to) {}
  constexpr R operator()(Arguments... arguments) const override {
    if constexpr (std::is_void_v<R>)
      f(static_cast<Arguments&&>(arguments)...);
    else
      return f(static_cast<Arguments&&>(arguments)...);
  }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// A function_ref to f, const or not, which must live longer than it is called.
/// gives   what f returns; nothing for a Signature that returns void
template <class Signature, class F>
[[nodiscard]] IRG_INLINE constexpr detail::function_ref_to<std::remove_reference_t<F>, Signature> as_function(
    F&& f) noexcept {
  return detail::function_ref_to<std::remove_reference_t<F>, Signature>(f);
}

}  // namespace IRG_ABI
}  // namespace irg
