# MuJoCo, another engine: a target on it, and a test of accelerations against it. Debian: libmujoco-dev.
macro(lacuna_find_mujoco)
  find_package(mujoco QUIET)
  if(TARGET mujoco::mujoco)
    # Debian's package names a folder of a library that only MuJoCo's own source includes, and does not bring it.
    set_property(TARGET mujoco::mujoco PROPERTY INTERFACE_INCLUDE_DIRECTORIES)
  endif()
endmacro()
