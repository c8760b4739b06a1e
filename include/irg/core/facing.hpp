// SPDX-License-Identifier: MIT
// Which way a face shows itself, and whether that keeps it from being drawn.
#pragma once

namespace irg {

/// Which way a face shows itself.
enum class facing { front, back };

/// Which faces are left out because of the way they face.
enum class face_culling { back, none };

}  // namespace irg
