#include "calibration/calibrate.h"

#include "calibration/logistic_regression.h"
#include "figures/dirty_scores.h"
#include "runs/dirty_store.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace hidden_effects {
namespace {

using Verdicts = std::vector<const JudgedVerdict*>;

constexpr std::size_t kCasesPerFigure = 5;
/// Of a kind: how often rarer ones are right is not known. Of few it is their share, with half a case of either kind
/// beside them (H. Jeffreys' prior).
constexpr std::size_t kFewestVerdicts = 3;

/// A figure of evidence, and whether more of it says more for a verdict, 1, or less, −1.
struct KnownFigure {
  const char* name;
  double sign;
};

constexpr std::size_t kMostFigures = 4;

/// What the least of an answer's effects adds; what the answer leaves; at how many lengths and recordings it helps; how
/// many readings there are. Of a verdict without an answer: what the model itself leaves.
constexpr std::array kFigures = {KnownFigure{"least_part", 1.0}, KnownFigure{"left", -1.0}, KnownFigure{"help", 1.0},
                                 KnownFigure{"log_readings", 1.0}, KnownFigure{"base_cost", -1.0}};

/// Figures that all of them have, as many as there are cases for.
std::vector<KnownFigure> common_evidence(const Verdicts& verdicts) {
  std::vector<KnownFigure> figures;
  for (const KnownFigure& figure : kFigures)
    if (figures.size() < kMostFigures && (figures.size() + 1) * kCasesPerFigure <= verdicts.size() &&
        std::all_of(verdicts.begin(), verdicts.end(),
                    [&](const JudgedVerdict* one) { return one->evidence.contains(figure.name); }))
      figures.push_back(figure);
  return figures;
}

/// Of the weights (logistic_regression.h).
constexpr std::array kPenalties = {1.0, 3.0, 10.0, 30.0, 100.0};
constexpr double kLeastProbability = 1e-6;

struct EvidenceTable {
  std::vector<KnownFigure> figures;  ///< by column
  std::vector<std::string> rigs;     ///< by row
  Eigen::MatrixXd rows;
  Eigen::VectorXd right;
  Eigen::VectorXd signs;  ///< of the weights, by column

  LogisticFit fit(double penalty) const { return fit_logistic(rows, right, penalty, signs); }
};

EvidenceTable table_of(const Verdicts& verdicts) {
  EvidenceTable table{common_evidence(verdicts), {}, {}, {}, {}};
  table.rows.resize(static_cast<Eigen::Index>(verdicts.size()), static_cast<Eigen::Index>(table.figures.size()));
  table.right.resize(table.rows.rows());
  table.signs.resize(table.rows.cols());
  for (Eigen::Index j = 0; j < table.signs.size(); ++j)
    table.signs(j) = table.figures[static_cast<std::size_t>(j)].sign;
  for (Eigen::Index i = 0; i < table.rows.rows(); ++i) {
    const JudgedVerdict& one = *verdicts[static_cast<std::size_t>(i)];
    table.rigs.push_back(one.rig);
    table.right(i) = one.is_right;
    for (Eigen::Index j = 0; j < table.rows.cols(); ++j)
      table.rows(i, j) = one.evidence.at(table.figures[static_cast<std::size_t>(j)].name);
  }
  return table;
}

/// −log likelihood of the verdicts on each rig, told by a fit to the others.
double loss_on_other_rigs(const EvidenceTable& table, double penalty) {
  double loss = 0.0;
  for (const std::string& rig : std::set<std::string>(table.rigs.begin(), table.rigs.end())) {
    std::vector<Eigen::Index> own, others;
    for (std::size_t i = 0; i < table.rigs.size(); ++i)
      (table.rigs[i] == rig ? own : others).push_back(static_cast<Eigen::Index>(i));
    const LogisticFit fit = fit_logistic(table.rows(others, Eigen::all), table.right(others), penalty, table.signs);
    for (const Eigen::Index i : own) {
      const double p = logistic(fit.intercept + table.rows.row(i).dot(fit.weights));
      loss -= std::log(std::max(kLeastProbability, table.right(i) > 0.5 ? p : 1.0 - p));
    }
  }
  return loss;
}

/// The one with which a rig is told best from the others; the least where there are no others.
double best_penalty(const EvidenceTable& table) {
  if (std::set<std::string>(table.rigs.begin(), table.rigs.end()).size() < 2) return kPenalties.front();
  return *std::min_element(kPenalties.begin(), kPenalties.end(), [&](double one, double other) {
    return loss_on_other_rigs(table, one) < loss_on_other_rigs(table, other);
  });
}

lacuna::VerdictCalibration calibrated(const Verdicts& verdicts) {
  const EvidenceTable table = table_of(verdicts);
  const LogisticFit fit = table.fit(best_penalty(table));
  lacuna::VerdictCalibration calibration{fit.intercept, {}};
  for (Eigen::Index j = 0; j < table.rows.cols(); ++j)
    calibration.terms.push_back({table.figures[static_cast<std::size_t>(j)].name, fit.weights(j),
                                 table.rows.col(j).minCoeff(), table.rows.col(j).maxCoeff()});
  return calibration;
}

}  // namespace

std::vector<JudgedVerdict> judged_verdicts(const Database& database, const std::string& version,
                                           const std::string& set) {
  std::vector<JudgedVerdict> verdicts;
  for (const CaseResult& one : read_dirty_results(database, version, set)) {
    const DirtyGrade grade = grade_of(one);
    if (grade == DirtyGrade::failed || grade == DirtyGrade::undecided) continue;
    const DiagnosisRecord& answer = one.diagnoses.front();
    verdicts.push_back({one.about.rig, answer.verdict,
                        nlohmann::json::parse(answer.json).value("evidence", lacuna::Evidence{}),
                        is_true(one) ? 1.0 : 0.0});
  }
  return verdicts;
}

lacuna::Calibration calibrate(const std::vector<JudgedVerdict>& verdicts) {
  std::map<std::string, Verdicts> by_verdict;
  for (const JudgedVerdict& one : verdicts) by_verdict[one.verdict].push_back(&one);
  lacuna::Calibration calibration;
  for (const auto& [verdict, all] : by_verdict)
    if (all.size() >= kFewestVerdicts) calibration[verdict] = calibrated(all);
  return calibration;
}

lacuna::ShippedCalibration calibrate_and_leave_out(const std::vector<JudgedVerdict>& verdicts) {
  std::set<std::string> rigs;
  for (const JudgedVerdict& one : verdicts) rigs.insert(one.rig);
  lacuna::ShippedCalibration calibration{calibrate(verdicts), {}};
  for (const std::string& rig : rigs) {
    std::vector<JudgedVerdict> others;
    std::copy_if(verdicts.begin(), verdicts.end(), std::back_inserter(others),
                 [&](const JudgedVerdict& one) { return one.rig != rig; });
    calibration.without[rig] = calibrate(others);
  }
  return calibration;
}

}  // namespace hidden_effects
