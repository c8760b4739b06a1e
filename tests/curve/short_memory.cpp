// SPDX-License-Identifier: MIT
#include "mesh/short_memory.cpp"
