#pragma once

#include "where_it_fails/regression_tree.h"
#include "where_it_fails/residual_tests.h"
#include "where_it_fails/state_features.h"

#include <limits>
#include <string>
#include <vector>

namespace lacuna {

/// A range of a feature.
struct Condition {
  std::size_t feature = 0;  ///< index into `FeatureTable::features`
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// Samples with similar error: a leaf of the tree.
struct Regime {
  std::vector<Condition> conditions;
  double share_of_error = 0.0;
  double share_of_samples = 0.0;
  double times_floor = 0.0;  ///< RMS over its samples and the channels
};

/// The dependence of a channel's mean residual on features.
struct ChannelTests {
  std::string channel;
  std::string unit;             ///< of the residual
  double share_of_error = 0.0;  ///< over all channels, errors in multiples of the floor
  IndependenceTest mean;        ///< of a zero mean
  /// In the order of `FeatureTable::features`. Of a free run each alone; of an acceleration each beside the selected
  /// ones and all that another mass, damping or stiffness would be linear in (position, velocity, command).
  std::vector<IndependenceTest> features;
  /// Forward selection: features that each lie outside their 99 % band given those before them, the one that explains
  /// most first.
  struct Selected {
    std::size_t feature = 0;
    double share = 0.0;  ///< additional share of the squared residual
    double p = 1.0;      ///< corrected for the number of tests
  };
  std::vector<Selected> selected;
  std::vector<std::size_t> not_on;  ///< features that explain nothing beside the selected ones
};

/// The residuals that are tested.
enum class ViewKind {
  free_run,     ///< residual of free runs: the accumulated effect of what the model lacked before
  acceleration  ///< acceleration of a channel that the model lacks now (unexplained_acceleration.h)
};

/// One kind of residual, tested and divided into regimes.
struct ResidualView {
  ViewKind kind = ViewKind::free_run;
  double horizon = 0.0;       ///< s, after which predictions restarted from the data; 0: free runs
  Eigen::MatrixXd residuals;  ///< rows of the feature table × channels; NaN where nothing is scored
  double times_floor = 0.0;   ///< RMS over rows and channels
  std::size_t family = 0;     ///< number of tests that share the 1 % of false alarms
  std::vector<ChannelTests> channels;
  RegressionTree tree;
  std::vector<Regime> regimes;  ///< its leaves, the largest share of error first; none: one regime
  /// Whether the test of that channel and feature alone lies outside of its 99 % band.
  bool depends(std::size_t channel, std::size_t feature) const;
};

enum class FindingKind {
  regime,      ///< the error is concentrated under `conditions`
  dependence,  ///< the residual of `channel` varies with `features`, the strongest first
  offset,      ///< a constant part of the residual of `channel`
  magnitude,   ///< predicted swings of `channel` are too wide or too narrow, in the same way in all trials
  trial        ///< one trial has much more than its share of the error
};

/// One finding, with the share of squared error that it concerns.
struct Finding {
  FindingKind kind = FindingKind::regime;
  double share = 0.0;
  ViewKind view = ViewKind::free_run;  ///< it was seen in
  std::string channel = {};            ///< empty: all
  std::string trial = {};
  double share_of_samples = 0.0;           ///< regime and trial
  std::vector<Condition> conditions = {};  ///< regime
  std::vector<std::size_t> features = {};  ///< dependence
  std::vector<std::size_t> not_on = {};  ///< dependence: other kinds of features on which the residual does not depend
  double p = 1.0;                        ///< dependence and offset: corrected for the number of tests
  double size = 0.0;                     ///< offset: in the unit; magnitude: relative, positive where too wide
  std::string unit = {};
};

struct ChannelWhiteness {
  std::string channel;
  Autocorrelation autocorrelation;  ///< of the free runs' residuals
};

/// Where a model fails, over the fit trials. Held-out trials are not used, so that they remain independent evidence.
struct WhereItFails {
  FeatureTable table;
  std::vector<ChannelWhiteness> whiteness;
  std::vector<ResidualView> views;  ///< free runs; accelerations where a channel gives some
  std::vector<Finding> findings;    ///< the largest share first
};

/// METHOD's "Where it fails". The error of a free run accumulates all that a model lacks, so it shows how much is
/// missing; the residual acceleration shows on what it depends. Regimes and parts of an error are reported above 1.2
/// floors; a dependence wherever a test finds one with more than a twentieth of the squares. Nothing is found where no
/// fit trial can be scored or no floor is known. Throws `Interrupted`.
WhereItFails where_it_fails(const FeatureTask& task);

/// The findings, ranked by their share.
std::vector<Finding> findings_of(const Comparison& comparison, const std::vector<ResidualView>& views);

}  // namespace lacuna
