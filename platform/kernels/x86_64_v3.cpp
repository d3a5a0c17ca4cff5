#define Eigen Eigen_x86_64_v3
#include "kernels/one_level.h"

const lacuna::DenseKernels* lacuna_kernels_x86_64_v3() {
  static constexpr lacuna::DenseKernels kKernels = lacuna::kernels_of("x86-64-v3");
  return &kKernels;
}
