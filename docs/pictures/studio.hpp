// SPDX-License-Identifier: MIT
// The studio: both views of the teapot and three bodies, and the window with its panels. Included by pictures.cpp.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/raster/image.hpp>

#include "../../examples/studio/studio_desk.hpp"
#include "../../examples/studio/studio_picture.hpp"
#include "../../examples/studio/studio_script.hpp"

namespace studio_pictures {

inline constexpr std::string_view script =
    "aim main 3 5 10 0 1 0\nshade teapot gouraud\ncolour teapot 205 128 70\n"
    "add kocka before translate -4 0 0\nadd kocka before rotate-y 20\nshow kocka edges on\ncolour kocka 220 215 190\n"
    "add \"kocka(2)\" before scale 1.6 1.6 1.6\nadd \"kocka(2)\" before translate 1.6 0 1.6\n"
    "add \"kocka(2)\" after rotate-z -8\nshow \"kocka(2)\" faces off\nshow \"kocka(2)\" edges on\n"
    "show \"kocka(2)\" points on\nadd ring before translate -1.5 0.5 3\nshade ring gouraud\ncolour ring 60 120 200\n"
    "opacity ring 0.5\nhelper main axes on\npyramid main 2 1.6 1.6 3 16\naim outer 32 16 8 0 1 5\n"
    "pyramid outer 2 1.3 1.3 1 99\n";

inline irg::image<irg::rgba8> both_views() {
  irg::studio<double> s;
  for (const auto& [name, shape] :
       {std::pair{"teapot", irg::shape_teapot<double>()}, std::pair{"kocka", irg::shape_cube<double>()},
        std::pair{"kocka", irg::shape_cube<double>()}, std::pair{"ring", irg::shape_torus<double>()}})
    (void)irg::apply_event(s, irg::load_body<double>{irg::store_body(name, shape)});
  const auto commands = irg::read_studio_script<double>(script);
  for (const auto& c : *commands) (void)irg::apply_event(s, c.event);
  irg::image<irg::rgba8> picture(960, 480);
  irg::studio_memory<double> memory;
  irg::draw_studio(picture.view(), s, memory);
  return picture;
}

// What the program shows, with a second lamp, the third body chosen, and a cell of the lower panel for keys.
inline irg::image<irg::rgba8> window() {
  program::studio_session session(1280, 720);
  const std::string loads = "load teapot\nload cube kocka\nload cube kocka\nload torus ring\n";
  const std::string all = loads + std::string(script) + "lamp 2 6 4 -2 1 0.6 0.3 0.2\n";
  const auto commands = irg::read_studio_script<double>(all);
  for (const auto& c : *commands) (void)session.run(c);
  program::studio_desk desk(session);
  desk.resize(1280, 720);
  for (const char* key : {"tab", "tab", "f2", "f2", "down", "down"}) (void)desk.key(key);
  return desk.draw();
}

}  // namespace studio_pictures
