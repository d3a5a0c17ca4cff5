# Settings that every target shares, and the three ways to add one.

option(LACUNA_TESTS "Build tests, benchmarks and generators" ON)
option(LACUNA_FUZZ "Build the fuzz targets (clang)" OFF)
option(LACUNA_UNITY "Compile the sources of large targets together: a quarter of the time for all of them, more for one" ON)
set(LACUNA_BATCH_OF_FOLDER "" CACHE STRING
  "Compile at most so many sources together, all of one folder: for who edits, as in the preset dev (default: 48 of any folder)")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
include(GNUInstallDirs)
include(lacuna_plugin)
set(LACUNA_PLUGIN_DIRECTORY lib/lacuna/plugins)  # of the build folder and of an installation

add_compile_options(-Wall -Wextra -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms on std::string in GCC 12 (its bugs 105329 and 105651); the sanitizers look for the true ones.
  add_compile_options(-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
# The same numbers from every build of one source: no contraction that depends on inlining.
add_compile_options(-ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Collects garbage from 600 MB on (kB here) instead of 128: a tenth of the time to compile, for 0.3 GB more memory.
  add_compile_options(--param=ggc-min-heapsize=600000)
endif()

# What a user installs: the program and its plugins.
add_custom_target(program)
# All plugin libraries of this project, the tests' faulty ones among them: the tests that run the program depend on them.
add_custom_target(all_plugins)
# The tests labelled `short`, with as much of the house as they need: what CI builds under the sanitizers.
add_custom_target(short_tests)
add_dependencies(short_tests all_plugins)

# Compiles the sources of a large target up to 48 at a time. Names in their anonymous namespaces must differ; where tests
# would all have a `kMass`, each has a namespace of its own file's name.
function(lacuna_compile_together target)
  if(NOT LACUNA_UNITY)
    return()
  elseif(LACUNA_BATCH_OF_FOLDER)
    lacuna_batch_by_folder(${target})
  else()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 48)
  endif()
endfunction()

# Batches of LACUNA_BATCH_OF_FOLDER neighbours in the list of sources, so that an edit compiles little else.
function(lacuna_batch_by_folder target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    string(MAKE_C_IDENTIFIER "at_${folder}" folder)
    list(APPEND ${folder} "${source}")
    list(LENGTH ${folder} count)
    math(EXPR batch "(${count} - 1) / ${LACUNA_BATCH_OF_FOLDER}")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${target}_${folder}_${batch}")
  endforeach()
endfunction()

# What is compiled quickly rather than to be quick.
function(lacuna_set_up_cold target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# A folder of platform/: a static library that sees platform/ as its include root.
#   PUBLIC   its headers that other rooms may include; tools/check_includes reads them here
#   SOURCES  default: those of the folder and of the folders in it
#   HEADERS  headers of others that most of its sources include, beyond those that all rooms share; compiled once for it
#   UNITY    a large room, compiled together
#   COLD     compiled in two thirds of the time. It reads files, writes text, or decides what is simulated next; the time
#            of a fit and of a diagnosis goes to the simulation and to Eigen's kernels (foundation/eigen_kernels.h).
function(lacuna_add_room name)
  cmake_parse_arguments(ARG "UNITY;COLD" "" "PUBLIC;SOURCES;LINKS;HEADERS" ${ARGN})
  if(NOT ARG_SOURCES)
    file(GLOB ARG_SOURCES CONFIGURE_DEPENDS *.cpp */*.cpp)
  endif()
  add_library(lacuna_${name} STATIC ${ARG_SOURCES})
  target_include_directories(lacuna_${name} PUBLIC ${PROJECT_SOURCE_DIR}/platform)
  target_link_libraries(lacuna_${name} PUBLIC ${ARG_LINKS})
  if(ARG_UNITY)
    lacuna_compile_together(lacuna_${name})
  endif()
  if(ARG_COLD)
    lacuna_set_up_cold(lacuna_${name})
  endif()
  if(ARG_HEADERS)
    target_precompile_headers(lacuna_${name} PRIVATE ${LACUNA_ROOM_HEADERS} ${ARG_HEADERS})
  elseif(ARG_COLD)
    target_precompile_headers(lacuna_${name} REUSE_FROM lacuna_cold_headers)
  else()
    target_precompile_headers(lacuna_${name} REUSE_FROM lacuna_room_headers)
  endif()
endfunction()

# What every test program is compiled with.
function(lacuna_set_up_test name)
  target_link_libraries(${name} PRIVATE GTest::gmock GTest::gtest_main Eigen3::Eigen fmt::fmt)
  lacuna_set_up_cold(${name})
endfunction()

# A test program of GoogleTest; each TEST is a test of ctest. Its label is one of
#   short    seconds even under sanitizers, and worth it: rooms that handle memory by hand, threads or foreign input
#   medium   the others (the default); report and app, fits and diagnoses, and physics that the engine's own tests walk
#            through too, need not be built twice in CI
#   long     half a minute and more; begun first
# UNITY: large, and no two of its sources use one name for two things; compiled together.
function(lacuna_add_test name)
  cmake_parse_arguments(ARG "UNITY" "LABELS;TIMEOUT" "SOURCES;LINKS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)  # s
  endif()
  if(NOT ARG_LABELS)
    set(ARG_LABELS medium)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  lacuna_set_up_test(${name})
  target_precompile_headers(${name} REUSE_FROM lacuna_test_headers)
  if(ARG_UNITY)
    lacuna_compile_together(${name})
  endif()
  target_link_libraries(${name} PRIVATE ${ARG_LINKS})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE
    LACUNA_SOURCE_DIRECTORY="${PROJECT_SOURCE_DIR}" LACUNA_BINARY_DIRECTORY="${CMAKE_BINARY_DIR}")
  if(ARG_LABELS STREQUAL "short")
    add_dependencies(short_tests ${name})
  endif()
  set(cost 0)
  if(ARG_LABELS STREQUAL "long")
    set(cost 1000)
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${ARG_LABELS} TIMEOUT ${ARG_TIMEOUT} COST ${cost})
endfunction()
