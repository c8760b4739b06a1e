// SPDX-License-Identifier: MIT
// Which way a face shows itself, and whether that keeps it from being drawn.
#pragma once

namespace irg {

/// What an eye sees of a face: the inner side (back), its edge, or the outer side (front). The values are the signs of
/// its plane's equation at the eye.
enum class facing { back = -1, edge_on = 0, front = 1 };

/// Which faces are left out because of the way they face.
enum class face_culling { back, none };

}  // namespace irg
