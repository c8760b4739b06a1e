# What irg's own programs share; nothing here reaches the projects that use irg.

# irg_own: link it privately to get the library and the strict warnings, as errors.
add_library(irg_own INTERFACE)
find_package(Threads REQUIRED)
include(CheckCXXSourceCompiles)
target_link_libraries(irg_own INTERFACE irg::irg Threads::Threads)
target_compile_options(irg_own INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast -Wdouble-promotion -Werror
  # g++ 12 sees overlapping copies in std::string's own operator+ (its bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

# A compiler cache asks that precompiled headers do not hold the time they were made.
target_compile_options(irg_own INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")

# irg_models: defines IRG_MODELS_DIR where there is a folder of models, which are not part of the project. What needs them
# says so and skips when it is undefined.
add_library(irg_models INTERFACE)
get_filename_component(irg_models_dir ${PROJECT_SOURCE_DIR}/../shared/models ABSOLUTE)
if(EXISTS ${irg_models_dir})
  target_compile_definitions(irg_models INTERFACE IRG_MODELS_DIR="${irg_models_dir}")
elseif(IRG_BUILD_TESTS OR IRG_BUILD_BENCH)
  message(STATUS "irg: tests and benchmarks on larger models skipped: no folder of models found")
endif()

# irg_optional(NAME HEADER [SUFFIX folder] [LIBRARIES ...] [COMPILED header...]): makes the target irg_NAME, which brings in
# a library that tests or benchmarks compare with and defines IRG_HAVE_NAME; where it is absent, says so aloud and leaves the
# target empty. COMPILED names headers that have to compile, for a library whose packages do not ask for all they need.
function(irg_optional name header)
  add_library(irg_${name} INTERFACE)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "SUFFIX" "LIBRARIES;COMPILED")
  find_path(IRG_${name}_INCLUDE ${header} PATH_SUFFIXES ${arg_SUFFIX})
  mark_as_advanced(IRG_${name}_INCLUDE)
  set(found ${IRG_${name}_INCLUDE})
  foreach(library IN LISTS arg_LIBRARIES)
    find_library(IRG_${name}_LIBRARY_${library} ${library})
    mark_as_advanced(IRG_${name}_LIBRARY_${library})
    list(APPEND found ${IRG_${name}_LIBRARY_${library}})
  endforeach()
  if(found MATCHES "NOTFOUND")
    message(STATUS "irg: what uses ${name} skipped: ${header} ${arg_LIBRARIES} not found")
    return()
  endif()
  list(POP_FRONT found include)
  if(arg_COMPILED)
    set(CMAKE_REQUIRED_INCLUDES ${include})
    set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
    list(TRANSFORM arg_COMPILED REPLACE "(.+)" "#include <\\1>" OUTPUT_VARIABLE lines)
    list(JOIN lines "\n" lines)
    check_cxx_source_compiles("${lines}\nint main() {}" IRG_${name}_COMPILES)
    if(NOT IRG_${name}_COMPILES)
      unset(IRG_${name}_COMPILES CACHE)  # asked again when packages may have come
      message(STATUS "irg: what uses ${name} skipped: its headers do not compile, a package is missing")
      return()
    endif()
  endif()
  target_include_directories(irg_${name} SYSTEM INTERFACE ${include})
  target_link_libraries(irg_${name} INTERFACE ${found})
  target_compile_definitions(irg_${name} INTERFACE IRG_HAVE_${name}=1)
endfunction()
