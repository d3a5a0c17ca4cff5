# find_package(lacuna) for authors of plugins: the target lacuna::interface and the function lacuna_add_plugin.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/lacuna-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/lacuna_plugin.cmake)
get_filename_component(LACUNA_PROGRAM ${CMAKE_CURRENT_LIST_DIR}/../../../bin/lacuna ABSOLUTE)
