// SPDX-License-Identifier: MIT
// Integers of 128 bits: products of two 64-bit numbers, and sums of some, without loss. irg takes them from here alone.
#pragma once

#ifndef __SIZEOF_INT128__
#include <irg/math/detail/two_word_integer.hpp>
#endif

namespace irg {

#ifdef __SIZEOF_INT128__

/// A signed integer of 128 bits.
/// exact   as every integer of the language: overflow is undefined
__extension__ typedef __int128 int128;

/// An unsigned integer of 128 bits.
/// exact   modulo 2^128
__extension__ typedef unsigned __int128 uint128;
#else
using int128 = detail::two_word_integer<detail::number_sign::twos_complement>;
using uint128 = detail::two_word_integer<detail::number_sign::none>;
#endif

}  // namespace irg
