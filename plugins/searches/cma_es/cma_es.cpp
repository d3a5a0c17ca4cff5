#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/generational_search.h>
#include <lacuna/plugin.h>
#include <lacuna/search_strategy.h>

#include "cma_constants.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lacuna {

/// Evolution strategy with covariance matrix adaptation after N. Hansen, "The CMA evolution strategy: a tutorial"
/// (2016, arXiv:1604.00772), with weights on the better half only. Makes its own children: the breeder is not used. All
/// scores count in full, because the better half is not known before the generation ends.
class CmaEs : public SearchStrategy {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` for a population of 1.
  std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const override;
};

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum Parameter : std::size_t { kPopulation, kGenerations, kSigma };

constexpr double kNarrowest = 1e-15;  // step size, in ranges of a gene: smaller steps are lost in rounding
constexpr double kLeastVariance = 1e-30;

/// Distance between the quartiles of the finite scores: the scale of differences in this generation.
double spread(const std::vector<ScoredIndividual>& told) {
  std::vector<double> finite;
  for (const ScoredIndividual& one : told)
    if (std::isfinite(one.score)) finite.push_back(one.score);
  if (finite.empty()) return 0.0;
  std::sort(finite.begin(), finite.end());
  return finite[3 * (finite.size() - 1) / 4] - finite[(finite.size() - 1) / 4];
}

/// Genes run from 0 to 1 here; symbols are those of the tutorial.
class CmaSearch : public GenerationalSearch {
 public:
  CmaSearch(const SearchTask& task, std::size_t population, std::size_t generations, double sigma)
      : GenerationalSearch(task, generations),
        constants_(task.layout.size(), population),
        lambda_(static_cast<Index>(population)),
        n_(static_cast<Index>(task.layout.size())),
        mean_(VectorXd::Constant(n_, 0.5)),
        sigma_(sigma),
        covariance_(MatrixXd::Identity(n_, n_)),
        path_c_(VectorXd::Zero(n_)),
        path_sigma_(VectorXd::Zero(n_)) {
    if (!task.seeds.empty()) mean_ = encoded(task.seeds.front());
  }

 private:
  std::vector<Individual> do_ask() override {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(covariance_);
    axes_ = solver.eigenvectors();
    lengths_ = solver.eigenvalues().cwiseMax(kLeastVariance).cwiseSqrt();
    steps_.resize(n_, lambda_);
    std::vector<Individual> individuals;
    for (Index k = 0; k < lambda_; ++k) {
      RandomStream random = stream(static_cast<std::size_t>(k));
      VectorXd z(n_);
      for (double& value : z) value = random.normal();
      steps_.col(k) = axes_ * lengths_.cwiseProduct(z);
      // A seed is also evaluated itself, so that a known solution is never lost.
      if (k == 0 && generation() == 0 && !task().seeds.empty()) steps_.col(k).setZero();
      individuals.push_back({0, decoded(mean_ + sigma_ * steps_.col(k)), {}});
    }
    return individuals;
  }

  void do_tell(std::vector<ScoredIndividual> told) override {
    if (std::any_of(told.begin(), told.end(), [](const auto& one) { return std::isfinite(one.score); }))
      adapt(ranking(told));
    kept().insert(kept().end(), std::make_move_iterator(told.begin()), std::make_move_iterator(told.end()));
    std::sort(kept().begin(), kept().end(), better);
    kept().resize(std::min(kept().size(), static_cast<std::size_t>(constants_.weights.size())));
  }

  /// Best first. A point beyond the bounds was evaluated at its nearest point within them; its rank is that of a score
  /// increased by the generation's spread for each squared step outside.
  std::vector<Index> ranking(const std::vector<ScoredIndividual>& told) const {
    const double step = sigma_ * std::sqrt(covariance_.trace() / static_cast<double>(n_));
    const double weight = spread(told) / (step * step);
    VectorXd scores(lambda_);
    for (Index k = 0; k < lambda_; ++k) {
      const VectorXd x = mean_ + sigma_ * steps_.col(k);
      const double outside = (x - x.cwiseMax(0.0).cwiseMin(1.0)).squaredNorm();
      scores(k) = told[static_cast<std::size_t>(k)].score + weight * outside;
    }
    std::vector<Index> order(static_cast<std::size_t>(lambda_));
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return scores(a) < scores(b); });
    return order;
  }

  /// The tutorial's equations 41 to 47.
  void adapt(const std::vector<Index>& order) {
    const CmaConstants& c = constants_;
    const auto mu = c.weights.size();
    MatrixXd selected(n_, mu);
    for (Index i = 0; i < mu; ++i) selected.col(i) = steps_.col(order[static_cast<std::size_t>(i)]);
    const VectorXd step = selected * c.weights;
    mean_ += sigma_ * step;

    const VectorXd whitened = axes_ * (axes_.transpose() * step).cwiseQuotient(lengths_);
    path_sigma_ = (1.0 - c.c_sigma) * path_sigma_ + std::sqrt(c.c_sigma * (2.0 - c.c_sigma) * c.mu_eff) * whitened;
    const double settled = std::sqrt(1.0 - std::pow(1.0 - c.c_sigma, 2.0 * (generation() + 1)));
    const bool moderate = path_sigma_.norm() / settled < (1.4 + 2.0 / (static_cast<double>(n_) + 1.0)) * c.chi_n;
    path_c_ *= 1.0 - c.c_c;
    if (moderate) path_c_ += std::sqrt(c.c_c * (2.0 - c.c_c) * c.mu_eff) * step;

    const double kept_back = moderate ? 0.0 : c.c_1 * c.c_c * (2.0 - c.c_c);
    covariance_ *= 1.0 + kept_back - c.c_1 - c.c_mu;
    covariance_ += c.c_1 * path_c_ * path_c_.transpose();
    covariance_ += c.c_mu * selected * c.weights.asDiagonal() * selected.transpose();
    covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();

    sigma_ *= std::exp(c.c_sigma / c.d_sigma * (path_sigma_.norm() / c.chi_n - 1.0));
    sigma_ = std::clamp(sigma_, kNarrowest, std::max(kNarrowest, 1.0 / lengths_.maxCoeff()));
  }

  VectorXd encoded(const Genome& genome) const {
    VectorXd x(n_);
    for (Index i = 0; i < n_; ++i) {
      const Gene& gene = task().layout.genes[static_cast<std::size_t>(i)];
      const double range = gene.upper - gene.lower;
      x(i) = range > 0.0 ? (genome[static_cast<std::size_t>(i)] - gene.lower) / range : 0.5;
    }
    return x;
  }

  Genome decoded(const VectorXd& x) const {
    Genome genome;
    for (Index i = 0; i < n_; ++i) {
      const Gene& gene = task().layout.genes[static_cast<std::size_t>(i)];
      const double value = std::clamp(gene.lower + x(i) * (gene.upper - gene.lower), gene.lower, gene.upper);
      genome.push_back(gene.kind == GeneKind::integer ? std::round(value) : value);
    }
    return genome;
  }

  void do_save(SearchStateWriter& state) const override {
    state.add(sigma_);
    for (const auto& numbers : {mean_, path_c_, path_sigma_}) state.add_all({numbers.data(), numbers.data() + n_});
    state.add_all({covariance_.data(), covariance_.data() + n_ * n_});
  }

  void do_load(SearchStateReader& state) override {
    const auto n = static_cast<std::size_t>(n_);
    sigma_ = state.next();
    for (VectorXd* numbers : {&mean_, &path_c_, &path_sigma_}) *numbers = VectorXd::Map(state.next(n).data(), n_);
    covariance_ = MatrixXd::Map(state.next(n * n).data(), n_, n_);
  }

  CmaConstants constants_;
  Index lambda_;
  Index n_;
  VectorXd mean_;
  double sigma_;
  MatrixXd covariance_;
  VectorXd path_c_;
  VectorXd path_sigma_;
  // Of the current generation.
  MatrixXd axes_;     // B
  VectorXd lengths_;  // the diagonal of D
  MatrixXd steps_;    // y, one column per individual
};

std::size_t default_population(std::size_t genes) {
  return 4 + static_cast<std::size_t>(3.0 * std::log(static_cast<double>(genes)));
}

}  // namespace

std::string CmaEs::summary() const { return "CMA-ES: samples a normal distribution that it adapts to the better half"; }

ParameterDeclarations CmaEs::parameters() const {
  return {{"population", "1", 0.0, 0.0, 1e6, Scale::linear, "Individuals per generation; 0: 4 + 3 ln n"},
          {"generations", "1", 130.0, 1.0, 1e6, Scale::linear, "Generations"},
          {"sigma0", "1", 0.3, 1e-6, 1.0, Scale::logarithmic, "First step size, as a share of the range"}};
}

std::unique_ptr<Search> CmaEs::begin(const SearchTask& task, std::span<const double> parameters) const {
  const ParameterDeclarations declared = this->parameters();
  std::size_t population = count_parameter(declared[kPopulation], parameters[kPopulation]);
  if (population == 1) throw Error("CMA-ES needs a population of at least 2; leave it 0 for 4 + 3 ln n");
  if (population == 0) population = default_population(task.layout.size());
  return std::make_unique<CmaSearch>(
      task, population, count_parameter(declared[kGenerations], parameters[kGenerations]), parameters[kSigma]);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::SearchStrategy, lacuna::CmaEs>("cma_es"))
