// SPDX-License-Identifier: MIT
// io: OBJ, PPM, PNG, SVG; reads from memory, writes any raster; nothing else touches files.
#pragma once

#include <irg/io/file.hpp>
#include <irg/io/image_file.hpp>
#include <irg/io/obj.hpp>
#include <irg/io/picture_limits.hpp>
#include <irg/io/png.hpp>
#include <irg/io/ppm.hpp>
#include <irg/io/svg.hpp>
