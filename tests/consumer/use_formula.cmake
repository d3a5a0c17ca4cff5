# `lacuna plugins new effect` writes a plugin from the formula that a diagnosis might propose; built by itself and placed
# in the model it brings the error down to the noise floor. The truth is the guide's propeller_drag, written by hand.
include(${CMAKE_CURRENT_LIST_DIR}/step.cmake)

set(lacuna ${WORK}/prefix/bin/lacuna)
set(bench ${WORK}/formula)
file(REMOVE_RECURSE ${bench})
file(COPY ${CMAKE_CURRENT_LIST_DIR}/formula/bench.toml ${LACUNA_SOURCE}/experiments/robots/servo-pendulum.toml
  DESTINATION ${bench})

step("c_v_abs_v +-0.013 +N\\*m\\*s\\^2/rad\\^2" ${lacuna} plugins new effect water_drag
  --formula "-0.013*v*abs(v)" --into ${bench})
step("" ${lacuna} plugins new effect mixture --into ${bench}
  --formula "-0.02*v - 0.1*sgn(v)*q^2 + 0.05*sin(3*q)")
foreach(effect water_drag mixture)
  build_project(${bench}/${effect} ${bench}/${effect}/build)
  step("tau = c_" ${lacuna} plugins show ${effect} --plugin-path ${bench}/${effect}/build/lib/lacuna/plugins)
endforeach()

set(rest --plugin-path ${bench}/water_drag/build/lib/lacuna/plugins --db ${bench}/bench.db)
foreach(seed 3 4)
  step("trial-" ${lacuna} trial ${bench}/bench.toml ${rest}
    --test "multisine motor 0.8 N*m 0.3-2 Hz 6 s seed ${seed}")
endforeach()
step("held out" ${lacuna} trial ${bench}/bench.toml ${rest} --holdout
  --test "multisine motor 0.8 N*m 0.3-2 Hz 6 s seed 5")

# Root mean square error on the trial held out, as a multiple of the noise floor.
function(held_out_error result)
  step("" ${lacuna} compare ${bench}/bench.toml ${rest} --json=${bench}/compare.json)
  file(READ ${bench}/compare.json json)
  string(JSON held_out GET "${json}" pooled 1 held_out)
  string(JSON error GET "${json}" pooled 1 times_floor)
  if(NOT held_out)
    message(FATAL_ERROR "compare --json has no held-out channel where it is expected:\n${json}")
  endif()
  set(${result} ${error} PARENT_SCOPE)
endfunction()

held_out_error(without)
step("c_v_abs_v" ${lacuna} add ${bench}/bench.toml water_drag --where joint.hinge ${rest})
held_out_error(with)
if(without LESS 20 OR with GREATER 1.3)
  message(FATAL_ERROR "the error is ${without} times the floor without the formula and ${with} times with it; "
    "expected are more than 20 and at most 1.3")
endif()
message("${without} times the floor without the formula, ${with} times with it")
