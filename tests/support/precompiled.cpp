// SPDX-License-Identifier: MIT
// The file that precompiled.hpp is compiled with.
