// SPDX-License-Identifier: MIT
// GLM as it is with its own lanes: types that fill registers, 16 bytes for three floats.
#if defined(IRG_HAVE_GLM)
#define GLM_FORCE_INTRINSICS
#define GLM_FORCE_ALIGNED_GENTYPES
#include "math/vec_mat_peer_glm.hpp"
#endif
#include "math/vec_mat.hpp"

namespace bench {

void enter_glm_simd(vec_mat_entries& to, const vec_mat_input<float>& in) {
#if defined(IRG_HAVE_GLM)
  enter_library<glm_library<float, glm::aligned_highp>>(to, in, "GLM intrinsics");
#else
  static_cast<void>(to);
  static_cast<void>(in);
#endif
}

}  // namespace bench
