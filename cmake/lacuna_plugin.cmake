# For authors of plugins, and for Lacuna's own:
#
#   lacuna_add_plugin(propeller_drag propeller_drag.cpp)
#
# makes the library lib/lacuna/plugins/propeller_drag.so of the build folder from the given sources: hidden symbols,
# the interface and nothing else of Lacuna. NOT_INSTALLED keeps it out of `cmake --install`.
function(lacuna_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "NOT_INSTALLED" "" "")
  add_library(${name} MODULE ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE lacuna::interface)
  target_compile_definitions(${name} PRIVATE LACUNA_BUILD_ID="${PROJECT_VERSION}")
  # The same numbers from every build of one source: no contraction that depends on inlining.
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  set_target_properties(${name} PROPERTIES
    PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/lacuna/plugins)
  if(TARGET all_plugins)
    add_dependencies(all_plugins ${name})
  endif()
  if(NOT ARG_NOT_INSTALLED)
    if(TARGET program)
      add_dependencies(program ${name})
    endif()
    if(TARGET lacuna_plugin_headers)  # in Lacuna's own build
      target_precompile_headers(${name} REUSE_FROM lacuna_plugin_headers)
    endif()
    install(TARGETS ${name} LIBRARY DESTINATION lib/lacuna/plugins)
  endif()
endfunction()

# After `enable_testing()`:
#
#   lacuna_test_plugin(propeller_drag)
#
# makes a test of ctest, propeller_drag_conformance: what `lacuna plugins check` tells of the library. SAMPLE names a
# file of the format that the plugin reads, in the source folder; with CARRY_OUT a target carries a test out, by which a
# rig moves.
function(lacuna_test_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "CARRY_OUT" "SAMPLE" "")
  set(program ${LACUNA_PROGRAM})
  if(TARGET lacuna)  # in Lacuna's own build
    set(program $<TARGET_FILE:lacuna>)
  endif()
  set(options "")
  if(ARG_SAMPLE)
    list(APPEND options --sample ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_SAMPLE})
  endif()
  if(ARG_CARRY_OUT)
    list(APPEND options --carry-out)
  endif()
  add_test(NAME ${name}_conformance COMMAND ${program} plugins check $<TARGET_FILE:${name}> ${options})
endfunction()
