#include "foundation/eigen_kernels.h"

LACUNA_EIGEN_KERNELS(template)
