#include "diagnosis/noise/contact_doubt.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kSofter = 0.8, kHarder = 1.25;  ///< of a contact's stiffness, and one over that of its damping
constexpr double kSlower = 0.5, kFaster = 2.0;   ///< of the share of a penetration that a rigid contact corrects a step
constexpr double kMostErp = 0.9;
constexpr int kFiner = 3;              ///< times as many substeps
constexpr double kExtrapolated = 1.5;  ///< the whole error over the change by so many: 1/(1 − 1/3)

/// The same robot, integrated and supported otherwise.
struct Variant {
  RobotSpec robot;
  EngineSettings engine;
  double weight = 1.0;  ///< of what it changes
};

void yield(Variant& variant, double stiffness, double erp) {
  ContactSpec& contact = variant.robot.contact;
  if (std::isinf(contact.stiffness)) {
    variant.engine.joint_erp = std::min(kMostErp, erp * variant.engine.joint_erp);
  } else {
    contact.stiffness *= stiffness;
    contact.damping /= stiffness;
  }
}

std::vector<Variant> variants_of(const ModelDefinition& definition) {
  const Variant own{definition.structure.robot, definition.engine};
  std::vector<Variant> all(1, own);
  all[0].engine.substeps *= kFiner;
  all[0].weight = kExtrapolated;
  if (!own.robot.contact.ground) return all;
  all.resize(3, own);
  yield(all[1], kSofter, kSlower);
  yield(all[2], kHarder, kFaster);
  return all;
}

/// Residuals as bins; empty where the variant cannot be simulated.
std::vector<Eigen::MatrixXd> predicted(const ModelDefinition& definition, const Variant& variant,
                                       const BaseSolution& base, const RowBins& bins, int threads) {
  ModelStructure structure = definition.structure;
  structure.robot = variant.robot;
  const std::unique_ptr<CompiledModel> model = compile(structure, variant.engine);
  const TrialPredictor predictor(*model, base.trials, threads);
  const ParameterSpace space(definition.free);
  ShootingProblem problem(predictor, space, base.segments, base.noise);
  std::vector<Eigen::VectorXd> residuals;
  std::vector<Eigen::MatrixXd> means;
  if (!problem.residuals({space.to_coordinates(base.values), base.states}, residuals)) return means;
  for (std::size_t k = 0; k < residuals.size(); ++k) means.push_back(bins.means(k, residuals[k]));
  return means;
}

}  // namespace

std::vector<Eigen::MatrixXd> contact_doubts(const ModelDefinition& definition, const BaseSolution& base,
                                            const RowBins& bins, int threads) {
  const auto own = predicted(definition, {definition.structure.robot, definition.engine}, base, bins, threads);
  std::vector<std::vector<Eigen::MatrixXd>> changes;
  for (const Variant& variant : variants_of(definition)) {
    std::vector<Eigen::MatrixXd> other = predicted(definition, variant, base, bins, threads);
    if (own.empty() || other.empty()) continue;
    for (std::size_t k = 0; k < own.size(); ++k) other[k] = variant.weight * (other[k] - own[k]);
    changes.push_back(std::move(other));
  }
  std::vector<Eigen::MatrixXd> doubts;
  const auto causes = static_cast<Eigen::Index>(changes.size());
  for (std::size_t k = 0; k < bins.segments(); ++k) {
    doubts.emplace_back(Eigen::MatrixXd::Zero(bins.rows(k), std::max<Eigen::Index>(1, causes)));
    for (Eigen::Index i = 0; i < causes; ++i) doubts.back().col(i) = changes[static_cast<std::size_t>(i)][k];
  }
  return doubts;
}

}  // namespace lacuna
