# irg::compiled: the heavy half, compiled once. What links it finds declarations in the same headers.
set(IRG_COMPILED_LEVELS "" CACHE STRING
  "Processors that irg::compiled is built for, the least first, as x86-64;x86-64-v3;x86-64-v4: each program chooses at start. Empty: for the one that the compiler's flags name")

set(IRG_COMPILED_OPTIMISATION "" CACHE STRING "How irg::compiled is optimised, if not as the build type says")

file(GLOB irg_compiled_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.cpp)

function(irg_compile_library target)
  target_link_libraries(${target} PUBLIC irg)
  target_compile_definitions(${target} PRIVATE IRG_COMPILING)
  target_compile_options(${target} PRIVATE ${IRG_COMPILED_OPTIMISATION})
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON
    POSITION_INDEPENDENT_CODE ON)
endfunction()

if(IRG_COMPILED_LEVELS)
  include(${CMAKE_CURRENT_LIST_DIR}/compiled_levels.cmake)
else()
  add_library(irg_compiled EXCLUDE_FROM_ALL ${irg_compiled_sources})
endif()
if(IRG_BUILD_COMPILED)
  set_target_properties(irg_compiled PROPERTIES EXCLUDE_FROM_ALL OFF)
endif()
add_library(irg::compiled ALIAS irg_compiled)
irg_compile_library(irg_compiled)
target_compile_definitions(irg_compiled PUBLIC IRG_COMPILED)
set_target_properties(irg_compiled PROPERTIES
  EXPORT_NAME compiled
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
