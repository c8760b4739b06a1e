// SPDX-License-Identifier: MIT
// Prints `name hash` for every registered function; ends with 1 where run time and constant evaluation differ.
#include "hashes.hpp"

#include <cstdio>
#include <cstring>

namespace {
determinism::section* first = nullptr;
}

// Keeps the list in order of names, whatever the order of the files.
determinism::section::section(const char* its_name, std::uint64_t (*function)(int), int few, std::uint64_t in_advance,
                              int many)
    : name(its_name), compute(function), constant_rounds(few), constant(in_advance), rounds(many), next(nullptr) {
  section** place = &first;
  while (*place && std::strcmp((*place)->name, name) < 0) place = &(*place)->next;
  next = *place;
  *place = this;
}

int main() {
  int wrong = 0;
  for (const determinism::section* s = first; s; s = s->next) {
    // Through a volatile, so that the run time's value is not folded into the constant one.
    volatile int few = s->constant_rounds;
    if (s->compute(few) != s->constant) {
      std::printf("%s: run time and constant evaluation differ\n", s->name);
      ++wrong;
    }
    std::printf("%s %016llx %016llx\n", s->name, static_cast<unsigned long long>(s->constant),
                static_cast<unsigned long long>(s->compute(s->rounds)));
  }
  return wrong == 0 ? 0 : 1;
}
