#include <cstdio>
#include <irg/hidden/line_drawing.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/projection.hpp>

int main() {
  const auto to_clip =
      irg::perspective(irg::radians(40.0), 1.5, 1.0, 100.0) * irg::translation(irg::vec<double, 3>{0, 0, -5});
  irg::line_drawing drawing;
  irg::add_mesh(drawing, irg::shape_torus<double>(), to_clip, irg::map_to_screen<double>({600, 400}));
  irg::hidden_lines(drawing.faces, drawing.edges, [](const irg::edge_part& part) {
    std::printf("%zu %d %.17g %.17g\n", part.edge, static_cast<int>(part.visibility), part.from, part.to);
  });
}
