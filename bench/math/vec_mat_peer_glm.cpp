// SPDX-License-Identifier: MIT
#if defined(IRG_HAVE_GLM)
#include "math/vec_mat_peer_glm.hpp"
#endif
#include "math/vec_mat.hpp"

namespace bench {

template <class T>
static void enter(vec_mat_entries& to, const vec_mat_input<T>& in) {
#if defined(IRG_HAVE_GLM)
  enter_library<glm_library<T, glm::packed_highp>>(to, in, "GLM");
#else
  static_cast<void>(to);
  static_cast<void>(in);
#endif
}

void enter_glm(vec_mat_entries& to, const vec_mat_input<float>& in) { enter<float>(to, in); }
void enter_glm(vec_mat_entries& to, const vec_mat_input<double>& in) { enter<double>(to, in); }

}  // namespace bench
