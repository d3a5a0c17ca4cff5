include(${CMAKE_CURRENT_LIST_DIR}/step.cmake)

file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/prefix)
step("" ${CMAKE_COMMAND} --install ${LACUNA_BUILD} --prefix ${prefix})
build_project(${CMAKE_CURRENT_LIST_DIR}/project ${WORK}/build)

set(lacuna ${prefix}/bin/lacuna)
set(plugins --plugin-path ${WORK}/build/lib/lacuna/plugins)
step("effect +propeller_drag +Drag of a propeller" ${lacuna} plugins list ${plugins})
step("effect +coulomb_friction" ${lacuna} plugins list)
step("1 of 1 component passed" ${lacuna} plugins check ${WORK}/build/lib/lacuna/plugins/propeller_drag.so)
step("N\\*m\\*s\\^2/rad\\^2.*build +1\\.2\\.3" ${lacuna} plugins show propeller_drag --verbose ${plugins})
step(": ok" ${lacuna} check ${LACUNA_SOURCE}/experiments/servo-pendulum.toml ${plugins}
  --set "model.effects=[{effect=\"propeller_drag\",where=\"joint.hinge\",start={drag=0.01}}]")

# Installed into Lacuna's own prefix it is found without being named.
step("" ${CMAKE_COMMAND} --install ${WORK}/build --prefix ${prefix})
step("effect +propeller_drag" ${lacuna} plugins list)
