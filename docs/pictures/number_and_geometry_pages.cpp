// SPDX-License-Identifier: MIT
// The pictures of the pages of docs/colour, docs/math and docs/geometry.
#include "barycentric.hpp"
#include "clip_stages.hpp"
#include "clipping.hpp"
#include "colours.hpp"
#include "error_plots.hpp"
#include "geometry.hpp"
#include "inverse_errors.hpp"
#include "lines_geometry.hpp"
#include "numbers.hpp"
#include "planes.hpp"
#include "polygon_pages.hpp"
#include "polygons.hpp"
#include "polygons_in_space.hpp"
#include "predicates.hpp"
#include "saving.hpp"
#include "simulated_simplicity.hpp"
#include "spaces.hpp"
#include "tiles.hpp"

void saving::number_and_geometry_pages() {
  save("mix", colour_pictures::mixes());
  save("over", colour_pictures::overs());
  save("palette", colour_pictures::palettes());
  save("executors", tile_pictures::orders());
  save("orient2d", predicate_pictures::turns());
  save("orient3d", predicate_pictures::planes());
  save("in_circle", predicate_pictures::circles());
  save("exact", predicate_pictures::discs());
  save("polygon_convexity", polygon_pages::convexity());
  save("polygon", polygon_pages::edges());
  save("polygon_orientation", polygon_pages::orientation());
  save("point_in_convex_polygon", polygon_pages::convex_search());
  save("orient2d_batch", polygon_pages::batch());
  save("flat_ring", polygons_in_space::shadows());
  save("newell_plane", polygons_in_space::newell());
  save("clip_stages", clip_stages::triangle());
  save("coordinate_system", space_pictures::systems());
  save("homogeneous", space_pictures::rays());
  save("vector_projection", space_pictures::projection());
  save("transform_points", space_pictures::grids());
  save("interval", number_pictures::enclosures());
  save("expansion", number_pictures::parts());
  save("double_double", number_pictures::mandelbrot());
  save("line_sides", geometry_pictures::lines());
  save("side_of_line", geometry_pictures::sides());
  save("compare", geometry_pictures::orders());
  save("compare_distance_to", geometry_pictures::nearer());
  save("box", geometry_pictures::boxes());
  save("intersect_planes", plane_pictures::meetings());
  save("parametric_plane", plane_pictures::parameters());
  save("point_in_polygon", polygon_pictures::rules());
  save("convex_hull", polygon_pictures::hull());
  save("triangulate_monotone", polygon_pictures::triangles());
  save("split_polygon", polygon_pictures::cut());
  save("polygons_overlap", polygon_pictures::overlaps());
  save("polygon_centroid", polygon_pictures::centres());
  failures += inverse_errors::write_plot(folder + "/inverse_errors.svg") ? 0 : 1;
  failures += error_plots::write_dots(folder + "/dot_errors.svg") ? 0 : 1;
  failures += error_plots::write_roots(folder + "/root_errors.svg") ? 0 : 1;
  save("clip_line", clipping_pictures::lines());
  save("clip_sutherland_hodgman", clipping_pictures::polygons());
  save("polygon_overlay", clipping_pictures::operations());
  save("clip_weiler_atherton", clipping_pictures::entering_and_leaving());
  save("intersect_segments", lines_geometry::segments());
  save("closest_point", lines_geometry::regions());
  save("smallest_sphere", lines_geometry::circle());
  save("barycentric", barycentric_pictures::weights());
  save("simulation_of_simplicity", simulated_simplicity::signs());
}
