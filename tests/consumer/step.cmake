# step(EXPECTED COMMAND ...): the command must succeed, and what it prints, which is left in `output`, must hold what is
# expected.
function(step expected)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  list(JOIN ARGN " " command)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${command}\nended with ${code}:\n${output}")
  endif()
  if(NOT output MATCHES "${expected}")
    message(FATAL_ERROR "${command}\ndid not print \"${expected}\":\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# Configures and builds a project by itself, with the installed package.
function(build_project source build)
  step("" ${CMAKE_COMMAND} -S ${source} -B ${build} -G ${GENERATOR}
    -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
    -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_FIND_PACKAGE_NO_PACKAGE_REGISTRY=ON)
  step("" ${CMAKE_COMMAND} --build ${build})
endfunction()
