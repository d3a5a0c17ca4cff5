#include "foundation/text/problem.h"
#include "kernels/kernels.h"
#include "kernels/levels.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <string>

namespace lacuna {

std::vector<const DenseKernels*> supported_kernels() {
  std::vector<const DenseKernels*> all = {lacuna_kernels_portable()};
#ifdef LACUNA_KERNELS_X86
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) all.push_back(lacuna_kernels_x86_64_v3());
#endif
  return all;
}

const DenseKernels& choose_kernels(const char* wanted) {
  const std::vector<const DenseKernels*> all = supported_kernels();
  if (wanted == nullptr || *wanted == '\0') return *all.back();
  std::vector<std::string> levels;
  for (const DenseKernels* one : all) {
    levels.emplace_back(one->level);
    if (levels.back() == wanted) return *one;
  }
  throw_problem({},
                fmt::format("environment variable LACUNA_KERNELS: no kernels \"{}\" for this processor; set it to {}, "
                            "or unset it to use the fastest",
                            wanted, fmt::join(levels, " or ")));
}

const DenseKernels& dense_kernels() {
  static const DenseKernels& chosen = choose_kernels(std::getenv("LACUNA_KERNELS"));
  return chosen;
}

}  // namespace lacuna
