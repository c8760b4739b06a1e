// SPDX-License-Identifier: MIT
// Where the pictures go. The pages of numbers and geometry have a source of their own, so that two compile at once.
#pragma once

#include <cstdio>
#include <string>

#include <irg/io/image_file.hpp>

#include "enlarged.hpp"

namespace saving {

inline std::string folder = ".";
inline int failures = 0;

inline void save(const std::string& name, const enlarging::picture& p) {
  if (const auto saved = irg::save_image(folder + "/" + name + ".png", p); !saved) {
    std::fprintf(stderr, "pictures: %s: %s\n", saved.error().message, name.c_str());
    ++failures;
  }
}

void number_and_geometry_pages();

}  // namespace saving
