// Dense kernels of each level beside Eigen as every other source is compiled, in turns: GFlop/s, medians.
#include "kernels/dense.h"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace lacuna {
namespace {

constexpr int kRepetitions = 15;
constexpr double kLeastFlops = 4e7;  // of one repetition
constexpr Eigen::Index kColumns = 61;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A way to do one kind of work.
struct Way {
  std::string name;
  std::function<void()> work;
};

/// Medians of GFlop/s, the ways in turns.
std::vector<double> speeds(const std::vector<Way>& ways, double flops) {
  const int times = 1 + static_cast<int>(kLeastFlops / flops);
  std::vector<std::vector<double>> all(ways.size());
  for (int repetition = 0; repetition < kRepetitions; ++repetition)
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const double begin = processor_seconds();
      for (int time = 0; time < times; ++time) ways[i].work();
      all[i].push_back(1e-9 * flops * times / (processor_seconds() - begin));
    }
  std::vector<double> medians;
  for (std::vector<double>& one : all) {
    std::nth_element(one.begin(), one.begin() + kRepetitions / 2, one.end());
    medians.push_back(one[kRepetitions / 2]);
  }
  return medians;
}

void print_row(const std::string& what, Eigen::Index size, const std::vector<Way>& ways, double flops) {
  fmt::print("{:<10} {:>4}", what, size);
  for (const double speed : speeds(ways, flops)) fmt::print(" {:>10.1f}", speed);
  fmt::print("\n");
}

class Bench {
 public:
  explicit Bench(Eigen::Index size)
      : size_(size),
        a_(Eigen::MatrixXd::Random(size, size)),
        b_(Eigen::MatrixXd::Random(size, size)),
        symmetric_(a_ * a_.transpose() + Eigen::MatrixXd::Identity(size, size)),
        lower_(symmetric_.llt().matrixL()),
        columns_(Eigen::MatrixXd::Random(size, kColumns)),
        result_(size, size) {}

  void run() {
    const double n = static_cast<double>(size_), columns = static_cast<double>(kColumns);
    print_row("product", size_,
              ways([&] { result_.noalias() = a_ * b_; },
                   [&](const DenseKernels& kernels) {
                     result_.setZero();
                     kernels.add_product(1.0, dense::operand(a_), dense::operand(b_), dense::view(result_));
                   }),
              2.0 * n * n * n);
    print_row("square", size_,
              ways([&] { result_.selfadjointView<Eigen::Lower>().rankUpdate(columns_, 1e-9); },
                   [&](const DenseKernels& kernels) {
                     kernels.add_square(1e-9, dense::operand(columns_), dense::view(result_));
                   }),
              n * n * columns);
    print_row("Cholesky", size_,
              ways([&] { result_ = symmetric_.llt().matrixLLT(); },
                   [&](const DenseKernels& kernels) {
                     result_ = symmetric_;
                     kernels.factorize(dense::view(result_));
                   }),
              n * n * n / 3.0);
    print_row("solve", size_,
              ways([&] { solution_ = lower_.triangularView<Eigen::Lower>().solve(columns_); },
                   [&](const DenseKernels& kernels) {
                     solution_ = columns_;
                     kernels.solve(dense::operand(lower_), dense::view(solution_));
                   }),
              n * n * columns);
  }

 private:
  static std::vector<Way> ways(const std::function<void()>& inline_eigen,
                               const std::function<void(const DenseKernels&)>& by_kernels) {
    std::vector<Way> all = {{"inline", inline_eigen}};
    for (const DenseKernels* one : supported_kernels()) all.push_back({one->level, [=] { by_kernels(*one); }});
    return all;
  }

  Eigen::Index size_;
  Eigen::MatrixXd a_, b_, symmetric_, lower_, columns_, result_, solution_;
};

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
  fmt::print("{:<15} {:>10}", "GFlop/s", "Eigen");
  for (const lacuna::DenseKernels* one : lacuna::supported_kernels()) fmt::print(" {:>10}", one->level);
  fmt::print("\n");
  std::vector<Eigen::Index> sizes = {8, 32, 120, 240, 600};
  if (argc > 1) sizes = {std::max(1, std::atoi(argv[1]))};
  for (const Eigen::Index size : sizes) lacuna::Bench(size).run();
}
