#pragma once

#include "kernels/kernels.h"

/// One function a level: the only symbols of a level that other objects see (CMakeLists.txt hides the others).
extern "C" {
const lacuna::DenseKernels* lacuna_kernels_portable();
const lacuna::DenseKernels* lacuna_kernels_x86_64_v3();
}
