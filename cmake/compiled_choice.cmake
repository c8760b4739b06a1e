# Writes OUT: under each function's name a jump through a pointer, which is set before anything else of the program runs to the
# best level that the processor has. Until then, and on the least, it is the first level's.
file(STRINGS ${FUNCTIONS} functions)
list(LENGTH functions count)
list(GET LEVELS 0 least)

set(jumps "")
set(pointers "")
foreach(function IN LISTS functions)
  string(APPEND jumps ".globl ${function}\n.type ${function}, @function\n.p2align 4\n${function}:\nendbr64\njmp *.Lat_${function}(%rip)\n.size ${function}, . - ${function}\n")
  string(APPEND pointers ".Lat_${function}: .quad \"${function}.${least}\"\n")
endforeach()
set(tables "")
set(choices "")
foreach(level IN LISTS LEVELS)
  string(MAKE_C_IDENTIFIER ${level} name)
  string(APPEND tables ".globl irg_functions_${name}\n.hidden irg_functions_${name}\nirg_functions_${name}:\n")
  foreach(function IN LISTS functions)
    string(APPEND tables ".quad \"${function}.${level}\"\n")
  endforeach()
  string(APPEND choices "  if (has(\"${level}\")) chosen = irg_functions_${name};\n")
  string(APPEND externs "extern \"C\" void* const irg_functions_${name}[];\n")
endforeach()

file(WRITE ${OUT} "// Written by cmake/compiled_choice.cmake.
#include <cstdlib>
#include <cstring>

extern \"C\" void* irg_functions[];
${externs}
namespace {

// Whether the processor has a level, and IRG_COMPILED_LEVEL does not name a lower one.
bool has(const char* level) {
  const char* const most = std::getenv(\"IRG_COMPILED_LEVEL\");
  if (most != nullptr && std::strcmp(level, most) > 0) return false;
  __builtin_cpu_init();
  if (std::strcmp(level, \"x86-64-v4\") == 0)
    return __builtin_cpu_supports(\"avx512f\") && __builtin_cpu_supports(\"avx512bw\") && __builtin_cpu_supports(\"avx512cd\") &&
           __builtin_cpu_supports(\"avx512dq\") && __builtin_cpu_supports(\"avx512vl\");
  if (std::strcmp(level, \"x86-64-v3\") == 0)
    return __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") && __builtin_cpu_supports(\"bmi\") &&
           __builtin_cpu_supports(\"bmi2\");
  if (std::strcmp(level, \"x86-64-v2\") == 0) return __builtin_cpu_supports(\"sse4.2\") && __builtin_cpu_supports(\"popcnt\");
  return true;
}

[[gnu::constructor(101)]] void choose() {
  void* const* chosen = nullptr;
${choices}
  for (int i = 0; chosen != nullptr && i < ${count}; ++i) irg_functions[i] = chosen[i];
}

}  // namespace

asm(R\"(
.text
${jumps}
.section .data.rel, \"aw\"
.p2align 3
.globl irg_functions
.hidden irg_functions
irg_functions:
${pointers}
.section .data.rel.ro, \"aw\"
.p2align 3
${tables}
.text
)\");
")
