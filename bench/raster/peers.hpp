// SPDX-License-Identifier: MIT
// The peers that were found on this machine.
#pragma once

#ifdef IRG_HAVE_OPENCV_IMGPROC
#include "raster/peer_opencv.hpp"
#endif
#ifdef IRG_HAVE_SDL2
#include "raster/peer_sdl.hpp"
#endif
#ifdef IRG_HAVE_AGG
#include "raster/peer_agg.hpp"
#endif
#ifdef IRG_HAVE_CAIRO
#include "raster/peer_cairo.hpp"
#endif
#ifdef IRG_HAVE_PIXMAN
#include "raster/peer_pixman.hpp"
#endif
