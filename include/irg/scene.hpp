// SPDX-License-Identifier: MIT
// scene: objects, camera, lights: the one interface every method draws from.
#pragma once

#include <irg/scene/scene.hpp>
#include <irg/scene/room_mesh.hpp>
#include <irg/scene/camera.hpp>
#include <irg/scene/stored_body.hpp>
