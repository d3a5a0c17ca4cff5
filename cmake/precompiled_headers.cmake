# Headers that nearly every source includes, compiled once for all rooms, once for cold ones, once for all plugins and
# once for all tests.
# What a source uses it still includes itself; clang-tidy compiles without these.

add_library(lacuna_room_headers STATIC cmake/headers.cpp)
target_link_libraries(lacuna_room_headers PRIVATE Eigen3::Eigen fmt::fmt)
target_include_directories(lacuna_room_headers PRIVATE ${PROJECT_SOURCE_DIR}/platform)
set(LACUNA_ROOM_HEADERS
  <algorithm> <filesystem> <functional> <map> <optional> <string> <vector> <Eigen/Core> <fmt/format.h>
  <foundation/eigen_kernels.h>)
target_precompile_headers(lacuna_room_headers PRIVATE ${LACUNA_ROOM_HEADERS})

add_library(lacuna_cold_headers STATIC cmake/headers.cpp)
target_link_libraries(lacuna_cold_headers PRIVATE Eigen3::Eigen fmt::fmt)
target_include_directories(lacuna_cold_headers PRIVATE ${PROJECT_SOURCE_DIR}/platform)
lacuna_set_up_cold(lacuna_cold_headers)
target_precompile_headers(lacuna_cold_headers PRIVATE ${LACUNA_ROOM_HEADERS})

# Compiled as lacuna_add_plugin compiles a plugin, or its users could not take it.
add_library(lacuna_plugin_headers STATIC cmake/headers.cpp)
target_link_libraries(lacuna_plugin_headers PRIVATE lacuna_interface)
target_compile_definitions(lacuna_plugin_headers PRIVATE LACUNA_BUILD_ID="${PROJECT_VERSION}")
set_target_properties(lacuna_plugin_headers PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
target_precompile_headers(lacuna_plugin_headers PRIVATE <lacuna/plugin.h> <algorithm> <cmath> <Eigen/Geometry>)

if(LACUNA_TESTS)
  add_executable(lacuna_test_headers cmake/headers.cpp)
  lacuna_set_up_test(lacuna_test_headers)
  target_precompile_headers(lacuna_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h> <Eigen/Core> <fmt/format.h>)
endif()
