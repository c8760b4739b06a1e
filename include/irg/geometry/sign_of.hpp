// SPDX-License-Identifier: MIT
// For those who include it by this path: math/exact/sign_of.hpp.
#pragma once

#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>
