# The vector instructions of the processor that Lacuna is built on: with AVX2 and FMA the linear algebra of a diagnosis
# takes less than half the time. Plugins may be compiled for another processor, and so are the libraries that take Eigen's
# types: their layout stays that of 16 bytes, which wider vectors would change.
include(CheckCXXSourceRuns)

set(CMAKE_REQUIRED_QUIET ON)
check_cxx_source_runs(
  "int main() { return __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") && __builtin_cpu_supports(\"bmi2\") ? 0 : 1; }"
  LACUNA_HAS_AVX2)
unset(CMAKE_REQUIRED_QUIET)

if(LACUNA_HAS_AVX2)
  set(processor -march=x86-64-v3)
endif()
set(LACUNA_PROCESSOR "${processor}" CACHE STRING "Option of the compiler that names the processor; empty: its default")
add_compile_options(${LACUNA_PROCESSOR})
add_compile_definitions(EIGEN_MAX_ALIGN_BYTES=16)
