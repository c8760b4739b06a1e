// SPDX-License-Identifier: MIT
// How something lies with regard to a region, told by a test that may leave the middle ground open.
#pragma once

namespace irg {

/// How something lies with regard to a region: a box to a view frustum, a window of pixels to a triangle.
enum class containment {
  outside,  // surely no point of it is in the region
  crossing,  // anything else
  inside  // surely all of it is in the region
};

}  // namespace irg
