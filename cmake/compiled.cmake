# irg::compiled: the heavy half, compiled once. What links it finds declarations in the same headers.
file(GLOB irg_compiled_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.cpp)
add_library(irg_compiled EXCLUDE_FROM_ALL ${irg_compiled_sources})
add_library(irg::compiled ALIAS irg_compiled)
target_link_libraries(irg_compiled PUBLIC irg)
target_compile_definitions(irg_compiled PRIVATE IRG_COMPILING PUBLIC IRG_COMPILED)
set_target_properties(irg_compiled PROPERTIES
  EXPORT_NAME compiled
  CXX_EXTENSIONS OFF
  CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON
  POSITION_INDEPENDENT_CODE ON
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
