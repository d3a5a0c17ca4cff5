#include "calibration/calibrate.h"

#include "calibration/logistic_regression.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace hidden_effects {
namespace {

using Verdicts = std::vector<const JudgedVerdict*>;

constexpr std::size_t kCasesPerFigure = 5;
constexpr std::size_t kFewestVerdicts = 10;  ///< of a kind: how often rarer ones are right is not known

/// Figures that all of them have.
std::vector<std::string> common_evidence(const Verdicts& verdicts) {
  std::vector<std::string> names;
  for (const auto& [name, unused] : verdicts.front()->evidence)
    if (std::all_of(verdicts.begin(), verdicts.end(),
                    [&, name = name](const JudgedVerdict* one) { return one->evidence.contains(name); }))
      names.push_back(name);
  if (verdicts.size() < kCasesPerFigure * names.size()) names.clear();
  return names;
}

lacuna::VerdictCalibration calibrated(const Verdicts& verdicts) {
  const std::vector<std::string> names = common_evidence(verdicts);
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(verdicts.size()), static_cast<Eigen::Index>(names.size()));
  Eigen::VectorXd right(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const JudgedVerdict& one = *verdicts[static_cast<std::size_t>(i)];
    right(i) = one.is_right;
    for (Eigen::Index j = 0; j < rows.cols(); ++j) rows(i, j) = one.evidence.at(names[static_cast<std::size_t>(j)]);
  }
  const LogisticFit fit = fit_logistic(rows, right);
  lacuna::VerdictCalibration calibration{fit.intercept, {}};
  for (Eigen::Index j = 0; j < rows.cols(); ++j)
    calibration.terms.push_back(
        {names[static_cast<std::size_t>(j)], fit.weights(j), rows.col(j).minCoeff(), rows.col(j).maxCoeff()});
  return calibration;
}

}  // namespace

std::vector<JudgedVerdict> judged_verdicts(Database& database, const std::string& version, const std::string& set) {
  std::vector<JudgedVerdict> verdicts;
  for (const Row& row : database.query(
           "WITH v AS MATERIALIZED (SELECT * FROM verdict_right) SELECT j.rig, j.noise, j.strength, j.effect, "
           "v.verdict, d.json, v.is_right FROM v CROSS JOIN judged j USING (version, set_name, number) "
           "JOIN diagnosis d ON (d.version, d.set_name, d.number, d.round) = (v.version, v.set_name, v.number, 1) "
           "WHERE +v.version = ? AND +v.set_name = ? AND v.verdict <> 'cannot_tell' AND j.group_name <> 'contact' "
           "ORDER BY v.number",
           {version, set}))
    verdicts.push_back({text(row[0]), text(row[1]), fmt::format("{:g}", real(row[2])), text(row[3]), text(row[4]),
                        nlohmann::json::parse(text(row[5])).value("evidence", lacuna::Evidence{}), real(row[6])});
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
