#define Eigen Eigen_portable
#include "kernels/one_level.h"

const lacuna::DenseKernels* lacuna_kernels_portable() {
  static constexpr lacuna::DenseKernels kKernels = lacuna::kernels_of("portable");
  return &kKernels;
}
