// SPDX-License-Identifier: MIT
// What irg::compiled has of solid, for float and double.
#include <irg/solid/boolean.hpp>
#include <irg/solid/orient_outward.hpp>
#include <irg/solid/self_intersections.hpp>

namespace irg {

using is_in_bodies = function_ref<bool(const std::vector<unsigned char>&)>;

#define IRG_FOR_NUMBERS(T)                                            \
  template std::vector<face_pair> self_intersections(const mesh<T>&); \
  template outward_status orient_outward(mesh<T>&);                   \
  template solid_boolean_result<T> detail::boolean_of_bodies(const std::vector<const mesh<T>*>&, const is_in_bodies&);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

}  // namespace irg
