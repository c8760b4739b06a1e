// SPDX-License-Identifier: MIT
// The command line of the numbered steps: `--help` says what the step shows, and words it does not take are refused.
#pragma once

#include "command_line.hpp"

namespace program {

/// Reads a step's command line and ends the program after `--help` or a word too many; returns the file that a step with
/// a `picture` writes: the word given, or else `picture`.
inline std::string step(int argc, char** argv, std::string_view name, std::string_view shows,
                        std::string_view picture = {}) {
  std::string help = std::string(name) + ": " + std::string(shows) + "\nusage: " + std::string(name);
  help += picture.empty()
              ? "\n"
              : " [FILE]     " + std::string(picture.ends_with(".svg") ? "FILE.svg" : "FILE.png, FILE.ppm") +
                    ": where the picture goes (" + std::string(picture) + ")\n";
  command_line line(argc, argv, name, help);
  std::string file(picture);
  if (!picture.empty() && !line.done()) file = line.take_file();
  if (!line.done()) line.refuse(line.take());
  return file;
}

}  // namespace program
