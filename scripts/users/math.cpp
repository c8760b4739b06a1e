#include <cstdio>
#include <irg/math/decimal.hpp>
#include <irg/math/inverse.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/roots.hpp>

int main() {
  const irg::mat<double, 3, 3> m{{{2, 1, 0}, {1, 3, 1}, {0, 1, 4}}};
  if (const auto inverted = irg::inverse(m)) std::printf("%.17g\n", (*inverted)(0, 0));
  const auto roots = irg::quadratic_roots(1.0, -1e9, 1.0);
  std::printf("%.17g %.17g\n", roots.root[0], roots.root[1]);
}
