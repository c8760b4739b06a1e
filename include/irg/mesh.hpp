// SPDX-License-Identifier: MIT
// mesh: indexed mesh, validation, triangulation, normals, shapes (the teapot from its patches).
#pragma once

#include <irg/mesh/mesh.hpp>
#include <irg/mesh/validate.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/normals.hpp>
#include <irg/mesh/crease_normals.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/mesh/to_half_edges.hpp>
#include <irg/mesh/half_edge_mesh.hpp>
#include <irg/mesh/from_half_edges.hpp>
#include <irg/mesh/euler_operators.hpp>
#include <irg/mesh/mesh_faults.hpp>
#include <irg/mesh/orient_faces.hpp>
#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/merge_positions.hpp>
#include <irg/mesh/merge_vertices.hpp>
#include <irg/mesh/fit.hpp>
#include <irg/mesh/edge_ends.hpp>
#include <irg/mesh/part_name.hpp>
#include <irg/mesh/to_mesh.hpp>
