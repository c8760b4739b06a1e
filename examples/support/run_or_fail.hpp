// SPDX-License-Identifier: MIT
// How the programs run and what ends them. The steps 01 to 09 do without: they compile without exceptions.
#pragma once

#include <csignal>
#include <new>
#include <string>
#include <string_view>

#include "command_line.hpp"

namespace program {

/// The body of main: run(line), whose memory may end. `size` names what takes it, for the message.
template <class Run>
void run_or_fail(command_line&& line, std::string_view size, const Run& run) {
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);  // a full quota is a failed write, which is cleaned up after, not the program's end
#endif
  try {
    run(line);
  } catch (const std::bad_alloc&) {
    line.fail("there is not enough memory for " + std::string(size));
  }
}

}  // namespace program
