# irg::compiled for several levels of x86-64. Each level is compiled whole and linked into one object, in which everything
# but the library's functions is local, also what the standard library's templates were compiled to: code for a newer processor is never
# taken for another's. These get names of their own for each level; under their usual names stand jumps through pointers
# that are set at start. Needs ELF, the binutils and a compiler with the options of g++.
set(irg_known_levels x86-64 x86-64-v2 x86-64-v3 x86-64-v4)
set(irg_level_objects)
list(GET IRG_COMPILED_LEVELS 0 irg_least_level)
foreach(level IN LISTS IRG_COMPILED_LEVELS)
  if(NOT level IN_LIST irg_known_levels)
    message(FATAL_ERROR "irg: IRG_COMPILED_LEVELS names ${level}; these are known: ${irg_known_levels}")
  endif()
  add_library(irg_compiled_${level} OBJECT EXCLUDE_FROM_ALL ${irg_compiled_sources})
  irg_compile_library(irg_compiled_${level})
  target_compile_options(irg_compiled_${level} PRIVATE -march=${level}
    $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  set(object ${CMAKE_CURRENT_BINARY_DIR}/irg_compiled_${level}.o)
  add_custom_command(OUTPUT ${object} ${object}.functions
    COMMAND ${CMAKE_COMMAND} -DLEVEL=${level} -DOUT=${object} "-DOBJECTS=$<JOIN:$<TARGET_OBJECTS:irg_compiled_${level}>,$<SEMICOLON>>"
      -DLINKER=${CMAKE_LINKER} -DNM=${CMAKE_NM} -DOBJCOPY=${CMAKE_OBJCOPY}
      -P ${CMAKE_CURRENT_LIST_DIR}/compiled_level.cmake
    DEPENDS irg_compiled_${level} $<TARGET_OBJECTS:irg_compiled_${level}> ${CMAKE_CURRENT_LIST_DIR}/compiled_level.cmake
    VERBATIM)
  list(APPEND irg_level_objects ${object})
endforeach()

set(irg_functions ${CMAKE_CURRENT_BINARY_DIR}/irg_compiled_choice.cpp)
add_custom_command(OUTPUT ${irg_functions}
  COMMAND ${CMAKE_COMMAND} "-DLEVELS=${IRG_COMPILED_LEVELS}" -DOUT=${irg_functions}
    -DFUNCTIONS=${CMAKE_CURRENT_BINARY_DIR}/irg_compiled_${irg_least_level}.o.functions
    -P ${CMAKE_CURRENT_LIST_DIR}/compiled_choice.cmake
  DEPENDS ${irg_level_objects} ${CMAKE_CURRENT_LIST_DIR}/compiled_choice.cmake
  VERBATIM)
set_source_files_properties(${irg_level_objects} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
add_library(irg_compiled EXCLUDE_FROM_ALL ${irg_functions} ${irg_level_objects})
