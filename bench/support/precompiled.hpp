// SPDX-License-Identifier: MIT
// What nearly every benchmark includes, parsed once where they are built as tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "support/measure.hpp"
