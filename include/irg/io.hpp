// SPDX-License-Identifier: MIT
// io: OBJ read from memory; PPM, PNG, SVG of any raster; nothing else touches files.
#pragma once

#include <irg/io/file.hpp>
#include <irg/io/image_file.hpp>
#include <irg/io/mesh_file.hpp>
#include <irg/io/obj.hpp>
#include <irg/io/obj_write.hpp>
#include <irg/io/mtl.hpp>
#include <irg/io/stl.hpp>
#include <irg/io/ply.hpp>
#include <irg/io/off.hpp>
#include <irg/io/body_xml.hpp>
#include <irg/io/png.hpp>
#include <irg/io/png_read.hpp>
#include <irg/io/apng.hpp>
#include <irg/io/ppm.hpp>
#include <irg/io/plan_text.hpp>
#include <irg/io/space_plan_text.hpp>
#include <irg/io/bsp_file.hpp>
#include <irg/io/grid_text.hpp>
#include <irg/io/svg.hpp>
#include <irg/io/svg_drawing.hpp>
#include <irg/io/terrain.hpp>
#include <irg/io/mesh_options.hpp>
#include <irg/io/picture_limits.hpp>
