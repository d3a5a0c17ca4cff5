# Each step must succeed; what a step prints must hold what is expected.
function(step expected)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  list(JOIN ARGN " " command)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${command}\nended with ${code}:\n${output}")
  endif()
  if(NOT output MATCHES "${expected}")
    message(FATAL_ERROR "${command}\ndid not print \"${expected}\":\n${output}")
  endif()
endfunction()

# The guide shows this project as it is.
file(READ ${LACUNA_SOURCE}/docs/how-to/write-a-plugin.md guide)
foreach(file CMakeLists.txt propeller_drag.cpp)
  file(READ ${CMAKE_CURRENT_LIST_DIR}/project/${file} content)
  string(FIND "${guide}" "${content}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "docs/how-to/write-a-plugin.md shows another ${file} than tests/consumer/project; copy it")
  endif()
endforeach()

file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/prefix)
step("" ${CMAKE_COMMAND} --install ${LACUNA_BUILD} --prefix ${prefix})
step("" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${WORK}/build -G ${GENERATOR}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
  -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_FIND_PACKAGE_NO_PACKAGE_REGISTRY=ON)
step("" ${CMAKE_COMMAND} --build ${WORK}/build)

set(lacuna ${prefix}/bin/lacuna)
set(plugins --plugin-path ${WORK}/build/lib/lacuna/plugins)
step("effect +propeller_drag +Drag of a propeller" ${lacuna} plugins list ${plugins})
step("effect +coulomb_friction" ${lacuna} plugins list)
step("N\\*m\\*s\\^2/rad\\^2.*build +1\\.2\\.3" ${lacuna} plugins show propeller_drag ${plugins})
step(": ok" ${lacuna} check ${LACUNA_SOURCE}/experiments/servo-pendulum.toml ${plugins}
  --set "model.effects=[{effect=\"propeller_drag\",where=\"joint.hinge\",start={drag=0.01}}]")

# Installed into Lacuna's own prefix it is found without being named.
step("" ${CMAKE_COMMAND} --install ${WORK}/build --prefix ${prefix})
step("effect +propeller_drag" ${lacuna} plugins list)
