#include "where_it_fails/feature_selection.h"

#include "foundation/parallel.h"

#include <algorithm>
#include <optional>

namespace lacuna {
namespace {

constexpr double kSelectionLevel = 0.01;
constexpr double kLeastShare = 0.05;        // of the squares: the least that a selected feature explains
constexpr double kLeastShareBeyond = 0.02;  // the same for a feature found beside all terms linear in the state
constexpr std::size_t kMostSelected = 4;

IndependenceTest test_of(const ResidualTester& tester, const FeatureTable& table, std::size_t feature) {
  const Eigen::VectorXd column = table.values.col(static_cast<Eigen::Index>(feature));
  return table.features[feature].classes() ? tester.of_classes(column) : tester.of(column);
}

Eigen::MatrixXd beside(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right, Eigen::Index rows) {
  Eigen::MatrixXd both(rows, left.cols() + right.cols());
  if (left.cols() > 0) both.leftCols(left.cols()) = left;
  if (right.cols() > 0) both.rightCols(right.cols()) = right;
  return both;
}

bool is_linear(FeatureKind kind) {
  return kind == FeatureKind::position || kind == FeatureKind::velocity || kind == FeatureKind::command;
}

/// Positions, velocities and commands: a wrong mass, damping or stiffness is linear in these.
Eigen::MatrixXd linear_state(const FeatureTable& table) {
  std::vector<Eigen::Index> columns;
  for (std::size_t f = 0; f < table.features.size(); ++f) {
    const FeatureKind kind = table.features[f].kind;
    if (is_linear(kind)) columns.push_back(static_cast<Eigen::Index>(f));
  }
  return table.values(Eigen::all, columns);
}

/// Forward selection of the features that one residual depends on.
class Selection {
 public:
  Selection(const SelectionTask& task, ChannelTests& tests)
      : task_(task), table_(task.table), covariates_(task.covariates), tests_(tests) {}

  void run() {
    const ResidualTester alone(task_.residual, task_.covariates, task_.family);
    tests_.mean = alone.of_mean();
    now_ = tests_.features = test_all(alone);
    forward(kLeastShare);
    if (task_.covariates.cols() > 0) {
      const Eigen::MatrixXd linear = linear_state(table_);
      covariates_ = beside(covariates_, linear, task_.residual.size());
      now_ = test_all(ResidualTester(task_.residual, covariates_, task_.family));
      forward(kLeastShareBeyond);
      covariates_ = beside_others(std::nullopt, false);  // features for which fitted values compensated
      now_ = test_all(ResidualTester(task_.residual, covariates_, task_.family));
      forward(kLeastShare);
      test_beside_the_others();
      now_ = tests_.features;
    }
    for (std::size_t f = 0; f < now_.size(); ++f)
      if (now_[f].testable && !outside_band(now_[f], task_.family) && !selected(f)) tests_.not_on.push_back(f);
  }

 private:
  std::vector<IndependenceTest> test_all(const ResidualTester& tester) const {
    std::vector<IndependenceTest> tests(table_.features.size());
    parallel_for(tests.size(), task_.work.threads, [&](std::size_t feature, int) {
      task_.work.stop.throw_if_due();
      if (std::find(task_.unasked.begin(), task_.unasked.end(), feature) == task_.unasked.end())
        tests[feature] = test_of(tester, table_, feature);
    });
    return tests;
  }

  bool selected(std::size_t feature) const {
    return std::any_of(tests_.selected.begin(), tests_.selected.end(),
                       [&](const auto& one) { return one.feature == feature; });
  }

  std::optional<std::size_t> strongest(double least_share) const {
    std::optional<std::size_t> best;
    for (std::size_t f = 0; f < now_.size(); ++f)
      if (outside_band(now_[f], task_.family) && !selected(f) && now_[f].share >= least_share &&
          (!best || now_[f].share > now_[*best].share))
        best = f;
    return best;
  }

  /// Each feature beside the selected ones and all other terms linear in the state.
  void test_beside_the_others() {
    tests_.features = test_all(ResidualTester(task_.residual, beside_others(std::nullopt, true), task_.family));
    for (std::size_t f = 0; f < now_.size(); ++f)
      if (is_linear(table_.features[f].kind)) tests_.features[f] = now_[f];
    for (const ChannelTests::Selected& one : tests_.selected)
      tests_.features[one.feature] = test_of(
          ResidualTester(task_.residual, beside_others(one.feature, !is_linear(table_.features[one.feature].kind)),
                         task_.family),
          table_, one.feature);
  }

  Eigen::MatrixXd beside_others(std::optional<std::size_t> feature, bool with_linear) const {
    Eigen::MatrixXd all = task_.covariates;
    for (const ChannelTests::Selected& one : tests_.selected)
      if (one.feature != feature)
        all = beside(all,
                     feature_basis(table_.values.col(static_cast<Eigen::Index>(one.feature)),
                                   table_.features[one.feature].classes()),
                     task_.residual.size());
    return with_linear ? beside(all, linear_state(table_), task_.residual.size()) : all;
  }

  void forward(double least_share) {
    while (tests_.selected.size() < kMostSelected) {
      const std::optional<std::size_t> best = strongest(least_share);
      if (!best) return;
      const IndependenceTest& test = now_[*best];
      tests_.selected.push_back({*best, test.share, std::min(1.0, test.p * static_cast<double>(task_.family))});
      const Eigen::MatrixXd basis =
          feature_basis(table_.values.col(static_cast<Eigen::Index>(*best)), table_.features[*best].classes());
      covariates_ = beside(covariates_, basis, task_.residual.size());
      now_ = test_all(ResidualTester(task_.residual, covariates_, task_.family));
    }
  }

  const SelectionTask& task_;
  const FeatureTable& table_;
  Eigen::MatrixXd covariates_;  ///< those of the task and those selected since
  ChannelTests& tests_;
  std::vector<IndependenceTest> now_;
};

}  // namespace

bool outside_band(const IndependenceTest& test, std::size_t family) {
  return test.testable && test.p * static_cast<double>(family) < kSelectionLevel;
}

void select_features(const SelectionTask& task, ChannelTests& tests) { Selection(task, tests).run(); }

}  // namespace lacuna
