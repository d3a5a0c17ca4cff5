#pragma once

#include <Eigen/Core>

namespace lacuna {

/// The inner loops of Eigen's products, which its factorisations call, too. They are compiled once, in
/// eigen_kernels.cpp, with full optimisation. Otherwise rooms that are compiled without optimisation would contain slow
/// copies, and the linker would use whichever copy comes first. The precompiled headers of the rooms include this file;
/// it affects only speed.
namespace kernels {

using Traits = Eigen::internal::gebp_traits<double, double>;
using Target = Eigen::internal::blas_data_mapper<double, Eigen::Index, Eigen::ColMajor, Eigen::Unaligned, 1>;
using Columns = Eigen::internal::const_blas_data_mapper<double, Eigen::Index, Eigen::ColMajor>;
using Rows = Eigen::internal::const_blas_data_mapper<double, Eigen::Index, Eigen::RowMajor>;

}  // namespace kernels
}  // namespace lacuna

/// `KIND` is `extern template` for declarations, `template` for the definitions.
#define LACUNA_EIGEN_KERNELS(KIND)                                                                                     \
  KIND struct Eigen::internal::gebp_kernel<double, double, Eigen::Index, lacuna::kernels::Target,                      \
                                           lacuna::kernels::Traits::mr, lacuna::kernels::Traits::nr, false, false>;    \
  KIND struct Eigen::internal::gemm_pack_lhs<double, Eigen::Index, lacuna::kernels::Columns,                           \
                                             lacuna::kernels::Traits::mr, lacuna::kernels::Traits::LhsProgress,        \
                                             lacuna::kernels::Traits::LhsPacket4Packing, Eigen::ColMajor>;             \
  KIND struct Eigen::internal::gemm_pack_lhs<double, Eigen::Index, lacuna::kernels::Rows, lacuna::kernels::Traits::mr, \
                                             lacuna::kernels::Traits::LhsProgress,                                     \
                                             lacuna::kernels::Traits::LhsPacket4Packing, Eigen::RowMajor>;             \
  KIND struct Eigen::internal::gemm_pack_rhs<double, Eigen::Index, lacuna::kernels::Columns,                           \
                                             lacuna::kernels::Traits::nr, Eigen::ColMajor>;                            \
  KIND struct Eigen::internal::gemm_pack_rhs<double, Eigen::Index, lacuna::kernels::Rows, lacuna::kernels::Traits::nr, \
                                             Eigen::RowMajor>;                                                         \
  KIND struct Eigen::internal::general_matrix_vector_product<Eigen::Index, double, lacuna::kernels::Columns,           \
                                                             Eigen::ColMajor, false, double, lacuna::kernels::Columns, \
                                                             false>;                                                   \
  KIND struct Eigen::internal::general_matrix_vector_product<                                                          \
      Eigen::Index, double, lacuna::kernels::Rows, Eigen::RowMajor, false, double, lacuna::kernels::Columns, false>;

LACUNA_EIGEN_KERNELS(extern template)
